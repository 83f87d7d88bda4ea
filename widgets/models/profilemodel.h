// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/configurationmodel.h"
#include "widgets/models/tablemodel.h"

/// The profiles of a board as rows: number, name, state, unsaved changes, difference to the active one.
class ProfileModel final : public TableModel
{
    Q_OBJECT
public:
    enum Column { NumberColumn, NameColumn, StateColumn, ChangesColumn, DifferenceColumn, ColumnCount };

    explicit ProfileModel(ConfigurationModel &configuration, QObject *parent = nullptr);
    /// Longest name in UTF-8 bytes; longer ones are refused.
    void setNameLimit(int bytes) { m_nameLimit = bytes; }

    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;

signals:
    /// Somebody typed a name; whoever owns the undo stack makes an edit of it.
    void renameRequested(int profile, const QString &name);
    void nameRefused(int profile, const QString &name, int limit);

private:
    [[nodiscard]] int rows() const override { return int(m_changes.size()); }
    void refresh();
    [[nodiscard]] int differences(int profile) const;

    ConfigurationModel &m_configuration;
    int m_nameLimit = 48;
    std::vector<int> m_changes;
    std::vector<int> m_differences;
};
