// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"

#include "app/cli/faultteller.h"
#include "protocol/base/linkloss.h"
#include "protocol/configuration/aftermath.h"
#include "protocol/procedure/inuse.h"
#include "protocol/procedure/wholewrite.h"
#include "widgets/models/alarmtext.h"
#include "widgets/models/boardtext.h"
#include "widgets/models/missingtext.h"

#include <QSet>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr qsizetype kMaxWord = 4096;  // characters: the longest path
constexpr qsizetype kShownOfWord = 40;

constexpr auto kTelemetryWait = 2s;
constexpr auto kTelemetryPeriod = 20ms;
constexpr auto kAbsence = 20s;  // of a board whose link broke during a write
constexpr qsizetype kGapsTold = 10;

// Something that was sent is unknown because the link broke.
bool isOpen(const Result<CommandOutcome> &outcome)
{
    if (!outcome)
        return outcome.error().after && !outcome.error().after->now;
    if (!outcome->report || !outcome->report->error || !outcome->report->hasUnknown())
        return false;
    const Error &error = *outcome->report->error;
    return isLinkLoss(error) || error.code == ErrorCode::Cancelled;
}

const Configuration &beforeOf(const Result<CommandOutcome> &outcome)
{
    return outcome ? outcome->report->before : outcome.error().after->before;
}

QString causeText(GapCause cause)
{
    switch (cause) {
    case GapCause::FirstLine: return u"its first line is damaged"_s;
    case GapCause::EndsWithin: return u"the file ends within a chunk"_s;
    case GapCause::NoChunk: return u"no chunk begins there"_s;
    case GapCause::Checksum: return u"a checksum is wrong"_s;
    case GapCause::Description: return u"the description is not JSON"_s;
    case GapCause::Pieces: return u"a chunk holds something else than pieces"_s;
    }
    return {};
}

}  // namespace

QList<int> defaultChannels(const Device &device)
{
    const ChannelRoles roles = rolesOf(device);
    return ChannelRoles::present({roles.angle, roles.target, roles.gyro});
}

Result<QList<int>> findChannels(ChannelTable table, const QStringList &keys)
{
    QList<int> channels;
    for (const QString &key : keys) {
        const int channel = findChannel(table, key.trimmed());
        if (channel < 0) {
            QStringList known;
            for (const ChannelSpec &spec : table)
                known.append(QLatin1String(spec.key));
            return failure(ErrorCode::InvalidArgument,
                           u"no channel '%1'; there are: %2"_s.arg(key, known.join(u", "_s)));
        }
        if (table[std::size_t(channel)].elements > 1) {
            return failure(ErrorCode::InvalidArgument,
                           u"'%1' is an array of %2 values, which has no place in a table"_s.arg(key).arg(
                               table[std::size_t(channel)].elements));
        }
        channels.append(channel);
    }
    return channels;
}

Commands allCommands(const CommandContext &context)
{
    Commands all;
    for (auto part : {parameterCommands, fileCommands, scriptCommands, textCommands, actionCommands,
                      recordingCommands, linkCommands, videoCommands, rawCommands, setupCommands}) {
        for (auto &command : part(context))
            all.push_back(std::move(command));
    }
    return all;
}

QString CommandOption::usage() const
{
    return value.isEmpty() ? u"[--%1]"_s.arg(name) : u"[--%1 %2]"_s.arg(name, value);
}

QString Command::wordMistake() const
{
    const QString spoken = QLatin1String(words());
    if (spoken.isEmpty() && !arguments().isEmpty())
        return u"%1 takes options only, and '%2' is none"_s.arg(QLatin1String(name()),
                                                                arguments().first().left(kShownOfWord));
    QSet<QString> assigned;
    for (const QString &word : arguments()) {
        if (word.isEmpty() && !takesEmptyWords())
            return u"one of the words after %1 is empty"_s.arg(QLatin1String(name()));
        if (word.size() > kMaxWord)
            return u"'%1...' has %2 characters, which is more than anything here takes"_s
                .arg(word.left(kShownOfWord))
                .arg(word.size());
        const QString key = word.section(u'=', 0, 0);
        if (!spoken.contains(u'=') || key.size() == word.size())
            continue;
        if (assigned.contains(key))
            return u"'%1' is given twice"_s.arg(key);
        assigned.insert(key);
    }
    return {};
}

