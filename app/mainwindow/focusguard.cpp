// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/focusguard.h"

#include "widgets/forms/keyboard.h"
#include "widgets/forms/panel.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QPushButton>
#include <QStackedWidget>

#include <algorithm>
#include <utility>

namespace {

bool holds(const QWidget &place, const QWidget *widget)
{
    return widget && (widget == &place || place.isAncestorOf(widget));
}

// Then Enter is meant for that one.
bool hasDefaultButton(const QAbstractButton &button)
{
    const QWidget *at = &button;
    while (at && !qobject_cast<const QDialog *>(at))
        at = at->parentWidget();
    const auto buttons = at ? at->findChildren<QPushButton *>() : QList<QPushButton *>();
    return std::any_of(buttons.begin(), buttons.end(),
                       [](const QPushButton *each) { return each->isDefault() && each->isVisible(); });
}

}  // namespace

FocusGuard::FocusGuard(QWidget &window, QStackedWidget &pages, PanelArea &panels)
    : m_window(window)
    , m_pages(pages)
    , m_panels(panels)
{
    connect(qApp, &QApplication::focusChanged, this, &FocusGuard::follow);
}

// The keyboard wanders while the window's widgets are destroyed.
FocusGuard::~FocusGuard()
{
    qApp->disconnect(this);
}

QWidget *FocusGuard::place() const
{
    return m_panels.isOpen() ? m_panels.newest() : m_pages.currentWidget();
}

void FocusGuard::enterPage(Qt::FocusReason reason)
{
    QWidget *page = m_pages.currentWidget();
    if (page && page->isVisible() && !m_panels.isOpen())
        giveKeyboard(*page, reason);
}

void FocusGuard::leave(const QWidget &part)
{
    const QWidget *focus = QApplication::focusWidget();
    if (!focus || holds(part, focus))
        enterPage();
}

void FocusGuard::follow(QWidget *before, QWidget *now)
{
    if (m_button)
        m_button->removeEventFilter(this);
    m_button = now && now->window() == &m_window ? qobject_cast<QAbstractButton *>(now) : nullptr;
    if (m_button)
        m_button->installEventFilter(this);
    // Nobody chose to leave what cannot be used any more.
    const bool isTaken
        = before && before->window() == &m_window && !(before->isVisible() && before->isEnabled());
    m_isLost = isTaken || !now;
    if (!m_isLost)
        return;
    const QWidget *here = place();
    const bool inside = here && holds(*here, before);
    if (isTaken)
        settle(inside);
    // Once more when whatever goes on is over: other widgets may follow, a panel may close or open.
    m_isLost = true;
    QMetaObject::invokeMethod(
        this,
        [this, inside] {
            if (std::exchange(m_isLost, false))
                settle(inside);
        },
        Qt::QueuedConnection);
}

void FocusGuard::settle(bool inside)
{
    if (QApplication::activeWindow() != &m_window || QApplication::activePopupWidget())
        return;
    QWidget *here = place();
    if (!here || !here->isVisible() || !here->isEnabled())
        return;
    const QWidget *focus = QApplication::focusWidget();
    const bool isFine = focus && mayTakeKeyboard(*focus) && (!inside || holds(*here, focus));
    if (!isFine)
        giveKeyboard(*here);
}

bool FocusGuard::eventFilter(QObject *watched, QEvent *event)
{
    if (watched != m_button || event->type() != QEvent::KeyPress)
        return QObject::eventFilter(watched, event);
    auto *button = qobject_cast<QAbstractButton *>(watched);
    const auto *key = static_cast<QKeyEvent *>(event);
    const bool isEnter = (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter)
        && !(key->modifiers() & ~Qt::KeypadModifier);
    if (!button || !isEnter || hasDefaultButton(*button))
        return false;
    if (!key->isAutoRepeat())
        button->click();
    return true;
}
