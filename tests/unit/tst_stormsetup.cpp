// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/storm32/commands.h"
#include "protocol/storm32/files.h"
#include "protocol/storm32/orientations.h"
#include "protocol/storm32/parametertables.h"
#include "tests/support/channelproxy.h"
#include "tests/support/stormrig.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace storm32;

namespace {

std::shared_ptr<const ParameterSet> parametersOf(const BoardIdentity &identity)
{
    return storm32::family().makeParameters(identity);
}

Configuration readBoard(StormRig &rig)
{
    return rig.device.readConfiguration(rig.channel).value();
}

/// The answer to one of the questions for a single stored value gets lost.
class AnswerLost final : public ChannelProxy
{
public:
    AnswerLost(Channel &channel, int which)
        : ChannelProxy(channel)
        , m_which(which)
    {
    }
    Result<Frame> transact(const Request &request) override
    {
        auto answer = ChannelProxy::transact(request);
        if (request.name != u"RESTOREPARAMETER"_s || --m_which != 0)
            return answer;
        return failure(ErrorCode::Timeout, request.name);
    }

private:
    int m_which;
};

}  // namespace

/// Setting up a STorM32 gimbal: calibration, configuration tasks, scripts and files, against the simulated
/// board.
class TestStormSetup : public QObject
{
    Q_OBJECT
private slots:
    void sensorIsAveraged();
    void onePositionFindsTheZeros_data();
    void onePositionFindsTheZeros();
    void sixPositionsFindZerosAndScales_data();
    void sixPositionsFindZerosAndScales();
    void motorsAreOffBetweenPositions_data() { sixPositionsFindZerosAndScales_data(); }
    void motorsAreOffBetweenPositions();
    void motorsThatMayRunStopIt();
    void orientationNeedsDisabledMotors();
    void movingSensorIsNotMeasured();
    void impossibleReadingIsNotTaken_data();
    void impossibleReadingIsNotTaken();
    void missingSensorIsSaid();
    void badCalibrationIsNotStored();
    void orientationIsFound_data();
    void orientationIsFound();
    void bothOrientationsAreFound_data();
    void bothOrientationsAreFound();
    void frameSensorIsCalibrated();
    void wrongOrientationMisleadsTheBoard();
    void orientationIsNotGuessed();
    void motorsAreSetUp();
    void startWaitsForTheBattery();
    void yawIsAligned();
    void storedIsComparedWithUse();
    void comparingLosesNothing();
    void valuesArriveOrAreReported();
    void scriptsAreWrittenLikeValues();
    void scriptsChangedByOthersAreAConflict();
    void scriptsOfABackupComeBack();
    void settingsFileComesBack_data();
    void settingsFileComesBack();
    void settingsOfAnotherLayoutAreUnderstood();
    void settingsThatNobodyMaySetAreTold();
    void settingsOfLayout89KeepTheirNames_data();
    void settingsOfLayout89KeepTheirNames();
    void settingsThatAreMissingStay();
    void badSettingsAreRefused_data();
    void badSettingsAreRefused();
    void calibrationFileComesBack();
};

void TestStormSetup::sensorIsAveraged()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.change(u"pose=1"_s);
    const auto reply
        = rig.device.perform(rig.channel, u"sensors.average"_s, {{u"imu"_s, 1}, {u"readings"_s, 64}});
    QVERIFY(reply);
    QCOMPARE(reply->value(u"one_g"_s).toDouble(), 8192.0);
    QCOMPARE(reply->value(u"face"_s).toInt(), 0);
    QVERIFY(std::abs(reply->value(u"z"_s).toDouble() - 8192 * (1.02 + 0.02))
            < 20);  // the simulated sensor's own error
    QVERIFY(reply->value(u"deviation"_s).toDouble() > 5 && reply->value(u"deviation"_s).toDouble() < 60);
    QVERIFY(std::abs(reply->value(u"temperature"_s).toDouble() - 31.0) < 0.1);
}

void TestStormSetup::onePositionFindsTheZeros_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<int>("mount");
    QTest::newRow("0.79") << 79 << 0;
    QTest::newRow("0.96") << 96 << 0;
    QTest::newRow("0.96, turned") << 96 << 5;
}

void TestStormSetup::onePositionFindsTheZeros()
{
    QFETCH(int, firmware);
    QFETCH(int, mount);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    rig.change(u"mount=%1"_s.arg(mount));
    rig.board().set(39, mount);
    rig.change(u"pose=1"_s);
    const auto reply
        = rig.device.perform(rig.channel, u"calibrate.level"_s, {{u"imu"_s, 1}, {u"store"_s, true}});
    QVERIFY(reply);
    QVERIFY(reply->value(u"stored"_s).toBool() && reply->value(u"plausible"_s).toBool());
    QVERIFY(rig.channel.sleep(2s));
    // What the board itself takes for level now.
    const auto &acc = rig.board().stabilizer().acc();
    QVERIFY2(std::abs(acc[0]) < 0.02 && std::abs(acc[1]) < 0.02,
             qPrintable(u"%1 %2"_s.arg(acc[0]).arg(acc[1])));
}

