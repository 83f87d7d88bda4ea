// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/watch/monitorpage.h"

#include "app/pages/watch/streamsdialog.h"
#include "app/workspace/signsnote.h"
#include "protocol/base/filefault.h"
#include "protocol/record/telemetrycsv.h"
#include "protocol/telemetry/telemetryplan.h"
#include "widgets/forms/panel.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/models/thinningtext.h"
#include "widgets/plot/curvechart.h"
#include "widgets/views/elidedlabel.h"

#include <QComboBox>
#include <QDateTime>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
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
const QString kLastPlots = u"monitor-plots"_s;

}  // namespace

MonitorPage::MonitorPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"monitor"_s, tr("Monitor"), parent)
    , m_tree(new QTreeView)
    , m_stack(new PlotStack(workspace.theme()))
    , m_arrayChart(new CurveChart(workspace.theme(), tr("Newest values of the arrays")))
    , m_empty(new QLabel(tr("Tick channels on the left to see them here.")))
    , m_window(new QComboBox)
    , m_layout(new QPushButton(tr("Layout")))
    , m_layoutMenu(new QMenu(m_layout))
    , m_streams(new QPushButton(tr("Streams…")))
    , m_pause(new QPushButton(tr("Pause")))
    , m_export(new QPushButton(tr("Export")))
    , m_record(new QPushButton)
    , m_recordMenu(new QMenu(m_record))
    , m_note(new ElidedLabel)
    , m_signs(new SignsNote(workspace))
{
    makeHeader();
    makeBody();
    connectAll();
    if (workspace.client().isConnected())
        onStore();
}

void MonitorPage::makeHeader()
{
    for (const double seconds : kWindows)
        m_window->addItem(seconds < 120 ? tr("%1 s").arg(shortNumberText(seconds))
                                        : tr("%1 min").arg(shortNumberText(seconds / 60)),
                          seconds);
    m_window->setCurrentIndex(kDefaultWindow);
    m_window->setAccessibleName(tr("Time shown"));
    m_window->setToolTip(tr("Time shown"));
    m_pause->setCheckable(true);
    m_pause->setToolTip(
        tr("Hold the picture still while data goes on (Space in the plot). The wheel zooms, dragging moves, "
           "Shift and dragging zooms to a box, a click sets the line that differences are counted from. "
           "Arrow keys move the cursor, with Ctrl from event to event; End goes on."));
    m_layout->setMenu(m_layoutMenu);
    m_layout->setToolTip(tr("Which plots there are and what they show, kept by name"));
    connect(m_layoutMenu, &QMenu::aboutToShow, this, &MonitorPage::fillLayoutMenu);
    m_streams->setToolTip(tr("What the board sends, how often, and how much of the line it takes"));
    connect(m_streams, &QPushButton::clicked, this, &MonitorPage::askStreams);
    m_note->setObjectName(u"muted"_s);
    header()->addWidget(m_note);
    for (QWidget *widget : {static_cast<QWidget *>(m_window), static_cast<QWidget *>(m_pause),
                            static_cast<QWidget *>(m_layout), static_cast<QWidget *>(m_streams),
                            static_cast<QWidget *>(m_record), static_cast<QWidget *>(m_export)})
        header()->addWidget(widget);
    m_recordMenu->addAction(tr("Record from now on…"), this,
                            [this] { askRecording(tr("Record to a file"), &LinkRecorder::start); });
    m_recordMenu->addAction(tr("Save the last minutes…"), this,
                            [this] { askRecording(tr("Save the last minutes"), &LinkRecorder::savePast); });
    m_record->setToolTip(tr("Everything on the link goes into a file that can be opened like the board"));
    connect(m_record, &QPushButton::clicked, this, [this] { workspace().recorder().stop(); });
    connect(&workspace().recorder(), &LinkRecorder::recordingChanged, this, &MonitorPage::updateRecord);
    updateRecord();
    auto *exports = new QMenu(m_export);
    exports->addAction(tr("Samples as CSV…"), this, &MonitorPage::askExport);
    exports->addAction(tr("Picture…"), this, &MonitorPage::askPicture);
    QAction *publishing
        = exports->addAction(tr("Send to PlotJuggler (UDP)…"), this, &MonitorPage::askPublish);
    connect(exports, &QMenu::aboutToShow, this, [this, publishing] {
        publishing->setText(m_publication ? tr("Stop sending to %1").arg(m_publishedTo)
                                          : tr("Send to PlotJuggler (UDP)…"));
    });
    m_export->setMenu(exports);
    m_export->setToolTip(tr("Save what is seen"));
    auto *space = new QShortcut(Qt::Key_Space, m_stack, m_pause, &QPushButton::toggle);
    space->setContext(Qt::WidgetWithChildrenShortcut);
}

