// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/checksum.h"
#include "protocol/storm32/framer.h"

#include <QTest>

#include <random>

using namespace Qt::StringLiterals;
using namespace storm32;

namespace {

QByteArray hex(const char *text)
{
    return QByteArray::fromHex(text);
}

struct Heard
{
    int id = 0;
    QByteArray payload;
    friend bool operator==(const Heard &, const Heard &) = default;
};

// Feeds in pieces of so many bytes and, at the end, lets it be silent.
QList<Heard> hear(storm32::Framer &framer, const QByteArray &bytes, int piece = 1)
{
    QList<Heard> heard;
    const auto sink = [&heard](const FrameView &frame) {
        heard.append({frame.id, toByteArray(frame.payload)});
    };
    for (qsizetype i = 0; i < bytes.size(); i += piece)
        framer.feed(asBytes(bytes.mid(i, piece)), sink);
    framer.flush(sink);
    return heard;
}

}  // namespace

/// Bytes of STorM32's three command sets, against what the errata work out.
class TestStormWire : public QObject
{
    Q_OBJECT
private slots:
    void checksums();
    void simpleCommandsAreKnown();
    void acksBecomeCauses_data();
    void acksBecomeCauses();
    void answersAreFound_data();
    void answersAreFound();
    void dataMayHoldAnything();
    void errorLettersInsteadOfData();
    void lateDataAreKnownByTheirChecksum();
    void ignoredQuestionsAreForgotten();
    void staleBytesBelongToNobody();
    void unfinishedMessageSurvivesACommand();
    void requestsTakeTheirAnswersOnly();
    void mavlinkTableIsWhole();
    void mavlinkFieldsSurvive();
    void parameterValuesByFirmware();
    void damageIsNeverTakenForAFrame();
};

void TestStormWire::checksums()
{
    QCOMPARE(crc16Mcrf4xx(asBytes("123456789")), 0x6F91);  // errata 2
    QCOMPARE(crc16Mcrf4xx(asBytes(hex("0001"))), 0xE131);
    QCOMPARE(crc16Mcrf4xx(asBytes(hex("02032f00"))), 0x75C8);
    QCOMPARE(crc16Mcrf4xx(asBytes(hex("0001"
                                      "31e1"))),
             0);  // over data and its own bytes
    const QByteArray bytes("a longer text, to get past eight bytes at once");
    QCOMPARE(crc16Mcrf4xx(asBytes(bytes.mid(7)), crc16Mcrf4xx(asBytes(bytes.left(7)))),
             crc16Mcrf4xx(asBytes(bytes)));
}

void TestStormWire::simpleCommandsAreKnown()
{
    QCOMPARE(encodeSimple(Simple::Test), "t");
    QCOMPARE(encodeSimple(Simple::SetBaudRate, hex("0400")),
             hex("7875"
                 "0400"
                 "d897"));  // errata 3.9
    for (const SimpleCommand &command : simpleCommands()) {
        QCOMPARE(findSimple(asBytes(QByteArrayView(command.letters))), &command);
        QCOMPARE(int(simpleCommand(command.id).id), int(command.id));
    }
    QCOMPARE(findSimple(asBytes("xs"))->id, Simple::Store);
    QVERIFY(!findSimple(asBytes("xZ")) && !findSimple(asBytes("T")));
    QCOMPARE(simpleRequest(Simple::GetParameters).replyBytes, 381);  // errata 3.4
    QCOMPARE(simpleRequest(Simple::LiveData).replyBytes, 67);
    QCOMPARE(simpleRequest(Simple::Version).replyBytes, 57);
    QCOMPARE(simpleRequest(Simple::ReadCalibration).replyBytes, 39);
    QCOMPARE(simpleRequest(Simple::RawSensors).replyBytes, 31);
}

