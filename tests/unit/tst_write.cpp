// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/base/filefault.h"
#include "protocol/procedure/safeaction.h"
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/record/configurationformats.h"
#include "tests/support/lossychannel.h"
#include "tests/support/virtualboard.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace simplebgc;
using namespace Qt::StringLiterals;

namespace {

SimulatorOptions deafTo(CommandId command)
{
    SimulatorOptions options;
    options.faults.deaf = int(command);
    return options;
}

/// A board that was read, an edited copy of it, and a history in a temporary folder.
struct Bench
{
    explicit Bench(const SimulatorOptions &options = {}, std::optional<LineSettings> line = {})
        : virtualBoard(options, line)
        , history(dir.path())
    {
        if (!virtualBoard.identify())
            qFatal("not identified");
        base = *virtualBoard.device.readConfiguration(virtualBoard.channel);
        edited = base;
    }
    void edit(const QString &key, int profile, int raw)
    {
        if (!edited.setRaw(*base.parameters().find(key), profile, raw))
            qFatal("not edited");
    }
    Result<WriteReport> write()
    {
        WriteOptions options;
        options.history = &history;
        return writeConfiguration(virtualBoard.channel, virtualBoard.device, base, edited, options);
    }
    simplebgc::SimulatedBoard &board() { return virtualBoard.board(); }

    QTemporaryDir dir;
    VirtualBoard virtualBoard;
    BoardHistory history;
    Configuration base;
    Configuration edited;
};

}  // namespace

class TestWrite : public QObject
{
    Q_OBJECT
private slots:
    void writesAndVerifies();
    void activeProfileStaysActive();
    void boardWideValuesReachAllProfiles();
    void reservedBytesSurvive();
    void bracketsOnLaterFirmware();
    void snapshotComesFirst();
    void refusesWithoutBackup();
    void nothingToWriteTouchesNothing();
    void conflictIsFound();
    void foreignChangesElsewhereSurvive();
    void resetInTheMiddleIsReportedTruly_data();
    void resetInTheMiddleIsReportedTruly();
    void unknownFirmwareIsNotWritten();
    void disturbedCableStillWrites();
    void namesAreWritten();
    void fileRoundTrip();
    void fileWithDoubledEntryIsRefused();
    void fileWithoutProfileNamesKeepsThem();
    void fileValuesEditedByHandCount();
    void badFilesAreExplained_data();
    void badFilesAreExplained();
    void fileOfOtherFirmwareAppliesWhatItCan();
    void valuesThatNobodyMaySet_data();
    void valuesThatNobodyMaySet();
    void whatABoardHoldsIsKept();
    void whatABoardHoldsIsNotPassedOn();
    void contradictionsAreNotWritten_data();
    void contradictionsAreNotWritten();
    void contradictionsOfTheBoardMayStay();
    void historyPathsStayInside();
    void destructiveActionsBackUpFirst();
    void whatIsNotDeliveredIsNamed();
    void whatABadLineLostIsAskedForAgain();
    void aSilentBoardIsNoIncompleteOne();
    void oldFirmwareLacksNothing();
    void missingPartsSurviveInFiles();
    void missingNamesAreNotWritten();
    void copyThatLacksWhatIsTouchedIsNoBackup();
};

void TestWrite::writesAndVerifies()
{
    Bench bench;
    bench.edit(u"pid.roll.p"_s, 0, 44);
    bench.edit(u"pid.yaw.d"_s, 2, 99);
    bench.edit(u"filter.pitch.lpf"_s, 0, 250);
    bench.edit(u"motion.roll.acc_limit"_s, 4, 50);
    const auto report = bench.write();
    QVERIFY(report);
    QVERIFY(report->isComplete());
    QCOMPARE(report->count(WriteState::Verified), 4);
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 44);
    QCOMPARE(bench.board().stored(u"pid.yaw.d"_s, 2), 99);
    QCOMPARE(bench.board().stored(u"filter.pitch.lpf"_s, 0), 250);
    QCOMPARE(bench.board().stored(u"motion.roll.acc_limit"_s, 4), 50);
    const auto again = bench.virtualBoard.device.readConfiguration(bench.virtualBoard.channel);
    QVERIFY(again->changesTo(bench.edited).empty());
    QVERIFY(report->onBoard.changesTo(bench.edited).empty());
}

