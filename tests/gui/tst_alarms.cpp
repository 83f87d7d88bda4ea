// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/alarmbar.h"
#include "app/mainwindow/bannerarea.h"
#include "app/mainwindow/bars.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/navigation.h"
#include "app/pages/board/controlpage.h"
#include "app/pages/program/settingspage.h"
#include "app/pages/tune/tuningpage.h"
#include "app/pages/watch/alarmcard.h"
#include "app/pages/watch/dashboardpage.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/clickshield.h"
#include "widgets/forms/panel.h"
#include "widgets/models/alarmtext.h"
#include "widgets/views/controlpad.h"

#include <QApplication>
#include <QComboBox>
#include <QCursor>
#include <QLabel>
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
    void alarmHidesNoMessage();
    void runawayIsSeenAndAcknowledged();
    void changeThatOscillatesGoesBackOnScreen();
    void warningGoesWithItsCause();
    void warningGoesWithTheLink();
    void deadLinkIsNotTheEndOfAnAlarm();
    void headingsStayInSight_data();
    void headingsStayInSight();
    void clickMeantForAnotherDoesNothing();
    void nothingMovesBeneathTheBar();
    void headOfThePageStaysInReach();
    void whatItPushesAwayTakesNoClicks();
    void storingAlarmedValuesAsks();
    void sameCauseIsOneCard();
    void motionStaysInSight_data();
    void motionStaysInSight();
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

// Nothing moves beneath the pointer, and the keyboard stays where it was.
void TestAlarms::alarmFloats()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=50"_s));
    auto *settings = m_rig->page<SettingsPage>();
    QVERIFY(m_rig->isSettled());
    QCursor::setPos(settings->mapToGlobal(settings->rect().center()));
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
    QCOMPARE(bar()->width(), m_rig->window().findChild<BannerArea *>()->width());  // of the page
    QVERIFY(bar()->remedyButton()->isVisible());
    // By keyboard it can be reached all the same.
    QVERIFY(bar()->remedyButton()->focusPolicy() & Qt::TabFocus);
    QVERIFY(bar()->acknowledgeButton()->focusPolicy() & Qt::TabFocus);
    QVERIFY(!bar()->accessibleName().isEmpty() && !bar()->accessibleDescription().isEmpty());
    // When it has left, the page comes out from beneath.
    const auto isFree = [&] {
        const auto end = [](const QWidget &widget) { return widget.mapToGlobal(QPoint(0, widget.height())); };
        return settings->mapToGlobal(QPoint()).y() >= end(*bar()).y();
    };
    QVERIFY(!isFree());
    QCursor::setPos(m_rig->window().mapToGlobal(QPoint(5, 5)));
    QTRY_VERIFY(isFree());
    QTest::qWait(700);  // clicks at once are not meant
    bar()->acknowledgeButton()->click();
    QTRY_VERIFY(bar()->isHidden());
    QTRY_COMPARE(placesOf(*settings), before);
}

// Whichever of them comes first.
void TestAlarms::alarmHidesNoMessage()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=50"_s));
    QCursor::setPos(m_rig->window().mapToGlobal(QPoint(2, m_rig->window().height() - 2)));
    MessageBar &messages = *m_rig->window().messageBar();
    const auto isInSight = [&] {
        const auto place
            = [](const QWidget &widget) { return QRect(widget.mapToGlobal(QPoint()), widget.size()); };
        return bar()->isVisible() && messages.isVisible() && !place(*bar()).intersects(place(messages));
    };
    AlarmReport report;
    report.number = 1;
    report.alarm.axis = Axis::Roll;
    emit m_rig->client().alarmChanged(report);
    m_rig->workspace().notifications().reportMotorsMayRun(u"Nobody knows."_s);
    QTRY_VERIFY(isInSight());
    m_rig->workspace().alarms().acknowledge(1);
    QTRY_VERIFY(bar()->isHidden());
    m_rig->workspace().notifications().settle(Concern::Motors);
    QTRY_VERIFY(!messages.isVisible());
    m_rig->workspace().notifications().reportMotorsMayRun(u"Nobody knows."_s);
    report.number = 2;
    emit m_rig->client().alarmChanged(report);
    QTRY_VERIFY(isInSight());
}

