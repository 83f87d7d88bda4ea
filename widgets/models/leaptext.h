// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

struct ParameterChange;

/// How many times the value before a leap (isLeap()) is.
[[nodiscard]] QString leapText(const ParameterChange &change);
