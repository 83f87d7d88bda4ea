// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/plotstack.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kFiguresPeriod = 200ms;

}  // namespace

PlotStack::PlotStack(const Theme &theme, QWidget *parent)
    : QSplitter(Qt::Vertical, parent)
    , m_theme(theme)
{
    setChildrenCollapsible(false);
    m_figuresTimer.setInterval(kFiguresPeriod);
    connect(&m_figuresTimer, &QTimer::timeout, this, [this] {
        for (PlotPanel *panel : m_panels)
            panel->refreshFigures();
    });
}

void PlotStack::setSource(ChannelTable table, std::shared_ptr<const TelemetryStore> store)
{
    if (store != m_store) {  // another time line: its marks would stand at meaningless times
        for (PlotPanel *panel : m_panels) {
            panel->view()->setCursorTime({});
            panel->view()->setReferenceTime({});
        }
    }
    m_table = table;
    m_store = std::move(store);
    for (PlotLayout::Plot &plot : m_layout)
        plot.channels.removeIf([this](int channel) { return channel >= int(m_table.size()); });
    rebuild();
}

void PlotStack::setMarks(const PlotMarks *marks)
{
    m_marks = marks;
    for (PlotPanel *panel : m_panels)
        panel->view()->setMarks(marks);
}

void PlotStack::setPlots(const QList<PlotLayout::Plot> &plots)
{
    m_layout = plots;
    rebuild();
}

