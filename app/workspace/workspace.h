// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/composition/links.h"
#include "app/workspace/alarms.h"
#include "app/workspace/boardnaming.h"
#include "app/workspace/boardwriter.h"
#include "app/workspace/confirmations.h"
#include "app/workspace/editjournal.h"
#include "app/workspace/freshness.h"
#include "app/workspace/leftsteering.h"
#include "app/workspace/linkhealth.h"
#include "app/workspace/linkmarks.h"
#include "app/workspace/linkrecorder.h"
#include "app/workspace/notchadviser.h"
#include "app/workspace/notifications.h"
#include "app/workspace/settings.h"
#include "app/workspace/telemetrysubscriptions.h"
#include "protocol/client/deviceclient.h"
#include "protocol/device/abilities.h"
#include "protocol/device/family.h"
#include "protocol/procedure/safeaction.h"
#include "widgets/forms/editstack.h"
#include "widgets/gamepad/gamepad.h"
#include "widgets/models/livemodel.h"
#include "widgets/theme/theme.h"

/// "31 °C" or "88 °F"; empty for NaN.
[[nodiscard]] QString temperatureText(double celsius, bool fahrenheit);

/// What all pages share: the client, the configuration with its edits, the history of snapshots, the theme,
/// what the operator is told, what the board sends. Turns what the operator wants into jobs, and their
/// results into changes of the models.
class Workspace final : public QObject
{
    Q_OBJECT
public:
    Workspace(Links links, QList<Family> families, Theme &theme, Settings &settings,
              QObject *parent = nullptr);
    ~Workspace() override;
    /// Ends the link and saves unsaved edits; to be called before pages are destroyed.
    void shutDown();

    [[nodiscard]] DeviceClient &client() { return m_client; }
    [[nodiscard]] const DeviceClient &client() const { return m_client; }
    [[nodiscard]] ConfigurationModel &configuration() { return m_configuration; }
    [[nodiscard]] const ConfigurationModel &configuration() const { return m_configuration; }
    [[nodiscard]] EditStack &edits() { return m_edits; }
    [[nodiscard]] Theme &theme() { return m_theme; }
    [[nodiscard]] BoardHistory &history() { return m_history; }
    /// Values that the board changes at once, shared by all pages.
    [[nodiscard]] LiveModel &live() { return m_live; }
    [[nodiscard]] Settings &settings() { return m_settings; }
    [[nodiscard]] const Links &links() const { return m_links; }
    [[nodiscard]] EditJournal &journal() { return m_journal; }
    [[nodiscard]] BoardNaming &naming() { return m_naming; }
    [[nodiscard]] LinkRecorder &recorder() { return m_recorder; }
    [[nodiscard]] Notifications &notifications() { return m_notifications; }
    [[nodiscard]] TelemetrySubscriptions &telemetry() { return m_telemetry; }
    [[nodiscard]] Freshness &freshness() { return m_freshness; }
    [[nodiscard]] Alarms &alarms() { return m_alarms; }
    [[nodiscard]] NotchAdviser &notches() { return m_notches; }
    /// Read only while somebody uses it.
    /// The file into which video is recorded; empty: none is.
    [[nodiscard]] const QString &videoRecording() const { return m_videoRecording; }
    void setVideoRecording(const QString &path);
    [[nodiscard]] Gamepad &gamepad() { return m_gamepad; }
    /// What happened on this link, for the plots.
    [[nodiscard]] PlotMarks &marks() { return m_marks; }
    /// Adds a mark at this moment.
    void mark(PlotMark::Kind kind, const QString &text) { m_linkMarks.add(kind, text); }

