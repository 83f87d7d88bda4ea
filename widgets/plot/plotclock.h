// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QTimer>

class PlotView;

/// The one frame timer of a page's plots. Runs only while started, and slows down when frames take too long.
class PlotClock final : public QObject
{
    Q_OBJECT
public:
    explicit PlotClock(QObject *parent = nullptr);

    void setPlots(const QList<PlotView *> &plots);
    void start();
    void stop() { m_timer.stop(); }
    /// The window or the size of a plot has changed: how often is worth painting?
    void updateRate();
    [[nodiscard]] bool isRunning() const { return m_timer.isActive(); }

private:
    void frame();

    QList<PlotView *> m_plots;
    QTimer m_timer;
    int m_slowFrames = 0;
    int m_quickFrames = 0;
    int m_rateDivider = 1;
};
