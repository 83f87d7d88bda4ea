// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/navigation.h"
#include "app/mainwindow/palettesource.h"
#include "app/pages/board/actionspage.h"
#include "app/pages/board/directioncard.h"
#include "app/pages/board/flightpage.h"
#include "app/pages/setup/documentspage.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/tune/spectrumpage.h"
#include "app/pages/tune/tuningpage.h"
#include "app/pages/watch/dashboardpage.h"
#include "app/pages/watch/monitorpage.h"
#include "app/workspace/flightstate.h"
#include "app/workspace/signsnote.h"
#include "protocol/bcflight/tables.h"
#include "protocol/configuration/writereport.h"
#include "protocol/device/device.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/argumentform.h"
#include "widgets/forms/liveslider.h"
#include "widgets/forms/panel.h"
#include "widgets/forms/reviewdialog.h"
#include "widgets/models/changemodel.h"
#include "widgets/models/errortext.h"
#include "widgets/theme/theme.h"
#include "widgets/views/armedstate.h"
#include "widgets/views/attitudeview.h"
#include "widgets/views/batteryview.h"
#include "widgets/views/stalecover.h"

#include <QComboBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTableView>
#include <QTextBrowser>
#include <QTreeWidget>

using namespace Qt::StringLiterals;

/// The window with a simulated drone: what it is has its pages, what it is not has none.
class TestBcflightWindow final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup() { m_rig.reset(); }
    void pagesAreListedOrFillThemselves();
    void gainsAreSetAndTold();
    void liveDataCome();
    void consoleLeavesHeartbeatsOut();
    void slidersSpanWhatIsNear();
    void manyTimesAsMuchIsAsked();
    void leapsAreMarkedBeforeTheyAreWritten();
    void itsOwnSpectrumStandsBeside();
    void itsUsualAddressIsOffered();
    void limitsOfTheBoardBeforeAreGone();
    void noAttitudeBeforeACalibration();
    void whatItLacksIsAClickAway();
    void messagesLeaveItsStateInSight();
    void checkedIsADroneThatIsKnown();
    void checkIsOfWhatWasReadNow();
    void exchangedDroneIsAskedAbout();
    void silenceIsAskedAbout();
    void noGimbalPageSteersIt();
    void lookalikeIsAskedAbout();
    void replaysStartNoMotors();
    void anotherIsConnectedAfterOneWasLost();
    void weakLinkIsNotShownAsGood();
    void lowBatteryIsSeenOnConnecting();
    void anotherGroundIsTold();
    void outputsThatAreNotToldAreUnknown();
    void outputsOfBeforeAStopAreNotTold();
    void repliesAreInWords();
    void hotProcessorIsMarked_data();
    void hotProcessorIsMarked();
    void otherSignsAreTold();
    void numbersHaveRoom();

private:
    MainWindow &window() { return m_rig->window(); }
    std::unique_ptr<WindowRig> m_rig;
};

void TestBcflightWindow::init()
{
    static int seed = 300;
    m_rig = std::make_unique<WindowRig>();
    QVERIFY(m_rig->open(u"sim:bcflight?notch=1&seed=%1"_s.arg(++seed)));
}

void TestBcflightWindow::pagesAreListedOrFillThemselves()
{
    int shown = 0;
    for (const PageEntry &entry : pageTable()) {
        const QString key = QLatin1String(entry.key);
        if (!window().navigation()->isOffered(key))
            continue;
        QVERIFY2(window().showPage(key), entry.key);
        QVERIFY2(window().page(key)->isVisible(), entry.key);
        QVERIFY(m_rig->jobsAreDone());
        ++shown;
    }
    QVERIFY(shown >= 8);
    QVERIFY(!window().navigation()->isOffered(u"control"_s));  // nothing steers it from here
    for (const PaletteEntry &entry : paletteEntries(m_rig->workspace(), *window().navigation(), {}))
        QVERIFY(entry.text != u"Start motors"_s);  // nor starts it
}

void TestBcflightWindow::gainsAreSetAndTold()
{
    const double before = m_rig->raw(u"pid.roll.p"_s);
    QVERIFY(before > 0);
    m_rig->edit(u"pid.roll.p"_s, 0, double(float(before * 1.1)));
    QSignalSpy finished(&m_rig->workspace(), &Workspace::writeFinished);
    QTest::mouseClick(window().unsavedBar()->writeButton(), Qt::LeftButton);
    QTRY_VERIFY(window().reviewDialog());
    QTest::mouseClick(window().reviewDialog()->writeButton(), Qt::LeftButton);
    QTRY_VERIFY(finished.count() > 0);
    QVERIFY(m_rig->workspace().lastReport()->isComplete());
    QCOMPARE(m_rig->raw(u"pid.roll.p"_s), double(float(before * 1.1)));
}

