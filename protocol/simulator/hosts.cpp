// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/hosts.h"

#include <QFile>
#include <QFileInfo>
#include <QTcpServer>
#include <QTcpSocket>
#include <QThread>

#include <asm/termbits.h>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <mutex>
#include <sys/ioctl.h>
#include <tuple>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kTick = 2ms;
// After a pause of the whole machine the simulation does not try to catch up more than this.
constexpr qint64 kMostCatchUpNs = 500'000'000;
constexpr qsizetype kReadBuffer = 4096;
constexpr qsizetype kPtyBacklog = 4096;  // beside what the system keeps for a reader that is late

}  // namespace

SimulatorHost::SimulatorHost(std::unique_ptr<SimulatedPort> port, QObject *parent)
    : QObject(parent)
    , m_port(std::move(port))
    , m_timer(this)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(kTick);
    connect(&m_timer, &QTimer::timeout, this, &SimulatorHost::onTick);
}

Result<void> SimulatorHost::start()
{
    m_clock.start();
    m_timer.start();
    return {};
}

void SimulatorHost::onTick()
{
    poll();
    const qint64 elapsed = m_clock.nsecsElapsed();
    m_simulatedNs = std::max(m_simulatedNs, elapsed - kMostCatchUpNs);
    m_port->advance(std::chrono::nanoseconds(elapsed - m_simulatedNs));
    m_simulatedNs = elapsed;
    if (m_plugged != m_port->isPlugged()) {
        m_plugged = m_port->isPlugged();
        plugged(m_plugged);
    }
    if (const QByteArray bytes = m_port->hostReads(); !bytes.isEmpty())
        deliver(bytes);
}

PtyHost::PtyHost(std::unique_ptr<SimulatedPort> port, QString path, QObject *parent)
    : SimulatorHost(std::move(port), parent)
    , m_path(std::move(path))
{
}

PtyHost::~PtyHost()
{
    closeTerminal();
}

Result<void> PtyHost::start()
{
    const QFileInfo info(m_path);
    // A link left by a simulator that was killed may go; anything else at that path is somebody's.
    if (info.isSymLink() && !info.exists())
        QFile::remove(m_path);
    else if (info.exists() || info.isSymLink())
        return failure(ErrorCode::PortBusy, u"%1 exists already"_s.arg(m_path));
    if (auto opened = openTerminal(); !opened)
        return opened;
    return SimulatorHost::start();
}

Result<void> PtyHost::openTerminal()
{
    m_master = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    if (m_master < 0 || ::grantpt(m_master) != 0 || ::unlockpt(m_master) != 0)
        return failure(ErrorCode::PortNotFound,
                       u"no pseudo-terminal: %1"_s.arg(QString::fromLocal8Bit(std::strerror(errno))));
    m_slave = QString::fromLocal8Bit(::ptsname(m_master));
    // Raw from the start: a client that only reads and writes must not see its bytes echoed.
    struct termios2 settings
    {
    };
    if (::ioctl(m_master, TCGETS2, &settings) == 0) {
        settings.c_iflag = 0;
        settings.c_oflag = 0;
        settings.c_lflag = 0;
        settings.c_cflag
            = (settings.c_cflag & ~static_cast<tcflag_t>(CSIZE | CBAUD)) | CS8 | CREAD | CLOCAL | B115200;
        ::ioctl(m_master, TCSETS2, &settings);
    }
    if (!QFile::link(m_slave, m_path)) {
        closeTerminal();
        return failure(ErrorCode::NoPermission, u"%1 cannot be made"_s.arg(m_path));
    }
    return {};
}

void PtyHost::closeTerminal()
{
    if (m_master < 0)
        return;
    if (QFileInfo(m_path).symLinkTarget() == m_slave)
        QFile::remove(m_path);
    ::close(m_master);
    m_master = -1;
    m_unsent.clear();
}

void PtyHost::poll()
{
    if (m_master < 0)
        return;
    drain();
    // The host's rate is seen through the terminal; its parity is not, Linux keeps none on pseudo-terminals.
    struct termios2 settings
    {
    };
    if (::ioctl(m_master, TCGETS2, &settings) == 0)
        port().setHostLine(
            LineSettings{int(settings.c_ospeed), port().board().onlyParity().value_or(Parity::None)});
    char buffer[kReadBuffer];
    for (;;) {
        const ssize_t count = ::read(m_master, buffer, sizeof buffer);
        if (count <= 0)
            break;  // nothing there, or nobody has the other end open
        hostWrote(QByteArrayView(buffer, count));
    }
}

