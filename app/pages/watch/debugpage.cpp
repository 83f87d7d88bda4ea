// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/watch/debugpage.h"

#include "widgets/plot/plotstack.h"
#include "widgets/theme/tablelook.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kPeriod = 100ms;
constexpr double kSeconds = 30;
constexpr qsizetype kMaxCurves = 6;

}  // namespace

DebugPage::DebugPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"debug"_s, tr("Debug variables"), parent)
    , m_model(workspace.client())
    , m_table(new QTableView)
    , m_plots(new PlotStack(workspace.theme()))
    , m_pause(new QPushButton(tr("Pause")))
{
    auto *clear = new QPushButton(tr("Reset bounds"));
    clear->setToolTip(tr("Reset the lowest and highest values"));
    m_pause->setCheckable(true);
    header()->addWidget(clear);
    header()->addWidget(m_pause);
    m_table->setModel(&m_model);
    m_table->setAccessibleName(tr("Debug variables"));
    setPlainRows(*m_table);
    m_table->setAlternatingRowColors(true);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setToolTip(tr("Choose several with Ctrl or Shift to see them together"));
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeader()->setDefaultSectionSize(
        m_table->fontMetrics().horizontalAdvance(u"-0.0000000000"_s) + Metric::kMargin);
    m_table->horizontalHeader()->setSectionResizeMode(DebugModel::NameColumn, QHeaderView::Stretch);
    m_plots->setSeconds(kSeconds);
    auto *note = new QLabel(tr(
        "Only the firmware's makers know what these variables mean; they are useful for technical support."));
    note->setObjectName(u"muted"_s);
    note->setWordWrap(true);
    body()->addWidget(note);
    body()->addWidget(m_table, 3);
    auto *plots = new QWidget;
    auto *plotsLayout = new QVBoxLayout(plots);
    plotsLayout->setContentsMargins(0, 0, 0, 0);
    plotsLayout->addWidget(m_plots);
    body()->addWidget(plots, 3);
    coverWhenStale(*plots, {}, StaleCover::Look::Tag);
    fadeWhenStale(*m_table, *m_table->horizontalHeader(), DebugModel::ValueColumn);

    connect(clear, &QPushButton::clicked, &m_model, &DebugModel::clearBounds);
    connect(m_pause, &QPushButton::toggled, this, [this](bool on) {
        m_pause->setText(on ? tr("Continue") : tr("Pause"));
        m_plots->setPaused(on);
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &DebugPage::showCurves);
    connect(m_plots, &PlotStack::pausedChanged, m_pause, &QPushButton::setChecked);
    connect(&m_model, &DebugModel::modelReset, this, [this] {
        if (m_model.rowCount() > 0)
            m_table->selectRow(0);
    });
    connect(&m_model, &DebugModel::failed, this, [this](const Error &error) {
        if (isEndOfLink(error))
            return;
        m_pause->setChecked(true);
        this->workspace().notifications().report(error);
    });
    connect(&workspace.client(), &DeviceClient::stateChanged, this, [this](DeviceClient::State state) {
        if (state == DeviceClient::State::Connected)
            m_model.reset();
    });
    refreshWhileShown(
        kPeriod, [this] { m_model.refresh(); }, [this] { return m_pause->isChecked(); });
}

// All in one plot, each with its own scale, because their units are unknown.
void DebugPage::showCurves()
{
    QList<int> channels;
    const QModelIndexList rows = m_table->selectionModel()->selectedRows();
    for (const QModelIndex &row : rows.first(std::min<qsizetype>(rows.size(), kMaxCurves)))
        channels.append(row.row());
    std::sort(channels.begin(), channels.end());
    m_plots->setPlots({});
    m_plots->setSource(m_model.table(), m_model.store());
    if (!channels.isEmpty())
        m_plots->setPlots({{channels, channels.size() > 1, false}});
}
