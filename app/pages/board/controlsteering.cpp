// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the control page sends: from the board's present, the operator's hands and the gamepad.
#include "app/pages/board/controlpage.h"
#include "app/pages/board/functionscard.h"
#include "app/pages/board/gamepadsteering.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/forms/numberbox.h"
#include "widgets/views/controlpad.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSlider>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kSecondsAcross = 4.0;  // for a stick at its end, through a range that is not one of degrees

}  // namespace

// Motors that no command switches on are started by steering, so they are off before it.
bool ControlPage::isLimp() const
{
    const Device *device = workspace().client().device();
    return device && device->motorSwitch() && !workspace().motorsRunning().value_or(true);
}

QString ControlPage::stateText() const
{
    if (!isArmed() && m_functions->isVisibleTo(this))
        return tr("Not armed: the camera is not steered. Choose a mode, then arm. What stands under "
                  "“Functions” acts at once, armed or not.");
    if (!isArmed())
        return tr("Not armed: the camera is not steered. Choose a mode, then arm.");
    if (steering() && steering()->controlFrames(setpoint()).setpoint.isEmpty() && wordIsNeeded()
        && !m_neverPanned->isChecked())
        return tr("Armed, but nothing is sent yet: the board does not report its targets, and it was running "
                  "before this link. Set each angle, press “To the middle”, or tick “%1” if that is so.")
            .arg(m_neverPanned->text());
    if (steering() && steering()->controlFrames(setpoint()).setpoint.isEmpty())
        return tr("Armed, but nothing is sent yet: the angles that hold the camera are unknown. Set each of "
                  "them, or press “To the middle”.");
    return tr("Armed: the camera follows you. It stops when you let go, leave this page, or do nothing "
              "for %1 s.")
        .arg(workspace().settings().disarmSeconds());
}

SteeringSetpoint ControlPage::holdingSetpoint(SteeredBefore steeredBefore) const
{
    return steering()->holdingSetpoint(mode()->id, *workspace().client().telemetry(), steeredBefore);
}

// More would be known if the operator said that nobody has steered the board before.
bool ControlPage::wordIsNeeded() const
{
    if (!mode() || !mode()->isPositional() || !workspace().client().telemetry())
        return false;
    const auto known = [this](SteeredBefore steeredBefore) {
        const std::vector<double> inputs = holdingSetpoint(steeredBefore).inputs;
        return std::count_if(inputs.begin(), inputs.end(), [](double input) { return !std::isnan(input); });
    };
    return known(SteeredBefore::Unknown) < known(SteeredBefore::Never);
}

void ControlPage::onWord(bool given)
{
    if (!given)
        setArmed(false);  // what was taken for known is not
    if (!isArmed())
        return;
    m_touched.start();
    takeHold();
    tick();
}

// Targets that are not known yet start at the present position, so that arming moves nothing.
void ControlPage::takeHold()
{
    const SteeringMode *chosen = mode();
    const SteeringSetpoint now
        = holdingSetpoint(m_neverPanned->isChecked() ? SteeredBefore::Never : SteeredBefore::Unknown);
    m_filling = true;
    for (std::size_t i = 0; i < std::min(chosen->inputs.size(), now.inputs.size()); ++i) {
        const SteeringInput &input = chosen->inputs[i];
        if (input.axis == Axis::None || input.springsBack)
            continue;
        const auto axis = std::size_t(input.axis);
        if (m_known[axis])
            continue;
        m_known[axis] = !std::isnan(now.inputs[i]);
        if (m_known[axis])
            m_angles[axis]->setValue(now.inputs[i]);
        else
            m_angles[axis]->clear();
    }
    m_filling = false;
}

double ControlPage::axisValue(const SteeringInput &input) const
{
    const auto axis = std::size_t(input.axis);
    if (!input.springsBack)
        return m_known[axis] ? m_angles[axis]->value() : std::nan("");
    const std::array<double, kAxisCount> push{double(m_roll->value()) / kSliderSteps, m_pad->value().y(),
                                              m_pad->value().x()};
    if (qstrcmp(input.unit, "°/s") == 0)
        return push[axis] * m_speed->value();
    return input.centre + push[axis] * (push[axis] < 0 ? input.centre - input.min : input.max - input.centre);
}

SteeringSetpoint ControlPage::setpoint() const
{
    SteeringSetpoint wanted;
    const SteeringMode *chosen = mode();
    if (!chosen)
        return wanted;
    wanted.mode = chosen->id;
    wanted.holds = !m_moved;
    for (const SteeringInput &input : chosen->inputs) {
        const auto more = m_moreInputs.find(input.key);
        wanted.inputs.push_back(input.axis != Axis::None         ? axisValue(input)
                                    : more != m_moreInputs.end() ? more->second->value()
                                                                 : double(m_speed->value()));
    }
    for (const QComboBox *box : m_switches)
        wanted.switches.push_back(box->currentData().toInt());
    return wanted;
}

void ControlPage::tick()
{
    if (m_touched.elapsed() > 1000LL * workspace().settings().disarmSeconds() && !m_pad->isHeld()) {
        setArmed(false);
        workspace().notifications().notify(tr("Control was disarmed: nothing was moved for %1 s.")
                                               .arg(workspace().settings().disarmSeconds()),
                                           Notice::Hint);
        return;
    }
    if (isLimp()) {
        setArmed(false);
        workspace().notifications().notify(tr("Control was disarmed: the motors are off."), Notice::Hint);
        return;
    }
    if (const auto sticks = m_gamepad->sticks())
        pushWithGamepad(*sticks);
    if (!isArmed())
        return;  // the gamepad is gone
    workspace().client().setControl(setpoint());
    m_state->setText(stateText());
}

// Sticks that spring back move the pad on the screen, which says what is sent. Where angles are steered to, a
// stick turns the angle as fast as the speed that is set, so that the camera stays where it is let go.
void ControlPage::pushWithGamepad(const GamepadSnapshot &sticks)
{
    const SteeringMode *chosen = mode();
    const std::array<double, kAxisCount> push{sticks[GamepadStick::Roll], sticks[GamepadStick::Pitch],
                                              sticks[GamepadStick::Yaw]};
    if (!chosen || m_pad->isHeld())
        return;
    const bool isPushed = push != std::array<double, kAxisCount>{};
    if (isPushed || push != m_pushed)
        touch();
    if (sticks.has(GamepadStick::Speed) && m_speed->isEnabled())
        m_speed->setValue(int(std::lround((sticks[GamepadStick::Speed] + 1) / 2 * m_speed->maximum())));
    if (!chosen->isPositional()) {
        if (push != m_pushed) {
            m_pad->steer({push[2], push[1]});
            m_roll->setValue(int(std::lround(push[0] * kSliderSteps)));
        }
    } else {
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            const int at = chosen->inputOf(kAxes[axis]);
            if (at < 0 || !m_known[axis] || push[axis] == 0.0)
                continue;
            const SteeringInput &input = chosen->inputs[std::size_t(at)];
            const double perSecond = qstrcmp(input.unit, "°") == 0 ? double(m_speed->value())
                                                                   : (input.max - input.min) / kSecondsAcross;
            m_angles[axis]->setValue(m_angles[axis]->value() + push[axis] * perSecond * seconds(kSendPeriod));
        }
    }
    m_pushed = push;
}
