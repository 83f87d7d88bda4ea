// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/filterresponse.h"

#include "protocol/base/angles.h"

#include <cmath>
#include <numbers>

std::complex<double> notchResponse(const NotchShape &notch, double hz)
{
    if (notch.hz <= 0.0 || notch.width <= 0.0)
        return 1.0;
    const std::complex<double> s(0.0, hz / notch.hz);
    const double damping = notch.width / notch.hz;
    const double a = std::pow(10.0, -notch.depthDb / 40.0);
    return (s * s + s * damping * a + 1.0) / (s * s + s * damping / a + 1.0);
}

std::complex<double> lowPassResponse(double cornerHz, double hz)
{
    if (cornerHz <= 0.0)
        return 1.0;
    const std::complex<double> s(0.0, hz / cornerHz);
    return 1.0 / (s * s + s * std::numbers::sqrt2 + 1.0);
}

double lagDeg(std::complex<double> response)
{
    return -degrees(std::arg(response));
}
