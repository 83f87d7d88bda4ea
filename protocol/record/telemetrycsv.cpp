// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/telemetrycsv.h"

#include "protocol/base/filefault.h"

#include <QIODevice>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

/// The wanted channels that one stream carries.
struct Stream
{
    const TelemetryGroup *group = nullptr;
    std::vector<std::pair<qsizetype, TrackView>> columns;  // position in the list of channels
    std::size_t row = 0;
    std::size_t end = 0;

    [[nodiscard]] double time() const { return columns.front().second.time(row); }
};

std::vector<Stream> streamsOf(const TelemetryStore &store, const QList<int> &channels, double from)
{
    std::vector<Stream> streams;
    for (qsizetype i = 0; i < channels.size(); ++i) {
        for (TrackView &track : store.tracks(channels[i])) {
            track.refresh();
            auto it = std::find_if(streams.begin(), streams.end(),
                                   [&track](const Stream &stream) { return stream.group == track.group(); });
            if (it == streams.end()) {
                it = streams.emplace(streams.end());
                it->group = track.group();
                it->row = track.rowAt(from);
                it->end = track.end();
            }
            it->end = std::min(it->end, track.end());
            it->columns.emplace_back(i, std::move(track));
        }
    }
    return streams;
}

}  // namespace

Result<qint64> writeTelemetryCsv(QIODevice &file, const TelemetryStore &store, ChannelTable table,
                                 const QList<int> &channels, double from, double to)
{
    QByteArray line = "time_s";
    for (const int channel : channels) {
        const ChannelSpec &spec = table[std::size_t(channel)];
        line += ',' + QByteArray(spec.key);
        if (*spec.unit)
            line += QByteArray(" [") + spec.unit + ']';
    }
    line += '\n';
    std::vector<Stream> streams = streamsOf(store, channels, from);
    qint64 lines = 0;
    for (;;) {
        if (file.write(line) != line.size())
            return tl::unexpected(systemError(file, FileKind::Other, true));
        Stream *next = nullptr;
        for (Stream &stream : streams) {
            if (stream.row < stream.end && stream.time() <= to && (!next || stream.time() < next->time()))
                next = &stream;
        }
        if (!next)
            return lines;
        std::vector<QByteArray> cells(std::size_t(channels.size()));
        for (const auto &[position, track] : next->columns) {
            const float value = track.value(next->row);
            if (!std::isnan(value))
                cells[std::size_t(position)] = QByteArray::number(double(value), 'g', 7);
        }
        line = QByteArray::number(next->time(), 'f', 6);
        for (const QByteArray &cell : cells)
            line += ',' + cell;
        line += '\n';
        ++next->row;
        ++lines;
    }
}