void TestBcflightWindow::liveDataCome()
{
    // It says what that means for what flies.
    const QPushButton *motors = window().findChild<LinkBar *>()->motorsButton();
    QTRY_VERIFY2(motors->isEnabled() && motors->toolTip().contains(u"in flight as well: it falls"_s),
                 qPrintable(motors->toolTip()));
    QVERIFY(m_rig->page<DashboardPage>());
    QVERIFY(m_rig->boardGoesOn(1));
    QTRY_VERIFY(m_rig->workspace().latest(bcflight::BatteryVolts) > 10);
    QTRY_COMPARE(m_rig->workspace().motorsRunning(), std::optional(false));
    QVERIFY(!m_rig->workspace().freshness().staleSince());
    // It tells no errors: that there are none is not said. Nor is said that it is asked for what it streams.
    for (const QLabel *label : window().findChildren<QLabel *>())
        QVERIFY2(!label->text().contains(u"no errors"_s) && !label->text().contains(u"polled"_s),
                 qPrintable(label->text()));
}

// What is sent all the time to stay connected is no news.
void TestBcflightWindow::consoleLeavesHeartbeatsOut()
{
    QVERIFY(window().showPage(u"console"_s));
    const auto *table = window().page(u"console"_s)->findChild<QTableView *>();
    QVERIFY(table);
    QVERIFY(m_rig->jobsAreDone());
    const auto names = [table] {
        QStringList list;
        for (int row = 0; row < table->model()->rowCount(); ++row)
            list.append(table->model()->index(row, 2).data().toString());
        return list;
    };
    QTRY_VERIFY(names().contains(u"— Connected —"_s));
    const qsizetype pings = names().count(u"PING"_s);  // asked for while it was looked for
    QVERIFY(m_rig->boardGoesOn(1));
    const auto told = m_rig->workspace().perform(u"vtx"_s, {});
    QTRY_VERIFY(told.isFinished() && names().contains(u"VTX_GET_SETTINGS"_s));
    QCOMPARE(names().count(u"PING"_s), pings);
}

// Up to 1 is accepted, and a gain is a thousandth of that: a key moves it by a part of itself.
void TestBcflightWindow::slidersSpanWhatIsNear()
{
    auto *page = m_rig->page<TuningPage>();
    QVERIFY(page);
    LiveModel &live = m_rig->workspace().live();
    for (const char *key : {"pid.roll.p", "pid.roll.i", "pid.roll.d"}) {
        const int gain = m_rig->spec(QLatin1String(key)).id;
        QTRY_VERIFY_WITH_TIMEOUT(live.value(gain).has_value(), kPatience);
        const double before = *live.value(gain);
        auto *slider = page->findChild<QSlider *>(QLatin1String(key));
        QVERIFY(slider);
        QTRY_VERIFY_WITH_TIMEOUT(slider->isEnabled(), kPatience);
        QTest::keyClick(slider, Qt::Key_Right);
        QTRY_VERIFY_WITH_TIMEOUT(live.isSettled() && *live.value(gain) > before, kPatience);
        QVERIFY2(*live.value(gain) < before * 1.2, qPrintable(QString::number(*live.value(gain) / before)));
    }
}

// A slip of a digit is within the range of a gain.
void TestBcflightWindow::manyTimesAsMuchIsAsked()
{
    auto *page = m_rig->page<TuningPage>();
    QVERIFY(page);
    LiveModel &live = m_rig->workspace().live();
    const int gain = m_rig->spec(u"pid.roll.p"_s).id;
    QTRY_VERIFY_WITH_TIMEOUT(live.value(gain).has_value(), kPatience);
    const double before = *live.value(gain);
    const double far = double(float(before * 350));
    const auto ask = [&] { emit page->control(u"pid.roll.p"_s)->edited(far); };
    ask();
    QVERIFY(window().panels()->isOpen());
    const QString said = window().panels()->newest()->findChild<QLabel *>(u"qt_msgbox_label"_s)->text();
    QVERIFY2(said.contains(u"350 times"_s), qPrintable(said));
    QTest::mouseClick(named<QPushButton>(window().panels()->newest(), u"Leave it"_s), Qt::LeftButton);
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(live.value(gain), std::optional(before));
    // In small steps neither.
    live.setValue(gain, before * 2.5);
    QTRY_VERIFY_WITH_TIMEOUT(live.isSettled() && *live.value(gain) > before * 2.4, kPatience);
    live.setValue(gain, before * 3.5);
    QTRY_VERIFY(window().panels()->isOpen());
    QTest::mouseClick(named<QPushButton>(window().panels()->newest(), u"Leave it"_s), Qt::LeftButton);
    ask();
    QTest::mouseClick(named<QPushButton>(window().panels()->newest(), u"Use it all the same"_s),
                      Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(live.isSettled() && *live.value(gain) == far, kPatience);
    live.setValue(gain, far * 1.1);  // it was agreed to
    QVERIFY(!window().panels()->isOpen());
    QTRY_VERIFY_WITH_TIMEOUT(live.isSettled() && *live.value(gain) > far, kPatience);
    // Stored, it would be there at each start.
    std::ignore = m_rig->workspace().saveLive(window());
    ReviewDialog *review = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT((review = window().findChild<ReviewDialog *>()), kPatience);
    const auto *rows = review->table()->model();
    QCOMPARE(rows->index(0, ChangeModel::NameColumn).data().toString(), u"⚠ Configuration text"_s);
    QVERIFY(rows->index(0, 0).data(ChangeModel::RedRole).toBool());
    QCOMPARE(review->writeButton()->objectName(), u"danger"_s);
    QVERIFY(review->riskText().contains(u"times what the board has"_s));
    review->reject();
}

void TestBcflightWindow::leapsAreMarkedBeforeTheyAreWritten()
{
    const auto reviewed = [this](double factor) {
        m_rig->edit(u"pid.roll.p"_s, 0, double(float(m_rig->raw(u"pid.roll.p"_s) * factor)));
        QTest::mouseClick(window().unsavedBar()->writeButton(), Qt::LeftButton);
        if (!QTest::qWaitFor([this] { return window().reviewDialog() != nullptr; }, kPatience))
            return QString();
        const QString text = window().reviewDialog()->riskText();
        window().reviewDialog()->reject();
        return QTest::qWaitFor([this] { return !window().reviewDialog(); }, kPatience) ? text : QString();
    };
    const QString near = reviewed(2);
    QVERIFY2(near.startsWith(u"⚠"_s), qPrintable(near));
    const QString far = reviewed(350);
    QVERIFY2(far.contains(u"350 times"_s), qPrintable(far));
}

void TestBcflightWindow::itsOwnSpectrumStandsBeside()
{
    auto *page = m_rig->page<SpectrumPage>();
    QVERIFY(page);
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->workspace().latest(m_rig->client().roles().armed) == 0, kPatience);
    m_rig->workspace().perform(u"calibrate.all"_s, {});
    const auto own = [page] {
        int count = 0;
        for (const ChartCurve &curve : page->chart()->curves())
            count += curve.name.contains(u"from the board"_s) && !curve.points.isEmpty() ? 1 : 0;
        return count;
    };
    QTRY_COMPARE_WITH_TIMEOUT(own(), 3, kPatience);
}

