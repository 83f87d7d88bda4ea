// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/monitorpage.h"

#include "widgets/plot/plotview.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kValuePeriod = 100ms;
constexpr qint64 kSlowFrameMs = 12;     // a frame over this, a few times in a row, halves the rate
constexpr int kSlowFramesInARow = 5;
constexpr std::array<double, 6> kWindows{2, 5, 10, 30, 60, 600};
constexpr int kDefaultWindow = 2;

} // namespace

MonitorPage::MonitorPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"monitor"_s, tr("Monitor"), parent)
    , m_tree(new QTreeView)
    , m_stack(new QSplitter(Qt::Vertical))
    , m_empty(new QLabel(tr("Tick channels on the left to see them here.")))
    , m_window(new QComboBox)
    , m_pause(new QPushButton(tr("Pause")))
    , m_note(new QLabel)
{
    for (const double seconds : kWindows)
        m_window->addItem(seconds < 120 ? tr("%1 s").arg(seconds) : tr("%1 min").arg(seconds / 60), seconds);
    m_window->setCurrentIndex(kDefaultWindow);
    m_window->setAccessibleName(tr("Time shown"));
    m_window->setToolTip(tr("Time shown"));
    m_pause->setCheckable(true);
    m_pause->setToolTip(tr("Hold the picture still; recording goes on"));
    m_note->setObjectName(u"muted"_s);
    header()->addWidget(m_note);
    header()->addWidget(m_window);
    header()->addWidget(m_pause);

    m_tree->setModel(&m_channels);
    m_tree->setAccessibleName(tr("Telemetry channels"));
    m_tree->setUniformRowHeights(true);
    m_tree->setRootIsDecorated(true);
    m_tree->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(ChannelModel::NameColumn, QHeaderView::Stretch);
    m_tree->setIndentation(14);
    m_tree->setMinimumWidth(292);
    m_stack->setChildrenCollapsible(false);
    m_empty->setObjectName(u"muted"_s);
    m_empty->setAlignment(Qt::AlignCenter);
    auto *right = new QWidget;
    auto *rightLayout = new QVBoxLayout(right);
    rightLayout->setContentsMargins(0, 0, 0, 0);
    rightLayout->addWidget(m_stack, 1);
    rightLayout->addWidget(m_empty);
    auto *split = new QSplitter;
    split->addWidget(m_tree);
    split->addWidget(right);
    split->setStretchFactor(1, 1);
    split->setSizes({330, 900});
    body()->addWidget(split, 1);

    m_frameTimer.setTimerType(Qt::PreciseTimer);
    connect(&m_frameTimer, &QTimer::timeout, this, &MonitorPage::frame);
    m_valueTimer.setInterval(kValuePeriod);
    connect(&m_valueTimer, &QTimer::timeout, this, [this] {
        m_channels.refresh();
        updateNote();
    });
    connect(&m_channels, &ChannelModel::ticksChanged, this, &MonitorPage::onTicks);
    connect(m_window, &QComboBox::currentIndexChanged, this, [this] {
        for (PlotView *plot : m_plots)
            plot->setWindow(m_window->currentData().toDouble());
        updateRate();
    });
    connect(m_pause, &QPushButton::toggled, this, [this](bool on) {
        m_pause->setText(on ? tr("Continue") : tr("Pause"));
        for (PlotView *plot : m_plots)
            plot->setPaused(on);
    });
    connect(&workspace.client(), &DeviceClient::stateChanged, this, [this](DeviceClient::State state) {
        if (state == DeviceClient::State::Connected)
            onStore();
    });
}

void MonitorPage::onStore()
{
    DeviceClient &client = workspace().client();
    m_channels.reset(client.device()->channels(), client.telemetry());
    if (!m_chosen) {
        m_chosen = true;
        const ChannelRoles roles = client.device()->roles();
        QList<int> first(roles.angle.begin(), roles.angle.end());
        first.append(QList<int>(roles.gyro.begin(), roles.gyro.end()));
        m_channels.setTicked(first);
    }
    m_tree->expandToDepth(0);
    for (int row = 3; row < m_channels.rowCount(); ++row)
        m_tree->collapse(m_channels.index(row, 0));
    m_tree->setColumnWidth(ChannelModel::ValueColumn, 64);
    m_tree->setColumnWidth(ChannelModel::UnitColumn, 44);
    onTicks();
}

void MonitorPage::onTicks()
{
    DeviceClient &client = workspace().client();
    if (!client.device())
        return;
    const ChannelTable table = client.device()->channels();
    const QList<int> ticked = m_channels.ticked();
    workspace().wishTelemetry(this, ticked);
    // One plot per unit: values of different kinds never share a scale.
    QList<std::pair<QString, QList<int>>> byUnit;
    for (const int channel : ticked) {
        const QString unit = QString::fromUtf8(table[std::size_t(channel)].unit);
        const auto it = std::find_if(byUnit.begin(), byUnit.end(), [&](const auto &entry) { return entry.first == unit; });
        if (it == byUnit.end())
            byUnit.append({unit, {channel}});
        else
            it->second.append(channel);
    }
    while (m_plots.size() > byUnit.size())
        delete m_plots.takeLast();
    while (m_plots.size() < byUnit.size()) {
        auto *plot = new PlotView(workspace().theme());
        plot->setWindow(m_window->currentData().toDouble());
        plot->setPaused(m_pause->isChecked());
        m_stack->addWidget(plot);
        m_plots.append(plot);
    }
    for (qsizetype i = 0; i < byUnit.size(); ++i)
        m_plots[i]->setChannels(table, byUnit[i].second, client.telemetry());
    m_empty->setVisible(byUnit.isEmpty());
    updateRate();
}

void MonitorPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    m_valueTimer.start();
    updateRate();
    m_frameTimer.start();
}

void MonitorPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    m_frameTimer.stop();
    m_valueTimer.stop();
}

void MonitorPage::frame()
{
    if (window()->isMinimized())
        return;
    QElapsedTimer timer;
    timer.start();
    for (PlotView *plot : m_plots)
        plot->advance();
    m_slowFrames = timer.elapsed() > kSlowFrameMs ? m_slowFrames + 1 : 0;
    if (m_slowFrames >= kSlowFramesInARow && m_rateDivider < 4) {
        m_slowFrames = 0;
        m_rateDivider *= 2;
        updateRate();
    }
}

void MonitorPage::updateRate()
{
    int rate = 10;
    for (const PlotView *plot : m_plots)
        rate = std::max(rate, plot->usefulRate());
    m_frameTimer.setInterval(1000 / std::max(5, rate / m_rateDivider));
}

void MonitorPage::updateNote()
{
    const auto store = workspace().client().telemetry();
    const TelemetryPlan &plan = workspace().client().telemetryPlan();
    if (!store || !workspace().client().isConnected()) {
        m_note->clear();
        return;
    }
    QString text = plan.streaming ? tr("%1 samples/s").arg(plan.rate, 0, 'f', 0)
                                  : tr("polled, up to %1 samples/s").arg(plan.rate, 0, 'f', 0);
    text += u" · "_s + tr("%1 lost").arg(store->lost());
    m_note->setText(text);
}
