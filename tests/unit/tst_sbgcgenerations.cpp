// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Each firmware answers as its generation does (errata 3): the payloads are worked out from there.
#include "tests/support/sbgcrig.h"

using namespace Qt::StringLiterals;
using simplebgc::CommandId;

namespace {

constexpr double kAnswered = 0.05;  // seconds

// What the board says to a command: "67 4d" is a CONFIRM of 77.
QStringList answers(simplebgc::SimulatedBoard &board, CommandId command, const char *payload,
                    double seconds = kAnswered)
{
    const QByteArray bytes = simplebgc::encodeFrame(int(command), hex(payload));
    board.takeOutput(100000);
    board.receive(asBytes(bytes));
    for (const double until = board.now() + seconds; board.now() < until;)
        board.cycle();
    QStringList all;
    simplebgc::Framer framer;
    const QByteArray told = board.takeOutput(100000);
    framer.feed(asBytes(told), [&all](const FrameView &frame) {
        all.append(u"%1 %2"_s.arg(frame.id).arg(QLatin1String(toByteArray(frame.payload).toHex())));
    });
    return all;
}

QString refused(CommandId command, int code)
{
    const QByteArray payload = ByteWriter().u8(int(command)).u8(code).zeros(4).take();
    return u"255 "_s + QLatin1String(payload.toHex());
}

}  // namespace

class TestSbgcGenerations : public QObject
{
    Q_OBJECT
private slots:
    void commandsAreTakenAsTheFirmwareKnowsThem_data();
    void commandsAreTakenAsTheFirmwareKnowsThem();
    void blocksComeBackAsWritten();
    void aSetOfWritesIsOneChange();
    void onlyListedVariablesAreSaved();
    void theEndOfAMenuCommandIsTold();
    void activeProfileGetsDefaults();
    void masksChooseVariables();
    void inputsAreTold();
    void frameAnglesNeedASensor();
    void firstBoardsAreReadAndWritten();
    void whoKnowsMoreIsNoFirstBoard();
};

void TestSbgcGenerations::commandsAreTakenAsTheFirmwareKnowsThem_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<int>("command");
    QTest::addColumn<QByteArray>("payload");
    QTest::addColumn<QStringList>("said");
    const auto row = [](const char *name, int firmware, CommandId command, const char *payload,
                        const QStringList &said) {
        QTest::addRow("%s", name) << firmware << int(command) << QByteArray(payload) << said;
    };
    row("follow offset", 2590, CommandId::CalibOffset, "", {u"67 4f"_s});
    row("start", 2590, CommandId::MotorsOn, "", {u"67 4d"_s});
    // A byte too many is taken by whoever knows no payload (errata 1.4).
    row("stop", 2590, CommandId::MotorsOff, "", {u"67 6d"_s});
    row("stop and a byte", 2590, CommandId::MotorsOff, "09", {u"67 6d"_s});
    row("stop and two bytes, of old", 2590, CommandId::MotorsOff, "0200", {});
    row("safe stop too early", 2686, CommandId::MotorsOff, "0200", {refused(CommandId::MotorsOff, 1)});
    row("safe stop", 2687, CommandId::MotorsOff, "02", {u"67 6d"_s});
    row("no such stop", 2687, CommandId::MotorsOff, "03", {refused(CommandId::MotorsOff, 2)});
    row("stop, too long", 2687, CommandId::MotorsOff, "0200", {refused(CommandId::MotorsOff, 1)});
    row("set of writes, unknown", 2590, CommandId::WriteParamsSet, "01", {});
    row("set of writes, too early", 2703, CommandId::WriteParamsSet, "01",
        {refused(CommandId::WriteParamsSet, 6)});
    row("set of writes", 2704, CommandId::WriteParamsSet, "01", {u"67 77"_s});
    row("set of writes, neither begin nor end", 2704, CommandId::WriteParamsSet, "02",
        {refused(CommandId::WriteParamsSet, 2)});
    row("menu", 2590, CommandId::ExecuteMenu, "00", {u"67 45"_s});
    row("menu with flags, of old", 2590, CommandId::ExecuteMenu, "0001", {});
    row("menu with flags, too early", 2737, CommandId::ExecuteMenu, "0001",
        {refused(CommandId::ExecuteMenu, 1)});
    row("menu, confirmed", 2738, CommandId::ExecuteMenu, "0001", {u"67 45"_s});
    row("menu, not confirmed", 2738, CommandId::ExecuteMenu, "0000", {});
    row("menu, its end confirmed", 2738, CommandId::ExecuteMenu, "0002", {u"67 45"_s});
    row("menu, both", 2738, CommandId::ExecuteMenu, "0003", {u"67 45"_s, u"67 45"_s});
    row("defaults of the active profile, too early", 2590, CommandId::UseDefaults, "FE",
        {refused(CommandId::UseDefaults, 2)});
    row("defaults of no profile", 2660, CommandId::UseDefaults, "05", {refused(CommandId::UseDefaults, 2)});
    row("defaults of the active profile", 2660, CommandId::UseDefaults, "FE", {u"67 46"_s, u"114 "_s});
    row("defaults of all", 2660, CommandId::UseDefaults, "FF", {u"67 46"_s, u"114 "_s});
    row("save", 2688, CommandId::SaveParams3, "", {u"67 20"_s});
    row("save a list, too early", 2688, CommandId::SaveParams3, "0003", {refused(CommandId::SaveParams3, 1)});
    row("save a list", 2689, CommandId::SaveParams3, "0003", {u"67 20"_s});
    row("save what is no variable", 2689, CommandId::SaveParams3, "00C8",
        {refused(CommandId::SaveParams3, 2)});
    row("variables from an index, too early", 2719, CommandId::DebugVarsInfo3, "0801",
        {refused(CommandId::DebugVarsInfo3, 1)});
    row("variables from an index", 2720, CommandId::DebugVarsInfo3, "09",
        {u"253 0a08"_s + QLatin1String(QByteArray("SERVO_US").toHex()) + u"040400"_s});
}

