// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/progress.h"
#include "protocol/device/device.h"

#include <QFuture>
#include <QPromise>

class FrameListener;
class FrameLog;
class LinkAddress;
class ReplayControl;
class TelemetryStore;
class Transport;
struct Family;
struct LinkStatistics;
struct SteeringSetpoint;

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

    DeviceClient(std::function<Result<std::unique_ptr<Transport>>(const LinkAddress &)> makeTransport,
                 QList<Family> families, QObject *parent = nullptr);
    ~DeviceClient() override;

    [[nodiscard]] State state() const;
    [[nodiscard]] bool isConnected() const { return state() == State::Connected; }
    [[nodiscard]] const QList<Family> &families() const;
    [[nodiscard]] const LinkAddress &address() const;
    /// Who is connected; the last board's identity while reconnecting.
    [[nodiscard]] const BoardIdentity &identity() const;
    /// Tables of the connected family; null before the first connection.
    [[nodiscard]] const Device *device() const;
    /// Where that board's channels are, by what they mean.
    [[nodiscard]] const ChannelRoles &roles() const;
    [[nodiscard]] std::shared_ptr<TelemetryStore> telemetry() const;
    [[nodiscard]] const TelemetryPlan &telemetryPlan() const;
    [[nodiscard]] const LinkStatistics &statistics() const;
    /// The question that live data is asked for with; empty where the board streams it by itself.
    [[nodiscard]] QByteArray pollBytes() const;
    [[nodiscard]] const std::optional<LineSettings> &line() const;
    [[nodiscard]] bool isBusy() const;
    /// Hears everything on the link, on the I/O thread, until it is removed or the client is shut down.
    void addListener(FrameListener &listener);
    void removeListener(FrameListener &listener);
    /// The last frames in and out.
    [[nodiscard]] const FrameLog &frames() const;
    /// For a recording.
    [[nodiscard]] ReplayControl &replay();

    /// Opens the link, finds rate and parity, identifies the board. stateChanged() and connectionFailed()
    /// tell the rest.
    void connectTo(const LinkAddress &address, const QString &family = {});
    void disconnectFromBoard();
    /// Ends link and threads; every future has its result afterwards. Whoever waits for one
    /// (`future.then(this,
    /// ...)`) must live until then, so this comes before anything that uses the client is taken down. The
    /// destructor does it too.
    void shutDown();

    /// Runs sequential code on the worker thread. The future always gets a result; NotConnected when there is
    /// no board.
    template <typename T>
    QFuture<Result<T>> submit(std::function<Result<T>(Channel &, Device &)> job,
                              JobKind kind = JobKind::Quiet);
    /// Cancels the running job and those waiting.
    void cancelJobs();
    /// Cancels only those that move the board.
    void cancelMovingJobs();

    /// Stops the motors by the device's plan: straight to the I/O thread, ahead of everything. Callable from
    /// any thread.
    void motorsOff();

    /// Steers. Must be repeated at least each 250 ms, or the I/O thread stops the board and lets go.
    void setControl(const SteeringSetpoint &setpoint);
    void releaseControl();

    /// Which telemetry to arrange with the board; kept over reconnections.
    void subscribe(const Subscription &subscription);

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
    /// The stop has been proven (or has not).
    void motorsOffFinished(bool confirmed);
    /// Set-points were not refreshed in time: the board was stopped and control given back.
    void failsafeActed();
    /// The board sent a text by itself.
    void boardSpoke(const QString &text);

private:
    struct Private;
    /// A job that has run, and what tells its future.
    using Delivery = std::function<void()>;
    /// Called once on the worker thread with a channel and the device, or here with why it cannot run.
    using Job = std::function<Delivery(Channel *, Device *, const Error &refused)>;
    void enqueue(Job job, JobKind kind);

    std::unique_ptr<Private> d;
};

template <typename T>
QFuture<Result<T>> DeviceClient::submit(std::function<Result<T>(Channel &, Device &)> job, JobKind kind)
{
    auto promise = std::make_shared<QPromise<Result<T>>>();
    QFuture<Result<T>> future = promise->future();
    promise->start();
    enqueue(
        [promise, job = std::move(job)](Channel *channel, Device *device, const Error &refused) -> Delivery {
            auto result = std::make_shared<Result<T>>(channel ? job(*channel, *device)
                                                              : Result<T>(tl::unexpected(refused)));
            return [promise, result] {
                promise->addResult(std::move(*result));
                promise->finish();
            };
        },
        kind);
    return future;
}
