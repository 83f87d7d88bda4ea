// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/request.h"

#include <QByteArray>

#include <optional>

/// The frames that steer a board, ready for the wire.
struct ControlFrames
{
    QByteArray setpoint;
    QByteArray stop;  ///< stand still, control kept
    QByteArray release;  ///< give control back to whoever had it before
    AnswerMatcher answer
        = {};  ///< the board answers each, and wants nothing else before it has; empty: nothing answers
};

/// Repeats a set-point at its rate, but only as long as somebody refreshes it: 250 ms without a refresh and
/// it sends stop, then releases control (the dead-man's rule). No clock of its own.
class ControlStream
{
public:
    static constexpr auto kPeriod = 20ms;  // document CMD_CONTROL: 50 Hz or less
    static constexpr auto kDeadMan = 250ms;
    static constexpr auto kReleaseDelay = 100ms;  // time for the stop to act before control is given back

    void refresh(ControlFrames frames, TimePoint now);
    /// Ends the stream on purpose: stop now, release shortly after.
    void end(TimePoint now);
    /// Ends without another word, when the link is gone or the motors were stopped.
    void drop() { m_state = State::Idle; }

    /// The frame to send now, if any; call at or after nextDeadline().
    std::optional<QByteArray> advance(TimePoint now);
    [[nodiscard]] std::optional<TimePoint> nextDeadline() const;
    [[nodiscard]] bool isActive() const { return m_state != State::Idle; }
    [[nodiscard]] bool isStreaming() const { return m_state == State::Streaming; }
    [[nodiscard]] const AnswerMatcher &answer() const { return m_frames.answer; }
    /// How often the dead-man's rule had to act.
    [[nodiscard]] int rescues() const { return m_rescues; }

private:
    enum class State { Idle, Streaming, Stopping };

    State m_state = State::Idle;
    ControlFrames m_frames;
    TimePoint m_refreshedAt{};
    TimePoint m_nextSend{};
    bool m_stopSent = false;
    int m_rescues = 0;
};
