// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/client/deviceclient.h"
#include "protocol/device/abilities.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/models/tablemodel.h"

/// The firmware's debug variables with their values as they come, kept in a store of their own for plots.
class DebugModel final : public TableModel
{
    Q_OBJECT
public:
    enum Column { NameColumn, TypeColumn, AxisColumn, ValueColumn, LowColumn, HighColumn, ColumnCount };
    explicit DebugModel(DeviceClient &client, QObject *parent = nullptr);

    void reset();
    /// Asks for all values, and first for the list of variables if it is unknown; unless a request is
    /// pending.
    void refresh();
    /// Resets lowest and highest values.
    void clearBounds();

    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;

    [[nodiscard]] QString name(int row) const;
    /// The variables as channels: a row's number is its channel. Both are new after a reset of the model.
    [[nodiscard]] ChannelTable table() const { return m_table; }
    [[nodiscard]] std::shared_ptr<const TelemetryStore> store() const { return m_store; }

signals:
    void refreshed();
    void failed(const Error &error);

private:
    [[nodiscard]] int rows() const override { return int(m_rows.size()); }
    struct Row
    {
        QString name;
        QString type;
        Axis axis = Axis::None;
        bool known = true;  // a type we can read
        double value = 0;
        double low = 0;
        double high = 0;
    };
    void setVariables(const std::vector<DebugVariable> &variables);
    void setValues(const std::vector<std::vector<double>> &values, TimePoint at);

    DeviceClient &m_client;
    std::vector<Row> m_rows;
    std::vector<QByteArray> m_names;  // what the table's keys point to
    std::vector<ChannelSpec> m_table;
    std::shared_ptr<TelemetryStore> m_store;
    std::shared_ptr<TelemetryGroup> m_group;
    bool m_asking = false;
    bool m_listed = false;
    int m_generation = 0;
};
