// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// Rows of a table about what such a machine tells of its battery, its processor and how it receives;
/// a percentage is kept within 0 to 100, with what was reported beside it.
[[nodiscard]] QList<std::pair<QString, QString>> flightFacts(Workspace &workspace);
[[nodiscard]] QList<std::pair<QString, QString>> flightLink(const Workspace &workspace);
