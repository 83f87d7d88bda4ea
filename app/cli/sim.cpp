// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sim.h"

#include "app/cli/signalwatcher.h"
#include "protocol/simulator/link/ptyhost.h"
#include "protocol/simulator/link/simulatorsetup.h"
#include "protocol/simulator/link/tcphost.h"
#include "protocol/simulator/link/udphost.h"

#include <QCommandLineParser>
#include <QTextStream>

#include <array>
#include <csignal>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace {

constexpr int kWrongArguments = 2;
constexpr int kRefused = 1;
constexpr int kHelpIndent = 20;

using Port = std::unique_ptr<SimulatedPort>;

/// A way to offer a simulated board, and the option that selects it.
struct HostKind
{
    const char *option;
    LinkAddress::Kind link;
    Result<std::unique_ptr<SimulatorHost>> (*make)(Port port, const QString &place);
};

template <typename Host>
Result<std::unique_ptr<SimulatorHost>> makeNetworkHost(Port port, const QString &place)
{
    bool ok = false;
    const uint number = place.toUInt(&ok);
    if (!ok || number > 65535)
        return failure(ErrorCode::InvalidArgument, u"needs a port from 0 to 65535, not '%1'"_s.arg(place));
    return std::make_unique<Host>(std::move(port), quint16(number));
}

Result<std::unique_ptr<SimulatorHost>> makePtyHost(Port port, const QString &place)
{
    return std::make_unique<PtyHost>(std::move(port), place);
}

constexpr std::array kHostKinds{HostKind{"pty", LinkAddress::Kind::Serial, makePtyHost},
                                HostKind{"tcp", LinkAddress::Kind::Tcp, makeNetworkHost<TcpHost>},
                                HostKind{"udp", LinkAddress::Kind::Udp, makeNetworkHost<UdpHost>}};

int wrong(const QString &message, int code = kWrongArguments)
{
    QTextStream(stderr) << "gimbalsim: " << message << "\n";
    return code;
}

QString helpLines(const QString &option, const QStringList &lines)
{
    return (u"  --"_s + option).leftJustified(kHelpIndent) + lines.join(u'\n' + QString(kHelpIndent, u' '))
        + u'\n';
}

/// The option by which the board is to be offered; null unless there is exactly one. TCP may come beside UDP.
const HostKind *chosenHost(const QCommandLineParser &parser)
{
    const HostKind *chosen = nullptr;
    for (const HostKind &kind : kHostKinds) {
        const bool isBeside = kind.link == LinkAddress::Kind::Tcp && parser.isSet(u"udp"_s);
        if (!parser.isSet(QLatin1String(kind.option)) || isBeside)
            continue;
        if (chosen)
            return nullptr;
        chosen = &kind;
    }
    return chosen;
}

QString hostsOf(const SimulatedFamily &family)
{
    QStringList names;
    for (const HostKind &kind : kHostKinds) {
        if (family.links.contains(kind.link))
            names.append(u"--"_s + QLatin1String(kind.option));
    }
    return names.join(u", "_s);
}

}  // namespace

Sim::Sim(QList<SimulatedFamily> families, QObject *parent)
    : QObject(parent)
    , m_families(std::move(families))
{
}

QStringList Sim::keys() const
{
    QStringList keys;
    for (const SimulatedFamily &family : m_families)
        keys.append(family.key);
    return keys;
}

// What is the same for all families is printed once.
QString Sim::optionsText() const
{
    QStringList names;
    QMap<QString, QString> headings;
    QMap<QString, QMap<QString, QStringList>> helps;  // by option and family
    for (const SimulatedFamily &family : m_families) {
        for (const SimulatedOption &option : simulatedOptions(family)) {
            if (!names.contains(option.name))
                names.append(option.name);
            headings.insert(option.name, option.name + u' ' + option.value);
            helps[option.name].insert(family.key, option.help);
        }
    }
    QString text;
    for (const QString &name : std::as_const(names)) {
        const auto &help = helps[name];
        const bool same = help.size() == m_families.size()
            && std::all_of(help.begin(), help.end(),
                           [&help](const QStringList &lines) { return lines == help.first(); });
        QStringList lines = same ? help.first() : QStringList();
        for (auto it = help.begin(); it != help.end() && !same; ++it)
            lines += it.key() + u": "_s + it->join(u'\n' + QString(kHelpIndent, u' '));
        text += helpLines(headings.value(name), lines);
    }
    return text;
}

