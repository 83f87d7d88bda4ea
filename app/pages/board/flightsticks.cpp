// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the operator pushes, with mouse, keys or a gamepad.
#include "app/pages/board/directioncard.h"
#include "app/pages/board/flightpage.h"
#include "app/pages/board/gamepadsteering.h"
#include "app/pages/board/stickstepcard.h"
#include "widgets/views/controlpad.h"

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>
#include <utility>

namespace {

constexpr int kThrottleStep = 2;  // %, by key
constexpr double kClimb = 15;  // %/s, while it is held
constexpr auto kClimbDelay = 300ms;

}  // namespace

ArmingSession::Sticks FlightPage::sticks() const
{
    if (!m_gamepad->isChosen())  // mouse and keyboard are read here and now
        return {double(m_throttle->value()) / kFullStick, Clock::now()};
    const GamepadSnapshot pad = m_gamepad->seen();
    const bool isSame = m_session.phase() <= ArmingSession::Phase::Open || m_gamepad->isSteeredBy(pad);
    ArmingSession::Sticks told{(pad[GamepadStick::Throttle] + 1) / 2,
                               pad.connected && pad.isSetUp && isSame ? pad.at : TimePoint{}};
    for (const GamepadStick stick :
         {GamepadStick::Throttle, GamepadStick::Roll, GamepadStick::Pitch, GamepadStick::Yaw}) {
        told.isComplete &= !pad.isSetUp || pad.has(stick);
        if (stick != GamepadStick::Throttle)
            told.pushed = std::max(told.pushed, std::abs(pad[stick]));
    }
    return told;
}

DirectionCheck::Axes FlightPage::pushed() const
{
    if (!m_gamepad->isChosen())
        return {m_pad->value().x(), m_pad->value().y(), double(m_yaw->value()) / kFullStick};
    const GamepadSnapshot pad = m_gamepad->seen();
    return {pad[GamepadStick::Roll], pad[GamepadStick::Pitch], pad[GamepadStick::Yaw]};
}

// Its keys as well: one that arms while it is held for a second, one that disarms.
void FlightPage::connectGamepad()
{
    connect(m_gamepad, &GamepadSteering::gone, this,
            [this] { disarm(m_gamepad->isChosen() ? ArmingBar::NoSticks : ArmingBar::Operator); });
    connect(m_gamepad, &GamepadSteering::armPressed, this, [this] {
        // Who arms with the gamepad has his hands there.
        if (workspace().gamepad().mapping()[GamepadButton::Disarm] < 0)
            workspace().notifications().notify(
                tr("Not armed: no button of the gamepad disarms. Assign one on the page “Gamepad”."),
                Notice::Attention);
        else if (m_session.phase() == ArmingSession::Phase::Open)
            press();
    });
    connect(m_gamepad, &GamepadSteering::armReleased, this, &FlightPage::release);
    connect(m_gamepad, &GamepadSteering::disarmWanted, this, [this] { disarm(ArmingBar::Operator); });
    connect(m_gamepad->choice(), &QCheckBox::toggled, this, [this] {
        disarm(ArmingBar::Operator);
        m_pad->reset();
        m_yaw->setValue(0);
        m_throttle->setValue(0);
        showNow();
    });
}

// What the gamepad pushes is seen on the screen, which steers nothing meanwhile.
void FlightPage::showGamepad()
{
    if (!m_gamepad->isChosen())
        return;
    const GamepadSnapshot pad = m_gamepad->seen();
    const QSignalBlocker blockers[]{QSignalBlocker(m_pad), QSignalBlocker(m_yaw), QSignalBlocker(m_throttle)};
    m_pad->steer({pad[GamepadStick::Roll], pad[GamepadStick::Pitch]});
    m_yaw->setValue(int(std::lround(kFullStick * pad[GamepadStick::Yaw])));
    m_throttle->setValue(int(std::lround(kFullStick * (pad[GamepadStick::Throttle] + 1) / 2)));
}

