// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plot/tracecolumns.h"

#include <QColor>
#include <QImage>
#include <QRectF>

#include <functional>
#include <span>

class QPainter;

/// The picture of one plot area: all traces over their grid, in a ring image of finished pixel columns that
/// scrolls by being copied in two parts. A live frame paints only the columns that are new; zoom, resize,
/// scale and theme changes rebuild the image. It is opaque, because copying costs less than half of blending,
/// and its pixels are set directly, because a painter allocates memory in each frame.
class TraceImage final
{
public:
    struct Trace
    {
        int channel = -1;
        int minus = -1;  ///< channel to subtract, -1 = none
        std::size_t scale = 0;  ///< which of the value ranges it is drawn in
        QColor color;
        bool visible = true;
        std::vector<TraceSource> sources;
        TraceColumns columns;
    };

    /// Values at the lower and upper edge.
    struct Range
    {
        double low = -1;
        double high = 1;
        friend bool operator==(const Range &, const Range &) = default;
    };

    /// What lies under the traces.
    struct Ground
    {
        QColor surface;
        QColor grid;
        int rows = 1;  ///< parts between horizontal lines
        int columns = 1;  ///< parts between vertical lines
        friend bool operator==(const Ground &, const Ground &) = default;
    };

    [[nodiscard]] std::vector<Trace> &traces() { return m_traces; }
    [[nodiscard]] const std::vector<Trace> &traces() const { return m_traces; }
    /// Area in the view's coordinates, seconds shown, value ranges, what lies under them, device pixels per
    /// pixel.
    void setView(const QRectF &area, double window, std::span<const Range> ranges, const Ground &ground,
                 qreal scale);
    void invalidate() { m_valid = false; }
    /// Shows the past up to that time, until follow().
    void hold(double end);
    void follow();
    [[nodiscard]] std::optional<double> heldAt() const { return m_held; }
    /// Time at the right edge.
    [[nodiscard]] double end() const { return m_now; }
    /// Takes new samples up to that time; true if the picture changed.
    bool advance(double now);
    /// Lowest and highest value in the window over all visible traces of one value range; empty if there is
    /// none.
    [[nodiscard]] TraceColumns::Span visibleRange(std::size_t scale) const;
    /// The same without what is over and was short: the newest third of the window counts in full, before it
    /// only what lasted. Never empty where visibleRange() is not.
    [[nodiscard]] TraceColumns::Span lastingRange(std::size_t scale) const;
    /// Newest sample time of all traces, NaN without any.
    [[nodiscard]] double newestSample();

    /// Nothing to paint yet: no sample has come.
    [[nodiscard]] bool isEmpty() const { return !m_valid; }
    /// Covers the area. @param painter works in device pixels
    void paint(QPainter &painter);

private:
    void rebuild();
    [[nodiscard]] TraceColumns::Span
    rangeOf(std::size_t scale, const std::function<TraceColumns::Span(const TraceColumns &)> &range) const;
    void fill(int slot, int top, int bottom, QRgb color);
    [[nodiscard]] int slotOf(qint64 column) const;
    [[nodiscard]] int thickness() const;
    void drawColumns(qint64 first, qint64 last);

    std::vector<Trace> m_traces;
    QRectF m_area;
    double m_window = 10;
    std::vector<Range> m_ranges;
    Ground m_ground;
    qreal m_scale = 1;
    QImage m_ring;
    QImage m_line;  // one vertical line of the grid, while it is drawn
    int m_width = 1;  // of the ring image in device pixels
    int m_height = 1;
    double m_pitch = 0.01;  // seconds per column
    double m_now = 0;
    qint64 m_lastColumn = 0;  // newest column that is drawn
    bool m_valid = false;
    std::optional<double> m_held;
};
