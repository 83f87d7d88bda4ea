// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/telemetrystore.h"

/// Seconds: samples further apart are not joined by a line, and none older than this speaks for a moment.
inline constexpr double kTraceGap = 0.6;

/// Where the samples of a trace are: one channel, or the difference of two from the same rows.
struct TraceSource
{
    TrackView track;
    std::optional<TrackView> minus;

    void refresh();
    /// One past the last row.
    [[nodiscard]] std::size_t end() const
    {
        return minus ? std::min(track.end(), minus->end()) : track.end();
    }
    [[nodiscard]] float value(std::size_t row) const
    {
        return minus ? track.value(row) - minus->value(row) : track.value(row);
    }
    /// Everything the store has of this trace, oldest first. @param minus channel to subtract, -1 = none
    static std::vector<TraceSource> find(const TelemetryStore &store, int channel, int minus);
};
