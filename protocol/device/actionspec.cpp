// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/device/actionspec.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

QString choiceNames(const ArgumentSpec &argument)
{
    QStringList names;
    for (const Choice &choice : argument.choices)
        names.append(QLatin1String(choice.name));
    return names.join(u", "_s);
}

Result<QVariant> parseArgument(const ArgumentSpec &argument, const QString &text)
{
    const QString key = QLatin1String(argument.key);
    bool ok = false;
    switch (argument.kind) {
    case ArgumentKind::Text:
        if (std::any_of(text.begin(), text.end(),
                        [](QChar letter) { return letter.category() == QChar::Other_Control; }))
            return failure(ErrorCode::InvalidArgument,
                           u"%1 has control characters, such as a line break"_s.arg(key));
        return QVariant(text);
    case ArgumentKind::Toggle:
        if (text == u"on"_s || text == u"true"_s || text == u"1"_s)
            return QVariant(true);
        if (text == u"off"_s || text == u"false"_s || text == u"0"_s)
            return QVariant(false);
        return failure(ErrorCode::InvalidArgument, u"%1=%2 is neither on nor off"_s.arg(key, text));
    case ArgumentKind::Choice: {
        for (const Choice &choice : argument.choices) {
            if (text.compare(QLatin1String(choice.name), Qt::CaseInsensitive) == 0)
                return QVariant(choice.value);
        }
        const int value = text.toInt(&ok, 0);
        for (const Choice &choice : argument.choices) {
            if (ok && choice.value == value)
                return QVariant(value);
        }
        return failure(ErrorCode::InvalidArgument,
                       u"%1=%2 is none of: %3"_s.arg(key, text, choiceNames(argument)));
    }
    case ArgumentKind::Integer:
    case ArgumentKind::Real: break;
    }
    const double value = argument.kind == ArgumentKind::Integer ? text.toInt(&ok, 0) : text.toDouble(&ok);
    if (!ok || !std::isfinite(value) || value < argument.min || value > argument.max) {
        return failure(
            ErrorCode::InvalidArgument,
            u"%1=%2 is not a %3 from %4 to %5"_s
                .arg(key, text, argument.kind == ArgumentKind::Integer ? u"whole number"_s : u"number"_s)
                .arg(argument.min)
                .arg(argument.max));
    }
    return argument.kind == ArgumentKind::Integer ? QVariant(static_cast<int>(value)) : QVariant(value);
}

}  // namespace

Result<void> checkClear(const ActionSpec &action, const QMap<QString, QString> &texts)
{
    for (const ArgumentSpec &argument : action.arguments) {
        const QString text = texts.value(QLatin1String(argument.key));
        bool isNumber = false;
        const int value = text.toInt(&isNumber);
        const bool isName
            = std::any_of(argument.choices.begin(), argument.choices.end(),
                          [&text](const Choice &choice) { return text == QLatin1String(choice.name); });
        for (const Choice &choice : argument.choices) {
            const QString name = QLatin1String(choice.name);
            if (isNumber && !isName && choice.value != value && name.endsWith(text)
                && !name.chopped(text.size()).back().isDigit())
                return failure(ErrorCode::InvalidArgument,
                               u"%1=%2 may mean %3 or the number of another; give the name: %4"_s.arg(
                                   QLatin1String(argument.key), text, name, choiceNames(argument)));
        }
    }
    return {};
}

QString replyUnit(const ActionSpec &action, const QString &key)
{
    const QString parts = u'.' + key + u'.';
    for (const ReplyUnit &unit : action.units) {
        if (parts.contains(u'.' + QLatin1String(unit.part) + u'.'))
            return QString::fromUtf8(unit.unit);
    }
    return {};
}

const ActionSpec *reloadingAction(std::span<const ActionSpec> actions)
{
    const auto found = std::ranges::find_if(actions, [](const ActionSpec &action) {
        return action.memory == MemoryEffect::Reloads && action.arguments.empty();
    });
    return found == actions.end() ? nullptr : &*found;
}

ActionSpec chosenAction(const ActionSpec &action, const QVariantMap &arguments)
{
    ActionSpec chosen = action;
    for (const EntryEffect &entry : action.entries) {
        const char *argument = *entry.argument ? entry.argument : action.arguments.front().key;
        if (arguments.value(QLatin1String(argument)).toInt() != entry.value
            || !arguments.contains(QLatin1String(argument)))
            continue;
        chosen.risk = entry.risk;
        chosen.memory = entry.memory;
        chosen.isShown = entry.isShown;
        chosen.letsGo |= entry.letsGo;
        chosen.switchesMotors |= entry.switchesMotors;
    }
    return chosen;
}

Result<QVariantMap> parseArguments(const ActionSpec &action, const QMap<QString, QString> &texts)
{
    QVariantMap values;
    for (const ArgumentSpec &argument : action.arguments) {
        const QString key = QLatin1String(argument.key);
        const auto given = texts.find(key);
        if (given == texts.end() && !*argument.defaultText)
            return failure(ErrorCode::InvalidArgument,
                           u"%1 needs %2=..."_s.arg(QLatin1String(action.key), key));
        // A real argument with the default "nan" may be left out.
        if (given == texts.end() && qstrcmp(argument.defaultText, "nan") == 0)
            continue;
        auto value = parseArgument(argument,
                                   given == texts.end() ? QString::fromLatin1(argument.defaultText) : *given);
        if (!value)
            return tl::unexpected(value.error());
        values.insert(key, *value);
    }
    for (auto it = texts.begin(); it != texts.end(); ++it) {
        const auto isKnown
            = [&it](const ArgumentSpec &argument) { return it.key() == QLatin1String(argument.key); };
        if (std::none_of(action.arguments.begin(), action.arguments.end(), isKnown)) {
            return failure(ErrorCode::InvalidArgument,
                           u"%1 has no argument '%2'"_s.arg(QLatin1String(action.key), it.key()));
        }
    }
    return values;
}
