// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/safeaction.h"
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/record/configurationfile.h"
#include "protocol/storm32/parametertables.h"
#include "protocol/storm32/scripts.h"
#include "tests/support/stormrig.h"
#include "tests/support/virtualboard.h"

#include <QTemporaryDir>
#include <QTest>

using namespace Qt::StringLiterals;

/// What may be entered, wherever it is; and what an entry does.
class TestEntry : public QObject
{
    Q_OBJECT
private slots:
    void menuEntriesHaveTheirRisk_data();
    void menuEntriesHaveTheirRisk();
    void flagsWithoutANameAreRefused();
    void oddTogglesBlockNothing();
    void oddPolesAreRefused();
    void variablesAreChecked_data();
    void variablesAreChecked();
    void scriptsSetWhatMayBeSet_data();
    void scriptsSetWhatMayBeSet();
    void impossibleCalibrationsAreRefused();
};

void TestEntry::menuEntriesHaveTheirRisk_data()
{
    QTest::addColumn<int>("entry");
    QTest::addColumn<ActionRisk>("risk");
    QTest::addColumn<bool>("isShown");
    QTest::newRow("motors off") << 12 << ActionRisk::Moves << true;
    QTest::newRow("set angles by hand") << 8 << ActionRisk::Writes << false;
    QTest::newRow("without storing") << 37 << ActionRisk::Moves << false;
    QTest::newRow("calibrate gyroscope") << 9 << ActionRisk::Writes << false;
    QTest::newRow("load a profile set") << 48 << ActionRisk::Destroys << false;
    QTest::newRow("load the backup") << 53 << ActionRisk::Destroys << false;
}

void TestEntry::menuEntriesHaveTheirRisk()
{
    QFETCH(int, entry);
    QFETCH(ActionRisk, risk);
    QFETCH(bool, isShown);
    VirtualBoard board(withFirmware(2738));
    QVERIFY(board.identify());
    for (const int slot : {1, 6})  // an empty one cannot be loaded
        QVERIFY(board.device.perform(board.channel, u"profile_set"_s, {{u"action"_s, 1}, {u"slot"_s, slot}}));
    const QTemporaryDir dir;
    const BoardHistory history(dir.path());
    const auto done = performSafely(board.channel, board.device, u"menu"_s, {{u"command"_s, entry}}, history);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->answered, isShown);
    QCOMPARE(!done->snapshotPath.isEmpty(), risk == ActionRisk::Writes || risk == ActionRisk::Destroys);
    for (const ActionSpec &action : board.device.actions()) {
        if (qstrcmp(action.key, "menu") == 0)
            QCOMPARE(chosenAction(action, {{u"command"_s, entry}}).risk, risk);
    }
    const auto raw = board.device.parseCommand(u"EXECUTE_MENU %1"_s.arg(entry, 2, 16, QChar(u'0')));
    QVERIFY(raw);
    QCOMPARE(raw->risk, risk);
}

void TestEntry::flagsWithoutANameAreRefused()
{
    VirtualBoard board;
    QVERIFY(board.identify());
    Configuration configuration = *board.device.readConfiguration(board.channel);
    const ParameterSpec &flags = *configuration.parameters().find(u"profile.flags1"_s);
    QVERIFY(configuration.setRaw(flags, 0, 0x0001));
    const auto set = configuration.setRaw(flags, 0, 0x0009);
    QVERIFY(!set);
    QCOMPARE(set.error().code, ErrorCode::OutOfRange);
    QCOMPARE(*configuration.raw(flags, 0), 1.0);
    // What the board holds stays, whatever else is changed.
    QVERIFY(configuration.restoreRaw(flags, 0, 0x0008));
    QVERIFY(configuration.setRaw(flags, 0, 0x000A));
    QCOMPARE(*configuration.raw(flags, 0), double(0x000A));
    const auto file
        = ConfigurationFile::fromJson(ConfigurationFile::toJson(configuration, {}, {}),
                                      [&](const BoardIdentity &) { return configuration.parameterSet(); });
    QVERIFY(file);
    QCOMPARE(*file->configuration.raw(flags, 0), double(0x000A));
}

