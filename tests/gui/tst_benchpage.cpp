// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/benchcards.h"
#include "app/families/bcflight/benchpage.h"
#include "app/mainwindow/bannerarea.h"
#include "app/mainwindow/bars.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/messagebar.h"
#include "app/pages/board/flightpage.h"
#include "app/pages/watch/dashboardpage.h"
#include "app/pages/watch/flightoverview.h"
#include "app/workspace/flightstate.h"
#include "protocol/base/filefault.h"
#include "protocol/bcflight/messages.h"
#include "protocol/bcflight/payloads.h"
#include "protocol/session/channel.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/clickshield.h"
#include "widgets/forms/numberbox.h"
#include "widgets/forms/panel.h"
#include "widgets/views/armedstate.h"
#include "widgets/views/attitudeview.h"
#include "widgets/views/gimbalview.h"
#include "widgets/views/motordiagram.h"

#include <QDir>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTime>

using namespace Qt::StringLiterals;
using State = ArmedState::State;

/// A simulated drone on the bench, as the operator sees it.
class TestBenchPage final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup() { m_rig.reset(); }
    void droneIsShownAtAGlance();
    void motorIsChosenConfirmedAndTurned();
    void stopTakesTheQuestionAway();
    void dangerIsSaidBeforeItBegins();
    void questionGoesWithWhatItWasAskedFor();
    void propellersInAStandKeepMotorsFromTheBench();
    void secondClickConfirmsNothing();
    void whatCannotBeCancelledIsOnlyWaitedFor();
    void redButtonSaysThatItIsDeaf();
    void fileIsLookedAtFirst();
    void firmwareNeedsABattery();
    void firmwareIsUploaded();
    void anotherFirmwareIsCheckedAnew();
    void cancelSaysWhatIsLeft();
    void phasesOfTheControllersAreShown();
    void controllersAreCalibratedUntilTheRedButton();
    void armedIsUnmistakable();
    void messagesLeaveMotorsInSight_data();
    void messagesLeaveMotorsInSight();

private:
    BenchPage &bench() { return *m_rig->page<BenchPage>(); }
    bool calibrate()
    {
        // Whether it is armed has to be known.
        const auto isDisarmed
            = [this] { return m_rig->workspace().latest(m_rig->workspace().roles().armed) == 0; };
        if (!QTest::qWaitFor(isDisarmed, kPatience))
            return false;
        const auto done = m_rig->workspace().perform(u"calibrate.all"_s, {});
        return QTest::qWaitFor([&done] { return done.isFinished(); }, kPatience) && done.result().has_value();
    }
    /// What is asked before something dangerous; null: nothing is.
    QMessageBox *asked() { return qobject_cast<QMessageBox *>(m_rig->window().panels()->newest()); }
    QPushButton *dangerousAnswer() { return asked()->findChild<QPushButton *>(u"danger"_s); }
    /// Goes on where that has to be confirmed.
    bool confirm(const QString &words)
    {
        if (!QTest::qWaitFor([&] { return asked() && asked()->text().contains(words); }))
            return false;
        dangerousAnswer()->click();
        return true;
    }
    /// A click as the window system sends it, to whatever lies there.
    void clickAt(QPoint place)
    {
        QTest::mouseClick(m_rig->window().windowHandle(), Qt::LeftButton, {}, place);
    }
    QPoint middleOf(const QWidget *widget)
    {
        return widget->mapTo(&m_rig->window(), widget->rect().center());
    }
    bool isShielded(QPoint place)
    {
        return qobject_cast<ClickShield *>(m_rig->window().childAt(place)) != nullptr;
    }
    void armFromElsewhere()
    {
        m_rig->client().submit<bool>([](Channel &channel, Device &) -> Result<bool> {
            Request request;
            const bcflight::Controls wanted{.thrust = 0.3, .arm = true};
            request.bytes
                = bcflight::encode(bcflight::Message::Controls, wanted.encode(bcflight::Generation::G));
            channel.post(request);
            return true;
        });
    }
    QString firmwareFile(const QString &name, qsizetype size, const QByteArray &version = "7.7")
    {
        const QString path = m_rig->filePath(name);
        QByteArray image = "version " + version + '\n';
        image.resize(size, '\x01');
        return writeWhole(path, image) ? path : QString();
    }
    std::unique_ptr<WindowRig> m_rig;
};

