// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the page for flying says and asks.
#include "app/pages/board/directioncard.h"
#include "app/pages/board/flightpage.h"
#include "app/pages/board/stickstepcard.h"
#include "app/workspace/flightstate.h"
#include "app/workspace/question.h"
#include "protocol/device/flight.h"
#include "widgets/models/errortext.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/armedstate.h"
#include "widgets/views/controlpad.h"

#include <QCheckBox>
#include <QDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>

using namespace Qt::StringLiterals;

QString FlightPage::stateText() const
{
    const DeviceClient &client = workspace().client();
    const FlyingMachine *flight = client.isConnected() ? client.device()->flight() : nullptr;
    if (flight && *flight->refusal())
        return tableText(flight->refusal());
    if (!client.isConnected())
        return tr("No drone is connected.");
    switch (m_session.phase()) {
    case ArmingSession::Phase::Closed:
        return tr("Nothing is sent that steers. Open a control session to arm it from here.");
    case ArmingSession::Phase::Holding: return tr("Keep holding: it arms after a second.");
    case ArmingSession::Phase::Asked: return tr("It is told to arm.");
    case ArmingSession::Phase::Armed:
        return tr("Armed from here. Leaving this page or window, a question, list or text field that takes "
                  "the "
                  "sticks’ place, a lost link and %1 s without a movement disarm it.")
            .arg(workspace().settings().disarmSeconds());
    case ArmingSession::Phase::Open: break;
    }
    const ArmingBar bar = m_session.bar(known(), sticks(), Clock::now());
    const QString ended = m_session.ended() == ArmingBar::None
        ? QString()
        : tr("Control has ended: %1").arg(barText(m_session.ended())) + u' ';
    return ended
        + (bar == ArmingBar::None ? tr("Ready: hold the key for a second to arm it.")
                                  : tr("It cannot be armed: %1").arg(barText(bar)));
}

// Each goes on where "Control has ended:" or "It cannot be armed:" begins.
QString FlightPage::barText(ArmingBar bar) const
{
    switch (bar) {
    case ArmingBar::None: return {};
    case ArmingBar::NoLink: return tr("there is no link.");
    case ArmingBar::Silent: return tr("nothing has come from it for a second.");
    case ArmingBar::NoState: return tr("it does not say whether it is armed.");
    case ArmingBar::Unchecked:
        if (presumedDirections(workspace()).found.level != CheckedDirections::Level::Nothing)
            return tr("nobody has said that it is “%1”, whose directions were checked: another drone may "
                      "look "
                      "the same.")
                .arg(workspace().naming().name());
        return droneDirections(workspace()).level == CheckedDirections::Level::All
            ? tr("its directions have not been checked with these sticks as they are assigned now.")
            : tr("its directions have not been checked.");
    case ArmingBar::NoPropellerWord: return tr("no control session is open.");
    case ArmingBar::NotCalibrated: return tr("it is not calibrated.");
    case ArmingBar::Calibrating: return tr("it is calibrating.");
    case ArmingBar::ArmedElsewhere:
        return workspace().mayStillFly() ? tr("it was armed from here, and does not say that it is disarmed.")
                                         : tr("it is armed already, and not from here.");
    case ArmingBar::MotorsTurn: return tr("its motors are driven although it is disarmed.");
    case ArmingBar::Busy: return tr("it is at work: a procedure or a write runs.");
    case ArmingBar::Stopping: return tr("its motors are being stopped, and it has not confirmed that.");
    case ArmingBar::Throttle: return tr("the throttle is not at zero.");
    case ArmingBar::Pushed: return tr("a stick is not in its middle.");
    case ArmingBar::Unassigned:
        return tr(
            "the gamepad has no stick for throttle, roll, pitch or yaw. Assign it on the page “Gamepad”.");
    case ArmingBar::Shared: return tr("another ground station talks to it.");
    case ArmingBar::Battery: return tr("its battery is below the limit of the alarm.");
    case ArmingBar::Tilted:
        return tr("it is tilted by more than %1°. Put it level, or hold it in a test stand.")
            .arg(numberText(ArmingSession::kMaxTilt, 0));
    case ArmingBar::NoSticks: return tr("the sticks have told nothing for a quarter of a second.");
    case ArmingBar::Operator: return tr("by you.");
    case ArmingBar::NotArmed: return tr("it was told to arm, and did not say that it is armed.");
    case ArmingBar::Disarmed: return tr("it says so itself, and nobody told it to from here.");
    case ArmingBar::Focus: return tr("the window was not in front any more.");
    case ArmingBar::Hidden: return tr("this page was not seen any more.");
    case ArmingBar::Covered: return tr("a question, a list or a text field has taken the sticks’ place.");
    case ArmingBar::Locked: return tr("the screen was locked.");
    case ArmingBar::Idle: return tr("nothing was moved for too long.");
    case ArmingBar::Emergency: return tr("the motors were stopped.");
    case ArmingBar::CheckOver: return tr("the check of its directions is over.");
    case ArmingBar::Changed: return tr("values are being set.");
    case ArmingBar::Hung: return tr("this program did not send in time.");
    case ArmingBar::Unguarded:
        return tr(
            "the process that stops it if this program dies (gimbalguard, in this program's folder) has not "
            "started, or has ended.");
    case ArmingBar::Failed: return tr("an error occurred.");
    }
    return {};
}

