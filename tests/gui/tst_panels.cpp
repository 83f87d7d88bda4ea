// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/messagehistory.h"
#include "app/mainwindow/navigation.h"
#include "app/mainwindow/translations.h"
#include "app/pages/board/actionspage.h"
#include "app/pages/board/backupspage.h"
#include "app/pages/setup/guidepage.h"
#include "app/pages/setup/profilespage.h"
#include "app/pages/setup/scriptspage.h"
#include "app/pages/tune/spectrumpage.h"
#include "app/pages/watch/monitorpage.h"
#include "app/workspace/filedialogs.h"
#include "app/workspace/question.h"
#include "protocol/device/abilities.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/keyboard.h"
#include "widgets/forms/panel.h"
#include "widgets/views/scripteditor.h"

#include <QDialog>
#include <QDirIterator>
#include <QFileDialog>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTableView>
#include <QTableWidget>
#include <QWindow>

using namespace Qt::StringLiterals;

namespace {

const QString kDemo = u"sim:simplebgc"_s;

/// A place in the sources that opens a panel, and what these tests call what it opens.
struct PanelSite
{
    const char *name;
    const char *place;  // file and function
    bool storm = false;  // only on such a board
};
constexpr PanelSite kSites[]{
    {"review", "app/mainwindow/shortcuts.cpp review"},
    {"palette", "app/mainwindow/shortcuts.cpp showPalette"},
    {"unsaved", "app/mainwindow/leaving.cpp askAboutEdits"},
    {"unstored", "app/mainwindow/leaving.cpp askAboutValues"},
    {"work", "app/mainwindow/leaving.cpp askAboutWork"},
    {nullptr, "app/mainwindow/leaving.cpp askAboutMotors"},  // comes when they were told off just now
    {"running", "app/mainwindow/leaving.cpp askAboutRunning"},
    {nullptr, "app/mainwindow/leaving.cpp askAboutSteering"},  // of a board that does not answer
    // Of a drone, and of the same kind as the others: see tst_flight and tst_camerapage.
    {nullptr, "app/mainwindow/leaving.cpp askAboutArmed"},
    {nullptr, "app/pages/board/flighttext.cpp askToOpen"},
    {nullptr, "app/pages/board/backupspage.cpp askBeforeRestoring"},
    {nullptr, "app/pages/board/flighttext.cpp askToTune"},
    {"forget", "app/pages/setup/guidepage.cpp forget"},
    {nullptr, "app/families/bcflight/picturesettings.cpp openLens"},
    {nullptr, "app/families/simplebgc/scriptslotspage.cpp askToRun"},  // see tst_scriptslots
    {nullptr, "app/workspace/filedialogs.cpp openBeside"},  // see fileDialogsLeaveTheMotorsInReach
    {nullptr, "app/workspace/filedialogs.cpp askToReplace"},  // comes after it; see tst_filedialogs
    {"back", "app/mainwindow/bars.cpp goBack", true},
    {"messages", "app/mainwindow/shortcuts.cpp showPalette"},
    {"play", "app/mainwindow/mainwindow.cpp openFile"},
    {nullptr,
     "app/mainwindow/mainwindow.cpp connectFrame"},  // what is confirmed each time: see tst_benchpage
    {nullptr, "app/workspace/question.cpp askAboutLeap"},  // of gains of a drone: see tst_bcflightwindow
    {nullptr, "app/workspace/question.cpp askToStartMotors"},  // goes by itself where motors run
    {"letgo", "app/workspace/question.cpp askToLetGo"},
    {"storing", "app/workspace/storing.cpp reviewStoring", true},
    {"alarmed", "app/workspace/storing.cpp askToStoreAlarmed"},
    {nullptr, "app/workspace/storing.cpp reviewRewriting"},  // of a board that keeps them in a text
    {nullptr, "app/workspace/storing.cpp askToStoreAll"},  // of motors that are stored otherwise
    {"switch", "app/workspace/question.cpp askToReload"},
    {"limp", "app/workspace/question.cpp askForMotorsOff"},
    {"streams", "app/pages/watch/monitorpage.cpp askStreams"},
    {"layout", "app/pages/watch/monitorpage.cpp askLayoutName"},
    {"publish", "app/pages/watch/monitorpage.cpp askPublish"},
    {"share", "app/pages/board/backupspage.cpp makeHeader"},
    {"name", "app/pages/board/backupspage.cpp askName"},
    {"notch", "app/pages/tune/spectrumpage.cpp askNotch"},
    {"profile", "app/pages/setup/profilespage.cpp loadInto"},
    {"scripts", "app/pages/setup/scriptspage.cpp askToDiscard", true},
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
    void answersAreReadWhole();
    void motorsGoOffBeneathEachDialog_data() { addRows(true); }
    void motorsGoOffBeneathEachDialog();
    void motorsGoOffBeneathStormsDialogs_data();
    void motorsGoOffBeneathStormsDialogs();
    void keysStopThemInEachDialog_data() { addRows(false); }
    void keysStopThemInEachDialog();
    void stopIsKeptBeneathEachDialog_data() { addRows(false); }
    void stopIsKeptBeneathEachDialog();
    void stopOutrunsAStartThatWaits();
    void stopOutrunsWhateverTheWorkerDoes_data();
    void stopOutrunsWhateverTheWorkerDoes();
    void lockedOutBoardIsStopped_data();
    void lockedOutBoardIsStopped();
    void motorsGoOffBesideAnOpenMenu();
    void windowsWouldBlockThem();
    void contentIsOutOfReach();
    void focusComesBack();
    void noDialogLeavesTheKeyboardOnAButtonThatActs_data() { addRows(false); }
    void noDialogLeavesTheKeyboardOnAButtonThatActs();
    void smallWindowHoldsThem();
    void redButtonStaysInSight_data();
    void redButtonStaysInSight();
    void closingTheWindowAsksOnceMore();
    void stopIsKeptUntilThereIsALink_data();
    void stopIsKeptUntilThereIsALink();
    void fileDialogsLeaveTheMotorsInReach_data();
    void fileDialogsLeaveTheMotorsInReach();

private:
    MainWindow &window() { return m_rig->window(); }
    Workspace &workspace() { return m_rig->workspace(); }
    QPushButton *motors() { return window().findChild<QPushButton *>(u"motors"_s); }
    bool motorsAre(bool running)
    {
        return QTest::qWaitFor([&] { return workspace().motorsRunning() == running; }, kPatience);
    }
    /// A click as the window system sends it: a window that is blocked gets none.
    void click(QWidget *widget)
    {
        QTest::mouseClick(window().windowHandle(), Qt::LeftButton, {},
                          widget->mapTo(&window(), widget->rect().center()));
    }
    void stopBeneath(const QString &address, const QString &name);
    /// Opens that dialog the operator's way; null if none came.
    QDialog *open(const QString &name);
    void chooseInMenu(const QString &text);
    void addRows(bool withSlow);
    bool isLiveValueSet(const QString &key = u"pid.yaw.p"_s);
    void discardTypedScripts();
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

bool TestPanels::isLiveValueSet(const QString &key)
{
    LiveModel &live = workspace().live();
    if (live.changeCount() > 0)
        return true;
    const int id = m_rig->spec(key).id;
    if (!QTest::qWaitFor([&live] { return !live.parameters().isEmpty(); }, kPatience))
        return false;
    live.read();
    if (!QTest::qWaitFor([&live, id] { return live.value(id).has_value(); }, kPatience))
        return false;
    live.setValue(id, *live.value(id) + 1);
    return QTest::qWaitFor([&live] { return live.changeCount() == 1; }, kPatience);
}

void TestPanels::discardTypedScripts()
{
    auto *page = m_rig->page<ScriptsPage>();
    page->editor()->setText(u"WAIT 5\n"_s);
    page->showScript(1);
    page->revertButton()->click();
}

bool TestPanels::isRecorded()
{
    const QString path = m_rig->filePath(u"link.gimbalrec"_s);
    if (QFile::exists(path))
        return true;
    QSignalSpy saved(&workspace().recorder(), &LinkRecorder::finished);
    return workspace().recorder().savePast(path) && (saved.count() > 0 || saved.wait(kPatience));
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
    else if (name == u"messages"_s)
        openPanel(*new MessageHistory(workspace().notifications(), &window()));
    else if (name == u"unsaved"_s)
        window().close();
    else if (name == u"streams"_s && window().showPage(u"monitor"_s))
        m_rig->page<MonitorPage>()->streamsButton()->click();
    else if (name == u"share"_s && window().showPage(u"backups"_s))
        m_rig->page<BackupsPage>()->findChild<QPushButton *>(u"share"_s)->click();
    else if (name == u"play"_s && isRecorded())
        window().openFile(m_rig->filePath(u"link.gimbalrec"_s));
    else if (name == u"limp"_s)
        askForMotorsOff(workspace(), &window(), [] {});
    else if (name == u"switch"_s)
        askToUseProfile(workspace(), 1, &window());
    else if (name == u"work"_s) {
        workspace().beginWork();
        window().close();
    } else if (name == u"unstored"_s && isLiveValueSet())
        window().close();
    else if (name == u"running"_s) {
        m_rig->settings().setAskAboutMotors(true);
        window().close();
    } else if (name == u"letgo"_s) {
        auto *page = m_rig->page<ActionsPage>();
        if (!page->showAction(u"reset"_s))
            return nullptr;
        page->runButton()->click();
    } else if (name == u"back"_s && isLiveValueSet(u"pan.pitch.deadband"_s))
        named<QPushButton>(window().findChild<UnstoredBar *>(), u"Revert all"_s)->click();
    else if (name == u"storing"_s && isLiveValueSet())
        std::ignore = workspace().saveLive(window(), QSet<QString>{});
    else if (name == u"alarmed"_s && isLiveValueSet()) {
        AlarmReport report;
        report.number = 1;
        report.alarm.kind = AlarmKind::Oscillation;
        emit m_rig->client().alarmChanged(report);
        std::ignore = workspace().saveLive(window());
    } else if (name == u"scripts"_s)
        discardTypedScripts();
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
    } else if (name == u"forget"_s) {
        auto *page = m_rig->page<GuidePage>();
        page->forgetButton()->click();
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
        if (!QTest::qWaitFor([&written] { return written.count() > 0; }, kPatience)
            || !QTest::qWaitFor(isOffered, 60000))
            return nullptr;
        page->notchButton()->click();
    }
    if (!QTest::qWaitFor([this] { return window().panels()->isOpen(); }, kPatience))
        return nullptr;
    return window().panels()->findChild<QDialog *>();
}

void TestPanels::addRows(bool withSlow)
{
    QTest::addColumn<QString>("name");
    for (const PanelSite &site : kSites) {
        // A notch is offered after half a minute; its box is of the same kind as others.
        if (site.name && !site.storm && (withSlow || qstrcmp(site.name, "notch") != 0))
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

// On a small or magnified screen too: the window gives the room, not the screen.
void TestPanels::answersAreReadWhole()
{
    QVERIFY(m_rig->open(kDemo));
    const Question question{u"Leave?"_s,
                            u"One change is not on the board."_s,
                            {{u"Keep all that is not on the board for the next time and leave"_s, [] {}},
                             {u"Throw all of that away for good and leave the program now"_s, [] {}, true}},
                            u"Stay here"_s};
    const QDialog *box = askInPanel(question, &window());
    const auto buttons = box->findChildren<QPushButton *>();
    QCOMPARE(buttons.size(), 3);
    // The keyboard reaches each of them and nothing else.
    QSet<const QWidget *> reached;
    for (const Qt::Key key :
         {Qt::Key_Tab, Qt::Key_Tab, Qt::Key_Tab, Qt::Key_Tab, Qt::Key_Backtab, Qt::Key_Backtab}) {
        QTest::keyClick(QApplication::focusWidget(), key);
        reached.insert(QApplication::focusWidget());
    }
    QCOMPARE(reached, QSet<const QWidget *>(buttons.begin(), buttons.end()));
    for (const QPushButton *button : buttons)
        QTRY_VERIFY2(
            button->width() >= button->sizeHint().width(),
            qPrintable(
                u"%1: %2 of %3"_s.arg(button->text()).arg(button->width()).arg(button->sizeHint().width())));
}

void TestPanels::motorsGoOffBeneathEachDialog()
{
    QFETCH(QString, name);
    stopBeneath(kDemo, name);
}

void TestPanels::motorsGoOffBeneathStormsDialogs_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"review", "palette", "unsaved", "unstored", "work", "running", "play", "layout",
                             "publish", "share", "letgo", "back", "storing", "scripts"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestPanels::motorsGoOffBeneathStormsDialogs()
{
    QFETCH(QString, name);
    stopBeneath(u"sim:storm32"_s, name);
}

void TestPanels::stopBeneath(const QString &address, const QString &name)
{
    QVERIFY(m_rig->open(address));
    QVERIFY(motorsAre(true));
    const QDialog *dialog = open(name);
    QVERIFY(dialog && dialog->isVisible());
    for (const QPushButton *button : dialog->findChildren<QPushButton *>()) {
        QVERIFY2(!button->isVisible() || button->width() >= button->sizeHint().width(),
                 qPrintable(u"“%1” is cut"_s.arg(button->text())));
    }
    QVERIFY(m_rig->boardGoesOn(0.3));  // with what it tells meanwhile
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
    QTRY_VERIFY(motors()->isEnabled());  // to switch them on
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
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Reconnecting);
    QTRY_VERIFY(motors()->isEnabled());
    QSignalSpy kept(&workspace().notifications(), &Notifications::notice);
    click(motors());
    QCOMPARE(kept.count(), 1);
    QTRY_VERIFY(m_rig->client().isConnected());
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
    QTRY_VERIFY(m_rig->client().isConnected());
    QVERIFY(motorsAre(false));
}

// The worker is busy, and the start waits for its turn: a stop that comes after it is the last word.
void TestPanels::stopOutrunsAStartThatWaits()
{
    QVERIFY(m_rig->open(kDemo));
    QSignalSpy off(&m_rig->client(), &DeviceClient::motorsOffFinished);
    workspace().setMotors(false);
    QTRY_COMPARE(off.count(), 1);
    QVERIFY(motorsAre(false));
    const auto busy = std::make_shared<QSemaphore>();
    const auto released = qScopeGuard([busy] { busy->release(); });
    m_rig->client().submit<bool>([busy](Channel &, Device &) -> Result<bool> {
        busy->acquire();
        return true;
    });
    workspace().setMotors(true);
    workspace().setMotors(false);
    QTRY_COMPARE(off.count(), 2);
    busy->release();
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(m_rig->boardGoesOn(1.0));
    QCOMPARE(workspace().motorsRunning(), std::optional(false));
}

void TestPanels::stopOutrunsWhateverTheWorkerDoes_data()
{
    QTest::addColumn<QString>("work");
    for (const char *work : {"job", "reading", "write", "autotune", "calibrate.gyro"})
        QTest::newRow(work) << QString::fromLatin1(work);
}

// Beneath a panel, while the worker is busy.
void TestPanels::stopOutrunsWhateverTheWorkerDoes()
{
    QFETCH(const QString, work);
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    QVERIFY(open(u"palette"_s));
    // Outlives this function where it fails: the worker still waits then.
    const auto busy = std::make_shared<QSemaphore>();
    const auto released = qScopeGuard([busy] { busy->release(); });
    const auto hold = [busy](Channel &, Device &) -> Result<bool> {
        busy->acquire();
        return true;
    };
    if (work == u"reading"_s) {
        workspace().readBoard();
    } else if (work == u"write"_s) {
        m_rig->edit(u"pid.roll.p"_s, 0, 44);
        workspace().write(m_rig->model().edited());
    } else if (work != u"job"_s) {
        QSignalSpy progress(&m_rig->client(), &DeviceClient::progressChanged);
        for (const ActionSpec &action : m_rig->client().device()->actions()) {
            const QString key = QLatin1String(action.key);
            if (key == work)
                workspace().perform(key, *parseArguments(action, {}));
        }
        QTRY_VERIFY(!progress.isEmpty());
    }
    m_rig->client().submit<bool>(hold);
    QSignalSpy off(&m_rig->client(), &DeviceClient::motorsOffFinished);
    click(motors());
    // On a machine that stands still the board is asked again before it proves it.
    QTRY_VERIFY(
        std::any_of(off.begin(), off.end(), [](const QVariantList &end) { return end.first().toBool(); }));
    QVERIFY(m_rig->client().isBusy());
    QVERIFY(motorsAre(false));
    busy->release();
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(m_rig->boardGoesOn(1.0));
    QCOMPARE(workspace().motorsRunning(), std::optional(false));
}

void TestPanels::lockedOutBoardIsStopped_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"palette", "layout", "publish", "share"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

// A STorM32 whose heartbeat is on answers in MAVLink only, and some of it cannot be read.
void TestPanels::lockedOutBoardIsStopped()
{
    QFETCH(const QString, name);
    const QString address = u"sim:storm32?rate=115200&seed=71"_s;
    QVERIFY(m_rig->open(address));
    QVERIFY(motorsAre(true));
    m_rig->edit(u"mavlink.heartbeat"_s, 0, 1);
    QSignalSpy written(&workspace(), &Workspace::writeFinished);
    workspace().write(m_rig->model().edited());
    QTRY_VERIFY(!written.isEmpty());
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    QVERIFY(m_rig->open(address));
    QVERIFY(m_rig->client().device()->statusWords()->connectOffer());  // it is reached that way
    QVERIFY(motorsAre(true));
    const QDialog *dialog = open(name);
    QVERIFY(dialog && dialog->isVisible());
    click(motors());
    QVERIFY(motorsAre(false));
    QVERIFY(dialog->isVisible());
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
    const auto entry = [this] {
        const Navigation *list = window().navigation();
        for (int row = 0; row < list->count(); ++row) {
            if (list->item(row)->data(Qt::UserRole) == u"monitor"_s)
                return list->viewport()
                    ->grab({list->visualItemRect(list->item(row)).topLeft(), QSize(150, 30)})
                    .toImage();
        }
        return QImage();
    };
    QVERIFY(m_rig->isSettled());
    const QImage before = entry();
    QVERIFY(!before.isNull());
    QDialog *dialog = open(u"review"_s);
    QVERIFY(dialog);
    QVERIFY(m_rig->isSettled());
    QCOMPARE(entry(), before);  // nothing moves beneath
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

// Whatever had it before, and whether that is still there: the next key stops, starts and ends nothing.
void TestPanels::noDialogLeavesTheKeyboardOnAButtonThatActs()
{
    QFETCH(QString, name);
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    QVERIFY(QTest::qWaitForWindowActive(&window()));
    const QPointer<QPushButton> disconnect = window().findChild<LinkBar *>()->connectButton();
    for (const bool isGone : {false, true}) {
        for (QPushButton *before : {disconnect.data(), motors()}) {
            before->setFocus();
            const QPointer<QDialog> dialog = open(name);
            QVERIFY(dialog);
            if (isGone)
                window().showPage(u"help"_s);
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
            QTRY_VERIFY(!window().panels()->isOpen());
            QVERIFY(m_rig->isSettled());
            const QWidget *focus = QApplication::focusWidget();
            QVERIFY(focus);
            const auto *button = qobject_cast<const QAbstractButton *>(focus);
            QVERIFY2(!button || mayTakeKeyboard(*button), qPrintable(button ? button->text() : QString()));
            QVERIFY2(!window().findChild<LinkBar *>()->isAncestorOf(focus),
                     qPrintable(focus->accessibleName()));
            tidy();
        }
    }
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
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Reconnecting);
    QTRY_VERIFY(motors()->isEnabled());
    QSignalSpy kept(&workspace().notifications(), &Notifications::notice);
    if (by == u"button"_s)
        click(motors());
    else
        QTest::keyPress(&window(), by == u"F12"_s ? Qt::Key_F12 : Qt::Key_Escape);
    QTRY_COMPARE(kept.count(), 1);
    QCOMPARE(m_rig->client().state(), DeviceClient::State::Reconnecting);
    QTRY_VERIFY(m_rig->client().isConnected());
    QVERIFY(motorsAre(false));
}

void TestPanels::fileDialogsLeaveTheMotorsInReach_data()
{
    QTest::addColumn<QString>("by");
    for (const char *by : {"F12 there", "F12 here", "Esc here", "button"})
        QTest::newRow(by) << QString::fromLatin1(by);
}

// Keys and clicks go the way that they take from the window system, which ends at a window that is blocked.
void TestPanels::fileDialogsLeaveTheMotorsInReach()
{
    QFETCH(QString, by);
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    QString chosen;
    askSavePath(&window(), u"Save"_s, u"gimbal.json"_s, u"*.json"_s,
                [&chosen](const QString &path) { chosen = path; });
    QPointer<QFileDialog> dialog = window().findChild<QFileDialog *>();
    QVERIFY(dialog && QTest::qWaitForWindowExposed(dialog));
    QVERIFY(!window().findChild<LinkBar *>()->connectButton()->isEnabled());
    QWindow *where = by == u"F12 there"_s ? dialog->windowHandle() : window().windowHandle();
    const QPoint button = motors()->mapTo(&window(), motors()->rect().center());
    if (by == u"button"_s)
        QTest::mouseClick(where, Qt::LeftButton, {}, button);
    else
        QTest::keyPress(where, by == u"Esc here"_s ? Qt::Key_Escape : Qt::Key_F12);
    QVERIFY(motorsAre(false));
    if (dialog)
        dialog->reject();
    QTRY_VERIFY(!dialog && !window().panels()->isOpen());
    QVERIFY(chosen.isEmpty());
}

QTEST_MAIN(TestPanels)
#include "tst_panels.moc"
