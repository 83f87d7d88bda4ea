// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/stickbar.h"

#include "widgets/models/numbertext.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

StickBar::StickBar(const Theme &theme, bool fromStop, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_fromStop(fromStop)
    , m_value(qQNaN())
    , m_position(qQNaN())
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void StickBar::setValue(double value, double position)
{
    const auto isSame = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    if (isSame(value, m_value) && isSame(position, m_position))
        return;
    m_value = value;
    m_position = position;
    setAccessibleDescription(std::isnan(value) ? QString() : u"%1 %"_s.arg(numberText(100 * value, 0)));
    update();
}

void StickBar::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF track(1, height() / 2.0 - 5, width() - 2, 10);
    painter.setPen(m_theme.color(ColorRole::Border));
    painter.setBrush(m_theme.color(ColorRole::SurfaceRaised));
    painter.drawRoundedRect(track, 3, 3);
    const auto x = [&track](double value) {
        return track.left() + (std::clamp(value, -1.0, 1.0) + 1) / 2 * track.width();
    };
    const double start = m_fromStop ? x(-1) : x(0);
    if (!std::isnan(m_value)) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_theme.color(ColorRole::Accent));
        const double end = x(m_value);
        painter.drawRect(
            QRectF(std::min(start, end), track.top() + 1, std::abs(end - start), track.height() - 2));
    }
    painter.setPen(QPen(m_theme.color(ColorRole::Muted), 1));
    painter.drawLine(QPointF(start, track.top() - 4), QPointF(start, track.bottom() + 4));
    if (!std::isnan(m_position)) {
        painter.setPen(QPen(m_theme.color(ColorRole::Text), 2));
        painter.drawLine(QPointF(x(m_position), track.top() - 2), QPointF(x(m_position), track.bottom() + 2));
    }
}
