// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/checksum.h"
#include "protocol/bcflight/framer.h"
#include "protocol/bcflight/infotext.h"
#include "protocol/bcflight/luadoubts.h"
#include "protocol/bcflight/luatext.h"
#include "protocol/bcflight/payloads.h"
#include "tests/unit/bcflightvectors.h"

#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace Qt::StringLiterals;
using namespace bcflight;

namespace {

struct Seen
{
    int id = 0;
    QByteArray payload;
};

/// What a framer finds in packets.
std::vector<Seen> found(const QList<QByteArray> &packets, FramerStatistics *statistics = nullptr)
{
    bcflight::Framer framer;
    std::vector<Seen> seen;
    const FrameSink sink = [&seen](const FrameView &frame) {
        seen.push_back({frame.id, toByteArray(frame.payload)});
    };
    for (const QByteArray &packet : packets) {
        framer.feed(asBytes(packet), sink);
        framer.packetEnded(sink);
    }
    if (statistics)
        *statistics = framer.statistics();
    return seen;
}

Generation generationOf(char letter)
{
    return Generation(letter - 'A' + 1);
}

// As sections 7.2 and 13 of the errata show them, with traps beside.
const QByteArray kConfiguration = R"lua(-- pid_roll = PID( 1, 2, 3 )
PID.pscale = 0.032029 * 0.0005
PID.iscale = 1.221905e-4
--[[ PID.dscale = 7
]] PID.dscale=2.645e-7
name = "pid_yaw = PID( 9, 9, 9 )"
stabilizer = Stabilizer {
    pid_roll = PID( 36, 50, 8 ),
	pid_pitch=PID(  37 ,51,8.5  ), -- pid_pitch
    pid_yaw = PID( 40, 50 ),
    pid_horizon = PID( 150, 0, 0 ),
    pid_horizon = PID( 151, 0, 0 ),
}
frame.motors = {
    PWM( 18 ):mix( Vector( 1, -1, -1, 1 ) ),
    PWM( 23 ):mix( Vector( -1.0, -1, 1, 1 ) ),
    PWM( 24 ):mix( Vector( 1, 1, 1, 1 ) ),
    PWM( 25 ):mix( Vector( -1, 1, -1, 1 ) ),
}
)lua";

}  // namespace

class TestBcflightWire final : public QObject
{
    Q_OBJECT

private slots:
    void checksumIsCastagnoli();
    void messagesAreWhatTheErrataSay_data();
    void messagesAreWhatTheErrataSay();
    void everyMessageHasItsVector();
    void idsAreUnique_data();
    void idsAreUnique();
    void sticksAreWhatTheErrataSay();
    void oddSticksAreHarmless();
    void rangesAreChecked();
    void packetsAreLists();
    void bothFormsOfIdsAreUnderstood();
    void paddingIsNothing();
    void acknowledgementsHaveTheirNumber();
    void unknownEndsItsPacket();
    void deadIdsEndTheirPacket_data();
    void deadIdsEndTheirPacket();
    void everyMessageSaysWhenItMayBeSent();
    void truncatedIsNoMessage();
    void streamsOfBytesAreReassembled();
    void longTextComesInTwoDatagrams();
    void countsOfThePeerAreBounded();
    void oldConfigurationIsNoCameraText();
    void anyBytesAreSurvived();
    void damagedTextIsRefused();
    void infoIsRead_data();
    void infoIsRead();
    void recordingsAreListed();
    void gainsAreFoundOnce();
    void gainsAreReplacedByteForByte();
    void otherThanPlainIsRefused_data();
    void otherThanPlainIsRefused();
    void motorsAreFound();
    void entriesAreCounted();
    void doubtsAreFound_data();
    void doubtsAreFound();
    void lossesAreDoubted();
    void nothingIsDoubtedWithoutCause_data();
    void nothingIsDoubtedWithoutCause();
};

void TestBcflightWire::checksumIsCastagnoli()
{
    QCOMPARE(crc32c(asBytes("123456789")), 0xE3069283U);
    QCOMPARE(crc32c(asBytes("6789"), crc32c(asBytes("12345"))), 0xE3069283U);
    QCOMPARE(crc32c({}), 0U);
}

void TestBcflightWire::messagesAreWhatTheErrataSay_data()
{
    QTest::addColumn<int>("number");
    int number = 0;
    for (const BcflightVector &vector : kBcflightVectors)
        QTest::addRow("%s from %c in %s, %.12s", vector.name, vector.from, vector.generations, vector.hex)
            << number++;
}

