// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/checksum.h"
#include "protocol/storm32/scripts.h"
#include "tests/support/patience.h"
#include "tests/support/stormbytes.h"
#include "tests/support/stormrig.h"

#include <QTest>

using namespace storm32;
using mavlink::MessageId;

namespace {

QByteArray hex(const char *text)
{
    return QByteArray::fromHex(text);
}

const QByteArray kAck = hex("fb019600622e");

// A message with a payload of any length and its right checksum.
QByteArray frameOf(MessageId id, const QByteArray &payload)
{
    QByteArray frame = hex("fe") + char(payload.size()) + hex("005243") + char(mavlink::number(id)) + payload;
    const int extra = mavlink::findMessage(mavlink::number(id))->crcExtra;
    const auto crc = crc16Mcrf4xx(asBytes(frame.mid(1) + char(extra)));
    return frame + ByteWriter().u16(crc).take();
}

// What the board answers to an embedded command, without the frame around it.
QByteArray embeddedAnswer(const QByteArray &frame)
{
    return fieldsOf(frame).value(u"specific_payload"_s).toByteArray();
}

}  // namespace

/// The simulated STorM32 board against the 19 corrections of the errata (section 13), row by row.
class TestStormFirmware : public QObject
{
    Q_OBJECT
private slots:
    void row01_standbyIsIgnoredWhileStarting_data();
    void row01_standbyIsIgnoredWhileStarting();
    void row02_factoryDefaultsDisableTheMotors_data() { addFirmwares(); }
    void row02_factoryDefaultsDisableTheMotors();
    void row03_unknownFramesAreSkippedWhole_data() { addFirmwares(); }
    void row03_unknownFramesAreSkippedWhole();
    void row04_heartbeatBeginsWithTexts_data() { addFirmwares(); }
    void row04_heartbeatBeginsWithTexts();
    void row05_componentNoneIsAnswered_data() { addFirmwares(); }
    void row05_componentNoneIsAnswered();
    void row06_unknownParameterWritesTheFirst_data() { addFirmwares(); }
    void row06_unknownParameterWritesTheFirst();
    void row06_isNeverSent_data() { addFirmwares(); }
    void row06_isNeverSent();
    void row07_signedWordsAreInt16_data() { addFirmwares(); }
    void row07_signedWordsAreInt16();
    void row08_negativeNumbersStoreZero_data() { addFirmwares(); }
    void row08_negativeNumbersStoreZero();
    void row09_numbersAreCutAndTruncated_data();
    void row09_numbersAreCutAndTruncated();
    void row10_listMayBeTooLong_data() { addFirmwares(); }
    void row10_listMayBeTooLong();
    void row11_embeddingWithoutACommand_data() { addFirmwares(); }
    void row11_embeddingWithoutACommand();
    void row12_anyScriptIsAcknowledged_data() { addFirmwares(); }
    void row12_anyScriptIsAcknowledged();
    void row13_gyroZerosSlip_data() { addFirmwares(); }
    void row13_gyroZerosSlip();
    void row14_selectorsThatAreNone_data() { addFirmwares(); }
    void row14_selectorsThatAreNone();
    void row15_defaultsOfTheFirmware_data() { addFirmwares(); }
    void row15_defaultsOfTheFirmware();
    void row16_word38Of79ReadsZero();
    void row17_anyHeartbeatLocksOut();
    void row18_scriptsRunAtOnce_data() { addFirmwares(); }
    void row18_scriptsRunAtOnce();
    void row19_storingKeepsAllInUse_data() { addFirmwares(); }
    void row19_storingKeepsAllInUse();

private:
    static void addFirmwares()
    {
        QTest::addColumn<int>("firmware");
        for (const int firmware : {79, 90, 96})
            QTest::newRow(QByteArray::number(firmware)) << firmware;
    }
};

void TestStormFirmware::row01_standbyIsIgnoredWhileStarting_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<int>("state");
    for (const auto &[firmware, state] : std::initializer_list<std::pair<int, int>>{
             {79, 1}, {90, 1}, {90, 4}, {96, 0}, {96, 1}, {96, 2}, {96, 4}, {96, 5}})
        QTest::addRow("%d in state %d", firmware, state) << firmware << state;
}

