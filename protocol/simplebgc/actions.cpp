// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/actions.h"

#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr auto kSteerPeriod = 50ms;

constexpr Choice kImuChoices[] = {{0, "selected"}, {1, "main"}, {2, "frame"}};
constexpr Choice kForms[] = {{0, "extended"}, {1, "simple"}};
// clang-format off
constexpr Choice kCalibrationActions[] = {
    {1, "normal"}, {2, "reset-all"}, {3, "temperature"}, {4, "temperature-on"}, {5, "temperature-off"},
    {6, "restore-factory"}, {7, "copy-to-sensor"}};
constexpr Choice kSteerModes[] = {{Speed, "speed"}, {Angle, "angle"}, {SpeedAngle, "speed-angle"}, {Rc, "rc"},
                                  {AngleRelFrame, "angle-frame"}};
constexpr Choice kSounds[] = {{1, "calibrate"}, {2, "confirm"}, {4, "error"}, {16, "click"}, {32, "complete"},
                              {64, "intro"}, {32768, "melody"}};
constexpr Choice kDefaultsScope[] = {{0, "profile1"}, {1, "profile2"}, {2, "profile3"}, {3, "profile4"},
                                     {4, "profile5"}, {253, "erase-eeprom"}};

constexpr ArgumentSpec kMenuArguments[] = {
    {.key = "command", .label = "Command", .kind = ArgumentKind::Choice, .choices = kMenuActions}};
constexpr ArgumentSpec kProfileArguments[] = {
    {.key = "profile", .label = "Profile", .kind = ArgumentKind::Integer, .min = 1, .max = 5}};
