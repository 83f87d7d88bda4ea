// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/tune/responsepage.h"

#include "app/pages/tune/movementform.h"
#include "app/pages/tune/responsecharts.h"
#include "protocol/base/filefault.h"
#include "protocol/base/responsecsv.h"
#include "protocol/client/whendone.h"
#include "widgets/forms/numberbox.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/theme/tablelook.h"
#include "widgets/views/card.h"

#include <QComboBox>
#include <QDateTime>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSaveFile>
#include <QStandardItemModel>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr int kMaxRecords = 12;
constexpr double kOwnFromHz = 0.3;
constexpr double kOwnToHz = 40.0;
constexpr qint64 kBiggestFile = 400'000'000;
constexpr int kMovementWidth = 300;

QString msText(std::optional<double> seconds)
{
    return seconds ? ResponsePage::tr("%1 ms").arg(numberText(*seconds * 1000.0, 0)) : u"–"_s;
}

QString boardName(const BoardIdentity &identity)
{
    return u"%1 %2"_s.arg(identity.model, identity.serial).trimmed();
}

}  // namespace

ResponsePage::ResponsePage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"response"_s, tr("Response"), parent)
    , m_way(new QComboBox)
    , m_axis(new QComboBox)
    , m_movement(new MovementForm)
    , m_state(new QLabel)
    , m_arm(new QPushButton(tr("Arm")))
    , m_start(new QPushButton(tr("Start")))
    , m_progress(new QProgressBar)
    , m_charts(new ResponseCharts(workspace.theme()))
    , m_model(new QStandardItemModel(this))
    , m_table(new QTableView)
    , m_remove(new QPushButton(tr("Remove")))
    , m_export(new QPushButton(tr("Export…")))
{
    m_way->addItem(tr("Step"), int(Way::Steps));
    m_way->addItem(tr("Sweep"), int(Way::Sweep));
    m_way->addItem(tr("Own motion"), int(Way::OwnMotion));
    m_way->setAccessibleName(tr("Kind of test"));
    m_way->setToolTip(tr("Step: how fast and how calmly the axis arrives. Sweep: margins, by moving it "
                         "slowly, then ever faster. "
                         "Own motion: the same from what you steered just now."));
    for (const Axis each : kAxes)
        m_axis->addItem(axisLabel(each), int(each));
    m_axis->setCurrentIndex(1);
    m_axis->setAccessibleName(tr("Axis"));
    auto *import = new QPushButton(tr("Import…"));
    import->setToolTip(tr("A measurement of another tool: a text file with two columns, in;out"));
    m_export->setToolTip(tr("Both sides of the chosen measurement as in;out"));
    header()->addWidget(m_way);
    header()->addWidget(m_axis);
    header()->addWidget(import);
    header()->addWidget(m_export);

    auto *left = new QVBoxLayout;
    left->setSpacing(Metric::kGroupGap);
    makeResults(left);
    auto *right = new QVBoxLayout;
    makeMovementCard(right);
    right->addStretch(1);
    auto *columns = new QHBoxLayout;
    columns->setSpacing(Metric::kGroupGap);
    columns->addLayout(left, 1);
    columns->addLayout(right);
    body()->addLayout(columns, 1);

    connect(m_way, &QComboBox::currentIndexChanged, this, &ResponsePage::onWay);
    connect(m_axis, &QComboBox::currentIndexChanged, this, [this] { setArmed(false); });
    connect(m_arm, &QPushButton::clicked, this, [this] { setArmed(m_arm->isChecked()); });
    connect(m_start, &QPushButton::clicked, this, &ResponsePage::start);
    connect(m_remove, &QPushButton::clicked, this, &ResponsePage::removeChosen);
    m_table->setModel(m_model);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &ResponsePage::updateButtons);
    connect(m_model, &QStandardItemModel::itemChanged, this, [this](QStandardItem *item) {
        const auto place = recordAt(item->row());
        if (m_filling || item->column() != 0 || !place)
            return;
        m_records[*place].shown = item->checkState() == Qt::Checked;
        m_records[*place].name = item->text();
        m_charts->setRecords(m_records);
    });
    connect(import, &QPushButton::clicked, this, [this] {
        askOpenPath(
            this, tr("Import a measurement"), tr("Text files (*.csv *.txt);;All files (*)"),
            [this](const QString &path) { this->workspace().notifications().reportLoaded(importCsv(path)); });
    });
    connect(m_export, &QPushButton::clicked, this, [this] {
        askSavePath(this, tr("Export a measurement"), u"response.csv"_s, tr("CSV files (*.csv)"),
                    [this](const QString &path) {
                        this->workspace().notifications().reportSaved(exportCsv(path), path);
                    });
    });
    connect(&workspace.client(), &DeviceClient::progressChanged, this, [this](const Progress &progress) {
        if (progress.step == u"motion-test"_s && progress.total > 0)
            m_progress->setValue(100 * progress.done / progress.total);
    });
    connect(&workspace.client(), &DeviceClient::stateChanged, this, [this](DeviceClient::State state) {
        offerWays();
        setArmed(false);
        if (state == DeviceClient::State::Connected)
            putOthersAside();
    });
    m_disarm.setSingleShot(true);
    connect(&m_disarm, &QTimer::timeout, this, [this] { setArmed(false); });
    onWay();
}

