// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace simplebgc {

/// All that Device::firmwareRemarks() may say, for the catalogues.
[[nodiscard]] std::vector<const char *> firmwareTexts();

}  // namespace simplebgc
