// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/theme/tablelook.h"

#include <QHeaderView>
#include <QTableView>

void setPlainRows(QTableView &table)
{
    table.verticalHeader()->hide();
    table.setShowGrid(false);
    table.setTabKeyNavigation(false);
}

void setSelectableRows(QTableView &table)
{
    setPlainRows(table);
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.setSelectionMode(QAbstractItemView::SingleSelection);
    table.horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table.horizontalHeader()->setHighlightSections(false);
}
