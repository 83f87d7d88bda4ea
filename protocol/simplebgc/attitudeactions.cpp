// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Steering to an attitude as a whole, and the limits of steering (errata 3.13 and 3.23).
#include "protocol/session/channel.h"
#include "protocol/simplebgc/actions.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/rotation.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr auto kTurnPeriod = 50ms;
constexpr auto kTurnFollows = 2s;  // of a camera behind its target
constexpr double kThere = 3.0;  // degrees in all
// Modes and flags of CONTROL_QUAT, and what CONTROL_QUAT_STATUS is asked for.
constexpr int kOff = 0;
constexpr int kSpeed = 1;
constexpr int kAttitude = 2;
constexpr int kConfirmed = 1;
constexpr quint32 kAskedState = 0x7F;  // mode, three attitudes, three speeds

QByteArray attitudeFrame(int mode, int flags, const Orientation *attitude)
{
    ByteWriter writer;
    writer.u8(mode).u8(flags);
    for (std::size_t i = 0; attitude && i < attitude->size(); ++i)
        writer.f32(float((*attitude)[i]));
    if (mode == kSpeed)
        writer.zeros(12);
    return writer.take();
}

Orientation readAttitudeOf(ByteReader &reader)
{
    Orientation attitude{};
    for (double &part : attitude)
        part = double(reader.f32());
    return attitude;
}

}  // namespace

Result<Actions::AttitudeState> Actions::attitudeState()
{
    const auto frame
        = m_channel.transact(replyRequest(CommandId::ControlQuatStatus, ByteWriter().u32(kAskedState).take(),
                                          CommandId::ControlQuatStatus, 73, Device::kVersion));
    if (!frame)
        return tl::unexpected(frame.error());
    ByteReader reader(frame->payload);
    AttitudeState state;
    const quint32 set = reader.u32();
    state.mode = reader.u8();
    reader.skip(2);
    for (Orientation &attitude : state.attitudes)
        attitude = readAttitudeOf(reader);
    for (auto &speed : state.speeds) {
        for (double &part : speed)
            part = reader.i16() * kGyroUnit;
    }
    return reader.ok() && set == kAskedState ? Result<AttitudeState>(state)
                                             : failure(ErrorCode::BadReply, u"CONTROL_QUAT_STATUS"_s);
}

ActionReply Actions::told(const AttitudeState &state)
{
    constexpr std::array kNames{"target", "setpoint", "imu"};
    constexpr std::array kModes{std::pair(kOff, "off"), std::pair(kSpeed, "speed"),
                                std::pair(kAttitude, "attitude"), std::pair(5, "speed-and-attitude"),
                                std::pair(9, "limited-speed")};
    ActionReply reply{{u"mode"_s, QString::number(state.mode)}};
    for (const auto &[mode, name] : kModes) {
        if (mode == state.mode)
            reply[u"mode"_s] = QLatin1String(name);
    }
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        const auto angles = anglesOf(state.attitudes[i]);
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            const QString name = QLatin1String(kNames[i]) + u'.' + axisName(axis);
            reply.insert(name, angles[axis]);
            reply.insert(u"speed."_s + name, state.speeds[i][axis]);
        }
    }
    return reply;
}

Result<ActionReply> Actions::readAttitudeControl(const QVariantMap &)
{
    const auto state = attitudeState();
    if (!state)
        return tl::unexpected(state.error());
    return told(*state);
}

// It turns about one axis in space, the short way, and not each angle by itself.
Result<ActionReply> Actions::steerAttitude(const QVariantMap &arguments)
{
    std::array<double, kAxisCount> angles{};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis)
        angles[axis] = arguments.value(axisName(axis)).toDouble();
    const Orientation wanted = attitudeAt(angles);
    const auto on = m_device.areMotorsOn(m_channel);
    if (!on)
        return tl::unexpected(on.error());
    if (!*on)
        return failure(ErrorCode::ConditionUnmet, u"the motors are off, so nothing would move"_s);
    ByteWriter limits;
    limits.u16(3);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis)
        limits.u16(toCount16(arguments.value(u"speed"_s).toDouble(), kControlSpeedUnit));
    for (std::size_t axis = 0; axis < kAxisCount; ++axis)
        limits.u16(arguments.value(u"acceleration"_s).toInt());
    if (const auto limited = confirm(CommandId::ControlQuatConfig, limits.take()); !limited)
        return limited;

    const auto framed = [](const QByteArray &payload) {
        return encodeFrame(number(CommandId::ControlQuat), payload, Device::kVersion);
    };
    // How it is seen to stand still is as it is after any other way to steer.
    ControlFrames frames
        = m_device.controlFrames(Device::Control{{{Speed, 0, 0}, {Speed, 0, 0}, {Speed, 0, 0}}});
    frames.setpoint = framed(attitudeFrame(kAttitude, 0, &wanted));
    frames.stop = framed(attitudeFrame(kSpeed, 0, nullptr));
    frames.release = framed(attitudeFrame(kOff, 0, nullptr));
    frames.angles = angles;
    if (!arguments.value(u"release"_s).toBool())
        frames.release.clear();
    // A board that has no such control says so.
    if (const auto begun = confirm(CommandId::ControlQuat, attitudeFrame(kAttitude, kConfirmed, &wanted));
        !begun)
        return begun;
    const double seconds = arguments.value(u"seconds"_s).toDouble();
    const TimePoint end = m_channel.now() + durationFromSeconds(seconds);
    Progress progress;
    progress.step = u"steer"_s;
    progress.total = 100;
    Result<AttitudeState> state;
    for (;;) {
        m_channel.steer(frames);
        const auto slept = m_channel.sleep(kTurnPeriod);
        if (!slept) {
            m_channel.releaseControl();
            return tl::unexpected(slept.error());
        }
        const Duration left = end - m_channel.now();
        progress.done = std::clamp(int(100 * (1 - ::seconds(left) / seconds)), 0, 100);
        m_channel.progress(progress);
        if (left > Duration::zero())
            continue;
        state = attitudeState();
        const auto away = state ? turnTo(state->attitudes[kActual], wanted) : std::array<double, 3>{};
        const bool isThere = std::hypot(away[0], away[1], away[2]) < kThere;
        if (!state || isThere || left < -kTurnFollows)
            break;
    }
    if (state) {  // it stays where it is
        frames.stop = frames.setpoint;
        frames.question.reset();
        m_channel.steer(frames);
    }
    m_channel.releaseControl();
    if (!state)
        return tl::unexpected(state.error());
    const auto away = turnTo(state->attitudes[kActual], wanted);
    if (const double angle = std::hypot(away[0], away[1], away[2]); angle >= kThere)
        return failure(
            ErrorCode::NotSeen,
            u"the camera is %1° away from the attitude that it was steered to"_s.arg(angle, 0, 'f', 1));
    return told(*state);
}

// The board confirms it, and tells none of it.
Result<ActionReply> Actions::limitSteering(const QVariantMap &arguments)
{
    constexpr int kPriorities = 5;
    ByteWriter writer;
    writer.u16(int(std::lround(arguments.value(u"timeout"_s).toDouble() * 1000))).zeros(kPriorities);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis)
        writer.zeros(3).u16(arguments.value(axisName(axis)).toInt()).zeros(2);
    return confirm(CommandId::ControlConfig, writer.zeros(13).take());
}

}  // namespace simplebgc
