// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/plotview.h"

#include "widgets/models/parametermodel.h"
#include "widgets/plot/spanstatistics.h"
#include "widgets/plot/traceitem.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QKeyEvent>
#include <QLegendMarker>
#include <QLineSeries>
#include <QMouseEvent>
#include <QPainter>
#include <QValueAxis>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace Qt::StringLiterals;

namespace {

constexpr int kMostFrames = 60;
// Room for labels and legend around the plot area.
constexpr double kLeft = 76;
constexpr double kTop = 34;
constexpr double kRight = 20;
constexpr double kBottom = 30;
// The scale shrinks only after the traces have used less than this part of it for a while.
constexpr double kShrinkBelow = 0.4;
constexpr qint64 kShrinkAfterMs = 1500;

// The next round number of the series 1, 2, 5 that is not below the value.
double roundStep(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-9))));
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
        if (factor * power >= value * 0.999999)
            return factor * power;
    }
    return 10.0 * power;
}

struct Scale
{
    double low;
    double high;
    int steps;
};

// The tightest scale of four to six round steps that holds the values with some air.
Scale roundScale(double low, double high)
{
    Scale best{low, high, 4};
    double tightest = std::numeric_limits<double>::infinity();
    for (const int steps : {4, 5, 6}) {
        double step = roundStep(std::max((high - low) * 1.08, 0.08) / steps);
        double bottom = std::floor(low / step) * step;
        if (bottom + steps * step < high) {
            step = roundStep(step * 1.01);
            bottom = std::floor(low / step) * step;
        }
        if (steps * step < tightest * 0.999 && bottom + steps * step >= high) {
            tightest = steps * step;
            best = {bottom, bottom + steps * step, steps};
        }
    }
    return best;
}

} // namespace

PlotView::PlotView(const Theme &theme, QWidget *parent)
    : QChartView(parent)
    , m_theme(theme)
    , m_timeAxis(new QValueAxis(this))
    , m_valueAxis(new QValueAxis(this))
{
    QChart *plot = chart();   // the view's own; one set over it would leave this one behind
    m_traces = new TraceItem(plot);
    m_traces->setZValue(10);
    plot->setAnimationOptions(QChart::NoAnimation);
    plot->setBackgroundVisible(false);
    plot->setBackgroundRoundness(0);
    plot->setMargins({0, 0, 4, 0});
    plot->layout()->setContentsMargins(0, 0, 0, 0);
    plot->legend()->setAlignment(Qt::AlignTop);
    plot->legend()->detachFromChart();
    plot->legend()->setBackgroundVisible(false);
    plot->legend()->setMarkerShape(QLegend::MarkerShapeRectangle);
    plot->addAxis(m_timeAxis, Qt::AlignBottom);
    plot->addAxis(m_valueAxis, Qt::AlignLeft);
    for (QValueAxis *axis : {m_timeAxis, m_valueAxis}) {
        axis->setLinePenColor(Qt::transparent);
        axis->setMinorTickCount(0);
    }
    m_timeAxis->setLabelFormat(u"%g s"_s);
    m_valueAxis->setLabelFormat(u"%g"_s);
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing, false);
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
    setMinimumHeight(120);
    setAccessibleName(tr("Live plot"));
    viewport()->setAccessibleName(accessibleName());
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    viewport()->setMouseTracking(true);
    connect(&m_theme, &Theme::changed, this, &PlotView::applyTheme);
    connect(plot, &QChart::plotAreaChanged, this, &PlotView::updateView);
    applyTheme();
    setWindow(m_window);
    setScale(-1, 1, 4);
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

void PlotView::setCurves(ChannelTable table, const QList<Curve> &curves, std::shared_ptr<const TelemetryStore> store)
{
    m_table = table;
    m_curves = curves;
    m_store = std::move(store);
    m_generation = -1;
    for (QLineSeries *series : std::exchange(m_series, {})) {
        chart()->removeSeries(series);
        delete series;
    }
    m_traces->traces().clear();
    for (const Curve &curve : curves) {
        auto *series = new QLineSeries(this);
        series->setName(curve.name.isEmpty() ? tableText(table[std::size_t(curve.channel)].label) : curve.name);
        chart()->addSeries(series);
        series->attachAxis(m_timeAxis);
        series->attachAxis(m_valueAxis);
        m_series.append(series);
        TraceItem::Trace trace;
        trace.channel = curve.channel;
        trace.minus = curve.minus;
        m_traces->traces().push_back(std::move(trace));
    }
    const auto markers = chart()->legend()->markers();
    for (qsizetype i = 0; i < markers.size(); ++i) {
        connect(markers[i], &QLegendMarker::clicked, this, [this, i] {
            if (std::size_t(i) >= m_traces->traces().size())
                return;
            TraceItem::Trace &trace = m_traces->traces()[std::size_t(i)];
            trace.visible = !trace.visible;
            m_traces->invalidate();
            applyTheme();
        });
    }
    // The unit stands at the scale, where the numbers are.
    m_valueAxis->setTitleText(
        curves.isEmpty() ? QString() : QString::fromUtf8(table[std::size_t(curves.first().channel)].unit));
    applyTheme();
}

