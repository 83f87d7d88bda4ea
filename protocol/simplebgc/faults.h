// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/abilities.h"

namespace simplebgc {

/// Faults behind SYSTEM_ERROR and SYSTEM_SUB_ERROR, with their causes and cures.
[[nodiscard]] std::vector<BoardFault> faultsOf(unsigned bits, unsigned detail);

}  // namespace simplebgc
