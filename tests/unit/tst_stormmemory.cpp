// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/safeaction.h"
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/record/configurationformats.h"
#include "tests/support/stormrig.h"

#include <QTemporaryDir>
#include <QTest>

using namespace storm32;

namespace {

QString why(const Result<WriteReport> &report)
{
    if (!report)
        return report.error().detail;
    return report->error ? report->error->detail : QString();
}

}  // namespace

/// A STorM32 board stores everything in use at once: what else is in use is told, and kept apart from what is
/// stored unless the operator wants it otherwise.
class TestStormMemory : public QObject
{
    Q_OBJECT
private slots:
    void otherValues_data();
    void otherValues();
    void wantedInUseWhereStoredAlready();
    void scriptsAreNamed_data();
    void scriptsAreNamed();
    void scriptThatSetsTheWrittenValueIsTold();
    void motorsNeitherStartNorFall_data();
    void motorsNeitherStartNorFall();
    void disabledMotorLetsTheOthersRun_data();
    void disabledMotorLetsTheOthersRun();
    void standbyIsLeftAgain();
    void cancelledReadingLosesNothing();
    void failedWriteLeavesBothAsTheyWere();
    void storedHeartbeatIsCompared_data();
    void storedHeartbeatIsCompared();
    void wholeWriteWithAStoredHeartbeat();
    void lockedOutBoardKeepsTheTwoApart_data();
    void lockedOutBoardKeepsTheTwoApart();
    void stoppedWhileStartingIsNotStored_data();
    void stoppedWhileStartingIsNotStored();
    void scriptIsKeptFromStoring();
    void storedMeanwhileIsTold();
    void storedIsNotWhatAScriptHasJustSet();
    void writtenValueThatAScriptSetsIsTold();
    void plainStoreKeepsWhatWasStored_data();
    void plainStoreKeepsWhatWasStored();
    void restoredWordIsOneOfTheBoard_data();
    void restoredWordIsOneOfTheBoard();
    void anyWordCanBeSetInRam_data();
    void anyWordCanBeSetInRam();
    void addressIsFollowed();

private:
    Result<WriteReport> write(StormRig &rig, const QString &key, double raw,
                              OtherValues others = OtherValues::Keep)
    {
        return write(rig, rig.device, key, raw, others);
    }
    Result<WriteReport> write(StormRig &rig, storm32::Device &device, const QString &key, double raw,
                              OtherValues others = OtherValues::Keep)
    {
        const BoardHistory history(m_dir.path());
        const auto base = device.readConfiguration(rig.channel);
        Configuration edited = *base;
        [&] { QVERIFY(edited.setRaw(*edited.parameters().find(key), 0, raw)); }();
        WriteOptions options;
        options.history = &history;
        options.others = others;
        options.named = {key};
        return writeConfiguration(rig.channel, device, *base, edited, options);
    }
    static int word(StormRig &rig, const QString &key)
    {
        return rig.device.parameters()->find(key)->offset / 2;
    }
    // Puts scripts and the input of the first one into RAM and EEPROM.
    static void runScript(StormRig &rig, const QString &text)
    {
        auto board = rig.device.readConfiguration(rig.channel).value();
        const auto code = storm32::family().scripts->compile(board, {text, {}, {}, {}});
        QVERIFY(code);
        board.setBlock({0, Scripts}, *code);
        QVERIFY(board.setRaw(*board.parameters().find(u"script1.input"_s), 0, 11));
        QVERIFY(rig.device.use(rig.channel, board));
        QVERIFY(rig.device.perform(rig.channel, u"store"_s, {}));
    }

    QTemporaryDir m_dir;
};

void TestStormMemory::otherValues_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<int>("others");
    QTest::addColumn<int>("inUse");
    QTest::addColumn<int>("stored");
    for (const int firmware : {79, 90, 96}) {
        QTest::addRow("%d, keep", firmware) << firmware << int(OtherValues::Keep) << 500 << 400;
        QTest::addRow("%d, store", firmware) << firmware << int(OtherValues::Store) << 500 << 500;
        QTest::addRow("%d, put back", firmware) << firmware << int(OtherValues::PutBack) << 400 << 400;
    }
}

