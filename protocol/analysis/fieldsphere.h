// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/vector3.h"

#include <array>
#include <bitset>
#include <optional>
#include <span>

/// What a magnetometer measures while it is turned to all sides: points on a sphere, which iron beside the
/// sensor shifts and stretches.
struct FieldSphere
{
    Vector3 centre;
    double radius = 0;
    double roughness = 0;  ///< rms distance of the points from the sphere, in radii
};

/// By least squares. Nothing where the points show no sphere: few, close together, or all in one plane.
[[nodiscard]] std::optional<FieldSphere> fitFieldSphere(std::span<const Vector3> points);
/// Longest by shortest half axis of the ellipsoid that the points lie on; nothing where they show none.
[[nodiscard]] std::optional<double> fieldStretch(std::span<const Vector3> points);

/// Along the axes, and halfway between two and three of them.
inline constexpr std::size_t kFieldDirections = 26;
using SeenDirections = std::bitset<kFieldDirections>;
/// Of length 1.
[[nodiscard]] const std::array<Vector3, kFieldDirections> &fieldDirections();
/// From the centre of the sphere.
[[nodiscard]] SeenDirections directionsSeen(std::span<const Vector3> points, const FieldSphere &sphere);
