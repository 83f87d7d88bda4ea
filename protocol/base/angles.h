// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
