// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/configurationmodel.h"

#include <QAbstractTableModel>

/// The profiles of a board as rows: number, name, state, unsaved changes, difference to the active one.
class ProfileModel final : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Column { NumberColumn, NameColumn, StateColumn, ChangesColumn, DifferenceColumn, ColumnCount };

    explicit ProfileModel(ConfigurationModel &configuration, QObject *parent = nullptr);
    /// Longest name in UTF-8 bytes; longer ones are refused.
    void setNameLimit(int bytes) { m_nameLimit = bytes; }

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

signals:
    /// Somebody typed a name; whoever owns the undo stack makes an edit of it.
    void renameRequested(int profile, const QString &name);
    void nameRefused(int profile, int bytes, int limit);

private:
    void refresh();
    [[nodiscard]] int differences(int profile) const;

    ConfigurationModel &m_configuration;
    int m_nameLimit = 48;
    std::vector<int> m_changes;
    std::vector<int> m_differences;
};
