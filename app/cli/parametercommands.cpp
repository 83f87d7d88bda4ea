// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"

#include <QRegularExpression>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

Result<int> chosenProfile(const CommandOptions &options, const Configuration &configuration)
{
    if (options.profile == 0)
        return configuration.activeProfile();
    if (options.profile > configuration.identity().profileCount) {
        return failure(ErrorCode::InvalidArgument,
                       u"profile %1; the board has %2"_s.arg(options.profile)
                           .arg(configuration.identity().profileCount));
    }
    return options.profile - 1;
}

QJsonObject parameterJson(const ParameterSpec &spec, int profile, int raw)
{
    QJsonObject json{{u"key"_s, spec.key},
                     {u"value"_s, spec.format(raw)},
                     {u"raw"_s, raw},
                     {u"unit"_s, QString::fromUtf8(spec.row->unit)},
                     {u"profile"_s, profile + 1},
                     {u"label"_s, QString::fromUtf8(spec.row->label)}};
    if (spec.row->kind == ValueKind::Number) {
        json.insert(u"min"_s, spec.toDisplay(spec.row->min));
        json.insert(u"max"_s, spec.toDisplay(spec.row->max));
    }
    return json;
}

class InfoCommand final : public Command
{
public:
    const char *name() const override { return "info"; }
    const char *usage() const override { return "info"; }
    const char *help() const override { return "who is connected"; }
    QString check(const CommandOptions &) const override { return {}; }
    Result<CommandOutcome> run(Channel &, Device &device, const CommandOptions &) override
    {
        const BoardIdentity &identity = device.identity();
        QStringList capabilities(identity.capabilities.begin(), identity.capabilities.end());
        capabilities.sort();
        CommandOutcome outcome;
        outcome.json = QJsonObject{{u"family"_s, identity.family},
                                   {u"model"_s, identity.model},
                                   {u"firmware"_s, identity.firmware},
                                   {u"serial"_s, identity.serial},
                                   {u"profiles"_s, identity.profileCount},
                                   {u"usb"_s, identity.usb},
                                   {u"writable"_s, identity.writable},
                                   {u"capabilities"_s, QJsonArray::fromStringList(capabilities)},
                                   {u"extra"_s, QJsonObject::fromVariantMap(identity.extra)}};
        outcome.text
            = u"board        %1\nfirmware     %2%3\nserial       %4\nprofiles     %5\nport         %6\n"
              u"can          %7\n"_s
                  .arg(identity.model, identity.firmware, identity.writable ? QString() : u" (read-only)"_s,
                       identity.serial)
                  .arg(identity.profileCount)
                  .arg(identity.usb ? u"USB"_s : u"UART"_s, capabilities.join(u", "_s));
        return outcome;
    }
};

class ListCommand final : public Command
{
public:
    const char *name() const override { return "list"; }
    const char *usage() const override { return "list [PATTERN] [--profile N]"; }
    const char *help() const override { return "parameters with unit, range and value"; }
    QString check(const CommandOptions &options) const override
    {
        return options.arguments.size() > 1 ? u"list takes one pattern at most"_s : QString();
    }
    Result<CommandOutcome> run(Channel &channel, Device &device, const CommandOptions &options) override
    {
        const auto configuration = device.readConfiguration(channel);
        if (!configuration)
            return tl::unexpected(configuration.error());
        const auto profile = chosenProfile(options, *configuration);
        if (!profile)
            return tl::unexpected(profile.error());
        const QString pattern = options.arguments.value(0, u"*"_s);
        const QRegularExpression matcher(QRegularExpression::wildcardToRegularExpression(
            pattern.contains(u'*') || pattern.contains(u'?') ? pattern : u'*' + pattern + u'*'));
        CommandOutcome outcome;
        QJsonArray array;
        for (const ParameterSpec &spec : configuration->parameters().all()) {
            const auto raw = configuration->raw(spec, *profile);
            if (!raw || !matcher.match(spec.key).hasMatch())
                continue;
            array.append(parameterJson(spec, *profile, *raw));
            const QString range
                = spec.row->kind == ValueKind::Number ? spec.minText() + u".."_s + spec.maxText() : QString();
            outcome.text += u"%1 %2 %3\n"_s.arg(spec.key.leftJustified(32),
                                                valueText(spec, *raw).leftJustified(24), range);
        }
        outcome.json = array;
        if (array.isEmpty()) {
            outcome.note = u"no parameter matches '%1'"_s.arg(pattern);
            outcome.exitCode = Refused;
        }
        return outcome;
    }
};

class GetCommand final : public Command
{
public:
    const char *name() const override { return "get"; }
    const char *usage() const override { return "get KEY... [--profile N]"; }
    const char *help() const override { return "values of parameters"; }
    QString check(const CommandOptions &options) const override
    {
        return options.arguments.isEmpty() ? u"get needs at least one key"_s : QString();
    }
    Result<CommandOutcome> run(Channel &channel, Device &device, const CommandOptions &options) override
    {
        const auto configuration = device.readConfiguration(channel);
        if (!configuration)
            return tl::unexpected(configuration.error());
        const auto profile = chosenProfile(options, *configuration);
        if (!profile)
            return tl::unexpected(profile.error());
        CommandOutcome outcome;
        QJsonArray array;
        for (const QString &key : options.arguments) {
            const ParameterSpec *spec = configuration->parameters().find(key);
            const auto raw = spec ? configuration->raw(*spec, *profile) : std::nullopt;
            if (!raw)
                return failure(ErrorCode::InvalidArgument, u"there is no parameter '%1'"_s.arg(key));
            array.append(parameterJson(*spec, *profile, *raw));
            outcome.text += options.arguments.size() == 1 ? spec->format(*raw) + u'\n'
                                                          : key + u'=' + spec->format(*raw) + u'\n';
        }
        outcome.json = array;
        return outcome;
    }
};

