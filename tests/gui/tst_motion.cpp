// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/autotunepage.h"
#include "app/families/simplebgc/calibrationpage.h"
#include "app/mainwindow/bars.h"
#include "app/mainwindow/messagebar.h"
#include "app/pages/board/controlpage.h"
#include "app/pages/tune/responsepage.h"
#include "app/pages/tune/tuningpage.h"
#include "app/pages/tune/variablespage.h"
#include "protocol/device/steering.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/argumentform.h"
#include "widgets/forms/liveslider.h"
#include "widgets/forms/panel.h"
#include "widgets/plot/iterationchart.h"
#include "widgets/views/controlpad.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineSeries>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTableWidget>
#include <QThread>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

// Points of one line of the chart that follows auto-tuning.
int errorPoints(const QWidget *page, const QString &line)
{
    const auto *view = named<IterationChart>(page, u"Tracking error by iteration"_s);
    const auto lines = view->chart()->series();
    for (const QAbstractSeries *each : lines) {
        if (each->name() == line)
            return qobject_cast<const QLineSeries *>(each)->count();
    }
    return 0;
}

}  // namespace

/// What moves the gimbal or measures it: calibration, auto-tune, steering; to the end, cancelled, with a
/// board that misbehaves.
class TestMotion : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }

    void gyroscopeToTheEnd();
    void gyroscopeWaitsForAFrozenBoard_data();
    void gyroscopeWaitsForAFrozenBoard();
    void gyroscopeWaitsWhileItMoves();
    void calibrationCancelled();
    void calibrationShaken();
    void calibrationUnplugged();
    void sixPositionsUnplugged();
    void testUnplugged();
    void sixPositionsToTheEnd();
    void autoTuneAcceptedAndSaved();
    void autoTuneReverted();
    void autoTuneThatHarmsIsTakenBack();
    void secondClickBeginsNoSearch();
    void stoppedSearchLeavesNothing_data();
    void stoppedSearchLeavesNothing();
    void autoTuneUnplugged();
    void searchThatGoesOnIsStoppedOnceMore();
    void foundGainsUnplugged_data();
    void foundGainsUnplugged();
    void searchHoldsWhatIsInUse();
    void stopIsNeverHeld();
    void searchEndsWithItsProfile();
    void storedElsewhereIsAnAnswer();
    void measurementHoldsWhatIsInUse();
    void armingMovesNothing();
    void limpCameraIsNotArmed();
    void padSteersAndSpringsBack();
    void angleModeGoesThere();
    void keysSteer();
    void everyModeIsOffered();
    void escDisarms();
    void doingNothingDisarms();
    void leavingThePageDisarms();
    void blockedScreenStopsTheBoard();
    void unpluggedWhileSteering();
    void whateverCoversThePadEndsTheDrag();
    void endOfTheLinkIsAnEndOfSteering();

private:
    Workspace &workspace() { return m_rig->workspace(); }
    double angle(Axis axis) { return workspace().latest(workspace().roles().angle[std::size_t(axis)]); }
    double target(Axis axis) { return workspace().latest(workspace().roles().target[std::size_t(axis)]); }
    bool alive()
    {
        return QTest::qWaitFor(
            [this] {
                return workspace().motorsRunning() == std::optional(true) && !std::isnan(target(Axis::Yaw));
            },
            kPatience);
    }
    CalibrationPage *calibration(CalibrationPage::Kind kind)
    {
        auto *page = m_rig->page<CalibrationPage>();
        page->start(kind);
        return page;
    }
    /// Puts the simulated sensor somewhere and goes on as soon as the wizard is satisfied.
    bool place(CalibrationPage *page, int pose)
    {
        workspace().changeWorld(u"pose=%1"_s.arg(pose));
        if (!QTest::qWaitFor([page] { return page->isSatisfied() && page->continueButton()->isEnabled(); },
                             kPatience))
            return false;
        QTest::mouseClick(page->continueButton(), Qt::LeftButton);
        return page->step() == CalibrationPage::Step::Measure;
    }
    /// How far the measurement that is shown has come.
    static int measured(const CalibrationPage *page)
    {
        int most = 0;
        for (const QProgressBar *bar : page->findChildren<QProgressBar *>()) {
            if (bar->isVisible())
                most = std::max(most, bar->value());
        }
        return page->step() == CalibrationPage::Step::Measure ? most : 0;
    }
    AutoTunePage *autoTune()
    {
        auto *page = m_rig->page<AutoTunePage>();
        if (!QTest::qWaitFor(
                [&] {
                    return page->startButton()->isEnabled()
                        && workspace().live().value(m_rig->spec(u"pid.roll.p"_s).id).has_value();
                },
                kPatience))
            return nullptr;
        page->form()->setText(u"pitch"_s, u"off"_s);
        page->form()->setText(u"yaw"_s, u"off"_s);
        return page;
    }
    /// On every way that leads there, nothing is put into use, stored, switched or begun.
    void nothingIsPutIntoUse();
    int liveP() { return workspace().live().value(m_rig->spec(u"pid.roll.p"_s).id).value_or(-1); }
    /// What the board answers.
    int boardsP()
    {
        const int variable = m_rig->spec(u"pid.roll.p"_s).adjustable;
        std::optional<double> value;
        m_rig->client()
            .submit<std::vector<AdjustableValue>>([variable](Channel &channel, Device &device) {
                return device.live()->readAdjustables(channel, {variable});
            })
            .then(this, [&value](const Result<std::vector<AdjustableValue>> &read) {
                value = read ? read->front().value : -1;
            });
        return QTest::qWaitFor([&value] { return value.has_value(); }, kPatience) ? int(*value) : -1;
    }
    /// Board, models, foot bar, and the pages that show gains.
    static int rowOf(const AutoTunePage *page, const QString &gain);
    void gainsAreAsBefore(const AutoTunePage *page, int before);
    ControlPage *control()
    {
        if (!m_rig->open() || !alive())
            return nullptr;
        return m_rig->page<ControlPage>();
    }

    std::unique_ptr<WindowRig> m_rig;
};

