// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/identity.h"

/// Which board it is, in the operator's language: its model with its number, or with its name.
[[nodiscard]] QString boardText(const BoardIdentity &identity);