void TestBcflightWire::messagesAreWhatTheErrataSay()
{
    QFETCH(int, number);
    const BcflightVector &vector = kBcflightVectors[number];
    const QByteArray bytes = QByteArray::fromHex(vector.hex);
    const MessageSpec *message = findMessage(QString::fromLatin1(vector.name));
    QVERIFY(message);
    if (vector.from == 'g') {
        QVERIFY(message->fromGround);
        const auto payload = encodeFields(*message->fromGround, vector.numbers, vector.text);
        QVERIFY2(payload, payload ? "" : qPrintable(payload.error().detail));
        for (const char *letter = vector.generations; *letter; ++letter) {
            const Generation generation = generationOf(*letter);
            QCOMPARE(encode(message->id, *payload, generation).toHex(), bytes.toHex());
            const int wire = bytes.size() > 0 && (bytes[0] & 0x80) ? quint8(bytes[0])
                                                                   : quint8(bytes[0]) << 8 | quint8(bytes[1]);
            QCOMPARE(groundMessage(wire, generation), std::optional(message->id));
        }
        return;
    }
    QVERIFY(message->fromDrone);
    FramerStatistics statistics;
    const auto seen = found({bytes}, &statistics);
    QCOMPARE(seen.size(), std::size_t(1));
    QCOMPARE(seen.front().id, int(message->id));
    QCOMPARE(statistics.skippedBytes, quint64(0));
    std::vector<double> numbers;
    QByteArray text;
    for (const FieldValue &value : decodeFields(*message->fromDrone, asBytes(seen.front().payload))) {
        if (value.spec->type == FieldType::Text)
            text = value.bytes;
        else if (value.numbers.empty())
            numbers.push_back(value.number);
        for (const float one : value.numbers)
            numbers.push_back(double(one));
    }
    QCOMPARE(numbers, vector.numbers);
    QCOMPARE(text, QByteArray(vector.text));
}

void TestBcflightWire::everyMessageHasItsVector()
{
    for (const MessageSpec &message : messages()) {
        if (message.id == Message::Unknown || message.id == Message::Ack || message.id == Message::Controls)
            continue;  // tested below
        for (const char from : {'g', 'd'}) {
            const bool isSent = from == 'g' ? message.fromGround.has_value() : message.fromDrone.has_value();
            const bool isThere = std::any_of(
                std::begin(kBcflightVectors), std::end(kBcflightVectors), [&](const BcflightVector &each) {
                    return each.from == from && qstrcmp(each.name, message.name) == 0;
                });
            QVERIFY2(isSent == isThere,
                     qPrintable(u"%1 %2"_s.arg(QLatin1String(message.name)).arg(QLatin1Char(from))));
        }
    }
}

void TestBcflightWire::idsAreUnique_data()
{
    QTest::addColumn<int>("generation");
    for (int generation = int(Generation::A); generation <= int(Generation::G); ++generation)
        QTest::addRow("%c", 'A' + generation - 1) << generation;
}

void TestBcflightWire::idsAreUnique()
{
    QFETCH(int, generation);
    QSet<int> ids;
    for (const MessageSpec &message : messages()) {
        const int wire = wireId(message.id, Generation(generation));
        if (wire < 0)
            continue;
        QVERIFY2(!ids.contains(wire), message.name);
        ids.insert(wire);
    }
    // Errata 1: what a generation does not know yet.
    QCOMPARE(wireId(Message::MotorsBeep, Generation(generation)) >= 0, generation >= int(Generation::D));
    QCOMPARE(wireId(Message::GetCamerasInfos, Generation(generation)) >= 0, generation >= int(Generation::B));
}

void TestBcflightWire::sticksAreWhatTheErrataSay()
{
    for (const BcflightSticks &sticks : kBcflightSticks) {
        const Generation generation = generationOf(sticks.generation);
        const Controls controls{sticks.thrust, sticks.roll, sticks.pitch,
                                sticks.yaw,    sticks.arm,  sticks.smoothing};
        const QByteArray payload = controls.encode(generation);
        QCOMPARE(payload.toHex(), QByteArray(sticks.hex));
        const auto back = Controls::decode(asBytes(payload), generation);
        QVERIFY(back);
        QCOMPARE(back->arm, sticks.arm);
        QVERIFY(std::abs(back->roll - sticks.roll) < 0.01);
        QVERIFY(std::abs(back->thrust - sticks.thrust) < 0.01);
    }
}

