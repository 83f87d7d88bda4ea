// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/channelproxy.h"
#include "tests/support/virtualboard.h"

#include <QTest>

#include <cmath>

using namespace simplebgc;
using namespace Qt::StringLiterals;

namespace {

/// A mailbox in which the confirmation of a start lies before anything else.
class StartTwice final : public Mailbox
{
public:
    StartTwice(std::unique_ptr<Mailbox> rest, int command)
        : m_rest(std::move(rest))
        , m_command(command)
    {
    }
    Result<Frame> next(milliseconds timeout) override
    {
        if (!std::exchange(m_isDone, true)) {
            Frame frame;
            frame.id = number(CommandId::Confirm);
            frame.payload = QByteArray(1, char(m_command));
            return frame;
        }
        return m_rest->next(timeout);
    }

private:
    std::unique_ptr<Mailbox> m_rest;
    int m_command;
    bool m_isDone = false;
};

/// A line that loses answers to one kind of request, or answers them as before.
class Disturbed final : public ChannelProxy
{
public:
    using ChannelProxy::ChannelProxy;
    Result<Frame> transact(const Request &request) override
    {
        if (request.name == frozen) {
            if (!m_first)
                m_first = ChannelProxy::transact(request);
            return *m_first;
        }
        const auto answer = ChannelProxy::transact(request);
        if (request.name == lossy && lost-- > 0)
            return failure(ErrorCode::Timeout, request.name);
        return answer;
    }
    std::unique_ptr<Mailbox> listen(std::function<bool(const FrameView &)> filter) override
    {
        auto box = ChannelProxy::listen(std::move(filter));
        if (startsTwice == 0)
            return box;
        return std::make_unique<StartTwice>(std::move(box), startsTwice);
    }

    QString lossy;
    int lost = 1;
    QString frozen;
    int startsTwice = 0;

private:
    std::optional<Result<Frame>> m_first;
};

}  // namespace

