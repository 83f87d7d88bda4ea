// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Encoders, the second motion sensor, the magnetometer and the flight controller of a simulated SimpleBGC
// board, and the calibrations that they need.
#include "protocol/simplebgc/messages.h"
#include "protocol/simulator/simplebgc/family.h"
#include "tests/support/channelproxy.h"
#include "tests/support/sbgcrig.h"

#include <cmath>

using namespace simplebgc;
using namespace Qt::StringLiterals;

namespace {

constexpr int kNew = 2;  // encoders that were never calibrated
const LineSettings kLine{115200, Parity::None};  // that stays while the board restarts
constexpr double kStandsStill = 0.001;  // strength of the hand: a tripod

SimulatorOptions with(const QMap<QString, int> &own, double shake = kStandsStill, int firmware = 2704)
{
    SimulatorOptions options = withFirmware(firmware);
    options.own = own;
    options.faults.shake = shake;
    return options;
}

bool isOffered(const SbgcRig &rig, const char *key)
{
    const auto list = rig.device.actions();
    return std::any_of(list.begin(), list.end(),
                       [key](const ActionSpec &action) { return qstrcmp(action.key, key) == 0; });
}

double motorAngle(SbgcRig &rig, Axis axis)
{
    return rig.perform("angles")->value(u"motor."_s + QLatin1String(axisKey(axis))).toDouble();
}

int field(SbgcRig &rig, int at)
{
    const auto status
        = rig.channel.transact(replyRequest(CommandId::RealtimeData4, {}, CommandId::RealtimeData4, 124, 1));
    return ByteReader(asBytes(status->payload).subspan(std::size_t(at))).i16();
}

}  // namespace

#define DONE(outcome) QVERIFY2(outcome, (outcome) ? "" : qPrintable((outcome).error().detail))

class TestSbgcSensors : public QObject
{
    Q_OBJECT
private slots:
    void whatIsNotThereIsNotOffered();
    void whatIsNotThereIsRefused_data();
    void whatIsNotThereIsRefused();
    void optionsAreChecked();
    void anglesNeedTheOffsets();
    void wrongFieldWeakensOrReversesTheMotor();
    void otherEncoderStopsTheBoard();
    void fieldsAreFound();
    void sameFieldsAreProvenByTheMode();
    void turnIsSaidToLaterFirmwareOnly();
    void motorThatDoesNotTurnHasNoField();
    void failureIsTold();
    void stopEndsTheCalibration();
    void cancelledCalibrationHasBegun();
    void lostLinkIsTold();
    void calibrationsExcludeEachOther();
    void positionBecomesZero();
    void oneMotorAlone();
    void movingCameraHasNoPosition();
    void flightControllerIsMatched();
    void stillFrameShowsNoGain();
    void headingNeedsTheMagnetometer();
    void magnetometerIsCalibrated();
    void cameraThatIsNotTurnedIsTold();
    void frameSensorIsSelectedAndCalibrated();
    void speedsFollowTheEncoder();
    void stateIsToldInWords();
    void silentBoardHasDoneNothing();
};

void TestSbgcSensors::whatIsNotThereIsNotOffered()
{
    for (const char *key : {"calibrate.encoder_field", "calibrate.encoder_offset", "calibrate.magnetometer"})
        QVERIFY2(!isOffered(SbgcRig(), key), key);
    const SbgcRig full(with({{u"encoders"_s, 1}, {u"magnetometer"_s, 1}}));
    for (const char *key : {"calibrate.encoder_field", "calibrate.encoder_offset", "calibrate.magnetometer"})
        QVERIFY2(isOffered(full, key), key);
    QVERIFY(full.device.parameters()->find(u"encoder.roll.offset"_s));
    // Before, firmware does not tell of a magnetometer, and has no calibration of encoders.
    const SbgcRig old(with({{u"encoders"_s, 1}, {u"magnetometer"_s, 1}}, kStandsStill, 2590));
    QVERIFY(!isOffered(old, "calibrate.encoder_field") && !isOffered(old, "calibrate.magnetometer"));
    QVERIFY(old.device.parameters()->find(u"encoder.roll.offset"_s));
}

