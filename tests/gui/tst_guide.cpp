// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/setup/guidepage.h"
#include "app/pages/setup/livefigures.h"
#include "app/pages/setup/stickinputs.h"
#include "app/workspace/setupbutton.h"
#include "protocol/device/abilities.h"
#include "protocol/device/device.h"
#include "protocol/telemetry/roles.h"
#include "tests/support/patience.h"
#include "tests/support/sticks.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/argumentform.h"
#include "widgets/models/errortext.h"
#include "widgets/views/inputbars.h"

#include <QCheckBox>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSet>
#include <QTextBrowser>

using namespace Qt::StringLiterals;
using State = SetupResult::State;

/// The guided set-up on the screen, on an unpacked simulated gimbal.
class TestGuide final : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }
    void anUnpackedGimbalIsTuned();
    void eachStepShowsWhatItSees();
    void eachStepIsReachedFromItsPage();
    void itGoesOnAnotherDay();
    void nothingBeginsUnconfirmed();
    void hiddenItEnds();
    void cancelledASearchEnds();
    void cancelledThePowerIsAsBefore();
    void leftOutIsSaid();
    void tabGoesFromTheQuestionsToTheButton();
    void cancelledItKeepsWhatWasDone();
    void aFailureIsToldAndKept();
    void withoutARemoteControlItSaysSo();

private:
    GuidePage &page() { return *m_rig->page<GuidePage>(); }
    /// Carries out the chosen step as an operator would. @return how it ended
    State doIt()
    {
        const SetupStep step = page().chosen();
        ++m_clicks;
        if (!page().confirmBox()->isHidden()) {
            page().confirmBox()->setChecked(true);
            ++m_clicks;
        }
        // What the step before has begun may still go on.
        if (!QTest::qWaitFor([this] { return page().beginButton()->isEnabled(); }, kPatience))
            return State::Open;
        page().beginButton()->click();
        std::ignore = QTest::qWaitFor([this] { return !page().isUnderWay(); }, 4 * kPatience);
        std::ignore = m_rig->jobsAreDone();
        return page().record().result(step).state;
    }
    void moveSticks(const Progress &progress)
    {
        const int stick = stickFor(progress, m_stick);
        if (std::exchange(m_stick, stick) != stick)
            world(u"stick=%1"_s.arg(stick));
    }
    void world(const QString &assignment) { m_rig->workspace().changeWorld(assignment); }

    std::unique_ptr<WindowRig> m_rig;
    int m_clicks = 0;
    int m_stick = 0;
};