QString Command::usage()
{
    QStringList parts{QLatin1String(name())};
    if (*words())
        parts.append(QLatin1String(words()));
    for (const CommandOption &option : options())
        parts.append(option.usage());
    return parts.join(u' ');
}

QString Command::fullHelp()
{
    QString text = u"gimbalctl %1\n\n%2\n"_s.arg(usage(), help());
    for (const CommandOption &option : options()) {
        const QString heading = u"\n  --%1 %2"_s.arg(option.name, option.value);
        text += heading.leftJustified(25) + option.help;
    }
    text += options().isEmpty() ? QString() : u"\n"_s;
    return text
        + u"\nExample: gimbalctl %1\nOptions that every command takes: gimbalctl --help\n"_s.arg(
            QLatin1String(example()));
}

void Command::tellCondition(DeviceClient &client)
{
    connect(&client, &DeviceClient::unwatchedChanged, this, [this, &client] {
        if (const QString missing = unwatchedText(client.unwatched()); !missing.isEmpty())
            emit told(u"not watched: "_s + missing);
    });
    connect(new FaultTeller(client, this), &FaultTeller::told, this, &Command::told);
}

void BoardCommand::start(DeviceClient &client)
{
    m_client = &client;
    if (const BoardIdentity &board = client.identity(); !board.writable && !client.address().isReplay()) {
        const QString generation = board.extra.value(u"generation"_s).toString();
        emit told((generation.isEmpty()
                       ? u"this program does not know the firmware %1"_s.arg(board.firmware)
                       : u"generation %1 of the protocol is open for reading only"_s.arg(generation))
                  + u": what is read may mean something else, and nothing is written"_s);
    }
    connect(&client, &DeviceClient::steeringEnded, this, [this](bool confirmed) {
        if (confirmed)
            return;
        m_goesOn = true;
        emit told(flies()
                      ? u"the drone did not confirm that it is disarmed, and may go on with its last "
                        u"throttle: stop "
                        "it by \"gimbalctl motors off\"; "_s
                          + keepAwayText(true)
                      : u"the board did not confirm that it has stopped turning the camera, which may go on "
                        "moving: stop it by \"gimbalctl motors off\", or hold it and disconnect the power"_s);
    });
    if (moves()) {
        tellCondition(client);
        const ChannelRoles &roles = client.roles();
        QList<int> live = ChannelRoles::present({roles.angle, roles.target, roles.gyro});
        for (const int channel : awaits(*client.device())) {
            if (!live.contains(channel))
                live.append(channel);
        }
        if (client.device()->steering() && !client.address().isReplay())
            client.subscribe({live});
    }
    m_telemetry = client.telemetry();
    if (const QList<int> channels = awaits(*client.device()); !channels.isEmpty())
        awaitTelemetry(channels);
    else
        submit();
}

// The client arranges live data as soon as a board is found.
void BoardCommand::awaitTelemetry(const QList<int> &channels)
{
    const TimePoint begun = Clock::now();
    connect(&m_awaiting, &QTimer::timeout, this, [this, channels, begun] {
        const bool told = std::all_of(channels.begin(), channels.end(), [this, begun](int channel) {
            return m_telemetry->latestAt(channel) > begun;
        });
        if (!told && Clock::now() - begun < kTelemetryWait)
            return;
        m_awaiting.stop();
        submit();
    });
    m_awaiting.start(kTelemetryPeriod);
}

