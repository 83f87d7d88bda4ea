// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/latebutton.h"

#include <QMouseEvent>

bool LateButton::takesClicks() const
{
    return m_since.isValid() && m_since.elapsed() >= kSeenAfterMs;
}

void LateButton::showEvent(QShowEvent *event)
{
    m_since.start();
    QToolButton::showEvent(event);
}

void LateButton::moveEvent(QMoveEvent *event)
{
    m_since.start();
    QToolButton::moveEvent(event);
}

void LateButton::mousePressEvent(QMouseEvent *event)
{
    if (takesClicks())
        QToolButton::mousePressEvent(event);
    else
        event->accept();
}

void LateButton::mouseDoubleClickEvent(QMouseEvent *event)
{
    event->accept();
}
