// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/navigation.h"
#include "app/pages/backupspage.h"
#include "app/pages/consolepage.h"
#include "app/pages/controlpage.h"
#include "app/pages/gaincard.h"
#include "app/pages/parameterspage.h"
#include "app/pages/responsepage.h"
#include "app/pages/scriptspage.h"
#include "app/pages/sharedialog.h"
#include "app/pages/spectrumpage.h"
#include "app/pages/tuningpage.h"
#include "app/wizards/sensorpage.h"
#include "app/wizards/setuppage.h"
#include "protocol/record/recording.h"
#include "protocol/simulator/stormboard.h"
#include "tests/support/loopmath.h"
#include "tests/support/simprocess.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/parameterform.h"
#include "widgets/forms/reviewdialog.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/models/framelogmodel.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/controlpad.h"
#include "widgets/views/scripteditor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QTableWidget>
#include <QTest>

#include <numbers>

using namespace Qt::StringLiterals;

/// The operator's work with a STorM32 board, on the simulated one.
class TestStorm : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }

    void onlyFittingPagesAreOffered();
    void slidersSetThreeGains();
    void unstoredValuesStayInSight();
    void closingAsksForWhatIsNotStored();
    void valuesWithoutEffectAreGrey();
    void scriptIsTypedTakenOverAndWritten();
    void scriptsAreEditedInAFile();
    void sensorIsCalibratedAndStored();
    void calibrationComesFromAFile();
    void gimbalIsSetUp_data();
    void gimbalIsSetUp();
    void setupCanBeCancelled();
    void steeringByAngleAndByPulse();
    void stepsAreMeasuredWithoutToldTargets();
    void stepsAreRefusedWhereNothingHolds();
    void spectrumOfPolledSamples();
    void consoleLeavesPollingOut();
    void snapshotsShowWhatDiffers();
    void functionsAreAtHandWhileSteering();
    void heartbeatIsEscapedByOneClick();
    void motorsOffWorksThroughMavlink();
    void settingsAreShared();
    void settingsFileIsLoadedAndSaved();
    void wholeDayOverAPseudoTerminal_data();
    void wholeDayOverAPseudoTerminal();

private:
    bool openStorm(const QString &options = {}) { return m_rig->open(u"sim:storm32"_s + options) && ready(); }
    bool ready()
    {
        return QTest::qWaitFor([this] { return m_rig->workspace().motorsRunning().has_value(); }, 10000);
    }
    Workspace &workspace() { return m_rig->workspace(); }
    /// A word as the board uses it now, asked past all models.
    int inUse(int word)
    {
        std::optional<int> value;
        m_rig->client().submit<std::vector<AdjustableValue>>([word](Channel &channel, Device &device) {
            return device.readAdjustables(channel, {word});
        }).then(this, [&value](const Result<std::vector<AdjustableValue>> &read) { value = read ? int(read->front().value) : -1; });
        return QTest::qWaitFor([&value] { return value.has_value(); }, 5000) ? *value : -1;
    }
    bool writeAll()
    {
        QSignalSpy finished(&workspace(), &Workspace::writeFinished);
        m_rig->window().review();
        if (!QTest::qWaitFor([this] { return m_rig->window().reviewDialog() != nullptr; }, 3000))
            return false;
        m_rig->window().reviewDialog()->accept();
        return QTest::qWaitFor([&finished] { return finished.count() == 1; }, 20000) && workspace().lastReport()->isComplete();
    }

    std::unique_ptr<WindowRig> m_rig;
};

void TestStorm::onlyFittingPagesAreOffered()
{
    const Navigation &pages = *m_rig->window().navigation();
    QVERIFY(pages.isOffered(u"calibration"_s) && !pages.isOffered(u"sensor"_s));   // before any board
    QVERIFY(openStorm());
    for (const char *there : {"dashboard", "parameters", "setup", "sensor", "scripts", "tuning", "control", "backups"})
        QVERIFY2(pages.isOffered(QLatin1String(there)), there);
    for (const char *absent : {"calibration", "autotune", "profiles", "debug"}) {
        QVERIFY2(!pages.isOffered(QLatin1String(absent)), absent);
        QVERIFY(!m_rig->window().showPage(QLatin1String(absent)));
    }
    QCOMPARE(pages.pageOfNumber(4), u"setup"_s);    // numbers count what is listed
    m_rig->window().showPage(u"scripts"_s);
    QVERIFY(m_rig->open());
    QTRY_VERIFY(pages.isOffered(u"calibration"_s) && !pages.isOffered(u"scripts"_s));
    QCOMPARE(pages.pageOfNumber(7), u"tuning"_s);
    QCOMPARE(pages.pageOfNumber(99), QString());
    QCOMPARE(pages.currentPage(), u"dashboard"_s);   // the page that was shown is gone
}

