// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/axis.h"
#include "protocol/base/battery.h"

#include <QString>

#include <array>
#include <optional>

/// What the supervisor looks for.
enum class AlarmKind {
    Runaway,  ///< away from its target beyond a limit, and going on
    Oscillation,  ///< the angular rate swings in a narrow band
    Limit,  ///< where it was never steered to, beyond the limits of its angles
    Saturation,  ///< away from its target for long: the motor cannot do what it is told
    Sensor,  ///< a motion sensor is missing or not sound
    Heat,
    Battery,
    Stale,  ///< no live data while it is steered
    Disarmed,  ///< its motors are driven although it says that it is disarmed
    Count
};
inline constexpr std::size_t kAlarmKinds = std::size_t(AlarmKind::Count);

/// What the program does about it, beside telling it.
enum class AlarmAction {
    Warn,
    TakeBack,  ///< the last live change, if there was one just before
    TakeBackElseOff,  ///< the same; where there was none, or it does not help, motors off
    MotorsOff,
};

/// What the samples show to be the cause. Where they do not, the words name the possible ones.
enum class AlarmCause {
    Unknown,
    SwappedAxes,  ///< two axes run away together, each driven by the other's error
    WrongDirection,  ///< an axis is pushed away from its target
    TooMuchGain,
    Resonance,
    Fault,  ///< the board says so itself: see Alarm::fault
    OtherBattery,  ///< a low battery by the board's alarm, which does not suit the cells that it seems to
                   ///< have
};

/// Something that went wrong. Plain data; its words are made in widgets/models/alarmtext.h.
struct Alarm
{
    AlarmKind kind = AlarmKind::Runaway;
    AlarmCause cause = AlarmCause::Unknown;
    Axis axis = Axis::None;
    Axis other = Axis::None;  ///< the second axis concerned
    double time = 0;  ///< seconds, as the samples tell it
    /// Runaway, Limit, Saturation: degrees; Oscillation: deg/s RMS; Heat: °C; Battery: volts; Stale: seconds.
    double value = 0;
    double limit = 0;  ///< in the same unit; Battery: volts of all cells
    double hertz = 0;  ///< of an oscillation
    int cells = 0;  ///< of the battery, by its voltage; 0: not known
    /// A runaway that is over by itself: the axis stands where it ended and is not coming back.
    bool isStanding = false;
    /// A runaway on a board without targets: it has turned by that much in one direction without a stop.
    bool isTurning = false;
    /// Somebody else may want it: it follows its frame, or an input of the board steers it. It is only told.
    bool mayBeMeant = false;
    /// Samples come too slowly to tell the frequency: it may be higher.
    bool isHertzVague = false;
    /// It began after a value was changed live.
    bool isAfterChange = false;
    QString fault;  ///< BoardFault::key

    /// The camera moved by itself, or nobody saw where it was steered: where it is now has to be looked at.
    [[nodiscard]] bool isUnwantedMotion() const
    {
        return (kind <= AlarmKind::Oscillation || kind == AlarmKind::Stale) && !mayBeMeant;
    }
    /// The same thing going on.
    [[nodiscard]] bool isSame(const Alarm &alarm) const
    {
        return kind == alarm.kind && axis == alarm.axis && mayBeMeant == alarm.mayBeMeant;
    }
    friend bool operator==(const Alarm &, const Alarm &) = default;
};

/// What the operator has chosen.
struct SupervisorRules
{
    /// What may be chosen for a kind: a change is taken back only where it may be the cause.
    [[nodiscard]] static constexpr bool offers(AlarmKind kind, AlarmAction action)
    {
        return action == AlarmAction::Warn || action == AlarmAction::MotorsOff
            || kind <= AlarmKind::Saturation;
    }

    std::array<AlarmAction, kAlarmKinds> actions{AlarmAction::MotorsOff, AlarmAction::TakeBack};
    double runawayDeg = 25.0;  ///< away from its target
    double oscillation = 4.0;  ///< deg/s RMS
    double cellVolts = kLowCellVolts;  ///< below this the battery is low
    BatteryThresholds battery{};  ///< those of the board
    double hotCelsius = 70.0;
    /// Lowest and highest angle that each axis may be steered to, in degrees.
    std::array<std::optional<std::pair<double, double>>, kAxisCount> angles{};
    /// An input of the board may steer the axis; empty: not known.
    std::array<std::optional<bool>, kAxisCount> isRemote{};

    [[nodiscard]] AlarmAction action(AlarmKind kind) const { return actions[std::size_t(kind)]; }
    friend bool operator==(const SupervisorRules &, const SupervisorRules &) = default;
};
