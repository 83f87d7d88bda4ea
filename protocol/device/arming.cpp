// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/device/arming.h"

#include <algorithm>
#include <utility>

void ArmingSession::open(bool held)
{
    if (m_phase != Phase::Closed)
        return;
    m_phase = Phase::Open;
    m_isHeld = held;
    m_ended = ArmingBar::None;
}

bool ArmingSession::close()
{
    const bool wasSending = end(ArmingBar::Operator);
    m_phase = Phase::Closed;
    m_isHeld = false;
    return wasSending;
}

void ArmingSession::press(TimePoint now)
{
    if (m_phase != Phase::Open)
        return;
    m_phase = Phase::Holding;
    m_since = now;
}

void ArmingSession::release()
{
    if (m_phase == Phase::Holding)
        end(ArmingBar::Operator);
}

bool ArmingSession::end(ArmingBar why)
{
    if (m_phase <= Phase::Open)
        return false;
    m_phase = Phase::Open;
    m_ended = why;
    return true;
}

double ArmingSession::held(TimePoint now) const
{
    if (m_phase < Phase::Holding)
        return 0;
    return m_phase > Phase::Holding ? 1 : std::clamp(seconds(now - m_since) / seconds(kHold), 0.0, 1.0);
}

// What holds for being armed as for arming.
ArmingBar ArmingSession::barSince(const Known &known, const Sticks &sticks, TimePoint now) const
{
    if (!known.isLinked)
        return ArmingBar::NoLink;
    if (now - known.heardAt >= kSilence)
        return ArmingBar::Silent;
    if (!known.isArmed || now - known.toldAt >= kSilence)
        return ArmingBar::NoState;
    if (known.isStopping)
        return ArmingBar::Stopping;
    if (known.isBusy)
        return ArmingBar::Busy;
    if (known.isCalibrating.value_or(false))
        return ArmingBar::Calibrating;
    if (!known.isCalibrated.value_or(false))
        return ArmingBar::NotCalibrated;
    if (now - sticks.at > kSticks)
        return ArmingBar::NoSticks;
    return ArmingBar::None;
}

ArmingBar ArmingSession::barBefore(const Known &known, const Sticks &sticks, TimePoint now) const
{
    if (const ArmingBar bar = barSince(known, sticks, now); bar != ArmingBar::None)
        return bar;
    if (*known.isArmed)
        return ArmingBar::ArmedElsewhere;
    if (known.isDriven.value_or(false))
        return ArmingBar::MotorsTurn;
    if (known.isShared)
        return ArmingBar::Shared;
    if (known.isBatteryLow)
        return ArmingBar::Battery;
    if (!m_isHeld && known.tiltDeg > kMaxTilt)
        return ArmingBar::Tilted;
    if (!sticks.isComplete)
        return ArmingBar::Unassigned;
    if (!known.isChecked)
        return ArmingBar::Unchecked;
    if (sticks.throttle != 0)
        return ArmingBar::Throttle;
    if (sticks.pushed > kMiddle)
        return ArmingBar::Pushed;
    return ArmingBar::None;
}

ArmingBar ArmingSession::bar(const Known &known, const Sticks &sticks, TimePoint now) const
{
    if (isArming())
        return barSince(known, sticks, now);
    const ArmingBar bar = barBefore(known, sticks, now);
    return bar == ArmingBar::None && m_phase == Phase::Closed ? ArmingBar::NoPropellerWord : bar;
}

ArmingSession::Send ArmingSession::step(const Known &known, const Sticks &sticks, TimePoint now)
{
    if (m_phase <= Phase::Open)
        return Send::Nothing;
    if (const ArmingBar why = bar(known, sticks, now); why != ArmingBar::None) {
        end(why);
        return Send::Nothing;
    }
    if (m_phase == Phase::Holding) {
        if (now - m_since < kHold)
            return Send::Disarmed;
        m_phase = Phase::Asked;
        m_since = now;
    }
    // What it said before it can have obeyed proves nothing.
    if (m_phase == Phase::Asked && *known.isArmed && known.toldAt > m_since) {
        m_phase = Phase::Armed;
        m_confirmedAt = known.toldAt;
    } else if (m_phase == Phase::Asked && now - m_since > kAnswer)
        end(ArmingBar::NotArmed);
    // Once is enough: what was sent meanwhile has armed it again. That another ground is there alone disarms
    // nothing that may fly; it is told (LinkHealth), and who wants it down only has to disarm it.
    else if (m_phase == Phase::Armed && (!*known.isArmed || known.disarmedAt > m_confirmedAt))
        end(ArmingBar::Disarmed);
    return isArming() ? Send::Armed : Send::Nothing;
}
