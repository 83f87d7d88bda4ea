// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/video/videoaddress.h"
#include "protocol/video/videoassembler.h"

#include <QHostAddress>
#include <QObject>
#include <QTimer>

class QUdpSocket;

/// Asks a drone for its video and puts the datagrams together. The drone sends to whoever wrote to its video
/// port last, so this writes to it all the time (errata 10). Lives on a thread with an event loop.
class VideoReceiver final : public QObject
{
    Q_OBJECT
public:
    /// What is sent: any bytes will do; these are the original's.
    static constexpr char kHello[] = {0x12, 0x34, 0x56, 0x78};
    static constexpr auto kHelloPeriod = 500ms;

    /// @param frame called on this object's thread, as is `datagram` with the size of each
    VideoReceiver(VideoAddress address, VideoAssembler::Sink frame, std::function<void(qsizetype)> datagram);

    void start();

signals:
    void failed(const Error &error);

private:
    void listen(const QHostAddress &host);
    void onDatagrams();
    void sendHello();

    VideoAddress m_address;
    VideoAssembler::Sink m_frame;
    std::function<void(qsizetype)> m_datagram;
    VideoAssembler m_assembler;
    QHostAddress m_host;
    QUdpSocket *m_socket;
    QTimer m_hello;
    QByteArray m_buffer;
};
