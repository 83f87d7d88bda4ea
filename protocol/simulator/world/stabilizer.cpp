// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/world/stabilizer.h"

#include "protocol/base/angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace {

// One unit of P, I and D in deg/s² per degree, per degree second and per deg/s.
constexpr double kUnitP = 28.0;
constexpr double kUnitI = 218.0;
constexpr double kUnitD = 1.5;
constexpr double kReference = 4000.0;  // deg/s² that the gains are scaled to
constexpr double kNominalVoltage = 12.3;
constexpr double kGyroLag = 0.002;  // seconds: the sensor's own low-pass
constexpr double kIntegralLimit = 0.6;  // of full torque
constexpr int kTruePoles = 14;
constexpr int kTilted = 7;  // pose

}  // namespace

Biquad Biquad::lowPass(double hz, double sampleRate)
{
    Biquad filter;
    if (hz <= 0.0 || hz >= 0.45 * sampleRate)
        return filter;
    const double w = 2.0 * std::numbers::pi * hz / sampleRate;
    const double alpha = std::sin(w) / std::numbers::sqrt2;
    const double a0 = 1.0 + alpha;
    filter.m_b0 = filter.m_b2 = (1.0 - std::cos(w)) / 2.0 / a0;
    filter.m_b1 = (1.0 - std::cos(w)) / a0;
    filter.m_a1 = -2.0 * std::cos(w) / a0;
    filter.m_a2 = (1.0 - alpha) / a0;
    return filter;
}

Biquad Biquad::notch(double hz, double width, double depthDb, double sampleRate)
{
    Biquad filter;
    if (hz <= 0.0 || width <= 0.0 || hz >= 0.45 * sampleRate)
        return filter;
    // A peaking filter with negative gain; a positive depth attenuates the band (errata 3.5: positive =
    // notch).
    const double w = 2.0 * std::numbers::pi * hz / sampleRate;
    const double a = std::pow(10.0, -std::clamp(depthDb, -40.0, 40.0) / 40.0);
    const double alpha = std::sin(w) * width / (2.0 * hz);
    const double a0 = 1.0 + alpha / a;
    filter.m_b0 = (1.0 + alpha * a) / a0;
    filter.m_b1 = -2.0 * std::cos(w) / a0;
    filter.m_b2 = (1.0 - alpha * a) / a0;
    filter.m_a1 = filter.m_b1;
    filter.m_a2 = (1.0 - alpha / a) / a0;
    return filter;
}

double Biquad::process(double input)
{
    const double output = m_b0 * input + m_b1 * m_x1 + m_b2 * m_x2 - m_a1 * m_y1 - m_a2 * m_y2;
    m_x2 = m_x1;
    m_x1 = input;
    m_y2 = m_y1;
    m_y1 = output;
    return output;
}

Stabilizer::Stabilizer(unsigned seed)
    : m_noise(seed * 2 + 1)
    , m_hand(seed * 2 + 2)
{
}

void Stabilizer::setGains(Axis axis, const AxisGains &gains)
{
    AxisState &state = m_axes[index(axis)];
    const AxisGains old = state.gains;
    state.gains = gains;
    // Filters keep their state while only gains change, so live tuning causes no jolt.
    const bool sameNotches = std::equal(gains.notches.begin(), gains.notches.end(), old.notches.begin(),
                                        [](const AxisGains::Notch &a, const AxisGains::Notch &b) {
                                            return a.hz == b.hz && a.width == b.width && a.gainDb == b.gainDb;
                                        });
    if (!sameNotches || gains.lpfHz != old.lpfHz) {
        for (std::size_t i = 0; i < 3; ++i) {
            const AxisGains::Notch &notch = gains.notches[i];
            state.filters[i] = Biquad::notch(notch.hz, notch.width, notch.gainDb, 1.0 / kCycle);
        }
        state.filters[3] = Biquad::lowPass(gains.lpfHz, 1.0 / kCycle);
    }
    if (gains.dLpfHz != old.dLpfHz)
        state.dFilter = Biquad::lowPass(gains.dLpfHz, 1.0 / kCycle);
}

void Stabilizer::setMotorsOn(bool on)
{
    if (on && !m_motorsOn) {
        for (AxisState &axis : m_axes)
            axis.integral = axis.command = 0.0;
    }
    m_motorsOn = on;
}

void Stabilizer::setPose(int pose)
{
    if (std::exchange(m_pose, pose) != 0 && pose == 0)
        resetEstimate();
}

void Stabilizer::setHandOnCamera(Hand hand)
{
    const Hand before = std::exchange(m_handOnCamera, hand);
    if (before == hand)
        return;
    m_moved = 0;
    constexpr double kTap = 15;  // deg/s: whoever lets go tips it lightly
    for (const Axis axis : {Axis::Roll, Axis::Pitch}) {
        if (before == Hand::HoldsLevel && hand == Hand::None)
            plant(axis).setMotion(plant(axis).trueAngle(), kTap);
    }
}