void TestStormSetup::sixPositionsFindZerosAndScales_data()
{
    QTest::addColumn<int>("firmware");
    for (const int firmware : {79, 90, 96})
        QTest::addRow("0.%d", firmware) << firmware;
}

// The operator lays the sensor on one face after the other, in an order of his own.
void TestStormSetup::sixPositionsFindZerosAndScales()
{
    QFETCH(int, firmware);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    rig.layOn({3, 1, 6, 2, 5, 4});
    const auto reply
        = rig.device.perform(rig.channel, u"calibrate.six"_s, {{u"imu"_s, 1}, {u"store"_s, true}});
    QVERIFY2(reply, reply ? "" : qPrintable(reply.error().detail));
    const double one = firmware >= 94 ? 8192 : 16384;
    // The simulated sensor: forward is its y with an error of -0.028 g and 0.975 per g, and so on.
    QVERIFY(std::abs(reply->value(u"scale.x"_s).toDouble() / one - 0.975) < 0.003);
    QVERIFY(std::abs(reply->value(u"zero.x"_s).toDouble() / one + 0.028) < 0.003);
    QVERIFY(std::abs(reply->value(u"scale.z"_s).toDouble() / one - 1.02) < 0.003);
    QVERIFY(reply->value(u"quality"_s).toDouble() < 0.005);
    rig.change(u"pose=3"_s);
    QVERIFY(rig.channel.sleep(2s));
    const auto &acc = rig.board().stabilizer().acc();
    QVERIFY(std::abs(acc[1] - 1.0) < 0.02 && std::abs(acc[0]) < 0.02 && std::abs(acc[2]) < 0.02);
}

// Whoever asks for it: the sensor is turned over by hand, and somebody may switch the motors on meanwhile.
void TestStormSetup::motorsAreOffBetweenPositions()
{
    QFETCH(int, firmware);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(rig.board().stabilizer().motorsOn());
    QList<int> poses{3, 1, 6, 2, 5, 4};
    rig.change(u"pose=%1"_s.arg(poses.takeFirst()));
    int done = 0;
    int asked = 0;
    int running = 0;
    rig.channel.setOperator([&](const Progress &progress) {
        ++asked;
        running += rig.board().stabilizer().motorsOn();
        if (progress.done == std::exchange(done, progress.done) || poses.isEmpty())
            return;
        rig.change(u"pose=%1"_s.arg(poses.takeFirst()));
        rig.board().receive(asBytes(encodeRc(int(Rc::SetStandby), QByteArray(1, '\0'))));
        rig.board().cycle();
    });
    const auto reply
        = rig.device.perform(rig.channel, u"calibrate.six"_s, {{u"imu"_s, 1}, {u"store"_s, true}});
    QVERIFY2(reply, reply ? "" : qPrintable(reply.error().detail));
    QVERIFY(asked > 50);
    QCOMPARE(running, 0);
    QVERIFY(reply->value(u"stored"_s).toBool() && reply->value(u"motors_switched_off"_s).toBool());
    QVERIFY(!rig.board().stabilizer().motorsOn());  // nobody starts them while the camera is in a hand
}

void TestStormSetup::motorsThatMayRunStopIt()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.change(u"deaf=115"_s);  // the letter of the status: nothing tells what standby did
    rig.layOn({1, 2, 3, 4, 5, 6});
    const auto reply
        = rig.device.perform(rig.channel, u"calibrate.six"_s, {{u"imu"_s, 1}, {u"store"_s, true}});
    QVERIFY(!reply);
    QCOMPARE(reply.error().code, ErrorCode::NotProven);
    QVERIFY(rig.channel.progressReports().empty());  // no position was asked for
}

void TestStormSetup::orientationNeedsDisabledMotors()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    const auto refused = rig.device.perform(rig.channel, u"setup.orientation"_s, {});
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::ConditionUnmet);
}

void TestStormSetup::movingSensorIsNotMeasured()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.change(u"pose=1"_s);
    int turns = 0;
    rig.channel.setOperator([&](const Progress &) { rig.change(u"pose=%1"_s.arg(++turns % 2 ? 3 : 1)); });
    const auto reply
        = rig.device.perform(rig.channel, u"calibrate.level"_s, {{u"imu"_s, 1}, {u"store"_s, true}});
    QVERIFY(!reply);
    QCOMPARE(reply.error().code, ErrorCode::NotSeen);
}

void TestStormSetup::impossibleReadingIsNotTaken_data()
{
    QTest::addColumn<QString>("action");
    QTest::newRow("one position") << u"calibrate.level"_s;
    QTest::newRow("six positions") << u"calibrate.six"_s;
    QTest::newRow("orientation") << u"setup.orientation"_s;
}