void TestMotion::gyroscopeToTheEnd()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    CalibrationPage *page = calibration(CalibrationPage::Kind::Gyroscope);
    QVERIFY(place(page, 1));
    QVERIFY(page->cancelButton()->isVisible());
    QTRY_COMPARE(page->step(), CalibrationPage::Step::Result);
    const QString result = page->findChild<QLabel *>(u"result"_s)->text();
    QVERIFY2(result.contains(u"Drift now"_s), qPrintable(result));
    // The figures of a sensor with a drift of 1.7, -2.4 and 1.1 °/s, before and after.
    static const QRegularExpression before(u"Drift before</td><td[^>]*>([0-9.]+)"_s);
    static const QRegularExpression now(u"Drift now</td><td[^>]*>([0-9.]+)"_s);
    QVERIFY(std::abs(before.match(result).captured(1).toDouble() - 2.4) < 0.2);
    QVERIFY(now.match(result).captured(1).toDouble() < 0.1);
    // It has kept the way back.
    QVERIFY(
        !workspace().history().snapshots(std::as_const(m_rig->model()).board().identity().serial).isEmpty());
    QTest::mouseClick(page->continueButton(), Qt::LeftButton);
    QCOMPARE(page->step(), CalibrationPage::Step::Choose);
}

// What a board repeats looks perfectly still.
void TestMotion::gyroscopeWaitsForAFrozenBoard_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QString>("told");
    QTest::newRow("with time stamps") << u"sim:simplebgc"_s << u"Waiting for live data of the sensor."_s;
    QTest::newRow("without") << u"sim:simplebgc?firmware=2.40"_s
                             << u"Waiting until the sensor sends live data again."_s;
}

void TestMotion::gyroscopeWaitsForAFrozenBoard()
{
    QFETCH(const QString, address);
    QFETCH(const QString, told);
    QVERIFY(m_rig->open(address));
    QVERIFY(alive());
    CalibrationPage *page = calibration(CalibrationPage::Kind::Gyroscope);
    workspace().changeWorld(u"pose=1"_s);
    QTRY_VERIFY(page->isSatisfied());
    workspace().changeWorld(u"frozen=1"_s);
    const auto says = [page, &told] {
        const auto labels = page->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(),
                           [&told](const QLabel *label) { return label->text().contains(told); });
    };
    QTRY_VERIFY(says());
    QVERIFY(!page->isSatisfied() && !page->continueButton()->isEnabled());
    workspace().changeWorld(u"frozen=0"_s);
    QTRY_VERIFY(page->isSatisfied());
}

void TestMotion::gyroscopeWaitsWhileItMoves()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?fault=shake=6"_s));
    QVERIFY(alive());
    workspace().setMotors(false);
    CalibrationPage *page = calibration(CalibrationPage::Kind::Gyroscope);
    QVERIFY(m_rig->boardGoesOn(2.0));
    QVERIFY(!page->isSatisfied());
    QVERIFY(!page->continueButton()->isEnabled());
    workspace().changeWorld(u"pose=1"_s);
    QTRY_VERIFY(page->isSatisfied());
    workspace().changeWorld(u"pose=0"_s);
    QTRY_VERIFY(!page->isSatisfied());
}

void TestMotion::calibrationCancelled()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    CalibrationPage *page = calibration(CalibrationPage::Kind::Gyroscope);
    QVERIFY(place(page, 1));
    QTRY_VERIFY(measured(page) > 0);
    QTest::mouseClick(page->cancelButton(), Qt::LeftButton);
    QTRY_COMPARE(page->step(), CalibrationPage::Step::Choose);
    QVERIFY(m_rig->window().messageBar()->text().contains(u"cancelled"_s));
    QVERIFY(m_rig->client().isConnected());
}

void TestMotion::calibrationShaken()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    CalibrationPage *page = calibration(CalibrationPage::Kind::Gyroscope);
    QVERIFY(place(page, 1));
    QTRY_VERIFY(measured(page) > 0);
    workspace().changeWorld(u"shake=8"_s);
    workspace().changeWorld(u"pose=0"_s);  // somebody takes it in his hands
    QTRY_VERIFY(page->step() == CalibrationPage::Step::Result
                || page->step() == CalibrationPage::Step::Choose);
    // The board gave up. What the sensor shows in a hand is judged poor, or, where the hand was still for the
    // moment of the comparison, found to be what it was before: nobody calls it good.
    if (page->step() == CalibrationPage::Step::Choose) {
        const QString said = m_rig->window().messageBar()->text();
        QVERIFY2(said.contains(u"did not carry it out"_s), qPrintable(said));
        return;
    }
    QStringList texts;
    for (const QLabel *label : page->findChildren<QLabel *>())
        texts.append(label->text());
    QVERIFY2(texts.join(u' ').contains(u"poor"_s), qPrintable(texts.join(u' ')));
}

