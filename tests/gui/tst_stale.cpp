// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/messagebar.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"
#include "tests/support/windowrig.h"
#include "widgets/models/channelmodel.h"
#include "widgets/plot/plotview.h"
#include "widgets/plot/spectrumchart.h"
#include "widgets/plot/waterfallview.h"
#include "widgets/views/attitudeview.h"
#include "widgets/views/axisdial.h"
#include "widgets/views/batteryview.h"
#include "widgets/views/gimbalview.h"
#include "widgets/views/stalecover.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTreeView>

#include <csignal>

using namespace Qt::StringLiterals;

namespace {

const QStringList kPages{u"dashboard"_s, u"control"_s, u"monitor"_s, u"tuning"_s, u"spectrum"_s};

}  // namespace

/// Old data never look alive: what shows them is covered as long as none come, and says since when.
class TestStale : public QObject
{
    Q_OBJECT
private slots:
    void viewsAreCoveredWhileNothingComes_data();
    void viewsAreCoveredWhileNothingComes();
    void everyViewOfLiveDataHasACover();
    void recordingsAreNeverStale();
    void aBoardWithoutLiveDataIsNoticed();
    void aMissingSensorIsShown_data();
    void aMissingSensorIsShown();
    void dataThatStandStillAreStale_data();
    void dataThatStandStillAreStale();
    void dataThatStandStillAreToldEverywhere();
    void silenceWithMotorsIsAnAlarm_data();
    void silenceWithMotorsIsAnAlarm();
    void silenceIsNoAlarmWhileWorkExplainsIt();

private:
    /// Of the views of live data on a page.
    static QList<QRect> placesOn(const QWidget &page)
    {
        QList<QRect> places;
        for (const QWidget *view : page.findChildren<QWidget *>()) {
            if (view->isVisible()
                && (qobject_cast<const AttitudeView *>(view) || qobject_cast<const AxisDial *>(view)
                    || qobject_cast<const GimbalView *>(view) || qobject_cast<const PlotView *>(view)
                    || qobject_cast<const SpectrumChart *>(view)))
                places.append({view->mapTo(&page, QPoint()), view->size()});
        }
        return places;
    }
    static QList<StaleCover *> shown(const QWidget &page)
    {
        QList<StaleCover *> covers;
        for (StaleCover *cover : page.findChildren<StaleCover *>()) {
            if (cover->isVisible())
                covers.append(cover);
        }
        return covers;
    }
};

void TestStale::viewsAreCoveredWhileNothingComes_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QStringList>("stop");
    QTest::addColumn<QStringList>("goOn");
    const QStringList pulled{u"replug=3"_s, u"unplug=0"_s};
    QTest::newRow("SimpleBGC, cable pulled") << u"sim:simplebgc"_s << pulled << QStringList();
    QTest::newRow("STorM32, cable pulled") << u"sim:storm32"_s << pulled << QStringList();
    // The link lives on, answers to d (100) do not come.
    QTest::newRow("STorM32, deaf") << u"sim:storm32"_s << QStringList{u"deaf=100"_s}
                                   << QStringList{u"deaf=-1"_s};
}

