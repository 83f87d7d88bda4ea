// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// A remote control at a SimpleBGC board: what its receiver gives, what the board tells of it and does with
// it.
#include "tests/support/sbgcrig.h"

#include <cmath>

using namespace simplebgc;
using namespace Qt::StringLiterals;

class TestSbgcReceiver final : public QObject
{
    Q_OBJECT
private slots:
    void everyInputIsTold();
    void aPinThatNothingUsesHasToBeMadeAnInput();
    void aServosPinStaysOne();
    void anEncodersPinIsLeftAlone();
    void channelsNeedTheirKindOfSignal_data();
    void channelsNeedTheirKindOfSignal();
    void olderFirmwareTellsWhatIsMapped();
    void aSignalThatIsLostIsUndefined();
    void aStickTurnsTheCamera_data();
    void aStickTurnsTheCamera();
    void theDeadBandIsKept();
    void aSwitchGivesCommands();

private:
    static constexpr int kNow = 2704;
};

void TestSbgcReceiver::everyInputIsTold()
{
    SbgcRig rig(kNow);
    QVERIFY(rig.perform("inputs")->isEmpty());  // there is no receiver
    rig.board().setFaults({.receiver = 1, .stick = 3});
    QVERIFY(rig.channel.sleep(1s));
    const auto told = rig.perform("inputs");
    QVERIFY(told);
    QCOMPARE(told->size(), 3);  // those that are mapped
    QVERIFY(std::abs(told->value(u"input.RC_ROLL (PWM)"_s).toDouble()) < 2);
    QVERIFY(std::abs(told->value(u"input.RC_PITCH (PWM)"_s).toDouble() - 96) < 2);
    rig.board().setFaults({.receiver = 1, .stick = 4});
    QVERIFY(rig.channel.sleep(1s));
    QVERIFY(std::abs(rig.perform("inputs")->value(u"input.RC_PITCH (PWM)"_s).toDouble() + 96) < 2);
}

void TestSbgcReceiver::aPinThatNothingUsesHasToBeMadeAnInput()
{
    SbgcRig rig(kNow);
    rig.board().store(u"rc.map.yaw"_s, 0, 0);
    rig.board().setFaults({.receiver = 1, .stick = 5});
    QVERIFY(rig.channel.sleep(1s));
    const QString yaw = u"input.RC_YAW (PWM)"_s;
    QVERIFY(!rig.perform("inputs")->contains(yaw));
    QVERIFY(rig.perform("inputs", {{u"initialize"_s, u"on"_s}})->value(yaw).toDouble() > 90);
    QVERIFY(rig.perform("inputs")->contains(yaw));
}

void TestSbgcReceiver::aServosPinStaysOne()
{
    SbgcRig rig(kNow);
    rig.board().store(u"service.servo1.source"_s, 0, 3);
    rig.board().setFaults({.receiver = 1, .stick = 7});
    QVERIFY(rig.channel.sleep(1s));
    QVERIFY(!rig.perform("inputs", {{u"initialize"_s, u"on"_s}})->contains(u"input.FC_ROLL (PWM)"_s));
    rig.board().store(u"service.servo1.source"_s, 0, 0);
    QVERIFY(rig.perform("inputs", {{u"initialize"_s, u"on"_s}})->contains(u"input.FC_ROLL (PWM)"_s));
}

// Which pin it is read by, no parameter says.
void TestSbgcReceiver::anEncodersPinIsLeftAlone()
{
    SimulatorOptions options = withFirmware(kNow);
    options.own[u"encoders"_s] = 1;
    SbgcRig rig(options);
    rig.board().store(u"rc.map.yaw"_s, 0, 0);
    rig.board().store(u"encoder.yaw.type"_s, 0, 3);
    rig.board().setFaults({.receiver = 1, .stick = 5});
    QVERIFY(rig.channel.sleep(1s));
    const auto told = rig.perform("inputs", {{u"initialize"_s, u"on"_s}});
    QVERIFY2(told && !told->contains(u"input.RC_YAW (PWM)"_s), told ? "" : qPrintable(told.error().detail));
}

void TestSbgcReceiver::channelsNeedTheirKindOfSignal_data()
{
    QTest::addColumn<int>("receiver");
    QTest::addColumn<int>("mode");
    QTest::addColumn<int>("count");
    QTest::newRow("CPPM") << 2 << 1 << 5;
    QTest::newRow("S-bus") << 3 << 2 << 5;
    QTest::newRow("Spektrum") << 4 << 3 << 5;
    QTest::newRow("another") << 4 << 2 << 0;
    QTest::newRow("pulses are expected") << 3 << 0 << 0;
}

