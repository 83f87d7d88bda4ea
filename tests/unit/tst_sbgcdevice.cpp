// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/client/connector.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"
#include "tests/support/lossychannel.h"
#include "tests/support/virtualboard.h"

#include <QTest>

#include <cmath>

using namespace simplebgc;
using namespace Qt::StringLiterals;

namespace {

SimulatorOptions options(int firmware)
{
    SimulatorOptions o;
    o.firmware = firmware;
    return o;
}

QVariantMap argumentsFor(const simplebgc::Device &device, const char *key,
                         const QMap<QString, QString> &texts = {})
{
    for (const ActionSpec &action : device.actions()) {
        if (qstrcmp(action.key, key) == 0)
            return parseArguments(action, texts).value();
    }
    return {};
}

Result<FoundBoard> find(VirtualBoard &bench, const LinkAddress &address)
{
    return findBoard(bench.channel, bench.family, bench.device, allFamilies(), address);
}

Request fireAndForget(const QByteArray &bytes)
{
    Request request;
    request.bytes = bytes;
    return request;
}

}  // namespace

/// The family's sequential code against the simulated board in virtual time.
class TestSbgcDevice : public QObject
{
    Q_OBJECT
private slots:
    void identifies();
    void unknownFirmwareIsReadOnly();
    void findsRateAndParity_data();
    void findsRateAndParity();
    void explainsSilenceGarbageAndForeigners();
    void readsEverything_data();
    void readsEverything();
    void missingExtendedBlocksAreLeftOut();
    void readTimeIsNearTheWire();
    void selectsProfiles();
    void profileNames();
    void adjustablesAreVolatileUntilSaved();
    void gyroCalibrationRemovesTheBias_data();
    void gyroCalibrationRemovesTheBias();
    void accCalibrationLevelsTheHorizon();
    void calibrationOfAShakenCameraChangesNothing();
    void secondCalibrationIsRefusedMeanwhile();
    void calibrationCanBeCancelled();
    void autoTuneFindsAndSavesGains();
    void autoTuneStopsWhenCancelled();
    void steersToAnAngle();
    void speedModeStopsAtTheEnd();
    void everyControlModeIsEncoded();
    void resetIsAnnounced();
    void defaultsOverwriteAProfile();
    void motorsOffStopsEvenATuningBoard();
    void debugVariablesAreListedAndRead();
    void faultsAreNamed();
    void streamsAtFullRateWithoutLoss();
    void oldFirmwareIsPolled();
    void pollsWhenAllStreamsAreTaken();
    void streamFitsASlowLine();
    void lostFramesAreCountedAsGaps();
    void streamsChosenByHandAllRun();
    void laterFieldsAreFoundByAsking_data();
    void laterFieldsAreFoundByAsking();
    void eachFlagOfCustomDelivers();
    void streamsThatDoNotFitAreRefused_data();
    void streamsThatDoNotFitAreRefused();
    void wireRatesAreThoseOfTheTable_data();
    void wireRatesAreThoseOfTheTable();
    void lossIsFoundWithoutStamps();
    void silenceIsNoLoss_data();
    void silenceIsNoLoss();
    void survivesADisturbedCable();
    void argumentsAreChecked();
};

void TestSbgcDevice::identifies()
{
    VirtualBoard bench;
    const auto identity = bench.device.identify(bench.channel);
    QVERIFY(identity);
    QCOMPARE(identity->model, u"SimpleBGC 3.0"_s);
    QCOMPARE(identity->firmware, u"2.59b0"_s);
    QVERIFY(identity->capabilities.contains(u"battery"_s));
    QVERIFY(identity->capabilities.contains(u"streams"_s));
    QVERIFY(identity->usb);
    QVERIFY(identity->writable);
    QVERIFY(!identity->serial.isEmpty());
    // The seed is in the serial number: another board is another board.
    SimulatorOptions other;
    other.seed = 2;
    VirtualBoard second(other);
    QVERIFY(second.device.identify(second.channel)->serial != identity->serial);
}

void TestSbgcDevice::unknownFirmwareIsReadOnly()
{
    SimulatorOptions o;
    o.faults.unknownFirmware = true;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    QVERIFY(!bench.device.identity().writable);
    // Everything we can decode is shown, nothing is written or moved.
    QVERIFY(bench.device.readConfiguration(bench.channel));
    QCOMPARE(bench.device.perform(bench.channel, u"motors.on"_s, {}).error().code, ErrorCode::ReadOnly);
    QVERIFY(bench.device.perform(bench.channel, u"motors.off"_s, {}));
}

void TestSbgcDevice::findsRateAndParity_data()
{
    QTest::addColumn<int>("baud");
    QTest::addColumn<bool>("even");
    QTest::addColumn<int>("firmware");
    for (const int baud : {115200, 57600, 38400, 19200, 9600, 256000}) {
        for (const bool even : {false, true})
            QTest::addRow("%d %s", baud, even ? "even" : "none") << baud << even << 2590;
        QTest::addRow("%d firmware 2.40", baud) << baud << true << 2400;
    }
}

void TestSbgcDevice::findsRateAndParity()
{
    QFETCH(int, baud);
    QFETCH(bool, even);
    QFETCH(int, firmware);
    SimulatorOptions o = options(firmware);
    o.usb = false;
    const LineSettings line{baud, even ? Parity::Even : Parity::None};
    VirtualBoard bench(o, line);
    const auto found = find(bench, LinkAddress::serial(u"/dev/x"_s));
    QVERIFY(found);
    QCOMPARE(found->line->baud, baud);
    // From 2.41 on the board takes either parity, so "none" is found first; 2.40 answers to even only.
    QCOMPARE(found->line->parity, firmware < 2410 ? Parity::Even : Parity::None);
    // It says what it tries.
    QVERIFY(bench.channel.progressReports().front().subject.contains(u"115200 8N1"_s));
}

