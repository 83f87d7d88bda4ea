// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/tracesource.h"

#include <map>

/// Statistics of one trace over a moving span of time. Partial sums are kept, so that ten minutes cost no
/// more than the newest second.
class SpanMeter
{
public:
    struct Figures
    {
        std::size_t samples = 0;
        double mean = 0;
        double rms = 0;  ///< around zero
        double low = 0;
        double high = 0;
        double rate = 0;  ///< samples per second
    };

    /// @param minus channel to subtract, -1 = none
    SpanMeter(std::shared_ptr<const TelemetryStore> store, int channel, int minus);
    /// Times in seconds since the store's origin. Samples that were lost do not count.
    [[nodiscard]] Figures measure(double from, double to);

private:
    struct Sum
    {
        std::size_t samples = 0;
        double sum = 0;
        double squares = 0;
        float low = std::numeric_limits<float>::infinity();
        float high = -std::numeric_limits<float>::infinity();
        void add(float value);
        void add(const Sum &other);
    };
    static Sum sumOf(const TraceSource &source, std::size_t first, std::size_t last);

    std::shared_ptr<const TelemetryStore> m_store;
    int m_channel;
    int m_minus;
    int m_generation = -1;
    std::vector<TraceSource> m_sources;
    std::map<std::pair<std::size_t, std::size_t>, Sum> m_known;  // by source and complete chunk of rows
};
