// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/client/framelog.h"
#include "protocol/configuration/livevalues.h"
#include "protocol/record/telemetrycsv.h"
#include "protocol/simplebgc/adjustables.h"
#include "protocol/simplebgc/frametext.h"
#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "tests/support/virtualboard.h"

#include <QBuffer>
#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace simplebgc;

namespace {

FrameText text(CommandId id, const QByteArray &payload, bool fromBoard)
{
    return describeFrame({number(id), asBytes(payload), 1}, fromBoard, nullptr);
}

}  // namespace

/// Looking inside a board: frames in words, commands typed by hand, variables, values in use against stored
/// ones.
class TestInspect : public QObject
{
    Q_OBJECT
private slots:
    void framesInWords_data();
    void framesInWords();
    void everyFrameSurvivesAnyPayload();
    void parameterBlocksNameTheirValues();
    void laterRealtimeIsToldInWords();
    void progressHasTheScaleOfTheFirmware_data();
    void progressHasTheScaleOfTheFirmware();
    void commandsByNameAndHex_data();
    void commandsByNameAndHex();
    void variablesGrowWithTheFirmware();
    void variablesHaveTheRangesOfTheirFirmware_data();
    void variablesHaveTheRangesOfTheirFirmware();
    void signalThatIsNotThereIsAGap();
    void debugVariablesInParts();
    void sixPositionsFindZeroAndScale();
    void aShakenSensorIsNotCalibrated();
    void liveValuesAreTakenOutOfReads();
    void logKeepsTheNewest();
    void csvMergesStreams();
};

void TestInspect::framesInWords_data()
{
    QTest::addColumn<int>("id");
    QTest::addColumn<QByteArray>("payload");
    QTest::addColumn<bool>("fromBoard");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("part");
    const auto row = [](const char *title, CommandId id, const char *payload, bool fromBoard,
                        const char *name, const char *part) {
        QTest::newRow(title) << number(id) << QByteArray::fromHex(payload) << fromBoard
                             << QString::fromLatin1(name) << QString::fromUtf8(part);
    };
    // 67 is CONTROL to the board and CONFIRM from it (errata 2).
    row("confirm", CommandId::Confirm, "4D", true, "CONFIRM", "MOTORS_ON");
    row("file written", CommandId::Confirm, "3604", true, "CONFIRM", "WRITE_FILE: no free space");
    row("memory written", CommandId::Confirm, "2F80000000", true, "CONFIRM", "EEPROM_WRITE: address 128");
    row("arrived", CommandId::Confirm, "4301", true, "CONFIRM", "CONTROL: the task is done");
    row("cogging at its end", CommandId::Confirm, "5DFF", true, "CONFIRM", "CALIB_COGGING: the task is done");
    row("with unknown data", CommandId::Confirm, "160A0B", true, "CONFIRM", "WRITE_PARAMS_3: data 0a 0b");
    row("control", CommandId::Control, "020202 0A00 5B04 0000 0000 0000 0000", false, "CONTROL",
        "R: angle 1.22°/s, 24.50°");
    // What a mode does not mean is not told in its place.
    row("control by signal", CommandId::Control, "040700 0000 2C01 0000 0000 0000 0000", false, "CONTROL",
        "R: rc 300; P: left alone; Y: not controlled");
    row("error", CommandId::Error, "450200000000", true, "ERROR", "EXECUTE_MENU: wrong parameters");
    row("menu", CommandId::ExecuteMenu, "0B", false, "EXECUTE_MENU", "Motors on");
    row("variables", CommandId::SetAdjVarsVal, "01 13 64000000", false, "SET_ADJ_VARS_VAL",
        "rc_speed.roll = 100");
    row("stream", CommandId::DataStreamInterval, "19 2800 0000000000000000 00000000000000000000", false,
        "DATA_STREAM_INTERVAL", "REALTIME_DATA_4, every 40 ms");
    row("battery", CommandId::CalibBat, "CE04", false, "CALIB_BAT", "12.30 V");
    row("defaults", CommandId::UseDefaults, "01", false, "USE_DEFAULTS", "profile 2");
    row("erased", CommandId::UseDefaults, "FD", false, "USE_DEFAULTS", "everything, the memory is erased");
    row("active profile", CommandId::ReadParams3, "FF", false, "READ_PARAMS_3", "the active profile");
}