void TestBcflightWindow::itsUsualAddressIsOffered()
{
    bool isOffered = false;
    for (const QComboBox *box : window().findChildren<QComboBox *>())
        isOffered |= box->findData(u"udp://192.168.32.1:2020"_s) >= 0;
    QVERIFY(isOffered);
}

void TestBcflightWindow::limitsOfTheBoardBeforeAreGone()
{
    const auto *battery = m_rig->page<DashboardPage>()->findChild<BatteryView *>();
    QVERIFY(battery);
    const auto change = [this](const QString &address) {
        m_rig->client().disconnectFromBoard();
        return QTest::qWaitFor([this] { return !m_rig->client().isConnected(); }, kPatience)
            && m_rig->open(address);
    };
    QVERIFY(change(u"sim:simplebgc"_s));
    const auto hasEnd = [battery] { return battery->accessibleDescription().contains(u"off below"_s); };
    QTRY_VERIFY_WITH_TIMEOUT(hasEnd(), kPatience);
    QVERIFY(change(u"sim:bcflight?seed=399"_s));
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->workspace().roles().armed >= 0 && !hasEnd(), kPatience);
}

// Dashboard and flight page say the same of it.
void TestBcflightWindow::noAttitudeBeforeACalibration()
{
    FlightPage &page = *m_rig->page<FlightPage>();
    QTRY_COMPARE_WITH_TIMEOUT(flightState(m_rig->workspace()), ArmedState::State::NotCalibrated, kPatience);
    QVERIFY(m_rig->boardGoesOn(0.5));
    auto *view = page.findChild<AttitudeView *>();
    QVERIFY(view);
    QCOMPARE(view->accessibleDescription(), u"No data"_s);
    // It is said once: the view itself says nothing beneath the words that lie over it.
    QVERIFY(window().showPage(u"flight"_s));
    QTRY_VERIFY_WITH_TIMEOUT(StaleCover::isOver(*view), kPatience);
    const auto own = [view] {
        QImage image(view->size(), QImage::Format_RGB32);
        image.fill(Qt::black);
        view->render(&image, {}, {}, QWidget::RenderFlags());
        return image;
    };
    const QImage drawn = own();
    view->setPlaceholder({});
    QCOMPARE(own(), drawn);
    QVERIFY(std::isnan(shownAngles(m_rig->workspace())[0]));
}

