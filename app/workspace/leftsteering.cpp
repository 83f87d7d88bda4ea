// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/leftsteering.h"

#include "protocol/device/device.h"
#include "protocol/device/steering.h"
#include "protocol/telemetry/telemetrystore.h"
#include "protocol/transport/linkaddress.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace std::chrono_literals;

namespace {

constexpr auto kTargetEvery = 250ms;
constexpr int kLooks = 40;  // 10 s; what begins later somebody does now
constexpr int kSteadyLooks = 8;
constexpr double kTurns = 3.0;  // deg/s
constexpr double kSameRate = 0.35;  // by a command the rate is the same; what follows a hand changes it
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

LeftSteering::LeftSteering(DeviceClient &client, Notifications &notifications)
    : m_client(client)
    , m_notifications(notifications)
{
    m_timer.setInterval(kTargetEvery);
    connect(&m_timer, &QTimer::timeout, this, &LeftSteering::look);
    connect(&client, &DeviceClient::stateChanged, this, &LeftSteering::onState);
}

void LeftSteering::onState()
{
    m_notifications.withdrawOffer(Topic::Steering);
    m_before.fill(kUnknown);
    m_at.fill({});
    m_rate.fill(0);
    m_steady.fill(0);
    m_looks = kLooks;
    if (m_client.isConnected() && !m_client.address().isReplay() && m_client.device()->steering())
        m_timer.start();
    else
        m_timer.stop();
}

void LeftSteering::look()
{
    const auto store = m_client.telemetry();
    if (m_client.isSteering() || !store || --m_looks < 0) {
        m_timer.stop();
        return;
    }
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const int channel = m_client.roles().target[axis];
        const TimePoint at = channel < 0 ? TimePoint{} : store->latestAt(channel);
        if (at == m_at[axis])
            continue;  // nothing has come since
        const double rate = rateOf(axis, double(store->latest(channel)), at);
        const double last = std::exchange(m_rate[axis], rate);
        const bool isSame = std::abs(rate) >= kTurns && std::abs(rate - last) < kSameRate * std::abs(rate);
        m_steady[axis] = isSame ? m_steady[axis] + 1 : 0;
        if (m_steady[axis] < kSteadyLooks)
            continue;
        m_timer.stop();
        ask(kAxes[axis], std::abs(rate));
        return;
    }
}

double LeftSteering::rateOf(std::size_t axis, double target, TimePoint at)
{
    const double by = target - std::exchange(m_before[axis], target);
    const double took = seconds(at - std::exchange(m_at[axis], at));
    return std::isnan(by) ? 0.0 : by / took;
}

void LeftSteering::ask(Axis axis, double rate)
{
    Offer question;
    question.topic = Topic::Steering;
    question.isUrgent = true;
    question.text
        = tr("The board turns the target of %1 by about %2 °/s, and nobody steers it here: a remote control "
             "does, or a steering command that was never ended. The camera goes on turning.")
              .arg(axisLabel(axis), numberText(rate, 0));
    question.choices.append({tr("End the command"), [this] { end(); }});
    question.choices.append({tr("Stop the motors"), [this] { m_client.motorsOff(); }});
    question.choices.append({tr("It is meant"), [] {}});
    m_notifications.ask(question);
}

// At rest, seen to be so, and control given back.
void LeftSteering::end()
{
    const Steering *steering = m_client.isConnected() ? m_client.device()->steering() : nullptr;
    if (!steering || m_client.isSteering())
        return;
    const auto modes = steering->modes();
    const auto byRate = std::find_if(modes.begin(), modes.end(),
                                     [](const SteeringMode &mode) { return !mode.isPositional(); });
    if (byRate == modes.end())
        return;
    SteeringSetpoint rest;
    rest.mode = byRate->id;
    for (const SteeringInput &input : byRate->inputs)
        rest.inputs.push_back(input.centre);
    for (const SteeringSwitch &each : steering->switches())
        rest.switches.push_back(each.start);
    m_client.setControl(rest);
    m_client.releaseControl();
}
