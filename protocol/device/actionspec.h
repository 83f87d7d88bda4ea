// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"
#include "protocol/base/result.h"
#include "protocol/configuration/parameterspec.h"

#include <QVariantMap>

/// What an action can do to a gimbal.
enum class ActionRisk { Safe, Moves, Writes, Destroys };

/// Effect of an action on the values in use, on boards that keep them apart from the stored ones.
enum class MemoryEffect {
    None,
    ChangesInUse,  ///< the values in use differ from the stored ones afterwards
    Stores,  ///< all values in use are stored
    Reloads,  ///< the stored values are in use again
};

enum class ArgumentKind { Integer, Real, Choice, Text, Toggle };

/// One typed argument of an action.
struct ArgumentSpec
{
    const char *key = "";
    const char *label = "";
    ArgumentKind kind = ArgumentKind::Integer;
    double min = 0;
    double max = 255;
    const char *unit = "";
    std::span<const Choice> choices{};
    const char *defaultText = "";  ///< "" = required
};

/// What must hold before an action is performed, according to the channels with the roles "armed",
/// "calibrated" and "outputs".
enum class Condition : std::uint8_t { Disarmed, Calibrated, MotorsOff };

/// The unit of figures in a reply.
struct ReplyUnit
{
    const char *part = "";  ///< a part of the figure's key between dots: "imu" for "imu.roll", "gyro.bias"
    const char *unit = "";
};

/// A named command: everything a protocol can do that is neither a parameter nor telemetry.
struct ActionSpec
{
    const char *key = "";  ///< "calibrate.gyro"
    const char *label = "";
    const char *help = "";
    const char *group = "";
    ActionRisk risk = ActionRisk::Safe;
    std::span<const ArgumentSpec> arguments{};
    bool isProcedure = false;  ///< takes many steps, with progress and cancel
    int since = 0;
    const char *capability = "";
    MemoryEffect memory = MemoryEffect::None;
    bool whileSteering = false;  ///< offered on the control page
    std::span<const Condition> needs{};
    const char *confirm = "";  ///< what the operator has to confirm each time: "The propellers are off."
    milliseconds silence{0};  ///< how long the board says nothing afterwards
    std::span<const ReplyUnit> units{};  ///< of the reply's figures; the first that fits counts
    bool answered = true;  ///< false: the board does not even confirm it, so it is sent at best, never done
};

/// The reply: figures and texts by key, e.g. {"angle.roll": 1.25}.
using ActionReply = QVariantMap;

/// The unit of a figure in the action's reply ("°"); empty where it has none.
QString replyUnit(const ActionSpec &action, const QString &key);

/// Checks texts against the specs and fills in defaults. Errors: InvalidArgument naming the argument, its
/// type and range.
Result<QVariantMap> parseArguments(const ActionSpec &action, const QMap<QString, QString> &texts);
