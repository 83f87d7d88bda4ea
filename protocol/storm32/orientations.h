// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

namespace storm32 {

/// The 24 ways in which a sensor can be mounted (errata 10): which of its axes point forward, left and up.
struct Orientation
{
    const char *name;  ///< "z90°"
    int code;  ///< shown in brackets
    std::array<std::array<int, 3>, 3> axes;  ///< forward, left, up as vectors of the sensor
};
[[nodiscard]] std::span<const Orientation> orientations();
/// The orientation whose z points up and x forward, from unit vectors of the sensor; -1 if there is none.
[[nodiscard]] int findOrientation(const std::array<int, 3> &up, const std::array<int, 3> &forward);

}  // namespace storm32
