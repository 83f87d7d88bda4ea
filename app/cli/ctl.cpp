// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/ctl.h"

#include "app/cli/signalwatcher.h"
#include "app/cli/telemetryprinter.h"
#include "protocol/supervisor/alarmkeys.h"
#include "widgets/models/alarmtext.h"

#include <QCommandLineParser>
#include <QJsonDocument>

#include <algorithm>
#include <cerrno>

using namespace Qt::StringLiterals;

namespace {

/// Options that are the same for every command. Those without a value name are switches.
struct GeneralOption
{
    const char *name;
    const char *value;
    const char *help;
    bool repeats = false;
};

// clang-format off
constexpr std::array kGeneralOptions{
    GeneralOption{"link", "ADDRESS", "where the board is, see above"},
    GeneralOption{"family", "F", "who is there; without it gimbalctl finds out who answers (over TCP a "
                                 "drone has to be named)"},
    GeneralOption{"json", "", "one JSON document on stdout"},
    GeneralOption{"history", "DIR", "where snapshots of boards are kept"},
    GeneralOption{"board", "NAME", "which board without a serial number it is"},
    GeneralOption{"alarm", "KIND=WHAT", "what happens at an alarm: warn, revert, revert-or-off, off", true},
    GeneralOption{"version", "", "which version this is"},
};
constexpr std::array<const char *, 4> kReactions{"warn", "revert", "revert-or-off", "off"};  // by AlarmAction
// clang-format on

constexpr int kUsageWidth = 70;

template <std::size_t N> QString choicesIn(const std::array<const char *, N> &names)
{
    QStringList list;
    for (const char *name : names)
        list.append(QLatin1String(name));
    return list.join(u", "_s);
}

/// "runaway=warn".
Result<void> takeReaction(SupervisorRules &rules, const QString &text)
{
    const auto find = [](const auto &names, const QString &name) {
        return std::find_if(names.begin(), names.end(),
                            [&name](const char *each) { return name == QLatin1String(each); });
    };
    const auto kind = find(kAlarmKeys, text.section(u'=', 0, 0));
    const auto reaction = find(kReactions, text.section(u'=', 1));
    if (kind == kAlarmKeys.end() || reaction == kReactions.end())
        return failure(ErrorCode::InvalidArgument,
                       u"--alarm needs KIND=WHAT, not '%1'; KIND is one of %2, WHAT of %3"_s.arg(
                           text, choicesIn(kAlarmKeys), choicesIn(kReactions)));
    const auto of = AlarmKind(kind - kAlarmKeys.begin());
    const auto action = AlarmAction(reaction - kReactions.begin());
    if (!SupervisorRules::offers(of, action))
        return failure(ErrorCode::InvalidArgument,
                       u"--alarm %1: no change of values is its cause; choose warn or off"_s.arg(text));
    rules.actions[std::size_t(of)] = action;
    return {};
}

QByteArray toJsonText(const QJsonValue &value)
{
    if (value.isArray())
        return QJsonDocument(value.toArray()).toJson();
    return QJsonDocument(value.toObject()).toJson();
}

}  // namespace

Ctl::Ctl(QList<Family> families, Links links, QObject *parent)
    : QObject(parent)
    , m_links(std::move(links))
    , m_context{std::move(families), BoardHistory(), false, {}}
    , m_commands(allCommands(m_context))
{
    m_context.offerVideo = m_links.offerVideo;
}

Ctl::~Ctl() = default;

QString Ctl::familyKeys(const QString &separator) const
{
    QStringList keys;
    for (const Family &family : m_context.families) {
        if (!family.links.isEmpty())
            keys.append(family.key);
    }
    return keys.join(separator);
}

QString Ctl::helpText() const
{
    QString text
        = u"gimbalctl --link ADDRESS [--family F] [--json] COMMAND\n\n"
          u"ADDRESS: serial:/dev/ttyUSB0?baud=115200&parity=none, tcp://host:port, udp://host[:port],\n"
          u"         sim:F?seed=1, replay:FILE?speed=4 (if it is damaged: exit code 1 without --partial)\n"
          u"F: %1\n\n"_s.arg(familyKeys(u" or "_s));
    for (const auto &command : m_commands)
        text += u"  %1 %2\n"_s.arg(command->usage().leftJustified(kUsageWidth), command->help());
    text += u"\nOptions of every command:\n"_s;
    for (const GeneralOption &option : kGeneralOptions) {
        text += u"  --%1 %2\n"_s.arg(
            (QLatin1String(option.name) + u' ' + QLatin1String(option.value)).leftJustified(18),
            QLatin1String(option.help));
    }
    text += u"\ngimbalctl COMMAND --help tells more of one.\n"
            u"Exit codes: 0 done, 1 the board or the link said no, 2 wrong arguments.\n"_s;
    return text;
}

