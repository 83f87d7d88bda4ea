// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Commands of later firmware, and what they do to a simulated gimbal.
#include "protocol/base/angles.h"
#include "protocol/base/responsecsv.h"
#include "protocol/simplebgc/rotation.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"
#include "tests/support/channelproxy.h"
#include "tests/support/sbgcrig.h"
#include "tests/unit/sbgcvectors.h"

#include <QFile>

#include <cmath>

using namespace simplebgc;
using namespace Qt::StringLiterals;

namespace {

constexpr int kNewest = 2742;

bool isOffered(SbgcRig &rig, const char *key)
{
    const auto list = rig.device.actions();
    return std::any_of(list.begin(), list.end(),
                       [key](const ActionSpec &action) { return qstrcmp(action.key, key) == 0; });
}

qsizetype argumentCount(SbgcRig &rig, const char *key)
{
    for (const ActionSpec &action : rig.device.actions()) {
        if (qstrcmp(action.key, key) == 0)
            return qsizetype(action.arguments.size());
    }
    return 0;
}

SimulatorOptions equipped(int firmware, const QStringList &options)
{
    SimulatorOptions all = withFirmware(firmware);
    for (const QString &option : options)
        all.own.insert(option, 1);
    return all;
}

#define DONE(outcome) QVERIFY2(outcome, (outcome) ? "" : qPrintable((outcome).error().detail))

}  // namespace

class TestSbgcLater : public QObject
{
    Q_OBJECT
private slots:
    void steersInFinerSteps();
    void steeringSpeedsUpSlowly();
    void steeringThatIsLateEnds();
    void attitudeIsSteeredTo();
    void attitudeThatIsNotReachedIsTold();
    void attitudeIsLeftWhenItIsCancelled();
    void attitudesAreAngles_data();
    void attitudesAreAngles();
    void plantAnswersItsStimulus_data();
    void plantAnswersItsStimulus();
    void testEndsWhenItIsCancelled();
    void testNeedsMotors();
    void calibrationIsTold();
    void temperaturesAreKnown();
    void accelerometerTakesItsReference();
    void referenceThatIsNotTakenIsSeen();
    void servosAreSetOneByOne();
    void furtherDataAreThoseOfTheWorld();
    void referencesAreInWords();
    void eventsAreTold();
    void gainsAreSearchedByAxis();
    void searchByAxisEndsWhenItIsCancelled();
    void rippleOfTheMotorsIsTakenOut();
    void variablesAreListed();
    void statisticsBeginAnew();
    void signalIsGivenInFinerSteps();
    void whatIsSentIsAsTheErrataSay_data();
    void whatIsSentIsAsTheErrataSay();
    void earlierFirmwareHasNoneOfIt();
};

// No count of 14 bits is as near as that.
void TestSbgcLater::steersInFinerSteps()
{
    SbgcRig rig(2704);
    const double yaw = rig.board().stabilizer().target(Axis::Yaw);
    const auto done
        = rig.perform("steer", {{u"pitch"_s, u"-10.007"_s}, {u"fine"_s, u"on"_s}, {u"release"_s, u"off"_s}});
    DONE(done);
    QVERIFY(std::abs(rig.board().stabilizer().target(Axis::Pitch) + 10.007) < 0.0004);
    QVERIFY(std::abs(rig.board().stabilizer().estimate(Axis::Pitch) + 10.007) < 2);
    QVERIFY(std::abs(rig.board().stabilizer().target(Axis::Yaw) - yaw) < 5);  // it follows the hand
    QCOMPARE(rig.board().lastControl()[0].mode, 0);
    // Worked out by tests/support/sbgcvectors.py.
    simplebgc::Device::Control turn{};
    turn[2] = {Speed, -0.005, 0};
    QCOMPARE(rig.device.controlFrames(turn, true).setpoint.mid(4).chopped(1).toHex(),
             QByteArray("0024"
                        "0100"
                        "fbffffff"));
    simplebgc::Device::Control place{};
    place[0] = {Angle, 100, 68.6645507812};
    QCOMPARE(rig.device.controlFrames(place, true).setpoint.mid(4).chopped(1).toHex(),
             QByteArray("0f00"
                        "0200"
                        "a0860100"
                        "400d0300"));
    SbgcRig old(2663);
    QCOMPARE(argumentCount(old, "steer") + 1, argumentCount(rig, "steer"));
}