void TestStormMemory::otherValues()
{
    QFETCH(int, firmware);
    QFETCH(int, others);
    QFETCH(int, inUse);
    QFETCH(int, stored);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    rig.board().set(0, 500);  // somebody, by RC command 4
    const auto report = write(rig, u"motor.yaw.poles"_s, 12, OtherValues(others));
    QVERIFY2(report && report->isComplete(), qPrintable(why(report)));
    QCOMPARE(report->count(WriteState::Verified), 1);
    QCOMPARE(report->others.size(), std::size_t(1));
    QCOMPARE(report->others.front().spec->key, u"pid.pitch.p"_s);
    QCOMPARE(report->others.front().inUse, 500.0);
    QCOMPARE(report->others.front().stored, 400.0);
    QVERIFY(!report->othersUnknown);
    const int poles = word(rig, u"motor.yaw.poles"_s);
    QCOMPARE(rig.board().inUse(poles), 12);
    QCOMPARE(rig.board().stored(poles), 12);
    QCOMPARE(rig.board().inUse(0), inUse);
    QCOMPARE(rig.board().stored(0), stored);
    QCOMPARE(report->onBoard.raw(*report->onBoard.parameters().find(u"pid.pitch.p"_s), 0), double(stored));
    // The copy taken before holds what was stored.
    QVERIFY(!report->snapshotPath.isEmpty());
}

// 5 in use, 4 stored, 4 wanted: the board uses 4 then.
void TestStormMemory::wantedInUseWhereStoredAlready()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.board().set(0, 500);
    const BoardHistory history(m_dir.path());
    WriteOptions options;
    options.history = &history;
    options.contents = rig.device.readBoth(rig.channel).value();
    const Configuration base = options.contents->stored;
    QCOMPARE(base.raw(*base.parameters().find(u"pid.pitch.p"_s), 0), 400.0);
    auto report = writeConfiguration(rig.channel, rig.device, base, base, options);
    QVERIFY(report && report->lines.empty());
    QCOMPARE(report->others.size(), std::size_t(1));  // and that is told
    options.named = {u"pid.pitch.p"_s};
    report = writeConfiguration(rig.channel, rig.device, base, base, options);
    QVERIFY(report && report->isComplete());
    QCOMPARE(report->lines.size(), std::size_t(1));
    QVERIFY(report->others.empty());
    QCOMPARE(rig.board().inUse(0), 400);
    QCOMPARE(rig.board().stored(0), 400);
}

void TestStormMemory::scriptsAreNamed_data()
{
    QTest::addColumn<int>("firmware");
    for (const int firmware : {79, 90, 96})
        QTest::newRow(QByteArray::number(firmware)) << firmware;
}

// A script that moves a value while the board is written: no mismatch, not stored, and named.
void TestStormMemory::scriptsAreNamed()
{
    QFETCH(int, firmware);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    runScript(rig, u"CASE#DEFAULT\nSET \"Yaw P\" 510\nWAIT 1\nSET \"Yaw P\" 520\nWAIT 1\nREPEAT"_s);
    QVERIFY(rig.channel.sleep(150ms));
    const auto report = write(rig, u"pid.roll.p"_s, 444);
    QVERIFY2(report && report->isComplete(), qPrintable(why(report)));
    QCOMPARE(rig.board().stored(6), 444);
    QCOMPARE(rig.board().inUse(6), 444);
    for (const OtherValue &other : report->others) {
        QCOMPARE(other.spec->key, u"pid.yaw.p"_s);
        QCOMPARE(other.setBy, u"script 1"_s);
        QCOMPARE(int(other.stored), rig.board().stored(12));  // whatever it is, it is told
    }
    QVERIFY(rig.channel.sleep(300ms));
    QVERIFY(rig.board().inUse(12) == 510 || rig.board().inUse(12) == 520);
}

