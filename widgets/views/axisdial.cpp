// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/axisdial.h"

#include "protocol/base/angles.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

QPointF onCircle(QPointF center, double radius, double degrees)
{
    const double angle = radians(degrees);
    return center + QPointF(std::sin(angle), -std::cos(angle)) * radius;
}

/// Two texts side by side, together in the middle; the first with the painter's own font and pen.
void drawPair(QPainter &painter, const QRect &room, const std::pair<QString, QString> &texts,
              const QFont &secondFont, const QColor &secondColor)
{
    const int first = painter.fontMetrics().horizontalAdvance(texts.first);
    const int both = first + QFontMetrics(secondFont).horizontalAdvance(texts.second);
    const int x = room.left() + (room.width() - both) / 2;
    const QRect line(x, room.top(), both + 2, room.height());
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, texts.first);
    painter.save();
    painter.setFont(secondFont);
    painter.setPen(secondColor);
    painter.drawText(line.adjusted(first, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, texts.second);
    painter.restore();
}

}  // namespace

AxisDial::AxisDial(const Theme &theme, Axis axis, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_axis(axis)
{
    setAccessibleName(axisLabel(axis));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    connect(&m_theme, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void AxisDial::setValues(double angle, double target, double power)
{
    // No "-0.0": a tenth is all that is shown.
    const auto shown = [](double degrees) { return std::abs(degrees) < 0.05 ? 0.0 : degrees; };
    m_valid = !std::isnan(angle);
    m_angle = shown(angle);
    m_target = shown(target);
    m_power = power;
    tell();
    update();
}

void AxisDial::tell()
{
    const auto said
        = [](double value, int decimals) { return std::isnan(value) ? u"–"_s : numberText(value, decimals); };
    QString text = m_valid ? tr("Angle %1°, target %2°, motor power %3 %")
                                 .arg(said(m_angle, 1), said(m_target, 1), said(m_power, 0))
                           : tr("No data");
    if (m_limits)
        text += u", "_s
            + tr("steered from %1° to %2°").arg(said(m_limits->first, 0), said(m_limits->second, 0));
    if (!guideText().isEmpty())
        text += u", "_s + guideText();
    setAccessibleDescription(text);
}

void AxisDial::setDriven(std::optional<bool> driven)
{
    if (driven == std::exchange(m_driven, driven))
        return;
    explain();
    tell();
    update();
}

void AxisDial::explain()
{
    if (!m_follows || m_driven == false)
        setToolTip({});
    else
        setToolTip(*m_follows ? tr("This axis follows the frame.")
                              : tr("This axis keeps its direction, however the frame turns."));
}

QString AxisDial::guideText() const
{
    if (m_driven == false)
        return tr("motor off");
    return !m_follows ? QString() : *m_follows ? tr("follows") : tr("holds");
}

void AxisDial::setLimits(const std::optional<std::pair<double, double>> &limits)
{
    if (limits == m_limits)
        return;
    m_limits = limits;
    tell();
    update();
}

void AxisDial::setFollows(std::optional<bool> follows)
{
    if (follows == m_follows)
        return;
    m_follows = follows;
    explain();
    tell();
    update();
}

void AxisDial::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor axisColor = m_theme.axisColor(m_axis);
    const QColor muted = m_theme.color(ColorRole::Muted);
    const int line = fontMetrics().height();
    QFont title = font();
    title.setWeight(QFont::DemiBold);
    painter.setFont(title);
    painter.setPen(axisColor);
    const QString guide = guideText().isEmpty() ? QString() : u" · "_s + guideText();
    drawPair(painter, QRect(0, 0, width(), line + 4), {axisLabel(m_axis), guide}, font(), muted);

    const double bottom = 2.0 * line + 22;
    const double radius = std::max(20.0, std::min(width() - 24.0, height() - line - 8 - bottom) / 2.0);
    const QPointF center(width() / 2.0, line + 8 + radius);
    painter.setPen(QPen(m_theme.color(ColorRole::Border), 2));
    painter.setBrush(m_theme.color(ColorRole::Surface));
    painter.drawEllipse(center, radius, radius);
    if (m_limits && m_limits->second > m_limits->first && m_limits->second - m_limits->first < 360) {
        // The part of the circle that steering reaches.
        QColor reach = axisColor;
        reach.setAlpha(70);
        painter.setPen(QPen(reach, 6, Qt::SolidLine, Qt::FlatCap));
        painter.drawArc(
            QRectF(center.x() - radius + 5, center.y() - radius + 5, 2 * radius - 10, 2 * radius - 10),
            int((90 - m_limits->second) * 16), int((m_limits->second - m_limits->first) * 16));
    }
    painter.setPen(QPen(muted, 1));
    for (int mark = 0; mark < 360; mark += 30)
        painter.drawLine(onCircle(center, radius - 2, mark),
                         onCircle(center, radius - (mark % 90 == 0 ? 9 : 5), mark));
    if (m_valid) {
        if (!std::isnan(m_target)) {
            painter.setPen(QPen(muted, 2, Qt::DashLine));
            painter.drawLine(center, onCircle(center, radius - 10, m_target));
        }
        painter.setPen(QPen(axisColor, 4, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(center, onCircle(center, radius - 10, m_angle));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(axisColor);
    painter.drawEllipse(center, 4, 4);

    // Numbers below: angle large, target small; then the motor power as a bar with its figure.
    double y = center.y() + radius + 4;
    painter.setPen(m_theme.color(ColorRole::Text));
    const QString angleText = m_valid ? u"%1°"_s.arg(numberText(m_angle, 1)) : u"–"_s;
    const QString targetText
        = m_valid && !std::isnan(m_target) ? u"  → %1°"_s.arg(numberText(m_target, 1)) : QString();
    drawPair(painter, QRect(0, int(y), width(), line), {angleText, targetText}, font(), muted);
    painter.setFont(font());
    painter.setPen(muted);
    if (std::isnan(m_power))
        return;  // not every board tells it
    y += line + 4;
    const QRectF bar(16, y, width() - 32, 6);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.color(ColorRole::SurfaceRaised));
    painter.drawRoundedRect(bar, 3, 3);
    painter.setBrush(m_power > 90 ? m_theme.color(ColorRole::Warning) : axisColor);
    painter.drawRoundedRect(
        QRectF(bar.left(), bar.top(), bar.width() * std::clamp(m_power, 0.0, 100.0) / 100.0, 6), 3, 3);
    painter.setPen(muted);
    painter.drawText(QRectF(0, y + 8, width(), line), Qt::AlignCenter,
                     tr("Motor power %1 %").arg(numberText(m_power, 0)));
}