void PtyHost::deliver(const QByteArray &bytes)
{
    if (m_master < 0)
        return;
    m_unsent += bytes;
    drain();
}

void PtyHost::drain()
{
    const ssize_t count
        = m_unsent.isEmpty() ? 0 : ::write(m_master, m_unsent.constData(), std::size_t(m_unsent.size()));
    if (count > 0)
        m_unsent.remove(0, count);
    // Nobody reads: on USB the board has to wait, which skips its streams; a UART does not wait, its bytes
    // are lost.
    port().setHostReady(m_unsent.size() < kPtyBacklog);
    if (m_unsent.size() > 2 * kPtyBacklog)
        m_unsent.truncate(kPtyBacklog);
}

void PtyHost::plugged(bool in)
{
    if (in)
        std::ignore = openTerminal();
    else
        closeTerminal();
}

TcpHost::TcpHost(std::unique_ptr<SimulatedPort> port, quint16 tcpPort, QObject *parent)
    : SimulatorHost(std::move(port), parent)
    , m_server(new QTcpServer(this))
    , m_tcpPort(tcpPort)
{
    connect(m_server, &QTcpServer::newConnection, this, &TcpHost::onConnection);
}

Result<void> TcpHost::start()
{
    if (!m_server->listen(QHostAddress::LocalHost, m_tcpPort))
        return failure(ErrorCode::PortBusy, u"TCP port %1: %2"_s.arg(m_tcpPort).arg(m_server->errorString()));
    m_tcpPort = m_server->serverPort();
    return SimulatorHost::start();
}

QString TcpHost::address() const
{
    return u"tcp://127.0.0.1:%1"_s.arg(m_tcpPort);
}

void TcpHost::onConnection()
{
    QTcpSocket *socket = m_server->nextPendingConnection();
    // The newest client wins, like at a serial bridge: the one before may be dead without our knowing.
    if (m_client)
        m_client->abort();
    m_client = socket;
    socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    connect(socket, &QTcpSocket::readyRead, this, [this, socket] { hostWrote(socket->readAll()); });
    connect(socket, &QTcpSocket::disconnected, this, [this, socket] {
        if (m_client == socket)
            m_client = nullptr;
        socket->deleteLater();
    });
}

void TcpHost::deliver(const QByteArray &bytes)
{
    if (!m_client)
        return;
    m_client->write(bytes);
    m_client->flush();
}

void TcpHost::plugged(bool in)
{
    if (in) {
        m_server->listen(QHostAddress::LocalHost, m_tcpPort);
        return;
    }
    m_server->close();
    if (m_client)
        m_client->abort();
}

// Versions of the simulated STorM32 board, each with its layout (errata 5).
Result<int> stormFirmware(const QString &text)
{
    for (const int known : {79, 90, 96}) {
        if (text == u"0.%1"_s.arg(known) || text == u"v0.%1"_s.arg(known))
            return known;
    }
    return failure(ErrorCode::InvalidArgument, u"firmware is 0.79, 0.90 or 0.96, not '%1'"_s.arg(text));
}