// Each axis to both ends and back, one after the other, as slowly as one looks where the cables are; from
// wherever it hangs it is brought there first.
void Stabilizer::moveByHand()
{
    constexpr std::array<double, kAxisCount> kReach{40, 85, 150};  // degrees
    constexpr double kPeriod = 6;  // seconds
    constexpr double kTilt = 40;
    constexpr double kFastest = 180;  // deg/s
    m_moved += kCycle;
    if (m_handOnCamera == Hand::TurnsOver || m_handOnCamera == Hand::TurnsUpright) {
        turnByHand();
        return;
    }
    const auto turn = std::size_t(std::fmod(m_moved / kPeriod, double(kAxisCount)));
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        AxisPlant &plant = m_axes[i].plant;
        double wanted = 0;
        if (m_handOnCamera == Hand::Moves && i == turn)
            wanted = kReach[i] * std::sin(2 * std::numbers::pi * std::fmod(m_moved, kPeriod) / kPeriod);
        else if (m_handOnCamera == Hand::NoseDown && kAxes[i] == Axis::Pitch)
            wanted = kTilt;
        else if (m_handOnCamera == Hand::RightDown && kAxes[i] == Axis::Roll)
            wanted = -kTilt;
        const double step = std::clamp(wanted - plant.trueAngle(), -kFastest * kCycle, kFastest * kCycle);
        plant.setMotion(plant.trueAngle() + step, step / kCycle);
    }
}

// Taken out of the gimbal: to all sides in turn, or about its upright axis only, as those do it who have not
// read on.
void Stabilizer::turnByHand()
{
    constexpr double kPeriod = 20;  // seconds until it has been everywhere
    constexpr double kRolledOver = 180;  // degrees to either side
    constexpr double kPitchedOver = 80;
    constexpr double kFull = 2 * std::numbers::pi / kPeriod;
    const bool isOver = m_handOnCamera == Hand::TurnsOver;
    const auto swing = [&](Axis axis, double reach, int times) {
        const double phase = m_moved * kFull * times;
        plant(axis).setMotion(reach * std::sin(phase), reach * kFull * times * std::cos(phase));
    };
    swing(Axis::Roll, isOver ? kRolledOver : 0, 5);
    swing(Axis::Pitch, isOver ? kPitchedOver : 0, 3);
    constexpr double kYawRate = 2 * 360 / kPeriod;
    plant(Axis::Yaw).setMotion(kYawRate * m_moved, kYawRate);
}

void Stabilizer::setBelievedAxes(const Rotation &axes)
{
    if (std::exchange(m_believed, axes) != axes)
        m_believesAnew = true;
}

void Stabilizer::resetEstimate()
{
    for (AxisState &axis : m_axes) {
        axis.estimate = axis.plant.angle();
        axis.integral = 0.0;
    }
    m_believesAnew = m_believed != kAsMounted;
}

Axis Stabilizer::motorAt(Axis plug) const
{
    if (!m_swapped || plug == Axis::Yaw)
        return plug;
    return plug == Axis::Roll ? Axis::Pitch : Axis::Roll;
}

void Stabilizer::step()
{
    m_hand.step(kCycle);
    m_current = 0.12;
    std::array<double, kAxisCount> torque{};
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
        AxisState &axis = m_axes[i];
        const bool driven = m_motorsOn && m_imuPresent;
        // The motor acts through the configured number of poles, and in the wrong direction if wrongly
        // inverted.
        const double poleFactor
            = axis.gains.poles <= 0 ? 0.0 : std::min(3.0, double(kTruePoles) / axis.gains.poles);
        const std::size_t turned = index(motorAt(axis.plug));
        const AxisPlant &motor = m_axes[turned].plant;
        const double strength = motor.motorStrength();
        const double limit = axis.gains.power * strength * m_voltage / kNominalVoltage;
        const AxisMechanics &mechanics = motor.mechanics();
        const double ripple = mechanics.cogging * std::sin(radians(motor.jointAngle()) * mechanics.poles)
            / mechanics.fullTorque;
        const double wanted = (axis.command + axis.stimulus - axis.rippleKnown * ripple) * poleFactor;
        const double command = driven ? std::clamp(wanted, -limit, limit) : 0.0;
        axis.torque = axis.gains.inverted ? -command : command;
        torque[turned] += axis.torque * axis.field;
        axis.effort = driven ? axis.gains.power : 0.0;
        m_current += std::abs(command) / strength * 1.6 + axis.effort * 0.25;
        axis.plant.heat(kCycle, axis.effort);
    }
    if (m_handOnCamera != Hand::None)
        moveByHand();
    for (std::size_t i = 0; i < m_axes.size() && m_handOnCamera == Hand::None; ++i) {
        AxisPlant &plant = m_axes[i].plant;
        if (m_held || m_pose != 0)
            plant.setAngle(plant.angle());
        else
            plant.step(kCycle, torque[i], m_hand.angle(kAxes[i]), m_hand.rate(kAxes[i]));
    }
    sense();
    for (AxisState &axis : m_axes)
        control(axis);
}

