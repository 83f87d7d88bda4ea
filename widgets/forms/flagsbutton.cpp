// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/flagsbutton.h"

#include <QEvent>

namespace {

constexpr int kFrameAndArrow = 34;  // what the style sheet leaves no room for text in

}  // namespace

FlagsButton::FlagsButton(QWidget *parent)
    : QPushButton(parent)
{
    setProperty("field", true);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    setMinimumWidth(96);
}

void FlagsButton::setWords(const QString &words)
{
    m_words = words;
    fit();
}

void FlagsButton::resizeEvent(QResizeEvent *event)
{
    QPushButton::resizeEvent(event);
    fit();
}

void FlagsButton::changeEvent(QEvent *event)
{
    QPushButton::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        fit();
}

void FlagsButton::fit()
{
    QString text = fontMetrics().elidedText(m_words, Qt::ElideRight, std::max(0, width() - kFrameAndArrow));
    setText(text.replace(u'&', QStringLiteral("&&")));
}
