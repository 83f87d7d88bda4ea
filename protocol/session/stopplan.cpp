// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/stopplan.h"

#include <utility>

void StopSequence::start(StopPlan plan, Completion completion, TimePoint now)
{
    m_plan = std::move(plan);
    m_completions.push_back(std::move(completion));
    m_active = true;
    m_means = 0;
    m_rounds = 0;
    m_allRounds = 0;
    m_startedAt = now;
    m_nextSend = now;
    advance(now);
}

void StopSequence::answered(const Frame &frame)
{
    if (m_active && m_plan.fromAnswer)
        take(m_plan.fromAnswer(frame));
}

void StopSequence::telemetryArrived(const LatestValues &values)
{
    if (m_active && m_plan.fromTelemetry)
        take(m_plan.fromTelemetry(values, m_startedAt));
}

// A refutation shows that the current means has not worked yet; its next round follows at its own time.
void StopSequence::take(Proof proof)
{
    if (proof != Proof::Proven)
        return;
    const std::vector<Request> restore = std::exchange(m_plan.restore, {});
    finish({});
    for (const Request &request : restore)
        m_send(request);
}

void StopSequence::advance(TimePoint now)
{
    while (m_active && now >= m_nextSend) {
        while (m_means < m_plan.means.size() && m_rounds >= m_plan.means[m_means].maxRounds) {
            ++m_means;
            m_rounds = 0;
        }
        if (m_means >= m_plan.means.size()) {
            finish(failure(ErrorCode::NotProven, QStringLiteral("sent %1 times").arg(m_allRounds)));
            return;
        }
        const StopPlan::Means means = m_plan.means[m_means];
        ++m_rounds;
        ++m_allRounds;
        m_nextSend = now + means.every;
        for (Request once : means.requests) {
            once.timeout = means.every;  // the next round takes the place of retries
            once.idempotent = false;
            m_send(once);
        }
    }
}

void StopSequence::abandon(const Error &why)
{
    if (m_active)
        finish(tl::unexpected(why));
}

std::optional<TimePoint> StopSequence::nextDeadline() const
{
    return m_active ? std::optional(m_nextSend) : std::nullopt;
}

void StopSequence::finish(const Result<void> &result)
{
    m_active = false;
    for (const Completion &completion : std::exchange(m_completions, {})) {
        if (completion)
            completion(result);
    }
}