void TestMotion::calibrationUnplugged()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    CalibrationPage *page = calibration(CalibrationPage::Kind::Level);
    QVERIFY(place(page, 1));
    QTRY_VERIFY(measured(page) > 0);
    workspace().changeWorld(u"replug=1"_s);
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_COMPARE(page->step(), CalibrationPage::Step::Choose);
    QTRY_VERIFY(m_rig->client().isConnected());
    QVERIFY(m_rig->jobsAreDone());
    // What became of it stays to be read.
    const QString told = m_rig->window().messageBar()->text();
    QVERIFY2(told.contains(u"The calibration ended with the link."_s)
                 && told.contains(u"Whether the board has finished"_s),
             qPrintable(told));
}

void TestMotion::sixPositionsUnplugged()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    workspace().setMotors(false);
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
    CalibrationPage *page = calibration(CalibrationPage::Kind::SixPositions);
    QVERIFY(place(page, 1));
    QTRY_COMPARE(page->step(), CalibrationPage::Step::Place);
    workspace().changeWorld(u"replug=1"_s);
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_COMPARE(page->step(), CalibrationPage::Step::Choose);
    QTRY_VERIFY(m_rig->client().isConnected());
    QVERIFY(m_rig->jobsAreDone());
    const QString told = m_rig->window().messageBar()->text();
    QVERIFY2(told.contains(u"1 of 6 positions were measured: Z up."_s), qPrintable(told));
    QVERIFY2(!told.contains(u"Whether the board has finished"_s), qPrintable(told));
}

void TestMotion::testUnplugged()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    auto *page = m_rig->page<ResponsePage>();
    page->armButton()->click();
    page->startButton()->click();
    QTRY_VERIFY(page->isRunning() && m_rig->client().isSteering());
    workspace().changeWorld(u"replug=1"_s);
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_VERIFY(!page->isRunning());
    QTRY_VERIFY(m_rig->client().isConnected());
    QVERIFY(m_rig->jobsAreDone());
    const QString told = m_rig->window().messageBar()->text();
    QVERIFY2(told.contains(u"The test ended with the link"_s), qPrintable(told));
    QVERIFY2(!told.contains(u"control was given back"_s), qPrintable(told));
}

void TestMotion::sixPositionsToTheEnd()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(true));
    auto *page = m_rig->page<CalibrationPage>();
    const auto buttonOf = [](const QWidget *in, const QString &text) -> QPushButton * {
        const auto buttons = in->findChildren<QPushButton *>();
        const auto it = std::find_if(buttons.begin(), buttons.end(),
                                     [&text](const QPushButton *each) { return each->text() == text; });
        return it == buttons.end() ? nullptr : *it;
    };
    // From hand to hand with motors that pull is no place for a sensor: nothing begins while they run.
    buttonOf(page, u"Calibrate six positions"_s)->click();
    QCOMPARE(page->step(), CalibrationPage::Step::Choose);
    QPushButton *off = nullptr;
    QTRY_VERIFY((off = buttonOf(m_rig->window().panels(), u"Stop motors"_s)));
    off->click();
    QTRY_COMPARE(page->step(), CalibrationPage::Step::Place);
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
    for (int pose = 1; pose <= 6; ++pose) {
        QVERIFY2(place(page, pose), qPrintable(QString::number(pose)));
        QCOMPARE(page->faceUp(), pose - 1);
        if (pose < 6) {
            QTRY_COMPARE(page->step(), CalibrationPage::Step::Place);
            QCOMPARE(page->doneCount(), pose);
            QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
            // The same face again is not wanted.
            QVERIFY(m_rig->boardGoesOn(0.3));
            QVERIFY(!page->continueButton()->isEnabled());
        }
    }
    QTRY_COMPARE(page->step(), CalibrationPage::Step::Result);
    static const QRegularExpression error(u"gravity</td><td[^>]*>([0-9.]+) g"_s);
    const QString figure = error.match(page->findChild<QLabel *>(u"result"_s)->text()).captured(1);
    QVERIFY2(!figure.isEmpty() && figure.toDouble() < 0.012,
             qPrintable(page->findChild<QLabel *>(u"result"_s)->text()));
}

void TestMotion::autoTuneAcceptedAndSaved()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    AutoTunePage *page = autoTune();
    QVERIFY(page);
    const int before = liveP();
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QCOMPARE(page->state(), AutoTunePage::State::Running);
    // What the board tries is in use now, not what was before.
    const auto *table = page->findChild<QTableWidget *>();
    QCOMPARE(table->item(0, 2)->text(), u"–"_s);
    QTRY_VERIFY(errorPoints(page, u"Error, Roll"_s) >= 3);
    QCOMPARE(page->state(), AutoTunePage::State::Running);
    QVERIFY(table->item(0, 2)->text() != u"–"_s);
    QVERIFY(table->item(0, 2)->text() != table->item(0, 1)->text());
    QTRY_COMPARE_WITH_TIMEOUT(page->state(), AutoTunePage::State::Finished, 120000);
    QTRY_VERIFY(liveP() != before);
    const int found = liveP();
    // In use, not stored.
    QCOMPARE(m_rig->raw(u"pid.roll.p"_s), before);
    QTest::mouseClick(named<QPushButton>(page, u"Accept and store"_s), Qt::LeftButton);
    QTRY_COMPARE(page->state(), AutoTunePage::State::Ready);
    QTRY_COMPARE(m_rig->raw(u"pid.roll.p"_s), found);
    // The snapshot before it holds what was stored, not what was found.
    const auto &history = workspace().history();
    const QStringList snapshots = history.snapshots(std::as_const(m_rig->model()).board().identity().serial);
    QVERIFY(!snapshots.isEmpty());
    QCOMPARE(workspace().loadFile(snapshots.first())->configuration.raw(m_rig->spec(u"pid.roll.p"_s), 0),
             before);
}