void TestSbgcReceiver::channelsNeedTheirKindOfSignal()
{
    QFETCH(int, receiver);
    QFETCH(int, mode);
    QFETCH(int, count);
    SbgcRig rig(kNow);
    rig.board().store(u"rc.input_mode"_s, 0, mode);
    rig.board().setFaults({.receiver = receiver, .stick = 2});
    QVERIFY(rig.channel.sleep(1s));
    const auto told = rig.perform("inputs");
    QVERIFY(told);
    QCOMPARE(int(told->size()), count);
    if (count > 0) {
        QVERIFY(std::abs(told->value(u"input.RC channel 1"_s).toDouble() + 96) < 2);
        QVERIFY(std::abs(told->value(u"input.RC channel 3"_s).toDouble() + 100) < 2);  // throttle
    }
}

void TestSbgcReceiver::olderFirmwareTellsWhatIsMapped()
{
    SbgcRig rig(2590);
    rig.board().store(u"rc.map.pitch"_s, 0, 1);
    rig.board().store(u"rc.map.roll"_s, 0, 0);
    rig.board().setFaults({.receiver = 1, .stick = 1});
    QVERIFY(rig.channel.sleep(1s));
    const auto told = rig.perform("inputs", {{u"initialize"_s, u"on"_s}});
    QVERIFY2(told, told ? "" : qPrintable(told.error().detail));
    QVERIFY(std::abs(told->value(u"input.RC_ROLL (PWM)"_s).toDouble() - 96) < 2);
    QVERIFY(!told->contains(u"input.RC_PITCH (PWM)"_s));
    QVERIFY(told->contains(u"input.RC_YAW (PWM)"_s));
}

void TestSbgcReceiver::aSignalThatIsLostIsUndefined()
{
    SbgcRig rig(kNow);
    Faults faults{.receiver = 1, .rcLoss = 0.3};
    rig.board().setFaults(faults);
    for (int i = 0; i < 20; ++i) {
        QVERIFY(rig.channel.sleep(200ms));
        QCOMPARE(rig.perform("inputs")->size(), 3);  // some frames are no loss
    }
    faults.rcLoss = 1;
    rig.board().setFaults(faults);
    QVERIFY(rig.channel.sleep(1s));
    QVERIFY(rig.perform("inputs")->isEmpty());
}

void TestSbgcReceiver::aStickTurnsTheCamera_data()
{
    QTest::addColumn<int>("mode");
    QTest::addColumn<bool>("isInverted");
    QTest::newRow("speed") << 1 << false;
    QTest::newRow("speed, inverted") << 1 << true;
    QTest::newRow("angle") << 0 << false;
    QTest::newRow("angle, inverted") << 0 << true;
}

void TestSbgcReceiver::aStickTurnsTheCamera()
{
    QFETCH(int, mode);
    QFETCH(bool, isInverted);
    SbgcRig rig(kNow);
    rig.board().store(u"rc.pitch.mode"_s, 0, mode);
    rig.board().store(u"rc.pitch.inverted"_s, 0, isInverted ? 1 : 0);
    rig.board().stabilizer().setMotorsOn(true);
    rig.board().setFaults({.receiver = 1, .stick = 3});
    QVERIFY(rig.channel.sleep(2s));
    const double pitch = rig.board().stabilizer().estimate(Axis::Pitch) * (isInverted ? -1 : 1);
    QVERIFY2(pitch > 25, qPrintable(QString::number(pitch)));
    rig.board().setFaults({.receiver = 1});
    QVERIFY(rig.channel.sleep(5s));
    const double later = rig.board().stabilizer().estimate(Axis::Pitch) * (isInverted ? -1 : 1);
    QVERIFY2(mode == 0 ? std::abs(later) < 5 : std::abs(later - pitch) < 5,
             qPrintable(QString::number(later)));
}

void TestSbgcReceiver::theDeadBandIsKept()
{
    SbgcRig rig(kNow);
    rig.board().store(u"rc.deadband"_s, 0, 255);
    rig.board().setFaults({.receiver = 1, .rcNoise = 30});
    const double before = rig.board().stabilizer().target(Axis::Pitch);
    QVERIFY(rig.channel.sleep(10s));
    QCOMPARE(rig.board().stabilizer().target(Axis::Pitch), before);
}

void TestSbgcReceiver::aSwitchGivesCommands()
{
    SbgcRig rig(kNow);
    rig.board().store(u"rc.map.cmd"_s, 0, 3);
    rig.board().store(u"service.rc_high"_s, 0, 11);
    rig.board().store(u"service.rc_low"_s, 0, 12);
    rig.board().setFaults({.receiver = 1});
    QVERIFY(rig.channel.sleep(1s));
    rig.board().stabilizer().setMotorsOn(false);
    rig.board().setFaults({.receiver = 1, .stick = 7});
    QVERIFY(rig.channel.sleep(1s));
    QVERIFY(rig.board().stabilizer().motorsOn());
    rig.board().setFaults({.receiver = 1, .stick = 8});
    QVERIFY(rig.channel.sleep(1s));
    QVERIFY(!rig.board().stabilizer().motorsOn());
}

QTEST_GUILESS_MAIN(TestSbgcReceiver)
#include "tst_sbgcreceiver.moc"
