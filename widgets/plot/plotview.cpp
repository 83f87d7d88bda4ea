// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/plotview.h"

#include "widgets/models/channelmodel.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/plot/chartnumbers.h"
#include "widgets/plot/plotoverlay.h"
#include "widgets/plot/spanstatistics.h"

#include <QChart>
#include <QDateTime>
#include <QGraphicsLayout>
#include <QPainter>
#include <QValueAxis>

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr int kMaxFrames = 60;
constexpr int kTimeSteps = 5;  // parts between the labels of the time axis
// Room for labels and legend around the plot area.
constexpr double kAreaLeft = 76;
constexpr double kAreaTop = 34;
constexpr double kNamesTop = 8;
constexpr double kNamesGap = 8;
constexpr int kRoomy = 150;  // height of a plot that can spare a third row for its names
constexpr double kAreaRight = 20;
constexpr double kRightAxis = 64;
constexpr double kAreaBottom = 30;
constexpr double kLabelPadding = 8;  // Qt keeps so much clear around each label
constexpr std::size_t kMaxAxes = 6;  // more would leave no room for the picture
// A transient is left out of the scale where it is so many times as high as the rest, and taken in again
// below the other.
constexpr double kFlat = 5.0;
constexpr double kFlatAgain = 3.0;
constexpr double kNearlyConstant = 0.02;
constexpr qint64 kRateTextMs = 500;
constexpr qint64 kFitMs = 80;  // before anyone notices that a trace leaves the plot

}  // namespace

PlotView::PlotView(const Theme &theme, QWidget *parent)
    : QChartView(parent)
    , m_theme(theme)
    , m_timeAxis(new QValueAxis(this))
{
    QChart *plot = chart();  // the view's own; replacing it would leak this one
    writeNumbers(*plot);
    plot->setAnimationOptions(QChart::NoAnimation);
    plot->setBackgroundVisible(false);
    plot->setBackgroundRoundness(0);
    plot->setMargins({0, 0, 4, 0});
    plot->layout()->setContentsMargins(0, 0, 0, 0);
    plot->legend()->detachFromChart();
    plot->legend()->hide();  // it loses traces whose names are long
    plot->addAxis(m_timeAxis, Qt::AlignBottom);
    m_timeAxis->setLinePenColor(Qt::transparent);
    m_timeAxis->setMinorTickCount(0);
    m_timeAxis->setLabelFormat(u"%.3g s"_s);
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing, false);
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
    setMinimumHeight(120);
    setAccessibleName(tr("Live plot"));
    viewport()->setAccessibleName(accessibleName());
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    viewport()->setMouseTracking(true);
    setAcceptDrops(true);
    makeAxes();
    connect(&m_theme, &Theme::changed, this, &PlotView::applyTheme);
    connect(scene(), &QGraphicsScene::changed, this, [this] {
        m_still = QPixmap();
        viewport()->update();
    });
    connect(plot, &QChart::plotAreaChanged, this, &PlotView::updateView);
    applyTheme();
    setWindow(m_window);
}

PlotView::~PlotView() = default;

QColor PlotView::colorOf(qsizetype curve, int &next) const
{
    const Axis axis = m_table[std::size_t(m_curves[curve].channel)].axis;
    // Axes keep their colour everywhere; a second trace of the same axis in one plot gets another one.
    const bool taken = std::any_of(m_curves.begin(), m_curves.begin() + curve, [&](const Curve &other) {
        return m_table[std::size_t(other.channel)].axis == axis;
    });
    if (axis != Axis::None && !taken)
        return m_theme.axisColor(axis);
    return m_theme.seriesColor(next++);
}

void PlotView::setChannels(ChannelTable table, const QList<int> &channels,
                           std::shared_ptr<const TelemetryStore> store)
{
    QList<Curve> curves;
    for (const int channel : channels)
        curves.append({channel, -1, {}});
    setCurves(table, curves, std::move(store));
}

void PlotView::setCurves(ChannelTable table, const QList<Curve> &curves,
                         std::shared_ptr<const TelemetryStore> store)
{
    m_table = table;
    m_curves.clear();
    m_store = std::move(store);
    m_generation = -1;
    m_traces.traces().clear();
    for (const Curve &curve : curves) {
        if (curve.channel < 0 || std::size_t(curve.channel) >= table.size())
            continue;
        m_curves.append(curve);
        TraceImage::Trace trace;
        trace.channel = curve.channel;
        trace.minus = curve.minus;
        m_traces.traces().push_back(std::move(trace));
    }
    makeAxes();
    applyTheme();
}

