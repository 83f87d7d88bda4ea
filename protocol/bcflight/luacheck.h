// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/scriptlanguage.h"

namespace bcflight {

/// What keeps a drone from loading this text: it is compiled with LuaJIT, which is what drones use, as text
/// alone and never run. What newer LuaJITs accept and the drone's 2.0.4 does not is a mistake as well (errata
/// 7.2). Empty: it compiles, which does not prove that the drone starts with it.
[[nodiscard]] std::optional<ScriptMistake> findMistake(const QByteArray &text);

/// The same as an error. Errors: InvalidArgument with the cause, the line and the place.
[[nodiscard]] Result<void> checkSyntax(const QByteArray &text);

}  // namespace bcflight