void TestStale::viewsAreCoveredWhileNothingComes()
{
    QFETCH(const QString, address);
    QFETCH(const QStringList, stop);
    QFETCH(const QStringList, goOn);
    WindowRig rig;
    QVERIFY(rig.open(address));
    for (const QString &key : kPages) {
        QVERIFY(rig.window().showPage(key));
        const QWidget *page = rig.window().page(key);
        QVERIFY(rig.boardGoesOn(0.5));
        QTRY_VERIFY2(shown(*page).isEmpty(), qPrintable(key));
        rig.window().messageBar()->hide();
        QTRY_VERIFY2(!placesOn(*page).isEmpty(), qPrintable(key));  // the board is read
        QVERIFY(rig.isSettled());
        const QList<QRect> places = placesOn(*page);
        const QDateTime before = QDateTime::currentDateTime();
        for (const QString &fault : stop)
            rig.workspace().changeWorld(fault);
        QTRY_VERIFY2(!shown(*page).isEmpty(), qPrintable(key));
        const QString text = shown(*page).front()->text();
        const QTime since = QTime::fromString(text.right(8), u"HH:mm:ss"_s);
        QVERIFY2(since.isValid(), qPrintable(text));
        QVERIFY2(std::abs(before.time().secsTo(since)) <= 10, qPrintable(text));
        rig.window().messageBar()->hide();
        QVERIFY(rig.isSettled());
        QCOMPARE(placesOn(*page), places);  // it takes no room
        if (const auto *table = page->findChild<QTreeView *>()) {
            const auto covers = table->findChildren<StaleCover *>(QString(), Qt::FindDirectChildrenOnly);
            QCOMPARE(covers.size(), 1);
            QVERIFY(covers.front()->isVisible());
            // Over the numbers, not over names and boxes to tick.
            const QModelIndex cell
                = table->model()->index(0, ChannelModel::ValueColumn, table->model()->index(0, 0));
            QRect number = table->visualRect(cell);
            number.moveTopLeft(table->viewport()->mapTo(table, number.topLeft()));
            QVERIFY(covers.front()->geometry().contains(number));
            QCOMPARE(covers.front()->width(), number.width());
        }
        for (const QString &fault : goOn)
            rig.workspace().changeWorld(fault);
        QTRY_VERIFY2(shown(*page).isEmpty(), qPrintable(key));
    }
}

void TestStale::everyViewOfLiveDataHasACover()
{
    WindowRig rig;
    QVERIFY(rig.open());
    int views = 0;
    for (const PageEntry &entry : pageTable()) {
        const QWidget *page = rig.window().page(QLatin1String(entry.key));
        for (const QWidget *view : page->findChildren<QWidget *>()) {
            if (!qobject_cast<const AttitudeView *>(view) && !qobject_cast<const AxisDial *>(view)
                && !qobject_cast<const GimbalView *>(view) && !qobject_cast<const BatteryView *>(view)
                && !qobject_cast<const PlotView *>(view) && !qobject_cast<const SpectrumChart *>(view)
                && !qobject_cast<const WaterfallView *>(view))
                continue;
            ++views;
            bool covered = false;
            for (const QWidget *each = view; each && each != page; each = each->parentWidget())
                covered |= each->findChild<StaleCover *>({}, Qt::FindDirectChildrenOnly) != nullptr;
            QVERIFY2(covered, entry.key);
        }
    }
    QVERIFY(views >= 11);
}

void TestStale::recordingsAreNeverStale()
{
    WindowRig rig;
    QVERIFY(rig.open());
    const QString path = rig.filePath(u"short.gimbalrec"_s);
    QVERIFY(rig.workspace().recorder().start(path));
    QVERIFY(rig.boardGoesOn(1.0));
    rig.workspace().recorder().stop();
    QVERIFY(rig.open(u"replay:"_s + path));
    QTRY_VERIFY(rig.client().address().isReplay());
    QVERIFY(
        QTest::qWaitFor([&rig] { return rig.client().telemetry() && rig.client().telemetry()->rows() > 0; }));
    rig.window().showPage(u"dashboard"_s);
    QVERIFY(!QTest::qWaitFor([&rig] { return !shown(*rig.window().page(u"dashboard"_s)).isEmpty(); }, 1500));
    // Its last picture stays readable, and is not said to be alive; the frame names what is looked at.
    QTRY_VERIFY(rig.workspace().freshness().hasPlayed());
    const auto says = [&rig](const QString &text) {
        const auto labels = rig.window().findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [&text](const QLabel *label) {
            return label->isVisible() && label->text().contains(text);
        });
    };
    QTRY_VERIFY(says(u"the recording has ended"_s));
    const QString green = rig.workspace().theme().color(ColorRole::Ok).name();
    QTRY_VERIFY(!rig.window().findChild<QLabel *>(u"dot"_s)->text().contains(green));
    rig.client().disconnectFromBoard();
    QTRY_COMPARE(rig.client().state(), DeviceClient::State::Disconnected);
    auto *bar = rig.window().findChild<LinkBar *>();
    const QString address = u"tcp://127.0.0.1:9"_s;
    bar->setAddress(address);
    rig.window().openFile(path);
    QTRY_VERIFY(bar->addressBox()->currentText().contains(u"short.gimbalrec"_s));
    QTRY_VERIFY(rig.client().isConnected());
    rig.client().disconnectFromBoard();
    QTRY_COMPARE(bar->addressBox()->currentText(), address);
}