void TestMotion::nothingIsPutIntoUse()
{
    LiveModel &live = workspace().live();
    QVERIFY(live.isHeld());
    const int id = m_rig->spec(u"pid.yaw.p"_s).id;
    const auto before = live.value(id);
    QVERIFY(before.has_value());
    const int changes = live.changeCount();
    live.setValue(id, *before + 7);
    QCOMPARE(live.value(id), before);
    live.useSlot(LiveModel::Slot::B);
    QCOMPARE(live.slot(), LiveModel::Slot::A);
    live.revert();
    QVERIFY(live.isSettled() && live.changeCount() == changes);
    QSignalSpy told(&workspace().notifications(), &Notifications::problem);
    workspace().useProfile(1);
    QCOMPARE(told.count(), 1);
    workspace().write(m_rig->model().edited());
    QCOMPARE(told.count(), 2);
    QVERIFY(!workspace().isWriting());
    const QFuture<bool> stored = workspace().saveLive(m_rig->window());
    QVERIFY(stored.isFinished() && !stored.result());
    QCOMPARE(told.count(), 3);
    for (const QString &key : {u"calibrate.gyro"_s, u"profile.select"_s}) {
        const auto begun = workspace().perform(key, {});
        QVERIFY2(begun.isFinished() && !begun.result(), qPrintable(key));
    }
    const auto *profiles = named<QComboBox>(&m_rig->window(), u"Active profile"_s);
    QVERIFY(profiles && !profiles->isEnabled());
}

// A stop waits for nothing, whatever it is called: the action ends the search as the red button does.
void TestMotion::stopIsNeverHeld()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    AutoTunePage *page = autoTune();
    QVERIFY(page);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QTRY_VERIFY(errorPoints(page, u"Error, Roll"_s) >= 1);
    QVERIFY(workspace().live().isHeld());
    const QFuture<Result<ActionOutcome>> stopped = workspace().perform(u"motors.off"_s, {});
    QTRY_VERIFY(stopped.isFinished());
    QVERIFY(stopped.result().has_value());
    QTRY_VERIFY(workspace().motorsRunning() == false);
    QTRY_VERIFY(!workspace().live().isHeld());
}

// Sliders, sets, variables, profiles: what was set during a search would be shown as in use, and replace what
// the board has found.
void TestMotion::searchHoldsWhatIsInUse()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    AutoTunePage *page = autoTune();
    QVERIFY(page);
    QVERIFY(!page->form()->field(u"profile"_s));  // what is told is told of the one in use
    const int before = liveP();
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QTRY_VERIFY(errorPoints(page, u"Error, Roll"_s) >= 1);
    nothingIsPutIntoUse();
    auto *tuning = m_rig->page<TuningPage>();
    const LiveSlider *slider = tuning->control(u"pid.yaw.p"_s);
    QVERIFY(slider && !slider->isEnabled());
    QVERIFY(!tuning->revertButton()->isEnabled() && !tuning->slotButton(LiveModel::Slot::B)->isEnabled());
    QVERIFY2(tuning->stateText().contains(u"Locked"_s), qPrintable(tuning->stateText()));
    const AdjustableModel &variables = m_rig->page<VariablesPage>()->model();
    QVERIFY(variables.rowCount() > 0);
    QVERIFY(!(variables.flags(variables.index(0, AdjustableModel::ValueColumn)) & Qt::ItemIsEditable));
    // Reading waits: what the search has in use would pass for stored.
    QTest::keyClick(&m_rig->window(), Qt::Key_F5);
    m_rig->page<AutoTunePage>();
    QTRY_COMPARE_WITH_TIMEOUT(page->state(), AutoTunePage::State::Finished, 120000);
    QTRY_VERIFY(liveP() != before);
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(m_rig->raw(u"pid.roll.p"_s), before);
    QVERIFY(workspace().live().changeCount() > 0);
    QCOMPARE(page->state(), AutoTunePage::State::Finished);
    QVERIFY(slider->isEnabled());
    QCOMPARE(std::as_const(m_rig->model()).board().activeProfile(), 0);
}

// The old gains are those of another profile then: they are not put back into this one.
void TestMotion::searchEndsWithItsProfile()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    AutoTunePage *page = autoTune();
    QVERIFY(page);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(page->state(), AutoTunePage::State::Finished, 120000);
    QVERIFY(m_rig->jobsAreDone());
    QSignalSpy notices(&workspace().notifications(), &Notifications::notice);
    workspace().useProfile(1);
    QTRY_COMPARE(page->state(), AutoTunePage::State::Ready);
    QVERIFY(notices.last().first().toString().contains(u"Profile 2 is in use"_s));
    QVERIFY(!page->revertButton()->isVisible());
    QVERIFY(m_rig->jobsAreDone());
    workspace().live().read();
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(workspace().live().changeCount(), 0);
}

