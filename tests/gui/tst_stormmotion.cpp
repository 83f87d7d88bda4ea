// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/storm32/sensorpage.h"
#include "app/families/storm32/setuppage.h"
#include "app/mainwindow/bars.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/messagebar.h"
#include "app/pages/board/actionspage.h"
#include "app/pages/board/controlpage.h"
#include "app/pages/tune/responsepage.h"
#include "app/pages/tune/tuningpage.h"
#include "app/workspace/question.h"
#include "protocol/device/abilities.h"
#include "protocol/record/recording.h"
#include "protocol/session/linkstatistics.h"
#include "protocol/simulator/storm32/board.h"
#include "protocol/telemetry/streams.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/loopmath.h"
#include "tests/support/measure.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"
#include "tests/support/stormwindow.h"
#include "widgets/forms/numberbox.h"
#include "widgets/forms/panel.h"
#include "widgets/models/parametermodel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QTest>

#include <numbers>

using namespace Qt::StringLiterals;

/// What moves a STorM32's camera or measures it: calibration, set-up, steering, steps; and a whole day over a
/// terminal.
class TestStormMotion : public StormWindowTest
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }

    void sensorIsCalibratedAndStored();
    void calibrationComesFromAFile();
    void gimbalIsSetUp_data();
    void gimbalIsSetUp();
    void setupListsWhatItHasNotSet();
    void setupCanBeCancelled();
    void aPulledCableIsToldByTheWizards();
    void steeringByAngleAndByPulse();
    void stepsAreMeasuredWithoutToldTargets();
    void stepsAreRefusedWhereNothingHolds();
    void functionsAreAtHandWhileSteering();
    void motorsOffWorksThroughMavlink();
    void startingBoardIsOfferedAStop();
    void wholeDayOverAPseudoTerminal_data();
    void wholeDayOverAPseudoTerminal();
};

void TestStormMotion::sensorIsCalibratedAndStored()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<SensorPage>();
    workspace().changeWorld(u"pose=1"_s);
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(true));
    page->start(true);  // past the question: the procedure itself keeps them off
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
    const std::array poses{1, 4, 2, 6, 3, 5};
    for (std::size_t i = 0; i < poses.size(); ++i) {
        workspace().changeWorld(u"pose=%1"_s.arg(poses[i]));
        QTRY_VERIFY2(page->doneCount() == int(i) + 1 || page->step() == SensorPage::Step::Result,
                     qPrintable(page->sees()));
    }
    QTRY_COMPARE(page->step(), SensorPage::Step::Result);
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
    QVERIFY(std::abs(page->calibration().scale[2] - 8356)
            < 60);  // 1.02 of 8192, the simulated sensor's own error
    // Nothing was changed so far.
    std::optional<int> scale;
    const auto stored = [&] {
        scale.reset();
        workspace().perform(u"calibration.read"_s, {}).then(this, [&](const Result<ActionOutcome> &reply) {
            scale = reply ? reply->reply.value(u"imu.acc.scale.z"_s).toInt() : -1;
        });
        return QTest::qWaitFor([&] { return scale.has_value(); }, kPatience) ? *scale : -1;
    };
    QCOMPARE(stored(), 8192);
    const QString file = m_rig->filePath(u"imu.cal"_s);
    QVERIFY(page->saveFile(file));
    page->storeButton()->click();
    QTRY_COMPARE(page->step(), SensorPage::Step::Choose);
    QCOMPARE(stored(), page->calibration().scale[2]);
}

void TestStormMotion::calibrationComesFromAFile()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<SensorPage>();
    const QString path = m_rig->filePath(u"imu.cal"_s);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("IMUNAME: Imu\nAXZERO: 1\nAYZERO: 2\nAZZERO: 3\nAXSCALE: 8190\nAYSCALE: 8191\nAZSCALE: "
               "8200\nCALIBRATIONMETHOD: 1 point\n");
    file.close();
    QVERIFY(page->loadFile(path));
    QCOMPARE(page->step(), SensorPage::Step::Result);
    page->storeButton()->click();
    QTRY_COMPARE(page->step(), SensorPage::Step::Choose);
    QVERIFY(!page->loadFile(m_rig->filePath(u"none.cal"_s)));
}

