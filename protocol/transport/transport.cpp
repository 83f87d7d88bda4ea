// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/transport/transport.h"

bool Transport::setLine(const LineSettings &)
{
    return true;
}
