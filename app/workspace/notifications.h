// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/offer.h"
#include "protocol/client/deviceclient.h"
#include "protocol/transport/replay.h"
#include "widgets/models/configurationmodel.h"
#include "widgets/models/errortext.h"

#include <QDateTime>
#include <QSet>

#include <optional>

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

/// What a message is about. It is withdrawn when that is settled, and only then.
enum class Concern {
    None,  ///< answers what was just asked for; stays until it is closed or something else is answered
    Link,
    OtherStation,  ///< that gets the board's answers
    Back,  ///< that a board is there again
    Reading,  ///< of the board's values
    LiveData,
    Frozen,  ///< live data that are the same again and again
    Silence,  ///< of a board whose motors ran
    Recording,  ///< that is played
    Start,  ///< of motors, which may come yet
    Motors,  ///< that may still be running, or are yet to be stopped
    Stopped,  ///< motors that were switched off, until they run again
    Steering,  ///< that may not have ended
    Standby,  ///< motors that stay disabled until the board restarts
    Writing,  ///< to the board's memory
    Interrupted,  ///< what a link or a restart has cut off, and what was read since
    Entry,  ///< what was typed and is no value
    Loading,  ///< of a file
    Saving,  ///< of a file
    Journal,  ///< of edits
    Settings,  ///< of this program
    Recorder,  ///< that records the link
    Leaving,  ///< what is waited for before the link or the program ends
};

/// A message as it was told.
struct ToldMessage
{
    QDateTime at;
    QString text;
    std::optional<Notice> kind;  ///< nothing for a problem
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
    /// A start that was sent, and not answered.
    void reportStartUnanswered(const Error &error);
    /// After a stop that is not proven, the board reports that its motors run.
    void reportMotorsRunOn();
    /// A stop was asked for, and there is no link.
    void reportNothingToStop();
    /// No live data come, and the motors ran when they came last.
    void reportSilence(const QDateTime &since);
    /// What was told of this holds no longer.
    void settle(Concern concern);
    void notify(const QString &text, Notice kind = Notice::Done, Concern concern = Concern::None);
    /// How saving a file went.
    /// @param lacking what the file lacks because it could not be read; empty if nothing
    void reportSaved(const Result<void> &saved, const QString &path, const QString &lacking = {});
    /// How loading a file went: a problem of an earlier load is settled by this one. Returns whether it went
    /// well.
    template <typename T> bool reportLoaded(const Result<T> &loaded)
    {
        settle(Concern::Loading);
        if (!loaded)
            report(loaded.error(), Concern::Loading);
        return bool(loaded);
    }
    /// What was told since the program began, the newest last, without what is long past.
    [[nodiscard]] const QList<ToldMessage> &history() const { return m_history; }
    /// The board is that of a drone.
    [[nodiscard]] bool flies() const;
    /// What keeps people unhurt while motors may run.
    [[nodiscard]] QString keepAwayText() const;
    void ask(const Offer &question);
    /// There is nothing to ask any more.
    void withdrawOffer(Topic topic);

    /// Reports when the journal of edits cannot be written.
    void follow(const EditJournal &journal);
    /// Reports how recordings end.
    void follow(const LinkRecorder &recorder);

signals:
    /// @param circumstances of which program, link and board, for a supporter
    void problem(const ErrorText &text, Concern concern, const QString &circumstances);
    /// @param motors what the board's may do, as long as that is not known
    void notice(const QString &text, Notice kind, Concern concern, const QString &motors);
    /// What was told of this holds no longer.
    void withdrawn(Concern concern);
    void offer(const Offer &offer);
    void offerWithdrawn(Topic topic);
    /// Another board answers on the same link: what was asked concerned the one before.
    void boardReplaced();

private:
    void tell(const QString &text, Notice kind, Concern concern, const QString &motors);
    void remember(const QString &text, std::optional<Notice> kind);
    [[nodiscard]] QString circumstances() const;
    /// What to do where motors may run.
    void onState(DeviceClient::State state);
    void onConnectionFailed(const Error &error);
    void onLost(const Error &error);
    void tellBack();
    void onTelemetryFailed(const Error &error);
    void onMotorsOff(bool confirmed);
    void onSteeringEnded(bool confirmed);
    void onReplay();
    [[nodiscard]] static QString causeText(GapCause cause);

    DeviceClient &m_client;
    const ConfigurationModel &m_configuration;
    bool m_wasLost = false;
    BoardIdentity m_board;  // connected last
    QList<ToldMessage> m_history;
    QSet<Concern> m_told;  // of which something may still be shown
    bool m_leftDisabled = false;  // motors of a board that did not reach standby
    bool m_damageTold = false;  // of the recording that is played
};
