// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Switching motors, and what is known about them.
#include "app/workspace/workspace.h"
#include "protocol/base/linkloss.h"

#include <QPromise>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

// Telemetry older than this says nothing about the present.
constexpr auto kStale = 1500ms;
constexpr auto kLastSamples = 500ms;
// By then a board that has restarted drives its motors.
constexpr auto kStartsWithin = 15s;

// It was sent, and what the board makes of it is not known.
bool mayStartYet(const Error &error)
{
    return error.code == ErrorCode::Timeout || isLinkLoss(error);
}

}  // namespace

void Workspace::setMotors(bool on)
{
    if (m_client.address().isReplay() && m_client.isConnected()) {
        m_notifications.notify(tr("This is a recording: there are no motors to switch."), Notice::Hint);
        return;
    }
    const DeviceClient::State state = m_client.state();
    if (!on && (state == DeviceClient::State::Connecting || state == DeviceClient::State::Reconnecting)) {
        stopAtNextLink();
        return;
    }
    if (!on && state == DeviceClient::State::Disconnected) {
        m_notifications.reportNothingToStop();
        return;
    }
    if (!on) {
        m_client.motorsOff();
        return;
    }
    if (m_guided) {
        tellGuided();
        return;
    }
    forgetStop();
    // As a moving job: a stop that comes meanwhile cancels a start that still waits for its turn.
    m_client
        .submit<void>(
            [](Channel &channel, Device &device) -> Result<void> {
                if (!device.motorSwitch())
                    return failure(ErrorCode::Unsupported,
                                   u"this board has no command that switches its motors on"_s);
                return device.motorSwitch()->switchMotorsOn(channel);
            },
            DeviceClient::JobKind::Moving)
        .then(this, [this](const Result<void> &done) {
            m_startUnanswered = !done && mayStartYet(done.error());
            if (m_startUnanswered)
                m_notifications.reportStartUnanswered(done.error());
            else if (!done && done.error().code != ErrorCode::Cancelled)
                m_notifications.report(done.error());
        });
}

void Workspace::stopAtNextLink()
{
    m_stopWhenConnected = true;
    m_notifications.settle(Concern::Motors);
    m_notifications.notify(tr("There is no link yet. The motors are switched off as soon as there is one."),
                           Notice::Attention, Concern::Motors);
}

// What is known of the motors of this board, from one link to the next.
void Workspace::followMotors(DeviceClient::State state)
{
    if (state == DeviceClient::State::Disconnected) {
        m_ranLast.reset();
        m_flownAt = {};
        forgetStop();
    }
    if (state != DeviceClient::State::Connected)
        return;
    m_startsUntil = Clock::now() + kStartsWithin;
    if (m_client.identity().serial != std::as_const(m_configuration).board().identity().serial)
        m_wereOff = false;
    m_ranLast.reset();
}

QFuture<bool> Workspace::stopMotors()
{
    const auto promise = std::make_shared<QPromise<bool>>();
    promise->start();
    auto *once = new QObject(this);
    const auto finish = [promise, once](bool isProven) {
        if (promise->future().isFinished())
            return;
        once->deleteLater();
        promise->addResult(isProven);
        promise->finish();
    };
    connect(&m_client, &DeviceClient::motorsOffFinished, once, finish);
    connect(&m_client, &DeviceClient::stateChanged, once, [finish] { finish(false); });  // the link went
    setMotors(false);
    if (m_client.state() == DeviceClient::State::Disconnected)
        finish(false);
    return promise->future();
}

void Workspace::releaseControl()
{
    emit controlReleased();
    m_client.releaseControl();
}