void TestSbgcSensors::whatIsNotThereIsRefused_data()
{
    QTest::addColumn<int>("command");
    QTest::addColumn<int>("code");
    QTest::newRow("encoder offsets") << 26 << 6;
    QTest::newRow("encoder fields") << 27 << 6;
    QTest::newRow("magnetometer") << 59 << 9;
    QTest::newRow("flight controller") << 71 << 8;
}

void TestSbgcSensors::whatIsNotThereIsRefused()
{
    QFETCH(int, command);
    QFETCH(int, code);
    SbgcRig rig;
    const auto refused = rig.channel.transact(confirmRequest(CommandId(command), {}, 1));
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::BoardError);
    QCOMPARE(refused.error().boardCode, code);
}

void TestSbgcSensors::optionsAreChecked()
{
    const SimulatedFamily family = simulatedFamily();
    const auto read = [&family](const QString &name, const QString &text) {
        SimulatorSetup setup;
        for (const SimulatedOption &option : family.options) {
            if (option.name == name && !option.read(setup, text))
                return -1;
        }
        return setup.options.own.value(name, -2);
    };
    QCOMPARE(read(u"encoders"_s, u"1"_s), 1);
    QCOMPARE(read(u"encoders"_s, u"new"_s), kNew);
    QCOMPARE(read(u"encoders"_s, u"2"_s), -1);
    QCOMPARE(read(u"magnetometer"_s, u"new"_s), -1);
    QCOMPARE(read(u"frame-imu"_s, u"0"_s), 0);
    QCOMPARE(read(u"fc"_s, u"1"_s), 1);
}

void TestSbgcSensors::anglesNeedTheOffsets()
{
    SbgcRig set(with({{u"encoders"_s, 1}}));
    for (const Axis axis : kAxes)
        QVERIFY(std::abs(motorAngle(set, axis) - set.board().stabilizer().jointAngle(axis)) < 0.1);
    set.board().store(u"encoder.yaw.offset"_s, 0, 0);
    QVERIFY(std::abs(motorAngle(set, Axis::Yaw) - 37.7) < 1);  // 1716 counts
    QVERIFY(std::abs(field(set, 67) * 360.0 / 16384 - 37.7) < 1);
    SbgcRig fresh(with({{u"encoders"_s, kNew}}));
    QVERIFY(std::abs(motorAngle(fresh, Axis::Roll) + 129.4) < 5);
    // An axis that is set to have none goes on without.
    fresh.board().store(u"encoder.roll.type"_s, 0, 0);
    QVERIFY(std::abs(motorAngle(fresh, Axis::Roll)) < 5);
}

void TestSbgcSensors::wrongFieldWeakensOrReversesTheMotor()
{
    SbgcRig set(with({{u"encoders"_s, 1}}));
    std::ignore = set.channel.sleep(3s);
    for (const Axis axis : kAxes)
        QVERIFY(std::abs(set.board().stabilizer().trueAngle(axis)) < 5);
    SbgcRig fresh(with({{u"encoders"_s, kNew}}));
    std::ignore = fresh.channel.sleep(3s);
    QVERIFY(std::abs(fresh.board().stabilizer().trueAngle(Axis::Pitch)) > 60);  // off by more than a quarter
    QVERIFY(std::abs(fresh.board().stabilizer().trueAngle(Axis::Yaw)) < 10);  // weaker, but it holds
}

void TestSbgcSensors::otherEncoderStopsTheBoard()
{
    SbgcRig rig(with({{u"encoders"_s, 1}}), kLine);
    rig.board().store(u"encoder.pitch.type"_s, 0, 7);
    rig.board().setFaults({.resetAfter = rig.board().now(), .shake = kStandsStill});
    std::ignore = rig.channel.sleep(4s);
    QVERIFY(!rig.board().stabilizer().motorsOn());
    QCOMPARE(field(rig, 16) & 0xFF, 29);  // encoder missing
    rig.board().store(u"encoder.pitch.skip_detection"_s, 0, 1);
    rig.board().setFaults({.resetAfter = rig.board().now(), .shake = kStandsStill});
    std::ignore = rig.channel.sleep(4s);
    QVERIFY(rig.board().stabilizer().motorsOn());
    SAYS(rig.perform("calibrate.encoder_offset"), u"operation failed"_s);
}

