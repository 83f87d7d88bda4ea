// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/world/plant.h"

#include "protocol/base/angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

constexpr double kMotorLag = 0.004;  // seconds: winding and driver
constexpr int kSubSteps = 4;  // of the 0.8 ms cycle, so that resonances stay accurate
constexpr double kRoom = 25;  // °C
constexpr double kFullHeat = 80;  // °C above the room that a motor reaches at full power
constexpr double kWarmingTime = 180;  // seconds: the time constant of a motor's body
constexpr double kSway = 2.0;  // degrees rms of a calm hand
constexpr double kSwayHz = 0.5;

}  // namespace

void AxisPlant::step(double seconds, double torque, double frameAngle, double frameRate)
{
    const double dt = seconds / kSubSteps;
    const double omega = 2.0 * std::numbers::pi * m_mechanics.resonanceHz;
    m_frameAngle = frameAngle;
    m_atStop = false;
    if (m_isBlocked) {
        m_angle += frameRate * seconds;
        m_rate = frameRate;
        m_bend = m_bendRate = m_motor = 0.0;
        return;
    }
    for (int i = 0; i < kSubSteps; ++i) {
        m_motor += (std::clamp(torque, -1.0, 1.0) - m_motor) * std::min(1.0, dt / kMotorLag);
        const double drive = m_mechanics.fullTorque * m_motor;
        const double slip = m_rate - frameRate;
        double acceleration = drive;
        acceleration -= m_mechanics.viscous * slip + m_mechanics.coulomb * std::tanh(slip / 1.5);
        acceleration += m_imbalance * m_mechanics.imbalance * std::cos(radians(m_angle));
        acceleration += m_mechanics.cogging * std::sin(radians(jointAngle()) * m_mechanics.poles);
        m_rate += acceleration * dt;
        m_angle += m_rate * dt;
        if (std::abs(jointAngle()) > m_mechanics.stop) {
            m_atStop = true;
            m_angle = frameAngle + std::copysign(m_mechanics.stop, jointAngle());
            m_rate = frameRate;
        }
        // The structure between motor and sensor is excited by the motor.
        const double bendAcceleration = m_mechanics.resonanceGain * drive - omega * omega * m_bend
            - 2.0 * m_mechanics.resonanceDamping * omega * m_bendRate;
        m_bendRate += bendAcceleration * dt;
        m_bend += m_bendRate * dt;
    }
}

void AxisPlant::heat(double seconds, double power)
{
    m_celsius += (kRoom + kFullHeat * power * power - m_celsius) * seconds / kWarmingTime;
}

void HandShake::step(double seconds)
{
    // Second-order coloured noise: white acceleration with a restoring force towards the middle.
    const double omega = 2.0 * std::numbers::pi * kSwayHz;
    const double drive = kSway * m_strength * std::pow(omega, 1.5) * 2.0 / std::sqrt(seconds);
    for (std::size_t axis = 0; axis < m_angle.size(); ++axis) {
        m_rate[axis]
            += (m_noise.gauss(drive) - omega * omega * m_angle[axis] - 2.0 * omega * m_rate[axis]) * seconds;
        m_angle[axis] += m_rate[axis] * seconds;
    }
}

AxisMechanics simulatedMechanics(Axis axis)
{
    AxisMechanics mechanics;
    switch (axis) {
    case Axis::Roll: break;
    case Axis::Pitch:
        mechanics.fullTorque = 4500.0;
        mechanics.resonanceHz = 70.0;
        mechanics.imbalance = 80.0;
        break;
    case Axis::Yaw:
    case Axis::None:
        mechanics.fullTorque = 3500.0;
        mechanics.resonanceHz = 45.0;
        mechanics.imbalance = 0.0;
        mechanics.viscous = 3.0;
        break;
    }
    return mechanics;
}