void BoardCommand::submit()
{
    m_client
        ->submit<CommandOutcome>([this](Channel &channel, Device &device) { return run(channel, device); },
                                 moves() ? DeviceClient::JobKind::Moving : DeviceClient::JobKind::Quiet)
        .then(this, [this](const Result<CommandOutcome> &outcome) {
            // A moving job posts its "stop" last; the link stays open until that has been sent.
            QTimer::singleShot(outcome ? 0 : 100, this, [this, outcome] {
                if (!outcome && goesOnAfter(outcome.error()))
                    return;
                onceStill([this, outcome] { isOpen(outcome) ? awaitBoard(outcome) : conclude(outcome); });
            });
        });
}

// The link stays open until the board was seen to stand still, or was not.
void BoardCommand::onceStill(const std::function<void()> &then)
{
    if (m_client->isSteering())
        connect(m_client, &DeviceClient::steeringEnded, this, then, Qt::SingleShotConnection);
    else
        then();
}

// The link broke in the middle of a write, or of something else that changes values. The client connects
// again by itself; what the board holds is read then.
void BoardCommand::awaitBoard(const Result<CommandOutcome> &outcome)
{
    m_interrupted = outcome;
    const ErrorCode why = (outcome ? *outcome->report->error : outcome.error()).code;
    if (why == ErrorCode::Restarted)
        emit told(u"the board restarted by itself; waiting until it is back, to read what it holds"_s);
    else if (outcome && why == ErrorCode::Cancelled)
        emit told(u"cancelled in the middle of the write; reading what the board holds"_s);
    else if (outcome)
        emit told(u"the link broke during the write; waiting for the board, to read what it holds"_s);
    else if (why == ErrorCode::LinkClosed)
        emit told(u"the link broke; waiting for the board, to read what it holds"_s);
    connect(m_client, &DeviceClient::stateChanged, this, &BoardCommand::readAgain);
    connect(&m_absence, &QTimer::timeout, this, [this] {
        if (m_interrupted)
            conclude(*m_interrupted);
    });
    m_absence.setSingleShot(true);
    m_absence.start(kAbsence);
    readAgain();
}

void BoardCommand::readAgain()
{
    if (!m_client->isConnected() || !m_interrupted)
        return;
    const BoardIdentity &before = beforeOf(*m_interrupted).identity();
    if (m_client->identity().serial != before.serial) {
        // One without a serial number is known by its look, which a name belongs to.
        const bool isSurely = before.isNumbered() || m_client->identity().isNumbered();
        emit told((isSurely ? u"another board answers now: %1; before it was %2"_s
                            : u"a board that looks otherwise answers now: %1; before it was %2. It has no "
                              "serial number: whether it is the same one is not known"_s)
                      .arg(boardText(m_client->identity()), boardText(before)));
        conclude(*m_interrupted);
        return;
    }
    const bool isInUse = !*m_interrupted && m_interrupted->error().after->isInUse;
    const QString endedBy = *m_interrupted ? QString() : m_interrupted->error().after->endedBy;
    const auto goesOn = std::make_shared<std::optional<Error>>();
    m_client
        ->submit<WholeMemory::Contents>(
            [isInUse, endedBy, goesOn](Channel &channel, Device &device) -> Result<WholeMemory::Contents> {
                if (const auto ended
                    = endedBy.isEmpty() ? Result<ActionReply>() : device.perform(channel, endedBy, {});
                    !ended) {
                    if (isLinkLoss(ended.error()))
                        return tl::unexpected(ended.error());
                    *goesOn = ended.error();
                }
                // What such a board answers says nothing about what is stored.
                if (WholeMemory *memory = device.wholeMemory(); memory && !isInUse)
                    return memory->readBoth(channel);
                return device.readConfiguration(channel).map([&](Configuration board) {
                    if (isInUse)
                        board = withInUse(channel, device, std::move(board));
                    return WholeMemory::Contents{board, board};
                });
            })
        .then(this, [this, endedBy, goesOn](const Result<WholeMemory::Contents> &board) {
            if (!m_interrupted)
                return;
            if (*goesOn)
                emit told(consoleText(**goesOn, flies()).oneLine());
            else if (board && !endedBy.isEmpty())
                emit told(u"the board was told to end it, and was seen to have ended it"_s);
            if (!board && !isUntold(board.error()))
                return;  // lost again: the next connection, or the limit
            if (board && *m_interrupted) {
                WriteReport report = *(*m_interrupted)->report;
                report.learn(board->stored);
                report.learnOthers(board->inUse);
                if (report.holdsAll() && (!report.use || report.use->now)) {
                    report.error.reset();
                    emit told(u"the write was cut off; the board was read again and holds all of it"_s);
                }
                (*m_interrupted)->report = std::make_shared<const WriteReport>(std::move(report));
            } else if (board) {
                m_interrupted = tl::unexpected(settled(m_interrupted->error(), board->stored));
            }
            conclude(*m_interrupted);
        });
}