void TestStormFirmware::row01_standbyIsIgnoredWhileStarting()
{
    QFETCH(int, firmware);
    QFETCH(int, state);
    ByteClient client(firmware);
    if (state == 5) {  // leaving standby goes through it
        QCOMPARE(client.ask(hex("fa010e0176e8")), kAck);
        std::ignore = client.wait(3s);
        QCOMPARE(client.askRc(Rc::SetStandby, hex("00")), kAck);
    } else {
        QCOMPARE(client.ask("xx").left(1), "o");
    }
    if (state == 4) {
        for (const int word : {21, 27, 33})  // directions are to be found
            client.board().set(word, 2);
    }
    for (int i = 0; i < 2500 && client.board().state() != state; ++i)
        std::ignore = client.wait(10ms);
    QCOMPARE(client.board().state(), state);
    QCOMPARE(u16(client.ask("s"), 0), state);
    QCOMPARE(client.ask(hex("fa010e0176e8")), kAck);
    for (int i = 0; i < 250 && client.board().state() != 6; ++i)
        std::ignore = client.wait(100ms);
    std::ignore = client.wait(1s);
    QByteArray status = client.ask("s");
    QCOMPARE(u16(status, 0), 6);
    QCOMPARE(u16(status, 4) & 0x0038, 0x0038);  // told off, and on all the same
    // Disabled motors drop their bits at once.
    for (const char *word : {"4e000300", "4f000300", "50000300"})
        client.askRc(Rc::SetParameter, hex(word));
    QCOMPARE(u16(client.ask("s"), 4) & 0x0038, 0);
}

void TestStormFirmware::row02_factoryDefaultsDisableTheMotors()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    QCOMPARE(client.ask("xd"), "o");
    for (const int word : {78, 79, 80})
        QCOMPARE(client.board().inUse(word), 3);
    QCOMPARE(client.askRc(Rc::SetStandby, hex("00")), kAck);
    std::ignore = client.wait(3s);
    QCOMPARE(u16(client.ask("s"), 4) & 0x0038, 0);
}

void TestStormFirmware::row03_unknownFramesAreSkippedWhole()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    // A message that the board does not know; its bytes are no plain commands.
    QVERIFY(client.ask(hex("fe0c75524321") + QByteArray(12, 't') + hex("0102")).isEmpty());
    QVERIFY(client.ask(hex("fe058a5243144743182530e504")).isEmpty());
    QVERIFY(client.ask(frameOf(MessageId::ParamRequestRead, hex("4743182530"))).isEmpty());
    QCOMPARE(client.ask("t"), "o");
}

void TestStormFirmware::row04_heartbeatBeginsWithTexts()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    QByteArray heard = client.ask(encodeRc(int(Rc::SetParameter), hex("70000100")), 900ms);
    heard.remove(0, kAck.size());
    QVERIFY(heard.size() >= 2 * 59 + 17);
    const QString first = fieldsOf(heard).value(u"text"_s).toString();
    QVERIFY2(first.startsWith(u"SToRM32 v0.%1 v1.30"_s.arg(firmware)), qPrintable(first));
    QCOMPARE(fieldsOf(heard.mid(59)).value(u"text"_s).toString(), u"OlliW 323BGC"_s);
    QCOMPARE(int(std::uint8_t(heard[2 * 59 + 5])), 0);
    QVERIFY(!client.wait(3s).contains(hex("4743fd")));  // once
}

void TestStormFirmware::row05_componentNoneIsAnswered()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    const auto ask = [&client](MessageId id, int system) {
        return client.ask(
            frameOf(id,
                    *mavlink::encodeFields(*mavlink::findMessage(mavlink::number(id)),
                                           {{u"target_system"_s, system}, {u"target_component"_s, 0}})));
    };
    QCOMPARE(fieldsOf(ask(MessageId::ParamRequestRead, 71)).value(u"param_index"_s).toInt(), 0);
    QVERIFY(ask(MessageId::ParamRequestRead, 0).isEmpty());
    QVERIFY(ask(MessageId::ParamRead2, 71).isEmpty());
}

void TestStormFirmware::row06_unknownParameterWritesTheFirst()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    const auto coding = firmware < 91 ? mavlink::ValueCoding::Number : mavlink::ValueCoding::Bits;
    const QVariantMap answer = fieldsOf(client.askMavlink(
        MessageId::ParamSet,
        {{u"param_id"_s, u"NONSENSE"_s}, {u"param_value"_s, mavlink::encodeValue(123, coding)}}));
    QCOMPARE(answer.value(u"param_index"_s).toInt(), 0);
    QCOMPARE(client.board().inUse(0), 123);
    client.askMavlink(MessageId::ParamSet2,
                      {{u"param_index"_s, 300}, {u"param_value"_s, mavlink::encodeValue(77, coding)}});
    QCOMPARE(client.board().inUse(0), 77);
}

