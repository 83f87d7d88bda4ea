// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command.h"
#include "protocol/procedure/motorsnow.h"
#include "protocol/procedure/safeaction.h"

#include <algorithm>
#include <vector>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kStopPatience = 1s;  // before a stop that is not over is told of

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

const ActionSpec *findAction(const Device &device, const QString &key)
{
    const auto actions = device.actions();
    const auto it = std::find_if(actions.begin(), actions.end(), [&key](const ActionSpec &action) {
        return key == QLatin1String(action.key);
    });
    return it == actions.end() ? nullptr : &*it;
}

// Whether it, or one of its entries, cuts the motors' current.
bool mayLetGo(const ActionSpec &action)
{
    return action.letsGo
        || std::any_of(action.entries.begin(), action.entries.end(),
                       [](const EntryEffect &entry) { return entry.letsGo; });
}

// An action that no board answers is sent; whether it was done nobody can tell.
CommandOutcome doneOutcome(const QString &key, const ActionReply &reply, bool answered = true,
                           const ActionSpec *action = nullptr)
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

const QString kStopKey = u"motors.off"_s;

// Whatever ended a stop, nobody has seen it work; the words for NotProven say so themselves.
QString unstopped(const Error &error)
{
    if (error.code == ErrorCode::NotProven || error.code == ErrorCode::ReadOnly)
        return {};
    return u"nobody has seen the motors stop, and they may be running: hold the camera and disconnect the "
           "power"_s;
}

/// Stops the motors for a command, which always works: runs the board's stop plan until something confirms
/// that they have stopped.
class MotorStop final : public QObject
{
public:
    explicit MotorStop(Command &command)
        : m_command(command)
    {
    }

    void start(DeviceClient &client)
    {
        if (client.address().isReplay()) {
            emit m_command.finished(failure(ErrorCode::ReadOnly, u"a recording has no motors"_s));
            return;
        }
        m_client = &client;
        connect(&client, &DeviceClient::motorsOffFinished, this, &MotorStop::onStopped);
        connect(&client, &DeviceClient::motorsOffSettled, this, &MotorStop::onSettled);
        connect(&m_repeating, &QTimer::timeout, this, [this] {
            emit m_command.told(u"the motors are not proven to be off; still stopping them"_s);
        });
        sayUnlessOver(u"the board does not confirm yet that the motors are off: the command is repeated; "
                      u"hold the camera"_s);
        client.motorsOff();
    }
    [[nodiscard]] bool isRunning() const { return m_client; }
    /// The link was lost. False: nothing was being stopped.
    bool endsWith(const Error &error)
    {
        if (isRunning())
            emit m_command.finished(failure(ErrorCode::NotProven, u"the link ended: "_s + error.detail));
        return isRunning();
    }
    /// Ctrl-C. False: nothing is being stopped, or only what it changed beside is being put back.
    bool interrupt()
    {
        const bool ends = isRunning() && !m_isProven;
        if (ends)
            emit m_command.finished(failure(ErrorCode::NotProven));
        return ends;
    }

private:
    // Nobody waits without knowing what for.
    void sayUnlessOver(const QString &line)
    {
        m_patience.disconnect(this);
        connect(&m_patience, &QTimer::timeout, this, [this, line] { emit m_command.told(line); });
        m_patience.setSingleShot(true);
        m_patience.start(kStopPatience);
    }
    // What is not proven is repeated by the session itself, until it is.
    void onStopped(bool proven)
    {
        m_isProven = proven;
        if (proven) {
            m_repeating.stop();
            sayUnlessOver(u"the motors are off; they stay disabled until the board confirms that it stands "
                          u"by, which is asked for half a minute at most, and what was in use before follows "
                          u"then"_s);
        } else if (!m_repeating.isActive()) {
            m_patience.stop();
            emit m_command.told(
                u"the board did not confirm that the motors are off, and they may still be running: "
                "stopping them goes on until it does (Ctrl-C ends it). Hold the camera; disconnecting "
                "the power stops them too"_s);
            if (m_client->device() && m_client->device()->stopPlan().restore)
                emit m_command.told(
                    u"if the board takes the stop late, its motors are disabled in volatile memory: restart "
                    u"it to have them back, and store nothing before"_s);
            m_repeating.start(kToldAgain);
        }
    }
    void onSettled(bool restored)
    {
        m_patience.stop();
        CommandOutcome outcome = doneOutcome(kStopKey, {});
        QJsonObject json = outcome.json.toObject();
        json.insert(u"restored"_s, restored);
        outcome.json = json;
        if (!restored) {
            outcome.note
                = u"the motors are off, but disabled in volatile memory, and what was in use before could "
                  u"not be put back: restart the board before you use them (gimbalctl do restart), and "
                  u"store nothing before"_s;
            json.insert(u"error"_s, outcome.note);
            json.insert(u"done"_s, false);
            json.insert(u"state"_s, u"off, not restored"_s);
            outcome.json = json;
            outcome.text = u"the motors are off\n"_s;
            outcome.exitCode = Refused;
        }
        emit m_command.finished(outcome);
    }

