// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/checksum.h"
#include "tests/support/stormbytes.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace Qt::StringLiterals;
using namespace storm32;

namespace {

QByteArray hex(const char *text)
{
    return QByteArray::fromHex(text);
}

}  // namespace

/// The simulated STorM32 board against the errata, on all three firmwares.
class TestStormBoard : public QObject
{
    Q_OBJECT
private slots:
    void lettersAndTimeouts_data();
    void lettersAndTimeouts();
    void versionIsWhatItIs_data();
    void versionIsWhatItIs();
    void parameterStream_data();
    void parameterStream();
    void memoryIsTwofold();
    void liveData_data();
    void liveData();
    void rcAnswers_data();
    void rcAnswers();
    void rcChecksumIsNotChecked();
    void dataFieldsComeInOrder();
    void steeringMovesTheCamera();
    void panAndStandby_data();
    void panAndStandby();
    void statesAfterARestart_data();
    void statesAfterARestart();
    void calibrationIsKept();
    void factoryDefaultsDoNotRunMotors();
    void heartbeatLocksOutAndIsEscaped();
    void mavlinkParameters_data();
    void mavlinkParameters();
    void mavlinkCommands();
    void embeddingHasItsLimit();
    void anyBytesAreSurvived();
};

namespace {

void addFirmwares()
{
    QTest::addColumn<int>("firmware");
    for (const int firmware : {79, 90, 96})
        QTest::newRow(QByteArray::number(firmware)) << firmware;
}

}  // namespace

void TestStormBoard::lettersAndTimeouts_data()
{
    addFirmwares();
}

void TestStormBoard::lettersAndTimeouts()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    QVERIFY(client.wait(3s).isEmpty());  // silent until asked
    QCOMPARE(client.ask("t"), "o");
    QCOMPARE(client.ask("T"), "e");  // letters are case sensitive
    QCOMPARE(client.ask(hex("f900000000")), "eeeee");  // five bytes, five answers; F9 came with v2.09
    QCOMPARE(client.ask("xZ"), "e");
    QCOMPARE(client.ask("Cz"), "e");
    QCOMPARE(client.ask("x"), "t");  // half a command
    QCOMPARE(client.ask(hex("fa0203")), "t");  // a half frame: the letter, no ack 150
    // 80 ms between bytes are all right, 120 are not.
    QVERIFY(client.ask(hex("fa00"), 80ms).isEmpty());
    QVERIFY(client.ask(hex("01"), 80ms).isEmpty());
    QCOMPARE(client.ask(hex("31e1")).left(4).toHex(), "fb0601" + QByteArray::number(firmware, 16));
    QVERIFY(client.ask(hex("fa00"), 99ms).isEmpty());
    QCOMPARE(client.wait(21ms), "t");
    QCOMPARE(client.ask("01"), "ee");
}

void TestStormBoard::versionIsWhatItIs_data()
{
    addFirmwares();
}

void TestStormBoard::versionIsWhatItIs()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    const QByteArray reply = client.ask("v");
    QCOMPARE(reply.size(), 57);
    QCOMPARE(reply.left(5), "v0." + QByteArray::number(firmware));
    QVERIFY(reply.mid(16, 16).startsWith("OlliW 323BGC"));
    QVERIFY(reply.mid(32, 16).startsWith("v1.30 F103RC"));
    QCOMPARE(u16(reply, 48), firmware);
    QCOMPARE(u16(reply, 50), firmware == 79 ? 78 : firmware == 90 ? 89 : 95);
    QCOMPARE(u16(reply, 52), 0xFF03);
    QCOMPARE(crc16Mcrf4xx(asBytes(reply.left(56))), 0);
    QCOMPARE(reply[56], 'o');
    // The name is padded with spaces when it is set, and survives.
    QCOMPARE(client.ask(encodeSimple(Simple::SetName, "Top gimbal      "), 1s), "o");
    QCOMPARE(client.ask("v").mid(16, 16), "Top gimbal      ");
    const QByteArray strings = client.askRc(Rc::GetVersionStrings);
    QCOMPARE(strings.left(3).toHex(), "fb3005");
    QCOMPARE(strings.mid(19, 16), "Top gimbal      ");
}

void TestStormBoard::parameterStream_data()
{
    addFirmwares();
}

