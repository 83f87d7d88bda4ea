// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/tune/spectrumpage.h"

#include "protocol/analysis/holdingquality.h"
#include "protocol/telemetry/uniformsamples.h"
#include "widgets/forms/panel.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/plot/waterfallview.h"
#include "widgets/theme/tablelook.h"
#include "widgets/views/card.h"
#include "widgets/views/elidedlabel.h"

#include <QActionGroup>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStackedWidget>
#include <QStyle>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kPeriod = 500ms;
constexpr std::array<int, 4> kSpans{5, 10, 30, 60};  // seconds
constexpr int kDefaultSpan = 1;
constexpr std::size_t kFewestBins = 8;
constexpr int kPeaks = 5;  // of each axis
constexpr double kFinest = 0.5;  // Hz
constexpr double kWaterfallSpan = 1.0;  // seconds in one column

// The finest resolution that leaves at least eight segments to average.
int segmentLength(const UniformSamples &samples)
{
    int length = 64;
    while (length * 9 <= int(samples.values.size()) && samples.rate / length > kFinest)
        length *= 2;
    return length;
}

QTableWidget *makeTable(const QStringList &titles, const QString &name)
{
    auto *table = new QTableWidget(0, int(titles.size()));
    table->setHorizontalHeaderLabels(titles);
    table->setAccessibleName(name);
    setSelectableRows(*table);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    return table;
}

QString bandText(double rms, double peak)
{
    return SpectrumPage::tr("%1° RMS\n%2° peak").arg(numberText(rms, 3), numberText(peak, 3));
}

QString frequencyText(double hertz)
{
    return SpectrumPage::tr("%1 Hz").arg(numberText(hertz, 1));
}

QString rmsText(double rms, const QString &unit)
{
    return u"%1 %2"_s.arg(shortNumberText(rms, 3)).arg(unit);
}

QStringList bandNames()
{
    return {SpectrumPage::tr("Sway"), SpectrumPage::tr("Wobble"), SpectrumPage::tr("Jitter")};
}

/// Of a column in which that text stands in full, of several lines the longest.
int columnWidthFor(const QTableWidget &table, const QString &text)
{
    const int padding
        = 2 * (table.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &table) + 1) + Metric::kGap;
    return table.fontMetrics().size(0, text).width() + padding;
}

/// Columns after the first as wide as these texts or their titles; the first takes the rest, at least the
/// same.
void fixColumns(QTableWidget &table, const QStringList &widest)
{
    QHeaderView *header = table.horizontalHeader();
    int width = 0;
    for (int column = 0; column < table.columnCount(); ++column) {
        const QString title = table.horizontalHeaderItem(column)->text();
        const int needed = std::max(columnWidthFor(table, widest[column]),
                                    columnWidthFor(table, title) + Metric::kGap);  // a title has wider edges
        width += needed;
        if (column == 0)
            continue;
        header->setSectionResizeMode(column, QHeaderView::Fixed);
        header->resizeSection(column, needed);
    }
    table.setMinimumWidth(width + 2 * table.frameWidth());
}

void setText(QTableWidget *table, int row, int column, const QString &text)
{
    if (!table->item(row, column))
        table->setItem(row, column, new QTableWidgetItem);
    table->item(row, column)->setText(text);
}

}  // namespace