    void connectTo(const LinkAddress &address, const QString &family = {});
    /// Reads everything; edits are kept where the board is the same one.
    void readBoard();
    /// What is shown as the board's was read on this connection: before that it is that of the one before.
    [[nodiscard]] bool isBoardRead() const { return m_client.isConnected() && !m_unread; }
    /// Writes what differs between the board and this, verified, with a snapshot before the first write.
    void write(const Configuration &wanted, OtherValues others = OtherValues::Keep);
    /// Values in use that a write would store as well, were they not kept apart: on boards that can only
    /// store everything.
    [[nodiscard]] LiveValues storedWithAWrite() const;
    /// Values in use that somebody else set, and that a write replaces by what is stored.
    [[nodiscard]] LiveValues replacedByAWrite() const;
    /// Stores the values in use in the active profile, with a snapshot of what was stored before. True when
    /// it was done. On a board that can only store everything in use, whatever else that would be is listed
    /// first in a panel of that widget's window, and can be kept out.
    /// @param listed keys of what the operator has been shown; by default the values known to be live
    QFuture<bool> saveLive(QWidget &over, std::optional<QSet<QString>> listed = {});
    /// What is in use is compared with what is stored, where the board tells the two apart.
    [[nodiscard]] bool canCompareStored() const;
    QFuture<Result<WholeMemory::Contents>> compareStored();
    /// It has been, on this link: values that were in use before count as well.
    [[nodiscard]] bool isStoredKnown() const { return m_storedKnown; }
    /// The board keeps a text of what it starts with, and uses just that.
    [[nodiscard]] bool usesItsText() const { return m_isTextOlder == false; }
    void useProfile(int profile);
    /// Opens a configuration without a board, to look at and to edit, or a recording as a link. Errors:
    /// BadFile.
    Result<void> openFile(const QString &path);
    /// Understands a configuration file in terms of the board shown. Errors: BadFile.
    Result<ConfigurationFile> loadFile(const QString &path) const;
    /// Takes a file's values over as edits, all of them or one profile's. Errors: BadFile, NotConnected.
    Result<void> applyFile(const QString &path, std::optional<int> from = {}, int to = 0);
    /// Saves what the pages show, edits included. Errors: BadFile.
    Result<void> saveFile(const QString &path);
    /// What a file saved now lacks, because it could not be read; empty if nothing.
    [[nodiscard]] QString lacking() const;
    /// The file that is being edited without a board; empty with one.
    [[nodiscard]] QString offlineFile() const { return m_client.isConnected() ? QString() : m_offlineFile; }
    /// Edits that are not on the board, and typed texts that are no edits yet or no values.
    [[nodiscard]] int unsavedCount() const
    {
        return m_configuration.changeCount() + m_journal.drafts().count() + m_edits.refused().count();
    }
    void discardUnsaved();
    /// Takes a snapshot of the board as it is now, or of the offline configuration.
    void takeSnapshot();

    /// Performs an action, with a snapshot before it where it writes. What it wants to be confirmed is asked
    /// each time; without the answer it ends with Cancelled. Failures are reported unless quiet.
    QFuture<Result<ActionOutcome>> perform(const QString &key, const QVariantMap &arguments,
                                           bool quiet = false);

    /// The gimbal is a simulated one whose world can be changed.
    [[nodiscard]] bool isSimulated() const;
    void changeWorld(const QString &assignment);
    void setMotors(bool on);
    /// Switches them off over the link there is. False: not proven so far (it goes on), or the link went.
    QFuture<bool> stopMotors();
    /// Ends steering, whoever steers.
    void releaseControl();
    /// While a wizard leads through several steps, storing and starting the motors are steps of its own:
    /// nothing else on the screen does that then.
    void setGuided(bool guided, const QString &steps = {});
    [[nodiscard]] bool isGuided() const { return m_guided; }
    /// Something that flies is armed from here: what would need it disarmed is refused until it is.
    void setFlown(bool flown);
    [[nodiscard]] bool isFlown() const { return m_flown; }
    /// A control session is open in which the propellers are on: nothing turns a motor from elsewhere.
    void setPropellersOn(bool on);
    /// What runs on the board now and ends by itself alone; null: nothing does.
    [[nodiscard]] const ActionSpec *unstoppable() const { return m_unstoppable; }
    [[nodiscard]] Confirmations &confirmations() { return m_confirmations; }
    /// It was armed from here, and has not said since that it is disarmed and its outputs are 0.
    [[nodiscard]] bool mayStillFly() const;
    /// True, and told, while a search, measurement or calibration runs (LiveModel::isHeld()): what is
    /// written, stored, switched or begun meanwhile would wait for its end, and fall on what it has found.
    bool refusesMeanwhile();
    /// The same for what would begin one, and while a write runs, which puts values back into use at its end.
    bool refusesToBegin();
    /// A procedure, or an action on the board's memory, runs: an end of the link would leave it half done.
    [[nodiscard]] bool isAtWork() const { return m_works > 0; }
    /// Brackets such work, for pages that do it by themselves.
    void beginWork() { ++m_works; }
    void endWork()
    {
        if (--m_works == 0)
            emit workEnded();
    }
    /// The span of time in a paused plot, in seconds since the store's origin.
    void setHeldSpan(std::optional<std::pair<double, double>> span) { m_heldSpan = span; }
    [[nodiscard]] std::optional<std::pair<double, double>> heldSpan() const { return m_heldSpan; }