QList<int> PlotStack::channels() const
{
    QList<int> all;
    for (const PlotLayout::Plot &plot : m_layout)
        all.append(plot.channels);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

void PlotStack::setChannels(const QList<int> &wanted)
{
    const QList<int> before = channels();
    if (wanted == before)
        return;
    for (PlotLayout::Plot &plot : m_layout)
        plot.channels.removeIf([&](int channel) { return !wanted.contains(channel); });
    m_layout.removeIf([](const PlotLayout::Plot &plot) { return plot.channels.isEmpty(); });
    for (const int channel : wanted) {
        if (before.contains(channel))
            continue;
        const QByteArray unit = m_table[std::size_t(channel)].unit;
        const auto sameUnit = [&](const PlotLayout::Plot &plot) {
            return std::all_of(plot.channels.begin(), plot.channels.end(),
                               [&](int other) { return unit == m_table[std::size_t(other)].unit; });
        };
        const auto plot = std::find_if(m_layout.begin(), m_layout.end(), sameUnit);
        if (plot == m_layout.end()) {
            m_layout.append({{channel}, false, false});
        } else {
            plot->channels.append(channel);
            std::sort(plot->channels.begin(), plot->channels.end());
        }
    }
    rebuild();
    emit edited();
}

void PlotStack::addChannels(qsizetype plot, const QList<int> &fresh)
{
    if (plot < 0 || plot >= m_layout.size()) {
        plot = m_layout.size();
        m_layout.append(PlotLayout::Plot());
    }
    for (const int channel : fresh) {
        if (channel >= 0 && channel < int(m_table.size()) && !m_layout[plot].channels.contains(channel))
            m_layout[plot].channels.append(channel);
    }
    m_layout.removeIf([](const PlotLayout::Plot &each) { return each.channels.isEmpty(); });
    rebuild();
    emit edited();
}

PlotPanel *PlotStack::makePanel()
{
    auto *panel = new PlotPanel(m_theme);
    PlotView *view = panel->view();
    view->setMarks(m_marks);
    view->setWindow(m_seconds);
    if (m_paused && !m_panels.isEmpty())
        view->hold(endTime());
    const auto place = [this, panel] { return m_panels.indexOf(panel); };
    connect(view, &PlotView::zoomRequested, this, &PlotStack::zoom);
    connect(view, &PlotView::spanRequested, this, &PlotStack::showSpan);
    connect(view, &PlotView::panRequested, this, [this, view](double by) {
        const double end = view->endTime() + by;
        setPaused(true);
        holdAt(end);
    });
    connect(view, &PlotView::followRequested, this, [this] { setPaused(false); });
    connect(view, &PlotView::cursorMoved, this, [this](std::optional<double> time) {
        for (PlotPanel *each : m_panels)
            each->view()->setCursorTime(time);
    });
    connect(view, &PlotView::referenceMoved, this, [this](std::optional<double> time) {
        for (PlotPanel *each : m_panels)
            each->view()->setReferenceTime(time);
    });
    // Panels are changed only after the event that requested it has been handled.
    connect(
        view, &PlotView::channelsDropped, this,
        [this, place](const QList<int> &dropped) { addChannels(place(), dropped); }, Qt::QueuedConnection);
    connect(
        panel, &PlotPanel::removeChannelRequested, this,
        [this, place](int channel) {
            if (place() < 0)
                return;
            m_layout[place()].channels.removeAll(channel);
            m_layout.removeIf([](const PlotLayout::Plot &each) { return each.channels.isEmpty(); });
            rebuild();
            emit edited();
        },
        Qt::QueuedConnection);
    connect(
        panel, &PlotPanel::removeRequested, this,
        [this, place] {
            if (place() < 0)
                return;
            m_layout.removeAt(place());
            rebuild();
            emit edited();
        },
        Qt::QueuedConnection);
    connect(panel, &PlotPanel::changed, this, &PlotStack::takeSettings);
    return panel;
}

void PlotStack::takeSettings()
{
    for (qsizetype i = 0; i < m_panels.size(); ++i) {
        m_layout[i].ownScales = m_panels[i]->view()->hasOwnScales();
        m_layout[i].figures = m_panels[i]->figuresVisible();
    }
    rebuild();
    emit edited();
}

void PlotStack::rebuild()
{
    while (m_panels.size() > m_layout.size())
        delete m_panels.takeLast();
    while (m_panels.size() < m_layout.size()) {
        PlotPanel *panel = makePanel();
        addWidget(panel);
        m_panels.append(panel);
    }
    int right = 0;
    for (qsizetype i = 0; i < m_layout.size(); ++i) {
        PlotPanel *panel = m_panels[i];
        panel->setAccessibleName(tr("Plot %1").arg(i + 1));
        panel->setChannels(m_table, m_layout[i].channels, m_store);  // first: the old table may be gone
        panel->view()->setOwnScales(m_layout[i].ownScales);
        panel->setFiguresVisible(m_layout[i].figures);
        right = std::max(right, panel->view()->rightAxes());
    }
    for (PlotPanel *panel : m_panels)
        panel->view()->setRightRoom(right);
    m_clock.setPlots(plots());
}

QList<PlotView *> PlotStack::plots() const
{
    QList<PlotView *> views;
    for (PlotPanel *panel : m_panels)
        views.append(panel->view());
    return views;
}

double PlotStack::endTime() const
{
    return m_panels.isEmpty() ? 0.0 : m_panels.first()->view()->endTime();
}

void PlotStack::setSeconds(double seconds)
{
    m_seconds = std::clamp(seconds, kShortest, kLongest);
    for (PlotPanel *panel : m_panels) {
        panel->view()->setWindow(m_seconds);
        if (panel->view()->isHeld())
            panel->view()->hold(panel->view()->endTime());
    }
    m_clock.updateRate();
    emit secondsChanged(m_seconds);
}

void PlotStack::setPaused(bool paused)
{
    if (m_paused == paused)
        return;
    m_paused = paused;
    for (PlotPanel *panel : m_panels) {
        if (paused)
            panel->view()->hold(panel->view()->endTime());
        else
            panel->view()->follow();
    }
    emit pausedChanged(paused);
}

void PlotStack::holdAt(double end)
{
    const double newest = m_store ? m_store->now() : end;
    for (PlotPanel *panel : m_panels)
        panel->view()->hold(std::min(end, newest));
}

void PlotStack::showSpan(double from, double to)
{
    setPaused(true);
    setSeconds(to - from);
    holdAt(to);
}

void PlotStack::zoom(double factor, double around)
{
    const double before = m_seconds;
    const double end = endTime();
    setSeconds(m_seconds * factor);
    // Live pictures keep their right edge, which is now; held ones keep the time under the cursor.
    if (m_paused)
        holdAt(around + (end - around) * m_seconds / before);
}

void PlotStack::showEvent(QShowEvent *event)
{
    QSplitter::showEvent(event);
    m_clock.start();
    m_figuresTimer.start();
}

void PlotStack::hideEvent(QHideEvent *event)
{
    QSplitter::hideEvent(event);
    m_clock.stop();
    m_figuresTimer.stop();
}
