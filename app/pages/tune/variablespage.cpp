// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/tune/variablespage.h"

#include "widgets/forms/filtertable.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QShortcut>
#include <QVBoxLayout>

#include <tuple>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kPeriod = 500ms;

}  // namespace

VariablesPage::VariablesPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"variables"_s, tr("Adjustable variables"), parent)
    , m_model(workspace.client())
    , m_table(new FilterTable(m_model, AdjustableModel::SearchRole))
    , m_search(new QLineEdit)
    , m_live(new QCheckBox(tr("Keep reading")))
    , m_note(new QLabel)
{
    m_note->setObjectName(u"muted"_s);
    m_note->setWordWrap(true);
    m_note->setText(
        tr("A value set here takes effect at once and is forgotten at the next start unless it is saved. "
           "Numbers are the board's own; the meaning stands beside them."));
    m_search->setPlaceholderText(tr("Search (Ctrl+F)"));
    m_search->setAccessibleName(tr("Search variables"));
    m_search->setClearButtonEnabled(true);
    m_search->setMinimumWidth(180);
    m_live->setChecked(true);
    m_live->setToolTip(tr("Shows changes that the radio, a menu or another program makes"));
    auto *save = new QPushButton(tr("Save variables"));
    save->setToolTip(tr("Store the values in use in the active profile; a snapshot is taken first"));
    header()->addWidget(m_live);
    header()->addWidget(save);
    header()->addWidget(m_search);
    m_table->setAccessibleName(tr("Adjustable variables"));
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed
                             | QAbstractItemView::AnyKeyPressed);
    body()->addWidget(m_note);
    body()->addWidget(m_table, 1);

    connect(m_search, &QLineEdit::textChanged, m_table, &FilterTable::setFilter);
    connect(&m_model, &AdjustableModel::failed, this, [this](const Error &error) {
        if (error.code != ErrorCode::LinkClosed && error.code != ErrorCode::Cancelled)
            this->workspace().notifications().report(error);
    });
    connect(&m_model, &AdjustableModel::written, &workspace.live(), &LiveModel::read);
    connect(save, &QPushButton::clicked, this, [this] { std::ignore = this->workspace().saveLive(); });
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &VariablesPage::onState);
    m_timer.setInterval(kPeriod);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        if (m_live->isChecked() && !m_table->isEditing())
            m_model.refresh();
    });
    new QShortcut(QKeySequence::Find, this, [this] { m_search->setFocus(); });
    onState();
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

void VariablesPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    m_model.refresh();
    m_timer.start();
}

void VariablesPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    m_timer.stop();
}
