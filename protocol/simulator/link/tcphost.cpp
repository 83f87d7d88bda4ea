// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/link/tcphost.h"

#include <QTcpServer>
#include <QTcpSocket>

using namespace Qt::StringLiterals;

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
    // The newest client wins, as on a serial bridge: the previous one may be dead without our knowing.
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
