// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/latestvalues.h"
#include "protocol/session/request.h"

#include <deque>
#include <vector>

/// What an observation says about whether the motors have stopped.
enum class Proof { Nothing, Proven, Refuted };

/// How a board's motors are stopped: plain data, provided by the device and carried out by the I/O thread
/// alone, without the worker or the GUI.
struct StopPlan
{
    /// One way of stopping. Its requests are sent ahead of everything, each as soon as the one before is
    /// answered or given up, and again in each period until the stop is proven.
    struct Means
    {
        std::vector<Request> requests;
        milliseconds every{100};
        int maxRounds = 5;  ///< rounds before the next means is tried
        /// What a round sends beside them, from what the answers have told so far; empty: nothing.
        std::function<std::vector<Request>()> more = {};
    };
    std::vector<Means> means;  ///< in order
    /// What an answer to one of the requests proves; empty: nothing.
    std::function<Proof(const Frame &)> fromAnswer;
    /// What telemetry that arrived since the stop began proves; empty: nothing.
    std::function<Proof(const LatestValues &, TimePoint since)> fromTelemetry;
    /// What remains to be sent once the stop is proven, to undo what the means changed apart from stopping:
    /// asked for in each round, from 0 on, until it is nothing. Empty: nothing.
    std::function<std::vector<Request>(int round)> restore;
    milliseconds restoreEvery{500};
    int maxRestoreRounds = 60;
    /// Sent over and over to a board that is deaf for a while and carries out afterwards what has queued up
    /// meanwhile, so that it hears this first; unanswered. The means follow once it hears. Empty: it is never
    /// deaf.
    std::vector<Request> firstHeard;
};

/// Carries out a stop plan. Pure bookkeeping without its own clock, like ControlStream.
class StopSequence
{
public:
    using Answered = std::function<void(const Result<Frame> &)>;
    /// Sends a request at once and calls back with its answer, or the error.
    using Send = std::function<void(const Request &, Answered)>;
    /// Called once with the outcome: success, or NotProven with the number of attempts; of restoring:
    /// success, or NotRestored.
    using Completion = std::function<void(Result<void>)>;

    explicit StopSequence(Send send)
        : m_send(std::move(send))
    {
    }

    /// Starts; a sequence that is still running starts over with this plan, and all callers get the outcome.
    /// @param restored called after a stop that succeeded, once nothing remains to be undone
    void start(StopPlan plan, Completion completion, TimePoint now, Completion restored = {});
    /// A stop that was not proven in time goes on being repeated, and this is called when it is proven.
    void persist(std::function<void()> provenLate) { m_provenLate = std::move(provenLate); }
    /// Ends repeating a stop that was not proven in time. False if there was none.
    bool forgo();
    /// The board hears nothing until then.
    void boardIsDeaf(TimePoint until) { m_deafUntil = until; }
    /// Telemetry arrived.
    void telemetryArrived(const LatestValues &values);
    /// Sends what is due.
    void advance(TimePoint now);
    /// The link is gone.
    void abandon(const Error &why);

    [[nodiscard]] std::optional<TimePoint> nextDeadline() const;
    /// The motors are being stopped; what is undone afterwards does not count.
    [[nodiscard]] bool isActive() const { return m_stage == Stage::Stopping || m_stage == Stage::Repeating; }

private:
    enum class Stage { Inactive, Stopping, Repeating, Restoring };
    void take(Proof proof);
    void sendRound(std::vector<Request> requests, milliseconds every, TimePoint now);
    void beginRound(std::vector<Request> requests, TimePoint now, TimePoint next);
    void sendNext();
    void answered(const Frame &frame);
    void queueOnce(TimePoint now);
    void stopOnce(TimePoint now);
    void repeatOnce(TimePoint now);
    [[nodiscard]] std::vector<Request> requestsOf(const StopPlan::Means &means) const;
    void restoreOnce(TimePoint now);
    void finish(const Result<void> &result);
    void finishRestoring(const Result<void> &result);

    Send m_send;
    StopPlan m_plan;
    std::vector<Completion> m_completions;
    std::vector<Completion> m_restored;
    std::function<void()> m_provenLate;
    Stage m_stage = Stage::Inactive;
    std::size_t m_means = 0;
    int m_rounds = 0;  // of the current means, or of restoring
    int m_allRounds = 0;
    std::deque<Request> m_round;  // what it still has to send
    quint64 m_roundNumber = 0;  // answers to an earlier one do not carry it on
    TimePoint m_startedAt{};
    TimePoint m_nextSend{};
    TimePoint m_roundAt{};
    TimePoint m_deafUntil{};
};
