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
    /// While they are held, none can be set.
    void setHeld(bool held) { m_held = held; }
    /// Asks the board for all values, unless a request is still pending.
    void refresh();

    /// The first cell with a text that is no value; invalid without one.
    [[nodiscard]] QModelIndex refusedCell() const;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    /// Not where it is a leap (isLeap()) from what is in use: leapt() tells of it then.
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;
    /// Sets what stands behind a variable, leap or not: the operator has been asked.
    void agree(const ParameterChange &change);
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;

signals:
    void failed(const Error &error);
    /// A value was set and confirmed.
    void written(int id, double value);
    /// It is not set unless agree() follows.
    void leapt(const ParameterChange &change);

private:
    void write(int id, double value);
    [[nodiscard]] int rows() const override { return int(m_specs.size()); }
    /// Whole numbers, unless the parameter behind it is a float.
    [[nodiscard]] bool isFloat(int row) const;
    [[nodiscard]] QString keyOf(int row) const { return QLatin1String(m_specs[std::size_t(row)].key); }
    [[nodiscard]] QString meaning(int row) const;

    DeviceClient &m_client;
    std::span<const AdjustableSpec> m_specs;
    std::shared_ptr<const ParameterSet> m_parameters;
    std::vector<const ParameterSpec *>
        m_behind;  // the parameter behind each variable, null where there is none
    std::vector<std::optional<double>> m_values;
    QMap<QString, QString> m_refused;  // what was typed and is no value, by the variable's key
    QString m_serial;  // of the board that it was typed for
    bool m_asking = false;
    bool m_held = false;
};