void FlightPage::showState()
{
    const ArmingSession::Known now = known();
    m_tile->setState(flightState(workspace()));
    const bool isOpen = m_session.phase() != ArmingSession::Phase::Closed;
    m_open->setText(isOpen ? tr("Close the control session") : tr("Open a control session…"));
    m_open->setEnabled(isOpen || now.isLinked);
    m_tune->setVisible(isOpen && m_session.isHeld());
    // Before that it cannot be armed; afterwards, in a stand, there is nothing to check.
    const bool isStand = isOpen && m_session.isHeld() && !m_directions->isChecking()
        && m_directions->found().level == CheckedDirections::Level::All;
    m_steps->setVisible(isStand);
    m_directions->setVisible(!isStand);
    m_throttle->setMaximum(m_directions->isChecking() ? int(kFullStick * DirectionCheck::kMostThrottle)
                                                      : kFullStick);
    m_steps->setReady(m_session.phase() == ArmingSession::Phase::Armed, sticks().throttle);
    m_why->setText(stateText());
    m_calibrate->setVisible(m_tile->state() == ArmedState::State::NotCalibrated);
    // Whatever is not known to be disarmed can be disarmed, and not armed.
    const bool isDisarmed = ArmedState::isDisarmed(m_tile->state());
    m_arm->setEnabled(isOpen && now.isLinked && !m_session.isArming() && isDisarmed);
    m_disarm->setEnabled(now.isLinked && (m_session.isArming() || !isDisarmed));
    m_held->setVisible(m_session.phase() == ArmingSession::Phase::Holding);
    m_held->setValue(int(kFullStick * m_session.held(Clock::now())));
    for (QWidget *stick :
         {static_cast<QWidget *>(m_pad), static_cast<QWidget *>(m_yaw), static_cast<QWidget *>(m_throttle)})
        stick->setEnabled(!m_gamepad->isChosen() && (m_session.isArming() || m_directions->isChecking()));
}

void FlightPage::open(bool held)
{
    followSystem();
    m_session.open(held);
    workspace().setPropellersOn(held);
    showState();
}

void FlightPage::askToOpen()
{
    if (known().isArmed.value_or(false)) {
        workspace().notifications().notify(tr("Not opened: %1").arg(barText(ArmingBar::ArmedElsewhere)),
                                           Notice::Attention);
        return;
    }
    QDialog *panel
        = askInPanel({tr("Open a control session?"),
                      tr("From then on this program can arm the drone and turn its motors. Stopping them, by "
                         "the button STOP MOTORS, F12 or the space bar, makes it fall. Nobody may be within "
                         "reach of a propeller."),
                      {{tr("The propellers are off"), [this] { open(false); }, true},
                       {tr("It is held in a test stand"), [this] { open(true); }, true}},
                      tr("Do not open")},
                     this);
    connect(&workspace().client(), &DeviceClient::stateChanged, panel, &QDialog::reject);
}

void FlightPage::askToTune(bool wanted)
{
    const auto set = [this](bool held) {
        m_tune->setChecked(held);
        workspace().client().submit<void>([held](Channel &, Device &device) -> Result<void> {
            if (device.flight())
                device.flight()->setHeld(held);
            return {};
        });
    };
    if (!wanted) {
        set(false);
        return;
    }
    m_tune->setChecked(false);  // until it is answered
    askInPanel({tr("Set values while it is armed?"),
                tr("A wrong gain makes it swing at once, with its propellers turning. Only in a test stand "
                   "that holds it, with nobody near."),
                {{tr("It is held: allow it"), [set] { set(true); }, true}},
                tr("Leave it off")},
               this);
}
