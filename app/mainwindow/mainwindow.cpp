// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/mainwindow.h"

#include "app/mainwindow/alarmbar.h"
#include "app/mainwindow/bannerarea.h"
#include "app/mainwindow/bars.h"
#include "app/mainwindow/contentarea.h"
#include "app/mainwindow/focusguard.h"
#include "app/mainwindow/footbar.h"
#include "app/mainwindow/languageswitch.h"
#include "app/mainwindow/leaving.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/messagehistory.h"
#include "app/mainwindow/motorskeys.h"
#include "app/mainwindow/navigation.h"
#include "app/mainwindow/pagetable.h"
#include "app/mainwindow/startpage.h"
#include "app/pages/program/helppage.h"
#include "app/pages/setup/guidepage.h"
#include "app/workspace/filedialogs.h"
#include "app/workspace/question.h"
#include "protocol/record/recording.h"
#include "widgets/forms/panel.h"
#include "widgets/forms/wheelguard.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLoggingCategory>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

Q_LOGGING_CATEGORY(logStart, "gimbal.start", QtWarningMsg)

namespace {

const QString kWindowLayout = u"window"_s;
constexpr QSize kContentSize(1024, 640);  // holds every page
constexpr int kAroundContent = 100;  // height of the link bar and the status at most

}  // namespace

MainWindow::MainWindow(Links links, QList<Family> families, Theme &theme, Settings &settings, QWidget *parent)
    : QMainWindow(parent)
    , m_workspace(std::make_unique<Workspace>(std::move(links), std::move(families), theme, settings))
    , m_keys(new MotorsKeys(*m_workspace, this))
    , m_leaving(new Leaving(*m_workspace, *this))
    , m_themeChoice(settings.theme())
{
    setWindowTitle(u"GimbalDesk"_s);
    new WheelGuard(this);
    takePlace(settings.layout(kWindowLayout));
    makeFrame();
    connectWorkspace();
    m_navigation->setCurrentPage(QLatin1String(pageTable().front().key));
    updateOffered();
    updateStart();
}

MainWindow::~MainWindow()
{
    m_panels->rejectAll();
    m_workspace->shutDown();
    // What that has ended arrives while those who wait for it are still there.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::MetaCall);
    delete m_focus;
    // Dialogs and pages refer to the workspace, which would otherwise be destroyed first.
    delete m_review;
    delete m_palette;
    delete m_keys;
    delete m_leaving;
    delete takeCentralWidget();
}

void MainWindow::layoutFrame()
{
    m_stack->addWidget(m_start);
    m_banners->add(*m_offers);
    m_banners->add(*m_messages, [this] { m_messages->closeNewest(); });
    auto *middle = new QHBoxLayout;
    middle->setContentsMargins(0, 0, 0, 0);
    middle->setSpacing(0);
    middle->addWidget(m_navigation);
    middle->addWidget(m_banners, 1);
    m_content = new QWidget;
    auto *contentLayout = new QVBoxLayout(m_content);
    contentLayout->setContentsMargins(0, 0, 0, 0);
    contentLayout->setSpacing(0);
    contentLayout->addWidget(m_replay);
    contentLayout->addLayout(middle, 1);
    contentLayout->addWidget(m_foot);
    const QSize smallest(kContentSize.width(), kContentSize.height() - kAroundContent);
    m_panels = new PanelArea(new ContentArea(*m_content, smallest));
    auto *central = new QWidget;
    auto *layout = new QVBoxLayout(central);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_linkBar);
    layout->addWidget(m_panels, 1);
    layout->addWidget(m_status);
    setCentralWidget(central);
    m_banners->giveWayTo(*new AlarmBar(m_workspace->alarms(), m_panels, smallest.height(),
                                       [this](const std::function<int(int width)> &heightFor) {
                                           return m_banners->freePlace(*m_panels, heightFor);
                                       }));
    m_focus = new FocusGuard(*this, *m_stack, *m_panels);
}

