// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/curvechart.h"

#include "widgets/plot/chartnumbers.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QLineSeries>
#include <QLogValueAxis>
#include <QPainter>
#include <QValueAxis>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

// Room around the plot area.
constexpr double kLeft = 76;
constexpr double kTop = 12;
constexpr double kLegend = 40;
constexpr double kLegendTop = 10;
constexpr int kLegendRows = 3;
constexpr double kWordGap = 8;
constexpr double kRight = 36;
constexpr double kBottom = 28;

}  // namespace

CurveChart::CurveChart(const Theme &theme, const QString &name, QWidget *parent)
    : QChartView(parent)
    , m_theme(theme)
{
    writeNumbers(*chart());
    chart()->setAnimationOptions(QChart::NoAnimation);
    chart()->setBackgroundVisible(false);
    chart()->setMargins({0, 0, 0, 0});
    chart()->layout()->setContentsMargins(0, 0, 0, 0);  // labels in the margins would be hidden
    chart()->legend()->detachFromChart();
    chart()->legend()->hide();  // it loses curves whose names are long
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing);
    setMinimumHeight(140);
    setAccessibleName(name);
    viewport()->setAccessibleName(name);
    connect(&theme, &Theme::changed, this, &CurveChart::applyTheme);
    setScales({}, {});
}

QAbstractAxis *CurveChart::makeAxis(const ChartScale &scale, Qt::Alignment side, QAbstractAxis *old)
{
    const bool wasLogarithmic = qobject_cast<QLogValueAxis *>(old);
    if (!old || wasLogarithmic != scale.logarithmic) {
        if (old) {
            chart()->removeAxis(old);
            delete old;
        }
        old = scale.logarithmic ? static_cast<QAbstractAxis *>(new QLogValueAxis(this))
                                : new QValueAxis(this);
        old->setLinePenColor(Qt::transparent);
        chart()->addAxis(old, side);
    }
    if (auto *logarithmic = qobject_cast<QLogValueAxis *>(old)) {
        logarithmic->setBase(10);
        logarithmic->setMinorTickCount(8);
        logarithmic->setLabelFormat(labelFormat(scale.labelFormat));
        logarithmic->setRange(scale.low, scale.high);
    } else {
        auto *linear = static_cast<QValueAxis *>(old);
        linear->setLabelFormat(labelFormat(scale.labelFormat));
        // Moved by a tiny amount, so that rounding yields 0 and not -0.
        const double hair = scale.labelFormat.contains(u'f') ? 1e-9 * (scale.high - scale.low) : 0.0;
        linear->setRange(scale.low + hair, scale.high + hair);
        if (scale.steps > 0)
            linear->setTickCount(scale.steps + 1);
        else
            linear->applyNiceNumbers();
    }
    old->setTitleText(scale.title);
    return old;
}

void CurveChart::setScales(const ChartScale &x, const ChartScale &y)
{
    m_x = x;
    m_y = y;
    m_xAxis = makeAxis(x, Qt::AlignBottom, m_xAxis);
    m_yAxis = makeAxis(y, Qt::AlignLeft, m_yAxis);
    attach();
    applyTheme();
}

void CurveChart::attach()
{
    for (QLineSeries *series : m_series) {
        const QList<QAbstractAxis *> attached = series->attachedAxes();
        for (QAbstractAxis *axis : {m_xAxis, m_yAxis}) {
            if (!attached.contains(axis))
                series->attachAxis(axis);
        }
    }
}

void CurveChart::setCurves(const QList<ChartCurve> &curves)
{
    m_curves = curves;
    while (m_series.size() > curves.size()) {
        chart()->removeSeries(m_series.last());
        delete m_series.takeLast();
    }
    while (m_series.size() < curves.size()) {
        auto *series = new QLineSeries(this);
        chart()->addSeries(series);
        m_series.append(series);
    }
    attach();
    for (qsizetype i = 0; i < curves.size(); ++i) {
        m_series[i]->setName(curves[i].name);
        m_series[i]->replace(curves[i].points);
    }
    applyTheme();
}

void CurveChart::setLabels(const QList<ChartLabel> &labels)
{
    m_labels = labels;
    viewport()->update();
}

void CurveChart::resizeEvent(QResizeEvent *event)
{
    layOut();  // first: the chart lays its labels out when it gets its size, and hides those that lie outside
    QChartView::resizeEvent(event);
    // Labels that lay outside of the old size stay hidden until the plot area changes once more.
    chart()->setPlotArea(chart()->plotArea().adjusted(0, 0, 0, -1));
    layOut();
}

