// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QList>
#include <QRectF>
#include <QString>

class QPainter;

/// The names of a plot's traces with their colours, in as many rows as they need. Every trace is in it,
/// however long the names are: where the rows allowed do not hold them, the longest names are shortened in
/// their middle.
class PlotLegend
{
public:
    struct Entry
    {
        QString name;
        QColor color;
        Qt::PenStyle style = Qt::SolidLine;
    };
    struct Placed
    {
        QRectF box;  ///< mark and name, in the coordinates of the view
        QString text;  ///< the name, shortened if need be
    };

    void setEntries(const QList<Entry> &entries) { m_entries = entries; }
    /// @param left,top,width room for the rows @param taken width at the right of the first row that is used
    /// by something else. Returns the height it takes; 0 without entries.
    double layOut(const QFont &font, double left, double top, double width, int maxRows, double taken = 0);
    void paint(QPainter &painter, const QColor &textColor) const;
    /// Which entry lies there, -1 = none.
    [[nodiscard]] int at(const QPointF &point) const;
    [[nodiscard]] const QList<Placed> &placed() const { return m_placed; }

private:
    [[nodiscard]] QList<Placed> place(double longest, double width, double taken, int &rows) const;

    QList<Entry> m_entries;
    QList<Placed> m_placed;
    QFont m_font;
    double m_left = 0;
    double m_top = 0;
};
