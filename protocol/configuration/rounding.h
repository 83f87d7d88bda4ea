// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/parameterspec.h"

/// What is to be told of a number that was asked for where the board can hold only one near it:
/// "pid.roll.p: 4.12 is the nearest to 4.123 that the board can hold". Empty where it holds that very number.
/// @param raw the one that it gets
[[nodiscard]] QString roundingText(const ParameterSpec &spec, double wanted, double raw);
