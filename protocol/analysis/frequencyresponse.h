// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/spectrum.h"

#include <complex>
#include <optional>

/// Ratio of output to input, frequency by frequency.
struct FrequencyResponse
{
    double resolution = 0;  ///< Hz from one bin to the next
    int segments = 0;  ///< averages; a coherence of one segment means nothing
    std::vector<std::complex<double>> gain;  ///< output / input at 0, resolution, 2*resolution ...
    std::vector<double> coherence;  ///< 0 noise ... 1 all of the output comes from the input

    [[nodiscard]] double frequency(std::size_t bin) const { return double(bin) * resolution; }
    [[nodiscard]] double gainDb(std::size_t bin) const;
    /// Phase in degrees, -180 to 180.
    [[nodiscard]] double phaseDeg(std::size_t bin) const;
};

/// How far a loop is from oscillating. Empty: the loop does not reach that point within the frequencies that
/// could be measured.
struct Margins
{
    std::optional<double> gainDb;  ///< how much more gain makes it oscillate (negative: how much less)
    std::optional<double> gainHz;  ///< where it would oscillate
    std::optional<double> phaseDeg;  ///< how much more lag makes it oscillate
    std::optional<double> phaseHz;  ///< the bandwidth of the loop
    double sensitivityDb = 0;  ///< greatest amplification of disturbances, max |1 / (1 + L)|
    double sensitivityHz = 0;
    int bins = 0;  ///< frequencies that were good enough to count
};

/// Response from evenly spaced samples of input and output (cross spectrum over input spectrum, Welch).
/// Samples beyond the shorter series are ignored. Errors: those of spectrum().
[[nodiscard]] Result<FrequencyResponse> frequencyResponse(std::span<const float> input,
                                                          std::span<const float> output, double rate,
                                                          const SpectrumOptions &options = {});

/// The open loop L behind a closed one T = L / (1 + L), with unit feedback.
[[nodiscard]] FrequencyResponse openLoop(const FrequencyResponse &closed);

/// Margins of an open loop. @param coherence bins below it do not count; @param from,to range in Hz
[[nodiscard]] Margins margins(const FrequencyResponse &openLoop, double coherence = 0.6, double from = 0.0,
                              double to = 1e9);