void TestBcflightWire::oddSticksAreHarmless()
{
    const double none = std::nan("");
    QCOMPARE((Controls{none, none, none, none}).encode(Generation::G), QByteArray(6, '\0'));
    QCOMPARE((Controls{-5, 7, -7, 1e30}).encode(Generation::G),
             (Controls{0, 1, -1, 1}).encode(Generation::G));
    QCOMPARE((Controls{-5, 7, -7, 1e30}).encode(Generation::A),
             (Controls{0, 1, -1, 1}).encode(Generation::A));
    QVERIFY(!Controls::decode(asBytes(QByteArrayView("12345")), Generation::G));
}

void TestBcflightWire::rangesAreChecked()
{
    const auto gain = *findMessage(Message::SetRollP)->fromGround;
    QVERIFY(encodeFields(gain, {1.0}));
    QCOMPARE(encodeFields(gain, {1.0001}).error().code, ErrorCode::OutOfRange);
    QCOMPARE(encodeFields(gain, {std::nan("")}).error().code, ErrorCode::InvalidArgument);
    QCOMPARE(encodeFields(gain, {}).error().code, ErrorCode::InvalidArgument);
    QCOMPARE(encodeFields(*findMessage(Message::SetHorizonOffset)->fromGround, {0, 46}).error().code,
             ErrorCode::OutOfRange);
    QCOMPARE(encodeFields(*findMessage(Message::SetMode)->fromGround, {2}).error().code,
             ErrorCode::OutOfRange);
}

void TestBcflightWire::packetsAreLists()
{
    // The reply to CALIBRATE (errata 13).
    const auto seen = found({QByteArray::fromHex("0060 00000003 0061 00000001")});
    QCOMPARE(seen.size(), std::size_t(2));
    QCOMPARE(seen[0].id, int(Message::Calibrate));
    QCOMPARE(seen[1].id, int(Message::Calibrating));
    // The answer of the oldest generations to PING (errata 1).
    const auto old = found({QByteArray::fromHex("81 12340007 80 00000002 82 00000000000000000000")});
    QCOMPARE(old.size(), std::size_t(3));
    QCOMPARE(old[1].id, int(Message::Status));
    QCOMPARE(old[2].id, int(Message::Telemetry));
    // Behind a text.
    QCOMPARE(found({QByteArray::fromHex("0069 4100 85 00000001")}).size(), std::size_t(2));
}

void TestBcflightWire::bothFormsOfIdsAreUnderstood()
{
    for (const char *hex : {"a300000001", "00a300000001"}) {
        const auto seen = found({QByteArray::fromHex(hex)});
        QCOMPARE(seen.size(), std::size_t(1));
        QCOMPARE(seen.front().id, int(Message::VideoStartRecord));
    }
}

void TestBcflightWire::paddingIsNothing()
{
    FramerStatistics statistics;
    const auto seen = found({QByteArray::fromHex("0000 85 00000002 0000 00")}, &statistics);
    QCOMPARE(seen.size(), std::size_t(1));
    QCOMPARE(statistics.skippedBytes, quint64(0));
}

void TestBcflightWire::acknowledgementsHaveTheirNumber()
{
    QCOMPARE(encodeAck(5), QByteArray::fromHex("0605"));
    const auto seen = found({QByteArray::fromHex("0605 0605")});
    QCOMPARE(seen.size(), std::size_t(1));
    QCOMPARE(seen.front().id, int(Message::Ack) + 5);
    // Other ids have those bits as well (errata 5).
    QCOMPARE(found({QByteArray::fromHex("7f01")}).front().id, int(Message::CameraMissing));
    QCOMPARE(found({QByteArray::fromHex("0680 0680")}).front().id, kDiscarded);
}

void TestBcflightWire::unknownEndsItsPacket()
{
    FramerStatistics statistics;
    const auto seen = found(
        {QByteArray::fromHex("85 00000002 0199 8500000001"), QByteArray::fromHex("8500000001")}, &statistics);
    QCOMPARE(seen.size(), std::size_t(3));
    QCOMPARE(seen[1].id, kDiscarded);
    QCOMPARE(seen[1].payload, QByteArray::fromHex("01998500000001"));
    QCOMPARE(seen[2].id, int(Message::Status));
    QCOMPARE(statistics.headerErrors, quint64(1));
    QCOMPARE(statistics.skippedBytes, quint64(7));
}