void TestStormMotion::gimbalIsSetUp_data()
{
    QTest::addColumn<bool>("terminal");
    QTest::newRow("in the program") << false;
    QTest::newRow("over a pseudo-terminal") << true;
}

void TestStormMotion::gimbalIsSetUp()
{
    QFETCH(bool, terminal);
    std::unique_ptr<SimProcess> board;
    if (terminal) {
        const QString path = m_rig->filePath(u"storm"_s);
        board = std::make_unique<SimProcess>(QStringList{u"--pty"_s, path, u"--rate"_s, u"115200"_s},
                                             u"storm32"_s);
        QVERIFY(m_rig->open(u"serial:"_s + path));
        QVERIFY(ready());
    } else {
        QVERIFY(openStorm());
    }
    const auto changeWorld = [&](const char *words) {
        if (board)
            board->process().write(QByteArray(words) + '\n');
        else
            workspace().changeWorld(QString::fromLatin1(words));
    };
    changeWorld("mount=5");
    auto *page = m_rig->page<SetupPage>();
    using Step = SetupPage::Step;
    changeWorld("pose=1");
    QTRY_VERIFY(page->continueButton()->isEnabled());
    QTest::keyClick(page->continueButton(), Qt::Key_Space);
    QTRY_VERIFY2(page->step() == Step::Orientation && page->what().contains(u"45°"_s),
                 qPrintable(page->what()));
    QVERIFY(workspace().isUnstored());
    changeWorld("pose=7");
    QTRY_COMPARE(page->step(), Step::Poles);
    QVERIFY2(page->report().last().contains(u"x90°"_s), qPrintable(page->report().last()));
    QCOMPARE(inUse(39), 5);
    page->poles(Axis::Yaw)->setValue(16);
    page->continueButton()->click();
    QTRY_COMPARE(page->step(), Step::AskStart);
    QCOMPARE(inUse(32), 16);
    QCOMPARE(inUse(21), 2);
    page->poles(Axis::Yaw)->setValue(14);
    QVERIFY(!workspace().motorsRunning().value_or(true));  // nothing moves before it is asked
    page->continueButton()->click();
    QTRY_VERIFY(page->step() == Step::AlignYaw && page->continueButton()->isEnabled());
    QCOMPARE(inUse(21), 0);
    QTRY_VERIFY(workspace().motorsRunning().value_or(false));
    for (QPushButton *button : page->findChildren<QPushButton *>()) {
        if (button->text() == u"+5°"_s)
            button->click();
    }
    QCOMPARE(page->yaw(), 5.0);
    QTRY_COMPARE(inUse(108), 50);
    page->continueButton()->click();
    QTRY_COMPARE(page->step(), Step::AskFinish);
    QCOMPARE(inUse(108), 0);
    page->continueButton()->click();
    QTRY_COMPARE(page->step(), Step::Done);
    QVERIFY(!workspace().isUnstored());
    QTRY_COMPARE(m_rig->raw(u"imu.orientation"_s), 5);
    QCOMPARE(m_rig->raw(u"motor.yaw.poles"_s), 16);
    workspace().perform(u"reset"_s, {});
    QTRY_COMPARE(inUse(39), 5);  // kept over a restart
}