// It lies still and measures what no sensor at rest does: nothing of it is stored, or found.
void TestStormSetup::impossibleReadingIsNotTaken()
{
    QFETCH(QString, action);
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(rig.device.perform(rig.channel, u"setup.motors_off"_s, {}));
    rig.change(u"pose=1"_s);
    rig.board().stabilizer().imu().accError = {0, 0, 0.4};
    const auto before = rig.device.perform(rig.channel, u"calibration.read"_s, {});
    const TimePoint begun = rig.channel.now();
    const auto reply = rig.device.perform(rig.channel, action, {{u"imu"_s, 1}, {u"store"_s, true}});
    QVERIFY(!reply);
    QCOMPARE(reply.error().code, ErrorCode::NotSeen);
    QVERIFY2(reply.error().detail.contains(u"1.42 g instead of 1 g"_s), qPrintable(reply.error().detail));
    QCOMPARE(rig.device.perform(rig.channel, u"calibration.read"_s, {}), before);
    if (action == u"calibrate.level"_s)
        QVERIFY(rig.channel.now() - begun < 10s);
    for (const Progress &progress : rig.channel.progressReports())
        QVERIFY(progress.step != u"calibrate"_s);
}

void TestStormSetup::missingSensorIsSaid()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    const auto second
        = rig.device.perform(rig.channel, u"calibrate.level"_s, {{u"imu"_s, 2}, {u"store"_s, true}});
    QVERIFY(!second);
    QCOMPARE(second.error().code, ErrorCode::NotSeen);
    QVERIFY(second.error().detail.contains(u"Imu2"_s));
    rig.change(u"no-imu=1"_s);
    const auto first = rig.device.perform(rig.channel, u"setup.orientation"_s, {});
    QVERIFY(!first);
    QVERIFY(first.error().detail.contains(u"no sensor"_s));
    const auto raw = rig.device.perform(rig.channel, u"sensors.raw"_s, {});
    QVERIFY(raw && !raw->contains(u"imu.acc.x"_s));
    QCOMPARE(raw->value(u"imu"_s).toString(), u"missing"_s);
}

void TestStormSetup::badCalibrationIsNotStored()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.board().stabilizer().imu().accScaleError = {1.14, 1.14, 1.14};  // a sensor that is broken
    rig.layOn({1, 2, 3, 4, 5, 6});
    const auto before = rig.device.perform(rig.channel, u"calibration.read"_s, {});
    const auto reply
        = rig.device.perform(rig.channel, u"calibrate.six"_s, {{u"imu"_s, 1}, {u"store"_s, true}});
    QVERIFY(!reply);
    QCOMPARE(reply.error().code, ErrorCode::OutOfRange);
    QCOMPARE(rig.device.perform(rig.channel, u"calibration.read"_s, {}), before);
}

void TestStormSetup::orientationIsFound_data()
{
    QTest::addColumn<int>("mount");
    for (int mount = 0; mount < int(orientations().size()); ++mount)
        QTest::addRow("%s", orientations()[std::size_t(mount)].name) << mount;
}

void TestStormSetup::orientationIsFound()
{
    QFETCH(int, mount);
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.change(u"mount=%1"_s.arg(mount));
    rig.change(u"pose=1"_s);
    QVERIFY(rig.device.perform(rig.channel, u"setup.motors_off"_s, {}));
    QCOMPARE(rig.board().inUse(79), 3);
    rig.channel.setOperator([&](const Progress &progress) {
        if (progress.step == u"tilt-camera"_s)
            rig.change(u"pose=7"_s);
    });
    const auto reply = rig.device.perform(rig.channel, u"setup.orientation"_s, {});
    QVERIFY2(reply, reply ? "" : qPrintable(reply.error().detail));
    QCOMPARE(rig.board().inUse(39), mount);
    QCOMPARE(reply->value(u"imu"_s).toString(), QString::fromUtf8(orientations()[std::size_t(mount)].name));
    // With it the board sees how the camera really lies: 45 degrees down.
    QVERIFY(rig.channel.sleep(15s));
    QVERIFY(std::abs(rig.board().stabilizer().estimate(Axis::Pitch) - 45.0) < 4.0);
    QVERIFY(std::abs(rig.board().stabilizer().estimate(Axis::Roll)) < 4.0);
}

void TestStormSetup::bothOrientationsAreFound_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<int>("mount");
    QTest::addColumn<int>("frameMount");
    QTest::newRow("0.79") << 79 << 3 << 20;
    QTest::newRow("0.90") << 90 << 5 << 14;
    QTest::newRow("0.96") << 96 << 13 << 2;
    QTest::newRow("0.96, frame on its side") << 96 << 0 << 9;
    QTest::newRow("0.96, the same way") << 96 << 22 << 22;
}

