// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"

#include "protocol/procedure/writeconfiguration.h"
#include "widgets/models/errortext.h"

using namespace Qt::StringLiterals;

namespace {

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

}  // namespace

QList<int> usualChannels(const Device &device)
{
    const ChannelRoles roles = device.roles();
    QList<int> channels;
    for (const auto &triple : {roles.angle, roles.target, roles.gyro})
        channels.append(QList<int>(triple.begin(), triple.end()));
    return channels;
}

std::vector<std::unique_ptr<Command>> allCommands()
{
    std::vector<std::unique_ptr<Command>> all;
    for (auto part : {parameterCommands, fileCommands, actionCommands, recordingCommands}) {
        for (auto &command : part())
            all.push_back(std::move(command));
    }
    return all;
}

QString valueText(const ParameterSpec &spec, int raw)
{
    QString text = spec.format(raw);
    if (spec.row->kind == ValueKind::Choice) {
        for (const Choice &choice : spec.row->choices) {
            if (choice.value == raw)
                text += u" ("_s + QString::fromUtf8(choice.name) + u')';
        }
    }
    if (*spec.row->unit)
        text += u' ' + QString::fromUtf8(spec.row->unit);
    return text;
}

QJsonObject changeJson(const ParameterChange &change)
{
    return {{u"key"_s, change.spec->key},
            {u"profile"_s, change.profile + 1},
            {u"from"_s, change.spec->format(change.from)},
            {u"to"_s, change.spec->format(change.to)},
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

Result<CommandOutcome> writeAndReport(Channel &channel, Device &device, const Configuration &base,
                                      const Configuration &edited, const CommandOptions &options)
{
    WriteOptions write;
    write.history = &options.history;
    const auto report = writeConfiguration(channel, device, base, edited, write);
    if (!report)
        return tl::unexpected(report.error());
    CommandOutcome outcome;
    QJsonArray lines;
    for (const WriteLine &line : report->lines) {
        QJsonObject object = changeJson({line.spec, line.profile, line.from, line.to});
        object.insert(u"state"_s, stateText(line.state));
        lines.append(object);
        outcome.text += u"%1 %2 %3 -> %4\n"_s.arg(
            stateText(line.state).leftJustified(12), line.spec->key.leftJustified(28),
            valueText(*line.spec, line.from), valueText(*line.spec, line.to));
    }
    QJsonArray data;
    for (const WriteData &block : report->data) {
        data.append(
            QJsonObject{{u"data"_s, QLatin1String(block.spec->data)}, {u"state"_s, stateText(block.state)}});
        outcome.text
            += u"%1 %2\n"_s.arg(stateText(block.state).leftJustified(12), QLatin1String(block.spec->data));
    }
    if (report->namesWritten)
        outcome.text += u"verified     profile names\n"_s;
    if (lines.isEmpty() && data.isEmpty() && !report->namesWritten && report->isComplete())
        outcome.text = u"nothing to write: the board holds these values already\n"_s;
    QJsonObject json{{u"complete"_s, report->isComplete()},
                     {u"written"_s, lines},
                     {u"data"_s, data},
                     {u"namesWritten"_s, report->namesWritten},
                     {u"snapshot"_s, report->snapshotPath}};
    if (report->error) {
        outcome.exitCode = Refused;
        outcome.note = describe(*report->error).oneLine();
        json.insert(u"error"_s, outcome.note);
    }
    if (!report->snapshotPath.isEmpty())
        outcome.note
            += (outcome.note.isEmpty() ? QString() : u"\n"_s) + u"snapshot: "_s + report->snapshotPath;
    outcome.json = json;
    return outcome;
}