void TestStormBoard::parameterStream()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    const int words = firmware == 79 ? 124 : 125;
    const QByteArray reply = client.ask("g");
    QCOMPARE(reply.size(), 2 * words + 128 + 3);
    QCOMPARE(u16(reply, 0), 400);
    QCOMPARE(u16(reply, 2 * 82), 25);  // unassigned, and to be kept
    QCOMPARE(u16(reply, 2 * words - 2), 0);  // the dummy
    QCOMPARE(reply.mid(2 * words, 128), QByteArray(128, char(0xFF)));
    // What is written is stored as it is, out of range or not; a wrong checksum changes nothing.
    QByteArray stream = reply.left(2 * words + 128);
    stream[0] = char(0xFF);
    stream[1] = char(0xFF);
    QByteArray wrong = encodeSimple(Simple::PutParameters, stream);
    wrong[wrong.size() - 1] = char(wrong[wrong.size() - 1] ^ 1);
    QCOMPARE(client.ask(wrong), "c");
    QCOMPARE(client.board().inUse(0), 400);
    QCOMPARE(client.ask(encodeSimple(Simple::PutParameters, stream)), "o");
    QCOMPARE(u16(client.ask("g"), 0), 65535);
    QCOMPARE(client.ask(encodeSimple(Simple::PutParameters, stream).left(100)), "t");
    QCOMPARE(client.ask("t"), "o");
}

void TestStormBoard::memoryIsTwofold()
{
    ByteClient client;
    QCOMPARE(client.askRc(Rc::SetParameter, hex("0000f401")).toHex(), "fb019600622e");
    QCOMPARE(client.board().inUse(0), 500);
    QCOMPARE(client.board().stored(0), 400);
    QCOMPARE(client.askRc(Rc::RestoreParameter, hex("0000")).toHex(), "fb019600622e");
    QCOMPARE(client.board().inUse(0), 400);
    client.board().set(0, 600);
    QVERIFY(client.ask("xs", 100ms).isEmpty());
    QVERIFY(client.ask("t", 300ms).isEmpty());  // writing the memory, nothing else is served
    QCOMPARE(client.wait(600ms), "oo");
    QCOMPARE(client.board().stored(0), 600);
    client.board().set(0, 700);
    QCOMPARE(client.ask("xr"), "o");
    QCOMPARE(client.board().inUse(0), 600);
    client.board().set(0, 700);
    QCOMPARE(client.ask("xx"), "o");
    QCOMPARE(client.board().inUse(0), 600);  // a restart loads what is stored
    QCOMPARE(client.ask("xd"), "o");
    QCOMPARE(client.board().inUse(0), 400);
    QCOMPARE(client.board().stored(0), 600);
    QCOMPARE(client.ask("xc", 1s), "o");
    QCOMPARE(client.board().stored(0), 400);
}

void TestStormBoard::liveData_data()
{
    addFirmwares();
}

void TestStormBoard::liveData()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    client.board().stabilizer().hand().setStrength(0);
    std::ignore = client.wait(2s);
    const QByteArray reply = client.ask("d");
    QCOMPARE(reply.size(), 67);
    QCOMPARE(crc16Mcrf4xx(asBytes(reply.left(66))), 0);
    QCOMPARE(u16(reply, 0), 6);  // normal
    QCOMPARE(u16(reply, 2) & 0x8028, 0x8028);  // IMU there and well, battery connected
    QVERIFY(std::abs(u16(reply, 8) - 12300) < 200);  // mV
    QCOMPARE(u16(reply, 12), 1500);
    const double oneG = firmware == 96 ? 8192.0 : 10000.0;
    QVERIFY(std::abs(s16(reply, 24) / oneG - 1.0) < 0.1);  // z up at rest
    QVERIFY(std::abs(s16(reply, 30) - 10000) < 30);
    QVERIFY(firmware == 79 ? u16(reply, 10) < 66 : true);  // its useless time
    QCOMPARE(client.ask("s").left(10).size(), 10);
    QCOMPARE(client.ask("s").size(), 13);
    // Pitch down is positive, and the up direction then points back in the camera (errata 3.5).
    for (int step = 0; step < 3; ++step)
        client.askRc(Rc::SetAngle, ByteWriter().f32(30).f32(0).f32(0).u8(0).u8(0).take());
    std::ignore = client.wait(4s);
    const QByteArray down = client.ask("d");
    QVERIFY2(std::abs(s16(down, 32) - 3000) < 150, qPrintable(QString::number(s16(down, 32))));
    QVERIFY(std::abs(s16(down, 26) + 5000) < 250);
    QVERIFY(std::abs(s16(down, 30) - 8660) < 250);
}

