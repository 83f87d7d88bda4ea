// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

class QPushButton;
class QTableWidget;

/// What a drone has recorded: names and sizes (errata 7.6). Its protocol offers no more.
class RecordingsPage final : public Page
{
    Q_OBJECT
public:
    explicit RecordingsPage(Workspace &workspace, QWidget *parent = nullptr);

    /// Asks the drone for its list.
    void read();
    /// Shows a list as the drone tells it.
    void showList(const QByteArray &list);
    [[nodiscard]] QTableWidget *table() const { return m_table; }

protected:
    void showEvent(QShowEvent *event) override;

private:
    void showState();

    QTableWidget *m_table;
    QPushButton *m_refresh;
    QLabel *m_found;
    QString m_finding;
    bool m_isReading = false;
    bool m_isRead = false;  // since this link began
};