void TestStormSetup::bothOrientationsAreFound()
{
    QFETCH(int, firmware);
    QFETCH(int, mount);
    QFETCH(int, frameMount);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    rig.board().set(94, 1);
    rig.change(u"mount=%1"_s.arg(mount));
    rig.change(u"frame-mount=%1"_s.arg(frameMount));
    rig.change(u"pose=1"_s);
    QVERIFY(rig.device.perform(rig.channel, u"setup.motors_off"_s, {}));
    double tiltedAfter = 0;
    rig.channel.setOperator([&](const Progress &progress) {
        if (progress.step == u"tilt-camera"_s && rig.options.faults.pose == 1) {
            tiltedAfter = rig.board().now();
            rig.change(u"pose=7"_s);
        }
    });
    const auto reply = rig.device.perform(rig.channel, u"setup.orientation"_s, {});
    QVERIFY2(reply, reply ? "" : qPrintable(reply.error().detail));
    QVERIFY(tiltedAfter > 0.9);  // level for a second, both
    QCOMPARE(rig.board().inUse(39), mount);
    QCOMPARE(rig.board().inUse(95), frameMount);
    QCOMPARE(reply->value(u"imu2"_s).toString(),
             QString::fromUtf8(orientations()[std::size_t(frameMount)].name));
    // With it the board sees how the frame lies: 45 degrees down, but for what its sensor's own error makes.
    const auto data = rig.channel.transact(simpleRequest(Simple::LiveData));
    QVERIFY(data);
    ByteReader words(QByteArrayView(data->payload).sliced(2 * 25));
    QVERIFY(std::abs(words.i16() - 4500) < 300);
    QVERIFY(std::abs(words.i16()) < 300);
}

void TestStormSetup::frameSensorIsCalibrated()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.board().set(94, 1);
    rig.change(u"frame-mount=5"_s);
    rig.board().set(95, 5);
    rig.layOn({2, 1, 6, 3, 4, 5});
    const auto before = rig.device.perform(rig.channel, u"calibration.read"_s, {}).value();
    const auto reply
        = rig.device.perform(rig.channel, u"calibrate.six"_s, {{u"imu"_s, 2}, {u"store"_s, true}});
    QVERIFY2(reply, reply ? "" : qPrintable(reply.error().detail));
    // The simulated sensor: x shows 0.99 per g and 0.015 g too much.
    QVERIFY(std::abs(reply->value(u"scale.x"_s).toDouble() / 8192 - 0.99) < 0.003);
    QVERIFY(std::abs(reply->value(u"zero.x"_s).toDouble() / 8192 - 0.015) < 0.003);
    rig.change(u"pose=1"_s);
    QVERIFY(rig.channel.sleep(100ms));
    const auto data = rig.channel.transact(simpleRequest(Simple::LiveData));
    QVERIFY(data);
    ByteReader words(QByteArrayView(data->payload).sliced(2 * 25));
    QVERIFY(std::abs(words.i16()) < 30);
    QVERIFY(std::abs(words.i16()) < 30);
    // The camera's own was not touched.
    const auto after = rig.device.perform(rig.channel, u"calibration.read"_s, {}).value();
    for (const QString &key : before.keys()) {
        if (!key.startsWith(u"imu2"_s))
            QCOMPARE(after.value(key), before.value(key));
    }
    QVERIFY(after != before);
}

void TestStormSetup::wrongOrientationMisleadsTheBoard()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.change(u"pose=7"_s);
    rig.board().set(39, 1);  // a quarter turn about the vertical: pitch is taken for roll
    QVERIFY(rig.channel.sleep(4s));
    QVERIFY(std::abs(rig.board().stabilizer().estimate(Axis::Pitch)) < 5.0);
    QVERIFY(std::abs(rig.board().stabilizer().estimate(Axis::Roll)) > 30.0);
}

void TestStormSetup::orientationIsNotGuessed()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.change(u"pose=1"_s);  // level, and never tilted
    QVERIFY(rig.device.perform(rig.channel, u"setup.motors_off"_s, {}));
    const int before = rig.board().inUse(39);
    const auto reply = rig.device.perform(rig.channel, u"setup.orientation"_s, {});
    QVERIFY(!reply);
    QCOMPARE(reply.error().code, ErrorCode::NotSeen);
    QVERIFY(reply.error().detail.contains(u"45"_s));
    QCOMPARE(rig.board().inUse(39), before);
}

void TestStormSetup::motorsAreSetUp()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(rig.device.perform(rig.channel, u"setup.motors_off"_s, {}));
    QVERIFY(rig.device.perform(rig.channel, u"setup.directions"_s, {{u"direction"_s, 2}}));
    QCOMPARE(rig.board().inUse(21), 2);
    QVERIFY(!rig.device.perform(rig.channel, u"setup.poles"_s,
                                {{u"pitch"_s, 15}, {u"roll"_s, 14}, {u"yaw"_s, 14}}));
    QVERIFY(rig.device.perform(rig.channel, u"setup.poles"_s,
                               {{u"pitch"_s, 16},
                                {u"roll"_s, 14},
                                {u"yaw"_s, 14}}));  // set up before the start, and still so after it
    const auto started = rig.device.perform(rig.channel, u"setup.start"_s, {});
    QVERIFY2(started, started ? "" : qPrintable(started.error().detail));
    QCOMPARE(started->value(u"state"_s).toString(), u"normal"_s);
    QCOMPARE(rig.board().inUse(78), 0);
    QCOMPARE(rig.board().inUse(20), 16);
    rig.board().set(20, 14);
    rig.board().set(23, 0);
    const auto taken = rig.device.perform(rig.channel, u"setup.take_motors"_s,
                                          {{u"directions"_s, true}, {u"positions"_s, true}});
    QVERIFY(taken);
    QCOMPARE(taken->value(u"direction.roll"_s).toString(), u"normal"_s);
    QCOMPARE(rig.board().inUse(21), 0);
    QCOMPARE(taken->value(u"start.pitch"_s).toInt(), rig.board().inUse(23));
    QVERIFY(std::abs(rig.board().inUse(23) - 504) < 60);
    QCOMPARE(rig.board().stored(21), 0);
    QVERIFY(rig.device.perform(rig.channel, u"store"_s, {}));
    QCOMPARE(rig.board().stored(23), rig.board().inUse(23));
}

