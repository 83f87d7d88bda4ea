// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/axis.h"

#include <QString>

#include <algorithm>
#include <cmath>

/// Raw and physical units of the serial API (errata 0).
namespace simplebgc {

inline constexpr double kDegreesPerCount = 360.0 / 16384.0;  ///< 14-bit angle
inline constexpr double kControlSpeedUnit = 0.1220740379;  ///< deg/s, CONTROL and GET_ANGLES
inline constexpr double kFineSpeedUnit = 0.001;  ///< deg/s, CONTROL with the high-resolution flag
inline constexpr double kGyroUnit = 0.06103701895;  ///< deg/s
inline constexpr double kAccUnit = 1.0 / 512.0;  ///< g

/// "roll", "pitch" or "yaw": the last part of a key.
inline QString axisName(std::size_t axis)
{
    return QLatin1String(axisKey(kAxes[axis]));
}

/// Nearest 16-bit count, clamped to the type's range.
inline int toCount16(double value, double unit)
{
    return static_cast<int>(std::clamp(std::round(value / unit), -32768.0, 32767.0));
}

/// A 14-bit angle of a command; it ends at two full turns, because what wraps turns the other way.
inline int angleToCount(double degrees)
{
    return toCount16(degrees, kDegreesPerCount);
}

/// A 14-bit angle as a board reports it: it wraps after two full turns.
inline int reportedAngle(double degrees)
{
    const auto count = static_cast<long long>(std::llround(degrees / kDegreesPerCount));
    return static_cast<int>(((count + 32768) % 65536 + 65536) % 65536 - 32768);
}

}  // namespace simplebgc
