// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/theme/theme.h"

#include <QWidget>

#include <optional>
#include <utility>

/// One axis at a glance: angle and target on a dial with the limits, whether it follows, motor power as a
/// bar, the numbers below.
class AxisDial final : public QWidget
{
    Q_OBJECT
public:
    AxisDial(const Theme &theme, Axis axis, QWidget *parent = nullptr);

    /// Degrees and percent; NaN = not known.
    void setValues(double angle, double target, double power);
    /// Degrees that steering reaches, low and high; empty = not known.
    void setLimits(const std::optional<std::pair<double, double>> &limits);
    /// Whether the axis follows the frame or keeps its direction; empty = not known.
    void setFollows(std::optional<bool> follows);
    /// Whether its motor works; one that does not neither follows nor holds. Empty = not known.
    void setDriven(std::optional<bool> driven);
    /// What is said of it: "holds".
    [[nodiscard]] QString guideText() const;
    [[nodiscard]] std::optional<std::pair<double, double>> limits() const { return m_limits; }
    [[nodiscard]] std::optional<bool> follows() const { return m_follows; }
    [[nodiscard]] QSize sizeHint() const override { return {200, 190}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {150, 160}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void tell();
    void explain();

    const Theme &m_theme;
    Axis m_axis;
    double m_angle = 0;
    double m_target = 0;
    double m_power = 0;
    std::optional<std::pair<double, double>> m_limits;
    std::optional<bool> m_follows;
    std::optional<bool> m_driven;
    bool m_valid = false;
};
