// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/board/stickstepcard.h"

#include "protocol/telemetry/telemetrystore.h"
#include "protocol/telemetry/uniformsamples.h"
#include "widgets/forms/numberbox.h"
#include "widgets/models/errortext.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/plot/curvechart.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t kShownBefore = 4;
constexpr double kLeastThrottle = 0.05;
constexpr double kGainStep = 0.05;  // of the value, by the arrows
constexpr int kGainDecimals = 8;
constexpr int kFigureDecimals = 2;
constexpr double kShare = 100;
constexpr double kFaint = 0.35;
constexpr int kChartHeight = 132;
constexpr double kRoomAbove = 1.5;  // of the step
constexpr double kRoomBelow = -0.5;
constexpr int kGridParts = 4;  // with room for their numbers in a low window

}  // namespace

StickStepCard::StickStepCard(Workspace &workspace, QWidget *parent)
    : Card(tr("Step response"), parent)
    , m_workspace(workspace)
    , m_axis(new QComboBox)
    , m_quantity(new QComboBox)
    , m_size(new NumberBox(2, 50, 0, tr(" %")))
    , m_start(new QPushButton(tr("Push the stick")))
    , m_figures(new QLabel)
    , m_text(new QLabel)
    , m_chart(new CurveChart(workspace.theme(), tr("Step response")))
{
    for (const Axis each : kAxes)
        m_axis->addItem(axisLabel(each), int(each));
    m_axis->setAccessibleName(tr("Axis"));
    m_quantity->addItems({tr("Angle"), tr("Rate")});
    m_quantity->setAccessibleName(tr("What follows the stick"));
    m_quantity->setToolTip(
        tr("Stabilised, roll and pitch follow the stick by their angle; yaw, and all axes in "
           "rate mode, by their rate."));
    m_size->setValue(10);
    m_size->setAccessibleName(tr("How far the stick is pushed"));
    m_start->setToolTip(tr("Pushes the stick of this axis to both sides by turns, for some seconds. Give it "
                           "throttle first. A stand has to hold it."));
    for (QLabel *label : {m_figures, m_text}) {
        label->setWordWrap(true);
        label->setObjectName(u"muted"_s);
    }
    m_chart->setMinimumHeight(kChartHeight);
    // The unit is in the numbers: a title beneath them would need a line that low windows do not have.
    m_chart->setScales(
        {.title = {}, .low = 0, .high = seconds(kHold), .labelFormat = tr("%.1f s")},
        {.title = {}, .low = kRoomBelow, .high = kRoomAbove, .labelFormat = u"%.1f"_s, .steps = kGridParts});
    m_chart->setHint(tr("Arm it, give it throttle, then push the stick."));
    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(Metric::kGap);
    grid->addWidget(m_axis, 0, 0);
    grid->addWidget(m_quantity, 0, 1);
    grid->addWidget(m_size, 0, 2);
    grid->addWidget(m_start, 1, 0, 1, 3);
    const std::array<const char *, 3> names{"P", "I", "D"};
    for (std::size_t gain = 0; gain < m_gains.size(); ++gain) {
        m_gains[gain] = new NumberBox;
        m_gains[gain]->setDecimals(kGainDecimals);
        m_gains[gain]->setPrefix(QLatin1String(names[gain]) + u' ');
        m_gains[gain]->setAccessibleName(tr("Gain %1").arg(QLatin1String(names[gain])));
        grid->addWidget(m_gains[gain], 2, int(gain));
        connect(m_gains[gain], &QDoubleSpinBox::valueChanged, this, [this, gain] { onGain(gain); });
    }
    grid->addWidget(m_figures, 3, 0, 1, 3);
    content()->addLayout(grid);
    content()->addWidget(m_chart, 1);
    content()->addWidget(m_text);
    connect(m_start, &QPushButton::clicked, this, [this] { start(Clock::now()); });
    connect(m_axis, &QComboBox::currentIndexChanged, this, [this] {
        m_quantity->setCurrentIndex(axis() == Axis::Yaw ? 1 : m_quantity->currentIndex());
        m_before.clear();
        m_measured.reset();
        draw();
        fillGains();
    });
    connect(&workspace.live(), &LiveModel::modelReset, this, &StickStepCard::fillGains);
    connect(&workspace.live(), &LiveModel::valueChanged, this, &StickStepCard::fillGains);
    fillGains();
}

Axis StickStepCard::axis() const
{
    return Axis(m_axis->currentData().toInt());
}

