// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "protocol/device/steering.h"

#include <QElapsedTimer>
#include <QTimer>

class NumberBox;
class AttitudeView;
class Card;
class ControlPad;
class FunctionsCard;
class GamepadSteering;
class QCheckBox;
class QComboBox;
class QGridLayout;
class QPushButton;
class QSlider;

/// Steering by hand: a pad for two axes, a slider for the third, every mode the board has. It must be armed,
/// and disarms by itself.
class ControlPage final : public Page
{
    Q_OBJECT
public:
    explicit ControlPage(Workspace &workspace, QWidget *parent = nullptr);
    ~ControlPage() override;

    [[nodiscard]] bool isArmed() const { return m_send.isActive(); }
    [[nodiscard]] bool isUnderWay() const override { return isArmed(); }
    void setArmed(bool on);
    [[nodiscard]] QPushButton *armButton() const { return m_arm; }
    [[nodiscard]] ControlPad *pad() const { return m_pad; }
    /// What is sent now.
    [[nodiscard]] SteeringSetpoint setpoint() const;

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeHeader();
    void makeBody();
    [[nodiscard]] Card *makeSteerCard();
    [[nodiscard]] Card *makeAnglesCard();
    void connectAll();
    void connectGamepad();
    void pointWithPad();
    void pointWithRoll(int value);
    void center();
    void onState();
    void onMode();
    void tick();
    void updateNow();
    void pushWithGamepad(const GamepadSnapshot &sticks);
    void takeHold();
    [[nodiscard]] SteeringSetpoint holdingSetpoint(SteeredBefore steeredBefore) const;
    [[nodiscard]] bool wordIsNeeded() const;
    void onWord(bool given);
    [[nodiscard]] bool isLimp() const;
    [[nodiscard]] QString stateText() const;
    void touch();
    void fillInputs();
    void showTargets(const SteeringMode *chosen);
    [[nodiscard]] const Steering *steering() const;
    [[nodiscard]] const SteeringMode *mode() const;
    [[nodiscard]] double axisValue(const SteeringInput &input) const;

    static constexpr auto kSendPeriod = 50ms;  // well below the dead-man limit of 250 ms
    static constexpr int kSliderSteps = 100;

    QComboBox *m_mode;
    QPushButton *m_arm;
    QPushButton *m_center;
    QCheckBox *m_neverPanned;  // the operator's word, for boards that do not say
    ControlPad *m_pad;
    QSlider *m_roll;
    QLabel *m_rollLabel;
    std::array<NumberBox *, kAxisCount> m_angles{};
    std::array<QLabel *, kAxisCount> m_angleLabels{};
    // Whether the target of an axis is known, from the board or the operator. An axis without one is left
    // alone.
    std::array<bool, kAxisCount> m_known{};
    QGridLayout *m_inputs;  // of the steer card
    std::vector<QWidget *> m_rows;  // of what follows
    std::map<QByteArray, NumberBox *> m_moreInputs;  // neither axis nor speed
    std::vector<QComboBox *> m_switches;  // in the order of the board's
    QSlider *m_speed;
    QLabel *m_speedText;
    QLabel *m_state;
    QLabel *m_now;
    AttitudeView *m_attitude;
    FunctionsCard *m_functions;
    GamepadSteering *m_gamepad;
    std::array<double, kAxisCount> m_pushed{};  // by the gamepad, at the last tick
    QTimer m_send;
    QTimer m_refresh;
    QElapsedTimer m_touched;  // since the operator last moved something
    bool m_moved = false;  // by the operator, since arming
    QString m_modesOf;  // the family whose modes are offered
    bool m_filling = false;
};
