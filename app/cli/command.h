// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/client/deviceclient.h"
#include "protocol/configuration/linediff.h"
#include "protocol/configuration/writereport.h"
#include "protocol/device/abilities.h"
#include "protocol/device/family.h"
#include "protocol/procedure/motiontest.h"
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/record/boardhistory.h"
#include "protocol/supervisor/alarm.h"
#include "protocol/telemetry/streams.h"
#include "protocol/telemetry/telemetrystore.h"
#include "protocol/transport/replay.h"
#include "widgets/models/errortext.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QTimer>

#include <memory>
#include <optional>

/// What the program provides to every command.
struct CommandContext
{
    QList<Family> families;
    BoardHistory history;
    bool json = false;
    QStringList arguments;  ///< words after the command's name
    bool isBoardSaid = false;  ///< the operator has said which board it is
    SupervisorRules rules{};
    /// Links::offerVideo.
    std::function<Result<quint16>(const LinkAddress &)> offerVideo = {};
};

/// An option that a command takes. Without a value name it is a switch.
struct CommandOption
{
    QString name;
    QString value;  ///< placeholder for the value in the help: "N"
    QString help;
    /// Called once per occurrence of the option. Errors: InvalidArgument.
    std::function<Result<void>(const QString &text)> take;
    bool repeats = false;  ///< may be given more than once

    /// As it stands in a usage line: "[--profile N]".
    [[nodiscard]] QString usage() const;
};

/// The output of a command: a JSON document, and the same as text.
struct CommandOutcome
{
    QJsonValue json;
    QString text;
    QString note;  ///< for people only, on stderr: where the snapshot was saved, how the command went
    int exitCode = 0;
    std::shared_ptr<const WriteReport> report;  ///< of a write; becomes text and JSON when the command ends

    friend bool operator==(const CommandOutcome &, const CommandOutcome &) = default;
};

/// Exit codes of gimbalctl.
enum ExitCode { Done = 0, Refused = 1, WrongArguments = 2 };

/// One command of gimbalctl: what it takes, and how it runs on a link. Commands that ask and answer derive
/// from BoardCommand or LocalCommand; those that live on the running link from this.
class Command : public QObject
{
    Q_OBJECT
public:
    /// @param context outlives the command; its arguments are known when the command is checked
    explicit Command(const CommandContext &context)
        : m_context(context)
    {
    }

    [[nodiscard]] virtual const char *name() const = 0;
    /// What follows the name: "KEY=VALUE...".
    [[nodiscard]] virtual const char *words() const { return ""; }
    /// One line.
    [[nodiscard]] virtual QString help() const = 0;
    /// What follows "gimbalctl" on a line that could be typed.
    [[nodiscard]] virtual const char *example() const = 0;
    [[nodiscard]] virtual QList<CommandOption> options() { return {}; }
    /// What is wrong with the arguments; empty if they are valid. Called once the options have been set.
    [[nodiscard]] virtual QString check() const { return {}; }

    /// Whether one of its words may be empty, which is a mistake otherwise.
    [[nodiscard]] virtual bool takesEmptyWords() const { return false; }
    /// What is wrong with the words whatever the command does with them: too many, empty, far too long, the
    /// same NAME=VALUE twice. Empty if nothing is.
    [[nodiscard]] QString wordMistake() const;

    [[nodiscard]] virtual bool needsBoard() const { return true; }
    /// It moves the board: it is cancelled when the motors are switched off, and motion that nobody wanted or
    /// saw is no success.
    [[nodiscard]] virtual bool moves() const { return false; }
    /// Called before the client connects, for commands that must not miss anything.
    virtual void prepare(DeviceClient &) { }
    /// A board is connected; finished() or failed() follows.
    virtual void start(DeviceClient &client) = 0;
    /// Called instead of start() where no board is needed.
    virtual void startWithoutBoard() { emit finished(failure(ErrorCode::NotConnected)); }
    /// A lost link is its own affair: it ends by itself, with what it knows.
    [[nodiscard]] virtual bool reportsLoss() const { return false; }
    /// What stays open when it fails, for people: motors that may run. Empty: nothing.
    [[nodiscard]] virtual QString leftOpen(const Error &) const { return {}; }
    /// The link was lost and does not come back in time; true if the command ends with what it has.
    [[nodiscard]] virtual bool endsWith(const Error &) { return false; }
    /// Ctrl-C: stops whatever moves; the end is reported as usual.
    virtual void stop() = 0;

    /// Name, words and options.
    [[nodiscard]] QString usage();
    /// Usage, options and an example.
    [[nodiscard]] QString fullHelp();

signals:
    void finished(const Result<CommandOutcome> &outcome);
    /// An error with an exit code of its own.
    void failed(const Error &error, int exitCode);
    /// For people, on stderr.
    void told(const QString &line);
    /// What is so at this moment, the same way; soon it is something else.
    void shown(const QString &line);

protected:
    /// What the supervisor cannot see, and which faults the board reports, is told from now on.
    void tellCondition(DeviceClient &client);
    [[nodiscard]] const QStringList &arguments() const { return m_context.arguments; }
    [[nodiscard]] const CommandContext &context() const { return m_context; }
    [[nodiscard]] const QList<Family> &families() const { return m_context.families; }
    [[nodiscard]] const BoardHistory &history() const { return m_context.history; }
    /// What the operator wants the supervisor to do.
    [[nodiscard]] const SupervisorRules &rules() const { return m_context.rules; }
    [[nodiscard]] bool speaksJson() const { return m_context.json; }

private:
    const CommandContext &m_context;
};

