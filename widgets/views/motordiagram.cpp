// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/motordiagram.h"

#include "widgets/models/numbertext.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr int kLeastSide = 170;  // px: below it four rings touch
constexpr double kTold = 0.05;  // %, less is not shown
constexpr double kMost = 100;  // %
constexpr double kClose = 0.25;  // places that would cover each other
constexpr double kFullCircle = 360 * 16;
constexpr double kTop = 90 * 16;
constexpr double kMarkLine = 2;  // pixels
constexpr double kAskedLine = 4;
constexpr double kTurnAngle = 70;  // degrees of an arrow that shows a direction

// Where the shares put a motor; two at the same place (one above the other) are moved apart.
std::vector<QPointF> placesOf(const std::vector<MotorShare> &shares)
{
    double most = 0;
    for (const MotorShare &share : shares)
        most = std::max({most, std::abs(share.roll), std::abs(share.pitch)});
    if (most <= 0)
        return {};
    std::vector<QPointF> places;
    for (const MotorShare &share : shares) {
        QPointF place(share.roll / most, -share.pitch / most);
        for (const QPointF &other : places) {
            if (std::hypot(place.x() - other.x(), place.y() - other.y()) < kClose)
                place *= 0.45;
        }
        places.push_back(place);
    }
    return places;
}

}  // namespace

