// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "protocol/base/linkloss.h"
#include "protocol/configuration/aftermath.h"
#include "protocol/configuration/rounding.h"
#include "protocol/device/firmwareadvice.h"
#include "protocol/procedure/inuse.h"
#include "protocol/procedure/motorsnow.h"
#include "widgets/models/parametermodel.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <tuple>

using namespace Qt::StringLiterals;

namespace {

/// What may be given for a parameter: "0 to 255", "on or off", "one of 0 (Off), 1 (Roll port)".
QString expectedText(const ParameterSpec &spec, int firmware)
{
    switch (spec.row->kind) {
    case ValueKind::Number: return parameterRangeText(spec);
    case ValueKind::Toggle: return u"on or off"_s;
    case ValueKind::Flags: return u"a number, each bit of which is a flag"_s;
    case ValueKind::Choice: break;
    }
    QStringList choices;
    for (const Choice &choice : spec.choices(firmware))
        choices.append(valueText(spec, choice.value));
    return u"one of "_s + choices.join(u", "_s);
}

/// @param number from 1; 0 = the active one
Result<int> chosenProfile(int number, const Configuration &configuration)
{
    if (number == 0)
        return configuration.activeProfile();
    if (number > configuration.identity().profileCount) {
        return failure(
            ErrorCode::InvalidArgument,
            u"profile %1; the board has %2"_s.arg(number).arg(configuration.identity().profileCount));
    }
    return number - 1;
}

// What a text of the board has instead of the value in use. Empty: the same, or it is not told.
QString storedOtherwise(const Configuration &configuration, const ParameterSpec &spec, double raw)
{
    const auto first = configuration.startsWith(spec);
    const auto figure = first && *first != raw ? configuration.textFigure(spec, *first) : std::nullopt;
    return figure ? u"the text has %1"_s.arg(plainNumber(*figure)) : QString();
}

// "inText": the number that stands for it in a text of the board; "stored": whether the text has it.
void addFigure(QJsonObject &json, const Configuration &configuration, const ParameterSpec &spec, double raw)
{
    if (const auto figure = configuration.textFigure(spec, raw))
        json.insert(u"inText"_s, *figure);
    if (const auto first = configuration.startsWith(spec))
        json.insert(u"stored"_s, *first == raw);
}

QJsonObject parameterJson(const ParameterSpec &spec, int profile, double raw)
{
    QJsonObject json{{u"key"_s, spec.key},
                     {u"value"_s, valueJson(spec, raw)},
                     {u"raw"_s, std::isnan(raw) ? QJsonValue() : QJsonValue(raw)},
                     {u"unit"_s, QString::fromUtf8(spec.row->unit)},
                     {u"profile"_s, profile + 1},
                     {u"label"_s, QString::fromUtf8(spec.row->label)}};
    if (spec.row->kind == ValueKind::Number) {
        json.insert(u"min"_s, spec.toDisplay(spec.row->min));
        json.insert(u"max"_s, spec.toDisplay(spec.row->max));
    }
    return json;
}

// "3 actions (signals, statistics, profile_set)".
QString gainedText(const QString &what, const QStringList &keys, bool areNamed)
{
    const QString noun = keys.size() == 1 && what.endsWith(u's') ? what.chopped(1) : what;
    const QString count = u"%1 %2"_s.arg(keys.size()).arg(noun);
    return areNamed ? u"%1 (%2)"_s.arg(count, keys.join(u", "_s)) : count;
}

// What is known of the firmware, and what newer ones would change in this program.
void tellFirmware(const FirmwareAdvice &advice, QString &text, QJsonObject &json)
{
    QJsonArray remarks;
    for (const FirmwareRemark &remark : advice.firmwareRemarks()) {
        remarks.append(
            QJsonObject{{u"text"_s, QString::fromUtf8(remark.text)}, {u"caution"_s, remark.isCaution}});
        text += u"%1 %2\n"_s.arg((remark.isCaution ? u"caution"_s : u"remark"_s).leftJustified(12),
                                 QString::fromUtf8(remark.text));
    }
    QJsonArray steps;
    for (const FirmwareStep &step : advice.firmwareSteps()) {
        const std::array<std::tuple<QString, QStringList, bool>, 8> kinds{{
            {u"actions"_s, step.actions, true},
            {u"parameters"_s, step.parameters, false},
            {u"variables"_s, step.variables, false},
            {u"modes"_s, step.modes, true},
            {u"streams"_s, step.streams, true},
            {u"channels"_s, step.channels, false},
            {u"commands"_s, step.commands, false},
            {u"gone"_s, step.gone, false},
        }};
        QJsonObject object{{u"firmware"_s, step.firmware}, {u"about"_s, step.isAbout}};
        QStringList parts;
        for (const auto &[what, keys, areNamed] : kinds) {
            object.insert(what, QJsonArray::fromStringList(keys));
            if (!keys.isEmpty())
                parts.append(gainedText(what, keys, areNamed));
        }
        steps.append(object);
        text += u"%1 %2%3: %4\n"_s.arg(u"would bring"_s.leftJustified(12),
                                       step.isAbout ? u"about "_s : QString(), step.firmware,
                                       parts.join(u", "_s));
    }
    json.insert(u"firmwareRemarks"_s, remarks);
    json.insert(u"firmwareSteps"_s, steps);
}

class InfoCommand final : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    const char *name() const override { return "info"; }
    QString help() const override { return u"who is connected"_s; }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 info"; }
    Result<CommandOutcome> run(Channel &, Device &device) override
    {
        const BoardIdentity &identity = device.identity();
        QStringList capabilities(identity.capabilities.begin(), identity.capabilities.end());
        capabilities.sort();
        const bool isNumbered = identity.isNumbered();
        CommandOutcome outcome;
        QJsonObject known{{u"family"_s, identity.family},
                          {u"model"_s, identity.model},
                          {u"firmware"_s, identity.firmware},
                          {u"serial"_s, identity.serial},
                          {u"numbered"_s, isNumbered},
                          {u"profiles"_s, identity.profileCount},
                          {u"usb"_s, identity.usb},
                          {u"writable"_s, identity.writable},
                          {u"capabilities"_s, QJsonArray::fromStringList(capabilities)},
                          {u"extra"_s, QJsonObject::fromVariantMap(identity.extra)}};
        // What the operator calls it, where it has no number of its own.
        const QString called = history().nameOf(identity.serial);
        if (!called.isEmpty())
            known.insert(u"called"_s, called);
        // Its own name, where the family has one.
        const QString own = identity.extra.value(u"name"_s).toString();
        // Of its protocol.
        const QString generation = identity.extra.value(u"generation"_s).toString();
        outcome.text = (own.isEmpty() ? QString() : u"name         %1\n"_s.arg(own))
            + (called.isEmpty() ? QString() : u"called       %1\n"_s.arg(called))
            + u"board        %1\nfirmware     %2%3\n"_s.arg(identity.model, identity.firmware,
                                                            identity.writable ? QString() : u" (read-only)"_s)
            + (generation.isEmpty() ? QString() : u"generation   %1\n"_s.arg(generation))
            + u"serial       %1\nprofiles     %2\nport         %3\ncan          %4\n"_s
                  .arg(isNumbered ? identity.serial : u"none"_s)
                  .arg(identity.profileCount)
                  .arg(identity.usb ? u"USB"_s : identity.extra.value(u"port"_s, u"UART"_s).toString(),
                       capabilities.join(u", "_s));
        if (const FirmwareAdvice *advice = device.firmwareAdvice())
            tellFirmware(*advice, outcome.text, known);
        outcome.json = known;
        return outcome;
    }
};

