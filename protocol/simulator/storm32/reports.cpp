// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Data that the simulated STorM32 board reports (errata 3.3-3.9).
#include "protocol/base/angles.h"
#include "protocol/simulator/storm32/board.h"
#include "protocol/storm32/orientations.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr int kCapabilities = 0xFF03;  // a v1.30 board with all features
constexpr double kLowCell = 3;  // cells of the simulated battery
constexpr double kTemperature = 31.0;
// The frame's sensor has errors too, in its own axes; calibration finds them.
constexpr std::array<double, 3> kFrameZero{0.015, -0.02, 0.03};  // g
constexpr std::array<double, 3> kFrameScale{0.99, 1.015, 1.01};
constexpr std::array<double, 3> kFrameTurn{-0.9, 1.3, 0.5};  // deg/s
constexpr double kFrameAccNoise = 0.004;  // g
constexpr double kFrameGyroNoise = 0.06;  // deg/s
constexpr int kFrameCalibration = 9;  // first word

QByteArray padded(const QByteArray &text)
{
    return text.leftJustified(16, '\0', true);
}

int rounded(double value)
{
    return int(std::lround(std::clamp(value, -32768.0, 32767.0)));
}

// From forward, left and up to the axes of a sensor mounted this way.
std::array<double, 3> inSensor(const std::array<double, 3> &body, int mount)
{
    std::array<double, 3> own{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < 3; ++i)
            own[i] += body[axis] * orientations()[std::size_t(mount)].axes[axis][i];
    }
    return own;
}

}  // namespace

QByteArray SimulatedBoard::versionData() const
{
    const bool unknown = m_options.faults.unknownFirmware;  // a layout without a table
    const QByteArray version = unknown ? "v2.20" : "v0." + QByteArray::number(m_options.firmware);
    return ByteWriter()
        .bytes(padded(version))
        .bytes(m_name)
        .bytes(padded("v1.30 F103RC"))
        .u16(unknown ? 220 : m_options.firmware)
        .u16(unknown ? 219 : m_layout)
        .u16(kCapabilities)
        .take();
}

int SimulatedBoard::status() const
{
    int bits = 0x0008;  // battery connected
    if (m_stabilizer.imuPresent())
        bits |= 0x8000 | 0x0020;
    if (value(u"imu2.configuration"_s) > 0 && m_stabilizer.imuPresent())
        bits |= 0x1000 | 0x0800 | 0x0040;  // on the board
    const double limit = value(u"battery.low_limit"_s);
    if (limit > 0 && volts() < kLowCell * (2.8 + 0.1 * limit))
        bits |= 0x0010;
    return bits;
}

int SimulatedBoard::status2() const
{
    int bits = 0;
    constexpr std::array<int, kAxisCount> kPanBits{0x4000, 0x2000, 0x8000};
    constexpr std::array<int, kAxisCount> kMotorBits{0x0010, 0x0008, 0x0020};
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        if (isPanning(kAxes[i]))
            bits |= kPanBits[i];
        if (isDriven(kAxes[i]))
            bits |= kMotorBits[i];
    }
    if (!m_stabilizer.imuPresent() && m_options.firmware < 80)
        bits |= 0x0006;
    return bits;
}

// The 32 words of `d`. Angles come pitch, roll, yaw; positive is down, right and left.
std::array<int, 32> SimulatedBoard::liveWords() const
{
    const Stabilizer &s = m_stabilizer;
    const bool later = m_options.firmware >= 93;
    const double gyroUnit = later ? 2048.0 : 1000.0;  // counts per rad/s
    const double accUnit = m_options.firmware >= 94 ? 8192.0 : later ? 16384.0 : 10000.0;  // counts per g
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
    words[7] = rounded(radians(-s.gyro(Axis::Roll)) * gyroUnit);
    words[8] = rounded(radians(s.gyro(Axis::Pitch)) * gyroUnit);
    words[9] = rounded(radians(-s.gyro(Axis::Yaw)) * gyroUnit);
    words[10] = rounded(s.acc()[1] * accUnit);
    words[11] = rounded(-s.acc()[0] * accUnit);
    words[12] = rounded(s.acc()[2] * accUnit);
    words[13] = rounded(-std::sin(radians(pitch)) * 10000.0);
    words[14] = rounded(std::cos(radians(pitch)) * std::sin(radians(roll)) * 10000.0);
    words[15] = rounded(std::cos(radians(pitch)) * std::cos(radians(roll)) * 10000.0);
    const std::array<double, 3> angles{pitch, roll, yaw};
    const bool second = status() & 0x1000;
    const Vector frame = second ? frameAngles() : Vector{};
    const std::array<Axis, 3> order{Axis::Pitch, Axis::Roll, Axis::Yaw};
    for (std::size_t i = 0; i < 3; ++i) {
        const Axis axis = order[i];
        const double sign = axis == Axis::Pitch ? 1.0 : -1.0;
        words[16 + i] = rounded(angles[i] * 100.0);
        // With an inactive motor exactly minus the angle (errata 3.5); otherwise the angle by which the motor
        // has turned the camera.
        const bool active = isDriven(axis);
        words[19 + i] = rounded((active ? sign * s.jointAngle(axis) : -angles[i]) * 100.0);
        words[22 + i] = m_pulse[std::size_t(axis)];
        words[25 + i] = rounded(frame[i] * 100.0);
    }
    words[28] = 0;
    words[29]
        = m_options.firmware >= 90 ? 300 + int(40.0 * std::sin(m_now)) : 0;  // meaningless without a link
    words[30] = state() == 6 ? 15000 : 10000;
    int functions = 0;
    for (std::size_t i = 0; i < m_scriptCase.size(); ++i)
        functions |= (m_scriptCase[i] & 3) << (6 - 2 * int(i));
    words[31] = functions;
    return words;
}

