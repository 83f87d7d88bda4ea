// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/actions.h"

#include "protocol/base/angles.h"
#include "protocol/storm32/look.h"
#include "protocol/storm32/parametertables.h"
#include "protocol/storm32/procedures.h"
#include "protocol/storm32/telemetrytables.h"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr auto kSettling = 1500ms;
constexpr auto kUntilStart = 3s;
constexpr auto kLongestTurn = 30s;
constexpr auto kRestingFor = 2s;  // no nearer to where it was steered
constexpr auto kLookEvery = 100ms;
constexpr double kArrived = 3.0;  // degrees
constexpr double kNearer = 1.0;
constexpr int kMinPulse = 700;  // µs (document, CMD_SETPITCH)
constexpr int kMaxPulse = 2300;
// Bits of the status (errata 3.8).
constexpr unsigned kCameraImuThere = 0x8000;
constexpr unsigned kFrameImuThere = 0x1000;

// clang-format off
constexpr Choice kPanModeChoices[] = {{0, "as set"}, {1, "hold hold pan"}, {2, "hold hold hold"}, {3, "pan pan pan"}, {4, "pan hold hold"},
                                {5, "pan hold pan"}, {6, "hold pan pan"}};
// clang-format on
constexpr Choice kPanSettings[] = {{0, "default"}, {1, "1"}, {2, "2"}, {3, "3"}};
constexpr Choice kShotChoices[]
    = {{0, "off"}, {1, "shutter"}, {2, "shutter-delayed"}, {3, "video-on"}, {4, "video-off"}};
constexpr Choice kCases[] = {{0, "off"}, {1, "default"}, {2, "1"}, {3, "2"}, {4, "3"}};
constexpr Choice kRates[] = {{0, "9600"}, {1, "19200"}, {2, "38400"}, {3, "57600"}, {4, "115200"}};

