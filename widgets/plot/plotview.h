// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/telemetry.h"
#include "widgets/theme/theme.h"

#include <QChartView>
#include <QElapsedTimer>

#include <optional>

class QLineSeries;
class QValueAxis;
class TraceItem;

/// What one trace shows.
struct Curve
{
    int channel = -1;
    int minus = -1;      ///< channel to subtract, -1 = none
    QString name;        ///< empty: the channel's label
};

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
    void setCurves(ChannelTable table, const QList<Curve> &curves, std::shared_ptr<const TelemetryStore> store);
    void setWindow(double seconds);
    /// Stands still, showing the past up to that time of the store.
    void hold(double end);
    /// Shows the newest samples again.
    void follow();
    [[nodiscard]] bool isHeld() const;
    /// Time at the right edge, in seconds since the store's origin.
    [[nodiscard]] double endTime() const;
    /// A line with the values at that time; empty = none.
    void setCursorTime(std::optional<double> time);
    [[nodiscard]] std::optional<double> cursorTime() const { return m_cursor; }
    [[nodiscard]] QStringList cursorTexts() const;
    [[nodiscard]] const QList<Curve> &curves() const { return m_curves; }

    /// One frame: called by the one timer of all plots, only while visible. True if something was painted anew.
    bool advance();
    /// Frames per second worth having at this window and size: one per scrolled pixel, 60 at most.
    [[nodiscard]] int usefulRate() const;

signals:
    /// The operator wants more (below 1) or less time, keeping this time in its place.
    void zoomRequested(double factor, double around);
    /// The operator moves the picture by so many seconds.
    void panRequested(double seconds);
    void cursorMoved(std::optional<double> time);
    /// The operator wants the newest samples again.
    void followRequested();

protected:
    void resizeEvent(QResizeEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void drawForeground(QPainter *painter, const QRectF &rect) override;

private:
    void applyTheme();
    void fitScale();
    void setScale(double low, double high, int steps);
    void updateView();
    [[nodiscard]] QColor colorOf(qsizetype curve, int &next) const;
    [[nodiscard]] double timeAt(double x) const;

    const Theme &m_theme;
    ChannelTable m_table;
    QList<Curve> m_curves;
    std::shared_ptr<const TelemetryStore> m_store;
    int m_generation = -1;
    QValueAxis *m_timeAxis;
    QValueAxis *m_valueAxis;
    QList<QLineSeries *> m_series;    // empty ones, for names, colours and the legend's toggles
    TraceItem *m_traces;
    double m_window = 10;
    double m_low = -1;
    double m_high = 1;
    std::optional<double> m_cursor;
    std::optional<double> m_dragFrom;      // x of the last mouse position while the picture is dragged
    QElapsedTimer m_shrinkTimer;
};