// One axis for each unit, or for each trace: the first one at the left, the others at the right.
void PlotView::makeAxes()
{
    QStringList keys;
    std::vector<ValueAxis> axes;
    for (qsizetype i = 0; i < m_curves.size(); ++i) {
        const QString unit = QString::fromUtf8(m_table[std::size_t(m_curves[i].channel)].unit);
        const QString key = m_ownScales ? QString::number(i) : unit;
        qsizetype place = keys.indexOf(key);
        if (place < 0 && axes.size() == kMaxAxes) {
            place = qsizetype(kMaxAxes) - 1;
            axes.back().unit = u"…"_s;  // its numbers are of several kinds
        }
        if (place < 0) {
            place = keys.size();
            keys.append(key);
            ValueAxis &fresh = axes.emplace_back();
            fresh.unit = unit;
            // A range that was there before stays, so that adding a trace moves nothing.
            if (std::size_t(place) < m_axes.size() && m_axes[std::size_t(place)].unit == unit)
                fresh.scale = m_axes[std::size_t(place)].scale;
        }
        m_traces.traces()[std::size_t(i)].scale = std::size_t(place);
    }
    if (axes.empty())
        axes.emplace_back();
    for (ValueAxis &old : m_axes) {
        chart()->removeAxis(old.axis);
        delete old.axis;
    }
    m_axes = std::move(axes);
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
        auto *axis = new QValueAxis(this);
        axis->setLinePenColor(Qt::transparent);
        axis->setMinorTickCount(0);
        axis->setTitleText(m_axes[i].unit);  // the unit stands at the scale, where the numbers are
        axis->setGridLineVisible(i == 0);
        chart()->addAxis(axis, i == 0 ? Qt::AlignLeft : Qt::AlignRight);
        m_axes[i].axis = axis;
        applyScale(m_axes[i]);
    }
    layOut();
    updateView();
}

void PlotView::setOwnScales(bool own)
{
    if (m_ownScales == own)
        return;
    m_ownScales = own;
    makeAxes();
    applyTheme();
}

void PlotView::setRightRoom(int axes)
{
    m_rightRoom = axes;
    layOut();
}

void PlotView::setMarks(const PlotMarks *marks)
{
    m_marks = marks;
    if (marks)
        connect(marks, &PlotMarks::changed, viewport(), qOverload<>(&QWidget::update));
}

QString PlotView::curveName(qsizetype curve) const
{
    const Curve &wanted = m_curves[curve];
    return wanted.name.isEmpty() ? tableText(m_table[std::size_t(wanted.channel)].label) : wanted.name;
}

QColor PlotView::curveColor(qsizetype curve) const
{
    return m_traces.traces()[std::size_t(curve)].color;
}

void PlotView::applyTheme()
{
    const QColor text = m_theme.color(ColorRole::Muted);
    setBackgroundBrush(m_theme.color(ColorRole::Surface));
    int next = 0;
    QList<PlotLegend::Entry> entries;
    for (qsizetype i = 0; i < m_curves.size(); ++i) {
        TraceImage::Trace &trace = m_traces.traces()[std::size_t(i)];
        trace.color = colorOf(i, next);
        QColor shown = trace.color;
        if (!trace.visible)
            shown.setAlpha(60);
        entries.append({curveName(i), shown});
    }
    m_legend.setEntries(entries);
    const auto style = [&](QValueAxis *axis, const QColor &color) {
        axis->setLabelsColor(color);
        axis->setTitleBrush(color);
        axis->setGridLineColor(m_theme.color(ColorRole::SurfaceRaised));
    };
    style(m_timeAxis, text);
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
        // An axis of a single trace among several has its colour.
        const bool single = m_ownScales && m_axes.size() > 1 && i < std::size_t(m_curves.size());
        style(m_axes[i].axis, single ? curveColor(qsizetype(i)) : text);
    }
    m_still = QPixmap();
    layOut();
    updateView();
    m_traces.invalidate();
    viewport()->update();
}

void PlotView::setWindow(double seconds)
{
    m_window = seconds;
    m_timeAxis->setRange(-seconds, 0);
    m_timeAxis->setTickCount(kTimeSteps + 1);
    updateView();
}

void PlotView::hold(double end)
{
    m_traces.hold(end);
    m_rateTimer.invalidate();
    advance();
    viewport()->update();
}