SpectrumPage::SpectrumPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"spectrum"_s, tr("Spectrum"), parent)
    , m_signal(new QComboBox)
    , m_span(new QComboBox)
    , m_view(new QPushButton(tr("View")))
    , m_viewMenu(new QMenu(m_view))
    , m_pause(new QPushButton(tr("Pause")))
    , m_compare(new QPushButton(tr("Compare")))
    , m_notch(new QPushButton(tr("Try a notch here…")))
    , m_advice(new QLabel)
    , m_note(new ElidedLabel)
    , m_pictures(new QStackedWidget)
    , m_chart(new SpectrumChart(workspace.theme()))
    , m_waterfall(new WaterfallView(workspace.theme()))
    , m_peaks(makeTable({tr("Axis"), tr("Frequency"), tr("RMS"), tr("Width")}, tr("Peaks")))
    , m_bands(makeTable({tr("Band"), axisLabel(Axis::Roll), axisLabel(Axis::Pitch), axisLabel(Axis::Yaw)},
                        tr("Angle error by band")))
{
    m_signal->addItem(tr("Gyro"), int(Signal::Gyro));
    m_signal->addItem(tr("Angle error"), int(Signal::Error));
    m_signal->setAccessibleName(tr("Signal"));
    m_signal->setToolTip(tr("What the spectrum is made of"));
    for (const int seconds : kSpans)
        m_span->addItem(tr("last %1 s").arg(seconds), seconds);
    m_span->setCurrentIndex(kDefaultSpan);
    m_span->setAccessibleName(tr("Span"));
    m_span->setToolTip(tr("A longer span shows finer lines, a shorter one follows faster"));
    m_pause->setCheckable(true);
    m_compare->setToolTip(tr("Keep the present figures and show how they change"));
    m_note->setObjectName(u"muted"_s);
    header()->addWidget(m_note);
    header()->addWidget(m_signal);
    header()->addWidget(m_span);
    header()->addWidget(m_view);
    header()->addWidget(m_pause);

    auto *peaks = new Card(tr("Peaks"));
    peaks->content()->addWidget(m_peaks, 1);
    m_notch->setToolTip(
        tr("Tries a filter that takes the chosen peak out of the loop, and measures what it does"));
    m_advice->setWordWrap(true);
    m_advice->setObjectName(u"muted"_s);
    auto *notchRow = new QHBoxLayout;
    notchRow->addWidget(m_advice, 1);
    notchRow->addWidget(m_notch);
    peaks->content()->addLayout(notchRow);
    auto *bands = new Card(tr("Angle error by band"));
    bands->content()->addWidget(m_bands, 1);
    auto *buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_compare);
    bands->content()->addLayout(buttons);
    m_bands->setRowCount(int(kHoldingBands.size()));
    m_bands->verticalHeader()->setDefaultSectionSize(2 * m_bands->fontMetrics().lineSpacing() + Metric::kGap);
    const QStringList axes{axisLabel(Axis::Roll), axisLabel(Axis::Pitch), axisLabel(Axis::Yaw)};
    fixColumns(*m_peaks,
               {axes.join(u'\n'), frequencyText(888.8), rmsText(0.000888, u"°/s"_s), frequencyText(88.8)});
    const QString band = bandText(88.888, 88.888);
    fixColumns(*m_bands, {bandNames().join(u'\n') + u"\n0.88–888 Hz"_s, band, band, band});
    nameBands({});
    auto *row = new QHBoxLayout;
    row->setSpacing(Metric::kGroupGap);
    row->addWidget(peaks, 2);
    row->addWidget(bands, 3);
    m_pictures->addWidget(m_chart);
    m_pictures->addWidget(m_waterfall);
    m_waterfall->setHop(std::chrono::duration<double>(kPeriod).count());
    makeViewMenu();
    body()->addWidget(m_pictures, 3);
    const auto channels = [this] {
        const ChannelRoles &roles = this->workspace().roles();
        return ChannelRoles::present({roles.gyro, roles.angle});
    };
    coverWhenStale(*m_pictures, channels, StaleCover::Look::Tag);
    for (QTableWidget *figures : {m_peaks, m_bands})
        coverWhenStale(*figures, channels, StaleCover::Look::Fade);
    body()->addLayout(row, 2);

    connect(m_pause, &QPushButton::toggled, this,
            [this](bool on) { m_pause->setText(on ? tr("Continue") : tr("Pause")); });
    connect(m_compare, &QPushButton::clicked, this, [this] {
        m_before = m_left;
        m_earlier = m_now;
        for (SpectrumCurve &curve : m_earlier)
            curve.earlier = true;
        showBands();
        drawCurves();
    });
    connect(m_notch, &QPushButton::clicked, this, &SpectrumPage::askNotch);
    connect(m_peaks, &QTableWidget::itemSelectionChanged, this, &SpectrumPage::updateNotch);
    connect(&workspace.notches(), &NotchAdviser::changed, this, &SpectrumPage::updateNotch);
    updateNotch();
    connect(m_signal, &QComboBox::activated, this, [this] {
        fillWaterfall();
        refresh();
    });
    connect(m_span, &QComboBox::activated, this, &SpectrumPage::refresh);
    m_timer.setInterval(kPeriod);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        if (!m_pause->isChecked())
            refresh();
    });
}