// Connected, everything read, and not one sample: that looks like a board at rest.
void TestStale::aBoardWithoutLiveDataIsNoticed()
{
    WindowRig rig;
    rig.window().openLink(u"sim:storm32?fault=deaf=100"_s);
    QTRY_VERIFY(rig.client().isConnected() && !rig.model().isEmpty());
    for (const QString &key : kPages) {
        QVERIFY(rig.window().showPage(key));
        QTRY_VERIFY2(!shown(*rig.window().page(key)).isEmpty(), qPrintable(key));
    }
    QVERIFY(rig.client().isConnected());
    const auto labels = rig.window().findChildren<QLabel *>();
    QTRY_VERIFY(std::any_of(labels.begin(), labels.end(),
                            [](const QLabel *label) { return label->text().contains(u"no live data"_s); }));
    rig.workspace().changeWorld(u"deaf=-1"_s);
    QTRY_VERIFY(shown(*rig.window().page(kPages.last())).isEmpty());
}

void TestStale::aMissingSensorIsShown_data()
{
    QTest::addColumn<QString>("address");
    QTest::newRow("simplebgc") << u"sim:simplebgc?fault=no-imu=1"_s;
    QTest::newRow("storm32") << u"sim:storm32?fault=no-imu=1"_s;
}

// Zeros without a sensor are no angles.
void TestStale::aMissingSensorIsShown()
{
    QFETCH(const QString, address);
    WindowRig rig;
    QVERIFY(rig.open(address));
    const ChannelRoles &roles = rig.client().roles();
    for (const QString &key : {u"dashboard"_s, u"control"_s}) {
        QVERIFY(rig.window().showPage(key));
        const QWidget *page = rig.window().page(key);
        const auto *attitude = page->findChild<AttitudeView *>();
        const auto *cover = attitude->findChild<StaleCover *>({}, Qt::FindDirectChildrenOnly);
        QTRY_COMPARE(cover->text(), u"The board sees no sensor"_s);
        QVERIFY(cover->isVisible());
    }
    const auto store = rig.client().telemetry();
    for (const int channel : ChannelRoles::present({roles.angle, roles.gyro, roles.acc})) {
        if (store->latestAt(channel) != TimePoint{})
            QVERIFY2(std::isnan(store->latest(channel)),
                     rig.client().device()->channels()[std::size_t(channel)].key);
    }
    QVERIFY(!std::isnan(store->latest(roles.battery)));
    rig.workspace().changeWorld(u"no-imu=0"_s);
    QTRY_VERIFY(!std::isnan(store->latest(roles.angle[0])));
}

void TestStale::dataThatStandStillAreStale_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QString>("text");
    QTest::newRow("stamped stream") << u"sim:simplebgc"_s << u"Unchanged since"_s;
    QTest::newRow("stamped answers") << u"sim:storm32"_s << u"Unchanged since"_s;
    QTest::newRow("answers without a stamp") << u"sim:storm32?firmware=0.79"_s << u"Unchanged since"_s;
}

