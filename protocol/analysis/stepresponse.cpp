// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/stepresponse.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t kFewest = 20;
constexpr double kJumpSeconds = 0.02;

// Seconds at which a way is first covered by that share, between samples.
std::optional<double> reached(std::span<const float> response, double rate, double from, double way, double share)
{
    double before = 0.0;
    for (std::size_t i = 0; i < response.size(); ++i) {
        const double covered = (double(response[i]) - from) / way;
        if (covered >= share) {
            const double part = i == 0 || covered <= before ? 1.0 : (share - before) / (covered - before);
            return i == 0 ? 0.0 : (double(i) - 1.0 + part) / rate;
        }
        before = covered;
    }
    return std::nullopt;
}

bool rests(std::span<const float> samples, double size)
{
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
    return low != samples.end() && double(*high - *low) < size / 4;
}

} // namespace

Result<StepMetrics> stepMetrics(std::span<const float> response, double rate, double from, double to, double band)
{
    if (response.size() < kFewest || !(rate > 0.0))
        return failure(ErrorCode::InvalidArgument, u"%1 samples are too few for a step"_s.arg(response.size()));
    const std::size_t tail = std::max<std::size_t>(2, response.size() / 10);
    double mean = 0.0;
    for (const float value : response.last(tail))
        mean += double(value) / double(tail);
    double squares = 0.0;
    for (const float value : response.last(tail))
        squares += (double(value) - mean) * (double(value) - mean) / double(tail);

    StepMetrics metrics;
    metrics.from = from;
    metrics.final = mean;
    metrics.error = to - mean;
    metrics.noise = std::sqrt(squares);
    const double way = mean - from;
    if (!(std::abs(way) > 0.0) || !std::isfinite(way) || std::abs(way) < 3.0 * metrics.noise)
        return failure(ErrorCode::InvalidArgument, u"the samples end where they began: no step to measure"_s);

    const auto start = reached(response, rate, from, way, 0.1);
    const auto most = reached(response, rate, from, way, 0.9);
    if (start && most)
        metrics.riseSeconds = *most - *start;
    double furthest = 0.0;
    std::size_t lastOutside = 0;
    bool outside = false;
    for (std::size_t i = 0; i < response.size(); ++i) {
        const double covered = (double(response[i]) - from) / way;
        if (covered > furthest) {
            furthest = covered;
            metrics.peakSeconds = double(i) / rate;
        }
        if (std::abs(covered - 1.0) > band) {
            lastOutside = i;
            outside = true;
        }
    }
    metrics.overshoot = std::max(0.0, (furthest - 1.0) * 100.0);
    if (!outside)
        metrics.settlingSeconds = 0.0;
    else if (lastOutside + tail < response.size())   // inside for the whole last tenth at least
        metrics.settlingSeconds = double(lastOutside + 1) / rate;
    return metrics;
}

std::vector<float> averageRuns(const std::vector<std::vector<float>> &runs)
{
    if (runs.empty())
        return {};
    std::size_t length = runs.front().size();
    for (const auto &run : runs)
        length = std::min(length, run.size());
    std::vector<float> mean(length);
    for (const auto &run : runs) {
        for (std::size_t i = 0; i < length; ++i)
            mean[i] += run[i] / float(runs.size());
    }
    return mean;
}

std::vector<StepEvent> findSteps(std::span<const float> target, double rate, double size, double rest)
{
    std::vector<StepEvent> steps;
    const auto jump = std::max<std::size_t>(1, std::size_t(std::lround(kJumpSeconds * rate)));
    const auto still = std::max<std::size_t>(2, std::size_t(std::lround(rest * rate)));
    for (std::size_t i = still; i + jump + still <= target.size();) {
        const double from = double(target[i - 1]);
        const double to = double(target[i + jump - 1]);
        // The first sample that has moved, not one that lies shortly before the jump.
        if (std::abs(double(target[i]) - from) < size / 4 || std::abs(to - from) < size
            || !rests(target.subspan(i - still, still), size) || !rests(target.subspan(i + jump - 1, still), size)) {
            ++i;
            continue;
        }
        steps.push_back({i, from, to});
        i += jump + still - 1;
    }
    return steps;
}
