// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/virtualboard.h"

#include <QTest>

#include <cmath>

using namespace simplebgc;
using namespace Qt::StringLiterals;

/// Calibrations and the automatic tuning of a SimpleBGC board, on the simulated one in virtual time.
class TestSbgcCalibration : public QObject
{
    Q_OBJECT
private slots:
    void gyroCalibrationRemovesTheBias_data();
    void gyroCalibrationRemovesTheBias();
    void accCalibrationLevelsTheHorizon();
    void calibrationOfAShakenCameraChangesNothing();
    void secondCalibrationIsRefusedMeanwhile();
    void calibrationCanBeCancelled();
    void autoTuneFindsAndSavesGains();
    void autoTuneStopsWhenCancelled();
    void errorEndsItAtOnce_data();
    void errorEndsItAtOnce();
};

void TestSbgcCalibration::gyroCalibrationRemovesTheBias_data()
{
    QTest::addColumn<QString>("form");
    QTest::newRow("extended: confirmed twice") << u"extended"_s;
    QTest::newRow("simple: confirmed at the end") << u"simple"_s;
}

void TestSbgcCalibration::gyroCalibrationRemovesTheBias()
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

void TestSbgcCalibration::accCalibrationLevelsTheHorizon()
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

void TestSbgcCalibration::calibrationOfAShakenCameraChangesNothing()
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

void TestSbgcCalibration::secondCalibrationIsRefusedMeanwhile()
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

void TestSbgcCalibration::calibrationCanBeCancelled()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.channel.cancelAfter(2s);
    const auto reply = bench.device.perform(bench.channel, u"calibrate.gyro"_s,
                                            argumentsFor(bench.device, "calibrate.gyro"));
    QCOMPARE(reply.error().code, ErrorCode::Cancelled);
}

void TestSbgcCalibration::autoTuneFindsAndSavesGains()
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

void TestSbgcCalibration::autoTuneStopsWhenCancelled()
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

void TestSbgcCalibration::errorEndsItAtOnce_data()
{
    QTest::addColumn<QString>("action");
    QTest::addColumn<QString>("form");
    QTest::newRow("gyroscope") << u"calibrate.gyro"_s << u"extended"_s;
    QTest::newRow("gyroscope, simple form") << u"calibrate.gyro"_s << u"simple"_s;
    QTest::newRow("accelerometer") << u"calibrate.acc"_s << u"extended"_s;
    QTest::newRow("auto-tune") << u"autotune"_s << QString();
}

// Its cause is told when the board tells it, not after a wait for an end that never comes.
void TestSbgcCalibration::errorEndsItAtOnce()
{
    QFETCH(QString, action);
    QFETCH(QString, form);
    SimulatorOptions o;
    o.faults.failWith = 10;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    const TimePoint started = bench.channel.now();
    const QMap<QString, QString> texts
        = form.isEmpty() ? QMap<QString, QString>() : QMap<QString, QString>{{u"form"_s, form}};
    const auto reply
        = bench.device.perform(bench.channel, action, argumentsFor(bench.device, action.toLatin1(), texts));
    QVERIFY(!reply);
    QCOMPARE(reply.error().code, ErrorCode::BoardError);
    QCOMPARE(reply.error().boardCode, 10);
    QVERIFY2(reply.error().detail.contains(u"operation failed"_s), qPrintable(reply.error().detail));
    QVERIFY(bench.channel.now() - started < 6s);
}

QTEST_APPLESS_MAIN(TestSbgcCalibration)
#include "tst_sbgccalibration.moc"