// The link is fine, and the board tells the same again and again.
void TestStale::dataThatStandStillAreStale()
{
    QFETCH(const QString, address);
    QFETCH(const QString, text);
    WindowRig rig;
    QVERIFY(rig.open(address));
    QVERIFY(rig.window().showPage(u"dashboard"_s));
    const QWidget *page = rig.window().page(u"dashboard"_s);
    const auto *cover
        = page->findChild<AttitudeView *>()->findChild<StaleCover *>({}, Qt::FindDirectChildrenOnly);
    QVERIFY(rig.boardGoesOn(1.0));
    QTRY_VERIFY(cover->text().isEmpty());
    rig.workspace().changeWorld(u"frozen=1"_s);
    QTRY_VERIFY2(cover->text().startsWith(text), qPrintable(cover->text()));
    QVERIFY(rig.client().isConnected());
    rig.workspace().changeWorld(u"frozen=0"_s);
    QTRY_VERIFY(cover->text().isEmpty());
}

// Nothing that the board has said before counts as the present; a stop that was proven since does.
void TestStale::dataThatStandStillAreToldEverywhere()
{
    WindowRig rig;
    QVERIFY(rig.open());
    QTRY_COMPARE(rig.workspace().motorsRunning(), std::optional(true));
    QVERIFY(rig.window().showPage(u"calibration"_s));
    QVERIFY(rig.boardGoesOn(1.0));
    const auto says = [&rig](const QString &text) {
        const auto labels = rig.window().findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [&text](const QLabel *label) {
            return label->isVisible() && label->text().contains(text);
        });
    };
    const auto *motors = rig.window().findChild<QPushButton *>(u"motors"_s);
    const QString told = u"the same live data again and again"_s;
    QVERIFY(!rig.window().messageBar()->text().contains(told));
    rig.workspace().changeWorld(u"frozen=1"_s);
    QTRY_VERIFY(rig.window().messageBar()->text().contains(told));
    QTRY_VERIFY(says(u"live data stand still"_s));
    QCOMPARE(rig.workspace().motorsRunning(), std::nullopt);
    QTRY_COMPARE(motors->text(), u"■ STOP MOTORS"_s);
    rig.window().showPage(u"dashboard"_s);
    QTRY_VERIFY(says(u"Whether the motors run is not known"_s));
    QVERIFY(!says(u"Motors are running"_s) && !says(u"reports no errors"_s));
    QTest::keyClick(&rig.window(), Qt::Key_F12);
    QTRY_COMPARE(rig.workspace().motorsRunning(), std::optional(false));
    QTRY_VERIFY(says(u"Motors are off."_s));
    QTRY_COMPARE(motors->text(), u"▶ Start motors"_s);
    rig.workspace().changeWorld(u"frozen=0"_s);
    QTRY_VERIFY(!rig.window().messageBar()->text().contains(told));
    QTRY_VERIFY(!says(u"live data stand still"_s));
    QTRY_VERIFY(says(u"reports no errors"_s));
    QCOMPARE(rig.workspace().motorsRunning(), std::optional(false));
}

void TestStale::silenceWithMotorsIsAnAlarm_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<bool>("run");
    QTest::addColumn<bool>("isBusy");
    for (const QString &family : {u"simplebgc"_s, u"storm32"_s}) {
        QTest::addRow("%s, motors run", qPrintable(family)) << family << true << false;
        QTest::addRow("%s, motors off", qPrintable(family)) << family << false << false;
        // No work explains a silence for so long.
        QTest::addRow("%s, in the middle of work", qPrintable(family)) << family << true << true;
    }
}

