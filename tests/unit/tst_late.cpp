// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/client/connector.h"
#include "protocol/device/abilities.h"
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
    void isFoundWhereThereIsNoOtherRate_data();
    void isFoundWhereThereIsNoOtherRate();
    void lateAnswersAreWaitedFor();
    void foreignBoardIsAskedOnce();
    void heartbeatIsNotWaitedFor();
};

void TestLate::isFoundAtItsRate_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("late");
    for (const QString &family : {u"simplebgc"_s, u"storm32"_s}) {
        for (const int late : {0, 300, 800, 1500, 3000})
            QTest::addRow("%s %d ms", qPrintable(family), late) << family << late;
    }
}

void TestLate::isFoundAtItsRate()
{
    QFETCH(QString, family);
    QFETCH(int, late);
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
    QVERIFY2(found, qPrintable(found ? QString() : found.error().detail));
    QCOMPARE(found->line->baud, 115200);
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

void TestLate::isFoundWhereThereIsNoOtherRate_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<int>("late");
    for (const QString &address : {u"tcp://127.0.0.1:1"_s, u"udp://127.0.0.1:1"_s}) {
        for (const int late : {0, 300, 800, 1500, 3000})
            QTest::addRow("%s %d ms", qPrintable(address.section(u':', 0, 0)), late) << address << late;
    }
}

// There is no other rate to ask at, so it is asked for some seconds.
void TestLate::isFoundWhereThereIsNoOtherRate()
{
    QFETCH(QString, address);
    QFETCH(int, late);
    SimulatorOptions options;
    options.faults.lateMs = late;
    VirtualBoard rig(options);
    const auto found
        = findBoard(rig.channel, rig.family, rig.device, allFamilies(), *LinkAddress::parse(address));
    if (!found) {
        QVERIFY2(late > 1000, qPrintable(found.error().detail));
        QVERIFY(found.error().code == ErrorCode::Timeout || found.error().code == ErrorCode::Garbage);
    }
}

// Each question is followed by its answer before another family is asked.
void TestLate::lateAnswersAreWaitedFor()
{
    SimulatorOptions options;
    options.faults.lateMs = 1200;
    VirtualBoard rig(options);
    const QByteArray question = rig.device.restartNotice()->harmlessQuestion().bytes;
    for (int i = 0; i < 3; ++i) {
        rig.port.hostWrites(asBytes(question));
        QVERIFY(rig.channel.sleep(500ms));
    }
    QVERIFY(awaitQuiet(rig.channel));
    const quint64 bytes = rig.channel.observation().bytesIn;
    QVERIFY(bytes > 0);
    QVERIFY(rig.channel.sleep(5s));
    QCOMPARE(rig.channel.observation().bytesIn, bytes);
}

// It answers each byte that it does not know with a letter.
void TestLate::foreignBoardIsAskedOnce()
{
    StormRig rig;
    const Family family = simplebgc::family();
    VirtualChannel channel(rig.port, family.makeFramer(), family.timing);
    simplebgc::Device device;
    const auto found = device.probe(channel);
    QVERIFY(found && !*found);
    QVERIFY(channel.sleep(2s));
    const quint64 letters = channel.observation().bytesIn;
    QVERIFY(letters > 0);
    QVERIFY2(letters <= quint64(device.restartNotice()->harmlessQuestion().bytes.size()),
             qPrintable(QString::number(letters)));
}

// It goes on for ever, whatever is asked.
void TestLate::heartbeatIsNotWaitedFor()
{
    for (const milliseconds phase : {0ms, 250ms, 500ms, 750ms}) {
        StormRig rig(stormOptions(96, false), LineSettings{115200, Parity::None});
        rig.lockOut();
        QVERIFY(rig.channel.setLine({115200, Parity::None}));
        QVERIFY(rig.channel.sleep(3s + phase));
        const quint64 bytes = rig.channel.observation().bytesIn;
        QVERIFY(bytes > 0);
        const TimePoint begun = rig.channel.now();
        QVERIFY(awaitQuiet(rig.channel));
        QVERIFY2(rig.channel.now() - begun < 1800ms,
                 qPrintable(QString::number(seconds(rig.channel.now() - begun))));
    }
}

QTEST_GUILESS_MAIN(TestLate)
#include "tst_late.moc"