void TestSbgcLater::steeringSpeedsUpSlowly()
{
    SbgcRig rig(2704);
    const auto speedAfter = [&rig](milliseconds time) {
        simplebgc::Device::Control turn{};
        turn[1] = {Speed, 40, 0};
        for (milliseconds passed{}; passed < time; passed += 20ms) {
            rig.channel.steer(rig.device.controlFrames(turn));
            std::ignore = rig.channel.sleep(20ms);
        }
        return rig.perform("angles")->value(u"speed.pitch"_s).toDouble();
    };
    DONE(rig.perform("steer.limits", {{u"pitch"_s, u"50"_s}}));
    const double early = speedAfter(400ms);
    QVERIFY2(early > 12 && early < 30, qPrintable(QString::number(early)));
    QVERIFY(std::abs(speedAfter(600ms) - 40) < 1);
    rig.channel.releaseControl();
}

// Whoever steers has gone: without the limit the axis turns on.
void TestSbgcLater::steeringThatIsLateEnds()
{
    for (const bool isLimited : {false, true}) {
        SbgcRig rig(2704);
        if (isLimited)
            DONE(rig.perform("steer.limits", {{u"timeout"_s, u"0.5"_s}}));
        // pitch at 10 degrees per second
        QVERIFY(rig.channel.transact(
            confirmRequest(CommandId::Control, hex("000100 0000 0000 5200 0000 0000 0000"), 1)));
        std::ignore = rig.channel.sleep(1s);
        const double then = rig.board().stabilizer().target(Axis::Pitch);
        QVERIFY(then > 4);
        std::ignore = rig.channel.sleep(1s);
        const double turned = rig.board().stabilizer().target(Axis::Pitch) - then;
        QVERIFY2(isLimited ? std::abs(turned) < 0.01 : turned > 9, qPrintable(QString::number(turned)));
    }
}

void TestSbgcLater::attitudeIsSteeredTo()
{
    SbgcRig rig(kNewest);
    const auto done = rig.perform(
        "steer.attitude",
        {{u"pitch"_s, u"-25"_s}, {u"yaw"_s, u"40"_s}, {u"speed"_s, u"60"_s}, {u"release"_s, u"off"_s}});
    DONE(done);
    QCOMPARE(done->value(u"mode"_s).toString(), u"attitude"_s);
    QVERIFY(std::abs(done->value(u"imu.pitch"_s).toDouble() + 25) < 3);
    Stabilizer &camera = rig.board().stabilizer();
    QVERIFY(std::abs(camera.estimate(Axis::Pitch) + 25) < 3);
    QVERIFY(std::abs(camera.estimate(Axis::Yaw) - 40) < 3);
    QVERIFY(std::abs(camera.estimate(Axis::Roll)) < 3);
    // On its way it has turned about one axis in space, so that it has rolled.
    const auto half = anglesOf(combined({1, 0, 0, 0}, turnBy([] {
                                            auto way = turnTo({1, 0, 0, 0}, attitudeAt({0, -25, 40}));
                                            for (double &part : way)
                                                part /= 2;
                                            return way;
                                        }())));
    QVERIFY(std::abs(half[0]) > 1);
    // Other steering ends it.
    QVERIFY(rig.channel.transact(confirmRequest(CommandId::Control, QByteArray(15, '\0'), 1)));
    QCOMPARE(rig.perform("steer.state")->value(u"mode"_s).toString(), u"off"_s);
}

void TestSbgcLater::attitudeThatIsNotReachedIsTold()
{
    SimulatorOptions blocked = withFirmware(kNewest);
    blocked.faults.blocked = 2;
    SbgcRig rig(blocked);
    const auto done = rig.perform("steer.attitude", {{u"pitch"_s, u"-25"_s}});
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::NotSeen);
    QVERIFY(rig.perform("motors.off"));
    SAYS(rig.perform("steer.attitude", {{u"pitch"_s, u"-25"_s}}), u"motors are off"_s);
}

