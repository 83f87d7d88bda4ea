// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QWidget>

/// What an operator finds under this name below a window or page: by the accessible name, or by the text on a
/// button.
template <typename W> W *named(const QWidget *where, const QString &name)
{
    for (W *widget : where->findChildren<W *>()) {
        if (widget->accessibleName() == name)
            return widget;
        const auto *button = qobject_cast<const QAbstractButton *>(widget);
        if (button && button->text().remove(u'&') == name)
            return widget;
    }
    qFatal("there is no '%s' in %s", qPrintable(name), where->metaObject()->className());
}
