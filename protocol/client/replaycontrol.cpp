// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/client/replaycontrol.h"

#include "protocol/transport/replay.h"

ReplayControl::ReplayControl(std::function<void(Job)> onLink, std::function<void()> reopen)
    : m_onLink(std::move(onLink))
    , m_reopen(std::move(reopen))
    , m_state(std::make_unique<std::optional<ReplayState>>())
{
}

ReplayControl::~ReplayControl() = default;

const std::optional<ReplayState> &ReplayControl::state() const
{
    return *m_state;
}

void ReplayControl::setPaused(bool paused)
{
    m_paused = paused;
    m_onLink([paused](Replay &replay) { replay.setPaused(paused); });
}

void ReplayControl::setSpeed(double speed)
{
    m_speed = speed;
    m_onLink([speed](Replay &replay) { replay.setSpeed(speed); });
}

void ReplayControl::seek(double seconds)
{
    if (m_begun && (!*m_state || seconds >= (*m_state)->position)) {
        m_onLink([seconds](Replay &replay) { replay.forwardTo(seconds); });
        return;
    }
    const auto speed = m_speed;
    const bool paused = m_paused;
    m_reopen();
    m_from = seconds;
    m_speed = speed;
    m_paused = paused;
}

void ReplayControl::forget()
{
    m_state->reset();
    m_from = 0;
    m_speed.reset();
    m_paused = false;
    m_begun = false;
}

void ReplayControl::begin()
{
    m_begun = true;
    m_onLink([speed = m_speed, from = m_from, paused = m_paused](Replay &replay) {
        replay.play();
        if (speed)
            replay.setSpeed(*speed);
        if (from > 0)
            replay.forwardTo(from);
        replay.setPaused(paused);
    });
}

void ReplayControl::setState(std::optional<ReplayState> state)
{
    *m_state = state;
}