void TestSbgcLater::attitudeIsLeftWhenItIsCancelled()
{
    SbgcRig rig(kNewest);
    rig.channel.cancelAfter(600ms);
    const auto done = rig.perform("steer.attitude",
                                  {{u"pitch"_s, u"-60"_s}, {u"speed"_s, u"20"_s}, {u"seconds"_s, u"60"_s}});
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::Cancelled);
    rig.channel.cancelAfter(100s);
    std::ignore = rig.channel.sleep(2s);
    QCOMPARE(rig.perform("steer.state")->value(u"mode"_s).toString(), u"off"_s);
    QVERIFY(rig.board().stabilizer().target(Axis::Pitch) > -30);
}

void TestSbgcLater::attitudesAreAngles_data()
{
    QTest::addColumn<QList<double>>("angles");
    QTest::addColumn<QList<double>>("parts");
    // By hand: half a turn's cosine and sine.
    QTest::newRow("level") << QList<double>{0, 0, 0} << QList<double>{1, 0, 0, 0};
    QTest::newRow("roll") << QList<double>{60, 0, 0} << QList<double>{0.8660254, 0.5, 0, 0};
    QTest::newRow("pitch") << QList<double>{0, -60, 0} << QList<double>{0.8660254, 0, -0.5, 0};
    QTest::newRow("yaw") << QList<double>{0, 0, 120} << QList<double>{0.5, 0, 0, 0.8660254};
    QTest::newRow("yaw, then roll") << QList<double>{90, 0, 90} << QList<double>{0.5, 0.5, 0.5, 0.5};
}

void TestSbgcLater::attitudesAreAngles()
{
    QFETCH(QList<double>, angles);
    QFETCH(QList<double>, parts);
    const auto attitude = attitudeAt({angles[0], angles[1], angles[2]});
    const auto back = anglesOf(attitude);
    for (int i = 0; i < 4; ++i)
        QVERIFY(std::abs(attitude[std::size_t(i)] - parts[i]) < 1e-6);
    for (int i = 0; i < 3; ++i)
        QVERIFY(std::abs(back[std::size_t(i)] - angles[i]) < 1e-4);
}

// Each axis rings at a frequency of its own, and that is where the answer is strongest.
void TestSbgcLater::plantAnswersItsStimulus_data()
{
    QTest::addColumn<QString>("axis");
    QTest::addColumn<QString>("stimulus");
    QTest::addColumn<double>("resonance");
    QTest::newRow("roll") << u"roll"_s << u"noise"_s << 55.0;
    QTest::newRow("pitch") << u"pitch"_s << u"noise"_s << 70.0;
    QTest::newRow("yaw") << u"yaw"_s << u"exponential-sweep"_s << 45.0;
}

void TestSbgcLater::plantAnswersItsStimulus()
{
    QFETCH(QString, axis);
    QFETCH(QString, stimulus);
    QFETCH(double, resonance);
    SbgcRig rig(kNewest);
    const SbgcRig::Texts test{{u"axis"_s, axis},         {u"system"_s, u"plant"_s},
                              {u"stimulus"_s, stimulus}, {u"gain"_s, u"1500"_s},
                              {u"from"_s, u"20"_s},      {u"to"_s, u"150"_s},
                              {u"seconds"_s, u"10"_s},   {u"file"_s, rig.path(u"plant.csv"_s)}};
    const auto done = rig.perform("response", test);
    DONE(done);
    QCOMPARE(done->value(u"samples"_s).toInt(), 12500);
    const double peak = done->value(u"peak.frequency"_s).toDouble();
    QVERIFY2(std::abs(peak - resonance) < 5, qPrintable(QString::number(peak)));
    QFile file(rig.path(u"plant.csv"_s));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const auto samples = readResponseCsv(file.readAll(), 0);
    DONE(samples);
    QCOMPARE(samples->rate, 1250.0);
    QCOMPARE(samples->in.size(), std::size_t(12500));
    // It is as calm as before.
    std::ignore = rig.channel.sleep(1s);
    QCOMPARE(rig.perform("state")->value(u"calibration"_s).toString(), u"none"_s);
    QVERIFY(std::abs(rig.board().stabilizer().estimate(Axis::Pitch)) < 3);
}