void ResponsePage::makeResults(QVBoxLayout *column)
{
    column->addWidget(m_charts, 3);
    auto *card = new Card(tr("Measurements"));
    m_table->setAccessibleName(tr("Measurements"));
    setSelectableRows(*m_table);
    m_table->setMinimumHeight(110);
    card->content()->addWidget(m_table, 1);
    auto *buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_remove);
    card->content()->addLayout(buttons);
    column->addWidget(card, 1);
}

void ResponsePage::makeMovementCard(QVBoxLayout *column)
{
    auto *card = new Card(tr("Movement"));
    card->setFixedWidth(kMovementWidth);
    card->content()->addLayout(m_movement);
    m_state->setWordWrap(true);
    card->content()->addWidget(m_state);
    m_progress->setRange(0, 100);
    m_progress->setAccessibleName(tr("Progress of the test"));
    m_progress->hide();
    card->content()->addWidget(m_progress);
    m_arm->setCheckable(true);
    m_start->setObjectName(u"primary"_s);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(Metric::kGap);
    buttons->addWidget(m_arm, 1);
    buttons->addWidget(m_start, 1);
    card->content()->addLayout(buttons);
    column->addWidget(card);
}

bool ResponsePage::tellsTargets() const
{
    const Device *device = workspace().client().device();
    return !device || ::tellsTargets(*device);
}

// Without targets from the board, steps can be measured; margins cannot, because the link's delay would count
// as the board's.
void ResponsePage::offerWays()
{
    const bool told = tellsTargets();
    auto *ways = qobject_cast<QStandardItemModel *>(m_way->model());
    for (int row = 0; row < ways->rowCount(); ++row) {
        const bool fits = told || Way(m_way->itemData(row).toInt()) == Way::Steps;
        ways->item(row)->setEnabled(fits);
        ways->item(row)->setToolTip(fits ? QString()
                                         : tr("This board does not report its targets: the line's delay "
                                              "would be mistaken for its own."));
    }
    if (!told)
        m_way->setCurrentIndex(m_way->findData(int(Way::Steps)));
}

ResponsePage::Way ResponsePage::way() const
{
    return Way(m_way->currentData().toInt());
}

Axis ResponsePage::axis() const
{
    return Axis(m_axis->currentData().toInt());
}

ResponseRecord::Kind ResponsePage::kind() const
{
    return way() == Way::Steps ? ResponseRecord::Kind::Steps : ResponseRecord::Kind::Frequency;
}

std::optional<MotionTestPlan::Kind> ResponsePage::testKind() const
{
    switch (way()) {
    case Way::Steps: return MotionTestPlan::Kind::Steps;
    case Way::Sweep: return MotionTestPlan::Kind::Sweep;
    case Way::OwnMotion: break;
    }
    return {};
}

