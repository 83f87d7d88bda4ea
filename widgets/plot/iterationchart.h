// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plot/plotlegend.h"
#include "widgets/theme/theme.h"

#include <QChartView>

class QLineSeries;
class QValueAxis;

/// A few curves over the steps of a procedure: one point per step, scaled to what is there.
class IterationChart final : public QChartView
{
    Q_OBJECT
public:
    IterationChart(const Theme &theme, const QString &title, QWidget *parent = nullptr);

    void clear();
    /// Adds a point to a curve; an unknown name makes a new curve. Steps that were there already are
    /// replaced.
    void addPoint(const QString &name, Axis axis, int step, double value, Qt::PenStyle style = Qt::SolidLine);
    [[nodiscard]] const PlotLegend &legend() const { return m_legend; }

protected:
    void resizeEvent(QResizeEvent *event) override;
    void drawForeground(QPainter *painter, const QRectF &rect) override;

private:
    void applyTheme();
    void showRange();
    void layOut();

    struct Line
    {
        QLineSeries *series;
        Axis axis;
        Qt::PenStyle style;
    };
    const Theme &m_theme;
    QString m_title;
    QValueAxis *m_steps;
    QValueAxis *m_values;
    QMap<QString, Line> m_lines;
    PlotLegend m_legend;
    double m_high = 0;
    int m_lastStep = 1;
};