void BoardCommand::conclude(Result<CommandOutcome> outcome)
{
    m_interrupted.reset();
    m_absence.stop();
    if (!outcome && outcome.error().after && !outcome.error().after->now
        && !outcome.error().after->endedBy.isEmpty())
        emit told(u"what was begun may go on on the board and move the camera: switch the motors off, or "
                  "disconnect the power"_s);
    if (outcome)
        tellReport(*outcome);
    if (outcome && m_goesOn)
        outcome->exitCode = Refused;
    emit finished(outcome);
}

void BoardCommand::stop()
{
    if (m_interrupted) {
        conclude(*m_interrupted);
        return;
    }
    if (m_awaiting.isActive()) {
        m_awaiting.stop();
        emit finished(failure(ErrorCode::Cancelled));
        return;
    }
    m_client->cancelJobs();
    const double deaf = seconds(m_client->deafUntil() - Clock::now());
    if (deaf <= 0)
        return;
    // What it carries out cannot be called back.
    m_client->motorsOff();
    emit told(u"the board hears nothing for %1 s more, also no stop: the stop is queued as the first thing "
              "that it hears then. To stop it at once, disconnect the battery"_s.arg(deaf, 0, 'f', 0));
}

CommandOption switchOption(const QString &name, const QString &help, bool &on)
{
    return {name, {}, help, [&on](const QString &) -> Result<void> {
                on = true;
                return {};
            }};
}

CommandOption textOption(const QString &name, const QString &value, const QString &help, QString &text)
{
    return {name, value, help, [&text](const QString &given) -> Result<void> {
                text = given;
                return {};
            }};
}

CommandOption profileOption(int &profile)
{
    return {u"profile"_s, u"N"_s, u"a profile from 1; without it, the active one"_s,
            [&profile](const QString &text) -> Result<void> {
                bool ok = false;
                profile = text.toInt(&ok);
                if (ok && profile >= 1)
                    return {};
                return failure(ErrorCode::InvalidArgument,
                               u"--profile needs a number from 1, not '%1'"_s.arg(text));
            }};
}

CommandOption channelsOption(QStringList &keys)
{
    return {u"channels"_s, u"a,b"_s, u"keys of channels"_s, [&keys](const QString &text) -> Result<void> {
                keys = text.split(u',', Qt::SkipEmptyParts);
                return {};
            }};
}

QString valueText(const ParameterSpec &spec, double raw)
{
    QString text = spec.format(raw);
    if (spec.row->kind == ValueKind::Choice) {
        for (const Choice &choice : spec.row->choices) {
            if (choice.value == raw)
                text += u" ("_s + QString::fromUtf8(choice.name) + u')';
        }
    }
    if (*spec.row->unit && !std::isnan(raw))
        text += u' ' + QString::fromUtf8(spec.row->unit);
    return text;
}

QJsonValue valueJson(const ParameterSpec &spec, double raw)
{
    return std::isnan(raw) ? QJsonValue() : QJsonValue(spec.format(raw));
}

