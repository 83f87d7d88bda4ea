// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/axis.h"

#include <array>
#include <random>

/// Deterministic noise from a seed.
class SimulatedNoise
{
public:
    explicit SimulatedNoise(unsigned seed)
        : m_engine(seed)
    {
    }
    double gauss(double sigma) { return sigma * m_normal(m_engine); }
    double uniform() { return m_uniform(m_engine); }
    bool chance(double probability) { return probability > 0.0 && uniform() < probability; }

private:
    std::mt19937 m_engine;
    std::normal_distribution<double> m_normal{0.0, 1.0};
    std::uniform_real_distribution<double> m_uniform{0.0, 1.0};
};

/// Mechanical properties of one axis. Accelerations in deg/s², as torque divided by inertia.
struct AxisMechanics
{
    double fullTorque = 4000.0;  ///< acceleration at full power and nominal voltage
    double viscous = 2.5;  ///< friction per deg/s between camera and frame
    double coulomb = 35.0;  ///< dry friction between camera and frame
    double imbalance = 60.0;  ///< gravity pulls the camera off level
    double cogging = 12.0;  ///< ripple of the motor's magnets
    double resonanceHz = 55.0;  ///< first mode of the structure
    double resonanceDamping = 0.03;
    double resonanceGain = 1.0;  ///< how strongly the motor excites it
    double stop = 150.0;  ///< mechanical end stop, degrees between frame and camera
    int poles = 14;
};

/// One axis: camera inertia behind a lagging motor, friction against a shaking frame, a resonant structure.
class AxisPlant
{
public:
    explicit AxisPlant(const AxisMechanics &mechanics)
        : m_mechanics(mechanics)
    {
    }

    /// @param torque -1..1 of full torque; @param frameAngle and frameRate of the frame about this axis, deg
    /// and deg/s
    void step(double seconds, double torque, double frameAngle, double frameRate);

    /// Attitude of the camera about this axis in degrees, including the structure's resonance.
    [[nodiscard]] double angle() const { return m_angle + m_bend; }
    [[nodiscard]] double rate() const { return m_rate + m_bendRate; }
    /// The same without the structure's resonance.
    [[nodiscard]] double trueAngle() const { return m_angle; }
    /// Angle between frame and camera.
    [[nodiscard]] double jointAngle() const { return m_angle - m_frameAngle; }
    [[nodiscard]] bool isAtStop() const { return m_atStop; }
    void setAngle(double degrees)
    {
        m_angle = degrees;
        m_rate = m_bend = m_bendRate = m_motor = 0.0;
    }
    /// A hand moves it: that is where it is, and how fast it turns.
    void setMotion(double degrees, double rate)
    {
        setAngle(degrees);
        m_rate = rate;
    }
    /// How far off balance it is mounted, relative to what the mechanics say.
    void setImbalance(double share) { m_imbalance = share; }
    /// What its motor can do at full power, as a share of fullTorque: less is a small motor for its camera.
    void setMotorStrength(double share) { m_motorStrength = share; }
    [[nodiscard]] double motorStrength() const { return m_motorStrength; }
    /// Warms or cools the motor for that time. @param power 0..1: its current grows with it, its heat with
    /// the square
    void heat(double seconds, double power);
    [[nodiscard]] double celsius() const { return m_celsius; }
    /// Something holds the camera fast to the frame.
    void setBlocked(bool blocked) { m_isBlocked = blocked; }
    [[nodiscard]] const AxisMechanics &mechanics() const { return m_mechanics; }

private:
    AxisMechanics m_mechanics;
    double m_angle = 0;
    double m_rate = 0;
    double m_bend = 0;
    double m_bendRate = 0;
    double m_motor = 0;  // present torque of the lagging motor
    double m_frameAngle = 0;
    bool m_atStop = false;
    bool m_isBlocked = false;
    double m_imbalance = 1;
    double m_motorStrength = 1;
    double m_celsius = 25;
};

/// The hand that holds the frame: slow sway and faster tremor about three axes.
class HandShake
{
public:
    explicit HandShake(unsigned seed)
        : m_noise(seed)
    {
    }

    void step(double seconds);
    /// 1 = a calm hand, 0 = a tripod, 5 = violent shaking.
    void setStrength(double strength) { m_strength = strength; }
    [[nodiscard]] double strength() const { return m_strength; }
    [[nodiscard]] double angle(Axis axis) const { return m_angle[static_cast<std::size_t>(axis)]; }
    [[nodiscard]] double rate(Axis axis) const { return m_rate[static_cast<std::size_t>(axis)]; }

private:
    SimulatedNoise m_noise;
    double m_strength = 1.0;
    std::array<double, kAxisCount> m_angle{};
    std::array<double, kAxisCount> m_rate{};
};

/// The mechanics of the simulated gimbal, different for roll, pitch and yaw.
[[nodiscard]] AxisMechanics simulatedMechanics(Axis axis);
