// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/tracesource.h"

void TraceSource::refresh()
{
    track.refresh();
    if (minus)
        minus->refresh();
}

std::vector<TraceSource> TraceSource::find(const TelemetryStore &store, int channel, int minus)
{
    std::vector<TraceSource> sources;
    if (minus < 0) {
        for (TrackView &track : store.tracks(channel))
            sources.push_back({std::move(track), {}});
        return sources;
    }
    const std::vector<TrackView> others = store.tracks(minus);
    for (TrackView &track : store.tracks(channel)) {
        for (const TrackView &other : others) {
            if (other.group() == track.group())
                sources.push_back({track, other});
        }
    }
    return sources;
}
