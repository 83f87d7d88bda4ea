// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// One entry of a choice list, or one bit of a flag word (value = bit number).
struct Choice
{
    int value = 0;
    const char *name = "";
    int since = 0;  ///< firmware that introduced it; 0 = always there
    int until = 99999;
};
