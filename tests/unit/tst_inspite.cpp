// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/configuration/aftermath.h"
#include "protocol/procedure/inuse.h"
#include "protocol/procedure/safeaction.h"
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/record/boardhistory.h"
#include "protocol/storm32/commands.h"
#include "tests/support/channelproxy.h"
#include "tests/support/stormrig.h"
#include "tests/support/virtualboard.h"
#include "widgets/models/errortext.h"

#include <QTemporaryDir>
#include <QTest>

namespace {

constexpr auto kRefused = [](const Request &request) {
    return failure(ErrorCode::BoardError, request.name + QStringLiteral(": not now"));
};

/// No frame that steers gets through.
class Unsteered final : public ChannelProxy
{
public:
    using ChannelProxy::ChannelProxy;
    void steer(const ControlFrames &) override { }
};

}  // namespace

/// What a board does in spite of its answer, or by itself meanwhile, is what counts and is told.
class TestInSpite : public QObject
{
    Q_OBJECT
private slots:
    void refusedLiveValueIsInUse();
    void refusedLiveValueIsNot();
    void refusedProfileIsInUse();
    void inUseIsToldApart();
    void searchIsJudgedByWhatIsInUse();
    void lostStoreIsTold();
    void turnThatNobodySawIsTold_data();
    void turnThatNobodySawIsTold();
    void storeBehindARestartIsTold();
    void confirmedStoreOfLiveValuesIsNoProof();
    void readingBackWhatWasInUseProvesNoStore();
    void profileSwitchedBeforeAWriteStays();
    void profileSwitchedInAWriteIsTold();
    void motorsAreToldAfterAWrite_data();
    void motorsAreToldAfterAWrite();
    void stormThatRestartsInAWriteIsTold_data();
    void stormThatRestartsInAWriteIsTold();
    void stormThatRestartsInAnActionIsTold_data();
    void stormThatRestartsInAnActionIsTold();
    void switchedUsageIsNoRestart();
    void calibrationIsJudgedByWhatItMeasures_data();
    void calibrationIsJudgedByWhatItMeasures();
    void motorsAreToldAfterACalibration();
    void failedSixPositionsSayThatMotorsAreOff();
    void unansweredCalibrationIsStored();
    void setupStartIsProven();
    void setupIsInUseAfterTheStart();
    void announcedRestartIsSent();
    void oneOldAnswerProvesNothing();
    void linkThatGoesWhilePuttingBackIsTold();
    void refusedButTakenIsInUse();
    void confirmedLoadingProvesNothing_data();
    void confirmedLoadingProvesNothing();
    void silentReadingBackIsTold_data();
    void silentReadingBackIsTold();
    void failedStoreSaysNothingOfWhatIsStored();
    void unansweredProfileIsInUse();
    void refusedMotorsRun();
    void motorsAreToldAfterAnAction_data();
    void motorsAreToldAfterAnAction();
    void motorsOfAStartingBoardRun();
    void otherVariablesAreNoAnswer();
    void anOldOrFrozenAnswerProvesNoStop();
    void aTurningCameraDoesNotStand();

private:
    Result<WriteReport> write(Channel &channel, Device &device, const QString &key, double raw)
    {
        const auto base = device.readConfiguration(channel);
        Configuration edited = *base;
        [&] { QVERIFY(edited.setRaw(*edited.parameters().find(key), 0, raw)); }();
        const BoardHistory history(m_dir.path());
        WriteOptions options;
        options.history = &history;
        return writeConfiguration(channel, device, *base, edited, options);
    }
    Result<ActionOutcome> perform(Channel &channel, Device &device, const char *key,
                                  const QMap<QString, QString> &texts = {})
    {
        const BoardHistory history(m_dir.path());
        return performSafely(channel, device, QString::fromLatin1(key), argumentsFor(device, key, texts),
                             history);
    }

    QTemporaryDir m_dir;
};

void TestInSpite::refusedLiveValueIsInUse()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    Altering inSpite(bench.channel, [](const Request &request, const Altering::Pass &pass) {
        auto answer = pass(request);
        return request.name == u"SET_ADJ_VARS_VAL"_s ? kRefused(request) : answer;
    });
    QVERIFY(bench.device.writeAdjustables(inSpite, {{0, 44}}));
    QCOMPARE(bench.board().inUse(u"pid.roll.p"_s), 44);
}

void TestInSpite::refusedLiveValueIsNot()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    Altering refusing(bench.channel, [](const Request &request, const Altering::Pass &pass) {
        return request.name == u"SET_ADJ_VARS_VAL"_s ? kRefused(request) : pass(request);
    });
    const auto done = bench.device.writeAdjustables(refusing, {{0, 44}});
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::BoardError);
    // Nothing is asserted of what nobody has looked at.
    QVERIFY(!describe(done.error()).oneLine().contains(u"Nothing was changed"_s));
}

