// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/pidshape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

PidShape shapeOf(const PidGains &gains)
{
    PidShape shape;
    if (gains.kd > 0) {
        shape.frequency = std::sqrt(gains.ki / gains.kd) / (2.0 * std::numbers::pi);
        if (gains.ki > 0)
            shape.damping = gains.kp / (2.0 * std::sqrt(gains.kd * gains.ki));
    }
    shape.delayMs = 1570.8 / (1.0 + gains.ki);
    return shape;
}

PidGains gainsFor(double damping, double stability)
{
    PidGains gains;
    gains.kd = 0.8 * std::clamp(damping, 0.0, 100.0) / 100.0;
    gains.ki = 2000.0 * std::clamp(stability, 0.0, 100.0) / 100.0;
    gains.kp = std::sqrt(0.5 * gains.kd * gains.ki);
    return gains;
}

std::pair<double, double> slidersFor(const PidGains &gains)
{
    return {std::clamp(125.0 * gains.kd, 0.0, 100.0), std::clamp(gains.ki / 20.0, 0.0, 100.0)};
}
