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
struct AlarmReport;
struct Family;
struct LinkStatistics;
struct SteeringSetpoint;
struct SupervisorRules;
struct Unwatched;

/// The only way from the GUI thread to the board. Owns the I/O thread (session) and the worker thread (device
/// and procedure code, one job at a time). Never blocks; every function that talks to a board returns a
/// future.
class DeviceClient final : public QObject
{
    Q_OBJECT
public:
    enum class State { Disconnected, Connecting, Connected, Reconnecting };
    Q_ENUM(State)
    /// OrderedRestart: the board was told to.
    enum class Loss { Link, Restart, OrderedRestart };
    /// Moving jobs (auto-tune, steering) are cancelled by motorsOff().
    enum class JobKind { Quiet, Moving };

    DeviceClient(std::function<Result<std::unique_ptr<Transport>>(const LinkAddress &)> makeTransport,
                 QList<Family> families, QObject *parent = nullptr);
    ~DeviceClient() override;

    [[nodiscard]] State state() const;
    [[nodiscard]] bool isConnected() const { return state() == State::Connected; }
    [[nodiscard]] const QList<Family> &families() const;
    [[nodiscard]] const LinkAddress &address() const;
    /// The same, as it is typed.
    [[nodiscard]] QString addressText() const;
    /// The connected board; while reconnecting, the last one.
    [[nodiscard]] const BoardIdentity &identity() const;
    /// Tables of the connected family; null before the first connection.
    [[nodiscard]] const Device *device() const;
    /// The channels of that board by role.
    [[nodiscard]] const ChannelRoles &roles() const;
    [[nodiscard]] std::shared_ptr<TelemetryStore> telemetry() const;
    [[nodiscard]] const TelemetryPlan &telemetryPlan() const;
    [[nodiscard]] const LinkStatistics &statistics() const;
    /// The request that polls live data; empty if the board streams it by itself.
    [[nodiscard]] QByteArray pollBytes() const;
    /// What is sent all the time to stay connected, as it would be now; empty if the family wants nothing.
    [[nodiscard]] QByteArray heartbeatBytes() const;
    [[nodiscard]] const std::optional<LineSettings> &line() const;
    [[nodiscard]] bool isBusy() const;
    /// The listener receives everything on the link, on the I/O thread, until it is removed or the client is
    /// shut down.
    void addListener(FrameListener &listener);
    void removeListener(FrameListener &listener);
    /// The most recent frames, in and out.
    [[nodiscard]] const FrameLog &frames() const;
    /// Playback control, when the link is a recording.
    [[nodiscard]] ReplayControl &replay();

    /// Opens the link, finds rate and parity, identifies the board. stateChanged() and connectionFailed()
    /// report the outcome.
    void connectTo(const LinkAddress &address, const QString &family = {});
    /// From the next connection on motors are stopped before anything is asked, where that can be done
    /// blindly (LinkTiming::blindStop). The stop of the board that is known has to follow.
    void stopBeforeAsking();
    void disconnectFromBoard();
    /// Ends the link and the threads; every future has its result afterwards. An object that waits for one
    /// (`future.then(this, ...)`) must live until then, so call this before destroying anything that uses the
    /// client. The destructor does it too.
    void shutDown();

    /// Runs sequential code on the worker thread. The future always gets a result; NotConnected when there is
    /// no board. It gets it on the thread of the client, from the event loop: never wait for it there.
    template <typename T>
    QFuture<Result<T>> submit(std::function<Result<T>(Channel &, Device &)> job,
                              JobKind kind = JobKind::Quiet);
    /// Cancels the running job and those waiting.
    void cancelJobs();
    /// Cancels only jobs that move the board.
    void cancelMovingJobs();

    /// Stops the motors according to the device's stop plan: directly on the I/O thread, ahead of everything
    /// else. Callable from any thread.
    void motorsOff();

    /// What flies is steered only by whoever says that it does, and answers for it: checked directions, an
    /// arming of its own, a guard that outlives the program.
    enum class Steers { Gimbal, FlyingMachine };
    /// Steers. Must be repeated at least every 250 ms, or the I/O thread stops the board and releases
    /// control. Nothing is sent to a flying machine that is taken for a gimbal.
    void setControl(const SteeringSetpoint &setpoint, Steers what = Steers::Gimbal);
    void releaseControl();
    /// The board is steered, by whomever, or has not been seen to stand still since.
    [[nodiscard]] bool isSteering() const;
    /// A stop was not proven in time, and is being repeated.
    [[nodiscard]] bool isStopUnproven() const;
    /// A machine flies that does not tell its outputs: "disarmed" is all that is known of its motors.
    [[nodiscard]] bool areOutputsUnknown() const;

    /// The board hears nothing until then, also no stop, because of what it was told to do; in the past: it
    /// hears.
    [[nodiscard]] TimePoint deafUntil() const;

    /// Why the link was lost last.
    [[nodiscard]] Loss loss() const;

    /// What the supervisor looks for and does; by default it works with the rules' own defaults. It acts by
    /// itself, whatever the worker and the GUI are doing.
    void setSupervisorRules(const SupervisorRules &rules);
    /// What the supervisor cannot look for on this board, with what it sends.
    [[nodiscard]] const std::vector<Unwatched> &unwatched() const;

    /// Selects the telemetry to request from the board; kept across reconnections.
    void subscribe(const Subscription &subscription);

signals:
    void stateChanged(DeviceClient::State state);
    void connectionFailed(const Error &error);
    /// The link broke unexpectedly, or was given up because the board restarts (error Restarted);
    /// reconnecting goes on until it succeeds or is cancelled.
    void connectionLost(const Error &error);
    void progressChanged(const Progress &progress);
    void busyChanged(bool busy);
    void telemetryPlanChanged();
    void telemetryFailed(const Error &error);
    void statisticsChanged();
    /// The motors are being stopped.
    void motorsOffBegun();
    /// The stop has been proven (or has not: it goes on being repeated, and this comes again with its proof).
    void motorsOffFinished(bool confirmed);
    /// Nothing has proven a stop for a second, in which the board could hear it; it goes on.
    void motorsOffLate();
    /// The board is deaf for so many more milliseconds: the stop is the first thing that it hears then.
    void motorsOffQueued(int milliseconds);
    void deafChanged();
    /// A stop that was not proven is no longer repeated, because motors are being started.
    void motorsOffForgone();
    /// Steering has ended: the board was seen to stand still, or boards like it cannot be seen to; or it was
    /// not, and the camera may go on moving.
    void steeringEnded(bool confirmed);
    /// After a stop that was proven: what it changed beside has been put back (or has not, and the motors
    /// stay disabled until the board restarts).
    void motorsOffSettled(bool restored);
    /// Set-points were not refreshed in time: the board was stopped and control released.
    void failsafeActed();
    /// The supervisor noticed something, or what it does about it has got on, or it is over. Reports with
    /// the same number are about the same alarm.
    void alarmChanged(const AlarmReport &report);
    void unwatchedChanged();
    /// The board sent a text message by itself.
    void boardSpoke(const QString &text);

private:
    struct Private;
    /// Hands the result of a finished job to its future.
    using Delivery = std::function<void()>;
    /// Called once: on the worker thread with a channel and the device, or right here with the reason it
    /// cannot run.
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
