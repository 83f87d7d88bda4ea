// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/chartnumbers.h"

#include "widgets/models/numbertext.h"

#include <QChart>

using namespace Qt::StringLiterals;

void writeNumbers(QChart &chart)
{
    chart.setLocale(numberLocale());
    chart.setLocalizeNumbers(true);
}

QString labelFormat(QString format)
{
    return format.replace(u"%g"_s, u"%.6g"_s).replace(u"%d"_s, u"%.0f"_s);
}
