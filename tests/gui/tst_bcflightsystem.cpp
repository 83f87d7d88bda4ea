// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/recordingspage.h"
#include "app/families/bcflight/systempage.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTreeWidget>

using namespace Qt::StringLiterals;

/// What a drone tells of itself and of its recordings, on the screen.
class TestBcflightSystem final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup() { m_rig.reset(); }
    void systemIsATree();
    void whatIsNoTableIsShownAsItCame();
    void silenceIsNamed();
    void recordingsAreListed();
    void listsOfEveryKind_data();
    void listsOfEveryKind();

private:
    static bool says(const QWidget *where, const QString &text)
    {
        const auto labels = where->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [&text](const QLabel *label) {
            return label->isVisible() && label->text().contains(text);
        });
    }
    std::unique_ptr<WindowRig> m_rig;
};

void TestBcflightSystem::init()
{
    static int seed = 800;
    m_rig = std::make_unique<WindowRig>();
    QVERIFY(m_rig->open(u"sim:bcflight?seed=%1"_s.arg(++seed)));
}

void TestBcflightSystem::systemIsATree()
{
    auto *page = m_rig->page<SystemPage>();
    QTRY_VERIFY(named<QPushButton>(page, u"Read again"_s)->isEnabled());
    const QTreeWidget *tree = page->tree();
    QCOMPARE(tree->topLevelItemCount(), int(SystemPage::PartCount));
    for (int part = 0; part < SystemPage::PartCount; ++part)
        QVERIFY2(tree->topLevelItem(part)->childCount() > 0, qPrintable(tree->topLevelItem(part)->text(0)));
    const QList<QTreeWidgetItem *> version
        = tree->findItems(u"Firmware version"_s, Qt::MatchExactly | Qt::MatchRecursive);
    QCOMPARE(version.size(), 1);
    QVERIFY(!version.first()->text(1).isEmpty());
    // A kind of sensor, the sensor, its properties.
    const QList<QTreeWidgetItem *> kinds
        = tree->findItems(u"Gyroscopes"_s, Qt::MatchExactly | Qt::MatchRecursive);
    QCOMPARE(kinds.size(), 1);
    QVERIFY(kinds.first()->childCount() > 0 && kinds.first()->child(0)->childCount() > 0);
    QTest::mouseClick(named<QPushButton>(page, u"Copy"_s), Qt::LeftButton);
    const QString copied = QGuiApplication::clipboard()->text();
    QVERIFY(copied.startsWith(u"Board\n"_s) && copied.contains(u"\n  Firmware version: "_s));
    QCOMPARE(copied, page->text());
    // What is chosen is copied alone.
    page->tree()->clearSelection();
    version.first()->setSelected(true);
    QTest::keyClick(page, Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QGuiApplication::clipboard()->text(), u"Firmware version: %1\n"_s.arg(version.first()->text(1)));
    // It stays when the drone goes, and says so.
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(says(page, u"not connected"_s));
    QVERIFY(!named<QPushButton>(page, u"Read again"_s)->isEnabled());
    QVERIFY(page->text().contains(u"Firmware version"_s));
}

void TestBcflightSystem::whatIsNoTableIsShownAsItCame()
{
    auto *page = m_rig->page<SystemPage>();
    QTRY_VERIFY(named<QPushButton>(page, u"Read again"_s)->isEnabled());
    page->showText(SystemPage::Sensors, u"{ broken = { \nos.execute(\"x\")\n"_s);
    const QTreeWidgetItem *item = page->tree()->topLevelItem(SystemPage::Sensors);
    QVERIFY(item->text(1).contains(u"as a table"_s));
    QCOMPARE(item->childCount(), 2);
    QCOMPARE(item->child(1)->text(0), u"os.execute(\"x\")"_s);
    page->showText(SystemPage::Cameras, u"nil"_s);
    QCOMPARE(page->tree()->topLevelItem(SystemPage::Cameras)->text(1), u"none"_s);
}

// A drone of an old generation knows no cameras.
void TestBcflightSystem::silenceIsNamed()
{
    QVERIFY(m_rig->open(u"sim:bcflight?generation=A"_s));
    auto *page = m_rig->page<SystemPage>();
    QTRY_VERIFY(named<QPushButton>(page, u"Read again"_s)->isEnabled());
    QVERIFY(page->tree()->topLevelItem(SystemPage::Board)->childCount() > 0);
    const QString cameras = page->tree()->topLevelItem(SystemPage::Cameras)->text(1);
    QVERIFY2(cameras.startsWith(u"not told"_s), qPrintable(cameras));
}

void TestBcflightSystem::recordingsAreListed()
{
    auto *page = m_rig->page<RecordingsPage>();
    QTRY_COMPARE(page->table()->rowCount(), 2);  // the two that begin with a dot are not shown
    QVERIFY(says(page, u"2 "_s) && says(page, u"neither be downloaded nor deleted"_s));
    QCOMPARE(page->table()->item(0, 0)->text(), u"video_0.h264"_s);
    // Sorted by size as a number, not as a text.
    page->table()->sortItems(1);
    QCOMPARE(page->table()->item(0, 0)->text(), u"video_1.h264"_s);
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(says(page, u"not connected"_s));
    QCOMPARE(page->table()->rowCount(), 2);
}

void TestBcflightSystem::listsOfEveryKind_data()
{
    QTest::addColumn<QByteArray>("list");
    QTest::addColumn<int>("rows");
    QTest::addColumn<QString>("said");
    QTest::newRow("empty") << QByteArray(";") << 0 << u"recorded nothing"_s;
    QTest::newRow("nothing at all") << QByteArray() << 0 << u"recorded nothing"_s;
    QTest::newRow("only hidden") << QByteArray(".:0:::;..:0:::;") << 0 << u"recorded nothing"_s;
    QTest::newRow("one") << QByteArray("a.h264:12:::;") << 1 << u"12"_s;
    QTest::newRow("broken") << QByteArray("a.h264:12:::;b.h264:many:::;::;") << 1 << u"could not be read"_s;
    QTest::newRow("huge") << QByteArray("a:9223372036854775807:::;") << 1 << u"1"_s;
}

void TestBcflightSystem::listsOfEveryKind()
{
    QFETCH(QByteArray, list);
    QFETCH(int, rows);
    QFETCH(QString, said);
    auto *page = m_rig->page<RecordingsPage>();
    QTRY_COMPARE(page->table()->rowCount(), 2);
    page->showList(list);
    QCOMPARE(page->table()->rowCount(), rows);
    QVERIFY(says(page, said));
}

QTEST_MAIN(TestBcflightSystem)
#include "tst_bcflightsystem.moc"
