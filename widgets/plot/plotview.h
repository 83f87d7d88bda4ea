// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/telemetry.h"
#include "widgets/theme/theme.h"

#include <QChartView>
#include <QElapsedTimer>

class QLineSeries;
class QValueAxis;
class TraceItem;

/// A live plot: Qt Charts for axes, grid and legend; our own item for the traces. Time runs as "seconds ago"; the value
/// scale follows the traces with hysteresis and round steps.
class PlotView final : public QChartView
{
    Q_OBJECT
public:
    PlotView(const Theme &theme, QWidget *parent = nullptr);
    ~PlotView() override;

    /// Which channels to show. The table must outlive the view's use of it.
    void setChannels(ChannelTable table, const QList<int> &channels, std::shared_ptr<const TelemetryStore> store);
    void setWindow(double seconds);
    void setPaused(bool paused);

    /// One frame: called by the one timer of all plots, only while visible. True if something was painted anew.
    bool advance();
    /// Frames per second worth having at this window and size: one per scrolled pixel, 60 at most.
    [[nodiscard]] int usefulRate() const;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void applyTheme();
    void fitScale();
    void setScale(double low, double high, int steps);
    void updateView();
    [[nodiscard]] QColor colorOf(int channel, int &next) const;

    const Theme &m_theme;
    ChannelTable m_table;
    QList<int> m_channels;
    std::shared_ptr<const TelemetryStore> m_store;
    int m_generation = -1;
    QValueAxis *m_timeAxis;
    QValueAxis *m_valueAxis;
    QList<QLineSeries *> m_series;    // empty ones, for names, colours and the legend's toggles
    TraceItem *m_traces;
    double m_window = 10;
    double m_low = -1;
    double m_high = 1;
    bool m_paused = false;
    QElapsedTimer m_shrinkTimer;
};
