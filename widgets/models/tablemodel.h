// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QMetaType>
#include <QStringList>

/// What the cell of a number takes.
struct NumberRange
{
    double low = 0;
    double high = 0;
    int decimals = 0;
};
Q_DECLARE_METATYPE(NumberRange)

/// A table with a title above each column. It provides rows, columns and titles; derived models provide the
/// cells.
class TableModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    /// Of cells that can be edited, in every model: the NumberRange of one that holds a number, and a text
    /// that was typed into it and is no value of it (setData() keeps it; invalid: it is gone).
    enum CellRole { NumberRole = Qt::UserRole + 1000, RefusedRole };

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const final;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const final;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

protected:
    /// @param titles of the columns, in their order
    TableModel(QStringList titles, QObject *parent);

    [[nodiscard]] virtual int rows() const = 0;
    /// Refills the table within a model reset.
    template <typename Fill> void resetWith(Fill fill)
    {
        beginResetModel();
        fill();
        endResetModel();
    }
    /// Reports a change in all rows, from one column to another.
    void tellAllChanged(int firstColumn, int lastColumn, const QList<int> &roles = {});

private:
    QStringList m_titles;
};
