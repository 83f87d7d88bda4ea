// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/spectrum.h"
#include "protocol/base/progress.h"
#include "protocol/base/vector3.h"
#include "protocol/configuration/livevalues.h"
#include "protocol/guide/setuprecord.h"
#include "protocol/record/boardhistory.h"
#include "protocol/telemetry/roles.h"
#include "protocol/telemetry/telemetrystore.h"

class Channel;

/// Carries out one step at a time on the worker, the same for the window and for the command line. Where a
/// person has to do something meanwhile, it is told by progress ("setup-hold", "setup-let-go", "setup-move",
/// "setup-tilt-...", "setup-stick-..."), and the step waits for what it sees. Whatever is written goes the
/// way of every write: with a safety copy, read back and compared.
class SetupGuide
{
public:
    SetupGuide(Channel &channel, Device &device, const TelemetryStore &telemetry, const BoardHistory &history,
               LiveValues live = {});

    /// The channels that must arrive while a step runs.
    [[nodiscard]] static QList<int> channels(const Device &device);

    /// @param areMotorsKnown before that they are not trusted to hold the camera: calibrations switch them
    /// off
    /// @param answers of parseArguments() of the step's action; whoever calls has had `confirm` confirmed
    /// Errors, with the board as it was unless the error says otherwise: ReadOnly, Unsupported (the board
    /// lacks something for it), Unready (no telemetry, motors off where they have to run), ConditionUnmet
    /// (with what has to be seen to), InvalidArgument (an answer is needed), Diverged (an axis ran away and
    /// the motors were stopped), those of writing and of the actions.
    Result<SetupResult> run(SetupStep step, const QVariantMap &answers, bool areMotorsKnown);

private:
    using Figures = std::array<double, kAxisCount>;
    using Span = std::pair<double, double>;  ///< seconds since the origin of the store

    Result<SetupResult> power(const QVariantMap &answers);
    Result<SetupResult> sensors();
    [[nodiscard]] bool hasFault(QLatin1String key) const;
    /// The remark on the sensor of the frame.
    [[nodiscard]] QString frameSensor(const Configuration &base) const;
    Result<SetupResult> calibrate(const QString &action, const QString &part, const QString &figure,
                                  double good, double usable, bool areMotorsKnown);
    Result<SetupResult> orientation();
    Result<SetupResult> balance();
    /// Finds what each motor is, one at a time. Errors: ConditionUnmet (one does not turn), Diverged.
    Result<SetupResult> motors();
    struct MotorTrial;
    /// What turned when the board turned a motor.
    struct TurnedMotor
    {
        Axis axis = Axis::None;
        bool isFound = false;  ///< the board says that it knows its poles now
    };
    Result<SetupResult> findMotors(MotorTrial &trial);
    Result<void> findMotor(MotorTrial &trial, Axis axis, SetupResult &result);
    Result<TurnedMotor> turnMotor(MotorTrial &trial, Axis axis);
    /// Has it hold its axis, all others off. @return whether the axis moves as it is steered
    Result<bool> runAlone(MotorTrial &trial, Axis axis, SetupResult &result);
    /// Stops the motors where an axis runs away. Errors: Diverged.
    Result<void> watchMotors(const std::vector<Axis> &axes, double seconds, const QString &step,
                             Figures &strays);
    [[nodiscard]] double fullPower(Axis axis) const;
    [[nodiscard]] Configuration withMotors(const MotorTrial &trial, std::optional<Axis> alone) const;
    Result<void> useMotors(MotorTrial &trial, const Configuration &edited, SetupResult &result);
    Error motorsBack(const MotorTrial &trial, const Error &why);
    /// Finds the power of each motor. Errors: ConditionUnmet (an axis is not held with any), Diverged.
    Result<SetupResult> motorPower();
    struct PowerTrial;
    Result<SetupResult> findPowers(PowerTrial &trial);
    /// @return the lowest that holds the axis
    Result<int> findPower(PowerTrial &trial, Axis axis);
    Result<void> usePower(PowerTrial &trial, Axis axis, int power);
    /// Moves the axis. @return how far it is off when it should have arrived, RMS; infinite: it is not held
    Result<double> probe(const Progress &told, Axis axis);
    Result<bool> comesToRest(const Progress &told, Axis axis);
    /// What heats: current and temperatures, with what was before where that is given.
    Result<void> measureHeat(SetupResult &result, const SetupResult *before);
    Error powersBack(const PowerTrial &trial, const Error &why);
    Result<SetupResult> gains(const QVariantMap &answers);
    /// How an axis follows a step of its target.
    struct Response
    {
        double overshoot = 0;  ///< % of the step
        double riseSeconds = 0;
    };
    /// How well the camera is held, and how it follows.
    struct Held
    {
        Figures off{};  ///< degrees RMS
        Span span;  ///< in which that was measured
        std::array<std::optional<Response>, kAxisCount> response{};
    };
    Result<Held> measureHeld();
    /// Empty: it does not follow, or cannot be steered.
    Result<std::optional<Response>> measureResponse(Axis axis);
    static void addHeld(const Held &is, const Held *before, SetupResult &result);
    Result<SetupResult> measureGains();
    /// @param board what it holds, and holds afterwards @return whether an axis got its gains back
    [[nodiscard]] static Result<Configuration> withoutWorse(const Configuration &base,
                                                            const Configuration &board, const Held &before,
                                                            const Held &after);
    Result<void> restoreAxes(const Configuration &base, const Configuration &board,
                             const Configuration &edited);
    /// After the board has searched them: those that hold the camera worse are taken back.
    Result<SetupResult> judgeGains(const Configuration &base, const Held &before);
    Result<SetupResult> vibration(const QVariantMap &answers);
    Result<SetupResult> limits(const QVariantMap &answers);
    /// How far the camera was moved, lowest and highest; by its angles, and by the angles of its motors.
    using Reached = std::array<std::pair<double, double>, kAxisCount>;
    struct Motion
    {
        Reached angle{};
        Reached joint{};
    };
    Result<Motion> watchHand(double seconds);
    /// Sets those limits of the axis that the board has.
    Result<void> setRanges(Axis axis, const Motion &motion, double margin, Configuration &edited,
                           SetupResult &result) const;
    Result<SetupResult> remote(const QVariantMap &answers);
    Result<SetupResult> use(const QVariantMap &answers);

