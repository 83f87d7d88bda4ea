// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Other ways to steer the simulated board: in finer figures, to an attitude as a whole, and within limits
// (errata 3.13, 3.14 and 3.23).
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kControlExtSince = 2680;
constexpr int kAttitudeSince = 2730;
constexpr double kFinestAngle = 360.0 / (1 << 20);
constexpr int kControlConfigSize = 41;
constexpr double kUsualTurnSpeed = 60;  // degrees per second, where nobody limits it: an assumption
constexpr double kAttitudeReached = 1;  // degrees
// Modes and flags of CONTROL_QUAT.
constexpr int kAttitudeOff = 0;
constexpr int kBySpeed = 1;
constexpr int kToAttitude = 2;
constexpr int kSpeedAndAttitude = 5;
constexpr int kByLimitedSpeed = 9;
constexpr int kConfirmFlag = 1;
constexpr int kPackedFlag = 2;
constexpr int kTaskFlag = 64;

bool hasLength(const Orientation &q)
{
    constexpr double kNoRotation = 0.01;
    return std::abs(std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3])) - 1) < kNoRotation;
}

/// The most that a vector of this direction may have, where each of its parts has a limit of its own.
double mostAlong(const std::array<double, kAxisCount> &direction,
                 const std::array<double, kAxisCount> &limits, double usual)
{
    const double size = std::hypot(direction[0], direction[1], direction[2]);
    std::optional<double> most;
    for (std::size_t i = 0; i < kAxisCount && size > 0; ++i) {
        const double share = std::abs(direction[i]) / size;
        if (limits[i] > 0 && share > 0)
            most = std::min(most.value_or(limits[i] / share), limits[i] / share);
    }
    return most.value_or(usual);
}

}  // namespace

bool SimulatedBoard::handleSteering(const Frame &frame)
{
    const int firmware = m_options.firmware;
    switch (static_cast<CommandId>(frame.id)) {
    case CommandId::ControlExt:
        if (firmware < kControlExtSince)
            return false;
        controlFinely(frame);
        return true;
    case CommandId::ControlConfig:
        if (firmware < kLater)
            return false;
        limitSteering(frame);
        return true;
    case CommandId::ControlQuat:
        if (firmware < kAttitudeSince)
            return false;
        controlAttitude(frame);
        return true;
    case CommandId::ControlQuatConfig:
        if (firmware < kAttitudeSince)
            return false;
        limitAttitude(frame);
        return true;
    case CommandId::ControlQuatStatus:
        if (firmware < kAttitudeSince)
            return false;
        if (hasSize(frame, 4))
            reply(frame, CommandId::ControlQuatStatus, attitudeState(ByteReader(frame.payload).u32()));
        return true;
    default: return false;
    }
}

// Which figures come, and how wide, stands in front of them; what is not named goes on as before.
void SimulatedBoard::controlFinely(const Frame &frame)
{
    struct ToldAxis
    {
        ControlAxis control;
        double speed = 0;
        double angle = 0;
        bool isThere = false;
    };
    ByteReader reader(frame.payload);
    const unsigned set = reader.u16();
    std::array<ToldAxis, kAxisCount> told{};
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        const unsigned bits = set >> (5 * i);
        ToldAxis &axis = told[i];
        axis.isThere = bits & 3U;
        if (!axis.isThere)
            continue;
        axis.control.mode = reader.u8();
        reader.skip(1);  // that the error is not corrected makes no difference to this camera
        const int mode = axis.control.mode & 0x0F;
        if (bits & 1U) {
            const bool isFine = axis.control.mode & ControlHighResSpeed;
            axis.speed = bits & 8U ? reader.i32() * kFineSpeedUnit
                                   : reader.i16() * (isFine ? kFineSpeedUnit : kControlSpeedUnit);
        }
        if (bits & 2U) {
            const double raw = bits & 4U ? reader.i32() : reader.i16();
            const double reach = axisValue("rc.%a.max_angle", kAxes[i]);
            axis.angle = mode == Rc ? raw / 500 * reach
                : mode == RcHighRes ? raw / 16384 * reach
                                    : raw * (bits & 4U ? kFinestAngle : kDegreesPerCount);
        }
        axis.control.speed = toCount16(axis.speed, kControlSpeedUnit);
        axis.control.angle = angleToCount(axis.angle);
    }
    if (!reader.ok() || reader.remaining() > 0) {
        refuse(frame, kWrongSize);
        return;
    }
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        if (told[i].isThere)
            steerAxis(i, told[i].control, told[i].speed, told[i].angle);
    }
    if (!m_steeringLimits.isSilent)
        confirm(frame);
}

