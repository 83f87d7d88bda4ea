// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/autotunepage.h"
#include "app/families/simplebgc/calibrationpage.h"
#include "app/mainwindow/bars.h"
#include "app/pages/board/controlpage.h"
#include "protocol/device/steering.h"
#include "tests/support/named.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/argumentform.h"
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
#include <QThread>

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
    void gyroscopeWaitsWhileItMoves();
    void calibrationCancelled();
    void calibrationShaken();
    void calibrationUnplugged();
    void sixPositionsToTheEnd();
    void autoTuneAcceptedAndSaved();
    void autoTuneReverted();
    void autoTuneCancelled();
    void autoTuneStoppedByMotorsOff();
    void autoTuneUnplugged();
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
            8000);
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
                             10000))
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
                5000))
            return nullptr;
        page->form()->setText(u"pitch"_s, u"off"_s);
        page->form()->setText(u"yaw"_s, u"off"_s);
        return page;
    }
    int liveP() { return workspace().live().value(m_rig->spec(u"pid.roll.p"_s).id).value_or(-1); }
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
    QTRY_COMPARE_WITH_TIMEOUT(page->step(), CalibrationPage::Step::Result, 20000);
    const QString result = page->findChild<QLabel *>(u"result"_s)->text();
    QVERIFY2(result.contains(u"Drift now"_s), qPrintable(result));
    // The figures of a sensor with a drift of 1.7, -2.4 and 1.1 °/s, before and after.
    static const QRegularExpression before(u"Drift before</td><td align='right'>([0-9.]+)"_s);
    static const QRegularExpression now(u"Drift now</td><td align='right'>([0-9.]+)"_s);
    QVERIFY(std::abs(before.match(result).captured(1).toDouble() - 2.4) < 0.2);
    QVERIFY(now.match(result).captured(1).toDouble() < 0.1);
    // It has kept the way back.
    QVERIFY(
        !workspace().history().snapshots(std::as_const(m_rig->model()).board().identity().serial).isEmpty());
    QTest::mouseClick(page->continueButton(), Qt::LeftButton);
    QCOMPARE(page->step(), CalibrationPage::Step::Choose);
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
    QTRY_VERIFY_WITH_TIMEOUT(page->isSatisfied(), 6000);
    workspace().changeWorld(u"pose=0"_s);
    QTRY_VERIFY_WITH_TIMEOUT(!page->isSatisfied(), 6000);
}

void TestMotion::calibrationCancelled()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    CalibrationPage *page = calibration(CalibrationPage::Kind::Gyroscope);
    QVERIFY(place(page, 1));
    QTRY_VERIFY_WITH_TIMEOUT(measured(page) > 0, 10000);
    QTest::mouseClick(page->cancelButton(), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(page->step(), CalibrationPage::Step::Choose, 3000);
    QVERIFY(m_rig->window().messageBar()->text().contains(u"cancelled"_s));
    QVERIFY(m_rig->client().isConnected());
}

void TestMotion::calibrationShaken()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    CalibrationPage *page = calibration(CalibrationPage::Kind::Gyroscope);
    QVERIFY(place(page, 1));
    workspace().changeWorld(u"shake=8"_s);
    workspace().changeWorld(u"pose=0"_s);  // somebody takes it in his hands
    QTRY_COMPARE_WITH_TIMEOUT(page->step(), CalibrationPage::Step::Result, 40000);
    // The board gave up; the wizard does not call that good.
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
    QTRY_VERIFY_WITH_TIMEOUT(measured(page) > 0, 10000);
    workspace().changeWorld(u"replug=1"_s);
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_COMPARE_WITH_TIMEOUT(page->step(), CalibrationPage::Step::Choose, 5000);
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected(), 15000);
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
    QTRY_VERIFY((off = buttonOf(&m_rig->window(), u"Switch motors off"_s)));
    off->click();
    QTRY_COMPARE_WITH_TIMEOUT(page->step(), CalibrationPage::Step::Place, 5000);
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
    for (int pose = 1; pose <= 6; ++pose) {
        QVERIFY2(place(page, pose), qPrintable(QString::number(pose)));
        QCOMPARE(page->faceUp(), pose - 1);
        if (pose < 6) {
            QTRY_COMPARE_WITH_TIMEOUT(page->step(), CalibrationPage::Step::Place, 20000);
            QCOMPARE(page->doneCount(), pose);
            QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
            // The same face again is not wanted.
            QVERIFY(m_rig->boardGoesOn(0.3));
            QVERIFY(!page->continueButton()->isEnabled());
        }
    }
    QTRY_COMPARE_WITH_TIMEOUT(page->step(), CalibrationPage::Step::Result, 20000);
    static const QRegularExpression error(u"gravity</td><td align='right'>([0-9.]+) g"_s);
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
    QTRY_VERIFY_WITH_TIMEOUT(errorPoints(page, u"Error, Roll"_s) >= 3, 30000);
    QTRY_COMPARE_WITH_TIMEOUT(page->state(), AutoTunePage::State::Finished, 120000);
    QTRY_VERIFY(liveP() != before);
    const int found = liveP();
    // In use, not stored.
    QCOMPARE(m_rig->raw(u"pid.roll.p"_s), before);
    QTest::mouseClick(named<QPushButton>(page, u"Accept and store"_s), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(page->state(), AutoTunePage::State::Ready, 10000);
    QTRY_COMPARE_WITH_TIMEOUT(m_rig->raw(u"pid.roll.p"_s), found, 10000);
    // The snapshot before it holds what was stored, not what was found.
    const auto &history = workspace().history();
    const QStringList snapshots = history.snapshots(std::as_const(m_rig->model()).board().identity().serial);
    QVERIFY(!snapshots.isEmpty());
    QCOMPARE(workspace().loadFile(snapshots.first())->configuration.raw(m_rig->spec(u"pid.roll.p"_s), 0),
             before);
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
    QTest::mouseClick(page->revertButton(), Qt::LeftButton);
    QCOMPARE(page->state(), AutoTunePage::State::Ready);
    QTRY_VERIFY(workspace().live().isSettled());
    workspace().live().read();
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(liveP(), before);
    QCOMPARE(workspace().live().changeCount(), 0);
}

