// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/actions.h"

#include "protocol/base/angles.h"
#include "protocol/session/carryout.h"
#include "protocol/simplebgc/adjustables.h"
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"

#include <algorithm>
#include <cmath>
#include <optional>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr auto kSteerPeriod = 50ms;
constexpr auto kMotorsSwitch = 2s;
constexpr auto kFollowing = 2s;  // of a camera behind its target
constexpr double kArrived = 3.0;  // degrees between them
constexpr double kEarlyTurn = 20.0;  // degrees, where it is looked first
constexpr double kLeastTurn = 3.0;  // less is not looked for
constexpr double kSeenTurn = 0.5;
constexpr qsizetype kErrorBits = 14;  // of REALTIME_DATA_3
constexpr unsigned kMissingSensor = 1;
// Entries of the board's menu (errata 4.1).
constexpr int kMenuAutoPid = 16;
constexpr int kMenuAutoPidGain = 64;

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
    {"state", &Actions::readState},
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
    {"autotune.stop", &Actions::stopAutoTune},
    {"reset", &Actions::reset},
    {"calibrate.poles", &Actions::calibratePoles},
    {"calibrate.magnetic_link", &Actions::calibrateMagLink},
    {"calibrate.encoder_field", &Actions::calibrateEncoderFields},
    {"calibrate.encoder_offset", &Actions::calibrateEncoderOffsets},
    {"calibrate.fc_gain", &Actions::calibrateFcGain},
    {"calibrate.magnetometer", &Actions::calibrateMagnetometer},
    {"imu.select", &Actions::selectImu},
    {"pin", &Actions::setPin},
    {"servo", &Actions::setServo},
    {"signals", &Actions::readSignals},
    {"inputs", &Actions::readInputs},
    {"channel", &Actions::setChannel},
    {"statistics", &Actions::readStatistics},
    {"profile_set", &Actions::profileSet},
    {"external.read", &Actions::readExternal},
    {"external.write", &Actions::writeExternal},
    {"memory.save", &Actions::saveMemory},
    {"memory.compare", &Actions::compareMemory},
    {"memory.restore", &Actions::restoreMemory},
    {"calibration.save", &Actions::saveCalibrations},
    {"calibration.compare", &Actions::compareCalibrations},
    {"calibration.restore", &Actions::restoreCalibrations},
    {"file.save", &Actions::saveFile},
    {"file.load", &Actions::loadFile},
    {"file.erase", &Actions::eraseFile},
    {"file.erase_all", &Actions::eraseAllFiles},
    {"script", &Actions::runScript},
    {"script.list", &Actions::listScripts},
    {"script.save", &Actions::saveScript},
    {"script.load", &Actions::loadScript},
    {"script.erase", &Actions::eraseScript},
    {"script.stop", &Actions::stopScript},
    {"script.follow", &Actions::followScript},
    {"slots.read", &Actions::readSlots},
    {"attitude", &Actions::readAttitude},
    {"feed", &Actions::feed},
    {"i2c.scan", &Actions::i2cScan},
    {"i2c.read", &Actions::i2cReadRegisters},
    {"i2c.write", &Actions::i2cWriteRegisters},
    {"bootloader", &Actions::enterBootLoader},
    {"defaults", &Actions::useDefaults},
    {"steer.attitude", &Actions::steerAttitude},
    {"steer.state", &Actions::readAttitudeControl},
    {"steer.limits", &Actions::limitSteering},
    {"response", &Actions::measureFrequencies},
    {"calibration", &Actions::readCalibration},
    {"calibrate.acc_reference", &Actions::calibrateByReference},
    {"variables.list", &Actions::describeVariables},
    {"statistics.reset", &Actions::resetStatistics},
    {"servo.single", &Actions::setSingleServo},
    {"live", &Actions::readFurtherData},
    {"references", &Actions::readReferences},
    {"events", &Actions::followEvents},
    {"autotune.by_axis", &Actions::tuneByAxis},
    {"calibrate.cogging", &Actions::calibrateRipple},
};
// clang-format on

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

bool Actions::isBlind(const Frame &status)
{
    return ByteReader(QByteArrayView(status.payload).sliced(kErrorBits)).u16() & kMissingSensor;
}