void TestBenchPage::init()
{
    static int seed = 700;
    m_rig = std::make_unique<WindowRig>();
    QVERIFY(m_rig->open(u"sim:bcflight?stand=1&seed=%1"_s.arg(++seed)));
}

void TestBenchPage::droneIsShownAtAGlance()
{
    DashboardPage &page = *m_rig->page<DashboardPage>();
    auto *overview = page.findChild<FlightOverview *>();
    QVERIFY(overview && overview->isVisible());
    QVERIFY(!page.findChild<GimbalView *>()->isVisible());  // it carries no camera that would be drawn
    QTRY_COMPARE(overview->state()->state(), State::NotCalibrated);
    // What it tells of its attitude before a calibration is not true.
    QCOMPARE(overview->attitude()->accessibleDescription(), u"No data"_s);
    QTRY_COMPARE(overview->motors()->count(), 4);
    QVERIFY(overview->motors()->hasPlaces());
    QTRY_COMPARE(overview->motors()->outputText(1), u"stands"_s);
    QVERIFY(calibrate());
    QTRY_COMPARE(overview->state()->state(), State::Disarmed);
    QTRY_VERIFY(overview->attitude()->accessibleDescription().contains(u"pitch"_s));
    const auto says = [&page](const QString &text) {
        for (const QLabel *label : page.findChildren<QLabel *>()) {
            if (label->text().contains(text))
                return true;
        }
        return false;
    };
    for (const QString &text : {u"Processor load"_s, u"Control loop"_s, u"Drone receives"_s, u"-48 dBm"_s})
        QTRY_VERIFY2(says(text), qPrintable(text));
    QVERIFY(!says(u"Sensor bus errors"_s));  // nobody tells them
    // Its sensor is not read: 0 A is no value (errata 4.2).
    QVERIFY(says(u"Current"_s));
    QVERIFY(!says(u"0.00 A"_s) && !says(u"0.0 A"_s));
    QVERIFY(std::isnan(m_rig->workspace().latest(m_rig->workspace().roles().current)));
    // An almost empty battery: what is shown stays within its limits, what came stands beside it.
    m_rig->workspace().changeWorld(u"battery=11"_s);
    QTRY_VERIFY(says(u"0 % (reported: -"_s));
    // Without a link nobody knows; it is not said to be disarmed.
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(overview->state()->state(), State::Unknown);
}

void TestBenchPage::motorIsChosenConfirmedAndTurned()
{
    QTRY_VERIFY(bench().obstacle().contains(u"Calibrate it first"_s));
    QVERIFY(!bench().turnButton()->isEnabled() && !bench().escs()->startButton()->isEnabled());
    QVERIFY(calibrate());
    QTRY_VERIFY(bench().obstacle().isEmpty());
    QTRY_VERIFY(bench().turnButton()->text().contains(u'1'));
    MotorDiagram *motors = bench().motors();
    QTest::mouseClick(motors, Qt::LeftButton, {}, motors->placeOf(2).toPoint());
    QTRY_VERIFY(bench().turnButton()->isEnabled());
    QVERIFY(bench().turnButton()->text().contains(u'2'));
    auto *number = bench().findChild<NumberBox *>();
    QCOMPARE(number->value(), 2.0);
    number->setValue(4);
    QCOMPARE(motors->selected(), 4);
    number->setValue(2);
    for (int round = 0; round < 2; ++round) {  // that the propellers are off is asked each time
        QTest::mouseClick(bench().turnButton(), Qt::LeftButton);
        QVERIFY(bench().isUnderWay());
        QCOMPARE(bench().deafText(), QString());
        // What is asked names the motor, and no other can be chosen meanwhile.
        QTRY_VERIFY(asked());
        QVERIFY(dangerousAnswer()->text().contains(u"Motor 2"_s));
        QTest::mouseClick(motors, Qt::LeftButton, {}, motors->placeOf(1).toPoint());
        QCOMPARE(motors->selected(), 2);
        QVERIFY(!number->isEnabled());
        if (round == 1)
            break;
        QVERIFY(confirm(u"The propellers are off"_s));
        QTRY_VERIFY(bench().deafText().contains(u"more second"_s));
        QTRY_COMPARE_WITH_TIMEOUT(motors->outputText(2), u"5 %"_s, 6000);
        QCOMPARE(motors->outputText(1), u"stands"_s);
        QVERIFY(motors->accessibleDescription().contains(u"being tested"_s));
        QTRY_VERIFY_WITH_TIMEOUT(!bench().isUnderWay(), kPatience);
        QCOMPARE(bench().deafText(), QString());
        QTRY_COMPARE(motors->outputText(2), u"stands"_s);
        QTRY_VERIFY(bench().turnButton()->isEnabled());
    }
    asked()->reject();
    QTRY_VERIFY(!bench().isUnderWay());
}