    // What is seen.
    [[nodiscard]] double latest(int channel) const { return double(m_telemetry.latest(channel)); }
    /// Waits until all of them are newer than now. Errors: Unready.
    Result<void> awaitNews(const QList<int> &channels);
    /// The mean over that time. Errors: Unready.
    Result<double> average(int channel, double seconds);
    /// Lets a moment pass. Errors: Cancelled, LinkClosed, NoSamples (live data do not come any more).
    Result<void> letPass();
    /// Watches for that time; `each` sees every moment and ends it by an error.
    Result<void> watch(double seconds, const std::function<Result<void>()> &each, const QString &step);
    /// Lets that time pass. @return from when to when, in seconds since the origin of the store
    Result<Span> measure(double seconds);
    /// How far angles are from their targets, RMS.
    Result<Held> measureHolding();
    void tell(const QString &step, double share);
    /// Which way is up, in the axes of the sensor; in no particular unit.
    [[nodiscard]] Vector3 upward() const;
    /// Waits until the camera is held so and still for that time. @return which way is up then, as a unit
    /// vector. Errors: ConditionUnmet.
    Result<Vector3> awaitPose(const QString &step, const std::function<bool(const Vector3 &)> &isThere,
                              double seconds);
    /// Has the camera held level, or with its nose down, until the board says so, too. Errors: NotSeen.
    Result<void> awaitAngles(const QString &step, const Vector3 &level, bool isDown);
    /// The same for both, one after the other.
    Result<void> awaitFollowing(const Vector3 &level);
    /// Lines of the turn rates that may be worth a notch.
    using Lines = std::vector<std::pair<Axis, SpectrumPeak>>;
    Result<Lines> linesOf(const Span &span, SetupResult &result) const;
    /// @return whether the notch was kept
    Result<bool> tryNotchFor(Axis axis, const SpectrumPeak &peak, SetupResult &result);

    // Sticks of a remote control, and what comes in at the inputs by their names, 1 at an end.
    using Inputs = QMap<QString, double>;
    struct Stick
    {
        QString function;  ///< "roll"
        QString input;
        double rest = 0;
        double wanted = 0;  ///< where it turns the axis the positive way
        double other = 0;
    };
    /// Where a stick is to be held.
    struct StickWish
    {
        QString step;
        QString subject;
        QString input;  ///< which it is about, where it may not differ from where it rests
        QStringList taken;  ///< that steer something else
        /// By the input's name, and how far it is from where it rests.
        std::function<bool(const QString &input, double way)> isThere;
    };
    [[nodiscard]] QStringList stickFunctions() const;
    Result<Inputs> readInputs(bool initializes);
    /// The same a moment later, told as progress. Errors: ConditionUnmet (no signal; the motors run).
    Result<Inputs> watchInputs(const QString &step, const QString &subject, double share);
    /// Waits until all are let go. @param before where they rested the last time
    Result<Inputs> awaitRest(const QString &step, const Inputs &before);
    /// Waits until one alone is held so. @return the input, and what comes in there
    Result<std::pair<QString, double>> awaitStick(const StickWish &wish, const Inputs &rest);
    Result<Stick> findStick(const QString &function, const Inputs &rest, const QStringList &taken);
    /// Errors: NotSeen.
    Result<void> checkStick(const Stick &stick, const std::vector<Stick> &all, const Inputs &before);
    Result<void> mapSticks(const std::vector<Stick> &sticks, Configuration &edited) const;
    void describeSticks(const std::vector<Stick> &sticks, const Configuration &board,
                        SetupResult &result) const;

    // What is done.
    Result<void> switchOff();
    Result<void> requireMotors();
    /// Writes the difference, verified, and lists it in the result. A cancel waits until it is written; what
    /// fails half-way is taken back.
    Result<void> write(const Configuration &base, const Configuration &edited, SetupResult &result);
    /// The same where it has to prove itself: until dropTrial() or takenBack(), a TrialNote is kept.
    Result<void> writeOnTrial(const Configuration &base, const Configuration &edited, SetupResult &result);
    /// What was on trial is written back, even after a cancel. @return why; NotRestored if the board may hold
    /// it still
    Error takenBack(const Error &why);
    static void list(const Configuration &base, const Configuration &edited, SetupResult &result);
    [[nodiscard]] const ParameterSpec *find(const QString &key, Axis axis = Axis::None) const;

    Channel &m_channel;
    Device &m_device;
    const TelemetryStore &m_telemetry;
    const BoardHistory &m_history;
    LiveValues m_live;
    const ChannelRoles m_roles;
    SetupKeys m_keys;
    TimePoint m_heardAt{};  // something came in
};