void TestStormBoard::rcAnswers_data()
{
    QTest::addColumn<QByteArray>("sent");
    QTest::addColumn<QByteArray>("begins");
    QTest::newRow("get version") << encodeRc(1, {}) << hex("fb060160005f0003ff");
    QTest::newRow("parameter beyond the last") << encodeRc(3, hex("e803")) << hex("fb0403e8030000");
    QTest::newRow("set beyond the last") << encodeRc(4, hex("e8030100")) << hex("fb019600622e");
    QTest::newRow("unknown command") << encodeRc(77, hex("0102")) << hex("fb019603f91c");
    QTest::newRow("wrong length") << hex("fa0211e8030000")
                                  << hex("fb019698a336");  // the document's own example
    QTest::newRow("pitch") << encodeRc(10, hex("e803")) << hex("fb019600622e");
    QTest::newRow("pitch, ignored value") << encodeRc(10, hex("0100")) << hex("fb019600622e");
    QTest::newRow("get data") << encodeRc(5, hex("00")) << hex("fb42050000");
    QTest::newRow("get data, another kind") << encodeRc(5, hex("01")) << hex("fb02050100");
    QTest::newRow("get no fields is all") << encodeRc(6, hex("0000")) << hex("fb42060000");
    QTest::newRow("unknown fields add nothing") << encodeRc(6, hex("00f0")) << hex("fb020600f0");
    QTest::newRow("script 4") << encodeRc(16, hex("0400")) << hex("fb019600");
    QTest::newRow("script case 5") << encodeRc(16, hex("0005")) << hex("fb019600");
    QTest::newRow("pwm too low") << encodeRc(19, hex("bb02")) << hex("fb019699");
    QTest::newRow("pwm") << encodeRc(19, hex("bc02")) << hex("fb019600");
    QTest::newRow("camera") << encodeRc(15, hex("000100000000")) << hex("fb019600");
    QTest::newRow("restore all") << encodeRc(21, {}) << hex("fb019600");
    QTest::newRow("active pan mode") << encodeRc(100, hex("02")) << hex("fb019600");
}

void TestStormBoard::rcAnswers()
{
    QFETCH(QByteArray, sent);
    QFETCH(QByteArray, begins);
    ByteClient client;
    const QByteArray reply = client.ask(sent);
    QCOMPARE(reply.left(begins.size()).toHex(), begins.toHex());
    QCOMPARE(reply.size(), 5 + std::uint8_t(reply[1]));
    QCOMPARE(crc16Mcrf4xx(asBytes(reply.mid(1))), 0);
}

void TestStormBoard::rcChecksumIsNotChecked()
{
    for (const char *crc : {"0000", "3334", "4444", "31e1"}) {
        ByteClient client;
        QCOMPARE(client.ask(hex("fa0001") + hex(crc)).left(3).toHex(), "fb0601");
    }
    ByteClient strict(96, true, true);
    QCOMPARE(strict.ask(hex("fa00013334")).left(4).toHex(), "fb019697");  // 151
    QCOMPARE(strict.ask(hex("fa000131e1")).left(3).toHex(), "fb0601");
}

void TestStormBoard::dataFieldsComeInOrder()
{
    ByteClient client;
    const QByteArray reply = client.askRc(Rc::GetDataFields, hex("a200"));  // times, angles, inputs
    QCOMPARE(reply.left(3).toHex(), "fb1406");
    QCOMPARE(u16(reply, 3), 0x00A2);
    QCOMPARE(u16(reply, 7), 1500);  // cycle time
    QCOMPARE(reply.size(), 5 + 2 + 2 * (2 + 3 + 3 + 1));
    QVERIFY(client.askRc(Rc::SetScriptControl, hex("0101")).contains(hex("9600")));
    QCOMPARE(u16(client.askRc(Rc::GetDataFields, hex("8000")), 11),
             0x0010);  // the packed word is the last: script 2 at 5:4
}

