// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/rigidbody.h"
#include "protocol/base/vector3.h"
#include "protocol/simulator/world/plant.h"

#include <array>
#include <optional>
#include <vector>

namespace bcflight {

/// How the motors take part: roll, pitch, yaw, thrust, as in the configuration text.
using Mix = std::vector<std::array<double, 4>>;

/// A quadcopter of 250 mm as a rigid body: motors that lag, propellers whose thrust goes with the square of
/// their speed, a battery that sags, sensors with noise, zeros and the propellers' vibration. It does not fly
/// away: it stands on the ground, or turns freely about its centre in a test stand.
class Quadcopter
{
public:
    static constexpr int kCells = 4;
    /// Where it is held.
    enum class Place : std::uint8_t { Ground, Stand };

    Quadcopter(unsigned seed, Mix mix);

    /// @param outputs what the controller commands, 0 to 1; beyond counts as the nearest
    void step(double seconds, const std::vector<double> &outputs);
    void setPlace(Place place) { m_place = place; }
    [[nodiscard]] Place place() const { return m_place; }
    /// Turns it by hand, degrees; in the stand it goes on from there.
    void setAttitude(double roll, double pitch, double yaw);
    /// A hand takes it there within a second and holds it, stronger than its propellers; nothing: lets go.
    void setHand(const std::optional<Vector3> &attitude) { m_hand = attitude; }
    /// A volt meter at the battery; 0: what the charge gives.
    void setBattery(double volts) { m_fixedVoltage = volts; }
    void setBlocked(int axis) { m_blocked = axis; }
    /// Strength of the gusts on the stand; 0: still air.
    void setGusts(double strength) { m_gusts = strength; }

    /// What the sensors measure now: °/s, m/s², and microtesla, about and along x (roll), y (pitch), z (yaw).
    [[nodiscard]] Vector3 gyro() const { return m_gyro; }
    [[nodiscard]] Vector3 acceleration() const { return m_acceleration; }
    [[nodiscard]] Vector3 field() const { return m_field; }
    /// True attitude in degrees: roll, pitch, yaw.
    [[nodiscard]] Vector3 attitude() const { return m_body.attitude(); }
    [[nodiscard]] Vector3 rates() const { return m_body.rates(); }

    [[nodiscard]] double voltage() const { return m_voltage; }
    [[nodiscard]] double current() const { return m_current; }
    [[nodiscard]] double charge() const { return m_charge; }  ///< drawn, mAh
    /// Speeds of the propellers as shares of full speed.
    [[nodiscard]] const std::vector<double> &speeds() const { return m_speeds; }

private:
    void feelMotors(double seconds, const std::vector<double> &outputs);
    void turn(double seconds);
    void sense(double seconds);

    SimulatedNoise m_noise;
    RigidBody m_body;
    Mix m_mix;
    Place m_place = Place::Stand;
    std::optional<Vector3> m_hand;
    Vector3 m_zero;  // of the gyroscope, °/s
    Vector3 m_gust;
    Vector3 m_gyro;
    Vector3 m_acceleration;
    Vector3 m_field;
    std::vector<double> m_speeds;
    std::vector<double> m_thrusts;  // N
    std::vector<double> m_phases;
    double m_voltage = 4.2 * kCells;
    double m_fixedVoltage = 0;
    double m_current = 0;
    double m_charge = 0;
    double m_gusts = 0;
    int m_blocked = 0;
};

}  // namespace bcflight