void TestSbgcLater::testEndsWhenItIsCancelled()
{
    SbgcRig rig(kNewest);
    rig.channel.cancelAfter(2s);
    const auto done = rig.perform(
        "response", {{u"axis"_s, u"roll"_s}, {u"seconds"_s, u"60"_s}, {u"file"_s, rig.path(u"none.csv"_s)}});
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::Cancelled);
    QVERIFY2(!done.error().detail.contains(u"without proof"_s), qPrintable(done.error().detail));
    rig.channel.cancelAfter(100s);
    QCOMPARE(rig.perform("state")->value(u"calibration"_s).toString(), u"none"_s);
    QVERIFY(!QFile::exists(rig.path(u"none.csv"_s)));
}

void TestSbgcLater::testNeedsMotors()
{
    SbgcRig rig(kNewest);
    QVERIFY(rig.perform("motors.off"));
    const SbgcRig::Texts test{{u"axis"_s, u"roll"_s}, {u"file"_s, rig.path(u"none.csv"_s)}};
    SAYS(rig.perform("response", test), u"motors are off"_s);
}

void TestSbgcLater::calibrationIsTold()
{
    SbgcRig rig(equipped(2704, {u"frame-imu"_s}));
    auto told = rig.perform("calibration");
    DONE(told);
    QCOMPARE(told->value(u"sensor"_s).toString(), u"main"_s);
    QCOMPARE(told->value(u"positions"_s).toString(), u"none"_s);
    DONE(rig.perform("calibrate.acc"));
    told = rig.perform("calibration");
    DONE(told);
    QCOMPARE(told->value(u"positions"_s).toString(), u"+Z"_s);
    QVERIFY(std::abs(told->value(u"acc.z"_s).toDouble() - rig.board().stabilizer().calibratedAcc(2)) < 0.03);
    QCOMPARE(rig.perform("calibration", {{u"imu"_s, u"frame"_s}})->value(u"sensor"_s).toString(), u"frame"_s);
    SbgcRig alone(2704);
    QVERIFY(!alone.perform("calibration", {{u"imu"_s, u"frame"_s}}));
}

void TestSbgcLater::temperaturesAreKnown()
{
    SbgcRig rig(2704, LineSettings{115200, Parity::None});  // its port stays when it restarts
    DONE(rig.perform("calibrate.gyro", {{u"action"_s, u"temperature"_s}}));
    auto told = rig.perform("calibration");
    DONE(told);
    QCOMPARE(told->value(u"range.gyro"_s).toString(), u"31 .. 31"_s);
    QCOMPARE(told->value(u"compensated"_s).toString(), u"none"_s);
    rig.board().setFaults({.heat = 44});
    DONE(rig.perform("calibrate.gyro", {{u"action"_s, u"temperature"_s}}));
    std::ignore = rig.perform("calibrate.gyro", {{u"action"_s, u"temperature-on"_s}});
    std::ignore = rig.channel.sleep(5s);
    told = rig.perform("calibration");
    DONE(told);
    QCOMPARE(told->value(u"range.gyro"_s).toString(), u"31 .. 44"_s);
    QCOMPARE(told->value(u"compensated"_s).toString(), u"gyroscope"_s);
    QCOMPARE(told->value(u"temperature"_s).toInt(), 44);
}

void TestSbgcLater::accelerometerTakesItsReference()
{
    SbgcRig rig(2704);
    const auto done = rig.perform("calibrate.acc_reference");
    DONE(done);
    QVERIFY(std::abs(done->value(u"acc.x"_s).toDouble()) < 0.02);
    QVERIFY(std::abs(done->value(u"acc.z.before"_s).toDouble() - 1) > 0.015);
    QVERIFY(std::abs(rig.board().stabilizer().calibratedAcc(2) - 1) < 0.02);
    SAYS(rig.perform("calibrate.acc_reference", {{u"z"_s, u"0.1"_s}}), u"1 g in all"_s);
}

void TestSbgcLater::referenceThatIsNotTakenIsSeen()
{
    SbgcRig rig(2704);
    rig.board().setFaults({.failWith = 10});
    const auto done = rig.perform("calibrate.acc_reference");
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::BoardError);
}