void SimulatedBoard::steerAxis(std::size_t axis, const ControlAxis &wanted, double speed, double destination)
{
    const int mode = wanted.mode & 0x0F;
    if (mode == Ignore)
        return;
    m_attitude.mode = kAttitudeOff;
    m_steeredAt = m_now;
    m_control[axis] = wanted;
    m_moveSpeed[axis]
        = mode == Speed || speed != 0 ? speed : std::max(5.0, axisValue("rc.%a.speed", kAxes[axis]));
    m_destination[axis] = destination;
    m_taskRunning |= (wanted.mode & ControlAutoTask) && (mode == Angle || mode == AngleRelFrame);
}

// The filters, the slope of the acceleration and the priorities of other ports are taken and have no effect.
void SimulatedBoard::limitSteering(const Frame &frame)
{
    if (!hasSize(frame, kControlConfigSize))
        return;
    ByteReader reader(frame.payload);
    m_steeringLimits.timeout = reader.u16() * 0.001;
    m_steeredAt = m_now;
    reader.skip(5);
    for (double &acceleration : m_steeringLimits.acceleration) {
        reader.skip(3);
        acceleration = reader.u16();
        reader.skip(2);
    }
    reader.skip(1);
    m_steeringLimits.isSilent = reader.u16() & 1U;
    confirm(frame);
}

void SimulatedBoard::stopSteering()
{
    m_control = {};
    m_attitude.mode = kAttitudeOff;
}

// Nobody steers any more: what the timeout of CONTROL_CONFIG is for.
void SimulatedBoard::updateSteering()
{
    const bool isLate = m_steeringLimits.timeout > 0 && m_now - m_steeredAt > m_steeringLimits.timeout;
    if (isLate)
        stopSteering();
    if (!m_stabilizer.motorsOn())
        m_attitude.mode = kAttitudeOff;
    turnAttitude();
}

double SimulatedBoard::nextTarget(std::size_t axis, std::optional<double> goal)
{
    const double before = m_stabilizer.target(kAxes[axis]);
    const double limit = m_steeringLimits.acceleration[axis];
    const double speed = m_moveSpeed[axis];
    if (limit <= 0) {
        const double step = std::abs(speed) * Stabilizer::kCycle;
        return before + (goal ? std::clamp(*goal - before, -step, step) : speed * Stabilizer::kCycle);
    }
    // It may only turn as fast as it can still stop.
    const double way = goal ? *goal - before : 0.0;
    const double wanted
        = goal ? std::copysign(std::min(std::abs(speed), std::sqrt(2 * limit * std::abs(way))), way) : speed;
    const double change = limit * Stabilizer::kCycle;
    double &turning = m_turnSpeed[axis];
    turning += std::clamp(wanted - turning, -change, change);
    const double step = turning * Stabilizer::kCycle;
    return goal && std::abs(way) <= std::abs(step) ? *goal : before + step;
}

void SimulatedBoard::controlAttitude(const Frame &frame)
{
    ByteReader reader(frame.payload);
    AttitudeControl wanted = m_attitude;
    wanted.mode = reader.u8();
    wanted.flags = reader.u8();
    wanted.version = frame.version;
    const bool hasAttitude = wanted.mode == kToAttitude || wanted.mode == kSpeedAndAttitude;
    const bool hasSpeed
        = wanted.mode == kBySpeed || wanted.mode == kSpeedAndAttitude || wanted.mode == kByLimitedSpeed;
    if (hasAttitude && wanted.flags & kPackedFlag) {
        wanted.target = unpackQuaternion(reader.read<quint64>());
    } else if (hasAttitude) {
        for (double &part : wanted.target)
            part = double(reader.f32());
    }
    wanted.speed = {};
    for (double &speed : wanted.speed)
        speed = hasSpeed ? degrees(double(reader.f32())) : 0.0;
    if (!reader.ok() || reader.remaining() > 0) {
        refuse(frame, kWrongSize);
        return;
    }
    if ((wanted.mode != kAttitudeOff && !hasAttitude && !hasSpeed) || !hasLength(wanted.target)) {
        refuse(frame, kWrongParameters);
        return;
    }
    if (wanted.mode != kAttitudeOff && m_attitude.mode == kAttitudeOff) {
        // It begins where the targets are.
        wanted.setpoint = attitudeAt({m_stabilizer.target(Axis::Roll), m_stabilizer.target(Axis::Pitch),
                                      m_stabilizer.target(Axis::Yaw)});
        wanted.turning = {};
    }
    wanted.isTask = hasAttitude && wanted.flags & kTaskFlag;
    m_attitude = wanted;
    m_control = {};
    m_steeredAt = m_now;
    if (wanted.flags & kConfirmFlag)
        confirm(frame);
}