Result<void> Actions::needSensor()
{
    const auto status = m_channel.transact(m_device.statusRequest());
    if (!status)
        return tl::unexpected(status.error());
    if (isBlind(*status))
        return failure(ErrorCode::ConditionUnmet, u"the board does not see its motion sensor"_s);
    return {};
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
    const auto status = m_channel.transact(m_device.statusRequest());
    if (!status)
        return tl::unexpected(status.error());
    const bool blind = isBlind(*status);
    ActionReply reply;
    if (blind)
        reply.insert(u"sensor"_s, u"missing"_s);
    for (std::size_t axis = 0; axis < angles->size(); ++axis) {
        if (!blind)  // zeros of a sensor that is not there are no angles
            reply.insert(u"imu."_s + axisName(axis), (*angles)[axis].imu);
        reply.insert(u"target."_s + axisName(axis), (*angles)[axis].target);
        reply.insert(u"speed."_s + axisName(axis), (*angles)[axis].targetSpeed);
    }
    // Motor angles come from a later command; boards without it still report the others, and would be waited
    // for while nobody sees the camera move.
    if (m_device.m_identity.firmwareNumber < kAnglesExtSince)
        return reply;
    Request request
        = replyRequest(CommandId::GetAnglesExt, {}, CommandId::GetAnglesExt, 54, Device::kVersion);
    request.retries = 1;
    if (const auto extended = m_channel.transact(request)) {
        if (const auto more = decodeAnglesExt(asBytes(extended->payload))) {
            for (std::size_t axis = 0; axis < more->size(); ++axis)
                reply.insert(u"motor."_s + axisName(axis), (*more)[axis].rotor);
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
    return m_device.switchMotorsOn(m_channel).map([] { return ActionReply{}; });
}

Result<void> Actions::stopMotors()
{
    return carryOut(m_channel, m_device.stopPlan());
}

Result<ActionReply> Actions::motorsOff(const QVariantMap &)
{
    return stopMotors().map([] { return ActionReply{}; });
}

Result<ActionReply> Actions::motorsAre(bool on)
{
    const auto are
        = holdsWithin(m_channel, m_device.statusRequest(), kMotorsSwitch, [on](const Frame &status) {
              return Device::areMotorsRunning(status).value_or(!on) == on;
          });
    if (!are)
        return tl::unexpected(are.error());
    if (*are)
        return ActionReply{};
    return failure(ErrorCode::NoEffect,
                   on ? u"the board reports that its motors are off"_s
                      : u"the board reports that its motors are running"_s);
}

// Where the status tells what an entry does, it is what counts.
Result<ActionReply> Actions::menu(const QVariantMap &arguments)
{
    const int command = arguments.value(u"command"_s).toInt();
    if (const int profile = Device::profileOf(command); profile >= 0)
        return m_device.selectProfile(m_channel, profile).map([] { return ActionReply{}; });
    std::optional<bool> motors;
    if (command == kMenuMotorsOn || command == kMenuMotorsOff)
        motors = command == kMenuMotorsOn;
    if (command == kMenuMotorsSwitch) {
        const auto status = m_channel.transact(m_device.statusRequest());
        if (!status)
            return tl::unexpected(status.error());
        if (const auto running = Device::areMotorsRunning(*status))
            motors = !*running;
    }
    if (std::any_of(std::begin(kMenuEffects), std::end(kMenuEffects), [command](const MenuEffect &effect) {
            return effect.action == command && effect.goesOn;
        })) {
        if (const auto sees = needSensor(); !sees)
            return tl::unexpected(sees.error());
        m_channel.expectSilence(kBusyCalibrating);
    }
    const auto done = confirm(CommandId::ExecuteMenu, ByteWriter().u8(command).take());
    const bool isSearch = command == kMenuAutoPid || command == kMenuAutoPidGain;
    if (!done && isSearch && done.error().code == ErrorCode::Timeout)
        return tl::unexpected(afterSearch(done.error()));
    if (!done || !motors)
        return done;
    const auto are = motorsAre(*motors);
    return are || *motors ? are : motorsOff({});  // a stop goes on until it is proven
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
    const SteeringMode *known = m_device.steeringMode(mode);
    if (!known)
        return failure(ErrorCode::Unsupported, u"steering in that mode"_s);
    Device::Control setpoint{};
    int named = 0;
    for (std::size_t axis = 0; axis < setpoint.size(); ++axis) {
        const QVariant wanted = arguments.value(axisName(axis));
        if (!wanted.isValid() || std::isnan(wanted.toDouble()))
            continue;
        ++named;
        // In speed mode the axis value is the speed itself.
        const double value = wanted.toDouble();
        const SteeringInput &input = known->inputs[axis];
        if (value < input.min || value > input.max)
            return failure(ErrorCode::InvalidArgument,
                           u"%1=%2: in the mode '%3' it goes from %4 to %5%6"_s.arg(
                               axisName(axis), QString::number(value), QLatin1String(known->key),
                               QString::number(input.min), QString::number(input.max),
                               QString::fromUtf8(input.unit)));
        setpoint[axis]
            = mode == Speed ? Device::AxisControl{mode, value, 0.0} : Device::AxisControl{mode, speed, value};
    }
    if (named == 0)
        return failure(ErrorCode::InvalidArgument, u"steer needs roll=, pitch= or yaw="_s);
    if (named < kAxisCount && m_device.steersTogether())
        return failure(
            ErrorCode::InvalidArgument,
            u"firmware before 2.55b5 steers all axes at once and cannot leave one alone: name roll, "
            "pitch and yaw"_s);
    const auto status = m_channel.transact(m_device.statusRequest());
    if (!status)
        return tl::unexpected(status.error());
    if (!Device::areMotorsRunning(*status).value_or(true))
        return failure(ErrorCode::ConditionUnmet, u"the motors are off, so nothing would move"_s);

    ControlFrames frames = m_device.controlFrames(setpoint, arguments.value(u"fine"_s).toBool());
    if (!arguments.value(u"release"_s).toBool())
        frames.release.clear();
    const auto seconds = arguments.value(u"seconds"_s).toDouble();
    const TimePoint end = m_channel.now() + durationFromSeconds(seconds);
    Progress progress;
    progress.step = u"steer"_s;
    progress.total = 100;
    // Whether it turns at all; looked for early as well, because a whole turn ends where it began.
    const auto before = mode == Speed ? readAngles({}) : Result<ActionReply>(ActionReply());
    if (!before)
        return before;
    const TimePoint begin = m_channel.now();
    bool isLookedAt = false;
    bool hasMoved = false;
    Result<void> slept;
    while (m_channel.now() < end && slept) {
        m_channel.steer(frames);
        if (mode == Speed && !isLookedAt && turned(setpoint, m_channel.now() - begin) > kEarlyTurn) {
            isLookedAt = true;
            hasMoved = hasTurned(setpoint, *before);
        }
        progress.done
            = int(100.0 * (1.0 - std::chrono::duration<double>(end - m_channel.now()).count() / seconds));
        m_channel.progress(progress);
        slept = m_channel.sleep(kSteerPeriod);
    }
    const bool isPlace = mode == Angle || mode == SpeedAngle;
    const auto there = isPlace && slept ? arrived(setpoint, frames) : Result<ActionReply>();
    const bool isSeen = mode != Speed || !slept || hasMoved
        || turned(setpoint, m_channel.now() - begin) < kLeastTurn || hasTurned(setpoint, *before);
    if (mode != Speed && slept) {  // it goes on to the angle, and stays there
        frames.stop = frames.setpoint;
        frames.question.reset();
        m_channel.steer(frames);
    }
    m_channel.releaseControl();
    if (!slept)
        return tl::unexpected(slept.error());
    if (!isSeen)
        return failure(ErrorCode::NotSeen,
                       u"as the board tells it, neither the camera nor its target has turned"_s);
    return isPlace ? there : readAngles({});
}

// How far an axis has to turn by then, in degrees.
double Actions::turned(const Device::Control &setpoint, Duration since)
{
    double most = 0;
    for (const Device::AxisControl &axis : setpoint)
        most = std::max(most, axis.mode == Speed ? std::abs(axis.speed) * seconds(since) : 0.0);
    return most;
}

// What cannot be read shows nothing, and refutes nothing.
bool Actions::hasTurned(const Device::Control &setpoint, const ActionReply &before)
{
    const auto now = readAngles({});
    if (!now)
        return true;
    for (std::size_t axis = 0; axis < setpoint.size(); ++axis) {
        for (const QString &key : {u"imu."_s + axisName(axis), u"target."_s + axisName(axis)}) {
            if (setpoint[axis].mode == Speed && setpoint[axis].speed != 0
                && turnBetween(before.value(key).toDouble(), now->value(key).toDouble()) > kSeenTurn)
                return true;
        }
    }
    return false;
}

// The board turns its target towards the angle, and the camera follows the target.
Result<ActionReply> Actions::arrived(const Device::Control &setpoint, const ControlFrames &frames)
{
    const TimePoint until = m_channel.now() + kFollowing;
    for (;;) {
        m_channel.steer(frames);
        auto reply = readAngles({});
        if (!reply)
            return reply;
        QStringList away;
        QStringList early;
        for (std::size_t axis = 0; axis < setpoint.size(); ++axis) {
            const QVariant camera = reply->value(u"imu."_s + axisName(axis));
            if (setpoint[axis].mode == NoControl || !camera.isValid())
                continue;
            const double wanted = setpoint[axis].angle;
            const double target = reply->value(u"target."_s + axisName(axis)).toDouble();
            const auto told = [&](double goal) {
                return u"%1: target %2°, camera at %3°"_s.arg(axisName(axis))
                    .arg(goal, 0, 'f', 1)
                    .arg(camera.toDouble(), 0, 'f', 1);
            };
            if (turnBetween(target, camera.toDouble()) > kArrived)
                away.append(told(target));
            else if (turnBetween(target, wanted) > kArrived)
                early.append(told(wanted));
        }
        if (away.isEmpty() && !early.isEmpty() && !frames.release.isEmpty())
            return failure(
                ErrorCode::NotSeen,
                u"control was given back before the camera was there, %1"_s.arg(early.join(u"; "_s)));
        if (away.isEmpty()) {
            if (!early.isEmpty() || reply->contains(u"sensor"_s))
                reply->insert(u"confirmed"_s, false);  // it goes on, or nobody sees it
            return reply;
        }
        if (m_channel.now() >= until)
            return failure(ErrorCode::NotSeen,
                           u"the camera did not get where it was steered to, %1"_s.arg(away.join(u"; "_s)));
        if (const auto slept = m_channel.sleep(kSteerPeriod); !slept)
            return tl::unexpected(slept.error());
    }
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
    if (arguments.value(u"real"_s).toBool())
        return readRealVariables(*ids);
    const auto values = m_device.readAdjustables(m_channel, *ids);
    if (!values)
        return tl::unexpected(values.error());
    ActionReply reply;
    for (const AdjustableValue &value : *values)
        reply.insert(QString::number(value.id), value.value);
    for (const int id : *ids) {
        if (!reply.contains(QString::number(id)))
            return failure(ErrorCode::BadReply, u"variable %1 was not told"_s.arg(id));
    }
    return reply;
}

Result<ActionReply> Actions::writeVariable(const QVariantMap &arguments)
{
    const AdjustableValue wanted{arguments.value(u"id"_s).toInt(), arguments.value(u"value"_s).toDouble()};
    const auto done = m_device.writeAdjustables(m_channel, {wanted});
    if (!done)
        return tl::unexpected(done.error());
    return ActionReply{};
}

Result<ActionReply> Actions::saveVariables(const QVariantMap &)
{
    Request request = confirmRequest(CommandId::SaveParams3, {}, Device::kVersion);
    request.timeout = 1500ms;
    // Stored twice is stored.
    request.idempotent = true;
    request.retries = 2;
    const auto reply = m_channel.transact(request);
    if (reply)
        return ActionReply{};
    Error error = reply.error();
    // The board answers out of volatile memory, so asking what is stored would prove nothing.
    if (error.code == ErrorCode::Timeout)
        error.detail
            += u": whether the values in use are stored now shows only when the board has restarted"_s;
    return tl::unexpected(error);
}

Result<ActionReply> Actions::reset(const QVariantMap &arguments)
{
    const int delay = arguments.value(u"delay"_s).toInt();
    Request request = replyRequest(CommandId::Reset, ByteWriter().u8(1).u16(delay).take(), CommandId::Reset,
                                   0, Device::kVersion);
    request.idempotent = false;
    const auto notice = m_channel.transact(request);
    if (!notice)
        return tl::unexpected(notice.error());
    return ActionReply{{u"restarts_in"_s, delay}};  // it is yet to come, so nobody takes it for done
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

Result<ActionReply> Device::perform(Channel &channel, const QString &key, const QVariantMap &arguments)
{
    const auto it = std::find_if(m_actions.begin(), m_actions.end(), [&key](const ActionSpec &action) {
        return key == QLatin1String(action.key);
    });
    if (it == m_actions.end())
        return failure(ErrorCode::Unsupported, key);
    if (!m_identity.writable && it->risk != ActionRisk::Safe)
        return failure(ErrorCode::ReadOnly, m_identity.firmware);
    return Actions(*this, channel).perform(key, arguments);
}

}  // namespace simplebgc
