// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/world/stabilizer.h"

namespace simplebgc {

/// Searches for gains on the running plant, as the firmware's automatic tuning does: moves the target, raises
/// D until the structure rings, steps back, raises P until it overshoots, steps back, then I; last it lowers
/// the low-pass filter as far as the target is still followed. All selected axes at once.
class AutoPidSearch
{
public:
    struct AxisResult
    {
        int p = 0;
        int i = 0;
        int d = 0;
        double trackingError = 0;  ///< rms, degrees
        int lpf = 0;  ///< Hz; 0: the low-pass filter is left as it is
    };

    /// @param gainVsStability 0 (stable) to 255 (strong), of each axis
    AutoPidSearch(std::array<bool, kAxisCount> axes, std::array<AxisResult, kAxisCount> start,
                  const std::array<int, kAxisCount> &gainVsStability);

    /// Offset that this cycle adds to an axis's target, in degrees.
    [[nodiscard]] double stimulus(Axis axis) const;
    /// One cycle's observation. True when an iteration has ended and results() hold new gains.
    bool observe(const Stabilizer &stabilizer);
    [[nodiscard]] const std::array<AxisResult, kAxisCount> &results() const { return m_results; }
    [[nodiscard]] bool isFinished() const;
    [[nodiscard]] int iteration() const { return m_iteration; }
    [[nodiscard]] bool isSelected(Axis axis) const { return m_selected[static_cast<std::size_t>(axis)]; }

private:
    enum class Phase { Settle, RaiseD, Calm, RaiseP, RaiseI, LowerFilter, Done };
    struct AxisState
    {
        Phase phase = Phase::Done;
        double squares = 0;
        double ringing = 0;
        double slow = 0;  // slow part of the gyro signal
        int samples = 0;
        double best = 0;
        double baseline = 0;  // ringing of the first, soft gains
        int goodFilter = 0;  // the lowest so far that did not harm, Hz
        bool isDoubted = false;
    };
    void decide(std::size_t axis);
    void lowerFilter(std::size_t axis, bool rings);
    static bool isInDoubt(AxisState &state, bool isWorse);

    std::array<bool, kAxisCount> m_selected;
    std::array<AxisResult, kAxisCount> m_results;
    std::array<AxisState, kAxisCount> m_states;
    std::array<double, kAxisCount> m_backOff{};
    int m_cycle = 0;
    int m_iteration = 0;
};

}  // namespace simplebgc
