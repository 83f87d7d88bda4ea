// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/steering.h"

namespace simplebgc {

/// The modes of CONTROL that this firmware has.
[[nodiscard]] std::vector<SteeringMode> steeringModes(int firmware);

}  // namespace simplebgc