QJsonObject changeJson(const ParameterChange &change)
{
    return {{u"key"_s, change.spec->key},
            {u"profile"_s, change.profile + 1},
            {u"from"_s, valueJson(*change.spec, change.from)},
            {u"to"_s, valueJson(*change.spec, change.to)},
            {u"red"_s, change.spec->row->risk == Risk::Red},
            {u"scope"_s, change.spec->row->scope == Scope::Board ? u"board"_s : u"profile"_s}};
}

QString changeText(const Configuration &configuration, const std::vector<ParameterChange> &changes)
{
    QString text;
    for (const ParameterChange &change : changes) {
        const QString where = change.spec->row->scope == Scope::Board
            ? u"all profiles"_s
            : configuration.profileName(change.profile);
        text += u"%1 %2 %3 -> %4%5\n"_s.arg(where.leftJustified(14), change.spec->key.leftJustified(28),
                                            valueText(*change.spec, change.from),
                                            valueText(*change.spec, change.to),
                                            change.spec->row->risk == Risk::Red ? u"   (risk)"_s : QString());
    }
    return text;
}

CommandOption partialOption(bool &on)
{
    return switchOption(u"partial"_s, u"parts of the board, or of a recording, may be missing"_s, on);
}

void reportMissing(CommandOutcome &outcome, const Configuration &configuration, const QString &where,
                   bool partial)
{
    const QStringList names = configuration.missingNames();
    if (names.isEmpty())
        return;
    if (!outcome.note.isEmpty())
        outcome.note += u'\n';
    // What a board has was asked for; a file may have been saved without it.
    const QString told = where == kTheBoard
        ? u"%2 could not be read from %1, so nothing is known about the values there"_s
        : u"%1 lacks %2, so nothing is known about the values there"_s;
    outcome.note += told.arg(where, missingText(configuration, configuration.missing()));
    addMissing(outcome, names, where);
    if (!partial)
        outcome.exitCode = Refused;
}

QString leftOutText(const QList<ReplayGap> &gaps)
{
    const auto time = [](double value, const QString &unknown) {
        return std::isnan(value) ? unknown : QString::number(value, 'f', 2) + u" s"_s;
    };
    QStringList lines;
    for (const ReplayGap &gap : gaps.first(std::min(gaps.size(), kGapsTold))) {
        lines.append(u"damaged from byte %1 on (%2): %3 bytes are left out, from %4 to %5"_s.arg(gap.offset)
                         .arg(causeText(gap.cause))
                         .arg(gap.bytes)
                         .arg(time(gap.from, u"the beginning"_s), time(gap.to, u"the end"_s)));
    }
    if (gaps.size() > kGapsTold)
        lines.append(u"and %1 more such places"_s.arg(gaps.size() - kGapsTold));
    lines.append(u"everything else that the file holds is here; --partial takes it as it is"_s);
    return lines.join(u'\n');
}

void reportLeftOut(CommandOutcome &outcome, const QList<ReplayGap> &gaps, bool partial)
{
    if (gaps.isEmpty())
        return;
    if (!outcome.note.isEmpty())
        outcome.note += u'\n';
    outcome.note += leftOutText(gaps);
    const auto time = [](double value) { return std::isnan(value) ? QJsonValue() : QJsonValue(value); };
    const bool isList = outcome.json.isArray();
    QJsonObject object = outcome.json.toObject();
    QJsonArray parts = isList ? outcome.json.toArray() : QJsonArray();
    for (const ReplayGap &gap : gaps) {
        const QJsonObject part{{u"at"_s, gap.offset},
                               {u"bytes"_s, gap.bytes},
                               {u"reason"_s, causeText(gap.cause)},
                               {u"from"_s, time(gap.from)},
                               {u"to"_s, time(gap.to)}};
        parts.append(isList ? QJsonObject{{u"leftOut"_s, part}} : part);
    }
    object.insert(u"leftOut"_s, parts);
    outcome.json = isList ? QJsonValue(parts) : QJsonValue(object);
    if (!partial)
        outcome.exitCode = Refused;
}

