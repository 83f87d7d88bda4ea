// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/transactionqueue.h"

#include <algorithm>
#include <utility>

namespace {

// Longest time to wait for a late answer before its kind may be asked again.
constexpr auto kLateAnswerWindow = 500ms;
// The same where a board has answered, or kept silent, for longer.
constexpr auto kLongestWindow = 3s;

// An answer came, or was waited for in vain, `now`: one to what was sent last may be as slow, and somewhat
// slower.
TimePoint lastAnswerBy(TimePoint firstSent, TimePoint lastSent, TimePoint now)
{
    const Duration slowest = std::max(Duration::zero(), now - firstSent);
    return std::min<TimePoint>(lastSent + slowest + slowest / 2, now + kLongestWindow);
}

}  // namespace

TransactionQueue::TransactionQueue(Write write)
    : m_write(std::move(write))
{
}

TransactionQueue::Id TransactionQueue::submit(Request request, Completion completion, TimePoint now,
                                              Lane lane)
{
    Pending pending;
    pending.id = ++m_lastId;
    pending.request = std::move(request);
    pending.completion = std::move(completion);
    pending.lane = lane;
    const Id id = pending.id;
    if (lane == Lane::Normal) {
        m_waiting.push_back(std::move(pending));
        startNext(now);
        return id;
    }
    send(pending, now);
    if (pending.request.answer)
        m_inFlight.push_back(std::move(pending));
    else
        complete(pending, Frame());
    return id;
}

void TransactionQueue::sendUnanswered(QByteArrayView bytes, TimePoint now)
{
    account(bytes.size(), now);
    m_write(bytes);
}

void TransactionQueue::cancel(Id id)
{
    const auto isIt = [id](const Pending &pending) { return pending.id == id; };
    if (const auto it = std::find_if(m_waiting.begin(), m_waiting.end(), isIt); it != m_waiting.end()) {
        Pending pending = std::move(*it);
        m_waiting.erase(it);
        complete(pending, failure(ErrorCode::Cancelled));
        return;
    }
    if (const auto it = std::find_if(m_inFlight.begin(), m_inFlight.end(), isIt); it != m_inFlight.end()) {
        Pending pending = std::move(*it);
        m_inFlight.erase(it);
        expectStaleReply(pending, pending.leftAt, pending.sends - pending.refused);
        complete(pending, failure(ErrorCode::Cancelled));
    }
}

void TransactionQueue::cancelAll(const Error &why)
{
    // Completions may submit new requests; those belong to the next round.
    auto waiting = std::exchange(m_waiting, {});
    auto inFlight = std::exchange(m_inFlight, {});
    m_staleReplies.clear();
    m_untaken = 0;
    m_lineFreeAt = {};
    m_pauseUntil = {};
    for (Pending &pending : inFlight)
        complete(pending, tl::unexpected(why));
    for (Pending &pending : waiting)
        complete(pending, tl::unexpected(why));
}

bool TransactionQueue::frameArrived(const FrameView &frame, TimePoint now)
{
    for (auto it = m_inFlight.begin(); it != m_inFlight.end(); ++it) {
        auto answer = it->request.answer(frame);
        if (!answer)
            continue;
        if (!answer->has_value() && answer->error().code == ErrorCode::Damaged && mayRepeat(*it)) {
            ++it->refused;
            send(*it, now);
            return true;
        }
        Pending pending = std::move(*it);
        m_inFlight.erase(it);
        // Which of several transmissions it answers cannot be told: no slow board is said to be a fast one.
        m_roundTrip
            = std::max(Duration::zero(), now - (pending.refused > 0 ? pending.sentAt : pending.firstSentAt));
        expectStaleReply(pending, now, pending.sends - pending.refused - 1);
        complete(pending, std::move(*answer));
        startNext(now);
        return true;
    }
    for (auto it = m_staleReplies.begin(); it != m_staleReplies.end(); ++it) {
        if (!it->answer(frame))
            continue;
        const StaleReply come = std::move(*it);
        m_staleReplies.erase(it);
        m_roundTrip = now - come.firstSentAt;
        learnLateness(come, now);
        startNext(now);
        return true;
    }
    return false;
}

void TransactionQueue::bytesTaken(qint64 count, TimePoint now)
{
    if (m_untaken == 0)
        return;
    m_untaken = std::max<qint64>(0, m_untaken - count);
    if (m_untaken > 0)
        return;
    // The last byte has only now been handed over: the answer timers of what was sent meanwhile start here.
    // Timers that already run are not extended by heartbeats and set-points.
    for (Pending &pending : m_inFlight) {
        if (std::exchange(pending.hasLeft, true))
            continue;
        pending.leftAt = std::max(pending.leftAt, now);
        pending.deadline = pending.leftAt + timeoutOf(pending.request);
    }
}