void TestInSpite::refusedProfileIsInUse()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    Altering inSpite(bench.channel, [](const Request &request, const Altering::Pass &pass) {
        auto answer = pass(request);
        return request.name == u"EXECUTE_MENU"_s ? kRefused(request) : answer;
    });
    QVERIFY(bench.device.selectProfile(inSpite, 2));
    Altering refusing(bench.channel, [](const Request &request, const Altering::Pass &pass) {
        return request.name == u"EXECUTE_MENU"_s ? kRefused(request) : pass(request);
    });
    QCOMPARE(bench.device.selectProfile(refusing, 1).error().code, ErrorCode::BoardError);
}

// The board answers for what is stored, and is asked for what it uses.
void TestInSpite::inUseIsToldApart()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const auto stored = bench.device.readConfiguration(bench.channel);
    QVERIFY(stored);
    const ParameterSpec &p = *stored->parameters().find(u"pid.roll.p"_s);
    QVERIFY(bench.device.writeAdjustables(bench.channel, {{p.adjustable, 61}}));
    QCOMPARE(*withInUse(bench.channel, bench.device, *stored).raw(p, 0), 61.0);
}

void TestInSpite::searchIsJudgedByWhatIsInUse()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.board().stabilizer().imu().gyroCorrection = bench.board().stabilizer().imu().gyroBias;
    std::optional<Frame> stored;
    Altering apart(bench.channel, [&stored](const Request &request, const Altering::Pass &pass) {
        if (request.name != u"READ_PARAMS_3"_s)
            return pass(request);
        if (!stored) {
            const auto answer = pass(request);
            if (answer)
                stored = *answer;
            return answer;
        }
        return Result<Frame>(*stored);
    });
    const auto reply = bench.device.perform(
        apart, u"autotune"_s,
        argumentsFor(bench.device, "autotune", {{u"yaw"_s, u"off"_s}, {u"save"_s, u"off"_s}}));
    QVERIFY2(reply, reply ? "" : qPrintable(reply.error().detail));
    QCOMPARE(reply->value(u"p.roll"_s).toInt(), bench.board().inUse(u"pid.roll.p"_s));
    QVERIFY(reply->value(u"i.roll"_s).toDouble() < 3);
}

void TestInSpite::lostStoreIsTold()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const auto before = bench.device.readBlock(bench.channel, {0, simplebgc::Params3});
    QVERIFY(before);
    QVERIFY(bench.device.writeAdjustables(bench.channel, {{0, 61}}));
    Altering losing(bench.channel, [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        if (request.name == u"SAVE_PARAMS_3"_s)
            return Frame{};
        auto answer = pass(request);
        if (answer && request.name == u"READ_PARAMS_3"_s && answer->payload[0] == 0)
            answer->payload = *before;
        return answer;
    });
    const auto done = perform(losing, bench.device, "variables.save");
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::NotStored);
    QVERIFY2(done.error().detail.contains(u"pid.roll.p is 61 in use"_s), qPrintable(done.error().detail));
    QVERIFY(perform(bench.channel, bench.device, "variables.save"));
}

// It has started anew before it stored: what was in use is gone, and the old value is stored once more.
// No frame that steers has arrived, whatever else answers: that is no success.
void TestInSpite::turnThatNobodySawIsTold_data()
{
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("seconds");
    QTest::newRow("a little") << 10.0 << 1.0;
    QTest::newRow("far") << 60.0 << 1.0;
}

void TestInSpite::turnThatNobodySawIsTold()
{
    QFETCH(double, speed);
    QFETCH(double, seconds);
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.board().stabilizer().setMotorsOn(true);
    QVERIFY(bench.channel.sleep(1s));
    const QMap<QString, QString> texts{{u"mode"_s, u"speed"_s},
                                       {u"yaw"_s, QString::number(speed)},
                                       {u"seconds"_s, QString::number(seconds)}};
    const auto done = perform(bench.channel, bench.device, "steer", texts);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QVERIFY(bench.channel.sleep(10s));  // it has come to rest
    Unsteered unsteered(bench.channel);
    const auto swallowed = perform(unsteered, bench.device, "steer", texts);
    QVERIFY(!swallowed);
    QCOMPARE(swallowed.error().code, ErrorCode::NotSeen);
}