void ResponsePage::onWay()
{
    const Way now = way();
    m_movement->showFor(testKind());
    m_arm->setVisible(now != Way::OwnMotion);
    m_charts->showKind(kind());
    setArmed(false);
    showRecords();
}

void ResponsePage::setArmed(bool armed)
{
    const DeviceClient &client = workspace().client();
    const bool ready = client.isConnected() && client.identity().writable;
    armed = armed && ready && isVisible() && !m_running;
    m_arm->setEnabled(ready && !m_running);
    m_arm->setChecked(armed);
    m_arm->setText(armed ? tr("■ Disarm") : tr("Arm"));
    if (armed)
        m_disarm.start(1000 * workspace().settings().disarmSeconds());
    else
        m_disarm.stop();
    if (way() == Way::OwnMotion)
        m_state->setText(tr("Steer the axis to and fro for a while, by hand controller or on the Control "
                            "page; then measure."));
    else if (m_running)
        m_state->setText(tr("The axis is being moved. Keep your hands off the camera."));
    else if (armed && tellsTargets())
        m_state->setText(tr("Armed: Start moves the axis by %1°. Keep clear.")
                             .arg(shortNumberText(m_movement->degrees())));
    else if (armed)
        m_state->setText(
            tr("Armed: Start brings the camera to its middle, then moves the axis by %1°. Keep clear.")
                .arg(shortNumberText(m_movement->degrees())));
    else
        m_state->setText(tr("Not armed: nothing moves. The motors must run and hold the camera."));
    m_state->setObjectName(armed || m_running ? u"warning"_s : u"muted"_s);
    repolish(m_state);
    updateButtons();
}

void ResponsePage::updateButtons()
{
    const bool running = m_running;
    m_start->setText(running ? tr("Stop") : way() == Way::OwnMotion ? tr("Measure") : tr("Start"));
    m_start->setEnabled(running || m_arm->isChecked()
                        || (way() == Way::OwnMotion && workspace().client().device()));
    m_progress->setVisible(running);
    m_way->setEnabled(!running);
    m_axis->setEnabled(!running);
    m_remove->setEnabled(recordAt(m_table->currentIndex().row()).has_value());
    m_export->setEnabled(!m_records.empty());
}

void ResponsePage::resume(const std::any &kept)
{
    m_records = std::any_cast<const std::vector<ResponseRecord> &>(kept);
    showRecords();
    updateButtons();
}

void ResponsePage::start()
{
    if (m_running) {
        workspace().client().cancelMovingJobs();
        return;
    }
    if (NumberBox::refusedIn(*this))
        return;
    const auto test = testKind();
    if (!test) {
        measureOwnMotion();
        return;
    }
    if (workspace().refusesToBegin())
        return;
    m_running = true;
    workspace().beginWork();
    workspace().live().hold();
    m_progress->setValue(0);
    workspace().mark(PlotMark::Kind::Note, tr("Test of %1 begins").arg(axisLabel(axis())));
    whenDone(workspace().client().submit<MotionTestResult>(
                 [wanted = m_movement->plan(*test, axis()),
                  telemetry = workspace().client().telemetry()](Channel &channel, Device &device) {
                     return measureMotion(channel, device, *telemetry, wanted);
                 },
                 DeviceClient::JobKind::Moving),
             this, [this](const Result<MotionTestResult> &result) {
                 m_running = false;
                 workspace().live().release();
                 workspace().endWork();
                 if (result)
                     onMeasured(*result);
                 else
                     onFailed(result.error());
             });
    setArmed(false);
}

void ResponsePage::onMeasured(const MotionTestResult &result)
{
    workspace().mark(PlotMark::Kind::Note, tr("Test of %1 is over").arg(axisLabel(result.plan.axis)));
    if (result.plan.kind == MotionTestPlan::Kind::Steps) {
        add(stepRecord(result), result.plan.axis);
    } else {
        add(frequencyRecord(result.target.values, result.angle.values, result.angle.rate, result.plan.fromHz,
                            result.plan.toHz),
            result.plan.axis);
    }
    setArmed(false);
}