void TestStormMemory::scriptThatSetsTheWrittenValueIsTold()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    runScript(rig, u"CASE#DEFAULT\nSET \"Yaw P\" 510\nWAIT 0\nREPEAT"_s);
    QVERIFY(rig.channel.sleep(150ms));
    const auto report = write(rig, u"pid.yaw.p"_s, 444);
    QVERIFY(report && !report->isComplete());
    QVERIFY2(report->error->detail.contains(u"pid.yaw.p, which script 1 sets"_s),
             qPrintable(report->error->detail));
}

void TestStormMemory::motorsNeitherStartNorFall_data()
{
    QTest::addColumn<int>("inUse");
    QTest::addColumn<int>("stored");
    QTest::newRow("disabled in use") << 3 << 0;
    QTest::newRow("disabled where stored") << 0 << 3;
}

// Telling the two apart puts stored values into use for a moment: motors must not notice.
void TestStormMemory::motorsNeitherStartNorFall()
{
    QFETCH(int, inUse);
    QFETCH(int, stored);
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    for (const int motor : {78, 79, 80})
        rig.board().set(motor, stored);
    QVERIFY(rig.device.perform(rig.channel, u"store"_s, {}));
    for (const int motor : {78, 79, 80})
        rig.board().set(motor, inUse);
    QVERIFY(rig.channel.sleep(3s));
    double longest = 0;
    double since = -1;
    rig.channel.setTap([&](const FrameView &, TimePoint) {
        const bool runs = rig.board().stabilizer().motorsOn() && rig.board().inUse(79) != 3;
        if (runs == (inUse != 3)) {
            since = -1;
            return;
        }
        since = since < 0 ? rig.board().now() : since;
        longest = std::max(longest, rig.board().now() - since);
    });
    const auto report = write(rig, u"pid.roll.p"_s, 444);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::ConditionUnmet);
    QVERIFY2(report.error().detail.contains(u".usage"_s), qPrintable(report.error().detail));
    QVERIFY2(longest < 0.05, qPrintable(QString::number(longest)));
    for (const int motor : {78, 79, 80}) {
        QCOMPARE(rig.board().inUse(motor), inUse);
        QCOMPARE(rig.board().stored(motor), stored);
    }
    QCOMPARE(rig.board().stored(6), 400);
    // The operator says that everything is to be stored.
    const auto all = write(rig, u"pid.roll.p"_s, 444, OtherValues::Store);
    QVERIFY(all && all->isComplete() && all->othersUnknown);
    QCOMPARE(rig.board().stored(78), inUse);
    QCOMPARE(rig.board().stored(6), 444);
}

void TestStormMemory::disabledMotorLetsTheOthersRun_data()
{
    QTest::addColumn<int>("firmware");
    for (const int firmware : {79, 90, 96})
        QTest::addRow("0.%d", firmware) << firmware;
}

// A gimbal of two axes: its third motor is disabled, in use as well as where it is stored.
void TestStormMemory::disabledMotorLetsTheOthersRun()
{
    QFETCH(int, firmware);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    const auto usage = write(rig, u"motor.yaw.usage"_s, 3);
    QVERIFY(usage && usage->isComplete());
    QVERIFY(rig.board().stabilizer().motorsOn());
    bool fell = false;
    rig.channel.setTap([&](const FrameView &, TimePoint) {
        fell |= !rig.board().stabilizer().motorsOn() || rig.board().state() != 6;
    });
    const BoardHistory history(m_dir.path());
    QVERIFY(performSafely(rig.channel, rig.device, u"stored.compare"_s, {}, history));
    for (const int raw : {441, 442}) {
        const auto gain = write(rig, u"pid.pitch.p"_s, raw);
        QVERIFY2(gain && gain->isComplete(), qPrintable(why(gain)));
        QCOMPARE(rig.board().stored(0), raw);
    }
    rig.board().set(6, 450);
    QVERIFY(performSafely(rig.channel, rig.device, u"store"_s, {}, history));
    QCOMPARE(rig.board().stored(6), 450);
    QVERIFY(!fell);
    QCOMPARE(rig.board().inUse(80), 3);
    QCOMPARE(rig.board().stored(80), 3);
}

