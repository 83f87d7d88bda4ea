// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/world/simulatedfamily.h"

namespace bcflight {

/// The row of this family in the table of simulated families.
[[nodiscard]] SimulatedFamily simulatedFamily();

}  // namespace bcflight
