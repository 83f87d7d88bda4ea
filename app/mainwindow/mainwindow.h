// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/pages/page.h"
#include "widgets/forms/reviewdialog.h"

#include <QMainWindow>
#include <QPointer>

class LinkBar;
class MessageBar;
class QListWidget;
class QStackedWidget;
class StartPage;
class StatusStrip;
class UnsavedBar;

/// The frame: link bar, messages, navigation, pages, unsaved bar, status.
class MainWindow final : public QMainWindow
{
    Q_OBJECT
public:
    MainWindow(TransportFactory transports, QList<Family> families, Theme &theme, QWidget *parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] Workspace &workspace() { return *m_workspace; }
    [[nodiscard]] LinkBar *linkBar() const { return m_linkBar; }
    [[nodiscard]] UnsavedBar *unsavedBar() const { return m_unsavedBar; }
    [[nodiscard]] MessageBar *messageBar() const { return m_messages; }
    [[nodiscard]] const QList<Page *> &pages() const { return m_pages; }
    [[nodiscard]] ReviewDialog *reviewDialog() const { return m_review; }

    void openLink(const QString &address);
    /// False if there is no such page.
    bool showPage(const QString &key);
    void review();

protected:
    void closeEvent(QCloseEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void addPage(Page *page);
    void addShortcuts();
    void updateMarks();
    void updateStart();

    std::unique_ptr<Workspace> m_workspace;
    LinkBar *m_linkBar;
    MessageBar *m_messages;
    QListWidget *m_navigation;
    QStackedWidget *m_stack;
    StartPage *m_start;
    UnsavedBar *m_unsavedBar;
    StatusStrip *m_status;
    QList<Page *> m_pages;
    QPointer<ReviewDialog> m_review;
};
