// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/stopplan.h"

#include <algorithm>
#include <utility>

namespace {

// Of a stop that was not proven in time: seldom enough to leave room for the rest, and patient enough for a
// line that was too slow for the proof.
constexpr auto kRepeatEvery = 1s;
constexpr auto kRepeatPatience = 1200ms;
constexpr auto kRepeatPatienceWithMore = 300ms;
constexpr auto kQueueEvery = 400ms;  // to a deaf board: a packet of them may be lost
constexpr int kMostPatience = 4;  // times that: of a board that answers later than anybody waits

}  // namespace

void StopSequence::start(StopPlan plan, Completion completion, TimePoint now, Completion restored)
{
    if (m_stage == Stage::Repeating)
        m_restored.clear();  // told once
    m_plan = std::move(plan);
    m_completions.push_back(std::move(completion));
    m_restored.push_back(std::move(restored));
    m_stage = Stage::Stopping;
    m_means = 0;
    m_rounds = 0;
    m_allRounds = 0;
    m_startedAt = now;
    m_nextSend = now;
    advance(now);
}

void StopSequence::answered(const Frame &frame)
{
    if (m_stage != Stage::Inactive && m_plan.fromAnswer)
        take(m_plan.fromAnswer(frame));
}

void StopSequence::telemetryArrived(const LatestValues &values)
{
    if (isActive() && m_plan.fromTelemetry)
        take(m_plan.fromTelemetry(values, m_startedAt));
}

// A refutation shows that the current means has not worked yet; its next round follows at its own time.
void StopSequence::take(Proof proof)
{
    if (proof != Proof::Proven || !isActive())
        return;
    const bool isLate = m_stage == Stage::Repeating;
    m_stage = Stage::Restoring;
    m_rounds = 0;
    m_round.clear();
    m_nextSend = m_startedAt;  // without delay
    if (isLate)
        m_provenLate();
    finish({});
    if (m_stage == Stage::Restoring && !m_plan.restore)
        finishRestoring({});
}

void StopSequence::advance(TimePoint now)
{
    while (m_stage != Stage::Inactive && now >= m_nextSend) {
        if (isActive() && now < m_deafUntil && !m_plan.firstHeard.empty())
            queueOnce(now);
        else if (m_stage == Stage::Stopping)
            stopOnce(now);
        else if (m_stage == Stage::Repeating)
            repeatOnce(now);
        else
            restoreOnce(now);
    }
}

// No rounds are counted and nothing is asked: it would all be carried out in a burst.
void StopSequence::queueOnce(TimePoint now)
{
    beginRound(m_plan.firstHeard, now, std::min<TimePoint>(now + kQueueEvery, m_deafUntil));
}

void StopSequence::stopOnce(TimePoint now)
{
    while (m_means < m_plan.means.size() && m_rounds >= m_plan.means[m_means].maxRounds) {
        ++m_means;
        m_rounds = 0;
    }
    if (m_means >= m_plan.means.size()) {
        const bool goesOn = m_provenLate && !m_plan.means.empty();
        m_stage = goesOn ? Stage::Repeating : Stage::Inactive;
        if (!goesOn)
            m_restored.clear();
        finish(failure(ErrorCode::NotProven, QStringLiteral("sent %1 times").arg(m_allRounds)));
        return;
    }
    const StopPlan::Means &means = m_plan.means[m_means];
    ++m_allRounds;
    sendRound(requestsOf(means), means.every, now);
}

std::vector<Request> StopSequence::requestsOf(const StopPlan::Means &means) const
{
    std::vector<Request> requests = means.requests;
    if (means.more) {
        for (Request &request : means.more())
            requests.push_back(std::move(request));
    }
    return requests;
}

// The next round begins when this one has been answered or given up.
void StopSequence::repeatOnce(TimePoint now)
{
    const StopPlan::Means &means = m_plan.means.back();
    std::vector<Request> requests = requestsOf(means);
    int before = 0;
    for (const StopPlan::Means &each : m_plan.means)
        before += each.maxRounds;
    const int repeats = ++m_allRounds - before;
    const milliseconds patience = kRepeatPatience * std::clamp(repeats, 1, kMostPatience);
    milliseconds all{};
    for (std::size_t i = 0; i < requests.size(); ++i) {
        requests[i].timeout = i < means.requests.size() ? patience : kRepeatPatienceWithMore;
        all += requests[i].timeout;
    }
    beginRound(std::move(requests), now, now + std::max<milliseconds>(all, kRepeatEvery));
}

bool StopSequence::forgo()
{
    if (m_stage != Stage::Repeating)
        return false;
    m_stage = Stage::Inactive;
    m_round.clear();
    m_restored.clear();
    return true;
}

void StopSequence::restoreOnce(TimePoint now)
{
    const std::vector<Request> requests = m_plan.restore(m_rounds);
    if (requests.empty())
        finishRestoring({});
    else if (m_rounds >= m_plan.maxRestoreRounds)
        finishRestoring(failure(ErrorCode::NotRestored));
    else
        sendRound(requests, m_plan.restoreEvery, now);
}

// The next round takes the place of retries.
void StopSequence::sendRound(std::vector<Request> requests, milliseconds every, TimePoint now)
{
    ++m_rounds;
    for (Request &once : requests)
        once.timeout = std::max(every / int(requests.size()), milliseconds(1));
    beginRound(std::move(requests), now, now + every);
}

void StopSequence::beginRound(std::vector<Request> requests, TimePoint now, TimePoint next)
{
    ++m_roundNumber;
    m_roundAt = now;
    m_nextSend = next;
    m_round.clear();
    for (Request &once : requests) {
        once.idempotent = false;
        m_round.push_back(std::move(once));
    }
    sendNext();
}

// One at a time: some boards' answers cannot be told apart otherwise.
void StopSequence::sendNext()
{
    if (m_round.empty() && m_stage == Stage::Repeating)
        m_nextSend = m_roundAt + kRepeatEvery;
    if (m_round.empty() || m_stage == Stage::Inactive)
        return;
    const Request request = std::move(m_round.front());
    m_round.pop_front();
    m_send(request, [this, number = m_roundNumber](const Result<Frame> &result) {
        if (result)
            answered(*result);
        if (number == m_roundNumber)
            sendNext();
    });
}

void StopSequence::abandon(const Error &why)
{
    if (isActive()) {
        m_stage = Stage::Inactive;
        m_restored.clear();
        finish(tl::unexpected(why));
    } else if (m_stage == Stage::Restoring) {
        finishRestoring(tl::unexpected(why));
    }
}

std::optional<TimePoint> StopSequence::nextDeadline() const
{
    return m_stage != Stage::Inactive ? std::optional(m_nextSend) : std::nullopt;
}

void StopSequence::finish(const Result<void> &result)
{
    for (const Completion &completion : std::exchange(m_completions, {})) {
        if (completion)
            completion(result);
    }
}

void StopSequence::finishRestoring(const Result<void> &result)
{
    m_stage = Stage::Inactive;
    for (const Completion &restored : std::exchange(m_restored, {})) {
        if (restored)
            restored(result);
    }
}
