// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/fieldsphereview.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace Qt::StringLiterals;

namespace {

constexpr double kOvershoot = 1.12;  // of the radius: points that lie outside
constexpr double kLargestRing = 5;
constexpr double kRing = 0.06;  // of the radius
constexpr double kPoint = 1.3;
constexpr double kCross = 9;
constexpr double kOnTheEdge = 0.01;
constexpr double kAlongAxis = 0.1;  // less is no part of a direction's name

void drawRing(QPainter &painter, const Theme &theme, QPointF at, bool isSeen, double size = kLargestRing)
{
    painter.setPen(QPen(theme.color(isSeen ? ColorRole::Ok : ColorRole::Warning), 2));
    painter.setBrush(isSeen ? QBrush(theme.color(ColorRole::Ok)) : QBrush(Qt::NoBrush));
    painter.drawEllipse(at, size, size);
}

void drawCross(QPainter &painter, const Theme &theme, QPointF at)
{
    painter.setPen(QPen(theme.color(ColorRole::Text), 2));
    painter.drawLine(at - QPointF(kCross, 0), at + QPointF(kCross, 0));
    painter.drawLine(at - QPointF(0, kCross), at + QPointF(0, kCross));
}

}  // namespace

/// One half of the sphere, seen from outside.
struct FieldSphereView::Half
{
    int side;  // 1: towards +Z, -1: towards -Z
    QPointF centre;
    double radius;
    [[nodiscard]] QPointF at(const Vector3 &point) const
    {
        return centre + QPointF(point.x * side, -point.y) * radius;
    }
};

FieldSphereView::FieldSphereView(const Theme &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setAccessibleName(tr("Sphere of the magnetic field"));
    setPoints({}, {}, {});
    connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void FieldSphereView::setPoints(const std::vector<Vector3> &points, const std::optional<FieldSphere> &sphere,
                                const SeenDirections &seen)
{
    m_points.clear();
    for (const Vector3 &point : points) {
        if (sphere)
            m_points.push_back((point - sphere->centre) / sphere->radius);
    }
    m_seen = seen;
    setAccessibleDescription(
        tr("%1 of %2 directions are seen.").arg(int(seen.count())).arg(int(kFieldDirections)));
    update();
}

QSize FieldSphereView::sizeHint() const
{
    return {30 * fontMetrics().height(), 18 * fontMetrics().height()};
}

QSize FieldSphereView::minimumSizeHint() const
{
    return {18 * fontMetrics().height(), 11 * fontMetrics().height()};
}

void FieldSphereView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double line = fontMetrics().height();
    const double legend = 1.5 * line;
    const double room = std::min(width() / 4.0 - 1.7 * line, (height() - legend) / 2 - line);
    const double radius = room / kOvershoot;
    const double middle = (height() - legend) / 2;
    for (const int side : {1, -1})
        drawHalf(painter, {side, {width() * (side > 0 ? 0.25 : 0.75), middle}, radius});
    drawLegend(painter);
}

void FieldSphereView::drawHalf(QPainter &painter, const Half &half) const
{
    const double line = fontMetrics().height();
    painter.setPen(QPen(m_theme.color(ColorRole::Border), 1.5));
    painter.setBrush(m_theme.color(ColorRole::Background));
    painter.drawEllipse(half.centre, half.radius, half.radius);
    const auto letter = [&](const Vector3 &way, const QString &text, ColorRole role) {
        const QPointF at
            = half.centre + QPointF(way.x * half.side, -way.y) * (half.radius * kOvershoot + line * 0.55);
        painter.setPen(m_theme.color(role));
        painter.drawText(QRectF(at.x() - line, at.y() - line / 2, 2 * line, line), Qt::AlignCenter, text);
    };
    letter({1, 0, 0}, u"+X"_s, ColorRole::AxisRoll);
    letter({-1, 0, 0}, u"−X"_s, ColorRole::AxisRoll);
    letter({0, 1, 0}, u"+Y"_s, ColorRole::AxisPitch);
    letter({0, -1, 0}, u"−Y"_s, ColorRole::AxisPitch);
    painter.setPen(Qt::NoPen);
    QColor ink = m_theme.color(ColorRole::Accent);
    ink.setAlphaF(0.7F);
    painter.setBrush(ink);
    for (const Vector3 &point : m_points) {
        if (point.z * half.side >= 0)
            painter.drawEllipse(half.at(point), kPoint, kPoint);
    }
    for (std::size_t i = 0; i < kFieldDirections && !m_points.empty(); ++i) {
        const Vector3 &way = fieldDirections()[i];
        if (way.z * half.side > -kOnTheEdge)
            drawRing(painter, m_theme, half.at(way), m_seen[i], std::min(kLargestRing, kRing * half.radius));
    }
    painter.setPen(m_theme.color(ColorRole::AxisYaw));
    const QPointF corner
        = half.centre - QPointF(half.radius * kOvershoot + line, half.radius * kOvershoot + line);
    painter.drawText(QRectF(corner, QSizeF(4 * line, line)), Qt::AlignLeft | Qt::AlignVCenter,
                     half.side > 0 ? u"+Z"_s : u"−Z"_s);
    if (m_points.empty()) {
        painter.setPen(m_theme.color(ColorRole::Muted));
        painter.drawText(
            QRectF(half.centre.x() - half.radius, half.centre.y() - 2 * line, 2 * half.radius, 4 * line),
            Qt::AlignCenter | Qt::TextWordWrap, tr("no sphere yet"));
    } else if (m_points.back().z * half.side >= 0) {
        drawCross(painter, m_theme, half.at(m_points.back()));
    }
}

// In one line beneath both.
void FieldSphereView::drawLegend(QPainter &painter) const
{
    const std::array texts{tr("missing"), tr("seen"), tr("now")};
    const int line = fontMetrics().height();
    const auto wide = [&](const QString &text) { return fontMetrics().horizontalAdvance(text) + 3 * line; };
    const int all = std::accumulate(texts.begin(), texts.end(), 0,
                                    [&](int sum, const QString &text) { return sum + wide(text); });
    double x = (width() - all) / 2.0 + line / 2.0;
    const double y = height() - 0.75 * line;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const QPointF at(x, y);
        if (i < 2)
            drawRing(painter, m_theme, at, i == 1);
        else
            drawCross(painter, m_theme, at);
        painter.setPen(m_theme.color(ColorRole::Text));
        painter.drawText(QRectF(x + line, y - line / 2.0, wide(texts[i]), line),
                         Qt::AlignLeft | Qt::AlignVCenter, texts[i]);
        x += wide(texts[i]);
    }
}

QString directionName(const Vector3 &direction)
{
    QStringList parts;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (std::abs(direction[axis]) > kAlongAxis)
            parts.append((direction[axis] > 0 ? u"+"_s : u"−"_s) + u"XYZ"[axis]);
    }
    return parts.join(u' ');
}