void TestGuide::anUnpackedGimbalIsTuned()
{
    QElapsedTimer clock;
    clock.start();
    QVERIFY(m_rig->open(u"sim:simplebgc?condition=new&seed=71"_s));
    connect(&m_rig->client(), &DeviceClient::progressChanged, this, [this](const Progress &progress) {
        if (progress.step == u"setup-let-go"_s)
            world(u"hand=0"_s);
        else if (progress.step == u"setup-tilt-right"_s)
            world(u"hand=4"_s);
        else if (progress.step == u"setup-tilt-down"_s)
            world(u"hand=3"_s);
        else if (progress.step == u"setup-tilt-level"_s)
            world(u"hand=1"_s);
        else if (progress.step.startsWith(u"setup-stick-"_s))
            moveSticks(progress);
    });
    QCOMPARE(page().list()->count(), int(kSetupSteps));
    QCOMPARE(page().chosen(), SetupStep::Power);
    // It runs wild, as its sensor sits otherwise than it is told: the red button, and a hand.
    world(u"hand=1"_s);
    QTest::keyClick(&m_rig->window(), Qt::Key_F12);
    QTRY_VERIFY(!m_rig->workspace().motorsRunning().value_or(true));
    const State first = doIt();
    QVERIFY2(first == State::Done, qPrintable(page().findings()->toPlainText()));
    QVERIFY2(page().findings()->toPlainText().contains(u"12."_s),
             qPrintable(page().findings()->toPlainText()));
    QCOMPARE(m_rig->raw(u"battery.alarm"_s), 1050.0);
    for (const SetupStep step :
         {SetupStep::Sensors, SetupStep::Gyroscope, SetupStep::Orientation, SetupStep::Level}) {
        page().choose(step);
        const State state = doIt();
        QVERIFY2(state == State::Done, qPrintable(page().findings()->toPlainText()));
    }
    QCOMPARE(m_rig->raw(u"imu.main.axis_top"_s), 3.0);
    page().choose(SetupStep::Balance);
    world(u"shake=0"_s);
    QCOMPARE(doIt(), State::Poor);
    QVERIFY(page().findings()->toPlainText().contains(u"not balanced"_s));
    world(u"imbalance=5"_s);
    world(u"hand=1"_s);
    QCOMPARE(doIt(), State::Done);
    world(u"shake=1"_s);
    page().choose(SetupStep::Motors);
    const State motors = doIt();
    QVERIFY2(motors == State::Done, qPrintable(page().findings()->toPlainText()));
    QCOMPARE(m_rig->raw(u"motor.pitch.poles"_s), 14.0);
    QTRY_VERIFY(m_rig->workspace().motorsRunning().value_or(false));
    page().choose(SetupStep::MotorPower);
    const State power = doIt();
    QVERIFY2(power == State::Done, qPrintable(page().findings()->toPlainText()));
    QVERIFY(m_rig->raw(u"motor.roll.power"_s) > 30);  // it was too weak for the camera, and pitch too strong
    QVERIFY(m_rig->raw(u"motor.pitch.power"_s) < 200);
    page().choose(SetupStep::Gains);
    const State gains = doIt();  // the board's own search may leave an axis that rings, which is said
    QVERIFY2(gains == State::Done || page().findings()->toPlainText().contains(u"vibrates strongly"_s),
             qPrintable(page().findings()->toPlainText()));
    QVERIFY2(page().findings()->toPlainText().contains(u"better"_s),
             qPrintable(page().findings()->toPlainText()));
    page().choose(SetupStep::Vibration);
    const State vibration = doIt();
    QVERIFY2(vibration == State::Done || page().findings()->toPlainText().contains(u"vibrates strongly"_s),
             qPrintable(page().findings()->toPlainText()));
    QVERIFY(page().findings()->toPlainText().contains(u"Vibrates"_s));
    page().choose(SetupStep::Limits);
    world(u"hand=2"_s);
    QCOMPARE(doIt(), State::Done);
    world(u"hand=1"_s);
    page().choose(SetupStep::Remote);
    QVERIFY(page().remote()->isVisible());
    QTRY_VERIFY(std::abs(page().remote()->bars()->value(u"RC_YAW (PWM)"_s)) < 5);
    QCOMPARE(m_rig->raw(u"rc.map.roll"_s), 2.0);
    const State remote = doIt();
    QVERIFY2(remote == State::Done, qPrintable(page().findings()->toPlainText()));
    QVERIFY2(page().findings()->toPlainText().contains(u"RC_PITCH (PWM) → RC_ROLL (PWM)"_s),
             qPrintable(page().findings()->toPlainText()));
    QCOMPARE(m_rig->raw(u"rc.map.roll"_s), 1.0);
    QCOMPARE(m_rig->raw(u"rc.yaw.inverted"_s), 0.0);
    world(u"hand=0"_s);
    page().choose(SetupStep::Use);
    QVERIFY(!page().remote()->isVisible());
    QCOMPARE(doIt(), State::Open);  // shown
    QVERIFY(page().findings()->toPlainText().contains(u"→"_s));
    page().form()->setText(u"apply"_s, u"on"_s);
    QCOMPARE(doIt(), State::Done);
    for (const SetupStepSpec &spec : setupSteps())  // each was walked
        QVERIFY2(page().record().result(spec.step).at.isValid(), spec.action.key);

    for (const QString &name : {u"certificate.pdf"_s, u"certificate.html"_s}) {
        const QString path = m_rig->filePath(name);
        QVERIFY(page().saveCertificate(path));
        QFile file(path);
        QVERIFY(file.open(QFile::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY(name.endsWith(u"pdf"_s) ? bytes.startsWith("%PDF") && bytes.size() > 5000
                                        : bytes.contains("Gains: ") && bytes.contains("simulated"));
    }
    qInfo("from the box to the certificate: %d clicks, %.1f minutes", m_clicks + 10,
          double(clock.elapsed()) / 60000);
}

// Before it begins, too: an operator sees what it will judge.
void TestGuide::eachStepShowsWhatItSees()
{
    QVERIFY(m_rig->open());
    for (const SetupStepSpec &spec : setupSteps()) {
        page().choose(spec.step);
        QCOMPARE(page().live()->isHidden(), spec.step == SetupStep::Remote);  // it has bars of its own
    }
    page().choose(SetupStep::Power);
    QTRY_VERIFY(page().live()->text("Voltage").startsWith(u"12."_s));
    world(u"battery=11.1"_s);
    QTRY_VERIFY2(page().live()->text("Voltage").startsWith(u"11."_s),
                 qPrintable(page().live()->text("Voltage")));
    page().choose(SetupStep::Sensors);
    QTRY_VERIFY(page().live()->text("Turn rate varies by").count(u"°/s"_s) == 3);
    page().choose(SetupStep::Limits);
    m_rig->workspace().setMotors(false);
    QTRY_VERIFY(!m_rig->workspace().motorsRunning().value_or(true));
    world(u"hand=3"_s);
    const auto pitch
        = [this] { return page().live()->text("Angle").section(u"°"_s, 1, 1).trimmed().toDouble(); };
    QTRY_VERIFY2(std::abs(pitch()) > 30, qPrintable(page().live()->text("Angle")));
}

// And from the step back to the page.
void TestGuide::eachStepIsReachedFromItsPage()
{
    QVERIFY(m_rig->open());
    auto *guide = static_cast<GuidePage *>(m_rig->window().page(u"guide"_s));
    int reached = 0;
    for (const SetupStepSpec &spec : setupSteps()) {
        if (!*spec.elsewhere)
            continue;
        const QString key = QLatin1String(spec.elsewhere);
        QVERIFY(m_rig->window().showPage(key));
        const auto *button = m_rig->window().page(key)->findChild<SetupButton *>();
        QVERIFY2(button && button->isVisible(), spec.elsewhere);
        const auto steps = button->menu()->actions();
        const auto step = std::find_if(steps.begin(), steps.end(), [&spec](const QAction *each) {
            return each->text() == QLatin1String(spec.action.label);
        });
        QVERIFY2(step != steps.end(), spec.action.key);
        (*step)->trigger();
        QTRY_VERIFY(guide->isVisible());
        QCOMPARE(guide->chosen(), spec.step);
        guide->elsewhereButton()->click();
        QTRY_VERIFY(m_rig->window().page(key)->isVisible());
        ++reached;
    }
    QCOMPARE(reached, int(kSetupSteps) - 1);  // balance belongs to no page
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(m_rig->window().page(u"autotune"_s)->findChild<SetupButton *>()->isHidden());
}

void TestGuide::itGoesOnAnotherDay()
{
    QVERIFY(m_rig->open());
    QCOMPARE(page().chosen(), SetupStep::Power);
    QCOMPARE(doIt(), State::Done);
    m_rig->restart();
    QVERIFY(m_rig->open());
    QCOMPARE(page().record().result(SetupStep::Power).state, State::Done);
    QCOMPARE(page().chosen(), SetupStep::Sensors);
    QVERIFY(page().list()->item(0)->text().contains(u"✓"_s));
    // Another board begins at the beginning.
    m_rig->client().disconnectFromBoard();
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=72"_s));
    QCOMPARE(page().record().result(SetupStep::Power).state, State::Open);
}

void TestGuide::nothingBeginsUnconfirmed()
{
    QVERIFY(m_rig->open());
    page().choose(SetupStep::Motors);
    QVERIFY(!page().beginButton()->isEnabled());
    page().confirmBox()->setChecked(true);
    QVERIFY(page().beginButton()->isEnabled());
    page().choose(SetupStep::Balance);
    QVERIFY(!page().beginButton()->isEnabled());  // each time anew
    page().choose(SetupStep::Power);
    QVERIFY(page().beginButton()->isEnabled());
}

// Who goes to another page does not watch what the motors do.
void TestGuide::hiddenItEnds()
{
    QVERIFY(m_rig->open());
    page().choose(SetupStep::Vibration);
    page().beginButton()->click();
    QVERIFY(page().isUnderWay());
    QVERIFY(!page().beginButton()->isEnabled() && page().cancelButton()->isVisible());
    QVERIFY(m_rig->boardGoesOn(0.5));
    m_rig->window().showPage(u"dashboard"_s);
    auto *guide = static_cast<GuidePage *>(m_rig->window().page(u"guide"_s));
    QTRY_VERIFY(!guide->isUnderWay());
    QCOMPARE(guide->record().result(SetupStep::Vibration).state, State::Failed);
    QVERIFY(!m_rig->workspace().isAtWork() && !m_rig->workspace().live().isHeld());
}

// The board searches by itself: it is told to end, and uses the gains from before.
void TestGuide::cancelledASearchEnds()
{
    QVERIFY(m_rig->open());
    const auto inUse = [this] {
        std::vector<AdjustableValue> values;
        m_rig->client()
            .submit<std::vector<AdjustableValue>>(
                [](Channel &channel, Device &device) { return device.live()->readAllAdjustables(channel); })
            .then(&m_rig->window(), [&values](const Result<std::vector<AdjustableValue>> &read) {
                values = read.value_or(std::vector<AdjustableValue>());
            });
        std::ignore = m_rig->jobsAreDone();
        return values;
    };
    const auto before = inUse();
    QVERIFY(!before.empty());
    page().choose(SetupStep::Gains);
    int rounds = 0;
    connect(&m_rig->client(), &DeviceClient::progressChanged, this,
            [&rounds](const Progress &progress) { rounds += progress.step == u"autotune"_s; });
    page().beginButton()->click();
    QTRY_VERIFY_WITH_TIMEOUT(rounds >= 3, kPatience);
    page().cancelButton()->click();
    QTRY_VERIFY(!page().isUnderWay());
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(page().record().result(SetupStep::Gains).state, State::Failed);
    const int ended = rounds;
    QVERIFY(m_rig->boardGoesOn(3));
    QCOMPARE(rounds, ended);
    QCOMPARE(inUse(), before);
}

// Tried in use alone: the power from before is in use again, and stored it never was.
void TestGuide::cancelledThePowerIsAsBefore()
{
    QVERIFY(m_rig->open());
    const auto before = m_rig->raw(u"motor.roll.power"_s);
    page().choose(SetupStep::MotorPower);
    page().confirmBox()->setChecked(true);
    QSet<double> tried;
    QString told;
    connect(&m_rig->client(), &DeviceClient::progressChanged, this, [&](const Progress &progress) {
        if (progress.step != u"setup-power"_s)
            return;
        tried.insert(progress.values.value(u"power"_s));
        told = describe(progress);
    });
    page().beginButton()->click();
    QTRY_VERIFY_WITH_TIMEOUT(tried.size() >= 2, kPatience);
    QVERIFY2(told.startsWith(u"Roll"_s), qPrintable(told));
    page().cancelButton()->click();
    QTRY_VERIFY(!page().isUnderWay());
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(page().record().result(SetupStep::MotorPower).state, State::Failed);
    QCOMPARE(m_rig->raw(u"motor.roll.power"_s), before);
    QVERIFY(m_rig->workspace().live().unsaved().empty());
}

void TestGuide::leftOutIsSaid()
{
    QVERIFY(m_rig->open());
    page().skipButton()->click();
    QCOMPARE(page().chosen(), SetupStep::Sensors);
    QVERIFY(!page().skipButton()->hasFocus());  // pressed again, it would leave out the next one
    page().choose(SetupStep::Power);
    QVERIFY(page().nextButton()->isVisible());
    page().nextButton()->click();
    QCOMPARE(page().chosen(), SetupStep::Sensors);
    page().choose(SetupStep::Power);
    QVERIFY2(page().findings()->toPlainText().contains(u"left out"_s),
             qPrintable(page().findings()->toPlainText()));
    QVERIFY(page().beginButton()->isEnabled());
}

void TestGuide::tabGoesFromTheQuestionsToTheButton()
{
    QVERIFY(m_rig->open());
    for (const SetupStep step : {SetupStep::Power, SetupStep::Limits}) {
        page().choose(step);
        page().confirmBox()->setChecked(true);
        page().list()->setFocus();
        QStringList passed;
        for (int i = 0; i < 8 && !page().beginButton()->hasFocus(); ++i) {
            QTest::keyClick(m_rig->window().focusWidget(), Qt::Key_Tab);
            passed.append(QLatin1String(m_rig->window().focusWidget()->metaObject()->className()));
            QVERIFY2(page().isAncestorOf(m_rig->window().focusWidget()), qPrintable(passed.join(u' ')));
        }
        QVERIFY2(page().beginButton()->hasFocus(), qPrintable(passed.join(u' ')));
    }
}

void TestGuide::cancelledItKeepsWhatWasDone()
{
    QVERIFY(m_rig->open());
    page().choose(SetupStep::Vibration);
    page().form()->setText(u"try"_s, u"off"_s);
    const State done = doIt();
    QVERIFY2(done == State::Done, qPrintable(page().findings()->toPlainText()));
    page().beginButton()->click();
    QVERIFY(page().isUnderWay());
    QVERIFY(page().findings()->toPlainText().isEmpty());  // of the time before
    page().cancelButton()->click();
    QTRY_VERIFY(!page().isUnderWay());
    QCOMPARE(page().record().result(SetupStep::Vibration).state, State::Done);
}

void TestGuide::aFailureIsToldAndKept()
{
    QVERIFY(m_rig->open());
    world(u"battery=4.9"_s);
    QCOMPARE(doIt(), State::Failed);
    QVERIFY2(page().findings()->toPlainText().contains(u"USB"_s),
             qPrintable(page().findings()->toPlainText()));
    world(u"battery=12.3"_s);
    QCOMPARE(doIt(), State::Done);
}

void TestGuide::withoutARemoteControlItSaysSo()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?firmware=2.70.4"_s));
    page().choose(SetupStep::Remote);
    QCOMPARE(doIt(), State::Failed);
    QVERIFY2(page().findings()->toPlainText().contains(u"no input has a signal"_s, Qt::CaseInsensitive),
             qPrintable(page().findings()->toPlainText()));
    QCOMPARE(m_rig->raw(u"rc.map.roll"_s), 1.0);
}

QTEST_MAIN(TestGuide)
#include "tst_guide.moc"
