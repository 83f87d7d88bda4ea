// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of the main window, and where they and names lead: to reviews, pages and actions.
#include "app/mainwindow/commandpalette.h"
#include "app/mainwindow/editguide.h"
#include "app/mainwindow/mainwindow.h"
#include "app/mainwindow/messagehistory.h"
#include "app/mainwindow/navigation.h"
#include "app/mainwindow/palettesource.h"
#include "app/pages/board/actionspage.h"
#include "app/workspace/question.h"
#include "protocol/device/flight.h"
#include "widgets/forms/panel.h"

#include <QApplication>
#include <QShortcut>

using namespace Qt::StringLiterals;

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
           [this, i] { enterPage(m_navigation->pageOfNumber(i + 1)); });
    // Where values are set live, what was set there last.
    const auto stepBack = [this](bool again) {
        LiveModel &live = m_workspace->live();
        const bool isLive = m_navigation->currentPage() == u"tuning"_s;
        if (isLive && (again ? live.canRedo() : live.canUndo()))
            again ? live.redo() : live.undo();
        else
            again ? m_workspace->edits().redo() : m_workspace->edits().undo();
    };
    on(QKeySequence::Undo, [stepBack] { stepBack(false); });
    // As the platform has it, and as others do; one key twice would do nothing.
    QList<QKeySequence> redo = QKeySequence::keyBindings(QKeySequence::Redo);
    for (const QKeySequence &keys :
         {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)}) {
        if (!redo.contains(keys))
            redo.append(keys);
    }
    for (const QKeySequence &keys : std::as_const(redo))
        on(keys, [stepBack] { stepBack(true); });
    m_guide = new EditGuide(
        *m_workspace, [this](const QString &key) { return showPage(key), page(key); }, m_content);
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

void MainWindow::showAction(const QString &key)
{
    if (enterPage(u"actions"_s))
        static_cast<ActionsPage *>(page(u"actions"_s))->showAction(key);
}

void MainWindow::review()
{
    ConfigurationModel &model = m_workspace->configuration();
    if (m_review || model.isEmpty() || !m_workspace->client().isConnected()
        || !m_workspace->client().identity().writable)
        return;
    // A value still being typed belongs to the edits as well; one that is refused would be missed.
    if (QWidget *focus = QApplication::focusWidget()) {
        focus->clearFocus();
        focus->setFocus();
    }
    if (m_guide->showRefused() || model.changeCount() == 0)
        return;
    if (m_guide->showContradiction())
        return;
    m_review = new ReviewDialog(model.board(), model.edited(), m_workspace->storedWithAWrite(), this);
    m_review->setReplaced(m_workspace->replacedByAWrite());
    m_review->setFlies(m_workspace->notifications().flies());
    m_review->setDoubtsOf([this](const Configuration &wanted) {
        const Device *device = m_workspace->client().device();
        return device && device->flight()
            ? device->flight()->doubts(wanted, std::as_const(m_workspace->configuration()).board())
            : std::vector<ScriptMistake>();
    });
    m_review->setAttribute(Qt::WA_DeleteOnClose);
    // What it compares with is old then.
    connect(&model, &ConfigurationModel::boardReset, m_review, &QDialog::reject);
    connect(m_review, &QDialog::accepted, this,
            [this] { m_workspace->write(m_review->chosen(), m_review->others()); });
    openPanel(*m_review);
}

void MainWindow::showPalette()
{
    if (m_palette)
        return;
    const PaletteTargets targets{
        [this](const QString &key) {
            enterPage(key);
            return page(key);
        },
        [this](const QString &key) { showAction(key); },
        [this] { review(); },
        [this] { askToStartMotors(*m_workspace, this); },
        [this] { openPanel(*new MessageHistory(m_workspace->notifications(), this)); },
        [this] { askOpenFile(); }};
    m_palette = new CommandPalette(paletteEntries(*m_workspace, *m_navigation, targets), this);
    m_palette->input()->setFocus();
    openPanel(*m_palette);
}