MotorDiagram::MotorDiagram(const Theme &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setAccessibleName(tr("Motors"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMinimumSize(kLeastSide, kLeastSide);
    connect(&m_theme, &Theme::changed, this, qOverload<>(&QWidget::update));
    tell();
}

void MotorDiagram::setMotors(int count, const std::vector<MotorShare> &shares)
{
    const bool fits = count > 0 && int(shares.size()) == count;
    const std::vector<QPointF> places = fits ? placesOf(shares) : std::vector<QPointF>();
    const std::vector<MotorShare> known = places.empty() ? std::vector<MotorShare>() : shares;
    if (count == this->count() && known == m_shares)
        return;
    m_shares = known;
    m_places = places;
    m_outputs.assign(std::size_t(std::max(0, count)), qQNaN());
    m_tested = std::min(m_tested, count);
    if (m_selected > count)
        choose(0);
    explain();
    tell();
}

void MotorDiagram::setSidesKnown(bool known)
{
    if (std::exchange(m_areSidesKnown, known) == known)
        return;
    explain();
    update();
}

void MotorDiagram::setOutputs(const std::vector<double> &outputs)
{
    std::vector<double> shown(m_outputs.size(), qQNaN());
    for (std::size_t i = 0; i < std::min(shown.size(), outputs.size()); ++i)
        shown[i] = std::isnan(outputs[i]) ? outputs[i] : std::round(outputs[i] * 10) / 10;
    const bool isSame
        = std::equal(shown.begin(), shown.end(), m_outputs.begin(), m_outputs.end(), [](double a, double b) {
              return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) < kTold;
          });
    if (isSame)
        return;
    m_outputs = std::move(shown);
    tell();
}

void MotorDiagram::setTested(int motor)
{
    if (std::exchange(m_tested, std::clamp(motor, 0, count())) != m_tested)
        tell();
}

void MotorDiagram::setAsked(const QList<int> &motors)
{
    if (std::exchange(m_asked, motors) != m_asked)
        tell();
}

void MotorDiagram::setSelectable(bool selectable)
{
    m_selectable = selectable;
    setFocusPolicy(selectable ? Qt::StrongFocus : Qt::NoFocus);
    setCursor(selectable ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update();
}

void MotorDiagram::setSelected(int motor)
{
    choose(std::clamp(motor, 0, count()));
}

void MotorDiagram::choose(int motor)
{
    if (std::exchange(m_selected, motor) == motor)
        return;
    tell();
    emit selectedChanged(motor);
}

QString MotorDiagram::outputText(int motor) const
{
    const double percent = output(motor);
    if (std::isnan(percent))
        return u"–"_s;
    // More than a motor can is what the drone would like (errata 6.3).
    return std::abs(percent) < kTold ? tr("stands")
        : percent > kMost            ? tr("> %1 %").arg(numberText(kMost, 0))
                                     : tr("%1 %").arg(numberText(percent, 0));
}

void MotorDiagram::explain()
{
    setToolTip(
        m_areSidesKnown && hasPlaces() ? tr("Seen from above, as the check of directions has found it.")
            : hasPlaces() ? tr("Places and directions follow from the signs of the mixing in the "
                               "configuration text. The protocol does not tell which side is the front, "
                               "and which of the two directions is clockwise: compare with the drone.")
                          : QString());
}

void MotorDiagram::tell()
{
    QStringList parts;
    for (int motor = 1; motor <= count(); ++motor) {
        QString part = tr("motor %1: %2").arg(motor).arg(outputText(motor));
        if (motor == m_tested)
            part += u", "_s + tr("being tested");
        if (motor == m_selected)
            part += u", "_s + tr("chosen");
        if (m_asked.contains(motor))
            part += u", "_s + tr("asked about");
        parts.append(part);
    }
    setAccessibleDescription(parts.isEmpty() ? tr("No data") : parts.join(u"; "_s));
    update();
}

QRectF MotorDiagram::area() const
{
    const double line = fontMetrics().height();
    return QRectF(rect()).adjusted(line, line + 4, -line, -line - 4);
}

// Of a motor's ring, so that neighbours have room for their numbers.
double MotorDiagram::radius() const
{
    const QRectF room = area();
    const double side = std::min(room.width(), room.height());
    return std::clamp(side * (count() > 4 ? 0.12 : 0.17), 18.0, 54.0);
}

QPointF MotorDiagram::placeOf(int motor) const
{
    if (!hasPlaces())
        return barOf(motor).center();
    const QRectF room = area();
    // However small it is, front is never behind.
    const double reach = std::max(radius(), std::min(room.width(), room.height()) / 2 - radius() - 12);
    return room.center() + m_places[std::size_t(motor - 1)] * reach;
}

QRectF MotorDiagram::barOf(int motor) const
{
    const double line = fontMetrics().height();
    const double width = double(this->width()) / std::max(1, count());
    const double bar = std::min(36.0, width * 0.6);
    return {(motor - 0.5) * width - bar / 2, line + 4, bar, height() - 2 * line - 12};
}

QColor MotorDiagram::colourOf(int motor) const
{
    return m_theme.color(motor == m_tested || output(motor) > 100 ? ColorRole::Warning : ColorRole::Accent);
}

QColor MotorDiagram::markOf(int motor) const
{
    if (motor == m_tested)
        return m_theme.color(ColorRole::Warning);
    return motor == m_selected || m_asked.contains(motor) ? m_theme.color(ColorRole::Accent) : QColor();
}

int MotorDiagram::motorAt(QPointF point) const
{
    for (int motor = 1; motor <= count(); ++motor) {
        const QPointF away = point - placeOf(motor);
        const bool isNear = hasPlaces() ? std::hypot(away.x(), away.y()) <= radius() + 10
                                        : std::abs(away.x()) <= double(width()) / count() / 2;
        if (isNear)
            return motor;
    }
    return 0;
}

void MotorDiagram::mousePressEvent(QMouseEvent *event)
{
    const int motor = m_selectable ? motorAt(event->position()) : 0;
    if (motor == 0) {
        QWidget::mousePressEvent(event);
        return;
    }
    choose(motor);
}

void MotorDiagram::keyPressEvent(QKeyEvent *event)
{
    const bool forward = event->key() == Qt::Key_Right || event->key() == Qt::Key_Down;
    const bool back = event->key() == Qt::Key_Left || event->key() == Qt::Key_Up;
    if (!m_selectable || count() == 0 || (!forward && !back)) {
        QWidget::keyPressEvent(event);
        return;
    }
    const int from = m_selected > 0 ? m_selected : (forward ? 0 : 1);
    choose((from - 1 + (forward ? 1 : count() - 1) + count()) % count() + 1);
}

// The two axes with the signs as the board has them, and arms from the middle.
void MotorDiagram::drawFrame(QPainter &painter) const
{
    const QRectF room = area();
    const QPointF middle = room.center();
    const double half = std::min(room.width(), room.height()) / 2;
    painter.setPen(QPen(m_theme.color(ColorRole::Border), 1, Qt::DashLine));
    painter.drawLine(middle - QPointF(half, 0), middle + QPointF(half, 0));
    painter.drawLine(middle - QPointF(0, half), middle + QPointF(0, half));
    painter.setPen(QPen(m_theme.color(ColorRole::Border), 5, Qt::SolidLine, Qt::RoundCap));
    for (int motor = 1; motor <= count(); ++motor)
        painter.drawLine(middle, placeOf(motor));
    const int line = fontMetrics().height();
    const auto label = [&](const QString &text, QPointF at, Axis axis) {
        painter.setPen(m_theme.axisColor(axis));
        const double wide = painter.fontMetrics().horizontalAdvance(text) + 4;
        painter.drawText(QRectF(std::clamp(at.x() - wide / 2, 0.0, std::max(0.0, width() - wide)),
                                at.y() - line / 2.0, wide, line),
                         Qt::AlignCenter, text);
    };
    label(m_areSidesKnown ? tr("front") : tr("pitch +"), {middle.x(), middle.y() - half - line / 2.0},
          Axis::Pitch);
    label(m_areSidesKnown ? tr("rear") : tr("pitch −"), {middle.x(), middle.y() + half + line / 2.0},
          Axis::Pitch);
    const double beside = middle.y() - line / 2.0 - 3;
    label(m_areSidesKnown ? tr("left") : tr("roll −"), {middle.x() - half, beside}, Axis::Roll);
    label(m_areSidesKnown ? tr("right") : tr("roll +"), {middle.x() + half, beside}, Axis::Roll);
}

// Half an arrow around the ring.
void MotorDiagram::drawTurn(QPainter &painter, QPointF centre, double size, bool positive) const
{
    const QRectF ring(centre.x() - size, centre.y() - size, 2 * size, 2 * size);
    const double from = 90 + kTurnAngle / 2;
    painter.setPen(QPen(m_theme.axisColor(Axis::Yaw), 2, Qt::SolidLine, Qt::RoundCap));
    painter.setBrush(Qt::NoBrush);
    painter.drawArc(ring, int(from * 16), int(-kTurnAngle * 16));
    const double end = (positive ? from - kTurnAngle : from) * M_PI / 180;
    const QPointF tip = centre + QPointF(std::cos(end), -std::sin(end)) * size;
    const double along = positive ? end - M_PI / 2 : end + M_PI / 2;
    for (const double turn : {2.5, -2.5}) {
        const double back = along + turn;
        painter.drawLine(tip, tip + QPointF(std::cos(back), -std::sin(back)) * 7);
    }
}

void MotorDiagram::drawMotor(QPainter &painter, int motor) const
{
    const QPointF centre = placeOf(motor);
    const double size = radius();
    const double percent = output(motor);
    const MotorShare &share = m_shares[std::size_t(motor - 1)];
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.color(motor == m_selected ? ColorRole::SurfaceRaised : ColorRole::Surface));
    painter.drawEllipse(centre, size, size);
    const QRectF ring(centre.x() - size + 4, centre.y() - size + 4, 2 * size - 8, 2 * size - 8);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_theme.color(ColorRole::Border), 6));
    painter.drawEllipse(ring);
    if (percent > kTold) {
        painter.setPen(QPen(colourOf(motor), 6, Qt::SolidLine, Qt::FlatCap));
        painter.drawArc(ring, int(kTop), -int(kFullCircle * std::clamp(percent / 100, 0.01, 1.0)));
    }
    if (const QColor mark = markOf(motor); mark.isValid()) {
        painter.setPen(QPen(mark, m_asked.contains(motor) ? kAskedLine : kMarkLine));
        painter.drawEllipse(centre, size + 2, size + 2);
    }
    if (share.yaw != 0)
        drawTurn(painter, centre, size + 6, share.yaw > 0);
    QFont large = font();
    large.setWeight(QFont::Bold);
    painter.setFont(large);
    const int line = fontMetrics().height();
    painter.setPen(m_theme.color(ColorRole::Text));
    painter.drawText(QRectF(centre.x() - size, centre.y() - line, 2 * size, line), Qt::AlignCenter,
                     QString::number(motor));
    const QString text = outputText(motor);
    // What does not fit is written smaller, never cut: "> 10..." is another number.
    QFont small = font();
    const double wide = fontMetrics().horizontalAdvance(text);
    if (const double room = 2 * size - 12; wide > room)
        small.setPointSizeF(small.pointSizeF() * room / wide);
    painter.setFont(small);
    painter.setPen(m_theme.color(percent > kTold ? ColorRole::Text : ColorRole::Muted));
    painter.drawText(QRectF(centre.x() - size, centre.y(), 2 * size, line), Qt::AlignCenter, text);
}