void ResponsePage::onFailed(const Error &error)
{
    workspace().mark(error.code == ErrorCode::Diverged ? PlotMark::Kind::Fault : PlotMark::Kind::Note,
                     tr("Test was ended"));
    if (isEndOfLink(error) && !workspace().client().isConnected())
        workspace().notifications().notify(
            tr("The test ended with the link: nothing was measured, and the camera may go on as it was moved "
               "last."),
            Notice::Attention);
    else if (error.code == ErrorCode::Cancelled)
        workspace().notifications().notify(tr("The test was ended; control was given back."), Notice::Hint);
    else
        workspace().notifications().report(error);
    setArmed(false);
}

void ResponsePage::measureOwnMotion()
{
    const auto store = workspace().client().telemetry();
    const ChannelRoles &roles = workspace().roles();
    const int seen = roles.angle[std::size_t(axis())];
    const int wanted = roles.target[std::size_t(axis())];
    const auto tracks = store && seen >= 0 ? store->tracks(seen) : std::vector<TrackView>();
    if (tracks.empty() || tracks.back().end() == tracks.back().begin()) {
        workspace().notifications().report({ErrorCode::Unready, {}, 0});
        return;
    }
    const double end = tracks.back().time(tracks.back().end() - 1);
    const auto target = uniformSamples(*store, wanted, -1, end - m_movement->seconds(), end);
    const auto angle = uniformSamples(*store, seen, -1, end - m_movement->seconds(), end);
    if (!target || !angle) {
        add(tl::unexpected(target ? angle.error() : target.error()), axis());
        return;
    }
    add(frequencyRecord(target->values, angle->values, angle->rate, kOwnFromHz, kOwnToHz), axis());
}

void ResponsePage::add(Result<ResponseRecord> record, Axis axis)
{
    if (!record) {
        ErrorText text = describe(record.error());
        text.what = tr("The samples tell nothing about how the axis follows.");
        text.cure = tr("Make the movement larger, or give it more time.");
        workspace().notifications().report(text);
        return;
    }
    record->axis = axis;
    if (record->kind == ResponseRecord::Kind::Frequency && axis != Axis::None)
        workspace().notches().keepLoop(axis, {openLoop(record->closed), record->fromHz, record->toHz});
    if (record->name.isEmpty()) {  // else it is from a file
        const BoardIdentity &identity = workspace().client().identity();
        record->name = u"%1 %2"_s.arg(axisLabel(axis), QDateTime::currentDateTime().toString(u"HH:mm:ss"_s));
        record->board = boardName(identity);
    }
    m_records.push_back(std::move(*record));
    if (m_records.size() > kMaxRecords)
        m_records.erase(m_records.begin());
    showRecords();
}

// Curves of another board would pass for this one's: they stay in the list, with its name, and are not shown.
void ResponsePage::putOthersAside()
{
    const QString board = boardName(workspace().client().identity());
    for (ResponseRecord &record : m_records) {
        if (record.board.isEmpty() || record.board == board)
            continue;
        record.shown = false;
        if (!record.name.contains(record.board))
            record.name += u" · "_s + record.board;
    }
    showRecords();
}

std::optional<std::size_t> ResponsePage::recordAt(int row) const
{
    // Newest first.
    for (std::size_t i = m_records.size(); i-- > 0;) {
        if (m_records[i].kind == kind() && row-- == 0)
            return i;
    }
    return {};
}

void ResponsePage::removeChosen()
{
    if (const auto place = recordAt(m_table->currentIndex().row())) {
        m_records.erase(m_records.begin() + std::ptrdiff_t(*place));
        showRecords();
    }
}