void TestInSpite::storeBehindARestartIsTold()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    QVERIFY(bench.device.writeAdjustables(bench.channel, {{0, 61}}));
    Altering restarting(bench.channel, [&](const Request &request, const Altering::Pass &pass) {
        if (request.name == u"SAVE_PARAMS_3"_s)  // what a restart does to values in use
            std::ignore = bench.device.writeAdjustables(bench.channel, {{0, 35}});
        return pass(request);
    });
    const auto done = perform(restarting, bench.device, "variables.save");
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::NotStored);
    QVERIFY2(done.error().detail.contains(u"pid.roll.p was 61 in use and is 35 now"_s),
             qPrintable(done.error().detail));
}

// A button on the board has switched it since it was read.
// What was set live here is known as such, which does not make the board tell what it has stored.
void TestInSpite::confirmedStoreOfLiveValuesIsNoProof()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    QVERIFY(bench.device.writeAdjustables(bench.channel, {{0, 44}}));
    Altering swallowing(bench.channel,
                        [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
                            return request.name == u"SAVE_PARAMS_3"_s ? Frame{} : pass(request);
                        });
    const BoardHistory history(m_dir.path());
    const LiveValues live{{u"pid.roll.p"_s, 35, 44}};
    const auto stored = performSafely(swallowing, bench.device, u"variables.save"_s, {}, history, live);
    QVERIFY(stored);
    QVERIFY(stored->isStoreUntold);
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 35);
}

// The board answers with what it uses, and used it before.
void TestInSpite::readingBackWhatWasInUseProvesNoStore()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    QVERIFY(bench.device.writeAdjustables(bench.channel, {{0, 44}}));
    Altering swallowing(bench.channel,
                        [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
                            return request.name == u"WRITE_PARAMS_3"_s ? Frame{} : pass(request);
                        });
    const auto base = bench.device.readConfiguration(bench.channel);
    QVERIFY(base);
    const BoardHistory history(m_dir.path());
    WriteOptions options;
    options.history = &history;
    options.named = {u"pid.roll.p"_s};
    options.evenIfInUse = true;
    const auto same = writeConfiguration(swallowing, bench.device, *base, *base, options);
    QVERIFY(same && same->lines.size() == 1);
    QCOMPARE(same->countStoreUntold(), 1);
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 35);
    // Beside a value that was not in use, all of the block is proven.
    Configuration edited = *base;
    QVERIFY(edited.setRaw(*edited.parameters().find(u"pid.roll.d"_s), 0, 33));
    const auto more = writeConfiguration(bench.channel, bench.device, *base, edited, options);
    QVERIFY(more && more->isComplete() && more->storesUse);
    QCOMPARE(more->countStoreUntold(), 0);
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 44);
    // What was refused has stored nothing.
    Altering refusing(bench.channel,
                      [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
                          return request.name == u"WRITE_PARAMS_3"_s ? kRefused(request) : pass(request);
                      });
    // Nor has what was never sent; and nobody has read the board again.
    Altering silent(bench.channel, [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        return request.name == u"WRITE_PARAMS_SET"_s || request.name == u"BOARD_INFO"_s
            ? failure(ErrorCode::Timeout, request.name)
            : pass(request);
    });
    const auto unsent = write(silent, bench.device, u"pid.roll.d"_s, 41);
    QVERIFY(unsent && !unsent->isComplete());
    QVERIFY2(describe(*unsent).meaning.startsWith(u"Nothing of it had been sent"_s),
             qPrintable(describe(*unsent).oneLine()));
    const auto refused = write(refusing, bench.device, u"pid.roll.d"_s, 41);
    QVERIFY(refused && !refused->isComplete());
    QVERIFY(!refused->storesUse);
}

void TestInSpite::profileSwitchedBeforeAWriteStays()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const auto base = bench.device.readConfiguration(bench.channel);
    Configuration edited = *base;
    QVERIFY(edited.setRaw(*edited.parameters().find(u"pid.roll.p"_s), 0, 39));
    QVERIFY(bench.device.selectProfile(bench.channel, 2));
    const BoardHistory history(m_dir.path());
    WriteOptions options;
    options.history = &history;
    const auto report = writeConfiguration(bench.channel, bench.device, *base, edited, options);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::Conflict);
    QCOMPARE(bench.board().activeProfile(), 2);
    QCOMPARE(double(bench.board().stored(u"pid.roll.p"_s, 0)),
             *base->raw(*base->parameters().find(u"pid.roll.p"_s), 0));
}

void TestInSpite::profileSwitchedInAWriteIsTold()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    Altering switching(bench.channel, [&](const Request &request, const Altering::Pass &pass) {
        auto answer = pass(request);
        if (request.name == u"WRITE_PARAMS_3"_s)
            std::ignore = bench.device.selectProfile(bench.channel, 2);
        return answer;
    });
    const auto report = write(switching, bench.device, u"pid.roll.p"_s, 39);
    QVERIFY2(report, report ? "" : qPrintable(report.error().detail));
    QCOMPARE(report->strayProfile, std::optional(2));
    QCOMPARE(bench.board().activeProfile(), 2);
    QVERIFY(describe(*report).meaning.contains(u"active profile is now"_s));
}

