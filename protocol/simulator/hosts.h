// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/simulatedport.h"
#include "protocol/transport/transport.h"

#include <QElapsedTimer>
#include <QTimer>

class QSocketNotifier;
class QTcpServer;
class QTcpSocket;

/// Runs a simulated port in real time and offers it to the world. Lives on a thread with an event loop.
class SimulatorHost : public QObject
{
    Q_OBJECT
public:
    explicit SimulatorHost(std::unique_ptr<SimulatedPort> port, QObject *parent = nullptr);

    /// Starts real time. Errors: InvalidArgument, PortBusy and the like, in words.
    virtual Result<void> start();
    /// What a client connects to.
    [[nodiscard]] virtual QString address() const = 0;
    [[nodiscard]] SimulatedPort &port() { return *m_port; }

protected:
    void hostWrote(QByteArrayView bytes) { m_port->hostWrites(asBytes(bytes)); }
    virtual void deliver(const QByteArray &bytes) = 0;
    /// The cable went in or out.
    virtual void plugged(bool in) = 0;
    /// Called before time passes, to look at the host's line settings and bytes.
    virtual void poll() { }

private:
    void onTick();

    std::unique_ptr<SimulatedPort> m_port;
    QTimer m_timer;
    QElapsedTimer m_clock;
    qint64 m_simulatedNs = 0;
    bool m_plugged = true;
};

/// A pseudo-terminal, reachable by a symbolic link at a path of the caller's choice.
class PtyHost final : public SimulatorHost
{
    Q_OBJECT
public:
    PtyHost(std::unique_ptr<SimulatedPort> port, QString path, QObject *parent = nullptr);
    ~PtyHost() override;

    Result<void> start() override;
    [[nodiscard]] QString address() const override { return m_path; }

protected:
    void deliver(const QByteArray &bytes) override;
    void plugged(bool in) override;
    void poll() override;

private:
    Result<void> openTerminal();
    void drain();
    void closeTerminal();

    QString m_path;
    QString m_slave;
    int m_master = -1;
    QByteArray m_unsent;
};

/// A TCP server for one client at a time (the newest), on the loopback interface.
class TcpHost final : public SimulatorHost
{
    Q_OBJECT
public:
    TcpHost(std::unique_ptr<SimulatedPort> port, quint16 tcpPort, QObject *parent = nullptr);

    Result<void> start() override;
    [[nodiscard]] QString address() const override;

protected:
    void deliver(const QByteArray &bytes) override;
    void plugged(bool in) override;

private:
    void onConnection();

    QTcpServer *m_server;
    QTcpSocket *m_client = nullptr;
    quint16 m_tcpPort;
};

/// The in-process pipe: transports with the simulator behind them, for `sim:` addresses. A simulated gimbal
/// lives as long as this object and the transports made by it, so unplugging and connecting anew meets the
/// same board.
class SimulatedGimbals
{
public:
    SimulatedGimbals();

    /// Errors: InvalidArgument for a family or option that does not exist. Called on the I/O thread.
    Result<std::unique_ptr<Transport>> connectTo(const LinkAddress &address) const;
    /// Changes the world around a gimbal that was connected to: a fault as NAME=VALUE. Callable from any
    /// thread. Errors: InvalidArgument, NotConnected.
    Result<void> change(const LinkAddress &address, const QString &assignment) const;

private:
    struct Rigs;
    std::shared_ptr<Rigs> m_rigs;
};

/// Reads the same options from a map, for the command line of gimbalsim and for `sim:` addresses.
struct SimulatorSetup
{
    SimulatorOptions options;
    std::optional<LineSettings> line;
};
Result<SimulatorSetup> parseSimulatorSetup(const QString &family, const QMap<QString, QString> &options,
                                           const QStringList &faults);
