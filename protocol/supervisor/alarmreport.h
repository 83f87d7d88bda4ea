// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/abilities.h"
#include "protocol/supervisor/alarm.h"

#include <QDateTime>

/// What became of an alarm's action.
enum class AlarmOutcome {
    Told,  ///< nothing else was wanted
    Acting,
    Done,  ///< motors off is proven; the change is taken back and the board uses the values from before
    NotProven,  ///< the motors were told to stop, but nothing proves that they did
    NoChange,  ///< there was no live change to take back
    Conflict,  ///< somebody else has changed the values since: nothing was written
    Failed,  ///< the values from before could not be put into use
    GoesOn,  ///< the change was taken back, and it goes on all the same
};

/// An alarm and what is done about it.
struct AlarmReport
{
    int number = 0;  ///< counts alarms
    Alarm alarm;
    AlarmAction action = AlarmAction::Warn;  ///< the last one taken; a board that flies is only warned of
    AlarmOutcome outcome = AlarmOutcome::Told;
    std::optional<LiveChange> change;  ///< that was taken back
    bool isOver = false;
    bool wasSeenToEnd = false;  ///< else it is over because nobody watches any more
    QDateTime at;

    /// The program intervened: the operator has to be told even when it is over.
    [[nodiscard]] bool hasActed() const { return action != AlarmAction::Warn; }
};