void TestSbgcSensors::fieldsAreFound()
{
    SbgcRig rig(with({{u"encoders"_s, kNew}}));
    const auto done = rig.perform("calibrate.encoder_field");
    DONE(done);
    QCOMPARE(done->value(u"encoder.pitch.field_offset"_s).toDouble(), 677 * 360.0 / 16384);
    QCOMPARE(done->value(u"encoder.pitch.field_offset.before"_s).toDouble(), 0.0);
    QVERIFY(done->value(u"confirmed"_s).toBool());
    QCOMPARE(rig.board().stored(u"encoder.yaw.field_offset"_s, 4), -230);
    QVERIFY(!rig.channel.progressReports().empty());
    QCOMPARE(rig.channel.progressReports().front().step, u"calibrate-motors"_s);
    // The motors hold again what they had lost.
    std::ignore = rig.channel.sleep(5s);
    for (const Axis axis : kAxes)
        QVERIFY(std::abs(rig.board().stabilizer().trueAngle(axis)) < 5);
}

void TestSbgcSensors::sameFieldsAreProvenByTheMode()
{
    SbgcRig rig(with({{u"encoders"_s, 1}}));
    const auto done = rig.perform("calibrate.encoder_field");
    DONE(done);
    QVERIFY(!done->contains(u"encoder.pitch.field_offset.before"_s));
    // Where nobody sees the board calibrate, the same figures prove nothing.
    Altering blind(rig.channel, [](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        auto frame = pass(request);
        if (frame && request.name == u"REALTIME_DATA_4"_s)
            frame->payload[94] = 0;
        return frame;
    });
    const auto unproven = rig.device.perform(blind, u"calibrate.encoder_field"_s,
                                             argumentsFor(rig.device, "calibrate.encoder_field"));
    QVERIFY(!unproven);
    QCOMPARE(unproven.error().code, ErrorCode::NoEffect);
}

void TestSbgcSensors::turnIsSaidToLaterFirmwareOnly()
{
    SbgcRig old(with({{u"encoders"_s, kNew}}, kStandsStill, 2610));
    SAYS(old.perform("calibrate.encoder_field", {{u"angle"_s, u"20"_s}}), u"angle"_s);
    DONE(old.perform("calibrate.encoder_field"));
    SbgcRig later(with({{u"encoders"_s, kNew}}, kStandsStill, 2730));
    double farthest = 0;
    later.channel.setOperator([&](const Progress &) {
        farthest = std::max(farthest, later.board().stabilizer().trueAngle(Axis::Yaw));
    });
    DONE(later.perform("calibrate.encoder_field", {{u"angle"_s, u"20"_s}, {u"speed"_s, u"20"_s}}));
    QVERIFY2(farthest > 10 && farthest < 30, qPrintable(QString::number(farthest)));
}

void TestSbgcSensors::motorThatDoesNotTurnHasNoField()
{
    SbgcRig rig(with({{u"encoders"_s, kNew}}));
    rig.board().setFaults({.blocked = 2, .shake = kStandsStill});
    SAYS(rig.perform("calibrate.encoder_field"), u"what is stored is as before"_s);
    QCOMPARE(rig.board().stored(u"encoder.pitch.field_offset"_s, 0), 0);
}

void TestSbgcSensors::failureIsTold()
{
    SbgcRig rig(with({{u"encoders"_s, kNew}}));
    rig.board().setFaults({.failWith = 11, .shake = kStandsStill});
    SAYS(rig.perform("calibrate.encoder_field"), u"temporarily impossible"_s);
    QCOMPARE(rig.board().stored(u"encoder.pitch.field_offset"_s, 0), 0);
    rig.board().setFaults({.noImu = true});
    SAYS(rig.perform("calibrate.encoder_field"), u"sensor"_s);
    rig.board().setFaults({.deaf = number(CommandId::EncodersCalibOffset)});
    const auto silent = rig.perform("calibrate.encoder_offset");
    QVERIFY(!silent);
    QCOMPARE(silent.error().code, ErrorCode::Timeout);
}

