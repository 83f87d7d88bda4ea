// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/fullview.h"

#include "widgets/forms/panel.h"

#include <QBoxLayout>
#include <QEvent>

#include <utility>

FullView::FullView(QWidget &view)
    : m_view(view)
{
}

FullView::~FullView()
{
    if (!m_cover)
        return;
    m_area->window()->setWindowState(m_before);
    delete m_cover;  // the page goes, and its view with it
}

void FullView::setOn(bool on)
{
    if (on == isOn())
        return;
    if (on)
        enter();
    else
        leave();
    if (isOn() == on)
        emit changed(on);
}

void FullView::enter()
{
    QWidget *window = m_view.window();
    m_area = window->findChild<PanelArea *>();
    m_place = m_view.parentWidget();
    auto *layout = m_place ? qobject_cast<QBoxLayout *>(m_place->layout()) : nullptr;
    if (!m_area || !layout)
        return;
    m_index = layout->indexOf(&m_view);
    m_before = window->windowState();
    m_cover = new QWidget(m_area);
    auto *inside = new QVBoxLayout(m_cover);
    inside->setContentsMargins(0, 0, 0, 0);
    inside->addWidget(&m_view);
    m_cover->setGeometry(m_area->rect());
    m_area->installEventFilter(this);
    window->setWindowState(m_before | Qt::WindowFullScreen);
    m_cover->show();
    m_cover->raise();
    m_view.setFocus(Qt::OtherFocusReason);
}

void FullView::leave()
{
    QWidget *window = m_view.window();
    m_area->removeEventFilter(this);
    if (auto *layout = m_place ? qobject_cast<QBoxLayout *>(m_place->layout()) : nullptr)
        layout->insertWidget(m_index, &m_view, 1);
    // Not at once: who hides the page goes through its siblings, and the cover is one of them.
    m_cover->hide();
    std::exchange(m_cover, nullptr)->deleteLater();
    window->setWindowState(m_before);
    m_view.setFocus(Qt::OtherFocusReason);
}

bool FullView::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize && m_cover)
        m_cover->setGeometry(m_area->rect());
    return QObject::eventFilter(watched, event);
}