void TestBcflightWire::deadIdsEndTheirPacket_data()
{
    QTest::addColumn<QByteArray>("id");
    const auto row = [](const char *name, const char *id) { QTest::newRow(name) << QByteArray::fromHex(id); };
    row("CONNECT", "84");
    row("PRESSURE", "0010");
    row("TEMPERATURE", "0011");
    row("ROLL", "0013");
    row("PITCH", "0014");
    row("YAW", "0015");
    row("SENSORS_DATA", "0020");
}

// Errata 6: known by name, and nobody knows how long they are.
void TestBcflightWire::deadIdsEndTheirPacket()
{
    QFETCH(QByteArray, id);
    const MessageSpec *message = findMessage(QString::fromLatin1(QTest::currentDataTag()));
    QVERIFY(message && !message->fromGround && !message->fromDrone);
    QCOMPARE(int(message->id), readId(asBytes(id))->wire);
    for (int generation = int(Generation::A); generation <= int(Generation::G); ++generation)
        QVERIFY(!groundMessage(int(message->id), Generation(generation)));
    FramerStatistics statistics;
    const QByteArray rest = id + QByteArray::fromHex("3f800000 8500000001");
    const auto seen
        = found({QByteArray::fromHex("8500000002") + rest, QByteArray::fromHex("8500000001")}, &statistics);
    QCOMPARE(seen.size(), std::size_t(3));
    QCOMPARE(seen[0].payload, QByteArray::fromHex("00000002"));
    QCOMPARE(seen[1].id, kDiscarded);
    QCOMPARE(seen[1].payload, rest);
    QCOMPARE(seen[2].payload, QByteArray::fromHex("00000001"));
    QCOMPARE(statistics.headerErrors, quint64(1));
    QCOMPARE(statistics.skippedBytes, quint64(rest.size()));
}

// Errata 9.2, 4, 5 and 7.
void TestBcflightWire::everyMessageSaysWhenItMayBeSent()
{
    const auto are = [](MaySend when, std::initializer_list<Message> ids) {
        for (const Message id : ids) {
            if (findMessage(id)->maySend != when)
                return false;
        }
        return true;
    };
    using enum Message;
    QVERIFY(are(MaySend::Disarmed,
                {MotorTest, CalibrateEscs, MotorsBeep, SetConfigFile, UploadInit, UploadData, UploadProcess,
                 SetMode, SetHorizonOffset, Calibrate}));
    QVERIFY(are(MaySend::Tuning,
                {SetRollP, SetRollI, SetRollD, SetPitchP, SetPitchI, SetPitchD, SetYawP, SetYawI, SetYawD,
                 SetOuterP, SetOuterI, SetOuterD}));
    QVERIFY(are(MaySend::Anytime, {ResetMotors, Status, Message::Ping, Message::Telemetry}));
    QVERIFY(are(MaySend::Steering, {Message::Controls}));
    for (const MessageSpec &message : messages()) {
        const bool isNever = !message.fromGround || (message.id >= SetRoll && message.id <= SetThrust);
        QVERIFY2((message.maySend == MaySend::Never) == isNever, message.name);
    }
}

void TestBcflightWire::truncatedIsNoMessage()
{
    FramerStatistics statistics;
    const auto seen = found(
        {QByteArray::fromHex("85 0000"), QByteArray::fromHex("00"), QByteArray::fromHex("01")}, &statistics);
    QCOMPARE(seen.size(), std::size_t(2));
    QCOMPARE(seen[0].id, kDiscarded);
    QCOMPARE(seen[1].id, kDiscarded);
    QCOMPARE(statistics.bodyErrors, quint64(1));
    // A text whose end is missing is one.
    const auto text = found({QByteArray::fromHex("0069 4142")});
    QCOMPARE(text.size(), std::size_t(1));
    QCOMPARE(text.front().payload, QByteArray("AB"));
}

// TCP: no boundaries at all.
void TestBcflightWire::streamsOfBytesAreReassembled()
{
    const QByteArray bytes = QByteArray::fromHex("85 00000002 0069 41424300 00")
        + QByteArray::fromHex("1a 00000001 3f000000") + QByteArray::fromHex("85 00000001");
    bcflight::Framer framer;
    std::vector<int> ids;
    const FrameSink sink = [&ids](const FrameView &frame) { ids.push_back(frame.id); };
    for (const char byte : bytes)
        framer.feed(asBytes(QByteArrayView(&byte, 1)), sink);
    QCOMPARE(ids,
             (std::vector<int>{int(Message::Status), int(Message::GetBoardInfos), int(Message::MotorsSpeed),
                               int(Message::Status)}));
    QVERIFY(!framer.isWaiting());
    framer.feed(asBytes(QByteArrayView("\x85\x00", 2)), sink);
    QVERIFY(framer.isWaiting());
    framer.flush(sink);
    QVERIFY(!framer.isWaiting());
}