// And nothing that it was to find has changed: that is no success.
void TestSbgcSensors::stopEndsTheCalibration()
{
    SbgcRig rig(with({{u"encoders"_s, kNew}}));
    bool isTold = false;
    rig.channel.setOperator([&](const Progress &progress) {
        if (progress.done > 15 && !std::exchange(isTold, true))
            rig.channel.post(confirmRequest(CommandId::MotorsOff, {}, 1));
    });
    const auto stopped = rig.perform("calibrate.encoder_field");
    QVERIFY(isTold);
    QVERIFY(!stopped);
    QCOMPARE(stopped.error().code, ErrorCode::NoEffect);
    QVERIFY(!rig.board().stabilizer().motorsOn());
}

void TestSbgcSensors::cancelledCalibrationHasBegun()
{
    SbgcRig rig(with({{u"encoders"_s, kNew}}));
    rig.channel.cancelAfter(4s);
    const auto cancelled = rig.perform("calibrate.encoder_field");
    SAYS(cancelled, u"it had begun on the board"_s);
    QCOMPARE(cancelled.error().code, ErrorCode::Cancelled);
    const auto list = rig.device.actions();
    const auto action = std::find_if(list.begin(), list.end(), [](const ActionSpec &each) {
        return qstrcmp(each.key, "calibrate.encoder_field") == 0;
    });
    QCOMPARE(action->endedBy, "motors.off");
    rig.channel.cancelAfter(100s);
    DONE(rig.perform("motors.off"));
    std::ignore = rig.channel.sleep(20s);
    QCOMPARE(rig.board().stored(u"encoder.pitch.field_offset"_s, 0), 0);
}

void TestSbgcSensors::lostLinkIsTold()
{
    SbgcRig rig(with({{u"encoders"_s, kNew}}));
    Altering cut(rig.channel, [](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        return request.name == u"REALTIME_DATA_4"_s ? failure(ErrorCode::LinkClosed, request.name)
                                                    : pass(request);
    });
    const auto lost = rig.device.perform(cut, u"calibrate.encoder_field"_s,
                                         argumentsFor(rig.device, "calibrate.encoder_field"));
    SAYS(lost, u"it had begun on the board"_s);
    QCOMPARE(lost.error().code, ErrorCode::LinkClosed);
}

void TestSbgcSensors::calibrationsExcludeEachOther()
{
    SbgcRig rig(with({{u"encoders"_s, 1}, {u"magnetometer"_s, 1}}));
    QVERIFY(rig.channel.transact(confirmRequest(CommandId::EncodersCalibFldOffset, {}, 1)));
    for (const CommandId id : {CommandId::EncodersCalibOffset, CommandId::CalibMag, CommandId::CalibGyro}) {
        const auto refused = rig.channel.transact(confirmRequest(id, {}, 1));
        QVERIFY(!refused);
        QCOMPARE(refused.error().boardCode, 8);
    }
}

void TestSbgcSensors::positionBecomesZero()
{
    SbgcRig rig(with({{u"encoders"_s, kNew}}));
    DONE(rig.perform("calibrate.encoder_field"));
    std::ignore = rig.channel.sleep(5s);
    const auto done = rig.perform("calibrate.encoder_offset");
    DONE(done);
    QVERIFY(std::abs(done->value(u"encoder.roll.offset"_s).toDouble() + 129.4) < 5);
    QCOMPARE(done->value(u"encoder.roll.offset.before"_s).toDouble(), 0.0);
    QVERIFY(std::abs(done->value(u"motor.roll.before"_s).toDouble() + 129.4) < 5);
    for (const Axis axis : kAxes)
        QVERIFY(std::abs(done->value(u"motor."_s + QLatin1String(axisKey(axis))).toDouble()) < 1);
}