// clang-format off
constexpr ArgumentSpec kAngles[] = {
    {.key = "pitch", .label = "Pitch", .kind = ArgumentKind::Real, .min = -720, .max = 720, .unit = "°", .defaultText = "0"},
    {.key = "roll", .label = "Roll", .kind = ArgumentKind::Real, .min = -720, .max = 720, .unit = "°", .defaultText = "0"},
    {.key = "yaw", .label = "Yaw", .kind = ArgumentKind::Real, .min = -720, .max = 720, .unit = "°", .defaultText = "0"},
    {.key = "limited", .label = "Within the limits of the sticks", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
constexpr ArgumentSpec kPulses[] = {
    {.key = "pitch", .label = "Pitch (0 = middle)", .min = 0, .max = 2300, .unit = "µs", .defaultText = "nan"},
    {.key = "roll", .label = "Roll (0 = middle)", .min = 0, .max = 2300, .unit = "µs", .defaultText = "nan"},
    {.key = "yaw", .label = "Yaw (0 = middle)", .min = 0, .max = 2300, .unit = "µs", .defaultText = "nan"}};
constexpr ArgumentSpec kPanMode[] = {{.key = "mode", .label = "Pan mode (pitch roll yaw)", .kind = ArgumentKind::Choice, .choices = kPanModeChoices}};
constexpr ArgumentSpec kPanSetting[] = {{.key = "setting", .label = "Pan mode setting", .kind = ArgumentKind::Choice, .choices = kPanSettings}};
constexpr ArgumentSpec kStandby[] = {{.key = "on", .label = "Standby", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
constexpr ArgumentSpec kShot[] = {{.key = "shot", .label = "Shot", .kind = ArgumentKind::Choice, .choices = kShotChoices, .defaultText = "shutter"}};
constexpr ArgumentSpec kScript[] = {
    {.key = "script", .label = "Script", .min = 1, .max = 4},
    {.key = "case", .label = "Case", .kind = ArgumentKind::Choice, .choices = kCases, .defaultText = "default"}};
constexpr ArgumentSpec kPwm[] = {{.key = "pulse", .label = "Pulse", .min = 700, .max = 2300, .unit = "µs", .defaultText = "1500"}};
constexpr ArgumentSpec kName[] = {{.key = "name", .label = "Name", .kind = ArgumentKind::Text}};
constexpr ArgumentSpec kRate[] = {{.key = "rate", .label = "Rate", .kind = ArgumentKind::Choice, .choices = kRates, .defaultText = "115200"}};
constexpr ArgumentSpec kWord[] = {{.key = "word", .label = "Number of the word", .min = 0, .max = 124}};

constexpr ReplyUnit kStatusUnits[] = {{"voltage", "V"}};
constexpr ReplyUnit kPlaceUnits[] = {{"pitch", "°"}, {"roll", "°"}, {"yaw", "°"}};
constexpr ReplyUnit kSensorUnits[] = {{"temperature", "°C"}};

constexpr ActionSpec kActions[] = {
    {.key = "status", .label = "Read status", .help = "State, status bits, bus errors and voltage.", .group = "Read", .units = kStatusUnits},
    {.key = "calibration.read", .label = "Read calibration", .help = "Zeros and scales of both sensors.", .group = "Read"},
    {.key = "sensors.raw", .label = "Read raw sensors", .help = "Counts of both sensors before calibration.", .group = "Read", .units = kSensorUnits},
    {.key = "motors.on", .label = "Start motors", .help = "Leaves standby.", .group = "Motion", .risk = ActionRisk::Moves, .switchesMotors = true},
    {.key = "motors.off", .label = "Stop motors", .help = "Standby: all motors are without current.", .group = "Motion", .stopsMotors = true},
    {.key = "angle", .label = "Set angles", .help = "Turns the camera to these angles; down, right and left are positive.",
     .group = "Motion", .risk = ActionRisk::Moves, .arguments = kAngles, .units = kPlaceUnits},
    {.key = "sticks", .label = "Set stick positions", .help = "Steers like a receiver would: 700 to 2300 µs, 0 for the middle. An axis without a value stays as it is.", .group = "Motion",
     .risk = ActionRisk::Moves, .arguments = kPulses, .isShown = false},
    {.key = "recenter", .label = "Re-center", .help = "Brings the camera back to its middle.", .group = "Motion", .risk = ActionRisk::Moves, .whileSteering = true, .isShown = false},
    {.key = "pan.mode", .label = "Pan mode", .help = "Which axes follow the handle, until it is changed back.", .group = "Motion",
     .risk = ActionRisk::Moves, .arguments = kPanMode, .whileSteering = true, .isShown = false},
    {.key = "pan.setting", .label = "Pan mode setting", .help = "One of the four that are set up.", .group = "Motion",
     .risk = ActionRisk::Moves, .arguments = kPanSetting, .whileSteering = true, .isShown = false},
    {.key = "standby", .label = "Standby", .help = "Switches standby on or off.", .group = "Motion", .risk = ActionRisk::Moves,
     .arguments = kStandby, .whileSteering = true, .switchesMotors = true},
    {.key = "level", .label = "Level", .help = "Levels the gimbal anew.", .group = "Motion", .risk = ActionRisk::Moves, .isShown = false},
    {.key = "camera", .label = "Release the camera", .help = "By infrared, as the camera model is set.", .group = "Functions",
     .arguments = kShot, .whileSteering = true, .isShown = false},
    {.key = "script", .label = "Run a script", .help = "Chooses the case that a script runs.", .group = "Functions",
     .risk = ActionRisk::Moves, .arguments = kScript, .whileSteering = true, .isShown = false},
    {.key = "pwm", .label = "PWM output", .help = "Sets the servo output.", .group = "Functions", .risk = ActionRisk::Moves,
     .arguments = kPwm, .whileSteering = true, .isShown = false},
    {.key = "trim", .label = "Take RC trims", .help = "Takes the sticks' present positions as their middle; in RAM.", .group = "Setup",
     .risk = ActionRisk::Writes, .memory = MemoryEffect::ChangesInUse, .isShown = false},
    {.key = "directions.take", .label = "Take motor directions", .help = "Copies the directions that were found into the parameters; in RAM.",
     .group = "Setup", .risk = ActionRisk::Writes, .memory = MemoryEffect::ChangesInUse},
    {.key = "start.take", .label = "Take start positions, pitch and roll", .help = "Copies where the motors stand now; in RAM.",
     .group = "Setup", .risk = ActionRisk::Writes, .memory = MemoryEffect::ChangesInUse, .isShown = false},
    {.key = "start.take_yaw", .label = "Take start position, yaw", .help = "Copies where the motor stands now; in RAM.", .group = "Setup",
     .risk = ActionRisk::Writes, .memory = MemoryEffect::ChangesInUse, .isShown = false},
    {.key = "name", .label = "Name the board", .help = "Up to 16 letters; stored at once.", .group = "Setup", .risk = ActionRisk::Writes,
     .arguments = kName},
    {.key = "rate", .label = "Set the serial rate", .help = "Stored at once; takes effect when the board is switched on again.",
     .group = "Setup", .risk = ActionRisk::Writes, .arguments = kRate, .isShown = false},
    {.key = "heartbeat.off", .label = "Switch the heartbeat off",
     .help = "Plain commands work again on this port at once. In RAM; store it to keep it.", .group = "Setup", .risk = ActionRisk::Writes, .memory = MemoryEffect::ChangesInUse},
    {.key = "store", .label = "Store", .help = "Stores all values in use, scripts included.", .group = "Memory", .risk = ActionRisk::Writes, .memory = MemoryEffect::Stores},
    {.key = "retrieve", .label = "Revert all values", .help = "Puts the stored values into use again; what was not stored is gone.",
     .group = "Memory", .risk = ActionRisk::Destroys, .memory = MemoryEffect::Reloads},
    {.key = "restore", .label = "Revert one value", .help = "Puts the stored value of one parameter into use again.", .group = "Memory",
     .risk = ActionRisk::Writes, .arguments = kWord, .memory = MemoryEffect::ChangesInUse},
    {.key = "defaults", .label = "Factory defaults", .help = "Puts the defaults into use; stored values stay until you store.",
     .group = "Memory", .risk = ActionRisk::Destroys, .memory = MemoryEffect::ChangesInUse},
    {.key = "erase", .label = "Erase the memory", .help = "The next start begins with defaults. Values in use stay until then.",
     .group = "Memory", .risk = ActionRisk::Destroys, .memory = MemoryEffect::Erases, .isShown = false},
    {.key = "restart", .label = "Restart", .help = "Restarts the controller with the stored values; motors go off, then start by themselves.",
     .group = "Board", .risk = ActionRisk::Moves, .memory = MemoryEffect::Reloads, .letsGo = true},
    {.key = "reset", .label = "Hardware reset", .help = "Like switching off and on: motors go off, then start by themselves.", .group = "Board", .risk = ActionRisk::Moves, .memory = MemoryEffect::Reloads, .letsGo = true},
    {.key = "motors.normal", .label = "Use all motors, restart", .help = "Sets all motors to normal use and restarts: the motors start.", .group = "Board",
     .risk = ActionRisk::Writes, .memory = MemoryEffect::ChangesInUse, .letsGo = true},
};
// clang-format on

}  // namespace

std::span<const ActionSpec> Actions::all()
{
    static const std::vector<ActionSpec> both = [] {
        std::vector<ActionSpec> list(std::begin(kActions), std::end(kActions));
        const auto procedures = Procedures::all();
        list.insert(list.end(), procedures.begin(), procedures.end());
        return list;
    }();
    return both;
}

Result<ActionReply> Actions::simple(Simple id, QByteArrayView arguments)
{
    const auto reply = m_channel.transact(m_device.simple(id, arguments));
    if (!reply)
        return tl::unexpected(reply.error());
    return ActionReply{};
}

Result<ActionReply> Actions::rc(Rc id, const QVariantMap &values)
{
    const RcCommand &command = *findRc(int(id));
    const auto payload = encodeFields(command.fields, values, command.payloadBytes);
    if (!payload)
        return tl::unexpected(payload.error());
    const auto reply = m_channel.transact(m_device.rc(id, *payload));
    if (!reply)
        return tl::unexpected(reply.error());
    return ActionReply{};
}

Result<Actions::Place> Actions::place()
{
    constexpr std::size_t kFirstAngle = 16;  // words of the live data (errata 3.5)
    constexpr std::size_t kFirstInput = 22;
    constexpr std::array<unsigned, 3> kPans{kPanBits[1], kPanBits[0], kPanBits[2]};
    const auto reply = m_channel.transact(m_device.rc(Rc::GetData, QByteArray(1, '\0')));
    if (!reply)
        return tl::unexpected(reply.error());
    ByteReader reader(QByteArrayView(reply->payload).sliced(2));
    std::array<int, kFirstInput + 3> words{};
    for (int &word : words)
        word = reader.i16();
    if (!reader.ok())
        return failure(ErrorCode::BadReply, u"GETDATA: %1 bytes"_s.arg(reply->payload.size()));
    const unsigned pans = unsigned(words[2]) | m_device.m_history->shifted;
    const bool sees = unsigned(words[1]) & kCameraImuThere;
    Place place;
    place.state = words[0];
    place.motorsRun = (words[2] & kMotorBits) != 0;
    for (std::size_t i = 0; i < kPans.size(); ++i) {
        place.angles[i] = words[kFirstAngle + i] * 0.01;
        place.isPlain[i] = sees && !(pans & kPans[i]) && std::abs(words[kFirstInput + i]) <= kStickRest;
    }
    return place;
}

// The board acknowledges every angle, and tells where the camera is but not its target.
Result<ActionReply> Actions::angle(const QVariantMap &arguments)
{
    static constexpr std::array kOrder{"pitch", "roll", "yaw"};
    const auto before = place();
    if (!before)
        return tl::unexpected(before.error());
    const bool works = m_device.isStabilising(before->state);
    if (isStandby(before->state, m_device.m_firmware) || (works && !before->motorsRun))
        return failure(ErrorCode::ConditionUnmet, u"the motors are off, so nothing would move"_s);
    const bool isLimited = arguments.value(u"limited"_s, true).toBool();
    QVariantMap values{{u"flags"_s, isLimited ? 7 : 0}};
    std::array<double, 3> wanted{};
    std::array<double, 3> near{};  // of a small turn, half is not there
    for (std::size_t i = 0; i < kOrder.size(); ++i) {
        wanted[i] = arguments.value(QLatin1String(kOrder[i])).toDouble();
        near[i] = std::clamp(turnBetween(wanted[i], before->angles[i]) / 2, kNearer, kArrived);
        values.insert(QLatin1String(kOrder[i]), float(wanted[i]));
    }
    if (const auto sent = rc(Rc::SetAngle, values); !sent)
        return sent;
    if (!works)  // it goes there when it has started
        return ActionReply{{u"confirmed"_s, false},
                           {u"state"_s, stateName(before->state, m_device.m_firmware)}};
    const TimePoint until = m_channel.now() + kLongestTurn;
    // What comes no nearer does not get there; a camera that something holds moves with the hand.
    std::array<double, 3> nearest{360.0, 360.0, 360.0};
    TimePoint nearerAt = m_channel.now();
    for (;;) {
        const auto now = place();
        if (!now)
            return tl::unexpected(now.error());
        ActionReply reply;
        QStringList away;
        for (std::size_t i = 0; i < kOrder.size(); ++i) {
            const QString axis = QLatin1String(kOrder[i]);
            if (!now->isPlain[i] && wanted[i] != 0.0)
                reply.insert(u"confirmed"_s, false);  // it counts from where nobody knows
            if (!now->isPlain[i])
                continue;
            reply.insert(axis, now->angles[i]);
            const double distance = turnBetween(wanted[i], now->angles[i]);
            if (distance < nearest[i] - kNearer) {
                nearest[i] = distance;
                nearerAt = m_channel.now();
            }
            if (distance > near[i])
                away.append(u"%1: target %2°, camera at %3°"_s.arg(axis)
                                .arg(wanted[i], 0, 'f', 1)
                                .arg(now->angles[i], 0, 'f', 1));
        }
        if (away.isEmpty())
            return reply;
        if (m_channel.now() >= until || m_channel.now() - nearerAt > kRestingFor) {
            return failure(
                ErrorCode::NotSeen,
                u"the camera did not get where it was steered to, %1"_s.arg(away.join(u"; "_s))
                    + (isLimited ? u"; the limits of the sticks may hold it back, which limited=off lifts"_s
                                 : QString()));
        }
        if (const auto slept = m_channel.sleep(kLookEvery); !slept)
            return tl::unexpected(slept.error());
    }
}

// The board acknowledges pulses that it ignores (document, CMD_SETPITCH), so they are checked here. An axis
// that is not named has no place in a command for all three: 0 would bring it to its middle.
Result<ActionReply> Actions::sticks(const QVariantMap &arguments)
{
    static constexpr std::array<std::pair<const char *, Rc>, 3> kAxisCommands{
        {{"pitch", Rc::SetPitch}, {"roll", Rc::SetRoll}, {"yaw", Rc::SetYaw}}};
    std::vector<std::pair<Rc, int>> named;
    for (const auto &[axis, command] : kAxisCommands) {
        const QVariant given = arguments.value(QLatin1String(axis));
        if (!given.isValid())
            continue;
        const int pulse = given.toInt();
        if (pulse != 0 && (pulse < kMinPulse || pulse > kMaxPulse)) {
            return failure(ErrorCode::OutOfRange,
                           u"%1=%2, allowed %3 to %4 µs, or 0 for the middle"_s.arg(QLatin1String(axis))
                               .arg(pulse)
                               .arg(kMinPulse)
                               .arg(kMaxPulse));
        }
        named.emplace_back(command, pulse);
    }
    if (named.empty())
        return failure(ErrorCode::InvalidArgument, u"sticks needs pitch=, roll= or yaw="_s);
    if (named.size() == kAxisCommands.size())
        return rc(Rc::SetPitchRollYaw, arguments);
    for (const auto &[command, pulse] : named) {
        if (auto done = rc(command, {{u"pulse"_s, pulse}}); !done)
            return done;
    }
    return ActionReply{};
}

// The board acknowledges the case of any script (errata 13, 12). One whose Script Control is off never runs
// (errata 8).
Result<ActionReply> Actions::runScript(int script, int chosen)
{
    const auto parameters = m_device.parameters();
    const ParameterSpec *input = parameters ? parameters->find(u"script%1.input"_s.arg(script)) : nullptr;
    if (input) {
        const auto raw = m_device.readWord(m_channel, input->offset / 2);
        if (!raw)
            return tl::unexpected(raw.error());
        if (*raw == 0) {
            return failure(
                ErrorCode::ConditionUnmet,
                u"%1 is off, so script %2 never runs; choose an input for it first"_s.arg(input->key)
                    .arg(script));
        }
    }
    return rc(Rc::SetScriptControl, {{u"script"_s, script - 1}, {u"case"_s, chosen}});
}

Result<ActionReply> Actions::status()
{
    const auto reply = m_channel.transact(m_device.simple(Simple::Status));
    if (!reply)
        return tl::unexpected(reply.error());
    ByteReader reader(reply->payload);
    const int state = reader.u16();
    const int bits = reader.u16();
    const int more = reader.u16();
    const int errors = reader.u16();
    return ActionReply{{u"state"_s, stateName(state, m_device.m_firmware)},
                       {u"status"_s, u"0x%1"_s.arg(bits, 4, 16, QChar(u'0'))},
                       {u"status2"_s, u"0x%1"_s.arg(more, 4, 16, QChar(u'0'))},
                       {u"errors"_s, errors},
                       {u"voltage"_s, reader.u16() / 1000.0}};
}

Result<ActionReply> Actions::calibration()
{
    const auto reply = m_channel.transact(m_device.simple(Simple::ReadCalibration));
    if (!reply)
        return tl::unexpected(reply.error());
    ByteReader reader(reply->payload);
    ActionReply words;
    for (const char *imu : {"imu", "imu2"}) {
        for (const char *kind : {"acc.zero", "acc.scale", "gyro.zero"}) {
            for (const char *axis : {"x", "y", "z"})
                words.insert(u"%1.%2.%3"_s.arg(QLatin1String(imu), QLatin1String(kind), QLatin1String(axis)),
                             int(reader.i16()));
        }
    }
    return words;
}

Result<ActionReply> Actions::rawSensors()
{
    const auto reply = m_channel.transact(m_device.simple(Simple::RawSensors));
    if (!reply)
        return tl::unexpected(reply.error());
    const auto status = m_channel.transact(m_device.simple(Simple::Status));
    if (!status)
        return tl::unexpected(status.error());
    const unsigned present = ByteReader(QByteArrayView(status->payload).sliced(2)).u16();
    ByteReader reader(reply->payload);
    ActionReply words;
    for (const auto &[imu, bit] :
         {std::pair(u"imu"_s, kCameraImuThere), std::pair(u"imu2"_s, kFrameImuThere)}) {
        ActionReply own;
        for (const char *kind : {"acc", "gyro"}) {
            for (const char *axis : {"x", "y", "z"})
                own.insert(u"%1.%2.%3"_s.arg(imu, QLatin1String(kind), QLatin1String(axis)),
                           int(reader.i16()));
        }
        own.insert(imu + u".temperature"_s, reader.i16() / 340.0 + 36.53);  // errata 3.9
        // What stands there for a sensor that is not there was not measured.
        if (present & bit)
            words.insert(own);
        else
            words.insert(imu, u"missing"_s);
    }
    return words;
}

// With the heartbeat off, plain commands work again at once and are used from then on.
Result<ActionReply> Actions::setHeartbeat(int mode)
{
    const auto done = m_device.writeWord(m_channel, kHeartbeatWord, mode);
    if (!done)
        return tl::unexpected(done.error());
    return ActionReply{};
}

Result<ActionReply> Actions::perform(const QString &key, const QVariantMap &arguments)
{
    const auto number
        = [&arguments](const char *name) { return arguments.value(QString::fromLatin1(name)).toInt(); };
    const auto on
        = [&arguments](const char *name) { return arguments.value(QString::fromLatin1(name)).toBool(); };
    if (key == u"status"_s)
        return status();
    if (key == u"calibration.read"_s)
        return calibration();
    if (key == u"sensors.raw"_s)
        return rawSensors();
    if (key == u"motors.off"_s || (key == u"standby"_s && on("on")))
        return m_device.stopMotors(m_channel).map([] { return ActionReply{}; });
    if (key == u"motors.on"_s || key == u"standby"_s)
        return m_device.switchMotorsOn(m_channel).map([] { return ActionReply{}; });
    if (key == u"angle"_s)
        return angle(arguments);
    if (key == u"sticks"_s)
        return sticks(arguments);
    if (key == u"recenter"_s)
        return rc(Rc::SetPitchRollYaw, {});
    if (key == u"pan.mode"_s)
        return rc(Rc::SetPanMode, {{u"mode"_s, number("mode")}});
    if (key == u"pan.setting"_s)
        return rc(Rc::ActivePanModeSetting, {{u"setting"_s, number("setting")}});
    if (key == u"camera"_s)
        return rc(Rc::DoCamera, {{u"shot"_s, number("shot")}});
    if (key == u"script"_s)
        return runScript(number("script"), number("case"));
    if (key == u"pwm"_s)
        return rc(Rc::SetPwmOut, {{u"pulse"_s, number("pulse")}});
    if (key == u"restore"_s)
        return restoreWord(number("word"));
    if (key == u"heartbeat.off"_s)
        return setHeartbeat(0);
    if (key == u"name"_s) {
        const QString wanted = arguments.value(u"name"_s).toString();
        const QByteArray name = wanted.toLatin1();
        if (name.size() > 16)
            return failure(ErrorCode::InvalidArgument,
                           u"a name has up to 16 letters, not %1"_s.arg(name.size()));
        // It has one byte for each.
        for (qsizetype i = 0; i < name.size(); ++i) {
            if (!wanted[i].isPrint() || wanted[i] != QLatin1Char(name[i]))
                return failure(ErrorCode::InvalidArgument,
                               u"the board has no letter “%1” for its name"_s.arg(wanted[i]));
        }
        return setName(name);
    }
    if (key == u"rate"_s)
        return simple(Simple::SetBaudRate, ByteWriter().u8(number("rate")).u8(0).take());
    if (auto done = performSimple(key))
        return *std::move(done);
    return Procedures(m_device, m_channel).perform(key, arguments);
}

// The board is asked for its name again: its history follows what it says.
Result<ActionReply> Actions::setName(const QByteArray &name)
{
    const auto set = simple(Simple::SetName, name.leftJustified(16, ' '));
    if (!set && set.error().code != ErrorCode::Timeout)
        return set;
    // Perhaps only its answer was lost.
    const auto reply = m_channel.transact(m_device.simple(Simple::Version));
    if (!reply)
        return tl::unexpected(set ? reply.error() : set.error());
    if (reply->payload.size() != 54)
        return failure(ErrorCode::BadReply, u"v: %1 bytes"_s.arg(reply->payload.size()));
    BoardIdentity now;
    describeLook(now, reply->payload);
    const QString wanted = QString::fromLatin1(name).trimmed();
    if (const QString is = now.extra.value(u"name"_s).toString(); is != wanted)
        return failure(set ? ErrorCode::VerifyFailed : ErrorCode::Timeout,
                       u"the board calls itself %1, not %2"_s.arg(is, wanted));
    return ActionReply{{u"name"_s, wanted}, {u"look"_s, now.serial}};
}

// Commands without arguments; empty if the action is not one of them.
std::optional<Result<ActionReply>> Actions::performSimple(const QString &key)
{
    struct Plain
    {
        const char *key;
        Simple id;
    };
    // clang-format off
    static constexpr Plain kPlain[] = {
        {"level", Simple::Level}, {"trim", Simple::RcTrim}, {"directions.take", Simple::TakeDirections},
        {"start.take", Simple::TakeStartPositions}, {"start.take_yaw", Simple::TakeYawStartPosition}, {"store", Simple::Store},
        {"retrieve", Simple::Retrieve}, {"defaults", Simple::Defaults}, {"erase", Simple::EraseEeprom}, {"restart", Simple::Restart},
        {"reset", Simple::HardReset}, {"motors.normal", Simple::NormalMotors},
    };
    // clang-format on
    for (const Plain &plain : kPlain) {
        if (key != QLatin1String(plain.key))
            continue;
        if (plain.id == Simple::Defaults)
            return useDefaults();
        if (plain.id == Simple::Retrieve)
            return m_device.loadStored(m_channel).map([] { return ActionReply{}; });
        auto done = simple(plain.id);
        // Answered at once but carried out later (errata 3.9, 7): answers can only be trusted after that.
        const bool restarts = plain.id == Simple::Restart || plain.id == Simple::HardReset
            || plain.id == Simple::NormalMotors;
        if (done && (restarts || plain.id == Simple::RcTrim)) {
            if (const auto slept = m_channel.sleep(kSettling); !slept)
                return Result<ActionReply>(tl::unexpected(slept.error()));
        }
        if (done && restarts)
            return hasRestarted();
        if (done && plain.id == Simple::TakeDirections)
            return haveDirections();
        return done;
    }
    return {};
}

// It begins in state 0, and needs some seconds to its normal state (errata 3.7).
Result<ActionReply> Actions::hasRestarted()
{
    std::optional<int> state;
    for (const TimePoint until = m_channel.now() + kUntilStart; m_channel.now() < until;) {
        const auto now = m_device.readState(m_channel);
        if (now && *now < kMotorsTurn)
            return ActionReply{};
        if (!now && now.error().code != ErrorCode::Timeout)
            return tl::unexpected(now.error());
        state = now ? std::optional(*now) : std::nullopt;
        if (const auto slept = m_channel.sleep(kLookEvery); !slept)
            return tl::unexpected(slept.error());
    }
    if (!state)
        return failure(ErrorCode::Timeout, u"the board has not answered since it was told to restart"_s);
    return failure(
        ErrorCode::NoEffect,
        u"the board has not restarted; its state is “%1”"_s.arg(stateName(*state, m_device.m_firmware)));
}

// Its answer says nothing: what is in use afterwards does.
Result<ActionReply> Actions::useDefaults()
{
    const auto before = m_device.readStream(m_channel);
    if (auto done = simple(Simple::Defaults); !done)
        return done;
    const auto after = before ? m_device.readStream(m_channel) : before;
    if (!after)  // a board whose heartbeat it has switched off, for instance
        return ActionReply{{u"confirmed"_s, false}};
    const Configuration now = m_device.configurationOf(*after);
    QStringList others;
    for (const ParameterSpec &spec : now.parameters().all()) {
        if (const auto raw = now.raw(spec, 0); raw && !sameValue(*raw, spec.defaultRaw))
            others.append(spec.key);
    }
    if (*after == *before && !others.isEmpty())
        return failure(
            ErrorCode::NoEffect,
            u"nothing has changed, and these are no defaults: %1"_s.arg(others.mid(0, 8).join(u' ')));
    return ActionReply{};
}

Result<ActionReply> Actions::haveDirections()
{
    QStringList open;
    for (const char *key : {"motor.pitch.direction", "motor.roll.direction", "motor.yaw.direction"}) {
        const auto parameters = m_device.parameters();
        const ParameterSpec *spec = parameters ? parameters->find(QLatin1String(key)) : nullptr;
        if (!spec)
            continue;
        const auto raw = m_device.readWord(m_channel, spec->offset / 2);
        if (!raw)
            return tl::unexpected(raw.error());
        if (*raw == kAutoDirection)
            open.append(spec->key);
    }
    if (!open.isEmpty())
        return failure(ErrorCode::NoEffect, u"still on auto: %1"_s.arg(open.join(u' ')));
    return ActionReply{};
}

// Beyond the last word everything is acknowledged (errata 4).
Result<ActionReply> Actions::restoreWord(int word)
{
    if (m_device.m_words > 0 && word >= m_device.m_words)
        return failure(ErrorCode::OutOfRange,
                       u"word=%1, allowed 0 to %2"_s.arg(word).arg(m_device.m_words - 1));
    const auto before = m_device.readWord(m_channel, word);
    if (auto done = rc(Rc::RestoreParameter, {{u"index"_s, word}}); !done)
        return done;
    const auto raw = m_device.readWord(m_channel, word);
    if (!raw)
        return tl::unexpected(raw.error());
    // The same value as before shows nothing: it may be what is stored, or what was not put back.
    return ActionReply{{u"word"_s, word}, {u"value"_s, *raw}, {u"confirmed"_s, before && *raw != *before}};
}

std::span<const ActionSpec> Device::actions() const
{
    return Actions::all();
}

QString Device::storeAction() const
{
    return u"store"_s;
}

Result<ActionReply> Device::perform(Channel &channel, const QString &key, const QVariantMap &arguments)
{
    // Nothing may be stored, or started, while the motors are disabled for a stop.
    const bool harmless = key == u"status"_s || key == u"motors.off"_s || key == u"standby"_s;
    if (const auto free = checkNotStopping(); !free && !harmless)
        return tl::unexpected(free.error());
    return Actions(*this, channel).perform(key, arguments);
}

}  // namespace storm32
