// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/progress.h"
#include "protocol/session/controlstream.h"
#include "protocol/session/framer.h"
#include "protocol/session/request.h"
#include "protocol/transport/linkaddress.h"

#include <memory>

/// Unsolicited frames (second confirmations, progress reports), kept from the moment the mailbox exists.
class Mailbox
{
public:
    virtual ~Mailbox() = default;
    /// The next kept frame; waits for it at most `timeout`. Errors: Timeout, Cancelled, LinkClosed.
    virtual Result<Frame> next(milliseconds timeout) = 0;
};

/// What was received so far, to tell a silent port from one that speaks another protocol.
struct LinkObservation
{
    FramerStatistics framing;
    quint64 bytesIn = 0;
    bool isPacketBased = false;  ///< what is sent at once arrives whole, or not at all
    bool isReplayed = false;  ///< a recording answers, and only what it was asked then
    QByteArray lastBytes;  ///< the most recent bytes, kept only until a frame is understood
    /// The last time that nothing at all came for at least kSilence: how long, and when something came again.
    Duration lastSilence{};
    TimePoint silenceEnd{};

    static constexpr auto kSilence = 500ms;
    /// Something came at `now`, and before that at `before` (the epoch: never).
    void noteArrival(TimePoint before, TimePoint now)
    {
        if (before == TimePoint{} || now - before < kSilence)
            return;
        lastSilence = now - before;
        silenceEnd = now;
    }
};

/// What family code talks to: a synchronous view of one link. In production it runs on the worker thread, in
/// tests on a single thread with virtual time.
class Channel
{
public:
    virtual ~Channel() = default;

    /// Sends the request and waits for its answer. Errors: the board's refusal, Timeout, Cancelled,
    /// LinkClosed.
    virtual Result<Frame> transact(const Request &request) = 0;
    /// Sends without waiting for an answer, even from a cancelled job: "stop" must get through.
    virtual void post(const Request &request) = 0;
    /// Waits. Errors: Cancelled, and LinkClosed as soon as a link that was open is closed.
    virtual Result<void> sleep(milliseconds duration) = 0;
    /// Keeps every frame that the filter accepts and that answers no request, as long as the mailbox exists.
    virtual std::unique_ptr<Mailbox> listen(std::function<bool(const FrameView &)> filter) = 0;
    /// Changes rate and parity of the line. Errors: Unsupported if the port refuses them.
    virtual Result<void> setLine(const LineSettings &line) = 0;
    /// Steers with these frames from now on; must be repeated at least every 250 ms (see ControlStream).
    virtual void steer(const ControlFrames &frames) = 0;
    /// Ends steering: stops, then returns control to whichever source had it before.
    virtual void releaseControl() = 0;
    /// Motors are about to be started: a stop that is still repeated without proof ends.
    virtual void allowMotors() { }
    /// Stops the motors, ahead of everything, even from a cancelled job. Does not wait for the result.
    virtual void stopMotors(const StopPlan &plan) = 0;
    /// The board will be silent for this long without the link counting as lost.
    virtual void expectSilence(milliseconds duration) = 0;
    /// Nothing is sent for this long but what this job itself sends: a board that is deaf would carry all of
    /// it out afterwards, in a burst.
    virtual void keepQuiet(milliseconds) { }
    [[nodiscard]] virtual bool cancelled() const = 0;
    /// While it is held, a job that is cancelled goes on: what it has begun would be left half done
    /// (Unbroken).
    virtual void holdCancel(bool) { }
    virtual void progress(const Progress &progress) = 0;
    /// Time as the job sees it (virtual in tests).
    [[nodiscard]] virtual TimePoint now() const = 0;
    [[nodiscard]] virtual LinkObservation observation() const = 0;
};

/// As long as it exists, what is begun on the channel is ended before the job is cancelled. Not to be nested.
class Unbroken
{
public:
    explicit Unbroken(Channel &channel)
        : m_channel(channel)
    {
        m_channel.holdCancel(true);
    }
    ~Unbroken() { m_channel.holdCancel(false); }
    Unbroken(const Unbroken &) = delete;
    Unbroken &operator=(const Unbroken &) = delete;

private:
    Channel &m_channel;
};
