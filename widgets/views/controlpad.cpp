// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/controlpad.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace {

constexpr double kKeyDeflection = 0.5;  // an arrow key pushes half-way, with Shift a tenth
constexpr double kFineDeflection = 0.1;
constexpr double kKeyStep = 0.05;  // of a knob that stays where it is

}  // namespace

ControlPad::ControlPad(const Theme &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Steering pad"));
    setAccessibleDescription(tr("Drag, or hold the arrow keys; Shift for slow"));
    connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void ControlPad::setLabels(const QString &horizontal, const QString &vertical)
{
    m_horizontal = horizontal;
    m_vertical = vertical;
    update();
}

void ControlPad::setSprings(bool on)
{
    m_springs = on;
    reset();
}

void ControlPad::reset()
{
    m_keys.clear();
    m_mouse = false;
    setValue({});
}

void ControlPad::steer(QPointF value)
{
    if (!isHeld())
        setValue(value);
}

void ControlPad::setValue(QPointF value)
{
    value = {std::clamp(value.x(), -1.0, 1.0), std::clamp(value.y(), -1.0, 1.0)};
    if (value == m_value)
        return;
    m_value = value;
    update();
    emit moved();
}

QRectF ControlPad::field() const
{
    const double size = std::min(width(), height()) - 12;
    return {(width() - size) / 2, (height() - size) / 2, size, size};
}

void ControlPad::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    m_mouse = true;
    mouseMoveEvent(event);
}

void ControlPad::mouseMoveEvent(QMouseEvent *event)
{
    if (!m_mouse)
        return;
    const QRectF area = field();
    setValue({(event->position().x() - area.center().x()) / (area.width() / 2),
              -(event->position().y() - area.center().y()) / (area.height() / 2)});
}

void ControlPad::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    m_mouse = false;
    if (m_springs)
        setValue({});
    else
        emit moved();
}

void ControlPad::applyKeys(bool fine)
{
    const auto pushed = [this](int key) { return m_keys.contains(key) ? 1.0 : 0.0; };
    const QPointF direction(pushed(Qt::Key_Right) - pushed(Qt::Key_Left),
                            pushed(Qt::Key_Up) - pushed(Qt::Key_Down));
    if (m_springs)
        setValue(direction * (fine ? kFineDeflection : kKeyDeflection));
    else
        setValue(m_value + direction * (fine ? kKeyStep / 5 : kKeyStep));
}

void ControlPad::keyPressEvent(QKeyEvent *event)
{
    const int key = event->key();
    if (key != Qt::Key_Left && key != Qt::Key_Right && key != Qt::Key_Up && key != Qt::Key_Down) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (!m_keys.contains(key))
        m_keys.append(key);
    if (!event->isAutoRepeat() || !m_springs)
        applyKeys(event->modifiers() & Qt::ShiftModifier);
}

void ControlPad::keyReleaseEvent(QKeyEvent *event)
{
    if (event->isAutoRepeat())
        return;
    m_keys.removeAll(event->key());
    if (m_springs)
        applyKeys(event->modifiers() & Qt::ShiftModifier);
    QWidget::keyReleaseEvent(event);
}

// Whoever is no longer told of the button coming up has let go.
void ControlPad::letGo()
{
    m_keys.clear();
    m_mouse = false;
    if (m_springs)
        setValue({});
}

bool ControlPad::endsDrag(const QWidget &widget, const QEvent &event)
{
    const QEvent::Type type = event.type();
    return type == QEvent::UngrabMouse || type == QEvent::WindowDeactivate || type == QEvent::Hide
        || (type == QEvent::EnabledChange && !widget.isEnabled());
}

bool ControlPad::event(QEvent *event)
{
    if (endsDrag(*this, *event))
        letGo();
    return QWidget::event(event);
}

void ControlPad::focusOutEvent(QFocusEvent *event)
{
    // A key released elsewhere must not keep pushing.
    m_keys.clear();
    if (m_springs && !m_mouse)
        setValue({});
    QWidget::focusOutEvent(event);
}

void ControlPad::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = field();
    painter.setPen(QPen(hasFocus() ? m_theme.color(ColorRole::Accent) : m_theme.color(ColorRole::Border),
                        hasFocus() ? 2 : 1));
    painter.setBrush(m_theme.color(ColorRole::SurfaceRaised));
    painter.drawRoundedRect(area, 8, 8);
    painter.setPen(QPen(m_theme.color(ColorRole::Border), 1));
    painter.drawLine(QPointF(area.center().x(), area.top() + 8),
                     QPointF(area.center().x(), area.bottom() - 8));
    painter.drawLine(QPointF(area.left() + 8, area.center().y()),
                     QPointF(area.right() - 8, area.center().y()));
    painter.setPen(m_theme.color(ColorRole::Muted));
    painter.drawText(area.adjusted(8, 0, -8, -6), Qt::AlignBottom | Qt::AlignRight,
                     m_horizontal + QStringLiteral(" →"));
    painter.drawText(area.adjusted(8, 6, -8, 0), Qt::AlignTop | Qt::AlignLeft,
                     m_vertical + QStringLiteral(" ↑"));
    const QPointF knob(area.center().x() + m_value.x() * area.width() / 2,
                       area.center().y() - m_value.y() * area.height() / 2);
    painter.setPen(QPen(m_theme.color(ColorRole::Accent), 2));
    painter.drawLine(area.center(), knob);
    painter.setPen(Qt::NoPen);
    painter.setBrush(isEnabled() ? m_theme.color(ColorRole::Accent) : m_theme.color(ColorRole::Muted));
    painter.drawEllipse(knob, 11, 11);
}
