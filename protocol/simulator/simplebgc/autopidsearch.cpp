// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/simplebgc/autopidsearch.h"

#include <algorithm>
#include <cmath>

namespace simplebgc {

namespace {

constexpr int kCyclesPerIteration = 750;  // 0.6 s
constexpr int kHalfPeriod = 375;  // of the square stimulus
constexpr double kStimulus = 1.5;  // degrees
constexpr double kSlowPart = 0.03;  // per cycle: slower than about 6 Hz is motion, not ringing
constexpr double kRingingFactor = 2.2;  // relative to the ringing of the soft gains
constexpr double kRingingFloor = 6.0;  // deg/s rms
constexpr int kSoftP = 20;
constexpr int kSoftD = 15;
constexpr double kMaxPForD = 2.0;  // more P than this needs more damping than there is
constexpr int kLowestFilter = 10;  // Hz, of the variable (errata, LPF_FREQ)
constexpr double kFilterStep = 0.75;
constexpr double kFilterHarms = 1.1;  // times the tracking error with the filter as it was
constexpr int kLongest = 80;  // iterations

int grown(int value, double factor)
{
    return std::clamp(std::max(value + 1, int(std::lround(value * factor))), 1, 255);
}

int shrunk(int value, double factor)
{
    return std::clamp(int(std::lround(value * factor)), 1, 255);
}

}  // namespace

AutoPidSearch::AutoPidSearch(std::array<bool, kAxisCount> axes, std::array<AxisResult, kAxisCount> start,
                             const std::array<int, kAxisCount> &gainVsStability)
    : m_selected(axes)
    , m_results(start)
{
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        m_backOff[axis] = 0.45 + 0.35 * gainVsStability[axis] / 255.0;
        if (axes[axis])
            m_states[axis].phase = Phase::Settle;
    }
}

double AutoPidSearch::stimulus(Axis axis) const
{
    if (!isSelected(axis) || m_states[static_cast<std::size_t>(axis)].phase == Phase::Done)
        return 0.0;
    return m_cycle < kHalfPeriod ? kStimulus : -kStimulus;
}

bool AutoPidSearch::observe(const Stabilizer &stabilizer)
{
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        AxisState &state = m_states[axis];
        const double gyro = stabilizer.gyro(kAxes[axis]);
        state.slow += kSlowPart * (gyro - state.slow);
        const double error = stabilizer.target(kAxes[axis]) - stabilizer.estimate(kAxes[axis]);
        state.squares += error * error;
        // Ringing is measured after the response to the step.
        if (m_cycle % kHalfPeriod > kHalfPeriod / 2) {
            state.ringing += (gyro - state.slow) * (gyro - state.slow);
            ++state.samples;
        }
    }
    if (++m_cycle < kCyclesPerIteration)
        return false;
    m_cycle = 0;
    ++m_iteration;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        m_results[axis].trackingError = std::sqrt(m_states[axis].squares / kCyclesPerIteration);
        if (m_selected[axis])
            decide(axis);
        m_states[axis].squares = m_states[axis].ringing = 0;
        m_states[axis].samples = 0;
    }
    if (m_iteration >= kLongest) {
        for (AxisState &state : m_states)
            state.phase = Phase::Done;
    }
    return true;
}

void AutoPidSearch::decide(std::size_t axis)
{
    AxisState &state = m_states[axis];
    AxisResult &result = m_results[axis];
    const double ringing = std::sqrt(state.ringing / std::max(1, state.samples));
    const bool rings = ringing > std::max(kRingingFloor, kRingingFactor * state.baseline);
    switch (state.phase) {
    case Phase::Settle:
        state.baseline = ringing;
        state.phase = Phase::RaiseD;
        result.d = grown(result.d, 1.3);
        break;
    case Phase::RaiseD:
        if (!rings && result.d < 200) {
            result.d = grown(result.d, 1.3);
            break;
        }
        result.d = shrunk(result.d, m_backOff[axis]);
        state.phase = Phase::Calm;
        break;
    case Phase::Calm:
        // Earlier ringing must die down before it is measured again.
        state.phase = Phase::RaiseP;
        state.best = result.trackingError;
        break;
    case Phase::RaiseP:
        // Still ringing although P was hardly raised: D is too high.
        if (rings && result.p < kSoftP && result.d > kSoftD) {
            result.d = shrunk(result.d, 0.75);
            state.phase = Phase::Calm;
            break;
        }
        // Stop when it rings, or when more P makes the error clearly larger because of overshoot.
        if (!rings && isInDoubt(state, result.trackingError >= state.best * 1.15))
            break;
        if (!rings && result.p < kMaxPForD * result.d && result.trackingError < state.best * 1.15) {
            state.best = std::min(state.best, result.trackingError);
            result.p = grown(result.p, 1.3);
            break;
        }
        result.p = shrunk(result.p, m_backOff[axis] + 0.15);
        result.i = std::max(result.i, shrunk(result.p, 0.15));
        state.phase = Phase::RaiseI;
        state.best = result.trackingError * 1.2;
        break;
    case Phase::RaiseI:
        if (!rings && isInDoubt(state, result.trackingError >= state.best))
            break;
        if (!rings && result.i < result.p / 2 && result.trackingError < state.best) {
            state.best = result.trackingError;
            result.i = grown(result.i, 1.4);
            break;
        }
        result.i = shrunk(result.i, 0.75);
        state.phase = result.lpf > 0 ? Phase::LowerFilter : Phase::Done;
        break;
    case Phase::LowerFilter: lowerFilter(axis, rings); break;
    case Phase::Done: break;
    }
}

void AutoPidSearch::lowerFilter(std::size_t axis, bool rings)
{
    AxisState &state = m_states[axis];
    AxisResult &result = m_results[axis];
    if (state.goodFilter == 0) {  // the first look at the gains that were found
        state.goodFilter = result.lpf;
        state.best = result.trackingError * kFilterHarms;
    }
    const bool isWorse = rings || result.trackingError > state.best;
    if (isInDoubt(state, isWorse))
        return;
    if (!isWorse) {
        state.goodFilter = result.lpf;
        result.lpf = std::max(kLowestFilter, int(std::lround(result.lpf * kFilterStep)));
    }
    if (isWorse || result.lpf == state.goodFilter) {
        result.lpf = state.goodFilter;
        state.phase = Phase::Done;
    }
}

// One movement of the hand is no overshoot: what is worse is measured twice.
bool AutoPidSearch::isInDoubt(AxisState &state, bool isWorse)
{
    state.isDoubted = isWorse && !state.isDoubted;
    return state.isDoubted;
}

bool AutoPidSearch::isFinished() const
{
    return std::all_of(m_states.begin(), m_states.end(),
                       [](const AxisState &state) { return state.phase == Phase::Done; });
}

}  // namespace simplebgc