void MonitorPage::makeBody()
{
    m_tree->setModel(&m_channels);
    m_tree->setAccessibleName(tr("Telemetry channels"));
    m_tree->setToolTip(tr("Tick a channel, or drag it into a plot"));
    m_tree->setUniformRowHeights(true);
    m_tree->setRootIsDecorated(true);
    m_tree->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_tree->setDragEnabled(true);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_tree, &QWidget::customContextMenuRequested, this, &MonitorPage::showChannelMenu);
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(ChannelModel::NameColumn, QHeaderView::Stretch);
    m_tree->setIndentation(14);
    m_tree->setMinimumWidth(292);
    fadeWhenStale(*m_tree, *m_tree->header(), ChannelModel::ValueColumn);
    m_empty->setObjectName(u"muted"_s);
    m_empty->setAlignment(Qt::AlignCenter);
    auto *right = new QWidget;
    auto *rightLayout = new QVBoxLayout(right);
    rightLayout->setContentsMargins(0, 0, 0, 0);
    rightLayout->addWidget(m_stack, 1);
    rightLayout->addWidget(m_arrayChart, 1);
    coverWhenStale(*right, {}, StaleCover::Look::Tag);
    m_arrayChart->hide();
    rightLayout->addWidget(m_empty);
    auto *left = new QWidget;
    auto *leftLayout = new QVBoxLayout(left);
    leftLayout->setContentsMargins(0, 0, 0, 0);
    leftLayout->setSpacing(Metric::kGap);
    leftLayout->addWidget(m_tree, 1);
    leftLayout->addWidget(m_signs);
    auto *split = new QSplitter;
    split->addWidget(left);
    split->addWidget(right);
    split->setStretchFactor(1, 1);
    split->setSizes({350, 880});
    split->restoreState(workspace().settings().layout(u"monitor"_s));
    connect(split, &QSplitter::splitterMoved, this,
            [this, split] { workspace().settings().setLayout(u"monitor"_s, split->saveState()); });
    body()->addWidget(split, 1);
}

void MonitorPage::connectAll()
{
    m_stack->setMarks(&workspace().marks());
    m_stack->setSeconds(m_window->currentData().toDouble());
    m_valueTimer.setInterval(kValuePeriod);
    connect(&m_valueTimer, &QTimer::timeout, this, [this] {
        m_channels.refresh();
        refreshArrays();
        updateNote();
    });
    connect(&m_channels, &ChannelModel::ticksChanged, this, &MonitorPage::onTicks);
    connect(m_stack, &PlotStack::edited, this, &MonitorPage::onPlotsEdited);
    connect(m_stack, &PlotStack::secondsChanged, this, &MonitorPage::showSeconds);
    connect(m_stack, &PlotStack::pausedChanged, m_pause, &QPushButton::setChecked);
    connect(m_window, &QComboBox::activated, this,
            [this] { m_stack->setSeconds(m_window->currentData().toDouble()); });
    connect(m_pause, &QPushButton::toggled, this, [this](bool paused) {
        m_pause->setText(paused ? tr("Continue") : tr("Pause"));
        m_stack->setPaused(paused);
    });
    connect(&workspace().client(), &DeviceClient::stateChanged, this, [this](DeviceClient::State state) {
        updateRecord();
        if (state == DeviceClient::State::Connected)
            onStore();
    });
}