/// Calibrations and the automatic tuning of a SimpleBGC board, on the simulated one in virtual time.
class TestSbgcCalibration : public QObject
{
    Q_OBJECT
private slots:
    void gyroCalibrationRemovesTheBias_data();
    void gyroCalibrationRemovesTheBias();
    void accCalibrationLevelsTheHorizon();
    void driftOfTheGyroscopeIsNoErrorOfTheAccelerometer_data();
    void driftOfTheGyroscopeIsNoErrorOfTheAccelerometer();
    void motorsAreOffBetweenPositions();
    void motorsThatMayRunStopIt();
    void turnedSensorIsRefusedWhileMotorsRun();
    void shakenCameraIsNotCalibrated();
    void impossibleReadingIsNotTaken();
    void missingSensorIsNotCalibrated_data();
    void missingSensorIsNotCalibrated();
    void secondCalibrationIsRefusedMeanwhile();
    void calibrationCanBeCancelled();
    void autoTuneFindsAndSavesGains_data();
    void autoTuneFindsAndSavesGains();
    void autoTuneLowersTheFilter_data();
    void autoTuneLowersTheFilter();
    void autoTuneStopsWhenCancelled();
    void confirmedStopOfASearchProvesNothing();
    void startConfirmedTwiceIsNoEnd();
    void searchThatFailsLeavesNothing();
    void searchWithoutAnswerIsStopped_data();
    void searchWithoutAnswerIsStopped();
    void searchThatChangedNothingIsNoSuccess();
    void calibrationWithoutAnswerIsAwaited();
    void startHeardTwiceIsNoEnd();
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

void TestSbgcCalibration::driftOfTheGyroscopeIsNoErrorOfTheAccelerometer_data()
{
    QTest::addColumn<int>("seed");
    QTest::addColumn<int>("waits");
    for (int seed = 1; seed <= 3; ++seed) {
        QTest::addRow("at once, %d", seed) << seed << 0;
        QTest::addRow("later, %d", seed) << seed << 20;
    }
}

// A gyroscope that nobody has calibrated has the motors hold the camera tilted, before and after.
void TestSbgcCalibration::driftOfTheGyroscopeIsNoErrorOfTheAccelerometer()
{
    QFETCH(int, seed);
    QFETCH(int, waits);
    SimulatorOptions options;
    options.seed = unsigned(seed);
    VirtualBoard bench(options);
    QVERIFY(bench.identify());
    std::ignore = bench.channel.sleep(std::chrono::seconds(waits));
    const QVariantMap arguments = argumentsFor(bench.device, "calibrate.acc");
    // Confirmed and not done, it is told as that all the same.
    Altering swallowing(bench.channel, [&](const Request &each, const Altering::Pass &pass) -> Result<Frame> {
        return each.name == u"CALIB_ACC"_s ? Frame{} : pass(each);
    });
    const auto swallowed
        = bench.device.perform(swallowing, u"calibrate.acc"_s,
                               argumentsFor(bench.device, "calibrate.acc", {{u"form"_s, u"simple"_s}}));
    QVERIFY(!swallowed);
    QCOMPARE(swallowed.error().code, ErrorCode::NoEffect);
    const auto done = bench.device.perform(bench.channel, u"calibrate.acc"_s, arguments);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QVERIFY(bench.board().stabilizer().motorsOn());
    QVERIFY(std::abs(bench.board().stabilizer().gravity()[1]) > 0.03);  // tilted it is
    const double before = done->value(u"acc.error.before"_s).toDouble();
    const double after = done->value(u"acc.error.after"_s).toDouble();
    QVERIFY2(before > 0.03 && after < 0.01, qPrintable(u"%1 %2"_s.arg(before).arg(after)));
}

// Whoever asks for it, and whatever the board does by itself at the end of a measurement.
void TestSbgcCalibration::motorsAreOffBetweenPositions()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const QVariantMap arguments = argumentsFor(bench.device, "calibrate.acc", {{u"six"_s, u"on"_s}});
    for (int pose = 1; pose <= 6; ++pose) {
        Faults faults;
        faults.pose = pose;
        bench.board().setFaults(faults);
        bench.board().stabilizer().setMotorsOn(pose % 2 == 1);  // by a button on the handle, say
        const auto reply = bench.device.perform(bench.channel, u"calibrate.acc"_s, arguments);
        QVERIFY2(reply, reply ? "" : qPrintable(reply.error().detail));
        QCOMPARE(reply->value(u"motors_switched_off"_s).toBool(), pose % 2 == 1);
        QVERIFY(!bench.board().stabilizer().motorsOn());
    }
}

void TestSbgcCalibration::motorsThatMayRunStopIt()
{
    SimulatorOptions o;
    o.faults.deaf = number(CommandId::MotorsOff);
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    const TimePoint started = bench.channel.now();
    const auto reply
        = bench.device.perform(bench.channel, u"calibrate.acc"_s,
                               argumentsFor(bench.device, "calibrate.acc", {{u"six"_s, u"on"_s}}));
    QVERIFY(!reply);
    QCOMPARE(reply.error().code, ErrorCode::NotProven);
    QVERIFY(bench.board().stabilizer().motorsOn());
    QVERIFY(bench.channel.now() - started < 4s);  // nothing was measured
}

void TestSbgcCalibration::turnedSensorIsRefusedWhileMotorsRun()
{
    SimulatorOptions o;
    o.faults.pose = 3;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    const auto refused = bench.device.perform(bench.channel, u"calibrate.acc"_s,
                                              argumentsFor(bench.device, "calibrate.acc"));
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::ConditionUnmet);
    bench.board().stabilizer().setMotorsOn(false);
    QVERIFY(
        bench.device.perform(bench.channel, u"calibrate.acc"_s, argumentsFor(bench.device, "calibrate.acc")));
}

