// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/valuescale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace {

// The scale shrinks only after the traces have used less than this part of it for a while.
constexpr double kShrinkBelow = 0.4;
constexpr qint64 kShrinkAfterMs = 1500;
constexpr double kSmallest = 0.1;  // span
constexpr double kSmallestFixed = 1e-4;
constexpr double kAir = 1.08;
constexpr int kUsualSteps = 4;  // at least, where there is room
constexpr int kMostSteps = 6;

// The next round number of the series 1, 2, 5 that is not below the value.
double roundStep(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-9))));
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
        if (factor * power >= value * 0.999999)
            return factor * power;
    }
    return 10.0 * power;
}

struct RoundRange
{
    double low;
    double high;
    int steps;
};

// The tightest range of four to six round steps that holds the values with some air; of fewer where there is
// no room for four. @param minSpan span of the range
RoundRange roundRange(double low, double high, double minSpan, double air, int most)
{
    RoundRange best{low, high, std::min(most, kUsualSteps)};
    double tightest = std::numeric_limits<double>::infinity();
    for (int steps = most < kUsualSteps ? 1 : kUsualSteps; steps <= most; ++steps) {
        double step = roundStep(std::max((high - low) * air, 0.8 * minSpan) / steps);
        double bottom = std::floor(low / step) * step;
        if (steps == 1 && low < 0 && high > 0) {  // no multiple of a step lies outside both
            step = 2 * roundStep(std::max({-low, high, 0.4 * minSpan}) * air);
            bottom = -step / 2;
        }
        while (bottom + steps * step < high) {
            step = roundStep(step * 1.01);
            bottom = std::floor(low / step) * step;
        }
        if (steps * step < tightest * 0.999 && bottom + steps * step >= high) {
            tightest = steps * step;
            best = {bottom, bottom + steps * step, steps};
        }
    }
    return best;
}

}  // namespace

bool ValueScale::fit(double lowest, double highest)
{
    if (m_fixed)
        return false;
    const double span = m_high - m_low;
    const bool outside = lowest < m_low || highest > m_high;
    if (!outside && (highest - lowest > kShrinkBelow * span || span <= kSmallest)) {
        m_shrinkTimer.invalidate();
        return false;
    }
    if (!outside) {
        if (!m_shrinkTimer.isValid())
            m_shrinkTimer.start();
        if (m_shrinkTimer.elapsed() < kShrinkAfterMs)
            return false;
    }
    m_shrinkTimer.invalidate();
    // A nearly constant value is centred instead of touching an edge.
    const double room = std::max(0.0, (kSmallest / 2 - (highest - lowest)) / 2);
    const RoundRange range = roundRange(lowest - room, highest + room, kSmallest, kAir, m_most);
    if (range.low == m_low && range.high == m_high)
        return false;
    m_low = range.low;
    m_high = range.high;
    m_steps = range.steps;
    return true;
}

void ValueScale::fix(double low, double high)
{
    const RoundRange range = roundRange(low, high, kSmallestFixed, 1.0, m_most);
    m_fixed = true;
    m_low = range.low;
    m_high = range.high;
    m_steps = range.steps;
}

bool ValueScale::setMostSteps(int most)
{
    most = std::clamp(most, 1, kMostSteps);
    if (std::exchange(m_most, most) == most)
        return false;
    const RoundRange range = roundRange(m_low, m_high, kSmallestFixed, 1.0, m_most);
    m_low = range.low;
    m_high = range.high;
    m_steps = range.steps;
    return true;
}
