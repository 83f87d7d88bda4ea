// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

/// By how much an axis has turned in one direction without a stop.
class SteadyTurn
{
public:
    void clear();
    /// @param rate in deg/s, as the angles tell it
    /// @return degrees, with the sign of the direction
    double add(double angle, double rate);
    [[nodiscard]] double turned() const { return m_turned; }

private:
    double m_turned = 0;
    double m_angle = std::numeric_limits<double>::quiet_NaN();
};
