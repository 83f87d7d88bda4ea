// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/frequencyresponse.h"

#include "protocol/analysis/segments.h"
#include "protocol/base/angles.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kTiny = 1e-300;

double amplitudeDecibel(double ratio)
{
    return 20.0 * std::log10(std::max(ratio, kTiny));
}

}  // namespace

double FrequencyResponse::gainDb(std::size_t bin) const
{
    return amplitudeDecibel(std::abs(gain[bin]));
}

double FrequencyResponse::phaseDeg(std::size_t bin) const
{
    return degrees(std::arg(gain[bin]));
}

Result<FrequencyResponse> frequencyResponse(std::span<const float> input, std::span<const float> output,
                                            double rate, const SpectrumOptions &options)
{
    const std::size_t samples = std::min(input.size(), output.size());
    auto in = Segments::make(samples, rate, options);
    auto out = Segments::make(samples, rate, options);
    if (!in || !out)
        return tl::unexpected(in ? out.error() : in.error());
    const std::size_t bins = in->bins();
    std::vector<double> inPower(bins), outPower(bins);
    FrequencyResponse result{in->resolution(), in->count(), std::vector<std::complex<double>>(bins),
                             std::vector<double>(bins)};
    for (int i = 0; i < in->count(); ++i) {
        const auto &x = in->transform(input, i);
        const auto &y = out->transform(output, i);
        for (std::size_t k = 0; k < bins; ++k) {
            inPower[k] += std::norm(x[k]);
            outPower[k] += std::norm(y[k]);
            result.gain[k] += std::conj(x[k]) * y[k];
        }
    }
    for (std::size_t k = 0; k < bins; ++k) {
        const double both = inPower[k] * outPower[k];
        result.coherence[k] = both > kTiny ? std::min(1.0, std::norm(result.gain[k]) / both) : 0.0;
        result.gain[k] = inPower[k] > kTiny ? result.gain[k] / inPower[k] : 0.0;
    }
    return result;
}

FrequencyResponse openLoop(const FrequencyResponse &closed)
{
    FrequencyResponse open = closed;
    for (std::complex<double> &gain : open.gain) {
        const std::complex<double> rest = 1.0 - gain;
        gain = std::abs(rest) > 1e-9 ? gain / rest : std::complex<double>(1e9, 0.0);
    }
    return open;
}

Margins margins(const FrequencyResponse &openLoop, double coherence, double from, double to)
{
    Margins result;
    std::optional<std::size_t> before;
    double sensitivity = 0.0;
    for (std::size_t bin = 1; bin < openLoop.gain.size(); ++bin) {
        const double hz = openLoop.frequency(bin);
        if (hz < from || hz > to || openLoop.coherence[bin] < coherence)
            continue;
        ++result.bins;
        const std::complex<double> here = openLoop.gain[bin];
        const double s = 1.0 / std::max(std::abs(1.0 + here), kTiny);
        if (s > sensitivity) {
            sensitivity = s;
            result.sensitivityDb = amplitudeDecibel(s);
            result.sensitivityHz = hz;
        }
        // Crossings are only searched between neighbouring bins: nothing is known across a gap.
        if (before && *before + 1 == bin) {
            const std::complex<double> last = openLoop.gain[*before];
            const double lastHz = openLoop.frequency(*before);
            if ((last.imag() < 0.0) != (here.imag() < 0.0)) {
                const double share = last.imag() / (last.imag() - here.imag());
                const double real = last.real() + share * (here.real() - last.real());
                const double gain = real < 0.0 ? -amplitudeDecibel(-real) : 0.0;
                if (real < 0.0 && (!result.gainDb || std::abs(gain) < std::abs(*result.gainDb))) {
                    result.gainDb = gain;
                    result.gainHz = lastHz + share * (hz - lastHz);
                }
            }
            const double lastDb = amplitudeDecibel(std::abs(last));
            const double hereDb = amplitudeDecibel(std::abs(here));
            if ((lastDb < 0.0) != (hereDb < 0.0)) {
                const double share = lastDb / (lastDb - hereDb);
                const std::complex<double> crossing = last + share * (here - last);
                // The angle between the crossing and -1: the phase margin with its sign.
                const double phase = degrees(std::arg(-crossing));
                if (!result.phaseDeg || std::abs(phase) < std::abs(*result.phaseDeg)) {
                    result.phaseDeg = phase;
                    result.phaseHz = lastHz + share * (hz - lastHz);
                }
            }
        }
        before = bin;
    }
    return result;
}