void TestStorm::slidersSetThreeGains()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<TuningPage>();
    QVERIFY(page->gains());
    const auto value = [&](const char *key) { return page->live().value(m_rig->spec(QLatin1String(key)).id).value_or(-1); };
    QTRY_COMPARE(value("pid.roll.p"), 400);
    QVERIFY(page->gains()->shapeText(Axis::Roll).contains(u"7.1 Hz"_s));
    page->gains()->dampingSlider(Axis::Roll)->setValue(50);
    page->gains()->stabilitySlider(Axis::Roll)->setValue(20);
    // Kd 0.4, Ki 400, Kp sqrt(0.5 * 0.4 * 400) = 8.94 (errata 9.1)
    QTRY_COMPARE(value("pid.roll.d"), 4000);
    QCOMPARE(value("pid.roll.i"), 4000);
    QCOMPARE(value("pid.roll.p"), 894);
    QTRY_VERIFY(page->live().isSettled());
    QCOMPARE(inUse(8), 4000);
    QCOMPARE(inUse(6), 894);
    // The other way round: a gain moves the slider.
    page->live().setValue(m_rig->spec(u"pid.pitch.i"_s).id, 2000);
    QCOMPARE(page->gains()->stabilitySlider(Axis::Pitch)->value(), 10);
    page->revertButton()->click();
    QTRY_COMPARE(inUse(8), 500);
    QCOMPARE(page->gains()->dampingSlider(Axis::Roll)->value(), 6);
}

void TestStorm::unstoredValuesStayInSight()
{
    QVERIFY(openStorm());
    UnstoredBar *bar = m_rig->window().unstoredBar();
    QVERIFY(!bar->isVisible());
    auto *page = m_rig->page<TuningPage>();
    QTRY_VERIFY(page->live().value(m_rig->spec(u"pid.yaw.p"_s).id));
    page->live().setValue(m_rig->spec(u"pid.yaw.p"_s).id, 421);
    QTRY_VERIFY(bar->isVisible());
    m_rig->window().showPage(u"dashboard"_s);
    QVERIFY(bar->isVisible());              // on every page
    bar->storeButton()->click();
    QTRY_VERIFY_WITH_TIMEOUT(!bar->isVisible(), 10000);
    QTRY_COMPARE(m_rig->raw(u"pid.yaw.p"_s), 421);
    workspace().perform(u"restart"_s, {});
    QTRY_COMPARE_WITH_TIMEOUT(inUse(12), 421, 8000);

    // A restart that was asked for elsewhere takes live values with it; the pages know.
    page->live().setValue(m_rig->spec(u"pid.yaw.p"_s).id, 433);
    QTRY_VERIFY(bar->isVisible());
    QTRY_COMPARE(inUse(12), 433);
    workspace().perform(u"restart"_s, {});
    QTRY_VERIFY_WITH_TIMEOUT(!bar->isVisible(), 10000);
    QTRY_COMPARE(page->live().value(m_rig->spec(u"pid.yaw.p"_s).id), std::optional(421));

    // An action that changes what is in use says so as well, and there is a way back.
    workspace().perform(u"defaults"_s, {});
    QTRY_VERIFY(workspace().isUnstored() && bar->isVisible());
    QTRY_COMPARE(inUse(12), 400);
    bar->backButton()->click();
    QTRY_VERIFY_WITH_TIMEOUT(!workspace().isUnstored() && !bar->isVisible(), 10000);
    QTRY_COMPARE(inUse(12), 421);
}

void TestStorm::closingAsksForWhatIsNotStored()
{
    QVERIFY(openStorm());
    workspace().perform(u"directions.take"_s, {});
    QTRY_VERIFY(workspace().isUnstored());
    m_rig->window().close();
    auto *box = m_rig->window().findChild<QMessageBox *>();
    QVERIFY(box && m_rig->window().isVisible());
    for (QAbstractButton *button : box->buttons()) {
        if (box->buttonRole(button) == QMessageBox::AcceptRole)
            button->click();
    }
    QTRY_VERIFY_WITH_TIMEOUT(!m_rig->window().isVisible(), 10000);
    QVERIFY(!workspace().isUnstored());
}

