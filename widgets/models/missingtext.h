// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

/// Names parts of a configuration in the operator's language, each block once: "PARAMS_EXT2 of all profiles,
/// profile names". Empty if there are none.
[[nodiscard]] QString missingText(const Configuration &configuration, const std::vector<MissingPart> &parts);
