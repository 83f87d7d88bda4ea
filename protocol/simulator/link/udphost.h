// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/link/host.h"

#include <QHostAddress>

class QUdpSocket;

/// Datagrams on the loopback interface: each packet is one, and answers go to the most recent sender.
class UdpHost final : public SimulatorHost
{
    Q_OBJECT
public:
    UdpHost(std::unique_ptr<SimulatedPort> port, quint16 udpPort, QObject *parent = nullptr);

    Result<void> start() override;
    [[nodiscard]] QString address() const override;

protected:
    void deliver(const QByteArray &bytes) override;

private:
    void onDatagrams();

    QUdpSocket *m_socket;
    quint16 m_udpPort;
    QHostAddress m_peer;
    quint16 m_peerPort = 0;
};
