// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/traceimage.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace {

/// The pixels of one column of an image, from the top.
struct PixelColumn
{
    QRgb &operator[](qsizetype y) const { return first[y * stride]; }
    QRgb *first;
    qsizetype stride;
};

PixelColumn columnIn(QImage &image, int x)
{
    return {reinterpret_cast<QRgb *>(image.bits()) + x, image.bytesPerLine() / qsizetype(sizeof(QRgb))};
}

}  // namespace

void TraceImage::setView(const QRectF &area, double window, std::span<const Range> ranges,
                         const Ground &ground, qreal scale)
{
    const bool samePlace = area == m_area && window == m_window && scale == m_scale;
    const bool sameRanges = std::equal(ranges.begin(), ranges.end(), m_ranges.begin(), m_ranges.end());
    if (samePlace && sameRanges && ground == m_ground)
        return;
    m_area = area;
    m_window = window;
    m_ranges.assign(ranges.begin(), ranges.end());
    m_scale = scale;
    m_ground = ground;
    if (samePlace && m_valid) {
        // The columns stay as they are, only their heights and colours change.
        drawColumns(m_lastColumn - m_width + 1, m_lastColumn);
        return;
    }
    m_valid = false;
}

double TraceImage::newestSample()
{
    double newest = std::numeric_limits<double>::quiet_NaN();
    for (Trace &trace : m_traces) {
        if (trace.sources.empty())
            continue;
        trace.sources.back().refresh();
        const TrackView &track = trace.sources.back().track;
        if (track.end() > track.begin()) {
            const double time = track.time(track.end() - 1);
            newest = std::isnan(newest) ? time : std::max(newest, time);
        }
    }
    return newest;
}

void TraceImage::hold(double end)
{
    if (m_held == end)
        return;
    m_held = end;
    m_valid = false;
}

void TraceImage::follow()
{
    if (m_held)
        m_valid = false;
    m_held.reset();
}

bool TraceImage::advance(double now)
{
    m_now = m_held.value_or(now);
    if (!m_valid) {
        rebuild();
        return true;
    }
    if (m_held)
        return false;
    const auto newColumn = static_cast<qint64>(std::floor(now / m_pitch));
    qint64 firstChanged = newColumn + 1;
    for (Trace &trace : m_traces) {
        if (const auto changed = trace.columns.update(trace.sources))
            firstChanged = std::min(firstChanged, *changed);
    }
    if (newColumn == m_lastColumn && firstChanged > newColumn)
        return false;
    if (newColumn - m_lastColumn >= m_width) {
        m_valid = false;
        return advance(now);
    }
    // Columns that came in on the right have to be wiped before they are drawn.
    const qint64 first = std::max(std::min(firstChanged, m_lastColumn + 1), newColumn - m_width + 1);
    m_lastColumn = newColumn;
    drawColumns(first, newColumn);
    return true;
}

void TraceImage::rebuild()
{
    m_width = std::max(1, int(std::lround(m_area.width() * m_scale)));
    m_height = std::max(1, int(std::lround(m_area.height() * m_scale)));
    m_pitch = m_window / m_width;
    m_ring = QImage(m_width, m_height, QImage::Format_RGB32);
    m_line = QImage(thickness(), m_height, QImage::Format_RGB32);
    m_lastColumn = static_cast<qint64>(std::floor(m_now / m_pitch));
    for (Trace &trace : m_traces) {
        const int kept = m_width + thickness() - 1;  // some before the left edge reach into the picture
        trace.columns.reset(kept, m_pitch, m_lastColumn - kept + 1,
                            m_held ? m_lastColumn : TraceColumns::kNoLimit);
        trace.columns.update(trace.sources);
    }
    m_valid = true;
    drawColumns(m_lastColumn - m_width + 1, m_lastColumn);
}

