// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/stalecover.h"

#include <QAbstractScrollArea>
#include <QEvent>
#include <QHeaderView>
#include <QPainter>
#include <QSplitter>

#include <algorithm>

using namespace Qt::StringLiterals;

StaleCover::StaleCover(const Theme &theme, QWidget &view, Look look)
    : QWidget(&view)
    , m_theme(theme)
    , m_look(look)
    , m_area([&view] { return view.rect(); })
{
    Q_ASSERT(!qobject_cast<QSplitter *>(&view));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    view.installEventFilter(this);
    hide();
}

StaleCover::StaleCover(const Theme &theme, QAbstractScrollArea &table, const QHeaderView &header, int column)
    : StaleCover(theme, table, Look::Fade)
{
    m_area = [&table, &header, column] {
        const QRect cells = table.viewport()->geometry();
        return QRect(cells.x() + header.sectionViewportPosition(column), cells.y(),
                     header.sectionSize(column), cells.height())
            & cells;
    };
    connect(&header, &QHeaderView::sectionResized, this, &StaleCover::place);
    connect(&header, &QHeaderView::geometriesChanged, this, &StaleCover::place);
    table.viewport()->installEventFilter(this);
}

void StaleCover::place()
{
    setGeometry(m_area());
}

void StaleCover::setText(const QString &text)
{
    if (text == m_text && isHidden() == text.isEmpty())
        return;
    m_text = text;
    setAccessibleName(text);
    setToolTip(text);
    setVisible(!text.isEmpty());
    if (text.isEmpty())
        return;
    place();
    raise();
    update();
}

bool StaleCover::isOver(const QWidget &view)
{
    const auto covers = view.findChildren<StaleCover *>(Qt::FindDirectChildrenOnly);
    return std::any_of(covers.begin(), covers.end(), [](const StaleCover *cover) {
        return cover->m_look == Look::Veil && !cover->isHidden();
    });
}

bool StaleCover::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize)
        place();
    return QWidget::eventFilter(watched, event);
}

void StaleCover::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_look != Look::Tag) {
        QColor veil = m_theme.color(ColorRole::Surface);
        veil.setAlpha(190);
        painter.fillRect(rect(), veil);
    }
    if (m_look == Look::Fade)
        return;
    const QFontMetrics metrics = painter.fontMetrics();
    const QString text = metrics.elidedText(m_text, Qt::ElideLeft, width() - 2 * Metric::kGap);
    QRect tag(0, 0, metrics.horizontalAdvance(text) + 2 * Metric::kGap, metrics.height() + Metric::kGap);
    if (m_look == Look::Veil)
        tag.moveCenter(rect().center());
    else
        tag.moveTopRight(rect().topRight() + QPoint(-Metric::kGap, Metric::kGap));
    painter.setPen(QPen(m_theme.color(ColorRole::Warning), 1));
    painter.setBrush(m_theme.color(ColorRole::Surface));
    painter.drawRoundedRect(tag, 4, 4);
    painter.drawText(tag, Qt::AlignCenter, text);
}
