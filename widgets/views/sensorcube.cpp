// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/sensorcube.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

using Vector = std::array<double, 3>;

// Where the sensor's X, Y, Z point in the room (x right, y away, z up) for each face that can lie up.
// clang-format off
constexpr std::array<std::array<Vector, 3>, 6> kFrames{{
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},    // +Z up
    {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}},  // -Z up
    {{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}},   // +X up
    {{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}},   // -X up
    {{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}},   // +Y up
    {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}},   // -Y up
}};
// clang-format on

constexpr double kLetter = 24;  // height and width

// A plain oblique view: x to the right, y into the picture, z up.
QPointF project(const Vector &point, double scale, QPointF centre)
{
    return centre + QPointF(point[0] + 0.42 * point[1], -point[2] - 0.30 * point[1]) * scale;
}

}  // namespace

SensorCube::SensorCube(const Theme &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setAccessibleName(tr("Position of the sensor"));
    connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void SensorCube::setPosition(int up)
{
    if (up == m_up)
        return;
    m_up = up;
    update();
}

void SensorCube::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double scale = std::min(width() / 5.2, (height() - kLetter) / 4.2);
    const QPointF centre(width() / 2.0 - 0.1 * scale, height() / 2.0);
    const auto at = [&](double x, double y, double z) { return project({x, y, z}, scale, centre); };
    // The table it lies on, then the three faces that are seen.
    painter.setPen(QPen(m_theme.color(ColorRole::Border), 1.5));
    painter.setBrush(m_theme.color(ColorRole::Background));
    painter.drawPolygon(
        QPolygonF({at(-2.0, -1.6, -1.0), at(1.8, -1.6, -1.0), at(2.0, 1.8, -1.0), at(-1.8, 1.8, -1.0)}));
    if (m_up < 0) {
        painter.setPen(m_theme.color(ColorRole::Muted));
        painter.drawText(rect(), Qt::AlignCenter, tr("tilted"));
        return;
    }
    const QColor surface = m_theme.color(ColorRole::SurfaceRaised);
    painter.setPen(QPen(m_theme.color(ColorRole::Muted), 1.5));
    painter.setBrush(surface);
    painter.drawPolygon(QPolygonF({at(-1, -1, 1), at(1, -1, 1), at(1, 1, 1), at(-1, 1, 1)}));
    painter.setBrush(surface.darker(106));
    painter.drawPolygon(QPolygonF({at(-1, -1, -1), at(1, -1, -1), at(1, -1, 1), at(-1, -1, 1)}));
    painter.setBrush(surface.darker(114));
    painter.drawPolygon(QPolygonF({at(1, -1, -1), at(1, 1, -1), at(1, 1, 1), at(1, -1, 1)}));
    constexpr std::array<ColorRole, 3> roles{ColorRole::AxisRoll, ColorRole::AxisPitch, ColorRole::AxisYaw};
    constexpr std::array<char, 3> names{'X', 'Y', 'Z'};
    QFont font = painter.font();
    font.setBold(true);
    painter.setFont(font);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Vector &direction = kFrames[std::size_t(m_up)][axis];
        const bool hidden = direction[1] > 0.5 || direction[2] < -0.5 || direction[0] < -0.5;
        const QPointF from = at(direction[0], direction[1], direction[2]);
        const QPointF to = at(direction[0] * 1.75, direction[1] * 1.9, direction[2] * 1.75);
        painter.setPen(
            QPen(m_theme.color(roles[axis]), 3, hidden ? Qt::DotLine : Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(from, to);
        painter.setPen(m_theme.color(roles[axis]));
        const QPointF label = at(direction[0] * 2.05, direction[1] * 2.4, direction[2] * 2.05);
        painter.drawText(QRectF(label.x() - kLetter / 2, label.y() - kLetter / 2, kLetter, kLetter),
                         Qt::AlignCenter, QString(QLatin1Char(names[axis])));
    }
}