void Stabilizer::sense()
{
    const double roll = radians(m_axes[0].plant.angle());
    const double pitch = radians(m_axes[1].plant.angle());
    m_gravity = {std::cos(pitch) * std::sin(roll), -std::sin(pitch), std::cos(pitch) * std::cos(roll)};
    if (m_pose == kTilted) {
        m_gravity = {0.0, -std::numbers::sqrt2 / 2.0, std::numbers::sqrt2 / 2.0};
    } else if (m_pose != 0) {
        constexpr std::array<std::size_t, 3> faceAxis{2, 0, 1};
        m_gravity = {};
        m_gravity[faceAxis[std::size_t(m_pose - 1) / 2]] = m_pose % 2 ? 1.0 : -1.0;
    }
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        AxisState &axis = m_axes[i];
        if (!m_imuPresent) {
            axis.gyro = axis.rawGyro = 0.0;
            m_acc[i] = m_rawAcc[i] = 0.0;
            continue;
        }
        axis.gyroFiltered += (axis.plant.rate() - axis.gyroFiltered) * kCycle / kGyroLag;
        axis.rawGyro = axis.gyroFiltered + m_imu.gyroBias[i] + m_noise.gauss(m_imu.gyroNoise);
        axis.gyro = axis.rawGyro - m_imu.gyroCorrection[i];
        const double reading
            = m_gravity[i] * m_imu.accScaleError[i] + m_imu.accError[i] + m_noise.gauss(m_imu.accNoise);
        m_rawAcc[i] = reading;
        m_acc[i] = (reading - m_imu.accCorrection[i]) / m_imu.accScale[i];
    }
    if (!m_imuPresent)
        return;
    misjudge();
    updateEstimate();
}

// Complementary filter: the gyroscope leads, the accelerometer corrects roll and pitch. Yaw has no reference.
void Stabilizer::updateEstimate()
{
    if (std::exchange(m_believesAnew, false)) {
        m_axes[0].estimate = degrees(std::atan2(m_acc[0], m_acc[2]));
        m_axes[1].estimate = degrees(std::atan2(-m_acc[1], std::hypot(m_acc[0], m_acc[2])));
    }
    const double pull = 0.6 * 120.0 / std::max(10.0, m_gyroTrust) * kCycle;
    const double roll = radians(m_axes[0].estimate);
    const double pitch = radians(m_axes[1].estimate);
    // Gravity in the plane in which the axis turns, as it was measured: across and along what the estimates
    // expect. An axis that points up or down sees none of it and is not corrected.
    const double up = m_acc[0] * std::sin(roll) + m_acc[2] * std::cos(roll);
    const double side = m_acc[0] * std::cos(roll) - m_acc[2] * std::sin(roll);
    const double sign = std::copysign(1.0, std::cos(pitch));
    const std::array<std::array<double, 2>, 2> seen{{{side * sign, up * sign},
                                                     {-m_acc[1] * std::cos(pitch) - up * std::sin(pitch),
                                                      up * std::cos(pitch) - m_acc[1] * std::sin(pitch)}}};
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        AxisState &axis = m_axes[i];
        axis.estimate += axis.gyro * kCycle;
        if (i < seen.size()) {
            const auto &[across, along] = seen[i];
            axis.estimate += degrees(std::atan2(across, along)) * std::hypot(across, along) * pull;
        }
    }
}

// Vectors as the firmware sees them, in the axes it is configured for. Plant axes are right, forward, up for
// the accelerometer; rotation is positive to the left about forward, down about left, to the right about up.
void Stabilizer::misjudge()
{
    if (m_believed == kAsMounted)
        return;
    const auto turned = [this](const std::array<double, 3> &v) {
        std::array<double, 3> result{};
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < 3; ++column)
                result[row] += m_believed[row][column] * v[column];
        }
        return result;
    };
    const auto acc = turned({m_acc[1], -m_acc[0], m_acc[2]});
    m_acc = {-acc[1], acc[0], acc[2]};
    const auto gyro = turned({-m_axes[0].gyro, m_axes[1].gyro, -m_axes[2].gyro});
    m_axes[0].gyro = -gyro[0];
    m_axes[1].gyro = gyro[1];
    m_axes[2].gyro = -gyro[2];
}

void Stabilizer::control(AxisState &axis)
{
    const AxisGains &gains = axis.gains;
    const double error = axis.target - axis.estimate;
    const double scale = gains.gain / kReference;
    if (m_motorsOn && m_imuPresent) {
        axis.integral = std::clamp(axis.integral + kUnitI * gains.i * scale * error * kCycle, -kIntegralLimit,
                                   kIntegralLimit);
    }
    double output = kUnitP * gains.p * scale * error
        - kUnitD * gains.d * scale * axis.dFilter.process(axis.gyro) + axis.integral;
    for (Biquad &filter : axis.filters)
        output = filter.process(output);
    axis.command = output;
}
