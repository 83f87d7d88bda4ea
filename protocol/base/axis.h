// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

/// The axes of a gimbal, in the order used by the manufacturers' documents.
enum class Axis : std::uint8_t { Roll, Pitch, Yaw, None };

inline constexpr std::array kAxes{Axis::Roll, Axis::Pitch, Axis::Yaw};
inline constexpr int kAxisCount = 3;

/// "roll", "pitch", "yaw": the form used in keys, files and on the command line.
constexpr const char *axisKey(Axis axis)
{
    constexpr std::array<const char *, 4> keys{"roll", "pitch", "yaw", ""};
    return keys[static_cast<std::size_t>(axis)];
}
