// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/link/host.h"

class QTcpServer;
class QTcpSocket;

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