std::optional<bool> Workspace::motorsRunning() const
{
    const auto store = m_client.telemetry();
    if (!m_client.isConnected() || !store)
        return {};
    const TimePoint now = Clock::now();
    if (store->rows() != m_lastRows) {
        m_lastRows = store->rows();
        m_lastRowsAt = now;
    }
    const double value = latest(roles().outputs);
    if (std::isnan(value) || now - m_lastRowsAt > kStale)
        return {};
    // What stands still says nothing of the present. What was asked for since, to prove a stop, does.
    if (m_stopProvenAt && m_freshness.changedAt() < std::min<TimePoint>(*m_stopProvenAt, now - kStale))
        return false;
    if (m_freshness.frozenSince())
        return {};
    if (value == 0.0 && (m_flown || mayStillFly()))
        return {};  // of before it was armed from here, or not known to have ended
    return value != 0.0;
}

void Workspace::setFlown(bool flown)
{
    m_flown = flown;
    if (flown)
        m_flownAt = Clock::now();
}

void Workspace::setPropellersOn(bool on)
{
    if (std::exchange(m_propellersOn, on) != on)
        m_confirmations.withdraw();
}

bool Workspace::mayStillFly() const
{
    const auto store = m_client.telemetry();
    if (!m_client.isConnected() || !store || m_flownAt == TimePoint{})
        return false;
    const auto isSeenOff = [&](int channel) {
        return channel >= 0 && store->latestAt(channel) > m_flownAt && latest(channel) == 0;
    };
    const int outputs = roles().outputs;
    const bool tellsOutputs = outputs >= 0 && store->latestAt(outputs) != TimePoint{};
    return !isSeenOff(roles().armed) || (tellsOutputs && !isSeenOff(outputs));
}

void Workspace::forgetStop()
{
    m_stopProvenAt.reset();
    m_stopUnprovenAt.reset();
    m_wereOff = false;
}

bool Workspace::isDeaf() const
{
    return m_client.deafUntil() > Clock::now();
}

bool Workspace::isStarting() const
{
    const double state = latest(roles().state);
    const StatusWords *words
        = m_client.isConnected() && !std::isnan(state) ? m_client.device()->statusWords() : nullptr;
    return words && words->isStarting(int(state)) && motorsRunning().has_value();
}

// What came before the board could have obeyed says nothing.
void Workspace::tellRunningOn(bool isRunning)
{
    if (!m_stopUnprovenAt || !m_client.isStopUnproven() || !isRunning || isStarting()
        || m_client.telemetry()->latestAt(roles().outputs) < *m_stopUnprovenAt)
        return;
    m_stopUnprovenAt.reset();
    m_notifications.reportMotorsRunOn();
}

// A stop that could not be proven, on this link or before it, is proven by what the board reports.
void Workspace::settleMotors()
{
    const std::optional<bool> running = motorsRunning();
    if (!m_flown && m_client.isConnected() && !mayStillFly())
        m_flownAt = {};  // who arms it from now on is somebody else
    // What was sent before the stop says nothing of it.
    if (running == true
        && (!m_stopProvenAt
            || m_client.telemetry()->latestAt(roles().outputs) > *m_stopProvenAt + kLastSamples))
        m_notifications.settle(Concern::Stopped);
    if (running == true && std::exchange(m_startUnanswered, false)) {
        m_notifications.settle(Concern::Start);
        m_notifications.notify(
            tr("The motors run: the board has carried out the start that it did not answer to."),
            Notice::Attention);
    }
    // A deaf board is about to drive them, or does so again at once.
    if (running == false && !isStarting() && !m_client.isStopUnproven() && !isDeaf())
        m_notifications.settle(Concern::Motors);
    tellRunningOn(running == true);
    if (m_client.isConnected() && m_wereOff && running == true)
        m_notifications.report(
            {tr("The motors run again."),
             tr("They were off before the link ended. A board that restarts switches them on by itself."),
             m_notifications.flies() ? tr("Keep clear of the propellers, or stop them (F12).")
                                     : tr("Keep clear of the gimbal, or stop them (F12)."),
             {}},
            Concern::Motors);
    if (running == true || (Clock::now() > m_startsUntil && !isStarting()))
        m_wereOff = m_wereOff && !m_client.isConnected();
    if (running && !isStarting())
        m_ranLast = running;
}