// Errors: Incomplete with the part that did not come.
Result<void> checkKnown(const Configuration &configuration, const ParameterSpec &spec, int profile)
{
    const MissingPart *part = configuration.findMissing(spec, profile);
    if (!part)
        return {};
    return failure(ErrorCode::Incomplete,
                   u"%1, in which %2 is"_s.arg(configuration.partName(part->key), spec.key));
}

class ListCommand final : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    const char *name() const override { return "list"; }
    const char *words() const override { return "[PATTERN]"; }
    QString help() const override { return u"parameters with unit, range and value"_s; }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 list 'pid.*'"; }
    QList<CommandOption> options() override { return {profileOption(m_profile), partialOption(m_partial)}; }
    QString check() const override
    {
        return arguments().size() > 1 ? u"list takes one pattern at most"_s : QString();
    }
    Result<CommandOutcome> run(Channel &channel, Device &device) override
    {
        const auto configuration = device.readConfiguration(channel);
        if (!configuration)
            return tl::unexpected(configuration.error());
        const auto profile = chosenProfile(m_profile, *configuration);
        if (!profile)
            return tl::unexpected(profile.error());
        const QString pattern = arguments().value(0, u"*"_s);
        const QRegularExpression matcher(QRegularExpression::wildcardToRegularExpression(
            pattern.contains(u'*') || pattern.contains(u'?') ? pattern : u'*' + pattern + u'*'));
        CommandOutcome outcome;
        QJsonArray array;
        for (const ParameterSpec &spec : configuration->parameters().all()) {
            const auto raw = configuration->raw(spec, *profile);
            if (!raw || !matcher.match(spec.key).hasMatch())
                continue;
            QJsonObject json = parameterJson(spec, *profile, *raw);
            addFigure(json, *configuration, spec, *raw);
            array.append(json);
            QString range
                = spec.row->kind == ValueKind::Number ? spec.minText() + u".."_s + spec.maxText() : QString();
            if (const auto figure = configuration->textFigure(spec, *raw))
                range += u"  %1 in the text's numbers"_s.arg(plainNumber(*figure));
            if (const QString other = storedOtherwise(*configuration, spec, *raw); !other.isEmpty())
                range += u", not stored: "_s + other;
            outcome.text += u"%1 %2 %3\n"_s.arg(spec.key.leftJustified(32),
                                                valueText(spec, *raw).leftJustified(24), range);
        }
        outcome.json = array;
        if (array.isEmpty()) {
            outcome.note = u"no parameter matches '%1'"_s.arg(pattern);
            outcome.exitCode = Refused;
        }
        reportMissing(outcome, *configuration, kTheBoard, m_partial);
        return outcome;
    }

