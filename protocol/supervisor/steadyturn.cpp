// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/supervisor/steadyturn.h"

#include <cmath>
#include <utility>

namespace {

constexpr double kTurns = 10.0;  // deg/s: slower than that it stands

}  // namespace

void SteadyTurn::clear()
{
    m_turned = 0;
    m_angle = std::numeric_limits<double>::quiet_NaN();
}

double SteadyTurn::add(double angle, double rate)
{
    const double before = std::exchange(m_angle, angle);
    if (std::abs(rate) < kTurns || std::isnan(before))
        return m_turned = 0;
    if (m_turned * rate < 0)
        m_turned = 0;
    return m_turned += std::remainder(angle - before, 360.0);
}
