// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/fieldsphere.h"
#include "widgets/theme/theme.h"

#include <QWidget>

#include <vector>

/// The sphere on which a magnetometer's points lie, as its two halves side by side: nothing is hidden. Rings
/// stand where a point is still missing.
class FieldSphereView final : public QWidget
{
    Q_OBJECT
public:
    explicit FieldSphereView(const Theme &theme, QWidget *parent = nullptr);

    /// @param points the newest last; without a sphere nothing of them is drawn
    void setPoints(const std::vector<Vector3> &points, const std::optional<FieldSphere> &sphere,
                   const SeenDirections &seen);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    struct Half;
    void drawHalf(QPainter &painter, const Half &half) const;
    void drawLegend(QPainter &painter) const;

    const Theme &m_theme;
    std::vector<Vector3> m_points;  // from the centre, in radii
    SeenDirections m_seen;
};

/// "+X", "+X −Z": which way a direction of the sensor goes.
[[nodiscard]] QString directionName(const Vector3 &direction);