void TestStormSetup::startWaitsForTheBattery()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.change(u"battery=7"_s);
    int waits = 0;
    rig.channel.setOperator([&](const Progress &progress) {
        if (progress.step == u"wait-battery"_s && ++waits == 20)
            rig.change(u"battery=12"_s);
    });
    QVERIFY(rig.device.perform(rig.channel, u"setup.start"_s, {}));
    QCOMPARE(waits, 20);
    rig.change(u"battery=7"_s);
    rig.channel.setOperator({});
    const auto never = rig.device.perform(rig.channel, u"setup.start"_s, {});
    QVERIFY(!never);
    QVERIFY(never.error().detail.contains(u"battery is low"_s));
}

void TestStormSetup::yawIsAligned()
{
    StormRig rig;
    rig.change(u"shake=0"_s);
    QVERIFY(rig.device.identify(rig.channel));
    rig.board().set(61, 65536 - 300);
    rig.board().set(66, 1);  // hold all axes
    QVERIFY(!rig.device.perform(rig.channel, u"setup.yaw_move"_s, {{u"angle"_s, 5.0}}));
    QVERIFY(rig.device.perform(rig.channel, u"setup.yaw_begin"_s, {}));
    QCOMPARE(rig.board().inUse(61), 65536 - 450);
    QVERIFY(rig.device.perform(rig.channel, u"setup.yaw_begin"_s, {}));  // twice is not twice remembered
    QVERIFY(rig.device.perform(rig.channel, u"setup.yaw_move"_s, {{u"angle"_s, 10.0}}));
    QVERIFY(rig.channel.sleep(3s));
    const int before = rig.board().inUse(35);
    const auto end = rig.device.perform(rig.channel, u"setup.yaw_end"_s, {{u"take"_s, true}});
    QVERIFY(end);
    QVERIFY(rig.board().inUse(35) != before);
    QCOMPARE(end->value(u"start.yaw"_s).toInt(), rig.board().inUse(35));
    QCOMPARE(rig.board().inUse(61), 65536 - 300);
    QCOMPARE(rig.board().inUse(108), 0);
}

void TestStormSetup::storedIsComparedWithUse()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    auto reply = rig.device.perform(rig.channel, u"stored.compare"_s, {});
    QVERIFY(reply);
    QCOMPARE(reply->value(u"unstored"_s).toBool(), false);
    rig.board().set(0, 444);
    reply = rig.device.perform(rig.channel, u"stored.compare"_s, {});
    QVERIFY(reply);
    QCOMPARE(reply->value(u"unstored"_s).toBool(), true);
    QCOMPARE(reply->value(u"pid.pitch.p"_s).toString(), u"4.44 in use, 4.00 stored"_s);
    QCOMPARE(rig.board().inUse(0), 444);  // nothing was changed by asking
    QCOMPARE(rig.board().stored(0), 400);
}

// A line that damages every tenth frame: what was in use is in use again, or the operator is told what it
// was.
void TestStormSetup::comparingLosesNothing()
{
    int compared = 0;
    for (unsigned seed = 1; seed <= 30; ++seed) {
        SimulatorOptions options = stormOptions(96);
        options.seed = seed;
        options.faults.loseByte = options.faults.flipByte = 0.001;
        StormRig rig(options);
        if (!rig.device.identify(rig.channel))
            continue;
        rig.board().set(0, 444);
        const auto reply = rig.device.perform(rig.channel, u"stored.compare"_s, {});
        compared += reply.has_value();
        if (reply)
            QCOMPARE(rig.board().inUse(0), 444);
        else if (rig.board().inUse(0) != 444)
            QVERIFY2(reply.error().code == ErrorCode::NotRestored
                         && reply.error().detail.contains(u"pid.pitch.p=4.44"_s),
                     qPrintable(reply.error().detail));
    }
    QVERIFY2(compared >= 20, qPrintable(QString::number(compared)));
    // The line dies after each of the answers.
    int died = 0;
    for (bool isWhole = false; !isWhole; ++died) {
        StormRig rig;
        QVERIFY(rig.device.identify(rig.channel));
        rig.board().set(0, 444);
        rig.channel.setTap([&, frames = 0](const FrameView &, TimePoint) mutable {
            if (frames++ == died)
                QVERIFY(rig.port.change(u"lose=1"_s));
        });
        const auto reply = rig.device.perform(rig.channel, u"stored.compare"_s, {});
        isWhole = reply.has_value();
        if (isWhole || rig.board().inUse(0) == 444)
            continue;
        // As stored, or marked to see it go.
        QVERIFY2(rig.board().inUse(0) == 400 || rig.board().inUse(0) == 443,
                 qPrintable(QString::number(rig.board().inUse(0))));
        QCOMPARE(reply.error().code, ErrorCode::NotRestored);
        QVERIFY2(reply.error().detail.contains(u"pid.pitch.p=4.44"_s), qPrintable(reply.error().detail));
    }
    QVERIFY2(died > 8, qPrintable(QString::number(died)));
    // The answer to the question for one word is lost: a motor that is stored as disabled runs on.
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.board().set(79, 3);
    QVERIFY(rig.device.perform(rig.channel, u"store"_s, {}));
    rig.board().set(79, 0);
    AnswerLost channel(rig.channel, 2);
    QVERIFY(!rig.device.perform(channel, u"stored.compare"_s, {}));
    QCOMPARE(rig.board().inUse(79), 0);
}