// What has to be done first is named where it is lacking, with the way there.
void TestBcflightWindow::whatItLacksIsAClickAway()
{
    for (const QString &key : {u"flight"_s, u"bench"_s, u"dashboard"_s}) {
        QVERIFY(window().showPage(key));
        QPushButton *button = nullptr;
        for (QPushButton *each : window().page(key)->findChildren<QPushButton *>())
            button = each->text() == u"Calibrate (Actions)…"_s ? each : button;
        QVERIFY(button);
        QTRY_VERIFY(button->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
        auto *actions = static_cast<ActionsPage *>(window().page(u"actions"_s));
        QVERIFY(actions->isVisible());
        QCOMPARE(actions->list()->currentItem()->data(0, Qt::UserRole).toString(), u"calibrate.all"_s);
    }
    const auto calibrated = m_rig->workspace().perform(u"calibrate.all"_s, {});
    QTRY_VERIFY(calibrated.isFinished());
    for (const QString &key : {u"flight"_s, u"bench"_s}) {
        QVERIFY(window().showPage(key));
        for (const QPushButton *each : window().page(key)->findChildren<QPushButton *>())
            QTRY_VERIFY(!each->isVisible() || each->text() != u"Calibrate (Actions)…"_s);
    }
}

void TestBcflightWindow::messagesLeaveItsStateInSight()
{
    for (const QString &key : {u"flight"_s, u"bench"_s, u"dashboard"_s}) {
        QVERIFY(window().showPage(key));
        const auto *state = window().page(key)->findChild<ArmedState *>();
        QVERIFY2(state, qPrintable(key));
        QTRY_VERIFY(state->isVisible());
        window().messageBar()->showNotice(u"One that stands for a while."_s, Notice::Attention);
        QTRY_VERIFY(window().messageBar()->isVisible());
        const auto placeOf = [this](const QWidget &widget) {
            return QRect(widget.mapTo(&window(), QPoint()), widget.size());
        };
        QVERIFY2(!placeOf(*window().messageBar()).intersects(placeOf(*state)), qPrintable(key));
        QTest::keyClick(&window(), Qt::Key_F6, Qt::ControlModifier);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QTRY_VERIFY(!window().messageBar()->isVisible());
    }
    // It came on a page without a state.
    const auto placeIn
        = [this](const QWidget &widget) { return QRect(widget.mapTo(&window(), QPoint()), widget.size()); };
    QVERIFY(window().showPage(u"monitor"_s));
    window().messageBar()->showNotice(u"One that stands for a while."_s, Notice::Attention);
    QTRY_VERIFY(window().messageBar()->isVisible());
    QVERIFY(window().showPage(u"flight"_s));
    const auto *state = window().page(u"flight"_s)->findChild<ArmedState *>();
    QTRY_VERIFY(state->isVisible());
    QTRY_VERIFY(!placeIn(*window().messageBar()).intersects(placeIn(*state)));
}

// A drone has no such command, and a recording no motors.
void TestBcflightWindow::replaysStartNoMotors()
{
    const QString path = m_rig->filePath(u"short.gimbalrec"_s);
    QVERIFY(m_rig->workspace().recorder().start(path));
    QVERIFY(m_rig->boardGoesOn(0.5));
    m_rig->workspace().recorder().stop();
    m_rig->client().disconnectFromBoard();
    QVERIFY(m_rig->open(u"replay:"_s + path));
    const QPushButton *motors = window().findChild<LinkBar *>()->motorsButton();
    QTRY_COMPARE(m_rig->workspace().motorsRunning(), std::optional(false));
    QVERIFY(m_rig->isSettled());
    QTRY_VERIFY2(!motors->text().contains(u"Start"_s), qPrintable(motors->text()));
    QVERIFY(!motors->isEnabled());
}

// Another that looks the same would be flown as if somebody had looked.
void TestBcflightWindow::checkedIsADroneThatIsKnown()
{
    SimProcess drone({u"--udp"_s, u"0"_s}, u"bcflight"_s);
    QVERIFY(!drone.address().isEmpty());
    const auto connected = [&] {
        return m_rig->open(drone.address())
            && QTest::qWaitFor([&] { return !axesKey(m_rig->workspace()).isEmpty(); }, kPatience);
    };
    QVERIFY(connected());
    QVERIFY(m_rig->page<FlightPage>());
    const QString look = m_rig->client().identity().serial;
    CheckedDirections all;
    all.level = CheckedDirections::Level::All;
    keepDirections(m_rig->workspace(), all);
    QCOMPARE(checkedDirections(m_rig->workspace()), all);
    m_rig->client().disconnectFromBoard();
    QVERIFY(connected());
    QCOMPARE(checkedDirections(m_rig->workspace()).level, CheckedDirections::Level::Nothing);
    keepDirections(m_rig->workspace(), all);
    // It is this drone that has got a name, and it is still there.
    QVERIFY(m_rig->workspace().naming().choose(u"Mine"_s));
    QCOMPARE(checkedDirections(m_rig->workspace()), all);
    m_rig->client().disconnectFromBoard();
    QVERIFY(connected());
    QCOMPARE(m_rig->client().identity().serial, look);
    QCOMPARE(checkedDirections(m_rig->workspace()).level, CheckedDirections::Level::Nothing);
    QCOMPARE(presumedDirections(m_rig->workspace()).found, all);
    QCOMPARE(presumedDirections(m_rig->workspace()).on, QDate::currentDate());
    QVERIFY(m_rig->workspace().naming().choose(u"Mine"_s));
    QCOMPARE(checkedDirections(m_rig->workspace()), all);
    QVERIFY(m_rig->workspace().naming().choose(u"Another"_s));
    QCOMPARE(checkedDirections(m_rig->workspace()).level, CheckedDirections::Level::Nothing);
}

// Until it has been read the configuration of the drone before is shown.
void TestBcflightWindow::checkIsOfWhatWasReadNow()
{
    const SimProcess one({u"--udp"_s, u"0"_s, u"--seed"_s, u"7"_s}, u"bcflight"_s);
    const SimProcess other({u"--udp"_s, u"0"_s, u"--seed"_s, u"8"_s}, u"bcflight"_s);
    QVERIFY(m_rig->open(one.address()));
    QTRY_VERIFY_WITH_TIMEOUT(!axesKey(m_rig->workspace()).isEmpty(), kPatience);
    m_rig->client().disconnectFromBoard();
    std::optional<QByteArray> early;
    connect(&m_rig->client(), &DeviceClient::stateChanged, this, [&](DeviceClient::State state) {
        if (state == DeviceClient::State::Connected)
            early = axesKey(m_rig->workspace());
    });
    QVERIFY(m_rig->open(other.address()));
    QTRY_VERIFY_WITH_TIMEOUT(early.has_value(), kPatience);
    QCOMPARE(*early, QByteArray());
    QTRY_VERIFY_WITH_TIMEOUT(!axesKey(m_rig->workspace()).isEmpty(), kPatience);
    m_rig->client().disconnect(this);
}

// Another machine answers at the same address after a short gap, and nothing tells the two apart.
void TestBcflightWindow::exchangedDroneIsAskedAbout()
{
    auto drone = std::make_unique<SimProcess>(QStringList{u"--udp"_s, u"0"_s}, u"bcflight"_s);
    const QString address = drone->address();
    const auto isRead = [this] { return !axesKey(m_rig->workspace()).isEmpty(); };
    QVERIFY(m_rig->open(address));
    QTRY_VERIFY_WITH_TIMEOUT(isRead(), kPatience);
    auto *flight = m_rig->page<FlightPage>();
    QVERIFY(flight && m_rig->workspace().naming().choose(u"Mine"_s));
    CheckedDirections all;
    all.level = CheckedDirections::Level::All;
    keepDirections(m_rig->workspace(), all);
    QCOMPARE(checkedDirections(m_rig->workspace()), all);
    drone.reset();
    QTRY_COMPARE_WITH_TIMEOUT(m_rig->client().state(), DeviceClient::State::Reconnecting, kPatience);
    drone = std::make_unique<SimProcess>(QStringList{u"--udp"_s, address.section(u':', -1)}, u"bcflight"_s);
    QCOMPARE(drone->address(), address);
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected() && isRead(), kPatience);
    QVERIFY(!m_rig->workspace().naming().isCertain());
    QCOMPARE(checkedDirections(m_rig->workspace()).level, CheckedDirections::Level::Nothing);
    QTRY_VERIFY_WITH_TIMEOUT(flight->directions()->sameButton()->isVisible(), kPatience);
}