void TestMotion::storedElsewhereIsAnAnswer()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    AutoTunePage *page = autoTune();
    QVERIFY(page);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(page->state(), AutoTunePage::State::Finished, 120000);
    QTRY_VERIFY(workspace().live().changeCount() > 0);
    QFuture<bool> stored = workspace().saveLive(m_rig->window());
    QTRY_VERIFY(stored.isFinished());
    QTRY_COMPARE(page->state(), AutoTunePage::State::Ready);
}

void TestMotion::measurementHoldsWhatIsInUse()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    QVERIFY(autoTune());  // what is in use is known
    auto *page = m_rig->page<ResponsePage>();
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QVERIFY(page->isRunning());
    nothingIsPutIntoUse();
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QTRY_VERIFY(!page->isRunning());
    QVERIFY(!workspace().live().isHeld());
    // A write puts values back into use at its end: nothing is measured before.
    m_rig->edit(u"pid.roll.p"_s, 0, 44);
    workspace().write(m_rig->model().edited());
    QVERIFY(workspace().isWriting());
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QVERIFY(!page->isRunning());
    QTRY_VERIFY(!workspace().isWriting());
}

void TestMotion::autoTuneReverted()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    AutoTunePage *page = autoTune();
    const int before = liveP();
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(page->state(), AutoTunePage::State::Finished, 120000);
    QTRY_VERIFY(liveP() != before);
    // Before they are accepted they are measured, and that is said.
    const auto says = [page](const QString &text) {
        const auto labels = page->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(),
                           [&text](const QLabel *label) { return label->text().contains(text); });
    };
    QTRY_VERIFY(says(u"Angle error, RMS"_s));
    QTest::mouseClick(page->revertButton(), Qt::LeftButton);
    QCOMPARE(page->state(), AutoTunePage::State::Ready);
    QTRY_VERIFY(workspace().live().isSettled());
    workspace().live().read();
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(liveP(), before);
    QCOMPARE(workspace().live().changeCount(), 0);
}

// Worse than before: nothing is left of it.
void TestMotion::autoTuneThatHarmsIsTakenBack()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    // Judged by the page: the supervisor would stop the motors first.
    SupervisorRules rules = m_rig->settings().supervisorRules();
    rules.actions.fill(AlarmAction::Warn);
    m_rig->settings().setSupervisorRules(rules);
    AutoTunePage *page = autoTune();
    const int before = liveP();
    QSignalSpy problems(&workspace().notifications(), &Notifications::problem);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    // At once: soon after it is found it is judged, by the last seconds.
    QTRY_COMPARE_WITH_TIMEOUT(page->state(), AutoTunePage::State::Finished, 120000);
    workspace().changeWorld(u"blocked=1"_s);
    workspace().changeWorld(u"shake=8"_s);
    QTRY_COMPARE(page->state(), AutoTunePage::State::Ready);
    QTRY_VERIFY(!problems.isEmpty());
    QVERIFY(problems.last().first().value<ErrorText>().oneLine().contains(u"were reverted"_s));
    QTRY_VERIFY(workspace().live().isSettled());
    workspace().live().read();
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(liveP(), before);
}

int TestMotion::rowOf(const AutoTunePage *page, const QString &gain)
{
    return page->findChild<QTableWidget *>()->findItems(gain, Qt::MatchExactly).value(0)->row();
}

void TestMotion::gainsAreAsBefore(const AutoTunePage *page, int before)
{
    QCOMPARE(boardsP(), before);
    QCOMPARE(liveP(), before);
    QCOMPARE(int(m_rig->raw(u"pid.roll.p"_s)), before);
    QCOMPARE(workspace().live().changeCount(), 0);
    QVERIFY(!workspace().isUnstored());
    QCOMPARE(m_rig->model().changeCount(), 0);
    const auto *table = page->findChild<QTableWidget *>();
    const int row = rowOf(page, u"P · Roll"_s);
    QCOMPARE(table->item(row, 1)->text(), QString::number(before));
    QCOMPARE(table->item(row, 2)->text(), QString::number(before));
    QCOMPARE(table->item(row, 3)->text(), QString());
    const auto *bar = m_rig->window().findChild<UnstoredBar *>();
    QVERIFY(bar && !bar->isVisible());
    auto *tuning = m_rig->page<TuningPage>();
    QVERIFY(!isMarked(m_rig->window(), u"Tuning"_s) && tuning);
}

// Nor by one that is meant for the end and comes too late: each button has its own place.
void TestMotion::secondClickBeginsNoSearch()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    AutoTunePage *page = autoTune();
    QPushButton *start = page->startButton();
    auto *stop = named<QPushButton>(page, u"Stop and revert to the old gains"_s);
    QVERIFY(stop->isVisible() && !stop->isEnabled());
    const QPoint startsAt = start->mapTo(page, QPoint());
    const QPoint stopsAt = stop->mapTo(page, stop->rect().center());
    QTest::mouseClick(start, Qt::LeftButton);
    QTRY_VERIFY(errorPoints(page, u"Error, Roll"_s) >= 1);
    QCOMPARE(start->mapTo(page, QPoint()), startsAt);
    QCOMPARE(page->childAt(stopsAt), stop);
    QVERIFY(!start->isEnabled());
    QTest::mouseClick(stop, Qt::LeftButton);
    QTRY_COMPARE(page->state(), AutoTunePage::State::Ready);
    QCOMPARE(page->childAt(stopsAt), stop);
    QTest::mouseClick(stop, Qt::LeftButton);
    QVERIFY(m_rig->boardGoesOn(0.3));
    QCOMPARE(page->state(), AutoTunePage::State::Ready);
}