void TestStormBoard::steeringMovesTheCamera()
{
    ByteClient client;
    client.board().stabilizer().hand().setStrength(0);
    // Half of the way to the end of its range, which is 25 degrees (defaults).
    QCOMPARE(client.askRc(Rc::SetPitch, ByteWriter().u16(1750).take()).toHex(), "fb019600622e");
    std::ignore = client.wait(4s);
    QVERIFY(std::abs(s16(client.ask("d"), 32) - 1250) < 120);
    QCOMPARE(s16(client.ask("d"), 44), 250);
    QCOMPARE(client.askRc(Rc::SetPitch, hex("0000")).toHex(), "fb019600622e");
    std::ignore = client.wait(4s);
    QVERIFY(std::abs(s16(client.ask("d"), 32)) < 120);
    // Limited angles end at the range, unlimited ones do not.
    client.askRc(Rc::SetAngle, ByteWriter().f32(40).f32(0).f32(0).u8(1).u8(0).take());
    std::ignore = client.wait(4s);
    QVERIFY(std::abs(s16(client.ask("d"), 32) - 2500) < 150);
    client.askRc(Rc::SetAngle, ByteWriter().f32(40).f32(0).f32(-20).u8(0).u8(0).take());
    std::ignore = client.wait(4s);
    QVERIFY(std::abs(s16(client.ask("d"), 32) - 4000) < 150);
    QVERIFY(std::abs(s16(client.ask("d"), 36) + 2000) < 250);
    QVERIFY(client.board().stabilizer().trueAngle(Axis::Yaw)
            > 17);  // right, which the firmware counts as negative
}

void TestStormBoard::panAndStandby_data()
{
    addFirmwares();
}

void TestStormBoard::panAndStandby()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    const auto pan = [&client](int mode) {
        client.askRc(Rc::SetPanMode, QByteArray(1, char(mode)));
        return u16(client.ask("d"), 4) & 0xE000;
    };
    QCOMPARE(pan(1), 0x8000);  // yaw
    QCOMPARE(pan(2), 0x0000);
    QCOMPARE(pan(3), 0xE000);
    QCOMPARE(pan(4), 0x2000);  // pitch
    QCOMPARE(pan(5), 0xA000);
    QCOMPARE(pan(6), firmware == 96 ? 0xC000 : 0xA000);  // from 0.92 on
    QCOMPARE(pan(0), 0x8000);  // back to the parameter
    QVERIFY(client.board().stabilizer().motorsOn());
    client.askRc(Rc::SetStandby, hex("01"));
    QCOMPARE(u16(client.ask("s"), 0), firmware == 96 ? 99 : 7);
    QCOMPARE(u16(client.ask("s"), 4) & 0x1000, 0);  // not in the bits
    QVERIFY(!client.board().stabilizer().motorsOn());
    client.askRc(Rc::SetStandby, hex("00"));
    QCOMPARE(u16(client.ask("s"), 0), 5);
    std::ignore = client.wait(1500ms);
    QCOMPARE(u16(client.ask("s"), 0), 6);
}

void TestStormBoard::statesAfterARestart_data()
{
    addFirmwares();
}

void TestStormBoard::statesAfterARestart()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    for (const int word : {21, 27, 33})
        client.board().set(word, 2);  // directions are searched for
    QCOMPARE(client.ask("xs", 1s), "o");
    QCOMPARE(client.ask("xx", 20ms), "o");
    const double start = client.board().now();
    std::array<double, 7> ended{};
    int last = 0;
    while (client.board().now() - start < 20.0) {
        std::ignore = client.wait(20ms);
        const int state = client.board().state();
        QVERIFY(state == last || state == last + 1);
        if (state != last)
            ended[std::size_t(last)] = client.board().now() - start;
        last = state;
    }
    QCOMPARE(last, 6);
    const std::array<double, 6> wanted = firmware == 79 ? std::array{3.7, 7.5, 9.8, 10.9, 17.7, 18.8}
                                                        : std::array{3.5, 6.5, 8.5, 9.5, 15.8, 16.7};
    for (std::size_t i = 0; i < wanted.size(); ++i)
        QVERIFY2(std::abs(ended[i] - wanted[i]) < 0.1,
                 qPrintable(u"state %1 ended after %2 s"_s.arg(i).arg(ended[i])));
    QCOMPARE(client.ask("xm"), "o");
    QCOMPARE(client.board().inUse(21), 0);
}

