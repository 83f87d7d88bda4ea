// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/monitorpage.h"

#include "protocol/record/telemetrycsv.h"
#include "widgets/plot/plotview.h"

#include <QComboBox>
#include <QDateTime>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QSaveFile>
#include <QShortcut>
#include <QSplitter>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kValuePeriod = 100ms;
constexpr std::array<double, 6> kWindows{2, 5, 10, 30, 60, 600};
constexpr int kDefaultWindow = 2;
constexpr double kShortestWindow = 0.1;
constexpr double kLongestWindow = 3600;

} // namespace

MonitorPage::MonitorPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"monitor"_s, tr("Monitor"), parent)
    , m_tree(new QTreeView)
    , m_stack(new QSplitter(Qt::Vertical))
    , m_empty(new QLabel(tr("Tick channels on the left to see them here.")))
    , m_window(new QComboBox)
    , m_pause(new QPushButton(tr("Pause")))
    , m_export(new QPushButton(tr("Export…")))
    , m_record(new QPushButton)
    , m_recordMenu(new QMenu(m_record))
    , m_note(new QLabel)
{
    for (const double seconds : kWindows)
        m_window->addItem(seconds < 120 ? tr("%1 s").arg(seconds) : tr("%1 min").arg(seconds / 60), seconds);
    m_window->setCurrentIndex(kDefaultWindow);
    m_window->setAccessibleName(tr("Time shown"));
    m_window->setToolTip(tr("Time shown"));
    m_pause->setCheckable(true);
    m_pause->setToolTip(tr("Hold the picture still while data goes on (Space in the plot). The wheel zooms, dragging moves, "
                           "arrow keys move the cursor, End goes on."));
    m_note->setObjectName(u"muted"_s);
    header()->addWidget(m_note);
    header()->addWidget(m_window);
    header()->addWidget(m_pause);
    header()->addWidget(m_record);
    header()->addWidget(m_export);
    m_recordMenu->addAction(tr("Record from now on…"), this, [this] {
        askRecording(tr("Record to a file"), &LinkRecorder::start);
    });
    m_recordMenu->addAction(tr("Save the last minutes…"), this, [this] {
        askRecording(tr("Save the last minutes"), &LinkRecorder::savePast);
    });
    m_record->setToolTip(tr("Everything on the link goes into a file that can be opened like the board"));
    connect(m_record, &QPushButton::clicked, this, [this] { this->workspace().recorder().stop(); });
    connect(&workspace.recorder(), &LinkRecorder::recordingChanged, this, &MonitorPage::updateRecord);
    updateRecord();
    m_export->setToolTip(tr("Save what is seen as a CSV file"));
    connect(m_export, &QPushButton::clicked, this, &MonitorPage::askExport);
    auto *space = new QShortcut(Qt::Key_Space, m_stack, m_pause, &QPushButton::toggle);
    space->setContext(Qt::WidgetWithChildrenShortcut);

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
    split->restoreState(workspace.settings().layout(u"monitor"_s));
    connect(split, &QSplitter::splitterMoved, this,
            [this, split] { this->workspace().settings().setLayout(u"monitor"_s, split->saveState()); });
    body()->addWidget(split, 1);

    m_valueTimer.setInterval(kValuePeriod);
    connect(&m_valueTimer, &QTimer::timeout, this, [this] {
        m_channels.refresh();
        updateNote();
    });
    connect(&m_channels, &ChannelModel::ticksChanged, this, &MonitorPage::onTicks);
    connect(m_window, &QComboBox::activated, this, [this] { setSeconds(m_window->currentData().toDouble()); });
    connect(m_pause, &QPushButton::toggled, this, &MonitorPage::setPaused);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, [this](DeviceClient::State state) {
        updateRecord();
        if (state == DeviceClient::State::Connected)
            onStore();
    });
    if (workspace.client().isConnected())
        onStore();
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
        plot->setWindow(m_seconds);
        if (m_pause->isChecked() && !m_plots.isEmpty())
            plot->hold(m_plots.first()->endTime());
        connectPlot(plot);
        m_stack->addWidget(plot);
        m_plots.append(plot);
    }
    for (qsizetype i = 0; i < byUnit.size(); ++i)
        m_plots[i]->setChannels(table, byUnit[i].second, client.telemetry());
    m_empty->setVisible(byUnit.isEmpty());
    m_export->setEnabled(!byUnit.isEmpty());
    m_clock.setPlots(m_plots);
}

void MonitorPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    m_valueTimer.start();
    m_clock.start();
}

void MonitorPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    m_clock.stop();
    m_valueTimer.stop();
}

void MonitorPage::connectPlot(PlotView *plot)
{
    connect(plot, &PlotView::zoomRequested, this, &MonitorPage::zoom);
    connect(plot, &PlotView::panRequested, this, [this, plot](double seconds) {
        const double end = plot->endTime() + seconds;
        m_pause->setChecked(true);
        holdAt(end);
    });
    connect(plot, &PlotView::followRequested, this, [this] { m_pause->setChecked(false); });
    connect(plot, &PlotView::cursorMoved, this, [this](std::optional<double> time) {
        for (PlotView *each : m_plots)
            each->setCursorTime(time);
    });
}