private:
    int m_profile = 0;
    bool m_partial = false;
};

class GetCommand final : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    const char *name() const override { return "get"; }
    const char *words() const override { return "KEY..."; }
    QString help() const override { return u"values of parameters"_s; }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 get pid.roll.p pid.roll.i"; }
    QList<CommandOption> options() override { return {profileOption(m_profile)}; }
    QString check() const override
    {
        return arguments().isEmpty() ? u"get needs at least one key"_s : QString();
    }
    Result<CommandOutcome> run(Channel &channel, Device &device) override
    {
        const auto configuration = device.readConfiguration(channel);
        if (!configuration)
            return tl::unexpected(configuration.error());
        const auto profile = chosenProfile(m_profile, *configuration);
        if (!profile)
            return tl::unexpected(profile.error());
        CommandOutcome outcome;
        QStringList notes;  // for people: the value alone is for scripts
        QJsonArray array;
        for (const QString &key : arguments()) {
            const ParameterSpec *spec = configuration->parameters().find(key);
            const auto raw = spec ? configuration->raw(*spec, *profile) : std::nullopt;
            if (const auto known = spec ? checkKnown(*configuration, *spec, *profile) : Result<void>();
                !known)
                return tl::unexpected(known.error());
            if (!raw)
                return failure(ErrorCode::InvalidArgument, u"there is no parameter '%1'"_s.arg(key));
            QJsonObject json = parameterJson(*spec, *profile, *raw);
            addFigure(json, *configuration, *spec, *raw);
            array.append(json);
            if (const auto figure = configuration->textFigure(*spec, *raw)) {
                const QString other = storedOtherwise(*configuration, *spec, *raw);
                notes.append(
                    other.isEmpty() && configuration->startsWith(*spec)
                        ? u"%1 stands as %2 in the configuration text, where it is stored"_s.arg(
                            key, plainNumber(*figure))
                        : u"%1 would stand as %2 in the configuration text"_s.arg(key, plainNumber(*figure)));
                if (!other.isEmpty())
                    notes.append(u"it is in use and not stored: "_s + other);
            }
            outcome.text += arguments().size() == 1 ? spec->format(*raw) + u'\n'
                                                    : key + u'=' + spec->format(*raw) + u'\n';
        }
        outcome.json = array;
        outcome.note = notes.join(u'\n');
        return outcome;
    }

private:
    int m_profile = 0;
};

// Perhaps some of the values are in use all the same: whatever was confirmed, the board is asked.
Error afterLive(Channel &channel, Device &device, Error error, const Configuration &before)
{
    if (error.code == ErrorCode::InvalidArgument || error.code == ErrorCode::OutOfRange)
        return error;
    error.after = std::make_shared<const Aftermath>(Aftermath{{}, before, true});
    if (isLinkLoss(error) || error.code == ErrorCode::Cancelled)
        return error;  // read when the board is back
    auto now = device.readConfiguration(channel);
    return now ? settled(std::move(error), withInUse(channel, device, *std::move(now))) : error;
}

