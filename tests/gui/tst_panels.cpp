// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/navigation.h"
#include "app/mainwindow/translations.h"
#include "app/pages/board/backupspage.h"
#include "app/pages/setup/profilespage.h"
#include "app/pages/tune/spectrumpage.h"
#include "app/pages/watch/monitorpage.h"
#include "app/workspace/question.h"
#include "tests/support/named.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/panel.h"

#include <QDialog>
#include <QDirIterator>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTableView>
#include <QTableWidget>

using namespace Qt::StringLiterals;

namespace {

const QString kDemo = u"sim:simplebgc"_s;

/// A place in the sources that opens a panel, and what these tests call what it opens.
struct PanelSite
{
    const char *name;
    const char *place;  // file and function
};
constexpr PanelSite kSites[]{
    {"review", "app/mainwindow/mainwindow.cpp review"},
    {"palette", "app/mainwindow/mainwindow.cpp showPalette"},
    {"unsaved", "app/mainwindow/leaving.cpp askAboutEdits"},
    {"unstored", "app/mainwindow/leaving.cpp askAboutValues"},
    {"work", "app/mainwindow/leaving.cpp askAboutWork"},
    {nullptr, "app/mainwindow/leaving.cpp askAboutMotors"},  // comes when they were told off just now
    {nullptr, "app/mainwindow/bars.cpp goBack"},  // not on this board
    {"play", "app/mainwindow/mainwindow.cpp openFile"},
    {"start", "app/workspace/question.cpp askToStartMotors"},
    {"switch", "app/workspace/question.cpp askToUseProfile"},
    {"limp", "app/workspace/question.cpp askForMotorsOff"},
    {"streams", "app/pages/watch/monitorpage.cpp askStreams"},
    {"layout", "app/pages/watch/monitorpage.cpp askLayoutName"},
    {"publish", "app/pages/watch/monitorpage.cpp askPublish"},
    {"share", "app/pages/board/backupspage.cpp makeHeader"},
    {"name", "app/pages/board/backupspage.cpp askName"},
    {"notch", "app/pages/tune/spectrumpage.cpp askNotch"},
    {"profile", "app/pages/setup/profilespage.cpp loadInto"},
};

/// Every function that opens a panel, with its file.
QStringList panelSites()
{
    static const QRegularExpression start(u"^\\w.*?(\\w+)\\([^;]*$"_s);
    static const QRegularExpression opens(u"(openPanel|askInPanel)\\("_s);
    const QDir root(QStringLiteral(GIMBAL_SOURCE_DIR));
    QStringList found;
    for (const QString &folder : {u"app"_s, u"widgets"_s}) {
        QDirIterator it(root.filePath(folder), {u"*.cpp"_s}, QDir::Files, QDirIterator::Subdirectories);
        while (it.hasNext()) {
            QFile file(it.next());
            const QString path = root.relativeFilePath(file.fileName());
            if (path == u"widgets/forms/panel.cpp"_s || !file.open(QIODevice::ReadOnly))
                continue;
            QString function;
            for (const QString &line : QString::fromUtf8(file.readAll()).split(u'\n')) {
                if (const auto match = start.match(line); match.hasMatch())
                    function = match.captured(1);
                else if (opens.match(line).hasMatch() && function != u"askInPanel"_s)
                    found.append(path + u' ' + function);
            }
        }
    }
    found.sort();
    return found;
}

}  // namespace

/// Dialogs lie over the content of the window and leave the button that switches the motors off in reach.
class TestPanels : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }
    void eachDialogIsTried();
    void motorsGoOffBeneathEachDialog_data() { addRows(true); }
    void motorsGoOffBeneathEachDialog();
    void keysStopThemInEachDialog_data() { addRows(false); }
    void keysStopThemInEachDialog();
    void stopIsKeptBeneathEachDialog_data() { addRows(false); }
    void stopIsKeptBeneathEachDialog();
    void stopOutrunsAStartThatWaits();
    void motorsGoOffBesideAnOpenMenu();
    void windowsWouldBlockThem();
    void contentIsOutOfReach();
    void focusComesBack();
    void smallWindowHoldsThem();
    void redButtonStaysInSight_data();
    void redButtonStaysInSight();
    void closingTheWindowAsksOnceMore();
    void stopIsKeptUntilThereIsALink_data();
    void stopIsKeptUntilThereIsALink();

