// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "widgets/gamepad/gamepaddetector.h"

class NumberBox;
class QCheckBox;
class QComboBox;
class QGridLayout;
class QPushButton;
class StickBar;

/// The gamepad: which stick steers what and how, found out by moving it; kept for each kind of gamepad.
class GamepadPage final : public Page
{
    Q_OBJECT
public:
    explicit GamepadPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] bool isUnderWay() const override { return m_detector.has_value(); }
    /// Waits for the stick, or the button, that shall do this.
    void assign(GamepadStick stick);
    void assign(GamepadButton button);
    /// All sticks, one after the other.
    void assignAll();

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    struct StickRow
    {
        StickBar *bar = nullptr;
        QLabel *axis = nullptr;
        QCheckBox *inverted = nullptr;
        NumberBox *deadBand = nullptr;
        NumberBox *expo = nullptr;
        QPushButton *assign = nullptr;
    };
    struct ButtonRow
    {
        QLabel *state = nullptr;
        QPushButton *assign = nullptr;
    };
    void makeHeader();
    void makeBody();
    void addStick(QGridLayout &grid, GamepadStick stick);
    void addButton(QGridLayout &grid, GamepadButton button);
    void connectAll();
    void begin(GamepadDetector::Wanted wanted);
    void next();
    void askFrom(std::size_t stick);
    void cancel();
    void endTask();
    void look();
    void take(const GamepadDetector::Found &found);
    void fill();
    void fillPads();
    void fillRows(const GamepadMapping &mapping);
    void applyFields();
    void updateTask();
    void updateSentence();
    [[nodiscard]] QString standardText() const;

    Gamepad &m_gamepad;
    QComboBox *m_pads;
    QPushButton *m_all;
    QPushButton *m_standard;
    QPushButton *m_skip;
    QPushButton *m_cancel;
    QLabel *m_sentence;
    QLabel *m_task;
    std::array<StickRow, kGamepadSticks> m_sticks;
    std::array<ButtonRow, kGamepadButtons> m_buttons;
    QTimer m_look;
    std::optional<GamepadDetector> m_detector;  // something is waited for
    std::size_t m_wanted = 0;  // the stick or button that is assigned
    bool m_wantsButton = false;
    bool m_inTurn = false;  // the next stick follows
    std::vector<int> m_taken;  // axes that were assigned in this turn
    GamepadMapping m_beforeTurn;
    bool m_filling = false;
};