void TestStorm::valuesWithoutEffectAreGrey()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<ParametersPage>();
    page->showParameter(u"pan.mode.setting1"_s);
    auto *form = page->findChild<ParameterForm *>();
    ValueEditor *editor = form->editor(m_rig->spec(u"pan.mode.setting1"_s).id);
    QVERIFY(editor);
    QVERIFY(editor->control()->property("idle").toBool());
    QVERIFY2(editor->control()->toolTip().contains(u"No effect while"_s), qPrintable(editor->control()->toolTip()));
    QVERIFY(editor->control()->isEnabled());      // it can be prepared all the same
    m_rig->edit(u"pan.mode.input"_s, 0, 1);
    QVERIFY(!editor->control()->property("idle").toBool());
    QVERIFY(!editor->control()->toolTip().contains(u"No effect while"_s));
    workspace().edits().undoStack().undo();
    QVERIFY(editor->control()->property("idle").toBool());
}

void TestStorm::scriptIsTypedTakenOverAndWritten()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<ScriptsPage>();
    QTRY_VERIFY(page->editor()->isEnabled());
    QCOMPARE(page->scriptList()->count(), 4);
    page->editor()->setFocus();
    QTest::keyClicks(page->editor(), u"WAIT 5"_s);
    QTest::keyClick(page->editor(), Qt::Key_Escape);   // completion
    QTest::keyClick(page->editor(), Qt::Key_Return);
    QTest::keyClicks(page->editor(), u"FLY"_s);
    QTRY_VERIFY2(page->message().contains(u"line 2"_s), qPrintable(page->message()));
    QVERIFY(!page->takeButton()->isEnabled());
    QVERIFY(page->hasChanges() && m_rig->window().navigation()->isMarked(u"scripts"_s));
    page->editor()->setText(u"; a while\nWAIT 5\nDORECENTER\n"_s);
    QTRY_VERIFY(page->takeButton()->isEnabled());
    QCOMPARE(page->listing()->count(), 3);              // and the STOP that was put behind
    QVERIFY(page->listing()->item(0)->text().contains(u"WAIT 5"_s));
    QCOMPARE(m_rig->model().changeCount(), 0);
    page->takeButton()->click();
    QCOMPARE(m_rig->model().changeCount(), 1);
    QVERIFY(page->editor()->text().contains(u"a while"_s));   // as it was typed
    // An edit like any other: undone, done again, written, read back.
    workspace().edits().undoStack().undo();
    QCOMPARE(m_rig->model().changeCount(), 0);
    QVERIFY(page->editor()->text().isEmpty());
    workspace().edits().undoStack().redo();
    QVERIFY(page->editor()->text().contains(u"DORECENTER"_s));
    QVERIFY(writeAll());
    QCOMPARE(m_rig->model().changeCount(), 0);
    QVERIFY(!page->hasChanges());
    QSignalSpy read(&workspace(), &Workspace::boardRead);
    workspace().readBoard();
    QTRY_COMPARE(read.count(), 1);
    QVERIFY(workspace().family()->scripts->text(std::as_const(m_rig->model()).board(), 0).contains(u"DORECENTER"_s));
    // Tab leaves the editor.
    page->editor()->setFocus();
    QTest::keyClick(page->editor(), Qt::Key_Tab);
    QVERIFY(!page->editor()->hasFocus());
}

void TestStorm::scriptsAreEditedInAFile()
{
    QVERIFY(openStorm());
    const QString path = m_rig->filePath(u"board.json"_s);
    QVERIFY(workspace().saveFile(path));
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!m_rig->client().isConnected());
    QVERIFY(workspace().openFile(path));
    auto *page = m_rig->page<ScriptsPage>();
    QVERIFY(page->editor()->isEnabled());
    page->showScript(2);
    page->editor()->setText(u"STOP\n"_s);
    QTRY_VERIFY(page->takeButton()->isEnabled());
    page->takeButton()->click();
    QVERIFY(workspace().saveFile(path));
    const auto file = workspace().loadFile(path);
    QVERIFY(file);
    QVERIFY(workspace().family()->scripts->text(file->configuration, 2).contains(u"STOP"_s));
}

