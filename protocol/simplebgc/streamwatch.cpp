// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/streamwatch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace simplebgc {

namespace {

constexpr double kStampWrap = 65536.0;  // milliseconds
constexpr double kStampStep = 1.0;  // milliseconds
constexpr double kLongestStep = 100.0;  // milliseconds, or so many periods, that a stamp is believed at once
constexpr double kStepPeriods = 4.0;
constexpr int kLearning = 50;  // frames
constexpr double kMeanWeight = 0.06;
constexpr double kRestart = -50.0;  // milliseconds behind: the board restarted its count
constexpr double kSilence = 0.1;  // seconds without a byte: nothing was lost, nothing was sent
constexpr double kBlock = 1.0;  // seconds over which frames without a clock are observed together
constexpr int kFramesPerBlock = 8;  // at least
constexpr double kDrift = 0.2;  // share of a slow change that is put down to drift of the two clocks

// Milliseconds from one stamp to the next.
double stepBetween(double from, double to)
{
    const double step = to - from;
    return step < -kStampWrap / 2 ? step + kStampWrap : step;
}

}  // namespace

bool StreamWatch::isDoubtful(double stamp)
{
    const auto follows = [&](double before) {
        const double step = stepBetween(before, stamp);
        return step >= 0 && step <= std::max(kLongestStep, kStepPeriods * m_period * 1000.0);
    };
    if (m_seen == 0 || follows(m_lastStamp) || (m_doubted && follows(*m_doubted))) {
        m_doubted.reset();
        return false;
    }
    m_doubted = stamp;
    return true;
}

StreamWatch::Finding StreamWatch::judge(int missing, double silence) const
{
    const double gap = missing * m_period;
    if (missing > 0 && gap >= kSilence && silence >= 0.8 * gap)
        return {0, gap};
    return {std::max(0, missing), 0};
}

// Compares the board's millisecond stamp with the counted time: the amount by which it is ahead was lost on
// the way. A whole millisecond is longer than the shortest period, so a single lost frame only shows in the
// mean over several frames; a longer gap shows at once.
StreamWatch::Finding StreamWatch::stamped(double stamp, double silence)
{
    const double period = m_period * 1000.0;
    const double step = m_seen == 0 ? 0.0 : stepBetween(m_lastStamp, stamp);
    m_lastStamp = stamp;
    m_board += step;
    m_counted += m_seen == 0 ? 0.0 : period;
    const double ahead = m_board - m_counted - m_base;
    ++m_seen;
    if (ahead < kRestart) {
        m_counted = m_board - m_base;
        m_mean = 0.0;
        return {};
    }
    int missing = 0;
    if (ahead > kStampStep + 1.5 * period) {
        missing = int(std::lround(ahead / period));
    } else if (m_seen <= kLearning) {
        m_base += ahead / m_seen;  // the phase between stamps and frames
        return {};
    } else {
        m_mean += kMeanWeight * (ahead - m_mean);
        if (m_mean > 0.6 * period)
            missing = 1;
        else if (m_mean < -0.6 * period)
            missing = -1;  // one frame too many was counted
    }
    m_counted += missing * period;
    m_mean -= missing * period;
    if (missing > 1)
        m_mean = 0.0;
    const Finding finding = judge(missing, silence);
    if (finding.silence > 0) {  // the number of frames in it is only known to about one: start over
        m_board = m_counted = m_base = m_mean = 0.0;
        m_seen = 1;
    }
    return finding;
}

StreamWatch::Finding StreamWatch::unstamped(double arrival, double silence)
{
    if (m_seen++ == 0) {
        m_first = arrival;
        m_expected = 0;
        m_minLate = 0;
        m_blockEnds = std::max(kBlock, kFramesPerBlock * m_period);
        return {};
    }
    m_expected += m_period;
    const double late = arrival - m_first - m_expected;
    m_minLate = std::min(m_minLate, late);
    m_maxSilence = std::max(m_maxSilence, silence);
    if (arrival - m_first < m_blockEnds)
        return {};
    // A busy reader hands over frames late, but the last of them on time: the least late one counts.
    Finding finding;
    if (!m_expectedLate) {
        m_expectedLate = m_minLate;
    } else {
        const double grown = m_minLate - *m_expectedLate;
        const int missing = int(std::lround(grown / m_period));
        if (missing > 0 && grown > 0.6 * m_period) {
            m_expected += missing * m_period;
            m_expectedLate = m_minLate - missing * m_period;
            finding = judge(missing, std::max(m_maxSilence, m_silenceBefore));
        } else {
            m_expectedLate = grown < 0 ? m_minLate : *m_expectedLate + kDrift * grown;
        }
    }
    m_blockEnds = arrival - m_first + std::max(kBlock, kFramesPerBlock * m_period);
    m_minLate = std::numeric_limits<double>::infinity();
    m_silenceBefore = std::exchange(m_maxSilence, 0.0);
    return finding;
}

}  // namespace simplebgc
