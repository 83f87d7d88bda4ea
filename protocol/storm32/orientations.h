// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

namespace storm32 {

/// The 24 ways to mount a sensor (errata 10): which of its axes point forward, left and up.
struct Orientation
{
    const char *name;  ///< "z90°"
    int code;  ///< shown in brackets
    std::array<std::array<int, 3>, 3> axes;  ///< forward, left, up as vectors in the sensor's axes
};
[[nodiscard]] std::span<const Orientation> orientations();
/// The orientation whose z points up and whose x points forward, from unit vectors in the sensor's axes; -1
/// if there is none.
[[nodiscard]] int findOrientation(const std::array<int, 3> &up, const std::array<int, 3> &forward);

}  // namespace storm32