void TestAlarms::runawayIsSeenAndAcknowledged()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=51"_s));
    QVERIFY(m_rig->boardGoesOn(1.5));
    QVERIFY(bar()->isHidden());
    m_rig->workspace().changeWorld(u"swapped-axes=1"_s);
    QTRY_VERIFY(bar()->isVisible());
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
    QTRY_VERIFY(bar()->isVisible() && bar()->text().contains(u"was reverted"_s));
    QVERIFY2(bar()->text().contains(u"255 → 25"_s), qPrintable(bar()->text()));
    // The page shows what the board uses.
    QTRY_COMPARE(*live.value(gain), before);
    QTRY_COMPARE(live.changeCount(), 0);
    QTRY_VERIFY(m_rig->workspace().alarms().all().first().isOver);
}

void TestAlarms::warningGoesWithItsCause()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=53"_s));
    QVERIFY(m_rig->boardGoesOn(1.0));
    m_rig->workspace().changeWorld(u"battery=9.9"_s);
    QTRY_VERIFY(bar()->isVisible());
    QCOMPARE(bar()->property("severe").toBool(), false);
    QVERIFY(bar()->text().contains(u"battery"_s));
    m_rig->workspace().changeWorld(u"battery=12.3"_s);
    QTRY_VERIFY(bar()->isHidden());
    // But not from the dashboard, until it is acknowledged.
    QCOMPARE(m_rig->workspace().alarms().all().size(), 1);
}

// Without a link nobody sees whether it goes on; what does is told again.
void TestAlarms::warningGoesWithTheLink()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?fault=battery=9.9"_s));
    QTRY_VERIFY(!bar()->isHidden());
    m_rig->workspace().changeWorld(u"battery=12.6"_s);
    m_rig->workspace().changeWorld(u"replug=1"_s);
    m_rig->workspace().changeWorld(u"unplug=0"_s);
    QTRY_VERIFY(m_rig->client().state() == DeviceClient::State::Reconnecting);
    QVERIFY(bar()->isHidden());
    QTRY_VERIFY(m_rig->client().isConnected());
    QVERIFY(m_rig->boardGoesOn(4.0));
    QVERIFY(bar()->isHidden());
}

// It has not ended, the link has.
void TestAlarms::deadLinkIsNotTheEndOfAnAlarm()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=57"_s));
    AlarmReport report;
    report.number = 1;
    report.alarm.kind = AlarmKind::Stale;
    emit m_rig->client().alarmChanged(report);
    QVERIFY(bar()->isVisible());
    m_rig->workspace().changeWorld(u"replug=1"_s);
    m_rig->workspace().changeWorld(u"unplug=0"_s);
    QTRY_VERIFY(m_rig->client().state() == DeviceClient::State::Reconnecting);
    QVERIFY(bar()->isHidden());
    report.isOver = true;
    emit m_rig->client().alarmChanged(report);
    QVERIFY2(bar()->isHidden(), qPrintable(bar()->text()));
    QVERIFY(m_rig->workspace().alarms().all().isEmpty());
}

void TestAlarms::headingsStayInSight_data()
{
    QTest::addColumn<QString>("page");
    QTest::addColumn<QSize>("size");
    QTest::newRow("dashboard") << u"dashboard"_s << QSize(1280, 800);
    for (const char *page : {"guide", "profiles"}) {
        QTest::addRow("%s", page) << QString::fromLatin1(page) << QSize(1280, 800);
        QTest::addRow("%s, small", page) << QString::fromLatin1(page) << QSize(1024, 640);
    }
}

