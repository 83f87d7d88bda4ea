// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"
#include "protocol/telemetry/channelspec.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QHostAddress>
#include <QTimer>
#include <QUdpSocket>

/// Forwards telemetry as JSON in UDP datagrams, one per row, in the form that PlotJuggler's UDP server reads
/// live: {"timestamp": seconds since 1970, "gyro": {"roll": 1.25, ...}, ...}. Lost samples are left out.
class UdpExport final : public QObject
{
    Q_OBJECT
public:
    /// PlotJuggler's default port.
    static constexpr quint16 kDefaultPort = 9870;

    /// @param channels columns of the table to send
    UdpExport(ChannelTable table, std::shared_ptr<const TelemetryStore> store, QList<int> channels,
              QObject *parent = nullptr);

    /// Starts with new samples only. Errors: InvalidArgument (no such address), HostUnreachable.
    Result<void> start(const QString &hostAndPort);
    void stop() { m_timer.stop(); }
    [[nodiscard]] bool isRunning() const { return m_timer.isActive(); }
    [[nodiscard]] quint64 sent() const { return m_sent; }
    [[nodiscard]] const TelemetryStore *store() const { return m_store.get(); }
    /// Sends what has arrived since the last call.
    void flush();

signals:
    /// The system refused to send.
    void failed(const Error &error);

private:
    struct Source
    {
        std::vector<TrackView> tracks;  // of one group, side by side
        QList<int> channels;
        std::size_t next = 0;
    };
    void findSources();
    [[nodiscard]] QByteArray messageFor(const Source &source, std::size_t row) const;

    ChannelTable m_table;
    std::shared_ptr<const TelemetryStore> m_store;
    QList<int> m_channels;
    QUdpSocket m_socket;
    QHostAddress m_host;
    quint16 m_port = kDefaultPort;
    QTimer m_timer;
    int m_generation = -1;
    bool m_first = true;
    std::vector<Source> m_sources;
    quint64 m_sent = 0;
};
