// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/tune/gaincard.h"

#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/theme/theme.h"

#include <QGridLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>

#include <cmath>

using namespace Qt::StringLiterals;

GainCard::GainCard(LiveModel &live, std::shared_ptr<const GainShape> shape, QWidget *parent)
    : Card(tr("Simplified tuning"), parent)
    , m_live(live)
    , m_shape(std::move(shape))
{
    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(Metric::kGap);
    grid->setVerticalSpacing(Metric::kUnit);
    grid->setColumnStretch(1, 1);
    int line = 0;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        Row &row = m_rows[axis];
        const QString name = axisLabel(kAxes[axis]);
        auto *head = new QLabel(name);
        head->setObjectName(u"section"_s);
        row.shape = new QLabel;
        row.shape->setObjectName(u"muted"_s);
        row.shape->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        row.shape->setToolTip(tr("f₀ = √(Ki/Kd) / 2π, d = Kp / (2 √(Kd·Ki)), τ = 1570.8 ms / (1 + Ki)"));
        grid->addWidget(head, line, 0);
        grid->addWidget(row.shape, line++, 1, 1, 2);
        const auto slider = [&](const QString &label, QSlider *&box, QLabel *&text) {
            box = new QSlider(Qt::Horizontal);
            box->setRange(0, 100);
            box->setPageStep(5);
            box->setAccessibleName(u"%1, %2"_s.arg(label, name));
            text = new QLabel;
            text->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
            text->setMinimumWidth(28);
            auto *caption = new QLabel(label);
            caption->setBuddy(box);
            grid->addWidget(caption, line, 0);
            grid->addWidget(box, line, 1);
            grid->addWidget(text, line++, 2);
            connect(box, &QSlider::valueChanged, this, [this, axis] { onMoved(axis); });
        };
        slider(tr("Damping"), row.damping, row.dampingText);
        slider(tr("Stability"), row.stability, row.stabilityText);
    }
    content()->addLayout(grid);
    auto *formulas = new QLabel(tr(
        "Moving a slider sets all three gains: Kd = 0.8 · D/100, Ki = 2000 · S/100, Kp = √(0.5 · Kd · Ki)."));
    formulas->setObjectName(u"muted"_s);
    formulas->setWordWrap(true);
    content()->addWidget(formulas);
    connect(&live, &LiveModel::valueChanged, this, [this](int parameter) {
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            const auto &gains = m_rows[axis].gains;
            if (std::find(gains.begin(), gains.end(), parameter) != gains.end())
                refresh(axis);
        }
    });
}

void GainCard::setParameters(std::shared_ptr<const ParameterSet> set)
{
    m_set = std::move(set);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        Row &row = m_rows[axis];
        constexpr std::array<char16_t, 3> kGains{u'p', u'i', u'd'};
        for (std::size_t gain = 0; gain < kGains.size(); ++gain) {
            const ParameterSpec *spec = m_set
                ? m_set->find(
                    u"pid.%1.%2"_s.arg(QLatin1String(axisKey(kAxes[axis]))).arg(QChar(kGains[gain])))
                : nullptr;
            row.gains[gain] = spec ? spec->id : -1;
        }
        refresh(axis);
    }
}

std::optional<PidGains> GainCard::gainsOf(const Row &row) const
{
    std::array<double, 3> values{};
    for (std::size_t gain = 0; gain < values.size(); ++gain) {
        const auto raw = row.gains[gain] < 0 ? std::nullopt : m_live.value(row.gains[gain]);
        if (!raw)
            return {};
        values[gain] = m_set->at(row.gains[gain]).toDisplay(*raw);
    }
    return PidGains{values[0], values[1], values[2]};
}

void GainCard::onMoved(std::size_t axis)
{
    const Row &row = m_rows[axis];
    if (m_filling || !m_set || row.gains[0] < 0)
        return;
    const PidGains gains = m_shape->gainsFor(row.damping->value(), row.stability->value());
    const std::array<double, 3> values{gains.kp, gains.ki, gains.kd};
    for (std::size_t gain = 0; gain < values.size(); ++gain)
        m_live.setValue(row.gains[gain], m_set->at(row.gains[gain]).toRaw(values[gain]));
    refresh(axis);
}

void GainCard::refresh(std::size_t axis)
{
    const Row &row = m_rows[axis];
    const auto gains = gainsOf(row);
    for (QWidget *widget : {static_cast<QWidget *>(row.damping), static_cast<QWidget *>(row.stability)})
        widget->setEnabled(gains.has_value());
    if (!gains) {
        row.shape->clear();
        return;
    }
    const auto [damping, stability] = m_shape->slidersFor(*gains);
    m_filling = true;
    // While dragged, a slider stays under the pointer, whatever rounding makes of its value.
    if (!row.damping->isSliderDown())
        row.damping->setValue(int(std::lround(damping)));
    if (!row.stability->isSliderDown())
        row.stability->setValue(int(std::lround(stability)));
    m_filling = false;
    row.dampingText->setText(numberText(damping, 0));
    row.stabilityText->setText(numberText(stability, 0));
    const PidShape shape = m_shape->shapeOf(*gains);
    row.shape->setText(tr("f₀ %1 Hz · d %2 · τ %3 ms")
                           .arg(numberText(shape.frequency, 1))
                           .arg(numberText(shape.damping, 2))
                           .arg(numberText(shape.delayMs, 1)));
}