SpectrumPage::Signal SpectrumPage::signal() const
{
    return Signal(m_signal->currentData().toInt());
}

void SpectrumPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    workspace().telemetry().subscribe(this, [this] {
        const ChannelRoles &roles = workspace().roles();
        return ChannelRoles::present({roles.gyro, roles.angle, roles.target});
    });
    offerHeldSpan();
    fillWaterfall();
    refresh();
    m_timer.start();
}

void SpectrumPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    m_timer.stop();
}

// Display options: rarely changed, so they take no room in the header.
void SpectrumPage::makeViewMenu()
{
    m_view->setMenu(m_viewMenu);
    m_view->setToolTip(tr("How the spectrum is made and drawn"));
    const auto choices
        = [this](const QString &title, const QList<std::pair<QString, std::function<void()>>> &entries) {
              m_viewMenu->addSection(title);
              auto *group = new QActionGroup(m_viewMenu);
              for (const auto &[text, chosen] : entries) {
                  QAction *action = m_viewMenu->addAction(text);
                  action->setCheckable(true);
                  action->setChecked(group->actions().isEmpty());
                  group->addAction(action);
                  connect(action, &QAction::triggered, this, [this, chosen = chosen] {
                      chosen();
                      refresh();
                  });
              }
          };
    QList<std::pair<QString, std::function<void()>>> pictures{{tr("Lines"), [this] {
                                                                   m_waterfallAxis = Axis::None;
                                                                   m_pictures->setCurrentWidget(m_chart);
                                                               }}};
    for (const Axis axis : kAxes) {
        pictures.append({tr("Waterfall, %1").arg(axisLabel(axis)), [this, axis] {
                             m_waterfallAxis = axis;
                             m_pictures->setCurrentWidget(m_waterfall);
                             fillWaterfall();
                         }});
    }
    choices(tr("Picture"), pictures);
    choices(tr("Frequency"),
            {{tr("Logarithmic"), [this] { m_scale.linearFrequency = false; }},
             {tr("Linear"), [this] { m_scale.linearFrequency = true; }}});
    choices(tr("Level"),
            {{tr("Decibel"), [this] { m_scale.amplitude = false; }},
             {tr("RMS of each line"), [this] { m_scale.amplitude = true; }}});
    choices(tr("Window"),
            {{tr("Hann: the usual one"), [this] { m_window = WindowShape::Hann; }},
             {tr("Flat top: true heights of single tones"), [this] { m_window = WindowShape::FlatTop; }},
             {tr("Rectangular: sharpest, leaks"), [this] { m_window = WindowShape::Rectangular; }}});
}

// A span held still on the Monitor page can be measured here and compared with another.
void SpectrumPage::offerHeldSpan()
{
    const int last = int(kSpans.size());
    const auto held = workspace().heldSpan();
    if (held && m_span->count() == last)
        m_span->addItem(QString());
    if (held)
        m_span->setItemText(
            last, tr("as held on Monitor, %1 s").arg(shortNumberText(held->second - held->first, 3)));
    else if (m_span->count() > last)
        m_span->removeItem(last);
}

std::pair<double, double> SpectrumPage::spanOf(const TelemetryStore &store, int channel) const
{
    if (const auto held = workspace().heldSpan(); held && m_span->currentIndex() == int(kSpans.size()))
        return *held;
    // The newest sample is the end: a recording goes on standing where it stopped.
    const std::vector<TrackView> tracks = channel < 0 ? std::vector<TrackView>() : store.tracks(channel);
    if (tracks.empty() || tracks.back().end() == tracks.back().begin())
        return {0, 0};
    const double end = tracks.back().time(tracks.back().end() - 1);
    return {end - m_span->currentData().toDouble(), end};
}