void TestStorm::sensorIsCalibratedAndStored()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<SensorPage>();
    workspace().changeWorld(u"pose=1"_s);
    page->start(true);
    const std::array poses{1, 4, 2, 6, 3, 5};
    for (std::size_t i = 0; i < poses.size(); ++i) {
        workspace().changeWorld(u"pose=%1"_s.arg(poses[i]));
        QTRY_VERIFY2_WITH_TIMEOUT(page->doneCount() == int(i) + 1 || page->step() == SensorPage::Step::Result, qPrintable(page->sees()), 20000);
    }
    QTRY_COMPARE(page->step(), SensorPage::Step::Result);
    QVERIFY(std::abs(page->calibration().scale[2] - 8356) < 60);    // 1.02 of 8192, the simulated sensor's own error
    // Nothing was changed so far.
    std::optional<int> scale;
    const auto stored = [&] {
        scale.reset();
        workspace().perform(u"calibration.read"_s, {}).then(this, [&](const Result<ActionOutcome> &reply) {
            scale = reply ? reply->reply.value(u"imu.acc.scale.z"_s).toInt() : -1;
        });
        return QTest::qWaitFor([&] { return scale.has_value(); }, 5000) ? *scale : -1;
    };
    QCOMPARE(stored(), 8192);
    const QString file = m_rig->filePath(u"imu.cal"_s);
    QVERIFY(page->saveFile(file));
    page->storeButton()->click();
    QTRY_COMPARE_WITH_TIMEOUT(page->step(), SensorPage::Step::Choose, 10000);
    QCOMPARE(stored(), page->calibration().scale[2]);
}

void TestStorm::calibrationComesFromAFile()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<SensorPage>();
    const QString path = m_rig->filePath(u"imu.cal"_s);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("IMUNAME: Imu\nAXZERO: 1\nAYZERO: 2\nAZZERO: 3\nAXSCALE: 8190\nAYSCALE: 8191\nAZSCALE: 8200\nCALIBRATIONMETHOD: 1 point\n");
    file.close();
    QVERIFY(page->loadFile(path));
    QCOMPARE(page->step(), SensorPage::Step::Result);
    page->storeButton()->click();
    QTRY_COMPARE_WITH_TIMEOUT(page->step(), SensorPage::Step::Choose, 10000);
    QVERIFY(!page->loadFile(m_rig->filePath(u"none.cal"_s)));
}

void TestStorm::gimbalIsSetUp_data()
{
    QTest::addColumn<bool>("terminal");
    QTest::newRow("in the program") << false;
    QTest::newRow("over a pseudo-terminal") << true;
}

void TestStorm::gimbalIsSetUp()
{
    QFETCH(bool, terminal);
    std::unique_ptr<SimProcess> board;
    if (terminal) {
        const QString path = m_rig->filePath(u"storm"_s);
        board = std::make_unique<SimProcess>(QStringList{u"--pty"_s, path, u"--rate"_s, u"115200"_s}, u"storm32"_s);
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
    QTRY_VERIFY2_WITH_TIMEOUT(page->step() == Step::Orientation && page->what().contains(u"45°"_s), qPrintable(page->what()), 15000);
    QVERIFY(workspace().isUnstored());
    changeWorld("pose=7");
    QTRY_COMPARE_WITH_TIMEOUT(page->step(), Step::Poles, 15000);
    QVERIFY2(page->report().last().contains(u"x90°"_s), qPrintable(page->report().last()));
    QCOMPARE(inUse(39), 5);
    page->poles(Axis::Yaw)->setValue(16);
    page->continueButton()->click();
    QTRY_COMPARE_WITH_TIMEOUT(page->step(), Step::AskStart, 8000);
    QCOMPARE(inUse(32), 16);
    QCOMPARE(inUse(21), 2);
    page->poles(Axis::Yaw)->setValue(14);
    QVERIFY(!workspace().motorsRunning().value_or(true));     // nothing moves before it is asked
    page->continueButton()->click();
    QTRY_VERIFY_WITH_TIMEOUT(page->step() == Step::AlignYaw && page->continueButton()->isEnabled(), 40000);
    QCOMPARE(inUse(21), 0);
    QTRY_VERIFY(workspace().motorsRunning().value_or(false));
    for (QPushButton *button : page->findChildren<QPushButton *>()) {
        if (button->text() == u"+5°"_s)
            button->click();
    }
    QCOMPARE(page->yaw(), 5.0);
    QTRY_COMPARE(inUse(108), 50);
    page->continueButton()->click();
    QTRY_COMPARE_WITH_TIMEOUT(page->step(), Step::AskFinish, 8000);
    QCOMPARE(inUse(108), 0);
    page->continueButton()->click();
    QTRY_COMPARE_WITH_TIMEOUT(page->step(), Step::Done, 40000);
    QVERIFY(!workspace().isUnstored());
    QTRY_COMPARE(m_rig->raw(u"imu.orientation"_s), 5);
    QCOMPARE(m_rig->raw(u"motor.yaw.poles"_s), 16);
    workspace().perform(u"reset"_s, {});
    QTRY_COMPARE_WITH_TIMEOUT(inUse(39), 5, 8000);           // kept over a restart
}

void TestStorm::setupCanBeCancelled()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<SetupPage>();
    for (const auto task : {SetupPage::Task::Orientation, SetupPage::Task::Poles, SetupPage::Task::AutoDirections})
        page->box(task)->setChecked(false);
    workspace().changeWorld(u"battery=7"_s);
    page->continueButton()->click();
    QTRY_COMPARE_WITH_TIMEOUT(page->step(), SetupPage::Step::AskStart, 8000);
    page->continueButton()->click();
    QTRY_VERIFY2(page->sees().contains(u"battery"_s), qPrintable(page->sees()));
    page->cancelButton()->click();
    QCOMPARE(page->step(), SetupPage::Step::Choose);
    QVERIFY(workspace().isUnstored());                        // the motors are disabled, and it says so
    QTRY_COMPARE(inUse(79), 3);
    m_rig->window().unstoredBar()->backButton()->click();
    QTRY_COMPARE_WITH_TIMEOUT(inUse(79), 0, 8000);
    // Nothing ticked: nothing to begin.
    for (int task = 0; task < SetupPage::kTasks; ++task)
        page->box(SetupPage::Task(task))->setChecked(false);
    QVERIFY(!page->continueButton()->isEnabled());
}