// Whoever has stopped the motors is not asked any more whether one is to turn.
void TestBenchPage::stopTakesTheQuestionAway()
{
    QVERIFY(calibrate());
    bench().motors()->setSelected(1);
    QTRY_VERIFY(bench().turnButton()->isEnabled());
    QTest::mouseClick(bench().turnButton(), Qt::LeftButton);
    QTRY_VERIFY(asked());
    QVERIFY(bench().isUnderWay());
    QTest::keyClick(&m_rig->window(), Qt::Key_F12);
    QTRY_VERIFY(!asked());
    QVERIFY(!bench().isUnderWay());
}

// All motors at full throttle, and nothing stops them: said in words, and what is safe is chosen already.
void TestBenchPage::dangerIsSaidBeforeItBegins()
{
    QVERIFY(calibrate());
    QTRY_VERIFY(bench().escs()->startButton()->isEnabled());
    bench().escs()->startButton()->click();
    QTRY_VERIFY(asked());
    for (const QString &words :
         {u"full throttle"_s, u"26 s"_s, u"Nothing stops it"_s, u"propellers are off"_s})
        QVERIFY2(asked()->text().contains(words), qPrintable(asked()->text()));
    QCOMPARE(dangerousAnswer()->text(), u"Calibrate motor controllers"_s);
    QVERIFY(asked()->defaultButton() != dangerousAnswer());
    QTRY_VERIFY(!isShielded(middleOf(dangerousAnswer())));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QTRY_VERIFY(!asked());
    QTRY_VERIFY(!bench().isUnderWay());
    QVERIFY(!m_rig->workspace().unstoppable());
}

// Neither on another page nor once the drone is armed.
void TestBenchPage::questionGoesWithWhatItWasAskedFor()
{
    QVERIFY(calibrate());
    const auto ask = [this] {
        bench().motors()->setSelected(1);
        return QTest::qWaitFor([this] { return bench().turnButton()->isEnabled(); }, kPatience)
            && (bench().turnButton()->click(), asked());
    };
    QVERIFY(ask());
    m_rig->page<DashboardPage>();
    QTRY_VERIFY(!asked());
    QVERIFY(!m_rig->workspace().isAtWork());
    QVERIFY(ask());
    armFromElsewhere();
    QTRY_VERIFY_WITH_TIMEOUT(!asked(), kPatience);
    QTRY_VERIFY(!bench().isUnderWay());
    QVERIFY(m_rig->window().messageBar()->text().contains(u"is not asked any more"_s));
    m_rig->workspace().setMotors(false);
    QTRY_COMPARE_WITH_TIMEOUT(bench().findChild<ArmedState *>()->state(), State::Disarmed, kPatience);
}

void TestBenchPage::propellersInAStandKeepMotorsFromTheBench()
{
    QVERIFY(calibrate());
    auto *flight = m_rig->page<FlightPage>();
    flight->open(true);
    auto refused = m_rig->workspace().perform(u"motor.test"_s, {{u"motor"_s, 1}});
    QVERIFY(refused.isFinished() && !refused.result());
    QVERIFY(!asked());
    QVERIFY(m_rig->window().messageBar()->text().contains(u"propellers are on"_s));
    flight->sessionButton()->click();
    auto wanted = m_rig->workspace().perform(u"motor.test"_s, {{u"motor"_s, 1}});
    QTRY_VERIFY(asked());
    flight->open(true);  // however that comes about
    QTRY_VERIFY(!asked());
    QTRY_VERIFY(wanted.isFinished() && !wanted.result());
}