void TestWrite::activeProfileStaysActive()
{
    Bench bench;
    bench.edit(u"pid.roll.p"_s, 3, 50);
    QVERIFY(bench.write()->isComplete());
    QCOMPARE(bench.board().activeProfile(), 0);
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 3), 50);
}

void TestWrite::boardWideValuesReachAllProfiles()
{
    Bench bench;
    bench.edit(u"motor.roll.poles"_s, 0, 22);
    bench.edit(u"pid.roll.p"_s, 2, 61);
    const auto report = bench.write();
    QVERIFY(report->isComplete());
    QCOMPARE(report->lines.size(), std::size_t(2));
    for (int profile = 0; profile < kProfileCount; ++profile)
        QCOMPARE(bench.board().stored(u"motor.roll.poles"_s, profile), 22);
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 2), 61);
}

void TestWrite::reservedBytesSurvive()
{
    Bench bench;
    const QByteArray before = bench.base.block({0, ParamsExt});
    const QByteArray before2 = bench.base.block({0, ParamsExt2});
    QVERIFY(before.mid(49, 2) != QByteArray(2, '\0'));
    bench.edit(u"filter.roll.lpf"_s, 0, 123);
    bench.edit(u"motion.yaw.acc_limit"_s, 0, 7);
    QVERIFY(bench.write()->isComplete());
    const auto again = *bench.virtualBoard.device.readConfiguration(bench.virtualBoard.channel);
    const QByteArray after = again.block({0, ParamsExt});
    int differences = 0;
    for (int i = 0; i < after.size(); ++i)
        differences += after[i] != before[i];
    QVERIFY(differences <= 2);
    QCOMPARE(after.mid(49, 2), before.mid(49, 2));
    // Seed-era firmware: 125 reserved bytes at the end of PARAMS_EXT2.
    QCOMPARE(again.block({0, ParamsExt2}).mid(26), before2.mid(26));
}

void TestWrite::bracketsOnLaterFirmware()
{
    SimulatorOptions options;
    options.firmware = 2704;
    Bench bench(options);
    QList<int> confirmed;
    bench.virtualBoard.channel.setTap([&](const FrameView &frame, TimePoint) {
        if (frame.id == 67 && !frame.payload.empty())
            confirmed.append(std::to_integer<int>(frame.payload[0]));
    });
    bench.edit(u"pid.roll.p"_s, 0, 44);
    QVERIFY(bench.write()->isComplete());
    QCOMPARE(confirmed, (QList<int>{119, 22, 119}));
}

void TestWrite::snapshotComesFirst()
{
    Bench bench;
    bench.edit(u"pid.roll.p"_s, 0, 44);
    const auto report = bench.write();
    QVERIFY(QFile::exists(report->snapshotPath));
    const auto snapshot = ConfigurationFile::load(report->snapshotPath, parametersFor);
    QVERIFY(snapshot);
    // It holds the board as it was, to the byte.
    QVERIFY(snapshot->configuration.blocks() == bench.base.blocks());
    QCOMPARE(snapshot->reason, u"before the first write"_s);
    QCOMPARE(bench.history.snapshots(bench.base.identity().serial).size(), 1);
}

void TestWrite::refusesWithoutBackup()
{
    Bench bench;
    bench.edit(u"pid.roll.p"_s, 0, 44);
    // The history's folder is a file: nothing can be saved there.
    QFile blocker(bench.dir.filePath(u"x"_s));
    QVERIFY(blocker.open(QIODevice::WriteOnly));
    bench.history = BoardHistory(bench.dir.filePath(u"x"_s));
    const auto report = bench.write();
    QCOMPARE(report.error().code, ErrorCode::NoBackup);
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 35);
    WriteOptions none;
    QCOMPARE(writeConfiguration(bench.virtualBoard.channel, bench.virtualBoard.device, bench.base,
                                bench.edited, none)
                 .error()
                 .code,
             ErrorCode::NoBackup);
}

void TestWrite::nothingToWriteTouchesNothing()
{
    Bench bench;
    const qint64 before = bench.virtualBoard.channel.bytesOut();
    const auto report = bench.write();
    QVERIFY(report->isComplete());
    QVERIFY(report->lines.empty());
    QCOMPARE(bench.virtualBoard.channel.bytesOut(), before);
}

