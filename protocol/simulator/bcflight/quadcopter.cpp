// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/bcflight/quadcopter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace bcflight {

namespace {

constexpr double kGravity = 9.80665;
constexpr double kFullThrust = 7.5;  // N of one propeller at full speed and nominal voltage
constexpr double kArm = 0.0884;  // m from the axis of roll and of pitch
constexpr double kDragTorque = 0.016;  // Nm about yaw per N of thrust
constexpr Vector3 kInertia{0.0030, 0.0034, 0.0056};  // kg m²
constexpr double kDriven = 0.01;  // of full speed
constexpr Vector3 kDamping{0.0022, 0.0024, 0.0020};  // Nm per rad/s: air and bearings of the stand
constexpr double kMotorLag = 0.035;  // s
constexpr double kNominal = 3.7;  // V per cell
constexpr double kInner = 0.012;  // ohm, whole battery
constexpr double kCapacity = 1500;  // mAh
constexpr double kFullCurrent = 17;  // A of one motor at full speed
constexpr double kIdleCurrent = 0.6;  // A of the electronics
constexpr double kPropellerHz = 260;  // at full speed
constexpr double kShake = 9.0;  // °/s of the gyroscope at full speed
constexpr double kHum = 2.5;  // m/s²
constexpr double kGyroNoise = 0.25;
constexpr double kAccelerationNoise = 0.06;
constexpr double kFieldNoise = 0.4;
constexpr Vector3 kEarthField{20.0, 0.0, 44.0};
constexpr double kHandRate = 60;  // °/s
constexpr double kHandStiffness = 4;  // 1/s
constexpr double kGustTime = 0.6;  // s
constexpr double kGustTorque = 0.02;  // Nm

// Of one cell, by the share of its charge that is left.
double openVoltage(double left)
{
    const double share = std::clamp(left, 0.0, 1.0);
    return 3.30 + 0.55 * share + 0.35 * std::pow(share, 6) - 0.30 * std::exp(-14 * share);
}

}  // namespace

Quadcopter::Quadcopter(unsigned seed, Mix mix)
    : m_noise(seed)
    , m_body(kInertia, kDamping)
    , m_mix(std::move(mix))
    , m_speeds(m_mix.size())
    , m_thrusts(m_mix.size())
    , m_phases(m_mix.size())
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        m_zero[axis] = m_noise.gauss(1.5);
    for (double &phase : m_phases)
        phase = m_noise.uniform() * 2 * std::numbers::pi;
    sense(0.001);
}

void Quadcopter::step(double seconds, const std::vector<double> &outputs)
{
    feelMotors(seconds, outputs);
    turn(seconds);
    sense(seconds);
}

void Quadcopter::setAttitude(double roll, double pitch, double yaw)
{
    m_body.setAttitude({roll, pitch, yaw});
}

void Quadcopter::feelMotors(double seconds, const std::vector<double> &outputs)
{
    const double perCell = m_voltage / kCells / kNominal;
    double current = kIdleCurrent;
    for (std::size_t i = 0; i < m_mix.size(); ++i) {
        const double wanted = std::clamp(i < outputs.size() ? outputs[i] : 0.0, 0.0, 1.0) * perCell;
        m_speeds[i] += (wanted - m_speeds[i]) * std::min(1.0, seconds / kMotorLag);
        m_thrusts[i] = kFullThrust * m_speeds[i] * m_speeds[i];
        current += kFullCurrent * std::pow(m_speeds[i], 3);
    }
    m_current = current;
    m_charge += current * 1000 * seconds / 3600;
    const double open = openVoltage(1 - m_charge / kCapacity) * kCells;
    m_voltage = m_fixedVoltage > 0 ? m_fixedVoltage : open - kInner * current;
}

void Quadcopter::turn(double seconds)
{
    Vector3 torque;
    for (std::size_t i = 0; i < m_mix.size(); ++i)
        torque += m_thrusts[i] * Vector3{kArm * m_mix[i][0], kArm * m_mix[i][1], kDragTorque * m_mix[i][2]};
    for (std::size_t axis = 0; axis < 3; ++axis)
        m_gust[axis] += -m_gust[axis] * seconds / kGustTime
            + m_noise.gauss(m_gusts * kGustTorque * std::sqrt(seconds / kGustTime));
    if (m_hand) {
        Vector3 rates;
        const Vector3 now = m_body.attitude();
        for (std::size_t axis = 0; axis < 3; ++axis)
            rates[axis] = std::clamp(kHandStiffness * std::remainder((*m_hand)[axis] - now[axis], 360.0),
                                     -kHandRate, kHandRate);
        m_body.carry(rates);
        m_body.turn(seconds);
        return;
    }
    if (m_place == Place::Ground) {
        m_body.stop();
        return;
    }
    // Gusts turn what flies; against a drone that is not driven they do not overcome the friction of the
    // bearings.
    const double drive = *std::max_element(m_speeds.begin(), m_speeds.end());
    m_body.push(seconds, drive > kDriven ? torque + m_gust : torque);
    if (m_blocked > 0)
        m_body.block(std::size_t(m_blocked - 1));
    m_body.turn(seconds);
}

void Quadcopter::sense(double seconds)
{
    Vector3 shake;
    for (std::size_t i = 0; i < m_speeds.size(); ++i) {
        m_phases[i] += 2 * std::numbers::pi * kPropellerHz * m_speeds[i] * seconds;
        const double strength = m_speeds[i] * m_speeds[i];
        const double side = i % 2 == 0 ? 1 : 0.7;
        shake += strength
            * Vector3{std::sin(m_phases[i]), side * std::cos(m_phases[i]), 0.3 * std::sin(m_phases[i])};
    }
    const auto noise = [this](double sigma) {
        const double x = m_noise.gauss(sigma);
        const double y = m_noise.gauss(sigma);
        return Vector3{x, y, m_noise.gauss(sigma)};
    };
    m_gyro = m_body.rates() + m_zero + kShake / 4 * shake + noise(kGyroNoise);
    // A stand or the ground carries it, so the sensor feels gravity whatever the propellers pull.
    m_acceleration = m_body.inBody({0, 0, kGravity}) + kHum / 4 * shake + noise(kAccelerationNoise);
    m_field = m_body.inBody(kEarthField) + noise(kFieldNoise);
}

}  // namespace bcflight
