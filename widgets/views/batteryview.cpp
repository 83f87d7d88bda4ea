// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/batteryview.h"

#include "protocol/base/battery.h"
#include "widgets/models/numbertext.h"

#include <QPainter>
#include <QPainterPath>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

// A cell of lithium polymer: empty and full.
constexpr double kEmptyCell = 3.0;
constexpr double kFullCell = 4.2;
constexpr int kBar = 18;

}  // namespace

BatteryView::BatteryView(const Theme &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_volts(qQNaN())
{
    setAccessibleName(tr("Battery"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&m_theme, &Theme::changed, this, qOverload<>(&QWidget::update));
    tell();
}

QSize BatteryView::sizeHint() const
{
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() + 8);
    return {240, QFontMetrics(large).height() + kBar + 2 * fontMetrics().height() + 2 * Metric::kUnit};
}

void BatteryView::setVolts(double volts, int counted)
{
    const bool isSame = (std::isnan(volts) && std::isnan(m_volts)) || std::abs(volts - m_volts) < 0.005;
    if (isSame && counted == m_counted)
        return;
    m_volts = volts;
    m_counted = counted;
    m_cells = batteryCells(volts) == 0 ? 0 : std::max({m_cells, batteryCells(volts), counted});
    tell();
}

void BatteryView::setThresholds(std::optional<double> alarm, std::optional<double> motorsOff, bool perCell)
{
    m_alarm = alarm;
    m_motorsOff = motorsOff;
    m_perCell = perCell;
    tell();
}

void BatteryView::setLowCell(double volts)
{
    if (std::exchange(m_lowCell, volts) != volts)
        tell();
}

std::optional<double> BatteryView::alarm() const
{
    return lowBattery(m_cells, m_lowCell, {.alarm = m_alarm, .motorsOff = {}, .perCell = m_perCell});
}

std::optional<double> BatteryView::whole(const std::optional<double> &volts) const
{
    if (!volts || (m_perCell && m_cells == 0))
        return {};
    return m_perCell ? *volts * m_cells : *volts;
}

BatteryView::State BatteryView::state() const
{
    if (std::isnan(m_volts) || m_cells == 0)
        return State::Unknown;
    if (motorsOff() && m_volts < *motorsOff())
        return State::Empty;
    return alarm() && m_volts < *alarm() ? State::Low : State::Good;
}

bool BatteryView::isAlarmOfOtherBattery() const
{
    return ::isAlarmOfOtherBattery(m_volts, m_cells, m_lowCell,
                                   {.alarm = m_alarm, .motorsOff = {}, .perCell = m_perCell}, false);
}

QString BatteryView::stateText() const
{
    switch (state()) {
    case State::Unknown: return std::isnan(m_volts) ? QString() : tr("no battery");
    case State::Empty: return tr("✖ motors off");
    case State::Low: return isAlarmOfOtherBattery() ? tr("⚠ below the alarm") : tr("⚠ low");
    case State::Good: break;
    }
    return alarm() || motorsOff() ? tr("✓ good") : QString();
}

// Where the board does not count them: so many would have such a voltage.
QString BatteryView::cellText() const
{
    if (m_cells == 0)
        return {};
    const QString each = numberText(m_volts / m_cells, 2);
    return m_counted == m_cells ? tr("%n cell(s) as the board counts, %1 V each", nullptr, m_cells).arg(each)
                                : tr("%n cell(s) by the voltage, %1 V each", nullptr, m_cells).arg(each);
}

QString BatteryView::thresholdText() const
{
    if (alarm() && motorsOff())
        return tr("Alarm below %1 V, off below %2 V")
            .arg(numberText(*alarm(), 1), numberText(*motorsOff(), 1));
    if (alarm())
        return tr("Alarm below %1 V").arg(numberText(*alarm(), 1));
    if (motorsOff())
        return tr("Motors off below %1 V").arg(numberText(*motorsOff(), 1));
    return m_cells > 0 ? tr("No limits are known.") : QString();
}

void BatteryView::tell()
{
    const QString volts = std::isnan(m_volts) ? tr("No data") : tr("%1 V").arg(numberText(m_volts, 2));
    setAccessibleDescription(QStringList{volts, stateText(), cellText(), thresholdText()}
                                 .filter(QRegularExpression(u"."_s))
                                 .join(u", "_s));
    setToolTip(thresholdText());
    update();
}

void BatteryView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor muted = m_theme.color(ColorRole::Muted);
    const State state = this->state();
    const QColor colour
        = m_theme.color(state == State::Empty                                  ? ColorRole::Danger
                            : state == State::Low                              ? ColorRole::Warning
                            : state == State::Good && (alarm() || motorsOff()) ? ColorRole::Ok
                                                                               : ColorRole::Text);
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() + 8);
    large.setWeight(QFont::DemiBold);
    painter.setFont(large);
    const int line = QFontMetrics(large).height();
    painter.setPen(colour);
    const QString volts = std::isnan(m_volts) ? u"–"_s : tr("%1 V").arg(numberText(m_volts, 2));
    painter.drawText(QRect(0, 0, width(), line), Qt::AlignLeft | Qt::AlignVCenter, volts);
    const int used = painter.fontMetrics().horizontalAdvance(volts) + 2 * Metric::kGap;
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    painter.setFont(bold);
    painter.drawText(QRect(used, 0, width() - used, line), Qt::AlignRight | Qt::AlignVCenter, stateText());

    // From empty to full, with what the board does where.
    const QRectF bar(0.5, line + Metric::kUnit + 0.5, width() - 1.0, kBar - 1.0);
    QPainterPath outline;
    outline.addRoundedRect(bar, 4, 4);
    painter.fillPath(outline, m_theme.color(ColorRole::SurfaceRaised));
    if (m_cells > 0) {
        double low = m_cells * kEmptyCell;
        double high = m_cells * kFullCell;
        for (const auto &threshold : {alarm(), motorsOff()}) {
            low = std::min(low, threshold.value_or(low));
            high = std::max(high, threshold.value_or(high));
        }
        const auto x = [&](double value) {
            return bar.left() + bar.width() * std::clamp((value - low) / (high - low), 0.0, 1.0);
        };
        painter.save();
        painter.setClipPath(outline);
        painter.fillRect(QRectF(bar.topLeft(), QPointF(x(m_volts), bar.bottom())), colour);
        painter.restore();
        for (const auto &[threshold, role] :
             {std::pair(alarm(), ColorRole::Warning), {motorsOff(), ColorRole::Danger}}) {
            if (!threshold)
                continue;
            painter.setPen(QPen(m_theme.color(ColorRole::Surface), 4));
            painter.drawLine(QPointF(x(*threshold), bar.top()), QPointF(x(*threshold), bar.bottom()));
            painter.setPen(QPen(m_theme.color(role), 2));
            painter.drawLine(QPointF(x(*threshold), bar.top() - 2), QPointF(x(*threshold), bar.bottom() + 2));
        }
    }
    painter.setPen(QPen(m_theme.color(ColorRole::Border), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(outline);
    painter.setFont(font());
    painter.setPen(muted);
    int y = line + kBar + 2 * Metric::kUnit;
    for (const QString &text : {cellText(), std::isnan(m_volts) ? QString() : thresholdText()}) {
        painter.drawText(QRect(0, y, width(), fontMetrics().height()), Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(text, Qt::ElideRight, width()));
        y += fontMetrics().height();
    }
}
