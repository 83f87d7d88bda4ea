// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/pages/page.h"

#include <QElapsedTimer>
#include <QTimer>

class AttitudeView;
class Card;
class ControlPad;
class QComboBox;
class QDoubleSpinBox;
class QPushButton;
class QSlider;

/// Steering by hand: a pad for two axes, a slider for the third, every mode the board has. Armed on purpose;
/// lets go by itself.
class ControlPage final : public Page
{
    Q_OBJECT
public:
    explicit ControlPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] bool isArmed() const;
    void setArmed(bool on);
    [[nodiscard]] QPushButton *armButton() const { return m_arm; }
    [[nodiscard]] ControlPad *pad() const { return m_pad; }
    [[nodiscard]] QComboBox *modeBox() const { return m_mode; }
    /// What is sent now.
    [[nodiscard]] ControlSetpoint setpoint() const;

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void onState();
    void onMode();
    void fillFunctions();
    void tick();
    void updateNow();
    [[nodiscard]] const ControlMode *mode() const;

    QComboBox *m_mode;
    QPushButton *m_arm;
    QPushButton *m_center;
    ControlPad *m_pad;
    QSlider *m_roll;
    std::array<QDoubleSpinBox *, kAxisCount> m_angles{};
    QSlider *m_speed;
    QLabel *m_speedText;
    QLabel *m_state;
    QLabel *m_now;
    AttitudeView *m_attitude;
    Card *m_functions;  // what else is at hand while steering
    QTimer m_send;
    QTimer m_refresh;
    QElapsedTimer m_touched;  // since the operator last moved something
    bool m_filling = false;
};
