// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Data that the simulated board reports: real-time data, angles, debug variables.
#include "protocol/base/angles.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kActualAngleSince = 2720;  // of REALTIME_DATA_4 (errata 3.8)
constexpr int kStateFlagsSince = 2730;

// No document says which firmware introduced which field; here they come in two steps, so that clients also
// meet boards that have only some.
quint32 laterCustomFlags(int firmware)
{
    constexpr quint32 kFirst = 0x001FFE00;  // bits 9-20
    constexpr quint32 kSecond = 0x3FE00000;  // bits 21-29
    return firmware < 2680 ? 0 : firmware < 2730 ? kFirst : kFirst | kSecond;
}

}  // namespace

int SimulatedBoard::celsius(int normal) const
{
    return m_options.faults.heat > 0 ? int(std::lround(m_options.faults.heat)) : normal;
}

double SimulatedBoard::volts() const
{
    return (m_options.faults.battery > 0 ? m_options.faults.battery : 12.3) + m_voltageOffset
        - 0.04 * m_stabilizer.current();
}

/// In hundredths of a percent.
int SimulatedBoard::motorOutput(Axis axis) const
{
    return int(std::lround(std::clamp(m_stabilizer.torque(axis), -1.0, 1.0) * 10000.0));
}

QByteArray SimulatedBoard::realtime(bool extended) const
{
    const Stabilizer &s = m_stabilizer;
    int errors = 0;
    if (!s.imuPresent())
        errors |= 1 << 0;
    const double volts = this->volts();
    const double alarm = value(u"battery.alarm"_s);
    const double motorsOff = value(u"battery.motors_off"_s);
    if (alarm > 0 && volts < alarm)
        errors |= 1 << 6;
    if (motorsOff > 0 && volts < motorsOff)
        errors |= 1 << 7;
    bool anyPower = false;
    for (const Axis axis : kAxes) {
        anyPower |= axisValue("motor.%a.power", axis) > 0;
        if (s.motorsOn() && std::abs(s.target(axis) - s.estimate(axis)) > 30.0)
            errors |= 1 << 9;
    }
    if (!anyPower)
        errors |= 1 << 2;
    if (m_emergency)
        errors |= 1 << 11;

    ByteWriter writer;
    const bool isFrame = m_imu == kFrameImu;
    for (std::size_t i = 0; i < kAxisCount; ++i)
        writer.i16(toCount16(isFrame ? m_frameRawAcc[i] - m_frameImu.accCorrection[i] : ownAcc(i), kAccUnit))
            .i16(toCount16(isFrame ? m_frameRawGyro[i] - m_frameImu.gyroCorrection[i] : s.gyro(kAxes[i]),
                           kGyroUnit));
    writer.u16(int(std::min<quint64>(m_serialErrors, 65535)))
        .u16(errors)
        .u8(m_emergency ? m_emergencyCause : 0)
        .zeros(3);
    for (const char *input : {"roll", "pitch", "yaw", "cmd"})
        writer.i16(1500 + int(std::lround(500 * rcInput(QLatin1String(input)).value_or(0))));
    for (const int pin : {kFcRollPin, kFcPitchPin}) {
        const auto told = signal(pin);
        writer.i16(told ? 1500 + int(std::lround(500 * *told)) : 0);
    }
    for (const Axis axis : kAxes)
        writer.i16(reportedAngle(s.estimate(axis)));
    for (const Axis axis : kAxes)
        writer.i16(reportedAngle(frameAngle(axis)));
    for (const Axis axis : kAxes)
        writer.i16(reportedAngle(s.target(axis)));
    writer.u16(800)
        .u16(s.imuPresent() ? 0 : 1000)
        .u8(errors & 0xFF)
        .u16(int(std::lround(volts * 100.0)))
        .u8(s.motorsOn() || isStepping())
        .u8(m_imu)
        .u8(m_active);
    for (const Axis axis : kAxes)
        writer.u8(int(std::lround(s.effort(axis) * 255.0)));
    if (!extended)
        return writer.take();
    for (const Axis axis : kAxes)
        writer.i16(reportedAngle(motorAngle(axis)));
    writer.zeros(1);
    for (const Axis axis : kAxes)
        writer.i16(int(std::lround(std::clamp(s.torque(axis), -1.0, 1.0) * 512.0)));
    writer.u16(int(std::lround(s.current() * 1000.0)));
    for (const double counts : m_magRaw)
        writer.i16(int(std::lround(counts)));
    writer.i8(celsius(31))
        .i8(isFitted("frame-imu") ? celsius(29) : 0)
        .u8(2)
        .u8(int(std::clamp(m_headingError * 10.0, 0.0, 255.0)));
    const bool isLater = m_options.firmware >= kLater;
    for (const Axis axis : kAxes)
        writer.i16(isLater ? motorOutput(axis) : 0);
    writer.u8(isLater ? calibrationMode() : 0).u8(0);
    // "Actual" is taken for where the camera is; no document says more.
    for (const Axis axis : kAxes)
        writer.i16(m_options.firmware >= kActualAngleSince ? reportedAngle(s.estimate(axis)) : 0);
    writer.u32(m_options.firmware >= kStateFlagsSince ? systemState() : 0);
    return writer.zeros(18).take();
}

