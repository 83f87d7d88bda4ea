// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/holdingquality.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace {

constexpr double kFade = 0.02;  // fraction of the span, at each end
constexpr double kPeriods = 2.0;  // of a band's lowest frequency that a span must contain

// The transform is only fast for lengths without large prime factors.
std::size_t handyLength(std::size_t samples)
{
    for (std::size_t length = samples & ~std::size_t(1); length >= 2; length -= 2) {
        std::size_t rest = length;
        for (const std::size_t prime : {2, 3, 5}) {
            while (rest % prime == 0)
                rest /= prime;
        }
        if (rest == 1)
            return length;
    }
    return 0;
}

// Removes mean and linear drift (least squares) and fades both ends.
std::vector<double> prepared(std::span<const float> error)
{
    const double count = double(error.size());
    const double middle = (count - 1) / 2;
    double mean = 0.0, slope = 0.0, spread = 0.0;
    for (std::size_t i = 0; i < error.size(); ++i)
        mean += double(error[i]) / count;
    for (std::size_t i = 0; i < error.size(); ++i) {
        slope += (double(i) - middle) * (double(error[i]) - mean);
        spread += (double(i) - middle) * (double(i) - middle);
    }
    slope /= spread;
    const double fade = std::max(1.0, kFade * count);
    std::vector<double> samples(error.size());
    for (std::size_t i = 0; i < error.size(); ++i) {
        const double inside = std::min(double(i), count - 1 - double(i)) / fade;
        const double weight = inside >= 1.0 ? 1.0 : 0.5 - 0.5 * std::cos(std::numbers::pi * inside);
        samples[i] = (double(error[i]) - mean - slope * (double(i) - middle)) * weight;
    }
    return samples;
}

}  // namespace

std::vector<BandQuality> holdingQuality(std::span<const float> error, double rate,
                                        std::span<const Band> bands)
{
    std::vector<BandQuality> result;
    const std::size_t length = handyLength(error.size());
    std::vector<std::complex<double>> spectrum;
    Eigen::FFT<double> fft;
    if (length >= 16 && rate > 0.0)
        fft.fwd(spectrum, prepared(error.last(length)));
    const double resolution = length ? rate / double(length) : 0.0;
    for (const Band &band : bands) {
        BandQuality quality{{band.from, std::min(band.to, rate / 2)}, false, 0.0, 0.0};
        quality.known = !spectrum.empty() && quality.band.to > quality.band.from
            && double(length) / rate >= kPeriods / band.from;
        if (quality.known) {
            std::vector<std::complex<double>> part(length);
            for (std::size_t k = 1; k <= length / 2; ++k) {
                const double hz = double(k) * resolution;
                if (hz < quality.band.from || hz >= quality.band.to)
                    continue;
                part[k] = spectrum[k];
                part[length - k] = std::conj(spectrum[k]);
            }
            std::vector<std::complex<double>> samples;
            fft.inv(samples, part);
            const auto fade = std::size_t(std::ceil(kFade * double(length)));
            double squares = 0.0;
            for (std::size_t i = fade; i < length - fade; ++i) {
                const double value = samples[i].real();
                squares += value * value;
                quality.peak = std::max(quality.peak, std::abs(value));
            }
            quality.rms = std::sqrt(squares / double(length - 2 * fade));
        }
        result.push_back(quality);
    }
    return result;
}