void TestStormWire::acksBecomeCauses_data()
{
    QTest::addColumn<int>("ack");
    QTest::addColumn<int>("code");
    QTest::newRow("failed") << 1 << int(ErrorCode::BoardError);
    QTest::newRow("denied") << 2 << int(ErrorCode::BoardError);
    QTest::newRow("not supported") << 3 << int(ErrorCode::Unsupported);
    QTest::newRow("timeout") << 150 << int(ErrorCode::Damaged);
    QTest::newRow("checksum") << 151 << int(ErrorCode::Damaged);
    QTest::newRow("length") << 152 << int(ErrorCode::BoardError);
    QTest::newRow("range") << 153 << int(ErrorCode::OutOfRange);
    QTest::newRow("unknown") << 77 << int(ErrorCode::BoardError);
}

void TestStormWire::acksBecomeCauses()
{
    QFETCH(int, ack);
    QFETCH(int, code);
    const Request request = rcRequest(Rc::SetPwmOut, hex("dc05"));
    const QByteArray payload(1, char(ack));
    const auto answer = request.answer({FrameId::kRc + 150, asBytes(payload)});
    QVERIFY(answer && !*answer);
    QCOMPARE(int(answer->error().code), code);
    QCOMPARE(answer->error().boardCode, ack);
    QVERIFY(answer->error().detail.startsWith(u"SETPWMOUT"_s));
    const QByteArray ok(1, '\0');
    QVERIFY(request.answer({FrameId::kRc + 150, asBytes(ok)})->has_value());
}

void TestStormWire::answersAreFound_data()
{
    QTest::addColumn<int>("asked");
    QTest::addColumn<int>("words");
    QTest::newRow("version") << int(Simple::Version) << 27;
    QTest::newRow("parameters, layout 78") << int(Simple::GetParameters) << 188;
    QTest::newRow("parameters, layout 95") << int(Simple::GetParameters) << 189;
    QTest::newRow("live data") << int(Simple::LiveData) << 32;
    QTest::newRow("status") << int(Simple::Status) << 5;
    QTest::newRow("status, later") << int(Simple::Status) << 7;
    QTest::newRow("calibration") << int(Simple::ReadCalibration) << 18;
    QTest::newRow("raw sensors") << int(Simple::RawSensors) << 14;
}

void TestStormWire::answersAreFound()
{
    QFETCH(int, asked);
    QFETCH(int, words);
    std::mt19937 random(5);
    QByteArray data;
    for (int i = 0; i < 2 * words; ++i)
        data.append(char(random()));
    const QByteArray reply = encodeReply(data);
    QCOMPARE(reply.size(), 2 * words + 3);
    for (const int piece : {1, 3, 64, 1000}) {
        storm32::Framer framer;
        framer.sent(asBytes(encodeSimple(Simple(asked))));
        QCOMPARE(hear(framer, reply, piece), (QList<Heard>{{FrameId::kSimple + asked, data}}));
        QCOMPARE(framer.statistics().frames, quint64(1));
        QCOMPARE(framer.statistics().skippedBytes, quint64(0));
    }
}

// Letters, start bytes and whole frames are data like any other.
void TestStormWire::dataMayHoldAnything()
{
    for (const QByteArray &filler :
         {QByteArray("o"), QByteArray("etco"), hex("fb019600622e"), hex("fe0300"), hex("fa000131e1")}) {
        const QByteArray data = filler.repeated(70).left(64);
        storm32::Framer framer;
        framer.sent(asBytes("d"));
        // A whole frame of the other set at the very beginning cannot be told from one; elsewhere it can.
        const QByteArray safe = hex("0600") + data.left(62);
        QCOMPARE(hear(framer, encodeReply(safe), 5),
                 (QList<Heard>{{FrameId::kSimple + int(Simple::LiveData), safe}}));
    }
}

void TestStormWire::errorLettersInsteadOfData()
{
    for (const char letter : {'e', 't', 'c'}) {
        storm32::Framer framer;
        framer.sent(asBytes("g"));
        QList<int> ids;
        const auto sink = [&ids](const FrameView &frame) { ids.append(frame.id); };
        framer.feed(asBytes(QByteArray(1, letter)), sink);
        QVERIFY(ids.isEmpty() && framer.isWaiting());  // it may be the first byte of the data
        framer.flush(sink);
        QCOMPARE(ids, QList<int>{letter});
        QVERIFY(!framer.isWaiting());
    }
    // Without a question for data a letter is one at once, and several are several (errata 3.1: five bytes,
    // five letters).
    storm32::Framer framer;
    framer.sent(asBytes("t"));
    QList<int> ids;
    framer.feed(asBytes("oeeee"), [&ids](const FrameView &frame) { ids.append(frame.id); });
    QCOMPARE(ids, (QList<int>{'o', 'e', 'e', 'e', 'e'}));
}

