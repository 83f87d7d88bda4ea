// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/motorstop.h"
#include "protocol/storm32/telemetrytables.h"
#include "tests/support/stormrig.h"

#include <QTest>

using namespace Qt::StringLiterals;

namespace {

using Words = std::array<int, storm32::MotorStop::kWords>;

Words usage(StormRig &rig)
{
    Words words{};
    for (int i = 0; i < int(words.size()); ++i)
        words[std::size_t(i)] = rig.board().inUse(storm32::MotorStop::kFirstWord + i);
    return words;
}

constexpr Words kNormal{0, 0, 0};
constexpr Words kDisabled{3, 3, 3};

/// Whether a motor is active or will be; what the board itself says.
bool motorsTurn(StormRig &rig)
{
    return rig.board().stabilizer().motorsOn() && usage(rig) != kDisabled;
}

}  // namespace

/// "Motors off" of a STorM32 counts once the board's status says so (errata 13, row 1).
class TestStormStop : public QObject
{
    Q_OBJECT
private slots:
    void startingBoardIsStopped_data();
    void startingBoardIsStopped();
    void nothingIsStoredMeanwhile();
    void actionIsProvenToo();
    void whatCannotBePutBackIsTold_data();
    void whatCannotBePutBackIsTold();
    void normalBoardIsPutIntoStandby();
    void disabledMotorsAreOff();
    void silentBoardIsNotProven();
    void motorsOnNeedsAMotor_data();
    void motorsOnNeedsAMotor();
};

void TestStormStop::startingBoardIsStopped_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<int>("state");
    QTest::addColumn<bool>("lockedOut");
    for (const int firmware : {79, 90, 96}) {
        for (const int state : {0, 2, 4, 5})
            QTest::addRow("0.%d in state %d", firmware, state) << firmware << state << false;
        QTest::addRow("0.%d through MAVLink", firmware) << firmware << 4 << true;
    }
}

void TestStormStop::startingBoardIsStopped()
{
    QFETCH(const int, firmware);
    QFETCH(const int, state);
    QFETCH(const bool, lockedOut);
    StormRig rig(stormOptions(firmware, !lockedOut));
    if (lockedOut)
        rig.lockOut();
    QVERIFY(rig.device.probe(rig.channel).value_or(false));
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(rig.device.readConfiguration(rig.channel));
    QVERIFY(rig.device.perform(rig.channel, u"restart"_s, {}));
    for (const QString &axis : {u"roll"_s, u"pitch"_s, u"yaw"_s}) {  // to be found in state 4
        const ParameterSpec *spec = rig.device.parameters()->find(u"motor.%1.direction"_s.arg(axis));
        rig.board().set(spec->offset / 2, 2);
    }
    if (state == 5) {  // leaving standby goes through it, with the motors on
        QVERIFY(rig.channel.sleep(25s));
        QVERIFY(rig.device.perform(rig.channel, u"motors.off"_s, {}));
        QVERIFY(rig.device.switchMotorsOn(rig.channel));
    }
    for (int i = 0; i < 250 && rig.board().state() != state; ++i)
        QVERIFY(rig.channel.sleep(100ms));
    QCOMPARE(rig.board().state(), state);
    rig.channel.stopMotors(rig.device.stopPlan());
    QVERIFY(rig.channel.sleep(2500ms));
    QVERIFY(rig.channel.stopResult() && rig.channel.stopResult()->has_value());
    QVERIFY(!motorsTurn(rig));
    // They stay off to the end of the start, and the words are the operator's again once standby is proven.
    for (int i = 0; i < 300 && (rig.board().state() < 6 || usage(rig) != kNormal); ++i) {
        QVERIFY(!motorsTurn(rig));
        QVERIFY(rig.channel.sleep(100ms));
    }
    QVERIFY(storm32::isStandby(rig.board().state(), firmware));
    QCOMPARE(usage(rig), kNormal);
    QVERIFY(rig.channel.sleep(1s));  // it is read back
    QVERIFY(rig.device.switchMotorsOn(rig.channel));
    QVERIFY(motorsTurn(rig));
}

