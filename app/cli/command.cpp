// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"

#include "widgets/models/errortext.h"
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

QString stateText(WriteState state)
{
    switch (state) {
    case WriteState::Verified: return u"verified"_s;
    case WriteState::Unknown: return u"unknown"_s;
    case WriteState::NotWritten: return u"not written"_s;
    case WriteState::Mismatch: return u"mismatch"_s;
    case WriteState::RolledBack: return u"rolled back"_s;
    }
    return {};
}

// Something that was sent is unknown because the link broke.
bool isOpen(const CommandOutcome &outcome)
{
    return outcome.report && outcome.report->error && outcome.report->error->code == ErrorCode::LinkClosed
        && outcome.report->count(WriteState::Unknown) > 0;
}

// The report comes before what the command has to say beside it.
void tellReport(CommandOutcome &outcome)
{
    if (!outcome.report)
        return;
    const WriteReport &report = *outcome.report;
    QString text;
    QJsonArray lines;
    for (const WriteLine &line : report.lines) {
        QJsonObject object = changeJson({line.spec, line.profile, line.from, line.to});
        object.insert(u"state"_s, stateText(line.state));
        if (line.state != WriteState::Unknown)
            object.insert(u"onBoard"_s, valueJson(*line.spec, line.found));
        lines.append(object);
        text += u"%1 %2 %3 -> %4"_s.arg(stateText(line.state).leftJustified(12),
                                        line.spec->key.leftJustified(28), valueText(*line.spec, line.from),
                                        valueText(*line.spec, line.to));
        if (line.state == WriteState::Mismatch)
            text += u" (the board holds %1)"_s.arg(valueText(*line.spec, line.found));
        text += u'\n';
    }
    QJsonArray data;
    for (const WriteData &block : report.data) {
        data.append(
            QJsonObject{{u"data"_s, QLatin1String(block.spec->data)}, {u"state"_s, stateText(block.state)}});
        text += u"%1 %2\n"_s.arg(stateText(block.state).leftJustified(12), QLatin1String(block.spec->data));
    }
    if (report.namesWritten)
        text += u"verified     profile names\n"_s;
    QJsonObject json = outcome.json.toObject();
    json.insert(u"complete"_s, report.isComplete());
    json.insert(u"written"_s, lines);
    json.insert(u"data"_s, data);
    json.insert(u"namesWritten"_s, report.namesWritten);
    json.insert(u"snapshot"_s, report.snapshotPath);
    const QString others = tellOthers(report, text, json);
    QStringList notes;
    if (report.error) {
        outcome.exitCode = Refused;
        notes.append(describe(report).oneLine());
        json.insert(u"error"_s, notes.first());
    }
    if (!report.snapshotPath.isEmpty())
        notes.append(u"snapshot: "_s + report.snapshotPath);
    if (!others.isEmpty())
        notes.append(others);
    if (!outcome.note.isEmpty())
        notes.append(outcome.note.trimmed());
    outcome.text = text + outcome.text;
    outcome.note = notes.join(u'\n');
    outcome.json = json;
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
    for (auto part : {parameterCommands, fileCommands, actionCommands, recordingCommands, linkCommands}) {
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

void BoardCommand::start(DeviceClient &client)
{
    m_client = &client;
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
                if (!outcome)
                    emit finished(outcome);
                else if (isOpen(*outcome))
                    awaitBoard(*outcome);
                else
                    conclude(*outcome);
            });
        });
}

// The link broke in the middle of a write. The client connects again by itself; what the board holds is read
// then.
void BoardCommand::awaitBoard(const CommandOutcome &outcome)
{
    m_interrupted = outcome;
    emit told(u"the link broke during the write; waiting for the board, to read what it holds"_s);
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
    if (!m_client->isConnected() || !m_interrupted
        || m_client->identity().serial != m_interrupted->report->before.identity().serial)
        return;
    m_client
        ->submit<Configuration>(
            [](Channel &channel, Device &device) { return device.readConfiguration(channel); })
        .then(this, [this](const Result<Configuration> &board) {
            if (!board || !m_interrupted)
                return;  // lost again: the next connection, or the limit
            WriteReport report = *m_interrupted->report;
            report.learn(*board);
            m_interrupted->report = std::make_shared<const WriteReport>(std::move(report));
            conclude(*m_interrupted);
        });
}

void BoardCommand::conclude(CommandOutcome outcome)
{
    m_interrupted.reset();
    m_absence.stop();
    tellReport(outcome);
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

QString dataText(const std::vector<DataChange> &changes)
{
    QString text;
    for (const DataChange &change : changes)
        text += u"%1 %2 differ\n"_s.arg(QString(), -14).arg(QLatin1String(change.spec->data));
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
    outcome.note += u"%1 lacks %2, so nothing is known about the values there"_s.arg(
        where, missingText(configuration, configuration.missing()));
    const bool isList = outcome.json.isArray();
    QJsonObject object = outcome.json.toObject();
    QJsonArray parts = isList ? outcome.json.toArray() : object.value(u"missing"_s).toArray();
    for (const QString &name : names)
        parts.append(QJsonObject{{u"missing"_s, name}, {u"where"_s, where}});
    object.insert(u"missing"_s, parts);
    outcome.json = isList ? QJsonValue(parts) : QJsonValue(object);
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
                         .arg(gap.reason)
                         .arg(gap.bytes)
                         .arg(time(gap.from, u"the beginning"_s), time(gap.to, u"the end"_s)));
    }
    if (gaps.size() > kGapsTold)
        lines.append(u"and %1 more such places"_s.arg(gaps.size() - kGapsTold));
    lines.append(u"everything else is here; --partial takes it as it is"_s);
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
                               {u"reason"_s, gap.reason},
                               {u"from"_s, time(gap.from)},
                               {u"to"_s, time(gap.to)}};
        parts.append(isList ? QJsonObject{{u"leftOut"_s, part}} : part);
    }
    object.insert(u"leftOut"_s, parts);
    outcome.json = isList ? QJsonValue(parts) : QJsonValue(object);
    if (!partial)
        outcome.exitCode = Refused;
}

QJsonObject errorJson(const Error &error)
{
    const ErrorText text = describe(error);
    return {{u"error"_s, text.what},
            {u"meaning"_s, text.meaning},
            {u"cure"_s, text.cure},
            {u"detail"_s, text.detail}};
}

void reportError(CommandOutcome &outcome, const Error &error)
{
    if (!outcome.note.isEmpty())
        outcome.note += u'\n';
    outcome.note += u"gimbalctl: "_s + describe(error).oneLine();
    QJsonObject object = outcome.json.toObject();
    const QJsonObject words = errorJson(error);
    for (auto it = words.begin(); it != words.end(); ++it)
        object.insert(it.key(), it.value());
    outcome.json = object;
    outcome.exitCode = Refused;
}

Result<CommandOutcome> writeAndReport(Channel &channel, Device &device, const Configuration &base,
                                      const Configuration &edited, WriteOptions options)
{
    auto report = writeConfiguration(channel, device, base, edited, options);
    if (!report && report.error().code == ErrorCode::ConditionUnmet && device.wholeMemory())
        report.error().detail += u"; --others store stores everything that is in use"_s;
    if (!report)
        return tl::unexpected(report.error());
    CommandOutcome outcome;
    if (report->lines.empty() && report->data.empty() && !report->namesWritten && report->isComplete())
        outcome.text = base.missing().empty() ? u"nothing to write: the board holds these values already\n"_s
                                              : u"nothing to write in what the board delivered\n"_s;
    outcome.report = std::make_shared<const WriteReport>(std::move(*report));
    return outcome;
}