// The board holds neither on nor off.
void TestEntry::oddTogglesBlockNothing()
{
    VirtualBoard board;
    QVERIFY(board.identify());
    Configuration odd = *board.device.readConfiguration(board.channel);
    for (const ParameterSpec &spec : odd.parameters().all()) {
        if (spec.row->kind == ValueKind::Toggle && spec.row->bitCount == 0 && !spec.row->state)
            QVERIFY2(odd.restoreRaw(spec, 0, 7), qPrintable(spec.key));
    }
    const auto file = ConfigurationFile::fromJson(ConfigurationFile::toJson(odd, {}, {}),
                                                  [&](const BoardIdentity &) { return odd.parameterSet(); });
    QVERIFY(file);
    QVERIFY(file->configuration.blocks() == odd.blocks());
    const QTemporaryDir dir;
    const auto saved = BoardHistory(dir.path()).save(odd, u"test"_s);
    QVERIFY2(saved, saved ? "" : qPrintable(saved.error().detail));
}

void TestEntry::oddPolesAreRefused()
{
    VirtualBoard board;
    QVERIFY(board.identify());
    Configuration configuration = *board.device.readConfiguration(board.channel);
    const ParameterSpec &poles = *configuration.parameters().find(u"motor.yaw.poles"_s);
    QVERIFY(!configuration.setRaw(poles, 0, 13));
    QVERIFY(configuration.setRaw(poles, 0, 22));
}

void TestEntry::variablesAreChecked_data()
{
    QTest::addColumn<int>("id");
    QTest::addColumn<double>("value");
    QTest::addColumn<bool>("isTaken");
    QTest::newRow("mode, speed") << 61 << 1.0 << true;
    QTest::newRow("mode, inverted") << 62 << 8.0 << true;
    QTest::newRow("mode, none") << 63 << 6.0 << false;
    QTest::newRow("mode, bits without a meaning") << 61 << 17.0 << false;
    QTest::newRow("euler order") << 64 << 1.0 << true;
    QTest::newRow("euler order, none") << 64 << 9.0 << false;
    QTest::newRow("follow mode") << 30 << 3.0 << false;
    QTest::newRow("range") << 0 << 256.0 << false;
}

void TestEntry::variablesAreChecked()
{
    QFETCH(int, id);
    QFETCH(double, value);
    QFETCH(bool, isTaken);
    VirtualBoard board(withFirmware(2738));
    QVERIFY(board.identify());
    const auto checked = board.device.checkAdjustable({id, value});
    QCOMPARE(checked.has_value(), isTaken);
    if (isTaken)
        return;
    const auto before = board.device.readAdjustables(board.channel, {id});
    const auto written = board.device.writeAdjustables(board.channel, {{id, value}});
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::OutOfRange);
    const auto after = board.device.readAdjustables(board.channel, {id});
    QCOMPARE(after.has_value(), before.has_value());
    if (after)  // the simulated board does not have all of them
        QCOMPARE(after->front().value, before->front().value);
}

void TestEntry::scriptsSetWhatMayBeSet_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isTaken");
    QTest::newRow("a gain") << u"SET \"Pitch P\" 400"_s << true;
    QTest::newRow("too great a gain") << u"SET \"Pitch P\" 60000"_s << false;
    QTest::newRow("by number") << u"SET \"#0\" 60000"_s << false;
    QTest::newRow("limits") << u"SETMINMAX \"Pitch P\" 100 60000"_s << false;
    QTest::newRow("no such choice") << u"SET \"Pitch Motor Usage\" 9"_s << false;
    QTest::newRow("no such parameter") << u"SET \"#250\" 1"_s << false;
}

void TestEntry::scriptsSetWhatMayBeSet()
{
    QFETCH(QString, text);
    QFETCH(bool, isTaken);
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    const auto context = storm32::scriptContext(*rig.device.parameters(), 96);
    const auto code = storm32::compileScripts({text, {}, {}, {}}, context);
    QCOMPARE(code.has_value(), isTaken);
    // What the board has already does not keep others from being written.
    QVERIFY(storm32::compileScripts({text, u"STOP"_s, {}, {}}, context, {true}));
}

void TestEntry::impossibleCalibrationsAreRefused()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    const QTemporaryDir dir;
    const BoardHistory history(dir.path());
    const auto arguments = argumentsFor(rig.device, "calibration.write",
                                        {{u"zero.x"_s, u"32000"_s},
                                         {u"zero.y"_s, u"0"_s},
                                         {u"zero.z"_s, u"0"_s},
                                         {u"scale.x"_s, u"1"_s},
                                         {u"scale.y"_s, u"16384"_s},
                                         {u"scale.z"_s, u"16384"_s}});
    const auto done = performSafely(rig.channel, rig.device, u"calibration.write"_s, arguments, history);
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::OutOfRange);
}

QTEST_GUILESS_MAIN(TestEntry)
#include "tst_entry.moc"
