// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/curvechart.h"

#include <QChart>
#include <QLegendMarker>
#include <QLineSeries>
#include <QLogValueAxis>
#include <QPainter>
#include <QValueAxis>

#include <algorithm>

using namespace Qt::StringLiterals;

CurveChart::CurveChart(const Theme &theme, const QString &name, QWidget *parent)
    : QChartView(parent)
    , m_theme(theme)
{
    chart()->setAnimationOptions(QChart::NoAnimation);
    chart()->setBackgroundVisible(false);
    chart()->setMargins({0, 0, 4, 0});
    chart()->legend()->setAlignment(Qt::AlignTop);
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
        old = scale.logarithmic ? static_cast<QAbstractAxis *>(new QLogValueAxis(this)) : new QValueAxis(this);
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
        linear->setRange(scale.low, scale.high);
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
        QColor color = curve.axis == Axis::None ? m_theme.seriesColor(curve.color) : m_theme.axisColor(curve.axis);
        color.setAlphaF(float(curve.strength));
        m_series[i]->setPen(QPen(color, curve.width, curve.style));
    }
    const auto markers = chart()->legend()->markers();
    for (QLegendMarker *marker : markers) {
        marker->setPen(QPen(Qt::transparent));   // no pen at all would bring the style's own back
        marker->setVisible(!marker->series()->name().isEmpty());
    }
    viewport()->update();
}

void CurveChart::drawForeground(QPainter *painter, const QRectF &rect)
{
    QChartView::drawForeground(painter, rect);
    if (m_series.isEmpty())
        return;
    const QRectF area = chart()->plotArea();
    const QFontMetricsF metrics(font());
    painter->setFont(font());
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
        // A word that would lie over another one is left out; the table has them all.
        if (std::any_of(taken.begin(), taken.end(), [&](const QRectF &other) { return other.intersects(box); }))
            continue;
        taken.append(box);
        painter->drawText(box, Qt::AlignCenter, label.text);
        painter->drawLine(QPointF(at.x(), box.bottom()), at);
    }
}
