// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/actioncommand.h"
#include "protocol/device/flight.h"
#include "protocol/procedure/motorsnow.h"
#include "protocol/procedure/safeaction.h"

#include <algorithm>
#include <vector>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kStopPatience = 1s;  // before a stop that is not over is told of

const QString kStopKey = u"motors.off"_s;

// What another ground streams arms again within a period of it.
constexpr auto kLookEvery = 50ms;
constexpr auto kStaysFor = 300ms;  // disarmed: nobody streams
constexpr auto kLookOn = 3s;  // at most: who steered it may need a moment to let go, and takes answers away

/// Looks on after a stop that was proven, on the worker: whether the machine is armed again. Errors: Timeout
/// where it fell silent, those of the channel.
Result<bool> findArmedAgain(Channel &channel, Device &device)
{
    const TimePoint begin = channel.now();
    TimePoint armedAt = begin;
    bool isArmed = false;
    int answers = 0;
    while (channel.now() - begin < kLookOn && (answers < 3 || channel.now() - armedAt < kStaysFor)) {
        const auto told = device.flight()->askArmed(channel);
        if (!told && told.error().code != ErrorCode::Timeout)
            return tl::unexpected(told.error());
        if (told) {
            isArmed = *told;
            answers = isArmed ? 0 : answers + 1;
        }
        if (isArmed)
            armedAt = channel.now();
        if (const auto slept = channel.sleep(kLookEvery); !slept)
            return tl::unexpected(slept.error());
    }
    // One that has fallen silent proves nothing.
    if (answers == 0 && !isArmed)
        return failure(ErrorCode::Timeout, u"it does not answer any more"_s);
    return isArmed;
}

// Whatever ended a stop, nobody has seen it work; the words for NotProven say so themselves.
QString unstopped(const Error &error, std::optional<bool> flies)
{
    if (error.code == ErrorCode::NotProven || error.code == ErrorCode::ReadOnly)
        return {};
    return u"nobody has seen the motors stop, and they may be running: "_s + keepAwayText(flies);
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
        m_flies = client.device() && client.device()->flight();
        connect(&client, &DeviceClient::motorsOffFinished, this, &MotorStop::onStopped);
        connect(&client, &DeviceClient::motorsOffSettled, this, &MotorStop::onSettled);
        connect(&m_repeating, &QTimer::timeout, this, [this] {
            emit m_command.told(u"the motors are not proven to be off; still stopping them"_s);
        });
        sayUnlessOver(u"the board does not confirm yet that the motors are off: the command is repeated; "_s
                      + (m_flies ? u"keep clear of the propellers"_s : u"hold the camera"_s));
        client.motorsOff();
    }
    [[nodiscard]] bool isRunning() const { return m_client; }
    /// Empty: no board has answered.
    [[nodiscard]] std::optional<bool> flies() const
    {
        return m_client ? std::optional(m_flies) : std::nullopt;
    }
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
                "stopping them goes on until it does (Ctrl-C ends it). "_s
                + (m_flies ? u"Keep clear of the propellers; taking out the battery from a safe place "_s
                           : u"Hold the camera; disconnecting the power "_s)
                + u"stops them too"_s);
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
        if (!m_flies || !restored) {
            tellStopped(restored);
            return;
        }
        m_client->submit<bool>(&findArmedAgain).then(this, [this](const Result<bool> &armed) {
            const ChannelRoles &roles = m_client->roles();
            const auto store = m_client->telemetry();
            const auto latest
                = [&](int channel) { return store && channel >= 0 ? store->latest(channel) : 0.0F; };
            if (!armed)
                emit m_command.finished(
                    failure(ErrorCode::NotProven, u"whether it stayed disarmed: "_s + armed.error().detail));
            else if (*armed || (!m_client->areOutputsUnknown() && latest(roles.outputs) > 0))
                tellArmedAgain();
            else
                tellStopped(true);
        });
    }
    void tellArmedAgain()
    {
        emit m_command.finished(
            notDone(doneOutcome(kStopKey, {}), u"armed again"_s, u"armed again\n"_s,
                    u"the motors were stopped, and the drone was armed again by another ground station that "
                    u"steers it: they can turn again. Disarm it there or end that program, keep clear of "
                    u"the propellers until then, and stop the motors once more"_s));
    }
    static CommandOutcome notDone(CommandOutcome outcome, const QString &state, const QString &text,
                                  const QString &note)
    {
        QJsonObject json = outcome.json.toObject();
        json.insert(u"error"_s, note);
        json.insert(u"done"_s, false);
        json.insert(u"state"_s, state);
        outcome.json = json;
        outcome.note = note;
        outcome.text = text;
        outcome.exitCode = Refused;
        return outcome;
    }
    void tellStopped(bool restored)
    {
        CommandOutcome outcome = doneOutcome(kStopKey, {});
        QJsonObject json = outcome.json.toObject();
        json.insert(u"restored"_s, restored);
        if (m_client->areOutputsUnknown()) {
            json.insert(u"outputs"_s, u"unknown"_s);
            outcome.note = u"disarmed; it does not tell what its motors do: see that they stand before you "
                           u"come near"_s;
        }
        outcome.json = json;
        if (!restored)
            outcome = notDone(
                outcome, u"off, not restored"_s, u"the motors are off\n"_s,
                u"the motors are off, but disabled in volatile memory, and what was in use before could "
                u"not be put back: restart the board before you use them (gimbalctl do restart), and "
                u"store nothing before"_s);
        emit m_command.finished(outcome);
    }

    static constexpr auto kToldAgain = 5s;
    Command &m_command;
    DeviceClient *m_client = nullptr;
    bool m_flies = false;
    QTimer m_patience;
    QTimer m_repeating;
    bool m_isProven = false;
};

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
        const ActionSpec *action = actionNamed(*client.device(), actionKey());
        if (action && action->stopsMotors && given().isEmpty() && !client.address().isReplay())
            m_stop.start(client);
        else
            ActionCommand::start(client);
    }
    [[nodiscard]] bool reportsLoss() const override { return !m_stop.isRunning(); }
    [[nodiscard]] bool endsWith(const Error &error) override { return m_stop.endsWith(error); }
    [[nodiscard]] QString leftOpen(const Error &error) const override
    {
        return m_stop.isRunning() || actionKey() == kStopKey ? unstopped(error, m_stop.flies()) : QString();
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
        const ActionSpec *action = actionNamed(*client().device(), actionKey());
        if (error.code != ErrorCode::NotProven || !action || action->isProcedure || !client().isConnected())
            return false;
        m_stop.start(client());
        return true;
    }

