// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/link/virtualchannel.h"

namespace {

constexpr auto kStep = 800us;
constexpr qsizetype kKeptBytes = 512;

}  // namespace

class VirtualMailbox final : public Mailbox
{
public:
    VirtualMailbox(VirtualChannel &channel, std::function<bool(const FrameView &)> filter)
        : m_channel(channel)
        , m_filter(std::move(filter))
    {
        m_channel.m_mailboxes.insert(this);
    }
    ~VirtualMailbox() override { m_channel.m_mailboxes.erase(this); }
    VirtualMailbox(const VirtualMailbox &) = delete;
    VirtualMailbox &operator=(const VirtualMailbox &) = delete;

    void offer(const FrameView &frame)
    {
        if (m_filter(frame))
            m_frames.push_back(Frame(frame));
    }

    Result<Frame> next(milliseconds timeout) override
    {
        const TimePoint end = m_channel.now() + timeout;
        for (;;) {
            if (!m_frames.empty()) {
                Frame frame = std::move(m_frames.front());
                m_frames.pop_front();
                return frame;
            }
            if (const auto stop = m_channel.stopped())
                return tl::unexpected(*stop);
            if (m_channel.now() >= end)
                return failure(ErrorCode::Timeout);
            m_channel.step();
        }
    }

private:
    VirtualChannel &m_channel;
    std::function<bool(const FrameView &)> m_filter;
    std::deque<Frame> m_frames;
};

VirtualChannel::VirtualChannel(SimulatedPort &port, std::unique_ptr<Framer> framer, LinkTiming timing)
    : m_port(port)
    , m_framer(std::move(framer))
    , m_sink([this](const FrameView &frame) {
        const bool claimed = m_queue.frameArrived(frame, now());
        if (m_tap)
            m_tap(frame, now());
        for (VirtualMailbox *mailbox : m_mailboxes) {
            if (!claimed)
                mailbox->offer(frame);
        }
        if (m_stop.isActive() && m_latest)
            m_stop.telemetryArrived(*m_latest);
    })
    , m_queue([this](QByteArrayView bytes) {
        m_bytesOut += bytes.size();
        m_framer->sent(asBytes(bytes));
        m_port.hostWrites(asBytes(bytes));
    })
    , m_timing(std::move(timing))
    , m_control(m_timing.controlPeriod)
    , m_stop([this](const Request &request, const StopSequence::Answered &answered) {
        m_queue.submit(request, answered, now(), TransactionQueue::Lane::Urgent);
    })
{
    m_queue.setPause(m_timing.pause);
    m_lastArrival = m_nextBeat = m_silentUntil = now();
    beat();
}

VirtualChannel::~VirtualChannel() = default;

std::optional<Error> VirtualChannel::stopped() const
{
    if (cancelled())
        return Error{ErrorCode::Cancelled, {}, 0};
    if (m_port.isGone() || isLost())
        return Error{ErrorCode::LinkClosed, {}, 0};
    return {};
}

// Counts silence as a session does (LinkTiming::silenceLimit).
bool VirtualChannel::isLost() const
{
    return m_timing.silenceLimit > 0ms
        && now() >= std::max(m_lastArrival, m_silentUntil) + m_timing.silenceLimit;
}

void VirtualChannel::expectSilence(milliseconds duration)
{
    m_silentUntil = std::max<TimePoint>(m_silentUntil, now() + duration);
}

void VirtualChannel::beat()
{
    if (m_timing.heartbeatPeriod <= 0ms || !m_timing.heartbeat || now() < m_nextBeat)
        return;
    m_nextBeat = now() + m_timing.heartbeatPeriod;
    m_queue.sendUnanswered(m_timing.heartbeat(), now());
}

void VirtualChannel::step()
{
    m_port.advance(kStep);
    for (const QByteArray &bytes : m_port.hostReads()) {
        m_observed.bytesIn += quint64(bytes.size());
        if (m_framer->statistics().frames == 0)
            m_observed.lastBytes = (m_observed.lastBytes + bytes).right(kKeptBytes);
        if (m_observed.bytesIn > quint64(bytes.size()))
            m_observed.noteArrival(m_lastArrival, now());
        m_lastArrival = now();
        m_framer->feed(asBytes(bytes), m_sink);
        if (m_port.isPacketBased())
            m_framer->packetEnded(m_sink);
    }
    if (m_framer->isWaiting() && now() - m_lastArrival > m_framer->gap())
        m_framer->flush(m_sink);
    while (const auto frame = m_control.advance(now(), m_latest.get())) {
        if (!frame->isEmpty() && (!m_control.isStreaming() || !m_queue.isCrowded(now())))
            m_queue.sendUnanswered(*frame, now());
        if (const Request *question = m_control.question(); question && !std::exchange(m_isAsking, true)) {
            m_queue.submit(
                *question,
                [this](const Result<Frame> &answer) {
                    m_isAsking = false;
                    if (answer)
                        m_control.answered(*answer);
                },
                now(), TransactionQueue::Lane::Urgent);
        }
    }
    if (const auto outcome = m_control.takeOutcome())
        m_stoodStill = outcome;
    m_stop.advance(now());
    beat();
    m_queue.bytesTaken(1 << 20, now());
    m_queue.advance(now());
}

Result<Frame> VirtualChannel::transact(const Request &request)
{
    if (const auto stop = stopped())
        return tl::unexpected(*stop);
    std::optional<Result<Frame>> result;
    const auto id = m_queue.submit(
        request, [&result](Result<Frame> r) { result.emplace(std::move(r)); }, now());
    while (!result) {
        if (cancelled()) {
            m_queue.cancel(id);
            break;
        }
        if (m_port.isGone() || isLost()) {
            m_queue.cancelAll({ErrorCode::LinkClosed, {}, 0});
            break;
        }
        step();
    }
    return *result;
}

void VirtualChannel::post(const Request &request)
{
    m_queue.submit(request, {}, now());
}

void VirtualChannel::stopMotors(const StopPlan &plan)
{
    m_control.motorsStopped(now());
    m_stop.start(
        plan, [this](const Result<void> &result) { m_stopped = result; }, now());
}

Result<void> VirtualChannel::sleep(milliseconds duration)
{
    const TimePoint end = now() + duration;
    while (now() < end) {
        if (const auto stop = stopped())
            return tl::unexpected(*stop);
        step();
    }
    return {};
}

std::unique_ptr<Mailbox> VirtualChannel::listen(std::function<bool(const FrameView &)> filter)
{
    return std::make_unique<VirtualMailbox>(*this, std::move(filter));
}

Result<void> VirtualChannel::setLine(const LineSettings &line)
{
    m_port.setHostLine(line);
    m_queue.setLine(line);
    return {};
}

LinkObservation VirtualChannel::observation() const
{
    LinkObservation observation = m_observed;
    observation.framing = m_framer->statistics();
    observation.isPacketBased = m_port.isPacketBased();
    return observation;
}

void VirtualChannel::progress(const Progress &progress)
{
    m_progress.push_back(progress);
    if (m_operator)
        m_operator(progress);
}