private:
    MainWindow &window() { return m_rig->window(); }
    Workspace &workspace() { return m_rig->workspace(); }
    QPushButton *motors() { return window().findChild<QPushButton *>(u"motors"_s); }
    bool motorsAre(bool running)
    {
        return QTest::qWaitFor([&] { return workspace().motorsRunning() == running; }, 15000);
    }
    /// A click as the window system sends it: a window that is blocked gets none.
    void click(QWidget *widget)
    {
        QTest::mouseClick(window().windowHandle(), Qt::LeftButton, {},
                          widget->mapTo(&window(), widget->rect().center()));
    }
    /// Opens that dialog the operator's way; null if none came.
    QDialog *open(const QString &name);
    void chooseInMenu(const QString &text);
    void addRows(bool withSlow);
    bool isLiveValueSet();
    bool isRecorded();
    void tidy();

    std::unique_ptr<WindowRig> m_rig;
};

void TestPanels::chooseInMenu(const QString &text)
{
    for (QMenu *menu : m_rig->page<MonitorPage>()->findChildren<QMenu *>()) {
        emit menu->aboutToShow();
        for (QAction *action : menu->actions()) {
            if (action->text() == text) {
                action->trigger();
                return;
            }
        }
    }
}

bool TestPanels::isLiveValueSet()
{
    LiveModel &live = workspace().live();
    if (live.changeCount() > 0)
        return true;
    const int id = m_rig->spec(u"pid.yaw.p"_s).id;
    if (!QTest::qWaitFor([&live] { return !live.parameters().isEmpty(); }, 8000))
        return false;
    live.read();
    if (!QTest::qWaitFor([&live, id] { return live.value(id).has_value(); }, 8000))
        return false;
    live.setValue(id, *live.value(id) + 1);
    return QTest::qWaitFor([&live] { return live.changeCount() == 1; }, 8000);
}

bool TestPanels::isRecorded()
{
    const QString path = m_rig->filePath(u"link.gimbalrec"_s);
    if (QFile::exists(path))
        return true;
    QSignalSpy saved(&workspace().recorder(), &LinkRecorder::finished);
    return workspace().recorder().savePast(path) && (saved.count() > 0 || saved.wait(8000));
}

// What was opened before leaves nothing behind.
void TestPanels::tidy()
{
    window().panels()->rejectAll();
    workspace().edits().discardAll();
    while (workspace().isAtWork())
        workspace().endWork();
}

QDialog *TestPanels::open(const QString &name)
{
    if (name == u"review"_s || name == u"unsaved"_s)
        m_rig->edit(u"pid.roll.p"_s, 0, 44);
    if (name == u"review"_s)
        window().review();
    else if (name == u"palette"_s)
        window().showPalette();
    else if (name == u"unsaved"_s)
        window().close();
    else if (name == u"streams"_s && window().showPage(u"monitor"_s))
        m_rig->page<MonitorPage>()->streamsButton()->click();
    else if (name == u"share"_s && window().showPage(u"backups"_s))
        m_rig->page<BackupsPage>()->findChild<QPushButton *>(u"share"_s)->click();
    else if (name == u"play"_s && isRecorded())
        window().openFile(m_rig->filePath(u"link.gimbalrec"_s));
    else if (name == u"start"_s)
        askToStartMotors(workspace(), &window());
    else if (name == u"limp"_s)
        askForMotorsOff(workspace(), &window(), [] {});
    else if (name == u"switch"_s)
        askToUseProfile(workspace(), 1, &window());
    else if (name == u"work"_s) {
        workspace().beginWork();
        window().close();
    } else if (name == u"unstored"_s && isLiveValueSet())
        window().close();
    else if (name == u"name"_s)
        named<QPushButton>(m_rig->page<BackupsPage>(), u"Which board…"_s)->click();
    else if (name == u"layout"_s)
        chooseInMenu(u"Keep this layout…"_s);
    else if (name == u"publish"_s)
        chooseInMenu(u"Send to PlotJuggler (UDP)…"_s);
    else if (name == u"profile"_s) {
        const QString path = m_rig->filePath(u"profiles.json"_s);
        if (!workspace().saveFile(path))
            return nullptr;
        m_rig->page<ProfilesPage>()->loadInto(path, 2);
    } else if (name == u"notch"_s) {
        // Gains that make the structure ring.
        m_rig->edit(u"pid.roll.p"_s, 0, 100);
        m_rig->edit(u"pid.roll.d"_s, 0, 60);
        QSignalSpy written(&workspace(), &Workspace::writeFinished);
        workspace().write(m_rig->model().edited());
        auto *page = m_rig->page<SpectrumPage>();
        const auto isOffered = [page] {
            for (int row = 0; row < page->peaks()->rowCount() && !page->notchButton()->isEnabled(); ++row)
                page->peaks()->selectRow(row);
            return page->notchButton()->isEnabled();
        };
        if (!QTest::qWaitFor([&written] { return written.count() > 0; }, 15000)
            || !QTest::qWaitFor(isOffered, 60000))
            return nullptr;
        page->notchButton()->click();
    }
    if (!QTest::qWaitFor([this] { return window().panels()->isOpen(); }, 5000))
        return nullptr;
    return window().panels()->findChild<QDialog *>();
}

