// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/formrows.h"

#include <QFormLayout>
#include <QWidget>

void alignLabels(QFormLayout &form)
{
    for (int row = 0; row < form.rowCount(); ++row) {
        const QLayoutItem *field = form.itemAt(row, QFormLayout::FieldRole);
        const QLayoutItem *label = form.itemAt(row, QFormLayout::LabelRole);
        if (field && label && label->widget())
            label->widget()->setMinimumHeight(field->sizeHint().height());
    }
}
