// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

#include <QObject>

class QTcpServer;
class QTcpSocket;
class SimulatedBoard;

/// A TCP server for one client at a time (the newest), on the loopback interface. The board hears of clients
/// that come and go. What a client writes comes out as it is read, in pieces of at most a segment.
class TcpDoor final : public QObject
{
    Q_OBJECT
public:
    /// @param board outlives it
    TcpDoor(SimulatedBoard &board, quint16 port, QObject *parent = nullptr);

    /// Errors: PortBusy.
    Result<void> open();
    /// Nobody gets in, and whoever is inside is thrown out.
    void close();
    [[nodiscard]] quint16 port() const { return m_port; }
    void write(const QByteArray &bytes);

signals:
    void read(const QByteArray &bytes);

private:
    void onConnection();

    SimulatedBoard &m_board;
    QTcpServer *m_server;
    QTcpSocket *m_client = nullptr;
    quint16 m_port;
};