void TestMotion::autoTuneCancelled()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    AutoTunePage *page = autoTune();
    const int before = liveP();
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(errorPoints(page, u"Error, Roll"_s) >= 2, 30000);
    QTest::mouseClick(named<QPushButton>(page, u"Stop and revert to the old gains"_s), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(page->state(), AutoTunePage::State::Ready, 5000);
    QTRY_VERIFY(workspace().live().isSettled());
    workspace().live().read();
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(liveP(), before);
}

void TestMotion::autoTuneStoppedByMotorsOff()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    AutoTunePage *page = autoTune();
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(errorPoints(page, u"Error, Roll"_s) >= 1, 30000);
    QTest::keyClick(page, Qt::Key_F12);
    QTRY_COMPARE_WITH_TIMEOUT(page->state(), AutoTunePage::State::Ready, 5000);
    QTRY_COMPARE_WITH_TIMEOUT(workspace().motorsRunning(), std::optional(false), 5000);
}

void TestMotion::autoTuneUnplugged()
{
    QVERIFY(m_rig->open());
    QVERIFY(alive());
    AutoTunePage *page = autoTune();
    QTest::mouseClick(page->startButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(errorPoints(page, u"Error, Roll"_s) >= 1, 30000);
    workspace().changeWorld(u"replug=1"_s);
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_COMPARE_WITH_TIMEOUT(page->state(), AutoTunePage::State::Ready, 5000);
    QVERIFY(m_rig->window().messageBar()->text().contains(u"Nothing was stored"_s));
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected(), 15000);
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
    QTRY_COMPARE_WITH_TIMEOUT(workspace().motorsRunning(), std::optional(true), 8000);
    const auto stateTexts = [page] {
        QStringList texts;
        for (const QLabel *label : page->findChildren<QLabel *>())
            texts.append(label->text());
        return texts.filter(u"Not armed"_s);
    };
    QCOMPARE(stateTexts().size(), 1);
    QVERIFY(stateTexts().first().contains(u"not steered"_s));
    workspace().setMotors(false);
    QTRY_COMPARE_WITH_TIMEOUT(workspace().motorsRunning(), std::optional(false), 8000);
    QSignalSpy told(&workspace().notifications(), &Notifications::notice);
    QTest::mouseClick(page->armButton(), Qt::LeftButton);
    QVERIFY(!page->isArmed());
    QVERIFY(!page->armButton()->isChecked());
    QCOMPARE(told.count(), 1);
    QVERIFY(told.first().first().toString().contains(u"motors are off"_s));
    workspace().setMotors(true);
    QTRY_COMPARE_WITH_TIMEOUT(workspace().motorsRunning(), std::optional(true), 8000);
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
    QTRY_VERIFY_WITH_TIMEOUT(target(Axis::Pitch) > before + 4.0, 5000);
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
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(angle(Axis::Pitch) - 12.0) < 1.0, 8000);
}

void TestMotion::keysSteer()
{
    ControlPage *page = control();
    QVERIFY(page);
    page->setArmed(true);
    QVERIFY(page->pad()->hasFocus());
    const double before = target(Axis::Pitch);
    QTest::keyPress(page->pad(), Qt::Key_Down);
    QTRY_VERIFY_WITH_TIMEOUT(target(Axis::Pitch) < before - 3.0, 5000);
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
    QTRY_VERIFY_WITH_TIMEOUT(!page->isArmed(), 5000);
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
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(target(Axis::Yaw) - before) > 2.0, 5000);
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
    QTRY_VERIFY_WITH_TIMEOUT(rescued.count() >= 1, 3000);
    QVERIFY(!page->isArmed());
}

void TestMotion::unpluggedWhileSteering()
{
    ControlPage *page = control();
    QVERIFY(page);
    page->setArmed(true);
    workspace().changeWorld(u"replug=1"_s);
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_VERIFY_WITH_TIMEOUT(!page->isArmed(), 5000);
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected(), 15000);
    // Coming back does not steer by itself.
    QVERIFY(!page->isArmed());
}

QTEST_MAIN(TestMotion)
#include "tst_motion.moc"
