// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/autotunepage.h"
#include "app/families/simplebgc/calibrationpage.h"
#include "app/families/storm32/sensorpage.h"
#include "app/families/storm32/setuppage.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/messagebar.h"
#include "app/pages/board/actionspage.h"
#include "app/pages/setup/scriptspage.h"
#include "app/pages/tune/tuningpage.h"
#include "app/workspace/question.h"
#include "protocol/device/steering.h"
#include "protocol/record/recording.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/panel.h"

#include <QDialog>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

const QString kDemo = u"sim:simplebgc"_s;

}  // namespace

/// Quitting and disconnecting lose nothing unsaid, and wait for what must not be cut off.
class TestLeaving : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }
    void disconnectingAsksForValuesInUse_data();
    void disconnectingAsksForValuesInUse();
    void eachQuestionIsAsked();
    void quittingWaitsForAWrite();
    void disconnectingWaitsForAWrite();
    void procedureIsWaitedForOrCancelled_data();
    void procedureIsWaitedForOrCancelled();
    void stayingWithdrawsTheAnnouncement();
    void motorsAreProvenOffBeforeQuitting_data();
    void motorsAreProvenOffBeforeQuitting();
    void unprovenStopIsNoQuit_data();
    void unprovenStopIsNoQuit();
    void lateProofQuitsAfterAll_data();
    void lateProofQuitsAfterAll();
    void recordingIsWhole();
    void nothingInTheWayAsksNothing();
    void motorsThatRunAreAskedAbout();
    void steeringEndsBeforeTheLink();
    void openingOpensWhatWasAskedFor();
    void theWindowMayGoInTheMiddle_data();
    void theWindowMayGoInTheMiddle();

private:
    MainWindow &window() { return m_rig->window(); }
    Workspace &workspace() { return m_rig->workspace(); }
    QDialog *question()
    {
        const auto all = window().panels()->findChildren<QDialog *>();
        const auto shown = std::find_if(all.begin(), all.end(), [](auto *each) { return each->isVisible(); });
        return shown == all.end() ? nullptr : *shown;
    }
    void disconnectByButton() { window().findChild<LinkBar *>()->connectButton()->click(); }
    bool setLive(const QString &key)
    {
        LiveModel &live = workspace().live();
        if (!QTest::qWaitFor([&live] { return !live.parameters().isEmpty(); }, kPatience))
            return false;
        const int id = m_rig->spec(key).id;
        live.read();
        if (!QTest::qWaitFor([&live, id] { return live.value(id).has_value(); }, kPatience))
            return false;
        live.setValue(id, *live.value(id) + 1);
        return QTest::qWaitFor([&live] { return live.changeCount() == 1; }, kPatience);
    }
    void answer(const QString &button) { named<QPushButton>(question(), button)->click(); }

    std::unique_ptr<WindowRig> m_rig;
};

void TestLeaving::disconnectingAsksForValuesInUse_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QString>("key");
    QTest::newRow("SimpleBGC") << kDemo << u"pid.yaw.p"_s;
    QTest::newRow("STorM32") << u"sim:storm32"_s << u"pid.yaw.p"_s;
}

void TestLeaving::disconnectingAsksForValuesInUse()
{
    QFETCH(const QString, address);
    QFETCH(const QString, key);
    QVERIFY(m_rig->open(address));
    const double stored = m_rig->raw(key);
    QVERIFY(setLive(key));
    disconnectByButton();
    QVERIFY(question());
    QVERIFY(m_rig->client().isConnected());
    answer(u"Stay"_s);
    QVERIFY(!window().panels()->isOpen());
    QVERIFY(m_rig->client().isConnected());
    disconnectByButton();
    QVERIFY(question());
    answer(u"Store and disconnect"_s);
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    QVERIFY(window().isVisible());
    QCOMPARE(m_rig->raw(key), stored + 1);
}

// Edits kept for next time say nothing about values in use.
void TestLeaving::eachQuestionIsAsked()
{
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(setLive(u"pid.yaw.p"_s));
    m_rig->edit(u"pid.roll.p"_s, 0, 44);
    window().close();
    QVERIFY(question());
    answer(u"Quit and keep for next time"_s);
    QVERIFY(window().isVisible());
    QVERIFY(!question());
    QTRY_VERIFY(question());
    answer(u"Quit without storing"_s);
    QTRY_VERIFY(!window().isVisible());
}