int Ctl::say(const QString &text)
{
    m_out << text;
    return flushed() ? Done : Refused;
}

int Ctl::wrong(const QString &message)
{
    m_err << "gimbalctl: " << message << "\n(gimbalctl --help lists commands and options)\n";
    m_err.flush();
    return WrongArguments;
}

Command *Ctl::findCommand(const QString &name) const
{
    const auto it = std::find_if(m_commands.begin(), m_commands.end(), [&name](const auto &command) {
        return name == QLatin1String(command->name());
    });
    return it == m_commands.end() ? nullptr : it->get();
}

// The options of all commands at once: only with them can the command be told from the values of options.
void Ctl::addOptions(QCommandLineParser &parser) const
{
    parser.addOption(QCommandLineOption(QStringList{u"h"_s, u"help"_s}));
    for (const GeneralOption &option : kGeneralOptions)
        parser.addOption(QCommandLineOption(QLatin1String(option.name), {},
                                            QString(QLatin1String(option.value)).toLower()));
    QStringList known;
    for (const auto &command : m_commands) {
        for (const CommandOption &option : command->options()) {
            if (known.contains(option.name))
                continue;
            known.append(option.name);
            parser.addOption(QCommandLineOption(option.name, {}, option.value.toLower()));
        }
    }
}

// Finds the command among the words, and gives it its options. Empty, or the exit code.
std::optional<int> Ctl::takeCommand(const QCommandLineParser &parser)
{
    QStringList words = parser.positionalArguments();
    const QString name = words.isEmpty() ? QString() : words.takeFirst();
    m_command = findCommand(name);
    if (!m_command && !parser.unknownOptionNames().isEmpty())
        return wrong(parser.errorText());
    if (parser.isSet(u"help"_s) && name.isEmpty())
        return say(helpText());
    if (parser.isSet(u"version"_s))
        return say(u"gimbalctl " GIMBAL_VERSION "\n"_s);
    if (name.isEmpty())
        return wrong(u"no command"_s);
    if (!m_command)
        return wrong(u"there is no command '%1'"_s.arg(name));
    if (parser.isSet(u"help"_s))
        return say(m_command->fullHelp());
    m_context.arguments = words;
    m_context.json = parser.isSet(u"json"_s);
    if (parser.isSet(u"history"_s))
        m_context.history = BoardHistory(parser.value(u"history"_s));
    m_board = parser.value(u"board"_s);
    m_context.isBoardSaid = !m_board.isEmpty();
    if (const auto taken = takeOptions(parser); !taken)
        return wrong(taken.error().detail);
    QString problem = m_command->wordMistake();
    if (problem.isEmpty())
        problem = m_command->check();
    if (!problem.isEmpty())
        return wrong(problem + u"\nusage: gimbalctl "_s + m_command->usage());
    return {};
}

Result<void> Ctl::takeOptions(const QCommandLineParser &parser)
{
    QStringList given = parser.optionNames() + parser.unknownOptionNames();
    for (const GeneralOption &option : kGeneralOptions) {
        const QString name = QLatin1String(option.name);
        given.removeAll(name);
        if (*option.value && !option.repeats && parser.values(name).size() > 1)
            return failure(ErrorCode::InvalidArgument, u"--%1 is given twice"_s.arg(name));
    }
    for (const QString &reaction : parser.values(u"alarm"_s)) {
        if (const auto taken = takeReaction(m_context.rules, reaction); !taken)
            return taken;
    }
    m_partial = parser.isSet(u"partial"_s);
    QStringList takes;
    for (const CommandOption &option : m_command->options()) {
        takes.append(u"--"_s + option.name + (option.value.isEmpty() ? QString() : u' ' + option.value));
        if (given.removeAll(option.name) == 0)
            continue;
        const QStringList values
            = option.value.isEmpty() ? QStringList{QString()} : parser.values(option.name);
        if (values.size() > 1 && !option.repeats)
            return failure(ErrorCode::InvalidArgument, u"--%1 is given twice"_s.arg(option.name));
        for (const QString &value : values) {
            if (const auto taken = option.take(value); !taken)
                return taken;
        }
    }
    if (parser.value(u"link"_s).startsWith(u"replay:"_s))  // parts may be missing from any answer then
        given.removeAll(u"partial"_s);
    if (given.isEmpty())
        return {};
    for (const GeneralOption &option : kGeneralOptions)
        takes.append(u"--"_s + QLatin1String(option.name));
    return failure(ErrorCode::InvalidArgument,
                   u"%1 has no option '--%2'; it takes %3"_s.arg(QLatin1String(m_command->name()),
                                                                 given.first(), takes.join(u", "_s)));
}

