// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/parameterbox.h"

#include "widgets/models/parametermodel.h"

#include <algorithm>
#include <cmath>

ParameterBox::ParameterBox(const ParameterSpec &spec, QWidget *parent)
    : NumberBox(parent)
    , m_spec(spec)
{
    setDecimals(spec.row->decimals);
    setRange(spec.toDisplay(spec.row->min), spec.toDisplay(spec.row->max));
    setSingleStep(std::abs(spec.row->scale));
    setAlignment(Qt::AlignRight);
    setButtonSymbols(QAbstractSpinBox::NoButtons);
}

// NaN stands below the range.
void ParameterBox::showRaw(double raw)
{
    double low = m_spec.toDisplay(m_spec.row->min);
    double high = m_spec.toDisplay(m_spec.row->max);
    if (std::isnan(raw)) {
        low -= std::pow(10.0, -decimals());
        setRange(low, high);
        setSpecialValueText(parameterValueText(m_spec, raw));
        setValue(low);
        return;
    }
    // A board may hold a value outside the documented range; it is shown as it is.
    const double display = m_spec.toDisplay(raw);
    setSpecialValueText(QString());
    setRange(std::min(low, display), std::max(high, display));
    setValue(display);
}

void ParameterBox::stepBy(int steps)
{
    if (isRefused())
        NumberBox::stepBy(steps);
    else if (isFloat())
        setValue(value() + steps * std::pow(10.0, -decimals()));
    else
        setValue(m_spec.toDisplay(m_spec.clamped(m_spec.toRaw(value()) + steps * m_spec.row->step)));
    selectAll();
}

double ParameterBox::nearestTo(double value) const
{
    if (!isFloat())
        return m_spec.toDisplay(m_spec.clamped(m_spec.toRaw(value)));
    const double shown = NumberBox::nearestTo(value);
    return std::clamp(shown, m_spec.toDisplay(m_spec.row->min), m_spec.toDisplay(m_spec.row->max));
}

// Where a count is coarser than the decimals shown, the nearest one stands for what was typed.
bool ParameterBox::isSame(double typed, double nearest) const
{
    const double count = isFloat() ? 0.0 : std::abs(m_spec.row->scale);
    return NumberBox::isSame(typed, nearest)
        || (count > 1.001 * std::pow(10.0, -decimals())
            && NumberBox::isSame(typed, NumberBox::nearestTo(typed))
            && std::abs(typed - nearest) <= 0.5001 * count);
}

QString ParameterBox::rangeText() const
{
    return parameterRangeText(m_spec);
}