void TestInSpite::motorsAreToldAfterAWrite_data()
{
    QTest::addColumn<bool>("ranBefore");
    QTest::addColumn<bool>("runAfter");
    QTest::newRow("started") << false << true;
    QTest::newRow("stopped") << true << false;
    QTest::newRow("running on") << true << true;
}

void TestInSpite::motorsAreToldAfterAWrite()
{
    QFETCH(bool, ranBefore);
    QFETCH(bool, runAfter);
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.board().stabilizer().setMotorsOn(ranBefore);
    Altering switching(bench.channel, [&](const Request &request, const Altering::Pass &pass) {
        if (request.name == u"WRITE_PARAMS_3"_s)
            bench.board().stabilizer().setMotorsOn(runAfter);
        return pass(request);
    });
    const auto report = write(switching, bench.device, u"pid.roll.p"_s, 39);
    QVERIFY(report && report->isComplete());
    QCOMPARE(report->restart.motorsStarted, !ranBefore && runAfter);
    QCOMPARE(report->restart.motorsStopped, ranBefore && !runAfter);
    QCOMPARE(restartText(*report).contains(u"off now"_s), ranBefore && !runAfter);
    QCOMPARE(report->restart.areAny(), !ranBefore && runAfter);
}

void TestInSpite::stormThatRestartsInAWriteIsTold_data()
{
    QTest::addColumn<int>("firmware");
    for (const int firmware : {79, 90, 96})
        QTest::addRow("0.%d", firmware) << firmware;
}

// In standby, and behind the storing it is not any more.
void TestInSpite::stormThatRestartsInAWriteIsTold()
{
    QFETCH(int, firmware);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(rig.device.perform(rig.channel, u"motors.off"_s, {}));
    Altering restarting(rig.channel, [&](const Request &request, const Altering::Pass &pass) {
        auto answer = pass(request);
        if (request.name == u"xs"_s)
            std::ignore = pass(storm32::simpleRequest(storm32::Simple::Restart));
        return answer;
    });
    const auto report = write(restarting, rig.device, u"pid.pitch.p"_s, 410);
    QVERIFY2(report, report ? "" : qPrintable(report.error().detail));
    QVERIFY2(report->restart.motorsStarted, qPrintable(restartText(*report)));
    const auto quiet = write(rig.channel, rig.device, u"pid.pitch.p"_s, 420);
    QVERIFY(quiet && !quiet->restart.areTold());
}

void TestInSpite::stormThatRestartsInAnActionIsTold_data()
{
    QTest::addColumn<QString>("action");
    QTest::addColumn<QString>("request");
    QTest::addColumn<bool>("ran");
    QTest::addColumn<bool>("runs");
    QTest::newRow("compare") << u"stored.compare"_s << u"xr"_s << false << true;
    QTest::newRow("compare, with an answer nobody expects")
        << u"stored.compare"_s << u"xr+"_s << false << true;
    QTest::newRow("name") << u"name"_s << u"xn"_s << false << true;
    QTest::newRow("trim") << u"trim"_s << u"CR"_s << false << true;
    QTest::newRow("erase") << u"erase"_s << u"xc"_s << true << false;  // defaults disable all motors
}

// Whatever the action is, and however it ends: motors that start by themselves, or let go, are told.
void TestInSpite::stormThatRestartsInAnActionIsTold()
{
    QFETCH(QString, action);
    QFETCH(QString, request);
    QFETCH(bool, ran);
    QFETCH(bool, runs);
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    if (!ran)
        QVERIFY(rig.device.perform(rig.channel, u"motors.off"_s, {}));
    const ParameterSpec &gain = *rig.device.parameters()->find(u"pid.pitch.p"_s);
    if (ran)
        QVERIFY(rig.device.live()->writeAdjustables(rig.channel, {{gain.adjustable, 700}}));
    bool isDone = false;
    const bool isStray = request.endsWith(u'+');
    Altering restarting(rig.channel, [&](const Request &each, const Altering::Pass &pass) {
        auto answer = pass(each);
        if (!isDone && (each.name == request || each.name + u'+' == request)) {
            isDone = true;
            if (isStray)
                rig.channel.post(storm32::simpleRequest(storm32::Simple::Restart));
            else
                std::ignore = pass(storm32::simpleRequest(storm32::Simple::Restart));
        }
        return answer;
    });
    const auto done = perform(restarting, rig.device, action.toLatin1(),
                              action == u"name"_s ? QMap<QString, QString>{{u"name"_s, u"Foo"_s}}
                                                  : QMap<QString, QString>());
    QVERIFY(isDone);
    const QString told = done ? QString() : done.error().detail;
    if (done)
        QCOMPARE(done->motorsNow, std::optional(runs));
    if (done && action == u"erase"_s) {
        QVERIFY2(std::ranges::any_of(done->lost,
                                     [](const ParameterChange &change) {
                                         return change.spec->key == u"pid.pitch.p"_s && change.from == 700;
                                     }),
                 "what was in use");
    }
    if (!done) {
        const ErrorText text = describe(done.error());
        // Either is true, never both.
        QVERIFY2(!(text.oneLine().contains(u"could not be put back"_s)
                   && text.oneLine().contains(u"uses the old values"_s)),
                 qPrintable(text.oneLine()));
    }
    if (done)
        return;
    QVERIFY2(told.contains(runs ? u"motors run now"_s : u"motors are off now"_s), qPrintable(told));
}

