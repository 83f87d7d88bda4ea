// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/sparkline.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

Sparkline::Sparkline(const Theme &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setAccessibleName(tr("Course of the chosen variable"));
}

void Sparkline::setValues(const QString &name, const std::deque<double> &values)
{
    m_name = name;
    m_values = values;
    update();
}

void Sparkline::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetrics metrics(font());
    painter.setPen(m_theme.color(ColorRole::Muted));
    if (m_values.size() < 2) {
        painter.drawText(rect(), Qt::AlignCenter, tr("Choose a variable to see its course"));
        return;
    }
    painter.setPen(m_theme.color(ColorRole::Text));
    painter.drawText(QRect(0, 0, width(), metrics.height()), Qt::AlignLeft, m_name);
    double low = *std::min_element(m_values.begin(), m_values.end());
    double high = *std::max_element(m_values.begin(), m_values.end());
    if (!(high > low)) {
        low -= 1;
        high += 1;
    }
    const QString highText = QString::number(high, 'g', 5);
    const QString lowText = QString::number(low, 'g', 5);
    const int margin = std::max(metrics.horizontalAdvance(highText), metrics.horizontalAdvance(lowText)) + 8;
    const QRectF area(margin, metrics.height() + 6, width() - margin - 2, height() - metrics.height() - 10);
    painter.setPen(m_theme.color(ColorRole::Muted));
    painter.drawText(QRectF(0, area.top(), margin - 6, metrics.height()), Qt::AlignRight, highText);
    painter.drawText(QRectF(0, area.bottom() - metrics.height(), margin - 6, metrics.height()), Qt::AlignRight, lowText);
    painter.setPen(m_theme.color(ColorRole::Border));
    painter.drawLine(area.topLeft(), area.bottomLeft());
    QPainterPath path;
    for (std::size_t i = 0; i < m_values.size(); ++i) {
        const QPointF point(area.left() + area.width() * double(i) / double(m_values.size() - 1),
                            area.bottom() - area.height() * (m_values[i] - low) / (high - low));
        if (i == 0)
            path.moveTo(point);
        else
            path.lineTo(point);
    }
    painter.setPen(QPen(m_theme.color(ColorRole::Accent), 1.5));
    painter.drawPath(path);
}
