// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/sessionchannel.h"
#include "protocol/supervisor/alarmreport.h"
#include "protocol/supervisor/supervisedstore.h"

#include <QThread>
#include <QTimer>

#include <memory>
#include <mutex>

/// What was steered last, noted on any thread; outlives whoever notes it.
struct SteeringNote
{
    std::atomic<Duration::rep> at{};  ///< ticks of the clock; 0: steering has ended
    std::array<std::atomic<double>, kAxisCount> to{};  ///< degrees, NaN: not known

    /// A set-point was sent; null: steering ends.
    void take(const ControlFrames *frames);
};

/// Runs the supervisor on a thread of its own, beside the worker and the GUI, on what the I/O thread puts
/// into the store, and does what the rules say: motors off in the urgent lane, or the last live change taken
/// back on a second thread, because both have to work while the worker is busy. Except where stated,
/// functions may be called from any thread.
class Supervision
{
public:
    /// What it needs of the client. Called on its threads.
    struct Hooks
    {
        /// Stops the motors; the callback comes from any thread.
        std::function<void(const std::function<void(bool proven)> &)> stop;
        std::function<std::unique_ptr<Channel>(std::shared_ptr<JobControl>)> makeChannel;
        /// A job moves the board.
        std::function<bool()> isMoving;
        std::function<void(const AlarmReport &)> report;
        /// What cannot be watched has changed.
        std::function<void(const std::vector<Unwatched> &)> unwatched = {};
    };
    struct Board
    {
        std::shared_ptr<TelemetryStore> store;
        std::shared_ptr<Device> device;
        ChannelRoles roles;
        bool flies = false;
    };

    explicit Supervision(Hooks hooks);
    /// Ends its threads.
    ~Supervision();
    Supervision(const Supervision &) = delete;
    Supervision &operator=(const Supervision &) = delete;

    void setRules(const SupervisorRules &rules);
    /// A board is connected.
    void begin(const Board &board);
    void end();
    /// The motors are off for certain, whoever stopped them: alarms that could not tell so far say so.
    void stopProven();
    /// Expected time between samples in seconds; 0: not known.
    void setPeriod(double seconds) { m_period = seconds; }
    [[nodiscard]] std::shared_ptr<SteeringNote> steering() const { return m_steering; }

private:
    // On the supervisor's thread.
    void start(const Board &board);
    void tick();
    [[nodiscard]] SupervisedSituation situation();
    void act(const Alarm &alarm);
    void stopFor(AlarmReport report);
    void takeBackFor(const AlarmReport &report);
    void tookBack(int number, const Result<LiveChange> &change);
    void followUp();
    void lookWhatIsMissing();
    void tell(const AlarmReport &report);
    [[nodiscard]] AlarmReport *find(int number);
    /// Of what is over, as soon as nothing more is to be told of it.
    void forgetSettled();

    /// The way back for answers that may come when it is gone: a stop ends with the link, which goes later.
    struct Door
    {
        std::mutex mutex;
        QObject *watcher = nullptr;
    };

    Hooks m_hooks;
    std::shared_ptr<Door> m_door = std::make_shared<Door>();
    QThread m_thread;
    QThread m_rescueThread;
    QObject *m_watcher;
    QObject *m_rescuer;
    QTimer *m_timer;
    std::shared_ptr<JobControl> m_control = std::make_shared<JobControl>();
    std::atomic<double> m_period = 0;
    std::shared_ptr<SteeringNote> m_steering = std::make_shared<SteeringNote>();

    std::optional<Board> m_board;
    std::unique_ptr<SupervisedStore> m_source;
    std::unique_ptr<Supervisor> m_supervisor;
    SupervisorRules m_rules;
    std::vector<AlarmReport> m_reports;  // those that are not over, or whose stop is not proven
    std::vector<std::pair<int, double>> m_helps;  // changes taken back, and when it has to have helped
    int m_count = 0;
    QSet<AlarmKind> m_possible;
    double m_nextMissing = 0;
    std::vector<Unwatched> m_missing;  // when it was looked at last
    std::vector<Unwatched> m_toldMissing;
};