    static constexpr auto kToldAgain = 5s;
    Command &m_command;
    DeviceClient *m_client = nullptr;
    QTimer m_patience;
    QTimer m_repeating;
    bool m_isProven = false;
};

/// Performs one of the board's actions.
class ActionCommand : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    QList<CommandOption> options() override
    {
        return {switchOption(u"confirmed"_s,
                             u"what the action asks to be confirmed each time is so (see \"do help\")"_s,
                             m_confirmed)};
    }

protected:
    /// The action and its arguments.
    [[nodiscard]] virtual QString actionKey() const = 0;
    [[nodiscard]] virtual QStringList given() const = 0;
    [[nodiscard]] QList<int> awaits(const Device &device) const override
    {
        const ActionSpec *action = findAction(device, actionKey());
        QList<int> channels;
        for (const Condition condition : action ? action->needs : std::span<const Condition>()) {
            if (const int channel = channelOf(condition, rolesOf(device)); channel >= 0)
                channels.append(channel);
        }
        if (const int outputs = rolesOf(device).outputs; action && mayLetGo(*action) && outputs >= 0)
            channels.append(outputs);
        return channels;
    }
    Result<CommandOutcome> run(Channel &channel, Device &device) override;

private:
    bool m_confirmed = false;
};

Result<CommandOutcome> ActionCommand::run(Channel &channel, Device &device)
{
    const ActionSpec *action = findAction(device, actionKey());
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

class DoCommand final : public ActionCommand
{
public:
    using ActionCommand::ActionCommand;
    const char *name() const override { return "do"; }
    const char *words() const override { return "ACTION [ARG=VALUE...]"; }
    QString help() const override { return u"perform an action; \"do help\" lists them"_s; }
    const char *example() const override
    {
        return "--link serial:/dev/ttyUSB0 do steer yaw=30 speed=20 seconds=3";
    }
    bool moves() const override { return true; }
    QString check() const override
    {
        return arguments().isEmpty() ? u"do needs the name of an action; \"do help\" lists them"_s
                                     : QString();
    }
    Result<CommandOutcome> run(Channel &channel, Device &device) override
    {
        return arguments().first() == u"help"_s ? help(device) : ActionCommand::run(channel, device);
    }
    // Stopping the motors does not give up, whatever it is called.
    void start(DeviceClient &client) override
    {
        const ActionSpec *action = findAction(*client.device(), actionKey());
        if (action && action->stopsMotors && given().isEmpty() && !client.address().isReplay())
            m_stop.start(client);
        else
            ActionCommand::start(client);
    }
    [[nodiscard]] bool reportsLoss() const override { return !m_stop.isRunning(); }
    [[nodiscard]] bool endsWith(const Error &error) override { return m_stop.endsWith(error); }
    [[nodiscard]] QString leftOpen(const Error &error) const override
    {
        return m_stop.isRunning() || actionKey() == kStopKey ? unstopped(error) : QString();
    }
    void stop() override
    {
        if (!m_stop.isRunning())
            ActionCommand::stop();
        else
            m_stop.interrupt();
    }

protected:
    QString actionKey() const override { return arguments().first(); }
    QStringList given() const override { return arguments().mid(1); }
    // Any action by which the motors were to stop.
    [[nodiscard]] bool goesOnAfter(const Error &error) override
    {
        const ActionSpec *action = findAction(*client().device(), actionKey());
        if (error.code != ErrorCode::NotProven || !action || action->isProcedure || !client().isConnected())
            return false;
        m_stop.start(client());
        return true;
    }

private:
    MotorStop m_stop{*this};

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
            QJsonObject json{{u"key"_s, key},
                             {u"risk"_s, risk},
                             {u"help"_s, QString::fromUtf8(action.help)},
                             {u"arguments"_s, arguments}};
            QJsonArray entries;
            for (const EntryEffect &entry : action.entries) {
                const auto choices = action.arguments.front().choices;
                const auto choice
                    = std::find_if(choices.begin(), choices.end(),
                                   [&entry](const Choice &each) { return each.value == entry.value; });
                const QString other = QLatin1String(risks[std::size_t(entry.risk)]);
                if (choice == choices.end() || other == risk)
                    continue;
                entries.append(QJsonObject{{u"entry"_s, QString::fromUtf8(choice->name)},
                                           {u"risk"_s, other},
                                           {u"answered"_s, entry.isShown}});
                outcome.text
                    += u"      %1 %2\n"_s.arg(other.leftJustified(9), QString::fromUtf8(choice->name));
            }
            if (!entries.isEmpty())
                json.insert(u"entries"_s, entries);
            if (action.risk == ActionRisk::Destroys && !*action.confirm)
                outcome.text += u"    --confirmed\n"_s;
            else if (mayLetGo(action))
                outcome.text += action.letsGo
                    ? u"    --confirmed  while the motors run\n"_s
                    : u"    --confirmed  while the motors run, where they let go\n"_s;
            if (mayLetGo(action))
                json.insert(u"letsGo"_s, true);
            if (*action.confirm) {
                json.insert(u"confirm"_s, QString::fromUtf8(action.confirm));
                outcome.text += u"    --confirmed  \"%1\"\n"_s.arg(QString::fromUtf8(action.confirm));
            }
            array.append(json);
        }
        outcome.json = array;
        return outcome;
    }
};

