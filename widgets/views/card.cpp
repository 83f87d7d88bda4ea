// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/card.h"

#include "widgets/theme/theme.h"

#include <QLabel>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

Card::Card(const QString &title, QWidget *parent)
    : QFrame(parent)
    , m_content(new QVBoxLayout(this))
{
    setObjectName(u"card"_s);
    m_content->setContentsMargins(Metric::kMargin, 12, Metric::kMargin, Metric::kMargin);
    m_content->setSpacing(Metric::kGap);
    if (title.isEmpty())
        return;
    auto *label = new QLabel(title);
    label->setObjectName(u"section"_s);
    m_content->addWidget(label);
}