void TestSbgcSensors::oneMotorAlone()
{
    SbgcRig rig(with({{u"encoders"_s, 1}}));
    rig.board().store(u"encoder.roll.offset"_s, 0, 0);
    rig.board().store(u"encoder.yaw.offset"_s, 0, 0);
    DONE(rig.perform("calibrate.encoder_offset", {{u"motor"_s, u"yaw"_s}}));
    QCOMPARE(rig.board().stored(u"encoder.roll.offset"_s, 0), 0);
    QVERIFY(rig.board().stored(u"encoder.yaw.offset"_s, 0) > 1500);
    SbgcRig old(with({{u"encoders"_s, 1}}, kStandsStill, 2660));
    SAYS(old.perform("calibrate.encoder_offset", {{u"motor"_s, u"yaw"_s}}), u"all motors at once"_s);
    const auto wrong
        = rig.channel.transact(confirmRequest(CommandId::EncodersCalibOffset, QByteArray(1, '\3'), 1));
    QVERIFY(!wrong);
    QCOMPARE(wrong.error().boardCode, 2);
}

void TestSbgcSensors::movingCameraHasNoPosition()
{
    SbgcRig rig(with({{u"encoders"_s, 1}}, 15));
    SAYS(rig.perform("calibrate.encoder_offset"), u"operation failed"_s);
}

void TestSbgcSensors::flightControllerIsMatched()
{
    SbgcRig rig(with({{u"fc"_s, 1}}, 2));
    const auto done = rig.perform("calibrate.fc_gain");
    DONE(done);
    QCOMPARE(done->value(u"fc.gain.roll"_s).toInt(), 45);
    QCOMPARE(done->value(u"fc.gain.roll.before"_s).toInt(), 0);
    QCOMPARE(rig.board().stored(u"fc.gain.pitch"_s, 0), 45);
    // Where no sensor tells the frame's tilt, the flight controller does.
    rig.board().store(u"imu.frame.position"_s, 0, 0);
    QVERIFY(std::abs(field(rig, 38) * 360.0 / 16384 - rig.board().stabilizer().hand().angle(Axis::Roll))
            < 0.5);
    rig.board().store(u"fc.gain.roll"_s, 0, 0);
    QCOMPARE(field(rig, 38), 0);
    SAYS(SbgcRig().perform("calibrate.fc_gain"), u"fc.map.roll"_s);
    SbgcRig mapped;
    mapped.board().store(u"fc.map.roll"_s, 0, 3);
    SAYS(mapped.perform("calibrate.fc_gain"), u"not possible in this state"_s);
}

void TestSbgcSensors::stillFrameShowsNoGain()
{
    SbgcRig rig(with({{u"fc"_s, 1}}));
    SAYS(rig.perform("calibrate.fc_gain"), u"operation failed"_s);
}

// The gyroscope's bias turns the yaw angle away; a magnetometer holds it, though not where north is.
void TestSbgcSensors::headingNeedsTheMagnetometer()
{
    const auto error = [](const QMap<QString, int> &own) {
        SbgcRig rig(with(own));
        std::ignore = rig.channel.sleep(60s);
        return std::abs(rig.board().stabilizer().trueAngle(Axis::Yaw));
    };
    QVERIFY(error({}) > 15);  // 0.4 degrees per second
    SbgcRig rig(with({{u"magnetometer"_s, 1}}));
    rig.board().store(u"imu.mag.trust"_s, 0, 0);
    std::ignore = rig.channel.sleep(60s);
    QVERIFY(std::abs(rig.board().stabilizer().trueAngle(Axis::Yaw)) > 15);
    const double held = error({{u"magnetometer"_s, 1}});
    QVERIFY2(held > 5 && held < 60, qPrintable(QString::number(held)));
}

