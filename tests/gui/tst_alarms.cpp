// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/alarmbar.h"
#include "app/pages/program/settingspage.h"
#include "app/pages/tune/tuningpage.h"
#include "app/pages/watch/alarmcard.h"
#include "app/pages/watch/dashboardpage.h"
#include "tests/support/windowrig.h"
#include "widgets/models/alarmtext.h"

#include <QApplication>
#include <QComboBox>
#include <QPushButton>
#include <QTest>

using namespace Qt::StringLiterals;

/// What the operator sees of the supervisor.
class TestAlarms : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }
    void alarmFloats();
    void runawayIsSeenAndAcknowledged();
    void changeThatOscillatesGoesBackOnScreen();
    void warningGoesWithItsCause();
    void clickMeantForAnotherDoesNothing();
    void sameCauseIsOneCard();
    void settingsAreKeptAndUsed();
    void settingsByHandAreChecked();
    void everyAlarmHasWords();

private:
    AlarmBar *bar() { return m_rig->window().findChild<AlarmBar *>(); }
    QList<QRect> placesOf(const QWidget &page)
    {
        QList<QRect> places;
        for (const QWidget *widget : page.findChildren<QWidget *>()) {
            if (widget->isVisible())
                places.append({widget->mapTo(&page, QPoint()), widget->size()});
        }
        return places;
    }

    std::unique_ptr<WindowRig> m_rig;
};

// Nothing moves, and the keyboard stays where it was.
void TestAlarms::alarmFloats()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=50"_s));
    auto *settings = m_rig->page<SettingsPage>();
    QVERIFY(m_rig->isSettled());
    const QList<QRect> before = placesOf(*settings);
    auto *focused = settings->findChild<QComboBox *>();
    focused->setFocus();
    AlarmReport report;
    report.number = 1;
    report.alarm.axis = Axis::Roll;
    emit m_rig->client().alarmChanged(report);
    QVERIFY(bar()->isVisible());
    QVERIFY(m_rig->isSettled());
    QCOMPARE(placesOf(*settings), before);
    QCOMPARE(QApplication::focusWidget(), focused);
    QCOMPARE(bar()->width(), m_rig->window().width());
    QVERIFY(bar()->remedyButton()->isVisible());
    // By keyboard it can be reached all the same.
    QVERIFY(bar()->remedyButton()->focusPolicy() & Qt::TabFocus);
    QVERIFY(bar()->acknowledgeButton()->focusPolicy() & Qt::TabFocus);
    QVERIFY(!bar()->accessibleName().isEmpty() && !bar()->accessibleDescription().isEmpty());
}

void TestAlarms::runawayIsSeenAndAcknowledged()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=51"_s));
    QVERIFY(m_rig->boardGoesOn(1.5));
    QVERIFY(bar()->isHidden());
    m_rig->workspace().changeWorld(u"swapped-axes=1"_s);
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), 5000);
    QVERIFY2(bar()->text().contains(u"axes are swapped"_s), qPrintable(bar()->text()));
    QTRY_VERIFY2(bar()->text().contains(u"The motors were switched off"_s), qPrintable(bar()->text()));
    QCOMPARE(bar()->property("severe").toBool(), true);
    QVERIFY(!bar()->remedyButton()->isVisible());  // they are off already
    // What the program did about it stays until it is acknowledged, also on the dashboard.
    QTRY_VERIFY(m_rig->workspace().alarms().all().first().isOver);
    QVERIFY(bar()->isVisible());
    auto *dashboard = m_rig->page<DashboardPage>();
    QTRY_COMPARE(dashboard->findChildren<AlarmCard *>().size(), 1);
    QVERIFY(std::any_of(m_rig->workspace().marks().all().begin(), m_rig->workspace().marks().all().end(),
                        [](const PlotMark &mark) { return mark.text.startsWith(u"Runaway"_s); }));
    QTest::qWait(700);  // clicks at once are not meant
    QTest::mouseClick(bar()->acknowledgeButton(), Qt::LeftButton);
    QTRY_VERIFY(bar()->isHidden());
    QTRY_COMPARE(dashboard->findChildren<AlarmCard *>().size(), 0);
}

void TestAlarms::changeThatOscillatesGoesBackOnScreen()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=52"_s));
    QVERIFY(m_rig->page<TuningPage>());
    QVERIFY(m_rig->boardGoesOn(1.5));
    LiveModel &live = m_rig->workspace().live();
    const int gain = m_rig->spec(u"pid.pitch.d"_s).id;
    QTRY_VERIFY(live.value(gain).has_value());
    const double before = *live.value(gain);
    live.setValue(gain, 255);
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible() && bar()->text().contains(u"was reverted"_s), 6000);
    QVERIFY2(bar()->text().contains(u"255 → 25"_s), qPrintable(bar()->text()));
    // The page shows what the board uses.
    QTRY_COMPARE(*live.value(gain), before);
    QTRY_COMPARE(live.changeCount(), 0);
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->workspace().alarms().all().first().isOver, 5000);
}

void TestAlarms::warningGoesWithItsCause()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=53"_s));
    QVERIFY(m_rig->boardGoesOn(1.0));
    m_rig->workspace().changeWorld(u"battery=9.9"_s);
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), 8000);
    QCOMPARE(bar()->property("severe").toBool(), false);
    QVERIFY(bar()->text().contains(u"battery"_s));
    m_rig->workspace().changeWorld(u"battery=12.3"_s);
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isHidden(), 8000);
    // But not from the dashboard, until it is acknowledged.
    QCOMPARE(m_rig->workspace().alarms().all().size(), 1);
}