void TestWrite::conflictIsFound()
{
    Bench bench;
    bench.edit(u"pid.roll.p"_s, 0, 44);
    bench.board().store(u"pid.roll.p"_s, 0, 60);  // somebody else
    const auto report = bench.write();
    QCOMPARE(report.error().code, ErrorCode::Conflict);
    QVERIFY(report.error().detail.contains(u"pid.roll.p"_s));
    QVERIFY(report.error().detail.contains(u"60"_s));
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 60);
    // Read anew, the difference is known and may be written.
    bench.base = *bench.virtualBoard.device.readConfiguration(bench.virtualBoard.channel);
    QVERIFY(bench.write()->isComplete());
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 44);
}

void TestWrite::foreignChangesElsewhereSurvive()
{
    Bench bench;
    bench.edit(u"pid.roll.p"_s, 0, 44);
    bench.board().store(u"pid.pitch.p"_s, 0, 77);
    QVERIFY(bench.write()->isComplete());
    QCOMPARE(bench.board().stored(u"pid.pitch.p"_s, 0), 77);
}

void TestWrite::resetInTheMiddleIsReportedTruly_data()
{
    QTest::addColumn<int>("atWrite");
    QTest::addColumn<bool>("usb");
    for (int n = 1; n <= 3; ++n) {
        QTest::addRow("USB, block %d", n) << n << true;
        QTest::addRow("UART, block %d", n) << n << false;
    }
}

void TestWrite::resetInTheMiddleIsReportedTruly()
{
    QFETCH(int, atWrite);
    QFETCH(bool, usb);
    SimulatorOptions options;
    options.usb = usb;
    options.faults.resetOnWrite = atWrite;
    const LineSettings line{115200, Parity::None};
    Bench bench(options, usb ? std::nullopt : std::optional(line));
    bench.edit(u"pid.roll.p"_s, 1, 11);  // first half of PARAMS_3 of profile 2
    bench.edit(u"follow.yaw.lpf"_s, 1, 9);  // second half of the same block
    bench.edit(u"pid.roll.p"_s, 2, 12);
    bench.edit(u"pid.roll.p"_s, 0, 13);
    const auto report = bench.write();
    QVERIFY(report);
    QVERIFY2(!report->isComplete() || (!usb && report->count(WriteState::Verified) == 4),
             "a broken write passes for a complete one");
    bench.virtualBoard.port.advance(3s);
    bench.virtualBoard.channel.queue().cancelAll({ErrorCode::LinkClosed, {}, 0});
    // What the report says must be so: verified values are there, values never sent are not.
    for (const WriteLine &told : report->lines) {
        const int stored = bench.board().stored(told.spec->key, told.profile);
        if (told.state == WriteState::Verified)
            QCOMPARE(stored, told.to);
        if (told.state == WriteState::NotWritten || told.state == WriteState::RolledBack)
            QCOMPARE(stored, told.from);
    }
    // After reconnecting, what is not on the board shows as a change again: nothing goes unnoticed.
    QVERIFY(bench.virtualBoard.identify());
    const auto again = bench.virtualBoard.device.readConfiguration(bench.virtualBoard.channel);
    QVERIFY(again);
    for (const ParameterChange &change : again->changesTo(bench.edited))
        QVERIFY(bench.board().stored(change.spec->key, change.profile) != change.to);
}

void TestWrite::unknownFirmwareIsNotWritten()
{
    SimulatorOptions options;
    options.faults.unknownFirmware = true;
    Bench bench(options);
    bench.edit(u"pid.roll.p"_s, 0, 44);
    QCOMPARE(bench.write().error().code, ErrorCode::ReadOnly);
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 35);
}

void TestWrite::disturbedCableStillWrites()
{
    SimulatorOptions options;
    options.faults.flipByte = 0.0003;
    options.seed = 5;
    Bench bench(options);
    bench.edit(u"pid.roll.p"_s, 0, 44);
    bench.edit(u"pid.roll.p"_s, 1, 46);
    const auto report = bench.write();
    QVERIFY(report);
    QVERIFY2(report->isComplete(), "retries did not bring the write through");
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 44);
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 1), 46);
}

void TestWrite::namesAreWritten()
{
    Bench bench;
    bench.edited.setProfileNames({u"Eins"_s, u"Zwei"_s, u"Drei"_s, u"Vier"_s, u"Fünf"_s});
    const auto report = bench.write();
    QVERIFY(report->isComplete());
    QVERIFY(report->areNamesWritten());
    QCOMPARE(bench.virtualBoard.device.readProfileNames(bench.virtualBoard.channel)->at(4), u"Fünf"_s);
}