// What was asked for and is there already: no line of the report, and not left out either.
void tellUnchanged(CommandOutcome &outcome, const Configuration &base, int profile,
                   const QStringList &assignments)
{
    QJsonArray array;
    for (const QString &assignment : assignments) {
        const ParameterSpec *spec = base.parameters().find(assignment.section(u'=', 0, 0));
        const auto &lines = outcome.report->lines;
        if (std::any_of(lines.begin(), lines.end(),
                        [spec](const WriteLine &line) { return line.spec == spec; }))
            continue;
        const double raw = base.raw(*spec, profile).value_or(std::nan(""));
        array.append(parameterJson(*spec, profile, raw));
        outcome.text += u"%1 %2 %3 (the board held it already)\n"_s.arg(
            u"unchanged"_s.leftJustified(12), spec->key.leftJustified(28), valueText(*spec, raw));
    }
    if (array.isEmpty())
        return;
    QJsonObject json = outcome.json.toObject();
    json.insert(u"unchanged"_s, array);
    outcome.json = json;
}

class SetCommand final : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    const char *name() const override { return "set"; }
    const char *words() const override { return "KEY=VALUE..."; }
    QString help() const override
    {
        return u"change parameters; --no-save changes them in volatile memory only"_s;
    }
    const char *example() const override
    {
        return "--link serial:/dev/ttyUSB0 set pid.roll.p=44 motor.yaw.power=150";
    }
    QList<CommandOption> options() override
    {
        return {profileOption(m_profile),
                switchOption(u"no-save"_s, u"change values in volatile memory only"_s, m_noSave),
                othersOption(m_others), leapOption(m_areLeapsConfirmed)};
    }
    QString check() const override
    {
        if (arguments().isEmpty())
            return u"set needs KEY=VALUE"_s;
        for (const QString &assignment : arguments()) {
            if (assignment.indexOf(u'=') < 1)
                return u"'%1' is not KEY=VALUE"_s.arg(assignment);
        }
        return {};
    }
    Result<CommandOutcome> run(Channel &channel, Device &device) override
    {
        WriteOptions options;
        if (const auto checked = checkOthers(device, m_others); !checked)
            return tl::unexpected(checked.error());
        const auto base
            = m_noSave ? device.readConfiguration(channel) : readBase(channel, device, m_others, options);
        if (!base)
            return tl::unexpected(base.error());
        const auto profile = chosenProfile(m_profile, *base);
        if (!profile)
            return tl::unexpected(profile.error());
        Configuration edited = *base;
        std::vector<AdjustableValue> live;
        std::vector<const ParameterSpec *> changed;
        QStringList rounded;
        for (const QString &assignment : arguments()) {
            const QString key = assignment.section(u'=', 0, 0);
            const ParameterSpec *spec = base->parameters().find(key);
            if (!spec)
                return failure(ErrorCode::InvalidArgument, u"there is no parameter '%1'"_s.arg(key));
            const auto raw = spec->parse(assignment.section(u'=', 1));
            if (!raw) {
                return failure(ErrorCode::InvalidArgument,
                               u"'%1' is not a value for %2, which takes %3"_s.arg(
                                   assignment.section(u'=', 1), key,
                                   expectedText(*spec, base->parameters().firmware())));
            }
            if (const auto known = checkKnown(*base, *spec, *profile); !known)
                return tl::unexpected(known.error());
            if (const auto set = edited.setRaw(*spec, *profile, *raw); !set)
                return tl::unexpected(set.error());
            if (const QString told = roundingText(*spec, assignment.section(u'=', 1).toDouble(), *raw);
                !told.isEmpty())
                rounded.append(told);
            const int variable = device.live() ? device.live()->variableOf(*spec) : -1;
            if (m_noSave && variable < 0) {
                return failure(ErrorCode::Unsupported,
                               u"%1 cannot be changed in volatile memory; leave --no-save out"_s.arg(key));
            }
            options.named.insert(key);
            changed.push_back(spec);
            live.push_back({variable, *raw * spec->row->adjustableScale});
        }
        if (const auto checked = checkLeaps(*base, edited, m_areLeapsConfirmed); !checked)
            return tl::unexpected(checked.error());
        if (!m_noSave) {
            options.history = &history();
            options.evenIfInUse = true;
            const QString replaced = base->changesTo(edited).empty()
                ? QString()
                : replacedText(channel, device, *base, options.named);
            if (!replaced.isEmpty())
                emit told(replaced);
            auto outcome = writeAndTellMissing(channel, device, *base, edited, options);
            if (outcome) {
                tellUnchanged(*outcome, *base, *profile, arguments());
                reportRounded(*outcome, rounded);
            }
            return outcome;
        }

        if (!device.identity().writable)
            return failure(ErrorCode::ReadOnly, device.identity().firmware);
        if (*profile != base->activeProfile())
            return failure(ErrorCode::InvalidArgument, u"--no-save works on the active profile only"_s);
        const auto ranBefore = askMotorsBefore(channel, device, changed);
        const Configuration usedBefore = withInUse(channel, device, *base);
        if (const auto done = device.live()->writeAdjustables(channel, live); !done) {
            Error error = afterLive(channel, device, done.error(), usedBefore);
            if (const auto run
                = isLinkLoss(error) ? std::nullopt : findMotorsChanged(channel, device, ranBefore))
                addDetail(error.detail, motorsChangedText(*run));
            return tl::unexpected(error);
        }
        CommandOutcome outcome;
        outcome.json = QJsonObject{{u"volatile"_s, true}, {u"count"_s, qint64(live.size())}};
        outcome.text = u"changed until the next restart: %1\n"_s.arg(arguments().join(u", "_s));
        // Such a board does not tell what is in use apart from what is stored.
        if (!device.wholeMemory())
            outcome.note = u"whatever writes to this profile before that stores them too, or puts the stored "
                           u"ones into "
                           "use"_s;
        // A board that has started anew takes them as well.
        if (const auto run = findMotorsChanged(channel, device, ranBefore)) {
            outcome.note += (outcome.note.isEmpty() ? u""_s : u"\n"_s) + motorsChangedText(*run);
            outcome.exitCode = Refused;
        }
        reportRounded(outcome, rounded);
        return outcome;
    }