void TestInSpite::switchedUsageIsNoRestart()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QCOMPARE(rig.device.areMotorsOn(rig.channel), Result<bool>(true));
    const auto base = rig.device.readConfiguration(rig.channel);
    for (const ParameterSpec &spec : base->parameters().all())
        QCOMPARE(rig.device.isSwitchedBy(spec),
                 spec.key.startsWith(u"motor."_s) && spec.key.endsWith(u".usage"_s));
}

void TestInSpite::calibrationIsJudgedByWhatItMeasures_data()
{
    QTest::addColumn<QString>("action");
    QTest::addColumn<QString>("request");
    QTest::newRow("gyroscope") << u"calibrate.gyro"_s << u"CALIB_GYRO"_s;
    QTest::newRow("accelerometer") << u"calibrate.acc"_s << u"CALIB_ACC"_s;
}

void TestInSpite::calibrationIsJudgedByWhatItMeasures()
{
    QFETCH(QString, action);
    QFETCH(QString, request);
    SimulatorOptions options;
    options.faults.pose = 1;
    options.faults.shake = 0;
    VirtualBoard bench(options);
    QVERIFY(bench.identify());
    QVERIFY(bench.device.perform(bench.channel, u"motors.off"_s, {}));
    // Swallowed, and confirmed at its start and at its end.
    Altering swallowing(bench.channel, [&](const Request &each, const Altering::Pass &pass) -> Result<Frame> {
        return each.name == request ? Frame{} : pass(each);
    });
    const auto swallowed = bench.device.perform(
        swallowing, action,
        argumentsFor(bench.device, action.toUtf8().constData(), {{u"form"_s, u"simple"_s}}));
    QVERIFY(!swallowed);
    QCOMPARE(swallowed.error().code, ErrorCode::NoEffect);
    const auto done = bench.device.perform(bench.channel, action,
                                           argumentsFor(bench.device, action.toUtf8().constData()));
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
}

void TestInSpite::motorsAreToldAfterACalibration()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.board().stabilizer().setMotorsOn(true);
    Altering switching(bench.channel, [&](const Request &request, const Altering::Pass &pass) {
        if (request.name == u"CALIB_BAT"_s)
            bench.board().stabilizer().setMotorsOn(false);
        return pass(request);
    });
    const auto done = perform(switching, bench.device, "calibrate.battery", {{u"voltage"_s, u"12"_s}});
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->motorsNow, std::optional(false));
    const auto quiet = perform(bench.channel, bench.device, "calibrate.battery", {{u"voltage"_s, u"12"_s}});
    QVERIFY(quiet && !quiet->motorsNow);
}

void TestInSpite::failedSixPositionsSayThatMotorsAreOff()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.change(u"pose=1"_s);
    int readings = 0;
    Altering failing(rig.channel, [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        if (request.name == u"Cd"_s && ++readings > 100)
            return kRefused(request);
        return pass(request);
    });
    const auto done = perform(failing, rig.device, "calibrate.six");
    QVERIFY(!done);
    QVERIFY2(done.error().detail.contains(u"the motors are off now"_s), qPrintable(done.error().detail));
}

// Only its answer was lost.
void TestInSpite::unansweredCalibrationIsStored()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(rig.device.perform(rig.channel, u"motors.off"_s, {}));
    rig.change(u"pose=1"_s);
    Altering losing(rig.channel, [](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        auto answer = pass(request);
        if (request.name == u"Cw"_s)
            return failure(ErrorCode::Timeout, request.name);
        return answer;
    });
    const auto done = perform(losing, rig.device, "calibrate.level", {{u"store"_s, u"on"_s}});
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    Altering deaf(rig.channel, [](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        if (request.name == u"Cw"_s)
            return failure(ErrorCode::Timeout, request.name);
        return pass(request);
    });
    rig.change(u"pose=3"_s);
    QCOMPARE(perform(deaf, rig.device, "calibrate.level", {{u"store"_s, u"on"_s}}).error().code,
             ErrorCode::Timeout);
}