// Neither an alarm nor a message lies over them, wherever the pointer is.
void TestAlarms::headingsStayInSight()
{
    QFETCH(QString, page);
    QFETCH(QSize, size);
    m_rig->window().resize(size);
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=58"_s));
    QVERIFY(m_rig->window().showPage(page));
    QVERIFY(m_rig->isSettled());
    const QWidget *shown = m_rig->window().page(page);
    QCursor::setPos(shown->mapToGlobal(shown->rect().center()));
    const auto hiddenBy = [&](const QWidget &banner) {
        const auto place
            = [](const QWidget &widget) { return QRect(widget.mapToGlobal(QPoint()), widget.size()); };
        QStringList hidden;
        for (const QLabel *label : shown->findChildren<QLabel *>()) {
            const bool isHeading = label->objectName() == u"section"_s || label->objectName() == u"title"_s;
            if (isHeading && !label->visibleRegion().isEmpty() && place(banner).intersects(place(*label)))
                hidden.append(label->text());
        }
        return hidden.join(u", "_s);
    };
    m_rig->workspace().notifications().notify(u"Done."_s);
    QVERIFY(m_rig->isSettled());
    const MessageBar &messages = *m_rig->window().messageBar();
    QVERIFY(messages.isVisible());
    QCOMPARE(hiddenBy(messages), QString());
    AlarmReport report;
    report.number = 1;
    report.alarm.axis = Axis::Roll;
    emit m_rig->client().alarmChanged(report);
    QVERIFY(m_rig->isSettled());
    QVERIFY(bar()->isVisible());
    QCOMPARE(hiddenBy(*bar()), QString());
}

void TestAlarms::clickMeantForAnotherDoesNothing()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=54"_s));
    AlarmReport report;
    report.number = 7;
    report.alarm.kind = AlarmKind::Saturation;
    report.alarm.axis = Axis::Yaw;
    emit m_rig->client().alarmChanged(report);
    QVERIFY(bar()->isVisible() && m_rig->isSettled());
    const auto click = [this] {
        const QPushButton *button = bar()->acknowledgeButton();
        QTest::mouseClick(m_rig->window().windowHandle(), Qt::LeftButton, {},
                          button->mapTo(&m_rig->window(), button->rect().center()));
    };
    click();
    QVERIFY(bar()->isVisible());
    QTRY_VERIFY((click(), bar()->isHidden()));
}

// Neither when the pointer comes to it, nor when it goes; and a second click in a hurry reaches nothing.
void TestAlarms::nothingMovesBeneathTheBar()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=50"_s));
    auto *settings = m_rig->page<SettingsPage>();
    QVERIFY(m_rig->isSettled());
    QCursor::setPos(settings->mapToGlobal(settings->rect().center()));
    const auto place = [&] { return settings->mapToGlobal(QPoint()); };
    const QPoint before = place();
    AlarmReport report;
    report.number = 1;
    report.alarm.axis = Axis::Roll;
    emit m_rig->client().alarmChanged(report);
    QVERIFY(m_rig->isSettled());
    const QPushButton *button = bar()->acknowledgeButton();
    const QPoint at = button->mapTo(&m_rig->window(), button->rect().center());
    QCursor::setPos(m_rig->window().mapToGlobal(at));
    QVERIFY(m_rig->isSettled());
    report.alarm.value = 1;
    emit m_rig->client().alarmChanged(report);
    QVERIFY(m_rig->isSettled());
    QCOMPARE(place(), before);
    m_rig->workspace().alarms().acknowledge(1);
    QVERIFY(bar()->isHidden());
    const auto isShielded
        = [&] { return qobject_cast<ClickShield *>(m_rig->window().childAt(at)) != nullptr; };
    QVERIFY(isShielded());
    QVERIFY(m_rig->isSettled());
    QCOMPARE(place(), before);
    QTRY_VERIFY(!isShielded());
    QCOMPARE(place(), before);
}