// All motors are disabled: reading what is stored goes through standby, twice in a row as well.
void TestStormMemory::standbyIsLeftAgain()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    for (const int motor : {78, 79, 80})
        rig.board().set(motor, 3);
    QVERIFY(rig.device.perform(rig.channel, u"store"_s, {}));
    const BoardHistory history(m_dir.path());
    for (const int raw : {441, 442}) {
        QVERIFY(performSafely(rig.channel, rig.device, u"stored.compare"_s, {}, history));
        const auto gain = write(rig, u"pid.pitch.p"_s, raw);
        QVERIFY2(gain && gain->isComplete(), qPrintable(why(gain)));
    }
    QVERIFY(rig.board().state() < 7);  // it has left standby
}

// For a moment what is stored is in use: whoever cancels then has it put back first.
void TestStormMemory::cancelledReadingLosesNothing()
{
    int cancelled = 0;
    for (milliseconds after = 0ms; after < 200ms; after += 1ms) {
        StormRig rig;
        QVERIFY(rig.device.identify(rig.channel));
        rig.board().set(6, 555);
        rig.channel.cancelAfter(after);
        const auto both = rig.device.wholeMemory()->readBoth(rig.channel);
        cancelled += !both && both.error().code == ErrorCode::Cancelled ? 1 : 0;
        QVERIFY2(rig.board().inUse(6) == 555, qPrintable(QString::number(after.count())));
    }
    QVERIFY(cancelled > 0);
}

void TestStormMemory::failedWriteLeavesBothAsTheyWere()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    runScript(rig, u"CASE#DEFAULT\nSET \"Yaw P\" 510\nWAIT 0\nREPEAT"_s);
    rig.board().set(0, 500);
    QVERIFY(rig.channel.sleep(150ms));
    const auto report = write(rig, u"pid.yaw.p"_s, 444);
    QVERIFY(report && !report->isComplete());
    QCOMPARE(rig.board().stored(0), 400);
    QCOMPARE(rig.board().inUse(0), 500);
}

void TestStormMemory::storedHeartbeatIsCompared_data()
{
    scriptsAreNamed_data();
}

// Stored on, switched off in use: the stored one must not lock the comparison out.
void TestStormMemory::storedHeartbeatIsCompared()
{
    QFETCH(int, firmware);
    StormRig rig(stormOptions(firmware, false), LineSettings{115200, Parity::None});
    QVERIFY(rig.device.identify(rig.channel));
    rig.board().set(112, 2);
    QVERIFY(rig.device.probe(rig.channel).value());
    QVERIFY(rig.device.perform(rig.channel, u"store"_s, {}));
    QVERIFY(rig.device.perform(rig.channel, u"heartbeat.off"_s, {}));
    rig.board().set(0, 444);
    const auto reply = rig.device.perform(rig.channel, u"stored.compare"_s, {});
    QVERIFY2(reply, reply ? "" : qPrintable(reply.error().detail));
    QCOMPARE(reply->size(), 3);
    QCOMPARE(reply->value(u"pid.pitch.p"_s).toString(), u"4.44 in use, 4.00 stored"_s);
    QCOMPARE(reply->value(u"mavlink.heartbeat"_s).toString(), u"0 in use, 2 stored"_s);
    QCOMPARE(rig.board().inUse(112), 0);
    QCOMPARE(rig.board().stored(112), 2);
    QCOMPARE(rig.board().inUse(0), 444);
    QVERIFY(!rig.device.isEmbedded());
}

void TestStormMemory::wholeWriteWithAStoredHeartbeat()
{
    StormRig rig(stormOptions(96, false), LineSettings{115200, Parity::None});
    QVERIFY(rig.device.identify(rig.channel));
    rig.board().set(112, 1);
    QVERIFY(rig.device.probe(rig.channel).value());
    QVERIFY(rig.device.perform(rig.channel, u"store"_s, {}));
    QVERIFY(rig.device.perform(rig.channel, u"heartbeat.off"_s, {}));
    const auto report = write(rig, u"pid.roll.p"_s, 444);
    QVERIFY2(report && report->isComplete(), qPrintable(why(report)));
    QCOMPARE(rig.board().stored(6), 444);
    QCOMPARE(rig.board().inUse(6), 444);
    QCOMPARE(rig.board().stored(112), 1);
    QCOMPARE(rig.board().inUse(112), 0);
    QVERIFY(!rig.device.isEmbedded());
}