void TestSbgcGenerations::commandsAreTakenAsTheFirmwareKnowsThem()
{
    QFETCH(int, firmware);
    QFETCH(int, command);
    QFETCH(QByteArray, payload);
    QFETCH(QStringList, said);
    simplebgc::SimulatedBoard board(withFirmware(firmware));
    QCOMPARE(answers(board, static_cast<CommandId>(command), payload.constData()), said);
}

void TestSbgcGenerations::blocksComeBackAsWritten()
{
    simplebgc::SimulatedBoard board(withFirmware(2704));
    const auto payload = [&board](CommandId read, const char *asked) {
        return hex(answers(board, read, asked).value(0).section(u' ', 1).toLatin1().constData());
    };
    constexpr std::array kBlocks{std::tuple(CommandId::ReadParams3, CommandId::WriteParams3, 134),
                                 std::tuple(CommandId::ReadParamsExt, CommandId::WriteParamsExt, 104),
                                 std::tuple(CommandId::ReadParamsExt2, CommandId::WriteParamsExt2, 151),
                                 std::tuple(CommandId::ReadParamsExt3, CommandId::WriteParamsExt3, 221)};
    for (const auto &[read, write, size] : kBlocks) {
        QByteArray block = payload(read, "02");
        QCOMPARE(int(block.size()), size);
        QCOMPARE(block[0], char(2));
        block[1] = char(block[1] ^ 1);
        const QString confirmed = u"67 "_s + QLatin1String(QByteArray(1, char(write)).toHex());
        QCOMPARE(answers(board, write, block.toHex().constData(), 0.1), QStringList{confirmed});
        QCOMPARE(payload(read, "02").left(130), block.left(130));  // behind them it tells what is in use
        QVERIFY(payload(read, "01").left(130) != block.left(130));
    }
    // The slots belong to the board, whose profile stays.
    QByteArray config = payload(CommandId::ReadAdjVarsCfg, "");
    QCOMPARE(config.size(), 128);
    config[1] = char(config[1] ^ 1);
    QCOMPARE(answers(board, CommandId::WriteAdjVarsCfg, config.toHex().constData(), 0.1),
             QStringList{u"67 2c"_s});
    QCOMPARE(payload(CommandId::ReadAdjVarsCfg, ""), config);
    QCOMPARE(board.activeProfile(), 2);
}

// Until its end the board uses what it used before; without an end it takes a restart.
void TestSbgcGenerations::aSetOfWritesIsOneChange()
{
    simplebgc::SimulatedBoard board(withFirmware(2704));
    const int before = board.inUse(u"pid.roll.p"_s);
    const auto write = [&board](int value) {
        QByteArray block = hex(
            answers(board, CommandId::ReadParams3, "00").value(0).section(u' ', 1).toLatin1().constData());
        block[1] = char(value);  // P of roll (errata 3.4)
        return answers(board, CommandId::WriteParams3, block.toHex().constData(), 0.1);
    };
    QCOMPARE(answers(board, CommandId::WriteParamsSet, "01"), QStringList{u"67 77"_s});
    QCOMPARE(write(before + 1), QStringList{u"67 16"_s});
    QCOMPARE(board.inUse(u"pid.roll.p"_s), before);
    QCOMPARE(board.stored(u"pid.roll.p"_s, 0), before + 1);
    QCOMPARE(answers(board, CommandId::WriteParamsSet, "00"), QStringList{u"67 77"_s});
    QCOMPARE(board.inUse(u"pid.roll.p"_s), before + 1);
    QCOMPARE(write(before + 2), QStringList{u"67 16"_s});  // outside of a set at once
    QCOMPARE(board.inUse(u"pid.roll.p"_s), before + 2);
    answers(board, CommandId::WriteParamsSet, "01");
    write(before + 3);
    answers(board, CommandId::Reset, "", 3);
    QCOMPARE(board.inUse(u"pid.roll.p"_s), before + 3);
}