void TestWrite::fileRoundTrip()
{
    for (const int firmware : {2439, 2590, 2738}) {
        SimulatorOptions options;
        options.firmware = firmware;
        Bench bench(options);
        const QString path = bench.dir.filePath(u"a.json"_s);
        QVERIFY(ConfigurationFile::save(path, bench.base, u"test"_s));
        const auto file = ConfigurationFile::load(path, parametersFor);
        QVERIFY(file);
        QVERIFY(file->configuration.blocks() == bench.base.blocks());
        QCOMPARE(file->configuration.profileNames(), bench.base.profileNames());
        QVERIFY(file->unknownKeys.isEmpty());
        QStringList skipped;
        QVERIFY(bench.base.changesTo(applied(bench.base, file->configuration, skipped)).empty());
        QVERIFY(skipped.isEmpty());
    }
}

// Which of the two counts nobody can know.
void TestWrite::fileWithDoubledEntryIsRefused()
{
    const Bench bench;
    QByteArray json = ConfigurationFile::toJson(bench.base, u"test"_s, QDateTime::currentDateTimeUtc());
    json.replace("\"pid.roll.i\": 0.15,", "\"pid.roll.i\": 0.15,\n\"pid.roll.i\": 0.22,");
    const auto file = ConfigurationFile::fromJson(json, parametersFor);
    QVERIFY(!file && file.error().file);
    QCOMPARE(file.error().file->problem, FileProblem::Doubled);
    QCOMPARE(file.error().file->key, u"pid.roll.i"_s);
    QCOMPARE(file.error().file->expected, QString::number(file.error().file->line - 1));
}

// Profiles without a name in the file do not lose theirs.
void TestWrite::fileWithoutProfileNamesKeepsThem()
{
    Bench bench;
    QByteArray json = ConfigurationFile::toJson(bench.base, u"test"_s, QDateTime::currentDateTimeUtc());
    json.replace("\"name\": ", "\"called\": ");
    const auto file = ConfigurationFile::fromJson(json, parametersFor);
    QVERIFY(file);
    QCOMPARE(file->configuration.missing().size(), std::size_t(1));
    bench.base.setProfileNames({u"Studio"_s});
    QStringList skipped;
    QCOMPARE(applied(bench.base, *file, skipped).profileNames(), bench.base.profileNames());
}

void TestWrite::fileValuesEditedByHandCount()
{
    Bench bench;
    QByteArray json = ConfigurationFile::toJson(bench.base, u"test"_s, QDateTime::currentDateTimeUtc());
    QVERIFY(json.contains("\"pid.roll.i\": 0.15"));
    json.replace("\"pid.roll.i\": 0.15", "\"pid.roll.i\": 0.2231");
    json.replace("\"motor.roll.poles\": 14", "\"motor.roll.poles\": 22, \"no.such.key\": 1");
    const auto file = ConfigurationFile::fromJson(json, parametersFor);
    QVERIFY(file);
    QCOMPARE(file->unknownKeys, QStringList{u"no.such.key"_s});
    QCOMPARE(file->rounded.size(), 5);  // in each profile
    QVERIFY2(file->rounded.first().contains(u"0.22 is the nearest to 0.2231"_s),
             qPrintable(file->rounded.first()));
    QStringList skipped;
    const auto changes = bench.base.changesTo(applied(bench.base, file->configuration, skipped));
    QStringList keys;
    for (const ParameterChange &change : changes)
        keys.append(u"%1=%2"_s.arg(change.spec->key).arg(change.to));
    keys.sort();
    QVERIFY2(keys.contains(u"pid.roll.i=22"_s) && keys.contains(u"motor.roll.poles=22"_s),
             qPrintable(keys.join(u' ')));
}