// By hand neither.
void TestStormFirmware::row06_isNeverSent()
{
    QFETCH(int, firmware);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    const auto typed = [&rig](MessageId id, QVariantMap values) {
        values.insert(u"target_system"_s, 71);
        values.insert(u"target_component"_s, 67);
        const auto payload = mavlink::encodeFields(*mavlink::findMessage(mavlink::number(id)), values);
        const auto command = rig.device.parseCommand(QString::fromLatin1(frameOf(id, *payload).toHex()));
        return command ? ErrorCode::Cancelled : command.error().code;
    };
    QCOMPARE(typed(MessageId::ParamSet, {{u"param_id"_s, u"NONSENSE"_s}}), ErrorCode::InvalidArgument);
    // Which names v0.90 has was never seen.
    QCOMPARE(typed(MessageId::ParamSet, {{u"param_id"_s, u"PID_PITCH_P"_s}}),
             firmware == 90 ? ErrorCode::InvalidArgument : ErrorCode::Cancelled);
    const int words = firmware == 79 ? 124 : 125;
    QCOMPARE(typed(MessageId::ParamSet2, {{u"param_index"_s, words}}), ErrorCode::InvalidArgument);
    QCOMPARE(typed(MessageId::ParamSet2, {{u"param_index"_s, words - 1}}), ErrorCode::Cancelled);
    // What would be confirmed and not done is not sent either, in whatever form.
    const auto isSent = [&rig](const QString &text) { return rig.device.parseCommand(text).has_value(); };
    for (const auto &[word, isThere] : {std::pair(words - 1, true), std::pair(words, false)}) {
        const QByteArray index = ByteWriter().u16(word).take();
        for (const Rc id : {Rc::GetParameter, Rc::SetParameter, Rc::RestoreParameter}) {
            const QByteArray payload = id == Rc::SetParameter ? index + hex("0100") : index;
            const QString name = QString::fromLatin1(findRc(int(id))->name);
            QCOMPARE(isSent(name + u' ' + QString::fromLatin1(payload.toHex())), isThere);
            QCOMPARE(isSent(name + u" index=%1"_s.arg(word)
                            + (id == Rc::SetParameter ? u" value=1"_s : QString())),
                     isThere);
            QCOMPARE(isSent(QString::fromLatin1(rcRequest(id, payload).bytes.toHex())), isThere);
            const QByteArray embedded = hex("4743fa") + char(id) + payload;
            QCOMPARE(isSent(QString::fromLatin1(frameOf(MessageId::TargetSpecific, embedded).toHex())),
                     isThere);
        }
        QCOMPARE(typed(MessageId::CommandLong, {{u"command"_s, 180}, {u"param1"_s, word}}),
                 isThere ? ErrorCode::Cancelled : ErrorCode::InvalidArgument);
    }
}

void TestStormFirmware::row07_signedWordsAreInt16()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    const auto type = [&client](int word) {
        return fieldsOf(client.askMavlink(MessageId::ParamRead2, {{u"param_index"_s, word}}))
            .value(u"param_type"_s)
            .toInt();
    };
    QCOMPARE(type(47), 4);
    QCOMPARE(type(0), 3);
}

void TestStormFirmware::row08_negativeNumbersStoreZero()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    client.askMavlink(MessageId::CommandLong, {{u"command"_s, 180}, {u"param1"_s, 0}, {u"param2"_s, -5}});
    QCOMPARE(client.board().inUse(0), 0);
}

void TestStormFirmware::row09_numbersAreCutAndTruncated_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<double>("number");
    QTest::addColumn<int>("held");
    for (const int firmware : {79, 90}) {
        QTest::addRow("%d, 70000", firmware) << firmware << 70000.0 << 4464;
        QTest::addRow("%d, 1.9", firmware) << firmware << 1.9 << 1;
        QTest::addRow("%d, negative", firmware) << firmware << -3.0 << 0;
    }
    QTest::newRow("96, low bits of the float") << 96 << 1.9 << 0x3333;
}

void TestStormFirmware::row09_numbersAreCutAndTruncated()
{
    QFETCH(int, firmware);
    QFETCH(double, number);
    QFETCH(int, held);
    ByteClient client(firmware);
    client.askMavlink(MessageId::ParamSet,
                      {{u"param_id"_s, u"PID_PITCH_P"_s}, {u"param_value"_s, float(number)}});
    QCOMPARE(client.board().inUse(0), held);
}

void TestStormFirmware::row10_listMayBeTooLong()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    const QByteArray list = client.ask(hex("fe049f524315474321c96667"), 3s);
    QCOMPARE(list.size(), 33 * (firmware == 79 ? 124 : 125));
}

void TestStormFirmware::row11_embeddingWithoutACommand()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    QCOMPARE(embeddedAnswer(client.ask(frameOf(MessageId::TargetSpecific, hex("4743")))).toHex(), "65");
    QCOMPARE(embeddedAnswer(client.ask(frameOf(MessageId::TargetSpecific, hex("4743fa")))).toHex(), "fb9603");
    QCOMPARE(embeddedAnswer(client.ask(frameOf(MessageId::TargetSpecific, "t"))).toHex(), "6f");
}

void TestStormFirmware::row12_anyScriptIsAcknowledged()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    for (const char *payload : {"0400", "0005", "00ff"})
        QCOMPARE(client.askRc(Rc::SetScriptControl, hex(payload)), kAck);
}

