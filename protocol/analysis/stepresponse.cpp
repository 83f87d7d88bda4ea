// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/stepresponse.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t kFewest = 20;
constexpr double kJumpSeconds = 0.02;
constexpr double kLeft = 0.1;  // fraction of the step after which the target has left its level

// Seconds until this fraction of the step is first covered, interpolated between samples.
std::optional<double> reached(std::span<const float> response, double rate, double from, double way,
                              double share)
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

}  // namespace

Result<StepMetrics> stepMetrics(std::span<const float> response, double rate, double from, double to,
                                double band)
{
    if (response.size() < kFewest || !(rate > 0.0))
        return failure(ErrorCode::TooFewSamples, u"%1 samples are too few for a step"_s.arg(response.size()));
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
    const auto end = reached(response, rate, from, way, 0.9);
    if (start && end)
        metrics.riseSeconds = *end - *start;
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
    else if (lastOutside + tail < response.size())  // inside for the whole last tenth at least
        metrics.settlingSeconds = double(lastOutside + 1) / rate;
    return metrics;
}

StepRuns cutSteps(std::span<const float> target, std::span<const float> response, double rate, double low,
                  double high, double seconds)
{
    StepRuns runs;
    const std::size_t size = std::min(target.size(), response.size());
    const auto length = std::size_t(std::lround(seconds * rate));
    const double way = high - low;
    if (size == 0 || length == 0 || !(std::abs(way) > 0.0))
        return runs;
    bool up = std::abs(double(target[0]) - low) > std::abs(double(target[0]) - high);  // at the upper level
    for (std::size_t i = 0; i < size; ++i) {
        const double level = up ? high : low;
        if (std::abs(double(target[i]) - level) < kLeft * std::abs(way))
            continue;
        const double sign = up ? -1.0 : 1.0;
        up = !up;
        if (i + length > size)
            continue;
        const auto share = [&](std::span<const float> samples) {
            std::vector<float> run(length);
            for (std::size_t k = 0; k < length; ++k)
                run[k] = float(sign * (double(samples[i + k]) - level) / way);
            return run;
        };
        runs.target.push_back(share(target));
        runs.response.push_back(share(response));
        // The next step cannot start before the target has reached the other level.
        const double other = up ? high : low;
        while (i < size && std::abs(double(target[i]) - other) > kLeft * std::abs(way))
            ++i;
    }
    return runs;
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

Result<StepMeasurement> measureSteps(std::span<const float> target, std::span<const float> response,
                                     double rate, double seconds)
{
    if (target.empty())
        return failure(ErrorCode::TooFewSamples, u"no samples"_s);
    const auto [lowest, highest] = std::minmax_element(target.begin(), target.end());
    const double rest = double(target.front());
    const double other
        = double(*highest) - rest > rest - double(*lowest) ? double(*highest) : double(*lowest);
    StepMeasurement measurement;
    measurement.runs = cutSteps(target, response, rate, rest, other, seconds);
    if (measurement.runs.response.empty())
        return failure(ErrorCode::NotSeen, u"the target did not step: another control source may hold it"_s);
    measurement.mean = averageRuns(measurement.runs.response);
    auto metrics = stepMetrics(measurement.mean, rate, 0.0, 1.0);
    if (!metrics)
        return tl::unexpected(metrics.error());
    measurement.metrics = *metrics;
    return measurement;
}

Result<StepMeasurement> measureCommandSteps(std::span<const float> command, std::span<const float> response,
                                            double rate, double seconds)
{
    if (command.empty() || response.size() < command.size())
        return failure(ErrorCode::TooFewSamples, u"no samples"_s);
    const auto [low, high] = std::minmax_element(command.begin(), command.end());
    const float middle = (*low + *high) / 2;
    std::array<double, 2> sums{};
    std::array<std::size_t, 2> counts{};
    for (std::size_t from = 0; from < command.size();) {
        const bool isHigh = command[from] > middle;
        std::size_t to = from;
        while (to < command.size() && (command[to] > middle) == isHigh)
            ++to;
        for (std::size_t i = to - (to - from) / 3; i < to; ++i, ++counts[isHigh])
            sums[isHigh] += double(response[i]);
        from = to;
    }
    if (counts[0] == 0 || counts[1] == 0)
        return failure(ErrorCode::InvalidArgument, u"the command did not step"_s);
    const std::array<float, 2> levels{float(sums[0] / double(counts[0])), float(sums[1] / double(counts[1]))};
    std::vector<float> target;
    target.reserve(command.size());
    for (const float wanted : command)
        target.push_back(levels[wanted > middle]);
    return measureSteps(target, response, rate, seconds);
}

std::vector<StepEvent> findSteps(std::span<const float> target, double rate, double size, double rest)
{
    std::vector<StepEvent> steps;
    const auto jump = std::max<std::size_t>(1, std::size_t(std::lround(kJumpSeconds * rate)));
    const auto still = std::max<std::size_t>(2, std::size_t(std::lround(rest * rate)));
    for (std::size_t i = still; i + jump + still <= target.size();) {
        const double from = double(target[i - 1]);
        const double to = double(target[i + jump - 1]);
        // The index is that of the first sample that has moved, not of one shortly before the jump.
        if (std::abs(double(target[i]) - from) < size / 4 || std::abs(to - from) < size
            || !rests(target.subspan(i - still, still), size)
            || !rests(target.subspan(i + jump - 1, still), size)) {
            ++i;
            continue;
        }
        steps.push_back({i, from, to});
        i += jump + still - 1;
    }
    return steps;
}