Result<SimulatorSetup> parseSimulatorSetup(const QString &family, const QMap<QString, QString> &options,
                                           const QStringList &faults)
{
    SimulatorSetup setup;
    const bool storm = family == u"storm32"_s;
    if (storm)
        setup.options.firmware = 96;
    const auto whole = [](const QString &name, const QString &text, int min, int max) -> Result<int> {
        bool ok = false;
        const int value = text.toInt(&ok);
        if (!ok || value < min || value > max) {
            return failure(
                ErrorCode::InvalidArgument,
                u"%1 needs a whole number from %2 to %3, not '%4'"_s.arg(name).arg(min).arg(max).arg(text));
        }
        return value;
    };
    std::optional<int> rate;
    Parity parity = Parity::None;
    for (auto it = options.begin(); it != options.end(); ++it) {
        if (it.key() == u"seed"_s) {
            const auto seed = whole(it.key(), it.value(), 0, 1'000'000'000);
            if (!seed)
                return tl::unexpected(seed.error());
            setup.options.seed = unsigned(*seed);
        } else if (storm && it.key() == u"firmware"_s) {
            const auto firmware = stormFirmware(it.value());
            if (!firmware)
                return tl::unexpected(firmware.error());
            setup.options.firmware = *firmware;
        } else if (storm && it.key() == u"strict"_s) {
            setup.options.strict = it.value() != u"0"_s;
        } else if (it.key() == u"firmware"_s) {
            bool ok = false;
            // "2.59" is 2590; "2.70b4" is 2704; "2.73.8" is 2738 (document BOARD_INFO).
            const QString digits = QString(it.value()).replace(u'b', u'.');
            const QStringList parts = digits.split(u'.');
            const int number
                = parts.value(0).toInt(&ok) * 1000 + parts.value(1).toInt() * 10 + parts.value(2).toInt();
            if (!ok || parts.size() < 2 || parts.value(1).size() != 2 || number < 2400 || number > 9999) {
                return failure(
                    ErrorCode::InvalidArgument,
                    u"firmware needs a version like 2.59, 2.70b4 or 2.73.8, not '%1'"_s.arg(it.value()));
            }
            setup.options.firmware = number;
        } else if (it.key() == u"board"_s && !storm) {
            const auto board = whole(it.key(), it.value(), 10, 99);
            if (!board)
                return tl::unexpected(board.error());
            setup.options.boardVersion = *board;
        } else if (it.key() == u"rate"_s) {
            const auto baud = whole(it.key(), it.value(), 1200, 4'000'000);
            if (!baud)
                return tl::unexpected(baud.error());
            rate = *baud;
        } else if (it.key() == u"parity"_s && !storm) {
            if (it.value() != u"none"_s && it.value() != u"even"_s) {
                return failure(ErrorCode::InvalidArgument,
                               u"parity is none or even, not '%1'"_s.arg(it.value()));
            }
            parity = it.value() == u"even"_s ? Parity::Even : Parity::None;
        } else if (it.key() != u"fault"_s) {
            return failure(ErrorCode::InvalidArgument,
                           u"there is no option '%1'; there are: %2"_s.arg(
                               it.key(),
                               storm ? u"seed, firmware, strict, rate, fault"_s
                                     : u"seed, firmware, board, rate, parity, fault"_s));
        }
    }
    for (const QString &fault : faults) {
        if (const auto set = setup.options.faults.set(fault); !set)
            return tl::unexpected(set.error());
    }
    if (rate)
        setup.line = LineSettings{*rate, parity};
    setup.options.usb = !rate;
    return setup;
}

namespace {

class SimulatorTransport;

/// The simulator end of the in-process pipe, on the simulator's own thread, so a busy I/O thread does not
/// slow it.
class PipeHost final : public SimulatorHost
{
public:
    using SimulatorHost::SimulatorHost;
    [[nodiscard]] QString address() const override { return u"sim:"_s; }

    /// Connects or disconnects the one who listens. False when the cable is out.
    bool attach(SimulatorTransport *transport);
    void write(const QByteArray &bytes) { hostWrote(bytes); }

protected:
    void deliver(const QByteArray &bytes) override;
    void plugged(bool in) override;

private:
    SimulatorTransport *m_transport = nullptr;
};

/// A simulated gimbal that lives on while nobody is connected: unplugging loses no memory.
class SimulatorRig
{
public:
    explicit SimulatorRig(std::unique_ptr<SimulatedPort> port)
        : m_host(new PipeHost(std::move(port)))
    {
        m_thread.setObjectName(u"gimbal-simulator"_s);
        m_host->moveToThread(&m_thread);
        QObject::connect(&m_thread, &QThread::finished, m_host, &QObject::deleteLater);
        m_thread.start();
        QMetaObject::invokeMethod(
            m_host, [this] { std::ignore = m_host->start(); }, Qt::QueuedConnection);
    }
    ~SimulatorRig()
    {
        m_thread.quit();
        m_thread.wait();
    }
    SimulatorRig(const SimulatorRig &) = delete;
    SimulatorRig &operator=(const SimulatorRig &) = delete;
    [[nodiscard]] PipeHost *host() const { return m_host; }

private:
    QThread m_thread;
    PipeHost *m_host;
};

/// The transport end of the pipe.
class SimulatorTransport final : public Transport
{
public:
    SimulatorTransport(std::shared_ptr<SimulatorRig> rig, bool hasLine)
        : m_rig(std::move(rig))
        , m_hasLine(hasLine)
    {
    }
    ~SimulatorTransport() override { SimulatorTransport::close(); }
    SimulatorTransport(const SimulatorTransport &) = delete;
    SimulatorTransport &operator=(const SimulatorTransport &) = delete;

    void open() override
    {
        bool in = false;
        QMetaObject::invokeMethod(
            m_rig->host(), [&] { in = m_rig->host()->attach(this); }, Qt::BlockingQueuedConnection);
        m_open = in;
        if (in)
            emit opened();
        else
            emit closed({ErrorCode::PortNotFound, u"the simulated cable is out"_s, 0});
    }

    void close() override
    {
        if (!std::exchange(m_open, false))
            return;
        QMetaObject::invokeMethod(
            m_rig->host(), [this] { m_rig->host()->attach(nullptr); }, Qt::BlockingQueuedConnection);
    }

    void write(QByteArrayView bytes) override
    {
        if (!m_open)
            return;
        QMetaObject::invokeMethod(
            m_rig->host(), [host = m_rig->host(), copy = bytes.toByteArray()] { host->write(copy); },
            Qt::QueuedConnection);
        const qint64 count = bytes.size();
        QMetaObject::invokeMethod(
            this, [this, count] { emit bytesWritten(count); }, Qt::QueuedConnection);
    }

    bool setLine(const LineSettings &line) override
    {
        m_line = line;
        QMetaObject::invokeMethod(
            m_rig->host(), [host = m_rig->host(), line] { host->port().setHostLine(line); },
            Qt::QueuedConnection);
        return true;
    }

    [[nodiscard]] std::optional<LineSettings> line() const override
    {
        return m_hasLine ? std::optional(m_line) : std::nullopt;
    }

    void arrived(const QByteArray &bytes)
    {
        if (m_open)
            emit received(bytes, Clock::now());
    }
    void pulled()
    {
        if (m_open)
            emit closed({ErrorCode::LinkClosed, u"the simulated cable was pulled"_s, 0});
    }

private:
    std::shared_ptr<SimulatorRig> m_rig;
    bool m_hasLine;
    LineSettings m_line;
    bool m_open = false;
};

bool PipeHost::attach(SimulatorTransport *transport)
{
    if (transport && !port().isPlugged())
        return false;
    m_transport = transport;
    if (!transport)
        port().setHostLine({});
    return true;
}

void PipeHost::deliver(const QByteArray &bytes)
{
    if (m_transport)
        QMetaObject::invokeMethod(
            m_transport, [t = m_transport, bytes] { t->arrived(bytes); }, Qt::QueuedConnection);
}

void PipeHost::plugged(bool in)
{
    if (!in && m_transport)
        QMetaObject::invokeMethod(
            m_transport, [t = m_transport] { t->pulled(); }, Qt::QueuedConnection);
}

}  // namespace

struct SimulatedGimbals::Rigs
{
    std::mutex mutex;
    QMap<QString, std::shared_ptr<SimulatorRig>> byAddress;
};

SimulatedGimbals::SimulatedGimbals()
    : m_rigs(std::make_shared<Rigs>())
{
}

Result<std::unique_ptr<Transport>> SimulatedGimbals::connectTo(const LinkAddress &address) const
{
    const QStringList faults = address.option(u"fault"_s).split(u',', Qt::SkipEmptyParts);
    const auto setup = parseSimulatorSetup(address.target(), address.options(), faults);
    if (!setup)
        return tl::unexpected(setup.error());
    const std::lock_guard lock(m_rigs->mutex);
    std::shared_ptr<SimulatorRig> &rig = m_rigs->byAddress[address.toString()];
    if (!rig) {
        auto board = makeSimulatedBoard(address.target(), setup->options);
        if (!board)
            return tl::unexpected(board.error());
        rig = std::make_shared<SimulatorRig>(
            std::make_unique<SimulatedPort>(std::move(*board), setup->options, setup->line));
    }
    return std::make_unique<SimulatorTransport>(rig, setup->line.has_value());
}

Result<void> SimulatedGimbals::change(const LinkAddress &address, const QString &assignment) const
{
    Faults check;
    if (const auto valid = check.set(assignment); !valid)
        return valid;
    std::shared_ptr<SimulatorRig> rig;
    {
        const std::lock_guard lock(m_rigs->mutex);
        rig = m_rigs->byAddress.value(address.toString());
    }
    if (!rig)
        return failure(ErrorCode::NotConnected, address.toString());
    QMetaObject::invokeMethod(
        rig->host(), [host = rig->host(), assignment] { std::ignore = host->port().change(assignment); },
        Qt::QueuedConnection);
    return {};
}