ChannelTable MonitorPage::table() const
{
    const Device *device = workspace().client().device();
    return device ? device->channels() : ChannelTable();
}

void MonitorPage::onStore()
{
    DeviceClient &client = workspace().client();
    if (m_publication && m_publication->store() != client.telemetry().get()) {
        m_publication.reset();
        workspace().notifications().notify(
            tr("Nothing is sent to %1 any more: the link over which the data came has ended.")
                .arg(m_publishedTo),
            Notice::Attention);
    }
    m_channels.reset(table(), client.telemetry());
    m_stack->setSource(table(), client.telemetry());
    if (!m_chosen) {
        m_chosen = true;
        const PlotLayout last = PlotLayout::fromJson(workspace().settings().layout(kLastPlots), table());
        if (last.plots.isEmpty()) {
            const ChannelRoles &roles = client.roles();
            m_stack->setPlots(
                PlotLayout::byUnit(table(), ChannelRoles::present({roles.angle, roles.gyro})).plots);
        } else {
            m_stack->setPlots(last.plots);
        }
    }
    m_tree->expandToDepth(0);
    for (int row = 3; row < m_channels.rowCount(); ++row)
        m_tree->collapse(m_channels.index(row, 0));
    m_tree->setColumnWidth(ChannelModel::ValueColumn, 80);
    m_tree->setColumnWidth(ChannelModel::UnitColumn, 36);
    showPlots();
}

void MonitorPage::onTicks()
{
    if (table().empty())
        return;
    m_stack->setChannels(ticked(false));
    refreshArrays();
}

QList<int> MonitorPage::ticked(bool arrays) const
{
    QList<int> channels = m_channels.ticked();
    channels.removeIf([&](int channel) { return (table()[std::size_t(channel)].elements > 1) != arrays; });
    return channels;
}

// An array cannot be plotted over time; the newest one is shown in full.
void MonitorPage::refreshArrays()
{
    const QList<int> arrays = table().empty() ? QList<int>() : ticked(true);
    m_arrayChart->setVisible(!arrays.isEmpty());
    m_empty->setVisible(arrays.isEmpty() && m_stack->channels().isEmpty());
    const auto store = workspace().client().telemetry();
    if (arrays.isEmpty() || !store || m_stack->isPaused())
        return;
    QList<ChartCurve> curves;
    int last = 1;
    ChartScale y{QString::fromUtf8(table()[std::size_t(arrays.first())].unit)};
    y.low = table()[std::size_t(arrays.first())].min;
    y.high = table()[std::size_t(arrays.first())].max;
    for (const int channel : arrays) {
        const ChannelSpec &spec = table()[std::size_t(channel)];
        ChartCurve curve;
        curve.name = tableText(spec.label);
        curve.axis = spec.axis;
        curve.color = int(curves.size());
        const ArraySample newest = store->latestArray(channel);
        for (std::size_t i = 0; i < newest.values->size(); ++i) {
            if (const double value = double((*newest.values)[i]); !std::isnan(value))
                curve.points.append({double(i), value});
        }
        last = std::max(last, spec.elements - 1);
        y.low = std::min(y.low, spec.min);
        y.high = std::max(y.high, spec.max);
        curves.append(curve);
    }
    const ChartScale x{tr("Place in the array"), 0, double(last)};
    if (m_arrayChart->xScale().high != x.high || m_arrayChart->yScale().low != y.low
        || m_arrayChart->yScale().high != y.high)
        m_arrayChart->setScales(x, y);
    m_arrayChart->setCurves(curves);
}

void MonitorPage::onPlotsEdited()
{
    workspace().settings().setLayout(kLastPlots, PlotLayout{m_stack->layoutPlots(), 0}.toJson(table()));
    showPlots();
}