void TestPanels::addRows(bool withSlow)
{
    QTest::addColumn<QString>("name");
    for (const PanelSite &site : kSites) {
        // A notch is offered after half a minute; its box is of the same kind as others.
        if (site.name && (withSlow || qstrcmp(site.name, "notch") != 0))
            QTest::newRow(site.name) << QString::fromLatin1(site.name);
    }
}

// A place that opens a panel and is not in the list above is not tried beneath: it belongs there.
void TestPanels::eachDialogIsTried()
{
    QStringList tried;
    for (const PanelSite &site : kSites)
        tried.append(QString::fromLatin1(site.place));
    tried.sort();
    QCOMPARE(panelSites().join(u'\n'), tried.join(u'\n'));
}

void TestPanels::motorsGoOffBeneathEachDialog()
{
    QFETCH(QString, name);
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    const QDialog *dialog = open(name);
    QVERIFY(dialog && dialog->isVisible());
    QVERIFY(motors()->isEnabled());
    QVERIFY(!motors()->geometry().isEmpty());
    click(motors());
    // In a hurry twice: they stay off, and the keyboard stays in the dialog.
    click(motors());
    QVERIFY(motorsAre(false));
    click(motors());
    QVERIFY(m_rig->boardGoesOn(1.0));
    QCOMPARE(workspace().motorsRunning(), false);
    QVERIFY(dialog->isVisible());
    QVERIFY(dialog->isAncestorOf(QApplication::focusWidget()));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QTRY_VERIFY(!window().panels()->isOpen());
    QTRY_VERIFY_WITH_TIMEOUT(motors()->isEnabled(), 5000);  // to switch them on
}

void TestPanels::keysStopThemInEachDialog()
{
    QFETCH(QString, name);
    QVERIFY(m_rig->open(kDemo));
    for (const Qt::Key key : {Qt::Key_F12, Qt::Key_Escape}) {
        workspace().setMotors(true);
        QVERIFY(motorsAre(true));
        const QPointer<QDialog> dialog = open(name);
        QVERIFY(dialog);
        QTest::keyPress(QApplication::focusWidget(), key);
        QVERIFY(motorsAre(false));
        // Esc has closed it as well, as ever; F12 means nothing else.
        QCOMPARE(window().panels()->isOpen(), key == Qt::Key_F12);
        QTest::keyRelease(&window(), key);
        tidy();
        QTRY_VERIFY(!dialog);
    }
    // Without a link nothing can be stopped, and that is said.
    workspace().setMotors(true);
    QVERIFY(motorsAre(true));
    const QDialog *dialog = open(name);
    QVERIFY(dialog);
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    QVERIFY(!motors()->isEnabled());
    QSignalSpy told(&workspace().notifications(), &Notifications::problem);
    QTest::keyClick(&window(), Qt::Key_F12);
    QTRY_COMPARE(told.count(), 1);
}

// By the button, F12, and Esc held: while a link that was lost comes back, and while one is being made.
void TestPanels::stopIsKeptBeneathEachDialog()
{
    QFETCH(QString, name);
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    QVERIFY(open(name));
    workspace().changeWorld(u"replug=1"_s);
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_COMPARE_WITH_TIMEOUT(m_rig->client().state(), DeviceClient::State::Reconnecting, 10000);
    QTRY_VERIFY(motors()->isEnabled());
    QSignalSpy kept(&workspace().notifications(), &Notifications::notice);
    click(motors());
    QCOMPARE(kept.count(), 1);
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected(), 20000);
    QVERIFY(motorsAre(false));
    tidy();
    workspace().setMotors(true);
    QVERIFY(motorsAre(true));
    QVERIFY(open(name));
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    window().openLink(kDemo);
    QCOMPARE(m_rig->client().state(), DeviceClient::State::Connecting);
    QVERIFY(motors()->isEnabled());
    kept.clear();
    click(motors());
    QCOMPARE(kept.count(), 1);
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected(), 20000);
    QVERIFY(motorsAre(false));
}

