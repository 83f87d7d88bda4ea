// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/plotclock.h"

#include "widgets/plot/plotview.h"

#include <QElapsedTimer>

#include <algorithm>

namespace {

constexpr qint64 kSlowFrameMs = 12;  // a frame over this, a few times in a row, halves the rate
constexpr int kSlowFramesInARow = 5;
constexpr qint64 kQuickFrameMs = 5;  // when it is quick again for a while, the rate comes back
constexpr int kQuickFramesInARow = 120;

}  // namespace

PlotClock::PlotClock(QObject *parent)
    : QObject(parent)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &PlotClock::frame);
}

void PlotClock::setPlots(const QList<PlotView *> &plots)
{
    m_plots = plots;
    updateRate();
}

void PlotClock::start()
{
    updateRate();
    m_timer.start();
}

void PlotClock::frame()
{
    if (m_plots.isEmpty() || m_plots.first()->window()->isMinimized())
        return;
    QElapsedTimer timer;
    timer.start();
    for (PlotView *plot : m_plots)
        plot->advance();
    const qint64 spent = timer.elapsed();
    m_slowFrames = spent > kSlowFrameMs ? m_slowFrames + 1 : 0;
    m_quickFrames = spent < kQuickFrameMs ? m_quickFrames + 1 : 0;
    if (m_quickFrames >= kQuickFramesInARow && m_rateDivider > 1) {
        m_quickFrames = 0;
        m_rateDivider /= 2;
        updateRate();
    }
    if (m_slowFrames >= kSlowFramesInARow && m_rateDivider < 4) {
        m_slowFrames = 0;
        m_rateDivider *= 2;
        updateRate();
    }
}

void PlotClock::updateRate()
{
    int rate = 10;
    for (const PlotView *plot : m_plots)
        rate = std::max(rate, plot->usefulRate());
    m_timer.setInterval(1000 / std::max(5, rate / m_rateDivider));
}