std::optional<int> Ctl::start(const QStringList &arguments)
{
    QCommandLineParser parser;
    addOptions(parser);
    if (!parser.parse(arguments) && parser.unknownOptionNames().isEmpty())
        return wrong(parser.errorText());
    if (const auto code = takeCommand(parser))
        return code;
    connect(m_command, &Command::finished, this, &Ctl::finish);
    connect(m_command, &Command::failed, this, &Ctl::onError);
    connect(m_command, &Command::told, this, &Ctl::onTold);
    if (!m_context.json)
        connect(m_command, &Command::shown, this, [this](const QString &line) { m_live.show(line); });
    if (!m_command->needsBoard()) {
        QMetaObject::invokeMethod(m_command, &Command::startWithoutBoard, Qt::QueuedConnection);
        return {};
    }
    if (!parser.isSet(u"link"_s))
        return wrong(u"%1 needs --link ADDRESS"_s.arg(QLatin1String(m_command->name())));
    const QString family = parser.value(u"family"_s);
    // Without one, the search finds out which family answers.
    if (parser.isSet(u"family"_s)
        && std::none_of(m_context.families.begin(), m_context.families.end(),
                        [&family](const Family &each) { return each.key == family; })) {
        return wrong(u"there is no family '%1'; there are: %2"_s.arg(family, familyKeys(u", "_s)));
    }
    return connectToBoard(parser.value(u"link"_s), family);
}

std::optional<int> Ctl::connectToBoard(const QString &link, const QString &family)
{
    const auto address = LinkAddress::parse(link);
    if (!address)
        return wrong(address.error().detail);
    // A simulator or recording is checked in full before anything starts.
    if (address->kind() == LinkAddress::Kind::Simulator || address->isReplay()) {
        const auto transport = m_links.transports(*address);
        if (!transport) {
            if (transport.error().code != ErrorCode::BadFile)
                return wrong(transport.error().detail);
            QMetaObject::invokeMethod(
                this, [this, error = transport.error()] { onError(error, Refused); }, Qt::QueuedConnection);
            return {};
        }
        if (Replay *replay = (*transport)->replay())
            m_leftOut = replay->state().gaps;
    }
    m_client = std::make_unique<DeviceClient>(m_links.transports, m_context.families);
    connect(m_client.get(), &DeviceClient::stateChanged, this, &Ctl::onState);
    connect(m_client.get(), &DeviceClient::connectionFailed, this,
            [this](const Error &error) { onError(error, Refused); });
    connect(m_client.get(), &DeviceClient::connectionLost, this, [this](const Error &error) {
        if (!m_started || !(m_command->reportsLoss() || m_command->endsWith(error)))
            onError(error, Refused);
    });
    connect(m_client.get(), &DeviceClient::progressChanged, this, &Ctl::onProgress);
    connect(m_client.get(), &DeviceClient::boardSpoke, this,
            [this](const QString &text) { onTold(u"the board says: "_s + text); });
    connect(m_client.get(), &DeviceClient::alarmChanged, this, [this](const AlarmReport &report) {
        // What became of a stop is told even when what it was for is over.
        const bool wasOpen = m_unprovenStops.remove(report.number);
        if (report.outcome == AlarmOutcome::Acting
            || (report.isOver && !(wasOpen && report.outcome == AlarmOutcome::Done)))
            return;
        if (report.outcome == AlarmOutcome::NotProven)
            m_unprovenStops.insert(report.number);
        const QString text = describe(report, m_client->device()->parameters().get()).oneLine();
        m_alarms.append(text);
        m_wasMovedUnwanted |= report.alarm.isUnwantedMotion();
        onTold(u"alarm: "_s + text);
    });
    auto *watcher = new SignalWatcher(this);
    connect(watcher, &SignalWatcher::stopRequested, this, &Ctl::stop);
    m_client->setSupervisorRules(m_context.rules);
    m_command->prepare(*m_client);
    m_client->connectTo(*address, family);
    return {};
}

// Ctrl-C: whatever moves is stopped before the program goes.
void Ctl::stop()
{
    if (m_finished)
        return;
    if (m_started)
        m_command->stop();
    else
        onError({ErrorCode::Cancelled, {}, 0}, Refused);
}

void Ctl::onState(DeviceClient::State state)
{
    if (state != DeviceClient::State::Connected || m_started)
        return;
    if (const auto known = knowBoard(); !known) {
        onError(known.error(), known.error().code == ErrorCode::InvalidArgument ? WrongArguments : Refused);
        return;
    }
    m_started = true;
    m_flies = m_client->device()->flight();
    m_command->start(*m_client);
}

