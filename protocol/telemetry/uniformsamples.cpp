// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/uniformsamples.h"

#include "protocol/telemetry/tracesource.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t kBridged = 10;  // samples; a longer gap ends a piece
constexpr std::size_t kFewest = 16;  // fewest polled samples that give a rate

// An existing sample, with its time.
struct Sample
{
    double time = 0;
    float value = 0;
};

// The samples that arrived in a span of time. Rows that mark a gap are left out; the next sample's time shows
// its length.
std::vector<Sample> samplesWithin(const TraceSource &source, double from, double to)
{
    const TrackView &track = source.track;
    std::vector<Sample> samples;
    for (std::size_t row = track.rowAt(from); row < source.end() && track.time(row) <= to; ++row) {
        if (const float value = source.value(row); !std::isnan(value))
            samples.push_back({track.time(row), value});
    }
    return samples;
}

// The usual interval between polled samples; 0: there are too few.
double medianPeriod(const std::vector<Sample> &samples)
{
    if (samples.size() < kFewest)
        return 0.0;
    std::vector<double> distances;
    for (std::size_t i = 1; i < samples.size(); ++i)
        distances.push_back(samples[i].time - samples[i - 1].time);
    const auto middle = distances.begin() + std::ptrdiff_t(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
}

// Samples of a stream are already on the grid, except for lost ones.
void continueStream(UniformSamples &piece, const Sample &last, const Sample &sample, double period)
{
    const auto missing = std::size_t(std::max(0.0, std::round((sample.time - last.time) / period) - 1.0));
    for (std::size_t i = 1; i <= missing; ++i)
        piece.values.push_back(last.value + (sample.value - last.value) * float(i) / float(missing + 1));
    piece.filled += missing;
    piece.values.push_back(sample.value);
}

// Polled samples are off the grid.
void continuePolled(UniformSamples &piece, const Sample &last, const Sample &sample, double period)
{
    std::size_t added = 0;
    for (double time = piece.start + period * double(piece.values.size()); time <= sample.time;
         time += period, ++added) {
        const double share = (time - last.time) / (sample.time - last.time);
        piece.values.push_back(last.value + (sample.value - last.value) * float(share));
    }
    piece.filled += sample.time - last.time > 1.5 * period && added > 0 ? added - 1 : 0;
}

Result<UniformSamples> longestPiece(TraceSource &source, double from, double to)
{
    source.refresh();
    const std::vector<Sample> samples = samplesWithin(source, from, to);
    if (samples.empty())
        return failure(ErrorCode::TooFewSamples, u"no samples in this span of time"_s);
    const bool polled = !(source.track.period() > 0.0);
    const double period = polled ? medianPeriod(samples) : source.track.period();
    if (!(period > 0.0))
        return failure(ErrorCode::TooFewSamples, u"too few samples to tell their rate"_s);

    UniformSamples best;
    UniformSamples piece;
    const auto finish = [&best, &piece] {
        if (piece.values.size() > best.values.size())
            best = std::move(piece);
        piece = {};
    };
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (i > 0 && std::round((samples[i].time - samples[i - 1].time) / period) - 1.0 > double(kBridged))
            finish();
        if (piece.values.empty()) {
            piece.start = samples[i].time;
            piece.values.push_back(samples[i].value);
        } else if (polled) {
            continuePolled(piece, samples[i - 1], samples[i], period);
        } else {
            continueStream(piece, samples[i - 1], samples[i], period);
        }
    }
    finish();
    best.rate = 1.0 / period;
    best.polled = polled;
    return best;
}

}  // namespace

// A stream that has only just been arranged anew does not hide what the one before it has brought.
Result<UniformSamples> uniformSamples(const TelemetryStore &store, int channel, int minus, double from,
                                      double to)
{
    const auto length = [](const Result<UniformSamples> &piece) {
        return piece ? double(piece->values.size()) / piece->rate : 0.0;
    };
    Result<UniformSamples> best = failure(ErrorCode::TooFewSamples, u"no samples in this span of time"_s);
    std::vector<TraceSource> sources = TraceSource::find(store, channel, minus);
    for (auto source = sources.rbegin(); source != sources.rend(); ++source) {
        auto piece = longestPiece(*source, from, to);
        if (source == sources.rbegin() || length(piece) > length(best))
            best = std::move(piece);
    }
    return best;
}
