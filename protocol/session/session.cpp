// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/session.h"

#include <QLoggingCategory>

#include <algorithm>
#include <numeric>

Q_LOGGING_CATEGORY(logSession, "gimbal.session", QtWarningMsg)

namespace {

// Bytes kept while no frame was understood, to identify the protocol that is spoken instead.
constexpr qsizetype kKeptBytes = 512;

// While requests follow one another without a pause, a poll takes its turn after this time; on a slow line
// after three times what the last one took, so that most of the line is left to the requests.
constexpr auto kPollPatience = 90ms;
constexpr auto kMaxPollPatience = 500ms;
constexpr int kPollShare = 3;
constexpr auto kBlindStops = 50ms;

qint64 slotOf(TimePoint now)
{
    return std::chrono::duration_cast<milliseconds>(now.time_since_epoch()).count() / 100;
}

}  // namespace

Session::Session(TransportFactory makeTransport, QObject *parent)
    : QObject(parent)
    , m_makeTransport(std::move(makeTransport))
    , m_sink([this](const FrameView &frame) { onFrame(frame); })
    , m_queue([this](QByteArrayView bytes) { send(bytes); })
    , m_stop([this](const Request &request, const StopSequence::Answered &answered) {
        m_queue.submit(request, answered, Clock::now(), TransactionQueue::Lane::Urgent);
    })
    , m_timer(this)
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &Session::onTick);
    m_stop.persist([this] { emit motorsStoppedLate(); });
}

Session::~Session()
{
    m_stop.abandon({ErrorCode::LinkClosed, {}});
    m_queue.cancelAll({ErrorCode::LinkClosed, {}});
}

void Session::send(QByteArrayView bytes)
{
    if (!m_transport)
        return;
    m_bytesOut += static_cast<quint64>(bytes.size());
    m_framer->sent(asBytes(bytes));
    if (m_probe)
        m_probe->sent(asBytes(bytes), Clock::now());
    m_transport->write(bytes);
    for (FrameListener *listener : m_listeners)
        listener->bytesSent(bytes, Clock::now());
}

void Session::open(const LinkAddress &address, std::unique_ptr<Framer> framer, LinkTiming timing)
{
    close({ErrorCode::Cancelled, {}});
    auto transport = m_makeTransport(address);
    if (!transport) {
        emit closed(transport.error());
        return;
    }
    m_transport = std::move(*transport);
    m_framer = std::move(framer);
    m_timing = std::move(timing);
    const bool isLive = !m_transport->replay();
    m_probe = isLive && m_timing.makeProbe ? m_timing.makeProbe() : nullptr;
    m_control = ControlStream(m_timing.controlPeriod);
    m_control.bar(Clock::now());
    m_queue.setPause(m_timing.pause);
    m_bytesOut = 0;
    m_observed = {};
    m_rateSlots = {};
    m_queue.setLine(m_transport->line());
    connect(m_transport.get(), &Transport::received, this, &Session::onReceived);
    connect(m_transport.get(), &Transport::bytesWritten, this, [this](qint64 count) {
        m_queue.bytesTaken(count, Clock::now());
        schedule();
    });
    connect(m_transport.get(), &Transport::opened, this, [this] {
        m_open = true;
        m_backAt.reset();
        m_arrival = m_nextBeat = m_nextBlindStop = m_silentUntil = Clock::now();
        qCInfo(logSession) << "link open";
        schedule();
        emit opened();
    });
    connect(m_transport.get(), &Transport::closed, this, &Session::close);
    connect(m_transport.get(), &Transport::replayed, this, [this](QByteArrayView bytes, TimePoint at) {
        m_framer->sent(asBytes(bytes));
        for (FrameListener *listener : m_listeners)
            listener->bytesSent(bytes, at);
    });
    m_transport->open();
}

