// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/client/boardsearch.h"
#include "protocol/client/deviceclient.h"
#include "protocol/client/framelog.h"
#include "protocol/client/replaycontrol.h"
#include "protocol/client/restartwatch.h"
#include "protocol/client/supervision.h"
#include "protocol/session/session.h"
#include "protocol/telemetry/telemetryfeed.h"
#include "protocol/telemetry/telemetryplan.h"

#include <QSemaphore>
#include <QThread>

#include <deque>

/// Implementation of the client.
struct DeviceClient::Private
{
    struct Attempt
    {
        std::shared_ptr<JobControl> control = std::make_shared<JobControl>();
        std::unique_ptr<BoardSearch> search;
    };

    Private(DeviceClient &client, TransportFactory makeTransport, QList<Family> known);

    void setState(State next);
    void startAttempt(State next, milliseconds delay);
    void finishAttempt(const std::shared_ptr<Attempt> &attempt, Result<BoardSearch::Found> found);
    void installFeed(bool isSameBoard);
    void disconnectFromBoard();
    void onSessionClosed(const Error &why);
    /// On the I/O thread, of each frame. @param boardState its state, NaN if it is not known
    void watchForRestart(const Device &board, const FrameView &frame, TimePoint at, bool isStreamed,
                         float boardState);
    /// On the I/O thread, a few times a second.
    void lookForRestart(const std::shared_ptr<Device> &board);
    void onResetAnnounced();
    void onRestarted(const QString &evidence, bool isOrdered);
    void renewLink(const Error &why, milliseconds pause);
    void requestTelemetry();
    void takePlan(const TelemetryPlan &arranged, const Subscription &asked);
    void startReplay();
    [[nodiscard]] std::optional<Error> refusal(const Subscription &wanted) const;
    void pollStatistics();
    void jobFinished();
    /// From the worker thread: hands the result over on the thread of the client.
    void deliverLater(Delivery delivery);
    [[nodiscard]] Delivery nextDelivery();
    void followWay();
    void cancelJobs(const Error &why = {ErrorCode::Cancelled, {}, 0});
    void cancelMovingJobs(const Error &why = {ErrorCode::Cancelled, {}, 0});
    void startSupervision();
    /// @param proven called on the I/O thread once it is known, beside the signals
    void stopMotors(const std::function<void(bool proven)> &proven = {});
    void tellStopped(bool isProven);
    void tellStopBegun();
    /// @param duration 0: it hears again
    void setDeaf(milliseconds duration);
    void closeSession();
    void shutDown();
    std::unique_ptr<SessionChannel> makeChannel(std::shared_ptr<JobControl> control,
                                                SessionChannel::Link link);
    /// Queues a job on the I/O thread, as long as there is one.
    template <typename F> void later(F &&job)
    {
        if (ioThread.isRunning())
            QMetaObject::invokeMethod(session, std::forward<F>(job), Qt::QueuedConnection);
    }
    /// Runs a job on the I/O thread and waits for it; without that thread it is not run.
    template <typename F> void now(F &&job)
    {
        if (ioThread.isRunning())
            QMetaObject::invokeMethod(session, std::forward<F>(job), Qt::BlockingQueuedConnection);
    }
    /// Queues a job on the GUI thread.
    template <typename F> void back(F &&job)
    {
        QMetaObject::invokeMethod(&q, std::forward<F>(job), Qt::QueuedConnection);
    }

    DeviceClient &q;
    QList<Family> families;
    QThread ioThread;
    QThread workerThread;
    Session *session;
    QObject *worker;
    FrameLog frames;
    std::vector<FrameListener *> foreign;  // owned by others
    std::unique_ptr<TelemetryFeed> feed;
    QTimer statisticsTimer;

    State state = State::Disconnected;
    LinkAddress address;
    QString familyKey;
    std::shared_ptr<Device> device;
    BoardIdentity identity;
    ChannelRoles roles;
    std::optional<LineSettings> line;
    std::shared_ptr<JobControl> control = std::make_shared<JobControl>();
    std::shared_ptr<JobControl> attemptControl;
    std::shared_ptr<TelemetryStore> store;
    Subscription subscription;
    TelemetryPlan plan;
    bool telemetryRequested = false;
    ReplayControl replay;
    LinkStatistics statistics;
    int jobs = 0;

    std::mutex urgentMutex;  // motorsOff() may be called from any thread
    std::optional<StopPlan> stopPlan;
    std::vector<std::weak_ptr<JobControl>> movingJobs;
    std::deque<Delivery> deliveries;  // of finished jobs, on their way
    std::unique_ptr<Supervision> supervision;
    std::vector<Unwatched> unwatched;
    std::shared_ptr<SteeringNote> steering;
    std::shared_ptr<QSemaphore> closing = std::make_shared<QSemaphore>();  // released for each closed link
    RestartWatch restarts;  // on the I/O thread, with its timer: a screen that stands still misses nothing
    QTimer *restartTimer;
    std::shared_ptr<Device> watched;
    Loss loss = Loss::Link;
    bool stopIsUnproven = false;  // it is being repeated
    QTimer stopPatience;
    TimePoint deafUntil{};
};