void TestWrite::badFilesAreExplained_data()
{
    QTest::addColumn<QByteArray>("find");
    QTest::addColumn<QByteArray>("replace");
    QTest::addColumn<QString>("says");
    QTest::newRow("not JSON") << QByteArray("{") << QByteArray("<") << u"JSON"_s;
    QTest::newRow("other format") << QByteArray("gimbaldesk-configuration") << QByteArray("x")
                                  << u"not a GimbalDesk"_s;
    QTest::newRow("other version") << QByteArray("\"version\": 1") << QByteArray("\"version\": 9")
                                   << u"version = 9"_s;
    QTest::newRow("other family") << QByteArray("simplebgc") << QByteArray("nonsense") << u"nonsense"_s;
    QTest::newRow("out of range") << QByteArray("\"pid.roll.p\": 35") << QByteArray("\"pid.roll.p\": 999")
                                  << u"0 to 255"_s;
    QTest::newRow("no number") << QByteArray("\"pid.roll.p\": 35") << QByteArray("\"pid.roll.p\": \"high\"")
                               << u"pid.roll.p"_s;
    QTest::newRow("profile 77") << QByteArray("\"activeProfile\": 1") << QByteArray("\"activeProfile\": 77")
                                << u"77"_s;
    QTest::newRow("many profiles") << QByteArray("\"profileCount\": 5")
                                   << QByteArray("\"profileCount\": 500000") << u"profileCount"_s;
}

void TestWrite::badFilesAreExplained()
{
    QFETCH(QByteArray, find);
    QFETCH(QByteArray, replace);
    QFETCH(QString, says);
    Bench bench;
    QByteArray json = ConfigurationFile::toJson(bench.base, u"test"_s, QDateTime::currentDateTimeUtc());
    QVERIFY(json.contains(find));
    json.replace(find, replace);
    const auto file = ConfigurationFile::fromJson(json, parametersFor);
    QVERIFY(!file);
    QCOMPARE(file.error().code, ErrorCode::BadFile);
    QVERIFY2(file.error().detail.contains(says), qPrintable(file.error().detail));
    QVERIFY(!ConfigurationFile::load(bench.dir.filePath(u"none.json"_s), parametersFor));
}

void TestWrite::fileOfOtherFirmwareAppliesWhatItCan()
{
    SimulatorOptions later;
    later.firmware = 2704;
    Bench newer(later);
    Bench older;
    newer.edit(u"pid.roll.p"_s, 0, 91);
    newer.edit(u"limit.yaw.max"_s, 0, 90);
    QStringList skipped;
    const Configuration result = applied(older.base, newer.edited, skipped);
    QCOMPARE(*result.raw(*older.base.parameters().find(u"pid.roll.p"_s), 0), 91);
    QVERIFY(skipped.contains(u"limit.yaw.max"_s));
    QVERIFY(!skipped.contains(u"pid.roll.p"_s));
}

void TestWrite::valuesThatNobodyMaySet_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("raw");
    QTest::addColumn<QString>("allowed");
    const auto row = [](int firmware, const char *key, int raw, const char *allowed) {
        QTest::addRow("%s %d", key, firmware)
            << firmware << QString::fromLatin1(key) << raw << QString::fromLatin1(allowed);
    };
    row(2590, "imu.main.axis_top", 0, "-3 to -1, 1 to 3");
    row(2590, "rc.map.roll", 200, "0 to 5, 33 to 35, 65 to 95, 129 to 159");
    row(2704, "rc.map.roll", 200, "0 to 5, 33 to 35, 65 to 95, 129 to 159, 161 to 166");
    row(2590, "imu.euler_order", 9, "0 to 5");
    row(2704, "imu.euler_order", 5, "0 to 4");
    row(2590, "motor.roll.output", 6, "0 to 3");
    row(2704, "motor.roll.output", 8, "0 to 7");
}

void TestWrite::valuesThatNobodyMaySet()
{
    QFETCH(int, firmware);
    QFETCH(QString, key);
    QFETCH(int, raw);
    QFETCH(QString, allowed);
    SimulatorOptions options;
    options.firmware = firmware;
    Bench bench(options);
    const ParameterSpec &spec = *bench.base.parameters().find(key);
    const auto set = bench.edited.setRaw(spec, 0, raw);
    QVERIFY(!set);
    QCOMPARE(set.error().code, ErrorCode::OutOfRange);
    QCOMPARE(set.error().detail, u"%1 = %2, allowed %3"_s.arg(key).arg(raw).arg(allowed));
    QCOMPARE(bench.edited.blocks(), bench.base.blocks());
}

