// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/video/videoreceiver.h"

#include <QHostInfo>
#include <QUdpSocket>
#include <QVariant>

#include <algorithm>
#include <ctime>
#include <sys/socket.h>

namespace {

constexpr qsizetype kLargestDatagram = 65536;
constexpr int kKernelBuffer = 4 * 1024 * 1024;  // a key frame comes all at once; the kernel gives less
constexpr auto kLongestWait = 1s;  // beyond, the computer's clock was set meanwhile

// How long the datagram that is read next has lain in the kernel.
Duration waitedInKernel(qintptr socket)
{
    alignas(cmsghdr) char control[CMSG_SPACE(sizeof(timespec))];
    msghdr message{};
    message.msg_control = control;
    message.msg_controllen = sizeof(control);
    if (::recvmsg(int(socket), &message, MSG_PEEK | MSG_DONTWAIT) < 0)
        return {};
    timespec now{};
    ::clock_gettime(CLOCK_REALTIME, &now);
    for (cmsghdr *part = CMSG_FIRSTHDR(&message); part; part = CMSG_NXTHDR(&message, part)) {
        if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_TIMESTAMPNS)
            continue;
        timespec came{};
        std::copy_n(CMSG_DATA(part), sizeof(came), reinterpret_cast<unsigned char *>(&came));
        const Duration waited = std::chrono::seconds(now.tv_sec - came.tv_sec)
            + std::chrono::nanoseconds(now.tv_nsec - came.tv_nsec);
        return waited >= 0s && waited < kLongestWait ? waited : Duration{};
    }
    return {};
}

}  // namespace

VideoReceiver::VideoReceiver(VideoAddress address, VideoAssembler::Sink frame,
                             std::function<void(qsizetype)> datagram)
    : m_address(std::move(address))
    , m_frame(std::move(frame))
    , m_datagram(std::move(datagram))
    , m_socket(new QUdpSocket(this))
    , m_hello(this)
    , m_buffer(kLargestDatagram, '\0')
{
    connect(m_socket, &QUdpSocket::readyRead, this, &VideoReceiver::onDatagrams);
    connect(&m_hello, &QTimer::timeout, this, &VideoReceiver::sendHello);
}

void VideoReceiver::start()
{
    if (const QHostAddress host(m_address.host); !host.isNull()) {
        listen(host);
        return;
    }
    QHostInfo::lookupHost(m_address.host, this, [this](const QHostInfo &found) {
        if (found.addresses().isEmpty())
            emit failed({ErrorCode::HostUnreachable, m_address.host, 0});
        else
            listen(found.addresses().first());
    });
}

void VideoReceiver::listen(const QHostAddress &host)
{
    m_host = host;
    const bool isV4 = host.protocol() == QAbstractSocket::IPv4Protocol;
    if (!m_socket->bind(isV4 ? QHostAddress::AnyIPv4 : QHostAddress::AnyIPv6)) {
        emit failed({ErrorCode::HostUnreachable, m_socket->errorString(), 0});
        return;
    }
    m_socket->setSocketOption(QAbstractSocket::ReceiveBufferSizeSocketOption, kKernelBuffer);
    const int on = 1;
    ::setsockopt(int(m_socket->socketDescriptor()), SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof(on));
    m_hello.start(kHelloPeriod);
    sendHello();
}

void VideoReceiver::sendHello()
{
    m_socket->writeDatagram(kHello, sizeof(kHello), m_host, m_address.port);
}

void VideoReceiver::onDatagrams()
{
    while (m_socket->hasPendingDatagrams()) {
        const Duration waited = waitedInKernel(m_socket->socketDescriptor());
        QHostAddress from;
        const qint64 size = m_socket->readDatagram(m_buffer.data(), m_buffer.size(), &from);
        const TimePoint at = Clock::now();
        if (size < 0 || !from.isEqual(m_host, QHostAddress::TolerantConversion))
            continue;
        m_datagram(size);
        m_assembler.take(asBytes(QByteArrayView(m_buffer.constData(), size)), at - waited, m_frame, waited);
    }
}