void TestStormMemory::lockedOutBoardKeepsTheTwoApart_data()
{
    otherValues_data();
}

// Through MAVLink as well: the heartbeat itself is one of the values in use that are not stored.
void TestStormMemory::lockedOutBoardKeepsTheTwoApart()
{
    QFETCH(int, firmware);
    QFETCH(int, others);
    QFETCH(int, inUse);
    QFETCH(int, stored);
    StormRig rig(stormOptions(firmware, false), LineSettings{115200, Parity::None});
    QVERIFY(rig.device.identify(rig.channel));
    rig.lockOut();
    rig.board().set(0, 500);
    QVERIFY(rig.device.probe(rig.channel).value());
    const auto report = write(rig, u"pid.roll.p"_s, 444, OtherValues(others));
    QVERIFY2(report && report->isComplete(), qPrintable(why(report)));
    QVERIFY(!report->othersUnknown);
    QCOMPARE(report->others.size(), std::size_t(2));
    QCOMPARE(rig.board().stored(6), 444);
    QCOMPARE(rig.board().inUse(6), 444);
    QCOMPARE(rig.board().inUse(0), inUse);
    QCOMPARE(rig.board().stored(0), stored);
    QCOMPARE(rig.board().inUse(112), OtherValues(others) == OtherValues::PutBack ? 0 : 1);
    QCOMPARE(rig.board().stored(112), OtherValues(others) == OtherValues::Store ? 1 : 0);
    QCOMPARE(rig.device.isEmbedded(), OtherValues(others) != OtherValues::PutBack);
}

void TestStormMemory::stoppedWhileStartingIsNotStored_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<bool>("isFresh");
    for (const int firmware : {79, 90, 96}) {
        QTest::addRow("0.%d, the device that stopped it", firmware) << firmware << false;
        QTest::addRow("0.%d, a new one", firmware) << firmware << true;
    }
}

// A board that starts ignores standby, so a stop disables its motors in RAM: nobody stores that unasked.
void TestStormMemory::stoppedWhileStartingIsNotStored()
{
    QFETCH(int, firmware);
    QFETCH(bool, isFresh);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    rig.change(u"no-imu=1"_s);
    QVERIFY(rig.device.perform(rig.channel, u"restart"_s, {}));
    if (isFresh) {
        for (const int motor : {78, 79, 80})
            rig.board().set(motor, 3);  // by a program that has ended since
    } else {
        rig.channel.stopMotors(rig.device.stopPlan());
        QVERIFY(rig.channel.sleep(2500ms));
        QCOMPARE(rig.board().inUse(78), 3);
    }
    storm32::Device fresh;
    QVERIFY(fresh.identify(rig.channel));
    storm32::Device &device = isFresh ? fresh : rig.device;
    const ErrorCode refusal = isFresh ? ErrorCode::Unready : ErrorCode::Disabled;
    const BoardHistory history(m_dir.path());
    for (const OtherValues others : {OtherValues::Keep, OtherValues::PutBack}) {
        const auto report = write(rig, device, u"pid.pitch.p"_s, 440, others);
        QVERIFY(!report);
        QCOMPARE(report.error().code, refusal);
    }
    for (const QString &key : {u"store"_s, u"stored.compare"_s}) {
        const auto done = performSafely(rig.channel, device, key, {}, history);
        QVERIFY2(!done, qPrintable(key));
        QCOMPARE(done.error().code, refusal);
    }
    QCOMPARE(rig.board().stored(78), 0);
    QCOMPARE(rig.board().stored(0), 400);
    if (!isFresh)
        return;
    // The operator says that everything is to be stored; nobody can tell whether it is.
    const auto all = write(rig, device, u"pid.pitch.p"_s, 440, OtherValues::Store);
    QVERIFY(all && !all->isComplete() && all->othersUnknown && all->storedUntold);
    QCOMPARE(all->error->code, ErrorCode::Unready);
    QCOMPARE(all->count(WriteState::Unknown), 1);
    QCOMPARE(rig.board().stored(78), 3);
    QCOMPARE(rig.board().stored(0), 440);
    // What is in use as wanted may not be stored so: it is written.
    rig.board().set(6, 450);
    const auto same = write(rig, device, u"pid.roll.p"_s, 450, OtherValues::Store);
    QVERIFY(same && same->storedUntold);
    QCOMPARE(same->lines.size(), std::size_t(1));
    QCOMPARE(rig.board().stored(6), 450);
}