void Session::close(const Error &why)
{
    if (!m_transport)
        return;
    if (m_open && why.code == ErrorCode::Cancelled && !m_shutdownFrames.isEmpty())
        send(m_shutdownFrames);
    m_shutdownFrames.clear();
    qCInfo(logSession) << "link closed:" << int(why.code) << why.detail;
    m_transport->disconnect(this);
    m_transport->close();
    // The transport may be the caller.
    m_transport.release()->deleteLater();
    m_open = false;
    m_stop.boardIsDeaf({});
    m_timer.stop();
    m_poll.reset();
    m_pollRunning = false;
    const bool wasSteering = m_control.isSteering();
    if (wasSteering && m_control.canProve())
        m_leftSteering = m_control.frames();
    m_control.drop();
    m_controlAsked = false;
    m_stop.abandon({ErrorCode::LinkClosed, why.detail});
    m_queue.cancelAll({ErrorCode::LinkClosed, why.detail});
    m_stillAsked = false;
    if (wasSteering)
        emit steeringEnded(false);
    emit closed(why);
    tellFinished();
}

void Session::finish(std::function<void()> then)
{
    m_finishing.push_back(std::move(then));
    m_control.end(Clock::now());
    if (!m_open || isReadyToFinish())
        finishNow();
    else
        schedule();
}

void Session::leaveRestarted(const Error &why)
{
    if (m_control.isActive() && m_control.canProve())
        finish({});
    else
        close(why);
}

bool Session::isReadyToFinish() const
{
    return !m_finishing.empty() && !m_control.isActive() && !m_controlAsked;
}

void Session::finishNow()
{
    close({ErrorCode::Cancelled, {}});
    tellFinished();
}

void Session::tellFinished()
{
    for (const auto &then : std::exchange(m_finishing, {})) {
        if (then)
            then();
    }
}

bool Session::setLine(const LineSettings &line)
{
    if (!m_transport || !m_transport->setLine(line))
        return false;
    m_queue.setLine(m_transport->line());
    return true;
}

TransactionQueue::Id Session::submit(Request request, TransactionQueue::Completion completion)
{
    if (!m_open) {
        if (completion)
            completion(failure(ErrorCode::LinkClosed));
        return 0;
    }
    const auto id = m_queue.submit(std::move(request), std::move(completion), Clock::now());
    schedule();
    return id;
}

void Session::setPoll(std::optional<Request> request, milliseconds interval)
{
    m_poll = std::move(request);
    m_pollInterval = interval;
    m_nextPoll = m_pollEndedAt = Clock::now();
    m_pollTook = {};
    schedule();
}

void Session::refreshControl(ControlFrames frames)
{
    if (!m_open || m_stop.isActive() || !m_finishing.empty())
        return;  // no steering while the motors are being stopped
    m_control.refresh(std::move(frames), Clock::now());
    schedule();
}

void Session::endControl()
{
    m_control.end(Clock::now());
    schedule();
}

void Session::endLeftSteering()
{
    if (!m_open || !m_leftSteering || m_control.isActive())
        return;
    m_control.endOther(*std::exchange(m_leftSteering, std::nullopt), Clock::now());
    schedule();
}

void Session::stopMotors(StopPlan plan, StopSequence::Completion completion,
                         StopSequence::Completion restored)
{
    if (!m_open) {
        completion(failure(ErrorCode::LinkClosed));
        return;
    }
    m_timing.stopsFirst = false;
    m_stop.start(std::move(plan), std::move(completion), Clock::now(), std::move(restored));
    m_control.motorsStopped(Clock::now());
    schedule();
}

void Session::allowMotors()
{
    if (m_stop.forgo())
        emit stopForgone();
}

void Session::expectSilence(milliseconds duration)
{
    m_silentUntil = std::max<TimePoint>(m_silentUntil, Clock::now() + duration);
    if (m_probe)
        m_probe->expectSilence(m_silentUntil);
    schedule();
}

void Session::keepQuiet(milliseconds duration)
{
    const TimePoint until = Clock::now() + duration;
    m_nextBeat = std::max<TimePoint>(m_nextBeat, until);
    m_nextPoll = std::max<TimePoint>(m_nextPoll, until);
    m_stop.boardIsDeaf(until);
    schedule();
}

