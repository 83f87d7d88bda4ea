// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/debugpage.h"

#include "widgets/views/card.h"
#include "widgets/views/sparkline.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kPeriod = 100ms;

} // namespace

DebugPage::DebugPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"debug"_s, tr("Debug variables"), parent)
    , m_model(workspace.client())
    , m_table(new QTableView)
    , m_curve(new Sparkline(workspace.theme()))
    , m_pause(new QPushButton(tr("Pause")))
{
    auto *clear = new QPushButton(tr("Forget bounds"));
    clear->setToolTip(tr("Start lowest, highest and the curve anew"));
    m_pause->setCheckable(true);
    header()->addWidget(clear);
    header()->addWidget(m_pause);
    m_table->setModel(&m_model);
    m_table->setAccessibleName(tr("Debug variables"));
    m_table->verticalHeader()->hide();
    m_table->setShowGrid(false);
    m_table->setTabKeyNavigation(false);
    m_table->setAlternatingRowColors(true);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeader()->setSectionResizeMode(DebugModel::NameColumn, QHeaderView::Stretch);
    auto *course = new Card(tr("Course"));
    course->content()->addWidget(m_curve, 1);
    auto *note = new QLabel(tr("What these variables mean is known to the firmware's makers only; they help a supporter."));
    note->setObjectName(u"muted"_s);
    note->setWordWrap(true);
    body()->addWidget(note);
    body()->addWidget(m_table, 3);
    body()->addWidget(course, 2);

    connect(clear, &QPushButton::clicked, &m_model, &DebugModel::clearHistory);
    connect(m_pause, &QPushButton::toggled, this, [this](bool on) { m_pause->setText(on ? tr("Continue") : tr("Pause")); });
    connect(&m_model, &DebugModel::refreshed, this, &DebugPage::showCurve);
    connect(&m_model, &DebugModel::modelReset, this, [this] {
        if (m_model.rowCount() > 0)
            m_table->selectRow(0);
    });
    connect(&m_model, &DebugModel::failed, this, [this](const Error &error) {
        if (error.code == ErrorCode::LinkClosed || error.code == ErrorCode::Cancelled)
            return;
        m_pause->setChecked(true);
        emit this->workspace().problem(describe(error));
    });
    connect(&workspace.client(), &DeviceClient::stateChanged, this, [this](DeviceClient::State state) {
        if (state == DeviceClient::State::Connected)
            m_model.reset();
    });
    m_timer.setInterval(kPeriod);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        if (!m_pause->isChecked())
            m_model.refresh();
    });
}

void DebugPage::showCurve()
{
    const QModelIndex current = m_table->currentIndex();
    if (current.isValid())
        m_curve->setValues(m_model.name(current.row()), m_model.history(current.row()));
}

void DebugPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    m_model.refresh();
    m_timer.start();
}

void DebugPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    m_timer.stop();
}
