// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/plotlegend.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace {

constexpr double kMark = 8;
constexpr double kDashes = 20;  // a broken line needs some length to be seen
constexpr double kMarkGap = 5;
constexpr double kEntryGap = 12;
constexpr double kRowGap = 2;
constexpr double kShortest = 24;  // of a shortened name

double markWidth(const PlotLegend::Entry &entry)
{
    return entry.style == Qt::SolidLine ? kMark : kDashes;
}

}  // namespace

QList<PlotLegend::Placed> PlotLegend::place(double longest, double width, double taken, int &rows) const
{
    const QFontMetricsF metrics(m_font);
    QList<Placed> placed;
    double x = 0;
    rows = 1;
    for (const Entry &entry : m_entries) {
        const QString text = metrics.elidedText(entry.name, Qt::ElideMiddle, longest);
        const double own = markWidth(entry) + kMarkGap + metrics.horizontalAdvance(text);
        const double room = width - (rows == 1 ? taken : 0.0);
        if (x > 0 && x + own > room) {
            x = 0;
            ++rows;
        }
        placed.append(
            {{m_left + x, m_top + (rows - 1) * (metrics.height() + kRowGap), own, metrics.height()}, text});
        x += own + kEntryGap;
    }
    return placed;
}

double PlotLegend::layOut(const QFont &font, double left, double top, double width, int maxRows, double taken)
{
    m_font = font;
    m_left = left;
    m_top = top;
    m_placed.clear();
    if (m_entries.isEmpty())
        return 0;
    const double full = std::max(kShortest, width - taken - kDashes - kMarkGap);
    int rows = 0;
    m_placed = place(full, width, taken, rows);
    for (double longest = full; rows > maxRows && longest > kShortest;) {
        longest = std::max(kShortest, 0.95 * longest);
        m_placed = place(longest, width, taken, rows);
    }
    return rows * (QFontMetricsF(m_font).height() + kRowGap);
}

void PlotLegend::paint(QPainter &painter, const QColor &textColor) const
{
    painter.setFont(m_font);
    for (qsizetype i = 0; i < m_placed.size(); ++i) {
        const QRectF &box = m_placed[i].box;
        const QRectF mark(box.left(), box.center().y() - kMark / 2, markWidth(m_entries[i]), kMark);
        if (m_entries[i].style == Qt::SolidLine) {
            painter.fillRect(mark, m_entries[i].color);
        } else {
            painter.setPen(QPen(m_entries[i].color, 2, m_entries[i].style));
            painter.drawLine(QPointF(mark.left(), mark.center().y()),
                             QPointF(mark.right(), mark.center().y()));
        }
        painter.setPen(textColor);
        painter.drawText(box.adjusted(mark.width() + kMarkGap, 0, kEntryGap, 0),
                         Qt::AlignLeft | Qt::AlignVCenter, m_placed[i].text);
    }
}

int PlotLegend::at(const QPointF &point) const
{
    const auto hit = std::find_if(m_placed.begin(), m_placed.end(),
                                  [&point](const Placed &placed) { return placed.box.contains(point); });
    return hit == m_placed.end() ? -1 : int(hit - m_placed.begin());
}