void TestSbgcCalibration::shakenCameraIsNotCalibrated()
{
    SimulatorOptions o;
    o.faults.shake = 8;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    bench.board().stabilizer().setMotorsOn(false);
    for (const char *action : {"calibrate.gyro", "calibrate.acc"}) {
        const auto reply = bench.device.perform(bench.channel, QString::fromLatin1(action),
                                                argumentsFor(bench.device, action));
        QVERIFY(!reply);
        QCOMPARE(reply.error().code, ErrorCode::ConditionUnmet);
        QVERIFY2(reply.error().detail.contains(u"the sensor moves"_s), qPrintable(reply.error().detail));
    }
    QCOMPARE(bench.board().stabilizer().imu().gyroCorrection[0], 0.0);
    QCOMPARE(bench.board().stabilizer().imu().accCorrection[2], 0.0);
}

// What no sensor at rest measures is not calibrated away; what an earlier calibration did can be reset.
void TestSbgcCalibration::impossibleReadingIsNotTaken()
{
    SimulatorOptions o;
    o.faults.pose = 1;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    bench.board().stabilizer().setMotorsOn(false);
    bench.board().stabilizer().imu().accError = {0, 0, 0.4};
    for (const char *six : {"off", "on"}) {
        const auto reply = bench.device.perform(
            bench.channel, u"calibrate.acc"_s,
            argumentsFor(bench.device, "calibrate.acc", {{u"six"_s, QLatin1String(six)}}));
        QVERIFY(!reply);
        QCOMPARE(reply.error().code, ErrorCode::ConditionUnmet);
        QVERIFY2(reply.error().detail.contains(u"1.42 g instead of 1 g"_s), qPrintable(reply.error().detail));
        QVERIFY(!bench.board().isCalibrating());
    }
    QVERIFY(bench.device.perform(
        bench.channel, u"calibrate.acc"_s,
        argumentsFor(bench.device, "calibrate.acc", {{u"action"_s, u"restore-factory"_s}})));
}

void TestSbgcCalibration::missingSensorIsNotCalibrated_data()
{
    QTest::addColumn<QString>("action");
    QTest::addColumn<QString>("argument");
    QTest::newRow("gyroscope") << u"calibrate.gyro"_s << QString();
    QTest::newRow("gyroscope, simple form") << u"calibrate.gyro"_s << u"form=simple"_s;
    QTest::newRow("gyroscope, temperature") << u"calibrate.gyro"_s << u"action=temperature"_s;
    QTest::newRow("accelerometer") << u"calibrate.acc"_s << QString();
    QTest::newRow("accelerometer, six positions") << u"calibrate.acc"_s << u"six=on"_s;
    QTest::newRow("auto-tune") << u"autotune"_s << QString();
    QTest::newRow("menu, accelerometer") << u"menu"_s << u"command=6"_s;
    QTest::newRow("menu, gyroscope") << u"menu"_s << u"command=9"_s;
    QTest::newRow("menu, auto-tune") << u"menu"_s << u"command=16"_s;
}

