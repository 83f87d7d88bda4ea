// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/notchadvice.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kWorthwhile = 0.1;  // of the vibration that has to go away with the line
constexpr double kBroadest = 0.35;  // width of a resonance in parts of its frequency
constexpr double kCommanded = 0.5;  // of the line
constexpr double kMinPhase = 30.0;  // degrees of margin to be left
constexpr double kMinGain = 4.0;  // dB of margin to be left
constexpr double kCoherence = 0.6;
constexpr double kAround = 1.3;  // factor of frequency either side of where the loop amplifies
constexpr double kAmplifies = 3.0;  // dB

// The range in which the loop amplifies what disturbs it, around its crossover.
bool isOwn(double hz, const Margins &margins)
{
    const auto isNear = [hz](std::optional<double> place) {
        return place && hz > *place / kAround && hz < *place * kAround;
    };
    if (isNear(margins.phaseHz) || isNear(margins.gainHz))
        return true;
    if (margins.phaseHz && margins.gainHz && hz > std::min(*margins.phaseHz, *margins.gainHz)
        && hz < std::max(*margins.phaseHz, *margins.gainHz))
        return true;
    return margins.sensitivityDb > kAmplifies && isNear(margins.sensitivityHz);
}

Margins marginsOf(const MeasuredLoop &loop, const NotchShape *notch)
{
    FrequencyResponse open = loop.open;
    for (std::size_t bin = 0; notch && bin < open.gain.size(); ++bin)
        open.gain[bin] *= notchResponse(*notch, open.frequency(bin));
    return margins(open, kCoherence, loop.fromHz, loop.toHz);
}

bool isLessThanNeeded(std::optional<double> before, std::optional<double> after, double needed)
{
    return after && *after < needed && (!before || *after < *before - 0.5);
}

}  // namespace

NotchAdvice adviseNotch(const NotchEvidence &evidence)
{
    using Finding = NotchAdvice::Finding;
    NotchAdvice advice;
    const SpectrumPeak &peak = evidence.peak;
    const double share = evidence.wholeRms > 0 ? std::min(1.0, peak.rms / evidence.wholeRms) : 0.0;
    advice.gain = 1.0 - std::sqrt(1.0 - share * share);
    if (evidence.loop) {
        advice.before = marginsOf(*evidence.loop, nullptr);
        advice.after = marginsOf(*evidence.loop, &evidence.shape);
    }
    if (advice.before && isOwn(peak.frequency, *advice.before))
        advice.finding = Finding::OwnLoop;
    else if (evidence.commandedRms > kCommanded * peak.rms)
        advice.finding = Finding::Commanded;
    else if (peak.width > kBroadest * peak.frequency)
        advice.finding = Finding::TooBroad;
    else if (advice.gain < kWorthwhile)
        advice.finding = Finding::TooWeak;
    else if (advice.after
             && (isLessThanNeeded(advice.before->phaseDeg, advice.after->phaseDeg, kMinPhase)
                 || isLessThanNeeded(advice.before->gainDb, advice.after->gainDb, kMinGain)))
        advice.finding = Finding::CostsMargin;
    return advice;
}
