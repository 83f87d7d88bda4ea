// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/theme/theme.h"

#include <QWidget>

/// A pad for two axes: the knob follows mouse or arrow keys and springs back when released. Values from -1 to
/// 1, right and up are positive.
class ControlPad final : public QWidget
{
    Q_OBJECT
public:
    explicit ControlPad(const Theme &theme, QWidget *parent = nullptr);

    [[nodiscard]] QPointF value() const { return m_value; }
    /// Held by mouse or key at this moment.
    [[nodiscard]] bool isHeld() const { return m_mouse || !m_keys.isEmpty(); }
    /// Springs back to the middle when let go (speed), or stays (angle).
    void setSprings(bool on);
    void reset();
    /// Moves the knob as another input would, unless it is held here.
    void steer(QPointF value);
    /// The widget will not be told of a button that comes up after this.
    [[nodiscard]] static bool endsDrag(const QWidget &widget, const QEvent &event);
    void setLabels(const QString &horizontal, const QString &vertical);
    [[nodiscard]] QSize sizeHint() const override { return {300, 300}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {180, 180}; }

signals:
    void moved();

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void keyReleaseEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    void setValue(QPointF value);
    void letGo();
    void applyKeys(bool fine);
    [[nodiscard]] QRectF field() const;

    const Theme &m_theme;
    QPointF m_value;
    QList<int> m_keys;
    bool m_mouse = false;
    bool m_springs = true;
    QString m_horizontal;
    QString m_vertical;
};
