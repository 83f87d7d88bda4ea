// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/scriptmistake.h"

#include <vector>

namespace bcflight {

/// What speaks against a text that compiles, read and never run: mixing that cannot hold a drone level, calls
/// that act on its computer, what never ends while it is loaded, and what the text before has set that is
/// set no more: its link, its motors. Empty proves nothing.
/// @param before what the drone starts with now; empty: not known
[[nodiscard]] std::vector<ScriptMistake> findDoubts(const QByteArray &text, const QByteArray &before = {});

}  // namespace bcflight