private:
    int m_profile = 0;
    bool m_noSave = false;
    bool m_areLeapsConfirmed = false;
    std::optional<OtherValues> m_others;
};

class ProfilesCommand final : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    const char *name() const override { return "profiles"; }
    QString help() const override { return u"names of the profiles; * marks the active one"_s; }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 profiles"; }
    Result<CommandOutcome> run(Channel &channel, Device &device) override
    {
        ProfileAccess *profiles = device.profiles();
        const auto names
            = profiles ? profiles->readProfileNames(channel) : Result<QStringList>(QStringList{QString()});
        if (!names)
            return tl::unexpected(names.error());
        const auto active = profiles ? profiles->activeProfile(channel) : Result<int>(0);
        if (!active)
            return tl::unexpected(active.error());
        CommandOutcome outcome;
        QJsonArray array;
        for (int i = 0; i < names->size(); ++i) {
            array.append(
                QJsonObject{{u"number"_s, i + 1}, {u"name"_s, (*names)[i]}, {u"active"_s, i == *active}});
            outcome.text += u"%1 %2  %3\n"_s.arg(i == *active ? u"*"_s : u" "_s).arg(i + 1).arg((*names)[i]);
        }
        outcome.json = array;
        return outcome;
    }
};

class RenameCommand final : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    const char *name() const override { return "rename"; }
    const char *words() const override { return "N NAME"; }
    QString help() const override { return u"give a profile a name"_s; }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 rename 2 Studio"; }
    QString check() const override
    {
        bool ok = false;
        const int number = arguments().value(0).toInt(&ok);
        if (arguments().size() != 2 || !ok || number < 1)
            return u"rename needs the number of a profile and its name"_s;
        const QString name = arguments().value(1);
        if (std::any_of(name.begin(), name.end(),
                        [](QChar letter) { return letter.category() == QChar::Other_Control; }))
            return u"a name has no control characters such as line breaks"_s;
        return {};
    }
    bool takesEmptyWords() const override { return true; }
    Result<CommandOutcome> run(Channel &channel, Device &device) override
    {
        const int number = arguments().value(0).toInt();
        const QString wanted = arguments().value(1);
        if (number > device.identity().profileCount)
            return failure(ErrorCode::InvalidArgument,
                           u"there is no profile %1; the board has %2"_s.arg(number).arg(
                               device.identity().profileCount));
        if (!device.profiles())
            return failure(ErrorCode::Unsupported, u"this board has one profile, without a name"_s);
        if (wanted.toUtf8().size() > device.profiles()->profileNameBytes()) {
            return failure(
                ErrorCode::InvalidArgument,
                u"a name has at most %1 bytes, this one has %2"_s.arg(device.profiles()->profileNameBytes())
                    .arg(wanted.toUtf8().size()));
        }
        const auto base = device.readConfiguration(channel);
        if (!base)
            return tl::unexpected(base.error());
        Configuration edited = *base;
        QStringList names = edited.profileNames();
        names.resize(device.identity().profileCount);
        names[number - 1] = wanted;
        edited.setProfileNames(names);
        WriteOptions options;
        options.history = &history();
        return writeAndTellMissing(channel, device, *base, edited, options);
    }
};

}  // namespace

Commands parameterCommands(const CommandContext &context)
{
    return makeCommands<InfoCommand, ListCommand, GetCommand, SetCommand, ProfilesCommand, RenameCommand>(
        context);
}