void TestSbgcGenerations::onlyListedVariablesAreSaved()
{
    simplebgc::SimulatedBoard board(withFirmware(2689));
    const int p = board.stored(u"pid.roll.p"_s, 0);
    const int d = board.stored(u"pid.roll.d"_s, 0);
    // Variables 0 and 6 are P and D of roll (errata 5).
    QCOMPARE(answers(board, CommandId::SetAdjVarsVal, "02 00 63000000 06 62000000"), QStringList{u"67 1f"_s});
    QCOMPARE(answers(board, CommandId::SaveParams3, "00"), QStringList{u"67 20"_s});
    QCOMPARE(board.stored(u"pid.roll.p"_s, 0), 0x63);
    QCOMPARE(board.stored(u"pid.roll.d"_s, 0), d);
    QCOMPARE(answers(board, CommandId::SaveParams3, "00C8"), QStringList{refused(CommandId::SaveParams3, 2)});
    QVERIFY(p != 0x63);
    QCOMPARE(answers(board, CommandId::SaveParams3, ""), QStringList{u"67 20"_s});
    QCOMPARE(board.stored(u"pid.roll.d"_s, 0), 0x62);
}

void TestSbgcGenerations::theEndOfAMenuCommandIsTold()
{
    simplebgc::SimulatedBoard board(withFirmware(2738));
    QCOMPARE(answers(board, CommandId::ExecuteMenu, "0903", 1),
             QStringList{u"67 45"_s});  // calibrate the gyroscope
    QVERIFY(board.isCalibrating());
    const QStringList end = answers(board, CommandId::ExecuteMenu, "0001", 5);  // meanwhile it answers
    QCOMPARE(end.count(u"67 45"_s), 2);
    QVERIFY(end.contains(u"67 67"_s));
    QVERIFY(!board.isCalibrating());
}

void TestSbgcGenerations::activeProfileGetsDefaults()
{
    simplebgc::SimulatedBoard board(withFirmware(2660));
    const int first = board.stored(u"pid.roll.p"_s, 0);
    answers(board, CommandId::ExecuteMenu, "02");  // profile 2
    board.store(u"pid.roll.p"_s, 0, 99);
    QVERIFY(board.stored(u"pid.roll.p"_s, 1) != first);
    answers(board, CommandId::UseDefaults, "FE", 4);
    QCOMPARE(board.stored(u"pid.roll.p"_s, 1), first);
    QCOMPARE(board.stored(u"pid.roll.p"_s, 0), 99);
    answers(board, CommandId::UseDefaults, "FF", 4);
    QCOMPARE(board.stored(u"pid.roll.p"_s, 0), first);
}

void TestSbgcGenerations::masksChooseVariables()
{
    simplebgc::SimulatedBoard older(withFirmware(2719));
    QCOMPARE(answers(older, CommandId::DebugVars3, "40000000"),
             QStringList{refused(CommandId::DebugVars3, 1)});
    const QString all = answers(older, CommandId::DebugVars3, "").value(0);
    QCOMPARE(all.section(u' ', 1).size() / 2, 3 * 2 + 3 * 4 + 1 + 1 + 2 + 4 + 4 + 4 * 2);
    simplebgc::SimulatedBoard board(withFirmware(2720));
    // Variable 6 is a u16 that says how long a cycle takes: 800 microseconds.
    QCOMPARE(answers(board, CommandId::DebugVars3, "40000000"), QStringList{u"254 400000002003"_s});
    QCOMPARE(answers(board, CommandId::DebugVars3, "4000000000000000"),
             QStringList{u"254 40000000000000002003"_s});
    QCOMPARE(answers(board, CommandId::DebugVars3, "").value(0).size(), all.size());
}

