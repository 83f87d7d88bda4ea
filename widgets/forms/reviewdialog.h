// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/changemodel.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QTableView;

/// What will be written, before it is: board and new value side by side, red class first, a tick for each.
class ReviewDialog final : public QDialog
{
    Q_OBJECT
public:
    ReviewDialog(const Configuration &board, const Configuration &edited, QWidget *parent = nullptr);

    /// The configuration with the ticked changes.
    [[nodiscard]] Configuration chosen() const { return m_changes.ticked(); }
    [[nodiscard]] QTableView *table() const { return m_table; }
    [[nodiscard]] QPushButton *writeButton() const { return m_write; }

private:
    void updateButton();

    ChangeModel m_changes;
    QTableView *m_table;
    QLabel *m_risk;
    QLabel *m_effect;  // what writing means for the board
    QPushButton *m_write;
};
