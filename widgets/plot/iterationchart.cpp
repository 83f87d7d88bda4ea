// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/iterationchart.h"

#include "widgets/plot/chartnumbers.h"

#include <QChart>
#include <QLegendMarker>
#include <QLineSeries>
#include <QValueAxis>

#include <algorithm>

using namespace Qt::StringLiterals;

IterationChart::IterationChart(const Theme &theme, const QString &title, QWidget *parent)
    : QChartView(parent)
    , m_theme(theme)
    , m_steps(new QValueAxis(this))
    , m_values(new QValueAxis(this))
{
    chart()->setTitle(title);
    writeNumbers(*chart());
    chart()->setAnimationOptions(QChart::NoAnimation);
    chart()->setBackgroundVisible(false);
    chart()->setMargins({0, 0, 4, 0});
    chart()->legend()->setAlignment(Qt::AlignTop);
    chart()->addAxis(m_steps, Qt::AlignBottom);
    chart()->addAxis(m_values, Qt::AlignLeft);
    m_steps->setLabelFormat(u"%d"_s);
    m_values->setLabelFormat(u"%g"_s);
    m_steps->setRange(0, 5);
    m_values->setRange(0, 1);
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
    m_high = 0;
    m_lastStep = 1;
    m_steps->setRange(0, 5);
    m_values->setRange(0, 1);
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
    m_steps->setRange(0, std::max(5, m_lastStep));
    m_steps->applyNiceNumbers();
    m_values->setRange(0, m_high > 0 ? m_high : 1);
    m_values->applyNiceNumbers();
}

void IterationChart::applyTheme()
{
    const QColor muted = m_theme.color(ColorRole::Muted);
    setBackgroundBrush(m_theme.color(ColorRole::Surface));
    chart()->setTitleBrush(m_theme.color(ColorRole::Text));
    chart()->legend()->setLabelColor(m_theme.color(ColorRole::Text));
    for (QValueAxis *axis : {m_steps, m_values}) {
        axis->setLabelsColor(muted);
        axis->setGridLineColor(m_theme.color(ColorRole::SurfaceRaised));
        axis->setLinePenColor(Qt::transparent);
    }
    for (const Line &line : std::as_const(m_lines))
        line.series->setPen(QPen(m_theme.axisColor(line.axis), 2, line.style));
    const auto markers = chart()->legend()->markers();
    for (QLegendMarker *marker : markers)
        marker->setPen(QPen(Qt::transparent));  // without any pen, the style's default would return
}
