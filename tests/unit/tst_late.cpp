// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/client/connector.h"
#include "tests/support/stormrig.h"
#include "tests/support/virtualboard.h"

#include <QTest>

using namespace Qt::StringLiterals;

/// Boards that answer late, on links that do not check the rate: what they say is credited to no other rate.
class TestLate : public QObject
{
    Q_OBJECT
private slots:
    void isFoundAtItsRate_data();
    void isFoundAtItsRate();
    void anotherRateIsStillFound_data();
    void anotherRateIsStillFound();
};

void TestLate::isFoundAtItsRate_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("late");
    QTest::addColumn<bool>("isUsable");
    for (const QString &family : {u"simplebgc"_s, u"storm32"_s}) {
        // Later than a STorM32's questions wait: it may not be found, but never at another rate.
        const int usable = family == u"storm32"_s ? 300 : 800;
        for (const int late : {0, 300, 800, 1500, 3000})
            QTest::addRow("%s %d ms", qPrintable(family), late) << family << late << (late <= usable);
    }
}

void TestLate::isFoundAtItsRate()
{
    QFETCH(QString, family);
    QFETCH(int, late);
    QFETCH(bool, isUsable);
    SimulatorOptions options;
    options.faults.lateMs = late;
    const auto find = [](auto &rig) {
        return findBoard(rig.channel, rig.family, rig.device, allFamilies(),
                         LinkAddress::serial(u"/dev/x"_s));
    };
    Result<FoundBoard> found = failure(ErrorCode::Silent);
    if (family == u"simplebgc"_s) {
        VirtualBoard rig(options);
        found = find(rig);
    } else {
        options.firmware = 96;
        StormRig rig(options);
        found = find(rig);
    }
    if (isUsable)
        QVERIFY2(found, qPrintable(found ? QString() : found.error().detail));
    if (found)
        QCOMPARE(found->line->baud, 115200);
    else
        QVERIFY(found.error().code == ErrorCode::Timeout || found.error().code == ErrorCode::Garbage);
}

void TestLate::anotherRateIsStillFound_data()
{
    QTest::addColumn<int>("late");
    QTest::newRow("in time") << 0;
    QTest::newRow("late") << 300;
}

// A link that checks the rate: only its own one is heard.
void TestLate::anotherRateIsStillFound()
{
    QFETCH(int, late);
    SimulatorOptions options;
    options.usb = false;
    options.faults.lateMs = late;
    VirtualBoard rig(options, LineSettings{57600, Parity::None});
    const auto found
        = findBoard(rig.channel, rig.family, rig.device, allFamilies(), LinkAddress::serial(u"/dev/x"_s));
    QVERIFY2(found, qPrintable(found ? QString() : found.error().detail));
    QCOMPARE(found->line->baud, 57600);
}

QTEST_GUILESS_MAIN(TestLate)
#include "tst_late.moc"