// Ticks, subscriptions and buttons follow the plots.
void MonitorPage::showPlots()
{
    const QList<int> channels = m_stack->channels();
    const QList<int> all = channels + (table().empty() ? QList<int>() : ticked(true));
    m_channels.setTicked(all);
    workspace().telemetry().subscribe(this, [all] { return all; });
    refreshArrays();
    m_export->setEnabled(!channels.isEmpty());
}

// A channel can be put into a plot without a mouse, by the menu key.
void MonitorPage::showChannelMenu(const QPoint &at)
{
    QList<int> channels;
    const QModelIndexList rows = m_tree->selectionModel()->selectedRows();
    for (const QModelIndex &row : rows) {
        if (const QVariant channel = row.data(ChannelModel::ChannelRole); channel.isValid())
            channels.append(channel.toInt());
    }
    if (channels.isEmpty())
        return;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (qsizetype i = 0; i < m_stack->panels().size(); ++i)
        menu->addAction(tr("Show in plot %1").arg(i + 1), this,
                        [this, i, channels] { m_stack->addChannels(i, channels); });
    menu->addAction(tr("Show in a new plot"), this, [this, channels] { m_stack->addChannels(-1, channels); });
    menu->popup(m_tree->viewport()->mapToGlobal(at));
}

void MonitorPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    m_signs->refresh();
    m_valueTimer.start();
}

void MonitorPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    m_valueTimer.stop();
    // What is held here can be measured on other pages.
    const double end = m_stack->endTime();
    workspace().setHeldSpan(m_stack->isPaused() ? std::optional(std::pair(end - m_stack->seconds(), end))
                                                : std::nullopt);
}

// A span made by zooming is shown as it is.
void MonitorPage::showSeconds(double seconds)
{
    const int known = m_window->findData(seconds);
    const int custom = int(kWindows.size());
    if (known >= 0 && known != custom) {
        m_window->setCurrentIndex(known);
        return;
    }
    const QString text = tr("%1 s").arg(shortNumberText(seconds, 3));
    if (m_window->count() == custom)
        m_window->addItem(text, seconds);
    m_window->setItemText(custom, text);
    m_window->setItemData(custom, seconds);
    m_window->setCurrentIndex(custom);
}

void MonitorPage::fillLayoutMenu()
{
    m_layoutMenu->clear();
    m_layoutMenu->addAction(tr("One plot for each unit"), this, [this] {
        m_stack->setPlots(PlotLayout::byUnit(table(), m_stack->channels()).plots);
        onPlotsEdited();
    });
    const QStringList names = workspace().settings().plotLayouts();
    if (!names.isEmpty())
        m_layoutMenu->addSeparator();
    for (const QString &name : names)
        m_layoutMenu->addAction(name, this, [this, name] { useLayout(name); });
    m_layoutMenu->addSeparator();
    m_layoutMenu->addAction(tr("Keep this layout…"), this, &MonitorPage::askLayoutName);
    QMenu *remove = m_layoutMenu->addMenu(tr("Forget a layout"));
    remove->setEnabled(!names.isEmpty());
    for (const QString &name : names)
        remove->addAction(name, this, [this, name] { workspace().settings().setPlotLayout(name, {}); });
}

void MonitorPage::saveLayout(const QString &name)
{
    workspace().settings().setPlotLayout(
        name, PlotLayout{m_stack->layoutPlots(), m_stack->seconds()}.toJson(table()));
    workspace().notifications().notify(tr("Layout kept as “%1”.").arg(name));
}

void MonitorPage::useLayout(const QString &name)
{
    const QByteArray kept = workspace().settings().plotLayout(name);
    if (const auto readable = PlotLayout::check(kept, name); !readable) {
        workspace().notifications().report(readable.error());
        return;
    }
    const PlotLayout layout = PlotLayout::fromJson(kept, table());
    if (layout.plots.isEmpty()) {
        workspace().notifications().notify(tr("This board has none of the channels of “%1”.").arg(name),
                                           Notice::Attention);
        return;
    }
    usePlots(layout);
}