SteeringSetpoint FlightPage::setpoint(bool isArmed) const
{
    DirectionCheck::Axes push = pushed();
    if (const auto step = m_steps->stick())
        push[std::size_t(step->first)] = step->second;
    const CheckedDirections found = m_directions->found();
    const DirectionCheck *check = m_directions->check();
    const double most = !check ? 1.0 : check->wantsIdle() ? 0.0 : DirectionCheck::kMostThrottle;
    SteeringSetpoint wanted;
    wanted.mode = steering()->modes().front().id;
    wanted.begun = m_begun;
    wanted.switches = {isArmed ? 1 : 0};
    for (const SteeringInput &input : steering()->modes().front().inputs) {
        const auto axis = std::size_t(input.axis);
        wanted.inputs.push_back(input.axis == Axis::None ? std::min(most, sticks().throttle)
                                                         : push[axis] * found.sticks[axis]);
    }
    return wanted;
}

// What was pressed for the sticks must not act on what gets the keyboard after them.
void FlightPage::leaveSticks()
{
    for (const QWidget *stick : {static_cast<QWidget *>(m_pad), static_cast<QWidget *>(m_yaw),
                                 static_cast<QWidget *>(m_throttle), static_cast<QWidget *>(m_disarm)}) {
        if (stick->hasFocus())
            setFocus(Qt::OtherFocusReason);
    }
}

// However fast the keyboard repeats its keys.
void FlightPage::climb(TimePoint now)
{
    if (m_climbing == 0 || now <= m_climbsSince)
        return;
    m_climbed += m_climbing * kClimb * seconds(now - std::exchange(m_climbsSince, now));
    const int whole = int(m_climbed);
    m_climbed -= whole;
    m_throttle->setValue(m_throttle->value() + whole);
}

// Armed, the keys that fly fly, wherever the keyboard is: a field takes digits alone.
bool FlightPage::givesToSticks(const QObject *to, QKeyEvent &event)
{
    const bool isField = qobject_cast<const QLineEdit *>(to) || qobject_cast<const QAbstractSpinBox *>(to)
        || qobject_cast<const QComboBox *>(to);
    const bool isDown = event.type() == QEvent::KeyPress;
    const int key = event.key();
    if (isField && m_session.isArming()) {
        if (key == Qt::Key_PageUp || key == Qt::Key_PageDown)
            return true;
        if (!(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) && handleKey(event, isDown))
            return true;
    }
    const bool isArrow = key >= Qt::Key_Left && key <= Qt::Key_Down;
    const bool isItsOwn = qobject_cast<const QSlider *>(to) || (isField && !m_session.isArming());
    if (!isDown || !isArrow || isItsOwn || !m_pad->isEnabled())
        return false;
    m_pad->setFocus(Qt::OtherFocusReason);
    QCoreApplication::sendEvent(m_pad, &event);
    return true;
}

bool FlightPage::handleKey(const QKeyEvent &event, bool isDown)
{
    const int turn = isDown ? kFullStick / 2 : 0;
    switch (event.key()) {
    case Qt::Key_W:
    case Qt::Key_S:
        if (!m_session.isArming())
            return false;
        if (event.isAutoRepeat())
            return true;
        m_climbing = !isDown ? 0 : event.key() == Qt::Key_W ? 1 : -1;
        m_climbsSince = Clock::now() + kClimbDelay;
        m_throttle->setValue(m_throttle->value() + m_climbing * kThrottleStep);
        return true;
    case Qt::Key_A:
    case Qt::Key_D:
        if (!event.isAutoRepeat())
            m_yaw->setValue(event.key() == Qt::Key_A ? -turn : turn);
        return true;
    default: return false;
    }
}

void FlightPage::keyPressEvent(QKeyEvent *event)
{
    if (!givesToSticks(this, *event)
        && (!(m_session.isArming() || m_directions->isChecking()) || !handleKey(*event, true)))
        Page::keyPressEvent(event);
}

void FlightPage::keyReleaseEvent(QKeyEvent *event)
{
    if (!(m_session.isArming() || m_directions->isChecking()) || !handleKey(*event, false))
        Page::keyReleaseEvent(event);
}