// There are no figures from a sensor that is not there.
void TestSbgcCalibration::missingSensorIsNotCalibrated()
{
    QFETCH(QString, action);
    QFETCH(QString, argument);
    SimulatorOptions o;
    o.faults.noImu = true;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    QMap<QString, QString> texts;
    if (!argument.isEmpty())
        texts.insert(argument.section(u'=', 0, 0), argument.section(u'=', 1));
    const auto reply
        = bench.device.perform(bench.channel, action, argumentsFor(bench.device, action.toLatin1(), texts));
    QVERIFY(!reply);
    QCOMPARE(reply.error().code, ErrorCode::ConditionUnmet);
    QVERIFY2(reply.error().detail.contains(u"does not see its motion sensor"_s),
             qPrintable(reply.error().detail));
    QVERIFY(!bench.board().isCalibrating());
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

void TestSbgcCalibration::autoTuneFindsAndSavesGains_data()
{
    QTest::addColumn<int>("firmware");
    for (const int firmware : {2590, 2738})
        QTest::addRow("%d", firmware) << firmware;
}

// From 2.73.1 gains are stored, and reported, on a logarithmic scale (errata 3.3): what is told is what is
// shown.
void TestSbgcCalibration::autoTuneFindsAndSavesGains()
{
    QFETCH(int, firmware);
    VirtualBoard bench(withFirmware(firmware));
    QVERIFY(bench.identify());
    bench.board().stabilizer().imu().gyroCorrection = bench.board().stabilizer().imu().gyroBias;
    const auto reply = bench.device.perform(bench.channel, u"autotune"_s,
                                            argumentsFor(bench.device, "autotune", {{u"yaw"_s, u"off"_s}}));
    QVERIFY(reply);
    const double p = reply->value(u"p.roll"_s).toDouble();
    QVERIFY2(p > 15 && p < 200, qPrintable(QString::number(p)));
    const ParameterSet &set = *bench.device.parameters();
    for (const QString &gain : {u"p"_s, u"i"_s, u"d"_s}) {
        const ParameterSpec *spec = set.find(u"pid.roll."_s + gain);
        QCOMPARE(spec->toDisplay(bench.board().stored(spec->key, 0)),
                 reply->value(gain + u".roll"_s).toDouble());
    }
    const ParameterSpec *untouched = set.find(u"pid.yaw.p"_s);  // not chosen
    QCOMPARE(bench.board().stored(untouched->key, 0), int(untouched->defaultRaw));
    // Progress came with each iteration, with gains and tracking error.
    int reports = 0;
    for (const Progress &progress : bench.channel.progressReports())
        reports += progress.values.contains(u"error.roll"_s) && progress.values.value(u"p.roll"_s) < 200;
    QVERIFY(reports >= 10);
    // The found gains hold.
    std::ignore = bench.channel.sleep(2s);
    QVERIFY(std::abs(bench.board().stabilizer().estimate(Axis::Roll)) < 0.5);
}

void TestSbgcCalibration::autoTuneLowersTheFilter_data()
{
    QTest::addColumn<QString>("action");
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 3; ++seed) {
        QTest::addRow("all axes alike, %d", seed) << u"autotune"_s << seed;
        QTest::addRow("by axis, %d", seed) << u"autotune.by_axis"_s << seed;
    }
}

// Where it is asked to, and the filter is in use: lower, and held as well as with the gains alone.
void TestSbgcCalibration::autoTuneLowersTheFilter()
{
    QFETCH(QString, action);
    QFETCH(int, seed);
    const auto search = [&](const QString &lpf, QMap<QString, int> &filters) {
        SimulatorOptions options = withFirmware(2738);
        options.seed = unsigned(seed);
        VirtualBoard bench(options);
        if (!bench.identify())
            qFatal("no board");
        bench.board().stabilizer().imu().gyroCorrection = bench.board().stabilizer().imu().gyroBias;
        for (const QString &axis : {u"roll"_s, u"pitch"_s, u"yaw"_s}) {
            bench.board().store(u"filter.%1.lpf"_s.arg(axis), 0, 350);
            bench.board().store(u"filter.%1.enabled"_s.arg(axis), 0, axis == u"yaw"_s ? 0 : 8);
        }
        const auto done = bench.device.perform(bench.channel, action,
                                               argumentsFor(bench.device, action.toUtf8().constData(),
                                                            {{u"lpf"_s, lpf}, {u"keep"_s, u"off"_s}}));
        if (!done)
            qFatal("%s", qPrintable(done.error().detail));
        std::ignore = bench.channel.sleep(3s);  // back from the last step
        double squares = 0;
        constexpr int kLooks = 4000;
        for (int look = 0; look < kLooks; ++look) {
            std::ignore = bench.channel.sleep(5ms);
            squares += std::pow(bench.board().stabilizer().estimate(Axis::Pitch), 2);
        }
        for (const QString &axis : {u"roll"_s, u"pitch"_s, u"yaw"_s}) {
            filters.insert(axis, bench.board().inUse(u"filter.%1.lpf"_s.arg(axis)));
            if (bench.board().stored(u"filter.%1.lpf"_s.arg(axis), 0) != filters[axis])
                qFatal("it is in use and not stored");
            if (done->contains(u"lpf."_s + axis) && done->value(u"lpf."_s + axis).toInt() != filters[axis])
                qFatal("it tells another one");
        }
        return std::sqrt(squares / kLooks);
    };
    QMap<QString, int> left;
    QMap<QString, int> tuned;
    const double without = search(u"off"_s, left);
    const double with = search(u"on"_s, tuned);
    QCOMPARE(left, (QMap<QString, int>{{u"roll"_s, 350}, {u"pitch"_s, 350}, {u"yaw"_s, 350}}));
    qInfo("roll %d Hz, pitch %d Hz; pitch off by %.3f°, with the filter as it was %.3f°", tuned[u"roll"_s],
          tuned[u"pitch"_s], with, without);
    for (const QString &axis : {u"roll"_s, u"pitch"_s})
        QVERIFY(tuned[axis] >= 10 && tuned[axis] < 350);
    QCOMPARE(tuned[u"yaw"_s], 350);  // its filter is not in use
    QVERIFY(with < 1.3 * without);
}