void TestStormBoard::calibrationIsKept()
{
    ByteClient client;
    QByteArray reply = client.ask("Cr");
    QCOMPARE(reply.size(), 39);
    QCOMPARE(s16(reply, 6), 8192);
    QCOMPARE(s16(ByteClient(90).ask("Cr"), 6), 16384);
    reply = client.ask("Cd");
    QCOMPARE(reply.size(), 31);
    QVERIFY(std::abs(s16(reply, 4) / 8192.0 - 1.0) < 0.15);
    QVERIFY(std::abs(s16(reply, 12) / 340.0 + 36.53 - 31.0) < 0.1);
    // Accelerometer of the first IMU: the other words are left alone.
    ByteWriter writer;
    writer.u16(1);
    for (int i = 0; i < 18; ++i)
        writer.i16(100 + i);
    QCOMPARE(client.ask(encodeSimple(Simple::WriteCalibration, writer.take()), 1s), "o");
    reply = client.ask("Cr");
    QCOMPARE(s16(reply, 0), 100);
    QCOMPARE(s16(reply, 10), 105);
    QCOMPARE(s16(reply, 12), 0);
    // The slip of the firmware: gyro zeros from the words behind.
    ByteWriter gyro;
    gyro.u16(2);
    for (int i = 0; i < 18; ++i)
        gyro.i16(i);
    const QByteArray bytes = gyro.take();
    QCOMPARE(client.ask(encodeSimple(Simple::WriteCalibration, bytes), 1s), "o");
    QCOMPARE(s16(client.ask("Cr"), 12), 7);
    // Selector 8 does nothing and sends everything back.
    const QByteArray odd = ByteWriter().u16(8).zeros(36).take();
    QCOMPARE(client.ask(encodeSimple(Simple::WriteCalibration, odd)), "Cw" + encodeReply(odd));
}

void TestStormBoard::factoryDefaultsDoNotRunMotors()
{
    ByteClient client;
    QVERIFY(u16(client.ask("d"), 4) & 0x0038);
    QCOMPARE(client.ask("xd"), "o");
    QVERIFY(!(u16(client.ask("d"), 4) & 0x0038));  // usage "disabled"
    const QByteArray live = client.ask("d");
    QVERIFY(std::abs(s16(live, 38) + s16(live, 32)) <= 1);  // the output is exactly minus the angle
    QCOMPARE(client.ask("xW"), "o");
    std::ignore = client.wait(20s);
    QVERIFY(u16(client.ask("d"), 4) & 0x0038);
}

void TestStormBoard::heartbeatLocksOutAndIsEscaped()
{
    ByteClient client;
    QVERIFY(client.wait(3s).isEmpty());
    client.askRc(Rc::SetParameter, hex("70000100"));  // its texts come first (errata 13, row 4)
    const QByteArray beats = client.wait(3s);
    const QVariantMap beat = fieldsOf(beats);
    QCOMPARE(beats.size() % 17, 0);
    QVERIFY(beats.size() >= 2 * 17 && beats.size() <= 4 * 17);
    QCOMPARE(beat.value(u"type"_s).toInt(), 26);
    QCOMPARE(beat.value(u"autopilot"_s).toInt(), 0x53);
    QCOMPARE(beat.value(u"custom_mode"_s).toInt(), 6);
    QCOMPARE(beat.value(u"base_mode"_s).toInt(), 0x80);
    QCOMPARE(beat.value(u"system_status"_s).toInt(), 4);
    // Plain commands are ignored, without even an e.
    QVERIFY(!client.ask("t", 150ms).contains('o'));
    QVERIFY(!client.ask(encodeRc(1, {}), 150ms).contains(char(0xFB)));
    // The way out: embedded (errata 6). The example of the errata first.
    QByteArray heard = client.ask(hex("fe03005243ea4743746893"), 60ms);
    while (!heard.isEmpty() && std::uint8_t(heard[5]) == 0)
        heard.remove(0, 17);
    QCOMPARE(heard.left(2).toHex(), "fe03");
    QCOMPARE(heard.mid(3, 6).toHex(), "4743eb52436f");
    heard = client.askMavlink(mavlink::MessageId::TargetSpecific,
                              {{u"specific_payload"_s, hex("fa0470000000")}});
    QVERIFY(heard.contains(hex("5243fb9600")));
    QCOMPARE(client.ask("t"), "o");
    QVERIFY(client.wait(3s).isEmpty());
    // USB goes on answering everything.
    ByteClient usb(96, false);
    usb.askRc(Rc::SetParameter, hex("70000100"));
    QVERIFY(usb.ask("t", 50ms).contains('o'));
}

