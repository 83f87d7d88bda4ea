// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"
#include "protocol/analysis/stepresponse.h"
#include "widgets/views/card.h"

#include <optional>
#include <utility>
#include <vector>

class CurveChart;
class NumberBox;
class QComboBox;
class QLabel;
class QPushButton;

/// Pushes one stick to and fro while something that flies is armed in a test stand, and shows how its angle
/// or rate follows; the gains of that axis stand beside it.
class StickStepCard final : public Card
{
    Q_OBJECT
public:
    static constexpr auto kHold = 700ms;  ///< for which the stick is held on either side
    static constexpr int kSides = 8;

    explicit StickStepCard(Workspace &workspace, QWidget *parent = nullptr);

    /// It may be started: motors that stand answer nothing. @param throttle 0 to 1
    void setReady(bool isArmed, double throttle);
    void start(TimePoint now);
    void cancel();
    [[nodiscard]] bool isRunning() const { return m_begun.has_value(); }
    /// To be called with each set-point.
    void advance(TimePoint now);
    /// The stick that is pushed now, and how far, -1 to 1.
    [[nodiscard]] std::optional<std::pair<Axis, double>> stick() const;
    /// What was measured last.
    [[nodiscard]] const std::optional<StepMeasurement> &measured() const { return m_measured; }
    [[nodiscard]] QComboBox *axisChoice() const { return m_axis; }
    [[nodiscard]] QPushButton *startButton() const { return m_start; }
    [[nodiscard]] const std::array<NumberBox *, 3> &gains() const { return m_gains; }

private:
    [[nodiscard]] Axis axis() const;
    void fillGains();
    void onGain(std::size_t gain);
    void measure();
    void draw();

    Workspace &m_workspace;
    QComboBox *m_axis;
    QComboBox *m_quantity;
    NumberBox *m_size;
    QPushButton *m_start;
    QLabel *m_figures;
    QLabel *m_text;
    CurveChart *m_chart;
    std::array<NumberBox *, 3> m_gains{};  // P, I, D
    std::array<int, 3> m_parameters{-1, -1, -1};
    bool m_filling = false;
    std::optional<TimePoint> m_begun;
    double m_pushed = 0;
    std::vector<std::pair<TimePoint, double>> m_sent;
    std::optional<StepMeasurement> m_measured;
    std::vector<StepMeasurement> m_before;  // faint
};