void TransactionQueue::advance(TimePoint now)
{
    std::erase_if(m_staleReplies, [now](const StaleReply &stale) { return stale.until <= now; });
    for (std::size_t i = 0; i < m_inFlight.size();) {
        Pending &pending = m_inFlight[i];
        if (m_untaken > 0 && !pending.hasLeft)
            pending.deadline = std::max(pending.deadline, now + timeoutOf(pending.request));
        if (pending.deadline > now) {
            ++i;
            continue;
        }
        if (mayRepeat(pending)) {
            send(pending, now);
            ++i;
            continue;
        }
        ++m_timeouts;
        m_roundTrip.reset();
        Pending late = std::move(pending);
        m_inFlight.erase(m_inFlight.begin() + static_cast<std::ptrdiff_t>(i));
        expectStaleReply(late, now, late.sends - late.refused);
        const QString name = late.request.name;
        complete(late, failure(ErrorCode::Timeout, name));
        i = 0;  // the completion may have changed the list
    }
    startNext(now);
}

std::optional<TimePoint> TransactionQueue::nextDeadline(TimePoint now) const
{
    std::optional<TimePoint> next;
    const auto consider = [&next](TimePoint time) { next = next ? std::min(*next, time) : time; };
    for (const Pending &pending : m_inFlight)
        consider(pending.deadline);
    for (const StaleReply &stale : m_staleReplies)
        consider(stale.until);
    if (!m_waiting.empty() && !normalInFlight() && !isFirstHeld())
        consider(std::max(now, m_pauseUntil));
    return next;
}

std::optional<TimePoint> TransactionQueue::readyAt() const
{
    return m_waiting.empty() && !normalInFlight() ? std::optional(m_pauseUntil) : std::nullopt;
}

void TransactionQueue::send(Pending &pending, TimePoint now)
{
    ++pending.sends;
    pending.hasLeft = false;
    pending.sentAt = pending.leftAt = account(pending.request.bytes.size(), now);
    if (pending.sends == 1)
        pending.firstSentAt = pending.sentAt;
    pending.deadline = pending.leftAt + timeoutOf(pending.request);
    m_write(pending.request.bytes);
}

// Calculates when the line will have carried these bytes, and from when on the next command may follow.
TimePoint TransactionQueue::account(qint64 bytes, TimePoint now)
{
    m_untaken += bytes;
    m_lineFreeAt
        = std::max(m_lineFreeAt, now) + durationFromSeconds(m_line ? m_line->secondsFor(bytes) : 0.0);
    m_pauseUntil = m_lineFreeAt + m_pause;
    return m_lineFreeAt;
}

void TransactionQueue::complete(const Pending &pending, Result<Frame> result)
{
    if (pending.completion)
        pending.completion(std::move(result));
}

void TransactionQueue::expectStaleReply(const Pending &pending, TimePoint now, int answers)
{
    if (!pending.request.answer)
        return;
    const TimePoint until = std::max(now + std::max<Duration>(kLateAnswerWindow, timeoutOf(pending.request)),
                                     lastAnswerBy(pending.firstSentAt, pending.sentAt, now));
    for (int i = 0; i < answers; ++i)
        m_staleReplies.push_back({pending.request.answer, pending.request.kind, until, pending.id,
                                  pending.firstSentAt, pending.sentAt});
}

void TransactionQueue::learnLateness(const StaleReply &come, TimePoint now)
{
    const TimePoint until = lastAnswerBy(come.firstSentAt, come.lastSentAt, now);
    for (StaleReply &stale : m_staleReplies) {
        if (stale.id == come.id)
            stale.until = std::max(stale.until, until);
    }
}

bool TransactionQueue::isCrowded(TimePoint now) const
{
    const bool isNext = !m_waiting.empty() && !normalInFlight() && !isFirstHeld();
    return m_untaken > 0 || m_lineFreeAt > now || (isNext && m_pauseUntil > now);
}

bool TransactionQueue::isHeld(int kind) const
{
    return std::any_of(m_staleReplies.begin(), m_staleReplies.end(),
                       [kind](const StaleReply &stale) { return stale.kind == kind; });
}

bool TransactionQueue::isFirstHeld() const
{
    const Request &first = m_waiting.front().request;
    return !first.repeated && isHeld(first.kind);
}

bool TransactionQueue::mayRepeat(const Pending &pending)
{
    return pending.request.idempotent && pending.sends <= pending.request.retries;
}

bool TransactionQueue::normalInFlight() const
{
    return std::any_of(m_inFlight.begin(), m_inFlight.end(),
                       [](const Pending &pending) { return pending.lane == Lane::Normal; });
}

Duration TransactionQueue::timeoutOf(const Request &request) const
{
    // Twice the reply's own time: a telemetry frame may be in front of it in the board's output buffer.
    const double wire = m_line ? 2.0 * m_line->secondsFor(request.replyBytes) : 0.0;
    return request.timeout + durationFromSeconds(wire);
}

void TransactionQueue::startNext(TimePoint now)
{
    while (!m_waiting.empty() && !normalInFlight() && m_pauseUntil <= now) {
        if (isFirstHeld())
            return;
        Pending pending = std::move(m_waiting.front());
        m_waiting.pop_front();
        send(pending, now);
        if (pending.request.answer) {
            m_inFlight.push_back(std::move(pending));
            return;
        }
        complete(pending, Frame());
    }
}