void TestSbgcSensors::magnetometerIsCalibrated()
{
    SbgcRig rig(with({{u"magnetometer"_s, 1}}), kLine);
    const auto done = rig.perform("calibrate.magnetometer");
    DONE(done);
    QVERIFY2(done->value(u"directions"_s).toInt() >= 24, qPrintable(done->value(u"directions"_s).toString()));
    QVERIFY(done->value(u"confirmed"_s).toBool());
    // What the simulated iron does: a shift, and another length along each axis.
    QVERIFY(std::abs(done->value(u"field"_s).toDouble() - 400) < 15);
    QVERIFY(std::abs(done->value(u"shift.x"_s).toDouble() - 90) < 15);
    QVERIFY(std::abs(done->value(u"shift.y"_s).toDouble() + 60) < 15);
    QVERIFY(std::abs(done->value(u"shift.z"_s).toDouble() - 110) < 15);
    QVERIFY(std::abs(done->value(u"stretch"_s).toDouble() - 1.12) < 0.03);
    QVERIFY(done->value(u"roughness"_s).toDouble() > 1);
    QVERIFY(done->value(u"roughness"_s).toDouble() < 6);
    const double before = done->value(u"heading.error.before"_s).toDouble();
    const double after = done->value(u"heading.error.after"_s).toDouble();
    QVERIFY2(before > 8 && after < 5, qPrintable(u"%1 %2"_s.arg(before).arg(after)));
    QVERIFY(rig.board().stabilizer().motorsOn());
    std::ignore = rig.channel.sleep(60s);
    QVERIFY(std::abs(rig.board().stabilizer().trueAngle(Axis::Yaw)) < 8);
    // It is kept over a restart, and taken back by a calibration that resets.
    rig.board().setFaults({.resetAfter = rig.board().now(), .shake = kStandsStill});
    std::ignore = rig.channel.sleep(5s);
    const auto error = [&rig] { return field(rig, 87) & 0xFF; };
    QVERIFY(error() < 60);
    QVERIFY(rig.channel.transact(confirmRequest(CommandId::CalibMag, encodeCalibration(1, 2), 1)));
    std::ignore = rig.channel.sleep(5s);
    QVERIFY(error() > 80);
}

void TestSbgcSensors::cameraThatIsNotTurnedIsTold()
{
    SbgcRig rig(with({{u"magnetometer"_s, 1}}));
    rig.board().setFaults({.pose = 1});
    SAYS(rig.perform("calibrate.magnetometer"), u"0 of 26 directions were seen"_s);
    Altering frozen(
        rig.channel,
        [last = QByteArray()](const Request &request, const Altering::Pass &pass) mutable -> Result<Frame> {
            auto frame = pass(request);
            if (frame && request.name == u"REALTIME_DATA_4"_s) {
                if (last.isEmpty())
                    last = frame->payload;
                frame->payload = last;
            }
            return frame;
        });
    const auto still = rig.device.perform(frozen, u"calibrate.magnetometer"_s, {});
    QVERIFY(!still);
    QCOMPARE(still.error().code, ErrorCode::NoSamples);
    // About one axis only, all directions lie in a plane; what is stored stays.
    constexpr int kUprightOnly = 6;
    rig.board().setFaults({.shake = kStandsStill, .hand = kUprightOnly});
    SAYS(rig.perform("calibrate.magnetometer"), u"0 of 26 directions were seen"_s);
}

void TestSbgcSensors::frameSensorIsSelectedAndCalibrated()
{
    SbgcRig rig(with({{u"frame-imu"_s, 1}}));
    const int tilted = field(rig, 38);
    QVERIFY(std::abs(tilted) > 40);  // an accelerometer that is not calibrated: counts
    SAYS(rig.perform("calibrate.gyro", {{u"imu"_s, u"frame"_s}}), u"imu.select"_s);
    const auto seen = rig.perform("attitude", {{u"imu"_s, u"frame"_s}});
    DONE(seen);
    QVERIFY(std::abs(seen->value(u"z.x"_s).toDouble() + 0.03) < 0.005);
    DONE(rig.perform("imu.select", {{u"imu"_s, u"frame"_s}}));
    const auto gyro = rig.perform("calibrate.gyro", {{u"imu"_s, u"frame"_s}});
    DONE(gyro);
    QVERIFY(gyro->value(u"gyro.bias.before"_s).toDouble() > 1.5);
    QVERIFY(gyro->value(u"gyro.bias.after"_s).toDouble() < 0.2);
    QVERIFY(rig.board().stabilizer().motorsOn());
    DONE(rig.perform("calibrate.acc", {{u"imu"_s, u"frame"_s}}));
    QVERIFY(std::abs(field(rig, 38)) < std::abs(tilted) / 4.0);
    // The one at the camera is as it was.
    QCOMPARE(rig.board().stabilizer().imu().gyroCorrection[0], 0.0);
    rig.board().store(u"imu.frame.position"_s, 0, 0);
    DONE(rig.perform("imu.select", {{u"imu"_s, u"main"_s}}));
    QVERIFY(!rig.perform("imu.select", {{u"imu"_s, u"frame"_s}}));
}

