// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/theme/theme.h"

#include <QWidget>

/// The sensor as a cube with its three axes, drawn in a position; beside it, the face that should lie up.
class SensorCube final : public QWidget
{
    Q_OBJECT
public:
    explicit SensorCube(const Theme &theme, QWidget *parent = nullptr);

    /// Which axis points up: 0 = +Z, 1 = -Z, 2 = +X, 3 = -X, 4 = +Y, 5 = -Y; -1 = none (tilted).
    void setPosition(int up);
    [[nodiscard]] QSize sizeHint() const override { return {220, 200}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 150}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    const Theme &m_theme;
    int m_up = 0;
};