// Values that somebody else has set are not stored with the set-up's own unless that is wanted.
void TestStormMotion::setupListsWhatItHasNotSet()
{
    QVERIFY(openStorm());
    LiveModel &live = workspace().live();
    live.setValue(m_rig->spec(u"pid.roll.p"_s).id, 450);
    QTRY_VERIFY(live.isSettled());
    auto *page = m_rig->page<SetupPage>();
    for (int task = 0; task < SetupPage::kTasks; ++task)
        page->box(SetupPage::Task(task))->setChecked(SetupPage::Task(task) == SetupPage::Task::Poles);
    page->continueButton()->click();
    QTRY_COMPARE(page->step(), SetupPage::Step::Poles);
    page->poles(Axis::Yaw)->setValue(16);
    page->continueButton()->click();
    QTRY_COMPARE(page->step(), SetupPage::Step::AskFinish);
    page->continueButton()->click();
    const auto review = [this] { return m_rig->window().findChild<ReviewDialog *>(); };
    QTRY_VERIFY(review());
    QAbstractItemModel *model = review()->table()->model();
    bool isListed = false;
    for (int row = 0; row < model->rowCount(); ++row) {
        if (!model->index(row, 0).data().toString().endsWith(parameterLabel(m_rig->spec(u"pid.roll.p"_s))))
            continue;
        isListed = true;
        QVERIFY(model->setData(model->index(row, 0), Qt::Unchecked, Qt::CheckStateRole));
    }
    QVERIFY(isListed);
    review()->accept();
    QTRY_COMPARE(page->step(), SetupPage::Step::Done);
    QCOMPARE(m_rig->raw(u"motor.yaw.poles"_s), 16);
    QCOMPARE(m_rig->raw(u"pid.roll.p"_s), 400);
    QCOMPARE(inUse(6), 450);
    QVERIFY(page->report().last().contains(u"✓"_s));
}

void TestStormMotion::setupCanBeCancelled()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<SetupPage>();
    for (const auto task :
         {SetupPage::Task::Orientation, SetupPage::Task::Poles, SetupPage::Task::AutoDirections})
        page->box(task)->setChecked(false);
    workspace().changeWorld(u"battery=7"_s);
    const auto *motors = named<QPushButton>(&m_rig->window(), u"Stop motors"_s);
    page->continueButton()->click();
    QTRY_COMPARE(page->step(), SetupPage::Step::AskStart);
    // Until it ends or is cancelled, nothing else stores or starts the motors.
    auto *bar = m_rig->window().findChild<UnstoredBar *>();
    auto *store = named<QPushButton>(bar, u"Store on the board"_s);
    auto *actions = m_rig->page<ActionsPage>();
    QTRY_VERIFY(bar->isVisible());
    QVERIFY(!store->isEnabled() && !bar->backButton()->isEnabled());
    QTRY_COMPARE(motors->accessibleName(), u"Start motors"_s);
    QTRY_VERIFY(!motors->isEnabled());
    for (const QString &key : {u"store"_s, u"motors.on"_s, u"restart"_s}) {
        QVERIFY2(actions->showAction(key), qPrintable(key));
        QVERIFY2(!actions->runButton()->isEnabled(), qPrintable(key));
    }
    QVERIFY(actions->showAction(u"status"_s) && actions->runButton()->isEnabled());
    QSignalSpy problems(&workspace().notifications(), &Notifications::problem);
    workspace().setMotors(true);
    QVERIFY(!workspace().saveLive(m_rig->window()).result());
    QCOMPARE(problems.size(), 2);
    for (const QString &key : {u"store"_s, u"motors.on"_s, u"reset"_s}) {
        const auto refused = workspace().perform(key, {});
        QVERIFY2(refused.isFinished() && !refused.result(), qPrintable(key));
    }
    workspace().write(m_rig->model().edited());
    QCOMPARE(problems.size(), 6);
    QCOMPARE(inUse(79), 3);
    m_rig->page<SetupPage>();
    page->continueButton()->click();
    QTRY_VERIFY2(page->sees().contains(u"battery"_s), qPrintable(page->sees()));
    page->cancelButton()->click();
    QCOMPARE(page->step(), SetupPage::Step::Choose);
    QVERIFY(workspace().isUnstored());  // the motors are disabled, and it says so
    QTRY_COMPARE(inUse(79), 3);
    QVERIFY(store->isEnabled() && bar->backButton()->isEnabled());
    // The board starts anew with it, and so may its motors: that is asked.
    bar->backButton()->click();
    auto *question = m_rig->window().panels()->findChild<QDialog *>();
    QVERIFY(question);
    named<QPushButton>(question, u"Revert all"_s)->click();
    QTRY_COMPARE(inUse(79), 0);
    // Nothing ticked: nothing to begin.
    for (int task = 0; task < SetupPage::kTasks; ++task)
        page->box(SetupPage::Task(task))->setChecked(false);
    QVERIFY(!page->continueButton()->isEnabled());
}