// What no frame can carry (errata 1.5).
bool SimulatedBoard::isTooLong(quint32 flags) const
{
    return customSize(flags & (kFirstCustomFlags | laterCustomFlags(m_options.firmware))) > kMaxPayload;
}

QByteArray SimulatedBoard::realtimeCustom(quint32 flags) const
{
    const Stabilizer &s = m_stabilizer;
    ByteWriter writer;
    writer.u16(int(std::fmod(m_now * 1000.0, 65536.0)));
    const auto each = [&writer](auto &&raw) {
        for (const Axis axis : kAxes)
            writer.i16(raw(axis));
    };
    if (flags & 1)
        each([&](Axis axis) { return reportedAngle(s.estimate(axis)); });
    if (flags & 2)
        each([&](Axis axis) { return reportedAngle(s.target(axis)); });
    if (flags & 4)
        each([&](Axis axis) { return toCount16(m_targetSpeed[std::size_t(axis)], kGyroUnit); });
    if (flags & 8)
        each([&](Axis axis) { return reportedAngle(motorAngle(axis)); });
    if (flags & 16)
        each([&](Axis axis) { return toCount16(s.gyro(axis), kGyroUnit); });
    if (flags & 32)
        writer.bytes(rcData());
    if (flags & 64)
        writer.bytes(attitudeVectors());
    if (flags & 128)
        writer.bytes(rcChannels());
    if (flags & 256) {
        for (std::size_t i = 0; i < kAxisCount; ++i)
            writer.i16(toCount16(ownAcc(i), kAccUnit));
    }
    return writer.bytes(laterFields(flags & laterCustomFlags(m_options.firmware))).take();
}

