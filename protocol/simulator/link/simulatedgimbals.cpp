// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/link/simulatedgimbals.h"

#include "protocol/simulator/link/host.h"
#include "protocol/simulator/link/simulatorsetup.h"
#include "protocol/simulator/video/cameraserver.h"

#include <QThread>

#include <mutex>
#include <tuple>

using namespace Qt::StringLiterals;

namespace {

class SimulatorTransport;

/// The simulator's end of the in-process pipe, on the simulator's own thread, so that a busy I/O thread does
/// not slow it down.
class PipeHost final : public SimulatorHost
{
public:
    using SimulatorHost::SimulatorHost;
    [[nodiscard]] QString address() const override { return u"sim:"_s; }

    /// Connects or disconnects the listener. False while the cable is out.
    bool attach(SimulatorTransport *transport);
    void write(const QByteArray &bytes) { hostWrote(bytes); }

protected:
    void deliver(const QByteArray &bytes) override;
    void plugged(bool in) override;

private:
    SimulatorTransport *m_transport = nullptr;
};

/// A simulated gimbal that keeps running while nobody is connected: unplugging loses no memory.
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
    Result<quint16> offerVideo()
    {
        if (!m_camera) {
            const auto feed = std::make_shared<CameraFeed>();
            auto camera = std::make_unique<CameraServer>(feed);
            if (const auto started = camera->start(0); !started)
                return tl::unexpected(started.error());
            m_camera = std::move(camera);
            QMetaObject::invokeMethod(
                m_host, [this, feed] { m_host->setCameraFeed(feed); }, Qt::QueuedConnection);
        }
        return m_camera->port();
    }

private:
    QThread m_thread;
    PipeHost *m_host;
    std::unique_ptr<CameraServer> m_camera;
};

/// The transport end of the pipe.
class SimulatorTransport final : public Transport
{
public:
    SimulatorTransport(std::shared_ptr<SimulatorRig> rig, bool hasLine)
        : m_rig(std::move(rig))
        , m_hasLine(hasLine)
        , m_packetBased(m_rig->host()->port().isPacketBased())
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

    [[nodiscard]] bool isPacketBased() const override { return m_packetBased; }

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
    bool m_packetBased;
    LineSettings m_line;
    bool m_open = false;
};

bool PipeHost::attach(SimulatorTransport *transport)
{
    if (transport && port().isGone())
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

SimulatedGimbals::SimulatedGimbals(QList<SimulatedFamily> families)
    : m_families(std::move(families))
    , m_rigs(std::make_shared<Rigs>())
{
}

Result<std::unique_ptr<Transport>> SimulatedGimbals::connectTo(const LinkAddress &address) const
{
    const auto family = findSimulatedFamily(m_families, address.target());
    if (!family)
        return tl::unexpected(family.error());
    const QStringList faults = address.option(u"fault"_s).split(u',', Qt::SkipEmptyParts);
    const auto setup = parseSimulatorSetup(*family, address.options(), faults);
    if (!setup)
        return tl::unexpected(setup.error());
    const std::lock_guard lock(m_rigs->mutex);
    std::shared_ptr<SimulatorRig> &rig = m_rigs->byAddress[address.toString()];
    if (!rig) {
        rig = std::make_shared<SimulatorRig>(std::make_unique<SimulatedPort>(
            family->makeBoard(setup->options), setup->options, setup->line()));
    }
    return std::make_unique<SimulatorTransport>(rig, setup->rate.has_value());
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

Result<quint16> SimulatedGimbals::offerVideo(const LinkAddress &address) const
{
    const std::lock_guard lock(m_rigs->mutex);
    const std::shared_ptr<SimulatorRig> rig = m_rigs->byAddress.value(address.toString());
    if (!rig)
        return failure(ErrorCode::NotConnected, address.toString());
    return rig->offerVideo();
}
