// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "widgets/models/blackboxmodel.h"

class QLineEdit;
class QPushButton;
class QTableView;

/// The black box that is played, as a table: its lines in order of time, with changed values marked.
class BlackBoxPage final : public Page
{
    Q_OBJECT
public:
    explicit BlackBoxPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] BlackBoxModel &model() { return m_model; }
    [[nodiscard]] QTableView *table() const { return m_table; }

protected:
    void showEvent(QShowEvent *event) override;

private:
    void read();
    void showBox(std::shared_ptr<const BlackBox> box);
    void goToNextChange();

    BlackBoxModel m_model;
    QTableView *m_table;
    QLineEdit *m_filter;
    QPushButton *m_next;
    QLabel *m_found;
    QString m_path;  // of what is shown
};
