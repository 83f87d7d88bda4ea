// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/spectrum.h"

#include "protocol/analysis/segments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace Qt::StringLiterals;

namespace {

constexpr double kDynamicRange = 1e-7;  // of power: 70 dB

double powerDecibel(double power)
{
    return 10.0 * std::log10(std::max(power, 1e-30));
}

// Where the density falls below a level or a stronger line begins, searching outwards from the top; in bins,
// with a fraction.
double edge(const std::vector<double> &density, std::size_t top, int direction, double level)
{
    auto bin = std::ptrdiff_t(top);
    const auto last = std::ptrdiff_t(density.size()) - 1;
    while (bin + direction >= 0 && bin + direction <= last) {
        const double here = density[std::size_t(bin)];
        const double next = density[std::size_t(bin + direction)];
        if (next <= level)
            return double(bin) + direction * (here > next ? (here - level) / (here - next) : 0.0);
        if (next > density[top])
            return double(bin);
        bin += direction;
    }
    return double(bin);
}

}  // namespace

double Spectrum::toneRms(std::size_t bin) const
{
    return bin < density.size() ? std::sqrt(density[bin] * resolution * noiseBandwidth) : 0.0;
}

double Spectrum::bandRms(double from, double to) const
{
    double power = 0.0;
    for (std::size_t bin = 0; bin < density.size(); ++bin) {
        // Each bin covers half a step on either side of it.
        const double low = std::max(from, frequency(bin) - resolution / 2);
        const double high = std::min(to, frequency(bin) + resolution / 2);
        if (high > low)
            power += density[bin] * (high - low);
    }
    return std::sqrt(power);
}

Result<Spectrum> spectrum(std::span<const float> samples, double rate, const SpectrumOptions &options)
{
    auto cut = Segments::make(samples.size(), rate, options);
    if (!cut)
        return tl::unexpected(cut.error());
    Spectrum result{rate, cut->resolution(), cut->noiseBandwidth(), cut->count(), {}};
    result.density.assign(cut->bins(), 0.0);
    for (int i = 0; i < cut->count(); ++i) {
        const auto &bins = cut->transform(samples, i);
        for (std::size_t k = 0; k < result.density.size(); ++k)
            result.density[k] += std::norm(bins[k]);
    }
    for (std::size_t k = 0; k < result.density.size(); ++k)
        result.density[k] *= cut->powerScale(k);
    return result;
}

std::vector<SpectrumPeak> findPeaks(const Spectrum &spectrum, int maxCount, double lowest, double height)
{
    std::vector<SpectrumPeak> peaks;
    const std::vector<double> &density = spectrum.density;
    std::vector<double> around;
    // Anything far below the strongest line is leakage of that line through the window.
    const double minHeight
        = density.empty() ? 0.0 : *std::max_element(density.begin(), density.end()) * kDynamicRange;
    for (std::size_t bin = 2; bin + 2 < density.size(); ++bin) {
        if (spectrum.frequency(bin) < lowest || density[bin] < minHeight)
            continue;
        if (density[bin] < density[bin - 1] || density[bin] <= density[bin + 1]
            || density[bin] < density[bin - 2] || density[bin] < density[bin + 2])
            continue;
        // The surroundings: half an octave on either side, at least eight bins.
        const auto low = std::min(std::size_t(double(bin) / std::numbers::sqrt2), bin > 8 ? bin - 8 : 0);
        const auto high
            = std::min(density.size(), std::max(std::size_t(double(bin) * std::numbers::sqrt2), bin + 8) + 1);
        around.assign(density.begin() + std::ptrdiff_t(low), density.begin() + std::ptrdiff_t(high));
        const auto middle = around.begin() + std::ptrdiff_t(around.size() / 2);
        std::nth_element(around.begin(), middle, around.end());
        const double above = powerDecibel(density[bin]) - powerDecibel(*middle);
        if (above < height)
            continue;
        const double left = powerDecibel(density[bin - 1]);
        const double top = powerDecibel(density[bin]);
        const double right = powerDecibel(density[bin + 1]);
        const double curve = left - 2 * top + right;
        const double shift = curve < 0.0 ? std::clamp(0.5 * (left - right) / curve, -0.5, 0.5) : 0.0;
        const double from = edge(density, bin, -1, density[bin] / 2);
        const double to = edge(density, bin, 1, density[bin] / 2);
        SpectrumPeak peak;
        peak.frequency = (double(bin) + shift) * spectrum.resolution;
        peak.width = (to - from) * spectrum.resolution;
        // The power of the whole line, out to the edge of the window's main lobe.
        const double reach = std::max(to - from, 2.0 * spectrum.noiseBandwidth) * spectrum.resolution;
        peak.rms = spectrum.bandRms(peak.frequency - reach, peak.frequency + reach);
        peak.height = above;
        peaks.push_back(peak);
    }
    std::sort(peaks.begin(), peaks.end(),
              [](const SpectrumPeak &a, const SpectrumPeak &b) { return a.rms > b.rms; });
    if (peaks.size() > std::size_t(std::max(0, maxCount)))
        peaks.resize(std::size_t(std::max(0, maxCount)));
    return peaks;
}