void TestStormMotion::aPulledCableIsToldByTheWizards()
{
    QVERIFY(openStorm());
    auto *sensor = m_rig->page<SensorPage>();
    const auto told = [this] { return m_rig->window().messageBar()->text(); };
    const auto pull = [this] {
        workspace().changeWorld(u"replug=1"_s);
        workspace().changeWorld(u"unplug=0"_s);
        return QTest::qWaitFor([this] { return !m_rig->client().isConnected(); }, kPatience)
            && QTest::qWaitFor([this] { return m_rig->client().isConnected(); }, kPatience)
            && m_rig->jobsAreDone();
    };
    workspace().changeWorld(u"pose=1"_s);
    sensor->start(true);
    QTRY_COMPARE(sensor->doneCount(), 1);
    QVERIFY(pull());
    QCOMPARE(sensor->step(), SensorPage::Step::Choose);
    QVERIFY2(told().contains(u"1 of 6 faces were measured; nothing of it is on the board."_s),
             qPrintable(told()));
    workspace().changeWorld(u"pose=0"_s);
    auto *setup = m_rig->page<SetupPage>();
    setup->box(SetupPage::Task::Orientation)->setChecked(false);
    setup->continueButton()->click();
    QTRY_COMPARE(setup->step(), SetupPage::Step::Poles);
    m_rig->window().showPage(u"dashboard"_s);
    QVERIFY(pull());
    QCOMPARE(setup->step(), SetupPage::Step::Choose);
    QVERIFY2(told().contains(u"The gimbal setup ended with the link. What was set by then is in use"_s),
             qPrintable(told()));
    QVERIFY(!workspace().isGuided());
    m_rig->window().messageBar()->hide();
    setup->continueButton()->click();
    QTRY_COMPARE(setup->step(), SetupPage::Step::Poles);
    workspace().changeWorld(u"reset=0"_s);
    QTRY_VERIFY(told().contains(u"The gimbal setup ended with the link."_s));
    QVERIFY2(told().contains(u"is lost: the board restarted."_s) && !told().contains(u"is in use and not"_s),
             qPrintable(told()));
}

void TestStormMotion::steeringByAngleAndByPulse()
{
    QVERIFY(openStorm());
    workspace().changeWorld(u"shake=0"_s);
    auto *page = m_rig->page<ControlPage>();
    const ChannelRoles roles = workspace().roles();
    const int input = findChannel(m_rig->client().device()->channels(), u"input.pitch"_s);
    named<QComboBox>(page, u"Mode of control"_s)
        ->setCurrentIndex(named<QComboBox>(page, u"Mode of control"_s)->findData(1));
    page->setArmed(true);
    QVERIFY(page->isArmed());
    named<QPushButton>(page, u"To the middle"_s)->click();  // yaw pans: what holds it is not known
    const auto spins = page->findChildren<QDoubleSpinBox *>();
    const auto pitch = std::find_if(spins.begin(), spins.end(), [](QDoubleSpinBox *box) {
        return box->accessibleName().contains(u"Pitch"_s);
    });
    QVERIFY(pitch != spins.end());
    (*pitch)->setValue(12);
    QTRY_VERIFY(std::abs(workspace().latest(roles.angle[1]) - 12) < 1.0);
    (*pitch)->setValue(90);  // within the limits of the sticks: 25 degrees
    QTRY_VERIFY(std::abs(workspace().latest(roles.angle[1]) - 25) < 1.0);
    const LinkStatistics before = m_rig->client().statistics();
    (*pitch)->setValue(0);
    QTRY_VERIFY(std::abs(workspace().latest(roles.angle[1])) < 1.0);
    // One request at a time: nothing was asked twice, no answer was taken for another's.
    QCOMPARE(m_rig->client().statistics().timeouts, before.timeouts);
    QCOMPARE(m_rig->client().statistics().framing.bodyErrors, 0U);
    named<QComboBox>(page, u"Mode of control"_s)
        ->setCurrentIndex(named<QComboBox>(page, u"Mode of control"_s)->findData(3));
    page->setArmed(true);
    (*pitch)->setValue(250);
    QTRY_COMPARE(int(workspace().latest(input)), 250);
    page->setArmed(false);
}

