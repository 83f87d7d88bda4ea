// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/supervisor/slowswing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

constexpr double kSwingKept = 16.0;  // seconds: three periods of 0.2 Hz
constexpr double kSwingSpacing = 0.04;  // seconds between the points that are kept
constexpr std::size_t kHalves = 6;  // in a row
constexpr double kLongest = 2.6;  // seconds of a half period
constexpr double kShortest = 0.12;
constexpr double kAlikeHalves = 1.6;  // the longest of them, compared with the shortest
constexpr double kFullPeak = 0.8;  // of a sine of the least RMS
constexpr double kLastOfFirst = 0.75;  // what dies away is none
constexpr double kEachWider = 1.08;
constexpr double kAllWider = 1.8;

}  // namespace

void SlowSwing::clear()
{
    m_points.clear();
    m_count = 0;
}

void SlowSwing::add(double time, double rate)
{
    if (!m_points.empty() && (time < m_points.back().time || time - m_points.back().time > 0.5))
        clear();
    if (m_count == 0) {
        m_from = time;
        m_sum = 0;
    }
    m_sum += rate;
    ++m_count;
    if (!m_points.empty() && time - m_points.back().time < kSwingSpacing)
        return;
    m_points.push_back({(m_from + time) / 2, m_sum / m_count});
    m_count = 0;
    while (m_points.back().time - m_points.front().time > kSwingKept)
        m_points.pop_front();
}

double SlowSwing::recent(double seconds) const
{
    double sum = 0;
    double squares = 0;
    int count = 0;
    for (auto it = m_points.rbegin(); it != m_points.rend(); ++it) {
        if (m_points.back().time - it->time > seconds)
            break;
        sum += it->rate;
        squares += it->rate * it->rate;
        ++count;
    }
    return count > 1 ? std::sqrt(std::max(0.0, squares / count - sum * sum / count / count)) : 0.0;
}

std::optional<SlowSwing::Finding> SlowSwing::look(double minRms) const
{
    const double least = minRms / 2;
    // From the present backwards; a half period ends where the rate changes sign by more than noise.
    const double noise = 0.3 * least;
    std::vector<Half> halves;
    double side = 0;
    double peak = 0;
    double turned = 0;
    for (auto it = m_points.rbegin(); it != m_points.rend() && halves.size() < kHalves + 1; ++it) {
        if (std::abs(it->rate) < noise)
            continue;
        if (side != 0 && side * it->rate < 0) {
            halves.push_back({turned - it->time, peak});
            turned = it->time;
            peak = 0;
        } else if (side == 0) {
            turned = it->time;
        }
        side = it->rate;
        peak = std::max(peak, std::abs(it->rate));
    }
    // The first is not over yet.
    if (halves.size() < kHalves + 1 || halves.front().length > kLongest)
        return {};
    halves.erase(halves.begin());
    const auto byLength = [](const Half &a, const Half &b) { return a.length < b.length; };
    const auto [shortest, longest] = std::minmax_element(halves.begin(), halves.end(), byLength);
    if (shortest->length < kShortest || longest->length > kLongest
        || longest->length > kAlikeHalves * shortest->length)
        return {};
    double length = 0;
    double squares = 0;
    double lowest = halves.front().peak;
    bool isWider = halves.front().peak > kAllWider * halves.back().peak;
    for (std::size_t i = 0; i < halves.size(); ++i) {
        length += halves[i].length;
        squares += halves[i].peak * halves[i].peak / 2;
        lowest = std::min(lowest, halves[i].peak);
        isWider &= i == 0 || halves[i - 1].peak > kEachWider * halves[i].peak;
    }
    const auto count = double(halves.size());
    Finding finding{std::sqrt(squares / count), count / length / 2, false};
    if (lowest >= kFullPeak * std::numbers::sqrt2 * minRms
        && halves.front().peak >= kLastOfFirst * halves.back().peak)
        return finding;
    finding.rms = halves.front().peak / std::numbers::sqrt2;
    finding.isGrowing = true;
    return isWider && finding.rms >= least ? std::optional(finding) : std::nullopt;
}