// The firmware looks at no checksum of these frames: a value that is said to be set is set.
void TestStormSetup::valuesArriveOrAreReported()
{
    int set = 0;
    for (unsigned seed = 1; seed <= 10; ++seed) {
        SimulatorOptions options = stormOptions(96);
        options.seed = seed;
        options.faults.flipByte = 0.004;
        StormRig rig(options);
        if (!rig.device.identify(rig.channel))
            continue;
        for (int value = 300; value < 340; ++value) {
            const auto done = rig.device.writeAdjustables(rig.channel, {{1, double(value)}});
            if (done)
                QCOMPARE(rig.board().inUse(1), value);
            set += done.has_value();
        }
    }
    QVERIFY2(set > 300, qPrintable(QString::number(set)));
}

void TestStormSetup::scriptsAreWrittenLikeValues()
{
    QTemporaryDir dir;
    const BoardHistory history(dir.path());
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    const Configuration base = readBoard(rig);
    const auto language = storm32::family().scripts;
    const auto code
        = language->compile(base, {u"WAIT 5\nDORECENTER"_s, u""_s, u""_s, u"SET \"Pitch P\" 500"_s});
    QVERIFY(code);
    Configuration edited = base;
    edited.setBlock({0, Scripts}, *code);
    QVERIFY(edited.setRaw(*edited.parameters().find(u"pid.roll.p"_s), 0, 410));
    const auto report = writeConfiguration(rig.channel, rig.device, base, edited, {&history, false, {}});
    QVERIFY(report && report->isComplete());
    QCOMPARE(report->count(WriteState::Verified), 2);
    QVERIFY(!report->snapshotPath.isEmpty());
    const Configuration now = readBoard(rig);
    QCOMPARE(now.block({0, Scripts}), *code);
    QCOMPARE(language->text(now, 0).split(u'\n').first().trimmed(), u"WAIT 5"_s);
    QVERIFY(language->text(now, 1).isEmpty());
    QVERIFY(language->listing(now, 3).front().text.contains(u"Pitch P"_s));
    QCOMPARE(language->used(now), (std::pair{5 + 6, 124}));
    // Stored as well: a restart has them.
    QVERIFY(rig.device.perform(rig.channel, u"restart"_s, {}));
    QCOMPARE(readBoard(rig).block({0, Scripts}), *code);
    const auto wrong = language->compile(base, {u"WAIT 5"_s, u"FLY"_s});
    QVERIFY(!wrong);
    QVERIFY2(wrong.error().error().detail.contains(u"script 2, line 1"_s),
             qPrintable(wrong.error().error().detail));
}

void TestStormSetup::scriptsChangedByOthersAreAConflict()
{
    QTemporaryDir dir;
    const BoardHistory history(dir.path());
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    const Configuration base = readBoard(rig);
    Configuration edited = base;
    Configuration others = base;
    edited.setBlock({0, Scripts}, storm32::family().scripts->compile(base, {u"WAIT 5"_s}).value());
    others.setBlock({0, Scripts}, storm32::family().scripts->compile(base, {u"WAIT 6"_s}).value());
    QVERIFY(writeConfiguration(rig.channel, rig.device, base, others, {&history, false, {}}));
    const auto report = writeConfiguration(rig.channel, rig.device, base, edited, {&history, false, {}});
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::Conflict);
    QCOMPARE(readBoard(rig).block({0, Scripts}), others.block({0, Scripts}));
}

