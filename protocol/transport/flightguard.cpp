// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/transport/flightguard.h"

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QHostInfo>
#include <QSocketNotifier>
#include <QTimer>
#include <QUdpSocket>

#include <csignal>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace {

constexpr int kNotNeeded = 0;
constexpr int kWrongArguments = 2;
constexpr int kHasStopped = 3;
constexpr std::size_t kRead = 64;

/// Waits for the end of the program, then stops.
class Watch final : public QObject
{
public:
    Watch(const QHostAddress &host, quint16 port, QByteArray stop)
        : m_host(host)
        , m_port(port)
        , m_stop(std::move(stop))
        , m_input(STDIN_FILENO, QSocketNotifier::Read)
    {
        connect(&m_input, &QSocketNotifier::activated, this, &Watch::read);
        m_silence.setSingleShot(true);
        m_silence.setInterval(FlightGuard::kSilence);
        connect(&m_silence, &QTimer::timeout, this, &Watch::act);
        m_silence.start();
        m_send.setInterval(FlightGuard::kPeriod);
        m_send.setTimerType(Qt::PreciseTimer);
        connect(&m_send, &QTimer::timeout, this, &Watch::send);
    }

private:
    void read()
    {
        std::array<char, kRead> heard{};
        const ssize_t count = ::read(STDIN_FILENO, heard.data(), heard.size());
        if (count <= 0)
            act();
        else if (QByteArrayView(heard.data(), count).contains(FlightGuard::kLeave))
            QCoreApplication::exit(kNotNeeded);
        else
            m_silence.start();
    }
    void act()
    {
        m_input.setEnabled(false);
        m_silence.stop();
        m_since.start();
        m_send.start();
        send();
    }
    void send()
    {
        m_socket.writeDatagram(m_stop, m_host, m_port);
        if (m_since.elapsed() > milliseconds(FlightGuard::kStops).count())
            QCoreApplication::exit(kHasStopped);
    }

    QHostAddress m_host;
    quint16 m_port;
    QByteArray m_stop;
    QSocketNotifier m_input;
    QTimer m_silence;
    QTimer m_send;
    QElapsedTimer m_since;
    QUdpSocket m_socket;
};

}  // namespace

int FlightGuard::run(const QStringList &arguments)
{
    const QByteArray stop = QByteArray::fromHex(arguments.value(2).toLatin1());
    const quint16 port = arguments.value(1).toUShort();
    const QHostInfo host = QHostInfo::fromName(arguments.value(0));
    if (arguments.size() != 3 || port == 0 || stop.isEmpty() || host.addresses().isEmpty())
        return kWrongArguments;
    // It outlives the terminal that both were started from.
    for (const int number : {SIGINT, SIGHUP, SIGTERM, SIGPIPE})
        std::signal(number, SIG_IGN);
    const Watch watch(host.addresses().first(), port, stop);
    return QCoreApplication::exec();
}

FlightGuardian::FlightGuardian(QObject *parent)
    : QObject(parent)
{
}

// Without a word: whoever dies with something armed wants it to act.
FlightGuardian::~FlightGuardian()
{
    if (!m_process || m_process->state() == QProcess::NotRunning)
        return;
    m_process->disconnect(this);
    // What is left of it ends by itself.
    m_process->setParent(nullptr);
    connect(m_process, &QProcess::finished, m_process, &QObject::deleteLater);
    m_process->closeWriteChannel();
}

void FlightGuardian::start(const QString &host, quint16 port, const QByteArray &stop)
{
    leave();
    m_process = new QProcess(this);
    m_process->setProgram(QDir(QCoreApplication::applicationDirPath()).filePath(u"gimbalguard"_s));
    m_process->setArguments({host, QString::number(port), QString::fromLatin1(stop.toHex())});
    m_process->setStandardOutputFile(QProcess::nullDevice());
    m_process->setStandardErrorFile(QProcess::nullDevice());
    connect(m_process, &QProcess::errorOccurred, this, [this] { emit lost(); });
    connect(m_process, &QProcess::finished, this, [this] { emit lost(); });
    m_process->start(QIODevice::WriteOnly);
}

void FlightGuardian::tell()
{
    if (m_process)
        m_process->write(&FlightGuard::kAlive, 1);
}

void FlightGuardian::leave()
{
    if (!m_process)
        return;
    QProcess *process = std::exchange(m_process, nullptr);
    process->disconnect(this);
    if (process->state() == QProcess::NotRunning) {
        process->deleteLater();
        return;
    }
    connect(process, &QProcess::finished, process, &QObject::deleteLater);
    process->write(&FlightGuard::kLeave, 1);
    process->closeWriteChannel();
}

bool FlightGuardian::isWatching() const
{
    return m_process && m_process->state() == QProcess::Running;
}
