// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/flagsbutton.h"

#include <QStyleOptionButton>
#include <QStylePainter>

namespace {

constexpr int kBeforeWords = 8;  // as in a choice
constexpr int kArrow = 26;

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
    QString text = words;
    setText(text.replace(u'&', QStringLiteral("&&")));
    update();
}

// The style neither shortens the text of a button nor keeps it off a left edge.
void FlagsButton::paintEvent(QPaintEvent *)
{
    QStylePainter painter(this);
    QStyleOptionButton option;
    initStyleOption(&option);
    option.text.clear();
    painter.drawControl(QStyle::CE_PushButton, option);
    const bool muted = !isEnabled() || property("inactive").toBool();
    painter.setPen(palette().color(muted ? QPalette::PlaceholderText : QPalette::WindowText));
    const QRect room = rect().adjusted(kBeforeWords, 0, -kArrow, 0);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(m_words, Qt::ElideRight, room.width()));
}
