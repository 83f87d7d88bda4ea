// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/streams.h"

#include <QAbstractItemModel>
#include <QSet>

class QMimeData;

/// A channel's value for people: what it means where that is known, else the number, without its unit.
[[nodiscard]] QString channelValueText(const ChannelSpec &spec, double value);

/// Telemetry channels in groups, each with a tick and its live value.
class ChannelModel final : public QAbstractItemModel
{
    Q_OBJECT
public:
    enum Column { NameColumn, ValueColumn, UnitColumn, ColumnCount };
    enum Role { ChannelRole = Qt::UserRole };
    /// MIME type of channels dragged to a plot.
    static const QString kMimeType;

    explicit ChannelModel(QObject *parent = nullptr);

    void reset(ChannelTable table, std::shared_ptr<const TelemetryStore> store);
    [[nodiscard]] QList<int> ticked() const;
    void setTicked(const QList<int> &channels);
    /// Picks up new values, with one dataChanged per group. At most 10 times a second.
    void refresh();

    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex &child) const override;
    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    [[nodiscard]] QStringList mimeTypes() const override { return {kMimeType}; }
    [[nodiscard]] QMimeData *mimeData(const QModelIndexList &indexes) const override;
    /// The channels in dragged data; empty if there are none.
    [[nodiscard]] static QList<int> channelsOf(const QMimeData &data);

signals:
    void ticksChanged();

private:
    [[nodiscard]] QString toolTip(int channel) const;
    struct Group
    {
        const char *name;
        QList<int> channels;
    };
    [[nodiscard]] int channelOf(const QModelIndex &index) const;

    ChannelTable m_table;
    std::shared_ptr<const TelemetryStore> m_store;
    std::vector<Group> m_groups;
    QSet<int> m_ticked;
};
