// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/scriptmistake.h"

#include <vector>

namespace bcflight {

/// What speaks against a text that compiles, read and never run: mixing that cannot hold a drone level, calls
/// that act on its computer, and what never ends while it is loaded. Empty proves nothing.
[[nodiscard]] std::vector<ScriptMistake> findDoubts(const QByteArray &text);

}  // namespace bcflight