// The same edges in every chart, so that charts above each other line up.
void CurveChart::layOut()
{
    const double room = std::max(10.0, width() - kLeft - kRight);
    const double names = m_legend.layOut(font(), kLeft, kLegendTop, room, kLegendRows);
    const double top = names > 0 ? std::max(kLegend, kLegendTop + names + kLegendTop) : kTop;
    chart()->setPlotArea({kLeft, top, room, std::max(10.0, height() - top - kBottom)});
}

void CurveChart::setHint(const QString &text)
{
    m_hint = text;
    viewport()->update();
}

void CurveChart::applyTheme()
{
    const QColor muted = m_theme.color(ColorRole::Muted);
    setBackgroundBrush(m_theme.color(ColorRole::Surface));
    for (QAbstractAxis *axis : {m_xAxis, m_yAxis}) {
        axis->setLabelsColor(muted);
        axis->setTitleBrush(muted);
        axis->setGridLineColor(m_theme.color(ColorRole::SurfaceRaised));
        axis->setMinorGridLineColor(m_theme.color(ColorRole::SurfaceRaised));
    }
    QList<PlotLegend::Entry> entries;
    for (qsizetype i = 0; i < m_series.size(); ++i) {
        const ChartCurve &curve = m_curves[i];
        QColor color
            = curve.axis == Axis::None ? m_theme.seriesColor(curve.color) : m_theme.axisColor(curve.axis);
        color.setAlphaF(float(curve.strength));
        m_series[i]->setPen(QPen(color, curve.width, curve.style));
        if (!curve.name.isEmpty())
            entries.append({curve.name, color, curve.style});
    }
    m_legend.setEntries(entries);
    layOut();
    viewport()->update();
}

void CurveChart::drawForeground(QPainter *painter, const QRectF &rect)
{
    QChartView::drawForeground(painter, rect);
    const QRectF area = chart()->plotArea();
    const QFontMetricsF metrics(font());
    painter->setFont(font());
    if (m_series.isEmpty()) {
        painter->setPen(m_theme.color(ColorRole::Muted));
        painter->drawText(area.adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, m_hint);
        return;
    }
    m_legend.paint(*painter, m_theme.color(ColorRole::Text));
    painter->setFont(font());
    painter->setPen(m_theme.color(ColorRole::Text));
    const QList<QRectF> boxes = labelBoxes();
    for (qsizetype i = 0; i < boxes.size(); ++i) {
        if (boxes[i].isNull())
            continue;
        painter->drawText(boxes[i], Qt::AlignCenter, m_labels[i].text);
        const QPointF at = chart()->mapToPosition(m_labels[i].point, m_series.first());
        const bool isAbove = boxes[i].bottom() <= at.y();
        painter->drawLine(QPointF(at.x(), isAbove ? boxes[i].bottom() : boxes[i].top()), at);
    }
}

// Above its point, or as many rows higher or lower as it needs to lie over no other.
QList<QRectF> CurveChart::labelBoxes() const
{
    const QRectF area = chart()->plotArea();
    const QFontMetricsF metrics(font());
    QList<QRectF> boxes;
    for (const ChartLabel &label : m_labels) {
        boxes.append(QRectF());
        const QPointF at
            = m_series.isEmpty() ? QPointF(-1, -1) : chart()->mapToPosition(label.point, m_series.first());
        if (!area.contains(at))
            continue;
        QRectF box(0, 0, metrics.horizontalAdvance(label.text) + 2, metrics.height());
        box.moveCenter({at.x(), at.y() - metrics.height()});
        box.moveLeft(std::clamp(box.left(), area.left(), area.right() - box.width()));
        box.moveTop(std::max(box.top(), area.top()));
        const auto isFree = [&](const QRectF &wanted) {
            return wanted.top() >= area.top() && wanted.bottom() <= area.bottom()
                && std::none_of(boxes.begin(), boxes.end(), [&](const QRectF &other) {
                       return !other.isNull()
                           && wanted.adjusted(-kWordGap / 2, 0, kWordGap / 2, 0).intersects(other);
                   });
        };
        const int rows = int(area.height() / metrics.height());
        for (int row = 0; row <= rows && boxes.last().isNull(); ++row) {
            for (const int direction : {-1, 1}) {
                const QRectF wanted = box.translated(0, direction * row * metrics.height());
                const bool hidesPoint
                    = direction > 0 && wanted.bottom() > at.y() - 2 && wanted.top() < at.y() + 2;
                if (!hidesPoint && isFree(wanted)) {
                    boxes.last() = wanted;
                    break;
                }
            }
        }
    }
    return boxes;
}