void TestStormFirmware::row13_gyroZerosSlip()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    ByteWriter data;
    data.u16(2);
    for (int word = 0; word < 18; ++word)
        data.i16(100 + word);
    QCOMPARE(client.ask(encodeSimple(Simple::WriteCalibration, data.take()), 1500ms), "o");
    const QByteArray now = client.ask("Cr");
    QCOMPARE(s16(now, 12), 107);
    QCOMPARE(s16(now, 16), 109);
}

void TestStormFirmware::row14_selectorsThatAreNone()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    const auto write = [&client](int selector) {
        return client.ask(encodeSimple(Simple::WriteCalibration, ByteWriter().u16(selector).zeros(36).take()),
                          1500ms);
    };
    QCOMPARE(write(0).toHex(), "43187f6f");
    QCOMPARE(write(8).left(4).toHex(), "43770800");
    QVERIFY(write(9).endsWith('o'));
    QCOMPARE(s16(client.ask("Cr"), 6), firmware >= 94 ? 8192 : 16384);  // nothing was changed
}

void TestStormFirmware::row15_defaultsOfTheFirmware()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    QCOMPARE(client.ask("xd"), "o");
    for (const int word : {45, 52, 59})
        QCOMPARE(client.board().inUse(word), firmware >= 90 ? 2 : 0);
    if (firmware >= 90)
        QCOMPARE(client.board().inUse(77), firmware == 90 ? 1 : 0);
}

void TestStormFirmware::row16_word38Of79ReadsZero()
{
    for (const int firmware : {79, 96}) {
        ByteClient client(firmware);
        QCOMPARE(client.askRc(Rc::SetParameter, hex("26000200")), kAck);
        const int held = firmware == 79 ? 0 : 2;
        QCOMPARE(client.askRc(Rc::GetParameter, hex("2600")).mid(5, 2), QByteArray(1, char(held)) + '\0');
    }
}

void TestStormFirmware::row17_anyHeartbeatLocksOut()
{
    ByteClient client(96);
    client.askRc(Rc::SetParameter, hex("70000300"));
    QVERIFY(!client.ask("t", 100ms).contains('o'));
    client.ask(mavlink::encode(MessageId::Heartbeat, QByteArray(9, '\0'), {1, 1}, 0));
    QVERIFY(client.wait(2s).contains(hex("47431e")));  // ATTITUDE
}

void TestStormFirmware::row18_scriptsRunAtOnce()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    const int words = firmware == 79 ? 124 : 125;
    const int input = firmware == 79 ? 119 : 120;
    ScriptContext context{{{0, u"Pitch P"_s, false}}, firmware};
    const auto code = compileScripts(
        {u"CASE#DEFAULT\nSET \"Pitch P\" 500\nWAIT 10\nSET \"Pitch P\" 600\nWAIT 10\nREPEAT"_s, {}, {}, {}},
        context);
    QVERIFY(code);
    QByteArray stream = client.ask("g");
    stream.truncate(2 * words + kScriptArea);
    stream.replace(2 * words, kScriptArea, *code);
    const auto put = [&client](const QByteArray &bytes) {
        return client.ask(encodeSimple(Simple::PutParameters, bytes));
    };
    QCOMPARE(put(stream), "o");
    std::ignore = client.wait(1s);
    QCOMPARE(client.board().inUse(0), 400);  // without an input it does not run
    stream[2 * input] = 11;  // Virtual-1, where nothing is connected
    QCOMPARE(put(stream), "o");
    QTRY_VERIFY((std::ignore = client.wait(10ms), client.board().inUse(0) == 500));
    QTRY_VERIFY((std::ignore = client.wait(10ms), client.board().inUse(0) == 600));
    QTRY_VERIFY((std::ignore = client.wait(10ms), client.board().inUse(0) == 500));  // again
    QCOMPARE(client.board().stored(0), 400);
    QCOMPARE(client.ask("xs", 2s), "o");
    QVERIFY(client.board().stored(0) != 400);  // what the script set
}

void TestStormFirmware::row19_storingKeepsAllInUse()
{
    QFETCH(int, firmware);
    ByteClient client(firmware);
    client.askRc(Rc::SetParameter, hex("06004101"));
    QByteArray stream = client.ask("g");
    stream.truncate(stream.size() - 3);
    stream[0] = char(stream[0] + 1);
    QCOMPARE(client.ask(encodeSimple(Simple::PutParameters, stream)), "o");
    QCOMPARE(client.board().stored(6), 400);
    QCOMPARE(client.ask("xs", 2s), "o");
    QCOMPARE(client.board().stored(0), 401);
    QCOMPARE(client.board().stored(6), 0x141);
}

QTEST_GUILESS_MAIN(TestStormFirmware)
#include "tst_stormfirmware.moc"