void TestSbgcLater::servosAreSetOneByOne()
{
    SbgcRig rig(kNewest);
    DONE(rig.perform("servo", {{u"servo1"_s, u"900"_s}, {u"servo2"_s, u"0"_s}}));
    DONE(rig.perform("servo.single", {{u"servo"_s, u"AUX1"_s}, {u"pulse"_s, u"1500"_s}}));
    DONE(rig.perform("servo.single", {{u"servo"_s, u"CAN7-2"_s}, {u"pulse"_s, u"1200"_s}}));
    std::ignore = rig.channel.sleep(50ms);
    QCOMPARE(rig.board().servoPulse(0), 900);
    QCOMPARE(rig.board().servoPulse(1), 0);
    QCOMPARE(rig.board().servoPulse(2), -1);
    QCOMPARE(rig.board().servoPulse(3), 1500);
    QCOMPARE(rig.perform("debug.read")->value(u"SERVO_US"_s).toList(),
             (QVariantList{900.0, 0.0, -1.0, 1500.0}));
}

void TestSbgcLater::furtherDataAreThoseOfTheWorld()
{
    SbgcRig rig(equipped(kNewest, {u"frame-imu"_s, u"magnetometer"_s}));
    const auto told = rig.perform("live");
    DONE(told);
    Stabilizer &camera = rig.board().stabilizer();
    QVERIFY(std::abs(told->value(u"frame.roll"_s).toDouble() - camera.hand().angle(Axis::Roll)) < 6);
    QVERIFY(std::abs(told->value(u"acc.frame.yaw"_s).toDouble() - 1) < 0.1);
    QVERIFY(told->value(u"magnetometer.roll"_s).toDouble() != 0);
    const double error = std::abs(camera.target(Axis::Pitch) - camera.estimate(Axis::Pitch));
    QVERIFY(std::abs(told->value(u"error.pitch"_s).toDouble() - error) < 1);
}

void TestSbgcLater::referencesAreInWords()
{
    SbgcRig rig(2704);
    const auto told = rig.perform("references");
    DONE(told);
    QCOMPARE(told->value(u"main.source.attitude"_s).toString(), u"1 (internal)"_s);
    QCOMPARE(told->value(u"external.state"_s).toString(), u"0 (off)"_s);
}

void TestSbgcLater::eventsAreTold()
{
    SbgcRig rig(2704);
    QFile file(rig.path(u"script"_s));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(QByteArray(30, 'x')) == 30);
    file.close();
    DONE(rig.perform("file.load",
                     {{u"type"_s, u"script"_s}, {u"number"_s, u"0"_s}, {u"file"_s, file.fileName()}}));
    DONE(rig.perform("script"));
    const auto told = rig.perform("events", {{u"seconds"_s, u"6"_s}});
    DONE(told);
    QCOMPARE(told->value(u"events"_s).toInt(), 1);
    QVERIFY2(told->value(u"event001"_s).toString().endsWith(u"script off"_s),
             qPrintable(told->value(u"event001"_s).toString()));
    // It has asked for them no longer than that.
    int more = 0;
    rig.channel.setTap(
        [&more](const FrameView &frame, TimePoint) { more += frame.id == number(CommandId::Event) ? 1 : 0; });
    DONE(rig.perform("motors.off"));
    std::ignore = rig.channel.sleep(500ms);
    QCOMPARE(more, 0);
}

void TestSbgcLater::gainsAreSearchedByAxis()
{
    SbgcRig rig(2738);
    const int before = rig.board().stored(u"pid.roll.p"_s, 0);
    const int yaw = rig.board().stored(u"pid.yaw.p"_s, 0);
    const auto done = rig.perform("autotune.by_axis", {{u"yaw"_s, u"off"_s}});
    DONE(done);
    QVERIFY(done->contains(u"pid.roll.p.before"_s));
    QVERIFY(rig.board().stored(u"pid.roll.p"_s, 0) != before);  // stored
    QCOMPARE(rig.board().stored(u"pid.yaw.p"_s, 0), yaw);
    SAYS(rig.perform("autotune.by_axis",
                     {{u"roll"_s, u"off"_s}, {u"pitch"_s, u"off"_s}, {u"yaw"_s, u"off"_s}}),
         u"no axis"_s);
}

void TestSbgcLater::searchByAxisEndsWhenItIsCancelled()
{
    SbgcRig rig(2738);
    const int before = rig.board().inUse(u"pid.roll.d"_s);
    rig.channel.cancelAfter(3s);
    const auto done = rig.perform("autotune.by_axis");
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::Cancelled);
    rig.channel.cancelAfter(100s);
    std::ignore = rig.channel.sleep(1s);
    QCOMPARE(rig.perform("state")->value(u"calibration"_s).toString(), u"none"_s);
    QCOMPARE(rig.board().inUse(u"pid.roll.d"_s), before);
}

