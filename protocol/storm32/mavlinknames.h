// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace storm32 {

/// Name of a word of the stream in PARAM_VALUE, unused ones included; empty past the last. Layout 89 is
/// assumed to use the names of 95, except for the words it does not have.
[[nodiscard]] QString mavlinkName(int layout, int word);

}  // namespace storm32
