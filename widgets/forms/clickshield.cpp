// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/clickshield.h"

#include <QAbstractButton>
#include <QApplication>
#include <QKeyEvent>
#include <QTimer>

using namespace std::chrono_literals;

namespace {

constexpr auto kShieldTime = 500ms;

}  // namespace

ClickShield::ClickShield(QWidget &area, const QRect &place)
    : QWidget(&area)
{
    setGeometry(place);
    show();
    raise();
    QTimer::singleShot(kShieldTime, this, &QWidget::deleteLater);
}

// What has appeared gets its size only later.
ClickShield::ClickShield(QWidget &fresh)
    : ClickShield(fresh, QRect(0, 0, QWIDGETSIZE_MAX, QWIDGETSIZE_MAX))
{
    qApp->installEventFilter(this);  // keys go to whatever in it has the keyboard
}

void ClickShield::raiseAll(QWidget &area)
{
    for (ClickShield *shield : area.findChildren<ClickShield *>(QString(), Qt::FindDirectChildrenOnly))
        shield->raise();
}

bool ClickShield::eventFilter(QObject *watched, QEvent *event)
{
    const auto *widget = event->type() == QEvent::KeyPress ? qobject_cast<const QWidget *>(watched) : nullptr;
    if (!widget || !parentWidget()->isAncestorOf(widget))
        return QWidget::eventFilter(watched, event);
    const int key = static_cast<const QKeyEvent *>(event)->key();
    const bool acts = key == Qt::Key_Return || key == Qt::Key_Enter
        || (key == Qt::Key_Space && qobject_cast<const QAbstractButton *>(widget));
    return acts || QWidget::eventFilter(watched, event);
}
