// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "protocol/device/arming.h"
#include "protocol/device/steering.h"
#include "protocol/procedure/directioncheck.h"
#include "protocol/transport/flightguard.h"

#include <QElapsedTimer>
#include <QPointer>
#include <QTimer>

class ArmedState;
class AttitudeView;
class Card;
class ControlPad;
class DirectionCard;
class GamepadSteering;
class MotorDiagram;
class PanelArea;
class StickStepCard;
class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSlider;

/// Flies what flies from here, under the rules of ArmingSession: a session that is opened on purpose, a key
/// that is held for a second, and whatever goes wrong ends in disarmed controls. A process of its own stops
/// the machine if this program dies.
class FlightPage final : public Page
{
    Q_OBJECT
public:
    explicit FlightPage(Workspace &workspace, QWidget *parent = nullptr);
    ~FlightPage() override;

    [[nodiscard]] bool isUnderWay() const override { return m_session.phase() > ArmingSession::Phase::Open; }
    [[nodiscard]] const ArmingSession &session() const { return m_session; }
    [[nodiscard]] QPushButton *sessionButton() const { return m_open; }
    [[nodiscard]] QPushButton *armButton() const { return m_arm; }
    [[nodiscard]] QPushButton *disarmButton() const { return m_disarm; }
    [[nodiscard]] QSlider *throttle() const { return m_throttle; }
    [[nodiscard]] ControlPad *pad() const { return m_pad; }
    [[nodiscard]] QSlider *yaw() const { return m_yaw; }
    [[nodiscard]] DirectionCard *directions() const { return m_directions; }
    [[nodiscard]] StickStepCard *steps() const { return m_steps; }
    [[nodiscard]] QCheckBox *tuneChoice() const { return m_tune; }
    [[nodiscard]] FlightGuardian &guardian() { return m_guardian; }
    [[nodiscard]] QCheckBox *padChoice() const;
    [[nodiscard]] QString stateText() const;
    /// Opens the session by the operator's word. @param held in a test stand
    void open(bool held);
    /// It is disarmed for this reason.
    void disarm(ArmingBar why);

public slots:
    /// Told by the system. Public for those who listen to it.
    void onScreenLocked(bool locked);
    void onSessionLocked();

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void keyReleaseEvent(QKeyEvent *event) override;

private:
    static constexpr int kFullStick = 100;

    void makeHeader();
    void makeBody();
    [[nodiscard]] Card *makeStickCard();
    void connectAll();
    void followSystem();
    void closeSession();
    [[nodiscard]] bool isCovered() const;
    void askToOpen();
    void askToTune(bool wanted);
    void connectGamepad();
    void press();
    void release();
    void tick();
    void takeSticks();
    void leaveSticks();
    void climb(TimePoint now);
    void stopSending();
    void showGamepad();
    void showNow();
    void showState();
    void touch() { m_touched.start(); }
    /// Arrow keys are the sticks', wherever on the page the focus was but in what uses them itself.
    bool givesToSticks(const QObject *to, QKeyEvent &event);
    [[nodiscard]] bool handleKey(const QKeyEvent &event, bool isDown);
    [[nodiscard]] const Steering *steering() const;
    [[nodiscard]] ArmingSession::Known known() const;
    [[nodiscard]] ArmingSession::Sticks sticks() const;
    [[nodiscard]] DirectionCheck::Axes pushed() const;
    [[nodiscard]] SteeringSetpoint setpoint(bool isArmed) const;
    [[nodiscard]] QString barText(ArmingBar bar) const;

    ArmingSession m_session;
    FlightGuardian m_guardian;
    TimePoint m_begun{};  // when the key was pressed
    bool m_isSending = false;
    bool m_isFollowing = false;
    QPushButton *m_open;
    QCheckBox *m_tune;
    ArmedState *m_tile;
    QLabel *m_why;
    QPushButton *m_calibrate;
    QPushButton *m_arm;
    QProgressBar *m_held;
    QPushButton *m_disarm;
    QSlider *m_throttle;
    QLabel *m_throttleText;
    int m_climbing = 0;  // by a key that is held: 1 more throttle, -1 less
    double m_climbed = 0;  // %, not yet on the slider
    TimePoint m_climbsSince{};
    ControlPad *m_pad;
    QSlider *m_yaw;
    GamepadSteering *m_gamepad;
    QLabel *m_keys;
    std::array<double, kGamepadSticks> m_pushedBefore{};  // on the gamepad
    AttitudeView *m_attitude;
    MotorDiagram *m_motors;
    QLabel *m_numbers;
    DirectionCard *m_directions;
    StickStepCard *m_steps;
    QPointer<PanelArea> m_panels;
    QTimer m_send;
    QTimer m_refresh;
    QElapsedTimer m_touched;
    int m_ticks = 0;
};
