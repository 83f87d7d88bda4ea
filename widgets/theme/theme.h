// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/axis.h"

#include <QColor>
#include <QObject>
#include <QPalette>

class QWidget;

/// What a colour is for. Code names roles, never colours.
enum class ColorRole {
    Background,
    Surface,
    SurfaceRaised,
    Border,
    Text,
    Muted,
    Accent,
    AccentText,
    Ok,
    Changed,
    Warning,
    Danger,
    DangerText,
    AxisRoll,
    AxisPitch,
    AxisYaw,
    Sky,
    Ground,
    Count
};

/// Colours of the program, light and dark. Follows the system at start and can be forced.
class Theme final : public QObject
{
    Q_OBJECT
public:
    enum class Mode { System, Light, Dark };

    explicit Theme(QObject *parent = nullptr);

    void setMode(Mode mode);
    [[nodiscard]] bool isDark() const { return m_dark; }
    [[nodiscard]] QColor color(ColorRole role) const;
    [[nodiscard]] QColor axisColor(Axis axis) const;
    /// Colours of traces that belong to no axis, told apart by colour-blind eyes as well.
    [[nodiscard]] QColor seriesColor(int index) const;
    /// Applies palette and style sheet to the application.
    void apply();

    /// WCAG contrast ratio of two colours, 1 to 21.
    [[nodiscard]] static double contrast(const QColor &a, const QColor &b);

signals:
    void changed();

private:
    [[nodiscard]] QPalette palette() const;
    [[nodiscard]] QString styleSheet() const;
    bool m_dark = false;
};

/// Reapplies the style sheet to a widget whose name or properties have changed.
void repolish(QWidget *widget);

/// Grid of the whole screen in logical pixels.
namespace Metric {
inline constexpr int kUnit = 4;
inline constexpr int kGap = 8;
inline constexpr int kMargin = 16;
inline constexpr int kGroupGap = 24;
inline constexpr int kFieldWidth = 420;
}  // namespace Metric