// The board does not tell where it wants the camera: it is brought to its middle, and what was sent stands
// for the target.
void TestStormMotion::stepsAreMeasuredWithoutToldTargets()
{
    QVERIFY(openStorm());
    workspace().changeWorld(u"shake=0"_s);
    m_rig->edit(u"rc.yaw.speed_limit"_s, 0, 0);  // else a step is a ramp
    QVERIFY(writeAll());
    const int yaw = workspace().roles().angle[2];
    workspace().perform(u"angle"_s, {{u"yaw"_s, 20}});
    QTRY_VERIFY(std::abs(workspace().latest(yaw) - 20) < 1.0);
    auto *page = m_rig->page<ResponsePage>();
    const auto *ways = qobject_cast<QStandardItemModel *>(page->wayChoice()->model());
    QVERIFY(ways->item(0)->isEnabled() && !ways->item(1)->isEnabled() && !ways->item(2)->isEnabled());
    named<QComboBox>(page, u"Axis"_s)->setCurrentIndex(2);  // nothing pulls at yaw
    const auto measured = [page] { return measure(*page) ? page->records().back() : ResponseRecord(); };
    const ResponseRecord usual = measured();
    QVERIFY(std::abs(workspace().latest(yaw)) < 1.0);
    QVERIFY(usual.steps.metrics.riseSeconds);
    AxisGains gains;
    gains.p
        = m_rig->spec(u"pid.yaw.p"_s).toDisplay(m_rig->raw(u"pid.yaw.p"_s)) * storm32::SimulatedBoard::kUnitP;
    gains.i
        = m_rig->spec(u"pid.yaw.i"_s).toDisplay(m_rig->raw(u"pid.yaw.i"_s)) * storm32::SimulatedBoard::kUnitI;
    gains.d
        = m_rig->spec(u"pid.yaw.d"_s).toDisplay(m_rig->raw(u"pid.yaw.d"_s)) * storm32::SimulatedBoard::kUnitD;
    gains.dLpfHz = 1000.0 / (2.0 * std::numbers::pi * 1.5);
    const auto wanted
        = stepMetrics(LoopMath{simulatedMechanics(Axis::Yaw), gains}.step(1250, 0.95), 1250, 0, 1);
    QVERIFY(wanted && wanted->riseSeconds);
    qInfo("rise %.1f ms, mathematics %.1f ms; overshoot %.1f %%, mathematics %.1f %%",
          *usual.steps.metrics.riseSeconds * 1000, *wanted->riseSeconds * 1000, usual.steps.metrics.overshoot,
          wanted->overshoot);
    QVERIFY(std::abs(*usual.steps.metrics.riseSeconds - *wanted->riseSeconds)
            < 0.3 * *wanted->riseSeconds + 0.01);
    QVERIFY(std::abs(usual.steps.metrics.overshoot - wanted->overshoot) < 12.0);
    // Less damping shows.
    m_rig->edit(u"pid.yaw.d"_s, 0, m_rig->raw(u"pid.yaw.d"_s) / 3);
    QVERIFY(writeAll());
    m_rig->page<ResponsePage>();
    const ResponseRecord lively = measured();
    QVERIFY2(
        lively.steps.metrics.overshoot > usual.steps.metrics.overshoot + 10,
        qPrintable(u"%1 after %2"_s.arg(lively.steps.metrics.overshoot).arg(usual.steps.metrics.overshoot)));
}

