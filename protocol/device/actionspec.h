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
    Erases,  ///< what was stored is gone; the values in use stay until the next start
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

/// What one entry of a choice does, where it is not what the action does in general.
struct EntryEffect
{
    int value = 0;  ///< of the action's first argument, unless another one is named
    ActionRisk risk = ActionRisk::Safe;
    MemoryEffect memory = MemoryEffect::None;
    bool isShown = true;
    bool letsGo = false;
    const char *argument = "";  ///< a choice, or a toggle that counts as 1
    bool switchesMotors = false;
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
    std::span<const EntryEffect> entries{};
    bool answered = true;  ///< false: the board does not even confirm it, so it is sent at best, never done
    /// false: the board confirms it, and says nothing that would show whether it was carried out: sent as
    /// well
    bool isShown = true;
    /// It stores, and reads back what the board holds once it has started anew with it.
    bool provesStore = false;
    /// The action that ends it on the board, and proves that, where it was broken off here: the board goes on
    /// by itself.
    const char *endedBy = "";
    /// Motors that run lose their current by it, although that is not what it is for: what they hold falls.
    bool letsGo = false;
    /// Whether motors run is otherwise afterwards: that is what it does.
    bool switchesMotors = false;
    /// It is a stop: it waits for no turn and goes on until the board's state proves it (StopPlan).
    bool stopsMotors = false;
};

/// The reply: figures and texts by key, e.g. {"angle.roll": 1.25}.
using ActionReply = QVariantMap;

/// The unit of a figure in the action's reply ("°"); empty where it has none.
QString replyUnit(const ActionSpec &action, const QString &key);

/// The action as it is with these arguments: risk, memory and answer follow the entry that was chosen.
[[nodiscard]] ActionSpec chosenAction(const ActionSpec &action, const QVariantMap &arguments);

/// What puts the stored values into use again and asks for nothing else; null: no action does.
[[nodiscard]] const ActionSpec *reloadingAction(std::span<const ActionSpec> actions);

/// Numbers that a person may mean otherwise than they count: "1" for "profile1", whose number is 0. Error:
/// InvalidArgument with the names.
Result<void> checkClear(const ActionSpec &action, const QMap<QString, QString> &texts);

/// Checks texts against the specs and fills in defaults. Errors: InvalidArgument naming the argument, its
/// type and range.
Result<QVariantMap> parseArguments(const ActionSpec &action, const QMap<QString, QString> &texts);
