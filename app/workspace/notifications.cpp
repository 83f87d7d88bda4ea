// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/notifications.h"

#include "app/workspace/editjournal.h"
#include "app/workspace/linkrecorder.h"
#include "protocol/client/replaycontrol.h"
#include "protocol/transport/replay.h"
#include "widgets/models/numbertext.h"

#include <utility>

using namespace Qt::StringLiterals;

bool isEndOfLink(const Error &error)
{
    return error.code == ErrorCode::LinkClosed || error.code == ErrorCode::Cancelled;
}

Notifications::Notifications(DeviceClient &client, const ConfigurationModel &configuration)
    : m_client(client)
    , m_configuration(configuration)
{
    connect(&m_client, &DeviceClient::stateChanged, this, &Notifications::onState);
    connect(&m_client, &DeviceClient::connectionFailed, this, &Notifications::onConnectionFailed);
    connect(&m_client, &DeviceClient::connectionLost, this, &Notifications::onLost);
    connect(&m_client, &DeviceClient::telemetryFailed, this, &Notifications::onTelemetryFailed);
    connect(&m_client, &DeviceClient::telemetryPlanChanged, this, [this] { settle(Concern::LiveData); });
    connect(&m_client, &DeviceClient::motorsOffFinished, this, &Notifications::onMotorsOff);
    connect(&m_client, &DeviceClient::motorsOffSettled, this, [this](bool restored) {
        m_leftDisabled = !restored;
        if (!restored)
            report(ErrorText{
                tr("The motors stay disabled until the board restarts."),
                tr("They were stopped while the board was starting, and it has not reached standby since."),
                tr("Restart the board before you use them, and store nothing before."),
                {}});
    });
    connect(&m_client, &DeviceClient::statisticsChanged, this, &Notifications::onReplay);
    connect(&m_client, &DeviceClient::boardSpoke, this,
            [this](const QString &text) { notify(tr("The board says: %1").arg(text), Notice::Hint); });
    connect(&m_client, &DeviceClient::failsafeActed, this, [this] {
        report({tr("Control was released because the program did not refresh it in time."),
                tr("The board was told to stop."),
                tr("Arm again when the computer is less busy."),
                {}});
    });
}

// Going back reopens a recording; its damage is told once.
void Notifications::onReplay()
{
    const auto &state = m_client.replay().state();
    if (!state || state->gaps.isEmpty() || std::exchange(m_damageTold, true))
        return;
    qint64 bytes = 0;
    for (const ReplayGap &gap : state->gaps)
        bytes += gap.bytes;
    report(ErrorText{tr("This recording is damaged."),
                     tr("%n part(s) of it cannot be read and are left out, %1 in all.", nullptr,
                        int(state->gaps.size()))
                         .arg(sizeText(bytes)),
                     tr("Everything else is here; where a part is missing, plots have a gap."),
                     state->gaps.first().reason},
           Concern::Recording);
}

void Notifications::report(const ErrorText &text, Concern concern)
{
    if (concern != Concern::None)
        m_told[concern] = text.oneLine();
    emit problem(text);
}

void Notifications::report(const Error &error, Concern concern)
{
    report(describe(error), concern);
}

void Notifications::reportMotorsMayRun(const QString &what)
{
    report(
        ErrorText{
            what, tr("They may still be running."), tr("Hold the camera and disconnect the power."), {}},
        Concern::Motors);
}

void Notifications::settle(Concern concern)
{
    if (m_told.contains(concern))
        emit withdrawn(m_told.take(concern));
}

void Notifications::notify(const QString &text, Notice kind)
{
    emit notice(text, kind);
}

void Notifications::reportSaved(const Result<void> &saved, const QString &path)
{
    if (saved)
        notify(tr("Saved to %1").arg(path));
    else
        report(saved.error());
}

void Notifications::ask(const Offer &question)
{
    emit offer(question);
}

void Notifications::follow(const EditJournal &journal)
{
    connect(&journal, &EditJournal::failed, this, [this](const Error &error) {
        ErrorText text = describe(error);
        text.meaning = tr("Unsaved edits would not survive a crash of the program.");
        report(text);
    });
}

void Notifications::follow(const LinkRecorder &recorder)
{
    connect(&recorder, &LinkRecorder::finished, this, [this](const QString &path, qint64 bytes) {
        notify(tr("Recording saved to %1 (%2)").arg(path, sizeText(bytes)));
    });
    connect(&recorder, &LinkRecorder::failed, this, [this](const Error &error) {
        ErrorText text = describe(error);
        text.what = tr("The recording has ended.");
        text.cure = tr("What was recorded before is in the file. Make room, or choose another place.");
        report(text);
    });
}

void Notifications::onState(DeviceClient::State state)
{
    m_damageTold = m_damageTold && state != DeviceClient::State::Disconnected;
    if (state != DeviceClient::State::Reconnecting)
        settle(Concern::Link);
    if (state == DeviceClient::State::Disconnected) {
        m_wasLost = false;  // given up
        for (const Concern concern : {Concern::Reading, Concern::LiveData, Concern::Recording})
            settle(concern);
    }
    if (state != DeviceClient::State::Connected)
        return;
    m_leftDisabled = false;
    if (std::exchange(m_wasLost, false))
        notify(tr("Connected again."));
    if (m_client.address().isReplay())
        notify(tr("This is a recording: everything can be looked at, nothing can be changed."), Notice::Hint);
    else if (!m_client.identity().writable)
        report({ErrorCode::ReadOnly, m_client.identity().firmware, 0}, Concern::Link);
    if (const QString left = m_client.identity().extra.value(u"streams.left"_s).toString(); !left.isEmpty())
        report({tr("The board sends data that nobody here has ordered."),
                tr("An earlier program has left them on; they take room on the line from everything else."),
                tr("Switch the board off and on again."), left},
               Concern::Link);
}

void Notifications::onConnectionFailed(const Error &error)
{
    report(error, Concern::Link);
}

void Notifications::onLost(const Error &error)
{
    m_wasLost = true;
    ErrorText text = describe(error);
    // It replaces what was told of the motors.
    if (m_leftDisabled)
        text.meaning
            += tr(" Its motors were disabled while it was starting and may stay so until it restarts; "
                  "store nothing before.");
    if (m_configuration.changeCount() > 0)
        text.cure += tr(" Unsaved changes are kept.");
    report(text, Concern::Link);
}

void Notifications::onTelemetryFailed(const Error &error)
{
    ErrorText text = describe(error);
    text.what = tr("Live data could not be started. ") + text.what;
    // What the operator chose is refused even if less of it is live a moment later.
    const bool isRefused = error.code == ErrorCode::TooMuch || error.code == ErrorCode::InvalidArgument;
    report(text, isRefused ? Concern::None : Concern::LiveData);
}

void Notifications::onMotorsOff(bool confirmed)
{
    if (confirmed) {
        settle(Concern::Motors);
        notify(tr("The motors were switched off."));
        return;
    }
    reportMotorsMayRun(tr("The board did not confirm that the motors are off."));
}