void TestWrite::whatABoardHoldsIsKept()
{
    Bench bench;
    const ParameterSpec &source = *bench.base.parameters().find(u"rc.map.roll"_s);
    QVERIFY(bench.base.restoreRaw(source, 0, 200));
    const auto file
        = ConfigurationFile::fromJson(ConfigurationFile::toJson(bench.base, {}, {}),
                                      [&](const BoardIdentity &) { return bench.base.parameterSet(); });
    QVERIFY(file);
    QCOMPARE(*file->configuration.raw(source, 0), 200.0);
    QStringList skipped;
    QCOMPARE(*applied(bench.base, file->configuration, skipped).raw(source, 0), 200.0);
    QVERIFY2(skipped.isEmpty(), qPrintable(skipped.join(u'\n')));
    // What was in use is put back, whatever it is.
    Configuration live = bench.base;
    QVERIFY(live.setRaw(source, 0, 2));
    live = withoutLive(live, {{source.key, 200, 2}});
    QCOMPARE(*live.raw(source, 0), 200.0);
    QVERIFY(!live.restoreRaw(source, 0, 256));
    QCOMPARE(*live.raw(source, 0), 200.0);
}

void TestWrite::whatABoardHoldsIsNotPassedOn()
{
    Bench bench;
    const ParameterSpec &source = *bench.base.parameters().find(u"rc.map.roll"_s);
    const ParameterSpec &gain = *bench.base.parameters().find(u"pid.roll.p"_s);
    Configuration other = bench.base;
    QVERIFY(other.restoreRaw(source, 1, 200));
    QVERIFY(other.setRaw(gain, 1, 77));
    QStringList skipped;
    const Configuration wanted = applied(bench.base, other, skipped);
    QCOMPARE(wanted.raw(source, 1), bench.base.raw(source, 1));
    QCOMPARE(*wanted.raw(gain, 1), 77.0);
    QCOMPARE(skipped.size(), 1);
    QVERIFY2(skipped.first().startsWith(u"rc.map.roll = 200, allowed 0 to 5"_s), qPrintable(skipped.first()));
    // A comparison hides nothing.
    skipped.clear();
    QCOMPARE(*applied(bench.base, other, skipped, AppliedFor::Comparing).raw(source, 1), 200.0);
    QVERIFY(skipped.isEmpty());
}

void TestWrite::contradictionsAreNotWritten_data()
{
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("second");
    QTest::addColumn<int>("raw");
    QTest::addColumn<int>("other");
    const auto row = [](const char *first, const char *second, int raw, int other) {
        QTest::addRow("%s %d", first, other)
            << QString::fromLatin1(first) << QString::fromLatin1(second) << raw << other;
    };
    row("imu.main.axis_top", "imu.main.axis_right", 2, 2);
    row("imu.main.axis_top", "imu.main.axis_right", 2, -2);
    row("imu.frame.axis_top", "imu.frame.axis_right", 1, 1);
    row("imu.mag.axis_top", "imu.mag.axis_right", 3, -3);
    row("motor.roll.output", "motor.pitch.output", 2, 2);
    row("motor.pitch.output", "motor.yaw.output", 3, 3);
    // The pins of servo outputs (document, SERVO_OUT) and of the receiver (RC_VIRT_MODE).
    row("rc.map.yaw", "service.servo1.source", 3, 1);
    row("rc.map.cmd", "service.servo2.source", 4, 2);
    row("rc.map.pitch", "service.servo3.source", 2, 3);
    row("rc.map.roll", "rc.input_mode", 1, 2);
}

void TestWrite::contradictionsAreNotWritten()
{
    QFETCH(QString, first);
    QFETCH(QString, second);
    QFETCH(int, raw);
    QFETCH(int, other);
    Bench bench;
    const auto before = bench.base;
    bench.edit(first, 0, raw);
    bench.edit(second, 0, other);
    const auto report = bench.write();
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::Contradiction);
    for (const QString &named : {first, second})
        QVERIFY2(report.error().detail.contains(named), qPrintable(report.error().detail));
    const auto now = bench.virtualBoard.device.readConfiguration(bench.virtualBoard.channel);
    QVERIFY(now && before.changesTo(*now).empty());
}