// Those to tune with of the chosen axis, in the order of the table: P, I, D.
void StickStepCard::fillGains()
{
    const LiveModel &live = m_workspace.live();
    m_parameters.fill(-1);
    m_filling = true;
    QStringList figures;
    std::size_t next = 0;
    const ConfigurationModel &shown = m_workspace.configuration();
    for (const int id : shown.isEmpty() ? QList<int>() : live.parameters()) {
        const ParameterSpec &spec = shown.board().parameters().at(id);
        if (spec.axis == axis() && next < m_gains.size() && spec.key.startsWith(u"pid."_s))
            m_parameters[next++] = id;
    }
    for (std::size_t gain = 0; gain < m_gains.size(); ++gain) {
        const int id = m_parameters[gain];
        const std::optional<double> held = id < 0 ? std::nullopt : live.value(id);
        m_gains[gain]->setEnabled(held.has_value());
        if (!held)
            continue;
        const double value = held.value_or(0.0);
        const auto [low, high] = live.range(id);
        m_gains[gain]->setRange(low, high);
        m_gains[gain]->setSingleStep(std::max(1e-8, std::abs(value) * kGainStep));
        m_gains[gain]->setValue(value);
        const ParameterSpec &spec = shown.board().parameters().at(id);
        if (const auto figure = shown.board().textFigure(spec, value))
            figures.append(numberText(*figure, kFigureDecimals));
    }
    m_figures->setText(tr("In the text's numbers: %1").arg(figures.join(u" · "_s)));
    m_figures->setVisible(!figures.isEmpty());
    m_filling = false;
}

void StickStepCard::onGain(std::size_t gain)
{
    if (m_filling || m_parameters[gain] < 0)
        return;
    m_workspace.live().setValue(m_parameters[gain], double(float(m_gains[gain]->value())));
}

void StickStepCard::setReady(bool isArmed, double throttle)
{
    const bool turns = throttle >= kLeastThrottle;
    m_start->setEnabled(isArmed && turns && !isRunning());
    m_start->setText(isArmed && !turns ? tr("Push the stick: throttle first") : tr("Push the stick"));
}

void StickStepCard::start(TimePoint now)
{
    if (isRunning())
        return;
    m_begun = now;
    m_sent.clear();
    m_text->setText(tr("The stick is pushed to both sides."));
    advance(now);
}

void StickStepCard::cancel()
{
    if (!isRunning())
        return;
    m_begun.reset();
    m_text->setText(tr("Broken off: it was disarmed."));
}

std::optional<std::pair<Axis, double>> StickStepCard::stick() const
{
    return isRunning() ? std::optional(std::pair(axis(), m_pushed)) : std::nullopt;
}

void StickStepCard::advance(TimePoint now)
{
    if (!isRunning())
        return;
    const auto side = int((now - *m_begun) / kHold);
    if (side >= kSides) {
        measure();
        m_begun.reset();
        return;
    }
    m_pushed = (side % 2 == 0 ? -1 : 1) * m_size->value() / kShare;
    m_sent.emplace_back(now, m_pushed);
}

void StickStepCard::measure()
{
    const auto store = m_workspace.client().telemetry();
    const ChannelRoles &roles = m_workspace.roles();
    const auto index = std::size_t(axis());
    const int channel = m_quantity->currentIndex() == 0 ? roles.angle[index] : roles.gyro[index];
    const double from = store->secondsAt(m_sent.front().first);
    const auto samples = uniformSamples(*store, channel, -1, from, store->secondsAt(m_sent.back().first));
    if (!samples) {
        m_text->setText(describe(samples.error()).oneLine());
        return;
    }
    std::vector<float> command;
    std::size_t at = 0;
    for (std::size_t i = 0; i < samples->values.size(); ++i) {
        const double time = samples->start + double(i) / samples->rate;
        while (at + 1 < m_sent.size() && store->secondsAt(m_sent[at + 1].first) <= time)
            ++at;
        command.push_back(float(m_sent[at].second));
    }
    const auto measured = measureCommandSteps(command, samples->values, samples->rate, seconds(kHold) * 0.95);
    if (!measured) {
        m_text->setText(describe(measured.error()).oneLine());
        return;
    }
    if (m_measured) {
        m_before.push_back(*m_measured);
        if (m_before.size() > kShownBefore)
            m_before.erase(m_before.begin());
    }
    m_measured = *measured;
    draw();
    const StepMetrics &metrics = measured->metrics;
    const auto ms = [](const std::optional<double> &time) {
        return time ? tr("%1 ms").arg(numberText(*time * 1000, 0)) : tr("not reached");
    };
    m_text->setText(
        tr("Rise %1, overshoot %2 %, settled after %3.")
            .arg(ms(metrics.riseSeconds), numberText(metrics.overshoot, 0), ms(metrics.settlingSeconds)));
}

void StickStepCard::draw()
{
    QList<ChartCurve> curves;
    const auto add = [&](const StepMeasurement &measurement, double strength, double width) {
        ChartCurve curve;
        curve.axis = axis();
        curve.strength = strength;
        curve.width = width;
        for (std::size_t i = 0; i < measurement.mean.size(); ++i)
            curve.points.append({seconds(kHold) * 0.95 * double(i) / double(measurement.mean.size()),
                                 double(measurement.mean[i])});
        curves.append(curve);
    };
    for (const StepMeasurement &each : m_before)
        add(each, kFaint, 1);
    if (m_measured)
        add(*m_measured, 1, 2);
    m_chart->setCurves(curves);
}
