// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/device/uniformsamples.h"

#include "protocol/device/tracesource.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t kBridged = 10;   // samples; a longer hole ends a piece

} // namespace

Result<UniformSamples> uniformSamples(const TelemetryStore &store, int channel, int minus, double from, double to)
{
    std::vector<TraceSource> sources = TraceSource::find(store, channel, minus);
    const auto holds = [from, to](TraceSource &source) {
        source.refresh();
        const std::size_t row = source.track.rowAt(from);
        return row < source.end() && source.track.time(row) <= to;
    };
    const auto source = std::find_if(sources.rbegin(), sources.rend(), holds);
    if (source == sources.rend())
        return failure(ErrorCode::InvalidArgument, u"no samples in this span of time"_s);
    const TrackView &track = source->track;
    const double period = track.period();
    if (!(period > 0.0))
        return failure(ErrorCode::InvalidArgument, u"the channel is polled at no steady rate"_s);

    UniformSamples best;
    UniformSamples piece;
    double lastTime = 0.0;
    const auto finish = [&best, &piece] {
        if (piece.values.size() > best.values.size())
            best = std::move(piece);
        piece = {};
    };
    for (std::size_t row = track.rowAt(from); row < source->end() && track.time(row) <= to; ++row) {
        const float value = source->value(row);
        const double time = track.time(row);
        if (std::isnan(value))
            continue;   // marks a hole; how long it is tells the next sample's time
        if (!piece.values.empty()) {
            const auto missing = std::size_t(std::max(0.0, std::round((time - lastTime) / period) - 1.0));
            if (missing > kBridged) {
                finish();
            } else {
                const float before = piece.values.back();
                for (std::size_t i = 1; i <= missing; ++i)
                    piece.values.push_back(before + (value - before) * float(i) / float(missing + 1));
                piece.filled += missing;
            }
        }
        if (piece.values.empty())
            piece.start = time;
        piece.values.push_back(value);
        lastTime = time;
    }
    finish();
    best.rate = 1.0 / period;
    if (best.values.empty())
        return failure(ErrorCode::InvalidArgument, u"no samples in this span of time"_s);
    return best;
}
