// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/spanstatistics.h"

#include "protocol/telemetry/tracesource.h"

#include <algorithm>
#include <cmath>
#include <limits>

SpanStatistics SpanStatistics::aroundMean() const
{
    SpanStatistics result = *this;
    if (samples == 0)
        return result;
    result.mean = 0;
    result.rms = std::sqrt(std::max(0.0, rms * rms - mean * mean));
    result.min = min - mean;
    result.max = max - mean;
    result.peak = std::max(-result.min, result.max);
    return result;
}

SpanStatistics spanStatistics(const TelemetryStore &store, int channel, int minus, double from, double to,
                              bool isAngle)
{
    SpanStatistics result;
    double last = 0;  // a deviation begins at its shorter way
    double sum = 0;
    double squares = 0;
    for (TraceSource &source : TraceSource::find(store, channel, minus)) {
        source.refresh();
        for (std::size_t row = source.track.rowAt(from); row < source.end(); ++row) {
            if (source.track.time(row) > to)
                break;
            double value = double(source.value(row));
            if (std::isnan(value))
                continue;
            if (isAngle && (minus >= 0 || result.samples > 0))
                value = last + std::remainder(value - last, 360.0);
            last = value;
            sum += value;
            squares += value * value;
            result.min = result.samples == 0 ? value : std::min(result.min, value);
            result.max = result.samples == 0 ? value : std::max(result.max, value);
            ++result.samples;
        }
    }
    if (result.samples == 0) {
        result.mean = result.rms = result.peak = result.min = result.max
            = std::numeric_limits<double>::quiet_NaN();
        return result;
    }
    result.peak = std::max(std::abs(result.min), std::abs(result.max));
    result.mean = sum / double(result.samples);
    result.rms = std::sqrt(squares / double(result.samples));
    return result;
}

double valueAt(const TelemetryStore &store, int channel, int minus, double time)
{
    double best = std::numeric_limits<double>::quiet_NaN();
    double bestTime = time - kTraceGap;
    for (TraceSource &source : TraceSource::find(store, channel, minus)) {
        source.refresh();
        std::size_t row = source.track.rowAt(time);
        if (row >= source.track.end() || source.track.time(row) > time) {
            if (row == source.track.begin())
                continue;
            --row;
        }
        if (source.track.time(row) >= bestTime && (!source.minus || row < source.minus->end())) {
            bestTime = source.track.time(row);
            best = double(source.value(row));
        }
    }
    return best;
}
