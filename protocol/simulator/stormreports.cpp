// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the simulated STorM32 board reports of itself (errata 3.3-3.9).
#include "protocol/simulator/stormboard.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace Qt::StringLiterals;
using namespace storm32;

namespace {

constexpr double kRadian = std::numbers::pi / 180.0;
constexpr int kCapabilities = 0xFF03;      // a v1.30 board with everything
constexpr double kLowCell = 3;             // cells of the simulated battery
constexpr double kTemperature = 31.0;
constexpr double kCountsPerDegree = 65.5;

QByteArray padded(const QByteArray &text)
{
    return text.leftJustified(16, '\0', true);
}

int rounded(double value)
{
    return int(std::lround(std::clamp(value, -32768.0, 32767.0)));
}

} // namespace

QByteArray StormBoard::versionData() const
{
    const bool unknown = m_options.faults.unknownFirmware;   // one whose layout nobody has a table for
    const QByteArray version = unknown ? "v2.20" : "v0." + QByteArray::number(m_options.firmware);
    return ByteWriter().bytes(padded(version)).bytes(m_name).bytes(padded("v1.30 F103RC"))
        .u16(unknown ? 220 : m_options.firmware).u16(unknown ? 219 : m_layout).u16(kCapabilities).take();
}

int StormBoard::status() const
{
    int bits = 0x0008;   // battery connected
    if (m_stabilizer.imuPresent())
        bits |= 0x8000 | 0x0020;
    if (value(u"imu2.configuration"_s) > 0 && m_stabilizer.imuPresent())
        bits |= 0x1000 | 0x0800 | 0x0040;   // on the board
    const double limit = value(u"battery.low_limit"_s);
    if (limit > 0 && volts() < kLowCell * (2.8 + 0.1 * limit))
        bits |= 0x0010;
    return bits;
}

int StormBoard::status2() const
{
    int bits = 0;
    constexpr std::array<int, kAxisCount> kPanBits{0x4000, 0x2000, 0x8000};
    constexpr std::array<int, kAxisCount> kMotorBits{0x0010, 0x0008, 0x0020};
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        if (isPanning(kAxes[i]))
            bits |= kPanBits[i];
        if (m_stabilizer.motorsOn() && axisValue("motor.%a.usage", kAxes[i]) != 3.0)
            bits |= kMotorBits[i];
    }
    if (!m_stabilizer.imuPresent() && m_options.firmware < 80)
        bits |= 0x0006;
    return bits;
}

// The 32 words of `d`. Angles come pitch, roll, yaw; positive is down, right and left.
std::array<int, 32> StormBoard::liveWords() const
{
    const Stabilizer &s = m_stabilizer;
    const bool later = m_options.firmware >= 93;
    const double gyroUnit = later ? 2048.0 : 1000.0;                                   // counts per rad/s
    const double accUnit = m_options.firmware >= 94 ? 8192.0 : later ? 16384.0 : 10000.0;   // counts per g
    const double pitch = s.estimate(Axis::Pitch);
    const double roll = -s.estimate(Axis::Roll);
    const double yaw = -s.estimate(Axis::Yaw);
    std::array<int, 32> words{};
    words[0] = state();
    words[1] = status();
    words[2] = status2();
    words[3] = s.imuPresent() ? 0 : 1000;
    words[4] = int(std::lround(volts() * 1000.0));
    const double ms = m_now * 1000.0;
    words[5] = int(m_options.firmware < 90 ? std::fmod(ms, 66.0) : std::fmod(ms, 65536.0));
    words[6] = 1500;
    words[7] = rounded(-s.gyro(Axis::Roll) * kRadian * gyroUnit);
    words[8] = rounded(s.gyro(Axis::Pitch) * kRadian * gyroUnit);
    words[9] = rounded(-s.gyro(Axis::Yaw) * kRadian * gyroUnit);
    words[10] = rounded(s.acc()[1] * accUnit);
    words[11] = rounded(-s.acc()[0] * accUnit);
    words[12] = rounded(s.acc()[2] * accUnit);
    words[13] = rounded(-std::sin(pitch * kRadian) * 10000.0);
    words[14] = rounded(std::cos(pitch * kRadian) * std::sin(roll * kRadian) * 10000.0);
    words[15] = rounded(std::cos(pitch * kRadian) * std::cos(roll * kRadian) * 10000.0);
    const std::array<double, 3> angles{pitch, roll, yaw};
    const std::array<Axis, 3> order{Axis::Pitch, Axis::Roll, Axis::Yaw};
    for (std::size_t i = 0; i < 3; ++i) {
        const Axis axis = order[i];
        const double sign = axis == Axis::Pitch ? 1.0 : -1.0;
        words[16 + i] = rounded(angles[i] * 100.0);
        // With a motor that does nothing exactly minus the angle (errata 3.5); else where the motor has turned the camera.
        const bool active = s.motorsOn() && axisValue("motor.%a.usage", axis) != 3.0;
        words[19 + i] = rounded((active ? sign * s.jointAngle(axis) : -angles[i]) * 100.0);
        words[22 + i] = m_pulse[std::size_t(axis)];
        words[25 + i] = status() & 0x1000 ? rounded(sign * s.hand().angle(axis) * 100.0) : 0;
    }
    words[28] = 0;
    words[29] = m_options.firmware >= 90 ? 300 + int(40.0 * std::sin(m_now)) : 0;   // means nothing without a link
    words[30] = state() == 6 ? 15000 : 10000;
    int functions = 0;
    for (std::size_t i = 0; i < m_scriptCase.size(); ++i)
        functions |= (m_scriptCase[i] & 3) << (6 - 2 * int(i));
    words[31] = functions;
    return words;
}

