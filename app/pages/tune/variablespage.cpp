// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/tune/variablespage.h"

#include "app/workspace/question.h"
#include "widgets/forms/filtertable.h"
#include "widgets/forms/typingkeeper.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <tuple>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kRefreshPeriod = 500ms;

}  // namespace

VariablesPage::VariablesPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"variables"_s, tr("Adjustable variables"), parent)
    , m_model(workspace.client())
    , m_table(new FilterTable(m_model, AdjustableModel::SearchRole, workspace.theme()))
    , m_search(m_table->makeFilterField(tr("Search (Ctrl+F)"), tr("Search variables"), this))
    , m_live(new QCheckBox(tr("Keep reading")))
    , m_note(new QLabel)
{
    m_note->setObjectName(u"muted"_s);
    m_note->setWordWrap(true);
    m_note->setText(
        tr("A value set here takes effect at once and is forgotten at the next start unless it is stored. "
           "Numbers are the board's own; their meaning is shown beside them."));
    m_search->setMinimumWidth(180);
    m_live->setChecked(true);
    m_live->setToolTip(tr("Shows changes that the radio, a menu or another program makes"));
    auto *save = new QPushButton(tr("Store variables"));
    save->setToolTip(tr("Store the values in use in the active profile; a snapshot is taken first"));
    header()->addWidget(m_live);
    header()->addWidget(save);
    header()->addWidget(m_search);
    new TypingKeeper(*m_table, AdjustableModel::IdRole,
                     [this] { return this->workspace().client().identity().serial; });
    m_table->setAccessibleName(tr("Adjustable variables"));
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed
                             | QAbstractItemView::AnyKeyPressed);
    body()->addWidget(m_note);
    body()->addWidget(m_table, 1);

    connect(&m_model, &AdjustableModel::failed, this, [this](const Error &error) {
        if (!isEndOfLink(error))
            this->workspace().notifications().report(error);
    });
    connect(&m_model, &AdjustableModel::leapt, this, [this](const ParameterChange &change) {
        askAboutLeap(this->workspace(), change, this, [this, change] { m_model.agree(change); });
    });
    connect(&m_model, &AdjustableModel::written, &workspace.live(), &LiveModel::read);
    connect(save, &QPushButton::clicked, this, &VariablesPage::save);
    connect(&workspace.live(), &LiveModel::heldChanged, this, [this, save](bool held) {
        m_model.setHeld(held);
        save->setEnabled(!held);
    });
    m_model.setHeld(workspace.live().isHeld());
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &VariablesPage::onState);
    refreshWhileShown(
        kRefreshPeriod, [this] { m_model.refresh(); },
        [this] { return !m_live->isChecked() || m_table->isEditing(); });
    onState();
}

// What stands in a cell and was refused is not in use, and would not be stored.
void VariablesPage::save()
{
    const QModelIndex refused = m_model.refusedCell();
    if (!refused.isValid()) {
        std::ignore = workspace().saveLive(*this);
        return;
    }
    m_search->clear();
    const QModelIndex cell = m_table->fromSource(refused);
    m_table->setCurrentIndex(cell);
    m_table->scrollTo(cell);
    m_table->edit(cell);
}

void VariablesPage::onState()
{
    if (!workspace().client().isConnected())
        return;
    m_model.reset();
    m_model.refresh();
    m_table->setColumnWidth(AdjustableModel::NumberColumn, 52);
    m_table->setColumnWidth(AdjustableModel::NameColumn, 220);
    m_table->setColumnWidth(AdjustableModel::GroupColumn, 150);
    m_table->setColumnWidth(AdjustableModel::ValueColumn, 100);
    m_table->setColumnWidth(AdjustableModel::MeaningColumn, 230);
    m_table->setColumnWidth(AdjustableModel::RangeColumn, 130);
}
