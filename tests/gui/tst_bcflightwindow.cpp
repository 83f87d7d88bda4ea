// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/navigation.h"
#include "app/pages/board/actionspage.h"
#include "app/pages/setup/documentspage.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/watch/dashboardpage.h"
#include "app/pages/watch/monitorpage.h"
#include "protocol/bcflight/tables.h"
#include "protocol/configuration/writereport.h"
#include "protocol/device/device.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"

#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>

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

private:
    MainWindow &window() { return m_rig->window(); }
    std::unique_ptr<WindowRig> m_rig;
};

void TestBcflightWindow::init()
{
    static int seed = 300;
    m_rig = std::make_unique<WindowRig>();
    QVERIFY(m_rig->open(u"sim:bcflight?seed=%1"_s.arg(++seed)));
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

QTEST_MAIN(TestBcflightWindow)
#include "tst_bcflightwindow.moc"
