// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/world/cameraview.h"
#include "protocol/video/videotypes.h"

#include <cstdint>
#include <optional>

/// Draws what a simulated camera sees: sky and ground along the horizon, a grid of directions every 10°, a
/// clock, and the number of the frame as black and white squares that programs can read.
void drawScene(VideoPlanes &picture, const CameraView &view, std::uint32_t number);

/// The number in a picture that drawScene() drew, encoded and decoded since. Empty: its check sum is wrong,
/// so parts of it are of another frame. Numbers have 20 bits.
[[nodiscard]] std::optional<std::uint32_t> readNumber(const VideoPicture &picture);
