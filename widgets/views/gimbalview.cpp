// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/gimbalview.h"

#include "protocol/base/angles.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/stalecover.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace Qt::StringLiterals;

namespace {

// x to the right, y ahead, z up; in halves of the camera's width.
struct Point
{
    double x = 0;
    double y = 0;
    double z = 0;
};

/// A rotation, row by row.
using Turn = std::array<std::array<double, 3>, 3>;

constexpr double kAzimuth = 48;  // from where it is looked at: to the right of straight behind,
constexpr double kElevation = 24;  // and above
constexpr double kHalfSpan = 2.15;  // what the view shows around the camera with its frame,
constexpr double kHalfSpanAlone = 1.75;  // and without
constexpr double kGround = -1.35;  // the ground beneath,
constexpr double kReach = 1.6;  // and how far it reaches
constexpr double kVisibleDegrees = 0.05;
constexpr int kCorners = 16;  // of what is round

Point turned(const Turn &turn, const Point &p)
{
    const auto row = [&p](const std::array<double, 3> &r) { return r[0] * p.x + r[1] * p.y + r[2] * p.z; };
    return {row(turn[0]), row(turn[1]), row(turn[2])};
}

Turn product(const Turn &a, const Turn &b)
{
    Turn all{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j)
            all[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    }
    return all;
}

Turn reversed(const Turn &turn)
{
    Turn back{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j)
            back[i][j] = turn[j][i];
    }
    return back;
}

Turn rolled(double degrees)
{
    const double c = std::cos(radians(degrees));
    const double s = std::sin(radians(degrees));
    return {{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}};
}