void TestBcflightWire::longTextComesInTwoDatagrams()
{
    const QByteArray text(100000, 'x');
    const QByteArray packet = QByteArray::fromHex("0070") + encodeChecked(text);
    const auto seen = found({packet.first(65000), packet.sliced(65000)});
    QCOMPARE(seen.size(), std::size_t(1));
    QCOMPARE(seen.front().id, int(Message::GetConfigFile));
    QCOMPARE(*decodeChecked(asBytes(seen.front().payload)), text);
}

void TestBcflightWire::countsOfThePeerAreBounded()
{
    bcflight::Framer framer;
    std::vector<int> ids;
    const FrameSink sink = [&ids](const FrameView &frame) { ids.push_back(frame.id); };
    framer.feed(asBytes(QByteArray::fromHex("001affffffff")), sink);
    for (int i = 0; i < 40; ++i)
        framer.feed(asBytes(QByteArray(4096, 'x')), sink);
    QCOMPARE(ids, std::vector<int>{kDiscarded});
    QVERIFY(!framer.isWaiting());
}

void TestBcflightWire::oldConfigurationIsNoCameraText()
{
    const QByteArray text = "camera = 1";
    const auto old = found({QByteArray::fromHex("006b") + encodeChecked(text)});
    QCOMPARE(old.size(), std::size_t(1));
    QCOMPARE(old.front().id, int(Message::GetConfigFile));
    QCOMPARE(*decodeChecked(asBytes(old.front().payload)), text);
    QCOMPARE(found({QByteArray::fromHex("006b") + "nil" + '\0'}).front().id, int(Message::GetCamerasInfos));
}

void TestBcflightWire::anyBytesAreSurvived()
{
    quint32 state = 1;
    const auto next = [&state] { return state = state * 1664525 + 1013904223; };
    for (int round = 0; round < 3000; ++round) {
        QByteArray bytes;
        for (auto left = next() % 200; left > 0; --left)
            bytes.append(char(next() >> 24));
        bcflight::Framer framer;
        quint64 taken = 0;
        const FrameSink sink = [&taken](const FrameView &frame) {
            taken += frame.raw.size();
            if (const MessageSpec *message = findMessage(Message(frame.id)); message && message->fromDrone)
                std::ignore = decodeFields(*message->fromDrone, frame.payload);
        };
        framer.feed(asBytes(bytes), sink);
        framer.packetEnded(sink);
        QVERIFY(taken <= quint64(bytes.size()));
        QVERIFY(!framer.isWaiting());
        int damaged = 0;
        std::ignore = readInfo(bytes);
        std::ignore = readRecordings(bytes, damaged);
        std::ignore = findGains(bytes, u"pid_roll"_s);
        std::ignore = findMotors(bytes);
        std::ignore = decodeChecked(asBytes(bytes));
    }
}

void TestBcflightWire::damagedTextIsRefused()
{
    QByteArray payload = encodeChecked("text");
    QCOMPARE(*decodeChecked(asBytes(payload)), QByteArray("text"));
    payload[5] = 'X';
    QCOMPARE(decodeChecked(asBytes(payload)).error().code, ErrorCode::Damaged);
    QCOMPARE(decodeChecked(asBytes(QByteArrayView("abc"))).error().code, ErrorCode::Damaged);
}

void TestBcflightWire::infoIsRead_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("told");
    QTest::newRow("board") << QByteArray(
        "{\n    [\"Type\"] = \"Raspberry Pi\",\n    [\"CPU cores count\"] = \"4\",\n}\n")
                           << u"Type=Raspberry Pi CPU cores count=4"_s;
    QTest::newRow("lines") << QByteArray("Type:generic\nOS:Linux: 6\n") << u"Type=generic OS=Linux: 6"_s;
    QTest::newRow("nested") << QByteArray("{\n    Accelerometers = {\n        [\"ICM-42605\"] = {\n          "
                                          "  bus = {\n                speed = 1000000,\n"
                                          "            },\n        },\n    },\n    Altimeters = nil,\n}")
                            << u"Accelerometers{ICM-42605{bus{speed=1000000}}} Altimeters=nil"_s;
    QTest::newRow("named") << QByteArray("Sensors = { a = \"b\" }") << u"a=b"_s;
    QTest::newRow("quotes inside") << QByteArray("{ a = \"one \"two\" three\", b = 1 }")
                                   << u"a=one \"two\" three b=1"_s;
    QTest::newRow("list") << QByteArray("{ \"x\", \"y\" }") << u"1=x 2=y"_s;
    QTest::newRow("nil") << QByteArray("nil") << u""_s;
    QTest::newRow("empty table") << QByteArray("{\n}") << u""_s;
    QTest::newRow("unfinished") << QByteArray("{ a = {") << u"?"_s;
    QTest::newRow("code") << QByteArray("os.execute('rm')") << u"?"_s;
    QTest::newRow("too deep") << QByteArray(QByteArray("{a=").repeated(100) + "1"
                                            + QByteArray("}").repeated(100))
                              << u"?"_s;
}