    /// The channel's newest value, NaN without one.
    [[nodiscard]] double latest(int channel) const;
    [[nodiscard]] const ChannelRoles &roles() const;
    /// The board shown, or boards like it when none is connected, have an action of that name.
    [[nodiscard]] bool hasAction(const QString &key) const;
    /// The tables of that board, or of its family without one.
    [[nodiscard]] const Device *tables() const;
    /// The family of the board or file shown; null before the first.
    [[nodiscard]] const Family *family() const;
    /// The same; before the first board or file, the most likely family.
    [[nodiscard]] const Family *expectedFamily() const;
    [[nodiscard]] const QString &defaultFamily() const { return m_links.defaultFamily; }
    /// Profiles of the board or file shown; 0 without one.
    [[nodiscard]] int profileCount() const;
    /// What a dialog offers for configurations of the family shown, and for everything that can be opened.
    [[nodiscard]] QString configurationFilter() const;
    [[nodiscard]] QString openFilter() const;
    /// Values are in use that a restart would lose, for all this program knows.
    /// Beyond the values to tune with, which can be put back one by one.
    [[nodiscard]] bool isUnstored() const
    {
        return m_unstored || m_isTextOlder.value_or(false) || m_live.changeCount() > m_live.tunedCount();
    }
    /// True, false, or nothing while telemetry is missing or old.
    [[nodiscard]] std::optional<bool> motorsRunning() const;
    /// The board reports that it starts: its motors run soon, without being told to.
    [[nodiscard]] bool isStarting() const;
    /// The board hears nothing, because of something that drives its motors (DeviceClient::deafUntil()).
    [[nodiscard]] bool isDeaf() const;
    [[nodiscard]] std::vector<BoardFault> faults() const;
    [[nodiscard]] const std::optional<WriteReport> &lastReport() const { return m_writer.lastReport(); }
    [[nodiscard]] bool isWriting() const { return m_writer.isWriting(); }

signals:
    void boardRead();
    void unstoredChanged();
    void videoRecordingChanged();
    void guidedChanged();
    /// A snapshot was added to the board's history.
    void snapshotTaken();
    /// The world around the simulated gimbal was changed: a fault as NAME=VALUE.
    void worldChanged(const QString &assignment);
    void writeStarted();
    void writeFinished();
    /// The last of what ran has ended.
    void workEnded();
    /// Steering shall end.
    void controlReleased();
    /// The operator wants to see that place of a text.
    void textWanted(const TextPlace &place);

private:
    void onState(DeviceClient::State state);
    void onLost();
    void offerLeftover(int steps, int texts);
    void restoreLeftover();
    QFuture<Result<ActionOutcome>> performNow(const QString &key, const QVariantMap &arguments, bool quiet);
    void applySettings();
    void keepMissing(Configuration &read) const;
    void tellMissing(const Configuration &configuration);
    void setUnstored(bool unstored);
    void compareWithText();
    void learnStored(const WholeMemory::Contents &both);
    void learnLastStored();
    QFuture<bool> storeLive(QWidget &over, std::optional<QSet<QString>> listed);
    QFuture<bool> askToStoreAlarmed(QWidget &over, const std::optional<QSet<QString>> &listed);
    [[nodiscard]] bool isAlarmedInUse() const;
    QFuture<bool> storeAll();
    QFuture<bool> reviewRewriting(QWidget &over);
    QFuture<bool> reviewStoring(const WholeMemory::Contents &both, QWidget &over);
    QFuture<bool> askToStoreAll(const Error &untold, QWidget &over);
    QFuture<bool> storeChosen(const Configuration &chosen);
    bool isProven(const ActionOutcome &stored);
    void tellGuided();
    QFuture<Result<ActionOutcome>> endWhatGoesOn(const ActionSpec &action,
                                                 QFuture<Result<ActionOutcome>> done);
    void tellFailure(const ActionSpec &action, const Error &error);
    void tellStopped(const ActionSpec &action, const Error &error);
    void offerPlace(const ActionSpec &action, const Error &error);
    void readWhenFree();
    void readUnknown();
    [[nodiscard]] bool isUnknown() const;
    void readAfterFailure(const Error &error, const LiveValues &before, bool quiet);
    [[nodiscard]] LiveValues changedInUse(const Aftermath &after, const Configuration &now) const;
    void settle(const Configuration &board);
    void readAfter(const ActionSpec &action, const ActionOutcome &outcome, const LiveValues &before);
    void readKnowing(const std::optional<LiveValues> &live, bool quiet = false);
    [[nodiscard]] QStringList changedMeanwhile(const Configuration &read) const;
    void leaveEdits();
    void judge(int others, QStringList names = {});
    void setEditsAside();
    void offerWayOut();
    void followActiveProfile();
    void settleMotors();
    void tellRunningOn(bool isRunning);
    void followMotors(DeviceClient::State state);
    /// The motors were told to stop, and there is no link to do it.
    void stopAtNextLink();
    void forgetStop();
    [[nodiscard]] LiveValues lostSince(const Configuration &read) const;
    void tellLost(const LiveValues &lost);
    void tellNotTaken(const LiveValues &values);