void SpectrumPage::refresh()
{
    const auto store = workspace().client().telemetry();
    const Device *device = workspace().client().device();
    if (!store || !device)
        return;
    const ChannelRoles &roles = workspace().roles();
    const ChannelTable table = device->channels();
    const bool gyro = signal() == Signal::Gyro;
    m_now.clear();
    m_own.clear();
    m_lines.clear();
    m_note->setFullText(tr("Waiting for samples at a steady rate"));
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
        const int channel = gyro ? roles.gyro[i] : roles.angle[i];
        const auto [from, to] = spanOf(*store, channel);
        if (to <= from)
            continue;
        const auto error = uniformSamples(*store, roles.angle[i], roles.target[i], from, to);
        if (error) {
            const auto qualities = holdingQuality(error->values, error->rate);
            for (std::size_t band = 0; band < qualities.size(); ++band)
                m_left[i][band] = {qualities[band].rms, qualities[band].peak, qualities[band].known};
            nameBands(qualities);
        }
        const auto samples = gyro ? uniformSamples(*store, channel, -1, from, to) : error;
        if (!samples)
            continue;
        auto result = spectrum(samples->values, samples->rate, {segmentLength(*samples), 0.5, m_window});
        if (!result)
            continue;
        m_unit = QString::fromUtf8(table[std::size_t(channel)].unit);
        for (const SpectrumPeak &peak : findPeaks(*result, kPeaks, kVibrationFrom))
            m_lines.push_back({kAxes[i], peak, result->bandRms(kVibrationFrom, result->rate / 2),
                               commandedRms(kAxes[i], peak, from, to)});
        QString note = tr("%1 samples/s, lines of %2 Hz, %n average(s)", nullptr, result->segments)
                           .arg(numberText(result->rate, 0))
                           .arg(shortNumberText(result->resolution, 2));
        if (samples->polled)  // polled values have not passed an anti-aliasing filter
            note = tr("%1; anything above %2 Hz shows up lower")
                       .arg(note)
                       .arg(numberText(result->rate / 2, 0));
        m_note->setFullText(note);
        m_now.push_back({axisLabel(kAxes[i]), kAxes[i], std::move(*result), false});
        if (gyro)
            addOwn(i, *store);
    }
    drawCurves();
    addWaterfall();
    showPeaks(m_unit);
    showBands();
}

std::any SpectrumPage::keep()
{
    return Kept{m_earlier, m_before, m_signal->currentIndex(), m_span->currentIndex()};
}

void SpectrumPage::resume(const std::any &kept)
{
    const auto &before = std::any_cast<const Kept &>(kept);
    m_earlier = before.earlier;
    m_before = before.before;
    m_signal->setCurrentIndex(before.signal);
    m_span->setCurrentIndex(before.span);
}

// In which scale it is counted is not told, so it is drawn as strong as that of the samples: what is compared
// is where its lines are. Its bins reach to half of the control loop's rate (BCFlight errata 8.3).
void SpectrumPage::addOwn(std::size_t axis, const TelemetryStore &store)
{
    const ChannelRoles &roles = workspace().roles();
    const double loops = workspace().latest(roles.loops);
    if (roles.spectrum[axis] < 0 || !(loops > 0))
        return;
    const ArraySample told = store.latestArray(roles.spectrum[axis]);
    if (told.values->size() < kFewestBins)
        return;
    Spectrum own;
    own.rate = loops;
    own.resolution = loops / 2 / double(told.values->size() - 1);
    own.segments = 1;
    for (const float magnitude : *told.values)
        own.density.push_back(double(magnitude) * double(magnitude));
    const Spectrum &seen = m_now.back().spectrum;
    const double highest = std::min(seen.rate, own.rate) / 2;
    const double strength = own.bandRms(kVibrationFrom, highest);
    if (!(strength > 0))
        return;
    const double factor = seen.bandRms(kVibrationFrom, highest) / strength;
    for (double &density : own.density)
        density *= factor * factor;
    m_own.push_back(
        {tr("%1, from the board").arg(axisLabel(kAxes[axis])), kAxes[axis], std::move(own), false, true});
}