void TestBcflightWire::infoIsRead()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, told);
    const std::function<QString(const QList<InfoNode> &)> tell = [&tell](const QList<InfoNode> &nodes) {
        QStringList parts;
        for (const InfoNode &node : nodes)
            parts.append(node.children.isEmpty() ? node.name + u'=' + node.value
                                                 : node.name + u'{' + tell(node.children) + u'}');
        return parts.join(u' ');
    };
    const auto info = readInfo(text);
    QCOMPARE(info ? tell(*info) : u"?"_s, told);
}

void TestBcflightWire::recordingsAreListed()
{
    int damaged = -1;
    const auto list = readRecordings("name:1234:::;.:0:::;..:0:::;b.h264:5:1:2:3:QUJD;broken;", damaged);
    QCOMPARE(list, (QList<RecordingEntry>{{u"name"_s, 1234, {}}, {u"b.h264"_s, 5, u"QUJD"_s}}));
    QCOMPARE(damaged, 1);
    QVERIFY(readRecordings(";", damaged).isEmpty());
    QCOMPARE(damaged, 0);
}

void TestBcflightWire::gainsAreFoundOnce()
{
    const auto roll = findGains(kConfiguration, u"pid_roll"_s);
    QVERIFY2(roll, roll ? "" : qPrintable(roll.error().detail));
    QCOMPARE((*roll)[0].value, 36.0);
    QCOMPARE((*roll)[1].value, 50.0);
    QCOMPARE((*roll)[2].value, 8.0);
    const auto pitch = findGains(kConfiguration, u"pid_pitch"_s);
    QVERIFY(pitch);
    QCOMPARE((*pitch)[2].value, 8.5);
    const auto scales = findScales(kConfiguration);
    QVERIFY2(scales, scales ? "" : qPrintable(scales.error().detail));
    QCOMPARE((*scales)[0], 0.032029 * 0.0005);
    QCOMPARE((*scales)[1], 1.221905e-4);
    QCOMPARE((*scales)[2], 2.645e-7);
    QCOMPARE(*findScale("x = 1", u"PID.pscale"_s), 1.0);
}

void TestBcflightWire::gainsAreReplacedByteForByte()
{
    const auto pitch = findGains(kConfiguration, u"pid_pitch"_s);
    QVERIFY(pitch);
    QByteArray wanted = kConfiguration;
    wanted.replace("PID(  37 ,51,8.5  )", "PID(  37 ,52.25,8.5  )");
    QCOMPARE(replaced(kConfiguration, (*pitch)[1], 52.25), wanted);
    QCOMPARE(replaced("a 1 b", {2, 3, 1}, double(0.1F)), QByteArray("a 0.1 b"));
    QCOMPARE(replaced("a 1 b", {2, 3, 1}, double(1.0F / 3)).split(' ').at(1).toFloat(), 1.0F / 3);
}

void TestBcflightWire::otherThanPlainIsRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("says");
    QTest::newRow("twice") << kConfiguration << u"pid_horizon"_s << u"lines 11, 12"_s;
    QTest::newRow("two numbers") << kConfiguration << u"pid_yaw"_s << u"line 10"_s;
    QTest::newRow("not there") << kConfiguration << u"pid_other"_s << u"not set"_s;
    QTest::newRow("part of a name") << QByteArray("my_pid_roll = PID(1,2,3)") << u"pid_roll"_s
                                    << u"not set"_s;
    QTest::newRow("a name inside") << QByteArray("pid_roll = PID( p, 2, 3 )") << u"pid_roll"_s << u"line 1"_s;
    QTest::newRow("computed") << QByteArray("pid_roll = PID( 1 + 1, 2, 3 )") << u"pid_roll"_s << u"line 1"_s;
    QTest::newRow("hexadecimal") << QByteArray("pid_roll = PID( 0x10, 2, 3 )") << u"pid_roll"_s
                                 << u"line 1"_s;
    QTest::newRow("compared") << QByteArray("if pid_roll == PID(1,2,3) then end") << u"pid_roll"_s
                              << u"not set"_s;
}