// An SPI encoder has four speeds; that a driver of its own has an encoder inside is another matter.
void TestSbgcSensors::speedsFollowTheEncoder()
{
    const ParameterSet set(parameterRows(), kBlocks, 2704, {u"encoders"_s}, valueRules());
    const auto broken = [&set](double type, double config) {
        return std::any_of(set.rules().begin(), set.rules().end(), [&](const ValueRule &rule) {
            return rule.concerns(u"encoder.roll.config"_s) && rule.isBroken(config, type);
        });
    };
    QVERIFY(!broken(1, 3) && broken(1, 4));
    QVERIFY(!broken(8, 6) && !broken(8, 3));
    QVERIFY(set.find(u"encoder.roll.config"_s)->accepts(6));
    QVERIFY(!set.find(u"encoder.roll.config"_s)->accepts(8));  // a driver within a driver
}

void TestSbgcSensors::stateIsToldInWords()
{
    SbgcRig rig(with({{u"encoders"_s, 1}}, kStandsStill, 2730));
    QCOMPARE(rig.perform("state")->value(u"calibration"_s).toString(), u"none"_s);
    QCOMPARE(rig.perform("state")->value(u"modes"_s).toString(), u"started"_s);
    QVERIFY(rig.channel.transact(confirmRequest(CommandId::EncodersCalibFldOffset, {}, 1)));
    QCOMPARE(rig.perform("state")->value(u"calibration"_s).toString(), u"encoder field"_s);
    SbgcRig older;
    QVERIFY(!older.perform("state")->contains(u"modes"_s));
    // In the console as well.
    const MessageSpec *message = findMessage(25);
    QByteArray payload(124, '\0');
    payload[94] = 12;
    payload[102] = 0x11;
    payload[103] = 0x20;
    QStringList told;
    for (const FieldValue &value : decodeFields(*message->fromBoard, asBytes(payload)))
        told.append(value.name + u'=' + value.text());
    QVERIFY2(told.contains(u"calibration=12 (magnetometer)"_s), qPrintable(told.join(u' ')));
    for (const QString &part :
         {u"state.debug=1"_s, u"state.started=1"_s, u"state.tripod=1"_s, u"state.servo=0"_s})
        QVERIFY2(told.contains(part), qPrintable(told.join(u' ')));
}

void TestSbgcSensors::silentBoardHasDoneNothing()
{
    SbgcRig rig(with({{u"encoders"_s, 1}, {u"magnetometer"_s, 1}, {u"fc"_s, 1}}));
    Altering mute(rig.channel, [](const Request &request, const Altering::Pass &) -> Result<Frame> {
        return failure(ErrorCode::Timeout, request.name);
    });
    for (const char *key : {"calibrate.encoder_field", "calibrate.encoder_offset", "calibrate.fc_gain",
                            "calibrate.magnetometer", "state"}) {
        const auto done = rig.device.perform(mute, QLatin1String(key), argumentsFor(rig.device, key));
        QVERIFY2(!done, key);
        QCOMPARE(done.error().code, ErrorCode::Timeout);
    }
}

QTEST_GUILESS_MAIN(TestSbgcSensors)
#include "tst_sbgcsensors.moc"