void PlotView::follow()
{
    m_traces.follow();
    viewport()->update();
}

bool PlotView::isHeld() const
{
    return m_traces.heldAt().has_value();
}

double PlotView::endTime() const
{
    return m_traces.end();
}

void PlotView::setCursorTime(std::optional<double> time)
{
    if (m_cursor == time)
        return;
    m_cursor = time;
    viewport()->update();
}

void PlotView::setReferenceTime(std::optional<double> time)
{
    if (m_reference == time)
        return;
    m_reference = time;
    viewport()->update();
}

void PlotView::applyScale(const ValueAxis &axis)
{
    // As many decimals as the steps need; moved by a tiny amount, so that rounding yields 0 and not -0 or
    // 3e-17.
    const double step = (axis.scale.high() - axis.scale.low()) / axis.scale.steps();
    const double number = axis.scale.steps() == 1 ? step / 2 : step;  // that one may lie around 0
    const int decimals = std::clamp(int(std::ceil(-std::log10(number) - 1e-9)), 0, 6);
    axis.axis->setLabelFormat(u"%.%1f"_s.arg(decimals));
    axis.axis->setRange(axis.scale.low() + step * 1e-9, axis.scale.high() + step * 1e-9);
    axis.axis->setTickCount(axis.scale.steps() + 1);
}

void PlotView::autoScale()
{
    for (ValueAxis &axis : m_axes)
        axis.scale.release();
    fitScales();
}

void PlotView::updateView()
{
    std::array<TraceImage::Range, kMaxAxes> ranges;
    for (std::size_t i = 0; i < m_axes.size(); ++i)
        ranges[i] = {m_axes[i].scale.low(), m_axes[i].scale.high()};
    const TraceImage::Ground ground{m_theme.color(ColorRole::Surface),
                                    m_theme.color(ColorRole::SurfaceRaised),
                                    m_axes.empty() ? 1 : m_axes.front().scale.steps(), kTimeSteps};
    m_traces.setView(chart()->plotArea(), m_window, std::span(ranges).first(m_axes.size()), ground,
                     devicePixelRatioF());
}

void PlotView::resizeEvent(QResizeEvent *event)
{
    layOut();  // first: the chart lays its labels out when it gets its size, and hides those that lie outside
    QChartView::resizeEvent(event);
    layOut();
    updateView();
}

// The same edges in every plot, whatever its labels need, so that stacked plots line up.
void PlotView::layOut()
{
    const double right = kAreaRight + kRightAxis * std::max(m_rightRoom, rightAxes());
    const double room = std::max(10.0, width() - kAreaLeft - right);
    const double rate = m_rateText.isEmpty() ? 0.0 : QFontMetricsF(font()).horizontalAdvance(m_rateText) + 8;
    const int rows = height() < kRoomy ? 2 : 3;
    const double names
        = m_legend.layOut(font(), kAreaLeft, kNamesTop, width() - kAreaLeft - kAreaRight, rows, rate);
    const double top = std::max(kAreaTop, kNamesTop + names + kNamesGap);
    const double high = std::max(10.0, height() - top - kAreaBottom);
    chart()->setPlotArea({kAreaLeft, top, room, high});
    // Labels with less room would be cut to dots.
    const double label = QFontMetricsF(m_timeAxis->labelsFont()).height() + kLabelPadding;
    for (ValueAxis &axis : m_axes) {
        if (axis.scale.setMostSteps(int(high / label) - 1))
            applyScale(axis);
    }
}

bool PlotView::advance()
{
    if (!m_store || m_curves.isEmpty())
        return false;
    if (m_generation != m_store->generation()) {
        m_generation = m_store->generation();
        for (TraceImage::Trace &trace : m_traces.traces())
            trace.sources = TraceSource::find(*m_store, trace.channel, trace.minus);
        m_traces.invalidate();
        m_rateTimer.invalidate();
    }
    const double newest = m_traces.newestSample();
    if (std::isnan(newest))
        return false;
    if (!m_rateTimer.isValid() || m_rateTimer.elapsed() > kRateTextMs)
        updateRateText();
    if (!m_traces.advance(newest))
        return false;
    if (isHeld() || !m_fitTimer.isValid() || m_fitTimer.elapsed() >= kFitMs)
        fitScales();
    // Nothing else has changed; lines at the edge reach a little beyond it.
    viewport()->update(chart()->plotArea().toAlignedRect().adjusted(-2, -2, 2, 2));
    return true;
}

