// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/armedstate.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr int kTilePadding = 12;
constexpr int kTileBorder = 3;
constexpr int kTileMinWidth = 200;

}  // namespace

ArmedState::ArmedState(const Theme &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setAccessibleName(tr("State of the drone"));
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    connect(&m_theme, &Theme::changed, this, qOverload<>(&QWidget::update));
    tell();
}

// Armed counts before all, whatever else is not known; "disarmed" does not mean that motors stand.
ArmedState::State ArmedState::stateOf(std::optional<bool> armed, std::optional<bool> calibrated,
                                      std::optional<bool> calibrating, std::optional<bool> outputs)
{
    if (armed == true)
        return State::Armed;
    if (outputs == true)
        return State::RunsOn;
    if (!armed)
        return State::Unknown;
    if (calibrating == true)
        return State::Calibrating;
    if (!calibrated)
        return State::Unknown;
    if (!*calibrated)
        return State::NotCalibrated;
    return outputs ? State::Disarmed : State::OutputsUnknown;
}

bool ArmedState::isDisarmed(State state)
{
    return state == State::Disarmed || state == State::OutputsUnknown || state == State::NotCalibrated;
}

void ArmedState::setState(State state)
{
    if (std::exchange(m_state, state) == state)
        return;
    tell();
    updateGeometry();
}

QString ArmedState::word() const
{
    switch (m_state) {
    case State::Unknown: break;
    case State::NotCalibrated: return tr("Not calibrated");
    case State::Calibrating: return tr("Calibrating");
    case State::Disarmed: return tr("Disarmed");
    case State::OutputsUnknown: return tr("Outputs unknown");
    case State::Awaited: return tr("Not told yet");
    case State::RunsOn: return tr("MOTORS DRIVEN");
    case State::Armed: return tr("ARMED");
    }
    return tr("State not known");
}

QString ArmedState::sentence() const
{
    switch (m_state) {
    case State::Unknown: break;
    case State::NotCalibrated: return tr("It cannot be armed before a calibration.");
    case State::Calibrating: return tr("It lies still until this is over.");
    case State::Disarmed: return tr("Calibrated.");
    case State::OutputsUnknown:
        return tr("Disarmed. It does not tell what its motors do: see that they stand.");
    case State::Awaited: return tr("Armed or disarmed from here, it has not said so yet: take it for armed.");
    case State::RunsOn: return tr("It is not armed, and drives motors all the same: keep clear.");
    case State::Armed: return tr("Propellers may turn at any moment.");
    }
    return tr("Take it for armed: nothing tells it at present.");
}

void ArmedState::tell()
{
    setAccessibleDescription(word() + u". "_s + sentence());
    update();
}

void ArmedState::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        updateGeometry();
}

QFont ArmedState::wordFont() const
{
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() + 8);
    large.setWeight(QFont::Bold);
    return large;
}

QFont ArmedState::wordFontIn(int room) const
{
    QFont fitting = wordFont();
    while (QFontMetrics(fitting).horizontalAdvance(word()) > room
           && fitting.pointSizeF() > font().pointSizeF())
        fitting.setPointSizeF(fitting.pointSizeF() - 1);
    return fitting;
}

// Beside the sign.
int ArmedState::roomIn(int width) const
{
    return width - 3 * kTilePadding - 2 * QFontMetrics(wordFont()).height();
}

QString ArmedState::shownWord(int width) const
{
    const int room = roomIn(width);
    return QFontMetrics(wordFontIn(room)).elidedText(word(), Qt::ElideRight, room);
}

int ArmedState::heightForWidth(int width) const
{
    const int line = QFontMetrics(wordFont()).height();
    const int room = std::max(60, roomIn(width));
    const int text
        = fontMetrics().boundingRect(QRect(0, 0, room, 1000), Qt::TextWordWrap, sentence()).height();
    return 2 * kTilePadding + line + Metric::kUnit + std::max(text, 2 * fontMetrics().height());
}

QSize ArmedState::sizeHint() const
{
    return {320, heightForWidth(320)};
}

