// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/supervisor/alarm.h"

/// Something that the supervisor cannot look for, and why. Its words are made in widgets/models/alarmtext.h.
struct Unwatched
{
    enum class Reason {
        NotTold,  ///< the board has no such channel
        NotComing,  ///< it has, but nothing comes
        TooSlow,  ///< samples come too seldom
        OnlySteered,  ///< only while this program steers to an angle: the board does not tell its targets
        ByRate,  ///< not while it steers otherwise, for the same reason
        NoBattery,  ///< the board measures a voltage that is no battery's
    };

    AlarmKind kind = AlarmKind::Runaway;
    Reason reason = Reason::NotTold;
    double hertz = 0;  ///< TooSlow: above which nothing is seen; 0: nothing at all
    bool isMotors = false;  ///< Heat: that of the motors, while that of the board's sensor is watched

    friend bool operator==(const Unwatched &, const Unwatched &) = default;
};
