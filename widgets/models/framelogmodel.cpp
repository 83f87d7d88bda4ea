// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/framelogmodel.h"

#include "widgets/models/numbertext.h"

#include <algorithm>
#include <iterator>
#include <tuple>

using namespace Qt::StringLiterals;

FrameLogModel::FrameLogModel(DeviceClient &client, QObject *parent)
    : TableModel({tr("Seconds"), tr("Direction"), tr("Frame"), tr("Fields"), tr("Bytes")}, parent)
    , m_client(client)
    , m_isKnown(client.isConnected())
{
    connect(&client, &DeviceClient::stateChanged, this, &FrameLogModel::onState);
    connect(&client, &DeviceClient::statisticsChanged, this, [this] {
        if (!m_paused && m_isKnown)
            refresh();
    });
}

void FrameLogModel::onState(DeviceClient::State state)
{
    // How a board was found is worded with its own tables, which are there once it is connected.
    const bool isConnected = state == DeviceClient::State::Connected;
    m_isKnown = m_isKnown || isConnected;
    settle();
    m_isKnown = isConnected;
    switch (state) {
    case DeviceClient::State::Disconnected: addMark(tr("Link ended")); break;
    case DeviceClient::State::Connecting: addMark(tr("New link"), m_client.addressText()); break;
    case DeviceClient::State::Reconnecting:
        addMark(m_client.loss() == DeviceClient::Loss::Link ? tr("Link lost") : tr("Board restarts"));
        break;
    case DeviceClient::State::Connected:
        addMark(tr("Connected"), u"%1 · %2"_s.arg(m_client.identity().model, m_client.identity().firmware));
        break;
    }
}

// Frames are decoded with the tables of their own board, as long as these are there.
void FrameLogModel::settle()
{
    refresh();
    for (const Row &row : m_rows)
        std::ignore = textOf(row);
}

void FrameLogModel::addMark(const QString &what, const QString &more)
{
    Row mark;
    mark.frame.at = Clock::now();
    if (!m_origin)
        m_origin = mark.frame.at;
    mark.text = FrameText{u"— %1 —"_s.arg(what), more};
    std::vector<Row> rows;
    rows.push_back(std::move(mark));
    addRows(std::move(rows));
}

void FrameLogModel::refresh()
{
    std::vector<LoggedFrame> fresh = m_client.frames().after(m_seen);
    if (fresh.empty())
        return;
    m_seen = fresh.back().number;
    if (!m_origin)
        m_origin = fresh.front().at;
    if (!m_showsStreams) {
        // Live data are frames that the board sends repeatedly, polled or unsolicited; not errors and
        // notices.
        const FrameInspector *inspector = m_client.device() ? m_client.device()->inspector() : nullptr;
        const QByteArray heartbeat = m_client.heartbeatBytes();
        const QString beat
            = inspector && !heartbeat.isEmpty() ? inspector->describeSent(heartbeat).name : QString();
        std::erase_if(fresh, [inspector, beat, poll = m_client.pollBytes()](const LoggedFrame &frame) {
            if (!frame.fromBoard)
                return (!poll.isEmpty() && frame.bytes == poll)
                    || (!beat.isEmpty() && inspector->describeSent(frame.bytes).name == beat);
            return (!frame.claimed || !poll.isEmpty()) && inspector && inspector->isTelemetryFrame(frame.id);
        });
    }
    std::vector<Row> rows;
    for (LoggedFrame &frame : fresh)
        rows.push_back({std::move(frame), {}});
    addRows(std::move(rows));
}

void FrameLogModel::addRows(std::vector<Row> fresh)
{
    if (fresh.empty())
        return;
    const qsizetype surplus = qsizetype(m_rows.size() + fresh.size()) - qsizetype(kCapacity);
    if (surplus > 0) {
        const int gone = int(std::min<qsizetype>(surplus, qsizetype(m_rows.size())));
        if (gone > 0) {
            beginRemoveRows({}, 0, gone - 1);
            m_rows.erase(m_rows.begin(), m_rows.begin() + gone);
            endRemoveRows();
        }
    }
    const int first = int(m_rows.size());
    beginInsertRows({}, first, first + int(fresh.size()) - 1);
    std::move(fresh.begin(), fresh.end(), std::back_inserter(m_rows));
    endInsertRows();
}

void FrameLogModel::clear()
{
    m_seen = m_client.frames().newest();
    resetWith([this] { m_rows.clear(); });
}

const FrameText &FrameLogModel::textOf(const Row &row) const
{
    if (row.text)
        return *row.text;
    row.text = FrameText{u"?"_s, {}};
    const FrameInspector *inspector
        = m_isKnown && m_client.device() ? m_client.device()->inspector() : nullptr;
    if (!inspector)
        return *row.text;
    if (row.frame.fromBoard) {
        row.text
            = inspector->describeFrame({row.frame.id, asBytes(row.frame.bytes), row.frame.version}, true);
        return *row.text;
    }
    row.text = inspector->describeSent(row.frame.bytes);
    return *row.text;
}

QString FrameLogModel::timeText(const Row &row) const
{
    return QString::number(seconds(row.frame.at - *m_origin), 'f', 4);
}

QString FrameLogModel::text() const
{
    QString all;
    for (const Row &row : m_rows) {
        const FrameText &words = textOf(row);
        if (isMark(row)) {
            all += u"%1 %2 %3\n"_s.arg(timeText(row).rightJustified(12), words.name, words.fields);
            continue;
        }
        all += u"%1 %2 %3 %4  [%5]\n"_s.arg(timeText(row).rightJustified(12),
                                            row.frame.fromBoard ? u"<"_s : u">"_s, words.name, words.fields,
                                            QString::fromLatin1(row.frame.bytes.toHex(' ')));
    }
    return all;
}

QVariant FrameLogModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const Row &row = m_rows[std::size_t(index.row())];
    if (role == FromBoardRole)
        return row.frame.fromBoard;
    if (isMark(row)
        && (index.column() == DirectionColumn || (role == Qt::ToolTipRole && index.column() == BytesColumn)))
        return {};
    if (role == SearchRole)
        return u"%1 %2"_s.arg(textOf(row).name, textOf(row).fields).toLower();
    if (role == Qt::ToolTipRole && index.column() == BytesColumn)
        return row.frame.fromBoard ? tr("Payload") : tr("Complete frames");
    if (role == Qt::TextAlignmentRole && index.column() == TimeColumn)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case TimeColumn: return numberText(timeText(row));
    case DirectionColumn: return row.frame.fromBoard ? tr("← board") : tr("→ board");
    case NameColumn: return textOf(row).name;
    case FieldsColumn: return withNumbers(textOf(row).fields);
    case BytesColumn: return QString::fromLatin1(row.frame.bytes.toHex(' '));
    default: return {};
    }
}
