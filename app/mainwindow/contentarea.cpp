// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/contentarea.h"

namespace {

// Without a layout: for one with texts that wrap, a scroll area makes as much room as it would like to have.
class ContentHolder final : public QWidget
{
public:
    explicit ContentHolder(QWidget &content)
        : m_content(content)
    {
        content.setParent(this);
    }

protected:
    void resizeEvent(QResizeEvent *) override { m_content.setGeometry(rect()); }

private:
    QWidget &m_content;
};

}  // namespace

ContentArea::ContentArea(QWidget &content, const QSize &smallest, QWidget *parent)
    : QScrollArea(parent)
{
    auto *holder = new ContentHolder(content);
    holder->setMinimumSize(smallest);
    setWidgetResizable(true);
    setFocusPolicy(Qt::NoFocus);
    setWidget(holder);
}