LinkStatistics Session::statistics() const
{
    LinkStatistics statistics;
    if (m_framer)
        statistics.framing = m_framer->statistics();
    statistics.bytesIn = m_observed.bytesIn;
    statistics.bytesOut = m_bytesOut;
    statistics.timeouts = m_queue.timeouts();
    statistics.roundTrip = m_queue.roundTrip();
    const TimePoint now = Clock::now();
    if (m_probe)
        statistics.quality = m_probe->quality(now);
    if (m_open && m_timing.silenceLimit > 0ms)
        statistics.silence = silenceAt(now);
    statistics.backAt = m_backAt;
    // Nine full slots: the current one is still filling.
    const qint64 slot = slotOf(now);
    quint64 frames = 0;
    for (qint64 back = 1; back < qint64(m_rateSlots.size()); ++back) {
        if (slot - back <= m_rateSlot)
            frames += m_rateSlots[std::size_t((slot - back) % qint64(m_rateSlots.size()))];
    }
    statistics.framesPerSecond = double(frames) / (0.1 * double(m_rateSlots.size() - 1));
    return statistics;
}

// What was announced does not count.
Duration Session::silenceAt(TimePoint now) const
{
    return std::max(Duration{}, now - std::max(m_arrival, m_silentUntil));
}

LinkObservation Session::observation() const
{
    LinkObservation observation = m_observed;
    observation.framing = m_framer ? m_framer->statistics() : FramerStatistics{};
    observation.isPacketBased = m_transport && m_transport->isPacketBased();
    observation.isReplayed = m_transport && m_transport->replay();
    return observation;
}

void Session::onReceived(QByteArrayView bytes, TimePoint at)
{
    if (m_framer->isWaiting() && at - m_arrival > m_framer->gap())
        m_framer->flush(m_sink);
    if (m_observed.bytesIn > 0)
        m_observed.noteArrival(m_arrival, at);
    if (m_timing.silenceLimit > 0ms && silenceAt(at) >= LinkStatistics::kDegraded)
        m_backAt = at;
    m_arrival = at;
    for (FrameListener *listener : m_listeners)
        listener->bytesReceived(bytes, at);
    m_observed.bytesIn += static_cast<quint64>(bytes.size());
    if (m_framer->statistics().frames == 0)
        m_observed.lastBytes = (m_observed.lastBytes + bytes.toByteArray()).right(kKeptBytes);
    m_framer->feed(asBytes(bytes), m_sink);
    if (m_transport && m_transport->isPacketBased())
        m_framer->packetEnded(m_sink);
    schedule();
}

void Session::onFrame(const FrameView &frame)
{
    const qint64 slot = slotOf(m_arrival);
    for (; m_rateSlot < slot; ++m_rateSlot) {
        if (slot - m_rateSlot > qint64(m_rateSlots.size()))
            m_rateSlot = slot - qint64(m_rateSlots.size());
        m_rateSlots[std::size_t((m_rateSlot + 1) % qint64(m_rateSlots.size()))] = 0;
    }
    ++m_rateSlots[std::size_t(slot % qint64(m_rateSlots.size()))];
    if (m_probe)
        m_probe->frameArrived(frame, m_arrival);
    const bool claimed = m_queue.frameArrived(frame, m_arrival);
    for (std::size_t i = 0; i < m_listeners.size(); ++i)
        m_listeners[i]->frameReceived(frame, m_arrival, claimed);
    if (m_stop.isActive() && m_latest)
        m_stop.telemetryArrived(*m_latest);
}

// A set-point is skipped where it would have to wait, because the next one is newer: on a slow line it would
// pile up and hold up a stop. If each frame is answered, it takes its turn, and is skipped while the previous
// one is unanswered, and while the answer to an earlier request may still come: waiting in the queue it would
// hold up what is behind it. Frames that end the steering are never skipped.
void Session::sendControl(const QByteArray &frame, TimePoint now)
{
    if (frame.isEmpty())
        return;
    if (!m_control.answer()) {
        if (!m_control.isStreaming() || !m_queue.isCrowded(now))
            m_queue.sendUnanswered(frame, now);
        return;
    }
    if (m_control.isStreaming() && (m_controlAsked || m_queue.isHeld(m_control.kind())))
        return;
    m_controlAsked = true;
    Request request;
    request.name = QStringLiteral("control");
    request.bytes = frame;
    request.answer = m_control.answer();
    request.kind = m_control.kind();
    m_queue.submit(
        std::move(request), [this](const Result<Frame> &) { m_controlAsked = false; }, now);
}

void Session::askWhetherStill(TimePoint now)
{
    const Request *question = m_control.question();
    if (!question || std::exchange(m_stillAsked, true))
        return;
    m_queue.submit(
        *question,
        [this](const Result<Frame> &answer) {
            m_stillAsked = false;
            if (answer)
                m_control.answered(*answer);
        },
        now, TransactionQueue::Lane::Urgent);
}

