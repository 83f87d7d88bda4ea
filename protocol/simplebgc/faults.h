// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/abilities.h"

namespace simplebgc {

/// Faults that SYSTEM_ERROR and SYSTEM_SUB_ERROR report, with causes and remedies.
[[nodiscard]] std::vector<BoardFault> faultsOf(unsigned bits, unsigned detail);

}  // namespace simplebgc