void TestSbgcDevice::explainsSilenceGarbageAndForeigners()
{
    SimulatorOptions o = options(2400);
    o.usb = false;
    VirtualBoard silent(o, LineSettings{115200, Parity::Even});
    const auto address = LinkAddress::serial(u"/dev/x"_s, 115200, Parity::None);
    QCOMPARE(find(silent, address).error().code, ErrorCode::Silent);

    SimulatorOptions noisy;
    noisy.faults.flipByte = 1.0;
    VirtualBoard garbage(noisy);
    // The board hears nothing either, so it is made to talk.
    garbage.port.board().receive(asBytes(DataStream{25, 20, QByteArray(8, '\0')}.encode()));
    garbage.port.board().receive(asBytes(encodeFrame(85, DataStream{25, 20, QByteArray(8, '\0')}.encode())));
    QCOMPARE(find(garbage, address).error().code, ErrorCode::Garbage);

    const QList<Family> known = allFamilies();
#if GIMBAL_WITH_STORM32
    // Two MAVLink heartbeats, one behind the other; a STorM32 answering every byte with e.
    const QByteArray heartbeat = hex("FE 09 00 01 01 00 00 00 00 00 1A 03 00 04 03 12 34");
    QCOMPARE(recogniseProtocol(known, heartbeat + heartbeat), u"MAVLink"_s);
    QCOMPARE(recogniseProtocol(known, "eeeee"), u"STorM32"_s);
#endif
    QCOMPARE(recogniseProtocol(known, hex("3E 56 00")), QString());
}

void TestSbgcDevice::readsEverything_data()
{
    QTest::addColumn<int>("firmware");
    for (const int firmware : {2400, 2439, 2590, 2610, 2704, 2738})
        QTest::addRow("%d", firmware) << firmware;
}

void TestSbgcDevice::readsEverything()
{
    QFETCH(int, firmware);
    VirtualBoard bench(options(firmware));
    QVERIFY(bench.identify());
    const auto configuration = bench.device.readConfiguration(bench.channel);
    QVERIFY(configuration);
    QCOMPARE(configuration->blocks().size(), std::size_t(15));
    QCOMPARE(configuration->profileNames().first(), u"Handheld"_s);
    for (const ParameterSpec &spec : configuration->parameters().all()) {
        for (int profile = 0; profile < kProfileCount; ++profile)
            QVERIFY2(configuration->raw(spec, profile).has_value(), qPrintable(spec.key));
        if (!spec.row->state && spec.key != u"imu.skip_gyro_calibration"_s)
            QCOMPARE(*configuration->raw(spec, 4), spec.defaultRaw);
    }
    QCOMPARE(*configuration->raw(*configuration->parameters().find(u"pid.roll.p"_s), 1), 45);
}

void TestSbgcDevice::missingExtendedBlocksAreLeftOut()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    LossyChannel channel(bench.channel);
    for (int profile = 0; profile < kProfileCount; ++profile)
        channel.lose(CommandId::ReadParamsExt2, profile, 99);
    const auto configuration = bench.device.readConfiguration(channel);
    QVERIFY(configuration);
    QCOMPARE(configuration->blocks().size(), std::size_t(10));
    QVERIFY(!configuration->raw(*configuration->parameters().find(u"motion.roll.acc_limit"_s), 0));
    QCOMPARE(*configuration->raw(*configuration->parameters().find(u"filter.roll.lpf"_s), 0), 400);
    // It is asked for in each profile, and not again and again at the end.
    QCOMPARE(channel.lost(), kProfileCount + 2);
    // Without the main block there is nothing to show.
    LossyChannel deaf(bench.channel);
    for (int profile = 0; profile < kProfileCount; ++profile)
        deaf.lose(CommandId::ReadParams3, profile, 99);
    QCOMPARE(bench.device.readConfiguration(deaf).error().code, ErrorCode::Timeout);
}

void TestSbgcDevice::readTimeIsNearTheWire()
{
    SimulatorOptions o;
    o.usb = false;
    const LineSettings line{115200, Parity::None};
    VirtualBoard bench(o, line);
    std::ignore = bench.channel.setLine(line);
    QVERIFY(bench.identify());
    QVERIFY(bench.channel.sleep(100ms));
    const TimePoint start = bench.channel.now();
    QVERIFY(bench.device.readConfiguration(bench.channel));
    const double taken = seconds(bench.channel.now() - start);
    // 15 blocks and the names: requests of 6 (5) bytes, replies of 139, 109, 156 (245) bytes.
    const double wire = line.secondsFor(15 * 6 + 5 * (139 + 109 + 156) + 5 + 245);
    // The document's pause is 10 ms after each command, beside the wire.
    const double allowed = wire + 16 * 0.010;
    qInfo() << "configuration read in" << taken * 1000 << "ms; wire" << wire * 1000 << "ms; wire and pauses"
            << allowed * 1000 << "ms; ratio" << taken / allowed;
    QVERIFY(taken < 1.15 * allowed);
}

void TestSbgcDevice::selectsProfiles()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    for (const int profile : {3, 4, 0, 1, 2}) {
        QVERIFY(bench.device.selectProfile(bench.channel, profile));
        QCOMPARE(bench.board().activeProfile(), profile);
        QCOMPARE(*bench.device.activeProfile(bench.channel), profile);
    }
    QCOMPARE(bench.device.selectProfile(bench.channel, 5).error().code, ErrorCode::InvalidArgument);
}

void TestSbgcDevice::profileNames()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const QStringList names{u"Kran"_s, u"Büro"_s, u"五"_s, QString(), u"x"_s};
    QVERIFY(bench.device.writeProfileNames(bench.channel, names));
    QCOMPARE(*bench.device.readProfileNames(bench.channel), names);
}

