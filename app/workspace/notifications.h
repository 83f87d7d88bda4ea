// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/offer.h"
#include "protocol/client/deviceclient.h"
#include "widgets/models/configurationmodel.h"
#include "widgets/models/errortext.h"

#include <QMap>

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

/// What a problem is about. It is withdrawn when that is settled, and only then.
enum class Concern {
    None,  ///< stays until it is closed
    Link,
    Reading,  ///< of the board's values
    LiveData,
    Recording,  ///< that is played
    Motors,  ///< that may still be running
};

/// Messages and questions to the operator. Events of the link are reported by this class itself.
class Notifications final : public QObject
{
    Q_OBJECT
public:
    Notifications(DeviceClient &client, const ConfigurationModel &configuration);

    /// Something the operator must know.
    void report(const ErrorText &text, Concern concern = Concern::None);
    void report(const Error &error, Concern concern = Concern::None);
    /// A stop that did not end well: what happened, the rest is said here.
    void reportMotorsMayRun(const QString &what);
    /// What was told of this holds no longer.
    void settle(Concern concern);
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
    QMap<Concern, QString> m_told;  // and holds still
    bool m_leftDisabled = false;  // motors of a board that did not reach standby
    bool m_damageTold = false;  // of the recording that is played
};