void TestInspect::framesInWords()
{
    QFETCH(int, id);
    QFETCH(QByteArray, payload);
    QFETCH(bool, fromBoard);
    QFETCH(QString, name);
    QFETCH(QString, part);
    const FrameText words = text(static_cast<CommandId>(id), payload, fromBoard);
    QCOMPARE(words.name, name);
    QVERIFY2(words.fields.contains(part), qPrintable(words.fields));
}

void TestInspect::everyFrameSurvivesAnyPayload()
{
    for (int id = 0; id < 256; ++id) {
        for (int size = 0; size < 256; size += size < 24 ? 1 : 31) {
            for (const char fill : {'\0', '\x7F', '\xFF'}) {
                const QByteArray payload(size, fill);
                QVERIFY(!text(static_cast<CommandId>(id), payload, true).name.isEmpty());
                QVERIFY(!text(static_cast<CommandId>(id), payload, false).name.isEmpty());
            }
        }
    }
}

void TestInspect::parameterBlocksNameTheirValues()
{
    VirtualBoard board{SimulatorOptions()};
    QVERIFY(board.identify());
    const auto bytes = board.device.readBlock(board.channel, {1, Params3});
    QVERIFY(bytes);
    const FrameText words
        = board.device.describeFrame({number(CommandId::ReadParams3), asBytes(*bytes), 1}, true);
    QVERIFY2(words.fields.startsWith(u"profile 2, "_s), qPrintable(words.fields));
    QVERIFY(words.fields.contains(u"pid.roll.p "_s));
    QVERIFY(!words.fields.contains(u"state."_s));
}

void TestInspect::laterRealtimeIsToldInWords()
{
    QByteArray payload(124, '\0');
    QVERIFY(!text(CommandId::RealtimeData4, payload, true).fields.contains(u"calibration"_s));
    payload.replace(88, 18, QByteArray::fromHex("E803 0CFE 0000 0C 02 8E03 0000 72FC 11200000"));
    const QString words = text(CommandId::RealtimeData4, payload, true).fields;
    const QString end = u"output.roll 10.00%, output.pitch -5.00%, output.yaw 0.00%, calibration 12 "
                        "(magnetometer), can.error 2, actual.roll 20.00°, actual.pitch 0.00°, "
                        "actual.yaw -20.00°, state.debug, state.started, state.tripod"_s;
    QVERIFY2(words.endsWith(end), qPrintable(words));
}

void TestInspect::progressHasTheScaleOfTheFirmware_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<QString>("gains");
    QTest::newRow("as they are") << 2730 << u"R: P 30 I 0.30 D 30"_s;
    QTest::newRow("logarithmic") << 2731 << u"R: P 3.0 I 3.0 D 3.0"_s;  // errata 3.3
}

void TestInspect::progressHasTheScaleOfTheFirmware()
{
    QFETCH(int, firmware);
    QFETCH(QString, gains);
    SimulatorOptions options;
    options.firmware = firmware;
    VirtualBoard board{options};
    QVERIFY(board.identify());
    QByteArray payload(57, '\0');
    for (const int offset : {0, 3, 6})
        payload[offset] = 30;
    const FrameText words
        = board.device.describeFrame({number(CommandId::AutoPid), asBytes(payload), 1}, true);
    QVERIFY2(words.fields.contains(gains), qPrintable(words.fields));
}