void TestWrite::contradictionsOfTheBoardMayStay()
{
    Bench bench;
    const ParameterSpec &top = *bench.base.parameters().find(u"imu.frame.axis_top"_s);
    const ParameterSpec &right = *bench.base.parameters().find(u"imu.frame.axis_right"_s);
    Configuration held = bench.base;
    QVERIFY(held.restoreRaw(right, 0, *held.raw(top, 0)));
    Configuration edited = held;
    QVERIFY(edited.setRaw(*edited.parameters().find(u"pid.roll.p"_s), 0, 44));
    QVERIFY(edited.checkRules(held));
    QVERIFY(!edited.checkRules(bench.base));
    // Two motors that are off are at no output.
    for (const QString &key : {u"motor.roll.output"_s, u"motor.yaw.output"_s})
        bench.edit(key, 0, 0);
    QVERIFY(bench.edited.checkRules(bench.base));
}

void TestWrite::historyPathsStayInside()
{
    Bench bench;
    BoardIdentity identity = bench.base.identity();
    identity.serial = u"../../etc/passwd"_s;
    Configuration evil(identity, bench.base.parameterSet());
    for (const auto &[key, bytes] : bench.base.blocks())
        evil.setBlock(key, bytes);
    const auto path = bench.history.save(evil, u"x"_s);
    QVERIFY(path);
    QVERIFY2(!QDir(bench.dir.path()).relativeFilePath(*path).startsWith(u".."_s), qPrintable(*path));
}

void TestWrite::destructiveActionsBackUpFirst()
{
    Bench bench;
    const QVariantMap arguments{{u"what"_s, 1}};
    BoardHistory broken(u"/proc/nowhere"_s);
    QCOMPARE(
        performSafely(bench.virtualBoard.channel, bench.virtualBoard.device, u"defaults"_s, arguments, broken)
            .error()
            .code,
        ErrorCode::NoBackup);
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 1), 45);
    const auto done = performSafely(bench.virtualBoard.channel, bench.virtualBoard.device, u"defaults"_s,
                                    arguments, bench.history);
    QVERIFY(done);
    QVERIFY(QFile::exists(done->snapshotPath));
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 1), 35);
}

void TestWrite::whatIsNotDeliveredIsNamed()
{
    const Bench bench(deafTo(CommandId::ReadParamsExt2));
    QCOMPARE(bench.base.missingNames(),
             (QStringList{u"PARAMS_EXT2 of profile 1"_s, u"PARAMS_EXT2 of profile 2"_s,
                          u"PARAMS_EXT2 of profile 3"_s, u"PARAMS_EXT2 of profile 4"_s,
                          u"PARAMS_EXT2 of profile 5"_s}));
    for (int profile = 0; profile < 5; ++profile) {
        QVERIFY(bench.base.blocks().contains({profile, Params3}));
        QVERIFY(bench.base.blocks().contains({profile, ParamsExt}));
    }
    const ParameterSpec &limit = *bench.base.parameters().find(u"motion.roll.acc_limit"_s);
    QVERIFY(!bench.base.raw(limit, 3));
    QCOMPARE(bench.base.findMissing(limit, 3)->why.code, ErrorCode::Timeout);
    QVERIFY(!bench.base.findMissing(*bench.base.parameters().find(u"pid.roll.p"_s), 3));

    QCOMPARE(Bench(deafTo(CommandId::ReadProfileNames)).base.missingNames(), QStringList{u"profile names"_s});
    QVERIFY(Bench().base.missing().empty());
}

void TestWrite::whatABadLineLostIsAskedForAgain()
{
    Bench bench;
    LossyChannel channel(bench.virtualBoard.channel);
    channel.lose(CommandId::ReadParamsExt, 1, 1);
    channel.lose(CommandId::ReadParams3, 0, 1);
    channel.lose(CommandId::ReadParamsExt2, 4, 2);
    const auto read = bench.virtualBoard.device.readConfiguration(channel);
    QVERIFY(read);
    QCOMPARE(read->missingNames(), QStringList{u"PARAMS_EXT2 of profile 5"_s});
    QCOMPARE(read->blocks().size(), std::size_t(19));
    QCOMPARE(read->activeProfile(), bench.base.activeProfile());
    QVERIFY(bench.base.changesTo(*read).empty());
}

void TestWrite::aSilentBoardIsNoIncompleteOne()
{
    Bench bench;
    LossyChannel channel(bench.virtualBoard.channel);
    for (const CommandId id : {CommandId::ReadParams3, CommandId::ReadParamsExt, CommandId::ReadParamsExt2})
        channel.lose(id, 2, 9);
    const auto read = bench.virtualBoard.device.readConfiguration(channel);
    QVERIFY(!read);
    QCOMPARE(read.error().code, ErrorCode::Timeout);
}

