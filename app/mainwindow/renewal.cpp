// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The main window in another language: everything in it is made anew around the same workspace.
#include "app/mainwindow/bannerarea.h"
#include "app/mainwindow/bars.h"
#include "app/mainwindow/focusguard.h"
#include "app/mainwindow/footbar.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/mainwindow.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/navigation.h"
#include "app/mainwindow/replaybar.h"
#include "app/mainwindow/startpage.h"
#include "widgets/forms/panel.h"

#include <QApplication>
#include <QEvent>
#include <QStackedWidget>
#include <QTimer>

#include <algorithm>
#include <any>
#include <utility>

using namespace Qt::StringLiterals;

void MainWindow::makeFrame()
{
    m_linkBar = new LinkBar(*m_workspace);
    m_replay = new ReplayBar(*m_workspace);
    m_messages = new MessageBar;
    m_offers = new OfferBar;
    m_navigation = new Navigation;
    m_stack = new QStackedWidget;
    m_banners = new BannerArea(*m_stack);
    m_start = new StartPage;
    m_unsavedBar = new UnsavedBar(*m_workspace);
    m_unstoredBar = new UnstoredBar(*m_workspace);
    m_foot = new FootBar(*m_workspace, {m_unstoredBar, m_unsavedBar});
    m_status = new StatusStrip(*m_workspace);
    layoutFrame();
    connectFrame();
    addShortcuts();
    m_start->setLeftovers(m_workspace->history().unsavedBases());
    m_start->setRecent(m_workspace->settings().recentAddresses(), m_workspace->settings().recentFiles());
    page(u"console"_s);  // it lists each link from its beginning
}

bool MainWindow::mayRenew() const
{
    const bool isUnderWay
        = std::any_of(m_pages.begin(), m_pages.end(), [](const Page *page) { return page->isUnderWay(); });
    return !isUnderWay && !m_workspace->client().isBusy() && !m_workspace->isWriting()
        && !m_workspace->isAtWork() && !m_workspace->isGuided() && !m_panels->isOpen()
        && !QApplication::activePopupWidget() && !QApplication::activeModalWidget();
}

void MainWindow::renew()
{
    const QString shown = m_navigation->currentPage();
    QHash<QString, std::any> kept;
    for (auto it = m_pages.begin(); it != m_pages.end(); ++it)
        kept.insert(it.key(), it.value()->keep());
    const QList<Offer> open = m_offers->open();
    const QList<MessageBar::Message> told = m_messages->messages();
    m_pages.clear();
    delete m_focus;
    delete takeCentralWidget();
    makeFrame();
    m_linkBar->setAddress(m_workspace->client().addressText());
    for (const Offer &offer : open)
        m_offers->ask(offer);
    m_messages->show(told);
    updateOffered();
    m_navigation->setCurrentPage(shown);
    for (auto it = kept.begin(); it != kept.end(); ++it) {
        if (it.value().has_value())
            page(it.key())->resume(it.value());
    }
    updateStart();
    updateMarks();
}

void MainWindow::changeEvent(QEvent *event)
{
    QMainWindow::changeEvent(event);
    // Told once for each catalogue, and each time before the next one is there.
    if (event->type() == QEvent::LanguageChange && m_panels && !std::exchange(m_isRenewed, true)) {
        QTimer::singleShot(0, this, [this] {
            renew();
            m_isRenewed = false;
        });
    }
}
