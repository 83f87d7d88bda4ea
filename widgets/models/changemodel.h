// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"
#include "widgets/models/tablemodel.h"

/// The differences that are about to be written, red class first, each one with a tick.
class ChangeModel final : public TableModel
{
    Q_OBJECT
public:
    enum Column { NameColumn, ProfileColumn, BoardColumn, EditedColumn, ColumnCount };
    enum Role { RedRole = Qt::UserRole };

    ChangeModel(Configuration board, Configuration edited, QObject *parent = nullptr);

    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    [[nodiscard]] int tickedCount() const;
    [[nodiscard]] int tickedProfiles() const;
    [[nodiscard]] bool hasTickedRed() const;
    /// Those that are leaps (isLeap()).
    [[nodiscard]] std::vector<ParameterChange> tickedLeaps() const;
    /// Whether writing what is ticked does this.
    [[nodiscard]] bool hasTicked(WriteEffect effect) const;
    /// Whether a text is among what is ticked.
    [[nodiscard]] bool hasTickedText() const;
    /// The board's configuration with the ticked changes only.
    [[nodiscard]] Configuration ticked() const;

signals:
    void ticksChanged();

private:
    struct Row
    {
        ParameterChange change;  // spec is null for a profile's name, and for data
        DataChange data = {};  // spec is null for everything else
        bool ticked = true;
        QString lines = {};  // of a text: how many change
    };
    [[nodiscard]] bool isRed(const Row &row) const;
    [[nodiscard]] QString linesText(const DataChange &change) const;
    [[nodiscard]] int rows() const override { return int(m_rows.size()); }
    Configuration m_board;  // copies: reconnecting must not change the values during a review
    Configuration m_edited;
    std::vector<Row> m_rows;
};
