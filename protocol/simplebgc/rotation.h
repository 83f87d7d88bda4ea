// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/angles.h"
#include "protocol/base/axis.h"

#include <array>
#include <cmath>

/// Attitudes as quaternions. Roll turns about x, pitch about y, yaw about z, in the order yaw, pitch, roll:
/// an assumption, the errata name no axes (3.23).
namespace simplebgc {

using Orientation = std::array<double, 4>;  ///< w, x, y, z

/// The attitude at these angles, in degrees.
[[nodiscard]] inline Orientation attitudeAt(const std::array<double, kAxisCount> &angles)
{
    const auto half = [&angles](Axis axis) { return radians(angles[std::size_t(axis)]) / 2.0; };
    const double cr = std::cos(half(Axis::Roll)), sr = std::sin(half(Axis::Roll));
    const double cp = std::cos(half(Axis::Pitch)), sp = std::sin(half(Axis::Pitch));
    const double cy = std::cos(half(Axis::Yaw)), sy = std::sin(half(Axis::Yaw));
    return {cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy};
}

/// Its angles, in degrees.
[[nodiscard]] inline std::array<double, kAxisCount> anglesOf(const Orientation &q)
{
    const auto &[w, x, y, z] = q;
    const double up = std::fmin(1.0, std::fmax(-1.0, 2 * (w * y - z * x)));
    return {degrees(std::atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))), degrees(std::asin(up)),
            degrees(std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))};
}

/// First `a`, then `b` about the axes that `a` has turned.
[[nodiscard]] inline Orientation combined(const Orientation &a, const Orientation &b)
{
    return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

/// The turn that leads from one attitude to the other, the short way: degrees about its own x, y and z.
[[nodiscard]] inline std::array<double, kAxisCount> turnTo(const Orientation &from, const Orientation &to)
{
    const Orientation way = combined({from[0], -from[1], -from[2], -from[3]}, to);
    const double size = std::hypot(way[1], way[2], way[3]);
    if (size == 0.0)
        return {};
    const double angle = 2 * degrees(std::atan2(size, std::abs(way[0]))) * std::copysign(1.0, way[0]);
    return {way[1] / size * angle, way[2] / size * angle, way[3] / size * angle};
}

/// A turn by so many degrees about x, y and z at once.
[[nodiscard]] inline Orientation turnBy(const std::array<double, kAxisCount> &turn)
{
    const double angle = std::hypot(turn[0], turn[1], turn[2]);
    if (angle == 0.0)
        return {1, 0, 0, 0};
    const double share = std::sin(radians(angle) / 2) / angle;
    return {std::cos(radians(angle) / 2), turn[0] * share, turn[1] * share, turn[2] * share};
}

}  // namespace simplebgc