void MonitorPage::usePlots(const PlotLayout &layout)
{
    m_stack->setPlots(layout.plots);
    if (layout.seconds > 0)
        m_stack->setSeconds(layout.seconds);
    onPlotsEdited();
}

std::any MonitorPage::keep()
{
    if (table().empty())
        return {};
    return Kept{PlotLayout{m_stack->layoutPlots(), m_stack->seconds()}.toJson(table()),
                std::exchange(m_publication, nullptr), m_publishedTo};
}

void MonitorPage::resume(const std::any &kept)
{
    const auto &before = std::any_cast<const Kept &>(kept);
    if (before.publication && before.publication->store() == workspace().client().telemetry().get()) {
        m_publication = before.publication;
        m_publishedTo = before.publishedTo;
        watchPublication();
    }
    usePlots(PlotLayout::fromJson(before.plots, table()));
}

void MonitorPage::askLayoutName()
{
    auto *dialog = new QInputDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Keep this layout"));
    dialog->setLabelText(tr("Name; one that exists is replaced"));
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString &name) {
        if (!name.trimmed().isEmpty())
            saveLayout(name.trimmed());
    });
    openPanel(*dialog);
}

Result<qint64> MonitorPage::exportCsv(const QString &path)
{
    const auto store = workspace().client().telemetry();
    if (!store || m_stack->panels().isEmpty())
        return failure(ErrorCode::NotConnected);
    if (const auto checked = checkTarget(path, FileKind::Other); !checked)
        return tl::unexpected(checked.error());
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return tl::unexpected(systemError(file, FileKind::Other, true));
    const double end = m_stack->endTime();
    const auto lines = writeTelemetryCsv(file, *store, table(), ticked(false), end - m_stack->seconds(), end);
    if (!lines)
        return lines;
    if (!file.commit())
        return tl::unexpected(systemError(file, FileKind::Other, true));
    return lines;
}

Result<void> MonitorPage::exportPicture(const QString &path) const
{
    constexpr qreal kScale = 2;
    QImage image(m_stack->size() * kScale, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(kScale);
    image.fill(workspace().theme().color(ColorRole::Surface));
    m_stack->render(&image);
    if (const auto checked = checkTarget(path, FileKind::Other); !checked)
        return tl::unexpected(checked.error());
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || !image.save(&file, "PNG") || !file.commit())
        return tl::unexpected(systemError(file, FileKind::Other, true));
    return {};
}

void MonitorPage::askExport()
{
    askSavePath(
        this, tr("Save samples"), u"samples.csv"_s, tr("CSV files (*.csv)"), [this](const QString &path) {
            const auto lines = exportCsv(path);
            workspace().notifications().settle(Concern::Saving);
            if (lines && *lines == 0)
                workspace().notifications().notify(
                    tr("%1 holds no samples: none came in the time shown.").arg(path), Notice::Attention);
            else if (lines)
                workspace().notifications().notify(tr("%1 lines saved to %2").arg(*lines).arg(path));
            else
                workspace().notifications().report(lines.error(), Concern::Saving);
        });
}

void MonitorPage::askPicture()
{
    askSavePath(
        this, tr("Save picture"), u"plots.png"_s, tr("Pictures (*.png)"),
        [this](const QString &path) { workspace().notifications().reportSaved(exportPicture(path), path); });
}

Result<void> MonitorPage::publish(const QString &hostAndPort)
{
    m_publication.reset();
    if (hostAndPort.isEmpty())
        return {};
    const auto store = workspace().client().telemetry();
    if (!store)
        return failure(ErrorCode::NotConnected);
    auto publication = std::make_shared<UdpExport>(table(), store, m_stack->channels());
    if (const auto started = publication->start(hostAndPort); !started)
        return started;
    m_publication = std::move(publication);
    m_publishedTo = hostAndPort;
    watchPublication();
    return {};
}

