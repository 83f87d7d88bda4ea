// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/tablemodel.h"

TableModel::TableModel(QStringList titles, QObject *parent)
    : QAbstractTableModel(parent)
    , m_titles(std::move(titles))
{
}

int TableModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : rows();
}

int TableModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : int(m_titles.size());
}

QVariant TableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole || section >= m_titles.size())
        return {};
    return m_titles.value(section);
}

void TableModel::tellAllChanged(int firstColumn, int lastColumn, const QList<int> &roles)
{
    if (rows() > 0)
        emit dataChanged(index(0, firstColumn), index(rows() - 1, lastColumn), roles);
}