// The second click of a hurry meets what was asked behind it: nothing turns.
void TestBenchPage::secondClickConfirmsNothing()
{
    QVERIFY(calibrate());
    int restored = 0;
    m_rig->workspace().notifications().ask({u"Restore?"_s, {{u"Restore them"_s, [&] { ++restored; }}}});
    int next = 0;
    m_rig->workspace().notifications().ask({u"And that?"_s, {{u"Do that as well"_s, [&] { ++next; }}}});
    QVERIFY(m_rig->isSettled());
    const auto *offers = m_rig->window().offerBar();
    const auto first = [&] { return middleOf(offers->buttons().first()); };
    QTRY_VERIFY(!isShielded(first()));
    clickAt(first());
    QCOMPARE(restored, 1);
    QVERIFY(m_rig->isSettled());
    if (isShielded(first()))
        clickAt(first());
    QCOMPARE(next, 0);
    // A question about a motor waits behind none of them.
    auto turned = m_rig->workspace().perform(u"motor.test"_s, {{u"motor"_s, 1}});
    QVERIFY(asked());
    QVERIFY(asked()->isVisible());
    const QPoint danger = middleOf(dangerousAnswer());
    QVERIFY(isShielded(danger));
    clickAt(danger);
    QTest::keyClick(dangerousAnswer(), Qt::Key_Return);
    QVERIFY(asked());
    QVERIFY(!turned.isFinished() && !m_rig->workspace().unstoppable());
    QTRY_VERIFY(!isShielded(middleOf(dangerousAnswer())));
    clickAt(middleOf(dangerousAnswer()));
    QTRY_VERIFY(m_rig->workspace().unstoppable());
    QTRY_VERIFY_WITH_TIMEOUT(turned.isFinished(), kPatience);
    QVERIFY(!m_rig->workspace().unstoppable());
}

void TestBenchPage::whatCannotBeCancelledIsOnlyWaitedFor()
{
    QVERIFY(calibrate());
    auto turned = m_rig->workspace().perform(u"motor.test"_s, {{u"motor"_s, 1}});
    QVERIFY(confirm(u"The propellers are off"_s));
    QTRY_VERIFY(m_rig->workspace().unstoppable());
    m_rig->window().close();
    QTRY_VERIFY(asked());
    QVERIFY2(asked()->text().contains(u"cannot be cancelled"_s) && asked()->text().contains(u"5 %"_s),
             qPrintable(asked()->text()));
    QVERIFY(!dangerousAnswer());
    QCOMPARE(asked()->buttons().size(), 2);
    QVERIFY(!turned.isFinished());
    QTRY_VERIFY_WITH_TIMEOUT(turned.isFinished(), kPatience);
    QTRY_VERIFY(!asked());
    QVERIFY(m_rig->window().isVisible());
}