void TestStormStop::nothingIsStoredMeanwhile()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(rig.device.perform(rig.channel, u"restart"_s, {}));
    rig.channel.stopMotors(rig.device.stopPlan());
    QVERIFY(rig.channel.sleep(2500ms));
    QVERIFY(rig.channel.stopResult() && rig.channel.stopResult()->has_value());
    QCOMPARE(usage(rig), kDisabled);
    for (const auto &refused :
         {rig.device.beginWrite(rig.channel), rig.device.endWrite(rig.channel),
          rig.device.perform(rig.channel, u"store"_s, {}).map([](const ActionReply &) {}),
          rig.device.switchMotorsOn(rig.channel)}) {
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::Disabled);
    }
    // What is read is what the operator set.
    const auto read = rig.device.readConfiguration(rig.channel);
    QVERIFY(read);
    for (const QString &key : {u"motor.pitch.usage"_s, u"motor.roll.usage"_s, u"motor.yaw.usage"_s})
        QCOMPARE(read->raw(*rig.device.parameters()->find(key), 0), 0.0);
    QVERIFY(rig.channel.sleep(30s));
    QVERIFY(rig.device.perform(rig.channel, u"store"_s, {}));
    QCOMPARE(rig.board().stored(storm32::MotorStop::kFirstWord), 0);
}

void TestStormStop::actionIsProvenToo()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(rig.device.perform(rig.channel, u"restart"_s, {}));
    QVERIFY(rig.device.perform(rig.channel, u"motors.off"_s, {}));
    QVERIFY(!motorsTurn(rig));
    QVERIFY(storm32::isStandby(rig.board().state(), 96));  // it returns when everything is put back
    QCOMPARE(usage(rig), kNormal);
}

void TestStormStop::whatCannotBePutBackIsTold_data()
{
    QTest::addColumn<int>("firmware");
    for (const int firmware : {79, 90, 96})
        QTest::newRow(QByteArray::number(firmware)) << firmware;
}

// A board that never comes to standby keeps its motors disabled: what was in use before is said.
void TestStormStop::whatCannotBePutBackIsTold()
{
    QFETCH(const int, firmware);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    rig.board().set(80, 1);
    rig.change(u"no-imu=1"_s);
    QVERIFY(rig.device.perform(rig.channel, u"reset"_s, {}));
    rig.board().set(80, 1);
    const auto off = rig.device.perform(rig.channel, u"motors.off"_s, {});
    QVERIFY(!off);
    QCOMPARE(off.error().code, ErrorCode::NotRestored);
    QCOMPARE(usage(rig), kDisabled);
    for (const QString &told :
         {u"motor.pitch.usage=0"_s, u"motor.roll.usage=0"_s, u"motor.yaw.usage=1"_s, u"Restart"_s})
        QVERIFY2(off.error().detail.contains(told), qPrintable(off.error().detail));
}

void TestStormStop::normalBoardIsPutIntoStandby()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(motorsTurn(rig));
    rig.channel.stopMotors(rig.device.stopPlan());
    QVERIFY(rig.channel.sleep(100ms));
    QVERIFY(rig.channel.stopResult() && rig.channel.stopResult()->has_value());
    QVERIFY(!motorsTurn(rig));
    QCOMPARE(usage(rig), kNormal);  // nothing else was touched
}

void TestStormStop::disabledMotorsAreOff()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(rig.device.perform(rig.channel, u"restart"_s, {}));
    for (int i = 0; i < storm32::MotorStop::kWords; ++i)
        rig.board().set(storm32::MotorStop::kFirstWord + i, 3);
    rig.channel.stopMotors(rig.device.stopPlan());
    QVERIFY(rig.channel.sleep(1s));
    QVERIFY(rig.channel.stopResult() && rig.channel.stopResult()->has_value());
    QCOMPARE(usage(rig), kDisabled);  // by the operator, so they stay so
}

void TestStormStop::silentBoardIsNotProven()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.change(u"deaf=115"_s);  // the letter of the status
    rig.channel.stopMotors(rig.device.stopPlan());
    QVERIFY(rig.channel.sleep(10s));
    QVERIFY(rig.channel.stopResult() && !rig.channel.stopResult()->has_value());
    QCOMPARE(rig.channel.stopResult()->error().code, ErrorCode::NotProven);
}

void TestStormStop::motorsOnNeedsAMotor_data()
{
    QTest::addColumn<int>("firmware");
    for (const int firmware : {79, 90, 96})
        QTest::newRow(QByteArray::number(firmware)) << firmware;
}

// What keeps them off is read, not guessed.
void TestStormStop::motorsOnNeedsAMotor()
{
    QFETCH(const int, firmware);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    for (int i = 0; i < storm32::MotorStop::kWords; ++i)
        rig.board().set(storm32::MotorStop::kFirstWord + i, 3);
    const auto done = rig.device.perform(rig.channel, u"motors.on"_s, {});
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::NoEffect);
    for (const QString &axis : {u"pitch"_s, u"roll"_s, u"yaw"_s})
        QVERIFY2(done.error().detail.contains(u"motor.%1.usage"_s.arg(axis)),
                 qPrintable(done.error().detail));
}

QTEST_GUILESS_MAIN(TestStormStop)
#include "tst_stormstop.moc"