void TestSbgcCalibration::autoTuneStopsWhenCancelled()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.channel.cancelAfter(3s);
    const auto reply
        = bench.device.perform(bench.channel, u"autotune"_s, argumentsFor(bench.device, "autotune"));
    QCOMPARE(reply.error().code, ErrorCode::Cancelled);
    // "Stop" and the old gains are sent although the job is over.
    bench.channel.cancelAfter(1h);
    QVERIFY(bench.channel.sleep(1s));
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 35);
    QCOMPARE(bench.board().inUse(u"pid.roll.p"_s), 35);
    QCOMPARE(bench.board().inUse(u"pid.yaw.i"_s), 12);
    const auto reports = bench.channel.listen([](const FrameView &frame) { return frame.id == 35; });
    QVERIFY2(!reports->next(3s), "the board is still tuning");
}

void TestSbgcCalibration::confirmedStopOfASearchProvesNothing()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    Faults faults;
    faults.runsOn = true;
    bench.board().setFaults(faults);
    // One that reports nothing, as another program starts it.
    const QByteArray start = ByteWriter().u8(0).u8(7).u8(100).zeros(16).take();
    QVERIFY(bench.channel.transact(confirmRequest(CommandId::AutoPid, start, 1)));
    const auto goesOn = bench.device.perform(bench.channel, u"autotune.stop"_s, {});
    QVERIFY(!goesOn);
    QCOMPARE(goesOn.error().code, ErrorCode::GoesOn);
    bench.board().setFaults({});
    QVERIFY(bench.device.perform(bench.channel, u"autotune.stop"_s, {}));
    const int p = bench.board().inUse(u"pid.roll.p"_s);
    QVERIFY(bench.channel.sleep(5s));
    QCOMPARE(bench.board().inUse(u"pid.roll.p"_s), p);
}

void TestSbgcCalibration::startConfirmedTwiceIsNoEnd()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.board().stabilizer().imu().gyroCorrection = bench.board().stabilizer().imu().gyroBias;
    bool isFirst = true;
    Altering doubled(bench.channel, [&](const Request &request, const Altering::Pass &pass) {
        const auto answer = pass(request);
        if (request.name == u"AUTO_PID"_s && std::exchange(isFirst, false)) {
            Request again = request;
            again.answer = {};  // nobody waits for its confirmation
            std::ignore = pass(again);
        }
        return answer;
    });
    const auto reply = bench.device.perform(
        doubled, u"autotune"_s,
        argumentsFor(bench.device, "autotune", {{u"yaw"_s, u"off"_s}, {u"save"_s, u"off"_s}}));
    QVERIFY2(reply, reply ? "" : qPrintable(reply.error().detail));
    QVERIFY(reply->value(u"iterations"_s).toInt() > 3);
    const int p = bench.board().inUse(u"pid.roll.p"_s);
    QVERIFY(bench.channel.sleep(5s));
    QCOMPARE(bench.board().inUse(u"pid.roll.p"_s), p);
}