void TestSbgcDevice::adjustablesAreVolatileUntilSaved()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    QVERIFY(bench.device.writeAdjustables(bench.channel, {{0, 77}, {39, 250}, {38, -5}}));
    const auto values = bench.device.readAdjustables(bench.channel, {0, 39, 38});
    QVERIFY(values);
    QCOMPARE((*values)[0].value, 77.0);
    QCOMPARE((*values)[1].value, 250.0);
    QCOMPARE((*values)[2].value, -5.0);
    QCOMPARE(bench.board().inUse(u"pid.roll.p"_s), 77);
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 35);
    // A profile that is loaded wipes them.
    QVERIFY(bench.device.selectProfile(bench.channel, 1));
    QVERIFY(bench.device.selectProfile(bench.channel, 0));
    QCOMPARE(bench.board().inUse(u"pid.roll.p"_s), 35);
    QVERIFY(bench.device.writeAdjustables(bench.channel, {{0, 78}}));
    QVERIFY(bench.device.perform(bench.channel, u"variables.save"_s, {}));
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 78);
    QCOMPARE(bench.device.readAdjustables(bench.channel, {200}).error().code, ErrorCode::BoardError);
}

void TestSbgcDevice::gyroCalibrationRemovesTheBias_data()
{
    QTest::addColumn<QString>("form");
    QTest::newRow("extended: confirmed twice") << u"extended"_s;
    QTest::newRow("simple: confirmed at the end") << u"simple"_s;
}

void TestSbgcDevice::gyroCalibrationRemovesTheBias()
{
    QFETCH(QString, form);
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const auto before
        = bench.board().stabilizer().imu().gyroBias[1] - bench.board().stabilizer().imu().gyroCorrection[1];
    QVERIFY(std::abs(before) > 1.0);
    const TimePoint start = bench.channel.now();
    const auto reply
        = bench.device.perform(bench.channel, u"calibrate.gyro"_s,
                               argumentsFor(bench.device, "calibrate.gyro", {{u"form"_s, form}}));
    QVERIFY(reply);
    QVERIFY(bench.channel.now() - start > 4s);
    for (std::size_t i = 0; i < 3; ++i) {
        const SimulatedImu &imu = bench.board().stabilizer().imu();
        QVERIFY(std::abs(imu.gyroBias[i] - imu.gyroCorrection[i]) < 0.05);
    }
    QVERIFY(reply->value(u"confirmed"_s).toBool());
    // The camera is held again afterwards, and stands.
    QVERIFY(bench.board().stabilizer().motorsOn());
    QVERIFY2(reply->value(u"gyro.bias.after"_s).toDouble() < 1.0,
             qPrintable(reply->value(u"gyro.bias.after"_s).toString()));
}

void TestSbgcDevice::accCalibrationLevelsTheHorizon()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.board().stabilizer().imu().gyroCorrection = bench.board().stabilizer().imu().gyroBias;
    std::ignore = bench.channel.sleep(20s);
    const double tiltedBefore = std::abs(bench.board().stabilizer().trueAngle(Axis::Roll));
    QVERIFY2(tiltedBefore > 1.0, qPrintable(QString::number(tiltedBefore)));
    QVERIFY(
        bench.device.perform(bench.channel, u"calibrate.acc"_s, argumentsFor(bench.device, "calibrate.acc")));
    std::ignore = bench.channel.sleep(20s);
    const double after = std::abs(bench.board().stabilizer().trueAngle(Axis::Roll));
    QVERIFY2(after < tiltedBefore / 2, qPrintable(QString::number(after)));
}

void TestSbgcDevice::calibrationOfAShakenCameraChangesNothing()
{
    SimulatorOptions o;
    o.faults.shake = 8;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    const auto reply = bench.device.perform(bench.channel, u"calibrate.gyro"_s,
                                            argumentsFor(bench.device, "calibrate.gyro"));
    QVERIFY(reply);
    QCOMPARE(bench.board().stabilizer().imu().gyroCorrection[0], 0.0);
}

void TestSbgcDevice::secondCalibrationIsRefusedMeanwhile()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    QVERIFY(bench.channel.transact(confirmRequest(CommandId::CalibGyro, encodeCalibration(1, 1), 1)));
    std::ignore = bench.channel.sleep(1s);
    const auto second
        = bench.channel.transact(confirmRequest(CommandId::CalibAcc, encodeCalibration(1, 1), 1));
    QCOMPARE(second.error().code, ErrorCode::BoardError);
    QCOMPARE(second.error().boardCode, 8);
}

void TestSbgcDevice::calibrationCanBeCancelled()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.channel.cancelAfter(2s);
    const auto reply = bench.device.perform(bench.channel, u"calibrate.gyro"_s,
                                            argumentsFor(bench.device, "calibrate.gyro"));
    QCOMPARE(reply.error().code, ErrorCode::Cancelled);
}

void TestSbgcDevice::autoTuneFindsAndSavesGains()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.board().stabilizer().imu().gyroCorrection = bench.board().stabilizer().imu().gyroBias;
    const auto reply = bench.device.perform(bench.channel, u"autotune"_s,
                                            argumentsFor(bench.device, "autotune", {{u"yaw"_s, u"off"_s}}));
    QVERIFY(reply);
    const int p = reply->value(u"p.roll"_s).toInt();
    QVERIFY2(p > 15, qPrintable(QString::number(p)));
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), p);
    QCOMPARE(bench.board().stored(u"pid.yaw.p"_s, 0), 40);  // not chosen, not touched
    // Progress came with each iteration, with gains and tracking error.
    int reports = 0;
    for (const Progress &progress : bench.channel.progressReports())
        reports += progress.values.contains(u"error.roll"_s);
    QVERIFY(reports >= 10);
    // The found gains hold.
    std::ignore = bench.channel.sleep(2s);
    QVERIFY(std::abs(bench.board().stabilizer().estimate(Axis::Roll)) < 0.5);
}

