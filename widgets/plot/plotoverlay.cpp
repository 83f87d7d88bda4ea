// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/plotoverlay.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kPadding = 4;
constexpr double kSquare = 8;
constexpr double kFlag = 9;
constexpr double kDot = 2;

ColorRole roleOf(PlotMark::Kind kind)
{
    switch (kind) {
    case PlotMark::Kind::Note: return ColorRole::Muted;
    case PlotMark::Kind::Change: return ColorRole::Accent;
    case PlotMark::Kind::Fault: return ColorRole::Danger;
    }
    return ColorRole::Muted;
}

}  // namespace

PlotOverlay::PlotOverlay(QPainter &painter, const QRectF &area, const Theme &theme)
    : m_painter(painter)
    , m_area(area)
    , m_theme(theme)
{
}

void PlotOverlay::vertical(double x, const QPen &pen)
{
    m_painter.setPen(pen);
    m_painter.drawLine(QPointF(x, m_area.top()), QPointF(x, m_area.bottom()));
}

// Marks may be in each live frame, so they are made of plain rectangles: pens, brushes and polygons allocate
// memory.
void PlotOverlay::mark(double x, PlotMark::Kind kind)
{
    const QColor color = m_theme.color(roleOf(kind));
    for (double y = m_area.top(); y < m_area.bottom(); y += 2 * kDot)
        m_painter.fillRect(QRectF(x, y, 1, kDot), color);
    // A flag on top, so that it is told from the cursor by shape as well.
    const double pixel = 1.0 / m_painter.device()->devicePixelRatioF();
    for (double y = 0; y < kFlag; y += pixel)
        m_painter.fillRect(QRectF(x, m_area.top() + y, kFlag - std::abs(2 * y + pixel - kFlag), pixel),
                           color);
}

void PlotOverlay::reference(double x)
{
    vertical(x, QPen(m_theme.color(ColorRole::Accent), 1));
}

void PlotOverlay::cursor(double x)
{
    vertical(x, QPen(m_theme.color(ColorRole::Muted), 1, Qt::DashLine));
}

void PlotOverlay::panel(const QRectF &box)
{
    QColor background = m_theme.color(ColorRole::SurfaceRaised);
    background.setAlpha(235);
    m_painter.setPen(m_theme.color(ColorRole::Border));
    m_painter.setBrush(background);
    m_painter.drawRoundedRect(box, kPadding, kPadding);
}

void PlotOverlay::box(double x, const QList<Line> &lines)
{
    const QFontMetricsF metrics(m_painter.font());
    const double height = metrics.lineSpacing();
    double width = 0;
    for (const Line &line : lines)
        width = std::max(width, metrics.horizontalAdvance(line.text));
    const auto shown = std::min(
        lines.size(), qsizetype(std::max(0.0, std::floor((m_area.height() - 3 * kPadding) / height))));
    if (shown == 0)
        return;
    QRectF box(x + 8, m_area.top() + kPadding, width + kSquare + 5 * kPadding,
               double(shown) * height + 2 * kPadding);
    if (box.right() > m_area.right())
        box.moveRight(x - 8);
    panel(box);
    for (qsizetype i = 0; i < shown; ++i) {
        const double top = box.top() + kPadding + double(i) * height;
        if (lines[i].color.isValid())
            m_painter.fillRect(
                QRectF(box.left() + kPadding + 2, top + (height - kSquare) / 2, kSquare, kSquare),
                lines[i].color);
        m_painter.setPen(m_theme.color(ColorRole::Text));
        m_painter.drawText(QRectF(box.left() + kSquare + 3 * kPadding, top, width + kPadding, height),
                           Qt::AlignLeft | Qt::AlignVCenter, lines[i].text);
    }
}

void PlotOverlay::corner(const QString &text)
{
    const QFontMetricsF metrics(m_painter.font());
    QRectF box(0, 0, metrics.horizontalAdvance(text) + 4 * kPadding, metrics.lineSpacing() + kPadding);
    box.moveBottomRight(m_area.bottomRight() - QPointF(kPadding, kPadding));
    panel(box);
    m_painter.setPen(m_theme.color(ColorRole::Text));
    m_painter.drawText(box, Qt::AlignCenter, text);
}

void PlotOverlay::selection(const QRectF &box)
{
    QColor fill = m_theme.color(ColorRole::Accent);
    m_painter.setPen(QPen(fill, 1));
    fill.setAlpha(50);
    m_painter.setBrush(fill);
    m_painter.drawRect(box.intersected(m_area));
}
