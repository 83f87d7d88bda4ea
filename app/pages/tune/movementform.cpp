// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/tune/movementform.h"

#include "widgets/forms/formrows.h"
#include "widgets/forms/numberbox.h"

#include <QLabel>

using namespace Qt::StringLiterals;

namespace {

NumberBox *makeField(double low, double high, double value, int decimals, const QString &suffix)
{
    auto *field = new NumberBox(low, high, decimals, suffix);
    field->setSingleStep(decimals ? 0.1 : 1);
    field->setValue(value);
    return field;
}

}  // namespace

MovementForm::MovementForm()
    : m_degrees(makeField(0.2, MotionTestPlan::kMaxDegrees, 2, 1, tr("°")))
    , m_count(makeField(2, 40, 6, 0, {}))
    , m_rest(makeField(0.3, 5, 1, 1, tr(" s")))
    , m_from(makeField(0.1, 20, 0.5, 1, tr(" Hz")))
    , m_to(makeField(1, 20, 15, 1, tr(" Hz")))
    , m_seconds(makeField(5, 120, 20, 0, tr(" s")))
    , m_limit(makeField(0.5, 20, 4, 1, tr("°")))
{
    m_degrees->setToolTip(tr("How far the axis is moved; as small as can still be told from its noise"));
    m_count->setSingleStep(2);
    m_limit->setToolTip(
        tr("If the axis moves further than this beyond the movement itself, the motors are switched off"));
    addRow(tr("Movement"), m_degrees);
    addRow(tr("Steps"), m_count);
    addRow(tr("Rest between"), m_rest);
    addRow(tr("From"), m_from);
    addRow(tr("To"), m_to);
    addRow(tr("Duration"), m_seconds);
    addRow(tr("Stop beyond"), m_limit);
    alignLabels(*this);
    for (QWidget *field :
         {static_cast<QWidget *>(m_degrees), static_cast<QWidget *>(m_count), static_cast<QWidget *>(m_rest),
          static_cast<QWidget *>(m_from), static_cast<QWidget *>(m_to), static_cast<QWidget *>(m_seconds),
          static_cast<QWidget *>(m_limit)})
        field->setAccessibleName(static_cast<QLabel *>(labelForField(field))->text());
}

void MovementForm::showFor(std::optional<MotionTestPlan::Kind> kind)
{
    const auto show = [this](QWidget *field, bool visible) {
        field->setVisible(visible);
        labelForField(field)->setVisible(visible);
    };
    show(m_degrees, kind.has_value());
    show(m_count, kind == MotionTestPlan::Kind::Steps);
    show(m_rest, kind == MotionTestPlan::Kind::Steps);
    show(m_from, kind == MotionTestPlan::Kind::Sweep);
    show(m_to, kind == MotionTestPlan::Kind::Sweep);
    show(m_seconds, kind != MotionTestPlan::Kind::Steps);
    show(m_limit, kind.has_value());
}

MotionTestPlan MovementForm::plan(MotionTestPlan::Kind kind, Axis axis) const
{
    MotionTestPlan plan;
    plan.kind = kind;
    plan.axis = axis;
    plan.degrees = m_degrees->value();
    plan.steps = int(m_count->value());
    plan.rest = m_rest->value();
    plan.fromHz = m_from->value();
    plan.toHz = m_to->value();
    plan.sweepSeconds = m_seconds->value();
    plan.limit = m_limit->value();
    return plan;
}

double MovementForm::degrees() const
{
    return m_degrees->value();
}

double MovementForm::seconds() const
{
    return m_seconds->value();
}
