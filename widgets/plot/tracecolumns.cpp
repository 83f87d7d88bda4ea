// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/tracecolumns.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

constexpr std::ptrdiff_t kPassing = 7;  // what takes up less than this part of the columns has passed

}  // namespace

void TraceColumns::reset(int width, double pitch, qint64 firstColumn, qint64 limit)
{
    m_limit = limit;
    m_spans.assign(std::size_t(std::max(width, 1)), Span());
    m_pitch = pitch;
    m_first = firstColumn;
    m_newest = firstColumn - 1;
    m_track = 0;
    m_nextRow = 0;
    m_started = false;
    m_hasLast = false;
}

qint64 TraceColumns::columnOf(double time) const
{
    return static_cast<qint64>(std::floor(time / m_pitch));
}

std::size_t TraceColumns::slot(qint64 column) const
{
    const auto size = static_cast<qint64>(m_spans.size());
    return static_cast<std::size_t>(((column % size) + size) % size);
}

TraceColumns::Span TraceColumns::span(qint64 column) const
{
    if (column > m_newest || column <= m_newest - qint64(m_spans.size()) || column < m_first)
        return {};
    return m_spans[slot(column)];
}

TraceColumns::Span TraceColumns::range(qint64 first, qint64 last) const
{
    Span all;
    for (qint64 column = first; column <= last; ++column) {
        const Span one = span(column);
        if (one.isEmpty())
            continue;
        all = all.isEmpty() ? one : Span{std::min(all.low, one.low), std::max(all.high, one.high)};
    }
    return all;
}

TraceColumns::Span TraceColumns::lastingRange(qint64 first, qint64 recent, qint64 last) const
{
    Span all = range(recent, last);
    if (all.isEmpty())
        return range(first, last);
    std::vector<float> lows;
    std::vector<float> highs;
    for (qint64 column = first; column < recent; ++column) {
        if (const Span one = span(column); !one.isEmpty()) {
            lows.push_back(one.low);
            highs.push_back(one.high);
        }
    }
    const auto passing = std::ptrdiff_t(last - first + 1) / kPassing;
    if (std::ptrdiff_t(lows.size()) <= passing)
        return all;
    std::nth_element(lows.begin(), lows.begin() + passing, lows.end());
    std::nth_element(highs.begin(), highs.end() - 1 - passing, highs.end());
    all.low = std::min(all.low, lows[std::size_t(passing)]);
    all.high = std::max(all.high, highs[highs.size() - 1 - std::size_t(passing)]);
    return all;
}

std::optional<qint64> TraceColumns::update(std::vector<TraceSource> &sources)
{
    const qint64 before = m_newest;
    bool changed = false;
    for (; m_track < sources.size(); ++m_track) {
        TraceSource &source = sources[m_track];
        source.refresh();
        const TrackView &track = source.track;
        if (!m_started) {
            // One sample before the window, so that the first line enters from the left.
            m_nextRow = track.rowAt(double(m_first) * m_pitch);
            m_nextRow = m_nextRow > track.begin() ? m_nextRow - 1 : m_nextRow;
            m_started = true;
        }
        m_nextRow = std::max(m_nextRow, track.begin());
        const std::size_t end = source.end();
        for (; m_nextRow < end; ++m_nextRow) {
            const double time = track.time(m_nextRow);
            if (m_limit != kNoLimit && columnOf(time) > m_limit + 1)
                return changed ? std::optional(std::max(m_first, before)) : std::nullopt;
            if (addBlock(source, m_nextRow))
                m_nextRow += TelemetryGroup::kRowsPerBlock - 1;
            else
                add(time, source.value(m_nextRow));
            changed = true;
        }
        if (m_track + 1 == sources.size())
            break;
        m_started = false;  // go on in the next stream that carried this channel
    }
    return changed ? std::optional(std::max(m_first, before)) : std::nullopt;
}

// Takes a block of rows at once where all of them lie in one column; the picture is the same as row by row.
bool TraceColumns::addBlock(const TraceSource &source, std::size_t row)
{
    if (source.minus)
        return false;
    const auto extent = source.track.block(row);
    const std::size_t last = row + TelemetryGroup::kRowsPerBlock - 1;
    if (!extent || columnOf(source.track.time(row)) != columnOf(source.track.time(last)))
        return false;
    add(source.track.time(row), source.value(row));
    const qint64 column = columnOf(source.track.time(last));
    extend(column, extent->low);
    extend(column, extent->high);
    m_lastTime = source.track.time(last);
    m_lastValue = source.value(last);
    return true;
}

void TraceColumns::add(double time, float value)
{
    if (std::isnan(value)) {
        m_hasLast = false;
        return;
    }
    const qint64 column = columnOf(time);
    if (m_hasLast && time - m_lastTime < kTraceGap && time >= m_lastTime) {
        // Spans touch the column before; between sparse samples the line is drawn through the columns it
        // crosses.
        const qint64 from = columnOf(m_lastTime);
        const double width = time - m_lastTime;
        for (qint64 between = std::max(from, m_first - 1); between < column; ++between) {
            const double edge = double(between + 1) * m_pitch;
            const float part = width > 0 ? float((edge - m_lastTime) / width) : 1.0F;
            const float at = m_lastValue + (value - m_lastValue) * part;
            extend(between, at);
            extend(between + 1, at);
        }
    }
    extend(column, value);
    m_hasLast = true;
    m_lastTime = time;
    m_lastValue = value;
}

void TraceColumns::extend(qint64 column, float value)
{
    if (column < m_first || column > m_limit || column <= m_newest - qint64(m_spans.size()))
        return;
    // Skipped columns are empty; they must not keep contents from the previous turn of the ring.
    for (qint64 fresh = std::max(m_newest + 1, column - qint64(m_spans.size()) + 1); fresh <= column; ++fresh)
        m_spans[slot(fresh)] = Span();
    m_newest = std::max(m_newest, column);
    Span &span = m_spans[slot(column)];
    span = span.isEmpty() ? Span{value, value} : Span{std::min(span.low, value), std::max(span.high, value)};
}
