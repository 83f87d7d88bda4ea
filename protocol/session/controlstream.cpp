// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/controlstream.h"

#include <algorithm>

void ControlStream::refresh(ControlFrames frames, TimePoint now)
{
    if (frames.setpoint.isEmpty()) {  // nothing is known to steer to
        end(now);
        return;
    }
    if (frames.begun && *frames.begun <= m_barredAt)
        return;
    if (m_state != State::Streaming)
        m_nextSend = now;
    m_state = State::Streaming;
    m_outcome.reset();
    m_frames = std::move(frames);
    m_refreshedAt = now;
}

void ControlStream::end(TimePoint now)
{
    bar(now);
    if (m_state != State::Streaming)
        return;
    m_state = State::Stopping;
    m_stopSent = false;
    m_isStill = false;
    m_stoppedAt = now;
    m_nextSend = now;
}

void ControlStream::motorsStopped(TimePoint now)
{
    bar(now);
    if (canProve())
        end(now);
    else
        drop();
}

void ControlStream::endOther(ControlFrames frames, TimePoint now)
{
    refresh(std::move(frames), now);
    end(now);
}

void ControlStream::answered(const Frame &frame)
{
    if (m_state == State::Stopping && m_stopSent && m_frames.fromAnswer
        && m_frames.fromAnswer(frame) == Proof::Proven)
        m_isStill = true;
}

// A single stop is enough if there is no way to prove it.
std::optional<bool> ControlStream::stopOutcome(TimePoint now, const LatestValues *latest) const
{
    if (!m_stopSent || now - m_stoppedAt < m_frames.stopFor)
        return {};
    const bool tellsTelemetry = m_frames.stopped && latest;
    const bool isStill = m_isStill || (!tellsTelemetry && !m_frames.question)
        || (tellsTelemetry && m_frames.stopped(*latest, m_stoppedAt) == Proof::Proven);
    return isStill || now - m_stoppedAt >= kStopLimit ? std::optional(isStill) : std::nullopt;
}

std::optional<QByteArray> ControlStream::advance(TimePoint now, const LatestValues *latest)
{
    if (m_state == State::Streaming && now - m_refreshedAt >= kDeadMan) {
        ++m_failsafeCount;
        end(now);
    }
    if (m_state == State::Inactive || now < m_nextSend)
        return {};
    if (m_state == State::Streaming) {
        m_nextSend = std::max(m_nextSend + m_period, now + m_period / 2);
        return m_frames.setpoint;
    }
    if (m_state == State::Releasing)
        return release(now);
    const std::optional<bool> outcome = stopOutcome(now, latest);
    if (!outcome) {
        m_stopSent = true;
        m_nextSend = now + (m_frames.stopFor > 0ms ? m_period : kReleaseDelay);
        return m_frames.stop;
    }
    m_outcome = outcome;
    m_state = State::Releasing;
    m_releasesLeft = kReleases;
    return release(now);
}

QByteArray ControlStream::release(TimePoint now)
{
    m_nextSend = now + kReleaseDelay;
    if (--m_releasesLeft == 0)
        m_state = State::Inactive;
    return m_frames.release;
}

std::optional<TimePoint> ControlStream::nextDeadline() const
{
    if (m_state == State::Inactive)
        return {};
    if (m_state == State::Streaming)
        return std::min<TimePoint>(m_nextSend, m_refreshedAt + kDeadMan);
    return m_nextSend;
}
