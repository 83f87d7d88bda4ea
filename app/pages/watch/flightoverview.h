// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/theme/theme.h"

#include <QWidget>

class ArmedState;
class AttitudeView;
class MotorDiagram;
class QLabel;
class QPushButton;
class Workspace;

/// A flying machine at a glance: whether its propellers may turn, its horizon and heading, its motors.
class FlightOverview final : public QWidget
{
    Q_OBJECT
public:
    explicit FlightOverview(Workspace &workspace, QWidget *parent = nullptr);

    /// Shows what was told last.
    void refresh();
    [[nodiscard]] ArmedState *state() const { return m_state; }
    [[nodiscard]] AttitudeView *attitude() const { return m_attitude; }
    [[nodiscard]] MotorDiagram *motors() const { return m_motors; }

signals:
    void calibrationWanted();

private:
    Workspace &m_workspace;
    ArmedState *m_state;
    QPushButton *m_calibrate;
    AttitudeView *m_attitude;
    QLabel *m_hint;
    QLabel *m_motorsHint;
    MotorDiagram *m_motors;
};

/// A row of a table about what such a machine tells.
struct FlightFact
{
    QString name;
    QString text;
    ColorRole role = ColorRole::Text;
};

/// Of its battery, its processor and how it receives; a percentage is kept within 0 to 100, with what was
/// reported beside it.
[[nodiscard]] QList<FlightFact> flightFacts(Workspace &workspace);
[[nodiscard]] QList<FlightFact> flightLink(const Workspace &workspace);