QByteArray SimulatedBoard::liveData(int words) const
{
    const auto live = m_frozen ? *m_frozen : liveWords();
    ByteWriter writer;
    for (int i = 0; i < words; ++i)
        writer.u16(live[std::size_t(i)] & 0xFFFF);
    return writer.take();
}

// Fields in bit order; the packed function word is always the last one (errata 4).
QByteArray SimulatedBoard::liveFields(int mask) const
{
    struct Field
    {
        int first;
        int count;
    };
    static constexpr std::array<Field, 12> kFields{{
        {0, 5},
        {5, 2},
        {7, 3},
        {10, 3},
        {13, 3},
        {16, 3},
        {19, 3},
        {22, 3},
        {25, 3},
        {28, 1},
        {29, 1},
        {30, 1},
    }};
    const int asked = mask == 0 ? 0x0FFF : mask;
    const auto live = liveWords();
    ByteWriter writer;
    writer.u16(mask);
    for (std::size_t bit = 0; bit < kFields.size(); ++bit) {
        for (int i = 0; asked >> bit & 1 && i < kFields[bit].count; ++i)
            writer.u16(live[std::size_t(kFields[bit].first) + std::size_t(i)] & 0xFFFF);
    }
    if (asked & 0x0080)
        writer.u16(live[31]);
    return writer.take();
}

// Held by hand; if the camera is out of the gimbal or tilted by hand, the frame moves with it.
SimulatedBoard::Vector SimulatedBoard::frameGravity() const
{
    if (m_stabilizer.pose() != 0) {
        const auto &g = m_stabilizer.gravity();
        return {g[1], -g[0], g[2]};
    }
    const double pitch = radians(m_stabilizer.hand().angle(Axis::Pitch));
    const double roll = radians(-m_stabilizer.hand().angle(Axis::Roll));
    return {-std::sin(pitch), std::cos(pitch) * std::sin(roll), std::cos(pitch) * std::cos(roll)};
}

SimulatedBoard::Vector SimulatedBoard::frameReading() const
{
    Vector reading = inSensor(frameGravity(), m_options.faults.frameMount);
    for (std::size_t i = 0; i < 3; ++i)
        reading[i] = reading[i] * kFrameScale[i] + kFrameZero[i];
    return reading;
}

SimulatedBoard::Vector SimulatedBoard::frameAngles() const
{
    Vector own = frameReading();
    for (std::size_t i = 0; i < 3; ++i) {
        const int scale = m_calibration[kFrameCalibration + 3 + i];
        own[i] = (own[i] * oneG() - m_calibration[kFrameCalibration + i]) / (scale != 0 ? scale : oneG());
    }
    const auto told
        = std::size_t(std::clamp(int(value(u"imu2.orientation"_s)), 0, int(orientations().size()) - 1));
    Vector body{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < 3; ++i)
            body[axis] += orientations()[told].axes[axis][i] * own[i];
    }
    const double yaw = -m_stabilizer.hand().angle(Axis::Yaw);  // known from the gyroscope only
    return {degrees(-std::atan2(body[0], std::hypot(body[1], body[2]))),
            degrees(std::atan2(body[1], body[2])), yaw};
}

// Counts before calibration, in the sensors' own axes: acceleration, angular rate, temperature of the
// camera's sensor, then of the frame's.
QByteArray SimulatedBoard::rawSensors()
{
    const Stabilizer &s = m_stabilizer;
    if (!s.imuPresent())
        return QByteArray(28, '\0');
    ByteWriter writer;
    const auto put = [&](const Vector &own, double unit) {
        for (const double value : own)
            writer.i16(rounded(value * unit));
    };
    const int temperature = rounded((kTemperature - 36.53) * 340.0);
    put(inSensor({s.rawAcc(1), -s.rawAcc(0), s.rawAcc(2)}, m_options.faults.mount), oneG());
    put(inSensor({-s.rawGyro(Axis::Roll), s.rawGyro(Axis::Pitch), -s.rawGyro(Axis::Yaw)},
                 m_options.faults.mount),
        kCountsPerDegree);
    writer.i16(temperature);
    if (!(status() & 0x1000))
        return writer.zeros(14).take();
    const HandShake &hand = s.hand();
    const bool lies = s.pose() != 0;
    Vector turn
        = lies ? Vector{} : Vector{-hand.rate(Axis::Roll), hand.rate(Axis::Pitch), -hand.rate(Axis::Yaw)};
    turn = inSensor(turn, m_options.faults.frameMount);
    Vector acc = frameReading();
    for (std::size_t i = 0; i < 3; ++i) {
        acc[i] += m_frameNoise.gauss(kFrameAccNoise);
        turn[i] += kFrameTurn[i] + m_frameNoise.gauss(kFrameGyroNoise);
    }
    put(acc, oneG());
    put(turn, kCountsPerDegree);
    return writer.i16(temperature).take();
}

}  // namespace storm32