void MotorDiagram::drawBar(QPainter &painter, int motor) const
{
    const QRectF bar = barOf(motor);
    const double percent = output(motor);
    QPainterPath outline;
    outline.addRoundedRect(bar, 4, 4);
    painter.fillPath(outline, m_theme.color(ColorRole::SurfaceRaised));
    if (percent > kTold) {
        const double high = bar.height() * std::clamp(percent / 100, 0.01, 1.0);
        painter.save();
        painter.setClipPath(outline);
        painter.fillRect(QRectF(bar.left(), bar.bottom() - high, bar.width(), high), colourOf(motor));
        painter.restore();
    }
    const QColor mark = markOf(motor);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(mark.isValid() ? QPen(mark, kMarkLine) : QPen(m_theme.color(ColorRole::Border), 1));
    painter.drawPath(outline);
    const double line = fontMetrics().height();
    const double wide = double(width()) / count();
    painter.setPen(m_theme.color(ColorRole::Text));
    QFont bold = font();
    bold.setWeight(QFont::Bold);
    painter.setFont(bold);
    painter.drawText(QRectF(bar.center().x() - wide / 2, height() - line - 2, wide, line), Qt::AlignCenter,
                     QString::number(motor));
    painter.setFont(font());
    painter.setPen(m_theme.color(percent > kTold ? ColorRole::Text : ColorRole::Muted));
    painter.drawText(QRectF(bar.center().x() - wide / 2, 0, wide, line), Qt::AlignCenter,
                     painter.fontMetrics().elidedText(outputText(motor), Qt::ElideRight, int(wide)));
}

void MotorDiagram::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (count() == 0) {
        painter.setPen(m_theme.color(ColorRole::Muted));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("The drone does not tell its motors yet."));
        return;
    }
    if (hasPlaces())
        drawFrame(painter);
    for (int motor = 1; motor <= count(); ++motor) {
        if (hasPlaces())
            drawMotor(painter, motor);
        else
            drawBar(painter, motor);
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(m_theme.color(ColorRole::Accent), 2));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
    }
}