QSize ArmedState::minimumSizeHint() const
{
    return {kTileMinWidth, heightForWidth(std::max(kTileMinWidth, width()))};
}

// A triangle warns, a ring turns, a tick is well, a bar cannot, a question mark is not known.
void ArmedState::drawSign(QPainter &painter, const QRectF &room, const QColor &colour) const
{
    const double unit = room.height() / 10;
    const QPointF middle = room.center();
    painter.setPen(QPen(colour, 1.4 * unit, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    const QRectF ring = room.adjusted(unit, unit, -unit, -unit);
    const auto at = [&](double x, double y) { return middle + QPointF(x, y) * unit; };
    switch (m_state) {
    case State::Armed:
    case State::RunsOn:
        painter.drawPolygon(QPolygonF({at(0, -4), at(4.4, 3.6), at(-4.4, 3.6)}));
        painter.drawLine(at(0, -1), at(0, 1));
        painter.drawPoint(at(0, 2.6));
        break;
    case State::Calibrating:
        painter.drawArc(ring, 40 * 16, 250 * 16);
        painter.drawLine(at(4, -2.6), at(4, -0.6));
        painter.drawLine(at(4, -0.6), at(1.9, -0.9));
        break;
    case State::Disarmed:
        painter.drawEllipse(ring);
        painter.drawPolyline(QPolygonF({at(-1.9, 0.1), at(-0.5, 1.6), at(2, -1.5)}));
        break;
    case State::OutputsUnknown:
    case State::Awaited:
        painter.drawEllipse(ring);
        painter.drawLine(at(0, -2.2), at(0, 0.4));
        painter.drawPoint(at(0, 2.2));
        break;
    case State::NotCalibrated:
        painter.drawEllipse(ring);
        painter.drawLine(at(-1.9, 0), at(1.9, 0));
        break;
    case State::Unknown: {
        painter.drawEllipse(ring);
        QFont mark = wordFont();
        mark.setPixelSize(int(5 * unit));
        painter.setFont(mark);
        painter.drawText(room, Qt::AlignCenter, u"?"_s);
        break;
    }
    }
}

void ArmedState::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ColorRole role = isAlarm()      ? ColorRole::Danger
        : isWarning()                     ? ColorRole::Warning
        : m_state == State::Disarmed      ? ColorRole::Ok
        : m_state == State::NotCalibrated ? ColorRole::Changed
                                          : ColorRole::Muted;
    const QColor own = m_theme.color(role);
    const QRectF tile = QRectF(rect()).adjusted(kTileBorder / 2.0, kTileBorder / 2.0, -kTileBorder / 2.0,
                                                -kTileBorder / 2.0);
    painter.setPen(QPen(own, kTileBorder, m_state == State::Unknown ? Qt::DashLine : Qt::SolidLine));
    painter.setBrush(isAlarm() ? own : m_theme.color(ColorRole::Surface));
    painter.drawRoundedRect(tile, 8, 8);
    const QColor ink = isAlarm() ? m_theme.color(ColorRole::DangerText) : own;

    const int line = QFontMetrics(wordFont()).height();
    const double size = 2.0 * line;
    drawSign(painter, QRectF(kTilePadding, (height() - size) / 2, size, size), ink);
    const int left = int(2 * kTilePadding + size);
    QRect room(left, kTilePadding, roomIn(width()), height() - 2 * kTilePadding);
    const int used = line + Metric::kUnit
        + fontMetrics().boundingRect(QRect(0, 0, room.width(), 1000), Qt::TextWordWrap, sentence()).height();
    room.adjust(0, std::max(0, (room.height() - used) / 2), 0, 0);
    painter.setFont(wordFontIn(room.width()));
    painter.setPen(ink);
    painter.drawText(QRect(room.left(), room.top(), room.width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                     shownWord(width()));
    painter.setFont(font());
    painter.setPen(isAlarm() ? ink : m_theme.color(ColorRole::Text));
    painter.drawText(room.adjusted(0, line + Metric::kUnit, 0, 0), Qt::TextWordWrap, sentence());
}