// Fields of later firmware. Those this gimbal lacks (a fourth motor, scripts, an external IMU, limits) read
// zero.
QByteArray SimulatedBoard::laterFields(quint32 flags) const
{
    const Stabilizer &s = m_stabilizer;
    ByteWriter writer;
    const auto has = [flags](int bit) { return (flags >> bit & 1) != 0; };
    const auto fine = [&writer](auto &&degrees) {
        for (const Axis axis : kAxes)
            writer.i32(qint32(std::lround(degrees(axis) / 360.0 * 1048576.0)));
    };
    const auto estimate = [&s](Axis axis) { return s.estimate(axis); };
    const auto target = [&s](Axis axis) { return s.target(axis); };
    const auto joint = [this](Axis axis) { return motorAngle(axis); };
    const auto attitude = [](auto &&degrees) {
        return attitudeAt({degrees(Axis::Roll), degrees(Axis::Pitch), degrees(Axis::Yaw)});
    };
    if (has(9))
        writer.zeros(8);
    if (has(10))
        writer.bytes(referenceInfo());
    if (has(11)) {
        for (const Axis axis : kAxes) {
            const auto count = quint32(std::lround(encoderReading(axis) / 360.0 * 16777216.0)) & 0xFFFFFF;
            writer.u16(int(count & 0xFFFF)).u8(int(count >> 16));
        }
    }
    if (has(12)) {
        for (const Axis axis : kAxes)
            writer.f32(float(radians(s.estimate(axis))));
    }
    if (has(13))
        writer.zeros(40);
    if (has(14))
        writer.zeros(20);
    if (has(15)) {
        for (const Axis axis : kAxes) {
            writer.i16(motorOutput(axis));
            writer.u16(int(std::lround(s.current() / 3.0 * 1000.0)))
                .i8(celsius(int(std::lround(s.motorCelsius(axis)))))
                .u16(s.motorsOn() ? 4 : 0)
                .zeros(6);
        }
        writer.i8(s.motorsOn() ? 1 : 0)
            .u16(int(std::lround(volts() * 100.0)))
            .u16(int(std::lround(s.current() * 1000.0)))
            .u16(0);
    }
    if (has(16)) {
        for (const Axis axis : kAxes)
            writer.i16(toCount16(s.gyro(axis), kGyroUnit));  // the frame only moves with the hand
    }
    if (has(17))
        fine(estimate);
    if (has(18))
        fine(target);
    if (has(19))
        writer.u16(s.imuPresent() ? 0 : 1000).u16(int(std::min<quint64>(m_serialErrors, 65535))).u16(0).u8(0);
    if (has(20))  // errata 4.4 and 4.6
        writer.u32(systemState()).u8(calibrationMode()).zeros(8);
    if (has(21))
        writer.write(packQuaternion(attitude(estimate)));
    if (has(22))
        writer.write(packQuaternion(attitude(target)));
    if (has(23))
        writer.write(packQuaternion(attitude(joint)));
    if (has(24))
        writer.zeros(8);
    if (has(25))
        writer.zeros(12);
    if (has(26))
        writer.zeros(6);
    if (has(27))
        writer.zeros(24);
    if (has(28))
        fine(joint);
    if (has(29))
        writer.zeros(11);
    return writer.take();
}

QByteArray SimulatedBoard::attitudeVectors(bool ofFrame) const
{
    const auto angle
        = [&](Axis axis) { return radians(ofFrame ? frameAngle(axis) : m_stabilizer.estimate(axis)); };
    const double roll = angle(Axis::Roll);
    const double pitch = angle(Axis::Pitch);
    const double yaw = angle(Axis::Yaw);
    ByteWriter writer;
    writer.f32(float(std::sin(roll)))
        .f32(float(-std::sin(pitch)))
        .f32(float(std::cos(roll) * std::cos(pitch)));
    writer.f32(float(std::sin(yaw))).f32(float(std::cos(yaw))).f32(0.0F);
    return writer.take();
}

Angles SimulatedBoard::angles() const
{
    Angles result;
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        result[i] = {m_stabilizer.estimate(kAxes[i]), m_stabilizer.target(kAxes[i]), m_targetSpeed[i],
                     motorAngle(kAxes[i])};
    }
    return result;
}

std::vector<std::vector<double>> SimulatedBoard::debugValues() const
{
    const Stabilizer &s = m_stabilizer;
    const auto error = [&s](Axis axis) { return s.target(axis) - s.estimate(axis); };
    return {{error(Axis::Roll)},
            {error(Axis::Pitch)},
            {error(Axis::Yaw)},
            {s.torque(Axis::Roll), s.torque(Axis::Pitch), s.torque(Axis::Yaw)},
            {41},
            {31},
            {800},
            {m_now * 1000.0},
            {motorAngle(Axis::Yaw)},
            std::vector<double>(m_servos.begin(), m_servos.end())};
}

}  // namespace simplebgc
