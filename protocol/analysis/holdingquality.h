// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

/// A range of frequencies in Hz.
struct Band
{
    double from = 0;
    double to = 0;
};

/// The three kinds of error a picture shows: sway, wobble, jitter.
inline constexpr std::array<Band, 3> kHoldingBands{{{0.5, 5.0}, {5.0, 30.0}, {30.0, 300.0}}};

/// The error that remains in one band.
struct BandQuality
{
    Band band;  ///< the part of it that could be measured
    bool known = false;  ///< false: the rate is too low or the span too short; the figures are 0
    double rms = 0;  ///< unit of the samples
    double peak = 0;  ///< greatest absolute value
};

/// Splits an error into bands. The mean and a steady drift are removed first; the outermost 2 % of the span
/// are faded out and do not count. @param rate samples per second; NaN is not allowed.
[[nodiscard]] std::vector<BandQuality> holdingQuality(std::span<const float> error, double rate,
                                                      std::span<const Band> bands = kHoldingBands);
