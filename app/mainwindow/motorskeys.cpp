// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/motorskeys.h"

#include <QAbstractButton>
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>

namespace {

constexpr int kAutoRepeatGap = 60;

}  // namespace

MotorsKeys::MotorsKeys(Workspace &workspace, QObject *parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    m_hold.setSingleShot(true);
    m_letGo.setSingleShot(true);
    m_letGo.setInterval(kAutoRepeatGap);
    connect(&m_letGo, &QTimer::timeout, this, [this] {
        m_down = false;
        m_hold.stop();
        emit holdEnded();
    });
    connect(&m_hold, &QTimer::timeout, this, [this] { m_workspace.setMotors(false); });
    // The application sees every key before any widget, also in dialogs that have nothing to do with the main
    // window.
    qApp->installEventFilter(this);
}

bool MotorsKeys::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::MouseButtonPress)
        pressedOutside(*static_cast<QMouseEvent *>(event));
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
    // Esc keeps its meaning everywhere; held down, it also stops the motors, even if its window closes
    // meanwhile.
    if (key->key() == Qt::Key_Escape && release)
        m_letGo.start();
    else if (key->key() == Qt::Key_Escape && press)
        escapePressed();
    return QObject::eventFilter(watched, event);
}

// Under X11 the press that closes a menu or a list reaches nothing else.
void MotorsKeys::pressedOutside(const QMouseEvent &press)
{
    if (!m_button || !m_button->isVisible() || !QApplication::activePopupWidget()
        || press.button() != Qt::LeftButton || !m_workspace.motorsRunning().value_or(true))
        return;
    if (m_button->rect().contains(m_button->mapFromGlobal(press.globalPosition().toPoint())))
        m_button->click();
}

void MotorsKeys::escapePressed()
{
    m_letGo.stop();
    const int ms = m_workspace.settings().escapeHoldMs();
    if (m_down || ms == 0 || m_workspace.client().state() == DeviceClient::State::Disconnected)
        return;
    m_down = true;
    m_hold.start(ms);
    emit holdStarted(ms);
}
