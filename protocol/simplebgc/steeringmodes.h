// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/steering.h"

namespace simplebgc {

/// The modes of CONTROL that this firmware has.
/// Not a mode of CONTROL: API_VIRT_CH_CONTROL, whose channels the board's inputs may be mapped to. Number of
/// the mode.
inline constexpr int kVirtualChannelMode = 256;

[[nodiscard]] std::vector<SteeringMode> steeringModes(int firmware);

}  // namespace simplebgc
