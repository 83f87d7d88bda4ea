// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/framelistener.h"
#include "protocol/session/channel.h"
#include "protocol/session/controlstream.h"
#include "protocol/session/linkprobe.h"
#include "protocol/session/linkstatistics.h"
#include "protocol/session/linktiming.h"
#include "protocol/session/stopplan.h"
#include "protocol/session/transactionqueue.h"
#include "protocol/transport/transport.h"

#include <QTimer>

#include <array>

/// One open link. Owns the transport, the framer, the transaction queue and the control stream; lives on the
/// I/O thread.
class Session final : public QObject
{
    Q_OBJECT
public:
    Session(TransportFactory makeTransport, QObject *parent = nullptr);
    ~Session() override;

    // All of the following are called on the I/O thread.
    /// @param timing what the family requires on a link
    void open(const LinkAddress &address, std::unique_ptr<Framer> framer, LinkTiming timing = {});
    void close(const Error &why);
    /// Closes on purpose: steering is ended first, and the board seen to stand still, as far as it answers.
    /// @param then called afterwards
    void finish(std::function<void()> then);
    /// Closes because the board has restarted: set-points that it took since are followed by a stop first,
    /// where it can be seen to stand still.
    void leaveRestarted(const Error &why);
    bool setLine(const LineSettings &line);
    TransactionQueue::Id submit(Request request, TransactionQueue::Completion completion);
    void cancel(TransactionQueue::Id id) { m_queue.cancel(id); }
    void addListener(FrameListener *listener) { m_listeners.push_back(listener); }
    void removeListener(FrameListener *listener) { std::erase(m_listeners, listener); }

    /// Repeats this request whenever the queue is idle, at most this often (for telemetry that cannot be
    /// streamed).
    void setPoll(std::optional<Request> request, milliseconds interval = 50ms);

    /// Frames to send when the link is closed on purpose, so that the board stops streaming.
    void setShutdownFrames(QByteArray bytes) { m_shutdownFrames = std::move(bytes); }
    /// Where telemetry is stored, to see the effect of a stop. Updated by a listener on this thread.
    void setLatestValues(std::shared_ptr<const LatestValues> latest) { m_latest = std::move(latest); }

    void refreshControl(ControlFrames frames);
    void endControl();
    /// On a new link to the same board: it still moves as a link that broke had steered it last, so it is
    /// told to stop, where it can be seen to stand still. steeringEnded() tells the outcome.
    void endLeftSteering();
    /// Another board answers.
    void forgetLeftSteering() { m_leftSteering.reset(); }
    /// Steers, or has not been seen to stand still yet.
    [[nodiscard]] bool isSteering() const { return m_control.isSteering(); }

    /// Ahead of everything: ends the control stream and carries out the plan until the stop is proven.
    /// Completes with nothing, NotProven or LinkClosed. A stop that is not proven in time is repeated until
    /// it is, the link is closed or allowMotors() is called.
    /// @param restored as for StopSequence::start()
    void stopMotors(StopPlan plan, StopSequence::Completion completion,
                    StopSequence::Completion restored = {});

    /// The operator wants motors to run again.
    void allowMotors();

    /// The board will be silent for this long; the silence limit counts from the end of it.
    void expectSilence(milliseconds duration);
    /// No heartbeat and no poll for this long, and of a stop only what a deaf board shall hear first.
    void keepQuiet(milliseconds duration);
    [[nodiscard]] TimePoint silentUntil() const { return m_silentUntil; }

    /// The recording behind the open link; null for a live one.
    [[nodiscard]] Replay *replay() const { return m_transport ? m_transport->replay() : nullptr; }

    [[nodiscard]] LinkStatistics statistics() const;
    [[nodiscard]] LinkObservation observation() const;

signals:
    void opened();
    /// Emitted once per link: why it ended (Cancelled if on request).
    void closed(const Error &why);
    /// Set-points were not refreshed in time: the board was stopped and control released.
    void failsafeActed();
    /// Steering has ended: the board was seen to stand still, or there is no way to see it; or it was not,
    /// and the camera may go on moving.
    void steeringEnded(bool confirmed);
    /// What stopMotors() could not prove in time is proven now.
    void motorsStoppedLate();
    /// It is given up by allowMotors().
    void stopForgone();

private:
    void send(QByteArrayView bytes);
    void onReceived(QByteArrayView bytes, TimePoint at);
    void onFrame(const FrameView &frame);
    void onTick();
    void schedule();
    void sendControl(const QByteArray &frame, TimePoint now);
    void askWhetherStill(TimePoint now);
    [[nodiscard]] bool isReadyToFinish() const;
    void finishNow();
    void tellFinished();
    void beat(TimePoint now);
    void stopBlindly(TimePoint now);
    [[nodiscard]] TimePoint lostAt() const;
    [[nodiscard]] Duration silenceAt(TimePoint now) const;
    [[nodiscard]] std::optional<TimePoint> pollAt() const;

    TransportFactory m_makeTransport;
    std::unique_ptr<Transport> m_transport;
    std::unique_ptr<Framer> m_framer;
    FrameSink m_sink;
    TransactionQueue m_queue;
    LinkTiming m_timing;
    std::unique_ptr<LinkProbe> m_probe;
    ControlStream m_control;
    StopSequence m_stop;
    QTimer m_timer;
    std::vector<FrameListener *> m_listeners;
    std::optional<Request> m_poll;
    milliseconds m_pollInterval = 50ms;
    TimePoint m_nextPoll{};
    TimePoint m_pollAskedAt{};
    TimePoint m_pollEndedAt{};
    Duration m_pollTook{};  // the last one, with its wait for the line
    bool m_pollRunning = false;
    bool m_controlAsked = false;  // a set-point is waiting for its answer
    bool m_stillAsked = false;  // whether the board stands still
    std::optional<ControlFrames> m_leftSteering;
    std::vector<std::function<void()>> m_finishing;
    QByteArray m_shutdownFrames;
    std::shared_ptr<const LatestValues> m_latest;
    TimePoint m_nextBeat{};
    TimePoint m_nextBlindStop{};
    TimePoint m_silentUntil{};  // silence is expected until then
    bool m_open = false;
    TimePoint m_arrival{};
    std::optional<TimePoint> m_backAt;  // from a silence
    LinkObservation m_observed;  // but for the framer's part
    quint64 m_bytesOut = 0;
    // Frame rate over the last second, in slots of 100 ms.
    mutable std::array<quint64, 10> m_rateSlots{};
    mutable qint64 m_rateSlot = 0;
};