/// Sequential code on the worker thread.
class BoardCommand : public Command
{
    Q_OBJECT
public:
    using Command::Command;

    [[nodiscard]] bool reportsLoss() const override { return true; }
    void start(DeviceClient &client) override;
    void stop() override;

protected:
    /// Channels that must have a new value before it runs. It waits for them for two seconds, then runs all
    /// the same and finds them without values.
    [[nodiscard]] virtual QList<int> awaits(const Device &) const { return {}; }
    virtual Result<CommandOutcome> run(Channel &channel, Device &device) = 0;
    /// It failed; true if the command goes on by itself and tells how it ends.
    [[nodiscard]] virtual bool goesOnAfter(const Error &) { return false; }
    [[nodiscard]] DeviceClient &client() const { return *m_client; }
    /// The board is that of a drone.
    [[nodiscard]] bool flies() const
    {
        return m_client && m_client->device() && m_client->device()->flight();
    }
    /// The telemetry of the board.
    [[nodiscard]] const std::shared_ptr<const TelemetryStore> &telemetry() const { return m_telemetry; }
    /// The newest of it.
    [[nodiscard]] const LatestValues *latest() const { return m_telemetry.get(); }

private:
    void awaitTelemetry(const QList<int> &channels);
    void submit();
    void awaitBoard(const Result<CommandOutcome> &outcome);
    void readAgain();
    void conclude(Result<CommandOutcome> outcome);
    void onceStill(const std::function<void()> &then);

    DeviceClient *m_client = nullptr;
    std::optional<Result<CommandOutcome>> m_interrupted;  // waits for the board to come back
    QTimer m_absence;
    bool m_goesOn = false;  // what it has moved
    std::shared_ptr<const TelemetryStore> m_telemetry;
    QTimer m_awaiting;
};

/// Needs no board at all.
class LocalCommand : public Command
{
    Q_OBJECT
public:
    using Command::Command;

    [[nodiscard]] bool needsBoard() const final { return false; }
    void start(DeviceClient &) final { startWithoutBoard(); }
    void startWithoutBoard() final { emit finished(run()); }
    void stop() final { }

protected:
    virtual Result<CommandOutcome> run() = 0;
};

using Commands = std::vector<std::unique_ptr<Command>>;

/// All commands in the order of the help text.
[[nodiscard]] Commands allCommands(const CommandContext &context);

[[nodiscard]] Commands parameterCommands(const CommandContext &context);
[[nodiscard]] Commands fileCommands(const CommandContext &context);
[[nodiscard]] Commands scriptCommands(const CommandContext &context);
[[nodiscard]] Commands textCommands(const CommandContext &context);
[[nodiscard]] Commands actionCommands(const CommandContext &context);
[[nodiscard]] Commands recordingCommands(const CommandContext &context);
[[nodiscard]] Commands linkCommands(const CommandContext &context);
[[nodiscard]] Commands videoCommands(const CommandContext &context);
[[nodiscard]] Commands rawCommands(const CommandContext &context);
[[nodiscard]] Commands setupCommands(const CommandContext &context);

template <typename... Each> [[nodiscard]] Commands makeCommands(const CommandContext &context)
{
    Commands commands;
    (commands.push_back(std::make_unique<Each>(context)), ...);
    return commands;
}

// Options that several commands take.
[[nodiscard]] CommandOption switchOption(const QString &name, const QString &help, bool &on);
[[nodiscard]] CommandOption textOption(const QString &name, const QString &value, const QString &help,
                                       QString &text);
/// A profile from 1; left at 0 without the option.
[[nodiscard]] CommandOption profileOption(int &profile);
/// Keys of channels, separated by commas.
[[nodiscard]] CommandOption channelsOption(QStringList &keys);

/// The channels with these keys. Errors: InvalidArgument.
[[nodiscard]] Result<QList<int>> findChannels(ChannelTable table, const QStringList &keys);
/// The channels of most interest: angles, targets and gyroscopes.
[[nodiscard]] QList<int> defaultChannels(const Device &device);
/// What a motion test found. Errors: InvalidArgument (the samples tell nothing).
[[nodiscard]] Result<CommandOutcome> describeMotion(const MotionTestResult &result);
/// A value with its unit, for people.
[[nodiscard]] QString valueText(const ParameterSpec &spec, double raw);
/// The text of the value, or null for NaN.
[[nodiscard]] QJsonValue valueJson(const ParameterSpec &spec, double raw);
[[nodiscard]] QJsonObject changeJson(const ParameterChange &change);
/// Lines "profile  key  old -> new".
[[nodiscard]] QString changeText(const Configuration &configuration,
                                 const std::vector<ParameterChange> &changes);
