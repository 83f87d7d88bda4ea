// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/board/gamepadsteering.h"

#include "app/workspace/question.h"

#include <QCheckBox>
#include <QGuiApplication>
#include <QLabel>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kLookPeriod = 20ms;

bool pushesAnything(const GamepadSnapshot &sticks)
{
    for (std::size_t i = 0; i < kGamepadSticks; ++i) {
        if (!startsAtStop(GamepadStick(i)) && sticks.sticks[i] != 0.0)
            return true;
    }
    return false;
}

}  // namespace

GamepadSteering::GamepadSteering(Workspace &workspace, QObject *parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_gamepad(workspace.gamepad())
    , m_choice(new QCheckBox(tr("Gamepad")))
    , m_note(new QLabel)
{
    m_choice->setToolTip(tr("A gamepad steers while armed. Its sticks are assigned on the page “Gamepad”."));
    m_choice->setChecked(workspace.settings().gamepadSteers());
    m_note->setWordWrap(true);
    m_note->setObjectName(u"muted"_s);
    connect(m_choice, &QCheckBox::toggled, this, [this](bool on) {
        m_workspace.settings().setGamepadSteers(on);
        follow();
    });
    connect(&workspace.settings(), &Settings::changed, this,
            [this] { m_choice->setChecked(m_workspace.settings().gamepadSteers()); });
    connect(&m_gamepad, &Gamepad::lost, this, &GamepadSteering::onLost);
    connect(&m_gamepad, &Gamepad::changed, this, &GamepadSteering::updateNote);
    m_look.setInterval(kLookPeriod);
    connect(&m_look, &QTimer::timeout, this, &GamepadSteering::lookAtButtons);
    updateNote();
}

bool GamepadSteering::isChosen() const
{
    return m_choice->isChecked();
}

void GamepadSteering::setShown(bool shown)
{
    m_shown = shown;
    follow();
}

void GamepadSteering::follow()
{
    if (m_shown && m_choice->isChecked()) {
        m_gamepad.use(*this);
        m_before = m_gamepad.snapshot();
        m_look.start();
    } else {
        if (std::exchange(m_session, std::nullopt))
            emit gone(tr("Control was disarmed: the gamepad was switched off."));
        m_look.stop();
        letGoOfArm();
        m_gamepad.letGo(*this);
    }
    updateNote();
}

QString GamepadSteering::whyNot() const
{
    if (const QString why = whyNotBehind(*m_choice); !why.isEmpty())
        return why;
    const GamepadSnapshot now = m_gamepad.snapshot();
    if (m_look.isActive() && now.isAlive(Clock::now()) && pushesAnything(now))
        return tr("Not armed: a stick of the gamepad is not at rest. Let go of it, then arm.");
    return {};
}

void GamepadSteering::begin()
{
    const GamepadSnapshot now = m_gamepad.snapshot();
    if (m_look.isActive() && now.isAlive(Clock::now()) && now.isSetUp)
        m_session = now.session;
    updateNote();
}

void GamepadSteering::end()
{
    m_session.reset();
    updateNote();
}

std::optional<GamepadSnapshot> GamepadSteering::sticks()
{
    if (!m_session)
        return {};
    const GamepadSnapshot now = m_gamepad.snapshot();
    if (now.isAlive(Clock::now()) && now.session == m_session)
        return now;
    onLost(now.connected && now.session == m_session ? Gamepad::Loss::Silent : Gamepad::Loss::Unplugged);
    return {};
}

void GamepadSteering::onLost(Gamepad::Loss why)
{
    letGoOfArm();
    if (!std::exchange(m_session, std::nullopt))
        return;
    emit gone(
        why == Gamepad::Loss::Silent
            ? tr("Control was disarmed: the gamepad has not been heard of for a quarter of a second. Plug it "
                 "out and in again.")
            : tr("Control was disarmed: the gamepad is gone. Plug it in, then arm again."));
}

void GamepadSteering::letGoOfArm()
{
    m_heldSince.reset();
    if (std::exchange(m_isHeld, false))
        emit armReleased();
}

// Only what is pressed while the page is shown, never what was pressed before.
void GamepadSteering::lookAtButtons()
{
    const GamepadSnapshot now = m_gamepad.snapshot();
    const TimePoint time = Clock::now();
    if (!now.isAlive(time)) {
        m_before = now;
        letGoOfArm();
        return;
    }
    if (now.session != m_before.session) {
        m_before = {};  // of a pad that comes presses are counted anew
        m_before.session = now.session;
    }
    const auto isPressed
        = [&](GamepadButton button) { return now.pressesOf(button) != m_before.pressesOf(button); };
    const bool disarm = isPressed(GamepadButton::Disarm);
    const bool centre = isPressed(GamepadButton::Centre);
    const bool arm = isPressed(GamepadButton::ArmHold);
    m_before = now;
    if (arm) {
        m_isHeld = true;
        m_heldSince = time;
        emit armPressed();
    }
    if (!now.isHeld(GamepadButton::ArmHold) || disarm)
        letGoOfArm();
    if (disarm)
        emit disarmWanted();
    else if (centre)
        emit centreWanted();
    if (m_heldSince && time - *m_heldSince >= kArmHold) {
        m_heldSince.reset();  // once for each press
        if (QGuiApplication::applicationState()
            == Qt::ApplicationActive)  // a pad is heard behind other windows too
            emit armWanted();
    }
}

QString GamepadSteering::noteText(const GamepadSnapshot &now) const
{
    if (const auto error = m_gamepad.error())
        return tr("Gamepads cannot be read: %1. The page “Gamepad” says more.").arg(error->detail);
    if (!now.connected)
        return tr("No gamepad is plugged in.");
    if (!now.isAlive(Clock::now()))
        return tr("%1 is not heard of.").arg(now.name);
    if (!now.isSetUp)
        return tr("%1 is there, but its sticks are not assigned yet. Do that on the page “Gamepad”.")
            .arg(now.name);
    if (m_session == now.session)
        return tr("%1 steers.").arg(now.name);
    return now.isStandard
        ? tr("%1 steers from the next arming on, with the default assignment (page “Gamepad”).").arg(now.name)
        : tr("%1 steers from the next arming on.").arg(now.name);
}

void GamepadSteering::updateNote()
{
    m_note->setVisible(m_look.isActive());
    m_note->setText(m_look.isActive() ? noteText(m_gamepad.snapshot()) : QString());
}