void MonitorPage::setSeconds(double seconds)
{
    m_seconds = std::clamp(seconds, kShortestWindow, kLongestWindow);
    for (PlotView *plot : m_plots) {
        plot->setWindow(m_seconds);
        if (plot->isHeld())
            plot->hold(plot->endTime());
    }
    const int known = m_window->findData(m_seconds);
    if (known < 0) {
        // A span made by zooming is shown as it is.
        const int custom = int(kWindows.size());
        const QString text = tr("%1 s").arg(m_seconds, 0, 'g', 3);
        if (m_window->count() == custom)
            m_window->addItem(text, m_seconds);
        m_window->setItemText(custom, text);
        m_window->setItemData(custom, m_seconds);
        m_window->setCurrentIndex(custom);
    } else {
        m_window->setCurrentIndex(known);
    }
    m_clock.updateRate();
}

void MonitorPage::setPaused(bool paused)
{
    m_pause->setText(paused ? tr("Continue") : tr("Pause"));
    for (PlotView *plot : m_plots) {
        if (paused)
            plot->hold(plot->endTime());
        else
            plot->follow();
    }
}

void MonitorPage::holdAt(double end)
{
    const auto store = workspace().client().telemetry();
    const double newest = store ? store->secondsAt(Clock::now()) : end;
    for (PlotView *plot : m_plots)
        plot->hold(std::min(end, newest));
}

void MonitorPage::zoom(double factor, double around)
{
    const double before = m_seconds;
    const double end = m_plots.isEmpty() ? 0.0 : m_plots.first()->endTime();
    setSeconds(m_seconds * factor);
    // Live pictures keep their right edge, which is now; held ones keep the time under the cursor.
    if (m_pause->isChecked())
        holdAt(around + (end - around) * m_seconds / before);
}

Result<qint64> MonitorPage::exportCsv(const QString &path)
{
    const auto store = workspace().client().telemetry();
    if (!store || m_plots.isEmpty())
        return failure(ErrorCode::NotConnected);
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return failure(ErrorCode::BadFile, u"%1: %2"_s.arg(path, file.errorString()));
    const double end = m_plots.first()->endTime();
    const auto lines = writeTelemetryCsv(file, *store, workspace().client().device()->channels(), m_channels.ticked(),
                                         end - m_seconds, end);
    if (!lines)
        return lines;
    if (!file.commit())
        return failure(ErrorCode::BadFile, u"%1: %2"_s.arg(path, file.errorString()));
    return lines;
}

void MonitorPage::askExport()
{
    askSavePath(tr("Save samples"), u"samples.csv"_s, tr("CSV files (*.csv)"), [this](const QString &path) {
        const auto lines = exportCsv(path);
        if (lines)
            emit workspace().notice(tr("%1 lines saved to %2").arg(*lines).arg(path));
        else
            emit workspace().problem(describe(lines.error()));
    });
}

// Idle: a menu with what can be recorded. Recording: one click ends it.
void MonitorPage::updateRecord()
{
    const bool recording = workspace().recorder().isRecording();
    m_record->setMenu(recording ? nullptr : m_recordMenu);
    m_record->setText(recording ? tr("Stop recording") : tr("Record"));
    m_record->setEnabled(recording || (workspace().client().isConnected() && !workspace().client().address().isReplay()));
}

void MonitorPage::askRecording(const QString &title, Result<void> (LinkRecorder::*record)(const QString &))
{
    const QString name = QDateTime::currentDateTime().toString(u"yyyyMMdd-HHmmss"_s) + u".gimbalrec"_s;
    askSavePath(title, name, tr("Recordings (*.gimbalrec)"), [this, record](const QString &path) {
        if (const auto done = (workspace().recorder().*record)(path); !done)
            emit workspace().problem(describe(done.error()));
    });
}

void MonitorPage::updateNote()
{
    const auto store = workspace().client().telemetry();
    const TelemetryPlan &plan = workspace().client().telemetryPlan();
    if (!store || !workspace().client().isConnected()) {
        m_note->clear();
        return;
    }
    QString text;
    if (workspace().client().address().isReplay())
        text = tr("recording");
    else if (plan.streaming)
        text = tr("%1 samples/s").arg(plan.rate, 0, 'f', 0);
    else
        text = tr("polled, up to %1 samples/s").arg(plan.rate, 0, 'f', 0);
    text += u" · "_s + tr("%1 lost").arg(store->lost());
    if (const LinkRecorder &recorder = workspace().recorder(); recorder.isRecording())
        text = tr("● recording, %1").arg(QLocale::c().formattedDataSize(recorder.size())) + u" · "_s + text;
    m_note->setText(text);
}
