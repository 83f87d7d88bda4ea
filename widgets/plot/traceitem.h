// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plot/tracecolumns.h"

#include <QColor>
#include <QGraphicsItem>
#include <QPixmap>

#include <span>

/// Draws all traces of one plot area: a ring image of finished pixel columns, scrolled by blitting it in two parts. A live
/// frame paints only the columns that are new; zoom, resize, scale and theme changes rebuild the image.
class TraceItem final : public QGraphicsItem
{
public:
    struct Trace
    {
        int channel = -1;
        int minus = -1;               ///< channel to subtract, -1 = none
        std::size_t scale = 0;        ///< which of the value ranges it is drawn in
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

    explicit TraceItem(QGraphicsItem *parent = nullptr);

    [[nodiscard]] std::vector<Trace> &traces() { return m_traces; }
    /// Area in item coordinates, seconds shown, value ranges, device pixels per pixel.
    void setView(const QRectF &area, double window, std::span<const Range> ranges, qreal scale);
    void invalidate() { m_valid = false; }
    /// Shows the past up to that time, until follow().
    void hold(double end);
    void follow();
    [[nodiscard]] std::optional<double> heldAt() const { return m_held; }
    /// Time at the right edge.
    [[nodiscard]] double end() const { return m_now; }
    /// Takes new samples up to that time; true if the picture changed.
    bool advance(double now);
    /// Lowest and highest value in the window over all visible traces of one value range; empty if there is none.
    [[nodiscard]] TraceColumns::Span visibleRange(std::size_t scale) const;
    /// Newest sample time of all traces, NaN without any.
    [[nodiscard]] double newestSample();

    [[nodiscard]] QRectF boundingRect() const override { return m_area; }
    void paint(QPainter *painter, const QStyleOptionGraphicsItem *option, QWidget *widget) override;

private:
    void rebuild();
    void drawColumns(qint64 first, qint64 last);

    std::vector<Trace> m_traces;
    QRectF m_area;
    double m_window = 10;
    std::vector<Range> m_ranges;
    qreal m_scale = 1;
    QPixmap m_ring;
    std::vector<QRect> m_spans;    // of one trace, while it is drawn
    int m_width = 1;               // of the ring image in device pixels
    int m_height = 1;
    double m_pitch = 0.01;         // seconds per column
    double m_now = 0;
    qint64 m_lastColumn = 0;       // newest column that is drawn
    bool m_valid = false;
    std::optional<double> m_held;
};
