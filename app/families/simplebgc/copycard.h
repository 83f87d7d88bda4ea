// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"
#include "widgets/views/card.h"

class QCheckBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QTableWidget;

/// Copies of what a board keeps besides its settings, made, compared with the board and written back by its
/// actions; each asks for a file first. The finding stands in one sentence, what differs in a table.
class CopyCard final : public Card
{
    Q_OBJECT
public:
    /// A button that does one action.
    struct Way
    {
        QString text;
        QString tip;
        QString action;
        bool makesCopy = false;  ///< it asks for a new file, otherwise for a copy
        QVariantMap arguments = {};
        bool isRed = false;
    };
    /// @param suggested name of a new file
    CopyCard(Workspace &workspace, const QString &title, const QString &text, const QString &suggested,
             const QList<Way> &ways, QWidget *parent = nullptr);

    /// Does it with this file.
    void run(const Way &way, const QString &path);
    [[nodiscard]] const QList<Way> &ways() const { return m_ways; }
    [[nodiscard]] QPushButton *button(int way) const { return m_buttons[way]; }
    [[nodiscard]] QCheckBox *other() const { return m_other; }
    [[nodiscard]] QString finding() const;
    [[nodiscard]] QTableWidget *table() const { return m_table; }
    [[nodiscard]] bool isRunning() const { return m_isRunning; }

private:
    void ask(const Way &way);
    void onDone(const Way &way, const Result<ActionOutcome> &outcome);
    void updateButtons();
    [[nodiscard]] QString sentence(const Way &way, const ActionReply &reply) const;
    void showRows(const ActionReply &reply);
    [[nodiscard]] QString nameOf(const QString &key) const;

    Workspace &m_workspace;
    QString m_suggested;
    QList<Way> m_ways;
    QList<QPushButton *> m_buttons;
    QPushButton *m_cancel;
    QCheckBox *m_other;
    QLabel *m_finding;
    QTableWidget *m_table;
    bool m_isRunning = false;
};
