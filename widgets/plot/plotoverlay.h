// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plot/plotmarks.h"
#include "widgets/theme/theme.h"

#include <QPainter>

/// What is drawn over the traces of a plot: marks, the two lines of the cursor and the box with its values.
class PlotOverlay
{
public:
    struct Line
    {
        QString text;
        QColor color;  ///< of the little square; invalid = none
    };

    PlotOverlay(QPainter &painter, const QRectF &area, const Theme &theme);

    void mark(double x, PlotMark::Kind kind);
    void reference(double x);
    void cursor(double x);
    /// Lines of text beside the cursor, as many as there is room for.
    void box(double x, const QList<Line> &lines);
    /// A few words in the lower right corner.
    void corner(const QString &text);
    void selection(const QRectF &box);

private:
    void vertical(double x, const QPen &pen);
    void panel(const QRectF &box);

    QPainter &m_painter;
    QRectF m_area;
    const Theme &m_theme;
};
