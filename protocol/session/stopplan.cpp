// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/stopplan.h"

#include <algorithm>
#include <utility>

void StopSequence::start(StopPlan plan, Completion completion, TimePoint now, Completion restored)
{
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
    if (m_stage == Stage::Stopping && m_plan.fromTelemetry)
        take(m_plan.fromTelemetry(values, m_startedAt));
}

// A refutation shows that the current means has not worked yet; its next round follows at its own time.
void StopSequence::take(Proof proof)
{
    if (proof != Proof::Proven || m_stage != Stage::Stopping)
        return;
    m_stage = Stage::Restoring;
    m_rounds = 0;
    m_round.clear();
    m_nextSend = m_startedAt;  // without delay
    finish({});
    if (m_stage == Stage::Restoring && !m_plan.restore)
        finishRestoring({});
}

void StopSequence::advance(TimePoint now)
{
    while (m_stage != Stage::Inactive && now >= m_nextSend) {
        if (m_stage == Stage::Stopping)
            stopOnce(now);
        else
            restoreOnce(now);
    }
}

void StopSequence::stopOnce(TimePoint now)
{
    while (m_means < m_plan.means.size() && m_rounds >= m_plan.means[m_means].maxRounds) {
        ++m_means;
        m_rounds = 0;
    }
    if (m_means >= m_plan.means.size()) {
        m_stage = Stage::Inactive;
        m_restored.clear();
        finish(failure(ErrorCode::NotProven, QStringLiteral("sent %1 times").arg(m_allRounds)));
        return;
    }
    const StopPlan::Means &means = m_plan.means[m_means];
    std::vector<Request> requests = means.requests;
    if (means.more) {
        for (Request &request : means.more())
            requests.push_back(std::move(request));
    }
    ++m_allRounds;
    sendRound(requests, means.every, now);
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
    ++m_roundNumber;
    m_nextSend = now + every;
    m_round.clear();
    for (Request &once : requests) {
        once.timeout = std::max(every / int(requests.size()), milliseconds(1));
        once.idempotent = false;
        m_round.push_back(std::move(once));
    }
    sendNext();
}

// One at a time: some boards' answers cannot be told apart otherwise.
void StopSequence::sendNext()
{
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
    if (m_stage == Stage::Stopping) {
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
