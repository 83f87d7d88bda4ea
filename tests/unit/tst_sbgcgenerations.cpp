// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Each firmware answers as its generation does (errata 3): the payloads are worked out from there.
#include "tests/support/sbgcrig.h"

using namespace Qt::StringLiterals;
using simplebgc::CommandId;

namespace {

constexpr double kAnswered = 0.05;  // seconds

// What the board says to a command: "67 4d" is a CONFIRM of 77.
QStringList answers(simplebgc::SimulatedBoard &board, int command, const char *payload,
                    double seconds = kAnswered)
{
    const QByteArray bytes = simplebgc::encodeFrame(command, hex(payload));
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

QString refused(int command, int code)
{
    const QByteArray payload = ByteWriter().u8(command).u8(code).zeros(4).take();
    return u"255 "_s + QLatin1String(payload.toHex());
}

}  // namespace

class TestSbgcGenerations : public QObject
{
    Q_OBJECT
private slots:
    void commandsAreTakenAsTheFirmwareKnowsThem_data();
    void commandsAreTakenAsTheFirmwareKnowsThem();
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
    const auto row
        = [](const char *name, int firmware, int command, const char *payload, const QStringList &said) {
              QTest::addRow("%s", name) << firmware << command << QByteArray(payload) << said;
          };
    // A byte too many is taken by whoever knows no payload (errata 1.4).
    row("stop", 2590, 109, "", {u"67 6d"_s});
    row("stop and a byte", 2590, 109, "09", {u"67 6d"_s});
    row("stop and two bytes, of old", 2590, 109, "0200", {});
    row("safe stop too early", 2686, 109, "0200", {refused(109, 1)});
    row("safe stop", 2687, 109, "02", {u"67 6d"_s});
    row("no such stop", 2687, 109, "03", {refused(109, 2)});
    row("stop, too long", 2687, 109, "0200", {refused(109, 1)});
    row("set of writes, unknown", 2590, 119, "01", {});
    row("set of writes, too early", 2703, 119, "01", {refused(119, 6)});
    row("set of writes", 2704, 119, "01", {u"67 77"_s});
    row("set of writes, neither begin nor end", 2704, 119, "02", {refused(119, 2)});
    row("menu", 2590, 69, "00", {u"67 45"_s});
    row("menu with flags, of old", 2590, 69, "0001", {});
    row("menu with flags, too early", 2737, 69, "0001", {refused(69, 1)});
    row("menu, confirmed", 2738, 69, "0001", {u"67 45"_s});
    row("menu, not confirmed", 2738, 69, "0000", {});
    row("menu, its end confirmed", 2738, 69, "0002", {u"67 45"_s});
    row("menu, both", 2738, 69, "0003", {u"67 45"_s, u"67 45"_s});
    row("defaults of the active profile, too early", 2590, 70, "FE", {refused(70, 2)});
    row("defaults of no profile", 2660, 70, "05", {refused(70, 2)});
    row("defaults of the active profile", 2660, 70, "FE", {u"67 46"_s, u"114 "_s});
    row("defaults of all", 2660, 70, "FF", {u"67 46"_s, u"114 "_s});
    row("save", 2688, 32, "", {u"67 20"_s});
    row("save a list, too early", 2688, 32, "0003", {refused(32, 1)});
    row("save a list", 2689, 32, "0003", {u"67 20"_s});
    row("save what is no variable", 2689, 32, "00C8", {refused(32, 2)});
    row("variables from an index, too early", 2719, 253, "0801", {refused(253, 1)});
    row("variables from an index", 2720, 253, "08",
        {u"253 090d"_s + QLatin1String(QByteArray("YAW_UNWRAPPED").toHex()) + u"360100"_s});
}

void TestSbgcGenerations::commandsAreTakenAsTheFirmwareKnowsThem()
{
    QFETCH(int, firmware);
    QFETCH(int, command);
    QFETCH(QByteArray, payload);
    QFETCH(QStringList, said);
    simplebgc::SimulatedBoard board(withFirmware(firmware));
    QCOMPARE(answers(board, command, payload.constData()), said);
}

// Until its end the board uses what it used before; without an end it takes a restart.
void TestSbgcGenerations::aSetOfWritesIsOneChange()
{
    simplebgc::SimulatedBoard board(withFirmware(2704));
    const int before = board.inUse(u"pid.roll.p"_s);
    const auto write = [&board](int value) {
        QByteArray block = hex(answers(board, 21, "00").value(0).section(u' ', 1).toLatin1().constData());
        block[1] = char(value);  // P of roll (errata 3.4)
        return answers(board, 22, block.toHex().constData(), 0.1);
    };
    QCOMPARE(answers(board, 119, "01"), QStringList{u"67 77"_s});
    QCOMPARE(write(before + 1), QStringList{u"67 16"_s});
    QCOMPARE(board.inUse(u"pid.roll.p"_s), before);
    QCOMPARE(board.stored(u"pid.roll.p"_s, 0), before + 1);
    QCOMPARE(answers(board, 119, "00"), QStringList{u"67 77"_s});
    QCOMPARE(board.inUse(u"pid.roll.p"_s), before + 1);
    QCOMPARE(write(before + 2), QStringList{u"67 16"_s});  // outside of a set at once
    QCOMPARE(board.inUse(u"pid.roll.p"_s), before + 2);
    answers(board, 119, "01");
    write(before + 3);
    answers(board, 114, "", 3);
    QCOMPARE(board.inUse(u"pid.roll.p"_s), before + 3);
}

void TestSbgcGenerations::onlyListedVariablesAreSaved()
{
    simplebgc::SimulatedBoard board(withFirmware(2689));
    const int p = board.stored(u"pid.roll.p"_s, 0);
    const int d = board.stored(u"pid.roll.d"_s, 0);
    // Variables 0 and 6 are P and D of roll (errata 5).
    QCOMPARE(answers(board, 31, "02 00 63000000 06 62000000"), QStringList{u"67 1f"_s});
    QCOMPARE(answers(board, 32, "00"), QStringList{u"67 20"_s});
    QCOMPARE(board.stored(u"pid.roll.p"_s, 0), 0x63);
    QCOMPARE(board.stored(u"pid.roll.d"_s, 0), d);
    QCOMPARE(answers(board, 32, "00C8"), QStringList{refused(32, 2)});
    QVERIFY(p != 0x63);
    QCOMPARE(answers(board, 32, ""), QStringList{u"67 20"_s});
    QCOMPARE(board.stored(u"pid.roll.d"_s, 0), 0x62);
}

void TestSbgcGenerations::theEndOfAMenuCommandIsTold()
{
    simplebgc::SimulatedBoard board(withFirmware(2738));
    QCOMPARE(answers(board, 69, "0903", 1), QStringList{u"67 45"_s});  // calibrate the gyroscope
    QVERIFY(board.isCalibrating());
    const QStringList end = answers(board, 69, "0001", 5);  // meanwhile it answers
    QCOMPARE(end.count(u"67 45"_s), 2);
    QVERIFY(end.contains(u"67 67"_s));
    QVERIFY(!board.isCalibrating());
}

void TestSbgcGenerations::activeProfileGetsDefaults()
{
    simplebgc::SimulatedBoard board(withFirmware(2660));
    const int first = board.stored(u"pid.roll.p"_s, 0);
    answers(board, 69, "02");  // profile 2
    board.store(u"pid.roll.p"_s, 0, 99);
    QVERIFY(board.stored(u"pid.roll.p"_s, 1) != first);
    answers(board, 70, "FE", 4);
    QCOMPARE(board.stored(u"pid.roll.p"_s, 1), first);
    QCOMPARE(board.stored(u"pid.roll.p"_s, 0), 99);
    answers(board, 70, "FF", 4);
    QCOMPARE(board.stored(u"pid.roll.p"_s, 0), first);
}

void TestSbgcGenerations::masksChooseVariables()
{
    simplebgc::SimulatedBoard older(withFirmware(2719));
    QCOMPARE(answers(older, 254, "40000000"), QStringList{refused(254, 1)});
    const QString all = answers(older, 254, "").value(0);
    QCOMPARE(all.section(u' ', 1).size() / 2, 3 * 2 + 3 * 4 + 1 + 1 + 2 + 4 + 4);
    simplebgc::SimulatedBoard board(withFirmware(2720));
    // Variable 6 is a u16 that says how long a cycle takes: 800 microseconds.
    QCOMPARE(answers(board, 254, "40000000"), QStringList{u"254 400000002003"_s});
    QCOMPARE(answers(board, 254, "4000000000000000"), QStringList{u"254 40000000000000002003"_s});
    QCOMPARE(answers(board, 254, "").value(0).size(), all.size());
}

// Roll, pitch, yaw and command, then the flight controller's two; 0x8000 is no signal (errata 3.9).
void TestSbgcGenerations::inputsAreTold()
{
    simplebgc::SimulatedBoard board(withFirmware(2590));
    const auto inputs
        = [&board] { return answers(board, 88, "20000000 000000000000").value(0).section(u' ', 1).mid(4); };
    QCOMPARE(inputs(), u"0080"_s.repeated(6));
    board.store(u"rc.map.pitch"_s, 0, 129);  // virtual channel 1
    board.store(u"rc.map.cmd"_s, 0, 130);
    answers(board, 45, "FA00 0CFE");  // 250 and -500 of 500
    QCOMPARE(inputs(), u"0080 0020 0080 00c0 0080 0080"_s.remove(u' '));
    QCOMPARE(answers(board, 88, "80000000 000000000000").value(0).section(u' ', 1).mid(4),
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
        return answers(board, 23, "", 2).value(0).section(u' ', 1).mid(76, 12);
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
    QCOMPARE(answers(rig.board(), 21, "00"), QStringList());
    QCOMPARE(answers(rig.board(), 82, "01").value(0).left(5), u"82 01"_s);
    QCOMPARE(answers(rig.board(), 68, "").value(0).left(3), u"23 "_s);

    auto read = rig.device.readConfiguration(rig.channel);
    QVERIFY2(read, read ? "" : qPrintable(read.error().detail));
    QVERIFY(read->missing().empty());
    QVERIFY(read->block({4, simplebgc::Params3}).size() == 134);
    QVERIFY(read->block({0, simplebgc::ParamsExt}).isEmpty());
    QVERIFY(rig.device.adjustables().empty());
    QCOMPARE(rig.device.activeProfile(rig.channel).value_or(-1), 0);
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
