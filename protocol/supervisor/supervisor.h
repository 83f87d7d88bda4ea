// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/supervisor/alarm.h"
#include "protocol/supervisor/oscillation.h"
#include "protocol/supervisor/slowswing.h"
#include "protocol/supervisor/steadyturn.h"
#include "protocol/supervisor/unwatched.h"
#include "protocol/telemetry/roles.h"

#include <QSet>
#include <QStringList>

#include <deque>
#include <limits>
#include <vector>

/// What arrived at one instant, by role (see ChannelRoles); NaN is what did not.
struct SupervisedSample
{
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    using Axes = std::array<double, kAxisCount>;

    double time = 0;  ///< seconds
    Axes angle{kNone, kNone, kNone};
    Axes target{kNone, kNone, kNone};
    Axes rate{kNone, kNone, kNone};
    Axes input{kNone, kNone, kNone};
    double outputs = kNone;
    double armed = kNone;
    double battery = kNone;
    double batteryCells = kNone;  ///< that the board counts
    double temperature = kNone;
    Axes motorTemperature{kNone, kNone, kNone};
};

/// What the samples do not tell.
struct SupervisedSituation
{
    bool isSteered = false;  ///< this program steers
    /// A procedure moves the board on purpose: only a runaway is looked for.
    bool isProcedure = false;
    /// The board is not starting, levelling or standing by. Otherwise only a runaway is looked for, and only
    /// one faster than any start.
    bool isStabilising = true;
    /// When values were changed live last, in the samples' seconds.
    std::optional<double> changedAt;
    /// By the board's status; empty: not known.
    std::array<std::optional<bool>, kAxisCount> follows{};  ///< its frame
    std::array<std::optional<bool>, kAxisCount> isDriven{};
    double period = 0;  ///< expected time between samples in seconds; 0: not known
    /// The board has channels for angles or rates: what else it tells does not show how it moves.
    bool tellsMotion = false;
    /// Since when the samples repeat themselves, in their seconds; empty: they do not.
    std::optional<double> unchangedSince;
    QStringList faults;  ///< keys of what the board reports (BoardFault::key)
    /// The board tells its faults, if it has any.
    bool tellsFaults = false;
    bool tellsMotorHeat = false;  ///< it has channels for that
    /// Where this program's own frames steer to while it steers, in degrees; NaN: not known (by rate). They
    /// stand for the targets of a board that does not tell them.
    SupervisedSample::Axes steeredTo{SupervisedSample::kNone, SupervisedSample::kNone,
                                     SupervisedSample::kNone};
};

/// Looks at live data for what must not go on. Fed with samples of one board; has no clock, no thread and
/// knows no family. What a board does not send is not watched.
class Supervisor
{
public:
    /// What can be watched on a board with these channels.
    [[nodiscard]] static QSet<AlarmKind> possible(const ChannelRoles &roles);

    /// The same alarm, once it is known that no live change is the cause.
    [[nodiscard]] static Alarm withoutChange(Alarm alarm);

    void setRules(const SupervisorRules &rules) { m_rules = rules; }
    [[nodiscard]] const SupervisorRules &rules() const { return m_rules; }
    void setSituation(const SupervisedSituation &situation) { m_situation = situation; }
    void add(const SupervisedSample &sample);
    /// Samples are missing here.
    void interrupt();

    /// To be called every 20 to 100 ms. @param now in the samples' seconds
    void look(double now);
    /// What has been noticed since the last call, in order. The same thing is told again only after it was
    /// over.
    [[nodiscard]] std::vector<Alarm> takeRaised();
    /// What was told and is over.
    [[nodiscard]] std::vector<Alarm> takeEnded();
    /// What was told is absent at present; it is over when it has been for a while.
    [[nodiscard]] bool isAbsent(const Alarm &alarm) const;
    /// What it cannot see at present, because it does not come, or not often enough.
    /// @param possible what the board's channels would allow
    [[nodiscard]] std::vector<Unwatched> unwatched(const QSet<AlarmKind> &possible, double now) const;

private:
    static constexpr double kChangeCounts = 10.0;  // seconds during which a live change may be the cause
    static constexpr double kAfterStart = 0.3;  // motors that were switched on find their place first
    static constexpr double kStaleTime = 0.5;
    static constexpr double kStalePeriods = 3.0;

