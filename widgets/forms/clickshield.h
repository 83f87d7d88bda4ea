// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

/// Seen by nobody; takes clicks for a moment after something has gone, moved or appeared: whoever clicks then
/// means what was there before. Lies over everything in its parent, and destroys itself.
class ClickShield final : public QWidget
{
    Q_OBJECT
public:
    ClickShield(QWidget &area, const QRect &place);
    /// Over the whole of something that has newly appeared, which takes no Return and no space bar either.
    explicit ClickShield(QWidget &fresh);
    /// To be called when something else was raised.
    static void raiseAll(QWidget &area);

    bool eventFilter(QObject *watched, QEvent *event) override;

protected:
    void mousePressEvent(QMouseEvent *) override { }
    void mouseReleaseEvent(QMouseEvent *) override { }
    void mouseDoubleClickEvent(QMouseEvent *) override { }
};
