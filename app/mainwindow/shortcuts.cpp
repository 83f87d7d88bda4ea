// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of the main window.
#include "app/mainwindow/mainwindow.h"
#include "app/mainwindow/navigation.h"

#include <QShortcut>

namespace {

constexpr int kNumberedPages = 9;

}  // namespace

void MainWindow::addShortcuts()
{
    const auto on = [this](const QKeySequence &keys, auto action) {
        // Of the content: none of them while a panel is open.
        connect(new QShortcut(keys, m_content), &QShortcut::activated, this, action);
    };
    for (int i = 0; i < kNumberedPages; ++i)
        on(QKeySequence(Qt::CTRL | Qt::Key(Qt::Key_1 + i)),
           [this, i] { showPage(m_navigation->pageOfNumber(i + 1)); });
    QUndoStack *stack = &m_workspace->edits().undoStack();
    on(QKeySequence::Undo, [stack] { stack->undo(); });
    on(QKeySequence::Redo, [stack] { stack->redo(); });
    on(QKeySequence(Qt::CTRL | Qt::Key_S), [this] {
        if (m_workspace->client().isConnected())
            review();
        else if (!m_workspace->configuration().isEmpty())
            askSaveFile();
    });
    on(QKeySequence(Qt::CTRL | Qt::Key_O), [this] { askOpenFile(); });
    on(QKeySequence(Qt::CTRL | Qt::Key_K), [this] { showPalette(); });
    on(QKeySequence(Qt::Key_F1), [this] { showHelp(); });
    on(QKeySequence(QKeySequence::Refresh), [this] {
        if (m_workspace->client().isConnected())
            m_workspace->readBoard();
    });
}
