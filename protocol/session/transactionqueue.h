// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/request.h"
#include "protocol/transport/linkaddress.h"

#include <deque>
#include <vector>

/// Requests, their answers and their timeouts. Pure bookkeeping: no event loop, no clock of its own; the time
/// is passed to every call, so the session drives it with the real clock and tests with a virtual one.
///
/// Each request completes exactly once: reply, the board's refusal, timeout, cancelled or link closed. Normal
/// requests are sent one at a time with a pause between them; urgent ones are sent at once, whatever is in
/// flight. The answer timer starts when the last byte has been sent. After a timeout, requests of the same
/// kind are held back until the late answer has come or can no longer come, so that it is never taken for the
/// answer to another request. The same goes for the further answers to one that was sent several times: they
/// come as late as the first did.
class TransactionQueue
{
public:
    using Completion = std::function<void(Result<Frame>)>;
    using Write = std::function<void(QByteArrayView)>;
    using Id = quint64;
    enum class Lane { Normal, Urgent };

    explicit TransactionQueue(Write write);

    Id submit(Request request, Completion completion, TimePoint now, Lane lane = Lane::Normal);
    /// Sends bytes that are not answered, at once (control stream, keep-alive).
    void sendUnanswered(QByteArrayView bytes, TimePoint now);
    void cancel(Id id);
    void cancelAll(const Error &why);

    /// True if the frame answered a request (even if late).
    bool frameArrived(const FrameView &frame, TimePoint now);
    /// The system has taken this many bytes from the transport.
    void bytesTaken(qint64 count, TimePoint now);
    /// Handles whatever is due: timeouts, retries, the next request.
    void advance(TimePoint now);
    /// Latest time at which advance() must be called; empty: nothing is due until the next event.
    [[nodiscard]] std::optional<TimePoint> nextDeadline(TimePoint now) const;

    /// Line settings determine how long bytes take to send; empty for links without a line rate.
    void setLine(std::optional<LineSettings> line) { m_line = line; }
    /// Pause after each command (document "Message format": 10-20 ms so the board's input buffer never
    /// overflows).
    void setPause(milliseconds pause) { m_pause = pause; }
    [[nodiscard]] bool isIdle() const { return count() == 0; }
    /// Requests that are not completed yet.
    [[nodiscard]] std::size_t count() const { return m_waiting.size() + m_inFlight.size(); }
    /// From when on a normal request would go out at once; empty while others are before it.
    [[nodiscard]] std::optional<TimePoint> readyAt() const;
    /// What is sent now would pile up behind bytes that have not left yet, or hold up a request that waits
    /// for nothing but the pause before it.
    [[nodiscard]] bool isCrowded(TimePoint now) const;
    /// True when a normal request of this kind would wait because an answer to an earlier one may still come.
    [[nodiscard]] bool isHeld(int kind) const;
    /// Time between the last byte sent and the answer of the newest request; empty while it stays without
    /// one.
    [[nodiscard]] std::optional<Duration> roundTrip() const { return m_roundTrip; }
    [[nodiscard]] quint64 timeouts() const { return m_timeouts; }

private:
    struct Pending
    {
        Id id = 0;
        Request request;
        Completion completion;
        Lane lane = Lane::Normal;
        int sends = 0;
        bool hasLeft = false;  // the system has taken the most recent transmission
        int refused = 0;  // refusals after which it was sent again
        TimePoint firstSentAt{};
        TimePoint sentAt{};  // when the line will have carried the last byte, for the round trip
        TimePoint leftAt{};  // when the last byte has certainly been sent, for the timeout
        TimePoint deadline{};
    };
    struct StaleReply  // a late answer that belongs to no pending request
    {
        AnswerMatcher answer;
        int kind = 0;
        TimePoint until{};
        Id id = 0;
        TimePoint firstSentAt{};
        TimePoint lastSentAt{};
    };

    void send(Pending &pending, TimePoint now);
    TimePoint account(qint64 bytes, TimePoint now);
    void complete(const Pending &pending, Result<Frame> result);
    void expectStaleReply(const Pending &pending, TimePoint now, int answers);
    /// A late answer has told how slow the board is: its further ones come as late.
    void learnLateness(const StaleReply &come, TimePoint now);
    [[nodiscard]] static bool mayRepeat(const Pending &pending);
    [[nodiscard]] bool normalInFlight() const;
    /// An answer to an earlier request may still come, and would be taken for that of the first that waits.
    [[nodiscard]] bool isFirstHeld() const;
    [[nodiscard]] Duration timeoutOf(const Request &request) const;
    void startNext(TimePoint now);

    Write m_write;
    std::optional<LineSettings> m_line;
    milliseconds m_pause = 10ms;
    std::deque<Pending> m_waiting;
    std::vector<Pending> m_inFlight;
    std::vector<StaleReply> m_staleReplies;
    Id m_lastId = 0;
    TimePoint m_lineFreeAt{};
    TimePoint m_pauseUntil{};
    qint64 m_untaken = 0;
    std::optional<Duration> m_roundTrip;
    quint64 m_timeouts = 0;
};