// The worker is busy, and the start waits for its turn: a stop that comes after it is the last word.
void TestPanels::stopOutrunsAStartThatWaits()
{
    QVERIFY(m_rig->open(kDemo));
    workspace().setMotors(false);
    QVERIFY(motorsAre(false));
    QSemaphore busy;
    m_rig->client().submit<bool>([&busy](Channel &, Device &) -> Result<bool> {
        busy.acquire();
        return true;
    });
    workspace().setMotors(true);
    QSignalSpy off(&m_rig->client(), &DeviceClient::motorsOffFinished);
    workspace().setMotors(false);
    QTRY_COMPARE(off.count(), 1);
    busy.release();
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(m_rig->boardGoesOn(1.0));
    QCOMPARE(workspace().motorsRunning(), std::optional(false));
}

// The click that closes a menu counts for what lies beneath it.
void TestPanels::motorsGoOffBesideAnOpenMenu()
{
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    QMenu menu;
    menu.addAction(u"anything"_s);
    menu.popup(window().mapToGlobal(window().rect().center()));
    QTRY_VERIFY(menu.isVisible());
    click(motors());
    QTRY_VERIFY(!menu.isVisible());
    QVERIFY(motorsAre(false));
}

// What a dialog with a window of its own would do, and that the click of these tests is one that can be
// blocked.
void TestPanels::windowsWouldBlockThem()
{
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    QDialog dialog(&window());
    dialog.open();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog));
    click(motors());
    QVERIFY(m_rig->boardGoesOn(1.0));
    QCOMPARE(workspace().motorsRunning(), true);
}

void TestPanels::contentIsOutOfReach()
{
    QVERIFY(m_rig->open(kDemo));
    QDialog *dialog = open(u"review"_s);
    QVERIFY(dialog);
    const QString page = window().navigation()->currentPage();
    click(window().navigation());
    QTest::keyClick(dialog, Qt::Key_4, Qt::ControlModifier);
    QTest::keyClick(dialog, Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(dialog, Qt::Key_K, Qt::ControlModifier);
    QCOMPARE(window().navigation()->currentPage(), page);
    QCOMPARE(workspace().configuration().changeCount(), 1);
    QVERIFY(!window().commandPalette());
    // The link as well: what is reviewed belongs to this board and this profile.
    QVERIFY(!window().findChild<LinkBar *>()->connectButton()->isEnabled());
    // Tab goes round in the dialog, with the motors button as the one thing outside.
    for (int i = 0; i < 20; ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QWidget *focus = QApplication::focusWidget();
        QVERIFY(focus && (dialog->isAncestorOf(focus) || focus == motors()));
    }
    dialog->reject();
    QVERIFY(window().findChild<LinkBar *>()->connectButton()->isEnabled());
    QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(workspace().configuration().changeCount(), 0);
}

void TestPanels::focusComesBack()
{
    QVERIFY(m_rig->open(kDemo));
    window().showPage(u"monitor"_s);
    QWidget *button = m_rig->page<MonitorPage>()->streamsButton();
    button->setFocus();
    QVERIFY(QTest::qWaitForWindowActive(&window()));
    const QDialog *dialog = open(u"streams"_s);
    QVERIFY(dialog);
    QVERIFY(dialog->isAncestorOf(QApplication::focusWidget()));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!window().panels()->isOpen());
    QCOMPARE(QApplication::focusWidget(), button);
    // After a review, the field that was edited.
    window().showPage(u"parameters"_s);
    QWidget *field = window().page(u"parameters"_s)->findChild<QWidget *>(u"pid.roll.p"_s);
    QVERIFY(field);
    field->setFocus();
    QVERIFY(open(u"review"_s));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!window().panels()->isOpen());
    QCOMPARE(QApplication::focusWidget(), field);
}