class SetCommand final : public Command
{
public:
    const char *name() const override { return "set"; }
    const char *usage() const override { return "set KEY=VALUE... [--profile N] [--no-save]"; }
    const char *help() const override
    {
        return "change parameters; --no-save changes them in volatile memory only";
    }
    QString check(const CommandOptions &options) const override
    {
        if (options.arguments.isEmpty())
            return u"set needs KEY=VALUE"_s;
        for (const QString &assignment : options.arguments) {
            if (assignment.indexOf(u'=') < 1)
                return u"'%1' is not KEY=VALUE"_s.arg(assignment);
        }
        return {};
    }
    Result<CommandOutcome> run(Channel &channel, Device &device, const CommandOptions &options) override
    {
        const auto base = device.readConfiguration(channel);
        if (!base)
            return tl::unexpected(base.error());
        const auto profile = chosenProfile(options, *base);
        if (!profile)
            return tl::unexpected(profile.error());
        Configuration edited = *base;
        std::vector<AdjustableValue> live;
        for (const QString &assignment : options.arguments) {
            const QString key = assignment.section(u'=', 0, 0);
            const ParameterSpec *spec = base->parameters().find(key);
            if (!spec)
                return failure(ErrorCode::InvalidArgument, u"there is no parameter '%1'"_s.arg(key));
            const auto raw = spec->parse(assignment.section(u'=', 1));
            if (!raw) {
                return failure(ErrorCode::InvalidArgument,
                               u"'%1' is not a value for %2"_s.arg(assignment.section(u'=', 1), key));
            }
            if (const auto set = edited.setRaw(*spec, *profile, *raw); !set)
                return tl::unexpected(set.error());
            if (options.noSave && spec->adjustable < 0) {
                return failure(ErrorCode::Unsupported,
                               u"%1 cannot be changed in volatile memory; leave --no-save out"_s.arg(key));
            }
            live.push_back({spec->adjustable, double(*raw) * spec->row->adjustableScale});
        }
        if (!options.noSave)
            return writeAndReport(channel, device, *base, edited, options);

        if (!device.identity().writable)
            return failure(ErrorCode::ReadOnly, device.identity().firmware);
        if (*profile != base->activeProfile())
            return failure(ErrorCode::InvalidArgument, u"--no-save works on the active profile only"_s);
        if (const auto done = device.writeAdjustables(channel, live); !done)
            return tl::unexpected(done.error());
        CommandOutcome outcome;
        outcome.json = QJsonObject{{u"volatile"_s, true}, {u"count"_s, qint64(live.size())}};
        outcome.text = u"changed until the next restart: %1\n"_s.arg(options.arguments.join(u", "_s));
        return outcome;
    }
};

class ProfilesCommand final : public Command
{
public:
    const char *name() const override { return "profiles"; }
    const char *usage() const override { return "profiles"; }
    const char *help() const override { return "names of the profiles; * marks the active one"; }
    QString check(const CommandOptions &) const override { return {}; }
    Result<CommandOutcome> run(Channel &channel, Device &device, const CommandOptions &) override
    {
        const auto names = device.readProfileNames(channel);
        if (!names)
            return tl::unexpected(names.error());
        const auto active = device.activeProfile(channel);
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

class RenameCommand final : public Command
{
public:
    const char *name() const override { return "rename"; }
    const char *usage() const override { return "rename N NAME"; }
    const char *help() const override { return "give a profile a name"; }
    QString check(const CommandOptions &options) const override
    {
        bool ok = false;
        const int number = options.arguments.value(0).toInt(&ok);
        if (options.arguments.size() != 2 || !ok || number < 1)
            return u"rename needs the number of a profile and its name"_s;
        return {};
    }
    Result<CommandOutcome> run(Channel &channel, Device &device, const CommandOptions &options) override
    {
        const int number = options.arguments.value(0).toInt();
        const QString wanted = options.arguments.value(1);
        if (number > device.identity().profileCount)
            return failure(ErrorCode::InvalidArgument,
                           u"the board has %1 profiles"_s.arg(device.identity().profileCount));
        if (wanted.toUtf8().size() > device.profileNameBytes()) {
            return failure(ErrorCode::InvalidArgument,
                           u"a name has at most %1 bytes, this one has %2"_s.arg(device.profileNameBytes())
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
        return writeAndReport(channel, device, *base, edited, options);
    }
};

}  // namespace

std::vector<std::unique_ptr<Command>> parameterCommands()
{
    std::vector<std::unique_ptr<Command>> commands;
    commands.push_back(std::make_unique<InfoCommand>());
    commands.push_back(std::make_unique<ListCommand>());
    commands.push_back(std::make_unique<GetCommand>());
    commands.push_back(std::make_unique<SetCommand>());
    commands.push_back(std::make_unique<ProfilesCommand>());
    commands.push_back(std::make_unique<RenameCommand>());
    return commands;
}
