// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/rigidbody.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

namespace {

constexpr double kRadians = std::numbers::pi / 180;

Eigen::Vector3d eigenOf(const Vector3 &vector)
{
    return {vector.x, vector.y, vector.z};
}

Vector3 plain(const Eigen::Vector3d &vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

Eigen::Quaterniond quaternionOf(const std::array<double, 4> &parts)
{
    return Eigen::Quaterniond(parts.data());
}

}  // namespace

RigidBody::RigidBody(const Vector3 &inertia, const Vector3 &damping)
    : m_inertia(inertia)
    , m_damping(damping)
{
}

void RigidBody::setAttitude(const Vector3 &degrees)
{
    using Eigen::AngleAxisd;
    const Eigen::Quaterniond turned = AngleAxisd(degrees.z * kRadians, Eigen::Vector3d::UnitZ())
        * AngleAxisd(degrees.y * kRadians, Eigen::Vector3d::UnitY())
        * AngleAxisd(degrees.x * kRadians, Eigen::Vector3d::UnitX());
    Eigen::Map<Eigen::Quaterniond>(m_attitude.data()) = turned;
    stop();
}

void RigidBody::push(double seconds, const Vector3 &torque)
{
    const Eigen::Vector3d omega = eigenOf(m_rates) * kRadians;
    const Eigen::Vector3d inertia = eigenOf(m_inertia);
    const Eigen::Vector3d spin = inertia.cwiseProduct(omega);
    const Eigen::Vector3d acceleration
        = (eigenOf(torque) - eigenOf(m_damping).cwiseProduct(omega) - omega.cross(spin))
              .cwiseQuotient(inertia);
    m_rates += plain(acceleration) * (seconds / kRadians);
}

void RigidBody::turn(double seconds)
{
    const Eigen::Vector3d turned = eigenOf(m_rates) * kRadians * seconds;
    const double angle = turned.norm();
    if (angle <= 0)
        return;
    const Eigen::Quaterniond next
        = (quaternionOf(m_attitude) * Eigen::AngleAxisd(angle, turned / angle)).normalized();
    Eigen::Map<Eigen::Quaterniond>(m_attitude.data()) = next;
}

Vector3 RigidBody::attitude() const
{
    const Eigen::Matrix3d matrix = quaternionOf(m_attitude).toRotationMatrix();
    const double pitch = std::asin(std::clamp(-matrix(2, 0), -1.0, 1.0));
    return Vector3{std::atan2(matrix(2, 1), matrix(2, 2)), pitch, std::atan2(matrix(1, 0), matrix(0, 0))}
    / kRadians;
}

Vector3 RigidBody::inBody(const Vector3 &world) const
{
    return plain(quaternionOf(m_attitude).conjugate() * eigenOf(world));
}
