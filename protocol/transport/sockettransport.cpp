// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/transport/sockettransport.h"

#include <QTcpSocket>
#include <QUdpSocket>

namespace {

QAbstractSocket *makeSocket(LinkAddress::Kind kind, QObject *parent)
{
    if (kind == LinkAddress::Kind::Udp)
        return new QUdpSocket(parent);
    return new QTcpSocket(parent);
}

}  // namespace

SocketTransport::SocketTransport(LinkAddress::Kind kind, const QString &host, quint16 port, QObject *parent)
    : Transport(parent)
    , m_socket(makeSocket(kind, this))
    , m_host(host)
    , m_port(port)
    , m_buffer(kReadBuffer, Qt::Uninitialized)
{
    connect(m_socket, &QAbstractSocket::connected, this, [this] {
        // Small requests must not wait for Nagle's algorithm.
        m_socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
        emit opened();
    });
    connect(m_socket, &QAbstractSocket::errorOccurred, this, &SocketTransport::onError);
    connect(m_socket, &QAbstractSocket::readyRead, this, &SocketTransport::onReadyRead);
    connect(m_socket, &QAbstractSocket::bytesWritten, this, &Transport::bytesWritten);
}

void SocketTransport::open()
{
    m_socket->connectToHost(m_host, m_port);
}

void SocketTransport::close()
{
    m_socket->disconnect(this);
    // What was written last still goes out; the socket is deleted with this transport.
    m_socket->flush();
    m_socket->disconnectFromHost();
}

void SocketTransport::write(QByteArrayView bytes)
{
    m_socket->write(bytes.data(), bytes.size());
    m_socket->flush();
}

bool SocketTransport::isPacketBased() const
{
    return m_socket->socketType() == QAbstractSocket::UdpSocket;
}

void SocketTransport::onReadyRead()
{
    const TimePoint now = Clock::now();
    for (;;) {
        const qint64 count = m_socket->read(m_buffer.data(), m_buffer.size());
        if (count <= 0)
            return;
        emit received(QByteArrayView(m_buffer).first(count), now);
    }
}

void SocketTransport::onError(QAbstractSocket::SocketError error)
{
    const bool never = error == QAbstractSocket::HostNotFoundError
        || error == QAbstractSocket::ConnectionRefusedError || error == QAbstractSocket::NetworkError
        || error == QAbstractSocket::SocketTimeoutError;
    emit closed({never ? ErrorCode::HostUnreachable : ErrorCode::LinkClosed, m_socket->errorString()});
}
