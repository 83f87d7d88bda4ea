// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/parameterspec.h"
#include "widgets/forms/numberbox.h"

/// A number box for one parameter, as it is declared. It works in raw counts: each step is one count on the
/// wire, or for a float one unit of the last decimal.
class ParameterBox final : public NumberBox
{
    Q_OBJECT
public:
    explicit ParameterBox(const ParameterSpec &spec, QWidget *parent = nullptr);

    /// Shows what the board holds, in range or not; NaN as a word, which whatever is typed replaces.
    void showRaw(double raw);
    void stepBy(int steps) override;

protected:
    [[nodiscard]] double nearestTo(double value) const override;
    [[nodiscard]] bool isSame(double typed, double nearest) const override;
    [[nodiscard]] QString rangeText() const override;

private:
    [[nodiscard]] bool isFloat() const { return m_spec.row->wire == WireType::F32; }

    const ParameterSpec &m_spec;
};
