// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

inline constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

constexpr double degrees(double radians)
{
    return radians * 180.0 / std::numbers::pi;
}

constexpr double radians(double degrees)
{
    return degrees * std::numbers::pi / 180.0;
}

/// Degrees between two directions, 0 to 180.
inline double turnBetween(double a, double b)
{
    return std::abs(std::remainder(a - b, 360.0));
}
