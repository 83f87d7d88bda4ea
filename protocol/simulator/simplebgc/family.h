// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/world/simulatedfamily.h"

namespace simplebgc {

/// The simulated SimpleBGC boards.
[[nodiscard]] SimulatedFamily simulatedFamily();

}  // namespace simplebgc
