// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

/// What a drone tells of its board, its sensors and its cameras, as a tree (errata 7.5). What cannot be read
/// as one is shown line by line, as it came.
class SystemPage final : public Page
{
    Q_OBJECT
public:
    enum Part { Board, Sensors, Cameras, PartCount };

    explicit SystemPage(Workspace &workspace, QWidget *parent = nullptr);

    /// Asks the drone for all of it.
    void read();
    /// Shows what it said of a part.
    void showText(Part part, const QString &text);
    /// All that is shown, as text: a line each, with what belongs to something indented.
    [[nodiscard]] QString text() const;
    [[nodiscard]] QTreeWidget *tree() const { return m_tree; }

protected:
    void showEvent(QShowEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    void readPart(Part part);
    void showNote(Part part, const QString &note);
    void showState();
    [[nodiscard]] QTreeWidgetItem *clearedPart(Part part);
    [[nodiscard]] static QString partName(Part part);

    QTreeWidget *m_tree;
    QPushButton *m_refresh;
    QPushButton *m_copy;
    QLabel *m_message;
    QDateTime m_readAt;
    int m_open = 0;  // answers that are still to come
    bool m_isRead = false;  // since this link began
};
