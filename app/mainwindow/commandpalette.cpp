// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/commandpalette.h"

#include "widgets/theme/theme.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr int kMaxShown = 60;
constexpr int kIndexRole = Qt::UserRole;

}  // namespace

CommandPalette::CommandPalette(QList<PaletteEntry> entries, QWidget *parent)
    : QDialog(parent)
    , m_entries(std::move(entries))
    , m_input(new QLineEdit)
    , m_list(new QListWidget)
{
    setWindowTitle(tr("Go to or do"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(620, 440);
    m_input->setPlaceholderText(tr("Page, parameter, channel or action"));
    m_input->setAccessibleName(windowTitle());
    m_input->setClearButtonEnabled(true);
    m_input->installEventFilter(this);
    m_list->setAccessibleName(tr("Matches"));
    m_list->setUniformItemSizes(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *layout = new QVBoxLayout(this);
    layout->setSpacing(Metric::kGap);
    layout->addWidget(m_input);
    layout->addWidget(m_list, 1);
    connect(m_input, &QLineEdit::textChanged, this, &CommandPalette::refilter);
    connect(m_input, &QLineEdit::returnPressed, this, &CommandPalette::choose);
    connect(m_list, &QListWidget::itemActivated, this, &CommandPalette::choose);
    connect(m_list, &QListWidget::itemClicked, this, &CommandPalette::choose);
    refilter();
}

void CommandPalette::refilter()
{
    const auto words = m_input->text().toLower().split(u' ', Qt::SkipEmptyParts);
    m_list->clear();
    const auto matches = [&words](const PaletteEntry &entry) {
        return std::all_of(words.begin(), words.end(),
                           [&entry](const QString &word) { return entry.search.contains(word); });
    };
    // Entries that begin with the words come before those that merely contain them.
    const QString start = m_input->text().trimmed().toLower();
    for (const bool beginning : {true, false}) {
        for (qsizetype i = 0; i < m_entries.size() && m_list->count() < kMaxShown; ++i) {
            const PaletteEntry &entry = m_entries[i];
            if (entry.text.toLower().startsWith(start) != beginning || !matches(entry))
                continue;
            auto *item
                = new QListWidgetItem(u"%1:  %2   %3"_s.arg(entry.kind, entry.text, entry.hint), m_list);
            item->setData(kIndexRole, i);
        }
    }
    if (m_list->count() == 0)
        (new QListWidgetItem(tr("Nothing was found."), m_list))->setFlags(Qt::NoItemFlags);
    m_list->setCurrentRow(0);
}

void CommandPalette::choose()
{
    const QListWidgetItem *item = m_list->currentItem();
    if (!item || !item->flags().testFlag(Qt::ItemIsEnabled))
        return;
    const auto chosen = m_entries[item->data(kIndexRole).toInt()].chosen;
    accept();
    chosen();
}

bool CommandPalette::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown) {
            const int step = key == Qt::Key_Up ? -1
                : key == Qt::Key_Down          ? 1
                : key == Qt::Key_PageUp        ? -8
                                               : 8;
            m_list->setCurrentRow(
                std::clamp(m_list->currentRow() + step, 0, std::max(0, m_list->count() - 1)));
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}