void TestStorm::steeringByAngleAndByPulse()
{
    QVERIFY(openStorm());
    workspace().changeWorld(u"shake=0"_s);
    auto *page = m_rig->page<ControlPage>();
    const ChannelRoles roles = workspace().roles();
    const int input = findChannel(m_rig->client().device()->channels(), u"input.pitch"_s);
    page->modeBox()->setCurrentIndex(page->modeBox()->findData(1));
    page->setArmed(true);
    QVERIFY(page->isArmed());
    const auto spins = page->findChildren<QDoubleSpinBox *>();
    const auto pitch = std::find_if(spins.begin(), spins.end(), [](QDoubleSpinBox *box) { return box->accessibleName().contains(u"Pitch"_s); });
    QVERIFY(pitch != spins.end());
    (*pitch)->setValue(12);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(workspace().latest(roles.angle[1]) - 12) < 1.0, 8000);
    (*pitch)->setValue(90);   // within the limits of the sticks: 25 degrees
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(workspace().latest(roles.angle[1]) - 25) < 1.0, 8000);
    const LinkStatistics before = m_rig->client().statistics();
    (*pitch)->setValue(0);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(workspace().latest(roles.angle[1])) < 1.0, 8000);
    // One request at a time: nothing was asked twice, no answer was taken for another's.
    QCOMPARE(m_rig->client().statistics().timeouts, before.timeouts);
    QCOMPARE(m_rig->client().statistics().framing.bodyErrors, 0U);
    page->modeBox()->setCurrentIndex(page->modeBox()->findData(3));
    page->setArmed(true);
    (*pitch)->setValue(250);
    QTRY_COMPARE_WITH_TIMEOUT(int(workspace().latest(input)), 250, 5000);
    page->setArmed(false);
}

// The board does not tell where it wants the camera: it is brought to its middle, and what was sent stands for the target.
void TestStorm::stepsAreMeasuredWithoutToldTargets()
{
    QVERIFY(openStorm());
    workspace().changeWorld(u"shake=0"_s);
    m_rig->edit(u"rc.yaw.speed_limit"_s, 0, 0);   // else a step is a ramp
    QVERIFY(writeAll());
    const int yaw = workspace().roles().angle[2];
    workspace().perform(u"angle"_s, {{u"yaw"_s, 20}});
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(workspace().latest(yaw) - 20) < 1.0, 8000);
    auto *page = m_rig->page<ResponsePage>();
    const auto *ways = qobject_cast<QStandardItemModel *>(page->wayChoice()->model());
    QVERIFY(ways->item(0)->isEnabled() && !ways->item(1)->isEnabled() && !ways->item(2)->isEnabled());
    page->axisChoice()->setCurrentIndex(2);       // nothing pulls at yaw
    const auto measure = [&]() -> ResponseRecord {
        const auto before = page->records().size();
        QTest::mouseClick(page->armButton(), Qt::LeftButton);
        QTest::mouseClick(page->startButton(), Qt::LeftButton);
        if (!page->isRunning() || !QTest::qWaitFor([&] { return page->records().size() == before + 1; }, 30000))
            return {};
        return page->records().back();
    };
    const ResponseRecord usual = measure();
    QVERIFY(std::abs(workspace().latest(yaw)) < 1.0);
    QVERIFY(usual.steps.metrics.riseSeconds);
    AxisGains gains;
    gains.p = m_rig->spec(u"pid.yaw.p"_s).toDisplay(m_rig->raw(u"pid.yaw.p"_s)) * StormBoard::kUnitP;
    gains.i = m_rig->spec(u"pid.yaw.i"_s).toDisplay(m_rig->raw(u"pid.yaw.i"_s)) * StormBoard::kUnitI;
    gains.d = m_rig->spec(u"pid.yaw.d"_s).toDisplay(m_rig->raw(u"pid.yaw.d"_s)) * StormBoard::kUnitD;
    gains.dLpfHz = 1000.0 / (2.0 * std::numbers::pi * 1.5);
    const auto wanted = stepMetrics(LoopMath{simulatedMechanics(Axis::Yaw), gains}.step(1250, 0.95), 1250, 0, 1);
    QVERIFY(wanted && wanted->riseSeconds);
    qInfo("rise %.1f ms, mathematics %.1f ms; overshoot %.1f %%, mathematics %.1f %%", *usual.steps.metrics.riseSeconds * 1000,
          *wanted->riseSeconds * 1000, usual.steps.metrics.overshoot, wanted->overshoot);
    QVERIFY(std::abs(*usual.steps.metrics.riseSeconds - *wanted->riseSeconds) < 0.3 * *wanted->riseSeconds + 0.01);
    QVERIFY(std::abs(usual.steps.metrics.overshoot - wanted->overshoot) < 12.0);
    // Less damping shows.
    m_rig->edit(u"pid.yaw.d"_s, 0, m_rig->raw(u"pid.yaw.d"_s) / 3);
    QVERIFY(writeAll());
    m_rig->page<ResponsePage>();
    const ResponseRecord lively = measure();
    QVERIFY2(lively.steps.metrics.overshoot > usual.steps.metrics.overshoot + 10,
             qPrintable(u"%1 after %2"_s.arg(lively.steps.metrics.overshoot).arg(usual.steps.metrics.overshoot)));
}

