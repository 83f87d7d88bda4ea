// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace storm32 {

/// What PARAM_VALUE calls a word of the stream, unused ones included; empty past the last. Layout 89 is taken
/// to call them as 95 does, but for the words it does not have.
[[nodiscard]] QString mavlinkName(int layout, int word);

}  // namespace storm32