void TestStormBoard::mavlinkParameters_data()
{
    addFirmwares();
}

void TestStormBoard::mavlinkParameters()
{
    QFETCH(int, firmware);
    using mavlink::MessageId;
    ByteClient client(firmware);
    const int words = firmware == 79 ? 124 : 125;
    const auto read = [&client](int index, const QString &name = {}) {
        return fieldsOf(client.askMavlink(MessageId::ParamRequestRead,
                                          {{u"param_index"_s, index}, {u"param_id"_s, name}}));
    };
    QVariantMap answer = read(47);
    QCOMPARE(answer.value(u"param_id"_s).toString(), u"RC_PITCH_MIN"_s);
    QCOMPARE(answer.value(u"param_index"_s).toInt(), 47);
    QCOMPARE(answer.value(u"param_count"_s).toInt(), words);
    QCOMPARE(answer.value(u"param_type"_s).toInt(), 4);
    const float value = answer.value(u"param_value"_s).toFloat();
    if (firmware < 91)
        QCOMPARE(value, 65286.0F);
    else
        QCOMPARE(ByteWriter().f32(value).take().toHex(), "06ff0000");
    QCOMPARE(read(-1, u"PID_ROLL_P"_s).value(u"param_index"_s).toInt(), 6);
    QCOMPARE(read(-1, u"NONSENSE"_s).value(u"param_index"_s).toInt(), 0);  // check the name in the answer
    QCOMPARE(read(words).value(u"param_index"_s).toInt(), 0);
    // The list has all of them, in order.
    QByteArray list = client.askMavlink(MessageId::ParamRequestList, {});
    list += client.wait(2s);
    QCOMPARE(list.size(), words * 33);
    for (int i = 0; i < words; ++i)
        QCOMPARE(fieldsOf(list.mid(i * 33, 33)).value(u"param_index"_s).toInt(), i);
    // Setting answers with the value in force and changes RAM only.
    const auto coding = firmware < 91 ? mavlink::ValueCoding::Number : mavlink::ValueCoding::Bits;
    answer = fieldsOf(client.askMavlink(
        MessageId::ParamSet,
        {{u"param_id"_s, u"PID_PITCH_P"_s}, {u"param_value"_s, mavlink::encodeValue(321, coding)}}));
    QCOMPARE(mavlink::decodeValue(answer.value(u"param_value"_s).toFloat(), coding), 321);
    QCOMPARE(client.board().inUse(0), 321);
    QCOMPARE(client.board().stored(0), 400);
    answer = fieldsOf(client.askMavlink(
        MessageId::ParamSet2, {{u"param_index"_s, 1}, {u"param_value"_s, mavlink::encodeValue(77, coding)}}));
    QCOMPARE(answer.value(u"target_system"_s).toInt(), 82);  // the asker's
    QCOMPARE(client.board().inUse(1), 77);
    QCOMPARE(fieldsOf(client.askMavlink(MessageId::ParamRead2, {{u"param_index"_s, 1}}))
                 .value(u"param_index"_s)
                 .toInt(),
             1);
    // Others get nothing, broadcast neither; damage gets nothing.
    QVERIFY(client.askMavlink(MessageId::ParamRequestRead, {{u"param_index"_s, 1}}, 1).isEmpty());
    QVERIFY(client.askMavlink(MessageId::ParamRequestRead, {{u"param_index"_s, 1}}, 0).isEmpty());
    QVERIFY(client.ask(hex("fe03005243ea4743746894")).isEmpty());
    QVERIFY(client.ask(hex("fe03005243ea47")).isEmpty());
    QCOMPARE(client.ask("t"), "o");
}