// A board that answers later than anybody waits: other questions have been asked by then.
void TestStormWire::lateDataAreKnownByTheirChecksum()
{
    const QByteArray status = encodeReply(QByteArray(14, '\x11'));
    const QByteArray live = encodeReply(QByteArray(64, 'o'));
    const QByteArray version = hex("fb019600622e");  // an acknowledgement of the RC set
    for (const int piece : {1, 5, 200}) {
        storm32::Framer framer;
        framer.sent(asBytes(encodeSimple(Simple::Status)));
        framer.sent(asBytes(encodeSimple(Simple::LiveData)));
        framer.sent(asBytes(encodeRc(int(Rc::SetStandby), QByteArray(1, '\1'))));
        QList<int> ids;
        for (const Heard &each : hear(framer, version + status + live, piece))
            ids.append(each.id);
        QCOMPARE(ids,
                 (QList<int>{FrameId::kRc + int(Rc::Ack), FrameId::kSimple + int(Simple::Status),
                             FrameId::kSimple + int(Simple::LiveData)}));
        // Each came once: what looks like it now answers nothing.
        for (const Heard &each : hear(framer, status, piece))
            QVERIFY(each.id < FrameId::kSimple);
    }
}

// A heartbeat has locked plain commands out: data were asked for and will never come.
void TestStormWire::ignoredQuestionsAreForgotten()
{
    const QByteArray heartbeat = mavlink::encode(mavlink::MessageId::Heartbeat, QByteArray(9, '\1'), {}, 3);
    const QByteArray version = hex("fb019600622e");
    const auto idsOf = [](storm32::Framer &framer, const QByteArray &bytes, int piece) {
        QList<int> ids;
        for (const Heard &each : hear(framer, bytes, piece))
            ids.append(each.id);
        return ids;
    };
    for (const int piece : {1, 5, 200}) {
        storm32::Framer framer;
        framer.sent(asBytes(encodeSimple(Simple::LiveData)));
        framer.sent(asBytes(encodeSimple(Simple::Retrieve)));
        // What follows the letter is whole and checked, so it is no part of the data.
        QCOMPARE(idsOf(framer, "o" + heartbeat, piece),
                 (QList<int>{FrameId::kLetter + 'o', FrameId::kMavlink}));
        for (int i = 0; i < 64; ++i) {
            framer.sent(asBytes(encodeRc(int(Rc::SetStandby), QByteArray(1, '\1'))));
            QCOMPARE(idsOf(framer, version, piece), QList<int>{FrameId::kRc + int(Rc::Ack)});
        }
        // No silence is needed any more to know a letter.
        framer.sent(asBytes(encodeSimple(Simple::Retrieve)));
        QList<int> ids;
        framer.feed(asBytes(QByteArrayView("o")), [&ids](const FrameView &frame) { ids.append(frame.id); });
        QCOMPARE(ids, QList<int>{FrameId::kLetter + 'o'});
    }
}

