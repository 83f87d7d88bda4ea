// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/notifications.h"

#include "app/workspace/editjournal.h"
#include "app/workspace/linkrecorder.h"
#include "protocol/base/linkloss.h"
#include "protocol/client/connector.h"
#include "protocol/client/replaycontrol.h"
#include "protocol/device/flight.h"
#include "protocol/transport/replay.h"
#include "widgets/models/boardtext.h"
#include "widgets/models/detailtext.h"
#include "widgets/models/numbertext.h"

#include <QSysInfo>
#include <QTime>

#include <array>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr int kMostRemembered = 200;

QString disarmedUntoldText()
{
    return Notifications::tr(
        "The drone was disarmed, and does not tell what its motors do. See that they stand before "
        "you come near.");
}

}  // namespace

bool isEndOfLink(const Error &error)
{
    return isLinkLoss(error) || error.code == ErrorCode::Cancelled;
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
        if (restored)
            settle(Concern::Standby);
        else
            report(ErrorText{tr("The motors stay disabled until the board restarts."),
                             tr("The board did not obey the ordinary stop, so they were disabled in its "
                                "volatile memory; it has not reached standby since."),
                             tr("Restart the board before you use them, and store nothing before."),
                             {}},
                   Concern::Standby);
    });
    connect(&m_client, &DeviceClient::motorsOffLate, this, [this] {
        notify(tr("The board does not confirm yet that the motors are off; the command is repeated.") + u' '
                   + (flies() ? tr("Keep away from the propellers.") : tr("Hold the camera.")),
               Notice::Attention, Concern::Motors);
    });
    connect(&m_client, &DeviceClient::motorsOffQueued, this, [this](int left) {
        const QTime heard = QTime::currentTime().addMSecs(left + 999);
        notify(
            tr("The board hears nothing until %1, also no stop. The stop is queued as the first thing that "
               "it hears then. To stop it at once, disconnect the battery.")
                .arg(heard.toString(u"HH:mm:ss"_s)),
            Notice::Attention, Concern::Motors);
    });
    connect(&m_client, &DeviceClient::motorsOffForgone, this, [this] { settle(Concern::Motors); });
    connect(&m_client, &DeviceClient::steeringEnded, this, &Notifications::onSteeringEnded);
    connect(&m_client, &DeviceClient::statisticsChanged, this, &Notifications::onReplay);
    connect(&m_client, &DeviceClient::boardSpoke, this,
            [this](const QString &text) { notify(tr("The board says: %1").arg(text), Notice::Hint); });
    connect(&m_client, &DeviceClient::failsafeActed, this, [this] {
        report({tr("Control was released because the program did not refresh it in time."),
                tr("The board was told to stop."),
                tr("Arm again when the computer is less busy."),
                {}},
               flies() ? Concern::Stopped : Concern::None);
    });
}

QString Notifications::causeText(GapCause cause)
{
    switch (cause) {
    case GapCause::FirstLine: return tr("Its first line is damaged.");
    case GapCause::EndsWithin: return tr("The file ends in the middle of a part.");
    case GapCause::NoChunk: return tr("No part begins where one should.");
    case GapCause::Checksum: return tr("A checksum is wrong.");
    case GapCause::Description: return tr("The description of the recording is no JSON.");
    case GapCause::Pieces: return tr("A part holds something else than data of the link.");
    }
    return {};
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
    report(
        ErrorText{
            tr("This recording is damaged."),
            tr("%n part(s) of it cannot be read and are left out, %1 in all.", nullptr,
               int(state->gaps.size()))
                .arg(sizeText(bytes)),
            tr("Everything else that the file holds is here; where a part is missing, plots have a gap."),
            causeText(state->gaps.first().cause)},
        Concern::Recording);
}

void Notifications::report(const ErrorText &text, Concern concern)
{
    if (concern != Concern::None)
        m_told.insert(concern);
    if (!text.motors.isEmpty())
        m_told.insert(Concern::Motors);
    remember(text.oneLine(), std::nullopt);
    emit problem(text, concern, circumstances());
}