void TestPanels::smallWindowHoldsThem()
{
    QVERIFY(m_rig->open(kDemo));
    window().resize(window().minimumSize());
    const QDialog *dialog = open(u"share"_s);
    QVERIFY(dialog);
    QVERIFY(m_rig->isSettled());
    const QRect place(dialog->mapTo(window().panels(), QPoint()), dialog->size());
    QVERIFY(window().panels()->rect().contains(place));
    QCOMPARE(window().size(), window().minimumSize());
    for (const QPushButton *button : dialog->findChildren<QPushButton *>())
        QVERIFY(dialog->rect().contains(QRect(button->mapTo(dialog, QPoint()), button->size())));
}

void TestPanels::redButtonStaysInSight_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("en") << u"en"_s;
    QTest::newRow("de") << u"de"_s;
}

// On a screen at 200 % a window has less room than the pages need: these are scrolled.
void TestPanels::redButtonStaysInSight()
{
    QFETCH(const QString, language);
    m_rig.reset();
    const Translations translations(language);
    m_rig = std::make_unique<WindowRig>();
    const auto check = [this](const QString &where) {
        for (const QSize &size : {QSize(1024, 640), QSize(960, 540), QSize(720, 450), QSize(560, 320)}) {
            window().setMinimumSize(200, 200);
            window().resize(size);
            QVERIFY(m_rig->isSettled());
            QCOMPARE(window().size(), size);
            const QString told = u"%1, %2 x %3"_s.arg(where).arg(size.width()).arg(size.height());
            const QRect inside = motors()->rect().adjusted(1, 1, -1, -1);
            for (const QPoint &corner :
                 {inside.topLeft(), inside.topRight(), inside.bottomLeft(), inside.bottomRight()})
                QVERIFY2(window().childAt(motors()->mapTo(&window(), corner)) == motors(), qPrintable(told));
            QVERIFY2(motors()->fontMetrics().horizontalAdvance(motors()->text()) < motors()->width(),
                     qPrintable(told));
            // All of the page can be reached.
            const QWidget *page = window().page(u"parameters"_s);
            auto *area = window().panels()->findChild<QScrollArea *>({}, Qt::FindDirectChildrenOnly);
            QVERIFY(area && area->widget()->isAncestorOf(window().navigation()));
            QVERIFY2(area->widget()->width() >= 1024, qPrintable(told));
            QCOMPARE(area->horizontalScrollBar()->maximum(), std::max(0, 1024 - area->viewport()->width()));
            QVERIFY(!page->isVisible() || page->height() >= 400);
        }
    };
    check(u"not connected"_s);
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    window().showPage(u"parameters"_s);
    check(u"connected"_s);
    QVERIFY(open(u"share"_s));
    check(u"beneath a panel"_s);
}

// The window's own close button, with a dialog open: that goes, and the question comes.
void TestPanels::closingTheWindowAsksOnceMore()
{
    QVERIFY(m_rig->open(kDemo));
    const QPointer<QDialog> review = open(u"review"_s);
    QVERIFY(review);
    window().close();
    QTRY_VERIFY(!review);
    QVERIFY(window().isVisible());
    QVERIFY(window().panels()->isOpen());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!window().panels()->isOpen());
    QCOMPARE(workspace().configuration().changeCount(), 1);
}

void TestPanels::stopIsKeptUntilThereIsALink_data()
{
    QTest::addColumn<QString>("by");
    for (const char *by : {"button", "F12", "Esc"})
        QTest::newRow(by) << QString::fromLatin1(by);
}

void TestPanels::stopIsKeptUntilThereIsALink()
{
    QFETCH(QString, by);
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    workspace().changeWorld(u"replug=4"_s);
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_COMPARE_WITH_TIMEOUT(m_rig->client().state(), DeviceClient::State::Reconnecting, 10000);
    QTRY_VERIFY(motors()->isEnabled());
    QSignalSpy kept(&workspace().notifications(), &Notifications::notice);
    if (by == u"button"_s)
        click(motors());
    else
        QTest::keyPress(&window(), by == u"F12"_s ? Qt::Key_F12 : Qt::Key_Escape);
    QTRY_COMPARE(kept.count(), 1);
    QCOMPARE(m_rig->client().state(), DeviceClient::State::Reconnecting);
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected(), 20000);
    QVERIFY(motorsAre(false));
}

QTEST_MAIN(TestPanels)
#include "tst_panels.moc"
