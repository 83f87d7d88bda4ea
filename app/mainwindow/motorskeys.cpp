// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/motorskeys.h"

#include <QApplication>
#include <QKeyEvent>

MotorsKeys::MotorsKeys(Workspace &workspace, QObject *parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    m_hold.setSingleShot(true);
    connect(&m_hold, &QTimer::timeout, this, [this] {
        emit holdEnded();
        m_workspace.setMotors(false);
    });
    // The application sees every key before any widget, also in dialogs that have nothing to do with the main window.
    qApp->installEventFilter(this);
}

bool MotorsKeys::eventFilter(QObject *watched, QEvent *event)
{
    const bool press = event->type() == QEvent::KeyPress;
    const bool release = event->type() == QEvent::KeyRelease;
    if (!press && !release && event->type() != QEvent::ShortcutOverride)
        return QObject::eventFilter(watched, event);
    const auto *key = static_cast<QKeyEvent *>(event);
    if (key->isAutoRepeat())
        return key->key() == Qt::Key_F12;
    if (key->key() == Qt::Key_F12 && !release) {
        if (press && watched->isWidgetType())
            m_workspace.setMotors(false);
        event->accept();
        return press && watched->isWidgetType();
    }
    // Esc keeps its meaning everywhere; held on, it stops the motors as well. A window that closes meanwhile does not matter.
    if (key->key() == Qt::Key_Escape && m_workspace.settings().escapeHoldMs() > 0) {
        if (release && m_hold.isActive()) {
            m_hold.stop();
            emit holdEnded();
        } else if (press && !m_hold.isActive() && m_workspace.client().isConnected()) {
            m_hold.start(m_workspace.settings().escapeHoldMs());
            emit holdStarted(m_workspace.settings().escapeHoldMs());
        }
    }
    return QObject::eventFilter(watched, event);
}