void PlotView::fitScales()
{
    m_fitTimer.start();
    bool changed = false;
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
        ValueAxis &axis = m_axes[i];
        const TraceColumns::Span whole = m_traces.visibleRange(i);
        if (whole.isEmpty())
            continue;
        // A transient that is over does not flatten what came after it; held still, all of it is shown.
        const TraceColumns::Span lasting = isHeld() ? whole : m_traces.lastingRange(i);
        const double times = axis.isOutside ? kFlatAgain : kFlat;
        const bool isOutside = double(whole.high - whole.low)
            > times * std::max(double(lasting.high - lasting.low), kNearlyConstant);
        changed |= std::exchange(axis.isOutside, isOutside) != isOutside;
        const TraceColumns::Span &used = isOutside ? lasting : whole;
        axis.outside = isOutside ? whole : TraceColumns::Span();
        if (!axis.scale.fit(double(used.low), double(used.high)))
            continue;
        applyScale(axis);
        changed = true;
    }
    if (changed)
        updateView();
}

// What the streams behind the traces can show: nothing above half their rate.
void PlotView::updateRateText()
{
    double slowest = 0;
    double fastest = 0;
    bool irregular = false;
    for (const TraceImage::Trace &trace : m_traces.traces()) {
        for (const TraceSource &source : trace.sources) {
            const TrackView &track = source.track;
            const bool seen = track.end() > track.begin() && track.time(track.end() - 1) >= startTime()
                && track.time(track.begin()) <= endTime();
            const double period = track.period();
            irregular |= seen && period <= 0;
            if (seen && period > 0) {
                fastest = std::max(fastest, 1.0 / period);
                slowest = slowest > 0 ? std::min(slowest, 1.0 / period) : 1.0 / period;
            }
        }
    }
    m_rateTimer.start();
    const auto number = [](double value) { return shortNumberText(value, 4); };
    QString text;
    if (fastest <= 0)
        text = irregular ? tr("no fixed rate") : QString();
    else if (irregular)
        text = tr("no fixed rate, up to %1/s").arg(number(fastest));
    else if (slowest < fastest)
        text = tr("%1 to %2/s").arg(number(slowest), number(fastest));
    else
        text = tr("%1/s, true to %2 Hz").arg(number(fastest), number(fastest / 2));
    if (text == m_rateText)
        return;
    m_rateText = text;
    setAccessibleDescription(text);
    m_still = QPixmap();
    layOut();
    viewport()->update();
}

int PlotView::usefulRate() const
{
    const double pixelsPerSecond = chart()->plotArea().width() * devicePixelRatioF() / m_window;
    return std::clamp(int(std::ceil(pixelsPerSecond)), 10, kMaxFrames);
}

double PlotView::timeAt(double x) const
{
    const QRectF area = chart()->plotArea();
    return endTime() - m_window * (1.0 - (x - area.left()) / std::max(1.0, area.width()));
}

double PlotView::xAt(double time) const
{
    const QRectF area = chart()->plotArea();
    return area.right() - (endTime() - time) / m_window * area.width();
}

QStringList PlotView::cursorTexts() const
{
    QStringList texts;
    if (!m_cursor || !m_store)
        return texts;
    for (qsizetype i = 0; i < m_curves.size(); ++i) {
        const Curve &curve = m_curves[i];
        const ChannelSpec &spec = m_table[std::size_t(curve.channel)];
        const QString unit = QString::fromUtf8(spec.unit);
        const double value = valueAt(*m_store, curve.channel, curve.minus, *m_cursor);
        if (std::isnan(value)) {
            texts.append(u"%1  –"_s.arg(curveName(i)));
            continue;
        }
        const bool isWhole = curve.minus < 0;  // a difference of two means nothing in words
        QString text = u"%1  %2 %3"_s.arg(
            curveName(i), isWhole ? channelValueText(spec, value) : numberText(value, spec.decimals), unit);
        const double before
            = m_reference ? valueAt(*m_store, curve.channel, curve.minus, *m_reference) : std::nan("");
        if (!std::isnan(before) && spec.choices.empty())
            text += u"  (Δ %1%2)"_s.arg(value < before ? u""_s : u"+"_s,
                                        numberText(value - before, spec.decimals));
        texts.append(text);
    }
    return texts;
}