void MonitorPage::watchPublication()
{
    connect(m_publication.get(), &UdpExport::failed, this,
            [this](const Error &error) { workspace().notifications().report(error); });
}

void MonitorPage::askPublish()
{
    if (m_publication) {
        std::ignore = publish({});
        return;
    }
    auto *dialog = new QInputDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Send to PlotJuggler"));
    dialog->setLabelText(tr("Address of its UDP server (JSON)"));
    dialog->setTextValue(u"127.0.0.1:%1"_s.arg(UdpExport::kDefaultPort));
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString &address) {
        if (const auto started = publish(address.trimmed()); started)
            workspace().notifications().notify(
                tr("What is ticked now is sent to %1 until you stop it in the same menu.")
                    .arg(address.trimmed()),
                Notice::Hint);
        else
            workspace().notifications().report(started.error());
    });
    openPanel(*dialog);
}

void MonitorPage::askStreams()
{
    auto *dialog = new StreamsDialog(workspace(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    openPanel(*dialog);
}

// Idle: a menu with what can be recorded. Recording: one click ends it.
void MonitorPage::updateRecord()
{
    const DeviceClient &client = workspace().client();
    const bool recording = workspace().recorder().isRecording();
    m_record->setMenu(recording ? nullptr : m_recordMenu);
    m_record->setText(recording ? tr("Stop recording") : tr("Record"));
    m_record->setEnabled(recording || (client.isConnected() && !client.address().isReplay()));
    m_streams->setEnabled(client.isConnected() && !client.address().isReplay()
                          && client.device()->streamControl());
}

void MonitorPage::askRecording(const QString &title, Result<void> (LinkRecorder::*record)(const QString &))
{
    const QString name = QDateTime::currentDateTime().toString(u"yyyyMMdd-HHmmss"_s) + u".gimbalrec"_s;
    askSavePath(this, title, name, tr("Recordings (*.gimbalrec)"), [this, record](const QString &path) {
        if (const auto done = (workspace().recorder().*record)(path); !done)
            workspace().notifications().report(done.error());
    });
}

void MonitorPage::updateNote()
{
    const auto store = workspace().client().telemetry();
    const TelemetryPlan &plan = workspace().client().telemetryPlan();
    if (!store || !workspace().client().isConnected()) {
        m_note->setFullText({});
        return;
    }
    QStringList parts{
        tr("%1 lost").arg(store->lost())};  // the most important part first: the end may be elided
    if (store->silences() > 0)
        parts.append(tr("%1 s of silence in all").arg(numberText(store->silentSeconds(), 1)));
    if (const LinkRecorder &recorder = workspace().recorder(); recorder.isRecording())
        parts.append(tr("● recording, %1").arg(sizeText(recorder.size())));
    if (workspace().client().address().isReplay())
        parts.append(tr("recording"));
    else if (plan.streaming && plan.budget.capacity > 0)
        parts.append(tr("%1 % of the line")
                         .arg(numberText(100.0 * plan.budget.bytesPerSecond() / plan.budget.capacity, 0)));
    else if (plan.isStreamedUnasked)
        parts.append(tr("as the board streams it"));
    else if (plan.poll)
        parts.append(tr("polled, up to %1 samples/s").arg(numberText(plan.rate, 0)));
    const QString thinned = thinningText(plan.rate, plan.fullRate, plan.budget);
    if (!thinned.isEmpty())
        parts.append(tr("thinned out to %1 samples/s by the slow line").arg(numberText(plan.rate, 0)));
    if (m_publication)
        parts.append(tr("sent on: %1").arg(m_publication->sent()));
    m_note->setFullText(
        parts.join(u" · "_s),
        (thinned.isEmpty() ? QString() : thinned + u'\n')
            + tr("Lost: samples that were sent and never arrived. Silent: the board sent nothing at "
                 "all, as while it calibrates."));
}