    struct Past
    {
        double time = 0;
        double angle = 0;
        double error = 0;
    };
    struct AxisState
    {
        std::deque<Past> past;  // about a second
        OscillationDetector oscillation;
        SlowSwing slow;
        SteadyTurn turn;
        double error = SupervisedSample::kNone;
        bool wasAnchored = false;  // when that was measured
        double away = 0;  // deg/s away from the target
        double target = SupervisedSample::kNone;
        bool isCommanded = false;  // the target is what this program steers to
        bool hasArrived = false;  // at a target of that kind
        double angleAt = -1e9;  // when it came last
        double rateAt = -1e9;
        double ratePeriod = 0;  // between the samples of its rate
        double motorTemperature = SupervisedSample::kNone;
        double motorAt = -1e9;
        double anchor = SupervisedSample::kNone;  // where it stood still last, on boards without targets
        double stillSince = -1;
        double input = SupervisedSample::kNone;
        double awaySince = -1;
        double awayFirst = 0;  // deg/s when that began
        int awaySamples = 0;
        double farSince = -1;
        double farError = 0;
        double beyondSince = -1;
        double movedAt = -1e9;  // its target moved by more than a little
        double movedFrom = SupervisedSample::kNone;
        int oscillating = 0;  // looks in a row
        double calm = 0.5;  // RMS of the rate while all was well
    };
    // A condition that has to last before it counts, and to be absent before it is over.
    struct Lasting
    {
        double since = -1;
        [[nodiscard]] bool holds(bool is, double now, double duration);
    };
    struct Active
    {
        Alarm alarm;
        Lasting over;
    };

    void addAxis(std::size_t axis, const SupervisedSample &sample);
    void watchCommand(std::size_t axis, double time);
    [[nodiscard]] bool isAnchored(const AxisState &state) const
    {
        return !m_hasTargets && !state.isCommanded;
    }
    void watchAnchor(AxisState &state, double time, double angle, double rate);
    /// Measured the way it has turned, further than half a circle.
    void measureError(AxisState &state, double time, double angle);
    void watchRunaway(std::size_t axis, double time);
    void watchTurn(std::size_t axis, double time, double angle, double rate);
    void watchPlace(std::size_t axis, double time);
    void watchOscillation(std::size_t axis, double now);
    void watchSlowly(std::size_t axis, double now);
    [[nodiscard]] bool isMovedWithin(const AxisState &state, double now) const;
    void watchBoard(double now);
    [[nodiscard]] Alarm explainRunaway(std::size_t axis, double time) const;
    [[nodiscard]] Alarm explainStanding(std::size_t axis, double time) const;
    [[nodiscard]] Alarm explainOscillation(std::size_t axis, double now,
                                           const OscillationDetector::Finding &finding) const;
    /// The motors work, and had time to find their place.
    [[nodiscard]] bool isDriven(double time) const;
    /// The same, and the board holds what it stabilises.
    [[nodiscard]] bool isHolding(double time) const;
    [[nodiscard]] bool isChangedSince(double time) const;
    /// Seconds without data that are no pause yet.
    [[nodiscard]] double patience() const;
    /// When it was told last how the camera moves.
    [[nodiscard]] double lastSeen() const;
    [[nodiscard]] bool isOver(const Alarm &alarm, double now) const;
    void raise(const Alarm &alarm);
    [[nodiscard]] bool isActive(AlarmKind kind, Axis axis) const;
    [[nodiscard]] QString faultOf(AlarmKind kind) const;

    SupervisorRules m_rules;
    SupervisedSituation m_situation;
    std::array<AxisState, kAxisCount> m_axes;
    bool m_hasTargets = false;
    double m_outputs = SupervisedSample::kNone;
    double m_armed = SupervisedSample::kNone;
    double m_drivenSince = -1;
    double m_idleSince = -1;  // off, starting or standing by
    double m_heldSince = -1e9;  // after that
    double m_steeredAt = -1e9;  // by this program or from outside
    double m_busyAt = -1e9;  // a procedure ran
    double m_lastSample = -1;
    double m_lastMotion = -1;  // that told an angle or a rate
    double m_steeringSince = -1;
    double m_battery = SupervisedSample::kNone;
    int m_countedCells = 0;
    int m_cells = 0;
    double m_temperature = SupervisedSample::kNone;
    double m_batteryAt = -1e9;
    double m_temperatureAt = -1e9;
    double m_targetAt = -1e9;
    double m_lastLook = -1e9;
    std::array<Lasting, kAlarmKinds> m_lasting;
    std::vector<Active> m_active;
    std::vector<Alarm> m_raised;
    std::vector<Alarm> m_ended;
};
