// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

/// The gains of a PID controller as its filter shape, and as two sliders (STorM32 errata 9.1).
struct PidGains
{
    double kp = 0;
    double ki = 0;
    double kd = 0;
};

/// Properties of the loop that follow from the gains.
struct PidShape
{
    double frequency = 0;  ///< f0 = sqrt(Ki / Kd) / 2 pi, Hz; 0 without D
    double damping = 0;  ///< d = Kp / (2 sqrt(Kd Ki)); 0 without D or I
    double delayMs = 0;  ///< tau = 1570.8 / (1 + Ki), ms
};

[[nodiscard]] PidShape shapeOf(const PidGains &gains);
/// Kd = 0.8 D / 100, Ki = 2000 S / 100, Kp = sqrt(0.5 Kd Ki). @param damping D, 0 to 100 @param stability S,
/// 0 to 100
[[nodiscard]] PidGains gainsFor(double damping, double stability);
/// D and S that correspond to these gains: 125 Kd and Ki / 20, each 0 to 100.
[[nodiscard]] std::pair<double, double> slidersFor(const PidGains &gains);