void TestMotion::stoppedSearchLeavesNothing_data()
{
    QTest::addColumn<bool>("isByKey");
    QTest::newRow("the page's button") << false;
    QTest::newRow("F12") << true;
}

// What the board had tried by then is neither taken for what is stored nor left in use.
void TestMotion::stoppedSearchLeavesNothing()
{
    QFETCH(bool, isByKey);
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    AutoTunePage *page = autoTune();
    const int before = liveP();
    QSignalSpy problems(&workspace().notifications(), &Notifications::problem);
    QSignalSpy notices(&workspace().notifications(), &Notifications::notice);
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QTRY_VERIFY(errorPoints(page, u"Error, Roll"_s) >= 3);
    if (isByKey)
        QTest::keyClick(page, Qt::Key_F12);
    else
        QTest::mouseClick(named<QPushButton>(page, u"Stop and revert to the old gains"_s), Qt::LeftButton);
    QTRY_COMPARE(page->state(), AutoTunePage::State::Ready);
    const auto isTold = [&notices](const QString &text) {
        return std::any_of(notices.begin(), notices.end(),
                           [&text](const auto &each) { return each.first().toString().contains(text); });
    };
    QTRY_VERIFY(isTold(u"The previous gains are in use again."_s));
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(m_rig->jobsAreDone());  // what these began
    gainsAreAsBefore(page, before);
    QVERIFY2(problems.isEmpty(), qPrintable(m_rig->window().messageBar()->text()));
    if (isByKey)
        QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
    QSignalSpy read(&workspace(), &Workspace::boardRead);
    workspace().readBoard();
    QTRY_VERIFY(!read.isEmpty());
    QVERIFY(m_rig->jobsAreDone());
    m_rig->page<AutoTunePage>();
    gainsAreAsBefore(page, before);
}

void TestMotion::autoTuneUnplugged()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    AutoTunePage *page = autoTune();
    const int before = liveP();
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QTRY_VERIFY(errorPoints(page, u"Error, Roll"_s) >= 1);
    workspace().changeWorld(u"replug=1"_s);
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_COMPARE(page->state(), AutoTunePage::State::Ready);
    QVERIFY(!m_rig->window().messageBar()->text().contains(u"Nothing was stored"_s));
    QTRY_VERIFY(m_rig->client().isConnected());
    // The board searched on: it is stopped, what differs is told, and the way back is offered.
    QTRY_COMPARE(page->state(), AutoTunePage::State::Finished);
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(liveP() != before);
    QCOMPARE(liveP(), boardsP());
    QCOMPARE(int(m_rig->raw(u"pid.roll.p"_s)), before);
    QVERIFY(workspace().live().changeCount() > 0);
    QVERIFY2(m_rig->window().messageBar()->text().contains(u"other gains"_s),
             qPrintable(m_rig->window().messageBar()->text()));
    QSignalSpy notices(&workspace().notifications(), &Notifications::notice);
    QTest::mouseClick(page->revertButton(), Qt::LeftButton);
    QTRY_COMPARE(liveP(), before);
    QVERIFY(m_rig->jobsAreDone());
    workspace().live().read();
    QVERIFY(m_rig->jobsAreDone());
    gainsAreAsBefore(page, before);
    // Nothing tells whether the board has stored what it tried: the old gains can be stored over it.
    const auto store = [this] { return named<QPushButton>(&m_rig->window(), u"Store the old gains"_s); };
    QTRY_VERIFY(store() && store()->isVisible());
    QTest::mouseClick(store(), Qt::LeftButton);
    QTRY_VERIFY(std::any_of(notices.begin(), notices.end(), [](const auto &each) {
        return each.first().toString().contains(u"that it has stored"_s);
    }));
    QTRY_COMPARE(liveP(), before);
    QVERIFY(m_rig->jobsAreDone());
    gainsAreAsBefore(page, before);
}

// Each stop is tried and judged anew; until one is proven, the page says that the board searches on.
void TestMotion::searchThatGoesOnIsStoppedOnceMore()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    AutoTunePage *page = autoTune();
    const int before = liveP();
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QTRY_VERIFY(errorPoints(page, u"Error, Roll"_s) >= 1);
    workspace().changeWorld(u"runs-on=1"_s);
    auto *stop = named<QPushButton>(page, u"Stop and revert to the old gains"_s);
    const auto says = [page](const QString &text) {
        const auto labels = page->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [&text](const QLabel *label) {
            return label->isVisible() && label->text().contains(text);
        });
    };
    for (int stops = 0; stops < 2; ++stops) {
        QTest::mouseClick(stop, Qt::LeftButton);
        QVERIFY(says(u"watched until it has"_s));
        QTRY_VERIFY(says(u"The board searches on although it was told to stop."_s));
        QVERIFY(stop->isEnabled());
        QVERIFY(page->state() != AutoTunePage::State::Ready);
        // Meanwhile what is shown as in use is what the board uses.
        const int shown = liveP();
        QTRY_VERIFY(liveP() > 0 && liveP() != shown);
        QTRY_COMPARE(page->findChild<QTableWidget *>()->item(rowOf(page, u"P · Roll"_s), 2)->text(),
                     QString::number(liveP()));
    }
    workspace().changeWorld(u"runs-on=0"_s);
    QTest::mouseClick(stop, Qt::LeftButton);
    QTRY_COMPARE(page->state(), AutoTunePage::State::Ready);
    QTRY_COMPARE(liveP(), before);
    QVERIFY(m_rig->jobsAreDone());
    QTRY_COMPARE(boardsP(), before);
    QVERIFY(!m_rig->window().messageBar()->text().contains(u"searches on"_s));
}