    Theme &m_theme;
    Settings &m_settings;
    Links m_links;
    DeviceClient m_client;
    ConfigurationModel m_configuration;
    LiveModel m_live;
    Notifications m_notifications;
    TelemetrySubscriptions m_telemetry;
    Freshness m_freshness;
    EditStack m_edits;
    BoardHistory m_history;
    EditJournal m_journal;
    BoardNaming m_naming;  // hears of a board before those that use its history
    LinkRecorder m_recorder;
    QString m_offlineFile;
    bool m_isRecording = false;  // what is shown was read from one
    std::optional<std::pair<double, double>> m_heldSpan;
    PlotMarks m_marks;
    LinkMarks m_linkMarks;
    Alarms m_alarms;
    LeftSteering m_leftSteering;
    LinkHealth m_linkHealth;
    BoardWriter m_writer;
    mutable std::unique_ptr<Device> m_tables;  // of the file's family, while no board is connected
    mutable QString m_tablesOf;
    Confirmations m_confirmations;
    NotchAdviser m_notches{m_client,  m_configuration, m_live,      m_edits,    m_writer,
                           m_history, m_notifications, m_telemetry, m_linkMarks};
    QString m_videoRecording;
    Gamepad m_gamepad;
    bool m_unstored = false;
    std::optional<bool> m_isTextOlder;  // than what the board uses (Configuration::usesUnstored)
    bool m_storedKnown = false;
    bool m_guided = false;
    bool m_flown = false;
    bool m_propellersOn = false;
    const ActionSpec *m_unstoppable = nullptr;
    TimePoint m_flownAt{};  // last, as long as it has not been seen to stand since
    QString m_guidedSteps;  // how the keys of its actions begin
    int m_works = 0;
    std::optional<Error> m_unsettled;  // something that failed; what the board holds since is not known yet
    bool m_unsettledQuietly = false;  // who began it tells of it
    QString m_unstoredSerial;
    bool m_reading = false;
    bool m_unread = false;  // since this link began
    std::optional<quint64> m_framesHeard;  // while something is unknown; more of them: the board answers
    int m_rereads = 0;  // for the same unknown
    bool m_readLater = false;  // when nothing is held any more
    bool m_isDoubted = false;  // whether it is the board before, until the operator has answered
    bool m_switchingProfile = false;
    TimePoint m_profileKnownAt{};  // the active one
    bool m_stopWhenConnected = false;
    std::optional<bool> m_ranLast;  // whether the motors ran, for all that was heard on this link
    bool m_wereOff = false;  // before the link was lost, and nobody has started them since
    TimePoint m_startsUntil{};
    std::optional<TimePoint> m_stopProvenAt;
    LiveValues m_alarmedWith;  // in use without being stored when an alarm came
    bool m_startUnanswered = false;  // the motors may start yet
    std::optional<TimePoint> m_stopUnprovenAt;  // and not told yet what the board reports since
    LiveValues m_usedBefore;  // in use without being stored when the link was lost
    mutable quint64 m_lastRows = 0;
    mutable TimePoint m_lastRowsAt{};
};