// Axes, grid and legend seldom change and cost more than the traces: a picture of them is kept. A frame is
// that picture around the plot area, the traces in it, and what lies over them.
void PlotView::paintEvent(QPaintEvent *event)
{
    const double scale = devicePixelRatioF();
    if (m_still.isNull() || m_still.size() != (QSizeF(viewport()->size()) * scale).toSize())
        drawStill();
    QPainter painter(viewport());
    painter.scale(1 / scale, 1 / scale);  // device pixels: copying is quick where nothing is stretched
    const auto copy = [&](const QRectF &part) {
        const QRect pixels = QRectF(part.topLeft() * scale, part.size() * scale).toAlignedRect();
        if (!pixels.isEmpty())
            painter.drawPixmap(pixels.topLeft(), m_still, pixels);
    };
    const QRectF all = event->rect();
    const QRectF area = chart()->plotArea();
    if (m_traces.isEmpty()) {
        copy(all);
    } else {
        copy({all.topLeft(), QPointF(all.right(), area.top())});
        copy({QPointF(all.left(), area.bottom()), all.bottomRight()});
        copy({all.topLeft(), QPointF(area.left(), all.bottom())});
        copy({QPointF(area.right(), all.top()), all.bottomRight()});
        m_traces.paint(painter);
    }
    painter.scale(scale, scale);
    drawOverlay(painter);
}

void PlotView::drawStill()
{
    m_still = QPixmap((QSizeF(viewport()->size()) * devicePixelRatioF()).toSize());
    QPainter painter(&m_still);
    painter.scale(devicePixelRatioF(), devicePixelRatioF());
    painter.setRenderHints(renderHints());
    const QRectF all(QPointF(0, 0), QSizeF(viewport()->size()));
    painter.fillRect(all, backgroundBrush());
    scene()->render(&painter, all, all);
    m_legend.paint(painter, m_theme.color(ColorRole::Text));
    painter.setFont(font());
    painter.setPen(m_theme.color(ColorRole::Muted));
    painter.drawText(
        QRectF(kAreaLeft, kNamesTop, width() - kAreaLeft - kAreaRight, QFontMetricsF(font()).height()),
        Qt::AlignRight | Qt::AlignVCenter, m_rateText);
}

void PlotView::drawOverlay(QPainter &painter)
{
    const QRectF area = chart()->plotArea();
    PlotOverlay overlay(painter, area, m_theme);
    const auto inside
        = [&](std::optional<double> time) { return time && *time >= startTime() && *time <= endTime(); };
    if (m_marks) {
        for (const PlotMark &mark : m_marks->between(startTime(), endTime()))
            overlay.mark(xAt(mark.time), mark.kind);
    }
    if (isHeld() && m_store) {
        const QDateTime end = m_store->wallClockAt(endTime());
        overlay.corner(tr("until %1").arg(end.toString(u"HH:mm:ss.zzz"_s)));
    }
    QStringList leftOut;  // of the scales
    for (const ValueAxis &axis : m_axes) {
        if (axis.isOutside)
            leftOut.append(tr("earlier from %1 to %2 %3")
                               .arg(shortNumberText(double(axis.outside.low), 3))
                               .arg(shortNumberText(double(axis.outside.high), 3))
                               .arg(axis.unit));
    }
    if (!leftOut.isEmpty() && !isHeld())
        overlay.corner(leftOut.join(u" · "_s));
    if (inside(m_reference))
        overlay.reference(xAt(*m_reference));
    if (m_drag == Drag::Box)
        overlay.selection(QRectF(m_dragFrom, m_dragAt).normalized());
    if (!inside(m_cursor))
        return;
    const double x = xAt(*m_cursor);
    overlay.cursor(x);
    QList<PlotOverlay::Line> lines;
    if (const PlotMark *mark = m_marks ? m_marks->near(*m_cursor, 5.0 * m_window / area.width()) : nullptr)
        lines.append({u"▸ "_s + mark->text, {}});
    QString time = m_store ? m_store->wallClockAt(*m_cursor).toString(u"HH:mm:ss.zzz"_s) : QString();
    if (m_reference && *m_reference != *m_cursor) {
        const double apart = *m_cursor - *m_reference;
        time += tr("  Δ %1 s (%2 Hz)")
                    .arg(numberText(apart, 4))
                    .arg(shortNumberText(std::abs(1.0 / apart), 4));
    }
    lines.append({time, {}});
    const QStringList texts = cursorTexts();
    for (qsizetype i = 0; i < texts.size(); ++i)
        lines.append({texts[i], curveColor(i)});
    overlay.box(x, lines);
}
