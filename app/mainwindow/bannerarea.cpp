// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bannerarea.h"

#include "widgets/theme/theme.h"

#include <QApplication>
#include <QCursor>
#include <QKeyEvent>
#include <QShortcut>
#include <QVBoxLayout>

#include <algorithm>

BannerArea::BannerArea(QWidget &page, QWidget *parent)
    : QWidget(parent)
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(&page);
    connect(new QShortcut(QKeySequence(Qt::CTRL | Qt::Key_F6), this), &QShortcut::activated, this,
            &BannerArea::jump);
    connect(qApp, &QApplication::focusChanged, this, &BannerArea::followFocus);
}

// The keyboard wanders while its children are destroyed.
BannerArea::~BannerArea()
{
    qApp->disconnect(this);
}

void BannerArea::add(QWidget &banner, Closing closing)
{
    banner.setParent(this);
    banner.hide();
    banner.installEventFilter(this);
    m_banners.push_back({&banner, closing});
}

bool BannerArea::eventFilter(QObject *watched, QEvent *event)
{
    auto *widget = qobject_cast<QWidget *>(watched);
    switch (event->type()) {
    case QEvent::ShowToParent: appear(widget); break;
    case QEvent::HideToParent:
        std::erase_if(m_shown, [widget](const Banner &banner) { return banner.widget == widget; });
        break;
    case QEvent::LayoutRequest: place(); break;
    default: break;
    }
    return QWidget::eventFilter(watched, event);
}

void BannerArea::appear(QWidget *widget)
{
    const auto known = std::find_if(m_banners.begin(), m_banners.end(),
                                    [widget](const Banner &banner) { return banner.widget == widget; });
    std::erase_if(m_shown, [widget](const Banner &banner) { return banner.widget == widget; });
    const bool isFirst = m_shown.empty();
    m_shown.push_back(*known);
    place();
    if (!isFirst)
        return;
    const bool lower = isInUse(room(false)) && !isInUse(room(true));
    if (lower != m_lower) {
        m_lower = lower;
        place();
    }
}

int BannerArea::heightOf(const QWidget &widget) const
{
    const int width = std::min(this->width() - 2 * Metric::kMargin, widget.maximumWidth());
    return widget.hasHeightForWidth() ? widget.heightForWidth(width) : widget.sizeHint().height();
}

// Each behind the one before it, and never nearer to the edge than it was.
void BannerArea::place()
{
    int next = Metric::kGap;
    for (Banner &banner : m_shown) {
        banner.offset = std::max(banner.offset, next);
        const int height = heightOf(*banner.widget);
        const int y = m_lower ? this->height() - banner.offset - height : banner.offset;
        const int wide = std::min(width() - 2 * Metric::kMargin, banner.widget->maximumWidth());
        banner.widget->setGeometry(width() - Metric::kMargin - wide, y, wide, height);
        banner.widget->raise();
        next = banner.offset + height + Metric::kGap;
    }
}

QRect BannerArea::room(bool lower) const
{
    int deep = 0;
    for (const Banner &banner : m_shown)
        deep = std::max(deep, banner.offset + heightOf(*banner.widget));
    return {0, lower ? height() - deep : 0, width(), deep};
}

bool BannerArea::isPointerIn(const QRect &room) const
{
    return room.contains(mapFromGlobal(QCursor::pos()));
}

bool BannerArea::isInUse(const QRect &room) const
{
    const QWidget *focus = QApplication::focusWidget();
    const bool isHere = focus && focus->isVisible() && isAncestorOf(focus) && !holds(focus);
    return isPointerIn(room)
        || (isHere && room.intersects(QRect(focus->mapTo(this, QPoint()), focus->size())));
}

bool BannerArea::holds(const QWidget *widget) const
{
    return std::any_of(m_banners.begin(), m_banners.end(), [widget](const Banner &banner) {
        return widget && (banner.widget == widget || banner.widget->isAncestorOf(widget));
    });
}

// Out of the way of the keyboard, but never from under the pointer; and back to the page from a banner that
// has gone.
void BannerArea::followFocus(QWidget *before, QWidget *now)
{
    if (holds(now) && !holds(before))
        m_before = before;
    if (holds(before) && !before->isVisible() && m_before && m_before->isVisible() && now != m_before) {
        m_before->setFocus(Qt::OtherFocusReason);
        return;
    }
    if (m_shown.empty() || holds(now) || isPointerIn(room(m_lower)))
        return;
    if (isInUse(room(m_lower)) && !isInUse(room(!m_lower))) {
        m_lower = !m_lower;
        place();
    }
}

void BannerArea::jump()
{
    if (holds(QApplication::focusWidget())) {
        if (m_before)
            m_before->setFocus(Qt::ShortcutFocusReason);
        return;
    }
    if (m_shown.empty())
        return;
    const QWidget *newest = m_shown.back().widget;
    for (QWidget *child : newest->findChildren<QWidget *>()) {
        if (child->isVisible() && child->isEnabled() && (child->focusPolicy() & Qt::TabFocus)) {
            child->setFocus(Qt::ShortcutFocusReason);
            return;
        }
    }
}

void BannerArea::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    place();
}

void BannerArea::keyPressEvent(QKeyEvent *event)
{
    const auto newest = std::find_if(m_shown.rbegin(), m_shown.rend(),
                                     [](const Banner &banner) { return banner.closing == Closing::ByEsc; });
    if (event->key() == Qt::Key_Escape && newest != m_shown.rend())
        newest->widget->hide();
    else
        QWidget::keyPressEvent(event);
}