void TraceImage::drawColumns(qint64 first, qint64 last)
{
    if (m_ring.isNull())
        return;
    // The background, with the horizontal grid lines; the vertical ones do not scroll.
    const QRgb surface = m_ground.surface.rgb();
    const QRgb grid = m_ground.grid.rgb();
    for (qint64 column = first; column <= last; ++column) {
        fill(slotOf(column), 0, m_height, surface);
        for (int i = 0; i <= m_ground.rows; ++i) {
            const int top = m_height * i / m_ground.rows - thickness() / 2;
            fill(slotOf(column), top, top + thickness(), grid);
        }
    }
    for (const Trace &trace : m_traces) {
        if (!trace.visible || trace.scale >= m_ranges.size())
            continue;
        const auto [low, high] = m_ranges[trace.scale];
        const double perUnit = high > low ? (m_height - 1) / (high - low) : 0.0;
        const auto row = [this, perUnit, bottom = low](float value) {
            return std::clamp(m_height - 1 - (double(value) - bottom) * perUnit, -2.0,
                              double(m_height) + 1.0);
        };
        const QRgb color = trace.color.rgb();
        for (qint64 column = first; column <= last; ++column) {
            // A line as wide as it is high: what stands in the columns before reaches into this one.
            for (int back = 0; back < thickness(); ++back) {
                const TraceColumns::Span span = trace.columns.span(column - back);
                if (span.isEmpty())
                    continue;
                const int top = int(std::floor(row(span.high)));
                fill(slotOf(column), top, std::max(top + thickness(), int(std::ceil(row(span.low))) + 1),
                     color);
            }
        }
    }
}

// Part of one column; rows outside the picture are left out.
void TraceImage::fill(int slot, int top, int bottom, QRgb color)
{
    const PixelColumn column = columnIn(m_ring, slot);
    for (int y = std::max(top, 0); y < std::min(bottom, m_height); ++y)
        column[y] = color;
}

int TraceImage::slotOf(qint64 column) const
{
    return int(((column % m_width) + m_width) % m_width);
}

int TraceImage::thickness() const
{
    return std::max(1, int(std::lround(m_scale)));
}

TraceColumns::Span
TraceImage::rangeOf(std::size_t scale,
                    const std::function<TraceColumns::Span(const TraceColumns &)> &range) const
{
    TraceColumns::Span all;
    for (const Trace &trace : m_traces) {
        if (!trace.visible || trace.scale != scale)
            continue;
        if (const TraceColumns::Span one = range(trace.columns); !one.isEmpty())
            all = all.isEmpty()
                ? one
                : TraceColumns::Span{std::min(all.low, one.low), std::max(all.high, one.high)};
    }
    return all;
}

TraceColumns::Span TraceImage::visibleRange(std::size_t scale) const
{
    return rangeOf(scale, [this](const TraceColumns &columns) {
        return columns.range(m_lastColumn - m_width + 1, m_lastColumn);
    });
}

TraceColumns::Span TraceImage::lastingRange(std::size_t scale) const
{
    return rangeOf(scale, [this](const TraceColumns &columns) {
        return columns.lastingRange(m_lastColumn - m_width + 1, m_lastColumn - m_width / 3, m_lastColumn);
    });
}

void TraceImage::paint(QPainter &painter)
{
    if (!m_valid)
        return;
    const int left = int(std::lround(m_area.left() * m_scale));
    const int top = int(std::lround(m_area.top() * m_scale));
    const int head = slotOf(m_lastColumn + 1);  // slot of the oldest column
    painter.drawImage(left, top, m_ring, head, 0, m_width - head, m_height);
    if (head > 0)
        painter.drawImage(left + m_width - head, top, m_ring, 0, 0, head, m_height);
    // The grid's vertical lines stand still while the traces pass over them: what is ground in the ring is
    // line there.
    const QRgb surface = m_ground.surface.rgb();
    const QRgb grid = m_ground.grid.rgb();
    for (int i = 0; i <= m_ground.columns; ++i) {
        const int from = std::max(0, m_width * i / m_ground.columns - thickness() / 2);
        const int to = std::min(m_width, m_width * i / m_ground.columns - thickness() / 2 + thickness());
        for (int x = from; x < to; ++x) {
            const PixelColumn ring = columnIn(m_ring, (head + x) % m_width);
            const PixelColumn line = columnIn(m_line, x - from);
            for (int y = 0; y < m_height; ++y)
                line[y] = ring[y] == surface ? grid : ring[y];
        }
        if (from < to)
            painter.drawImage(left + from, top, m_line, 0, 0, to - from, m_height);
    }
}