void MainWindow::connectFrame()
{
    Workspace *workspace = m_workspace.get();
    connect(&workspace->notifications(), &Notifications::problem, m_messages, &MessageBar::showProblem);
    connect(&workspace->notifications(), &Notifications::notice, m_messages, &MessageBar::showNotice);
    connect(&workspace->notifications(), &Notifications::withdrawn, m_messages, &MessageBar::withdraw);
    connect(&workspace->notifications(), &Notifications::offer, m_offers, &OfferBar::ask);
    connect(&workspace->notifications(), &Notifications::offerWithdrawn, m_offers, &OfferBar::withdraw);
    connect(&workspace->notifications(), &Notifications::boardReplaced, m_offers, &OfferBar::clear);
    Confirmations &confirmations = workspace->confirmations();
    connect(&confirmations, &Confirmations::asked, m_panels,
            [this, &confirmations](const Question &question, const std::function<void()> &over) {
                const QDialog *panel = askInPanel(question, this);
                connect(&confirmations, &Confirmations::withdrawn, panel, &QDialog::reject);
                connect(panel, &QDialog::finished, &confirmations, over, Qt::QueuedConnection);
            });
    connect(m_stack, &QStackedWidget::currentChanged, &confirmations, &Confirmations::withdraw);
    m_status->follow(*m_keys);
    m_keys->serve(*m_linkBar->motorsButton());
    connect(m_linkBar, &LinkBar::disconnectRequested, this, [this] {
        const auto disconnectNow = [this] { m_workspace->client().disconnectFromBoard(); };
        if (m_leaving->mayGo(Leaving::Way::Disconnect, disconnectNow))
            disconnectNow();
    });
    connect(m_panels, &PanelArea::openChanged, this, [this](bool open) { m_linkBar->setLinkEnabled(!open); });
    connect(m_unsavedBar, &UnsavedBar::reviewRequested, this, &MainWindow::review);
    connect(m_unsavedBar, &UnsavedBar::saveFileRequested, this, &MainWindow::askSaveFile);
    connect(m_start, &StartPage::connectRequested, this, [this] {
        m_linkBar->addressBox()->setFocus();
        m_linkBar->addressBox()->showPopup();
    });
    connect(m_start, &StartPage::fileRequested, this, &MainWindow::askOpenFile);
    connect(m_start, &StartPage::leftoverRequested, this, &MainWindow::openFile);
    connect(m_start, &StartPage::addressRequested, this, &MainWindow::openLink);
    connect(m_start, &StartPage::pathRequested, this, &MainWindow::openFile);
    connect(m_start, &StartPage::demoRequested, this,
            [this] { openLink(u"sim:"_s + m_workspace->defaultFamily()); });
    connect(m_navigation, &Navigation::pageChosen, this, &MainWindow::updateStart);
}

void MainWindow::connectWorkspace()
{
    Workspace *workspace = m_workspace.get();
    connect(&workspace->configuration(), &ConfigurationModel::boardReset, this, &MainWindow::updateStart);
    connect(&workspace->configuration(), &ConfigurationModel::boardReset, this, &MainWindow::updateOffered);
    connect(&workspace->client(), &DeviceClient::stateChanged, this, &MainWindow::updateOffered);
    connect(&workspace->configuration(), &ConfigurationModel::changeCountChanged, this,
            &MainWindow::updateMarks);
    connect(&workspace->edits().refused(), &RefusedTexts::changed, this, &MainWindow::updateMarks);
    connect(&workspace->client(), &DeviceClient::stateChanged, this, [this](DeviceClient::State state) {
        if (state == DeviceClient::State::Connecting) {
            m_messages->keepOnly({Concern::Start, Concern::Motors, Concern::Steering});
            m_offers->clear();
        }
        updateStart();
        if (state == DeviceClient::State::Connected)
            m_focus->leave(*m_linkBar);  // where a key would now disconnect
    });
    connect(&workspace->settings(), &Settings::changed, this, &MainWindow::applyTheme);
    connect(&workspace->naming(), &BoardNaming::asked, this, [this] { showPage(u"backups"_s); });
    const auto *language = new LanguageSwitch(
        workspace->settings(), [this] { return mayRenew(); }, this);
    connect(language, &LanguageSwitch::due, this, &MainWindow::languageDue);
}

void MainWindow::openLink(const QString &address)
{
    m_linkBar->setAddress(address);
    const auto parsed = LinkAddress::parse(address);
    if (!parsed) {
        m_workspace->notifications().report(parsed.error());
        return;
    }
    m_workspace->connectTo(*parsed);
}

void MainWindow::openFile(const QString &path)
{
    if (m_workspace->client().isConnected() && Recording::describe(path)) {
        const auto play = [this, path] {
            m_workspace->client().disconnectFromBoard();
            openFile(path);
        };
        if (m_workspace->client().address().isReplay())
            return play();  // nothing of it is lost
        askInPanel({tr("Play a recording?"),
                    tr("The link to the board ends before it is played."),
                    {{tr("Disconnect and play"),
                      [this, play] {
                          if (m_leaving->mayGo(Leaving::Way::Disconnect, play))
                              play();
                      }}},
                    tr("Stay connected")},
                   this);
        return;
    }
    // With a board, a configuration is loaded as edits of it.
    const bool isEdit = m_workspace->client().isConnected();
    if (const auto opened = isEdit ? m_workspace->applyFile(path) : m_workspace->openFile(path);
        !m_workspace->notifications().reportLoaded(opened))
        return;
    m_workspace->settings().addRecentFile(path);
    if (isEdit || !m_workspace->offlineFile().isEmpty())
        showPage(u"parameters"_s);
}

void MainWindow::askOpenFile()
{
    askOpenPath(
        this, tr("Open a configuration or a recording"), m_workspace->openFilter(),
        [this](const QString &path) { openFile(path); }, BoardHistory::defaultRoot());
}

void MainWindow::askSaveFile()
{
    askSavePath(this, tr("Save the configuration"), u"gimbal.json"_s, m_workspace->configurationFilter(),
                [this](const QString &path) {
                    m_workspace->notifications().reportSaved(m_workspace->saveFile(path), path,
                                                             m_workspace->lacking());
                });
}

