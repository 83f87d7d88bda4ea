// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/progress.h"

/// The stick that an operator holds when he is told that, see Faults::stick. @param before which he held
inline int stickFor(const Progress &progress, int before)
{
    const QString told = progress.step.section(u'-', 2);
    const QString wanted = told == QStringLiteral("check") ? progress.subject : told;
    if (wanted == QStringLiteral("back"))
        return before % 2 == 1 ? before + 1 : before;
    return wanted == QStringLiteral("roll")                                      ? 1
        : wanted == QStringLiteral("pitch")                                      ? 3
        : wanted == QStringLiteral("yaw")                                        ? 5
        : wanted == QStringLiteral("command") || wanted == QStringLiteral("cmd") ? 7
                                                                                 : 0;
}