void TestStormSetup::scriptsOfABackupComeBack()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    const Configuration empty = readBoard(rig);
    Configuration saved = empty;
    saved.setBlock({0, Scripts}, storm32::family().scripts->compile(empty, {u"WAIT 5"_s}).value());
    const auto file = ConfigurationFile::fromJson(ConfigurationFile::toJson(saved, {}, {}), parametersOf);
    QVERIFY(file);
    QStringList skipped;
    QCOMPARE(applied(empty, file->configuration, skipped).block({0, Scripts}), saved.block({0, Scripts}));
    QVERIFY(skipped.isEmpty());
    // On a board of another layout they would mean something else.
    StormRig old(stormOptions(79));
    QVERIFY(old.device.identify(old.channel));
    const Configuration other = readBoard(old);
    QCOMPARE(applied(other, file->configuration, skipped).block({0, Scripts}), other.block({0, Scripts}));
    QVERIFY(skipped.contains(u"Scripts"_s));
}

void TestStormSetup::settingsFileComesBack_data()
{
    QTest::addColumn<int>("firmware");
    for (const int firmware : {79, 90, 96})
        QTest::addRow("0.%d", firmware) << firmware;
}

void TestStormSetup::settingsFileComesBack()
{
    QFETCH(int, firmware);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    Configuration board = readBoard(rig);
    QVERIFY(board.setRaw(*board.parameters().find(u"motor.pitch.offset"_s), 0, -250));
    QVERIFY(board.setRaw(*board.parameters().find(u"pan.mode.setting1"_s), 0, 3));
    board.setBlock({0, Scripts}, storm32::family().scripts->compile(board, {u"WAIT 5"_s}).value());
    const auto text = writeSettings(board);
    QVERIFY(text);
    QVERIFY(text->startsWith("%SettingsHash = (\n"));
    QVERIFY(text->endsWith(");\n"));
    QVERIFY2(text->contains("'Pitch Offset' => [ 65286 , '-2.50 \xB0' ],"),
             text->constData());  // raw is unsigned
    QVERIFY(text->contains("'Pan Mode Setting #1' => [ 3 , 'pan hold hold' ],"));
    const auto read = readSettings(*text);
    QVERIFY2(read, read ? "" : qPrintable(read.error().detail));
    QCOMPARE(read->configuration.parameters().firmware(), board.parameters().firmware());
    QVERIFY(read->unknown.isEmpty() && read->missing.isEmpty());
    QStringList skipped;
    const Configuration back = applied(readBoard(rig), read->configuration, skipped);
    QVERIFY(skipped.isEmpty());
    QVERIFY(board.changesTo(back).empty() && board.dataChangesTo(back).empty());
}

// Numbers of choices differ between layouts; their names are what is meant (errata 5).
void TestStormSetup::settingsOfAnotherLayoutAreUnderstood()
{
    StormRig old(stormOptions(79));
    QVERIFY(old.device.identify(old.channel));
    Configuration before = readBoard(old);
    QVERIFY(before.setRaw(*before.parameters().find(u"rc.yaw.mode"_s), 0, 2));  // relative turn around
    QVERIFY(before.setRaw(*before.parameters().find(u"standby.input"_s), 0, 29));  // Aux-0 switch
    const auto file = readSettings(writeSettings(before).value());
    QVERIFY(file);
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QStringList skipped;
    const Configuration board = readBoard(rig);
    const Configuration now = applied(board, file->configuration, skipped);
    QCOMPARE(now.raw(*now.parameters().find(u"rc.yaw.mode"_s), 0), 3);
    QCOMPARE(now.raw(*now.parameters().find(u"standby.input"_s), 0), 30);
}

// Such a file opens, as a board has held what is in it; another board does not get it.
void TestStormSetup::settingsThatNobodyMaySetAreTold()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    const Configuration board = readBoard(rig);
    Configuration held = board;
    const ParameterSpec &poles = *board.parameters().find(u"motor.yaw.poles"_s);
    QVERIFY(held.restoreRaw(poles, 0, 13));
    const auto file = readSettings(writeSettings(held).value());
    QVERIFY(file);
    QCOMPARE(file->configuration.raw(*file->configuration.parameters().find(poles.key), 0), 13);
    QStringList skipped;
    const Configuration now = applied(board, file->configuration, skipped);
    QCOMPARE(now.raw(poles, 0), board.raw(poles, 0));
    QCOMPARE(skipped, QStringList{u"motor.yaw.poles = 13, allowed 12 to 28 in steps of 2"_s});
}

// Errata 13. Earlier versions of this program wrote the name that layout 95 has.
void TestStormSetup::settingsOfLayout89KeepTheirNames_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::newRow("original tool") << QByteArray("'Yaw Pan LPF'");
    QTest::newRow("earlier version") << QByteArray("'Yaw Pan Deadband LPF'");
}

