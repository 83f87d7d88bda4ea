// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/blackbox.h"

#include <QAbstractTableModel>

#include <memory>

/// The lines of a black box as rows, with a column for each name: what was written there, or else what was
/// written last. Only lines of the columns that are shown have a row.
class BlackBoxModel final : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Role {
        ChangedRole = Qt::UserRole,  ///< it was written in this row, and is another value than before
        WrittenRole,  ///< it was written in this row
    };
    static constexpr int kTimeColumn = 0;

    explicit BlackBoxModel(QObject *parent = nullptr);

    /// @param box null: none
    void setBox(std::shared_ptr<const BlackBox> box);
    /// Shows only names that hold all of these words.
    void setFilter(const QString &words);
    /// The next row with a changed value in that column, or in any; -1: none.
    [[nodiscard]] int nextChange(int row, int column = -1) const;
    /// The column of a name, -1 if it is not shown.
    [[nodiscard]] int columnOf(const QByteArray &name) const;

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    void fill();
    [[nodiscard]] int lineFor(const QModelIndex &index) const;
    [[nodiscard]] bool isChanged(int line) const;

    std::shared_ptr<const BlackBox> m_box;
    QStringList m_words;
    std::vector<int> m_names;  // shown, in the order of their columns
    std::vector<int> m_rows;  // the lines that have one
    std::vector<std::vector<int>> m_linesOf;  // of each name, in order of time
};
