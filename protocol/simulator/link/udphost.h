// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/link/host.h"
#include "protocol/simulator/link/tcpdoor.h"

#include <QHostAddress>

class QUdpSocket;

/// Datagrams on the loopback interface: each packet is one, and answers go to the most recent sender. The
/// same board can be offered over TCP beside: who wrote last gets the answers there too.
class UdpHost final : public SimulatorHost
{
    Q_OBJECT
public:
    UdpHost(std::unique_ptr<SimulatedPort> port, quint16 udpPort, QObject *parent = nullptr);

    Result<void> start() override;
    [[nodiscard]] QString address() const override;
    /// Before start().
    void offerTcp(quint16 tcpPort);
    /// The port of TCP, 0 without.
    [[nodiscard]] quint16 tcpPort() const { return m_door ? m_door->port() : 0; }

protected:
    void deliver(const QByteArray &bytes) override;

private:
    void onDatagrams();

    QUdpSocket *m_socket;
    quint16 m_udpPort;
    QHostAddress m_peer;
    quint16 m_peerPort = 0;
    std::unique_ptr<TcpDoor> m_door;
    bool m_isLastByTcp = false;
};
