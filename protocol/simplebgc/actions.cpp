// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/actions.h"

#include "protocol/session/carryout.h"
#include "protocol/simplebgc/adjustables.h"
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr auto kSteerPeriod = 50ms;

// The board checks nothing. Of variables that no table has, only the board knows what they may be.
Result<void> checkVariable(const BoardIdentity &identity, const AdjustableValue &wanted)
{
    for (const AdjustableSpec &spec : adjustablesOf(identity.firmwareNumber)) {
        if (spec.id == wanted.id && !(wanted.value >= spec.min && wanted.value <= spec.max))
            return failure(ErrorCode::OutOfRange,
                           u"%1 = %2, allowed %3 to %4"_s.arg(QLatin1String(spec.key))
                               .arg(wanted.value)
                               .arg(spec.min)
                               .arg(spec.max));
    }
    const ParameterSet parameters(parameterRows(), kBlocks, identity.firmwareNumber, identity.capabilities);
    for (const ParameterSpec &spec : parameters.all()) {
        const double raw = wanted.value / spec.row->adjustableScale;
        if (spec.adjustable == wanted.id && spec.row->kind == ValueKind::Choice && !spec.accepts(raw))
            return failure(ErrorCode::OutOfRange,
                           u"%1 = %2, allowed %3"_s.arg(spec.key, spec.format(raw), spec.allowedText()));
    }
    return {};
}

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
        reply.insert(u"imu."_s + axisName(axis), (*angles)[axis].imu);
        reply.insert(u"target."_s + axisName(axis), (*angles)[axis].target);
        reply.insert(u"speed."_s + axisName(axis), (*angles)[axis].targetSpeed);
    }
    // Motor angles come from a later command (document revision 0.6); boards without it still report the
    // others.
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

Result<ActionReply> Actions::motorsOff(const QVariantMap &)
{
    return carryOut(m_channel, m_device.stopPlan()).map([] { return ActionReply{}; });
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
        const QVariant wanted = arguments.value(axisName(axis));
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
    const AdjustableValue wanted{arguments.value(u"id"_s).toInt(), arguments.value(u"value"_s).toDouble()};
    if (const auto checked = checkVariable(m_device.identity(), wanted); !checked)
        return tl::unexpected(checked.error());
    const auto done = m_device.writeAdjustables(m_channel, {wanted});
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