void TestSbgcDevice::autoTuneStopsWhenCancelled()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.channel.cancelAfter(3s);
    const auto reply
        = bench.device.perform(bench.channel, u"autotune"_s, argumentsFor(bench.device, "autotune"));
    QCOMPARE(reply.error().code, ErrorCode::Cancelled);
    // "Stop" is sent although the job is over.
    int frames = 0;
    bench.channel.setTap([&frames](const FrameView &frame, TimePoint) { frames += frame.id == 35; });
    bench.port.advance(200ms);
    bench.channel.queue().advance(bench.channel.now());
    bench.port.advance(3s);
    const QByteArray rest = bench.port.hostReads().join();
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 35);
    // Progress reports of 62 bytes come each 0.6 s while tuning: after "stop" there are none.
    QVERIFY2(rest.count(encodeFrame(35, {}, 1).first(2)) <= 1, "the board is still tuning");
}

void TestSbgcDevice::steersToAnAngle()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.board().stabilizer().imu().gyroCorrection = bench.board().stabilizer().imu().gyroBias;
    const auto reply = bench.device.perform(
        bench.channel, u"steer"_s,
        argumentsFor(bench.device, "steer",
                     {{u"yaw"_s, u"25"_s}, {u"speed"_s, u"40"_s}, {u"seconds"_s, u"3"_s}}));
    QVERIFY(reply);
    QVERIFY(std::abs(reply->value(u"imu.yaw"_s).toDouble() - 25.0) < 1.5);
    QVERIFY(std::abs(reply->value(u"imu.pitch"_s).toDouble()) < 1.5);
    QVERIFY(std::abs(bench.board().stabilizer().estimate(Axis::Yaw) - 25.0) < 1.5);
}

void TestSbgcDevice::speedModeStopsAtTheEnd()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    QVERIFY(bench.device.perform(
        bench.channel, u"steer"_s,
        argumentsFor(bench.device, "steer",
                     {{u"mode"_s, u"speed"_s}, {u"pitch"_s, u"15"_s}, {u"seconds"_s, u"2"_s}})));
    const double reached = bench.board().stabilizer().target(Axis::Pitch);
    QVERIFY2(reached > 24 && reached < 36, qPrintable(QString::number(reached)));
    std::ignore = bench.channel.sleep(2s);
    QCOMPARE(bench.board().stabilizer().target(Axis::Pitch), reached);
    QCOMPARE(
        bench.device.perform(bench.channel, u"steer"_s, argumentsFor(bench.device, "steer")).error().code,
        ErrorCode::InvalidArgument);
}

void TestSbgcDevice::everyControlModeIsEncoded()
{
    VirtualBoard old(options(2439));
    VirtualBoard now(options(2738));
    QVERIFY(old.identify());
    QVERIFY(now.identify());
    // All but those that steer nothing.
    QCOMPARE(old.device.modes().size(), std::size_t(5));
    QCOMPARE(now.device.modes().size(), std::size_t(7));
    for (const int still : {int(NoControl), int(Ignore)}) {
        simplebgc::Device::Control control{};
        control[1].mode = still;
        const auto command
            = decodeControl(asBytes(now.device.controlFrames(control).setpoint).subspan(4, 15));
        QCOMPARE((*command)[1].mode, still);
        const auto stop = decodeControl(asBytes(now.device.controlFrames(control).stop).subspan(4, 15));
        QCOMPARE((*stop)[1].mode, still);
    }
    for (const SteeringMode &mode : now.device.modes()) {
        // Axes whose input is unknown keep what they do.
        SteeringSetpoint setpoint{mode.id, std::vector<double>(mode.inputs.size(), std::nan("")), {}};
        const bool usesSpeed = mode.find("speed") >= 0 || !mode.isPositional();
        setpoint.inputs[1] = mode.isPositional() ? 20.0 : 30.0;
        if (mode.find("speed") >= 0)
            setpoint.inputs[std::size_t(mode.find("speed"))] = 30.0;
        const ControlFrames frames = now.device.controlFrames(setpoint);
        const auto command = decodeControl(asBytes(frames.setpoint).subspan(4, 15));
        QVERIFY(command);
        QCOMPARE((*command)[1].mode & 0x0F, mode.id);
        QCOMPARE((*command)[0], ControlAxis());
        if (usesSpeed)
            QCOMPARE((*command)[1].speed, 246);  // 30 °/s, errata section 8
        const auto stop = decodeControl(asBytes(frames.stop).subspan(4, 15));
        QCOMPARE((*stop)[1].speed, 0);
        QCOMPARE(frames.release, encodeFrame(67, QByteArray(13, '\0')));
    }
    // Slow motion uses the fine unit where the firmware has it; before 2.55b5 all axes share one mode byte.
    simplebgc::Device::Control slow{};
    slow[2] = {Speed, 0.5, 0};
    const auto fine = decodeControl(asBytes(now.device.controlFrames(slow).setpoint).subspan(4, 15));
    QCOMPARE((*fine)[2].mode, int(Speed) | int(ControlHighResSpeed));
    QCOMPARE((*fine)[2].speed, 500);
    QCOMPARE(old.device.controlFrames(slow).setpoint.size(), 13 + 5);
}

void TestSbgcDevice::resetIsAnnounced()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    QVERIFY(bench.device.writeAdjustables(bench.channel, {{0, 99}}));
    TimePoint notice{};
    bench.channel.setTap([&](const FrameView &frame, TimePoint at) {
        if (bench.device.announcesReset(frame))
            notice = at;
    });
    QVERIFY(bench.device.perform(bench.channel, u"reset"_s, argumentsFor(bench.device, "reset")));
    QVERIFY(notice != TimePoint());
    const auto gone = bench.channel.sleep(3s);
    QCOMPARE(gone.error().code, ErrorCode::LinkClosed);  // native USB vanishes
    QVERIFY(bench.channel.now() - notice > 950ms && bench.channel.now() - notice < 1100ms);
    bench.port.advance(2s);
    QVERIFY(bench.port.isPlugged());
    QCOMPARE(bench.board().inUse(u"pid.roll.p"_s), 35);  // volatile values are gone
}