void TestAlarms::clickMeantForAnotherDoesNothing()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=54"_s));
    AlarmReport report;
    report.number = 7;
    report.alarm.kind = AlarmKind::Saturation;
    report.alarm.axis = Axis::Yaw;
    emit m_rig->client().alarmChanged(report);
    QVERIFY(bar()->isVisible());
    QTest::mouseClick(bar()->acknowledgeButton(), Qt::LeftButton);
    QVERIFY(bar()->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(
        (QTest::mouseClick(bar()->acknowledgeButton(), Qt::LeftButton), bar()->isHidden()), 5000);
}

void TestAlarms::sameCauseIsOneCard()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=55"_s));
    Alarms &alarms = m_rig->workspace().alarms();
    AlarmReport report;
    report.alarm.kind = AlarmKind::Battery;
    for (int number = 1; number <= 4; ++number) {
        report.number = number;
        report.isOver = false;
        emit m_rig->client().alarmChanged(report);
        report.isOver = true;
        emit m_rig->client().alarmChanged(report);
    }
    QCOMPARE(alarms.all().size(), 1);
    QCOMPARE(alarms.timesOf(4), 4);
    alarms.acknowledge(4);
    emit m_rig->client().alarmChanged(report);  // what is told late of it is not wanted any more
    QVERIFY(alarms.all().isEmpty());
}

void TestAlarms::settingsAreKeptAndUsed()
{
    const SupervisorRules defaults = m_rig->settings().supervisorRules();
    QCOMPARE(defaults, SupervisorRules());
    QCOMPARE(defaults.action(AlarmKind::Runaway), AlarmAction::MotorsOff);
    QCOMPARE(defaults.action(AlarmKind::Oscillation), AlarmAction::TakeBack);
    QCOMPARE(defaults.action(AlarmKind::Battery), AlarmAction::Warn);
    auto *page = m_rig->page<SettingsPage>();
    const auto boxOf = [&](const QString &name) {
        for (QComboBox *box : page->findChildren<QComboBox *>()) {
            if (box->accessibleName() == name)
                return box;
        }
        return static_cast<QComboBox *>(nullptr);
    };
    QComboBox *runaway = boxOf(alarmName(AlarmKind::Runaway));
    QVERIFY(runaway);
    QCOMPARE(runaway->count(), 4);
    QCOMPARE(boxOf(alarmName(AlarmKind::Battery))->count(), 2);
    runaway->setCurrentIndex(0);
    emit runaway->activated(0);
    QCOMPARE(m_rig->settings().supervisorRules().action(AlarmKind::Runaway), AlarmAction::Warn);
    m_rig->restart();
    QCOMPARE(m_rig->settings().supervisorRules().action(AlarmKind::Runaway), AlarmAction::Warn);
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=56"_s));
    QVERIFY(m_rig->boardGoesOn(1.0));
    m_rig->workspace().changeWorld(u"swapped-axes=1"_s);
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), 5000);
    QVERIFY(bar()->remedyButton()->isVisible());
    QVERIFY(m_rig->workspace().motorsRunning().value_or(false));
    QTRY_VERIFY_WITH_TIMEOUT((QTest::mouseClick(bar()->remedyButton(), Qt::LeftButton),
                              m_rig->workspace().motorsRunning() == std::optional(false)),
                             8000);
}

void TestAlarms::settingsByHandAreChecked()
{
    {
        QSettings file(m_rig->filePath(u"odd.ini"_s), QSettings::IniFormat);
        file.setValue(u"supervisor/battery"_s, u"back"_s);  // not for a battery
        file.setValue(u"supervisor/runaway"_s, u"explode"_s);
        file.setValue(u"supervisor/runawayDegrees"_s, 1e9);
        file.setValue(u"supervisor/cellVolts"_s, u"nan"_s);
    }
    const Settings settings(m_rig->filePath(u"odd.ini"_s));
    SupervisorRules expected;
    expected.runawayDeg = 90;
    QCOMPARE(settings.supervisorRules(), expected);
}

void TestAlarms::everyAlarmHasWords()
{
    for (std::size_t kind = 0; kind < kAlarmKinds; ++kind) {
        QVERIFY(!alarmName(AlarmKind(kind)).isEmpty());
        for (const AlarmCause cause :
             {AlarmCause::Unknown, AlarmCause::SwappedAxes, AlarmCause::WrongDirection,
              AlarmCause::TooMuchGain, AlarmCause::Resonance, AlarmCause::Fault}) {
            AlarmReport report;
            report.alarm.kind = AlarmKind(kind);
            report.alarm.cause = cause;
            report.alarm.axis = Axis::Roll;
            report.alarm.other = Axis::Pitch;
            const ErrorText text = describe(report, nullptr);
            QVERIFY(!text.what.isEmpty() && !text.meaning.isEmpty() && !text.cure.isEmpty());
            QVERIFY2(!text.oneLine().contains(u'%'), qPrintable(text.oneLine()));
        }
    }
}

QTEST_MAIN(TestAlarms)
#include "tst_alarms.moc"
