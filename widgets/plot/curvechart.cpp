// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/curvechart.h"

#include "widgets/plot/chartnumbers.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QLegendMarker>
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
    chart()->legend()->setAlignment(Qt::AlignTop);
    chart()->legend()->detachFromChart();
    chart()->legend()->setBackgroundVisible(false);
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
        logarithmic->setLabelFormat(scale.labelFormat);
        logarithmic->setRange(scale.low, scale.high);
    } else {
        auto *linear = static_cast<QValueAxis *>(old);
        linear->setLabelFormat(scale.labelFormat);
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
}

// The same edges in every chart, so that charts above each other line up.
void CurveChart::layOut()
{
    const double top = chart()->legend()->isVisible() ? kLegend : kTop;
    chart()->setPlotArea(
        {kLeft, top, std::max(10.0, width() - kLeft - kRight), std::max(10.0, height() - top - kBottom)});
    // Attached to the chart, the legend would keep the size it had while hidden.
    chart()->legend()->setGeometry(kLeft, 4, std::max(10.0, width() - kLeft - kRight), kLegend - 8);
    chart()->legend()->update();
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
    chart()->legend()->setLabelColor(m_theme.color(ColorRole::Text));
    for (QAbstractAxis *axis : {m_xAxis, m_yAxis}) {
        axis->setLabelsColor(muted);
        axis->setTitleBrush(muted);
        axis->setGridLineColor(m_theme.color(ColorRole::SurfaceRaised));
        axis->setMinorGridLineColor(m_theme.color(ColorRole::SurfaceRaised));
    }
    for (qsizetype i = 0; i < m_series.size(); ++i) {
        const ChartCurve &curve = m_curves[i];
        QColor color
            = curve.axis == Axis::None ? m_theme.seriesColor(curve.color) : m_theme.axisColor(curve.axis);
        color.setAlphaF(float(curve.strength));
        m_series[i]->setPen(QPen(color, curve.width, curve.style));
    }
    const auto named = [](const ChartCurve &curve) { return !curve.name.isEmpty(); };
    chart()->legend()->setVisible(std::any_of(m_curves.begin(), m_curves.end(), named));
    layOut();
    const auto markers = chart()->legend()->markers();
    for (QLegendMarker *marker : markers) {
        marker->setPen(QPen(Qt::transparent));  // without any pen, the style's default would return
        marker->setVisible(!marker->series()->name().isEmpty());
    }
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
    painter->setPen(m_theme.color(ColorRole::Text));
    QList<QRectF> taken;
    for (const ChartLabel &label : m_labels) {
        const QPointF at = chart()->mapToPosition(label.point, m_series.first());
        if (!area.contains(at))
            continue;
        QRectF box(0, 0, metrics.horizontalAdvance(label.text) + 2, metrics.height());
        box.moveCenter({at.x(), at.y() - metrics.height()});
        box.moveLeft(std::clamp(box.left(), area.left(), area.right() - box.width()));
        box.moveTop(std::max(box.top(), area.top()));
        // Beside a word that is there already it would lie over that one's line or peak; the table has them
        // all.
        const auto beside = [&](const QRectF &other) {
            return box.left() < other.right() + kWordGap && other.left() < box.right() + kWordGap;
        };
        if (std::any_of(taken.begin(), taken.end(), beside))
            continue;
        taken.append(box);
        painter->drawText(box, Qt::AlignCenter, label.text);
        painter->drawLine(QPointF(at.x(), box.bottom()), at);
    }
}
