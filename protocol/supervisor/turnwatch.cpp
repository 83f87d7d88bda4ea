// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Axes that turn on and on, on boards without targets.
#include "protocol/supervisor/supervisor.h"

#include <cmath>

namespace {

// Of the limit of a runaway: it turns further than that without a stop. What may be meant is told later.
constexpr double kTurnTimes = 2.4;
constexpr double kToldTimes = 3.6;
constexpr double kFindsPlace = 3.0;  // seconds that motors need after they were switched on
constexpr double kHandsOff = 2.0;  // seconds since it was steered or a procedure ran
constexpr double kLeaves = 5.0;  // degrees beyond a limit of its angles

}  // namespace

// On a board without targets nothing tells where an axis should be; but one that is steered by nobody does
// not turn on and on. Whoever carries it, or an input of the board, may turn it all the same.
void Supervisor::watchTurn(std::size_t axis, double time, double angle, double rate)
{
    AxisState &state = m_axes[axis];
    const bool isWatched = isAnchored(state) && isHolding(time) && m_situation.isDriven[axis].value_or(true)
        && time - m_heldSince >= kFindsPlace && time - m_steeredAt >= kHandsOff
        && time - m_busyAt >= kHandsOff;
    if (!isWatched) {
        state.turn.clear();
        return;
    }
    const double turned = std::abs(state.turn.add(angle, rate));
    const bool follows = m_situation.follows[axis].value_or(false);
    const auto &angles = m_rules.angles[axis];
    const bool leaves = angles && !follows
        && (rate > 0 ? angle > angles->second + kLeaves : angle < angles->first - kLeaves);
    const bool mayBeMeant = follows || (!leaves && m_rules.isRemote[axis].value_or(true));
    const double limit = m_rules.runawayDeg * (mayBeMeant ? kToldTimes : leaves ? 1.0 : kTurnTimes);
    if (turned < limit)
        return;
    Alarm alarm;
    alarm.kind = AlarmKind::Runaway;
    alarm.axis = kAxes[axis];
    alarm.time = time;
    alarm.value = turned;
    alarm.limit = limit;
    alarm.isTurning = true;
    alarm.mayBeMeant = mayBeMeant;
    alarm.isAfterChange = isChangedSince(time - kChangeCounts);
    const Alarm seen = explainRunaway(axis, time);
    if (!mayBeMeant && seen.cause == AlarmCause::SwappedAxes) {
        alarm.cause = seen.cause;
        alarm.other = seen.other;
    }
    raise(alarm);
}