// What the board had tried until it gave up is no result.
void TestSbgcCalibration::searchThatFailsLeavesNothing()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    Faults faults;
    faults.failWith = 3;
    bench.board().setFaults(faults);
    QVERIFY(bench.device.writeAdjustables(bench.channel, {{0, 37}}));
    const auto reply
        = bench.device.perform(bench.channel, u"autotune"_s, argumentsFor(bench.device, "autotune"));
    QVERIFY(!reply);
    QCOMPARE(bench.board().inUse(u"pid.roll.p"_s), 37);
    QCOMPARE(bench.board().inUse(u"pid.yaw.d"_s), bench.board().stored(u"pid.yaw.d"_s, 0));
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 35);
}

void TestSbgcCalibration::searchWithoutAnswerIsStopped_data()
{
    QTest::addColumn<int>("lost");
    QTest::newRow("answer to the start") << 1;
    QTest::newRow("answers to start and stop") << 2;
}

// The board tunes although nobody heard that it had begun.
void TestSbgcCalibration::searchWithoutAnswerIsStopped()
{
    QFETCH(int, lost);
    VirtualBoard bench;
    QVERIFY(bench.identify());
    Disturbed channel(bench.channel);
    channel.lossy = u"AUTO_PID"_s;
    channel.lost = lost;
    const auto reply = bench.device.perform(channel, u"autotune"_s, argumentsFor(bench.device, "autotune"));
    QVERIFY(!reply);
    QCOMPARE(reply.error().code, ErrorCode::Timeout);
    QVERIFY2(reply.error().detail.contains(u"reports no search any more"_s),
             qPrintable(reply.error().detail));
    const auto reports = bench.channel.listen([](const FrameView &frame) { return frame.id == 35; });
    QVERIFY(!reports->next(3s));
}

void TestSbgcCalibration::searchThatChangedNothingIsNoSuccess()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.board().stabilizer().imu().gyroCorrection = bench.board().stabilizer().imu().gyroBias;
    Disturbed channel(bench.channel);
    channel.frozen = u"GET_ADJ_VARS_VAL"_s;
    const auto reply = bench.device.perform(channel, u"autotune"_s, argumentsFor(bench.device, "autotune"));
    QVERIFY(!reply);
    QCOMPARE(reply.error().code, ErrorCode::NoEffect);
    QVERIFY2(reply.error().detail.contains(u"still uses"_s), qPrintable(reply.error().detail));
}

void TestSbgcCalibration::calibrationWithoutAnswerIsAwaited()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    Disturbed channel(bench.channel);
    channel.lossy = u"CALIB_GYRO"_s;
    const TimePoint started = bench.channel.now();
    const auto reply
        = bench.device.perform(channel, u"calibrate.gyro"_s, argumentsFor(bench.device, "calibrate.gyro"));
    QVERIFY(reply);
    QVERIFY(reply->value(u"confirmed"_s).toBool());
    QVERIFY(bench.channel.now() - started > 4s);
}

void TestSbgcCalibration::startHeardTwiceIsNoEnd()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    Disturbed channel(bench.channel);
    channel.startsTwice = number(CommandId::CalibGyro);
    const TimePoint started = bench.channel.now();
    QVERIFY(bench.device.perform(channel, u"calibrate.gyro"_s, argumentsFor(bench.device, "calibrate.gyro")));
    QVERIFY(bench.channel.now() - started > 4s);
    QVERIFY(!bench.board().isCalibrating());
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
