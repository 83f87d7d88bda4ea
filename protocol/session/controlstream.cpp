// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/controlstream.h"

#include <algorithm>

void ControlStream::refresh(ControlFrames frames, TimePoint now)
{
    if (m_state != State::Streaming)
        m_nextSend = now;
    m_state = State::Streaming;
    m_frames = std::move(frames);
    m_refreshedAt = now;
}

void ControlStream::end(TimePoint now)
{
    if (m_state != State::Streaming)
        return;
    m_state = State::Stopping;
    m_stopSent = false;
    m_nextSend = now;
}

std::optional<QByteArray> ControlStream::advance(TimePoint now)
{
    if (m_state == State::Streaming && now - m_refreshedAt >= kDeadMan) {
        ++m_rescues;
        end(now);
    }
    if (m_state == State::Idle || now < m_nextSend)
        return {};
    if (m_state == State::Streaming) {
        m_nextSend = std::max(m_nextSend + kPeriod, now + kPeriod / 2);
        return m_frames.setpoint;
    }
    if (!m_stopSent) {
        m_stopSent = true;
        m_nextSend = now + kReleaseDelay;
        return m_frames.stop;
    }
    m_state = State::Idle;
    return m_frames.release;
}

std::optional<TimePoint> ControlStream::nextDeadline() const
{
    if (m_state == State::Idle)
        return {};
    if (m_state == State::Streaming)
        return std::min<TimePoint>(m_nextSend, m_refreshedAt + kDeadMan);
    return m_nextSend;
}
