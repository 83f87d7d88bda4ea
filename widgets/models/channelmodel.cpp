// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/channelmodel.h"

#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QMimeData>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

// Internal id of a group's own row; a channel's row carries the number of its group plus one.
constexpr quintptr kGroupRow = 0;

}  // namespace

QString channelValueText(const ChannelSpec &spec, double value)
{
    if (std::isnan(value))
        return u"–"_s;
    const QString meaning = spec.choices.empty() ? QString() : choicesText(spec.choices, value, spec.areBits);
    return meaning.isEmpty() ? numberText(value, spec.decimals) : meaning;
}

const QString ChannelModel::kMimeType = u"application/x-gimbaldesk-channels"_s;

ChannelModel::ChannelModel(QObject *parent)
    : QAbstractItemModel(parent)
{
}

void ChannelModel::reset(ChannelTable table, std::shared_ptr<const TelemetryStore> store)
{
    beginResetModel();
    m_table = table;
    m_store = std::move(store);
    m_groups.clear();
    for (std::size_t i = 0; i < table.size(); ++i) {
        const auto it = std::find_if(m_groups.begin(), m_groups.end(), [&](const Group &group) {
            return qstrcmp(group.name, table[i].group) == 0;
        });
        Group &group = it == m_groups.end() ? m_groups.emplace_back(Group{table[i].group, {}}) : *it;
        group.channels.append(int(i));
    }
    m_ticked.removeIf([&](int channel) { return channel >= int(table.size()); });
    endResetModel();
}

QList<int> ChannelModel::ticked() const
{
    QList<int> channels(m_ticked.begin(), m_ticked.end());
    std::sort(channels.begin(), channels.end());
    return channels;
}

void ChannelModel::setTicked(const QList<int> &channels)
{
    const QSet<int> wanted(channels.begin(), channels.end());
    if (wanted == m_ticked)
        return;
    m_ticked = wanted;
    for (int group = 0; group < rowCount(); ++group) {
        const QModelIndex parentIndex = index(group, 0);
        emit dataChanged(index(0, 0, parentIndex), index(rowCount(parentIndex) - 1, 0, parentIndex),
                         {Qt::CheckStateRole});
    }
    emit ticksChanged();
}

void ChannelModel::refresh()
{
    for (int group = 0; group < rowCount(); ++group) {
        const QModelIndex parentIndex = index(group, 0);
        emit dataChanged(index(0, ValueColumn, parentIndex),
                         index(rowCount(parentIndex) - 1, ValueColumn, parentIndex), {Qt::DisplayRole});
    }
}

int ChannelModel::channelOf(const QModelIndex &index) const
{
    if (!index.isValid() || index.internalId() == kGroupRow)
        return -1;
    return m_groups[std::size_t(index.internalId() - 1)].channels.value(index.row(), -1);
}

QModelIndex ChannelModel::index(int row, int column, const QModelIndex &parent) const
{
    if (!hasIndex(row, column, parent))
        return {};
    return createIndex(row, column, parent.isValid() ? quintptr(parent.row() + 1) : kGroupRow);
}

QModelIndex ChannelModel::parent(const QModelIndex &child) const
{
    if (!child.isValid() || child.internalId() == kGroupRow)
        return {};
    return createIndex(int(child.internalId() - 1), 0, kGroupRow);
}

int ChannelModel::rowCount(const QModelIndex &parent) const
{
    if (!parent.isValid())
        return int(m_groups.size());
    if (parent.internalId() != kGroupRow || parent.column() != 0)
        return 0;
    return int(m_groups[std::size_t(parent.row())].channels.size());
}

int ChannelModel::columnCount(const QModelIndex &) const
{
    return ColumnCount;
}

QVariant ChannelModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const int channel = channelOf(index);
    if (channel < 0) {
        if (role == Qt::DisplayRole && index.column() == NameColumn)
            return tableText(m_groups[std::size_t(index.row())].name);
        return {};
    }
    const ChannelSpec &spec = m_table[std::size_t(channel)];
    if (role == ChannelRole)
        return channel;
    if (role == Qt::CheckStateRole && index.column() == NameColumn)
        return m_ticked.contains(channel) ? Qt::Checked : Qt::Unchecked;
    if (role == Qt::TextAlignmentRole && index.column() == ValueColumn)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole)
        return toolTip(channel);
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case NameColumn: return tableText(spec.label);
    case ValueColumn: {
        if (spec.elements > 1) {
            const auto values = m_store ? m_store->latestArray(channel).values : nullptr;
            return values && !values->empty() ? tr("%n value(s)", nullptr, int(values->size())) : u"–"_s;
        }
        const float value = m_store ? m_store->latest(channel) : std::numeric_limits<float>::quiet_NaN();
        return channelValueText(spec, double(value));
    }
    case UnitColumn: return QString::fromUtf8(spec.unit);
    default: return {};
    }
}

QString ChannelModel::toolTip(int channel) const
{
    const ChannelSpec &spec = m_table[std::size_t(channel)];
    QString key = QString::fromLatin1(spec.key);
    // Words may not fit into their column; the plot has the number.
    if (const double value = m_store && !spec.choices.empty() ? double(m_store->latest(channel)) : qQNaN();
        !std::isnan(value))
        key += u"\n%1 = %2"_s.arg(numberText(value, spec.decimals), channelValueText(spec, value));
    const quint64 invalid = m_store ? m_store->invalid(channel) : 0;
    return invalid == 0 ? key
                        : key + u'\n'
            + tr("%n value(s) came that are no numbers, or not initialised; they are gaps.", nullptr,
                 int(std::min<quint64>(invalid, INT_MAX)));
}

bool ChannelModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    const int channel = channelOf(index);
    if (role != Qt::CheckStateRole || channel < 0 || index.column() != NameColumn)
        return false;
    if (value.toInt() == Qt::Checked)
        m_ticked.insert(channel);
    else
        m_ticked.remove(channel);
    emit dataChanged(index, index, {Qt::CheckStateRole});
    emit ticksChanged();
    return true;
}

Qt::ItemFlags ChannelModel::flags(const QModelIndex &index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (channelOf(index) >= 0 && index.column() == NameColumn)
        flags |= Qt::ItemIsUserCheckable;
    // Arrays have a curve of their own; there is no plot over time to drag them into.
    if (const int channel = channelOf(index); channel >= 0 && m_table[std::size_t(channel)].elements == 1)
        flags |= Qt::ItemIsDragEnabled;
    return flags;
}

QMimeData *ChannelModel::mimeData(const QModelIndexList &indexes) const
{
    QStringList channels;
    for (const QModelIndex &index : indexes) {
        const QString channel = QString::number(channelOf(index));
        if (channelOf(index) >= 0 && !channels.contains(channel))
            channels.append(channel);
    }
    auto *data = new QMimeData;
    data->setData(kMimeType, channels.join(u',').toLatin1());
    return data;
}

QList<int> ChannelModel::channelsOf(const QMimeData &data)
{
    QList<int> channels;
    const QList<QByteArray> parts = data.data(kMimeType).split(',');
    for (const QByteArray &part : parts) {
        bool ok = false;
        const int channel = part.toInt(&ok);
        if (ok)
            channels.append(channel);
    }
    return channels;
}

QVariant ChannelModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    return section == NameColumn ? tr("Channel") : section == ValueColumn ? tr("Now") : QString();
}