// A link that ended, or never came to be, is what the report is about.
QString Notifications::circumstances() const
{
    QStringList lines{u"GimbalDesk " GIMBAL_VERSION ", Qt %1, %2 (%3), %4"_s.arg(
        QLatin1String(qVersion()), QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture(),
        QDateTime::currentDateTime().toString(Qt::ISODate))};
    static constexpr std::array kStates{QT_TR_NOOP("not connected"), QT_TR_NOOP("connecting"),
                                        QT_TR_NOOP("connected"), QT_TR_NOOP("link lost")};
    const QString address = m_client.addressText();
    const DeviceClient::State state = m_client.state();
    lines.append(
        tr("Link: %1, %2")
            .arg(address.isEmpty() ? tr("none used yet") : address, tr(kStates[std::size_t(state)])));
    const bool isLinked = m_client.isConnected() || state == DeviceClient::State::Reconnecting;
    if (!isLinked && m_configuration.isEmpty()) {
        lines.append(tr("Board: none"));
        return lines.join(u'\n');
    }
    const BoardIdentity &board
        = isLinked ? m_client.identity() : std::as_const(m_configuration).board().identity();
    QString text = tr("Board: %1, firmware %2").arg(boardText(board), board.firmware);
    if (!isLinked)
        text += tr(" (read before, or from a file)");
    lines.append(text);
    return lines.join(u'\n');
}

void Notifications::report(const Error &error, Concern concern)
{
    // A recording has no cable and no power.
    if (m_client.address().isReplay() && error.code == ErrorCode::Timeout) {
        report({tr("The recording does not hold an answer to what the program asks."),
                tr("It was not asked while this was recorded, or that part of the file is missing."),
                tr("What the recording holds is shown all the same."), detailText(error.detail)},
               concern);
        return;
    }
    ErrorText text = describe(error);
    if (flies() && error.code == ErrorCode::NotProven)
        text.cure = keepAwayText();
    report(text, concern);
}

bool Notifications::flies() const
{
    return m_client.device() && m_client.device()->flight();
}

QString Notifications::keepAwayText() const
{
    return flies() ? tr("Keep away from the propellers, and disconnect the battery once they stand.")
                   : tr("Hold the camera and disconnect the power.");
}

void Notifications::reportMotorsMayRun(const QString &what)
{
    report(ErrorText{what, tr("They may still be running."), keepAwayText(), {}}, Concern::Motors);
}

void Notifications::reportMotorsRunOn()
{
    settle(Concern::Motors);
    report({tr("The motors run on although they were told to stop."),
            tr("The board answers and reports that they run; stopping them is repeated."),
            keepAwayText(),
            {}},
           Concern::Motors);
}

void Notifications::reportNothingToStop()
{
    settle(Concern::Link);
    report({tr("There is no connection: nothing was sent to stop motors."),
            tr("Motors that run go on running."),
            tr("Connect first, then stop them (F12); or disconnect their power."),
            {}},
           Concern::Link);
}

void Notifications::reportSilence(const QDateTime &since)
{
    report({tr("No live data have come since %1; the motors ran then.").arg(since.toString(u"HH:mm:ss"_s)),
            tr("They may go on, and nothing is watched: no alarm can tell or stop anything."),
            flies() ? keepAwayText()
                    : tr("Keep clear of the gimbal. Stop the motors (F12), or disconnect the power."),
            {}},
           Concern::Silence);
}

void Notifications::settle(Concern concern)
{
    if (m_told.remove(concern))
        emit withdrawn(concern);
}

void Notifications::notify(const QString &text, Notice kind, Concern concern)
{
    tell(text, kind, concern, {});
}

void Notifications::tell(const QString &text, Notice kind, Concern concern, const QString &motors)
{
    if (concern != Concern::None)
        m_told.insert(concern);
    if (!motors.isEmpty())
        m_told.insert(Concern::Motors);
    remember(motors.isEmpty() ? text : text + u' ' + motors, kind);
    emit notice(text, kind, concern, motors);
}

void Notifications::remember(const QString &text, std::optional<Notice> kind)
{
    m_history.append({QDateTime::currentDateTime(), text, kind});
    if (m_history.size() > kMostRemembered)
        m_history.removeFirst();
}

void Notifications::reportSaved(const Result<void> &saved, const QString &path, const QString &lacking)
{
    settle(Concern::Saving);
    if (saved && !lacking.isEmpty())
        report(ErrorText{tr("Saved to %1, but not everything.").arg(path),
                         tr("The file lacks what could not be read: %1.").arg(lacking),
                         tr("Read the board again, then save once more."),
                         {}},
               Concern::Saving);
    else if (saved)
        notify(tr("Saved to %1").arg(path));
    else
        report(saved.error(), Concern::Saving);
}