// What the controller has to do against the magnets while the camera turns slowly over many of them.
void TestSbgcLater::rippleOfTheMotorsIsTakenOut()
{
    SbgcRig rig(2704);
    rig.board().setFaults({.shake = 0.01});
    Stabilizer &camera = rig.board().stabilizer();
    const auto turn = [&](double speed) {
        std::ignore = rig.channel.sleep(5s);  // it returns to where it looked
        simplebgc::Device::Control control{};
        control[2] = {Speed, speed, 0};
        const AxisMechanics &motor = camera.plant(Axis::Yaw).mechanics();
        double sine = 0;
        double cosine = 0;
        const int samples = int(std::lround(5 * 360 / motor.poles / std::abs(speed) / 0.004));
        for (int i = 0; i < samples; ++i) {
            rig.channel.steer(rig.device.controlFrames(control));
            std::ignore = rig.channel.sleep(4ms);
            const double phase = radians(camera.jointAngle(Axis::Yaw)) * motor.poles;
            sine += camera.command(Axis::Yaw) * std::sin(phase);
            cosine += camera.command(Axis::Yaw) * std::cos(phase);
        }
        rig.channel.releaseControl();
        return 2 * std::hypot(sine, cosine) / samples;
    };
    const auto effort = [&turn] {
        const double there = turn(10);
        return (there + turn(-10)) / 2;
    };
    const double before = effort();
    DONE(rig.perform("calibrate.cogging", {{u"iterations"_s, u"6"_s}}));
    const double learned = effort();
    QVERIFY2(learned < 0.7 * before, qPrintable(u"%1 %2"_s.arg(before).arg(learned)));
    DONE(rig.perform("calibrate.cogging", {{u"action"_s, u"forget"_s}}));
    const double forgotten = effort();
    QVERIFY2(forgotten > 1.4 * learned, qPrintable(u"%1 %2"_s.arg(forgotten).arg(learned)));
    SAYS(rig.perform("calibrate.cogging",
                     {{u"roll"_s, u"off"_s}, {u"pitch"_s, u"off"_s}, {u"yaw"_s, u"off"_s}}),
         u"no axis"_s);
}

void TestSbgcLater::variablesAreListed()
{
    SbgcRig rig(2738);
    const auto told = rig.perform("variables.list");
    DONE(told);
    QCOMPARE(told->size() % 2, 0);
    const auto all = rig.device.adjustables();
    QVERIFY(told->size() / 2 >= int(all.size()));
    const auto plain = rig.perform("variables.read", {{u"ids"_s, u"0,3"_s}});
    const auto real = rig.perform("variables.read", {{u"ids"_s, u"0,3"_s}, {u"real"_s, u"on"_s}});
    DONE(plain);
    DONE(real);
    QCOMPARE(real->value(u"3"_s).toDouble(), plain->value(u"3"_s).toDouble());
    QCOMPARE(real->size(), 2);
}

void TestSbgcLater::statisticsBeginAnew()
{
    SbgcRig rig(2704);
    std::ignore = rig.channel.sleep(30s);
    QVERIFY(rig.perform("statistics")->value(u"work"_s).toInt() >= 30);
    const auto done = rig.perform("statistics.reset");
    DONE(done);
    QCOMPARE(done->value(u"starts"_s).toInt(), 0);
    QVERIFY(done->value(u"work"_s).toInt() <= 1);
}

void TestSbgcLater::signalIsGivenInFinerSteps()
{
    SbgcRig rig(2704);
    QCOMPARE(simplebgc::Device::channelFrames({33.337}, true).setpoint.mid(4, 4).toHex(),
             QByteArray("5615"
                        "0080"));
    rig.board().store(u"rc.map.pitch"_s, 0, 129);
    QVERIFY(rig.channel.transact(silentRequest(CommandId::ApiVirtChHighRes, hex("5615"), 1)));
    std::ignore = rig.channel.sleep(20ms);
    QVERIFY(std::abs(rig.perform("signals")->value(u"rc.map.pitch"_s).toDouble() - 33.337) < 0.01);
    DONE(rig.perform("channel", {{u"channel"_s, u"1"_s}, {u"value"_s, u"20"_s}, {u"fine"_s, u"on"_s}}));
}