void TestStorm::stepsAreRefusedWhereNothingHolds()
{
    QVERIFY(openStorm());
    workspace().setMotors(false);
    QTRY_VERIFY(!workspace().motorsRunning().value_or(true));
    auto *page = m_rig->page<ResponsePage>();
    QSignalSpy problems(&workspace(), &Workspace::problem);
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QVERIFY(!page->isRunning());
    QCOMPARE(problems.count(), 1);
    // On the way to its middle the motors go off: it ends.
    workspace().setMotors(true);
    QTRY_VERIFY_WITH_TIMEOUT(workspace().motorsRunning().value_or(false), 30000);
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QVERIFY(page->isRunning());
    workspace().setMotors(false);
    QTRY_VERIFY(!page->isRunning());
    QVERIFY(page->records().empty());
}

void TestStorm::spectrumOfPolledSamples()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<SpectrumPage>();
    QTRY_COMPARE_WITH_TIMEOUT(page->chart()->curveCount(), 3, 15000);
    QTRY_VERIFY(page->bands()->item(0, 1) && page->bands()->item(0, 1)->text().contains(u'°'));
    const auto labels = page->findChildren<QLabel *>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](QLabel *label) { return label->text().contains(u"shows up lower"_s); }));
    // The highest band ends where the samples do.
    const auto end = [page] { return page->bands()->item(2, 0)->text().section(u'–', 1).section(u' ', 0, 0).toDouble(); };
    QTRY_VERIFY2(end() > 30 && end() < 60, qPrintable(page->bands()->item(2, 0)->text()));
    QVERIFY(!page->notchButton()->isVisible());              // such a board has no filter to put there
}

void TestStorm::consoleLeavesPollingOut()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<ConsolePage>();
    FrameLogModel &model = page->model();
    const auto count = [&model](const QString &name) {
        int found = 0;
        for (int row = 0; row < model.rowCount(); ++row)
            found += model.index(row, FrameLogModel::NameColumn).data().toString() == name ? 1 : 0;
        return found;
    };
    model.clear();
    page->input()->setText(u"getparameter index=0"_s);
    page->send();
    QTRY_COMPARE(count(u"GETPARAMETER"_s), 2);               // the question and its answer
    QVERIFY(QTest::qWaitFor([&] { return m_rig->client().telemetry()->rows() > 200; }, 10000));
    QCOMPARE(count(u"d"_s), 0);
    for (QCheckBox *box : page->findChildren<QCheckBox *>()) {
        if (box->text().contains(u"Live data"_s))
            box->setChecked(true);
    }
    QTRY_VERIFY(count(u"d"_s) > 10);
}

