// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/identity.h"
#include "protocol/device/actionspec.h"

#include <vector>

namespace simplebgc {

/// The actions that this board has.
[[nodiscard]] std::vector<ActionSpec> availableActions(const BoardIdentity &identity);

}  // namespace simplebgc