QByteArray StormBoard::liveData(int words) const
{
    const auto live = liveWords();
    ByteWriter writer;
    for (int i = 0; i < words; ++i)
        writer.u16(live[std::size_t(i)] & 0xFFFF);
    return writer.take();
}

// Fields in bit order; the packed function word is always the last one (errata 4).
QByteArray StormBoard::liveFields(int mask) const
{
    struct Field
    {
        int first;
        int count;
    };
    static constexpr std::array<Field, 12> kFields{{
        {0, 5}, {5, 2}, {7, 3}, {10, 3}, {13, 3}, {16, 3}, {19, 3}, {22, 3}, {25, 3}, {28, 1}, {29, 1}, {30, 1},
    }};
    const int asked = mask == 0 ? 0x0FFF : mask;
    const auto live = liveWords();
    ByteWriter writer;
    writer.u16(mask);
    for (std::size_t bit = 0; bit < kFields.size(); ++bit) {
        for (int i = 0; asked >> bit & 1 && i < kFields[bit].count; ++i)
            writer.u16(live[std::size_t(kFields[bit].first + i)] & 0xFFFF);
    }
    if (asked & 0x0080)
        writer.u16(live[31]);
    return writer.take();
}

// Counts before calibration, in the sensor's own axes.
QByteArray StormBoard::rawSensors() const
{
    const Stabilizer &s = m_stabilizer;
    if (!s.imuPresent())
        return QByteArray(28, '\0');
    const double one = m_options.firmware >= 94 ? 8192.0 : 16384.0;
    ByteWriter writer;
    // From the camera's forward, left and up to the axes of the sensor, as it sits.
    const auto &mounted = orientations()[std::size_t(m_options.faults.mount)].axes;
    const auto put = [&](const std::array<double, 3> &camera) {
        for (std::size_t own = 0; own < 3; ++own) {
            double along = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                along += camera[axis] * mounted[axis][own];
            writer.i16(rounded(along));
        }
    };
    put({s.rawAcc(1) * one, -s.rawAcc(0) * one, s.rawAcc(2) * one});
    put({-s.rawGyro(Axis::Roll) * kCountsPerDegree, s.rawGyro(Axis::Pitch) * kCountsPerDegree, -s.rawGyro(Axis::Yaw) * kCountsPerDegree});
    const int temperature = rounded((kTemperature - 36.53) * 340.0);
    writer.i16(temperature);
    const bool second = status() & 0x1000;
    writer.i16(0).i16(0).i16(second ? rounded(one) : 0).zeros(6).i16(second ? temperature : 0);
    return writer.take();
}