void TestSbgcDevice::defaultsOverwriteAProfile()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 1), 45);
    QVERIFY(bench.device.perform(bench.channel, u"defaults"_s,
                                 argumentsFor(bench.device, "defaults", {{u"what"_s, u"profile2"_s}})));
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 1), 35);
    QCOMPARE(bench.board().stored(u"imu.gyro_trust"_s, 2), 190);
}

void TestSbgcDevice::motorsOffStopsEvenATuningBoard()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    QVERIFY(bench.channel.transact(
        confirmRequest(CommandId::AutoPid, hex("00 0F 80") + QByteArray(16, '\0'), 1)));
    std::ignore = bench.channel.sleep(1s);
    bench.channel.stopMotors(bench.device.stopPlan());
    std::ignore = bench.channel.sleep(200ms);
    QVERIFY(bench.channel.stopResult() && bench.channel.stopResult()->has_value());
    QVERIFY(!bench.board().stabilizer().motorsOn());
    std::ignore = bench.channel.sleep(2s);
    QVERIFY(!bench.board().stabilizer().motorsOn());
    QVERIFY(bench.device.switchMotorsOn(bench.channel));
    QVERIFY(bench.board().stabilizer().motorsOn());
}

void TestSbgcDevice::debugVariablesAreListedAndRead()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const auto list = bench.device.perform(bench.channel, u"debug.list"_s, {});
    QVERIFY(list);
    QCOMPARE(list->value(u"MOTOR_OUT"_s).toString(), u"f32[3]"_s);
    const auto values = bench.device.perform(bench.channel, u"debug.read"_s, {});
    QVERIFY(values);
    QCOMPARE(values->size(), list->size());
    QCOMPARE(values->value(u"CYCLE_US"_s).toInt(), 800);
    QCOMPARE(values->value(u"MOTOR_OUT"_s).toList().size(), 3);
}

void TestSbgcDevice::faultsAreNamed()
{
    SimulatorOptions o;
    o.faults.noImu = true;
    o.faults.battery = 9.5;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    QVERIFY(bench.device.readConfiguration(bench.channel));  // a missing sensor never stops reading
    std::ignore = bench.channel.sleep(1s);
    const auto frame
        = bench.channel.transact(replyRequest(CommandId::RealtimeData3, {}, CommandId::RealtimeData3, 63, 1));
    const unsigned bits = ByteReader(QByteArrayView(frame->payload).sliced(14)).u16();
    QStringList keys;
    for (const BoardFault &fault : bench.device.faults(bits, 0)) {
        keys.append(fault.key);
        QVERIFY(!fault.meaning.isEmpty() && !fault.cure.isEmpty());
    }
    QCOMPARE(keys, (QStringList{u"no-sensor"_s, u"low-battery"_s, u"battery-empty"_s}));
    QVERIFY(!bench.board().stabilizer().motorsOn());
    QVERIFY(bench.device.faults(1 << 11, 9).front().name.contains(u"inversion"_s));
    QCOMPARE(bench.device.faults(0xFFF, 0).size(), std::size_t(12));
}

void TestSbgcDevice::streamsAtFullRateWithoutLoss()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    TelemetryStore store(int(bench.device.channels().size()));
    const ChannelRoles roles = rolesOf(bench.device);
    const QList<int> wanted{roles.angle[0], roles.gyro[1]};
    const auto plan = bench.device.subscribe(bench.channel, {wanted, 0}, {});
    QVERIFY(plan);
    QVERIFY(plan->streaming);
    QCOMPARE(plan->rate, 1250.0);
    bench.channel.setTap(
        [&](const FrameView &frame, TimePoint at) { plan->decoder->decode(frame, at, store); });
    std::ignore = bench.channel.sleep(4s);
    // A long read in between costs nothing.
    QVERIFY(bench.device.readConfiguration(bench.channel));
    const auto tracks = store.tracks(roles.gyro[1]);
    QCOMPARE(tracks.size(), std::size_t(1));
    QVERIFY(tracks[0].end() >= 5000);
    QCOMPARE(store.lost(), quint64(0));
    // Samples are evenly spaced, not at their times of arrival.
    for (std::size_t row = 1000; row < 4000; ++row) {
        const double step = tracks[0].time(row) - tracks[0].time(row - 1);
        QVERIFY2(std::abs(step - 0.0008) < 0.0002, qPrintable(QString::number(step)));
    }
    // Status channels come beside the fast ones.
    QVERIFY(std::abs(double(store.latest(roles.battery)) - 12.3) < 0.3);
    bench.channel.post(fireAndForget(plan->shutdownFrames));
    std::ignore = bench.channel.sleep(100ms);
    const auto rows = store.rows();
    std::ignore = bench.channel.sleep(500ms);
    QVERIFY(store.rows() <= rows + 1);
}

void TestSbgcDevice::oldFirmwareIsPolled()
{
    VirtualBoard bench(options(2439));
    QVERIFY(bench.identify());
    const auto plan = bench.device.subscribe(bench.channel, {}, {});
    QVERIFY(plan);
    QVERIFY(!plan->streaming);
    QVERIFY(plan->poll);
    TelemetryStore store(int(bench.device.channels().size()));
    const auto reply = bench.channel.transact(*plan->poll);
    QVERIFY(reply);
    plan->decoder->decode({reply->id, asBytes(reply->payload), 1}, bench.channel.now(), store);
    QVERIFY(double(store.latest(rolesOf(bench.device).battery)) > 11.0);
    QVERIFY(bench.device.fastChannels().isEmpty());
}

void TestSbgcDevice::pollsWhenAllStreamsAreTaken()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    // The board has ten streams (errata 3.10); somebody else holds them all.
    for (int i = 0; i < 10; ++i) {
        const DataStream taken{88, 1000, QByteArray(1, char(1 + i)) + QByteArray(7, '\0')};
        QVERIFY(bench.channel.transact(confirmRequest(CommandId::DataStreamInterval, taken.encode(), 1)));
    }
    const auto plan = bench.device.subscribe(bench.channel, {{rolesOf(bench.device).gyro[0]}, 0}, {});
    QVERIFY(plan);
    QVERIFY(!plan->streaming && plan->poll);
}

