// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/supervisor/oscillation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace {

constexpr double kKept = 1.3;  // seconds
constexpr double kSpacing = 0.0022;  // seconds between the points that are kept
// Fast oscillations are found in a short window, slow ones need a long one. Each holds three periods.
constexpr std::array<double, 3> kWindows{0.4, 0.75, 1.2};  // seconds
constexpr double kPeriods = 3.0;
constexpr std::size_t kFewest = 12;  // points in a window
constexpr double kHighest = 220.0;  // Hz
constexpr double kOfNyquist = 0.96;
constexpr double kNarrow = 0.55;  // share of the energy that lies in the narrow band
constexpr double kGoesOn = 0.75;  // RMS of the later half of the window, compared with the earlier one
constexpr double kEvenly = 0.4;  // RMS of its second and last third, compared with each other
constexpr double kBegun = 0.15;  // of its first third
constexpr double kSlowTimes = 2.0;  // a slow oscillation counts from twice the RMS on: hands shake slowly
constexpr double kVagueRate = 150.0;  // samples per second

double rmsOf(const std::vector<double> &values, std::size_t from, std::size_t to)
{
    double sum = 0;
    for (std::size_t i = from; i < to; ++i)
        sum += values[i] * values[i];
    return to > from ? std::sqrt(sum / double(to - from)) : 0.0;
}

}  // namespace

/// The last points, without their mean and trend.
struct OscillationDetector::Window
{
    double length = 0;
    std::vector<double> times;
    std::vector<double> rates;
    double rms = 0;
};

void OscillationDetector::clear()
{
    m_points.clear();
    m_sumCount = 0;
}

void OscillationDetector::add(double time, double rate)
{
    if (!m_points.empty() && (time < m_points.back().time || time - m_points.back().time > 0.5))
        clear();
    if (m_sumCount == 0) {
        m_sumFrom = time;
        m_sumTime = m_sumRate = 0;
    }
    m_sumTime += time;
    m_sumRate += rate;
    ++m_sumCount;
    // Half a sample of slack: the next one would be too late.
    const double step = (time - m_sumFrom) / std::max(1, m_sumCount - 1);
    if (m_sumCount > 1 && time - m_sumFrom + 1.5 * step < kSpacing)
        return;
    if (m_sumCount == 1 && !m_points.empty() && time - m_points.back().time < kSpacing / 2)
        return;
    m_points.push_back({m_sumTime / m_sumCount, m_sumRate / m_sumCount});
    m_sumCount = 0;
    while (m_points.back().time - m_points.front().time > kKept)
        m_points.pop_front();
}

OscillationDetector::Window OscillationDetector::window(double length) const
{
    Window window{length, {}, {}, 0};
    if (m_points.size() < kFewest || m_points.back().time - m_points.front().time < 0.9 * length)
        return window;
    const double end = m_points.back().time;
    auto first = m_points.end();
    while (first != m_points.begin() && end - std::prev(first)->time <= length)
        --first;
    double st = 0;
    double sr = 0;
    double stt = 0;
    double str = 0;
    const auto count = double(m_points.end() - first);
    for (auto it = first; it != m_points.end(); ++it) {
        const double t = it->time - end;
        st += t;
        sr += it->rate;
        stt += t * t;
        str += t * it->rate;
    }
    const double denominator = count * stt - st * st;
    const double slope = denominator > 0 ? (count * str - st * sr) / denominator : 0.0;
    const double mean = (sr - slope * st) / count;
    for (auto it = first; it != m_points.end(); ++it) {
        window.times.push_back(it->time - end);
        window.rates.push_back(it->rate - mean - slope * (it->time - end));
    }
    window.rms = rmsOf(window.rates, 0, window.rates.size());
    return window;
}

double OscillationDetector::roughness() const
{
    return window(kWindows.front()).rms;
}

std::optional<OscillationDetector::Finding> OscillationDetector::look(double minRms, double lowest) const
{
    for (const double length : kWindows) {
        const double slowest = kPeriods / length;
        const bool isShort = length == kWindows.front();
        if (!isShort && slowest < lowest)
            break;
        const auto finding
            = lookAt(window(length), std::max(slowest, lowest), isShort ? minRms : kSlowTimes * minRms);
        if (finding)
            return finding;
    }
    return {};
}

std::optional<OscillationDetector::Finding> OscillationDetector::lookAt(const Window &window, double lowest,
                                                                        double minRms)
{
    const std::size_t count = window.rates.size();
    if (count < kFewest || window.rms < minRms)
        return {};
    const std::size_t half = count / 2;
    if (rmsOf(window.rates, half, count) < kGoesOn * rmsOf(window.rates, 0, half))
        return {};  // it dies away
    // One bump, however smooth, is none.
    const double middle = rmsOf(window.rates, count / 3, 2 * count / 3);
    const double end = rmsOf(window.rates, 2 * count / 3, count);
    if (std::min(middle, end) < kEvenly * std::max(middle, end)
        || rmsOf(window.rates, 0, count / 3) < kBegun * std::max(middle, end))
        return {};
    // A discrete Fourier transform at the times at which the samples were taken, with a Hann window.
    const double span = window.times.back() - window.times.front();
    const double rate = double(count - 1) / span;
    const double highest = std::min(kHighest, kOfNyquist * rate / 2.0);
    const double step = 0.5 / window.length;
    std::vector<double> power;
    for (double hz = lowest - 2.0 * step; hz <= highest; hz += step) {
        std::complex<double> sum = 0;
        const double turn = 2.0 * std::numbers::pi;
        for (std::size_t i = 0; i < count; ++i) {
            const double place = (window.times[i] - window.times.front()) / span;
            const double hann = 0.5 - 0.5 * std::cos(turn * place);
            sum += window.rates[i] * hann * std::polar(1.0, -turn * hz * window.times[i]);
        }
        power.push_back(std::norm(sum));
    }
    if (power.size() < 5)
        return {};
    const auto peak = std::size_t(std::max_element(power.begin() + 2, power.end()) - power.begin());
    // What lies below belongs to hands and steering; it counts against the oscillation all the same, because
    // the window's RMS holds it.
    double energy = 0;
    for (const double value : power)
        energy += value;
    double inBand = 0;
    double moment = 0;
    for (std::size_t i = peak - std::min<std::size_t>(peak, 3); i < std::min(power.size(), peak + 4); ++i) {
        inBand += power[i];
        moment += power[i] * (lowest - 2.0 * step + double(i) * step);
    }
    const double hertz = moment / inBand;
    // Amplitude of a sine: the Hann window halves the sum over its samples.
    const double amplitude = std::sqrt(power[peak]) * 4.0 / double(count);
    const double rms = amplitude / std::numbers::sqrt2;
    const bool isNarrow = inBand >= kNarrow * energy && rms >= 0.6 * window.rms;
    if (!isNarrow || rms < minRms || hertz < lowest)
        return {};
    return Finding{rms, hertz, rate < kVagueRate};
}
