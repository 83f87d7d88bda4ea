// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/tune/responsecharts.h"

#include "widgets/plot/curvechart.h"

#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

ResponseCharts::ResponseCharts(const Theme &theme, QWidget *parent)
    : QStackedWidget(parent)
    , m_steps(new CurveChart(theme, tr("Step response")))
    , m_gain(new CurveChart(theme, tr("Gain")))
    , m_phase(new CurveChart(theme, tr("Phase")))
    , m_coherence(new CurveChart(theme, tr("Coherence")))
{
    auto *bode = new QWidget;
    auto *charts = new QVBoxLayout(bode);
    charts->setContentsMargins(0, 0, 0, 0);
    charts->setSpacing(2);
    charts->addWidget(m_gain, 4);
    charts->addWidget(m_phase, 4);
    charts->addWidget(m_coherence, 3);
    m_coherence->setMinimumHeight(110);
    m_steps->setHint(tr("Arm, then Start: the axis steps back and forth, and its response appears here."));
    m_gain->setHint(
        tr("Arm, then Start: the axis sways faster and faster, and how it follows appears here."));
    addWidget(m_steps);
    addWidget(bode);
}

void ResponseCharts::showKind(ResponseRecord::Kind kind)
{
    setCurrentIndex(kind == ResponseRecord::Kind::Steps ? 0 : 1);
}

void ResponseCharts::setRecords(const std::vector<ResponseRecord> &records)
{
    drawSteps(records);
    drawBode(records);
}

void ResponseCharts::drawSteps(const std::vector<ResponseRecord> &records)
{
    QList<ChartCurve> curves;
    double last = 1000.0;
    double high = 1.4;
    bool newest = true;
    for (std::size_t i = records.size(); i-- > 0;) {
        const ResponseRecord &record = records[i];
        if (record.kind != ResponseRecord::Kind::Steps || !record.shown)
            continue;
        curves.append(stepCurves(record, int(i), std::exchange(newest, false)));
        last = std::max(curves.size() == 1 ? 0.0 : last,
                        1000.0 * double(record.steps.mean.size()) / record.rate);
        for (const float value : record.steps.mean)
            high = std::max(high, std::ceil(double(value) * 5.0 + 0.5) / 5.0);
    }
    m_steps->setScales(
        {{}, 0, std::ceil(last / 100.0) * 100.0, false, tr("%g ms"), 0},
        {tr("Share of the way"), -0.2, high, false, u"%.1f"_s, int(std::lround((high + 0.2) / 0.2))});
    m_steps->setCurves(curves);
}

void ResponseCharts::drawBode(const std::vector<ResponseRecord> &records)
{
    QList<ChartCurve> gain;
    QList<ChartCurve> phase;
    QList<ChartCurve> coherence;
    double highest = 10;
    double lowPhase = -180;
    double lowGain = -20;
    double highGain = 10;
    bool newest = true;
    for (std::size_t i = records.size(); i-- > 0;) {
        const ResponseRecord &record = records[i];
        if (record.kind != ResponseRecord::Kind::Frequency || !record.shown)
            continue;
        const bool first = std::exchange(newest, false);
        gain.append(bodeCurve(record, BodePart::Gain, int(i), first));
        phase.append(bodeCurve(record, BodePart::Phase, int(i), first));
        coherence.append(bodeCurve(record, BodePart::Coherence, int(i), first));
        highest = std::max(highest, record.toHz);
        for (const QPointF &point : gain.last().points) {
            lowGain = std::min(lowGain, std::floor(point.y() / 10.0) * 10.0);
            highGain = std::max(highGain, std::ceil(point.y() / 10.0) * 10.0);
        }
        for (const QPointF &point : phase.last().points)
            lowPhase = std::min(lowPhase, std::floor(point.y() / 90.0) * 90.0);
    }
    lowGain = std::max(lowGain, -60.0);
    lowPhase = std::max(lowPhase, -540.0);
    const ChartScale hertz{{}, 0.3, highest, true, tr("%g Hz"), 0};
    m_gain->setScales(
        hertz,
        {tr("Gain, dB"), lowGain, highGain, false, u"%.0f"_s, int(std::lround((highGain - lowGain) / 10.0))});
    m_phase->setScales(
        hertz, {tr("Phase, °"), lowPhase, 90, false, u"%.0f"_s, int(std::lround((90 - lowPhase) / 90.0))});
    m_coherence->setScales(hertz, {tr("Coherence"), 0, 1, false, u"%.1f"_s, 2});
    m_gain->setCurves(gain);
    m_phase->setCurves(phase);
    m_coherence->setCurves(coherence);
}
