// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/telemetrystore.h"

/// Figures of one channel, or of the difference of two, over a span of time. NaN without samples.
struct SpanStatistics
{
    double mean = 0;
    double rms = 0;  ///< around zero
    double peak = 0;  ///< greatest absolute value
    double min = 0;
    double max = 0;
    std::size_t samples = 0;

    /// The same of what is left when the mean is taken away.
    [[nodiscard]] SpanStatistics aroundMean() const;
};

/// @param minus channel to subtract, -1 = none; times in seconds since the store's origin; @param isAngle in
/// degrees: whoever turns from 180 to -180 has hardly moved
[[nodiscard]] SpanStatistics spanStatistics(const TelemetryStore &store, int channel, int minus, double from,
                                            double to, bool isAngle = false);

/// Value of the newest sample at or before that time and not more than a gap older; NaN without one.
[[nodiscard]] double valueAt(const TelemetryStore &store, int channel, int minus, double time);
