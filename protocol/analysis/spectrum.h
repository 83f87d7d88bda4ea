// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/spectrumoptions.h"
#include "protocol/base/result.h"

#include <span>
#include <vector>

/// One-sided power spectral density, averaged over segments (Welch).
struct Spectrum
{
    double rate = 0;  ///< samples per second; nothing above half of it is known
    double resolution = 0;  ///< Hz from one bin to the next
    double noiseBandwidth = 1;  ///< of the window, in bins
    int segments = 0;  ///< averages
    std::vector<double> density;  ///< unit² per Hz at 0, resolution, 2*resolution ... rate/2

    [[nodiscard]] double frequency(std::size_t bin) const { return double(bin) * resolution; }
    /// RMS value that a tone in this bin would have, in the unit of the samples.
    [[nodiscard]] double toneRms(std::size_t bin) const;
    /// RMS value of everything between two frequencies (Hz), in the unit of the samples.
    [[nodiscard]] double bandRms(double from, double to) const;
};

/// A line that stands out from its surroundings.
struct SpectrumPeak
{
    double frequency = 0;  ///< Hz, interpolated between bins
    double rms = 0;  ///< unit of the samples
    double width = 0;  ///< Hz between the points 3 dB below the top
    double height = 0;  ///< dB above the surroundings
};

/// Spectrum of evenly spaced samples; the mean of each segment is removed. NaN is not allowed. @param rate
/// samples per second. Errors: InvalidArgument (length, overlap or rate out of range), TooFewSamples (fewer
/// than one segment).
[[nodiscard]] Result<Spectrum> spectrum(std::span<const float> samples, double rate,
                                        const SpectrumOptions &options = {});

/// The lines of a spectrum, strongest first. @param lowest frequency in Hz below which lines are ignored;
/// @param height dB above the median of the surrounding octave
[[nodiscard]] std::vector<SpectrumPeak> findPeaks(const Spectrum &spectrum, int maxCount = 5,
                                                  double lowest = 2.0, double height = 9.0);