void TestInSpite::setupStartIsProven()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    Altering ignoring(rig.channel, [](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        return request.name == u"xW"_s ? Result<Frame>(Frame{}) : pass(request);
    });
    const auto done = rig.device.perform(ignoring, u"setup.start"_s, {});
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::NoEffect);
    QVERIFY(rig.device.perform(rig.channel, u"setup.start"_s, {}));
}

// A start that loads what is stored: what was set up is put back.
void TestInSpite::setupIsInUseAfterTheStart()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(rig.device.perform(rig.channel, u"setup.directions"_s, {{u"direction"_s, 2}}));
    Altering ignoring(rig.channel, [](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        auto answer = request.name == u"p"_s ? Result<Frame>(Frame{}) : pass(request);
        if (request.name == u"xW"_s)
            std::ignore = pass(storm32::simpleRequest(storm32::Simple::Retrieve));
        return answer;
    });
    const auto done = rig.device.perform(ignoring, u"setup.start"_s, {});
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::NotInUse);
}

// It is yet to come.
void TestInSpite::announcedRestartIsSent()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const auto done = perform(bench.channel, bench.device, "reset", {{u"delay"_s, u"500"_s}});
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QVERIFY(!done->answered);
}

// The board answers with what it held at the question before.
void TestInSpite::oneOldAnswerProvesNothing()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const double before = bench.board().stored(u"pid.roll.p"_s, 0);
    std::map<QByteArray, Frame> last;
    bool isLate = false;
    Altering late(bench.channel, [&](const Request &request, const Altering::Pass &pass) {
        auto answer = pass(request);
        isLate = isLate || request.name == u"WRITE_PARAMS_3"_s;
        if (!answer || request.name != u"READ_PARAMS_3"_s)
            return answer;
        const QByteArray profile = answer->payload.left(1);
        const Frame older = last.contains(profile) ? last[profile] : *answer;
        last[profile] = *answer;
        return isLate ? Result<Frame>(older) : answer;
    });
    const auto report = write(late, bench.device, u"pid.roll.p"_s, 39);
    QVERIFY(report && report->error);
    QCOMPARE(double(bench.board().stored(u"pid.roll.p"_s, 0)), before);
    QCOMPARE(report->lines.front().found, before);
    QVERIFY(report->lines.front().state != WriteState::Verified);
}

void TestInSpite::linkThatGoesWhilePuttingBackIsTold()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    int writes = 0;
    Altering failing(bench.channel, [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        writes += request.name == u"WRITE_PARAMS_3"_s ? 1 : 0;
        if (writes > 1)
            return failure(ErrorCode::LinkClosed, u"the cable"_s);
        auto answer = pass(request);
        if (writes == 1 && answer && request.name == u"READ_PARAMS_3"_s)
            answer->payload[20] = char(answer->payload[20] ^ 0x08);
        return answer;
    });
    const auto report = write(failing, bench.device, u"pid.roll.p"_s, 39);
    QVERIFY(report && report->error);
    QCOMPARE(report->error->code, ErrorCode::LinkClosed);  // so it is waited for, and read
}

// Each "p" is said to have arrived damaged, and is taken: what was in use before is in use again.
void TestInSpite::refusedButTakenIsInUse()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.board().set(6, 450);
    Altering refusing(rig.channel, [](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        auto answer = pass(request);
        return request.name == u"p"_s ? failure(ErrorCode::BoardError, u"p"_s) : answer;
    });
    const auto report = write(refusing, rig.device, u"pid.pitch.p"_s, 460);
    QCOMPARE(rig.board().inUse(6), 450);
    const QString told = report ? describe(*report).oneLine() : describe(report.error()).oneLine();
    QVERIFY2(!told.contains(u"not in use again"_s), qPrintable(told));
}

void TestInSpite::confirmedLoadingProvesNothing_data()
{
    QTest::addColumn<int>("firmware");
    for (const int firmware : {79, 90, 96})
        QTest::newRow(QByteArray::number(firmware)) << firmware;
}

