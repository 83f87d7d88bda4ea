// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/link/tcpdoor.h"

#include "protocol/simulator/world/simulatedboard.h"

#include <QTcpServer>
#include <QTcpSocket>

using namespace Qt::StringLiterals;

namespace {

constexpr qsizetype kSegment = 1448;

}  // namespace

TcpDoor::TcpDoor(SimulatedBoard &board, quint16 port, QObject *parent)
    : QObject(parent)
    , m_board(board)
    , m_server(new QTcpServer(this))
    , m_port(port)
{
    connect(m_server, &QTcpServer::newConnection, this, &TcpDoor::onConnection);
}

Result<void> TcpDoor::open()
{
    if (!m_server->listen(QHostAddress::LocalHost, m_port))
        return failure(ErrorCode::PortBusy, u"TCP port %1: %2"_s.arg(m_port).arg(m_server->errorString()));
    m_port = m_server->serverPort();
    return {};
}

void TcpDoor::close()
{
    m_server->close();
    if (m_client)
        m_client->abort();
}

void TcpDoor::onConnection()
{
    QTcpSocket *socket = m_server->nextPendingConnection();
    // The newest client wins, as on a serial bridge: the previous one may be dead without our knowing.
    if (m_client)
        m_client->abort();
    m_client = socket;
    m_board.clientCame();
    socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    connect(socket, &QTcpSocket::readyRead, this, [this, socket] {
        for (QByteArray piece = socket->read(kSegment); !piece.isEmpty(); piece = socket->read(kSegment))
            emit read(piece);
    });
    connect(socket, &QTcpSocket::disconnected, this, [this, socket] {
        if (m_client == socket) {
            m_client = nullptr;
            m_board.clientWent();
        }
        socket->deleteLater();
    });
}

void TcpDoor::write(const QByteArray &bytes)
{
    if (!m_client)
        return;
    m_client->write(bytes);
    m_client->flush();
}
