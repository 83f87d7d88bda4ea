// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/cardlabels.h"

#include "widgets/theme/theme.h"

#include <QLabel>

QLabel *wrappedLabel(const QString &text, const char *look)
{
    auto *label = new QLabel(text);
    label->setObjectName(QLatin1String(look));
    label->setWordWrap(true);
    return label;
}

void sayIn(QLabel &label, const QString &text, const char *look)
{
    label.setText(text);
    label.setObjectName(QLatin1String(look));
    label.setVisible(!text.isEmpty());
    repolish(&label);
}