void TestLeaving::quittingWaitsForAWrite()
{
    QVERIFY(m_rig->open(kDemo));
    m_rig->edit(u"pid.roll.p"_s, 0, 44);
    QSignalSpy told(&workspace().notifications(), &Notifications::notice);
    workspace().write(m_rig->model().edited());
    QVERIFY(workspace().isWriting());
    window().close();
    QVERIFY(window().isVisible());
    QVERIFY(m_rig->client().isConnected());
    QCOMPARE(told.count(), 1);
    QVERIFY(told.first().first().toString().contains(u"quits when it has ended"_s));
    QTRY_VERIFY(!window().isVisible());
    QVERIFY(workspace().lastReport() && workspace().lastReport()->isComplete());
    QCOMPARE(m_rig->model().changeCount(), 0);
}

void TestLeaving::disconnectingWaitsForAWrite()
{
    QVERIFY(m_rig->open(kDemo));
    m_rig->edit(u"pid.roll.p"_s, 0, 44);
    workspace().write(m_rig->model().edited());
    disconnectByButton();
    QVERIFY(m_rig->client().isConnected());
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    QVERIFY(workspace().lastReport() && workspace().lastReport()->isComplete());
    QVERIFY(window().isVisible());
}

void TestLeaving::procedureIsWaitedForOrCancelled_data()
{
    QTest::addColumn<QString>("answered");
    QTest::addColumn<bool>("ends");
    QTest::newRow("wait") << u"Wait, then quit"_s << true;
    QTest::newRow("cancel") << u"Cancel it and quit"_s << false;
}

void TestLeaving::procedureIsWaitedForOrCancelled()
{
    QFETCH(const QString, answered);
    QFETCH(const bool, ends);
    QVERIFY(m_rig->open(kDemo));
    const auto calibration = workspace().perform(u"calibrate.gyro"_s, {});
    QVERIFY(!calibration.isFinished());
    window().close();
    QVERIFY(window().isVisible());
    QVERIFY(question());
    answer(answered);
    QTRY_VERIFY(!window().isVisible());
    QVERIFY(calibration.isFinished());
    QCOMPARE(calibration.result().has_value(), ends);
}

// Whoever stays after all is not told any longer that the link will end.
void TestLeaving::stayingWithdrawsTheAnnouncement()
{
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(setLive(u"pid.yaw.p"_s));
    const auto calibration = workspace().perform(u"calibrate.gyro"_s, {});
    disconnectByButton();
    QVERIFY(question());
    answer(u"Wait, then disconnect"_s);
    const auto *bar = window().findChild<MessageBar *>();
    QVERIFY2(bar->text().contains(u"The link ends when"_s), qPrintable(bar->text()));
    QTRY_VERIFY(question());
    QVERIFY(calibration.isFinished());
    answer(u"Stay"_s);
    QVERIFY2(!bar->text().contains(u"The link ends when"_s), qPrintable(bar->text()));
    QVERIFY(m_rig->client().isConnected());
}

void TestLeaving::motorsAreProvenOffBeforeQuitting_data()
{
    QTest::addColumn<QString>("address");
    QTest::newRow("SimpleBGC") << kDemo;
    QTest::newRow("STorM32") << u"sim:storm32"_s;
}

void TestLeaving::motorsAreProvenOffBeforeQuitting()
{
    QFETCH(const QString, address);
    QVERIFY(m_rig->open(address));
    m_rig->settings().setMotorsOffOnQuit(true);
    QVERIFY(QTest::qWaitFor([this] { return workspace().motorsRunning().value_or(false); }, kPatience));
    QSignalSpy off(&m_rig->client(), &DeviceClient::motorsOffFinished);
    bool wasVisible = false;
    connect(&m_rig->client(), &DeviceClient::motorsOffFinished, this,
            [this, &wasVisible] { wasVisible = window().isVisible(); });
    window().close();
    QTRY_VERIFY(!window().isVisible());
    QCOMPARE(off.count(), 1);
    QVERIFY(off.first().first().toBool());
    QVERIFY(wasVisible);
}

void TestLeaving::unprovenStopIsNoQuit_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QString>("fault");
    QTest::newRow("SimpleBGC, silent") << kDemo << u"lose=1"_s;
    QTest::newRow("SimpleBGC, confirms and goes on") << kDemo << u"runs-on=1"_s;
    QTest::newRow("STorM32, confirms and goes on") << u"sim:storm32"_s << u"runs-on=1"_s;
}