void TestStormSetup::settingsOfLayout89KeepTheirNames()
{
    QFETCH(QByteArray, name);
    StormRig rig(stormOptions(90));
    QVERIFY(rig.device.identify(rig.channel));
    Configuration before = readBoard(rig);
    const ParameterSpec &filter = *before.parameters().find(u"pan.yaw.deadband_lpf"_s);
    QVERIFY(before.setRaw(filter, 0, 145));
    QByteArray text = writeSettings(before).value();
    QVERIFY(text.contains("'Yaw Pan LPF' => [ 145 ,"));
    const auto file = readSettings(text.replace("'Yaw Pan LPF'", name));
    QVERIFY2(file, qPrintable(file ? QString() : file.error().detail));
    QCOMPARE(file->configuration.parameters().firmware(), 89);
    QVERIFY2(file->missing.isEmpty() && file->unknown.isEmpty(),
             qPrintable((file->missing + file->unknown).join(u", "_s)));
    QStringList skipped;
    const Configuration now = applied(readBoard(rig), file->configuration, skipped);
    QCOMPARE(now.raw(*now.parameters().find(filter.key), 0), 145);
}

// Defaults that nobody has asked for are not taken.
void TestStormSetup::settingsThatAreMissingStay()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    Configuration board = readBoard(rig);
    const ParameterSpec &pitch = *board.parameters().find(u"pid.pitch.p"_s);
    const ParameterSpec &roll = *board.parameters().find(u"pid.roll.p"_s);
    QVERIFY(board.setRaw(pitch, 0, 777) && board.setRaw(roll, 0, 888));
    const auto settings = readSettings("%SettingsHash = (\n'Pitch P' => [ 512 , '5.12' ],\n);\n");
    QVERIFY(settings);
    QVERIFY(settings->missing.contains(roll.key) && !settings->missing.contains(pitch.key));
    ConfigurationFile file;
    file.configuration = settings->configuration;
    file.missingKeys = settings->missing;
    QStringList skipped;
    const Configuration now = applied(board, file, skipped);
    const auto changes = board.changesTo(now);
    QCOMPARE(changes.size(), std::size_t(1));
    QCOMPARE(changes.front().spec->key, pitch.key);
    QCOMPARE(changes.front().to, 512);
    QVERIFY(board.dataChangesTo(now).empty());
}

void TestStormSetup::badSettingsAreRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("says");
    QTest::newRow("nothing") << QByteArray() << u"empty"_s;
    QTest::newRow("something else") << QByteArray("{\"a\": 1}\n") << u"line 1"_s;
    QTest::newRow("cut off") << QByteArray("%SettingsHash = (\n'Pitch P' => [ 400 , '4.00' ],\n")
                             << u"cut off"_s;
    QTest::newRow("a program") << QByteArray("%SettingsHash = (\nsystem('rm -rf /');\n);\n") << u"line 2"_s;
    QTest::newRow("too large") << QByteArray("%SettingsHash = (\n'Pitch P' => [ 400000 , '4000' ],\n);\n")
                               << u"line 2"_s;
    QTest::newRow("out of range") << QByteArray("%SettingsHash = (\n'Pitch P' => [ 4000 , '40' ],\n);\n")
                                  << u"Pitch P"_s;
    QTest::newRow("nobody's") << QByteArray("%SettingsHash = (\n'Colour' => [ 4 , 'red' ],\n);\n")
                              << u"no entry"_s;
    QTest::newRow("scripts") << QByteArray(
        "%SettingsHash = (\n'Pitch P' => [ 400 , '4' ],\n'Scripts' => [ 'XY' ],\n);\n")
                             << u"line 3"_s;
    QTest::newRow("doubled") << QByteArray(
        "%SettingsHash = (\n'Pitch P' => [ 400 , '4' ],\n'Roll P' => [ 400 , '4' ],\n"
        "'Pitch P' => [ 500 , '5' ],\n);\n")
                             << u"line 4: Pitch P, also in line 2"_s;
}

void TestStormSetup::badSettingsAreRefused()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, says);
    const auto read = readSettings(text);
    QVERIFY(!read);
    QCOMPARE(read.error().code, ErrorCode::BadFile);
    QVERIFY2(read.error().detail.contains(says), qPrintable(read.error().detail));
}

void TestStormSetup::calibrationFileComesBack()
{
    const SensorCalibration calibration{{-12, 130, 7}, {8192, 8100, 8301}, u"6 point"_s, 31.5};
    const QByteArray text = writeCalibration(calibration);
    QVERIFY(text.contains("AYZERO: 130\n") && text.contains("AZSCALE: 8301\n")
            && text.contains("CALIBRATIONMETHOD: 6 point\n"));
    const auto read = readCalibration(text);
    QVERIFY(read);
    QCOMPARE(*read, calibration);
    for (const auto &[bad, says] : {std::pair{"AXZERO: 1\n", "AXSCALE"},
                                    {"AXZERO: many\nAXSCALE: 1\n", "AXZERO"},
                                    {"AXZERO: 1\nAXSCALE: 0\n", "AXSCALE"},
                                    {"AXZERO: 1\nAXSCALE: 9\nAXZERO: 2\n", "line 3: AXZERO"}}) {
        const auto wrong = readCalibration(bad);
        QVERIFY(!wrong);
        QVERIFY2(wrong.error().detail.contains(QLatin1String(says)), qPrintable(wrong.error().detail));
    }
}

QTEST_GUILESS_MAIN(TestStormSetup)
#include "tst_stormsetup.moc"