void TestStormWire::staleBytesBelongToNobody()
{
    const QByteArray data(10, 'x');
    storm32::Framer framer;
    framer.sent(asBytes("d"));
    QList<Heard> heard = hear(framer, encodeReply(QByteArray(64, 'y')).left(40), 7);
    QVERIFY(heard.isEmpty());
    // Half an answer lies there when the next question goes out.
    framer.feed(asBytes("abc"), [](const FrameView &) {});
    framer.sent(asBytes("s"));
    heard = hear(framer, encodeReply(data), 4);
    QCOMPARE(heard, (QList<Heard>{{FrameId::kSimple + int(Simple::Status), data}}));
    // Noise in front of an answer.
    framer.sent(asBytes("s"));
    heard = hear(framer, "~~" + encodeReply(data), 4);
    QCOMPARE(heard, (QList<Heard>{{FrameId::kSimple + int(Simple::Status), data}}));
    // A heartbeat in front of it.
    const QByteArray beat = mavlink::encode(mavlink::MessageId::Heartbeat, QByteArray(9, '\1'), {}, 3);
    framer.sent(asBytes("s"));
    heard = hear(framer, beat + encodeReply(data), 9);
    QCOMPARE(heard.size(), 2);
    QCOMPARE(heard[0].id, FrameId::kMavlink);
    QCOMPARE(heard[1].payload, data);
    // Without end it does not fill the memory.
    framer.sent(asBytes("g"));
    for (int i = 0; i < 100; ++i)
        framer.feed(asBytes(QByteArray(1000, '~')), [](const FrameView &) {});
    QVERIFY(framer.statistics().skippedBytes > 98000);
}

// The board's texts are sent unasked, and hold letters that look like answers.
void TestStormWire::unfinishedMessageSurvivesACommand()
{
    const QByteArray payload
        = mavlink::encodeFields(*mavlink::findMessage(mavlink::number(mavlink::MessageId::StatusText)),
                                {{u"severity"_s, 6}, {u"text"_s, u"SToRM32 on the motor"_s}})
              .value();
    const QByteArray text = mavlink::encode(mavlink::MessageId::StatusText, payload, {71, 67}, 0);
    for (qsizetype cut = 1; cut < text.size(); ++cut) {
        storm32::Framer framer;
        QList<int> ids;
        const auto sink = [&ids](const FrameView &frame) { ids.append(frame.id); };
        framer.feed(asBytes(text.left(cut)), sink);
        framer.sent(asBytes(QByteArray("t")));
        framer.feed(asBytes(text.mid(cut)), sink);
        framer.feed(asBytes(QByteArray("o")), sink);
        QCOMPARE(ids, (QList<int>{FrameId::kMavlink + 253, FrameId::kLetter + 'o'}));
    }
}

void TestStormWire::requestsTakeTheirAnswersOnly()
{
    const QByteArray ten(10, '\0');
    const QByteArray four(4, '\0');
    const QByteArray six(6, '\0');
    const Request status = simpleRequest(Simple::Status);
    QVERIFY(status.answer({FrameId::kSimple + int(Simple::Status), asBytes(ten)})->has_value());
    QVERIFY(!status.answer({'o', {}}));  // data was due
    QVERIFY(!status.answer({FrameId::kSimple + int(Simple::LiveData), asBytes(ten)}));
    QCOMPARE(status.answer({'e', {}})->error().code, ErrorCode::Unsupported);
    QCOMPARE(status.answer({'c', {}})->error().boardCode, int('c'));
    const Request store = simpleRequest(Simple::Store);
    QVERIFY(store.answer({'o', {}})->has_value());
    const Request version = rcRequest(Rc::GetVersion);
    QVERIFY(version.answer({FrameId::kRc + 1, asBytes(six)})->has_value());  // errata 4: 01, not 00
    QVERIFY(!version.answer({FrameId::kRc + 3, asBytes(four)}));
    const QByteArray texts(48, 'a');
    for (const int number : {5, 2})  // by firmware
        QVERIFY(
            rcRequest(Rc::GetVersionStrings).answer({FrameId::kRc + number, asBytes(texts)})->has_value());
    QVERIFY(!rcRequest(Rc::GetData, QByteArray(1, '\0')).answer({FrameId::kRc + 5, asBytes(texts)}));
    QCOMPARE(version.answer({'t', {}})->error().boardCode, int('t'));
}