void TestStormBoard::mavlinkCommands()
{
    using mavlink::MessageId;
    ByteClient client;
    const auto command = [&client](int id, const QVariantMap &parameters = {}) {
        QVariantMap values = parameters;
        values.insert(u"command"_s, id);
        return fieldsOf(client.askMavlink(MessageId::CommandLong, values));
    };
    for (const int id : {180, 183, 203, 204, 205, 220, 245}) {
        const QVariantMap ack = command(id);
        QCOMPARE(ack.value(u"command"_s).toInt(), id);
        QCOMPARE(ack.value(u"result"_s).toInt(), 0);
    }
    QCOMPARE(command(400).value(u"result"_s).toInt(), 3);
    command(180, {{u"param1"_s, 0}, {u"param2"_s, 555}});
    QCOMPARE(client.board().inUse(0), 555);
    command(245, {{u"param1"_s, 1}});
    std::ignore = client.wait(1s);
    QCOMPARE(client.board().stored(0), 555);
    command(180, {{u"param1"_s, 0}, {u"param2"_s, 1}});
    command(180, {{u"param1"_s, 0}, {u"param7"_s, 83}});
    QCOMPARE(client.board().inUse(0), 555);
    // 1234 is answered by one ATTITUDE from 0.94 on; pitch up is positive there.
    client.board().stabilizer().hand().setStrength(0);
    QCOMPARE(command(205, {{u"param1"_s, 30}}).value(u"result"_s).toInt(), 0);
    std::ignore = client.wait(4s);
    const QVariantMap attitude = command(1234);
    QVERIFY(attitude.contains(u"rollspeed"_s));
    QVERIFY2(std::abs(attitude.value(u"pitch"_s).toDouble() + 0.5236) < 0.03,
             qPrintable(attitude.value(u"pitch"_s).toString()));
    QVERIFY(client.wait(2s).isEmpty());
    ByteClient old(90);
    QCOMPARE(
        fieldsOf(old.askMavlink(MessageId::CommandLong, {{u"command"_s, 1234}})).value(u"result"_s).toInt(),
        3);
    // Mount messages are executed without an answer.
    QVERIFY(client.askMavlink(MessageId::MountControl, {{u"input_a"_s, -1000}}).isEmpty());
    std::ignore = client.wait(4s);
    QVERIFY(std::abs(s16(client.ask("d"), 32) + 1000) < 150);
    QVERIFY(client.askMavlink(MessageId::MountConfigure, {{u"mount_mode"_s, 1}}).isEmpty());
    std::ignore = client.wait(4s);
    QVERIFY(std::abs(s16(client.ask("d"), 32)) < 150);
    QVERIFY(client.askMavlink(MessageId::DigicamControl, {{u"shot"_s, 1}}).isEmpty());
    // ATTITUDE by itself comes only after somebody's heartbeat, twice a second.
    client.board().set(112, 2);
    std::ignore = client.wait(200ms);  // its texts
    QVERIFY(!client.wait(3s).contains(hex("1e")));
    client.ask(mavlink::encode(MessageId::Heartbeat, QByteArray(9, '\0'), {1, 1}, 0));
    const QByteArray heard = client.wait(4s);
    QVERIFY(heard.size() >= 4 * 17 + 7 * 36 - 17 && heard.size() <= 5 * 17 + 9 * 36);
}

void TestStormBoard::embeddingHasItsLimit()
{
    for (const int firmware : {79, 96}) {
        ByteClient client(firmware);
        const QByteArray heard = client.askMavlink(mavlink::MessageId::TargetSpecific,
                                                   {{u"specific_payload"_s, QByteArray("g")}});
        QCOMPARE(int(std::uint8_t(heard[1])), firmware == 79 ? 125 : 127);
        const QByteArray version = client.askMavlink(mavlink::MessageId::TargetSpecific,
                                                     {{u"specific_payload"_s, QByteArray("v")}});
        QCOMPARE(int(std::uint8_t(version[1])), 2 + 57);
        const QByteArray wrong = client.askMavlink(mavlink::MessageId::TargetSpecific,
                                                   {{u"specific_payload"_s, QByteArray("?")}});
        QCOMPARE(fieldsOf(wrong).value(u"specific_payload"_s).toByteArray(), "e");
    }
}

void TestStormBoard::anyBytesAreSurvived()
{
    std::mt19937 random(9);
    for (const int firmware : {79, 90, 96}) {
        ByteClient client(firmware);
        for (int round = 0; round < 300; ++round) {
            QByteArray bytes;
            for (int i = 0; i < int(random() % 80); ++i)
                bytes.append(char(random() % 4 ? random() : unsigned("tvgdspxC\xFA\xFE"[random() % 10])));
            std::ignore = client.ask(bytes, milliseconds(random() % 40));
        }
        client.board().set(112, 0);
        std::ignore = client.wait(3s);
        QCOMPARE(client.ask("t"), "o");
    }
}

QTEST_GUILESS_MAIN(TestStormBoard)
#include "tst_stormboard.moc"