private:
    MotorStop m_stop{*this};

    static Result<CommandOutcome> help(Device &device)
    {
        CommandOutcome outcome;
        QJsonArray array;
        for (const ActionSpec &action : device.actions()) {
            const QString key = QLatin1String(action.key);
            const QString risk = riskName(action.risk);
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
                const QString other = riskName(entry.risk);
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
    const char *words() const override { return "[NAME [ARG=VALUE...]]"; }
    QString help() const override
    {
        return u"calibrate a sensor, the gyroscope without a name; \"do help\" lists what the board can"_s;
    }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 calibrate gyro"; }
    QList<CommandOption> options() override
    {
        return ActionCommand::options() << switchOption(
                   u"full"_s, u"all sensors at once, where the board can: as the name \"all\""_s, m_full);
    }
    QString check() const override
    {
        return m_full && !arguments().isEmpty() ? u"calibrate takes either a name or --full"_s : QString();
    }

protected:
    QString actionKey() const override
    {
        return u"calibrate."_s + (m_full ? u"all"_s : arguments().value(0, u"gyro"_s));
    }
    QStringList given() const override { return arguments().mid(1); }

private:
    bool m_full = false;
};

class MotorTestCommand final : public ActionCommand
{
public:
    using ActionCommand::ActionCommand;
    const char *name() const override { return "motor-test"; }
    const char *words() const override { return "N"; }
    QString help() const override
    {
        return u"turn one motor, from 1, for a moment; the propellers have to be off (--confirmed)"_s;
    }
    const char *example() const override
    {
        return "--family bcflight --link udp://192.168.32.1:2020 motor-test 2 --confirmed";
    }
    bool moves() const override { return true; }
    QString check() const override
    {
        bool isNumber = false;
        const int motor = arguments().value(0).toInt(&isNumber);
        return arguments().size() == 1 && isNumber && motor > 0 ? QString()
                                                                : u"motor-test needs the number of a motor"_s;
    }

protected:
    QString actionKey() const override { return u"motor.test"_s; }
    QStringList given() const override { return {u"motor="_s + arguments().first()}; }
};

class UploadCommand final : public ActionCommand
{
public:
    using ActionCommand::ActionCommand;
    const char *name() const override { return "upload"; }
    const char *words() const override { return "FILE"; }
    QString help() const override
    {
        return u"replace the board's firmware by a file, where it takes one over this link (--confirmed)"_s;
    }
    const char *example() const override
    {
        return "--family bcflight --link udp://192.168.32.1:2020 upload flight --confirmed";
    }
    bool moves() const override { return true; }
    QString check() const override { return arguments().size() == 1 ? QString() : u"upload needs a file"_s; }

protected:
    QString actionKey() const override { return u"firmware.upload"_s; }
    QStringList given() const override { return {u"file="_s + arguments().first()}; }
};

class FeedCommand final : public ActionCommand
{
public:
    using ActionCommand::ActionCommand;
    const char *name() const override { return "feed"; }
    const char *words() const override { return "helper|gyro|attitude FILE"; }
    QString help() const override
    {
        return u"send the board what other sensors see: rows of a CSV file with \"time\" and the "
               "message's fields, each at its time"_s;
    }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 feed helper frame.csv"; }
    bool moves() const override { return true; }
    QString check() const override
    {
        return arguments().size() == 2 ? QString() : u"feed needs what it is and a file"_s;
    }

protected:
    QString actionKey() const override { return u"feed"_s; }
    QStringList given() const override { return {u"what="_s + arguments()[0], u"file="_s + arguments()[1]}; }
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
    void prepare(DeviceClient &client) override
    {
        if (arguments().first() == u"off"_s)
            client.stopBeforeAsking();
    }
    [[nodiscard]] bool endsWith(const Error &error) override { return m_stop.endsWith(error); }
    [[nodiscard]] QString leftOpen(const Error &error) const override
    {
        return arguments().first() == u"off"_s ? unstopped(error, m_stop.flies()) : QString();
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
        if (actionNamed(device, key)) {
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
    return makeCommands<DoCommand, CalibrateCommand, MotorTestCommand, UploadCommand, FeedCommand,
                        AutotuneCommand, MotorsCommand, StreamsCommand>(context);
}
