// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

#include <QByteArray>

namespace bcflight {

/// Whether a drone could load this text: compiled with LuaJIT, which is what drones use, as text alone and
/// never run. What newer LuaJITs accept and the drone's 2.0.4 does not is refused as well (errata 7.2). That
/// it compiles does not prove that the drone starts with it. Errors: InvalidArgument with line and cause.
[[nodiscard]] Result<void> checkSyntax(const QByteArray &text);

}  // namespace bcflight
