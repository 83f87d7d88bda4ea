// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/link/udphost.h"

#include <QNetworkDatagram>
#include <QUdpSocket>

using namespace Qt::StringLiterals;

UdpHost::UdpHost(std::unique_ptr<SimulatedPort> port, quint16 udpPort, QObject *parent)
    : SimulatorHost(std::move(port), parent)
    , m_socket(new QUdpSocket(this))
    , m_udpPort(udpPort)
{
    connect(m_socket, &QUdpSocket::readyRead, this, &UdpHost::onDatagrams);
}

Result<void> UdpHost::start()
{
    if (!m_socket->bind(QHostAddress::LocalHost, m_udpPort))
        return failure(ErrorCode::PortBusy, u"UDP port %1: %2"_s.arg(m_udpPort).arg(m_socket->errorString()));
    m_udpPort = m_socket->localPort();
    if (m_door) {
        if (const auto opened = m_door->open(); !opened)
            return opened;
    }
    return SimulatorHost::start();
}

QString UdpHost::address() const
{
    return u"udp://127.0.0.1:%1"_s.arg(m_udpPort);
}

void UdpHost::offerTcp(quint16 tcpPort)
{
    m_door = std::make_unique<TcpDoor>(port().board(), tcpPort, this);
    connect(m_door.get(), &TcpDoor::read, this, [this](const QByteArray &bytes) {
        m_isLastByTcp = true;
        hostWrote(bytes);
    });
}

void UdpHost::onDatagrams()
{
    while (m_socket->hasPendingDatagrams()) {
        const QNetworkDatagram datagram = m_socket->receiveDatagram();
        if (!datagram.isValid())
            continue;
        m_peer = datagram.senderAddress();
        m_peerPort = quint16(datagram.senderPort());
        m_isLastByTcp = false;
        hostWrote(datagram.data());
    }
}

void UdpHost::deliver(const QByteArray &bytes)
{
    if (m_isLastByTcp)
        m_door->write(bytes);
    else if (m_peerPort != 0)
        m_socket->writeDatagram(bytes, m_peer, m_peerPort);
}