void TestMotion::foundGainsUnplugged_data()
{
    QTest::addColumn<bool>("restarts");
    QTest::newRow("the cable") << false;
    QTest::newRow("the board") << true;
}

// Nothing was decided: the way back is there again if the board still uses what was found.
void TestMotion::foundGainsUnplugged()
{
    QFETCH(bool, restarts);
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    AutoTunePage *page = autoTune();
    const int before = liveP();
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(page->state(), AutoTunePage::State::Finished, 120000);
    QTRY_VERIFY(liveP() != before);
    if (!restarts)
        workspace().changeWorld(u"replug=1"_s);
    workspace().changeWorld(restarts ? u"reset=0"_s : u"unplug=0"_s);
    QTRY_COMPARE(page->state(), AutoTunePage::State::Ready);
    const auto told = [this] { return m_rig->window().messageBar()->text(); };
    QVERIFY2(told().contains(u"before the new gains were accepted or reverted"_s), qPrintable(told()));
    QTRY_VERIFY(m_rig->client().isConnected());
    if (restarts) {
        QTRY_VERIFY2(told().contains(u"uses the gains from before the search again"_s), qPrintable(told()));
        QCOMPARE(page->state(), AutoTunePage::State::Ready);
        return;
    }
    QTRY_COMPARE(page->state(), AutoTunePage::State::Finished);
    QTest::mouseClick(page->revertButton(), Qt::LeftButton);
    QTRY_VERIFY(workspace().live().isSettled());
    workspace().live().read();
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(liveP(), before);
}

void TestMotion::armingMovesNothing()
{
    ControlPage *page = control();
    QVERIFY(page);
    QVERIFY(!page->isArmed());
    QVERIFY(!page->pad()->isEnabled());
    const double before = target(Axis::Yaw);
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QVERIFY(page->isArmed());
    QVERIFY(m_rig->boardGoesOn(0.7));
    QVERIFY(std::abs(target(Axis::Yaw) - before) < 1.5);
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QVERIFY(!page->isArmed());
}

// Where a limp camera hangs is no target.
void TestMotion::limpCameraIsNotArmed()
{
    ControlPage *page = control();
    QVERIFY(page);
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(true));
    const auto stateTexts = [page] {
        QStringList texts;
        for (const QLabel *label : page->findChildren<QLabel *>())
            texts.append(label->text());
        return texts.filter(u"Not armed"_s);
    };
    QCOMPARE(stateTexts().size(), 1);
    QVERIFY(stateTexts().first().contains(u"not steered"_s));
    workspace().setMotors(false);
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
    QSignalSpy told(&workspace().notifications(), &Notifications::notice);
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QVERIFY(!page->isArmed());
    QVERIFY(!page->armButton()->isChecked());
    QCOMPARE(told.count(), 1);
    QVERIFY(told.first().first().toString().contains(u"motors are off"_s));
    workspace().setMotors(true);
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(true));
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QVERIFY(page->isArmed());
}

void TestMotion::padSteersAndSpringsBack()
{
    ControlPage *page = control();
    QVERIFY(page);
    page->setArmed(true);
    const double before = target(Axis::Pitch);
    const QPoint middle = page->pad()->rect().center();
    QTest::mousePress(page->pad(), Qt::LeftButton, {}, middle);
    QTest::mouseMove(page->pad(), middle - QPoint(0, page->pad()->height() / 4));
    QTRY_VERIFY(target(Axis::Pitch) > before + 4.0);
    QTest::mouseRelease(page->pad(), Qt::LeftButton, {}, middle - QPoint(0, page->pad()->height() / 4));
    QCOMPARE(page->pad()->value(), QPointF());
    QVERIFY(m_rig->boardGoesOn(0.3));
    const double stopped = target(Axis::Pitch);
    QVERIFY(m_rig->boardGoesOn(0.6));
    QVERIFY2(std::abs(target(Axis::Pitch) - stopped) < 0.3, "it stands where it was let go");
}

void TestMotion::angleModeGoesThere()
{
    ControlPage *page = control();
    QVERIFY(page);
    const int index = named<QComboBox>(page, u"Mode of control"_s)->findText(u"Angle"_s);
    QVERIFY(index >= 0);
    named<QComboBox>(page, u"Mode of control"_s)->setCurrentIndex(index);
    page->setArmed(true);
    auto boxes = page->findChildren<QDoubleSpinBox *>();
    QCOMPARE(boxes.size(), 3);
    boxes[1]->setValue(12.0);
    QTRY_VERIFY(std::abs(angle(Axis::Pitch) - 12.0) < 1.0);
}

void TestMotion::keysSteer()
{
    ControlPage *page = control();
    QVERIFY(page);
    page->setArmed(true);
    QVERIFY(page->pad()->hasFocus());
    const double before = target(Axis::Pitch);
    QTest::keyPress(page->pad(), Qt::Key_Down);
    QTRY_VERIFY(target(Axis::Pitch) < before - 3.0);
    QTest::keyRelease(page->pad(), Qt::Key_Down);
    QCOMPARE(page->pad()->value(), QPointF());
}