void TestStorm::snapshotsShowWhatDiffers()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<BackupsPage>();
    page->takeButton()->click();
    const auto says = [page](const QString &words) {
        const auto labels = page->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [&words](QLabel *label) { return label->text().startsWith(words); });
    };
    QTRY_VERIFY(says(u"All values are the same."_s));
    QVERIFY(!page->restoreButton()->isEnabled());            // this board's one profile has no name that could differ
    m_rig->edit(u"pid.roll.p"_s, 0, 555);
    workspace().perform(u"directions.take"_s, {});
    m_rig->page<ParametersPage>();
    QTRY_VERIFY(workspace().isUnstored());
    m_rig->page<BackupsPage>();
    // A snapshot says before what it was taken, by the name that the operator knows.
    const QTableWidget *whys = page->table();
    const auto named = [whys] {
        for (int row = 0; row < whys->rowCount(); ++row) {
            if (whys->item(row, 1)->text() == u"before “Take motor directions”"_s)
                return true;
        }
        return false;
    };
    QTRY_VERIFY(named());
    QTRY_VERIFY(says(u"1 value"_s));
}

void TestStorm::functionsAreAtHandWhileSteering()
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
    choice->setCurrentIndex(3);      // pan pan pan
    pan->click();
    const int status2 = findChannel(m_rig->client().device()->channels(), u"status2"_s);
    QTRY_COMPARE_WITH_TIMEOUT(int(workspace().latest(status2)) & 0xE000, 0xE000, 5000);
    // A board without such actions has no such card.
    QVERIFY(m_rig->open());
    QTRY_VERIFY(!pan || !page->findChild<QComboBox *>(u"mode"_s));
}

void TestStorm::heartbeatIsEscapedByOneClick()
{
    QVERIFY(openStorm(u"?rate=115200"_s));
    m_rig->edit(u"mavlink.heartbeat"_s, 0, 1);
    QVERIFY2(writeAll(), "a write that switches the heartbeat on is read back through MAVLink");
    QTRY_VERIFY(m_rig->raw(u"mavlink.heartbeat"_s) == 1);
    m_rig->edit(u"pid.roll.p"_s, 0, 433);
    QVERIFY(writeAll());
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!m_rig->client().isConnected());
    m_rig->window().openLink(u"sim:storm32?rate=115200"_s);
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected(), 15000);
    QTRY_VERIFY(m_rig->window().offerBar()->text().contains(u"MAVLink"_s));
    QVERIFY(ready());                                        // live data comes all the same
    QTRY_COMPARE(m_rig->raw(u"pid.roll.p"_s), 433);
    auto *page = m_rig->page<ScriptsPage>();
    QVERIFY(!page->editor()->isEnabled() && !page->message().isEmpty());
    m_rig->window().offerBar()->buttons().first()->click();
    QTRY_COMPARE_WITH_TIMEOUT(m_rig->raw(u"mavlink.heartbeat"_s), 0, 10000);
    QTRY_VERIFY_WITH_TIMEOUT(page->editor()->isEnabled(), 5000);
    QVERIFY(workspace().isUnstored());                       // it would be back after a restart, and that is said
    QVERIFY(ready());
}

void TestStorm::motorsOffWorksThroughMavlink()
{
    QVERIFY(openStorm(u"?rate=115200"_s));
    QTRY_VERIFY(workspace().motorsRunning().value_or(false));
    m_rig->edit(u"mavlink.heartbeat"_s, 0, 2);
    QVERIFY(writeAll());
    QSignalSpy done(&m_rig->client(), &DeviceClient::motorsOffFinished);
    workspace().setMotors(false);
    QTRY_COMPARE(done.count(), 1);
    QVERIFY(done.first().first().toBool());
    QTRY_VERIFY_WITH_TIMEOUT(!workspace().motorsRunning().value_or(true), 5000);
}

void TestStorm::settingsAreShared()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<BackupsPage>();
    page->findChild<QPushButton *>(u"share"_s)->click();
    auto *dialog = page->findChild<ShareDialog *>();
    QVERIFY(dialog);
    QVERIFY(dialog->image().width() > 1000 && dialog->image().height() > 500);
    const QString path = m_rig->filePath(u"settings.png"_s);
    QVERIFY(dialog->save(path));
    QCOMPARE(QImage(path).size(), dialog->image().size());
    QVERIFY(!dialog->save(u"/nowhere/settings.png"_s));
    // What is on it changes with the values.
    const QImage before = dialog->image();
    dialog->reject();
    m_rig->edit(u"pid.roll.p"_s, 0, 1234);
    const ShareDialog again(workspace());
    QVERIFY(again.image() != before);
}

