// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"
#include "protocol/device/arming.h"

#include <QTimer>

class QCheckBox;
class QLabel;

/// The gamepad's part of steering by hand: whether it steers, what its buttons want, and that its loss ends
/// it. A pad that comes while something is steered already steers nothing until the next time.
class GamepadSteering final : public QObject
{
    Q_OBJECT
public:
    /// The button to arm with has to be held so long.
    static constexpr auto kArmHold = ArmingSession::kHold;

    explicit GamepadSteering(Workspace &workspace, QObject *parent = nullptr);

    /// Whether it steers, for the operator to choose.
    [[nodiscard]] QCheckBox *choice() const { return m_choice; }
    [[nodiscard]] bool isChosen() const;
    /// What is known about it, in a sentence.
    [[nodiscard]] QLabel *note() const { return m_note; }
    /// It is read only while the page is shown and it was chosen.
    void setShown(bool shown);

    /// Why steering may not begin now; empty if it may.
    [[nodiscard]] QString whyNot() const;
    /// Steering begins: with the pad there is, or without one.
    void begin();
    void end();
    /// The sticks now; nothing if steering has begun without a pad, or it is lost. Then gone() was emitted.
    [[nodiscard]] std::optional<GamepadSnapshot> sticks();
    /// As it was polled last, whether it steers or not.
    [[nodiscard]] GamepadSnapshot seen() const { return m_gamepad.snapshot(); }
    /// The button to arm with is held.
    [[nodiscard]] bool isArmHeld() const { return m_isHeld; }
    /// Whether steering has begun with this pad, and it has not been plugged in anew.
    [[nodiscard]] bool isSteeredBy(const GamepadSnapshot &pad) const { return m_session == pad.session; }

signals:
    /// The pad that steered does not any more; a sentence about it.
    void gone(const QString &what);
    /// The button to arm with was held for kArmHold.
    void armWanted();
    /// The same button goes down, and is let go of or not heard of any more; for who measures the time.
    void armPressed();
    void armReleased();
    void disarmWanted();
    void centreWanted();

private:
    void follow();
    void onLost(Gamepad::Loss why);
    void lookAtButtons();
    void letGoOfArm();
    void updateNote();
    [[nodiscard]] QString noteText(const GamepadSnapshot &now) const;

    Workspace &m_workspace;
    Gamepad &m_gamepad;
    QCheckBox *m_choice;
    QLabel *m_note;
    bool m_shown = false;
    std::optional<quint64> m_session;  // of the pad that steers
    QTimer m_look;
    GamepadSnapshot m_before;
    bool m_isHeld = false;  // the button to arm with
    std::optional<TimePoint> m_heldSince;  // it, until it was held for long enough
};