QString Sim::helpText() const
{
    return u"gimbalsim --family F (--pty PATH | --tcp PORT | --udp PORT [--tcp PORT]) [options]\n\n"
           u"A simulated gimbal for other programs. Prints \"ready ADDRESS\" and runs until it is told to "
           u"end.\n"
           u"Lines NAME=VALUE on standard input change the world while it runs: pose=1, shake=3, unplug=0.\n"
           u"The line \"streams\" is answered with how many stream frames were sent and how many skipped."
           u"\n\n"_s
        + helpLines(u"family F"_s, {keys().join(u" or "_s)})
        + helpLines(u"pty PATH"_s, {u"a pseudo-terminal, reachable at PATH (a symbolic link)"_s})
        + helpLines(u"tcp PORT"_s, {u"a TCP server on 127.0.0.1, 0 = any free port"_s})
        + helpLines(u"udp PORT"_s, {u"the same for boards that work in datagrams"_s})
        + helpLines(u"video PORT"_s,
                    {u"what its camera sees as video on that UDP port of 127.0.0.1, 0 = any free one;"_s,
                     u"to whoever writes to it"_s})
        + optionsText() + helpLines(u"fault NAME=V"_s, QStringList{u"repeatable:"_s} + Faults::help());
}

Result<std::unique_ptr<SimulatedPort>> Sim::makePort(const SimulatedFamily &family,
                                                     const QCommandLineParser &parser) const
{
    QMap<QString, QString> options;
    for (const SimulatedFamily &each : m_families) {
        for (const SimulatedOption &option : simulatedOptions(each)) {
            if (parser.isSet(option.name))
                options.insert(option.name, parser.value(option.name));
        }
    }
    if (options.contains(u"parity"_s) && !options.contains(u"rate"_s))
        return failure(ErrorCode::InvalidArgument, u"--parity is for a UART: give --rate as well"_s);
    const auto setup = parseSimulatorSetup(family, options, parser.values(u"fault"_s));
    if (!setup)
        return tl::unexpected(setup.error());
    return std::make_unique<SimulatedPort>(family.makeBoard(setup->options), setup->options, setup->line());
}