void TestStorm::settingsFileIsLoadedAndSaved()
{
    QVERIFY(openStorm());
    m_rig->edit(u"pid.roll.p"_s, 0, 777);
    const QString path = m_rig->filePath(u"mine.cfg"_s);
    QVERIFY(workspace().saveFile(path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly) && file.readAll().contains("'Roll P' => [ 777 , '7.77' ],"));
    workspace().edits().discardAll();
    QVERIFY(workspace().applyFile(path));
    QCOMPARE(m_rig->model().value(m_rig->spec(u"pid.roll.p"_s), 0), 777);
    QCOMPARE(m_rig->model().changeCount(), 1);
    // Without a board it opens by itself.
    workspace().edits().discardAll();
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!m_rig->client().isConnected());
    m_rig->window().openFile(path);
    QCOMPARE(workspace().offlineFile(), path);
    QCOMPARE(m_rig->raw(u"pid.roll.p"_s), 777);
}

void TestStorm::wholeDayOverAPseudoTerminal_data()
{
    QTest::addColumn<QString>("firmware");
    for (const char *firmware : {"0.79", "0.90", "0.96"})
        QTest::newRow(firmware) << QString::fromLatin1(firmware);
}

// Read, edit, review, write, restart, read again, compare, calibrate, tune, store, steer and record, over a terminal with the real
// serial port, without saying which family it is.
void TestStorm::wholeDayOverAPseudoTerminal()
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
    QVERIFY(writeAll());                                  // by the review of these changes, read back and stored
    QVERIFY(!workspace().isUnstored());
    workspace().perform(u"restart"_s, {});
    QSignalSpy read(&workspace(), &Workspace::boardRead);
    workspace().readBoard();
    QTRY_VERIFY_WITH_TIMEOUT(read.count() >= 1, 15000);
    QCOMPARE(m_rig->raw(u"pid.roll.p"_s), 430);
    QCOMPARE(m_rig->raw(u"rc.pitch.max"_s), 300);
    QVERIFY(workspace().applyFile(before));               // the way back: what differs becomes an edit
    QCOMPARE(m_rig->model().changeCount(), 2);
    workspace().edits().discardAll();

    board.process().write("pose=1\n");
    auto *sensor = m_rig->page<SensorPage>();
    sensor->start(false);
    QTRY_VERIFY2_WITH_TIMEOUT(sensor->step() == SensorPage::Step::Result, qPrintable(sensor->sees()), 30000);
    sensor->storeButton()->click();
    QTRY_COMPARE_WITH_TIMEOUT(sensor->step(), SensorPage::Step::Choose, 10000);
    board.process().write("pose=0\n");

    auto *tuning = m_rig->page<TuningPage>();
    QTRY_VERIFY(tuning->live().value(m_rig->spec(u"pid.pitch.d"_s).id));
    tuning->live().setValue(m_rig->spec(u"pid.pitch.d"_s).id, 600);
    QTRY_VERIFY(tuning->live().isSettled());
    QCOMPARE(inUse(2), 600);
    QVERIFY(!workspace().live().unsaved().empty() && tuning->saveButton()->isEnabled());
    QTRY_VERIFY(m_rig->window().unstoredBar()->isVisible());
    tuning->saveButton()->click();
    QTRY_COMPARE_WITH_TIMEOUT(m_rig->raw(u"pid.pitch.d"_s), 600, 10000);
    QTRY_VERIFY(!workspace().isUnstored());
    workspace().perform(u"reset"_s, {});
    QTRY_COMPARE_WITH_TIMEOUT(inUse(2), 600, 15000);      // it was stored

    auto *response = m_rig->page<ResponsePage>();
    QTRY_VERIFY_WITH_TIMEOUT(workspace().motorsRunning().value_or(false), 40000);
    QTest::mouseClick(response->armButton(), Qt::LeftButton);
    QTest::mouseClick(response->startButton(), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(response->records().size(), std::size_t(1), 40000);

    auto *control = m_rig->page<ControlPage>();
    control->modeBox()->setCurrentIndex(control->modeBox()->findData(1));
    control->setArmed(true);
    for (QDoubleSpinBox *box : control->findChildren<QDoubleSpinBox *>()) {
        if (box->accessibleName().contains(u"Pitch"_s))
            box->setValue(15);
    }
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(workspace().latest(workspace().roles().angle[1]) - 15) < 1.5, 15000);
    control->setArmed(false);

    const QString file = m_rig->filePath(u"day.gimbalrec"_s);
    QVERIFY(workspace().recorder().savePast(file));
    QTRY_VERIFY(Recording::load(file).has_value());
    QCOMPARE(Recording::describe(file)->value(u"family"_s).toString(), u"storm32"_s);
}

QTEST_MAIN(TestStorm)
#include "tst_storm.moc"