void TestInspect::commandsByNameAndHex_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QByteArray>("bytes");  // empty = refused
    QTest::addColumn<QString>("nameOrReason");
    QTest::addColumn<int>("risk");
    const auto good = [](const char *typed, const char *bytes, const char *name, ActionRisk risk) {
        QTest::newRow(typed) << QString::fromLatin1(typed) << QByteArray::fromHex(bytes)
                             << QString::fromLatin1(name) << int(risk);
    };
    const auto bad = [](const char *typed, const char *reason) {
        QTest::newRow(typed) << QString::fromLatin1(typed) << QByteArray() << QString::fromLatin1(reason)
                             << 0;
    };
    good("board_info", "3E56005600", "BOARD_INFO", ActionRisk::Safe);
    good("READ_PARAMS_3 FF", "3E150116FFFF", "READ_PARAMS_3",
         ActionRisk::Safe);  // errata, example "active profile"
    good("  execute_menu 0b ", "3E4501460B0B", "EXECUTE_MENU", ActionRisk::Moves);
    good("3E 56 00 56 00", "3E56005600", "BOARD_INFO", ActionRisk::Safe);
    good("MOTORS_OFF", "3E6D006D00", "MOTORS_OFF", ActionRisk::Safe);
    good("USE_DEFAULTS 00", "3E4601470000", "USE_DEFAULTS", ActionRisk::Destroys);
    good("control 00", "3E4301440000", "CONTROL", ActionRisk::Moves);
    bad("", "nothing");
    bad("3E 56 00 57 00", "checksum");
    bad("3E 56 00 56 00 3E", "checksum");
    bad("FORMAT_DISK", "FORMAT_DISK");
    bad("BOARD_INFO 0", "hex");
    bad("BOARD_INFO xyz", "hex");
}

void TestInspect::commandsByNameAndHex()
{
    QFETCH(QString, typed);
    QFETCH(QByteArray, bytes);
    QFETCH(QString, nameOrReason);
    QFETCH(int, risk);
    const auto command = parseCommand(typed, 1);
    if (bytes.isEmpty()) {
        QVERIFY(!command);
        QCOMPARE(command.error().code, ErrorCode::InvalidArgument);
        QVERIFY2(command.error().detail.contains(nameOrReason), qPrintable(command.error().detail));
        return;
    }
    QVERIFY2(command, qPrintable(command ? QString() : command.error().detail));
    QCOMPARE(command->bytes, bytes);
    QCOMPARE(command->name, nameOrReason);
    QCOMPARE(int(command->risk), risk);
    // Every command that can be named can be sent.
    for (const QString &name : commandNames())
        QVERIFY2(parseCommand(name, 1), qPrintable(name));
}

void TestInspect::variablesGrowWithTheFirmware()
{
    // Errata 5: 48 in the document, 50 before 2.68b7, then more with each release.
    QCOMPARE(adjustablesOf(2590).size(), 48U);
    QCOMPARE(adjustablesOf(2600).size(), 50U);
    QCOMPARE(adjustablesOf(2687).size(), 51U);
    QCOMPARE(adjustablesOf(2688).size(), 57U);
    QCOMPARE(adjustablesOf(2720).size(), 76U);
    QCOMPARE(adjustablesOf(2738).size(), 102U);
    // What a parameter calls its variable is what the table calls it: same axis, and its default fits.
    VirtualBoard board{SimulatorOptions()};
    QVERIFY(board.identify());
    int linked = 0;
    for (const ParameterSpec &spec : board.device.parameters()->all()) {
        if (spec.adjustable < 0)
            continue;
        const AdjustableSpec &variable = board.device.adjustables()[std::size_t(spec.adjustable)];
        QVERIFY2(variable.axis == Axis::None || spec.axis == Axis::None || variable.axis == spec.axis,
                 qPrintable(spec.key));
        QVERIFY2(spec.defaultRaw * spec.row->adjustableScale >= variable.min
                     && spec.defaultRaw * spec.row->adjustableScale <= variable.max,
                 qPrintable(spec.key));
        ++linked;
    }
    QVERIFY(linked > 30);
}