// A silence that does not end the link is long enough for another one to answer after it.
void TestBcflightWindow::silenceIsAskedAbout()
{
    SimProcess drone({u"--udp"_s, u"0"_s}, u"bcflight"_s);
    QVERIFY(m_rig->open(drone.address()));
    QTRY_VERIFY_WITH_TIMEOUT(!axesKey(m_rig->workspace()).isEmpty(), kPatience);
    BoardNaming &naming = m_rig->workspace().naming();
    QVERIFY(naming.choose(u"Mine"_s) && naming.isCertain());
    drone.process().write("replug=1.5\nunplug=0\n");
    QTRY_VERIFY_WITH_TIMEOUT(!naming.isCertain(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected(), kPatience);
    QCOMPARE(naming.name(), u"Mine"_s);
    QVERIFY(naming.choose(u"Mine"_s) && naming.isCertain());
}

// Letters typed in the navigation reach no page that is not listed; and below every page, what takes a drone
// for a gimbal sends it nothing.
void TestBcflightWindow::noGimbalPageSteersIt()
{
    QVERIFY(m_rig->open(u"sim:bcflight?stand=1"_s));
    Navigation *list = window().navigation();
    for (const PageEntry &entry : pageTable()) {
        const QString key = QString::fromLatin1(entry.key);
        QVERIFY(window().showPage(u"dashboard"_s));
        list->keyboardSearch(QString());  // from the beginning
        list->keyboardSearch(list->titleOf(key));
        QVERIFY2(list->isOffered(list->currentPage()), qPrintable(key));
    }
    const auto done = m_rig->workspace().perform(u"calibrate.all"_s, {});
    QTRY_VERIFY_WITH_TIMEOUT(done.isFinished() && m_rig->jobsAreDone(), kPatience);
    const auto isArmed = [this] { return m_rig->workspace().latest(m_rig->client().roles().armed) > 0.5; };
    for (const auto what : {DeviceClient::Steers::Gimbal, DeviceClient::Steers::FlyingMachine}) {
        QTimer send;
        connect(&send, &QTimer::timeout, this, [&] {
            m_rig->client().setControl({1, {0, 0, 0, 0}, {1}}, what);
        });
        send.start(50);
        if (what == DeviceClient::Steers::FlyingMachine)
            QTRY_VERIFY_WITH_TIMEOUT(isArmed(), kPatience);
        else
            QVERIFY(m_rig->boardGoesOn(2) && !isArmed() && !m_rig->client().isSteering());
    }
}

// It inherits the name, and neither the check nor, unasked, the snapshots.
void TestBcflightWindow::lookalikeIsAskedAbout()
{
    SimProcess one({u"--udp"_s, u"0"_s, u"--seed"_s, u"7"_s}, u"bcflight"_s);
    SimProcess other({u"--udp"_s, u"0"_s, u"--seed"_s, u"8"_s}, u"bcflight"_s);
    const auto connected = [&](const SimProcess &drone) {
        m_rig->client().disconnectFromBoard();
        QSignalSpy read(&m_rig->workspace(), &Workspace::boardRead);
        return m_rig->open(drone.address()) && QTest::qWaitFor([&] { return read.count() > 0; }, kPatience);
    };
    QVERIFY(connected(one));
    CheckedDirections all;
    all.level = CheckedDirections::Level::All;
    QVERIFY(m_rig->workspace().naming().choose(u"quad one"_s));
    keepDirections(m_rig->workspace(), all);
    m_rig->workspace().takeSnapshot();
    const auto snapshots
        = [this] { return m_rig->workspace().history().snapshots(m_rig->client().identity().serial); };
    QTRY_COMPARE_WITH_TIMEOUT(snapshots().size(), 1, kPatience);

    QVERIFY(connected(other));
    QCOMPARE(m_rig->workspace().naming().name(), u"quad one"_s);
    auto *flight = m_rig->page<FlightPage>();
    QVERIFY(flight);
    QVERIFY(window().showPage(u"flight"_s));
    const auto done = m_rig->workspace().perform(u"calibrate.all"_s, {});
    QTRY_VERIFY_WITH_TIMEOUT(done.isFinished(), kPatience);
    flight->open(true);
    QTRY_VERIFY2_WITH_TIMEOUT(flight->stateText().contains(u"nobody has said that it is “quad one”"_s),
                              qPrintable(flight->stateText()), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(flight->directions()->sameButton()->isVisible(), kPatience);
    // Checked without that word, it is for this connection, and the other drone's check stays.
    CheckedDirections reversed = all;
    reversed.sticks = {-1, 1, 1};
    keepDirections(m_rig->workspace(), reversed);
    QCOMPARE(checkedDirections(m_rig->workspace()), reversed);

    QVERIFY(connected(one));
    QCOMPARE(presumedDirections(m_rig->workspace()).found, all);
    QTRY_VERIFY_WITH_TIMEOUT(flight->directions()->sameButton()->isVisible(), kPatience);
    QTest::mouseClick(flight->directions()->sameButton(), Qt::LeftButton);
    QCOMPARE(checkedDirections(m_rig->workspace()), all);
    QTRY_VERIFY(!flight->directions()->sameButton()->isVisible());

    // What a snapshot holds is asked about as well.
    QVERIFY(connected(other));
    m_rig->edit(u"pid.roll.p"_s, 0, double(float(m_rig->raw(u"pid.roll.p"_s) * 1.1)));
    QVERIFY(window().showPage(u"backups"_s));
    QPushButton *restore = named<QPushButton>(window().page(u"backups"_s), u"Restore as edits"_s);
    QTRY_VERIFY_WITH_TIMEOUT(restore->isEnabled(), kPatience);
    QTest::mouseClick(restore, Qt::LeftButton);
    QTRY_VERIFY(window().panels()->isOpen());
    QVERIFY(m_rig->model().changeCount() > 0);
    QTest::mouseClick(named<QPushButton>(window().panels()->newest(), u"It is “quad one”"_s), Qt::LeftButton);
    QTRY_COMPARE(m_rig->model().changeCount(), 0);
    QVERIFY(m_rig->workspace().naming().isCertain());
}

// One that does not come back keeps nobody from the next.
void TestBcflightWindow::anotherIsConnectedAfterOneWasLost()
{
    m_rig->workspace().changeWorld(u"replug=-1"_s);
    m_rig->workspace().changeWorld(u"unplug=0"_s);
    QTRY_COMPARE_WITH_TIMEOUT(m_rig->client().state(), DeviceClient::State::Reconnecting, kPatience);
    m_rig->client().disconnectFromBoard();
    QVERIFY(m_rig->open(u"sim:bcflight?seed=900"_s));
    m_rig->workspace().changeWorld(u"replug=-1"_s);
    m_rig->workspace().changeWorld(u"unplug=0"_s);
    QTRY_COMPARE_WITH_TIMEOUT(m_rig->client().state(), DeviceClient::State::Reconnecting, kPatience);
    // Without disconnecting first.
    QVERIFY(m_rig->open(u"sim:bcflight?seed=901"_s));
}

void TestBcflightWindow::weakLinkIsNotShownAsGood()
{
    const QList<QLabel *> labels = window().findChild<StatusStrip *>()->findChildren<QLabel *>();
    const QLabel *link = labels.first();
    const QString good = m_rig->workspace().theme().color(ColorRole::Ok).name();
    const auto isGood = [&] { return link->text().contains(good) && !link->toolTip().contains(u"link:"_s); };
    window().resize(1600, 900);
    QTRY_VERIFY2(isGood() && link->text().contains(u"100 %"_s), qPrintable(link->text()));
    // It cannot count what its stream loses.
    QVERIFY2(!link->text().contains(u"lost"_s), qPrintable(link->text()));
    m_rig->workspace().changeWorld(u"lose=0.4"_s);
    QTRY_VERIFY2_WITH_TIMEOUT(link->text().contains(u"weak link"_s) && !link->text().contains(good)
                                  && link->toolTip().contains(u"Weak link: only"_s),
                              qPrintable(link->text() + link->toolTip()), kPatience);
    m_rig->workspace().changeWorld(u"lose=0"_s);
    QTRY_VERIFY2_WITH_TIMEOUT(isGood(), qPrintable(link->text()), kPatience);
    m_rig->workspace().changeWorld(u"late=700"_s);
    QTRY_VERIFY2_WITH_TIMEOUT(link->toolTip().contains(u"Slow link"_s) && !link->text().contains(good),
                              qPrintable(link->text() + link->toolTip()), kPatience);
}

// Four cells of 3.15 V look like three full ones, but for the level that the drone tells.
void TestBcflightWindow::lowBatteryIsSeenOnConnecting()
{
    WindowRig rig;
    QVERIFY(rig.open(u"sim:bcflight?fault=battery=12.6&seed=399"_s));
    auto *page = rig.page<DashboardPage>();
    const auto *battery = page->findChild<BatteryView *>();
    QTRY_COMPARE_WITH_TIMEOUT(battery->state(), BatteryView::State::Low, kPatience);
    QVERIFY2(battery->accessibleDescription().contains(u"4 cell"_s),
             qPrintable(battery->accessibleDescription()));
    const auto warns = [&rig] {
        const QList<AlarmReport> open = rig.workspace().alarms().pressing();
        return std::any_of(open.begin(), open.end(),
                           [](const AlarmReport &report) { return report.alarm.kind == AlarmKind::Battery; });
    };
    QTRY_VERIFY_WITH_TIMEOUT(warns(), kPatience);
    // Nor is it armed so, not even in a stand.
    const auto calibrated = rig.workspace().perform(u"calibrate.all"_s, {});
    QTRY_VERIFY_WITH_TIMEOUT(calibrated.isFinished(), kPatience);
    auto *flight = rig.page<FlightPage>();
    flight->open(true);
    QTRY_VERIFY2_WITH_TIMEOUT(flight->stateText().contains(u"its battery is below"_s),
                              qPrintable(flight->stateText()), kPatience);
}

void TestBcflightWindow::anotherGroundIsTold()
{
    QStringList told;
    connect(&m_rig->workspace().notifications(), &Notifications::problem, this,
            [&told](const ErrorText &text) { told.append(text.what); });
    // What comes when it is alone has to be learned, and a machine that stands still is no good teacher.
    for (int attempt = 0; attempt < 4 && told.isEmpty(); ++attempt) {
        m_rig->workspace().changeWorld(u"other-ground=0"_s);
        QVERIFY(m_rig->boardGoesOn(5));
        m_rig->workspace().changeWorld(u"other-ground=100"_s);
        QVERIFY(m_rig->boardGoesOn(5));
    }
    QVERIFY2(told.join(u' ').contains(u"Another ground station"_s), qPrintable(told.join(u' ')));
    // Nothing is armed beside it.
    const auto calibrated = m_rig->workspace().perform(u"calibrate.all"_s, {});
    QTRY_VERIFY_WITH_TIMEOUT(calibrated.isFinished(), kPatience);
    auto *flight = m_rig->page<FlightPage>();
    flight->open(true);
    QTRY_VERIFY2_WITH_TIMEOUT(flight->stateText().contains(u"another ground station"_s),
                              qPrintable(flight->stateText()), kPatience);
}

// Errata 9.2, 8: "disarmed" does not mean that its motors stand.
void TestBcflightWindow::outputsThatAreNotToldAreUnknown()
{
    const auto state = [this] { return flightState(m_rig->workspace()); };
    for (const QString &action : {u"calibrate.all"_s, u"telemetry.full"_s}) {
        const auto done = m_rig->workspace().perform(action, {{u"on"_s, false}});
        QTRY_VERIFY_WITH_TIMEOUT(done.isFinished(), kPatience);
        QVERIFY(done.result());
    }
    QTRY_COMPARE_WITH_TIMEOUT(state(), ArmedState::State::OutputsUnknown, kPatience);
    QStringList told;
    connect(&m_rig->workspace().notifications(), &Notifications::notice, this,
            [&told](const QString &text) { told.append(text); });
    // A stop is proven as far as it can be, and not said to be more.
    QSignalSpy stopped(&m_rig->client(), &DeviceClient::motorsOffFinished);
    m_rig->workspace().setMotors(false);
    QTRY_VERIFY_WITH_TIMEOUT(!stopped.isEmpty(), kPatience);
    QVERIFY(stopped.last().first().toBool());
    QVERIFY2(told.join(u' ').contains(u"does not tell what its motors do"_s), qPrintable(told.join(u' ')));
    QVERIFY(!told.join(u' ').contains(u"switched off"_s));
    const auto full = m_rig->workspace().perform(u"telemetry.full"_s, {{u"on"_s, true}});
    QTRY_VERIFY_WITH_TIMEOUT(full.isFinished(), kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(state(), ArmedState::State::Disarmed, kPatience);
}

// They fell silent only just before: what they were then proves nothing.
void TestBcflightWindow::outputsOfBeforeAStopAreNotTold()
{
    const int outputs = m_rig->client().roles().outputs;
    QTRY_VERIFY_WITH_TIMEOUT(freshlyTold(m_rig->workspace(), outputs), kPatience);
    const auto silent = m_rig->workspace().perform(u"telemetry.full"_s, {{u"on"_s, false}});
    QTRY_VERIFY_WITH_TIMEOUT(silent.isFinished(), kPatience);
    const QObject listener;
    QStringList told;
    connect(&m_rig->workspace().notifications(), &Notifications::notice, &listener,
            [&told](const QString &text) { told.append(text); });
    QSignalSpy stopped(&m_rig->client(), &DeviceClient::motorsOffFinished);
    m_rig->workspace().setMotors(false);
    QTRY_VERIFY_WITH_TIMEOUT(!stopped.isEmpty(), kPatience);
    QVERIFY(stopped.last().first().toBool());
    QVERIFY2(told.join(u' ').contains(u"does not tell what its motors do"_s), qPrintable(told.join(u' ')));
    QVERIFY(!told.join(u' ').contains(u"switched off"_s));
}

void TestBcflightWindow::repliesAreInWords()
{
    QVERIFY(window().showPage(u"actions"_s));
    auto *page = m_rig->page<ActionsPage>();
    QVERIFY(page->showAction(u"status"_s));
    QTest::mouseClick(page->runButton(), Qt::LeftButton);
    QTRY_VERIFY2(page->reply()->toPlainText().contains(u"Battery voltage"_s),
                 qPrintable(page->reply()->toPlainText()));
    const QString told = page->reply()->toPlainText();
    for (const QString &raw : {u"battery."_s, u"rx."_s, u"cpu."_s})
        QVERIFY2(!told.contains(raw), qPrintable(told));
    // What a progress speaks of as well.
    Progress restarts;
    restarts.step = u"await-restart"_s;
    restarts.subject = u"CONFIG_FILE"_s;
    QVERIFY(!describe(restarts).contains(u"CONFIG_FILE"_s));
}

void TestBcflightWindow::hotProcessorIsMarked_data()
{
    QTest::addColumn<int>("celsius");
    QTest::addColumn<QString>("sign");
    QTest::addColumn<std::optional<ColorRole>>("role");
    QTest::newRow("cool") << 69 << QString() << std::optional<ColorRole>();
    QTest::newRow("warm") << 70 << u"⚠ "_s << std::optional(ColorRole::Warning);
    QTest::newRow("hot") << 80 << u"✖ "_s << std::optional(ColorRole::Danger);
}

void TestBcflightWindow::hotProcessorIsMarked()
{
    QFETCH(int, celsius);
    QFETCH(QString, sign);
    QFETCH(std::optional<ColorRole>, role);
    QVERIFY(m_rig->page<DashboardPage>());
    m_rig->workspace().changeWorld(u"heat=%1"_s.arg(celsius));
    const auto facts = [this] {
        for (const QLabel *label : m_rig->page<DashboardPage>()->findChildren<QLabel *>()) {
            if (label->text().contains(u"Processor temperature"_s))
                return label->text();
        }
        return QString();
    };
    const QString text = u"%1%2 °C"_s.arg(sign).arg(celsius);
    const QString wanted = role
        ? u"<span style='color:%1'>%2</span>"_s.arg(m_rig->theme().color(*role).name(), text)
        : u">%1<"_s.arg(text);
    QTRY_VERIFY2_WITH_TIMEOUT(facts().contains(wanted), qPrintable(facts()), kPatience);
}

// Only while they are, and wherever the drone's own are shown.
void TestBcflightWindow::otherSignsAreTold()
{
    QTRY_VERIFY_WITH_TIMEOUT(!axesKey(m_rig->workspace()).isEmpty(), kPatience);
    CheckedDirections found;
    found.level = CheckedDirections::Level::All;
    for (const QString &key : {u"monitor"_s, u"tuning"_s, u"dashboard"_s}) {
        dropDirections(m_rig->workspace());
        QVERIFY(window().showPage(key));
        const auto *note = window().page(key)->findChild<SignsNote *>();
        QVERIFY(note && note->isHidden());
        const auto checked = [&](const std::array<int, kAxisCount> &angles) {
            found.angles = angles;
            keepDirections(m_rig->workspace(), found);
            return window().showPage(u"backups"_s) && window().showPage(key);
        };
        // A horizon is drawn by what grows with the nose up, the check asks for what grows with it down.
        QVERIFY(checked({1, -1, 1}));
        QVERIFY(note->isHidden());
        QVERIFY(checked({1, 1, -1}));
        QVERIFY(!note->isHidden());
        QVERIFY2(note->text().contains(u"Pitch, Yaw"_s) && !note->text().contains(u"Roll"_s),
                 qPrintable(note->text()));
        QCOMPARE(shownSigns(m_rig->workspace()), (std::array<int, kAxisCount>{1, -1, -1}));
    }
}

void TestBcflightWindow::numbersHaveRoom()
{
    auto *page = m_rig->page<ActionsPage>();
    QVERIFY(page->showAction(u"vtx.channel"_s));
    QVERIFY(m_rig->isSettled());
    const QWidget *field = page->form()->field(u"channel"_s);
    QVERIFY(field && field->width() >= field->fontMetrics().horizontalAdvance(u"88888"_s));
}

QTEST_MAIN(TestBcflightWindow)
#include "tst_bcflightwindow.moc"