void TestBcflightWire::otherThanPlainIsRefused()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, name);
    QFETCH(QString, says);
    const auto gains = findGains(text, name);
    QVERIFY(!gains);
    QCOMPARE(gains.error().code, ErrorCode::ConditionUnmet);
    QVERIFY2(gains.error().detail.contains(says), qPrintable(gains.error().detail));
    QVERIFY(!findScale("PID.pscale = 2 * x", u"PID.pscale"_s));
    QVERIFY(!findScale("PID.pscale = 2 + 3", u"PID.pscale"_s));
}

void TestBcflightWire::motorsAreFound()
{
    const auto motors = findMotors(kConfiguration);
    QCOMPARE(motors.size(), std::size_t(4));
    QCOMPARE(motors[1], (MotorMix{-1, -1, 1, 1}));
    QVERIFY(findMotors("Vector( 1, 2, 3 )").empty());
}

void TestBcflightWire::entriesAreCounted()
{
    QCOMPARE(countEntries("motors = { DShot( 1, 2 ), PWM{ a = 1, b = 2 }; x, }", u"motors"_s),
             std::optional(3));
    QCOMPARE(countEntries("motors = { -- a, b\n }", u"motors"_s), std::optional(0));
    QVERIFY(!countEntries("motors = build()", u"motors"_s));
    QVERIFY(!countEntries("motors = { a }\nmotors = { b }", u"motors"_s));
    QVERIFY(!countEntries("motors = { a", u"motors"_s));
}

void TestBcflightWire::doubtsAreFound_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    QTest::addColumn<QString>("says");
    QTest::addColumn<int>("line");
    const int first = 15;  // the first row of the mixing
    const QByteArray mixed = "Vector( 1, -1, -1, 1 ) ),\n    PWM( 23 ):mix( Vector( -1.0, -1, 1, 1 ) ),\n"
                             "    PWM( 24 ):mix( Vector( 1, 1, 1, 1 ) ),\n"
                             "    PWM( 25 ):mix( Vector( -1, 1, -1, 1 )";
    const QByteArray alike = "Vector( -1, -1, -1, 1 ) ),\n    PWM( 23 ):mix( Vector( -1.0, -1, 1, 1 ) ),\n"
                             "    PWM( 24 ):mix( Vector( 1, 1, 1, 1 ) ),\n"
                             "    PWM( 25 ):mix( Vector( 1, 1, -1, 1 )";
    QTest::newRow("axes alike") << mixed << alike << u"roll and pitch drive the motors alike"_s << first;
    QTest::newRow("sign") << QByteArray("Vector( 1, -1, -1, 1 )") << QByteArray("Vector( -1, -1, -1, 1 )")
                          << u"roll add up to -2"_s << first;
    QTest::newRow("beyond 1") << QByteArray("Vector( -1.0, -1, 1, 1 )")
                              << QByteArray("Vector( -1.0, -1, 1.5, 1 )") << u"motor 2 is beyond 1: 1.5"_s
                              << first + 1;
    QTest::newRow("no lift") << QByteArray("Vector( 1, 1, 1, 1 )") << QByteArray("Vector( 1, 1, 1, 0 )")
                             << u"motor 3 does not lift"_s << first + 2;
    QTest::newRow("a row less") << QByteArray("PWM( 25 ):mix( Vector( -1, 1, -1, 1 ) )")
                                << QByteArray("PWM( 25 )") << u"3 rows for 4 motors"_s << first;
    const QByteArray end = "frame.motors";
    const auto with = [&end](const QByteArray &text) { return text + '\n' + end; };
    QTest::newRow("command") << end << with("os.execute \"reboot\"") << u"os.execute acts"_s << first - 1;
    QTest::newRow("by another name") << end << with("local run = os . execute") << u"os.execute acts"_s
                                     << first - 1;
    QTest::newRow("by a key") << end << with("os[ \"exit\" ]()") << u"os[ acts"_s << first - 1;
    QTest::newRow("reboot") << end << with("Board.reboot()") << u"reboot acts"_s << first - 1;
    QTest::newRow("in a function") << end << with("on = function() os.exit( 1 ) end")
                                   << u"os.exit acts on the drone's computer when this function"_s
                                   << first - 1;
    QTest::newRow("endless") << end << with("while true do x = 1 end") << u"never ends"_s << first - 1;
    QTest::newRow("endless, repeated")
        << end << with("repeat if x then y() end until false") << u"never ends"_s << first - 1;
    QTest::newRow("ends the loading") << end << with("error( \"no\" )") << u"ends the loading"_s << first - 1;
}