void TestInspect::variablesHaveTheRangesOfTheirFirmware_data()
{
    QTest::addColumn<int>("id");
    QTest::addColumn<int>("most");
    QTest::addColumn<int>("mostLater");
    // Errata 5 and 6.
    for (const int id : {16, 17, 18})
        QTest::addRow("follow low-pass %d", id) << id << 15 << 15;
    for (const int id : {22, 23, 24})
        QTest::addRow("RC low-pass %d", id) << id << 15 << 255;
    QTest::newRow("follow mode, then follow pitch") << 30 << 2 << 1;
    QTest::newRow("follow yaw, then yaw and pitch") << 31 << 1 << 2;
    for (const int id : {39, 40, 41})
        QTest::addRow("acceleration %d", id) << id << 1275 << 10000;
}

void TestInspect::variablesHaveTheRangesOfTheirFirmware()
{
    QFETCH(int, id);
    QFETCH(int, most);
    QFETCH(int, mostLater);
    for (const auto &[firmware, max] : {std::pair(2590, most), {2610, mostLater}}) {
        const AdjustableSpec &variable = adjustablesOf(firmware)[std::size_t(id)];
        QCOMPARE(variable.id, id);
        QCOMPARE(int(variable.max), max);
    }
}

// -32768 is no signal (errata 3.23), not -200 %.
void TestInspect::signalThatIsNotThereIsAGap()
{
    const QByteArray payload = QByteArray::fromHex("0000 0080 0040 00C0") + QByteArray(8, '\0');
    const std::vector<WireField> fields = customLayout(1U << 5);
    QCOMPARE(fields.size(), std::size_t(6));
    QVERIFY(std::isnan(readField(fields[0], asBytes(payload))));
    QCOMPARE(readField(fields[1], asBytes(payload)), 100.0F);
    QCOMPARE(readField(fields[2], asBytes(payload)), -100.0F);
}

void TestInspect::debugVariablesInParts()
{
    for (const int firmware : {2590, 2734}) {
        SimulatorOptions options;
        options.firmware = firmware;
        VirtualBoard board(options);
        QVERIFY(board.identify());
        const auto variables = board.device.debugVariables(board.channel);
        QVERIFY(variables);
        const auto values = board.device.readDebugVariables(board.channel);
        QVERIFY(values);
        QCOMPARE(values->size(), variables->size());
        for (std::size_t i = 0; i < values->size(); ++i)
            QCOMPARE(int((*values)[i].size()), (*variables)[i].elements);
    }
}

void TestInspect::sixPositionsFindZeroAndScale()
{
    VirtualBoard bench{SimulatorOptions()};
    QVERIFY(bench.identify());
    simplebgc::SimulatedBoard &simulated = bench.board();
    double worst = 0;
    for (int pose = 1; pose <= 6; ++pose) {
        QVERIFY(bench.port.change(u"pose=%1"_s.arg(pose)));
        const auto done = bench.device.perform(bench.channel, u"calibrate.acc"_s,
                                               {{u"imu"_s, 0}, {u"action"_s, 1}, {u"six"_s, true}});
        QVERIFY2(done, qPrintable(done ? QString() : done.error().detail));
        if (pose == 6)
            worst = done->value(u"acc.error.after"_s).toDouble();
    }
    const SimulatedImu &imu = simulated.stabilizer().imu();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        QVERIFY(std::abs(imu.accCorrection[axis] - imu.accError[axis]) < 0.002);
        QVERIFY(std::abs(imu.accScale[axis] - imu.accScaleError[axis]) < 0.002);
    }
    QVERIFY2(worst < 0.012, qPrintable(QString::number(worst)));
    // In the gimbal again, the horizon is straight.
    QVERIFY(bench.port.change(u"pose=0"_s));
    QVERIFY(!bench.port.change(u"pose=8"_s));
    QVERIFY(!bench.port.change(u"weather=1"_s));
}

