// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/keyboard.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QRadioButton>

namespace {

constexpr const char *kHarmless = "harmless";

bool isAnyButton(const QWidget &widget)
{
    return qobject_cast<const QAbstractButton *>(&widget) && !qobject_cast<const QCheckBox *>(&widget)
        && !qobject_cast<const QRadioButton *>(&widget);
}

}  // namespace

void setHarmless(QAbstractButton &button, bool harmless)
{
    button.setProperty(kHarmless, harmless);
}

bool mayTakeKeyboard(const QWidget &widget)
{
    return widget.isVisible() && widget.isEnabled()
        && (!isAnyButton(widget) || widget.property(kHarmless).toBool());
}

void giveKeyboard(QWidget &place, Qt::FocusReason reason)
{
    QWidget *last = place.focusWidget();
    if (last && last != &place && mayTakeKeyboard(*last)) {
        last->setFocus(reason);
        return;
    }
    QWidget *button = nullptr;
    for (QWidget *next = place.nextInFocusChain(); next != &place; next = next->nextInFocusChain()) {
        if (!place.isAncestorOf(next) || !(next->focusPolicy() & Qt::TabFocus) || next->focusProxy()
            || !mayTakeKeyboard(*next))
            continue;
        if (!isAnyButton(*next)) {
            next->setFocus(reason);
            return;
        }
        if (!button)
            button = next;
    }
    (button ? button : &place)->setFocus(reason);
}