void TestMotion::everyModeIsOffered()
{
    ControlPage *page = control();
    QVERIFY(page);
    const int usable = int(m_rig->client().device()->steering()->modes().size());
    QVERIFY(usable >= 5);
    QCOMPARE(named<QComboBox>(page, u"Mode of control"_s)->count(), usable);
    for (int i = 0; i < usable; ++i) {
        named<QComboBox>(page, u"Mode of control"_s)->setCurrentIndex(i);
        QVERIFY(!page->isArmed());
        page->setArmed(true);
        QVERIFY(page->isArmed());
        QCOMPARE(page->setpoint().mode, named<QComboBox>(page, u"Mode of control"_s)->currentData().toInt());
        page->setArmed(false);
    }
}

void TestMotion::escDisarms()
{
    ControlPage *page = control();
    QVERIFY(page);
    page->setArmed(true);
    QTest::keyClick(page->pad(), Qt::Key_Escape);
    QVERIFY(!page->isArmed());
}

void TestMotion::doingNothingDisarms()
{
    ControlPage *page = control();
    QVERIFY(page);
    m_rig->settings().setDisarmSeconds(2);
    page->setArmed(true);
    QTRY_VERIFY(!page->isArmed());
    QVERIFY(m_rig->window().messageBar()->text().contains(u"disarmed"_s));
}

void TestMotion::leavingThePageDisarms()
{
    ControlPage *page = control();
    QVERIFY(page);
    page->setArmed(true);
    m_rig->window().showPage(u"dashboard"_s);
    QVERIFY(!page->isArmed());
}

void TestMotion::blockedScreenStopsTheBoard()
{
    ControlPage *page = control();
    QVERIFY(page);
    page->setArmed(true);
    QSignalSpy rescued(&m_rig->client(), &DeviceClient::failsafeActed);
    const QPoint middle = page->pad()->rect().center();
    QTest::mousePress(page->pad(), Qt::LeftButton, {}, middle + QPoint(page->pad()->width() / 3, 0));
    const double before = target(Axis::Yaw);
    QTRY_VERIFY(std::abs(target(Axis::Yaw) - before) > 2.0);
    // The GUI thread hangs. The I/O thread goes on: it stops the board and lets go; telemetry goes on
    // arriving.
    const double atBlock = target(Axis::Yaw);
    QVERIFY(boardGoesOnWhileBlocked(m_rig->client(), 0.5));
    const double half = target(Axis::Yaw);
    QVERIFY(boardGoesOnWhileBlocked(m_rig->client(), 1.0));
    const double end = target(Axis::Yaw);
    QVERIFY2(std::abs(half - atBlock) < 20 * 0.5, "less than it would have moved");
    // Follow mode may draw it back slowly, but nobody steers any more.
    QVERIFY2(std::abs(end - half) < 4.0, qPrintable(u"%1 -> %2"_s.arg(half).arg(end)));
    QTRY_VERIFY(rescued.count() >= 1);
    QVERIFY(!page->isArmed());
}

void TestMotion::unpluggedWhileSteering()
{
    ControlPage *page = control();
    QVERIFY(page);
    page->setArmed(true);
    workspace().changeWorld(u"replug=1"_s);
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_VERIFY(!page->isArmed());
    QTRY_VERIFY(m_rig->client().isConnected());
    // Coming back does not steer by itself.
    QVERIFY(!page->isArmed());
}

// The button comes up somewhere else, and nobody is told.
void TestMotion::whateverCoversThePadEndsTheDrag()
{
    ControlPage *page = control();
    QVERIFY(page);
    const auto drag = [page] {
        page->setArmed(true);
        QTest::mousePress(page->pad(), Qt::LeftButton, {},
                          page->pad()->rect().center() + QPoint(page->pad()->width() / 3, 0));
        return page->pad()->value().x() > 0.5;
    };
    QVERIFY(drag());
    m_rig->window().showPalette();
    QVERIFY(!page->pad()->isHeld());
    QCOMPARE(page->pad()->value(), QPointF());
    m_rig->window().panels()->rejectAll();
    QVERIFY(drag());
    QEvent deactivated(QEvent::WindowDeactivate);
    QApplication::sendEvent(page->pad(), &deactivated);
    QCOMPARE(page->pad()->value(), QPointF());
    QVERIFY(drag());
    QEvent ungrabbed(QEvent::UngrabMouse);
    QApplication::sendEvent(page->pad(), &ungrabbed);
    QCOMPARE(page->pad()->value(), QPointF());
}

// What the board does is known before the link is closed.
void TestMotion::endOfTheLinkIsAnEndOfSteering()
{
    ControlPage *page = control();
    QVERIFY(page);
    page->setArmed(true);
    QTest::mousePress(page->pad(), Qt::LeftButton, {},
                      page->pad()->rect().center() + QPoint(page->pad()->width() / 3, 0));
    const double before = target(Axis::Yaw);
    QTRY_VERIFY(std::abs(target(Axis::Yaw) - before) > 2.0);
    QSignalSpy ended(&m_rig->client(), &DeviceClient::steeringEnded);
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(ended.count(), 1);
    QVERIFY(ended.first().first().toBool());
    QVERIFY(!page->isArmed());
}

QTEST_MAIN(TestMotion)
#include "tst_motion.moc"
