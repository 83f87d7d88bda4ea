// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/elidedlabel.h"

using namespace Qt::StringLiterals;

ElidedLabel::ElidedLabel(QWidget *parent)
    : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
}

void ElidedLabel::setFullText(const QString &text, const QString &explanation, const QString &shorter)
{
    m_full = text;
    m_shorter = shorter;
    setToolTip(explanation.isEmpty() || text.isEmpty() ? text : text + u"\n\n"_s + explanation);
    setAccessibleName(text);
    elide();
    updateGeometry();
}

QSize ElidedLabel::sizeHint() const
{
    return {fontMetrics().horizontalAdvance(m_full) + 2, QLabel::sizeHint().height()};
}

QSize ElidedLabel::minimumSizeHint() const
{
    return {std::min(sizeHint().width(), fontMetrics().horizontalAdvance(u"00000000"_s)),
            QLabel::minimumSizeHint().height()};
}

void ElidedLabel::resizeEvent(QResizeEvent *event)
{
    QLabel::resizeEvent(event);
    elide();
}

void ElidedLabel::elide()
{
    const bool fits = m_shorter.isEmpty() || fontMetrics().horizontalAdvance(m_full) <= width();
    setText(fontMetrics().elidedText(fits ? m_full : m_shorter, Qt::ElideRight, width()));
}
