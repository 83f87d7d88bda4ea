// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/theme/theme.h"

#include <QWidget>

#include <optional>

/// The battery: its voltage, on a bar with the voltages below which the board does something.
class BatteryView final : public QWidget
{
    Q_OBJECT
public:
    explicit BatteryView(const Theme &theme, QWidget *parent = nullptr);

    /// Volts; NaN = not known. @param counted cells that the board counts; 0: it tells none
    void setVolts(double volts, int counted = 0);
    /// Volts of the whole battery, or of each cell; those that are set.
    void setThresholds(std::optional<double> alarm, std::optional<double> motorsOff, bool perCell);

    /// Volts of each cell below which the program warns, whatever the board does.
    void setLowCell(double volts);

    enum class State { Unknown, Good, Low, Empty };
    [[nodiscard]] State state() const;
    /// What is said of the limits.
    [[nodiscard]] QString thresholdText() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {150, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    [[nodiscard]] std::optional<double> alarm() const;
    [[nodiscard]] std::optional<double> motorsOff() const { return whole(m_motorsOff); }
    [[nodiscard]] std::optional<double> whole(const std::optional<double> &volts) const;
    [[nodiscard]] QString cellText() const;
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] bool isAlarmOfOtherBattery() const;
    void tell();

    const Theme &m_theme;
    double m_volts;
    int m_cells = 0;  // counted once: it does not lose one by emptying
    int m_counted = 0;
    std::optional<double> m_alarm;
    std::optional<double> m_motorsOff;
    bool m_perCell = false;
    double m_lowCell = 0;
};
