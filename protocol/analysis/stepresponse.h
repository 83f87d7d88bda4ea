// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

#include <optional>
#include <span>
#include <vector>

/// How a quantity moved from one value to another.
struct StepMetrics
{
    double from = 0;  ///< value before
    double final = 0;  ///< mean of the last tenth of the record
    double error = 0;  ///< wanted minus final
    std::optional<double> riseSeconds;  ///< from 10 % to 90 % of the way to the final value
    double overshoot = 0;  ///< beyond the final value, percent of the step
    double peakSeconds = 0;  ///< time of the peak
    std::optional<double> settlingSeconds;  ///< after which it stays within the band; empty: it never does
    double noise = 0;  ///< RMS of the last tenth around its mean
};

/// A place where a target jumps and then rests.
struct StepEvent
{
    std::size_t index = 0;  ///< first sample after the jump
    double from = 0;
    double to = 0;
};

/// Measures a step that begins with the first sample. Samples are evenly spaced, without NaN. @param rate
/// samples per second; @param from value before; @param to wanted value; @param band fraction of the step
/// that counts as settled. Errors: TooFewSamples (fewer than 20), InvalidArgument (no difference between from
/// and to).
[[nodiscard]] Result<StepMetrics> stepMetrics(std::span<const float> response, double rate, double from,
                                              double to, double band = 0.05);

/// The steps of a record, each from the moment the target leaves its level, scaled so that 0 is the old level
/// and 1 the new one, in either direction.
struct StepRuns
{
    std::vector<std::vector<float>> target;
    std::vector<std::vector<float>> response;
};

/// Cuts up a record in which a target alternates between two levels. @param seconds length of a run; steps
/// with less data after them are left out
[[nodiscard]] StepRuns cutSteps(std::span<const float> target, std::span<const float> response, double rate,
                                double low, double high, double seconds);

/// Several steps taken together.
struct StepMeasurement
{
    StepRuns runs;
    std::vector<float> mean;  ///< of the responses, sample by sample
    StepMetrics metrics;  ///< of the mean; the step is from 0 to 1
};

/// Finds the two levels of a target that alternates between them, cuts out the steps and measures their mean.
/// @param seconds length of a run. Errors: TooFewSamples (none), InvalidArgument (no step, or none
/// that the response follows).
[[nodiscard]] Result<StepMeasurement>
measureSteps(std::span<const float> target, std::span<const float> response, double rate, double seconds);

/// The same for a command in units of its own, which alternates between two levels: what of the response
/// belongs to each of them is the mean of the last third of the time for which it lasts.
[[nodiscard]] Result<StepMeasurement> measureCommandSteps(std::span<const float> command,
                                                          std::span<const float> response, double rate,
                                                          double seconds);

/// The mean of several runs, sample by sample, as long as the shortest.
[[nodiscard]] std::vector<float> averageRuns(const std::vector<std::vector<float>> &runs);

/// Jumps of at least `size` that take at most 20 ms, with the target at rest for `rest` seconds on both
/// sides.
[[nodiscard]] std::vector<StepEvent> findSteps(std::span<const float> target, double rate, double size,
                                               double rest);