// Whoever drags the stick disarms where he did before, and acknowledges nothing there.
void TestAlarms::headOfThePageStaysInReach()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=50"_s));
    auto *page = m_rig->page<ControlPage>();
    QVERIFY(m_rig->isSettled());
    const auto *arm = page->armButton();
    const auto *pad = page->findChild<ControlPad *>();
    QVERIFY(arm && pad);
    QCursor::setPos(pad->mapToGlobal(pad->rect().center()));
    const QPoint at = arm->mapTo(&m_rig->window(), arm->rect().center());
    const QRect before(pad->mapToGlobal(QPoint()), pad->size());
    AlarmReport report;
    report.number = 1;
    report.alarm.kind = AlarmKind::Stale;
    emit m_rig->client().alarmChanged(report);
    QVERIFY(m_rig->isSettled());
    QVERIFY(bar()->isVisible());
    QVERIFY(!bar()->geometry().isEmpty());
    QTRY_COMPARE(m_rig->window().childAt(at), arm);
    QCOMPARE(QRect(pad->mapToGlobal(QPoint()), pad->size()), before);
    const QRect entries(m_rig->window().findChild<Navigation *>()->mapToGlobal(QPoint()),
                        m_rig->window().findChild<Navigation *>()->size());
    QVERIFY(!entries.intersects({bar()->mapToGlobal(QPoint()), bar()->size()}));
}

void TestAlarms::whatItPushesAwayTakesNoClicks()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=50"_s));
    QVERIFY(m_rig->window().showPage(u"help"_s));  // with nothing of importance at the upper edge
    const QWidget *page = m_rig->window().page(u"help"_s);
    QCursor::setPos(page->mapToGlobal(page->rect().center()));
    m_rig->workspace().notifications().ask({u"Which?"_s, {{u"This"_s, [] {}}}});
    QVERIFY(m_rig->isSettled());
    const OfferBar *offers = m_rig->window().offerBar();
    const auto middle = [&] {
        const QPushButton *button = offers->buttons().first();
        return button->mapTo(&m_rig->window(), button->rect().center());
    };
    const auto isShielded
        = [&](QPoint at) { return qobject_cast<ClickShield *>(m_rig->window().childAt(at)) != nullptr; };
    const QPoint before = middle();
    QTRY_VERIFY(!isShielded(before));
    AlarmReport report;
    report.number = 1;
    report.alarm.axis = Axis::Roll;
    emit m_rig->client().alarmChanged(report);
    QVERIFY(m_rig->isSettled());
    QVERIFY(middle() != before);
    QVERIFY(isShielded(middle()));
    QVERIFY(isShielded(before) || bar()->geometry().contains(before));
    QTRY_VERIFY(!isShielded(middle()));
}

void TestAlarms::storingAlarmedValuesAsks()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=50"_s));
    LiveModel &live = m_rig->workspace().live();
    const int gain = m_rig->spec(u"pid.roll.p"_s).id;
    QTRY_VERIFY(live.value(gain));
    live.setValue(gain, m_rig->raw(u"pid.roll.p"_s) + 5);
    QTRY_VERIFY(live.isSettled() && live.changeCount() == 1);
    AlarmReport report;
    report.number = 1;
    report.alarm.kind = AlarmKind::Oscillation;
    report.alarm.axis = Axis::Roll;
    emit m_rig->client().alarmChanged(report);
    std::optional<bool> stored;
    const auto store = [&] {
        stored.reset();
        m_rig->workspace().saveLive(m_rig->window()).then(this, [&stored](bool done) { stored = done; });
    };
    store();
    QVERIFY(m_rig->window().panels()->isOpen());
    m_rig->window().panels()->newest()->reject();
    QTRY_COMPARE(stored, std::optional(false));
    QCOMPARE(live.changeCount(), 1);
    // Other values have caused none.
    live.setValue(gain, m_rig->raw(u"pid.roll.p"_s) + 3);
    QTRY_VERIFY(live.isSettled());
    store();
    QVERIFY(!m_rig->window().panels()->isOpen());
    QTRY_COMPARE(stored, std::optional(true));
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

// What only gives time goes with its cause; that the camera moved, or was steered unseen, is not overlooked.
void TestAlarms::motionStaysInSight()
{
    QFETCH(AlarmKind, kind);
    QFETCH(bool, mayBeMeant);
    QFETCH(bool, stays);
    QVERIFY(m_rig->open(u"sim:simplebgc?seed=56"_s));
    AlarmReport report;
    report.number = 1;
    report.alarm.kind = kind;
    report.alarm.axis = Axis::Yaw;
    report.alarm.mayBeMeant = mayBeMeant;
    emit m_rig->client().alarmChanged(report);
    QVERIFY(bar()->isVisible());
    report.isOver = true;
    emit m_rig->client().alarmChanged(report);
    QCOMPARE(bar()->isVisible(), stays);
    if (!stays)
        return;
    // Nobody has seen it end.
    QVERIFY2(bar()->text().contains(u"Not watched any more: "_s), qPrintable(bar()->text()));
    report.wasSeenToEnd = true;
    emit m_rig->client().alarmChanged(report);
    QVERIFY2(bar()->text().contains(u"Over: "_s), qPrintable(bar()->text()));
    m_rig->workspace().alarms().acknowledge(1);
    QVERIFY(!bar()->isVisible());
}

