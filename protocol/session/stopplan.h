// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/latestvalues.h"
#include "protocol/session/request.h"

#include <vector>

/// What an observation says about whether the motors have stopped.
enum class Proof { Nothing, Proven, Refuted };

/// How a board's motors are stopped: plain data, provided by the device and carried out by the I/O thread
/// alone, without the worker or the GUI.
struct StopPlan
{
    /// One way of stopping. All requests are sent at once, ahead of everything, and again in each period
    /// until the stop is proven.
    struct Means
    {
        std::vector<Request> requests;
        milliseconds every{100};
        int maxRounds = 5;  ///< rounds before the next means is tried
    };
    std::vector<Means> means;  ///< in order
    /// What an answer to one of the requests proves; empty: nothing.
    std::function<Proof(const Frame &)> fromAnswer;
    /// What telemetry that arrived since the stop began proves; empty: nothing.
    std::function<Proof(const LatestValues &, TimePoint since)> fromTelemetry;
    /// Sent once the stop is proven: undoes what the means changed apart from stopping.
    std::vector<Request> restore;
};

/// Carries out a stop plan. Pure bookkeeping without its own clock, like ControlStream.
class StopSequence
{
public:
    using Send = std::function<void(const Request &)>;
    /// Called once with the outcome: success, or NotProven with the number of attempts.
    using Completion = std::function<void(Result<void>)>;

    explicit StopSequence(Send send)
        : m_send(std::move(send))
    {
    }

    /// Starts; a sequence that is still running starts over with this plan, and all callers get the outcome.
    void start(StopPlan plan, Completion completion, TimePoint now);
    /// An answer to one of the requests arrived.
    void answered(const Frame &frame);
    /// Telemetry arrived.
    void telemetryArrived(const LatestValues &values);
    /// Sends what is due.
    void advance(TimePoint now);
    /// The link is gone.
    void abandon(const Error &why);

    [[nodiscard]] std::optional<TimePoint> nextDeadline() const;
    [[nodiscard]] bool isActive() const { return m_active; }

private:
    void take(Proof proof);
    void finish(const Result<void> &result);

    Send m_send;
    StopPlan m_plan;
    std::vector<Completion> m_completions;
    bool m_active = false;
    std::size_t m_means = 0;
    int m_rounds = 0;  // of the current means
    int m_allRounds = 0;
    TimePoint m_startedAt{};
    TimePoint m_nextSend{};
};