void PlotView::applyTheme()
{
    const QColor text = m_theme.color(ColorRole::Muted);
    setBackgroundBrush(m_theme.color(ColorRole::Surface));
    for (QValueAxis *axis : {m_timeAxis, m_valueAxis}) {
        axis->setLabelsColor(text);
        axis->setTitleBrush(text);
        axis->setGridLineColor(m_theme.color(ColorRole::SurfaceRaised));
    }
    chart()->legend()->setLabelColor(m_theme.color(ColorRole::Text));
    int next = 0;
    for (qsizetype i = 0; i < m_series.size(); ++i) {
        TraceItem::Trace &trace = m_traces->traces()[std::size_t(i)];
        trace.color = colorOf(i, next);
        QColor shown = trace.color;
        if (!trace.visible)
            shown.setAlpha(60);
        m_series[i]->setPen(QPen(shown, 1));
        m_series[i]->setBrush(shown);
    }
    const auto markers = chart()->legend()->markers();
    for (QLegendMarker *marker : markers)
        marker->setPen(QPen(Qt::transparent));   // no pen at all would bring the style's own back
    m_traces->invalidate();
    viewport()->update();
}

void PlotView::setWindow(double seconds)
{
    m_window = seconds;
    m_timeAxis->setRange(-seconds, 0);
    m_timeAxis->setTickCount(6);
    updateView();
}

void PlotView::hold(double end)
{
    m_traces->hold(end);
    advance();
    viewport()->update();
}

void PlotView::follow()
{
    m_traces->follow();
    viewport()->update();
}

bool PlotView::isHeld() const
{
    return m_traces->heldAt().has_value();
}

double PlotView::endTime() const
{
    return m_traces->end();
}

void PlotView::setCursorTime(std::optional<double> time)
{
    if (m_cursor == time)
        return;
    m_cursor = time;
    viewport()->update();
}

void PlotView::setScale(double low, double high, int steps)
{
    m_low = low;
    m_high = high;
    m_valueAxis->setRange(low, high);
    m_valueAxis->setTickCount(steps + 1);
    updateView();
}

void PlotView::updateView()
{
    if (chart())
        m_traces->setView(chart()->plotArea(), m_window, m_low, m_high, devicePixelRatioF());
}

void PlotView::resizeEvent(QResizeEvent *event)
{
    // The same edges in every plot, whatever its labels need, so that stacked plots line up. Set first: the chart lays its
    // labels out when it gets its size, and hides those that lie outside.
    const QSizeF size = event->size();
    chart()->setPlotArea({kLeft, kTop, std::max(10.0, size.width() - kLeft - kRight),
                          std::max(10.0, size.height() - kTop - kBottom)});
    QChartView::resizeEvent(event);
    // The legend stays where the room for it is; attached to the chart it keeps what room it found when it was hidden.
    chart()->legend()->setGeometry(kLeft, 2, std::max(10.0, size.width() - kLeft - kRight), kTop - 4);
    chart()->legend()->update();
    updateView();
}

bool PlotView::advance()
{
    if (!m_store || m_curves.isEmpty())
        return false;
    if (m_generation != m_store->generation()) {
        m_generation = m_store->generation();
        for (TraceItem::Trace &trace : m_traces->traces())
            trace.sources = TraceSource::find(*m_store, trace.channel, trace.minus);
        m_traces->invalidate();
    }
    const double newest = m_traces->newestSample();
    if (std::isnan(newest))
        return false;
    if (!m_traces->advance(newest))
        return false;
    fitScale();
    return true;
}

void PlotView::fitScale()
{
    const TraceColumns::Span used = m_traces->visibleRange();
    if (used.isEmpty())
        return;
    const double low = double(used.low);
    const double high = double(used.high);
    const double span = m_high - m_low;
    const bool outside = low < m_low || high > m_high;
    if (!outside && (high - low > kShrinkBelow * span || span <= 0.1)) {
        m_shrinkTimer.invalidate();
        return;
    }
    if (!outside) {
        if (!m_shrinkTimer.isValid())
            m_shrinkTimer.start();
        if (m_shrinkTimer.elapsed() < kShrinkAfterMs)
            return;
    }
    m_shrinkTimer.invalidate();
    const Scale scale = roundScale(low, high);
    if (scale.low != m_low || scale.high != m_high)
        setScale(scale.low, scale.high, scale.steps);
}

int PlotView::usefulRate() const
{
    const double pixelsPerSecond = chart()->plotArea().width() * devicePixelRatioF() / m_window;
    return std::clamp(int(std::ceil(pixelsPerSecond)), 10, kMostFrames);
}

double PlotView::timeAt(double x) const
{
    const QRectF area = chart()->plotArea();
    return endTime() - m_window * (1.0 - (x - area.left()) / std::max(1.0, area.width()));
}