void SpectrumPage::drawCurves()
{
    std::vector<SpectrumCurve> all = m_earlier;
    all.insert(all.end(), m_own.begin(), m_own.end());
    all.insert(all.end(), m_now.begin(), m_now.end());
    m_chart->setSpectra(all, m_unit, m_scale);
    std::vector<std::pair<const Spectrum *, SpectrumPeak>> peaks;
    for (const Line &line : m_lines) {
        for (const SpectrumCurve &curve : m_now) {
            if (curve.axis == line.axis)
                peaks.push_back({&curve.spectrum, line.peak});
        }
    }
    m_chart->setPeaks(peaks);
}

void SpectrumPage::addWaterfall()
{
    if (m_waterfallAxis == Axis::None)
        return;
    m_waterfall->setLogarithmic(!m_scale.linearFrequency);
    addColumn(spanOf(*workspace().client().telemetry(), waterfallChannel()).second);
}

// Show at once what is already in memory.
void SpectrumPage::fillWaterfall()
{
    m_waterfall->clear();
    if (m_waterfallAxis == Axis::None)
        return;
    const auto store = workspace().client().telemetry();
    if (!store || !workspace().client().device())
        return;
    const double hop = std::chrono::duration<double>(kPeriod).count();
    const double end = spanOf(*store, waterfallChannel()).second;
    for (int column = WaterfallView::kColumns; column >= 1; --column)
        addColumn(end - column * hop);
}

int SpectrumPage::waterfallChannel() const
{
    const ChannelRoles &roles = workspace().roles();
    return signal() == Signal::Gyro ? roles.gyro[std::size_t(m_waterfallAxis)]
                                    : roles.angle[std::size_t(m_waterfallAxis)];
}

// One second only, so that each column shows its own moment.
void SpectrumPage::addColumn(double end)
{
    const auto store = workspace().client().telemetry();
    const ChannelRoles &roles = workspace().roles();
    const auto axis = std::size_t(m_waterfallAxis);
    const bool gyro = signal() == Signal::Gyro;
    const int channel = waterfallChannel();
    const auto samples
        = uniformSamples(*store, channel, gyro ? -1 : roles.target[axis], end - kWaterfallSpan, end);
    if (!samples)
        return;
    int length = 64;
    while (length * 2 <= int(samples->values.size()))
        length *= 2;
    if (const auto now = spectrum(samples->values, samples->rate, {length, 0.5, m_window}))
        m_waterfall->add(*now);
}

void SpectrumPage::showPeaks(const QString &unit)
{
    m_peaks->setRowCount(int(m_lines.size()));
    for (int row = 0; row < int(m_lines.size()); ++row) {
        const Axis axis = m_lines[std::size_t(row)].axis;
        const SpectrumPeak &peak = m_lines[std::size_t(row)].peak;
        setText(m_peaks, row, 0, axisLabel(axis));
        setText(m_peaks, row, 1, frequencyText(peak.frequency));
        setText(m_peaks, row, 2, rmsText(peak.rms, unit));
        setText(m_peaks, row, 3, frequencyText(peak.width));
    }
    updateNotch();
}

const SpectrumPage::Line *SpectrumPage::chosenLine() const
{
    const int row = m_peaks->currentRow();
    return row >= 0 && row < int(m_lines.size()) ? &m_lines[std::size_t(row)] : nullptr;
}

// How much of a line the target makes, in the unit of the samples.
double SpectrumPage::commandedRms(Axis axis, const SpectrumPeak &peak, double from, double to) const
{
    const int channel = workspace().roles().target[std::size_t(axis)];
    const auto target = uniformSamples(*workspace().client().telemetry(), channel, -1, from, to);
    const auto moved = target
        ? spectrum(target->values, target->rate, {segmentLength(*target), 0.5, m_window})
        : Result<Spectrum>(tl::unexpected(target.error()));
    if (!moved)
        return 0.0;
    const double reach = std::max(peak.width, 2.0 * moved->resolution);
    const double rms = moved->bandRms(peak.frequency - reach, peak.frequency + reach);
    return signal() == Signal::Gyro ? rms * 2.0 * std::numbers::pi * peak.frequency : rms;
}