// The link stays open, and the board says nothing at all.
void TestStale::silenceWithMotorsIsAnAlarm()
{
    QFETCH(const QString, family);
    QFETCH(const bool, run);
    QFETCH(const bool, isBusy);
    const bool isOwnProcess = family == u"simplebgc"_s;
    std::optional<SimProcess> board;
    if (isOwnProcess)
        board.emplace(QStringList{u"--tcp"_s, u"0"_s}, family);
    WindowRig rig;
    QVERIFY(rig.open(isOwnProcess ? board->address() : u"sim:"_s + family));
    const auto freeze = [&](bool frozen) {
        if (board)
            ::kill(pid_t(board->process().processId()), frozen ? SIGSTOP : SIGCONT);
        else
            rig.workspace().changeWorld(frozen ? u"deaf=100"_s : u"deaf=-1"_s);
    };
    QTRY_COMPARE(rig.workspace().motorsRunning(), std::optional(true));
    QTRY_VERIFY(!rig.workspace().isStarting());
    QVERIFY(rig.jobsAreDone());
    if (!run) {
        rig.workspace().setMotors(false);
        QTRY_COMPARE(rig.workspace().motorsRunning(), std::optional(false));
    }
    const QString told = u"No live data have come since"_s;
    const auto tellsAnswerTime = [&rig] {
        const auto labels = rig.window().findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [](const QLabel *label) {
            return label->text().contains(u"lost"_s) && label->text().endsWith(u" ms"_s);
        });
    };
    QVERIFY(rig.boardGoesOn(0.5));
    QTRY_VERIFY(tellsAnswerTime());
    QVERIFY(!rig.window().messageBar()->text().contains(told));
    QSignalSpy silent(&rig.workspace().freshness(), &Freshness::silentChanged);
    if (isBusy)
        rig.client().submit<bool>([](Channel &channel, Device &) -> Result<bool> {
            return channel.sleep(30s).map([] { return true; });
        });
    freeze(true);
    QTRY_COMPARE(silent.count(), 1);
    QCOMPARE(rig.client().isBusy(), isBusy);
    QTRY_VERIFY(!tellsAnswerTime());
    const auto *dot = rig.window().findChild<QLabel *>(u"dot"_s);
    QVERIFY(dot && !dot->text().contains(rig.workspace().theme().color(ColorRole::Ok).name()));
    QCOMPARE(rig.window().messageBar()->text().contains(told), run);
    QVERIFY(rig.client().isConnected());
    freeze(false);
    QTRY_COMPARE(silent.count(), 2);
    QTRY_VERIFY(tellsAnswerTime());
    QVERIFY(!rig.window().messageBar()->text().contains(told));
    QTRY_VERIFY(dot->text().contains(rig.workspace().theme().color(ColorRole::Ok).name()));
}

void TestStale::silenceIsNoAlarmWhileWorkExplainsIt()
{
    WindowRig rig;
    QVERIFY(rig.open(u"sim:storm32"_s));
    QVERIFY(rig.jobsAreDone());
    QVERIFY(rig.boardGoesOn(0.5));
    const auto goesOn = std::make_shared<std::atomic<bool>>(true);
    auto work = rig.client().submit<bool>([goesOn](Channel &channel, Device &) -> Result<bool> {
        while (*goesOn && !channel.cancelled())
            static_cast<void>(channel.sleep(50ms));
        return true;
    });
    QTRY_VERIFY(rig.client().isBusy());
    rig.workspace().changeWorld(u"deaf=100"_s);
    const auto silence = [&rig] {
        const auto since = rig.workspace().freshness().staleSince();
        return since ? since->msecsTo(QDateTime::currentDateTime()) : 0;
    };
    const auto rows = rig.client().telemetry()->rows();
    QTRY_VERIFY2(silence() > 5000,
                 qPrintable(u"%1 ms, %2 rows, then %3"_s.arg(silence()).arg(rows).arg(
                     rig.client().telemetry()->rows())));
    QVERIFY(!rig.workspace().freshness().silentSince());
    *goesOn = false;
    QTRY_VERIFY(work.isFinished());
    QTRY_VERIFY(rig.workspace().freshness().silentSince());
    rig.workspace().changeWorld(u"deaf=-1"_s);
    QTRY_VERIFY(!rig.workspace().freshness().silentSince());
}

QTEST_MAIN(TestStale)
#include "tst_stale.moc"