void TestStormMotion::stepsAreRefusedWhereNothingHolds()
{
    QVERIFY(openStorm());
    workspace().setMotors(false);
    QTRY_VERIFY(!workspace().motorsRunning().value_or(true));
    auto *page = m_rig->page<ResponsePage>();
    QSignalSpy problems(&workspace().notifications(), &Notifications::problem);
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QTRY_VERIFY(!page->isRunning());
    QCOMPARE(problems.count(), 1);
    // On the way to its middle the motors go off: it ends.
    workspace().setMotors(true);
    QTRY_VERIFY(workspace().motorsRunning().value_or(false));
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QVERIFY(page->isRunning());
    workspace().setMotors(false);
    QTRY_VERIFY(!page->isRunning());
    QVERIFY(page->records().empty());
}

void TestStormMotion::functionsAreAtHandWhileSteering()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<ControlPage>();
    QPushButton *pan = nullptr;
    for (QPushButton *button : page->findChildren<QPushButton *>()) {
        if (button->text() == u"Pan mode"_s)
            pan = button;
    }
    QVERIFY(pan && pan->isVisible());
    auto *choice = page->findChild<QComboBox *>(u"mode"_s);
    QVERIFY(choice);
    choice->setCurrentIndex(3);  // pan pan pan
    pan->click();
    const int status2 = findChannel(m_rig->client().device()->channels(), u"status2"_s);
    QTRY_COMPARE(int(workspace().latest(status2)) & 0xE000, 0xE000);
#if GIMBAL_WITH_SIMPLEBGC
    // A board without such actions has no such card.
    QVERIFY(m_rig->open());
    QTRY_VERIFY(!pan || !page->findChild<QComboBox *>(u"mode"_s));
#endif
}

void TestStormMotion::motorsOffWorksThroughMavlink()
{
    QVERIFY(openStorm(u"?rate=115200"_s));
    QTRY_VERIFY(workspace().motorsRunning().value_or(false));
    m_rig->edit(u"mavlink.heartbeat"_s, 0, 2);
    QVERIFY(writeAll());
    QSignalSpy done(&m_rig->client(), &DeviceClient::motorsOffFinished);
    workspace().setMotors(false);
    QTRY_COMPARE(done.count(), 1);
    QVERIFY(done.first().first().toBool());
    QTRY_VERIFY(!workspace().motorsRunning().value_or(true));
}

void TestStormMotion::wholeDayOverAPseudoTerminal_data()
{
    QTest::addColumn<QString>("firmware");
    for (const char *firmware : {"0.79", "0.90", "0.96"})
        QTest::newRow(firmware) << QString::fromLatin1(firmware);
}

// Its motors run soon, without being told to.
void TestStormMotion::startingBoardIsOfferedAStop()
{
    QVERIFY(openStorm());
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(true));
    workspace().setMotors(false);
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
    QVERIFY(!workspace().isStarting());
    askToStartMotors(workspace(), &m_rig->window());
    QVERIFY(m_rig->window().panels()->isOpen());
    workspace().perform(u"restart"_s, {});
    QTRY_VERIFY(workspace().isStarting() && workspace().motorsRunning() == std::optional(false));
    QTRY_VERIFY(!m_rig->window().panels()->isOpen());
    const QPushButton *motors = m_rig->window().findChild<LinkBar *>()->motorsButton();
    QTRY_VERIFY(motors->text().contains(u"STOP"_s) && motors->isEnabled());
    workspace().setMotors(false);
    QTRY_VERIFY(!workspace().isStarting());
    QCOMPARE(workspace().motorsRunning(), std::optional(false));
}

