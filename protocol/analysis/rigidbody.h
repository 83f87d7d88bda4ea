// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/vector3.h"

#include <array>

/// A body that turns freely about its centre of mass, by Euler's equations.
class RigidBody
{
public:
    /// @param inertia about its own axes, kg m²
    /// @param damping Nm per rad/s
    RigidBody(const Vector3 &inertia, const Vector3 &damping);

    /// Turned by hand, in degrees: yaw first, then pitch, then roll. It stands still there.
    void setAttitude(const Vector3 &degrees);
    void stop() { m_rates = {}; }
    /// Turned by something stronger, at this rate.
    void carry(const Vector3 &rates) { m_rates = rates; }
    /// Its rate about that axis, 0 to 2, is taken away.
    void block(std::size_t axis) { m_rates[axis] = 0; }
    /// Goes on for a short time. @param torque about its own axes, Nm
    void push(double seconds, const Vector3 &torque);
    void turn(double seconds);

    /// Degrees: roll, pitch, yaw.
    [[nodiscard]] Vector3 attitude() const;
    /// °/s about its own axes.
    [[nodiscard]] Vector3 rates() const { return m_rates; }
    /// A direction of the world as the body sees it.
    [[nodiscard]] Vector3 inBody(const Vector3 &world) const;

private:
    Vector3 m_inertia;
    Vector3 m_damping;
    std::array<double, 4> m_attitude{0, 0, 0, 1};  // quaternion: x, y, z, w
    Vector3 m_rates;
};