void TestInspect::aShakenSensorIsNotCalibrated()
{
    SimulatorOptions options;
    options.faults.shake = 8;
    VirtualBoard bench(options);
    QVERIFY(bench.identify());
    simplebgc::SimulatedBoard &simulated = bench.board();
    const auto before = simulated.stabilizer().imu().gyroCorrection;
    const auto done
        = bench.device.perform(bench.channel, u"calibrate.gyro"_s, {{u"imu"_s, 0}, {u"action"_s, 1}});
    if (done)
        QVERIFY(done->value(u"gyro.bias.after"_s).toDouble() > 0.5);
    QCOMPARE(simulated.stabilizer().imu().gyroCorrection, before);
}

void TestInspect::liveValuesAreTakenOutOfReads()
{
    VirtualBoard bench{SimulatorOptions()};
    QVERIFY(bench.identify());
    const auto stored = bench.device.readConfiguration(bench.channel);
    QVERIFY(stored);
    const ParameterSpec &p = *stored->parameters().find(u"pid.roll.p"_s);
    const double before = *stored->raw(p, 0);
    QVERIFY(bench.device.writeAdjustables(bench.channel, {{0, double(before + 20)}}));
    const auto read = bench.device.readConfiguration(bench.channel);
    // The board answers for its active profile out of volatile memory.
    QCOMPARE(*read->raw(p, 0), before + 20);
    QCOMPARE(*withoutLive(*read, {{p.key, before, before + 20}}).raw(p, 0), before);
    // Somebody else's value is left alone.
    QCOMPARE(*withoutLive(*read, {{p.key, before, before + 21}}).raw(p, 0), before + 20);
    QCOMPARE(
        withoutLive(read->block({0, Params3}), Params3, read->parameters(), {{p.key, before, before + 20}}),
        stored->block({0, Params3}));
}

void TestInspect::logKeepsTheNewest()
{
    FrameLog log(3);
    for (int id = 1; id <= 5; ++id) {
        const QByteArray payload(1, char(id));
        log.frameReceived({id, asBytes(payload), 1}, Clock::now(), id % 2);
    }
    log.bytesSent("abc", Clock::now());
    QCOMPARE(log.newest(), 6U);
    auto kept = log.after(0);
    QCOMPARE(kept.size(), 3U);
    QCOMPARE(kept.front().number, 4U);
    QCOMPARE(kept.back().bytes, QByteArray("abc"));
    QVERIFY(!kept.back().fromBoard);
    QCOMPARE(log.after(5).size(), 1U);
    QVERIFY(log.after(6).empty());
    QVERIFY(log.after(99).empty());
}

void TestInspect::csvMergesStreams()
{
    static constexpr ChannelSpec table[]
        = {{"a", "A", "", "°", 2, Axis::None, 0, 0}, {"b", "B", "", "", 2, Axis::None, 0, 0}};
    TelemetryStore store(2);
    const auto fast = store.defineGroup({0}, 0.1);
    const auto slow = store.defineGroup({1}, 0.2);
    const TimePoint start = store.origin();
    for (int i = 0; i < 4; ++i) {
        const float value = i == 2 ? std::nanf("") : float(i);
        store.append(*fast, start + durationFromSeconds(0.1 * i), std::array{value});
    }
    store.append(*slow, start + durationFromSeconds(0.15), std::array{7.5F});
    QBuffer buffer;
    QVERIFY(buffer.open(QIODevice::WriteOnly));
    const auto lines = writeTelemetryCsv(buffer, store, table, {0, 1}, 0.05, 10);
    QVERIFY(lines);
    QCOMPARE(*lines, 4);
    QCOMPARE(buffer.data(),
             QByteArray("time_s,a [°],b\n0.100000,1,\n0.150000,,7.5\n0.200000,,\n0.300000,3,\n"));
}

QTEST_GUILESS_MAIN(TestInspect)
#include "tst_inspect.moc"