void TestStormWire::mavlinkTableIsWhole()
{
    // Errata 6: number, checksum seed, length.
    // clang-format off
    const QList<std::array<int, 3>> wanted{{0, 50, 9}, {20, 214, 20}, {21, 159, 2}, {22, 220, 25}, {23, 168, 23}, {30, 39, 28},
                                           {76, 152, 33}, {77, 143, 3}, {155, 22, 13}, {156, 19, 6}, {157, 21, 15}, {234, 152, 2},
                                           {235, 102, 2}, {236, 195, 4}, {237, 49, 9}, {238, 78, 11}, {253, 83, 51}};
    // clang-format on
    QCOMPARE(qsizetype(mavlink::messages().size()), wanted.size());
    for (const auto &[id, seed, size] : wanted) {
        const mavlink::Message *message = mavlink::findMessage(id);
        QVERIFY(message);
        QCOMPARE(int(message->crcExtra), seed);
        QCOMPARE(message->size, size);
        QCOMPARE(mavlink::findMessage(QString::fromLatin1(message->name)), message);
    }
    QVERIFY(!mavlink::findMessage(239) && !mavlink::findMessage(u"NONSENSE"_s));
    for (const int command : {180, 183, 203, 204, 205, 220, 245, 1234})
        QVERIFY(mavlink::commandName(command) != QString::number(command));
}

void TestStormWire::mavlinkFieldsSurvive()
{
    for (const mavlink::Message &message : mavlink::messages()) {
        QByteArray payload;
        for (int i = 0; i < message.size + (message.variable ? 7 : 0); ++i)
            payload.append(char('A' + i));
        const auto fields = mavlink::decodeFields(message, asBytes(payload));
        QVERIFY(fields);
        QCOMPARE(fields->size(), qsizetype(message.fields.size()));
        const auto again = mavlink::encodeFields(message, *fields);
        QVERIFY2(again && *again == payload, message.name);
        QVERIFY(!mavlink::decodeFields(message, asBytes(payload.left(message.size - 1))));
    }
    const mavlink::Message *set = mavlink::findMessage(23);
    QCOMPARE(mavlink::encodeFields(*set, {{u"param_id"_s, u"PID_PITCH_P"_s}})->mid(6, 12),
             QByteArray("PID_PITCH_P\0", 12));
    QVERIFY(!mavlink::encodeFields(*set, {{u"nonsense"_s, 1}}));
    QVERIFY(
        !mavlink::encodeFields(*mavlink::findMessage(234), {{u"specific_payload"_s, QByteArray(300, 'x')}}));
}

void TestStormWire::parameterValuesByFirmware()
{
    using mavlink::ValueCoding;
    QCOMPARE(mavlink::encodeValue(-250, ValueCoding::Number), 65286.0F);  // errata 6
    QCOMPARE(mavlink::decodeValue(65286.0F, ValueCoding::Number), 0xFF06);
    QCOMPARE(mavlink::decodeValue(-3.0F, ValueCoding::Number), 0);
    QCOMPARE(ByteWriter().f32(mavlink::encodeValue(-250, ValueCoding::Bits)).take().toHex(), "06ff0000");
    for (const int raw : {0, 1, 400, 32767, 32768, 65535}) {
        QCOMPARE(mavlink::decodeValue(mavlink::encodeValue(raw, ValueCoding::Bits), ValueCoding::Bits), raw);
        QCOMPARE(mavlink::decodeValue(mavlink::encodeValue(raw, ValueCoding::Number), ValueCoding::Number),
                 raw);
    }
    QCOMPARE(mavlink::decodeValue(std::nanf(""), ValueCoding::Number), 0);
}

void TestStormWire::damageIsNeverTakenForAFrame()
{
    std::mt19937 random(11);
    int wrong = 0;
    for (int round = 0; round < 3000; ++round) {
        storm32::Framer framer;
        framer.sent(asBytes("d"));
        QByteArray data(64, '\0');
        for (char &byte : data)
            byte = char(random());
        QByteArray reply = encodeReply(data);
        reply[qsizetype(random() % 67)] ^= char(1 << random() % 8);
        for (const Heard &heard : hear(framer, reply, 16))
            wrong += heard.id >= 0x100 ? 1 : 0;
    }
    QCOMPARE(wrong, 0);
}

QTEST_GUILESS_MAIN(TestStormWire)
#include "tst_stormwire.moc"