void TestSbgcDevice::streamFitsASlowLine()
{
    SimulatorOptions o;
    o.usb = false;
    const LineSettings line{115200, Parity::None};
    VirtualBoard bench(o, line);
    std::ignore = bench.channel.setLine(line);
    QVERIFY(bench.identify());
    const ChannelRoles roles = rolesOf(bench.device);
    const auto plan
        = bench.device.subscribe(bench.channel, {{roles.angle[0], roles.target[0], roles.gyro[0]}, 0}, line);
    QVERIFY(plan);
    // 25 bytes a frame: 443/s would fill the line (performance notes, section 1); some is left for requests.
    QVERIFY2(plan->rate > 280 && plan->rate < 400, qPrintable(QString::number(plan->rate)));
    TelemetryStore store(int(bench.device.channels().size()));
    bench.channel.setTap(
        [&](const FrameView &frame, TimePoint at) { plan->decoder->decode(frame, at, store); });
    std::ignore = bench.channel.sleep(3s);
    QCOMPARE(store.lost(), quint64(0));
    QVERIFY(store.tracks(roles.gyro[0])[0].end() > std::size_t(2.5 * plan->rate));
}

void TestSbgcDevice::lostFramesAreCountedAsGaps()
{
    SimulatorOptions o;
    o.faults.loseByte = 0.0006;
    o.seed = 4;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    const ChannelRoles roles = rolesOf(bench.device);
    const auto plan = bench.device.subscribe(bench.channel, {{roles.gyro[0]}, 0}, {});
    QVERIFY(plan);
    TelemetryStore store(int(bench.device.channels().size()));
    quint64 frames = 0;
    bench.channel.setTap([&](const FrameView &frame, TimePoint at) {
        frames += frame.id == 88;
        plan->decoder->decode(frame, at, store);
    });
    const TimePoint start = bench.channel.now();
    std::ignore = bench.channel.sleep(8s);
    const double sent = seconds(bench.channel.now() - start) * 1250.0;
    QVERIFY(store.lost() > 20);
    QVERIFY2(std::abs(double(frames + store.lost()) - sent) < 0.01 * sent,
             qPrintable(u"%1 + %2 of %3"_s.arg(frames).arg(store.lost()).arg(sent)));
}

void TestSbgcDevice::streamsChosenByHandAllRun()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const ChannelRoles roles = rolesOf(bench.device);
    // clang-format off
    const Subscription wish{{}, 0, {{u"custom"_s, 500, {roles.gyro[0]}}, {u"realtime4"_s, 200, {}}, {u"realtime3"_s, 50, {}},
                                     {u"helper"_s, 100, {}}}};
    // clang-format on
    const auto plan = bench.device.subscribe(bench.channel, wish, {});
    QVERIFY(plan);
    QCOMPARE(plan->budget.streams.size(), std::size_t(4));
    QCOMPARE(plan->rate, 500.0);
    TelemetryStore store(int(bench.device.channels().size()));
    QMap<int, int> frames;
    bench.channel.setTap([&](const FrameView &frame, TimePoint at) {
        ++frames[frame.id];
        plan->decoder->decode(frame, at, store);
    });
    std::ignore = bench.channel.sleep(4s);
    QVERIFY(std::abs(frames[88] - 2000) < 20 && std::abs(frames[25] - 800) < 10);
    QVERIFY(std::abs(frames[23] - 200) < 5 && std::abs(frames[56] - 400) < 6);
    QCOMPARE(store.lost(), quint64(0));
    QCOMPARE(store.silences(), quint64(0));
    // Each channel comes from the fastest stream that has it, and only from there.
    const auto periodOf = [&](const char *key) {
        const auto tracks = store.tracks(findChannel(bench.device.channels(), QString::fromLatin1(key)));
        return tracks.size() == 1 ? tracks[0].period() : -1.0;
    };
    QCOMPARE(periodOf("gyro.roll"), 0.002);
    QCOMPARE(periodOf("imu.angle.roll"), 0.005);
    QCOMPARE(periodOf("battery"), 0.005);
    QCOMPARE(periodOf("z1.z"), 0.01);
    QVERIFY(std::abs(double(store.latest(findChannel(bench.device.channels(), u"z1.z"_s))) - 1.0) < 0.05);
    // The shutdownFrames stops them all.
    QCOMPARE(plan->shutdownFrames.count(char(0x55)) >= 4, true);
    bench.channel.post(fireAndForget(plan->shutdownFrames));
    std::ignore = bench.channel.sleep(100ms);
    frames.clear();
    std::ignore = bench.channel.sleep(500ms);
    QCOMPARE(frames.value(88) + frames.value(25) + frames.value(23) + frames.value(56), 0);
}

void TestSbgcDevice::laterFieldsAreFoundByAsking_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<quint32>("flags");
    QTest::newRow("2.59") << 2590 << quint32(0x1FF);
    QTest::newRow("2.66, none of the later ones") << 2660 << quint32(0x1FF);
    QTest::newRow("2.70, some of them") << 2700 << quint32(0x1FFFFF);
    QTest::newRow("2.73, all that are described") << 2739 << quint32(0x1FFFFFFF);
}

void TestSbgcDevice::laterFieldsAreFoundByAsking()
{
    QFETCH(int, firmware);
    QFETCH(quint32, flags);
    SimulatorOptions o;
    o.firmware = firmware;
    VirtualBoard bench(o);
    int asked = 0;
    bench.channel.setTap([&](const FrameView &frame, TimePoint) { asked += frame.id == 88; });
    QVERIFY(bench.identify());
    QVERIFY2(firmware >= 2610 ? asked >= 2 && asked < 30 : asked == 0, qPrintable(QString::number(asked)));
    QList<int> wanted;
    for (const simplebgc::WireField &field : simplebgc::customLayout(flags))
        wanted.append(field.channel);
    QCOMPARE(bench.device.fastChannels(), wanted);
    // What the firmware does not have is not asked for, and said.
    const auto budget = bench.device.streamBudget({{}, 0, {{u"custom"_s, 100, {simplebgc::FrameQuatX}}}}, {});
    QCOMPARE(bool(budget), firmware >= 2730);
    if (!budget)
        QCOMPARE(budget.error().code, ErrorCode::InvalidArgument);
}