// A board that says "o" to what it does not do: neither what is in use nor what is stored is taken for what
// it would be then.
void TestInSpite::confirmedLoadingProvesNothing()
{
    QFETCH(int, firmware);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    const QStringList ignored{u"xr"_s, u"xs"_s, u"RESTOREPARAMETER"_s};
    Altering ignoring(rig.channel, [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        if (request.name == u"RESTOREPARAMETER"_s)
            return pass(storm32::rcRequest(storm32::Rc::DoCamera, QByteArray(6, '\0')));  // an ack
        return ignored.contains(request.name) ? pass(storm32::simpleRequest(storm32::Simple::Test))
                                              : pass(request);
    });
    rig.board().set(0, 444);
    const auto retrieved = perform(ignoring, rig.device, "retrieve");
    QVERIFY(!retrieved);
    QCOMPARE(retrieved.error().code, ErrorCode::VerifyFailed);
    QCOMPARE(rig.board().inUse(0), 444);  // as it was
    const auto compared = perform(ignoring, rig.device, "stored.compare");
    QVERIFY(!compared);
    QCOMPARE(rig.board().inUse(0), 444);
    const auto restored = perform(ignoring, rig.device, "restore", {{u"word"_s, u"0"_s}});
    QVERIFY(restored && !restored->answered);  // sent, not done
    const auto written = write(ignoring, rig.device, u"pid.pitch.p"_s, 460);
    QVERIFY(!written || !written->isComplete());
    QCOMPARE(rig.board().stored(0), 400);
    // One that does it: done.
    const auto done = perform(rig.channel, rig.device, "retrieve");
    QVERIFY(done && done->answered);
    QCOMPARE(rig.board().inUse(0), rig.board().stored(0));
}

void TestInSpite::silentReadingBackIsTold_data()
{
    QTest::addColumn<bool>("isStreaming");
    QTest::newRow("nothing comes") << false;
    QTest::newRow("live data go on, an answer is lost") << true;
}

void TestInSpite::silentReadingBackIsTold()
{
    QFETCH(bool, isStreaming);
    VirtualBoard bench;
    QVERIFY(bench.identify());
    if (isStreaming)
        QVERIFY(bench.device.subscribe(bench.channel, {}, {}));
    bool isWritten = false;
    Altering silent(bench.channel, [&](const Request &request, const Altering::Pass &pass) {
        if (std::exchange(isWritten, request.name == u"WRITE_PARAMS_3"_s))
            std::ignore = bench.channel.sleep(1500ms);
        return pass(request);
    });
    const auto report = write(silent, bench.device, u"pid.roll.p"_s, 39);
    QVERIFY(report && report->isComplete());
    QCOMPARE(report->restart.silentSeconds > 1, !isStreaming);
}

// What it answers is what it uses.
void TestInSpite::failedStoreSaysNothingOfWhatIsStored()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    Altering refusing(bench.channel, [](const Request &request, const Altering::Pass &pass) {
        auto answer = pass(request);
        return request.name == u"SAVE_PARAMS_3"_s ? kRefused(request) : answer;
    });
    const auto done = perform(refusing, bench.device, "variables.save");
    QVERIFY(!done);
    const QString told = describe(done.error()).oneLine();
    QVERIFY2(told.contains(u"only when the board has restarted"_s) && !told.contains(u"old values"_s),
             qPrintable(told));
}

void TestInSpite::unansweredProfileIsInUse()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    Altering losing(bench.channel, [](const Request &request, const Altering::Pass &pass) {
        auto answer = pass(request);
        return request.name == u"EXECUTE_MENU"_s ? failure(ErrorCode::Timeout, request.name) : answer;
    });
    QVERIFY(bench.device.selectProfile(losing, 2));
    Altering deaf(bench.channel, [](const Request &request, const Altering::Pass &pass) {
        return request.name == u"EXECUTE_MENU"_s ? failure(ErrorCode::Timeout, request.name) : pass(request);
    });
    QCOMPARE(bench.device.selectProfile(deaf, 1).error().code, ErrorCode::Timeout);
    // Whoever changes values hears in which profile they are not.
    Error error{ErrorCode::NotInUse, {}, 0};
    Configuration before = *bench.device.readConfiguration(bench.channel);
    before.setActiveProfile(0);
    error.after = std::make_shared<const Aftermath>(Aftermath{{}, before, true});
    const auto now = bench.device.readConfiguration(bench.channel);
    QVERIFY(describe(settled(error, *now)).meaning.contains(u"active profile is now 3"_s));
}

void TestInSpite::refusedMotorsRun()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.board().stabilizer().setMotorsOn(false);
    Altering inSpite(bench.channel, [](const Request &request, const Altering::Pass &pass) {
        auto answer = pass(request);
        return request.name == u"MOTORS_ON"_s ? kRefused(request) : answer;
    });
    QVERIFY(perform(inSpite, bench.device, "motors.on"));
    bench.board().stabilizer().setMotorsOn(false);
    Altering refusing(bench.channel, [](const Request &request, const Altering::Pass &pass) {
        return request.name == u"MOTORS_ON"_s ? kRefused(request) : pass(request);
    });
    QCOMPARE(perform(refusing, bench.device, "motors.on").error().code, ErrorCode::BoardError);
}