void TestSbgcLater::whatIsSentIsAsTheErrataSay_data()
{
    using Texts = SbgcRig::Texts;
    QTest::addColumn<QString>("key");
    QTest::addColumn<Texts>("texts");
    QTest::addColumn<QStringList>("sent");
    const auto row = [](const char *key, const Texts &texts, const QStringList &sent) {
        QTest::newRow(key) << QString::fromLatin1(key) << texts << sent;
    };
    row("steer.limits", {{u"timeout"_s, u"0.5"_s}, {u"roll"_s, u"50"_s}, {u"yaw"_s, u"900"_s}},
        {u"CONTROL_CONFIG"_s});
    row("steer.attitude", {{u"pitch"_s, u"60"_s}},
        {u"CONTROL_QUAT_CONFIG"_s, u"CONTROL_QUAT"_s, u"CONTROL_QUAT_STATUS"_s});
    row("response",
        {{u"axis"_s, u"yaw"_s},
         {u"system"_s, u"plant"_s},
         {u"stimulus"_s, u"sweep"_s},
         {u"gain"_s, u"1500"_s},
         {u"from"_s, u"20"_s},
         {u"seconds"_s, u"4"_s},
         {u"file"_s, u"/nowhere/at/all"_s}},
        {u"BODE_TEST_START_STOP"_s});
    row("calibrate.acc_reference", {{u"x"_s, u"0.5"_s}, {u"y"_s, u"-0.5"_s}, {u"z"_s, u"0.7"_s}},
        {u"CALIB_ACC_EXT_REF"_s});
    row("calibrate.cogging", {{u"action"_s, u"forget"_s}, {u"roll"_s, u"off"_s}, {u"pitch"_s, u"off"_s}},
        {u"CALIB_COGGING"_s});
    row("servo.single", {{u"servo"_s, u"CAN7-2"_s}, {u"pulse"_s, u"1200"_s}}, {u"SERVO_OUT_EXT"_s});
    row("variables.read", {{u"ids"_s, u"0,3"_s}, {u"real"_s, u"on"_s}}, {u"GET_ADJ_VARS_VAL_F"_s});
    row("calibration", {{u"imu"_s, u"frame"_s}}, {u"CALIB_INFO"_s});
    row("live", {}, {u"REALTIME_DATA_CUSTOM2"_s});
    row("autotune.by_axis", {{u"roll"_s, u"off"_s}, {u"pitch"_s, u"off"_s}, {u"yaw"_s, u"off"_s}},
        {u"AUTO_PID2"_s});
}

// Bytes worked out by tests/support/sbgcvectors.py, whatever comes of them.
void TestSbgcLater::whatIsSentIsAsTheErrataSay()
{
    QFETCH(QString, key);
    QFETCH(SbgcRig::Texts, texts);
    QFETCH(QStringList, sent);
    SbgcRig rig(kNewest);
    QStringList seen;
    Altering channel(rig.channel, [&](const Request &request, const Altering::Pass &pass) {
        const QByteArray payload = request.bytes.mid(4).chopped(1).toHex();
        for (const SbgcVector &vector : kSbgcVectors) {
            if (vector.way == '>' && request.name == QLatin1String(vector.name) && payload == vector.hex
                && !seen.contains(request.name))
                seen.append(request.name);
        }
        return pass(request);
    });
    std::ignore = rig.device.perform(channel, key, argumentsFor(rig.device, qPrintable(key), texts));
    for (const QString &name : sent)
        QVERIFY2(seen.contains(name), qPrintable(name));
}

void TestSbgcLater::earlierFirmwareHasNoneOfIt()
{
    SbgcRig rig(2590);
    for (const char *key : {"steer.attitude", "steer.state", "steer.limits", "response", "calibration",
                            "live", "calibrate.acc_reference", "variables.list", "statistics.reset",
                            "servo.single", "references", "events", "autotune.by_axis"})
        QVERIFY2(!isOffered(rig, key), key);
}

QTEST_GUILESS_MAIN(TestSbgcLater)
#include "tst_sbgclater.moc"