void Notifications::ask(const Offer &question)
{
    emit offer(question);
}

void Notifications::withdrawOffer(Topic topic)
{
    emit offerWithdrawn(topic);
}

void Notifications::follow(const EditJournal &journal)
{
    connect(&journal, &EditJournal::failed, this, [this](const Error &error) {
        ErrorText text = describe(error);
        text.meaning = tr("Unwritten edits would not survive a crash of the program.");
        settle(Concern::Journal);
        report(text, Concern::Journal);
    });
    connect(&journal, &EditJournal::written, this, [this] { settle(Concern::Journal); });
    connect(&journal, &EditJournal::unreadable, this, [this](const Error &error, const QString &folder) {
        ErrorText text = describe(error);
        text.cure = tr("The file is kept in the folder %1.").arg(folder);
        report(text, Concern::Loading);
    });
    connect(&journal, &EditJournal::setAside, this, [this](const QString &folder) {
        notify(
            tr("New edits take the place of edits of an earlier run, which concern parts of the board that "
               "could not be read. Those are kept in %1.")
                .arg(folder),
            Notice::Attention);
    });
    connect(&journal, &EditJournal::keptAside, this, [this](const QString &path) {
        notify(tr("New edits take the place of edits of an earlier run. Those are kept as the snapshot %1.")
                   .arg(path),
               Notice::Attention);
    });
    connect(&journal, &EditJournal::leftoverGone, this, [this] { withdrawOffer(Topic::Leftover); });
}

void Notifications::follow(const LinkRecorder &recorder)
{
    connect(&recorder, &LinkRecorder::finished, this,
            [this](const QString &path, qint64 bytes, bool hasSamples) {
                if (hasSamples)
                    notify(tr("Recording saved to %1 (%2)").arg(path, sizeText(bytes)));
                else
                    notify(tr("The recording %1 holds no live data: none came while it was made.").arg(path),
                           Notice::Attention);
            });
    connect(&recorder, &LinkRecorder::replaced, this, [this, &recorder] {
        notify(
            tr("The recording has ended: another board answers on this link. What came from the one before "
               "is in %1.")
                .arg(recorder.path()),
            Notice::Attention);
    });
    connect(&recorder, &LinkRecorder::silenceChanged, this, [this](bool silent) {
        if (silent)
            report(ErrorText{tr("Live data have stopped while the link is being recorded."),
                             tr("The recording goes on, and has a gap from here on."),
                             tr("Choose streams on the Monitor, or connect again."),
                             {}},
                   Concern::LiveData);
        else
            settle(Concern::LiveData);
    });
    connect(&recorder, &LinkRecorder::failed, this, [this](const Error &error) {
        ErrorText text = describe(error);
        text.what = tr("The recording has ended.") + u' ' + text.what;
        text.cure = tr("What was recorded before is in the file. Make room, or choose another place.");
        report(text, Concern::Recorder);
    });
    connect(&recorder, &LinkRecorder::recordingChanged, this, [this](bool recording) {
        if (recording)
            settle(Concern::Recorder);
    });
}

