// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/stopplan.h"

#include <QByteArray>

#include <optional>

/// The frames that steer a board, ready to be sent.
struct ControlFrames
{
    QByteArray setpoint;
    QByteArray stop;  ///< stand still, keep control
    QByteArray release;  ///< return control to whichever source had it before
    /// The board answers each frame and accepts nothing else until it has; empty: no answers.
    AnswerMatcher answer = {};
    int kind = 0;  ///< as Request::kind: whose answers could be taken for these
    /// What telemetry since the stop proves about the board standing still; the stop is repeated until it is
    /// proven. Empty: one stop is enough.
    std::function<Proof(const LatestValues &, TimePoint since)> stopped = {};
};

/// Repeats a set-point at its rate, but only while it is refreshed: after 250 ms without a refresh it sends
/// stop, then releases control (the dead-man rule). Has no clock of its own. Belongs to one link.
class ControlStream
{
public:
    static constexpr auto kDeadMan = 250ms;
    static constexpr auto kReleaseDelay = 100ms;  ///< for the stop to act before control is released
    static constexpr auto kStopLimit = 2s;  ///< an unproven stop is repeated for this long

    /// @param period between two set-points, see LinkTiming::controlPeriod
    explicit ControlStream(milliseconds period = 20ms)
        : m_period(period)
    {
    }

    void refresh(ControlFrames frames, TimePoint now);
    /// Ends the stream deliberately: stop now, release shortly after.
    void end(TimePoint now);
    /// Ends without sending anything, when the link is gone or the motors were stopped.
    void drop() { m_state = State::Inactive; }

    /// The frame to send now, if any; call at or after nextDeadline().
    std::optional<QByteArray> advance(TimePoint now, const LatestValues *latest = nullptr);
    [[nodiscard]] std::optional<TimePoint> nextDeadline() const;
    [[nodiscard]] bool isActive() const { return m_state != State::Inactive; }
    [[nodiscard]] bool isStreaming() const { return m_state == State::Streaming; }
    [[nodiscard]] const AnswerMatcher &answer() const { return m_frames.answer; }
    [[nodiscard]] int kind() const { return m_frames.kind; }
    /// How often the dead-man rule had to act.
    [[nodiscard]] int failsafeCount() const { return m_failsafeCount; }

private:
    enum class State { Inactive, Streaming, Stopping };

    [[nodiscard]] bool isStopDone(TimePoint now, const LatestValues *latest) const;

    milliseconds m_period;
    State m_state = State::Inactive;
    ControlFrames m_frames;
    TimePoint m_refreshedAt{};
    TimePoint m_nextSend{};
    TimePoint m_stoppedAt{};
    bool m_stopSent = false;
    int m_failsafeCount = 0;
};
