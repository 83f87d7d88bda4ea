// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"

#include <QAbstractButton>
#include <QPointer>
#include <QTimer>

class QMouseEvent;

/// F12, or Esc held, switches the motors off: from every window and dialog, whatever has the focus.
class MotorsKeys final : public QObject
{
    Q_OBJECT
public:
    explicit MotorsKeys(Workspace &workspace, QObject *parent = nullptr);
    /// While motors run this button takes also the press that closes an open menu or list.
    void serve(QAbstractButton &button) { m_button = &button; }

signals:
    /// Esc is down and will act after this many milliseconds.
    void holdStarted(int ms);
    void holdEnded();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void escapePressed();
    void pressedOutside(const QMouseEvent &press);

    Workspace &m_workspace;
    QPointer<QAbstractButton> m_button;
    QTimer m_hold;
    QTimer m_letGo;  // a release counts only if no press follows at once: that would be auto-repeat
    bool m_down = false;
};
