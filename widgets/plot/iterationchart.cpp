// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/iterationchart.h"

#include "widgets/plot/chartnumbers.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QLineSeries>
#include <QPainter>
#include <QValueAxis>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr double kEdge = 12;
constexpr int kNameRows = 3;
// Room around the plot area.
constexpr double kStepsLeft = 56;
constexpr double kStepsTop = 36;
constexpr double kStepsRight = 24;
constexpr double kStepsBottom = 30;

}  // namespace

IterationChart::IterationChart(const Theme &theme, const QString &title, QWidget *parent)
    : QChartView(parent)
    , m_theme(theme)
    , m_title(title)
    , m_steps(new QValueAxis(this))
    , m_values(new QValueAxis(this))
{
    writeNumbers(*chart());
    chart()->setAnimationOptions(QChart::NoAnimation);
    chart()->setBackgroundVisible(false);
    chart()->setMargins({0, 0, 0, 0});
    chart()->layout()->setContentsMargins(0, 0, 0, 0);  // labels in the margins would be hidden
    chart()->legend()->detachFromChart();
    chart()->legend()->hide();  // it loses lines whose names are long
    chart()->addAxis(m_steps, Qt::AlignBottom);
    chart()->addAxis(m_values, Qt::AlignLeft);
    m_steps->setLabelFormat(labelFormat(u"%d"_s));
    m_values->setLabelFormat(labelFormat(u"%g"_s));
    showRange();
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing);
    setMinimumHeight(150);
    setAccessibleName(title);
    viewport()->setAccessibleName(title);
    connect(&theme, &Theme::changed, this, &IterationChart::applyTheme);
    applyTheme();
}

void IterationChart::clear()
{
    for (const Line &line : std::as_const(m_lines)) {
        chart()->removeSeries(line.series);
        delete line.series;
    }
    m_lines.clear();
    applyTheme();
    m_high = 0;
    m_lastStep = 1;
    showRange();
}

// Labels of the steps are whole numbers.
void IterationChart::showRange()
{
    m_steps->setRange(0, std::max(5, m_lastStep));
    m_steps->applyNiceNumbers();
    m_values->setRange(0, m_high > 0 ? m_high : 1);
    m_values->applyNiceNumbers();
}

void IterationChart::addPoint(const QString &name, Axis axis, int step, double value, Qt::PenStyle style)
{
    if (!m_lines.contains(name)) {
        auto *series = new QLineSeries(this);
        series->setName(name);
        chart()->addSeries(series);
        series->attachAxis(m_steps);
        series->attachAxis(m_values);
        m_lines.insert(name, {series, axis, style});
        applyTheme();
    }
    QLineSeries *series = m_lines[name].series;
    if (series->count() > 0 && int(series->at(series->count() - 1).x()) == step)
        series->replace(series->count() - 1, step, value);
    else
        series->append(step, value);
    m_high = std::max(m_high, value);
    m_lastStep = std::max(m_lastStep, step);
    showRange();
}

void IterationChart::applyTheme()
{
    const QColor muted = m_theme.color(ColorRole::Muted);
    setBackgroundBrush(m_theme.color(ColorRole::Surface));
    for (QValueAxis *axis : {m_steps, m_values}) {
        axis->setLabelsColor(muted);
        axis->setGridLineColor(m_theme.color(ColorRole::SurfaceRaised));
        axis->setLinePenColor(Qt::transparent);
    }
    QList<PlotLegend::Entry> entries;
    for (auto it = m_lines.cbegin(); it != m_lines.cend(); ++it) {
        it->series->setPen(QPen(m_theme.axisColor(it->axis), 2, it->style));
        entries.append({it.key(), m_theme.axisColor(it->axis), it->style});
    }
    m_legend.setEntries(entries);
    layOut();
    viewport()->update();
}

void IterationChart::resizeEvent(QResizeEvent *event)
{
    layOut();
    QChartView::resizeEvent(event);
    // Labels that lay outside of the old size stay hidden until the plot area changes once more.
    chart()->setPlotArea(chart()->plotArea().adjusted(0, 0, 0, -1));
    layOut();
}

// The names stand below the picture, in as many rows as they need.
void IterationChart::layOut()
{
    const double room = std::max(10.0, width() - 2.0 * kEdge);
    const double names = m_legend.layOut(font(), kEdge, 0, room, kNameRows);
    m_legend.layOut(font(), kEdge, height() - names, room, kNameRows);
    chart()->setPlotArea({kStepsLeft, kStepsTop, std::max(10.0, width() - kStepsLeft - kStepsRight),
                          std::max(10.0, height() - kStepsTop - kStepsBottom - names)});
}

void IterationChart::drawForeground(QPainter *painter, const QRectF &rect)
{
    QChartView::drawForeground(painter, rect);
    painter->setFont(font());
    painter->setPen(m_theme.color(ColorRole::Text));
    painter->drawText(QRectF(0, 0, width(), kStepsTop), Qt::AlignCenter, m_title);
    m_legend.paint(*painter, m_theme.color(ColorRole::Text));
}