void Session::onTick()
{
    const TimePoint now = Clock::now();
    if (m_framer && m_framer->isWaiting() && now - m_arrival > m_framer->gap())
        m_framer->flush(m_sink);
    const int failsafes = m_control.failsafeCount();
    while (auto frame = m_control.advance(now, m_latest.get())) {
        sendControl(*frame, now);
        askWhetherStill(now);
    }
    if (const auto isStill = m_control.takeOutcome()) {
        if (!*isStill && m_control.canProve())
            m_leftSteering = m_control.frames();
        emit steeringEnded(*isStill);
    }
    if (isReadyToFinish()) {
        finishNow();
        return;
    }
    if (m_control.failsafeCount() != failsafes)
        emit failsafeActed();
    m_stop.advance(now);
    stopBlindly(now);
    beat(now);
    m_queue.advance(now);
    if (const auto at = pollAt(); at && now >= *at) {
        m_pollRunning = true;
        m_nextPoll = std::max(m_nextPoll + m_pollInterval, now);
        m_pollAskedAt = now;
        m_queue.submit(
            *m_poll,
            [this](const Result<Frame> &) {
                m_pollRunning = false;
                m_pollEndedAt = Clock::now();
                m_pollTook = m_pollEndedAt - m_pollAskedAt;
            },
            now);
    }
    if (m_open && m_timing.silenceLimit > 0ms && now >= lostAt()) {
        close({ErrorCode::LinkClosed,
               QStringLiteral("nothing came for %1 s").arg(seconds(now - m_arrival), 0, 'f', 1)});
        return;
    }
    schedule();
}

// Polling gives way to requests, but not for long, and takes turns with set-points: however busy or slow a
// board is, it is watched.
std::optional<TimePoint> Session::pollAt() const
{
    if (!m_poll || m_pollRunning)
        return {};
    if (m_controlAsked && m_queue.count() == 1)
        return m_nextPoll;
    const TimePoint overdue
        = m_pollEndedAt + std::clamp<Duration>(kPollShare * m_pollTook, kPollPatience, kMaxPollPatience);
    return std::max<TimePoint>(m_nextPoll, std::min(overdue, m_queue.readyAt().value_or(overdue)));
}

TimePoint Session::lostAt() const
{
    return std::max(m_arrival, m_silentUntil) + m_timing.silenceLimit;
}

void Session::beat(TimePoint now)
{
    if (!m_open || m_timing.heartbeatPeriod <= 0ms || !(m_probe || m_timing.heartbeat) || now < m_nextBeat)
        return;
    m_nextBeat = std::max<TimePoint>(m_nextBeat + m_timing.heartbeatPeriod, now);
    m_queue.sendUnanswered(m_probe ? m_probe->beat(now) : m_timing.heartbeat(), now);
}

// Who it is need not be known for that.
void Session::stopBlindly(TimePoint now)
{
    if (!m_open || !m_timing.stopsFirst || m_timing.blindStop.isEmpty() || now < m_nextBlindStop)
        return;
    m_nextBlindStop = now + kBlindStops;
    m_queue.sendUnanswered(m_timing.blindStop, now);
}

void Session::schedule()
{
    if (!m_open)
        return;
    const TimePoint now = Clock::now();
    std::optional<TimePoint> next = m_queue.nextDeadline(now);
    const auto consider = [&next](std::optional<TimePoint> time) {
        if (time)
            next = next ? std::min(*next, *time) : *time;
    };
    consider(m_control.nextDeadline());
    consider(m_stop.nextDeadline());
    if (isReadyToFinish())
        consider(now);
    if (m_timing.stopsFirst && !m_timing.blindStop.isEmpty())
        consider(m_nextBlindStop);
    if (m_timing.heartbeatPeriod > 0ms)
        consider(m_nextBeat);
    if (m_timing.silenceLimit > 0ms)
        consider(lostAt());
    consider(pollAt());
    if (m_framer && m_framer->isWaiting())
        consider(m_arrival + m_framer->gap() + 1ms);
    if (!next) {
        m_timer.stop();
        return;
    }
    const auto wait = std::chrono::ceil<milliseconds>(*next - now);
    m_timer.start(std::max(wait, milliseconds(0)));
}
