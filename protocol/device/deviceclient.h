// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/connector.h"
#include "protocol/session/framelog.h"
#include "protocol/session/sessionchannel.h"

#include <QFuture>
#include <QPromise>
#include <QThread>

class TelemetryFeed;

/// The only door between the screen's thread and the board. Owns the I/O thread (session) and the worker
/// thread (device and procedure code, one job at a time). Never blocks; whatever talks to a board returns a
/// future.
class DeviceClient final : public QObject
{
    Q_OBJECT
public:
    enum class State { Disconnected, Connecting, Connected, Reconnecting };
    Q_ENUM(State)
    /// Moving jobs (auto-tune, steering) are cancelled by motorsOff().
    enum class JobKind { Quiet, Moving };

    DeviceClient(TransportFactory makeTransport, QList<Family> families, QObject *parent = nullptr);
    ~DeviceClient() override;

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] bool isConnected() const { return m_state == State::Connected; }
    [[nodiscard]] const QList<Family> &families() const { return m_families; }
    [[nodiscard]] const LinkAddress &address() const { return m_address; }
    /// Who is connected; the last board's identity while reconnecting.
    [[nodiscard]] const BoardIdentity &identity() const { return m_identity; }
    /// Tables of the connected family; null before the first connection.
    [[nodiscard]] const Device *device() const { return m_device.get(); }
    [[nodiscard]] std::shared_ptr<TelemetryStore> telemetry() const { return m_store; }
    [[nodiscard]] const TelemetryPlan &telemetryPlan() const { return m_plan; }
    [[nodiscard]] const LinkStatistics &statistics() const { return m_statistics; }
    /// The question that live data is asked for with; empty where the board streams it by itself.
    [[nodiscard]] QByteArray pollBytes() const { return m_plan.poll ? m_plan.poll->bytes : QByteArray(); }
    [[nodiscard]] std::optional<LineSettings> line() const { return m_line; }
    [[nodiscard]] bool isBusy() const { return m_jobs > 0; }
    /// Hears everything on the link, on the I/O thread, until it is removed or the client is shut down.
    void addListener(FrameListener &listener);
    void removeListener(FrameListener &listener);
    /// The last frames in and out.
    [[nodiscard]] const FrameLog &frames() const { return m_frames; }

    /// Opens the link, finds rate and parity, identifies the board. stateChanged() and connectionFailed()
    /// tell the rest.
    void connectTo(const LinkAddress &address, const QString &family = {});
    void disconnectFromBoard();
    /// Ends link and threads; every future has its result afterwards. Whoever waits for one
    /// (`future.then(this, ...)`) must live until then, so this comes before anything that uses the client is
    /// taken down. The destructor does it too.
    void shutDown();

    /// Runs sequential code on the worker thread. The future always gets a result; NotConnected when there is
    /// no board.
    template <typename T>
    QFuture<Result<T>> submit(std::function<Result<T>(Channel &, Device &)> job,
                              JobKind kind = JobKind::Quiet);
    /// Cancels the running job and those waiting.
    void cancelJobs();

    /// Switches the motors off: straight to the I/O thread, ahead of everything. Callable from any thread.
    void motorsOff();

    /// Steers. Must be repeated at least each 250 ms, or the I/O thread stops the board and lets go.
    void setControl(const ControlSetpoint &setpoint);
    void releaseControl();

    /// Which telemetry to arrange with the board; kept over reconnections.
    void setTelemetry(const TelemetryWish &wish);

    /// A recording: stands still, runs at another speed, or goes to a place (seconds since its first byte).
    /// Going back opens it anew and plays up to there at once, so that everything before is there to look at.
    void setReplayPaused(bool paused);
    void setReplaySpeed(double speed);
    void seekReplay(double seconds);

signals:
    void stateChanged(DeviceClient::State state);
    void connectionFailed(const Error &error);
    /// The link broke by itself; reconnecting goes on until it succeeds or is cancelled.
    void connectionLost(const Error &error);
    void progressChanged(const Progress &progress);
    void busyChanged(bool busy);
    void telemetryPlanChanged();
    void telemetryFailed(const Error &error);
    void statisticsChanged();
    /// The board confirmed (or did not) that the motors are off.
    void motorsOffFinished(bool confirmed);
    void controlRescued();
    /// The board sent a text by itself.
    void boardSpoke(const QString &text);

private:
    struct Attempt;

    void setState(State state);
    void startAttempt(State state, milliseconds delay);
    void finishAttempt(const std::shared_ptr<Attempt> &attempt, Result<FoundBoard> found);
    void onSessionClosed(const Error &why);
    void onResetAnnounced();
    void requestTelemetry();
    void startReplay();
    [[nodiscard]] std::optional<Error> refusal(const TelemetryWish &wish) const;
    void jobStarted();
    void jobFinished();
    void followWay();
    std::unique_ptr<SessionChannel> makeChannel(std::shared_ptr<JobControl> control);
    void closeSession();

    TransportFactory m_makeTransport;
    QList<Family> m_families;
    QThread m_ioThread;
    QThread m_workerThread;
    Session *m_session;
    QObject *m_worker;
    FrameLog m_frames;
    std::vector<FrameListener *> m_foreign;  // listeners that others own
    std::unique_ptr<TelemetryFeed> m_feed;
    QTimer m_statisticsTimer;

    State m_state = State::Disconnected;
    LinkAddress m_address;
    QString m_familyKey;
    std::shared_ptr<Device> m_device;
    BoardIdentity m_identity;
    std::optional<LineSettings> m_line;
    std::shared_ptr<JobControl> m_control = std::make_shared<JobControl>();
    std::shared_ptr<JobControl> m_attemptControl;
    std::shared_ptr<TelemetryStore> m_store;
    TelemetryWish m_wish;
    TelemetryPlan m_plan;
    bool m_telemetryRequested = false;
    double m_replayFrom = 0;  // go there as soon as the recording is open
    std::optional<double> m_replaySpeed;  // chosen by the operator, kept over seeking
    bool m_replayPaused = false;
    LinkStatistics m_statistics;
    int m_jobs = 0;

    std::mutex m_urgentMutex;  // motorsOff() comes from any thread
    std::optional<Request> m_motorsOff;
    std::vector<std::weak_ptr<JobControl>> m_movingJobs;
};

template <typename T>
QFuture<Result<T>> DeviceClient::submit(std::function<Result<T>(Channel &, Device &)> job, JobKind kind)
{
    auto promise = std::make_shared<QPromise<Result<T>>>();
    QFuture<Result<T>> future = promise->future();
    promise->start();
    if (m_state != State::Connected) {
        promise->addResult(Result<T>(failure(ErrorCode::NotConnected)));
        promise->finish();
        return future;
    }
    // A moving job has a control of its own, so that stopping it leaves a write alone.
    auto control = kind == JobKind::Moving ? std::make_shared<JobControl>() : m_control;
    if (kind == JobKind::Moving) {
        const std::lock_guard lock(m_urgentMutex);
        m_movingJobs.push_back(control);
    }
    jobStarted();
    QMetaObject::invokeMethod(
        m_worker,
        [this, promise, control, device = m_device, job = std::move(job)] {
            const auto channel = makeChannel(control);
            Result<T> result
                = channel->cancelled() ? Result<T>(failure(ErrorCode::Cancelled)) : job(*channel, *device);
            QMetaObject::invokeMethod(
                this, [this] { jobFinished(); }, Qt::QueuedConnection);
            promise->addResult(std::move(result));
            promise->finish();
        },
        Qt::QueuedConnection);
    return future;
}