void TestLeaving::unprovenStopIsNoQuit()
{
    QFETCH(const QString, address);
    QFETCH(const QString, fault);
    QVERIFY(m_rig->open(address));
    m_rig->settings().setMotorsOffOnQuit(true);
    QVERIFY(QTest::qWaitFor([this] { return workspace().motorsRunning().value_or(false); }, kPatience));
    workspace().changeWorld(fault);
    window().close();
    QTRY_VERIFY(question());
    QVERIFY(window().isVisible());
    answer(u"Quit all the same"_s);
    QTRY_VERIFY(!window().isVisible());
}

void TestLeaving::lateProofQuitsAfterAll_data()
{
    motorsAreProvenOffBeforeQuitting_data();
}

// The stop is repeated while the question stands, which must not outlive its proof.
void TestLeaving::lateProofQuitsAfterAll()
{
    QFETCH(const QString, address);
    QVERIFY(m_rig->open(address));
    m_rig->settings().setMotorsOffOnQuit(true);
    QVERIFY(QTest::qWaitFor([this] { return workspace().motorsRunning().value_or(false); }, kPatience));
    workspace().changeWorld(u"runs-on=1"_s);
    window().close();
    QTRY_VERIFY(question());
    workspace().changeWorld(u"runs-on=0"_s);
    QTRY_VERIFY(!window().isVisible());
}

void TestLeaving::recordingIsWhole()
{
    QVERIFY(m_rig->open(kDemo));
    const QString path = m_rig->filePath(u"link.gimbalrec"_s);
    QVERIFY(workspace().recorder().start(path));
    QVERIFY(m_rig->boardGoesOn(1.0));
    window().close();
    QVERIFY(!window().isVisible());
    m_rig->restart();
    const auto recording = Recording::load(path);
    QVERIFY(recording);
    QVERIFY(recording->gaps.empty());
    QVERIFY(recording->pieces.size() > 100);
}

void TestLeaving::nothingInTheWayAsksNothing()
{
    QVERIFY(m_rig->open(kDemo));
    disconnectByButton();
    QVERIFY(!question());
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    QVERIFY(m_rig->open(kDemo));
    window().close();
    QVERIFY(!window().isVisible());
}

void TestLeaving::motorsThatRunAreAskedAbout()
{
    m_rig->settings().setAskAboutMotors(true);
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(QTest::qWaitFor([this] { return workspace().motorsRunning().value_or(false); }, kPatience));
    window().close();
    QVERIFY(question() && window().isVisible());
    answer(u"Stay"_s);
    disconnectByButton();
    QVERIFY(question() && m_rig->client().isConnected());
    answer(u"Disconnect and leave them running"_s);
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(QTest::qWaitFor([this] { return workspace().motorsRunning().value_or(false); }, kPatience));
    QSignalSpy off(&m_rig->client(), &DeviceClient::motorsOffFinished);
    disconnectByButton();
    QVERIFY(question());
    answer(u"Stop motors and disconnect"_s);
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    QVERIFY(off.count() == 1 && off.first().first().toBool());
}

// The end of steering is proven while the link is there; unproven, it is asked about.
void TestLeaving::steeringEndsBeforeTheLink()
{
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(QTest::qWaitFor([this] { return workspace().motorsRunning().value_or(false); }, kPatience));
    QTimer steering;
    connect(&steering, &QTimer::timeout, this, [this] {
        m_rig->client().setControl({1, {std::nan(""), std::nan(""), 10.0}, {}});
    });
    connect(&workspace(), &Workspace::controlReleased, &steering, &QTimer::stop);
    steering.start(50);
    QTRY_VERIFY(m_rig->client().isSteering());
    QSignalSpy ended(&m_rig->client(), &DeviceClient::steeringEnded);
    disconnectByButton();
    QVERIFY(m_rig->client().isConnected());
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    QCOMPARE(ended.count(), 1);
    QVERIFY(ended.first().first().toBool());

    QVERIFY(m_rig->open(kDemo));
    steering.start(50);
    QTRY_VERIFY(m_rig->client().isSteering());
    workspace().changeWorld(u"lose=1"_s);
    disconnectByButton();
    QTRY_VERIFY(question());
    QVERIFY(m_rig->client().isConnected());
    QVERIFY(window().messageBar()->text().contains(u"may go on moving"_s));
    answer(u"Disconnect all the same"_s);
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
}