Page *MainWindow::page(const QString &key)
{
    if (Page *made = m_pages.value(key))
        return made;
    for (const PageEntry &entry : pageTable()) {
        if (key != QLatin1String(entry.key))
            continue;
        Page *made = entry.make(*m_workspace);
        m_pages.insert(key, made);
        m_stack->addWidget(made);
        // Rows measured before the style sheet applied would keep their height.
        for (auto *view : made->findChildren<QAbstractItemView *>()) {
            view->ensurePolished();
            view->doItemsLayout();
        }
        connect(made, &Page::changesChanged, this, &MainWindow::updateMarks);
        connect(made, &Page::actionWanted, this, &MainWindow::showAction);
        connect(made, &Page::pageWanted, this, &MainWindow::showPage);
        connect(made, &Page::setupStepWanted, this, [this](SetupStep step) {
            if (showPage(u"guide"_s))
                static_cast<GuidePage *>(page(u"guide"_s))->choose(step);
        });
        return made;
    }
    return nullptr;
}

bool MainWindow::showPage(const QString &key)
{
    if (!page(key) || !m_navigation->isOffered(key))
        return false;
    m_navigation->setCurrentPage(key);
    return true;
}

bool MainWindow::enterPage(const QString &key)
{
    if (!showPage(key))
        return false;
    m_focus->enterPage(Qt::ShortcutFocusReason);
    return true;
}

// Pages that the board shown has no use for are not offered.
void MainWindow::updateOffered()
{
    for (const PageEntry &entry : pageTable())
        m_navigation->setOffered(QLatin1String(entry.key), isOffered(entry, *m_workspace));
    const bool isConnected = m_workspace->client().isConnected();
    const QString awaited = isConnected ? m_navigation->takeAwaited() : QString();
    const QString wanted = awaited.isEmpty() ? m_navigation->currentPage() : awaited;
    if (m_navigation->isOffered(wanted) || showPage(m_navigation->offeredInPlaceOf(wanted)))
        return;
    if (!m_navigation->isOffered(m_navigation->currentPage()))
        showPage(QLatin1String(pageTable().front().key));
    if (isConnected)
        m_workspace->notifications().notify(
            tr("This board has no page “%1”. It has: %2.")
                .arg(m_navigation->titleOf(wanted), m_navigation->offeredTitles().join(u", "_s)),
            awaited.isEmpty() ? Notice::Hint : Notice::Attention);
}

// Pages are shown with the first board or file; until then, one card says how to begin.
void MainWindow::updateStart()
{
    const QString key = m_navigation->currentPage();
    const bool needsBoard = key != u"gamepad"_s && key != u"settings"_s && key != u"help"_s;
    const bool begin
        = needsBoard && m_workspace->configuration().isEmpty() && !m_workspace->client().isConnected();
    QWidget *wanted = begin ? static_cast<QWidget *>(m_start) : page(key);
    if (!wanted || m_stack->currentWidget() == wanted)
        return;
    m_stack->setCurrentWidget(wanted);
    m_focus->leave(*m_stack);
}

void MainWindow::updateMarks()
{
    const ConfigurationModel &model = m_workspace->configuration();
    m_navigation->setMarked(u"parameters"_s,
                            !model.isEmpty()
                                && (!model.changes().empty() || m_workspace->edits().refused().count() > 0));
    m_navigation->setMarked(u"profiles"_s, !model.isEmpty() && model.namesChanged());
    for (auto it = m_pages.begin(); it != m_pages.end(); ++it) {
        if (it.key() != u"parameters"_s && it.key() != u"profiles"_s)
            m_navigation->setMarked(it.key(), it.value()->hasChanges());
    }
}

void MainWindow::showHelp()
{
    const bool start = m_stack->currentWidget() == m_start;
    const QString topic = start ? u"start"_s : m_navigation->currentPage();
    if (auto *help = qobject_cast<HelpPage *>(page(u"help"_s))) {
        if (topic != u"help"_s)
            help->showTopic(topic);
        enterPage(u"help"_s);
    }
}

void MainWindow::applyTheme()
{
    const Settings::ThemeChoice choice = m_workspace->settings().theme();
    if (choice == std::exchange(m_themeChoice, choice))
        return;
    Theme &theme = m_workspace->theme();
    theme.setMode(choice == Settings::ThemeChoice::Light      ? Theme::Mode::Light
                      : choice == Settings::ThemeChoice::Dark ? Theme::Mode::Dark
                                                              : Theme::Mode::System);
    theme.apply();
}

void MainWindow::paintEvent(QPaintEvent *event)
{
    QMainWindow::paintEvent(event);
    static bool first = true;
    if (std::exchange(first, false))
        qCDebug(logStart) << "first paint";
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    m_panels->rejectAll();
    const auto closeNow = [this] {
        m_mayClose = true;
        close();
    };
    if (!m_mayClose && !m_leaving->mayGo(Leaving::Way::Quit, closeNow)) {
        event->ignore();
        return;
    }
    m_workspace->settings().setLayout(kWindowLayout, saveGeometry());
    m_workspace->journal().flush();
    m_workspace->client().disconnectFromBoard();
    QMainWindow::closeEvent(event);
}