void SpectrumPage::updateNotch()
{
    const Device *device = workspace().client().device();
    const NotchFilters *notches = device ? device->notchFilters() : nullptr;
    const bool has = notches && std::any_of(kAxes.begin(), kAxes.end(), [notches](Axis axis) {
                         return !notches->notchesOf(axis).empty();
                     });
    NotchAdviser &adviser = workspace().notches();
    m_notch->setVisible(!device || has);
    m_advice->setVisible(has);
    m_notch->setText(adviser.isRunning() ? tr("End the trial") : tr("Try a notch here…"));
    if (adviser.isRunning()) {
        m_notch->setEnabled(true);
        m_advice->setText(tr("A notch is being tried. Leave gimbal and sticks as they are."));
        return;
    }
    m_notch->setEnabled(false);
    const Line *line = chosenLine();
    if (!has || !workspace().client().isConnected() || !workspace().client().identity().writable
        || workspace().configuration().isEmpty() || !line) {
        m_advice->setText(adviser.outcome());
        return;
    }
    const auto plan = adviser.plan(line->axis, line->peak);
    if (!plan) {
        m_advice->setText(tr("All notch filters of this axis are in use; change one of them on Parameters."));
        return;
    }
    const NotchAdvice advice = adviser.advise(*plan, line->wholeRms, line->commandedRms);
    QString obstacle = advice.isOffered() ? adviser.obstacle() : QString();
    if (advice.isOffered() && workspace().motorsRunning() == false)
        obstacle = tr("The motors are off: there is nothing to measure.");
    m_advice->setText(obstacle.isEmpty() ? adviser.inWords(*plan, advice) : obstacle);
    m_notch->setEnabled(advice.isOffered() && obstacle.isEmpty());
}

void SpectrumPage::askNotch()
{
    NotchAdviser &adviser = workspace().notches();
    if (adviser.isRunning()) {
        adviser.stop();
        return;
    }
    const Line *line = chosenLine();
    const auto plan = line ? adviser.plan(line->axis, line->peak) : std::nullopt;
    if (!plan || m_question)
        return;
    const NotchAdvice advice = adviser.advise(*plan, line->wholeRms, line->commandedRms);
    m_question = new QMessageBox(QMessageBox::NoIcon, tr("Try a notch here"), adviser.question(*plan, advice),
                                 QMessageBox::NoButton, this);
    m_question->setAttribute(Qt::WA_DeleteOnClose);
    auto *accept = m_question->addButton(tr("Try it"), QMessageBox::AcceptRole);
    auto *leave = m_question->addButton(tr("Leave it"), QMessageBox::RejectRole);
    m_question->setDefaultButton(accept);
    m_question->setEscapeButton(leave);
    connect(accept, &QPushButton::clicked, this, [&adviser, plan = *plan] { adviser.start(plan); });
    openPanel(*m_question);
}

// The bands, as far as they could be measured.
void SpectrumPage::nameBands(const std::vector<BandQuality> &measured)
{
    const QStringList names = bandNames();
    for (std::size_t i = 0; i < kHoldingBands.size(); ++i) {
        const Band &band = i < measured.size() && measured[i].known ? measured[i].band : kHoldingBands[i];
        setText(m_bands, int(i), 0,
                u"%1\n%2–%3 Hz"_s.arg(names[qsizetype(i)])
                    .arg(shortNumberText(band.from, 2))
                    .arg(numberText(band.to, 0)));
    }
}

void SpectrumPage::showBands()
{
    for (std::size_t axis = 0; axis < m_left.size(); ++axis) {
        for (std::size_t band = 0; band < m_left[axis].size(); ++band) {
            const Left &left = m_left[axis][band];
            QString text = left.known ? bandText(left.rms, left.peak) : u"–"_s;
            if (m_before && left.known && (*m_before)[axis][band].known && (*m_before)[axis][band].rms > 0) {
                const double change = (left.rms / (*m_before)[axis][band].rms - 1.0) * 100.0;
                text = tr("%1° RMS").arg(numberText(left.rms, 3))
                    + u"\n%1 %2 %"_s.arg(change > 0 ? u"▲"_s : u"▼"_s).arg(numberText(std::abs(change), 0));
            }
            setText(m_bands, int(band), int(axis) + 1, text);
        }
    }
}