void TestSbgcDevice::eachFlagOfCustomDelivers()
{
    SimulatorOptions o;
    o.firmware = 2739;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    for (const simplebgc::CustomField &field : simplebgc::customFields()) {
        const int channel = field.fields.front().channel;
        const QByteArray key = bench.device.channels()[std::size_t(channel)].key;
        const auto plan = bench.device.subscribe(bench.channel, {{}, 0, {{u"custom"_s, 250, {channel}}}}, {});
        QVERIFY2(plan, key);
        TelemetryStore store(int(bench.device.channels().size()));
        bench.channel.setTap(
            [&](const FrameView &frame, TimePoint at) { plan->decoder->decode(frame, at, store); });
        std::ignore = bench.channel.sleep(200ms);
        for (const simplebgc::WireField &wire : field.fields) {
            QVERIFY2(store.tracks(wire.channel).size() == 1 && store.tracks(wire.channel)[0].end() > 40, key);
            QVERIFY2(!std::isnan(store.latest(wire.channel)), key);
        }
        QCOMPARE(store.lost(), quint64(0));
        bench.channel.setTap({});
    }
    // Different codings of one angle agree.
    const QList<int> same{simplebgc::ImuPitch, simplebgc::ImuRadPitch, simplebgc::Imu20Pitch,
                          simplebgc::ImuQuatW};
    const auto plan = bench.device.subscribe(bench.channel, {same, 0, {}}, {});
    QVERIFY(plan);
    TelemetryStore store(int(bench.device.channels().size()));
    bench.channel.setTap(
        [&](const FrameView &frame, TimePoint at) { plan->decoder->decode(frame, at, store); });
    bench.board().stabilizer().setTarget(Axis::Pitch, 20);
    std::ignore = bench.channel.sleep(2s);
    const auto latest = [&](int channel) { return double(store.latest(channel)); };
    QVERIFY2(std::abs(latest(simplebgc::ImuPitch)) > 1,
             qPrintable(QString::number(latest(simplebgc::ImuPitch))));
    QVERIFY(std::abs(latest(simplebgc::ImuPitch) - latest(simplebgc::ImuRadPitch)) < 0.012);
    QVERIFY(std::abs(latest(simplebgc::Imu20Pitch) - latest(simplebgc::ImuRadPitch)) < 0.0004);
    bench.channel.setTap({});
    // More than a frame can carry is refused before anything is sent.
    const auto most = bench.device.subscribe(bench.channel, {bench.device.fastChannels(), 0, {}}, {});
    QVERIFY(!most);
    QCOMPARE(most.error().code, ErrorCode::TooMuch);
    QVERIFY(most.error().detail.contains(u"255"_s));
}

void TestSbgcDevice::streamsThatDoNotFitAreRefused_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<double>("rate");
    QTest::addColumn<int>("baud");
    QTest::addColumn<int>("code");
    QTest::newRow("too fast for the line") << u"realtime4"_s << 100.0 << 115200 << int(ErrorCode::TooMuch);
    QTest::newRow("just fits") << u"realtime4"_s << 75.0 << 115200 << -1;
    QTest::newRow("fits a faster line") << u"realtime4"_s << 500.0 << 921600 << -1;
    QTest::newRow("faster than the board")
        << u"realtime4"_s << 2000.0 << 921600 << int(ErrorCode::InvalidArgument);
    QTest::newRow("no such stream") << u"realtime5"_s << 10.0 << 115200 << int(ErrorCode::InvalidArgument);
    QTest::newRow("custom of nothing") << u"custom"_s << 10.0 << 115200 << int(ErrorCode::InvalidArgument);
}

void TestSbgcDevice::streamsThatDoNotFitAreRefused()
{
    QFETCH(QString, key);
    QFETCH(double, rate);
    QFETCH(int, baud);
    QFETCH(int, code);
    SimulatorOptions o;
    o.usb = false;
    const LineSettings line{baud, Parity::None};
    VirtualBoard bench(o, line);
    std::ignore = bench.channel.setLine(line);
    QVERIFY(bench.identify());
    const auto plan = bench.device.subscribe(bench.channel, {{}, 0, {{key, rate, {}}}}, line);
    QCOMPARE(plan ? -1 : int(plan.error().code), code);
    // The numbers are in it: 100 frames of 129 bytes against 85 % of 11520.
    if (code == int(ErrorCode::TooMuch))
        QVERIFY2(plan.error().detail.contains(u"12903"_s) || plan.error().detail.contains(u"12900"_s),
                 qPrintable(plan.error().detail));
}

void TestSbgcDevice::wireRatesAreThoseOfTheTable_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QStringList>("channels");
    QTest::addColumn<int>("baud");
    QTest::addColumn<bool>("even");
    QTest::addColumn<double>("rate");
    // Errata 1.3 and 3.8-3.10: frame version 1, payload and 5 bytes, 10 or 11 bits a byte.
    QTest::newRow("4 at 115200") << u"realtime4"_s << QStringList() << 115200 << false << 89.0;
    QTest::newRow("4 at 115200 8E1") << u"realtime4"_s << QStringList() << 115200 << true << 81.0;
    QTest::newRow("3 at 256000") << u"realtime3"_s << QStringList() << 256000 << false << 376.0;
    QTest::newRow("gyro at 115200") << u"custom"_s << QStringList{u"gyro.roll"_s} << 115200 << false << 886.0;
    QTest::newRow("gyro and acc at 115200")
        << u"custom"_s << QStringList{u"gyro.roll"_s, u"acc.x"_s} << 115200 << false << 606.0;
}