// With a board, a file's values become edits of it; a recording is played once the link may end.
void TestLeaving::openingOpensWhatWasAskedFor()
{
    QVERIFY(m_rig->open(kDemo));
    const double stored = m_rig->raw(u"pid.roll.p"_s);
    m_rig->edit(u"pid.roll.p"_s, 0, stored + 3);
    const QString file = m_rig->filePath(u"a.json"_s);
    QVERIFY(workspace().saveFile(file));
    workspace().edits().discardAll();
    window().openFile(file);
    QCOMPARE(m_rig->model().changeCount(), 1);
    QCOMPARE(m_rig->model().value(m_rig->spec(u"pid.roll.p"_s), 0), stored + 3);
    QVERIFY(m_rig->client().isConnected());
    QVERIFY(m_rig->boardGoesOn(0.5));
    const QString recording = m_rig->filePath(u"link.gimbalrec"_s);
    QSignalSpy saved(&workspace().recorder(), &LinkRecorder::finished);
    QVERIFY(workspace().recorder().savePast(recording));
    QTRY_COMPARE(saved.count(), 1);
    QVERIFY(setLive(u"pid.yaw.p"_s));
    window().openFile(recording);
    QVERIFY(question() && m_rig->client().isConnected());
    answer(u"Disconnect and play"_s);
    QTRY_VERIFY(question());
    QVERIFY(!m_rig->client().address().isReplay());
    answer(u"Disconnect without storing"_s);
    QTRY_VERIFY(m_rig->client().isConnected() && m_rig->client().address().isReplay());
}

void TestLeaving::theWindowMayGoInTheMiddle_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QString>("what");
    for (const char *what :
         {"read", "write", "action", "calibration", "search", "store", "question", "values"})
        QTest::addRow("SimpleBGC, %s", what) << kDemo << QString::fromLatin1(what);
    for (const char *what : {"read", "write", "action", "sensor", "setup", "store", "values", "scripts"})
        QTest::addRow("STorM32, %s", what) << u"sim:storm32"_s << QString::fromLatin1(what);
}

// As at the end of a session on the computer: nobody is asked, and nothing that waits is left behind.
void TestLeaving::theWindowMayGoInTheMiddle()
{
    QFETCH(const QString, address);
    QFETCH(const QString, what);
    QVERIFY(m_rig->open(address));
    QVERIFY(m_rig->jobsAreDone());
    if (what == u"read"_s) {
        workspace().readBoard();
    } else if (what == u"write"_s) {
        m_rig->edit(u"pid.roll.p"_s, 0, m_rig->raw(u"pid.roll.p"_s) + 1);
        workspace().write(m_rig->model().edited());
    } else if (what == u"action"_s) {
        auto *page = m_rig->page<ActionsPage>();
        workspace().perform(u"info"_s, {}).then(page, [](const Result<ActionOutcome> &) {});
    } else if (what == u"calibration"_s) {
        auto *page = m_rig->page<CalibrationPage>();
        workspace().changeWorld(u"pose=1"_s);
        page->start(CalibrationPage::Kind::Gyroscope);
        QTRY_VERIFY(page->isSatisfied() && page->continueButton()->isEnabled());
        page->continueButton()->click();
    } else if (what == u"search"_s) {
        auto *page = m_rig->page<AutoTunePage>();
        QTRY_VERIFY(page->startButton()->isEnabled());
        page->startButton()->click();
        QCOMPARE(page->state(), AutoTunePage::State::Running);
    } else if (what == u"sensor"_s) {
        m_rig->page<SensorPage>()->start(false);
    } else if (what == u"setup"_s) {
        m_rig->page<SetupPage>()->continueButton()->click();
    } else if (what == u"store"_s) {
        QVERIFY(setLive(u"pid.yaw.p"_s));
        auto *page = m_rig->page<TuningPage>();
        workspace().saveLive(*page).then(page, [](bool) {});
    } else if (what == u"question"_s) {
        auto *page = m_rig->page<ActionsPage>();
        workspace().perform(u"reset"_s, {}).then(page, [](const Result<ActionOutcome> &) {});
        askForMotorsOff(workspace(), page, [] {});
    } else if (what == u"values"_s) {
        QVERIFY(m_rig->page<TuningPage>());
        workspace().live().read();
    } else if (what == u"scripts"_s) {
        QVERIFY(m_rig->page<ScriptsPage>());
        workspace().readBoard();
    }
    m_rig.reset();
}

QTEST_MAIN(TestLeaving)
#include "tst_leaving.moc"
