// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/offer.h"
#include "protocol/client/deviceclient.h"
#include "widgets/models/configurationmodel.h"
#include "widgets/models/errortext.h"

class EditJournal;
class LinkRecorder;

/// The link has ended or the request was withdrawn: no news for whoever asked without being told to.
[[nodiscard]] bool isEndOfLink(const Error &error);

/// What a message that is no problem means.
enum class Notice {
    Done,  ///< something went well
    Hint,  ///< good to know
    Attention,  ///< something is not as wished; stays until it is closed
};

/// Messages and questions to the operator. Events of the link are reported by this class itself.
class Notifications final : public QObject
{
    Q_OBJECT
public:
    Notifications(DeviceClient &client, const ConfigurationModel &configuration);

    /// Something the operator must know.
    void report(const ErrorText &text);
    void report(const Error &error);
    void notify(const QString &text, Notice kind = Notice::Done);
    /// How saving a file went.
    void reportSaved(const Result<void> &saved, const QString &path);
    void ask(const Offer &question);

    /// Reports when the journal of edits cannot be written.
    void follow(const EditJournal &journal);
    /// Reports how recordings end.
    void follow(const LinkRecorder &recorder);

signals:
    void problem(const ErrorText &text);
    void notice(const QString &text, Notice kind);
    /// What was told under this text holds no longer.
    void withdrawn(const QString &text);
    void offer(const Offer &offer);

private:
    void onState(DeviceClient::State state);
    void onConnectionFailed(const Error &error);
    void onLost(const Error &error);
    void onTelemetryFailed(const Error &error);
    void onMotorsOff(bool confirmed);
    void onReplay();

    DeviceClient &m_client;
    const ConfigurationModel &m_configuration;
    bool m_wasLost = false;
    QString m_linkProblem;  // what was told of the link
    bool m_leftDisabled = false;  // motors of a board that did not reach standby
    bool m_damageTold = false;  // of the recording that is played
};
