// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/theme/theme.h"

#include <QPolygonF>
#include <QWidget>

#include <array>
#include <optional>
#include <vector>

/// The gimbal as a body, seen from behind and above: the camera as its sensor has it, and, where the frame is
/// measured too, the frame, the arms and the motors between both. Nothing is drawn that is not known.
class GimbalView final : public QWidget
{
    Q_OBJECT
public:
    /// Roll, pitch, yaw in degrees; NaN = not known. Pitch up, roll and yaw to the right are positive.
    using Angles = std::array<double, 3>;
    struct Pose
    {
        Angles camera{};
        /// Empty: nobody measures it. Its yaw may be unknown all the same: then the camera's counts from it.
        std::optional<Angles> frame;
        std::optional<bool> running;  ///< the motors
    };

    explicit GimbalView(const Theme &theme, QWidget *parent = nullptr);

    void setPose(const Pose &pose);
    [[nodiscard]] const Pose &pose() const { return m_pose; }
    [[nodiscard]] QSize sizeHint() const override { return {280, 240}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {150, 150}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    [[nodiscard]] bool isKnown() const;
    [[nodiscard]] QString sentence() const;

    const Theme &m_theme;
    Pose m_pose{{qQNaN(), qQNaN(), qQNaN()}, {}, {}};
};
