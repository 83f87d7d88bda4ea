// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/channel.h"
#include "protocol/session/controlstream.h"
#include "protocol/session/transactionqueue.h"
#include "protocol/transport/transport.h"

#include <QTimer>

#include <array>

/// Gets every frame on the I/O thread with its time of arrival.
class FrameListener
{
public:
    virtual ~FrameListener() = default;
    /// @param claimed the frame was the answer to a request (polled telemetry is an answer and telemetry all
    /// the same)
    virtual void frameReceived(const FrameView &frame, TimePoint at, bool claimed) = 0;
    /// Bytes as they came from the port, before the frames in them are found.
    virtual void bytesReceived(QByteArrayView, TimePoint) { }
    /// Whole frames that left for the board.
    virtual void bytesSent(QByteArrayView, TimePoint) { }
};

/// Counters of one link, as shown in the status bar.
struct LinkStatistics
{
    FramerStatistics framing;
    quint64 bytesIn = 0;
    quint64 bytesOut = 0;
    quint64 timeouts = 0;
    double framesPerSecond = 0;
    std::optional<Duration> roundTrip;
    int deadManRescues = 0;
    std::optional<ReplayState> replay;  ///< where a recorded link stands
};

/// One open link. Owns the transport, the framer, the transaction queue and the control stream; lives on the
/// I/O thread.
class Session final : public QObject
{
    Q_OBJECT
public:
    Session(TransportFactory makeTransport, QObject *parent = nullptr);
    ~Session() override;

    // All of the following are called on the I/O thread.
    void open(const LinkAddress &address, std::unique_ptr<Framer> framer);
    void close(const Error &why);
    bool setLine(const LineSettings &line);
    TransactionQueue::Id submit(Request request, TransactionQueue::Completion completion);
    void cancel(TransactionQueue::Id id) { m_queue.cancel(id); }
    void addListener(FrameListener *listener) { m_listeners.push_back(listener); }
    void removeListener(FrameListener *listener) { std::erase(m_listeners, listener); }

    /// Repeats this request whenever the queue is idle, at most this often (telemetry that cannot be
    /// streamed).
    void setPoll(std::optional<Request> request, milliseconds interval = 50ms);

    /// Bytes to send when the link is closed on purpose, so that the board falls silent behind us.
    void setFarewell(QByteArray bytes) { m_farewell = std::move(bytes); }

    void refreshControl(ControlFrames frames);
    void endControl();

    /// Ahead of everything: drops the control stream, sends at once, repeats every 100 ms until answered,
    /// five times at most. The completion tells whether the board confirmed.
    void sendUrgent(Request request, TransactionQueue::Completion completion);

    /// Lets a replayed link run; others run by themselves.
    void play();
    void setReplayPaused(bool paused);
    void setReplaySpeed(double speed);
    void forwardReplay(double seconds);

    [[nodiscard]] LinkStatistics statistics() const;
    [[nodiscard]] LinkObservation observation() const;

signals:
    void opened();
    /// Once per link: why it ended (Cancelled when it was asked for).
    void closed(const Error &why);

private:
    void send(QByteArrayView bytes);
    void onReceived(QByteArrayView bytes, TimePoint at);
    void onFrame(const FrameView &frame);
    void onTick();
    void schedule();
    void sendControl(const QByteArray &frame, TimePoint now);
    void sendUrgentAttempt(Request request, TransactionQueue::Completion completion, int attemptsLeft);

    TransportFactory m_makeTransport;
    std::unique_ptr<Transport> m_transport;
    std::unique_ptr<Framer> m_framer;
    FrameSink m_sink;
    TransactionQueue m_queue;
    ControlStream m_control;
    QTimer m_timer;
    std::vector<FrameListener *> m_listeners;
    std::optional<Request> m_poll;
    milliseconds m_pollInterval = 50ms;
    TimePoint m_nextPoll{};
    bool m_pollRunning = false;
    bool m_controlAsked = false;  // a set-point waits for its answer
    QByteArray m_farewell;
    bool m_open = false;
    TimePoint m_arrival{};
    quint64 m_bytesIn = 0;
    QByteArray m_lastBytes;
    quint64 m_bytesOut = 0;
    // Frame rate over the last second, in slots of 100 ms.
    mutable std::array<quint64, 10> m_rateSlots{};
    mutable qint64 m_rateSlot = 0;
};