void Notifications::onState(DeviceClient::State state)
{
    m_damageTold = m_damageTold && state != DeviceClient::State::Disconnected;
    if (state != DeviceClient::State::Reconnecting)
        settle(Concern::Link);
    if (state != DeviceClient::State::Connected)
        settle(Concern::Back);
    if (state == DeviceClient::State::Disconnected) {
        m_wasLost = false;  // given up
        for (const Concern concern : {Concern::Reading, Concern::LiveData, Concern::Recording})
            settle(concern);
        // Nothing is repeated any more, and nobody sees what they do.
        if (m_told.contains(Concern::Motors)) {
            settle(Concern::Motors);
            reportMotorsMayRun(tr("The connection ended before the motors were seen to stop."));
        }
    }
    if (state != DeviceClient::State::Connected)
        return;
    m_leftDisabled = false;
    settle(Concern::Standby);
    const BoardIdentity before = std::exchange(m_board, m_client.identity());
    if (std::exchange(m_wasLost, false)) {
        if (before.serial == m_board.serial) {
            tellBack();
        } else {
            emit boardReplaced();
            notify(tr("Another board answers now: %1. It is read anew; the one before was %2.")
                       .arg(boardText(m_board), boardText(before)),
                   Notice::Attention);
        }
    }
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

// A restart that nobody ordered stays on the screen.
void Notifications::tellBack()
{
    switch (m_client.loss()) {
    case DeviceClient::Loss::Link: notify(tr("Connected again."), Notice::Done, Concern::Back); break;
    case DeviceClient::Loss::OrderedRestart:
        notify(tr("The board has restarted and is back."), Notice::Done, Concern::Back);
        break;
    case DeviceClient::Loss::Restart:
        tell(tr("The board restarted by itself and is back. It uses the stored values."), Notice::Attention,
             Concern::None, tr("Its motors may run."));
    }
}

void Notifications::onConnectionFailed(const Error &error)
{
    ErrorText text = describe(error);
    const LinkAddress &address = m_client.address();
    const bool isNobodyHere = error.code == ErrorCode::Silent || error.code == ErrorCode::SilentPeer
        || error.code == ErrorCode::Garbage || error.code == ErrorCode::WrongProtocol;
    const QList<Family> families = isNobodyHere ? m_client.families() : QList<Family>();
    for (const Family &family : familiesNotAsked(families, address))
        text.cure += u' '
            + tr("Over this kind of link %1 is asked only if it is named: add ?family=%2 to the address.")
                  .arg(family.name, family.key);
    for (const Family &family : families) {
        if (!family.livesOn(address.kind()) && !family.usualAddress.isEmpty())
            text.cure += u' '
                + tr("%1 is not reached this way; it is usually at %2.")
                      .arg(family.name, family.usualAddress);
    }
    report(text, Concern::Link);
}

void Notifications::onLost(const Error &error)
{
    m_wasLost = true;
    settle(Concern::Standby);
    if (m_client.loss() == DeviceClient::Loss::OrderedRestart) {
        notify(tr("The board restarts, as it was told to. The program connects again as soon as it is back."),
               Notice::Hint);
        return;
    }
    ErrorText text = describe(error);
    if (m_client.loss() == DeviceClient::Loss::Restart)
        text.cure = tr("The program connects again as soon as it is back. Check its supply voltage and its "
                       "cables.");
    // It replaces what was told of the motors.
    if (m_leftDisabled)
        text.meaning
            += tr(" Its motors were disabled while it was starting and may stay so until it restarts; "
                  "store nothing before.");
    if (m_configuration.changeCount() > 0)
        text.cure += tr(" Unwritten edits are kept.");
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

void Notifications::onSteeringEnded(bool confirmed)
{
    const bool wasInDoubt = m_told.contains(Concern::Steering);
    settle(Concern::Steering);
    if (confirmed && wasInDoubt && m_client.areOutputsUnknown())
        notify(disarmedUntoldText(), Notice::Attention, Concern::Stopped);
    else if (confirmed && wasInDoubt)
        notify(flies() ? tr("The drone is disarmed, and its outputs stand.")
                       : tr("The board has stopped turning the camera."));
    if (!confirmed && flies())
        report(ErrorText{tr("The drone did not confirm that it is disarmed."),
                         tr("It may go on with its last throttle. Disarming it goes on as long as there is a "
                            "link, and begins again with the next one."),
                         keepAwayText(),
                         {}},
               Concern::Steering);
    else if (!confirmed)
        report(ErrorText{tr("The board did not confirm that it has stopped turning the camera."),
                         tr("The camera may go on moving as it was steered last."),
                         tr("Stop the motors (F12), once there is a link; or hold the camera and "
                            "disconnect the power."),
                         {}},
               Concern::Steering);
}

void Notifications::reportStartUnanswered(const Error &error)
{
    ErrorText text = describe(error);
    text.what = tr("The board did not answer to the start of its motors.");
    text.meaning = tr("They may start yet, at any moment.");
    text.cure = tr("Keep your hands off the gimbal, or have the motors stopped (F12).");
    report(text, Concern::Start);
}

void Notifications::onMotorsOff(bool confirmed)
{
    if (confirmed) {
        settle(Concern::Start);
        settle(Concern::Motors);
        settle(Concern::Steering);
        if (m_client.areOutputsUnknown())
            notify(disarmedUntoldText(), Notice::Attention, Concern::Stopped);
        else
            notify(tr("The motors were switched off."), Notice::Done, Concern::Stopped);
        return;
    }
    settle(Concern::Stopped);
    settle(Concern::Motors);  // what was told meanwhile
    reportMotorsMayRun(tr("The board did not confirm that the motors are off."));
}
