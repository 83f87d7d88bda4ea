// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/client/restartwatch.h"

#include <algorithm>
#include <utility>

namespace {

constexpr Duration kSuspicious = 400ms;
constexpr Duration kAbsence = 700ms;  // of a board that restarts, at least
constexpr Duration kResumes = 1000ms;  // by then streams that still exist have gone on
constexpr double kMissed = 3;  // samples
constexpr Duration kOrderLimit = 15s;  // from the moment for which it was ordered

}  // namespace

void RestartWatch::meet(bool isSame)
{
    end();
    m_hasRun = false;
    if (!isSame)
        m_due.reset();
}

void RestartWatch::begin(TimePoint now, double period)
{
    m_period = period;
    m_heardAt = now;
    heard(now, true);
}

void RestartWatch::end()
{
    m_period = 0;
}

Duration RestartWatch::periods(double count) const
{
    return durationFromSeconds(count * m_period);
}

void RestartWatch::heard(TimePoint at, bool isStreamed)
{
    m_silence = std::max<Duration>(m_silence, at - m_heardAt);
    m_heardAt = at;
    if (!isStreamed)
        return;
    m_streamedAt = at;
    m_silence = {};
    m_wasAway = false;
    m_answeredAt.reset();
}

bool RestartWatch::takeState(bool isFresh)
{
    return std::exchange(m_hasRun, !isFresh) && isFresh;
}

void RestartWatch::answered(bool isThere, TimePoint at)
{
    m_isAsking = false;
    if (!isThere)
        m_wasAway = true;
    else if (!m_answeredAt)
        m_answeredAt = at;
}

// A board that calibrates is silent as well, and its streams may go on late.
RestartWatch::Step RestartWatch::look(TimePoint now, TimePoint silentUntil)
{
    if (m_period <= 0 || m_isAsking || now - m_streamedAt < std::max<Duration>(kSuspicious, periods(kMissed)))
        return Step::Wait;
    if (!m_answeredAt) {
        m_isAsking = true;
        return Step::Ask;
    }
    if (now < std::max(*m_answeredAt, silentUntil) + std::max<Duration>(kResumes, periods(kMissed)))
        return Step::Wait;
    end();
    return m_wasAway && m_silence >= kAbsence ? Step::Restarted : Step::StreamsEnded;
}

std::optional<TimePoint> RestartWatch::takeOrder(TimePoint now)
{
    const auto due = std::exchange(m_due, std::nullopt);
    return due && now < *due + kOrderLimit ? due : std::nullopt;
}