void TestSbgcDevice::wireRatesAreThoseOfTheTable()
{
    QFETCH(QString, key);
    QFETCH(QStringList, channels);
    QFETCH(int, baud);
    QFETCH(bool, even);
    QFETCH(double, rate);
    SimulatorOptions o;
    o.usb = false;
    const LineSettings line{baud, even ? Parity::Even : Parity::None};
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    QList<int> wanted;
    for (const QString &name : channels)
        wanted.append(findChannel(bench.device.channels(), name));
    const auto budget = bench.device.streamBudget({{}, 0, {{key, 0, wanted}}}, line);
    QVERIFY(budget);
    QVERIFY(budget->fits());
    // As fast as goes: the share for streams, rounded down to whole milliseconds or the firmware's cycle.
    const StreamUse &use = budget->streams.front();
    const double wire = budget->capacity / use.frameBytes;
    QVERIFY2(std::abs(wire - rate) < 1.0, qPrintable(QString::number(wire)));
    QVERIFY(use.rate <= wire * StreamBudget::kShare);
    QVERIFY(1000.0 / use.rate - 1000.0 / (wire * StreamBudget::kShare) < 1.0001);
}

void TestSbgcDevice::lossIsFoundWithoutStamps()
{
    SimulatorOptions o;
    o.faults.loseByte = 0.0003;
    o.seed = 4;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    const auto plan = bench.device.subscribe(bench.channel, {{}, 0, {{u"realtime4"_s, 1250, {}}}}, {});
    QVERIFY(plan);
    TelemetryStore store(int(bench.device.channels().size()));
    quint64 frames = 0;
    bench.channel.setTap([&](const FrameView &frame, TimePoint at) {
        frames += frame.id == 25;
        plan->decoder->decode(frame, at, store);
    });
    const TimePoint start = bench.channel.now();
    std::ignore = bench.channel.sleep(12s);
    const double sent = seconds(bench.channel.now() - start) * 1250.0;
    QVERIFY(store.lost() > 100);
    // The loss of the last second is found a second later.
    QVERIFY2(std::abs(double(frames + store.lost()) - sent) < 0.01 * sent,
             qPrintable(u"%1 + %2 of %3"_s.arg(frames).arg(store.lost()).arg(sent)));
}

void TestSbgcDevice::silenceIsNoLoss_data()
{
    QTest::addColumn<QString>("stream");
    QTest::newRow("with stamps") << u"custom"_s;
    QTest::newRow("without stamps") << u"realtime4"_s;
}

void TestSbgcDevice::silenceIsNoLoss()
{
    QFETCH(QString, stream);
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const int gyro = rolesOf(bench.device).gyro[0];
    const auto plan = bench.device.subscribe(bench.channel, {{}, 0, {{stream, 1250, {gyro}}}}, {});
    QVERIFY(plan);
    TelemetryStore store(int(bench.device.channels().size()));
    bool deaf = false;  // the board calibrates and says nothing
    bench.channel.setTap([&](const FrameView &frame, TimePoint at) {
        if (!deaf)
            plan->decoder->decode(frame, at, store);
    });
    std::ignore = bench.channel.sleep(3s);
    deaf = true;
    std::ignore = bench.channel.sleep(2s);
    deaf = false;
    std::ignore = bench.channel.sleep(3s);
    QCOMPARE(store.lost(), quint64(0));
    QCOMPARE(store.silences(), quint64(1));
    QVERIFY2(std::abs(store.silentSeconds() - 2.0) < 0.05,
             qPrintable(QString::number(store.silentSeconds())));
    // It is drawn as a gap, and the samples behind it have their right times.
    const auto tracks = store.tracks(gyro);
    QCOMPARE(tracks.size(), std::size_t(1));
    int holes = 0;
    for (std::size_t row = tracks[0].begin(); row < tracks[0].end(); ++row)
        holes += std::isnan(tracks[0].value(row));
    QCOMPARE(holes, 1);
    const double newest = tracks[0].time(tracks[0].end() - 1);
    QVERIFY2(std::abs(newest - store.secondsAt(bench.channel.now())) < 0.02,
             qPrintable(QString::number(newest)));
}

void TestSbgcDevice::survivesADisturbedCable()
{
    SimulatorOptions o;
    o.faults.flipByte = 0.0008;
    o.faults.loseByte = 0.0004;
    o.faults.doubleByte = 0.0004;
    o.faults.delayMs = 20;
    VirtualBoard bench(o);
    for (int i = 0; i < 10 && !bench.identify(); ++i) { }
    QVERIFY(!bench.device.identity().serial.isEmpty());
    int complete = 0;
    for (int i = 0; i < 5; ++i) {
        const auto configuration = bench.device.readConfiguration(bench.channel);
        if (!configuration)
            continue;
        complete += configuration->blocks().size() == 15;
        // What arrived is right, whatever the cable did.
        for (const ParameterSpec &spec : configuration->parameters().all()) {
            const auto raw = configuration->raw(spec, 4);
            if (raw && !spec.row->state && spec.key != u"imu.skip_gyro_calibration"_s)
                QCOMPARE(*raw, spec.defaultRaw);
        }
    }
    QVERIFY(complete >= 3);
}

void TestSbgcDevice::argumentsAreChecked()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    for (const ActionSpec &action : bench.device.actions()) {
        QVERIFY(*action.label && *action.help && *action.group);
        QVERIFY(!parseArguments(action, {{u"nonsense"_s, u"1"_s}}));
        for (const ArgumentSpec &argument : action.arguments) {
            if (argument.kind != ArgumentKind::Text)
                QVERIFY(!parseArguments(action, {{QLatin1String(argument.key), u"what"_s}}));
        }
    }
    QCOMPARE(bench.device.perform(bench.channel, u"nonsense"_s, {}).error().code, ErrorCode::Unsupported);
}

QTEST_APPLESS_MAIN(TestSbgcDevice)
#include "tst_sbgcdevice.moc"
