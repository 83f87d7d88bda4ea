// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plot/plotclock.h"
#include "widgets/plot/plotlayout.h"
#include "widgets/plot/plotpanel.h"

#include <QSplitter>

/// Plots above each other that share time: one window, one cursor, held or running together.
class PlotStack final : public QSplitter
{
    Q_OBJECT
public:
    static constexpr double kShortest = 0.1;  // seconds shown
    static constexpr double kLongest = 3600;

    PlotStack(const Theme &theme, QWidget *parent = nullptr);

    /// Where the plots find their data. The table must outlive the use of it.
    void setSource(ChannelTable table, std::shared_ptr<const TelemetryStore> store);
    void setMarks(const PlotMarks *marks);
    void setPlots(const QList<PlotLayout::Plot> &plots);
    [[nodiscard]] const QList<PlotLayout::Plot> &layoutPlots() const { return m_layout; }
    /// All channels of all plots, in the order of the table.
    [[nodiscard]] QList<int> channels() const;
    /// Shows just these channels: new ones join a plot of their unit, others leave theirs.
    void setChannels(const QList<int> &channels);
    /// Puts channels into one plot, or into a new one below if there is no such plot.
    void addChannels(qsizetype plot, const QList<int> &channels);

    void setSeconds(double seconds);
    [[nodiscard]] double seconds() const { return m_seconds; }
    void setPaused(bool paused);
    [[nodiscard]] bool isPaused() const { return m_paused; }
    /// Stands still at this span.
    void showSpan(double from, double to);
    /// Time at the right edge; 0 without plots.
    [[nodiscard]] double endTime() const;

    [[nodiscard]] QList<PlotView *> plots() const;
    [[nodiscard]] const QList<PlotPanel *> &panels() const { return m_panels; }

signals:
    /// The operator changed which plots there are or what they show.
    void edited();
    void secondsChanged(double seconds);
    void pausedChanged(bool paused);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void rebuild();
    void takeSettings();
    PlotPanel *makePanel();
    void zoom(double factor, double around);
    void holdAt(double end);

    const Theme &m_theme;
    ChannelTable m_table;
    std::shared_ptr<const TelemetryStore> m_store;
    const PlotMarks *m_marks = nullptr;
    QList<PlotLayout::Plot> m_layout;
    QList<PlotPanel *> m_panels;
    PlotClock m_clock;
    QTimer m_figuresTimer;
    double m_seconds = 10;
    bool m_paused = false;
};
