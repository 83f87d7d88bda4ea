// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/streams.h"
#include "widgets/plot/plotlegend.h"
#include "widgets/plot/plotmarks.h"
#include "widgets/plot/traceimage.h"
#include "widgets/plot/valuescale.h"
#include "widgets/theme/theme.h"

#include <QChartView>
#include <QElapsedTimer>
#include <QPixmap>
#include <QPointer>

#include <memory>
#include <optional>

class QValueAxis;

/// What one trace shows.
struct Curve
{
    int channel = -1;
    int minus = -1;  ///< channel to subtract, -1 = none
    QString name;  ///< empty: the channel's label
};

/// A live plot: Qt Charts for axes, grid and legend; our own item for the traces. Time runs as "seconds ago".
/// Traces of one unit share a value axis (or each has its own), which follows them with hysteresis and round
/// steps, or stands still.
class PlotView final : public QChartView
{
    Q_OBJECT
public:
    PlotView(const Theme &theme, QWidget *parent = nullptr);
    ~PlotView() override;

    /// Which channels to show; what is none of the table's (a role that this board has not) is left out. The
    /// table must outlive the view's use of it.
    void setChannels(ChannelTable table, const QList<int> &channels,
                     std::shared_ptr<const TelemetryStore> store);
    void setCurves(ChannelTable table, const QList<Curve> &curves,
                   std::shared_ptr<const TelemetryStore> store);
    [[nodiscard]] const QList<Curve> &curves() const { return m_curves; }
    [[nodiscard]] QString curveName(qsizetype curve) const;
    [[nodiscard]] QColor curveColor(qsizetype curve) const;
    /// Each trace has a value axis of its own, instead of one for each unit.
    void setOwnScales(bool own);
    [[nodiscard]] bool hasOwnScales() const { return m_ownScales; }
    /// Value axes at the right side, besides the first one at the left.
    [[nodiscard]] int rightAxes() const { return std::max(0, int(m_axes.size()) - 1); }
    /// Keeps room for so many axes at the right, so that plots above each other line up.
    void setRightRoom(int axes);
    /// What happened, drawn as lines; null = nothing.
    void setMarks(const PlotMarks *marks);

    void setWindow(double seconds);
    /// Stands still, showing the past up to that time of the store.
    void hold(double end);
    /// Shows the newest samples again.
    void follow();
    [[nodiscard]] bool isHeld() const;
    /// Time at the right edge, in seconds since the store's origin.
    [[nodiscard]] double endTime() const;
    [[nodiscard]] double startTime() const { return endTime() - m_window; }
    /// A line with the values at that time; empty = none.
    void setCursorTime(std::optional<double> time);
    [[nodiscard]] std::optional<double> cursorTime() const { return m_cursor; }
    /// A second line that the cursor's differences are counted from; empty = none.
    void setReferenceTime(std::optional<double> time);
    [[nodiscard]] std::optional<double> referenceTime() const { return m_reference; }
    /// Values at the cursor, and how much they differ from those at the reference.
    [[nodiscard]] QStringList cursorTexts() const;
    /// Lets value axes follow the traces again after zooming to a box.
    void autoScale();
    /// The range of a value axis. @param axis from 0, the left one
    [[nodiscard]] const ValueScale &scale(std::size_t axis) const { return m_axes[axis].scale; }
    /// The traces' names as they are shown; a click on one hides its trace.
    [[nodiscard]] const PlotLegend &legend() const { return m_legend; }

    /// One frame: called by the one timer of all plots, only while visible. True if something was painted
    /// anew.
    bool advance();
    /// Frames per second worth having at this window and size: one per scrolled pixel, 60 at most.
    [[nodiscard]] int usefulRate() const;

signals:
    /// The operator wants more (below 1) or less time, keeping this time in its place.
    void zoomRequested(double factor, double around);
    /// The operator wants to see just this.
    void spanRequested(double from, double to);
    /// The operator moves the picture by so many seconds.
    void panRequested(double seconds);
    void cursorMoved(std::optional<double> time);
    void referenceMoved(std::optional<double> time);
    /// The operator wants the newest samples again.
    void followRequested();
    /// Channels were dragged here.
    void channelsDropped(const QList<int> &channels);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dragMoveEvent(QDragMoveEvent *event) override;
    void dropEvent(QDropEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    struct ValueAxis
    {
        QValueAxis *axis = nullptr;
        ValueScale scale;
        QString unit;
        bool isOutside = false;  // the scale leaves a transient out
        TraceColumns::Span outside;  // from where to where that reaches
    };
    enum class Drag { None, Undecided, Pan, Box };

    void makeAxes();
    void layOut();
    void applyTheme();
    void applyScale(const ValueAxis &axis);
    void fitScales();
    void updateView();
    void drawStill();
    void drawOverlay(QPainter &painter);
    void zoomToBox(const QRectF &box);
    void updateRateText();
    [[nodiscard]] QColor colorOf(qsizetype curve, int &next) const;
    [[nodiscard]] double timeAt(double x) const;
    [[nodiscard]] double xAt(double time) const;

    const Theme &m_theme;
    ChannelTable m_table;
    QList<Curve> m_curves;
    std::shared_ptr<const TelemetryStore> m_store;
    QPointer<const PlotMarks> m_marks;
    int m_generation = -1;
    QValueAxis *m_timeAxis;
    std::vector<ValueAxis> m_axes;
    PlotLegend m_legend;
    TraceImage m_traces;
    double m_window = 10;
    bool m_ownScales = false;
    int m_rightRoom = 0;
    std::optional<double> m_cursor;
    std::optional<double> m_reference;
    QPixmap m_still;  // axes, grid and legend; empty: to be drawn anew
    QString m_rateText;  // samples per second, and the highest frequency that they can show
    QElapsedTimer m_rateTimer;
    QElapsedTimer m_fitTimer;
    Drag m_drag = Drag::None;
    QPointF m_dragFrom;  // where the button went down
    QPointF m_dragAt;  // where the mouse is or was last
};