class CalibrateCommand final : public ActionCommand
{
public:
    using ActionCommand::ActionCommand;
    const char *name() const override { return "calibrate"; }
    const char *words() const override { return "NAME [ARG=VALUE...]"; }
    QString help() const override { return u"calibrate a sensor; \"do help\" lists what the board can"_s; }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 calibrate gyro"; }
    QString check() const override
    {
        return arguments().isEmpty() ? u"calibrate needs a name; \"do help\" lists the board's"_s : QString();
    }

protected:
    QString actionKey() const override { return u"calibrate."_s + arguments().first(); }
    QStringList given() const override { return arguments().mid(1); }
};

class AutotuneCommand final : public ActionCommand
{
public:
    using ActionCommand::ActionCommand;
    const char *name() const override { return "autotune"; }
    const char *words() const override { return "[roll=off] [gain=0..255] [keep=on] [save=off] ..."; }
    QString help() const override { return u"the board searches its gains by moving the camera"_s; }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 autotune yaw=off"; }
    bool moves() const override { return true; }

protected:
    QString actionKey() const override { return u"autotune"_s; }
    QStringList given() const override { return arguments(); }
};

class MotorsCommand final : public Command
{
public:
    using Command::Command;
    const char *name() const override { return "motors"; }
    const char *words() const override { return "on|off"; }
    QString help() const override { return u"switch the motors"_s; }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 motors off"; }
    QString check() const override
    {
        const QString word = arguments().value(0);
        return arguments().size() == 1 && (word == u"on"_s || word == u"off"_s) ? QString()
                                                                                : u"motors needs on or off"_s;
    }
    [[nodiscard]] bool endsWith(const Error &error) override { return m_stop.endsWith(error); }
    [[nodiscard]] QString leftOpen(const Error &error) const override
    {
        return arguments().first() == u"off"_s ? unstopped(error) : QString();
    }
    void start(DeviceClient &client) override
    {
        m_client = &client;
        if (arguments().first() == u"off"_s) {
            m_stop.start(client);
            return;
        }
        client
            .submit<CommandOutcome>(
                [safe = history()](Channel &channel, Device &device) { return on(channel, device, safe); })
            .then(this, [this](const Result<CommandOutcome> &outcome) { emit finished(outcome); });
    }
    void stop() override
    {
        if (!m_stop.interrupt())
            m_client->cancelJobs();
    }

private:
    static Result<CommandOutcome> on(Channel &channel, Device &device, const BoardHistory &history)
    {
        const QString key = u"motors.on"_s;
        if (findAction(device, key)) {
            return performSafely(channel, device, key, {}, history).map([&key](const ActionOutcome &done) {
                return doneOutcome(key, done.reply, done.answered);
            });
        }
        if (!device.motorSwitch())
            return failure(ErrorCode::Unsupported,
                           u"this board has no command that switches its motors on"_s);
        return device.motorSwitch()->switchMotorsOn(channel).map([&key] { return doneOutcome(key, {}); });
    }

