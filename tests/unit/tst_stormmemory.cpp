// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/writeconfiguration.h"
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
    void failedWriteLeavesBothAsTheyWere();
    void storedHeartbeatIsCompared();
    void wholeWriteWithAStoredHeartbeat();
    void lockedOutBoardSaysWhatItCannotTell();
    void anyWordCanBeSetInRam_data();
    void anyWordCanBeSetInRam();
    void addressIsFollowed();

private:
    Result<WriteReport> write(StormRig &rig, const QString &key, double raw,
                              OtherValues others = OtherValues::Keep)
    {
        const BoardHistory history(m_dir.path());
        const auto base = rig.device.readConfiguration(rig.channel);
        Configuration edited = *base;
        [&] { QVERIFY(edited.setRaw(*edited.parameters().find(key), 0, raw)); }();
        WriteOptions options;
        options.history = &history;
        options.others = others;
        return writeConfiguration(rig.channel, rig.device, *base, edited, options);
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

// Stored on, switched off in use: the stored one must not lock the comparison out.
void TestStormMemory::storedHeartbeatIsCompared()
{
    StormRig rig(stormOptions(96, false), LineSettings{115200, Parity::None});
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

void TestStormMemory::lockedOutBoardSaysWhatItCannotTell()
{
    StormRig rig(stormOptions(96, false), LineSettings{115200, Parity::None});
    QVERIFY(rig.device.identify(rig.channel));
    rig.lockOut();
    QVERIFY(rig.device.probe(rig.channel).value());
    const auto report = write(rig, u"pid.roll.p"_s, 444);
    QVERIFY(report && report->isComplete() && report->othersUnknown);
    QCOMPARE(report->othersUnknown->code, ErrorCode::Unsupported);
    QCOMPARE(rig.board().stored(6), 444);
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
