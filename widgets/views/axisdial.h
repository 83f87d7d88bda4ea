// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/theme/theme.h"

#include <QWidget>

/// One axis at a glance: angle and target on a dial, motor power as a bar, the numbers beside.
class AxisDial final : public QWidget
{
    Q_OBJECT
public:
    AxisDial(const Theme &theme, Axis axis, QWidget *parent = nullptr);

    /// Degrees and percent; NaN = not known.
    void setValues(double angle, double target, double power);
    void setLimits(double low, double high);
    [[nodiscard]] QSize sizeHint() const override { return {200, 190}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {150, 160}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    const Theme &m_theme;
    Axis m_axis;
    double m_angle = 0;
    double m_target = 0;
    double m_power = 0;
    double m_low = 0;
    double m_high = 0;
    bool m_valid = false;
};
