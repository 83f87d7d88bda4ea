// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/attitudeview.h"

#include "widgets/models/numbertext.h"
#include "widgets/views/stalecover.h"

#include <QPainter>
#include <QPainterPath>

#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr double kDegreesOverHeight = 70.0;  // pitch range that the view spans
constexpr double kHeadingSpan = 90.0;  // degrees of heading on the strip
constexpr double kEdge = 2;  // beside a number

}  // namespace

AttitudeView::AttitudeView(const Theme &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setAccessibleName(tr("Attitude of the camera"));
    setPlaceholder(tr("No attitude yet"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&m_theme, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void AttitudeView::setPlaceholder(const QString &text)
{
    if (std::exchange(m_placeholder, text) != text)
        update();
}

void AttitudeView::setAttitude(double roll, double pitch, double yaw)
{
    m_valid = !std::isnan(roll) && !std::isnan(pitch);
    m_roll = roll;
    m_pitch = pitch;
    m_hasHeading = !std::isnan(yaw);
    m_yaw = m_hasHeading ? yaw : 0.0;
    setAccessibleDescription(m_valid ? tr("Roll %1°, pitch %2°, yaw %3°")
                                           .arg(numberText(roll, 1))
                                           .arg(numberText(pitch, 1))
                                           .arg(numberText(m_yaw, 1))
                                     : tr("No data"));
    update();
}

void AttitudeView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    QPainterPath frame;
    frame.addRoundedRect(area, 6, 6);
    painter.setClipPath(frame);
    painter.fillRect(area, m_theme.color(ColorRole::Surface));
    const QColor text = m_theme.color(ColorRole::Text);
    const QPointF center = area.center();
    const double perDegree = area.height() / kDegreesOverHeight;

    if (m_valid) {
        painter.save();
        painter.translate(center);
        painter.rotate(-m_roll);
        const double horizon = m_pitch * perDegree;
        const double far = area.width() + area.height();
        painter.fillRect(QRectF(-far, horizon - 4 * far, 2 * far, 4 * far), m_theme.color(ColorRole::Sky));
        painter.fillRect(QRectF(-far, horizon, 2 * far, 4 * far), m_theme.color(ColorRole::Ground));
        painter.setPen(QPen(text, 1.5));
        painter.drawLine(QPointF(-far, horizon), QPointF(far, horizon));
        painter.setPen(QPen(text, 1));
        QFont small = font();
        small.setPointSizeF(std::max(7.0, small.pointSizeF() - 1));
        painter.setFont(small);
        for (int degrees = -90; degrees <= 90; degrees += 10) {
            const double y = horizon - degrees * perDegree;
            if (degrees == 0 || std::abs(y) > area.height())
                continue;
            const double half = degrees % 20 == 0 ? 28 : 14;
            painter.drawLine(QPointF(-half, y), QPointF(half, y));
            if (degrees % 20 == 0)
                painter.drawText(QRectF(half + 4, y - 9, 40, 18), Qt::AlignVCenter, QString::number(degrees));
        }
        painter.restore();
        // The camera, fixed in the middle.
        painter.setPen(QPen(m_theme.color(ColorRole::Accent), 3));
        painter.drawLine(center + QPointF(-60, 0), center + QPointF(-20, 0));
        painter.drawLine(center + QPointF(20, 0), center + QPointF(60, 0));
        painter.drawEllipse(center, 3, 3);
    } else if (!StaleCover::isOver(*this)) {
        painter.setPen(m_theme.color(ColorRole::Muted));
        painter.drawText(area, Qt::AlignCenter | Qt::TextWordWrap, m_placeholder);
    }

    if (m_valid || m_hasHeading)
        drawHeading(painter, area);
    painter.setClipping(false);
    painter.setPen(QPen(m_theme.color(ColorRole::Border), 1));
    painter.drawPath(frame);
}

// A strip at the top.
void AttitudeView::drawHeading(QPainter &painter, const QRectF &area) const
{
    const QPointF center = area.center();
    const QRectF strip(area.left(), area.top(), area.width(), 24);
    QColor veil = m_theme.color(ColorRole::Surface);
    veil.setAlpha(220);
    painter.fillRect(strip, veil);
    painter.setPen(QPen(m_theme.axisColor(Axis::Yaw), 1));
    const double headingScale = area.width() / kHeadingSpan;
    // Each mark with room for its number.
    const int step = 10 * headingScale < painter.fontMetrics().horizontalAdvance(u"-170° "_s) ? 20 : 10;
    const int first = int(std::floor((m_yaw - kHeadingSpan / 2) / step)) * step;
    for (int mark = first; mark <= m_yaw + kHeadingSpan / 2 + step; mark += step) {
        const double x = center.x() + (mark - m_yaw) * headingScale;
        painter.drawLine(QPointF(x, strip.bottom() - 4), QPointF(x, strip.bottom()));
        const QString number = u"%1°"_s.arg(mark);
        const double half = painter.fontMetrics().horizontalAdvance(number) / 2.0 + kEdge;
        if (x - half >= strip.left() && x + half <= strip.right())  // else a part of it would be read
            painter.drawText(QRectF(x - half, strip.top(), 2 * half, 19), Qt::AlignCenter, number);
    }
    painter.setPen(QPen(m_theme.axisColor(Axis::Yaw), 2));
    painter.drawLine(QPointF(center.x(), strip.bottom() - 2), QPointF(center.x(), strip.bottom() + 8));
}