// Boards without a serial number may look the same. Nothing is asked here: what is not said is told.
Result<void> Ctl::knowBoard()
{
    const BoardIdentity &identity = m_client->identity();
    BoardHistory &history = m_context.history;
    if (m_client->address().isReplay())
        return {};
    if (const QString left = identity.extra.value(u"streams.left"_s).toString(); !left.isEmpty())
        onTold(u"the board sends data that an earlier program has left on and that could not be stopped: %1; "
               "switch it off and on again"_s.arg(left));
    if (const auto names = history.checkNames(); !names)
        onTold(describe(names.error()).oneLine());
    const auto known = history.meet(identity);
    if (!m_board.isEmpty())
        return history.choose(identity, m_board);
    const QStringList names = history.names(identity);
    if (known == BoardHistory::Acquaintance::Ambiguous) {
        onTold(u"boards that look like this one are known: %1; say which it is with --board NAME. "
               "Until then its snapshots are kept apart"_s.arg(names.join(u", "_s)));
    } else if (known == BoardHistory::Acquaintance::Unnamed
               && !(names.isEmpty() && history.snapshots(identity.serial).isEmpty())) {
        onTold(u"this board has no serial number%1; name it once with --board NAME, so that it shares its "
               "snapshots with no other"_s.arg(
                   names.isEmpty() ? QString() : u" and looks like none of "_s + names.join(u", "_s)));
    }
    m_isNameless = known == BoardHistory::Acquaintance::Unnamed && names.isEmpty()
        && history.snapshots(identity.serial).isEmpty();
    return {};
}

void Ctl::onTold(const QString &line)
{
    m_live.clear();
    m_err << line << "\n";
    m_err.flush();
}

void Ctl::onError(const Error &error, int exitCode)
{
    if (m_finished)
        return;
    m_finished = true;
    m_live.clear();
    if (!m_leftOut.isEmpty())
        m_err << leftOutText(m_leftOut) << "\n";
    const QString open = m_command->leftOpen(error);
    m_err << "gimbalctl: " << consoleText(error, m_flies).oneLine() << "\n";
    if (!open.isEmpty())
        m_err << open << "\n";
    m_err.flush();
    if (m_context.json) {
        QJsonObject json = errorJson(error, m_flies);
        if (!open.isEmpty())
            json.insert(u"open"_s, open);
        m_out << toJsonText(withAlarms(json));
        m_out.flush();
    }
    emit finished(exitCode);
}

// What nobody could read was not told.
bool Ctl::flushed()
{
    errno = 0;
    m_out.flush();
    if (m_out.status() == QTextStream::Ok)
        return true;
    const Error error = outputError(errno);
    m_err << "gimbalctl: " << consoleText(error).oneLine() << "\n";
    m_err.flush();
    return false;
}

// What was told while it ran; a bare list has no place for it.
QJsonValue Ctl::withAlarms(const QJsonValue &json) const
{
    if (m_alarms.isEmpty() || !json.isObject())
        return json;
    QJsonObject object = json.toObject();
    object.insert(u"alarms"_s, m_alarms);
    return object;
}

void Ctl::onProgress(const Progress &progress)
{
    QString text = describe(progress);
    if (progress.step == u"autotune"_s) {
        text = u"iteration %1: "_s.arg(progress.done);
        for (const Axis axis : kAxes) {
            const QString name = QLatin1String(axisKey(axis));
            text += u" %1 P %2 I %3 D %4 error %5°"_s.arg(name)
                        .arg(progress.values.value(u"p."_s + name))
                        .arg(progress.values.value(u"i."_s + name))
                        .arg(progress.values.value(u"d."_s + name))
                        .arg(progress.values.value(u"error."_s + name), 0, 'f', 2);
        }
    }
    if (progress.step == u"firmware-upload"_s && progress.total > 0)
        text += u", %1 %"_s.arg(10 * (10 * progress.done / progress.total));
    if (text == m_lastProgress || progress.step == u"read-block"_s)
        return;
    m_lastProgress = text;
    onTold(text);
}

void Ctl::finish(const Result<CommandOutcome> &outcome)
{
    if (m_finished)
        return;
    if (!outcome) {
        const ErrorCode code = outcome.error().code;
        onError(outcome.error(),
                code == ErrorCode::InvalidArgument || code == ErrorCode::OutOfRange ? WrongArguments
                                                                                    : Refused);
        return;
    }
    m_finished = true;
    m_live.clear();
    m_err.flush();
    CommandOutcome whole = *outcome;
    reportLeftOut(whole, m_leftOut, m_partial);
    if (m_wasMovedUnwanted && m_command->moves() && whole.exitCode == Done)
        whole.exitCode = Refused;
    if (!whole.note.isEmpty())
        onTold(whole.note);
    if (m_isNameless && !whole.json.toObject().value(u"snapshot"_s).toString().isEmpty())
        onTold(
            u"this board has no serial number, and boards that look like it share this history; name it once "
            "with --board NAME"_s);
    if (m_context.json)
        m_out << toJsonText(withAlarms(whole.json));
    else
        m_out << whole.text;
    emit finished(flushed() ? whole.exitCode : Refused);
}
