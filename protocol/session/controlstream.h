// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/axis.h"
#include "protocol/session/stopplan.h"

#include <QByteArray>

#include <array>
#include <limits>
#include <optional>
#include <utility>

/// The frames that steer a board, ready to be sent.
struct ControlFrames
{
    QByteArray setpoint;
    QByteArray stop;  ///< stand still, keep control
    QByteArray release;  ///< return control to whichever source had it before
    /// The stop is sent at the rate of the set-points for at least this long, for boards that do not confirm
    /// it and go on as they were told last; 0: once.
    milliseconds stopFor{0};
    /// When the operator began; empty: it does not matter. Once steering was ended, by whatever, frames of
    /// what had begun before are not taken any more: only the operator begins anew.
    std::optional<TimePoint> begun{};
    /// The board answers each frame and accepts nothing else until it has; empty: no answers.
    AnswerMatcher answer = {};
    int kind = 0;  ///< as Request::kind: whose answers could be taken for these
    /// What telemetry since the stop proves about the board standing still; the stop is repeated until it is
    /// proven. Empty: one stop is enough.
    std::function<Proof(const LatestValues &, TimePoint since)> stopped = {};
    /// Asked after each stop, on boards that can tell whether they stand still; empty: telemetry alone tells.
    std::optional<Request> question = {};
    /// What its answer proves about that.
    std::function<Proof(const Frame &)> fromAnswer = {};
    static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    /// Where the set-point steers roll, pitch and yaw to, in degrees as the board reports its angles; NaN
    /// where that is not known: by rate, relative to something else. Boards may go less far, and slowly.
    std::array<double, kAxisCount> angles{kUnknown, kUnknown, kUnknown};
};

/// Repeats a set-point at its rate, but only while it is refreshed: after 250 ms without a refresh it sends
/// stop, then releases control (the dead-man rule). Nothing confirms a release, so it is sent several times.
/// Has no clock of its own. Belongs to one link.
class ControlStream
{
public:
    static constexpr auto kDeadMan = 250ms;
    static constexpr auto kReleaseDelay = 100ms;  ///< for the stop to act before control is released
    static constexpr int kReleases = 3;
    static constexpr auto kStopLimit = 2s;  ///< an unproven stop is repeated for this long

    /// @param period between two set-points, see LinkTiming::controlPeriod
    explicit ControlStream(milliseconds period = 20ms)
        : m_period(period)
    {
    }

    void refresh(ControlFrames frames, TimePoint now);
    /// What has begun before is not taken any more.
    void bar(TimePoint now) { m_barredAt = now; }
    /// Ends the stream deliberately: stop now, release shortly after.
    void end(TimePoint now);
    /// Ends what another link had streamed.
    void endOther(ControlFrames frames, TimePoint now);
    /// The motors are being stopped. Where it can be seen, the stream is ended as well: motors that run again
    /// later would go on turning as they were steered last.
    void motorsStopped(TimePoint now);
    /// Ends without sending anything, when the link is gone or the motors were stopped.
    void drop() { m_state = State::Inactive; }
    /// The board has answered ControlFrames::question.
    void answered(const Frame &frame);

    /// The frame to send now, if any; call at or after nextDeadline().
    std::optional<QByteArray> advance(TimePoint now, const LatestValues *latest = nullptr);
    [[nodiscard]] std::optional<TimePoint> nextDeadline() const;
    [[nodiscard]] bool isActive() const { return m_state != State::Inactive; }
    /// Steers, or has not been seen to stand still yet; what is left after that is to give control back.
    [[nodiscard]] bool isSteering() const
    {
        return m_state == State::Streaming || m_state == State::Stopping;
    }
    [[nodiscard]] bool isStreaming() const { return m_state == State::Streaming; }
    /// What is to be asked now, to see whether the board stands still; null if nothing.
    [[nodiscard]] const Request *question() const
    {
        return m_state == State::Stopping && m_frames.question ? &*m_frames.question : nullptr;
    }
    /// A stop of this stream can be proven.
    [[nodiscard]] bool canProve() const { return m_frames.question.has_value(); }
    /// Once after an end: whether the board was seen to stand still, or there is no way to see it.
    [[nodiscard]] std::optional<bool> takeOutcome() { return std::exchange(m_outcome, std::nullopt); }
    /// Those of the stream that runs, or ran last.
    [[nodiscard]] const ControlFrames &frames() const { return m_frames; }
    [[nodiscard]] const AnswerMatcher &answer() const { return m_frames.answer; }
    [[nodiscard]] int kind() const { return m_frames.kind; }
    /// How often the dead-man rule had to act.
    [[nodiscard]] int failsafeCount() const { return m_failsafeCount; }

private:
    enum class State { Inactive, Streaming, Stopping, Releasing };

    /// Whether it was proven; nothing while it is not done.
    [[nodiscard]] std::optional<bool> stopOutcome(TimePoint now, const LatestValues *latest) const;

    QByteArray release(TimePoint now);

    milliseconds m_period;
    State m_state = State::Inactive;
    ControlFrames m_frames;
    TimePoint m_refreshedAt{};
    TimePoint m_nextSend{};
    TimePoint m_stoppedAt{};
    TimePoint m_barredAt{};
    bool m_stopSent = false;
    int m_releasesLeft = 0;
    bool m_isStill = false;  // by an answer
    std::optional<bool> m_outcome;
    int m_failsafeCount = 0;
};