void ResponsePage::showRecords()
{
    m_filling = true;
    const bool steps = kind() == ResponseRecord::Kind::Steps;
    const QStringList titles = steps
        ? QStringList{tr("Measurement"), tr("Rise"), tr("Overshoot"), tr("Settled after"), tr("Left over")}
        : QStringList{tr("Measurement"), tr("Phase margin"), tr("Gain margin"), tr("Bandwidth"),
                      tr("Greatest sensitivity")};
    m_model->clear();
    m_model->setHorizontalHeaderLabels(titles);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    for (int row = 0; const auto place = recordAt(row); ++row) {
        const ResponseRecord &record = m_records[*place];
        QStringList cells;
        if (steps) {
            cells = {msText(record.steps.metrics.riseSeconds),
                     tr("%1 %").arg(numberText(record.steps.metrics.overshoot, 1)),
                     msText(record.steps.metrics.settlingSeconds),
                     tr("%1 %").arg(numberText(100.0 * record.steps.metrics.error, 1))};
        } else {
            const Margins &m = record.margins;
            cells = {
                m.phaseDeg ? tr("%1° at %2 Hz").arg(numberText(*m.phaseDeg, 0)).arg(numberText(*m.phaseHz, 1))
                           : u"–"_s,
                m.gainDb ? tr("%1 dB at %2 Hz").arg(numberText(*m.gainDb, 1)).arg(numberText(*m.gainHz, 1))
                         : u"–"_s,
                m.phaseHz ? tr("%1 Hz").arg(numberText(*m.phaseHz, 1)) : u"–"_s,
                tr("%1 dB at %2 Hz").arg(numberText(m.sensitivityDb, 1)).arg(numberText(m.sensitivityHz, 1))};
        }
        auto *name = new QStandardItem(record.name);
        name->setCheckable(true);
        name->setCheckState(record.shown ? Qt::Checked : Qt::Unchecked);
        QList<QStandardItem *> items{name};
        for (const QString &cell : std::as_const(cells)) {
            items.append(new QStandardItem(cell));
            items.last()->setEditable(false);
        }
        m_model->appendRow(items);
    }
    m_filling = false;
    m_charts->setRecords(m_records);
    updateButtons();
}

Result<void> ResponsePage::importCsv(const QString &path)
{
    const auto text = readWhole(path, FileKind::Measurement, kBiggestFile);
    if (!text)
        return tl::unexpected(text.error());
    auto samples = readResponseCsv(*text, fullRate(workspace().client().families()));
    if (!samples)
        return tl::unexpected(inFile(samples.error(), path));
    auto record = frequencyRecord(std::move(samples->in), std::move(samples->out), samples->rate, kOwnFromHz,
                                  kOwnToHz);
    if (!record)
        return tl::unexpected(record.error());
    record->name = QFileInfo(path).completeBaseName();
    if (kind() != ResponseRecord::Kind::Frequency)
        m_way->setCurrentIndex(m_way->findData(int(Way::OwnMotion)));
    add(std::move(record), Axis::None);
    if (samples->rateAssumed)
        workspace().notifications().notify(tr("The file does not state its rate; %1 samples/s are assumed.")
                                               .arg(shortNumberText(samples->rate)),
                                           Notice::Attention);
    return {};
}

Result<void> ResponsePage::exportCsv(const QString &path) const
{
    const auto place = recordAt(std::max(0, m_table->currentIndex().row()));
    if (!place)
        return failure(ErrorCode::InvalidArgument, u"no measurement"_s);
    const ResponseRecord &record = m_records[*place];
    if (const auto checked = checkTarget(path, FileKind::Measurement); !checked)
        return tl::unexpected(checked.error());
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return tl::unexpected(systemError(file, FileKind::Measurement, true));
    if (const auto written = writeResponseCsv(file, record.target, record.angle, record.rate); !written)
        return written;
    if (!file.commit())
        return tl::unexpected(systemError(file, FileKind::Measurement, true));
    return {};
}

void ResponsePage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    workspace().telemetry().subscribe(this, [this] {
        const ChannelRoles &roles = workspace().roles();
        return ChannelRoles::present({roles.angle, roles.target, roles.gyro});
    });
    offerWays();
    setArmed(false);
}

void ResponsePage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    if (m_running)
        workspace().client().cancelMovingJobs();  // nobody is watching any more
    setArmed(false);
}
