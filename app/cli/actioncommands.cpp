// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "protocol/procedure/safeaction.h"

#include <algorithm>
#include <vector>

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

Result<CommandOutcome> performAction(Channel &channel, Device &device, const QString &key,
                                     const QStringList &words, const CommandOptions &options)
{
    const auto actions = device.actions();
    const auto it = std::find_if(actions.begin(), actions.end(), [&key](const ActionSpec &action) {
        return key == QLatin1String(action.key);
    });
    if (it == actions.end()) {
        QStringList names;
        for (const ActionSpec &action : actions)
            names.append(QLatin1String(action.key));
        return failure(ErrorCode::InvalidArgument,
                       u"no action '%1'; there are: %2"_s.arg(key, names.join(u", "_s)));
    }
    const auto texts = assignments(words);
    if (!texts)
        return tl::unexpected(texts.error());
    const auto arguments = parseArguments(*it, *texts);
    if (!arguments)
        return tl::unexpected(arguments.error());
    const auto done = performSafely(channel, device, key, *arguments, options.history);
    if (!done)
        return tl::unexpected(done.error());
    CommandOutcome outcome;
    QJsonObject json{
        {u"action"_s, key}, {u"done"_s, true}, {u"reply"_s, QJsonObject::fromVariantMap(done->reply)}};
    if (!done->snapshotPath.isEmpty()) {
        json.insert(u"snapshot"_s, done->snapshotPath);
        outcome.note = u"snapshot: "_s + done->snapshotPath;
    }
    outcome.json = json;
    for (auto reply = done->reply.begin(); reply != done->reply.end(); ++reply) {
        QStringList values;
        for (const QVariant &value :
             reply->typeId() == QMetaType::QVariantList ? reply->toList() : QVariantList{*reply})
            values.append(value.typeId() == QMetaType::Double ? QString::number(value.toDouble(), 'g', 6)
                                                              : value.toString());
        outcome.text += u"%1 %2\n"_s.arg(reply.key().leftJustified(20), values.join(u' '));
    }
    if (outcome.text.isEmpty())
        outcome.text = u"done\n"_s;
    return outcome;
}

class DoCommand final : public Command
{
public:
    const char *name() const override { return "do"; }
    const char *usage() const override { return "do ACTION [ARG=VALUE...]"; }
    const char *help() const override { return "perform an action; \"do help\" lists them"; }
    bool moves() const override { return true; }
    QString check(const CommandOptions &options) const override
    {
        return options.arguments.isEmpty() ? u"do needs the name of an action; \"do help\" lists them"_s
                                           : QString();
    }
    Result<CommandOutcome> run(Channel &channel, Device &device, const CommandOptions &options) override
    {
        if (options.arguments.first() == u"help"_s)
            return help(device);
        return performAction(channel, device, options.arguments.first(), options.arguments.mid(1), options);
    }

private:
    static Result<CommandOutcome> help(Device &device)
    {
        constexpr std::array<const char *, 4> risks{"safe", "moves", "writes", "destroys"};
        CommandOutcome outcome;
        QJsonArray array;
        for (const ActionSpec &action : device.actions()) {
            const QString key = QLatin1String(action.key);
            const QString risk = QLatin1String(risks[std::size_t(action.risk)]);
            outcome.text += u"%1 %2 %3\n"_s.arg(key.leftJustified(20), risk.leftJustified(9),
                                                QString::fromUtf8(action.help));
            QJsonArray arguments;
            for (const ArgumentSpec &argument : action.arguments) {
                QStringList names;
                for (const Choice &choice : argument.choices)
                    names.append(QString::fromUtf8(choice.name));
                arguments.append(QJsonObject{{u"key"_s, QLatin1String(argument.key)},
                                             {u"min"_s, argument.min},
                                             {u"max"_s, argument.max},
                                             {u"unit"_s, QString::fromUtf8(argument.unit)},
                                             {u"default"_s, QLatin1String(argument.defaultText)},
                                             {u"choices"_s, QJsonArray::fromStringList(names)}});
                const QString preset = QLatin1String(argument.defaultText);
                outcome.text += u"    %1=%2  %3\n"_s.arg(QLatin1String(argument.key),
                                                         preset == u"nan"_s ? QString() : preset,
                                                         QString::fromUtf8(argument.label));
            }
            array.append(QJsonObject{{u"key"_s, key},
                                     {u"risk"_s, risk},
                                     {u"help"_s, QString::fromUtf8(action.help)},
                                     {u"arguments"_s, arguments}});
        }
        outcome.json = array;
        return outcome;
    }
};

