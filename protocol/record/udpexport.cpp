// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/udpexport.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kPeriod = 20ms;

}  // namespace

UdpExport::UdpExport(ChannelTable table, std::shared_ptr<const TelemetryStore> store, QList<int> channels,
                     QObject *parent)
    : QObject(parent)
    , m_table(table)
    , m_store(std::move(store))
    , m_channels(std::move(channels))
{
    m_timer.setInterval(kPeriod);
    connect(&m_timer, &QTimer::timeout, this, &UdpExport::flush);
}

Result<void> UdpExport::start(const QString &hostAndPort)
{
    const qsizetype colon = hostAndPort.lastIndexOf(u':');
    const QString host = colon < 0 ? hostAndPort : hostAndPort.left(colon);
    bool ok = true;
    const uint port = colon < 0 ? uint(kDefaultPort) : hostAndPort.mid(colon + 1).toUInt(&ok);
    const QString numeric = host.compare(u"localhost"_s, Qt::CaseInsensitive) == 0 ? u"127.0.0.1"_s : host;
    if (!ok || port == 0 || port > 65535 || !m_host.setAddress(numeric)) {
        return failure(
            ErrorCode::InvalidArgument,
            u"'%1' is not an address; one looks like 127.0.0.1:%2"_s.arg(hostAndPort).arg(kDefaultPort));
    }
    m_port = quint16(port);
    m_first = true;
    m_generation = -1;
    findSources();
    m_timer.start();
    return {};
}

// Channels that arrive in the same rows go into one message.
void UdpExport::findSources()
{
    if (m_generation == m_store->generation())
        return;
    m_generation = m_store->generation();
    std::vector<Source> sources;
    for (const int channel : std::as_const(m_channels)) {
        for (TrackView &track : m_store->tracks(channel)) {
            const auto same
                = [&](const Source &source) { return source.tracks.front().group() == track.group(); };
            auto source = std::find_if(sources.begin(), sources.end(), same);
            if (source == sources.end()) {
                sources.emplace_back();
                source = std::prev(sources.end());
                source->next = m_first ? track.end() : track.begin();
            }
            source->tracks.push_back(std::move(track));
            source->channels.append(channel);
        }
    }
    for (Source &source : sources) {
        for (const Source &old : m_sources) {
            if (old.tracks.front().group() == source.tracks.front().group())
                source.next = old.next;
        }
    }
    m_sources = std::move(sources);
    m_first = false;
}

QByteArray UdpExport::messageFor(const Source &source, std::size_t row) const
{
    QJsonObject message;
    for (qsizetype i = 0; i < source.channels.size(); ++i) {
        const double value = double(source.tracks[std::size_t(i)].value(row));
        if (std::isnan(value))
            continue;
        // "imu.angle.roll" becomes roll in imu.angle, so that PlotJuggler shows a tree of curves.
        const QString key = QString::fromLatin1(m_table[std::size_t(source.channels[i])].key);
        const QString group = key.section(u'.', 0, -2);
        if (group.isEmpty()) {
            message.insert(key, value);
        } else {
            QJsonObject inner = message.value(group).toObject();
            inner.insert(key.section(u'.', -1), value);
            message.insert(group, inner);
        }
    }
    if (message.isEmpty())
        return {};
    const double wall = double(m_store->wallClockAt(0).toMSecsSinceEpoch()) / 1000.0;
    message.insert(u"timestamp"_s, wall + source.tracks.front().time(row));
    return QJsonDocument(message).toJson(QJsonDocument::Compact);
}

void UdpExport::flush()
{
    findSources();
    for (Source &source : m_sources) {
        std::size_t end = std::numeric_limits<std::size_t>::max();
        for (TrackView &track : source.tracks) {
            track.refresh();
            end = std::min(end, track.end());
        }
        for (source.next = std::max(source.next, source.tracks.front().begin()); source.next < end;
             ++source.next) {
            const QByteArray message = messageFor(source, source.next);
            if (message.isEmpty())
                continue;
            // Keep sending while nobody listens: a receiver may start later.
            const bool refused = m_socket.writeDatagram(message, m_host, m_port) < 0
                && m_socket.error() != QAbstractSocket::ConnectionRefusedError;
            if (refused) {
                m_timer.stop();
                emit failed({ErrorCode::HostUnreachable, m_socket.errorString(), 0});
                return;
            }
            ++m_sent;
        }
    }
}
