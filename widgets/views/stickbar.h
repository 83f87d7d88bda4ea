// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/theme/theme.h"

#include <QWidget>

/// A stick as a bar: filled from where it begins to what it steers, with a mark where it stands.
class StickBar final : public QWidget
{
    Q_OBJECT
public:
    /// @param fromStop it begins at the left end instead of the middle
    StickBar(const Theme &theme, bool fromStop, QWidget *parent = nullptr);
    /// @param value what is steered, -1 to 1; NaN: nothing @param position of the stick in the same direction
    void setValue(double value, double position);
    [[nodiscard]] double value() const { return m_value; }
    [[nodiscard]] QSize sizeHint() const override { return {220, 22}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 22}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    const Theme &m_theme;
    bool m_fromStop;
    double m_value;
    double m_position;
};