// Read, edit, review, write, restart, read again, compare, calibrate, tune, store, steer and record, over a
// terminal with the real serial port, without saying which family it is.
void TestStormMotion::wholeDayOverAPseudoTerminal()
{
    QFETCH(QString, firmware);
    const QString path = m_rig->filePath(u"storm"_s);
    SimProcess board({u"--pty"_s, path, u"--rate"_s, u"115200"_s, u"--firmware"_s, firmware}, u"storm32"_s);
    QVERIFY(!board.address().isEmpty());
    QVERIFY(m_rig->open(u"serial:"_s + path));
    QCOMPARE(m_rig->client().identity().family, u"storm32"_s);
    QCOMPARE(m_rig->client().identity().firmware, firmware);
    QVERIFY(ready());
    const QString before = m_rig->filePath(u"before.cfg"_s);
    QVERIFY(workspace().saveFile(before));
    m_rig->edit(u"pid.roll.p"_s, 0, 430);
    m_rig->edit(u"rc.pitch.max"_s, 0, 300);
    QCOMPARE(m_rig->model().changeCount(), 2);
    QVERIFY(writeAll());  // by the review of these changes, read back and stored
    QVERIFY(!workspace().isUnstored());
    workspace().perform(u"restart"_s, {});
    QSignalSpy read(&workspace(), &Workspace::boardRead);
    workspace().readBoard();
    QTRY_VERIFY(read.count() >= 1);
    QCOMPARE(m_rig->raw(u"pid.roll.p"_s), 430);
    QCOMPARE(m_rig->raw(u"rc.pitch.max"_s), 300);
    QVERIFY(workspace().applyFile(before));  // the way back: what differs becomes an edit
    QCOMPARE(m_rig->model().changeCount(), 2);
    workspace().edits().discardAll();

    board.process().write("pose=1\n");
    auto *sensor = m_rig->page<SensorPage>();
    sensor->start(false);
    QTRY_VERIFY2(sensor->step() == SensorPage::Step::Result, qPrintable(sensor->sees()));
    sensor->storeButton()->click();
    QTRY_COMPARE(sensor->step(), SensorPage::Step::Choose);
    board.process().write("pose=0\n");

    auto *tuning = m_rig->page<TuningPage>();
    QTRY_VERIFY(tuning->live().value(m_rig->spec(u"pid.pitch.d"_s).id));
    tuning->live().setValue(m_rig->spec(u"pid.pitch.d"_s).id, 600);
    QTRY_VERIFY(tuning->live().isSettled());
    QCOMPARE(inUse(2), 600);
    QVERIFY(!workspace().live().unsaved().empty() && named<QPushButton>(tuning, u"Store"_s)->isEnabled());
    QTRY_VERIFY(m_rig->window().findChild<UnstoredBar *>()->isVisible());
    named<QPushButton>(tuning, u"Store"_s)->click();
    QTRY_COMPARE(m_rig->raw(u"pid.pitch.d"_s), 600);
    QTRY_VERIFY(!workspace().isUnstored());
    workspace().perform(u"reset"_s, {});
    QTRY_COMPARE(inUse(2), 600);  // it was stored

    auto *response = m_rig->page<ResponsePage>();
    QTRY_VERIFY(workspace().motorsRunning().value_or(false));
    QVERIFY(measure(*response));

    auto *control = m_rig->page<ControlPage>();
    named<QComboBox>(control, u"Mode of control"_s)
        ->setCurrentIndex(named<QComboBox>(control, u"Mode of control"_s)->findData(1));
    control->setArmed(true);
    named<QPushButton>(control, u"To the middle"_s)->click();
    for (QDoubleSpinBox *box : control->findChildren<QDoubleSpinBox *>()) {
        if (box->accessibleName().contains(u"Pitch"_s))
            box->setValue(15);
    }
    QTRY_VERIFY(std::abs(workspace().latest(workspace().roles().angle[1]) - 15) < 1.5);
    control->setArmed(false);

    const QString file = m_rig->filePath(u"day.gimbalrec"_s);
    QVERIFY(workspace().recorder().savePast(file));
    QTRY_VERIFY(Recording::load(file).has_value());
    QCOMPARE(Recording::describe(file)->value(u"family"_s).toString(), u"storm32"_s);
}

QTEST_MAIN(TestStormMotion)
#include "tst_stormmotion.moc"
