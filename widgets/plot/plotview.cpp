// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/plotview.h"

#include "widgets/models/parametermodel.h"
#include "widgets/plot/traceitem.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QLegendMarker>
#include <QLineSeries>
#include <QValueAxis>

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
    connect(&m_theme, &Theme::changed, this, &PlotView::applyTheme);
    connect(plot, &QChart::plotAreaChanged, this, &PlotView::updateView);
    applyTheme();
    setWindow(m_window);
    setScale(-1, 1, 4);
}

PlotView::~PlotView() = default;

QColor PlotView::colorOf(int channel, int &next) const
{
    const Axis axis = m_table[std::size_t(channel)].axis;
    // Axes keep their colour everywhere; a second trace of the same axis in one plot gets another one.
    const bool taken = std::any_of(m_channels.begin(), m_channels.begin() + m_channels.indexOf(channel),
                                   [&](int other) { return m_table[std::size_t(other)].axis == axis; });
    if (axis != Axis::None && !taken)
        return m_theme.axisColor(axis);
    return m_theme.seriesColor(next++);
}

void PlotView::setChannels(ChannelTable table, const QList<int> &channels,
                           std::shared_ptr<const TelemetryStore> store)
{
    m_table = table;
    m_channels = channels;
    m_store = std::move(store);
    m_generation = -1;
    for (QLineSeries *series : std::exchange(m_series, {})) {
        chart()->removeSeries(series);
        delete series;
    }
    m_traces->traces().clear();
    for (const int channel : channels) {
        auto *series = new QLineSeries(this);
        const ChannelSpec &spec = table[std::size_t(channel)];
        series->setName(tableText(spec.label));
        chart()->addSeries(series);
        series->attachAxis(m_timeAxis);
        series->attachAxis(m_valueAxis);
        m_series.append(series);
        TraceItem::Trace trace;
        trace.channel = channel;
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
        channels.isEmpty() ? QString() : QString::fromUtf8(table[std::size_t(channels.first())].unit));
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
        trace.color = colorOf(trace.channel, next);
        QColor shown = trace.color;
        if (!trace.visible)
            shown.setAlpha(60);
        m_series[i]->setPen(QPen(shown, 1));
        m_series[i]->setBrush(shown);
    }
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

void PlotView::setPaused(bool paused)
{
    m_paused = paused;
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
    QChartView::resizeEvent(event);
    // The same edges in every plot, whatever its labels need, so that stacked plots line up.
    const QSizeF size = viewport()->size();
    chart()->setPlotArea({kLeft, kTop, std::max(10.0, size.width() - kLeft - kRight),
                          std::max(10.0, size.height() - kTop - kBottom)});
    updateView();
}

bool PlotView::advance()
{
    if (!m_store || m_paused || m_channels.isEmpty())
        return false;
    if (m_generation != m_store->generation()) {
        m_generation = m_store->generation();
        for (TraceItem::Trace &trace : m_traces->traces())
            trace.tracks = m_store->tracks(trace.channel);
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