QString keepAwayText(std::optional<bool> flies)
{
    if (!flies)
        return u"hold the camera, or keep clear of a drone's propellers, and disconnect the power"_s;
    return *flies ? u"keep clear of the propellers, and take out the battery from a safe place"_s
                  : u"hold the camera and disconnect the power"_s;
}

ErrorText forConsole(ErrorText text, ErrorCode code, bool flies)
{
    if (flies && code == ErrorCode::NotProven)
        text.cure = u"Keep clear of the propellers, and take out the battery from a safe place."_s;
    if (flies && code == ErrorCode::GoesOn)
        text.meaning = u"Its motors may be turning."_s;
    if (code == ErrorCode::LinkClosed)
        text.cure = u"Check its cable or network, and its power, then run the command again."_s;
    return text;
}

ErrorText consoleText(const Error &error, bool flies)
{
    return forConsole(describe(error), error.code, flies);
}

QJsonObject errorJson(const Error &error, bool flies)
{
    const ErrorText text = consoleText(error, flies);
    QJsonObject json{{u"error"_s, text.what},
                     {u"meaning"_s, text.meaning},
                     {u"cure"_s, text.cure},
                     {u"detail"_s, text.detail}};
    if (!error.after)
        return json;
    json.insert(u"snapshot"_s, error.after->snapshotPath);
    if (!error.after->now)
        return json;
    QJsonArray changed;
    for (const ParameterChange &change : error.after->changes())
        changed.append(changeJson(change));
    for (const DataChange &change : error.after->dataChanges())
        changed.append(QJsonObject{{u"data"_s, QLatin1String(change.spec->data)}});
    json.insert(u"changed"_s, changed);
    if (const QStringList lost = error.after->lost(); !lost.isEmpty())
        json.insert(u"missing"_s, QJsonArray::fromStringList(lost));
    return json;
}

void reportError(CommandOutcome &outcome, const Error &error)
{
    if (!outcome.note.isEmpty())
        outcome.note += u'\n';
    outcome.note += u"gimbalctl: "_s + consoleText(error).oneLine();
    QJsonObject object = outcome.json.toObject();
    const QJsonObject words = errorJson(error);
    for (auto it = words.begin(); it != words.end(); ++it)
        object.insert(it.key(), it.value());
    outcome.json = object;
    outcome.exitCode = Refused;
}

Result<CommandOutcome> writeAndReport(Channel &channel, Device &device, const Configuration &base,
                                      const Configuration &edited, const WriteOptions &options)
{
    auto report = writeConfiguration(channel, device, base, edited, options);
    const bool isUntold = !report
        && (report.error().code == ErrorCode::ConditionUnmet || report.error().code == ErrorCode::Unready);
    if (isUntold && device.wholeMemory())
        addDetail(report.error().detail, u"--others store stores everything that is in use"_s);
    if (!report)
        return tl::unexpected(report.error());
    CommandOutcome outcome;
    if (report->lines.empty() && report->data.empty() && !report->namesWanted && report->isComplete())
        outcome.text = !base.missing().empty() ? u"nothing to write in what the board delivered\n"_s
            : answersWithUse(device)
            ? u"nothing to write: the board uses these values already; it does not tell whether those that "
              "can be set live are stored (\"set\" writes them all the same)\n"_s
            : u"nothing to write: the board holds these values already\n"_s;
    outcome.report = std::make_shared<const WriteReport>(std::move(*report));
    return outcome;
}

Result<CommandOutcome> writeAndTellMissing(Channel &channel, Device &device, const Configuration &base,
                                           const Configuration &edited, const WriteOptions &options)
{
    auto outcome = writeAndReport(channel, device, base, edited, options);
    if (outcome)
        reportMissing(*outcome, base, kTheBoard, true);
    return outcome;
}
