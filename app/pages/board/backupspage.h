// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

class QLabel;
class QPushButton;
class QTableWidget;

/// The snapshots of this board: what differs from now, and how to go back.
class BackupsPage final : public Page
{
    Q_OBJECT
public:
    explicit BackupsPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] QTableWidget *table() const { return m_table; }
    [[nodiscard]] QPushButton *takeButton() const { return m_take; }

protected:
    void showEvent(QShowEvent *event) override;

private:
    void makeHeader();
    void makeBody();
    void connectAll();
    void askName();
    void restore();
    void askBeforeRestoring();
    void askWhatIsOpen();
    void reload();
    void showDifferences();
    [[nodiscard]] QString chosenPath() const;
    /// Of its sensors, which is no setting.
    [[nodiscard]] bool hasCalibration() const;

    QTableWidget *m_table;
    QTableWidget *m_differences;
    QLabel *m_summary;
    QPushButton *m_take;
    QPushButton *m_restore;
    QPushButton *m_export;
    QLabel *m_board;
    QPushButton *m_which;
    QLabel *m_lacking;
};
