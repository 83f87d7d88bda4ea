// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>

/// The range of a value axis: follows the traces with hysteresis and round steps, or stays fixed.
class ValueScale
{
public:
    [[nodiscard]] double low() const { return m_low; }
    [[nodiscard]] double high() const { return m_high; }
    /// Parts between the labels.
    [[nodiscard]] int steps() const { return m_steps; }

    /// Follows the visible values: grows at once, shrinks after a while. True if the range changed.
    bool fit(double lowest, double highest);
    /// Fixes this range, rounded outwards, until release().
    void fix(double low, double high);
    void release() { m_fixed = false; }
    /// At most so many parts, for labels that have room; at least one. True if the range changed.
    bool setMostSteps(int most);

private:
    double m_low = -1;
    double m_high = 1;
    int m_steps = 4;
    int m_most = 6;
    bool m_fixed = false;
    QElapsedTimer m_shrinkTimer;
};
