// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/abilities.h"

namespace simplebgc {

/// The live-adjustable variables that a firmware has, by number (errata 5).
[[nodiscard]] std::span<const AdjustableSpec> adjustablesOf(int firmware);

}  // namespace simplebgc
