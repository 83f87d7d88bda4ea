// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/transport/transport.h"

#include <QSerialPort>

/// A serial port (real, USB or pseudo-terminal) through QSerialPort.
class SerialTransport final : public Transport
{
    Q_OBJECT
public:
    SerialTransport(const QString &port, const LineSettings &line, QObject *parent = nullptr);

    void open() override;
    void close() override;
    void write(QByteArrayView bytes) override;
    bool setLine(const LineSettings &line) override;
    [[nodiscard]] std::optional<LineSettings> line() const override { return m_line; }

private:
    void onReadyRead();
    [[nodiscard]] bool isHungUp() const;
    void onError(QSerialPort::SerialPortError error);

    QSerialPort m_port;
    LineSettings m_line;
    QByteArray m_buffer;
    bool m_open = false;
};
