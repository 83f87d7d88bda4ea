// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/plotmarks.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr std::size_t kMax = 2000;  // older ones go

bool earlier(const PlotMark &mark, double time)
{
    return mark.time < time;
}

}  // namespace

void PlotMarks::add(PlotMark mark)
{
    const auto place = std::upper_bound(m_marks.begin(), m_marks.end(), mark.time,
                                        [](double time, const PlotMark &other) { return time < other.time; });
    m_marks.insert(place, std::move(mark));
    if (m_marks.size() > kMax)
        m_marks.erase(m_marks.begin());
    emit changed();
}

void PlotMarks::clear()
{
    m_marks.clear();
    emit changed();
}

std::span<const PlotMark> PlotMarks::between(double from, double to) const
{
    const auto first = std::lower_bound(m_marks.begin(), m_marks.end(), from, earlier);
    const auto last = std::lower_bound(first, m_marks.end(), to, earlier);
    return {first, last};
}

const PlotMark *PlotMarks::near(double time, double within) const
{
    const PlotMark *best = nullptr;
    for (const PlotMark &mark : between(time - within, time + within)) {
        if (!best || std::abs(mark.time - time) < std::abs(best->time - time))
            best = &mark;
    }
    return best;
}

std::optional<double> PlotMarks::next(double time, bool forward) const
{
    const auto place = std::lower_bound(m_marks.begin(), m_marks.end(), time, earlier);
    if (forward) {
        const auto after = std::find_if(place, m_marks.end(),
                                        [time](const PlotMark &mark) { return mark.time > time + 1e-6; });
        return after == m_marks.end() ? std::nullopt : std::optional(after->time);
    }
    const auto before = std::find_if(std::make_reverse_iterator(place), m_marks.rend(),
                                     [time](const PlotMark &mark) { return mark.time < time - 1e-6; });
    return before == m_marks.rend() ? std::nullopt : std::optional(before->time);
}
