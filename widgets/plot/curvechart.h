// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plot/plotlegend.h"
#include "widgets/theme/theme.h"

#include <QChartView>

class QAbstractAxis;
class QLineSeries;

/// A curve of a measurement, a few hundred points.
struct ChartCurve
{
    QString name;  ///< empty: not in the legend
    QList<QPointF> points;
    Axis axis = Axis::None;  ///< gives the colour
    int color = 0;  ///< of the series colours, for a curve without axis
    Qt::PenStyle style = Qt::SolidLine;
    double width = 1;
    double strength = 1;  ///< 0 unseen ... 1; faint curves are what was before
};

/// The scale of a chart's axis.
struct ChartScale
{
    QString title;
    double low = 0;
    double high = 1;
    bool logarithmic = false;
    QString labelFormat = QStringLiteral("%g");
    int steps = 0;  ///< parts between labels; 0 = round ones are found
};

/// A word at a point.
struct ChartLabel
{
    QPointF point;
    QString text;
};

/// Static curves over linear or logarithmic scales.
class CurveChart : public QChartView
{
    Q_OBJECT
public:
    CurveChart(const Theme &theme, const QString &name, QWidget *parent = nullptr);

    void setScales(const ChartScale &x, const ChartScale &y);
    void setCurves(const QList<ChartCurve> &curves);
    /// What to do, shown while there are no curves.
    void setHint(const QString &text);
    void setLabels(const QList<ChartLabel> &labels);
    [[nodiscard]] const QList<ChartCurve> &curves() const { return m_curves; }
    [[nodiscard]] const ChartScale &xScale() const { return m_x; }
    [[nodiscard]] const ChartScale &yScale() const { return m_y; }
    [[nodiscard]] const PlotLegend &legend() const { return m_legend; }
    /// Where the labels stand that lie within the scales, each beside no other; those of places without room
    /// are left out.
    [[nodiscard]] QList<QRectF> labelBoxes() const;

protected:
    void resizeEvent(QResizeEvent *event) override;
    void drawForeground(QPainter *painter, const QRectF &rect) override;

private:
    void applyTheme();
    void layOut();
    void attach();
    QAbstractAxis *makeAxis(const ChartScale &scale, Qt::Alignment side, QAbstractAxis *old);

    const Theme &m_theme;
    ChartScale m_x;
    ChartScale m_y;
    QAbstractAxis *m_xAxis = nullptr;
    QAbstractAxis *m_yAxis = nullptr;
    QList<ChartCurve> m_curves;
    QList<QLineSeries *> m_series;
    QList<ChartLabel> m_labels;
    QString m_hint;
    PlotLegend m_legend;
};
