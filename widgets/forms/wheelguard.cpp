// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/wheelguard.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <QSlider>

namespace {

// The field in which a choice or a number is typed belongs to it.
QWidget *controlOf(QObject *watched)
{
    auto *widget = qobject_cast<QWidget *>(watched);
    return qobject_cast<QLineEdit *>(widget) ? widget->parentWidget() : widget;
}

}  // namespace

WheelGuard::WheelGuard(QObject *parent)
    : QObject(parent)
{
    qApp->installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Polish) {
        auto *widget = qobject_cast<QWidget *>(watched);
        if (widget && widget->focusPolicy() == Qt::WheelFocus
            && (qobject_cast<QComboBox *>(widget) || qobject_cast<QAbstractSpinBox *>(widget)))
            widget->setFocusPolicy(Qt::StrongFocus);
        return false;
    }
    if (event->type() != QEvent::Wheel)
        return false;
    QWidget *control = controlOf(watched);
    const bool isNumber = qobject_cast<QAbstractSpinBox *>(control) || qobject_cast<QSlider *>(control);
    if (!qobject_cast<QComboBox *>(control) && !(isNumber && !control->hasFocus()))
        return false;
    event->ignore();  // for what scrolls around it
    return true;
}
