// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/client/deviceclient.h"
#include "protocol/device/abilities.h"
#include "widgets/models/tablemodel.h"

/// All live-adjustable variables of a board with the values in use, by the board's own numbers.
class AdjustableModel final : public TableModel
{
    Q_OBJECT
public:
    enum Column {
        NumberColumn,
        NameColumn,
        GroupColumn,
        ValueColumn,
        MeaningColumn,
        RangeColumn,
        KeyColumn,
        ColumnCount
    };
    enum Role { IdRole = Qt::UserRole, SearchRole };

    explicit AdjustableModel(DeviceClient &client, QObject *parent = nullptr);

    /// Another board (or none).
    void reset();
    /// Asks the board for all values, unless a request is still pending.
    void refresh();

    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;

signals:
    void failed(const Error &error);
    /// A value was set and confirmed.
    void written(int id, double value);

private:
    [[nodiscard]] int rows() const override { return int(m_specs.size()); }
    /// Whole numbers, unless the parameter behind it is a float.
    [[nodiscard]] bool isFloat(int row) const;
    [[nodiscard]] QString meaning(int row) const;

    DeviceClient &m_client;
    std::span<const AdjustableSpec> m_specs;
    std::shared_ptr<const ParameterSet> m_parameters;
    std::vector<const ParameterSpec *>
        m_behind;  // the parameter behind each variable, null where there is none
    std::vector<std::optional<double>> m_values;
    bool m_asking = false;
};
