// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

/// From one value to so many times it is a leap: gains of a machine that flies have a range of which they are
/// a thousandth, so that their range keeps no slip of a digit out.
constexpr double kLeap = 3;

/// A value of the risk class, a fraction that only grows from 0, becomes more than kLeap times what it was.
[[nodiscard]] bool isLeap(const ParameterSpec &spec, double from, double to);
/// Those of the changes that are.
[[nodiscard]] std::vector<ParameterChange> leapsAmong(const std::vector<ParameterChange> &changes);
/// How many times the value before; empty: that was 0.
[[nodiscard]] std::optional<double> timesAsMuch(double from, double to);

/// Values of the risk class stand in such a text of the board.
[[nodiscard]] bool isOfRiskClass(const ParameterSet &parameters, const BlockSpec &block);
