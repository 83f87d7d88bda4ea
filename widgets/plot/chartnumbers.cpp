// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/chartnumbers.h"

#include "widgets/models/numbertext.h"

#include <QChart>

void writeNumbers(QChart &chart)
{
    chart.setLocale(numberLocale());
    chart.setLocalizeNumbers(true);
}