QStringList PlotView::cursorTexts() const
{
    QStringList texts;
    if (!m_cursor || !m_store)
        return texts;
    for (const Curve &curve : m_curves) {
        const ChannelSpec &spec = m_table[std::size_t(curve.channel)];
        const double value = valueAt(*m_store, curve.channel, curve.minus, *m_cursor);
        const QString name = curve.name.isEmpty() ? tableText(spec.label) : curve.name;
        texts.append(std::isnan(value) ? u"%1  –"_s.arg(name)
                                       : u"%1  %2 %3"_s.arg(name, QString::number(value, 'f', spec.decimals),
                                                            QString::fromUtf8(spec.unit)));
    }
    return texts;
}

void PlotView::drawForeground(QPainter *painter, const QRectF &rect)
{
    QChartView::drawForeground(painter, rect);
    const QRectF area = chart()->plotArea();
    if (!m_cursor)
        return;
    const double x = area.right() - (endTime() - *m_cursor) / m_window * area.width();
    if (x < area.left() || x > area.right())
        return;
    painter->setPen(QPen(m_theme.color(ColorRole::Muted), 1, Qt::DashLine));
    painter->drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    const QStringList texts = cursorTexts();
    const QFontMetricsF metrics(font());
    double width = 0;
    for (const QString &text : texts)
        width = std::max(width, metrics.horizontalAdvance(text));
    const double lines = std::min<double>(double(texts.size()), std::floor((area.height() - 8) / metrics.lineSpacing()));
    QRectF box(x + 8, area.top() + 4, width + 28, lines * metrics.lineSpacing() + 8);
    if (box.right() > area.right())
        box.moveRight(x - 8);
    QColor background = m_theme.color(ColorRole::SurfaceRaised);
    background.setAlpha(235);
    painter->setPen(m_theme.color(ColorRole::Border));
    painter->setBrush(background);
    painter->drawRoundedRect(box, 4, 4);
    for (int i = 0; i < int(lines); ++i) {
        const double top = box.top() + 4 + i * metrics.lineSpacing();
        painter->fillRect(QRectF(box.left() + 6, top + metrics.lineSpacing() / 2 - 4, 8, 8),
                          m_traces->traces()[std::size_t(i)].color);
        painter->setPen(m_theme.color(ColorRole::Text));
        painter->drawText(QRectF(box.left() + 20, top, width + 4, metrics.lineSpacing()),
                          Qt::AlignLeft | Qt::AlignVCenter, texts[i]);
    }
}

void PlotView::wheelEvent(QWheelEvent *event)
{
    const int steps = event->angleDelta().y();
    if (steps == 0) {
        event->ignore();
        return;
    }
    emit zoomRequested(steps > 0 ? 0.8 : 1.25, timeAt(event->position().x()));
    event->accept();
}

void PlotView::mousePressEvent(QMouseEvent *event)
{
    QChartView::mousePressEvent(event);   // the legend's toggles
    if (event->button() == Qt::LeftButton && chart()->plotArea().contains(event->position()))
        m_dragFrom = event->position().x();
}

void PlotView::mouseMoveEvent(QMouseEvent *event)
{
    QChartView::mouseMoveEvent(event);
    const QRectF area = chart()->plotArea();
    if (m_dragFrom && (event->buttons() & Qt::LeftButton)) {
        const double moved = event->position().x() - *m_dragFrom;
        m_dragFrom = event->position().x();
        emit panRequested(-moved / std::max(1.0, area.width()) * m_window);
        return;
    }
    if (area.contains(event->position()))
        emit cursorMoved(timeAt(event->position().x()));
    else
        emit cursorMoved({});
}

void PlotView::mouseReleaseEvent(QMouseEvent *event)
{
    QChartView::mouseReleaseEvent(event);
    m_dragFrom.reset();
}

void PlotView::leaveEvent(QEvent *event)
{
    QChartView::leaveEvent(event);
    emit cursorMoved({});
}

void PlotView::keyPressEvent(QKeyEvent *event)
{
    constexpr double kStep = 0.01;
    const double step = m_window * kStep * (event->modifiers() & Qt::ShiftModifier ? 0.1 : 1.0);
    const double cursor = m_cursor.value_or(endTime() - m_window / 2);
    switch (event->key()) {
    case Qt::Key_Left: emit cursorMoved(cursor - step); return;
    case Qt::Key_Right: emit cursorMoved(std::min(cursor + step, endTime())); return;
    case Qt::Key_PageUp: emit panRequested(-m_window / 2); return;
    case Qt::Key_PageDown: emit panRequested(m_window / 2); return;
    case Qt::Key_Plus: emit zoomRequested(0.8, cursor); return;
    case Qt::Key_Minus: emit zoomRequested(1.25, cursor); return;
    case Qt::Key_End: emit followRequested(); return;
    default: QChartView::keyPressEvent(event);
    }
}