std::optional<int> Sim::start(const QStringList &arguments)
{
    QCommandLineParser parser;
    const QCommandLineOption help(QStringList{u"h"_s, u"help"_s});
    parser.addOption(help);
    QStringList names{u"family"_s, u"fault"_s, u"video"_s};
    for (const HostKind &kind : kHostKinds)
        names.append(QLatin1String(kind.option));
    for (const SimulatedFamily &family : std::as_const(m_families)) {
        for (const SimulatedOption &option : simulatedOptions(family))
            names.append(option.name);
    }
    names.removeDuplicates();
    for (const QString &name : std::as_const(names))
        parser.addOption(QCommandLineOption(name, {}, u"value"_s));
    if (!parser.parse(arguments))
        return wrong(parser.errorText());
    if (parser.isSet(help)) {
        QTextStream(stdout) << helpText();
        return 0;
    }
    for (const QString &name : std::as_const(names)) {
        if (name != u"fault"_s && parser.values(name).size() > 1)
            return wrong(u"--%1 is given twice"_s.arg(name));
    }
    if (!parser.positionalArguments().isEmpty())
        return wrong(
            u"'%1' is not understood (gimbalsim --help)"_s.arg(parser.positionalArguments().first()));
    if (!parser.isSet(u"family"_s))
        return wrong(u"which gimbal? --family %1 (gimbalsim --help)"_s.arg(keys().join(u" or "_s)));
    const HostKind *kind = chosenHost(parser);
    if (!kind)
        return wrong(u"where? one of --pty PATH, --tcp PORT and --udp PORT (gimbalsim --help)"_s);
    const auto family = findSimulatedFamily(m_families, parser.value(u"family"_s));
    if (!family)
        return wrong(family.error().detail);
    const QString option = QLatin1String(kind->option);
    if (!family->links.contains(kind->link))
        return wrong(
            u"a %1 cannot be reached by --%2; there are: %3"_s.arg(family->key, option, hostsOf(*family)));
    auto port = makePort(*family, parser);
    if (!port)
        return wrong(port.error().detail);
    auto host = kind->make(std::move(*port), parser.value(option));
    if (!host)
        return wrong(u"--%1 %2"_s.arg(option, host.error().detail));
    m_host = std::move(*host);
    if (auto *udp = dynamic_cast<UdpHost *>(m_host.get()); udp && parser.isSet(u"tcp"_s)) {
        const auto number = wholeNumber(u"tcp"_s, parser.value(u"tcp"_s), 0, 65535);
        if (!number || !family->links.contains(LinkAddress::Kind::Tcp))
            return wrong(number ? u"a %1 cannot be reached by --tcp"_s.arg(family->key)
                                : number.error().detail);
        udp->offerTcp(quint16(*number));
    }
    if (parser.isSet(u"video"_s)) {
        if (const auto offered = offerVideo(parser.value(u"video"_s)); !offered)
            return wrong(offered.error().detail,
                         offered.error().code == ErrorCode::InvalidArgument ? kWrongArguments : kRefused);
    }
    if (const auto started = m_host->start(); !started)
        return wrong(started.error().detail, kRefused);
    listenToCommands();
    QTextStream(stdout) << "ready " << m_host->address() << "\n";
    if (const auto *udp = dynamic_cast<UdpHost *>(m_host.get()); udp && udp->tcpPort() != 0)
        QTextStream(stdout) << "tcp 127.0.0.1:" << udp->tcpPort() << "\n";
    if (m_camera)
        QTextStream(stdout) << "video 127.0.0.1:" << m_camera->port() << "\n";
    if (m_camera && m_camera->isWithoutH264())
        QTextStream(stderr) << "gimbalsim: libav has no encoder for H.264 (libx264): JPEGs are sent\n";
    return {};
}

Result<void> Sim::offerVideo(const QString &port)
{
    const auto number = wholeNumber(u"video"_s, port, 0, 65535);
    if (!number)
        return tl::unexpected(number.error());
    if (!m_host->port().board().cameraView())
        return failure(ErrorCode::InvalidArgument, u"--video: this board has no camera"_s);
    const auto feed = std::make_shared<CameraFeed>();
    m_camera = std::make_unique<CameraServer>(feed);
    m_host->setCameraFeed(feed);
    return m_camera->start(quint16(*number));
}

void Sim::listenToCommands()
{
    // In the background of a shell, reading the terminal must fail instead of stopping the program.
    std::signal(SIGTTIN, SIG_IGN);
    m_input = std::make_unique<QSocketNotifier>(STDIN_FILENO, QSocketNotifier::Read);
    connect(m_input.get(), &QSocketNotifier::activated, this, &Sim::onTyped);
    auto *watcher = new SignalWatcher(this);
    connect(watcher, &SignalWatcher::stopRequested, this, &Sim::finished);
}

void Sim::onTyped()
{
    std::array<char, 512> buffer{};
    const ssize_t count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
    if (count <= 0) {
        m_input->setEnabled(false);
        return;
    }
    m_typed.append(buffer.data(), count);
    for (qsizetype end = m_typed.indexOf('\n'); end >= 0; end = m_typed.indexOf('\n')) {
        const QString line = QString::fromUtf8(m_typed.first(end)).trimmed();
        m_typed.remove(0, end + 1);
        if (!line.isEmpty())
            onCommand(line);
    }
}

void Sim::onCommand(const QString &line)
{
    if (line == u"streams"_s) {
        const SimulatedBoard::StreamCount streams = m_host->port().board().streamCount();
        QTextStream(stdout) << "streams sent " << streams.sent << " skipped " << streams.skipped << "\n";
        return;
    }
    if (const auto changed = m_host->port().change(line); !changed)
        QTextStream(stderr) << "gimbalsim: " << changed.error().detail << "\n";
}
