// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/mainwindow/commandpalette.h"
#include "app/mainwindow/replaybar.h"
#include "app/workspace/page.h"
#include "widgets/forms/reviewdialog.h"

#include <QMainWindow>
#include <QPointer>

class BannerArea;
class EditGuide;
class FocusGuard;
class FootBar;
class Leaving;
class LinkBar;
class MessageBar;
class MotorsKeys;
class Navigation;
class OfferBar;
class PanelArea;
class QStackedWidget;
class StartPage;
class StatusStrip;
class UnsavedBar;
class UnstoredBar;

/// The frame: link bar, messages, navigation, pages, unsaved bar, status. Pages are made when they are first
/// shown.
class MainWindow final : public QMainWindow
{
    Q_OBJECT
public:
    MainWindow(Links links, QList<Family> families, Theme &theme, Settings &settings,
               QWidget *parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] Workspace &workspace() { return *m_workspace; }
    [[nodiscard]] UnsavedBar *unsavedBar() const { return m_unsavedBar; }
    [[nodiscard]] MessageBar *messageBar() const { return m_messages; }
    [[nodiscard]] OfferBar *offerBar() const { return m_offers; }
    [[nodiscard]] Navigation *navigation() const { return m_navigation; }
    [[nodiscard]] ReplayBar *replayBar() const { return m_replay; }
    [[nodiscard]] PanelArea *panels() const { return m_panels; }
    [[nodiscard]] ReviewDialog *reviewDialog() const { return m_review; }
    [[nodiscard]] CommandPalette *commandPalette() const { return m_palette; }

    void openLink(const QString &address);
    /// Opens a configuration: without a board to look at, with one as edits of it. Plays a recording, after
    /// asking where that ends a link.
    void openFile(const QString &path);
    /// All of the window in the language that is installed now: pages are made anew, and go on with what they
    /// kept. The link, edits, and what runs on the board know nothing of it.
    void renew();
    /// The page with that key, made if need be; null if there is none.
    Page *page(const QString &key);
    /// False if there is no such page.
    bool showPage(const QString &key);
    /// Shows it and leads the keyboard into it.
    bool enterPage(const QString &key);
    /// Shows the page of actions with this one.
    void showAction(const QString &key);
    void review();
    void showPalette();
    /// The help text of the page that is shown.
    void showHelp();

signals:
    /// The operator has chosen another language, and nothing is in its way: its catalogues are to be
    /// installed, which renews the window.
    void languageDue(const QString &code);

protected:
    void changeEvent(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void takePlace(const QByteArray &saved);
    void keepOnScreen();
    void makeFrame();
    void layoutFrame();
    void connectFrame();
    void connectWorkspace();
    [[nodiscard]] bool mayRenew() const;
    void addShortcuts();
    void updateMarks();
    void updateStart();
    void updateOffered();
    void askOpenFile();
    void askSaveFile();
    void applyTheme();

    std::unique_ptr<Workspace> m_workspace;
    LinkBar *m_linkBar = nullptr;
    ReplayBar *m_replay = nullptr;
    MessageBar *m_messages = nullptr;
    OfferBar *m_offers = nullptr;
    Navigation *m_navigation = nullptr;
    QStackedWidget *m_stack = nullptr;
    BannerArea *m_banners = nullptr;
    StartPage *m_start = nullptr;
    UnsavedBar *m_unsavedBar = nullptr;
    UnstoredBar *m_unstoredBar = nullptr;
    FootBar *m_foot = nullptr;
    StatusStrip *m_status = nullptr;
    QWidget *m_content = nullptr;
    PanelArea *m_panels = nullptr;
    FocusGuard *m_focus = nullptr;
    MotorsKeys *m_keys;
    Leaving *m_leaving;
    EditGuide *m_guide = nullptr;
    Settings::ThemeChoice m_themeChoice;
    QHash<QString, Page *> m_pages;
    QPointer<ReviewDialog> m_review;
    QPointer<CommandPalette> m_palette;
    bool m_mayClose = false;
    bool m_isPlaced = false;
    QMetaObject::Connection m_room;  // how much of the screen can be used
    bool m_isRenewed = false;  // or will be at once
};