void TestAlarms::motionStaysInSight_data()
{
    QTest::addColumn<AlarmKind>("kind");
    QTest::addColumn<bool>("mayBeMeant");
    QTest::addColumn<bool>("stays");
    QTest::newRow("runaway") << AlarmKind::Runaway << false << true;
    QTest::newRow("runaway that may be meant") << AlarmKind::Runaway << true << false;
    QTest::newRow("oscillation") << AlarmKind::Oscillation << false << true;
    QTest::newRow("steered unseen") << AlarmKind::Stale << false << true;
    QTest::newRow("heat") << AlarmKind::Heat << false << false;
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
    QTRY_VERIFY(bar()->isVisible());
    QVERIFY(bar()->remedyButton()->isVisible());
    QVERIFY(m_rig->workspace().motorsRunning().value_or(false));
    QTRY_VERIFY((QTest::mouseClick(bar()->remedyButton(), Qt::LeftButton),
                 m_rig->workspace().motorsRunning() == std::optional(false)));
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
              AlarmCause::TooMuchGain, AlarmCause::Resonance, AlarmCause::Fault, AlarmCause::OtherBattery}) {
            AlarmReport report;
            report.alarm.kind = AlarmKind(kind);
            report.alarm.cause = cause;
            report.alarm.axis = Axis::Roll;
            report.alarm.other = Axis::Pitch;
            report.alarm.cells = 3;
            const ErrorText text = describe(report, nullptr);
            QVERIFY(!text.what.isEmpty() && !text.meaning.isEmpty() && !text.cure.isEmpty());
            QVERIFY2(!text.oneLine().contains(u'%'), qPrintable(text.oneLine()));
        }
    }
    // A full battery below an alarm that belongs to another is not told to be changed; both voltages are
    // said.
    AlarmReport battery;
    battery.alarm.kind = AlarmKind::Battery;
    battery.alarm.cause = AlarmCause::OtherBattery;
    battery.alarm.value = 12.3;
    battery.alarm.limit = 14;
    battery.alarm.cells = 3;
    const ErrorText told = describe(battery, nullptr);
    QCOMPARE(alarmName(battery.alarm), u"Battery below the alarm"_s);
    QVERIFY2(told.what.contains(u"12.3"_s) && told.what.contains(u"14.0"_s), qPrintable(told.what));
    QVERIFY2(told.meaning.contains(u"4.10"_s) && told.cure.contains(u"if it has 3"_s), qPrintable(told.cure));
    // What is over goes on no more, and what nobody watches any longer is not called quiet.
    AlarmReport report;
    report.alarm.kind = AlarmKind::Oscillation;
    report.action = AlarmAction::TakeBack;
    report.change = LiveChange();
    report.outcome = AlarmOutcome::Done;
    report.isOver = true;
    QVERIFY(!describe(report, nullptr).what.contains(u"quiet"_s));
    report.wasSeenToEnd = true;
    QVERIFY(describe(report, nullptr).what.contains(u"it has been quiet since"_s));
    // Why the program had to act is needed by whoever goes on; what only was so is past.
    QVERIFY(!describe(report, nullptr).cure.isEmpty());
    report.action = AlarmAction::Warn;
    QVERIFY(describe(report, nullptr).cure.isEmpty());
    report.action = AlarmAction::TakeBack;
    report.outcome = AlarmOutcome::GoesOn;
    QVERIFY(!describe(report, nullptr).what.contains(u"goes on"_s));
}

QTEST_MAIN(TestAlarms)
#include "tst_alarms.moc"