    DeviceClient *m_client = nullptr;
    MotorStop m_stop{*this};
};

class StreamsCommand final : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    const char *name() const override { return "streams"; }
    QString help() const override
    {
        return u"data streams of the board, and how fast a line can carry each"_s;
    }
    const char *example() const override
    {
        return "--link serial:/dev/ttyUSB0 streams --channels gyro.roll,gyro.yaw";
    }
    QList<CommandOption> options() override { return {channelsOption(m_channels)}; }
    Result<CommandOutcome> run(Channel &, Device &device) override
    {
        const auto named = findChannels(device.channels(), m_channels);
        if (!named)
            return tl::unexpected(named.error());
        const QList<int> channels = named->isEmpty() ? defaultChannels(device) : *named;
        CommandOutcome outcome;
        QJsonArray list;
        const StreamControl *streams = device.streamControl();
        if (!streams || streams->streams().isEmpty()) {
            outcome.text = u"this firmware has no streams; it is polled\n"_s;
            outcome.json = list;
            return outcome;
        }
        // Over USB the line imposes no limit.
        const std::vector<int> lines
            = device.identity().usb ? std::vector<int>{0} : std::vector<int>{115200, 256000, 921600};
        outcome.text = u"%1 %2 %3"_s.arg(u"stream"_s, -12).arg(u""_s, -22).arg(u"bytes"_s, 6);
        for (const int baud : lines)
            outcome.text += u"%1"_s.arg(baud ? QString::number(baud) : u"USB"_s, 12);
        outcome.text += u'\n';
        for (const StreamSpec &spec : streams->streams()) {
            const QList<int> wanted = spec.choosesChannels ? channels : spec.channels;
            QJsonObject json{{u"stream"_s, spec.key}, {u"name"_s, spec.label}};
            QJsonObject rates;
            QString cells;
            for (const int baud : lines) {
                const auto budget = streams->streamBudget({{}, 0, {{spec.key, 0, wanted}}},
                                                          LineSettings{baud, Parity::None});
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
        outcome.json = list;
        return outcome;
    }

private:
    QStringList m_channels;
};

}  // namespace

Commands actionCommands(const CommandContext &context)
{
    return makeCommands<DoCommand, CalibrateCommand, AutotuneCommand, MotorsCommand, StreamsCommand>(context);
}