Turn pitched(double degrees)
{
    const double c = std::cos(radians(degrees));
    const double s = std::sin(radians(degrees));
    return {{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
}

Turn yawed(double degrees)
{
    const double c = std::cos(radians(degrees));
    const double s = std::sin(radians(degrees));
    return {{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}};
}

double orZero(double degrees)
{
    return std::isnan(degrees) ? 0.0 : degrees;
}

Turn attitude(const GimbalView::Angles &angles)
{
    return product(yawed(orZero(angles[2])), product(pitched(orZero(angles[1])), rolled(orZero(angles[0]))));
}

/// A face of a body, ready to be painted.
struct Face
{
    QPolygonF outline;
    QColor colour;
    double depth = 0;
    bool isRound = false;  // its edges are none
};

/// Collects the faces of convex bodies that are seen.
class Scene
{
public:
    Scene(double scale, QPointF centre)
        : m_scale(scale)
        , m_centre(centre)
    {
    }

    [[nodiscard]] QPointF at(const Point &p) const
    {
        const Point seen = turned(eye(), p);
        return m_centre
            + QPointF(seen.x, -(seen.z * cosine(kElevation) + seen.y * sine(kElevation))) * m_scale;
    }

    void addFace(const std::vector<Point> &corners, const QColor &colour, bool isRound = false)
    {
        QPolygonF outline;
        double depth = 0;
        for (const Point &corner : corners) {
            const Point seen = turned(eye(), corner);
            depth += seen.y * cosine(kElevation) - seen.z * sine(kElevation);
            outline.append(at(corner));
        }
        const double area = areaOf(outline);
        if (area >= 0)
            return;  // seen from behind
        m_faces.push_back({outline, lit(corners, colour), depth / double(corners.size()), isRound});
    }

    void addBox(const Turn &turn, const Point &centre, const Point &half, const QColor &colour)
    {
        const auto corner = [&](double x, double y, double z) {
            return turned(turn, {centre.x + x * half.x, centre.y + y * half.y, centre.z + z * half.z});
        };
        for (const double side : {-1.0, 1.0}) {
            addFace(
                wound({corner(-1, -1, side), corner(1, -1, side), corner(1, 1, side), corner(-1, 1, side)},
                      side),
                colour);
            addFace(
                wound({corner(-1, side, 1), corner(1, side, 1), corner(1, side, -1), corner(-1, side, -1)},
                      side),
                colour);
            addFace(
                wound({corner(side, -1, -1), corner(side, 1, -1), corner(side, 1, 1), corner(side, -1, 1)},
                      side),
                colour);
        }
    }

    /// @param along 0, 1, 2: its axis is x, y, z
    void addDrum(const Turn &turn, const Point &centre, int along, double half, double radius,
                 const QColor &colour)
    {
        const auto corner = [&](int i, double side) {
            const double angle = 2 * std::numbers::pi * i / kCorners;
            const double a = radius * std::cos(angle);
            const double b = radius * std::sin(angle);
            const double c = half * side;
            const Point p = along == 0 ? Point{c, a, b} : along == 1 ? Point{b, c, a} : Point{a, b, c};
            return turned(turn, {centre.x + p.x, centre.y + p.y, centre.z + p.z});
        };
        for (const double side : {-1.0, 1.0}) {
            std::vector<Point> lid;
            for (int i = 0; i < kCorners; ++i)
                lid.push_back(corner(i, side));
            addFace(wound(lid, side), colour);
        }
        for (int i = 0; i < kCorners; ++i)
            addFace({corner(i, -1), corner(i + 1, -1), corner(i + 1, 1), corner(i, 1)}, colour, true);
    }

    /// The farthest first.
    void paint(QPainter &painter, const QColor &edge)
    {
        std::sort(m_faces.begin(), m_faces.end(),
                  [](const Face &a, const Face &b) { return a.depth > b.depth; });
        for (const Face &face : m_faces) {
            painter.setPen(QPen(face.isRound ? face.colour : edge, 0.7));
            painter.setBrush(face.colour);
            painter.drawPolygon(face.outline);
        }
    }

private:
    static double cosine(double degrees) { return std::cos(radians(degrees)); }
    static double sine(double degrees) { return std::sin(radians(degrees)); }
    static const Turn &eye()
    {
        static const Turn turn = yawed(-kAzimuth);
        return turn;
    }
    static double areaOf(const QPolygonF &outline)
    {
        double twice = 0;
        for (qsizetype i = 0; i < outline.size(); ++i) {
            const QPointF &a = outline[i];
            const QPointF &b = outline[(i + 1) % outline.size()];
            twice += a.x() * b.y() - b.x() * a.y();
        }
        return twice / 2;
    }
    static std::vector<Point> wound(std::vector<Point> corners, double side)
    {
        if (side < 0)
            std::reverse(corners.begin(), corners.end());
        return corners;
    }
    /// Light falls from above, a little from the left.
    static QColor lit(const std::vector<Point> &corners, const QColor &colour)
    {
        const Point &a = corners[0];
        const Point &b = corners[1];
        const Point &c = corners[2];
        const Point u{b.x - a.x, b.y - a.y, b.z - a.z};
        const Point v{c.x - b.x, c.y - b.y, c.z - b.z};
        const Point normal{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
        const double length = std::hypot(normal.x, normal.y, normal.z);
        const double light
            = length > 0 ? (-0.35 * normal.x - 0.25 * normal.y + 0.9 * normal.z) / length : 0.0;
        return light >= 0 ? colour.lighter(100 + int(14 * light)) : colour.darker(100 + int(-45 * light));
    }

    double m_scale;
    QPointF m_centre;
    std::vector<Face> m_faces;
};

QColor mixed(const QColor &a, const QColor &b, double share)
{
    const auto part = [share](float x, float y) { return float(x + (y - x) * share); };
    return QColor::fromRgbF(part(a.redF(), b.redF()), part(a.greenF(), b.greenF()),
                            part(a.blueF(), b.blueF()));
}

/// Turns of the three joints, in degrees, from the frame inwards: yaw, roll, pitch.
struct Joints
{
    double yaw = 0;
    double roll = 0;
    double pitch = 0;
};

Joints jointsBetween(const Turn &frame, const Turn &camera)
{
    const Turn between = product(reversed(frame), camera);
    return {-degrees(std::atan2(between[1][0], between[0][0])),
            degrees(std::asin(std::clamp(-between[2][0], -1.0, 1.0))),
            degrees(std::atan2(between[2][1], between[2][2]))};
}

}  // namespace

GimbalView::GimbalView(const Theme &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setAccessibleName(tr("The gimbal as a body"));
    setAccessibleDescription(sentence());
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&m_theme, &Theme::changed, this, qOverload<>(&QWidget::update));
}

bool GimbalView::isKnown() const
{
    return std::any_of(m_pose.camera.begin(), m_pose.camera.end(),
                       [](double angle) { return !std::isnan(angle); });
}

void GimbalView::setPose(const Pose &pose)
{
    const auto differs = [](const Angles &a, const Angles &b) {
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (std::isnan(a[i]) != std::isnan(b[i]) || std::abs(a[i] - b[i]) > kVisibleDegrees)
                return true;
        }
        return false;
    };
    const bool isSame = pose.running == m_pose.running && pose.frame.has_value() == m_pose.frame.has_value()
        && !differs(pose.camera, m_pose.camera) && (!pose.frame || !differs(*pose.frame, *m_pose.frame));
    if (isSame)
        return;
    m_pose = pose;
    setAccessibleDescription(sentence());
    update();
}

QString GimbalView::sentence() const
{
    if (!isKnown())
        return tr("No data");
    const auto said = [](const Angles &angles) {
        QStringList parts;
        for (const Axis axis : kAxes) {
            const double angle = angles[std::size_t(axis)];
            if (!std::isnan(angle))
                parts.append(u"%1 %2°"_s.arg(axisLabel(axis), numberText(angle, 1)));
        }
        return parts.join(u", "_s);
    };
    return m_pose.frame
        ? tr("The camera has %1; the frame has %2.").arg(said(m_pose.camera), said(*m_pose.frame))
        : tr("The camera has %1; nobody measures the frame.").arg(said(m_pose.camera));
}