// It says how long the drone hears nothing, and that the stop comes first then; so it does.
void TestBenchPage::redButtonSaysThatItIsDeaf()
{
    QVERIFY(calibrate());
    bench().motors()->setSelected(1);
    QTRY_VERIFY(bench().turnButton()->isEnabled());
    QTest::mouseClick(bench().turnButton(), Qt::LeftButton);
    QVERIFY(confirm(u"The propellers are off"_s));
    QTRY_VERIFY(!bench().deafText().isEmpty());
    // What it said before counts no more, although nothing turns yet.
    QVERIFY(QTest::qWaitFor([this] {
        return bench().findChild<ArmedState *>()->state() == State::RunsOn
            && m_rig->workspace().latest(m_rig->workspace().roles().outputs) == 0;
    }));
    auto *red = m_rig->window().findChild<QPushButton *>(u"motors"_s);
    QVERIFY(red);
    QVERIFY(red->toolTip().contains(u"in flight"_s));
    QTRY_VERIFY2(red->text().contains(u"deaf"_s), qPrintable(red->text()));
    QSignalSpy stopped(&m_rig->client(), &DeviceClient::motorsOffFinished);
    QStringList told;
    connect(&m_rig->workspace().notifications(), &Notifications::notice, this,
            [&told](const QString &text) { told.append(text); });
    QStringList problems;
    connect(&m_rig->workspace().notifications(), &Notifications::problem, this,
            [&problems](const ErrorText &text) { problems.append(text.what); });
    QSignalSpy withdrawn(&m_rig->workspace().notifications(), &Notifications::withdrawn);
    QList<AlarmKind> alarms;
    connect(&m_rig->client(), &DeviceClient::alarmChanged, this,
            [&alarms](const AlarmReport &report) { alarms.append(report.alarm.kind); });
    QTest::mouseClick(red, Qt::LeftButton);
    QTRY_VERIFY(told.join(u' ').contains(u"first thing that it hears"_s));
    static const QRegularExpression until(u"hears nothing until ([0-9:]{8}), also no stop"_s);
    const auto heard = until.match(told.join(u' '));
    QVERIFY2(heard.hasMatch(), qPrintable(told.join(u' ')));
    // Of the 8 s that it takes at most.
    const int left = QTime::currentTime().secsTo(QTime::fromString(heard.captured(1), u"HH:mm:ss"_s));
    QVERIFY2(left <= 9 && left > -60, qPrintable(heard.captured(1)));
    QCOMPARE(stopped.count(), 0);
    // That stays to be read, and red is red, although no motor turns yet.
    QTRY_VERIFY(red->property("running").toBool());
    QTRY_COMPARE(bench().findChild<ArmedState *>()->state(), State::RunsOn);
    QVERIFY(withdrawn.isEmpty());
    QTRY_VERIFY_WITH_TIMEOUT(stopped.count() > 0, kPatience);
    QVERIFY(stopped.first().first().toBool());
    // Who has stopped it is told so, and how it stands: that is no error.
    QTRY_VERIFY_WITH_TIMEOUT(told.join(u' ').contains(u"You stopped “Turn one motor”"_s), kPatience);
    QVERIFY2(told.join(u' ').contains(u"proven"_s), qPrintable(told.join(u' ')));
    QVERIFY2(problems.isEmpty(), qPrintable(problems.join(u' ')));
    // The test that goes on drives its motors although it is disarmed: that is what it is for.
    QVERIFY(!alarms.contains(AlarmKind::Disarmed));
    // Nothing was said to be unconfirmed while it could not hear.
    QVERIFY2(!told.join(u' ').contains(u"does not confirm yet"_s), qPrintable(told.join(u' ')));
    QTRY_VERIFY_WITH_TIMEOUT(!bench().isUnderWay(), kPatience);
    // What was proven is past with the next one.
    const auto says = [this] { return m_rig->window().messageBar()->text().contains(u"You stopped"_s); };
    QTRY_VERIFY_WITH_TIMEOUT(says(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(bench().obstacle().isEmpty(), kPatience);
    QTest::mouseClick(bench().turnButton(), Qt::LeftButton);
    QVERIFY(confirm(u"The propellers are off"_s));
    QTRY_VERIFY_WITH_TIMEOUT(!bench().deafText().isEmpty(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!says(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!bench().isUnderWay(), kPatience);
}

void TestBenchPage::fileIsLookedAtFirst()
{
    FirmwareCard *card = bench().firmware();
    QVERIFY(!card->uploadButton()->isEnabled());
    card->choose(firmwareFile(u"large.bin"_s, 4194305));
    QVERIFY2(!card->said().isEmpty() && !card->uploadButton()->isEnabled(), qPrintable(card->said()));
    card->choose(firmwareFile(u"empty.bin"_s, 0));
    QVERIFY(!card->said().isEmpty() && !card->uploadButton()->isEnabled());
    card->choose(m_rig->filePath(u"none.bin"_s));
    QVERIFY(!card->said().isEmpty() && !card->uploadButton()->isEnabled());
    card->choose(firmwareFile(u"good.bin"_s, 4194304));
    QVERIFY(card->said().isEmpty());
    QTRY_VERIFY(card->uploadButton()->isEnabled());
}

void TestBenchPage::firmwareNeedsABattery()
{
    FirmwareCard *card = bench().firmware();
    card->choose(firmwareFile(u"new.bin"_s, 20000));
    m_rig->workspace().changeWorld(u"battery=13.2"_s);
    QTRY_VERIFY(std::abs(m_rig->workspace().latest(m_rig->workspace().roles().battery) - 13.2) < 0.3);
    QTRY_VERIFY(card->uploadButton()->isEnabled());
    QTest::mouseClick(card->uploadButton(), Qt::LeftButton);
    QVERIFY(!card->isRunning());
    QVERIFY2(card->said().contains(u"battery is low"_s), qPrintable(card->said()));
}

void TestBenchPage::firmwareIsUploaded()
{
    FirmwareCard *card = bench().firmware();
    QVERIFY(QDir(m_rig->filePath({})).mkpath(QString(120, u'x')));
    const QString path = firmwareFile(QString(120, u'x') + u"/new.bin"_s, 20000);
    card->choose(path);
    QTRY_VERIFY(card->uploadButton()->isEnabled());
    QCOMPARE(m_rig->client().identity().firmware, u"1.0"_s);
    QTest::mouseClick(card->uploadButton(), Qt::LeftButton);
    QVERIFY(card->isRunning() && bench().isUnderWay());
    QTRY_VERIFY(asked());
    // What cannot be had back is asked in red, and with a short word, however long the path is.
    QCOMPARE(dangerousAnswer()->text(), u"Upload firmware"_s);
    QVERIFY2(asked()->text().contains(u"new.bin"_s), qPrintable(asked()->text()));
    QVERIFY(asked()->text().contains(u'…'));
    QVERIFY(asked()->toolTip().contains(path));
    QVERIFY2(asked()->text().contains(u"Nothing in the file shows"_s), qPrintable(asked()->text()));
    QVERIFY(confirm(u"The file was made for this drone"_s));
    QTRY_VERIFY_WITH_TIMEOUT(card->said().contains(u"do not switch it off"_s), kPatience);
    QVERIFY(!card->cancelButton()->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(!card->isRunning(), 2 * kPatience);
    QVERIFY2(card->said().contains(u"7.7"_s) && card->said().startsWith(u'✓'), qPrintable(card->said()));
    // And the window knows it.
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected() && m_rig->client().identity().firmware == u"7.7"_s,
                             kPatience);
}

// It may count its axes otherwise, even where it tells the same version.
void TestBenchPage::anotherFirmwareIsCheckedAnew()
{
    QTRY_VERIFY_WITH_TIMEOUT(!axesKey(m_rig->workspace()).isEmpty(), kPatience);
    CheckedDirections all;
    all.level = CheckedDirections::Level::All;
    keepDirections(m_rig->workspace(), all);
    QVERIFY(calibrate());
    QCOMPARE(checkedDirections(m_rig->workspace()), all);
    // What was refused has changed nothing.
    const QString text = m_rig->filePath(u"notes.txt"_s);
    QVERIFY(writeWhole(text, QByteArray("no program\n").repeated(200)));
    const auto refused = m_rig->workspace().perform(u"firmware.upload"_s, {{u"file"_s, text}});
    QVERIFY(confirm(u"The file was made for this drone"_s));
    QTRY_VERIFY_WITH_TIMEOUT(refused.isFinished(), kPatience);
    QVERIFY(!refused.result());
    QCOMPARE(refused.result().error().code, ErrorCode::BadFile);
    QCOMPARE(checkedDirections(m_rig->workspace()), all);
    FirmwareCard *card = bench().firmware();
    card->choose(firmwareFile(u"same.bin"_s, 20000, "1.0"));
    QTRY_VERIFY(card->uploadButton()->isEnabled());
    QTest::mouseClick(card->uploadButton(), Qt::LeftButton);
    QVERIFY(confirm(u"The file was made for this drone"_s));
    QTRY_VERIFY_WITH_TIMEOUT(card->said().contains(u"do not switch it off"_s), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!card->isRunning(), 2 * kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected() && !axesKey(m_rig->workspace()).isEmpty(),
                             kPatience);
    QCOMPARE(m_rig->client().identity().firmware, u"1.0"_s);
    QCOMPARE(checkedDirections(m_rig->workspace()).level, CheckedDirections::Level::Nothing);
    QCOMPARE(droneDirections(m_rig->workspace()).level, CheckedDirections::Level::Nothing);
}

void TestBenchPage::cancelSaysWhatIsLeft()
{
    FirmwareCard *card = bench().firmware();
    card->choose(firmwareFile(u"long.bin"_s, 4000000));
    QTRY_VERIFY(card->uploadButton()->isEnabled());
    QTest::mouseClick(card->uploadButton(), Qt::LeftButton);
    QVERIFY(confirm(u"The file was made for this drone"_s));
    QTRY_VERIFY_WITH_TIMEOUT(card->said().contains(u" of "_s), kPatience);
    QTest::mouseClick(card->cancelButton(), Qt::LeftButton);
    QTRY_VERIFY(!card->isRunning());
    QVERIFY2(card->said().contains(u"stays silent until it is restarted"_s), qPrintable(card->said()));
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(m_rig->client().identity().firmware, u"1.0"_s);
    QVERIFY(m_rig->client().isConnected());
}

void TestBenchPage::phasesOfTheControllersAreShown()
{
    EscCard card;
    card.setObstacle(u"armed"_s);
    QVERIFY(!card.startButton()->isEnabled());
    const auto why = [&card] {
        const auto labels = card.findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [&card](const QLabel *label) {
            return label->text() == u"armed"_s && label->isVisibleTo(&card);
        });
    };
    QVERIFY(why());
    card.setObstacle({});
    QVERIFY(card.startButton()->isEnabled() && !why());
    const auto boldOnes = [&card] {
        QStringList texts;
        for (const QLabel *label : card.findChildren<QLabel *>()) {
            if (label->font().bold() && label->text().contains(u" s"_s))
                texts.append(label->text());
        }
        return texts;
    };
    Progress progress;
    progress.total = 260;
    QStringList seen;
    for (const char *step : {"escs-off", "escs-full", "escs-zero"}) {
        progress.step = QLatin1String(step);
        card.take(progress);
        QCOMPARE(boldOnes().size(), 1);
        seen += boldOnes();
        QVERIFY(!card.startButton()->isEnabled());
    }
    QVERIFY2(seen.removeDuplicates() == 0 && seen.at(1).contains(u"Full throttle"_s),
             qPrintable(seen.join(u' ')));
    card.setRunning(false);
    QCOMPARE(card.phase(), -1);
    QVERIFY(boldOnes().isEmpty() && card.startButton()->isEnabled());
}

// All of its 26 s: what turns when, the red button in the middle of it, and that the stop is what counts
// then.
void TestBenchPage::controllersAreCalibratedUntilTheRedButton()
{
    QVERIFY(calibrate());
    EscCard *card = bench().escs();
    QTRY_VERIFY(card->startButton()->isEnabled());
    QStringList told;
    connect(&m_rig->workspace().notifications(), &Notifications::notice, this,
            [&told](const QString &text) { told.append(text); });
    QTest::mouseClick(card->startButton(), Qt::LeftButton);
    QVERIFY(confirm(u"The propellers are off"_s));
    QTRY_COMPARE(card->phase(), 0);
    QVERIFY(!bench().turnButton()->isEnabled() && !card->startButton()->isEnabled());
    auto *red = m_rig->window().findChild<QPushButton *>(u"motors"_s);
    QTRY_VERIFY2(red->text().contains(u"deaf"_s), qPrintable(red->text()));
    QTRY_COMPARE_WITH_TIMEOUT(card->phase(), 1, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(bench().motors()->outputText(1), u"100 %"_s, kPatience);
    QSignalSpy stopped(&m_rig->client(), &DeviceClient::motorsOffFinished);
    QTest::mouseClick(red, Qt::LeftButton);
    QTRY_VERIFY(told.join(u' ').contains(u"first thing that it hears"_s));
    QCOMPARE(stopped.count(), 0);
    QTRY_COMPARE_WITH_TIMEOUT(card->phase(), 2, kPatience);  // nothing can end it before
    QTRY_VERIFY_WITH_TIMEOUT(stopped.count() > 0, kPatience);
    QVERIFY(stopped.first().first().toBool());
    QTRY_VERIFY_WITH_TIMEOUT(!bench().isUnderWay(), kPatience);
    QCOMPARE(card->phase(), -1);
    QTRY_COMPARE(bench().deafText(), QString());
    QTRY_COMPARE(bench().motors()->outputText(1), u"stands"_s);
    QVERIFY2(told.join(u' ').contains(u"You stopped “Calibrate motor controllers”"_s),
             qPrintable(told.join(u' ')));
    QTRY_VERIFY(card->startButton()->isEnabled());
}

// Armed by another ground station: the dashboard says so, and the red button is red.
void TestBenchPage::armedIsUnmistakable()
{
    DashboardPage &page = *m_rig->page<DashboardPage>();
    auto *overview = page.findChild<FlightOverview *>();
    QVERIFY(calibrate());
    QTRY_COMPARE(overview->state()->state(), State::Disarmed);
    const QString atRest = overview->state()->accessibleName() + overview->state()->accessibleDescription();
    const QImage before = overview->state()->grab().toImage();
    armFromElsewhere();
    QTRY_COMPARE_WITH_TIMEOUT(overview->state()->state(), State::Armed, kPatience);
    QVERIFY(overview->state()->accessibleName() + overview->state()->accessibleDescription() != atRest);
    QVERIFY(overview->state()->grab().toImage() != before);
    QTRY_VERIFY(overview->motors()->outputText(1).contains(u'%'));
    auto *red = m_rig->window().findChild<QPushButton *>(u"motors"_s);
    QTRY_VERIFY(red->property("running").toBool());
    QTRY_VERIFY2(red->text().contains(u"STOP"_s), qPrintable(red->text()));
    // What is dangerous now is not offered.
    QTRY_VERIFY(bench().obstacle().contains(u"armed"_s));
    QVERIFY(!bench().turnButton()->isEnabled() && !bench().escs()->startButton()->isEnabled());
    m_rig->page<DashboardPage>();
    QTest::mouseClick(red, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(overview->state()->state(), State::Disarmed, kPatience);
    QTRY_COMPARE(overview->motors()->outputText(1), u"stands"_s);
}

void TestBenchPage::messagesLeaveMotorsInSight_data()
{
    QTest::addColumn<QString>("key");
    for (const QString &key : {u"bench"_s, u"flight"_s, u"dashboard"_s})
        QTest::newRow(qPrintable(key)) << key;
}

// The page gets lower where motors would be hidden at both edges, and has its room again afterwards.
void TestBenchPage::messagesLeaveMotorsInSight()
{
    QFETCH(const QString, key);
    MainWindow &window = m_rig->window();
    window.resize(1280, 800);
    QVERIFY(calibrate());
    QVERIFY(window.showPage(key));
    window.messageBar()->hide();
    window.offerBar()->clear();
    QCursor::setPos(window.mapToGlobal(QPoint(40, 400)));
    QVERIFY(m_rig->isSettled());
    const Page *page = window.page(key);
    const QSize before = page->size();
    const auto placeOf = [&window](const QWidget *widget) {
        return QRect(widget->mapTo(&window, QPoint()), widget->size());
    };
    m_rig->workspace().notifications().notify(u"Something to be looked at."_s, Notice::Attention);
    QVERIFY(m_rig->isSettled());
    const QRect message = placeOf(window.messageBar());
    QVERIFY(window.messageBar()->isVisible());
    int seen = 0;
    for (const QWidget *each : page->findChildren<QWidget *>()) {
        const bool isKept
            = qobject_cast<const ArmedState *>(each) || qobject_cast<const MotorDiagram *>(each);
        if (!isKept || !each->isVisible())
            continue;
        ++seen;
        QVERIFY2(!message.intersects(placeOf(each)), each->metaObject()->className());
    }
    QCOMPARE(seen, 2);
    window.messageBar()->hide();
    QTRY_COMPARE(page->size(), before);
}

QTEST_MAIN(TestBenchPage)
#include "tst_benchpage.moc"