constexpr ArgumentSpec kSteerArguments[] = {
    {.key = "mode", .label = "Mode", .kind = ArgumentKind::Choice, .choices = kSteerModes, .defaultText = "angle"},
    {.key = "roll", .label = "Roll", .kind = ArgumentKind::Real, .min = -720, .max = 720, .unit = "°",
     .defaultText = "nan"},
    {.key = "pitch", .label = "Pitch", .kind = ArgumentKind::Real, .min = -720, .max = 720, .unit = "°",
     .defaultText = "nan"},
    {.key = "yaw", .label = "Yaw", .kind = ArgumentKind::Real, .min = -720, .max = 720, .unit = "°",
     .defaultText = "nan"},
    {.key = "speed", .label = "Speed", .kind = ArgumentKind::Real, .min = 0, .max = 1000, .unit = "°/s",
     .defaultText = "30"},
    {.key = "seconds", .label = "Duration", .kind = ArgumentKind::Real, .min = 0.1, .max = 600, .unit = "s",
     .defaultText = "3"},
    {.key = "release", .label = "Release control at the end", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
constexpr ArgumentSpec kBeepArguments[] = {
    {.key = "sound", .label = "Sound", .kind = ArgumentKind::Choice, .choices = kSounds, .defaultText = "confirm"},
    {.key = "notes", .label = "Notes of a melody (Hz, comma between)", .kind = ArgumentKind::Text,
     .defaultText = "988,1175,1568"},
    {.key = "length", .label = "Length of a note", .kind = ArgumentKind::Integer, .min = 8, .max = 2040, .unit = "ms",
     .defaultText = "120"},
    {.key = "decay", .label = "Decay", .kind = ArgumentKind::Integer, .min = 0, .max = 15, .defaultText = "3"}};
constexpr ArgumentSpec kReadVariables[] = {
    {.key = "ids", .label = "Numbers (comma between)", .kind = ArgumentKind::Text,
     .defaultText = "0,1,2,3,4,5,6,7,8,9,10,11"}};
constexpr ArgumentSpec kWriteVariable[] = {
    {.key = "id", .label = "Number", .kind = ArgumentKind::Integer, .min = 0, .max = 255},
    {.key = "value", .label = "Value", .kind = ArgumentKind::Integer, .min = -2147483648.0, .max = 2147483647.0}};
constexpr ArgumentSpec kCalibrationArguments[] = {
    {.key = "imu", .label = "Sensor", .kind = ArgumentKind::Choice, .choices = kImuChoices, .defaultText = "selected"},
    {.key = "action", .label = "Kind", .kind = ArgumentKind::Choice, .choices = kCalibrationActions,
     .defaultText = "normal"},
    {.key = "form", .label = "Form of the command", .kind = ArgumentKind::Choice, .choices = kForms,
     .defaultText = "extended"}};
constexpr ArgumentSpec kBatteryArguments[] = {
    {.key = "voltage", .label = "Measured voltage", .kind = ArgumentKind::Real, .min = 3, .max = 60, .unit = "V"}};
constexpr ArgumentSpec kAutoTuneArguments[] = {
    {.key = "roll", .label = "Roll", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "pitch", .label = "Pitch", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "yaw", .label = "Yaw", .kind = ArgumentKind::Toggle, .defaultText = "on"},
    {.key = "profile", .label = "Profile (0 = active)", .kind = ArgumentKind::Integer, .min = 0, .max = 5,
     .defaultText = "0"},
    {.key = "gain", .label = "Gain against stability", .kind = ArgumentKind::Integer, .min = 0, .max = 255,
     .defaultText = "128"},
    {.key = "keep", .label = "Start from current gains", .kind = ArgumentKind::Toggle, .defaultText = "off"},
    {.key = "lpf", .label = "Tune the low-pass filter", .kind = ArgumentKind::Toggle, .defaultText = "off"},
    {.key = "save", .label = "Save the result", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
constexpr ArgumentSpec kResetArguments[] = {
    {.key = "delay", .label = "Delay", .kind = ArgumentKind::Integer, .min = 0, .max = 10000, .unit = "ms",
     .defaultText = "1000"}};
constexpr ArgumentSpec kDefaultsArguments[] = {
    {.key = "what", .label = "What", .kind = ArgumentKind::Choice, .choices = kDefaultsScope}};

constexpr ActionSpec kActions[] = {
    {.key = "angles", .label = "Read angles", .help = "Camera, target and motor angles.", .group = "Read"},
    {.key = "debug.list", .label = "List debug variables", .help = "Names and types of the board's inner variables.",
     .group = "Read"},
    {.key = "debug.read", .label = "Read debug variables", .help = "Values of the board's inner variables.",
     .group = "Read"},
    {.key = "variables.read", .label = "Read adjustable variables", .help = "Live values in the board's memory.",
     .group = "Read", .arguments = kReadVariables},
    {.key = "beep", .label = "Make a sound", .help = "Standard sound or melody; helps to find the right board.",
     .group = "Board", .arguments = kBeepArguments, .since = 2590},
    {.key = "motors.on", .label = "Motors on", .help = "Starts stabilization.", .group = "Motion",
     .risk = ActionRisk::Moves},
    {.key = "motors.off", .label = "Motors off", .help = "Switches all motors off at once.", .group = "Motion"},
    {.key = "menu", .label = "Menu command", .help = "Runs a command of the board's menu.", .group = "Motion",
     .risk = ActionRisk::Moves, .arguments = kMenuArguments},
    {.key = "steer", .label = "Steer", .help = "Moves the camera for a time, then gives control back.",
     .group = "Motion", .risk = ActionRisk::Moves, .arguments = kSteerArguments, .isProcedure = true},
    {.key = "profile.select", .label = "Use profile", .help = "Makes a profile the active one.", .group = "Profiles",
     .risk = ActionRisk::Moves, .arguments = kProfileArguments},
    {.key = "variables.write", .label = "Set adjustable variable",
     .help = "Changes a value in volatile memory; lost at the next start unless saved.", .group = "Variables",
     .risk = ActionRisk::Moves, .arguments = kWriteVariable},
    {.key = "variables.save", .label = "Save variables", .help = "Stores the live values in the active profile.",
     .group = "Variables", .risk = ActionRisk::Writes},
    {.key = "calibrate.gyro", .label = "Calibrate gyroscope",
     .help = "Measures the zero of the gyroscope. The camera must stand absolutely still.", .group = "Calibration",
     .risk = ActionRisk::Writes, .arguments = kCalibrationArguments, .isProcedure = true},
    {.key = "calibrate.acc", .label = "Calibrate accelerometer",
     .help = "Measures the zero of the accelerometer in this position. The sensor must be level and still.",
     .group = "Calibration", .risk = ActionRisk::Writes, .arguments = kCalibrationArguments, .isProcedure = true},
    {.key = "calibrate.battery", .label = "Calibrate voltage sensor",
     .help = "Tells the board the true battery voltage.", .group = "Calibration", .risk = ActionRisk::Writes,
     .arguments = kBatteryArguments, .capability = "battery"},
    {.key = "calibrate.offset", .label = "Calibrate follow offset",
     .help = "Takes the present position as the neutral point of following.", .group = "Calibration",
     .risk = ActionRisk::Writes, .isProcedure = true},
    {.key = "autotune", .label = "Auto-tune PID", .help = "The board searches gains by moving the camera.",
     .group = "Calibration", .risk = ActionRisk::Writes, .arguments = kAutoTuneArguments, .isProcedure = true},
    {.key = "reset", .label = "Restart board", .help = "Restarts the controller; motors go off meanwhile.",
     .group = "Board", .risk = ActionRisk::Moves, .arguments = kResetArguments},
    {.key = "defaults", .label = "Factory defaults", .help = "Overwrites a profile, or everything, with defaults.",
     .group = "Board", .risk = ActionRisk::Destroys, .arguments = kDefaultsArguments},
};
// clang-format on

const QString kAxisNames[] = {u"roll"_s, u"pitch"_s, u"yaw"_s};

Result<QList<int>> parseNumbers(const QString &text, int min, int max)
{
    QList<int> numbers;
    for (const QString &part : text.split(u',', Qt::SkipEmptyParts)) {
        bool ok = false;
        const int value = part.trimmed().toInt(&ok);
        if (!ok || value < min || value > max) {
            return failure(ErrorCode::InvalidArgument,
                           u"'%1' is not a whole number from %2 to %3"_s.arg(part).arg(min).arg(max));
        }
        numbers.append(value);
    }
    return numbers;
}

}  // namespace

// clang-format off
const Actions::Entry Actions::kHandlers[] = {
    {"angles", &Actions::readAngles},
    {"debug.list", &Actions::listDebugVariables},
    {"debug.read", &Actions::readDebugVariables},
    {"variables.read", &Actions::readVariables},
    {"beep", &Actions::beep},
    {"motors.on", &Actions::motorsOn},
    {"motors.off", &Actions::motorsOff},
    {"menu", &Actions::menu},
    {"steer", &Actions::steer},
    {"profile.select", &Actions::selectProfile},
    {"variables.write", &Actions::writeVariable},
    {"variables.save", &Actions::saveVariables},
    {"calibrate.gyro", &Actions::calibrateGyro},
    {"calibrate.acc", &Actions::calibrateAcc},
    {"calibrate.battery", &Actions::calibrateBattery},
    {"calibrate.offset", &Actions::calibrateOffset},
    {"autotune", &Actions::autoTune},
    {"reset", &Actions::reset},
    {"defaults", &Actions::useDefaults},
};
// clang-format on

std::vector<ActionSpec> Actions::available(const BoardIdentity &identity)
{
    std::vector<ActionSpec> list;
    for (const ActionSpec &action : kActions) {
        if (identity.firmwareNumber < action.since)
            continue;
        if (*action.capability && !identity.capabilities.contains(QLatin1String(action.capability)))
            continue;
        list.push_back(action);
    }
    return list;
}

Result<ActionReply> Actions::perform(const QString &key, const QVariantMap &arguments)
{
    for (const Entry &entry : kHandlers) {
        if (key == QLatin1String(entry.key))
            return (this->*entry.handler)(arguments);
    }
    return failure(ErrorCode::Unsupported, key);
}

Result<ActionReply> Actions::confirm(CommandId id, const QByteArray &payload)
{
    const auto reply = m_channel.transact(confirmRequest(id, payload, Device::kVersion));
    if (!reply)
        return tl::unexpected(reply.error());
    return ActionReply{};
}

Result<ActionReply> Actions::readAngles(const QVariantMap &)
{
    const auto plain = m_channel.transact(
        replyRequest(CommandId::GetAngles, {}, CommandId::GetAngles, 18, Device::kVersion));
    if (!plain)
        return tl::unexpected(plain.error());
    const auto angles = decodeAngles(asBytes(plain->payload));
    if (!angles)
        return tl::unexpected(angles.error());
    ActionReply reply;
    for (std::size_t axis = 0; axis < angles->size(); ++axis) {
        reply.insert(u"imu."_s + kAxisNames[axis], (*angles)[axis].imu);
        reply.insert(u"target."_s + kAxisNames[axis], (*angles)[axis].target);
        reply.insert(u"speed."_s + kAxisNames[axis], (*angles)[axis].targetSpeed);
    }
    // The motor angles come with a later command (document revision 0.6); boards without it are read all the
    // same.
    Request request
        = replyRequest(CommandId::GetAnglesExt, {}, CommandId::GetAnglesExt, 54, Device::kVersion);
    request.retries = 1;
    if (const auto extended = m_channel.transact(request)) {
        if (const auto more = decodeAnglesExt(asBytes(extended->payload))) {
            for (std::size_t axis = 0; axis < more->size(); ++axis)
                reply.insert(u"motor."_s + kAxisNames[axis], (*more)[axis].rotor);
        }
    }
    return reply;
}

Result<ActionReply> Actions::listDebugVariables(const QVariantMap &)
{
    const auto vars = m_device.debugVariables(m_channel);
    if (!vars)
        return tl::unexpected(vars.error());
    ActionReply reply;
    for (const DebugVariable &var : *vars)
        reply.insert(var.name, var.type);
    return reply;
}

Result<ActionReply> Actions::readDebugVariables(const QVariantMap &)
{
    const auto vars = m_device.debugVariables(m_channel);
    if (!vars)
        return tl::unexpected(vars.error());
    const auto values = m_device.readDebugVariables(m_channel);
    if (!values)
        return tl::unexpected(values.error());
    ActionReply reply;
    for (std::size_t i = 0; i < vars->size(); ++i) {
        QVariantList elements;
        for (const double value : (*values)[i])
            elements.append(value);
        reply.insert((*vars)[i].name, elements.size() == 1 ? elements.first() : QVariant(elements));
    }
    return reply;
}

Result<ActionReply> Actions::motorsOn(const QVariantMap &)
{
    return confirm(CommandId::MotorsOn);
}

Result<ActionReply> Actions::motorsOff(const QVariantMap &)
{
    const auto reply = m_channel.transact(confirmRequest(CommandId::MotorsOff, {}, Device::kVersion));
    if (!reply)
        return tl::unexpected(reply.error());
    return ActionReply{};
}

Result<ActionReply> Actions::menu(const QVariantMap &arguments)
{
    return confirm(CommandId::ExecuteMenu, ByteWriter().u8(arguments.value(u"command"_s).toInt()).take());
}

Result<ActionReply> Actions::selectProfile(const QVariantMap &arguments)
{
    const auto done = m_device.selectProfile(m_channel, arguments.value(u"profile"_s).toInt() - 1);
    if (!done)
        return tl::unexpected(done.error());
    return ActionReply{};
}

Result<ActionReply> Actions::steer(const QVariantMap &arguments)
{
    const int mode = arguments.value(u"mode"_s).toInt();
    const double speed = arguments.value(u"speed"_s).toDouble();
    Device::Control setpoint{};
    bool any = false;
    for (std::size_t axis = 0; axis < setpoint.size(); ++axis) {
        const QVariant wanted = arguments.value(kAxisNames[axis]);
        if (!wanted.isValid() || std::isnan(wanted.toDouble()))
            continue;
        any = true;
        // In speed mode the axis value is the speed itself.
        const double value = wanted.toDouble();
        setpoint[axis]
            = mode == Speed ? Device::AxisControl{mode, value, 0.0} : Device::AxisControl{mode, speed, value};
    }
    if (!any)
        return failure(ErrorCode::InvalidArgument, u"steer needs roll=, pitch= or yaw="_s);

    const ControlFrames frames = m_device.controlFrames(setpoint);
    const auto unanswered = [](const QByteArray &bytes) {
        Request request;
        request.name = u"CONTROL"_s;
        request.bytes = bytes;
        return request;
    };
    const auto seconds = arguments.value(u"seconds"_s).toDouble();
    const TimePoint end = m_channel.now() + durationFromSeconds(seconds);
    Progress progress;
    progress.step = u"steer"_s;
    progress.total = 100;
    Result<void> slept;
    while (m_channel.now() < end && slept) {
        m_channel.post(unanswered(frames.setpoint));
        progress.done
            = int(100.0 * (1.0 - std::chrono::duration<double>(end - m_channel.now()).count() / seconds));
        m_channel.progress(progress);
        slept = m_channel.sleep(kSteerPeriod);
    }
    if (mode == Speed || !slept)
        m_channel.post(unanswered(frames.stop));
    if (arguments.value(u"release"_s).toBool())
        m_channel.post(unanswered(frames.release));
    if (!slept)
        return tl::unexpected(slept.error());
    return readAngles({});
}

Result<ActionReply> Actions::beep(const QVariantMap &arguments)
{
    constexpr int kMelody = 32768;
    constexpr int kMaxNotes = 30;
    const int sound = arguments.value(u"sound"_s).toInt();
    QList<int> notes;
    if (sound == kMelody) {
        const auto parsed = parseNumbers(arguments.value(u"notes"_s).toString(), 554, 21000);
        if (!parsed)
            return tl::unexpected(parsed.error());
        if (parsed->size() > kMaxNotes)
            return failure(ErrorCode::InvalidArgument, u"a melody has at most %1 notes"_s.arg(kMaxNotes));
        notes = *parsed;
    }
    const int length = std::max(1, arguments.value(u"length"_s).toInt() / 8);
    const auto sent = m_channel.transact(silentRequest(
        CommandId::BeepSound, encodeBeep(sound, length, arguments.value(u"decay"_s).toInt(), notes),
        Device::kVersion));
    if (!sent)
        return tl::unexpected(sent.error());
    return ActionReply{};
}

Result<ActionReply> Actions::readVariables(const QVariantMap &arguments)
{
    const auto ids = parseNumbers(arguments.value(u"ids"_s).toString(), 0, 255);
    if (!ids)
        return tl::unexpected(ids.error());
    const auto values = m_device.readAdjustables(m_channel, *ids);
    if (!values)
        return tl::unexpected(values.error());
    ActionReply reply;
    for (const AdjustableValue &value : *values)
        reply.insert(QString::number(value.id), value.value);
    return reply;
}

Result<ActionReply> Actions::writeVariable(const QVariantMap &arguments)
{
    const auto done = m_device.writeAdjustables(
        m_channel, {{arguments.value(u"id"_s).toInt(), arguments.value(u"value"_s).toDouble()}});
    if (!done)
        return tl::unexpected(done.error());
    return ActionReply{};
}

Result<ActionReply> Actions::saveVariables(const QVariantMap &)
{
    Request request = confirmRequest(CommandId::SaveParams3, {}, Device::kVersion);
    request.timeout = 1500ms;
    const auto reply = m_channel.transact(request);
    if (!reply)
        return tl::unexpected(reply.error());
    return ActionReply{};
}

Result<ActionReply> Actions::reset(const QVariantMap &arguments)
{
    Request request
        = replyRequest(CommandId::Reset, ByteWriter().u8(1).u16(arguments.value(u"delay"_s).toInt()).take(),
                       CommandId::Reset, 0, Device::kVersion);
    request.idempotent = false;
    const auto notice = m_channel.transact(request);
    if (!notice)
        return tl::unexpected(notice.error());
    return ActionReply{};
}

Result<ActionReply> Actions::useDefaults(const QVariantMap &arguments)
{
    Request request = confirmRequest(
        CommandId::UseDefaults, ByteWriter().u8(arguments.value(u"what"_s).toInt()).take(), Device::kVersion);
    request.timeout = 3000ms;
    const auto reply = m_channel.transact(request);
    if (!reply)
        return tl::unexpected(reply.error());
    return ActionReply{};
}

}  // namespace simplebgc