void TestWrite::oldFirmwareLacksNothing()
{
    SimulatorOptions options = deafTo(CommandId::ReadParamsExt2);
    options.firmware = 2400;
    const Bench bench(options, LineSettings{115200, Parity::Even});
    QVERIFY(bench.base.missing().empty());
    QCOMPARE(bench.base.blocks().size(), std::size_t(15));
}

void TestWrite::missingPartsSurviveInFiles()
{
    Bench whole;
    whole.edited.setProfileNames({u"A"_s, u"B"_s, u"C"_s, u"D"_s, u"E"_s});
    Configuration partial(whole.base.identity(), whole.base.parameterSet());
    for (const auto &[key, bytes] : whole.base.blocks()) {
        if (key != BlockKey{1, ParamsExt})
            partial.setBlock(key, bytes);
    }
    partial.addMissing({1, ParamsExt}, {ErrorCode::Timeout, {}, 0});
    partial.addMissing({0, MissingPart::kProfileNames}, {ErrorCode::Timeout, {}, 0});
    const QString path = whole.dir.filePath(u"partial.json"_s);
    QVERIFY(ConfigurationFile::save(path, partial, u"x"_s));
    const auto file = loadConfiguration(path, allFamilies());
    QVERIFY(file);
    QCOMPARE(file->configuration.missingNames(), partial.missingNames());
    // Applied to the whole board it changes nothing: neither the names nor the values it does not know.
    QStringList skipped;
    const Configuration wanted = applied(whole.edited, file->configuration, skipped);
    QCOMPARE(wanted.profileNames(), whole.edited.profileNames());
    QVERIFY(whole.edited.changesTo(wanted).empty());
    QVERIFY2(skipped.isEmpty(), qPrintable(skipped.join(u", "_s)));
    // What the later profiles hold is not dropped with the missing one.
    Configuration other = partial;
    QVERIFY(other.setRaw(*other.parameters().find(u"filter.pitch.lpf"_s), 2, 123));
    const auto changes = whole.edited.changesTo(applied(whole.edited, other, skipped));
    QCOMPARE(changes.size(), std::size_t(1));
    QCOMPARE(changes.front().profile, 2);
}

void TestWrite::missingNamesAreNotWritten()
{
    const Bench deaf(deafTo(CommandId::ReadProfileNames));
    Bench whole;
    whole.base.setProfileNames({u"A"_s, u"B"_s, u"C"_s, u"D"_s, u"E"_s});
    QStringList skipped;
    const Configuration wanted = applied(deaf.base, whole.base, skipped);
    QVERIFY(!deaf.base.hasOtherNames(wanted));
    QCOMPARE(skipped, QStringList{u"profile names"_s});
}

void TestWrite::copyThatLacksWhatIsTouchedIsNoBackup()
{
    Bench bench;
    LossyChannel channel(bench.virtualBoard.channel);
    channel.lose(CommandId::ReadParamsExt2, 0, 99);
    WriteOptions options;
    options.history = &bench.history;
    bench.edit(u"motion.roll.acc_limit"_s, 0, 50);
    const auto refused
        = writeConfiguration(channel, bench.virtualBoard.device, bench.base, bench.edited, options);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::NoBackup);
    QVERIFY(refused.error().detail.contains(u"PARAMS_EXT2 of profile 1"_s));
    // What the copy holds may be written; the copy is not whole.
    bench.edited = bench.base;
    bench.edit(u"pid.roll.p"_s, 0, 44);
    const auto report
        = writeConfiguration(channel, bench.virtualBoard.device, bench.base, bench.edited, options);
    QVERIFY(report && report->isComplete());
    QVERIFY(!report->isSnapshotComplete());
    QVERIFY(!report->snapshotLacks.isEmpty() && !report->snapshotLacks.contains(QString()));
    QVERIFY(bench.write()->isSnapshotComplete());
    // An action that destroys may touch everything.
    const auto destroyed
        = performSafely(channel, bench.virtualBoard.device, u"defaults"_s, {{u"what"_s, 1}}, bench.history);
    QVERIFY(!destroyed);
    QCOMPARE(destroyed.error().code, ErrorCode::NoBackup);
}

QTEST_APPLESS_MAIN(TestWrite)
#include "tst_write.moc"