void TestBcflightWire::doubtsAreFound()
{
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    QFETCH(QString, says);
    QFETCH(int, line);
    QCOMPARE(int(findDoubts(kConfiguration).size()), 0);
    QVERIFY(kConfiguration.contains(before));
    QByteArray text = kConfiguration;
    text.replace(before, after);
    QStringList found;
    bool isThere = false;
    for (const ScriptMistake &doubt : findDoubts(text)) {
        const QString sentence = doubt.sentence(QString::fromUtf8(doubt.what));
        found.append(u"%1: %2"_s.arg(doubt.line).arg(sentence));
        isThere |= doubt.line == line && sentence.contains(says);
    }
    QVERIFY2(isThere, qPrintable(found.join(u'\n')));
}

// What the drone lives by is not dropped unnoticed.
void TestBcflightWire::lossesAreDoubted()
{
    const QByteArray before
        = kConfiguration + "controller = Controller {\n\tlink = Socket{ port = 2020 },\n}\n";
    const auto told = [&before](const QByteArray &text) {
        QStringList found;
        for (const ScriptMistake &doubt : findDoubts(text, before))
            found.append(doubt.sentence(QString::fromUtf8(doubt.what)));
        return found.join(u'\n');
    };
    QCOMPARE(told(before), QString());
    QVERIFY2(told("x = 1").contains(QRegularExpression(u"no more in this one: .*stabilizer"_s)),
             qPrintable(told("x = 1")));
    QVERIFY2(told(kConfiguration).contains(u"no more in this one: controller."_s),
             qPrintable(told(kConfiguration)));
    QByteArray moved = before;
    moved.replace("port = 2020", "port = 2021");
    QVERIFY2(told(moved).contains(u"ports change from"_s), qPrintable(told(moved)));
    QByteArray quiet = before;
    quiet.replace("stabilizer =", "-- stabilizer =");
    QVERIFY2(told(quiet).contains(u"no more in this one: stabilizer."_s), qPrintable(told(quiet)));
    // Set otherwise, it is set.
    QByteArray otherwise = before;
    otherwise.replace("stabilizer =", "local unused = 1\nstabilizer  =");
    QCOMPARE(told(otherwise), QString());
}

// What only looks like it, and what has a way out.
void TestBcflightWire::nothingIsDoubtedWithoutCause_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("comment") << QByteArray("-- os.execute( \"reboot\" )");
    QTest::newRow("string") << QByteArray("name = \"os.execute\"");
    QTest::newRow("another's field") << QByteArray("os.time() exit = 1 cost = costs.execute");
    QTest::newRow("a function of that name") << QByteArray("function reboot() return 1 end");
    QTest::newRow("left") << QByteArray("while true do if x then break end end");
    QTest::newRow("in a function") << QByteArray("run = function() while true do wait() end end");
    QTest::newRow("ends") << QByteArray("while x < 3 do x = x + 1 end repeat until y");
    QTest::newRow("guarded error") << QByteArray("if not x then error( \"x\" ) end");
    QTest::newRow("three arms, yaw by a servo")
        << QByteArray("m = { Vector( 1, 0.5, 0, 1 ), Vector( -1, 0.5, 0, 1 ), Vector( 0, -1, 0, 1 ) }");
    QTest::newRow("unequal arms") << QByteArray("m = { Vector( 0.7, -1, -1, 1 ), Vector( -0.7, -1, 1, 1 ),\n"
                                                "Vector( 1, 1, 1, 1 ), Vector( -1, 1, -1, 1 ) }");
}

void TestBcflightWire::nothingIsDoubtedWithoutCause()
{
    QFETCH(QByteArray, text);
    QStringList found;
    for (const ScriptMistake &doubt : findDoubts(text))
        found.append(doubt.sentence(QString::fromUtf8(doubt.what)));
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
}

QTEST_GUILESS_MAIN(TestBcflightWire)
#include "tst_bcflightwire.moc"