// Roll, pitch, yaw and command, then the flight controller's two; 0x8000 is no signal (errata 3.9).
void TestSbgcGenerations::inputsAreTold()
{
    simplebgc::SimulatedBoard board(withFirmware(2590));
    const auto inputs = [&board] {
        return answers(board, CommandId::RealtimeDataCustom, "20000000 000000000000")
            .value(0)
            .section(u' ', 1)
            .mid(4);
    };
    QCOMPARE(inputs(), u"0080"_s.repeated(6));
    board.store(u"rc.map.pitch"_s, 0, 129);  // virtual channel 1
    board.store(u"rc.map.cmd"_s, 0, 130);
    answers(board, CommandId::ApiVirtChControl, "FA00 0CFE");  // 250 and -500 of 500
    QCOMPARE(inputs(), u"0080 0020 0080 00c0 0080 0080"_s.remove(u' '));
    QCOMPARE(answers(board, CommandId::RealtimeDataCustom, "80000000 000000000000")
                 .value(0)
                 .section(u' ', 1)
                 .mid(4),
             u"0080"_s.repeated(18));
}

void TestSbgcGenerations::frameAnglesNeedASensor()
{
    // Bytes 38 to 43 of REALTIME_DATA_3 (errata 3.8); a hand sways the frame.
    const auto angles = [](int isFitted, int position) {
        SimulatorOptions options = withFirmware(2704);
        options.own.insert(u"frame-imu"_s, isFitted);
        simplebgc::SimulatedBoard board(options);
        if (position >= 0)
            board.store(u"imu.frame.position"_s, 0, position);
        return answers(board, CommandId::RealtimeData3, "", 2).value(0).section(u' ', 1).mid(76, 12);
    };
    QVERIFY(angles(1, -1) != u"000000000000"_s);
    QCOMPARE(angles(1, 0), u"000000000000"_s);
    QCOMPARE(angles(0, -1), u"000000000000"_s);
    QCOMPARE(angles(0, 2), u"000000000000"_s);
}

// They know READ_PARAMS, WRITE_PARAMS and REALTIME_DATA, and nothing with a "3".
void TestSbgcGenerations::firstBoardsAreReadAndWritten()
{
    SimulatorOptions options = withFirmware(2400);
    options.own.insert(u"legacy"_s, 1);
    SbgcRig rig(options);
    QCOMPARE(answers(rig.board(), CommandId::ReadParams3, "00"), QStringList());
    QCOMPARE(answers(rig.board(), CommandId::ReadParams, "01").value(0).left(5), u"82 01"_s);
    QCOMPARE(answers(rig.board(), CommandId::RealtimeData, "").value(0).left(3), u"23 "_s);

    const QString block = answers(rig.board(), CommandId::ReadParams, "01").value(0).section(u' ', 1);
    QCOMPARE(answers(rig.board(), CommandId::WriteParams, block.toLatin1().constData(), 0.1),
             QStringList{u"67 57"_s});

    auto read = rig.device.readConfiguration(rig.channel);
    QVERIFY2(read, read ? "" : qPrintable(read.error().detail));
    QVERIFY(read->missing().empty());
    QVERIFY(read->block({4, simplebgc::Params3}).size() == 134);
    QVERIFY(read->block({0, simplebgc::ParamsExt}).isEmpty());
    QVERIFY(rig.device.adjustables().empty());
    QCOMPARE(rig.device.activeProfile(rig.channel).value_or(-1), 1);  // the one that was written
    QCOMPARE(rig.device.areMotorsOn(rig.channel).value_or(false), true);

    const int before = rig.board().stored(u"pid.roll.p"_s, 2);
    Configuration wanted = *read;
    QVERIFY(wanted.setRaw(*wanted.parameters().find(u"pid.roll.p"_s), 2, before + 5));
    QVERIFY(
        rig.device.writeBlock(rig.channel, {2, simplebgc::Params3}, wanted.block({2, simplebgc::Params3})));
    QCOMPARE(rig.board().stored(u"pid.roll.p"_s, 2), before + 5);
    const auto back = rig.device.readBlock(rig.channel, {2, simplebgc::Params3});
    QVERIFY(back && back->at(1) == char(before + 5));

    const auto plan = rig.device.subscribe(rig.channel, {}, {});
    QVERIFY(plan && plan->poll);
    QVERIFY(plan->poll->bytes.startsWith(hex("3E4400")));  // REALTIME_DATA
    const auto stop = rig.device.stopPlan();
    QVERIFY(stop.means.front().requests.at(1).bytes.startsWith(hex("3E4400")));
}

// Silence on BOARD_INFO_3 alone proves nothing.
void TestSbgcGenerations::whoKnowsMoreIsNoFirstBoard()
{
    SimulatorOptions options = withFirmware(2590);
    options.faults.deaf = 20;
    SbgcRig rig(options);
    QVERIFY(rig.device.statusRequest().bytes.startsWith(hex("3E1700")));
    const auto read = rig.device.readConfiguration(rig.channel);
    QVERIFY(read && read->block({0, simplebgc::ParamsExt}).size() == 104);
}

QTEST_GUILESS_MAIN(TestSbgcGenerations)
#include "tst_sbgcgenerations.moc"
