// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/video/videostatistics.h"

#include <algorithm>

void RateMeter::add(TimePoint at, double amount)
{
    m_events.push_back({at, amount});
    forget(at);
}

void RateMeter::forget(TimePoint now) const
{
    while (!m_events.empty() && now - m_events.front().at > m_span)
        m_events.pop_front();
}

double RateMeter::sum() const
{
    double all = 0;
    for (const Event &event : m_events)
        all += event.amount;
    return all;
}

double RateMeter::rate(TimePoint now) const
{
    forget(now);
    if (m_events.size() < 2)
        return 0;
    const double time = seconds(now - m_events.front().at);
    return time > 0 ? double(m_events.size() - 1) / time : 0;
}

double RateMeter::amountRate(TimePoint now) const
{
    const double often = rate(now);
    return m_events.empty() ? 0 : often * sum() / double(m_events.size());
}

double RateMeter::mean(TimePoint now) const
{
    forget(now);
    return m_events.empty() ? 0 : sum() / double(m_events.size());
}

void DelayMeter::add(Duration delay)
{
    m_delays.push_back(delay);
    if (m_delays.size() > kKept)
        m_delays.pop_front();
}

std::optional<Duration> DelayMeter::median() const
{
    if (m_delays.empty())
        return {};
    std::vector<Duration> sorted(m_delays.begin(), m_delays.end());
    const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

std::optional<Duration> DelayMeter::worst() const
{
    if (m_delays.empty())
        return {};
    return *std::max_element(m_delays.begin(), m_delays.end());
}
