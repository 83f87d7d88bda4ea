// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/deviceclient.h"

#include <QAbstractTableModel>

#include <deque>

/// The firmware's debug variables with their values as they come, and a short history of each for a small curve.
class DebugModel final : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Column { NameColumn, TypeColumn, AxisColumn, ValueColumn, LowColumn, HighColumn, ColumnCount };
    static constexpr std::size_t kHistory = 600;

    explicit DebugModel(DeviceClient &client, QObject *parent = nullptr);

    void reset();
    /// Asks for all values; the list of variables first, if it is not known. Not twice at a time.
    void refresh();
    /// Forgets lowest and highest values and the history.
    void clearHistory();

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    [[nodiscard]] QString name(int row) const;
    /// Latest values, oldest first.
    [[nodiscard]] const std::deque<double> &history(int row) const { return m_rows[std::size_t(row)].history; }

signals:
    void refreshed();
    void failed(const Error &error);

private:
    struct Row
    {
        QString name;
        QString type;
        Axis axis = Axis::None;
        bool known = true;        // a type we can read
        double value = 0;
        double low = 0;
        double high = 0;
        std::deque<double> history;
    };
    void setVariables(const std::vector<DebugVariable> &variables);
    void setValues(const std::vector<std::vector<double>> &values);

    DeviceClient &m_client;
    std::vector<Row> m_rows;
    bool m_asking = false;
    bool m_listed = false;
    int m_generation = 0;
};