class CalibrateCommand final : public Command
{
public:
    const char *name() const override { return "calibrate"; }
    const char *usage() const override { return "calibrate NAME [ARG=VALUE...]"; }
    const char *help() const override { return "gyro, acc, battery, offset; with STorM32: level, six"; }
    QString check(const CommandOptions &options) const override
    {
        return options.arguments.isEmpty() ? u"calibrate needs a name; \"do help\" lists the board's"_s
                                           : QString();
    }
    Result<CommandOutcome> run(Channel &channel, Device &device, const CommandOptions &options) override
    {
        return performAction(channel, device, u"calibrate."_s + options.arguments.first(),
                             options.arguments.mid(1), options);
    }
};

class AutotuneCommand final : public Command
{
public:
    const char *name() const override { return "autotune"; }
    const char *usage() const override
    {
        return "autotune [roll=off] [gain=0..255] [keep=on] [save=off] ...";
    }
    const char *help() const override { return "the board searches its gains by moving the camera"; }
    bool moves() const override { return true; }
    QString check(const CommandOptions &) const override { return {}; }
    Result<CommandOutcome> run(Channel &channel, Device &device, const CommandOptions &options) override
    {
        return performAction(channel, device, u"autotune"_s, options.arguments, options);
    }
};

class MotorsCommand final : public Command
{
public:
    const char *name() const override { return "motors"; }
    const char *usage() const override { return "motors on|off"; }
    const char *help() const override { return "switch the motors"; }
    QString check(const CommandOptions &options) const override
    {
        const QString word = options.arguments.value(0);
        return options.arguments.size() == 1 && (word == u"on"_s || word == u"off"_s)
            ? QString()
            : u"motors needs on or off"_s;
    }
    Result<CommandOutcome> run(Channel &channel, Device &device, const CommandOptions &options) override
    {
        return performAction(channel, device, u"motors."_s + options.arguments.first(), {}, options);
    }
};

class StreamsCommand final : public Command
{
public:
    const char *name() const override { return "streams"; }
    const char *usage() const override { return "streams [--channels a,b]"; }
    const char *help() const override
    {
        return "data streams of the board, and how fast a line can carry each";
    }
    QString check(const CommandOptions &options) const override
    {
        return options.arguments.isEmpty() ? QString() : u"streams takes options only"_s;
    }
    Result<CommandOutcome> run(Channel &, Device &device, const CommandOptions &options) override
    {
        QList<int> channels;
        for (const QString &key : options.channels) {
            const int channel = findChannel(device.channels(), key.trimmed());
            if (channel < 0)
                return failure(ErrorCode::InvalidArgument,
                               u"no channel '%1'; gimbalctl monitor lists them"_s.arg(key));
            channels.append(channel);
        }
        if (channels.isEmpty())
            channels = usualChannels(device);
        CommandOutcome outcome;
        QJsonArray list;
        // The line sets no limit on USB.
        const std::vector<int> lines
            = device.identity().usb ? std::vector<int>{0} : std::vector<int>{115200, 256000, 921600};
        outcome.text = u"%1 %2 %3"_s.arg(u"stream"_s, -12).arg(u""_s, -22).arg(u"bytes"_s, 6);
        for (const int baud : lines)
            outcome.text += u"%1"_s.arg(baud ? QString::number(baud) : u"USB"_s, 12);
        outcome.text += u'\n';
        for (const StreamSpec &spec : device.streams()) {
            const QList<int> wanted = spec.choosesChannels ? channels : spec.channels;
            QJsonObject json{{u"stream"_s, spec.key}, {u"name"_s, spec.label}};
            QJsonObject rates;
            QString cells;
            for (const int baud : lines) {
                const auto budget
                    = device.streamBudget({{}, 0, {{spec.key, 0, wanted}}}, LineSettings{baud, Parity::None});
                if (!budget)
                    return tl::unexpected(budget.error());
                const StreamUse &use = budget->streams.front();
                if (cells.isEmpty())
                    cells = u"%1"_s.arg(use.frameBytes, 6);
                cells += u"%1/s"_s.arg(use.rate, 10, 'f', 0);
                json.insert(u"frameBytes"_s, use.frameBytes);
                rates.insert(baud ? QString::number(baud) : u"usb"_s, use.rate);
            }
            json.insert(u"samplesPerSecond"_s, rates);
            list.append(json);
            outcome.text += u"%1 %2 %3\n"_s.arg(spec.key, -12).arg(spec.label, -22).arg(cells);
        }
        if (list.isEmpty())
            outcome.text = u"this firmware has no streams; it is polled\n"_s;
        outcome.json = list;
        return outcome;
    }
};

}  // namespace

std::vector<std::unique_ptr<Command>> actionCommands()
{
    std::vector<std::unique_ptr<Command>> commands;
    commands.push_back(std::make_unique<DoCommand>());
    commands.push_back(std::make_unique<CalibrateCommand>());
    commands.push_back(std::make_unique<AutotuneCommand>());
    commands.push_back(std::make_unique<MotorsCommand>());
    commands.push_back(std::make_unique<StreamsCommand>());
    return commands;
}
