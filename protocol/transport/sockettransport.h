// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/transport/transport.h"

#include <QAbstractSocket>

/// A TCP or UDP peer. UDP keeps datagrams: one received() per datagram.
class SocketTransport final : public Transport
{
    Q_OBJECT
public:
    SocketTransport(LinkAddress::Kind kind, const QString &host, quint16 port, QObject *parent = nullptr);

    void open() override;
    void close() override;
    void write(QByteArrayView bytes) override;
    [[nodiscard]] bool isPacketBased() const override;

private:
    void onReadyRead();
    void onError(QAbstractSocket::SocketError error);

    QAbstractSocket *m_socket;
    QString m_host;
    quint16 m_port;
    QByteArray m_buffer;
};
