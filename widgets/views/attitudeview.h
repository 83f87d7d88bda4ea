// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/theme/theme.h"

#include <QWidget>

/// An artificial horizon with the camera's roll and pitch, and its heading against the frame.
class AttitudeView final : public QWidget
{
    Q_OBJECT
public:
    explicit AttitudeView(const Theme &theme, QWidget *parent = nullptr);

    /// Degrees; NaN shows "no data".
    void setAttitude(double roll, double pitch, double yaw);
    /// What stands there without data.
    void setPlaceholder(const QString &text);
    [[nodiscard]] QSize sizeHint() const override { return {280, 240}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {180, 160}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void drawHeading(QPainter &painter, const QRectF &area) const;

    const Theme &m_theme;
    double m_roll = 0;
    double m_pitch = 0;
    double m_yaw = 0;
    bool m_hasHeading = false;
    bool m_valid = false;
    QString m_placeholder;
};
