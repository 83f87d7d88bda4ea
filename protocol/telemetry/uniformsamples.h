// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"
#include "protocol/telemetry/telemetrystore.h"

/// Evenly spaced samples of one channel, as analysis wants them.
struct UniformSamples
{
    double start = 0;  ///< seconds since the store's origin
    double rate = 0;  ///< samples per second
    std::size_t filled = 0;  ///< samples that were lost on the way and drawn straight across
    bool polled = false;  ///< asked for one by one: the rate is what came, and no filter stands before it
    std::vector<float> values;

    [[nodiscard]] double end() const { return start + double(values.size()) / rate; }
};

/// The longest piece without a hole within a span of time. Holes of up to ten samples are bridged by a
/// straight line and counted; the stream that carries the channel at the end of the span is used. What a
/// board is asked for one by one comes about evenly: such samples are put on an even grid of their median
/// distance, on straight lines between them.
/// @param minus channel to subtract, -1 = none; it must come in the same rows. @param from,to seconds since
/// the store's origin. Errors: InvalidArgument (no samples there, or too few to tell their rate).
[[nodiscard]] Result<UniformSamples> uniformSamples(const TelemetryStore &store, int channel, int minus,
                                                    double from, double to);