void TestInSpite::motorsAreToldAfterAnAction_data()
{
    QTest::addColumn<QString>("action");
    QTest::addColumn<QString>("argument");
    QTest::addColumn<QString>("value");
    QTest::newRow("profile") << u"profile.select"_s << u"profile"_s << u"2"_s;
    QTest::newRow("menu") << u"menu"_s << u"command"_s << u"18"_s;
    QTest::newRow("steer") << u"steer"_s << u"yaw"_s << u"5"_s;
}

void TestInSpite::motorsAreToldAfterAnAction()
{
    QFETCH(QString, action);
    QFETCH(QString, argument);
    QFETCH(QString, value);
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.board().stabilizer().setMotorsOn(true);
    Altering switching(bench.channel, [&](const Request &request, const Altering::Pass &pass) {
        if (request.name == u"EXECUTE_MENU"_s || request.name == u"GET_ANGLES"_s)
            bench.board().stabilizer().setMotorsOn(false);
        return pass(request);
    });
    const auto done = perform(switching, bench.device, action.toLatin1(), {{argument, value}});
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->motorsNow, std::optional(false));
}

// They start by themselves a few seconds later.
void TestInSpite::motorsOfAStartingBoardRun()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(rig.device.perform(rig.channel, u"restart"_s, {}));
    const auto done = rig.device.perform(rig.channel, u"motors.on"_s, {});
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(rig.device.areMotorsOn(rig.channel), Result<bool>(true));
    Altering refusing(rig.channel, [](const Request &request, const Altering::Pass &pass) {
        auto answer = pass(request);
        return request.name.contains(u"STANDBY"_s) ? kRefused(request) : answer;
    });
    QVERIFY(rig.device.perform(rig.channel, u"motors.off"_s, {}));
    QVERIFY(rig.device.perform(refusing, u"motors.on"_s, {}));
}

void TestInSpite::otherVariablesAreNoAnswer()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    std::optional<Frame> first;
    Altering late(bench.channel, [&first](const Request &request, const Altering::Pass &pass) {
        if (request.name != u"GET_ADJ_VARS_VAL"_s)
            return pass(request);
        if (!first) {
            first = *pass(request);
            return Result<Frame>(*first);
        }
        // What a channel does with an answer that does not fit.
        return request.answer({first->id, asBytes(first->payload)}) ? Result<Frame>(*first) : pass(request);
    });
    QVERIFY(bench.device.readAdjustables(late, {0, 1}));
    const auto values = bench.device.readAdjustables(late, {2, 3});
    QVERIFY(values && values->size() == 2);
    QCOMPARE(values->front().id, 2);
}

void TestInSpite::anOldOrFrozenAnswerProvesNoStop()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const auto status = [&] { return *bench.channel.transact(bench.device.statusRequest()); };
    bench.board().stabilizer().setMotorsOn(false);
    const Frame off = status();
    QVERIFY(bench.channel.sleep(100ms));
    const Frame offLater = status();
    QVERIFY(off.payload != offLater.payload);
    bench.board().stabilizer().setMotorsOn(true);
    const Frame on = status();
    const StopPlan plan = bench.device.stopPlan();
    QCOMPARE(plan.fromAnswer(off), Proof::Nothing);
    QCOMPARE(plan.fromAnswer(off), Proof::Nothing);
    QCOMPARE(plan.fromAnswer(on), Proof::Refuted);
    QCOMPARE(plan.fromAnswer(offLater), Proof::Nothing);
    QCOMPARE(plan.fromAnswer(off), Proof::Proven);
}

// Whatever its target says.
void TestInSpite::aTurningCameraDoesNotStand()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.board().stabilizer().setMotorsOn(true);
    Frame frame = *bench.channel.transact(bench.device.statusRequest());
    constexpr double kNone = ControlFrames::kUnknown;
    const ControlFrames frames = bench.device.controlFrames(SteeringSetpoint{1, {kNone, kNone, 20}, {}});
    QCOMPARE(frames.fromAnswer(frame), Proof::Nothing);
    constexpr int kCameraYaw = 36;
    frame.payload[kCameraYaw] = char(frame.payload[kCameraYaw] + 0x50);  // 1.8°
    QCOMPARE(frames.fromAnswer(frame), Proof::Refuted);
    QCOMPARE(frames.fromAnswer(frame), Proof::Proven);
}

QTEST_GUILESS_MAIN(TestInSpite)
#include "tst_inspite.moc"