void GimbalView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor muted = m_theme.color(ColorRole::Muted);
    if (!isKnown()) {
        painter.setPen(muted);
        if (!StaleCover::isOver(*this))
            painter.drawText(rect(), Qt::AlignCenter, tr("No attitude yet"));
        return;
    }
    const double scale = std::min(width(), height()) / (2 * (m_pose.frame ? kHalfSpan : kHalfSpanAlone));
    Scene scene(scale, QPointF(width() / 2.0, height() / 2.0 + (m_pose.frame ? 0.1 : -0.25) * scale));

    // The ground, with the direction that yaw counts from.
    painter.setPen(QPen(m_theme.color(ColorRole::Border), 1.2));
    painter.setBrush(m_theme.color(ColorRole::Background));
    QPolygonF ground;
    for (int i = 0; i < 48; ++i) {
        const double angle = 2 * std::numbers::pi * i / 48;
        ground.append(scene.at({kReach * std::cos(angle), kReach * std::sin(angle), kGround}));
    }
    painter.drawPolygon(ground);
    const bool hasYaw = !std::isnan(m_pose.camera[2]);
    if (hasYaw) {
        painter.setPen(QPen(m_theme.axisColor(Axis::Yaw), 1.5));
        painter.drawLine(scene.at({0, kReach - 0.3, kGround}), scene.at({0, kReach, kGround}));
        painter.drawText(QRectF(scene.at({0, kReach + 0.3, kGround}) - QPointF(20, 9), QSizeF(40, 18)),
                         Qt::AlignCenter, u"0°"_s);
        const Turn heading = yawed(m_pose.camera[2]);
        painter.setPen(QPen(m_theme.axisColor(Axis::Yaw), 2, Qt::DotLine));
        painter.drawLine(scene.at({0, 0, kGround}), scene.at(turned(heading, {0, kReach - 0.35, kGround})));
    }

    const QColor metal = mixed(m_theme.color(ColorRole::SurfaceRaised), muted, 0.25);
    const QColor body = mixed(m_theme.color(ColorRole::SurfaceRaised), muted, 0.75);
    const auto motorColour = [this, &metal](Axis axis) {
        return mixed(metal, m_theme.axisColor(axis), m_pose.running.value_or(false) ? 1.0 : 0.4);
    };
    const Turn camera = attitude(m_pose.camera);
    if (m_pose.frame) {
        Angles angles = *m_pose.frame;
        // Without its own heading the frame's is where the camera's counts from.
        angles[2] = orZero(angles[2]);
        const Turn frame = attitude(angles);
        const Joints joints = jointsBetween(frame, camera);
        const Turn outer = product(frame, yawed(joints.yaw));
        const Turn inner = product(outer, rolled(joints.roll));
        scene.addBox(frame, {0, 0, 1.82}, {0.95, 0.6, 0.07}, metal);
        scene.addBox(frame, {0, 0.72, 1.82}, {0.16, 0.12, 0.07}, muted);  // its front
        scene.addDrum(frame, {0, 0, 1.6}, 2, 0.14, 0.3, motorColour(Axis::Yaw));
        scene.addBox(outer, {0, -0.68, 1.38}, {0.13, 0.8, 0.07}, metal);
        scene.addBox(outer, {0, -1.41, 0.62}, {0.13, 0.07, 0.69}, metal);
        scene.addDrum(outer, {0, -1.22, 0}, 1, 0.12, 0.28, motorColour(Axis::Roll));
        scene.addBox(inner, {0.58, -1.03, 0}, {0.7, 0.07, 0.13}, metal);
        scene.addBox(inner, {1.21, -0.48, 0}, {0.07, 0.5, 0.13}, metal);
        scene.addDrum(inner, {1.02, 0, 0}, 0, 0.12, 0.28, motorColour(Axis::Pitch));
    }
    scene.addBox(camera, {0, -0.05, 0}, {0.72, 0.42, 0.46}, body);
    scene.addDrum(camera, {0, 0.6, 0}, 1, 0.24, 0.3, muted);
    scene.addBox(camera, {0, -0.05, 0.54}, {0.24, 0.24, 0.08}, body);
    scene.paint(painter, m_theme.color(ColorRole::Surface));

    // Its axes, those that are measured: ahead, to the right, up.
    constexpr std::array<Point, 3> kFrom{{{0, 0.84, 0}, {0.72, 0, 0}, {0, 0, 0.62}}};
    constexpr std::array<Point, 3> kTo{{{0, 1.5, 0}, {1.45, 0, 0}, {0, 0, 1.25}}};
    for (const Axis axis : kAxes) {
        const auto i = std::size_t(axis);
        if (std::isnan(m_pose.camera[i]))
            continue;
        painter.setPen(QPen(m_theme.axisColor(axis), 2.5, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(scene.at(turned(camera, kFrom[i])), scene.at(turned(camera, kTo[i])));
    }
    if (m_pose.frame)
        return;
    painter.setPen(muted);
    const QString told = tr("The frame is not measured");
    painter.drawText(QRectF(0, 0, width(), fontMetrics().height()), Qt::AlignCenter,
                     fontMetrics().elidedText(told, Qt::ElideRight, width()));
}
