// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/windowrig.h"
#include "widgets/models/channelmodel.h"
#include "widgets/plot/plotview.h"
#include "widgets/views/attitudeview.h"
#include "widgets/views/axisdial.h"
#include "widgets/views/batteryview.h"
#include "widgets/views/gimbalview.h"
#include "widgets/views/stalecover.h"

#include <QLabel>
#include <QTreeView>

using namespace Qt::StringLiterals;

namespace {

const QStringList kPages{u"dashboard"_s, u"control"_s, u"monitor"_s, u"tuning"_s};

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

private:
    /// Of the views of live data on a page.
    static QList<QRect> placesOn(const QWidget &page)
    {
        QList<QRect> places;
        for (const QWidget *view : page.findChildren<QWidget *>()) {
            if (view->isVisible()
                && (qobject_cast<const AttitudeView *>(view) || qobject_cast<const AxisDial *>(view)
                    || qobject_cast<const GimbalView *>(view) || qobject_cast<const PlotView *>(view)))
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
        QVERIFY(rig.isSettled());
        const QList<QRect> places = placesOn(*page);
        QVERIFY(!places.isEmpty());
        const QDateTime before = QDateTime::currentDateTime();
        for (const QString &fault : stop)
            rig.workspace().changeWorld(fault);
        QTRY_VERIFY2_WITH_TIMEOUT(!shown(*page).isEmpty(), qPrintable(key), 10000);
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
        QTRY_VERIFY2_WITH_TIMEOUT(shown(*page).isEmpty(), qPrintable(key), 30000);
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
                && !qobject_cast<const PlotView *>(view))
                continue;
            ++views;
            bool covered = false;
            for (const QWidget *each = view; each && each != page; each = each->parentWidget())
                covered |= each->findChild<StaleCover *>({}, Qt::FindDirectChildrenOnly) != nullptr;
            QVERIFY2(covered, entry.key);
        }
    }
    QVERIFY(views >= 9);
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
}

// Connected, everything read, and not one sample: that looks like a board at rest.
void TestStale::aBoardWithoutLiveDataIsNoticed()
{
    WindowRig rig;
    rig.window().openLink(u"sim:storm32?fault=deaf=100"_s);
    QTRY_VERIFY_WITH_TIMEOUT(rig.client().isConnected() && !rig.model().isEmpty(), 15000);
    for (const QString &key : kPages) {
        QVERIFY(rig.window().showPage(key));
        QTRY_VERIFY2_WITH_TIMEOUT(!shown(*rig.window().page(key)).isEmpty(), qPrintable(key), 15000);
    }
    QVERIFY(rig.client().isConnected());
    const auto labels = rig.window().findChildren<QLabel *>();
    QTRY_VERIFY(std::any_of(labels.begin(), labels.end(),
                            [](const QLabel *label) { return label->text().contains(u"no live data"_s); }));
    rig.workspace().changeWorld(u"deaf=-1"_s);
    QTRY_VERIFY_WITH_TIMEOUT(shown(*rig.window().page(kPages.last())).isEmpty(), 30000);
}

QTEST_MAIN(TestStale)
#include "tst_stale.moc"
