// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/scriptlanguage.h"

namespace storm32 {

/// The four scripts (errata 8) as pages and the command line see them.
[[nodiscard]] std::shared_ptr<const ScriptLanguage> scriptLanguage();

}  // namespace storm32
