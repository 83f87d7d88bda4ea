// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"
#include "protocol/telemetry/telemetrystore.h"

/// Evenly spaced samples of one channel, as analysis needs them.
struct UniformSamples
{
    double start = 0;  ///< seconds since the store's origin
    double rate = 0;  ///< samples per second
    std::size_t filled = 0;  ///< lost samples that were filled in by interpolation
    bool polled = false;  ///< polled: the rate is the one achieved, and there is no anti-aliasing filter
    std::vector<float> values;

    [[nodiscard]] double end() const { return start + double(values.size()) / rate; }
};

/// The longest piece without a gap within a span of time. Gaps of up to ten samples are interpolated linearly
/// and counted; it comes from one stream, the later one of two that carry as much. Polled samples arrive at
/// approximately even intervals: they are interpolated linearly onto an even grid of their median interval.
/// @param minus channel to subtract, -1 = none; it must come in the same rows. @param from,to seconds since
/// the store's origin. Errors: TooFewSamples (no samples there, or too few to tell their rate).
[[nodiscard]] Result<UniformSamples> uniformSamples(const TelemetryStore &store, int channel, int minus,
                                                    double from, double to);