/// Lines for the blocks that differ as a whole.
[[nodiscard]] QString dataText(const std::vector<DataChange> &changes);
/// The same in a document: "data", and for a text how many lines were "added" and "removed".
[[nodiscard]] QJsonObject dataJson(const DataChange &change);
/// Lines with "+", "-" or nothing before them, and only those around a difference.
[[nodiscard]] QString differenceText(const std::vector<DiffLine> &lines);
/// The switch for a result that may lack parts of the board, or of a recording.
[[nodiscard]] CommandOption partialOption(bool &on);
/// `where` of reportMissing() for a board.
inline const QString kTheBoard = QStringLiteral("the board");
/// Names what this board or file lacks, in the note and in the document: its "missing", or an entry each of
/// an array. The exit code is then 1 unless the operator wants a partial result.
void reportMissing(CommandOutcome &outcome, const Configuration &configuration, const QString &where,
                   bool partial);
/// Names what is missing in the document alone.
void addMissing(CommandOutcome &outcome, const QStringList &names, const QString &where);
/// Names what was rounded to what the board can hold, in the note and in the document.
void reportRounded(CommandOutcome &outcome, const QStringList &rounded);
/// Lines that tell what a damaged recording lacks.
[[nodiscard]] QString leftOutText(const QList<ReplayGap> &gaps);
/// Adds them to the note, and to the document as reportMissing() does, under "leftOut". The exit code is then
/// 1 unless the operator wants a partial result.
void reportLeftOut(CommandOutcome &outcome, const QList<ReplayGap> &gaps, bool partial);
/// Words for an error as a command says them, which has ended: no window connects again by itself.
/// @param flies the board is that of a drone: nobody holds it while its motors turn
[[nodiscard]] ErrorText forConsole(ErrorText text, ErrorCode code, bool flies = false);
/// The same, from the error.
[[nodiscard]] ErrorText consoleText(const Error &error, bool flies = false);
/// What keeps people unhurt while motors may run.
/// @param flies empty: no board has answered
[[nodiscard]] QString keepAwayText(std::optional<bool> flies);
/// An error in a document: "error", "meaning", "cure" and "detail".
[[nodiscard]] QJsonObject errorJson(const Error &error, bool flies = false);
/// Adds an error to what came all the same, in the note and in the document (an object). The exit code is 1.
void reportError(CommandOutcome &outcome, const Error &error);
/// What becomes of values that are in use without being stored, beside those that are written.
[[nodiscard]] CommandOption othersOption(std::optional<OtherValues> &others);
/// The report of a write becomes text, note and document; it comes before what the command has to say beside
/// it.
void tellReport(CommandOutcome &outcome);
/// "Studio: " where the lines of a report are of several profiles.
[[nodiscard]] QString profileOf(const WriteReport &report, const WriteLine &line);
/// Tells what else was in use without being stored, and which profile is active if another one than before:
/// adds lines to the text and "others" to the document, and returns a sentence for the note; empty if there
/// is nothing.
[[nodiscard]] QString tellOthers(const WriteReport &report, QString &text, QJsonObject &json);
/// Reads what a write starts from: everything as it is stored, where the board tells that apart from what is
/// in use. Goes into the options of the write.
/// Errors: InvalidArgument where the board cannot do what was asked for.
Result<Configuration> readBase(Channel &channel, Device &device, std::optional<OtherValues> others,
                               WriteOptions &options);
/// Whether the board has a choice about them. Errors: InvalidArgument.
Result<void> checkOthers(Device &device, std::optional<OtherValues> others);
/// What else is in use without being stored, as found by readBase(): a sentence before anything is written.
/// @param wanted keys of parameters, and names of blocks without any, that are to be written
[[nodiscard]] QString othersText(Device &device, const WriteOptions &options, const QSet<QString> &wanted);
/// What a write of these would replace in use, on a board that loads what is written: a sentence; empty if
/// nothing is known to be.
/// @param wanted keys of parameters that are to be written
[[nodiscard]] QString replacedText(Channel &channel, Device &device, const Configuration &base,
                                   const QSet<QString> &wanted);
/// The switch that lets leaps (isLeap()) through.
[[nodiscard]] CommandOption leapOption(bool &on);
/// Whether it may be written. Errors: InvalidArgument (there are leaps, and nobody has confirmed them).
Result<void> checkLeaps(const Configuration &base, const Configuration &edited, bool areConfirmed);
/// Writes and reports the result. The exit code is 1 unless everything was verified.
Result<CommandOutcome> writeAndReport(Channel &channel, Device &device, const Configuration &base,
                                      const Configuration &edited, const WriteOptions &options);
/// The same, and names what of the board was not read beside it; that is no failure of this write.
Result<CommandOutcome> writeAndTellMissing(Channel &channel, Device &device, const Configuration &base,
                                           const Configuration &edited, const WriteOptions &options);
