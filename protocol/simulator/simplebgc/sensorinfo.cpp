// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the simulated board knows of its sensors' calibration, and the accelerometer by a reference (errata
// 3.19).
#include "protocol/base/angles.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/units.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kCalibrationInfoSize = 12;
constexpr int kReferenceSize = 20;
constexpr int kUsualTemperature = 31;

}  // namespace

bool SimulatedBoard::handleSensorInfo(const Frame &frame)
{
    if (m_options.firmware < kLater)
        return false;
    switch (static_cast<CommandId>(frame.id)) {
    case CommandId::CalibInfo: {
        if (!hasSize(frame, kCalibrationInfoSize))
            return true;
        const int asked = quint8(frame.payload[0]);
        const int imu = asked == 0 ? m_imu : asked;
        if (imu > kFrameImu || (imu == kFrameImu && !isFrameSensor()))
            refuse(frame, kWrongParameters);
        else
            reply(frame, CommandId::CalibInfo, calibrationInfo(imu));
        return true;
    }
    case CommandId::CalibAccExtRef: startReference(frame); return true;
    default: return false;
    }
}

// The amplitude of the gyroscope is in counts of its own: an assumption.
QByteArray SimulatedBoard::calibrationInfo(int imu) const
{
    const bool isFrame = imu == kFrameImu;
    const bool isRunning = m_calibration.left > 0 && m_calibration.imu == imu;
    double gyro = 0;
    for (std::size_t i = 0; i < kAxisCount; ++i)
        gyro = std::max(gyro,
                        std::abs(isFrame ? m_frameRawGyro[i] - m_frameImu.gyroCorrection[i]
                                         : m_stabilizer.gyro(kAxes[i])));
    std::array<double, kAxisCount> acc{};
    for (std::size_t i = 0; i < kAxisCount; ++i)
        acc[i] = isFrame ? m_frameRawAcc[i] - m_frameImu.accCorrection[i] : ownAcc(i);
    const auto up = std::max_element(acc.begin(), acc.end(),
                                     [](double a, double b) { return std::abs(a) < std::abs(b); });
    int limits = 0;
    for (std::size_t i = 0; i < kAxisCount && !isFrame; ++i) {
        limits |= m_accLimits[i][1] ? 1 << (2 * i) : 0;
        limits |= m_accLimits[i][0] ? 2 << (2 * i) : 0;
    }
    const auto temperatures = [&](CommandId command) {
        const auto known = m_temperatures.find({command, imu});
        return known == m_temperatures.end() ? Temperatures() : known->second;
    };
    const Temperatures ofGyro = temperatures(CommandId::CalibGyro);
    const Temperatures ofAcc = temperatures(CommandId::CalibAcc);
    ByteWriter writer;
    writer.u8(isRunning ? int(100 * (1 - m_calibration.left / m_calibration.total)) : 0).u8(imu);
    for (const double each : acc)
        writer.i16(toCount16(each, kAccUnit));
    writer.u16(toCount16(gyro, kGyroUnit)).u8(int(up - acc.begin())).u8(limits);
    writer.i8(celsius(kUsualTemperature)).u8(ofGyro.isUsed);
    writer.i8(ofGyro.range ? ofGyro.range->first : 0).i8(ofGyro.range ? ofGyro.range->second : 0);
    writer.u8(ofAcc.isUsed);
    for (const int position : ofAcc.positions)
        writer.u8(position);
    writer.i8(ofAcc.range ? ofAcc.range->first : 0).i8(ofAcc.range ? ofAcc.range->second : 0);
    // As far apart as two unit vectors are.
    const double heading = isFitted("magnetometer") ? 2 * std::sin(radians(m_headingError) / 2) : 0;
    return writer.u8(int(std::clamp(100 * heading, 0.0, 255.0))).zeros(7).take();
}

void SimulatedBoard::noteTemperatures(CommandId command, int imu, int action)
{
    constexpr int kForget = 2;
    constexpr int kMeasure = 3;
    constexpr int kUse = 4;
    constexpr int kIgnore = 5;
    Temperatures &known = m_temperatures[{command, imu}];
    const int now = celsius(kUsualTemperature);
    switch (action) {
    case kForget: known = {}; break;
    case kMeasure: {
        known.range = known.range
            ? std::pair(std::min(known.range->first, now), std::max(known.range->second, now))
            : std::pair(now, now);
        std::size_t up = 0;
        const auto gravity
            = [&](std::size_t i) { return imu == kFrameImu ? m_frameRawAcc[i] : m_stabilizer.rawAcc(i); };
        for (std::size_t i = 1; i < kAxisCount; ++i)
            up = std::abs(gravity(i)) > std::abs(gravity(up)) ? i : up;
        ++known.positions[gravity(up) > 0 ? up : up + kAxisCount];
        break;
    }
    case kUse: known.isUsed = known.range.has_value(); break;
    case kIgnore: known.isUsed = false; break;
    default: break;
    }
}

// Confirmed at reception and, measured, once more; motors go on, because only they hold it still.
void SimulatedBoard::startReference(const Frame &frame)
{
    if (!hasSize(frame, kReferenceSize))
        return;
    if (isBusy() || !m_stabilizer.imuPresent()) {
        refuse(frame, kWrongState);
        return;
    }
    ByteReader reader(frame.payload);
    std::array<double, kAxisCount> own{};
    for (double &each : own)
        each = reader.i16() * kAccUnit;
    if (std::abs(std::hypot(own[0], own[1], own[2]) - 1) > 0.5) {
        refuse(frame, kWrongParameters);
        return;
    }
    m_reference = m_imu == kFrameImu ? own : fromSensor(own);
    beginCalibration(CommandId::CalibAccExtRef, m_imu, kOnce, frame.version);
    confirm(frame);
}

void SimulatedBoard::levelByReference(const std::array<double, kAxisCount> &mean)
{
    SimulatedImu &imu = m_calibration.imu == kFrameImu ? m_frameImu : m_stabilizer.imu();
    for (std::size_t i = 0; i < kAxisCount; ++i)
        imu.accCorrection[i] = mean[i] - m_reference[i] * imu.accScale[i];
}

}  // namespace simplebgc