// It sets a value between putting everything into use and storing it; the next time it does not.
void TestStormMemory::scriptIsKeptFromStoring()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    runScript(rig, u"CASE#DEFAULT\nWAIT 200\nSET \"Yaw P\" 510\nREPEAT"_s);
    QCOMPARE(rig.board().stored(12), 400);
    bool wasStored = false;
    rig.channel.setTap([&](const FrameView &, TimePoint) {
        if (rig.board().inUse(6) == 444 && !wasStored)
            rig.board().set(12, 510);
        wasStored |= rig.board().stored(12) == 510;
    });
    const auto report = write(rig, u"pid.roll.p"_s, 444);
    QVERIFY2(report && report->isComplete(), qPrintable(why(report)));
    QVERIFY(wasStored);
    QCOMPARE(rig.board().stored(12), 400);
    QCOMPARE(rig.board().inUse(12), 510);  // what the script has set stays in use
    QCOMPARE(rig.board().stored(6), 444);
    QVERIFY(report->storedMeanwhile.empty());
}

// A script that never pauses: what it has stored is not said to be left so.
void TestStormMemory::storedMeanwhileIsTold()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    runScript(rig, u"CASE#DEFAULT\nWAIT 200\nSET \"Yaw P\" 510\nREPEAT"_s);
    QCOMPARE(rig.board().stored(12), 400);
    rig.channel.setTap([&](const FrameView &, TimePoint) {
        if (rig.board().inUse(6) == 444)
            rig.board().set(12, 510);
    });
    const auto report = write(rig, u"pid.roll.p"_s, 444);
    QVERIFY2(report && report->isComplete(), qPrintable(why(report)));
    QCOMPARE(rig.board().stored(12), 510);
    QVERIFY(report->others.empty());
    QCOMPARE(report->storedMeanwhile.size(), std::size_t(1));
    const StoredMeanwhile &value = report->storedMeanwhile.front();
    QCOMPARE(value.spec->key, u"pid.yaw.p"_s);
    QCOMPARE(value.before, 400.0);
    QCOMPARE(value.now, 510.0);
    QCOMPARE(value.setBy, u"script 1"_s);
}

// Nor is it taken for what is stored when it falls between loading and reading.
void TestStormMemory::storedIsNotWhatAScriptHasJustSet()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    runScript(rig, u"CASE#DEFAULT\nWAIT 200\nSET \"Yaw P\" 510\nREPEAT"_s);
    rig.board().set(0, 500);
    bool wasLoaded = false;
    rig.channel.setTap([&](const FrameView &, TimePoint) {
        if (rig.board().inUse(0) == 400 && !std::exchange(wasLoaded, true))
            rig.board().set(12, 510);
    });
    const auto both = rig.device.readBoth(rig.channel);
    QVERIFY(both && wasLoaded);
    QCOMPARE(both->stored.raw(*both->stored.parameters().find(u"pid.yaw.p"_s), 0), 400.0);
}

void TestStormMemory::writtenValueThatAScriptSetsIsTold()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    runScript(rig, u"CASE#DEFAULT\nWAIT 200\nSET \"Yaw P\" 510\nREPEAT"_s);
    const auto report = write(rig, u"pid.yaw.p"_s, 420);
    QVERIFY2(report && report->isComplete(), qPrintable(why(report)));
    QCOMPARE(report->lines.front().state, WriteState::Verified);
    QCOMPARE(report->lines.front().setBy, u"script 1"_s);
}

