// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/spectrumchart.h"

#include <QChart>
#include <QLegendMarker>
#include <QLineSeries>
#include <QLogValueAxis>
#include <QValueAxis>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kLowest = 1.0;            // Hz: what is slower is steering and drift
constexpr double kPointsPerOctave = 48.0;
constexpr double kLeastDecibel = -160.0;
constexpr double kStep = 20.0;             // dB between lines of the grid

double decibel(double density)
{
    return std::max(kLeastDecibel, 10.0 * std::log10(std::max(density, 1e-30)));
}

// The greatest value of all bins that fall on one point: no line is lost by drawing fewer points.
QList<QPointF> pointsOf(const Spectrum &spectrum)
{
    QList<QPointF> points;
    int last = -1;
    for (std::size_t bin = 1; bin < spectrum.density.size(); ++bin) {
        const double hz = spectrum.frequency(bin);
        if (hz < kLowest)
            continue;
        const double level = decibel(spectrum.density[bin]);
        const int place = int(std::log2(hz / kLowest) * kPointsPerOctave);
        if (place == last && level > points.last().y())
            points.last() = {hz, level};
        else if (place != last)
            points.append({hz, level});
        last = place;
    }
    return points;
}

} // namespace

SpectrumChart::SpectrumChart(const Theme &theme, QWidget *parent)
    : QChartView(parent)
    , m_theme(theme)
    , m_frequency(new QLogValueAxis(this))
    , m_level(new QValueAxis(this))
{
    chart()->setAnimationOptions(QChart::NoAnimation);
    chart()->setBackgroundVisible(false);
    chart()->setMargins({0, 0, 4, 0});
    chart()->legend()->setAlignment(Qt::AlignTop);
    chart()->addAxis(m_frequency, Qt::AlignBottom);
    chart()->addAxis(m_level, Qt::AlignLeft);
    m_frequency->setBase(10);
    m_frequency->setMinorTickCount(8);
    m_frequency->setLabelFormat(u"%g Hz"_s);
    m_frequency->setRange(kLowest, 1000);
    m_level->setLabelFormat(u"%g"_s);
    m_level->setRange(-80, 0);
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing);
    setMinimumHeight(180);
    setAccessibleName(tr("Spectrum"));
    viewport()->setAccessibleName(accessibleName());
    connect(&theme, &Theme::changed, this, &SpectrumChart::applyTheme);
    applyTheme();
}

double SpectrumChart::highestFrequency() const
{
    return m_series.isEmpty() ? 0.0 : m_frequency->max();
}

void SpectrumChart::setCurves(const std::vector<SpectrumCurve> &curves, const QString &unit)
{
    while (m_series.size() > qsizetype(curves.size())) {
        chart()->removeSeries(m_series.last());
        delete m_series.takeLast();
    }
    while (m_series.size() < qsizetype(curves.size())) {
        auto *series = new QLineSeries(this);
        chart()->addSeries(series);
        series->attachAxis(m_frequency);
        series->attachAxis(m_level);
        m_series.append(series);
    }
    m_axes.clear();
    double low = 0.0;
    double high = kLeastDecibel;
    double highest = 10.0;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const QList<QPointF> points = pointsOf(curves[i].spectrum);
        m_series[qsizetype(i)]->setName(curves[i].name);
        m_series[qsizetype(i)]->replace(points);
        m_axes.append(curves[i].axis);
        highest = std::max(highest, curves[i].spectrum.rate / 2);
        for (const QPointF &point : points) {
            low = std::min(low, point.y());
            high = std::max(high, point.y());
        }
    }
    m_frequency->setRange(kLowest, highest);
    if (high > low) {
        // Whole steps, so that the scale does not dance with the noise.
        const double top = std::ceil(high / kStep) * kStep;
        const double bottom = std::max(std::floor(low / kStep) * kStep, top - 6 * kStep);
        m_level->setRange(bottom, top);
        m_level->setTickCount(int((top - bottom) / kStep) + 1);
    }
    m_level->setTitleText(unit.isEmpty() ? tr("dB") : tr("dB of (%1)²/Hz").arg(unit));
    applyTheme();
}

void SpectrumChart::applyTheme()
{
    const QColor muted = m_theme.color(ColorRole::Muted);
    setBackgroundBrush(m_theme.color(ColorRole::Surface));
    chart()->legend()->setLabelColor(m_theme.color(ColorRole::Text));
    for (QAbstractAxis *axis : {static_cast<QAbstractAxis *>(m_frequency), static_cast<QAbstractAxis *>(m_level)}) {
        axis->setLabelsColor(muted);
        axis->setTitleBrush(muted);
        axis->setGridLineColor(m_theme.color(ColorRole::SurfaceRaised));
        axis->setMinorGridLineColor(m_theme.color(ColorRole::SurfaceRaised));
        axis->setLinePenColor(Qt::transparent);
    }
    for (qsizetype i = 0; i < m_axes.size(); ++i) {
        const Axis axis = m_axes[i];
        m_series[i]->setPen(QPen(axis == Axis::None ? m_theme.seriesColor(int(i)) : m_theme.axisColor(axis), 1));
    }
    const auto markers = chart()->legend()->markers();
    for (QLegendMarker *marker : markers)
        marker->setPen(QPen(Qt::transparent));   // no pen at all would bring the style's own back
}
