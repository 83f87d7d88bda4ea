// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/actioncommand.h"

#include "protocol/device/flight.h"
#include "protocol/procedure/motorsnow.h"
#include "protocol/procedure/safeaction.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

Result<QMap<QString, QString>> assignments(const QStringList &words)
{
    QMap<QString, QString> map;
    for (const QString &word : words) {
        if (word.indexOf(u'=') < 1)
            return failure(ErrorCode::InvalidArgument, u"'%1' is not ARG=VALUE"_s.arg(word));
        map.insert(word.section(u'=', 0, 0), word.section(u'=', 1));
    }
    return map;
}

}  // namespace

const ActionSpec *actionNamed(const Device &device, const QString &key)
{
    const auto actions = device.actions();
    const auto it = std::find_if(actions.begin(), actions.end(), [&key](const ActionSpec &action) {
        return key == QLatin1String(action.key);
    });
    return it == actions.end() ? nullptr : &*it;
}

CommandOutcome doneOutcome(const QString &key, const ActionReply &reply, bool answered,
                           const ActionSpec *action)
{
    const QString state = answered ? u"done"_s : u"sent"_s;
    CommandOutcome outcome;
    QJsonObject units;
    for (auto it = reply.begin(); it != reply.end(); ++it) {
        QStringList values;
        for (const QVariant &value :
             it->typeId() == QMetaType::QVariantList ? it->toList() : QVariantList{*it})
            values.append(value.typeId() == QMetaType::Double ? QString::number(value.toDouble(), 'g', 6)
                                                              : value.toString());
        const QString unit = action ? replyUnit(*action, it.key()) : QString();
        outcome.text += u"%1 %2%3\n"_s.arg(it.key().leftJustified(20), values.join(u' '),
                                           unit.isEmpty() ? QString() : u' ' + unit);
        if (!unit.isEmpty())
            units.insert(it.key(), unit);
    }
    outcome.json = QJsonObject{{u"action"_s, key},
                               {u"done"_s, answered},
                               {u"state"_s, state},
                               {u"reply"_s, QJsonObject::fromVariantMap(reply)},
                               {u"units"_s, units}};
    if (outcome.text.isEmpty() || !answered)
        outcome.text += state + u'\n';
    return outcome;
}

QString riskName(ActionRisk risk)
{
    constexpr std::array kNames{"safe", "moves", "writes", "destroys"};
    return QLatin1String(kNames[std::size_t(risk)]);
}

bool mayLetGo(const ActionSpec &action)
{
    return action.letsGo
        || std::any_of(action.entries.begin(), action.entries.end(),
                       [](const EntryEffect &entry) { return entry.letsGo; });
}

QList<CommandOption> ActionCommand::options()
{
    return {switchOption(u"confirmed"_s,
                         u"what the action asks to be confirmed each time is so (see \"do help\")"_s,
                         m_confirmed)};
}

QList<int> ActionCommand::awaits(const Device &device) const
{
    const ActionSpec *action = actionNamed(device, actionKey());
    QList<int> channels;
    for (const Condition condition : action ? action->needs : std::span<const Condition>()) {
        if (const int channel = channelOf(condition, rolesOf(device)); channel >= 0)
            channels.append(channel);
    }
    if (const int outputs = rolesOf(device).outputs; action && mayLetGo(*action) && outputs >= 0)
        channels.append(outputs);
    return channels;
}

Result<CommandOutcome> ActionCommand::run(Channel &channel, Device &device)
{
    const ActionSpec *action = actionNamed(device, actionKey());
    if (!action) {
        QStringList names;
        for (const ActionSpec &each : device.actions())
            names.append(QLatin1String(each.key));
        return failure(ErrorCode::InvalidArgument,
                       u"no action '%1'; there are: %2"_s.arg(actionKey(), names.join(u", "_s)));
    }
    const auto texts = assignments(given());
    if (!texts)
        return tl::unexpected(texts.error());
    if (const auto clear = checkClear(*action, *texts); !clear)
        return tl::unexpected(clear.error());
    const auto arguments = parseArguments(*action, *texts);
    if (!arguments)
        return tl::unexpected(arguments.error());
    if (const char *doubt = device.flight() ? device.flight()->doubt(actionKey(), *arguments) : ""; *doubt)
        emit told(QString::fromUtf8(doubt));
    if (*action->confirm && !m_confirmed) {
        return failure(ErrorCode::InvalidArgument,
                       u"%1 has to be confirmed with --confirmed each time: \"%2\""_s.arg(
                           actionKey(), QString::fromUtf8(action->confirm)));
    }
    if (chosenAction(*action, *arguments).risk == ActionRisk::Destroys && !m_confirmed) {
        return failure(ErrorCode::InvalidArgument,
                       u"%1 replaces values on the board: confirm it with --confirmed"_s.arg(actionKey()));
    }
    if (chosenAction(*action, *arguments).letsGo && !m_confirmed) {
        const std::optional<bool> run = motorsRun(device, latest(), channel.now());
        if (run.value_or(true))
            return failure(
                ErrorCode::InvalidArgument,
                u"%1 makes the motors let go, and what they hold falls; %2: hold it and confirm "
                "with --confirmed"_s.arg(actionKey(),
                                         run ? u"they are running"_s : u"nothing tells whether they run"_s));
    }
    const auto done = performSafely(channel, device, actionKey(), *arguments, history(), {}, latest());
    if (!done)
        return tl::unexpected(done.error());
    CommandOutcome outcome
        = doneOutcome(actionKey(), done->reply, done->answered && !done->isStoreUntold, action);
    QJsonObject json = outcome.json.toObject();
    if (!done->snapshotPath.isEmpty()) {
        json.insert(u"snapshot"_s, done->snapshotPath);
        outcome.note = u"snapshot: "_s + done->snapshotPath;
    }
    if (done->isStoreUntold || done->reply.value(u"stored"_s) == u"confirmed"_s) {
        json.insert(u"storeUntold"_s, true);
        outcome.note += (outcome.note.isEmpty() ? u""_s : u"\n"_s)
            + u"the board confirms that it has stored; as it answers with what is in use, only its next "
              "start shows it"_s;
    }
    if (done->stored) {
        if (const QString told = tellOthers(*done->stored, outcome.text, json); !told.isEmpty())
            outcome.note += u'\n' + told;
    }
    QJsonArray lost;
    for (const ParameterChange &change : done->lost) {
        lost.append(changeJson(change));
        outcome.text += u"%1 %2 (%3 was in use, and not stored)\n"_s.arg(
            change.spec->key.leftJustified(28), valueText(*change.spec, change.to),
            valueText(*change.spec, change.from));
    }
    if (!lost.isEmpty())
        json.insert(u"lost"_s, lost);
    if (done->motorsNow) {
        json.insert(u"motorsNow"_s, *done->motorsNow);
        outcome.note += (outcome.note.isEmpty() ? u""_s : u"\n"_s) + motorsChangedText(*done->motorsNow);
        outcome.exitCode = Refused;
    }
    outcome.json = json;
    return outcome;
}