void TestStormMemory::plainStoreKeepsWhatWasStored_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<QString>("action");
    for (const int firmware : {79, 90, 96}) {
        QTest::addRow("0.%d, store", firmware) << firmware << u"store"_s;
        QTest::addRow("0.%d, erase", firmware) << firmware << u"erase"_s;
    }
}

// What is stored is overwritten: the snapshot holds it, and what becomes of it is told.
void TestStormMemory::plainStoreKeepsWhatWasStored()
{
    QFETCH(int, firmware);
    QFETCH(QString, action);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    rig.board().set(0, 500);
    const BoardHistory history(m_dir.path());
    const auto done = performSafely(rig.channel, rig.device, action, {}, history);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    const auto kept = loadConfiguration(done->snapshotPath, {rig.family});
    QVERIFY(kept);
    const Configuration &snapshot = kept->configuration;
    QCOMPARE(snapshot.raw(*snapshot.parameters().find(u"pid.pitch.p"_s), 0), 400.0);
    QCOMPARE(done->stored.has_value(), action == u"store"_s);
    if (!done->stored)
        return;
    QCOMPARE(rig.board().stored(0), 500);
    QCOMPARE(done->stored->others.size(), std::size_t(1));
    QCOMPARE(done->stored->others.front().inUse, 500.0);
    QCOMPARE(done->stored->others.front().stored, 400.0);
}

void TestStormMemory::restoredWordIsOneOfTheBoard_data()
{
    scriptsAreNamed_data();
}

void TestStormMemory::restoredWordIsOneOfTheBoard()
{
    QFETCH(int, firmware);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    const int words = storm32::wordsOf(rig.board().layout());
    QVERIFY(rig.device.perform(rig.channel, u"restore"_s, {{u"word"_s, words - 1}}));
    const auto beyond = rig.device.perform(rig.channel, u"restore"_s, {{u"word"_s, words}});
    QVERIFY(!beyond);
    QCOMPARE(beyond.error().code, ErrorCode::OutOfRange);
}

void TestStormMemory::anyWordCanBeSetInRam_data()
{
    scriptsAreNamed_data();
}

void TestStormMemory::anyWordCanBeSetInRam()
{
    QFETCH(int, firmware);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    const auto set = [&](const QString &key, double raw) {
        const int id = rig.device.variableOf(*rig.device.parameters()->find(key));
        QVERIFY(rig.device.writeAdjustables(rig.channel, {{id, raw}}));
        QCOMPARE(rig.device.readAdjustables(rig.channel, {id}).value().front().value, raw);
    };
    set(u"rc.pitch.min"_s, -300);  // signed
    set(u"motor.yaw.poles"_s, 12);
    set(u"rc.deadband"_s, 7);
    // All at once, as the pages ask.
    QList<int> ids;
    for (const ParameterSpec &spec : rig.device.parameters()->all())
        ids.append(rig.device.variableOf(spec));
    const auto all = rig.device.readAdjustables(rig.channel, ids);
    QVERIFY(all);
    const Configuration board = rig.device.readConfiguration(rig.channel).value();
    for (std::size_t i = 0; i < all->size(); ++i)
        QCOMPARE((*all)[i].value, board.raw(board.parameters().all()[i], 0).value());
    QCOMPARE(rig.board().stored(word(rig, u"motor.yaw.poles"_s)), 14);
}

// A board that is reached through MAVLink gets another address.
void TestStormMemory::addressIsFollowed()
{
    StormRig rig(stormOptions(96, false), LineSettings{115200, Parity::None});
    QVERIFY(rig.device.identify(rig.channel));
    rig.lockOut();
    QVERIFY(rig.device.probe(rig.channel).value());
    QVERIFY(rig.device.writeAdjustables(rig.channel, {{110, 80}}));
    QVERIFY(rig.device.writeAdjustables(rig.channel, {{111, 90}}));
    QCOMPARE(rig.device.readAdjustables(rig.channel, {110}).value().front().value, 80.0);
}

QTEST_GUILESS_MAIN(TestStormMemory)
#include "tst_stormmemory.moc"
