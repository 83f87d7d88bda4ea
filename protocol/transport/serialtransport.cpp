// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/transport/serialtransport.h"

#include <QFileInfo>

#ifdef Q_OS_UNIX
#include <poll.h>
#endif

using namespace Qt::StringLiterals;

namespace {

ErrorCode codeOf(QSerialPort::SerialPortError error, const QString &text)
{
    switch (error) {
    case QSerialPort::DeviceNotFoundError: return ErrorCode::PortNotFound;
    case QSerialPort::PermissionError:
        // Qt reports a port that another program holds (EBUSY, or a lock file) as a permission error too.
        return text.contains(QLatin1String("busy"), Qt::CaseInsensitive)
                || text.contains(QLatin1String("lock"), Qt::CaseInsensitive)
            ? ErrorCode::PortBusy
            : ErrorCode::NoPermission;
    default: return ErrorCode::LinkClosed;
    }
}

}  // namespace

SerialTransport::SerialTransport(const QString &port, const LineSettings &line, QObject *parent)
    : Transport(parent)
    , m_line(line)
    , m_buffer(kReadBuffer, Qt::Uninitialized)
{
    m_port.setParent(this);
    m_port.setPortName(port);
    connect(&m_port, &QSerialPort::readyRead, this, &SerialTransport::onReadyRead);
    connect(&m_port, &QSerialPort::errorOccurred, this, &SerialTransport::onError);
    connect(&m_port, &QSerialPort::bytesWritten, this, &Transport::bytesWritten);
}

void SerialTransport::open()
{
    const QFileInfo info(m_port.portName());
    if (info.isAbsolute() && !info.exists()) {
        emit closed({ErrorCode::PortNotFound, m_port.portName()});
        return;
    }
    if (info.isAbsolute() && !(info.isReadable() && info.isWritable())) {
        emit closed({ErrorCode::NoPermission, m_port.portName()});
        return;
    }
    m_port.setFlowControl(QSerialPort::NoFlowControl);
    if (!m_port.open(QIODevice::ReadWrite)) {
        const QString text = m_port.errorString();
        emit closed({codeOf(m_port.error(), text), text});
        return;
    }
    m_open = true;
    setLine(m_line);
    emit opened();
}

void SerialTransport::close()
{
    m_open = false;
    m_port.close();
}

void SerialTransport::write(QByteArrayView bytes)
{
    if (!m_open)
        return;
    m_port.write(bytes.data(), bytes.size());
    m_port.flush();
}

bool SerialTransport::setLine(const LineSettings &line)
{
    m_line = line;
    if (!m_open)
        return true;
    const bool ok = m_port.setBaudRate(line.baud)
        && m_port.setParity(line.parity == Parity::Even ? QSerialPort::EvenParity : QSerialPort::NoParity);
    m_port.clear(QSerialPort::Input);
    return ok;
}

void SerialTransport::onReadyRead()
{
    const TimePoint now = Clock::now();
    for (;;) {
        const qint64 count = m_port.read(m_buffer.data(), m_buffer.size());
        if (count <= 0)
            return;
        emit received(QByteArrayView(m_buffer).first(count), now);
        if (!m_open)
            return;
    }
}

bool SerialTransport::isHungUp() const
{
#ifdef Q_OS_UNIX
    pollfd port{int(m_port.handle()), POLLIN, 0};
    return ::poll(&port, 1, 0) > 0 && (port.revents & (POLLHUP | POLLERR | POLLNVAL));
#else
    return true;
#endif
}

void SerialTransport::onError(QSerialPort::SerialPortError error)
{
    // Refused rates and the like are reported by setLine(); only a port that has disappeared ends the link.
    // QSerialPort also reports a read error when there was simply nothing left to read, so the system is
    // asked.
    const bool isGone = error == QSerialPort::ResourceError || error == QSerialPort::DeviceNotFoundError
        || ((error == QSerialPort::ReadError || error == QSerialPort::WriteError) && isHungUp());
    if (!m_open || !isGone)
        return;
    // Not its own text: that is about whatever the program happened to do with it last.
    const QString text = u"the port %1 disappeared"_s.arg(m_port.portName());
    m_open = false;
    m_port.close();
    emit closed({ErrorCode::LinkClosed, text});
}
