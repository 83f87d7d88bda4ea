// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/signalwatcher.h"
#include "protocol/simulator/hosts.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QSocketNotifier>
#include <QTextStream>

#include <array>
#include <csignal>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace {

constexpr int kWrongArguments = 2;
constexpr int kRefused = 1;

int wrong(const QString &message, int code = kWrongArguments)
{
    QTextStream(stderr) << "gimbalsim: " << message << "\n";
    return code;
}

QString helpText()
{
    return u"gimbalsim --family F (--pty PATH | --tcp PORT) [options]\n\n"
           u"A simulated gimbal for other programs. Prints \"ready ADDRESS\" and runs until it is told to "
           u"end.\n"
           u"Lines NAME=VALUE on standard input change the world while it runs: pose=1, shake=3, unplug=0.\n"
           u"The line \"streams\" is answered with how many stream frames were sent and how many skipped.\n\n"
           u"  --family F        simplebgc or storm32\n"
           u"  --pty PATH        a pseudo-terminal, reachable at PATH (a symbolic link)\n"
           u"  --tcp PORT        a TCP server on 127.0.0.1, 0 = any free port\n"
           u"  --seed N          another gimbal: noise, bias, hand; same seed, same behaviour\n"
           u"  --firmware V      simplebgc: 2.59 (default), 2.40 ... 2.73.8; storm32: 0.79, 0.90, 0.96 "
           u"(default)\n"
           u"  --strict 1        storm32: refuse frames that the real firmware lets pass, to test a client\n"
           u"  --board N         board version times ten, default 30 (simplebgc)\n"
           u"  --rate BAUD       behave like a UART of that rate; without it, like native USB (not "
           u"throttled)\n"
           u"  --parity P        none or even. Firmware 2.40 knows only even, later ones take both.\n"
           u"                    Linux pseudo-terminals carry no parity: there it changes the timing only\n"
           u"  --fault NAME=V    repeatable:\n                      "_s
        + Faults::help().join(u"\n                      "_s) + u"\n"_s;
}

}  // namespace

int main(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    const QCommandLineOption family(u"family"_s, {}, u"family"_s);
    const QCommandLineOption pty(u"pty"_s, {}, u"path"_s);
    const QCommandLineOption tcp(u"tcp"_s, {}, u"port"_s);
    const QCommandLineOption fault(u"fault"_s, {}, u"fault"_s);
    const QCommandLineOption help(QStringList{u"h"_s, u"help"_s});
    parser.addOptions({family, pty, tcp, fault, help});
    const QStringList setupNames{u"seed"_s, u"firmware"_s, u"board"_s, u"rate"_s, u"parity"_s, u"strict"_s};
    for (const QString &name : setupNames)
        parser.addOption(QCommandLineOption(name, {}, u"value"_s));
    if (!parser.parse(application.arguments()))
        return wrong(parser.errorText());
    if (parser.isSet(help)) {
        QTextStream(stdout) << helpText();
        return 0;
    }
    if (!parser.positionalArguments().isEmpty())
        return wrong(
            u"'%1' is not understood (gimbalsim --help)"_s.arg(parser.positionalArguments().first()));
    if (!parser.isSet(family))
        return wrong(u"which gimbal? --family simplebgc or storm32"_s);
    if (parser.isSet(pty) == parser.isSet(tcp))
        return wrong(u"where? one of --pty PATH and --tcp PORT"_s);

    QMap<QString, QString> options;
    for (const QString &name : setupNames) {
        if (parser.isSet(name))
            options.insert(name, parser.value(name));
    }
    if (options.contains(u"parity"_s) && !options.contains(u"rate"_s))
        return wrong(u"--parity is for a UART: give --rate as well"_s);
    const auto setup = parseSimulatorSetup(parser.value(family), options, parser.values(fault));
    if (!setup)
        return wrong(setup.error().detail);
    auto board = makeSimulatedBoard(parser.value(family), setup->options);
    if (!board)
        return wrong(board.error().detail);
    auto port = std::make_unique<SimulatedPort>(std::move(*board), setup->options, setup->line);

    std::unique_ptr<SimulatorHost> host;
    if (parser.isSet(pty)) {
        host = std::make_unique<PtyHost>(std::move(port), parser.value(pty));
    } else {
        bool ok = false;
        const uint number = parser.value(tcp).toUInt(&ok);
        if (!ok || number > 65535)
            return wrong(u"--tcp needs a port from 0 to 65535, not '%1'"_s.arg(parser.value(tcp)));
        host = std::make_unique<TcpHost>(std::move(port), quint16(number));
    }
    if (const auto started = host->start(); !started)
        return wrong(started.error().detail, kRefused);
    // In the background of a shell, reading the terminal must fail instead of stopping the program.
    std::signal(SIGTTIN, SIG_IGN);
    QSocketNotifier input(STDIN_FILENO, QSocketNotifier::Read);
    QByteArray typed;
    QObject::connect(&input, &QSocketNotifier::activated, &application, [&] {
        std::array<char, 512> buffer{};
        const ssize_t count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
        if (count <= 0) {
            input.setEnabled(false);
            return;
        }
        typed.append(buffer.data(), count);
        for (qsizetype end = typed.indexOf('\n'); end >= 0; end = typed.indexOf('\n')) {
            const QString line = QString::fromUtf8(typed.first(end)).trimmed();
            typed.remove(0, end + 1);
            if (line.isEmpty())
                continue;
            if (line == u"streams"_s) {
                const SimulatedBoard::StreamCount streams = host->port().board().streamCount();
                QTextStream(stdout) << "streams sent " << streams.sent << " skipped " << streams.skipped
                                    << "\n";
                continue;
            }
            if (const auto changed = host->port().change(line); !changed)
                QTextStream(stderr) << "gimbalsim: " << changed.error().detail << "\n";
        }
    });
    SignalWatcher watcher;
    QObject::connect(&watcher, &SignalWatcher::stopRequested, &application, &QCoreApplication::quit);
    {
        QTextStream out(stdout);
        out << "ready " << host->address() << "\n";
    }
    return QCoreApplication::exec();
}
