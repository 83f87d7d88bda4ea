// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QToolButton>

/// A button that comes up beside a field by itself. A click that was meant for what it lies over presses
/// nothing: it takes clicks once it can have been seen, and never the second one of a double click.
class LateButton final : public QToolButton
{
    Q_OBJECT
public:
    using QToolButton::QToolButton;
    static constexpr qint64 kSeenAfterMs = 600;
    [[nodiscard]] bool takesClicks() const;

protected:
    void showEvent(QShowEvent *event) override;
    void moveEvent(QMoveEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;

private:
    QElapsedTimer m_since;
};