// The slope of the acceleration and the filters are taken and have no effect.
void SimulatedBoard::limitAttitude(const Frame &frame)
{
    ByteReader reader(frame.payload);
    const unsigned set = reader.u16();
    AttitudeControl wanted = m_attitude;
    for (std::size_t i = 0; i < kAxisCount && set & 1U; ++i)
        wanted.maxSpeed[i] = reader.u16() * kControlSpeedUnit;
    for (std::size_t i = 0; i < kAxisCount && set & 2U; ++i)
        wanted.maxAcceleration[i] = reader.u16();
    reader.skip((set & 4U ? 6 : 0) + (set & 8U ? 2 : 0) + (set & 16U ? 1 : 0) + (set & 32U ? 1 : 0));
    if (!reader.ok() || reader.remaining() > 0) {
        refuse(frame, kWrongSize);
        return;
    }
    m_attitude = wanted;
    confirm(frame);
}

// The set-point turns about one axis in space, the short way, and the angles of all three follow from it.
void SimulatedBoard::turnAttitude()
{
    AttitudeControl &a = m_attitude;
    if (a.mode == kAttitudeOff)
        return;
    const auto bySpeed = [](const std::array<double, kAxisCount> &speed) {
        return turnBy(
            {speed[0] * Stabilizer::kCycle, speed[1] * Stabilizer::kCycle, speed[2] * Stabilizer::kCycle});
    };
    std::array<double, kAxisCount> wanted = a.speed;
    const bool isAimed = a.mode == kToAttitude || a.mode == kSpeedAndAttitude;
    if (isAimed) {
        if (a.mode == kSpeedAndAttitude)
            a.target = combined(a.target, bySpeed(a.speed));
        wanted = turnTo(a.setpoint, a.target);
        const double way = std::hypot(wanted[0], wanted[1], wanted[2]);
        const double brake = mostAlong(wanted, a.maxAcceleration, 0);
        double speed = mostAlong(wanted, a.maxSpeed, kUsualTurnSpeed);
        if (brake > 0)
            speed = std::min(speed, std::sqrt(2 * brake * way));
        speed = std::min(speed, way / Stabilizer::kCycle);
        for (double &part : wanted)
            part = way > 0 ? part / way * speed : 0.0;
    }
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        if (a.maxSpeed[i] > 0)
            wanted[i] = std::clamp(wanted[i], -a.maxSpeed[i], a.maxSpeed[i]);
        const double change = a.maxAcceleration[i] * Stabilizer::kCycle;
        a.turning[i]
            = change > 0 ? a.turning[i] + std::clamp(wanted[i] - a.turning[i], -change, change) : wanted[i];
    }
    a.setpoint = combined(a.setpoint, bySpeed(a.turning));
    if (a.isTask) {
        const auto left
            = turnTo(attitudeAt({m_stabilizer.estimate(Axis::Roll), m_stabilizer.estimate(Axis::Pitch),
                                 m_stabilizer.estimate(Axis::Yaw)}),
                     a.target);
        if (std::hypot(left[0], left[1], left[2]) < kAttitudeReached) {
            a.isTask = false;
            send(CommandId::Confirm, ByteWriter().u8(number(CommandId::ControlQuat)).u8(1).take(), a.version);
        }
    }
}

QByteArray SimulatedBoard::attitudeState(quint32 set) const
{
    constexpr quint32 kKnown = 0x3FF;
    set &= kKnown;
    const auto has = [set](int bit) { return (set >> bit & 1U) != 0; };
    const Orientation actual
        = attitudeAt({m_stabilizer.estimate(Axis::Roll), m_stabilizer.estimate(Axis::Pitch),
                      m_stabilizer.estimate(Axis::Yaw)});
    const std::array attitudes{m_attitude.target, m_attitude.setpoint, actual};
    const std::array speeds{m_attitude.speed, m_attitude.turning,
                            std::array{m_stabilizer.gyro(Axis::Roll), m_stabilizer.gyro(Axis::Pitch),
                                       m_stabilizer.gyro(Axis::Yaw)}};
    ByteWriter writer;
    writer.u32(set);
    if (has(0))
        writer.u8(m_attitude.mode).u16(m_attitude.flags);
    for (int i = 0; i < 3; ++i) {
        for (std::size_t part = 0; has(1 + i) && part < 4; ++part)
            writer.f32(float(attitudes[std::size_t(i)][part]));
    }
    for (int i = 0; i < 3; ++i) {
        for (std::size_t part = 0; has(4 + i) && part < kAxisCount; ++part)
            writer.i16(toCount16(speeds[std::size_t(i)][part], kGyroUnit));
    }
    for (int i = 0; i < 3; ++i) {
        if (has(7 + i))
            writer.write(packQuaternion(attitudes[std::size_t(i)]));
    }
    return writer.take();
}

}  // namespace simplebgc
