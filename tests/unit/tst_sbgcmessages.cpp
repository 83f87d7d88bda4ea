// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/commands.h"
#include "protocol/simplebgc/frametext.h"
#include "protocol/simplebgc/messages.h"
#include "tests/support/sbgcrig.h"
#include "tests/unit/sbgcvectors.h"

#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace simplebgc;

namespace {

constexpr int kOldestNumber = 2400;  // of the firmware that is looked at
constexpr int kNewestNumber = 2750;

const MessageSpec *messageOf(const SbgcVector &vector)
{
    const QString name = QString::fromLatin1(vector.name);
    return name == u"CONFIRM"_s ? findMessage(67) : findMessage(name);
}

std::optional<Fields> fieldsOf(const MessageSpec &message, char way, int firmware)
{
    const MessageSpec then = asOf(message, firmware);
    return way == '>' ? then.toBoard : then.fromBoard;
}

std::optional<Fields> fieldsOf(const SbgcVector &vector)
{
    return fieldsOf(*messageOf(vector), vector.way, vector.firmware);
}

QStringList wordsOf(Fields fields, const QByteArray &payload)
{
    QStringList words;
    for (const FieldValue &value : decodeFields(fields, asBytes(payload))) {
        const QString text = value.spec->type == FieldType::Bytes ? QString::fromLatin1(value.bytes.toHex())
            : value.isText()                                      ? QString::fromUtf8(value.bytes)
                                                                  : QString::number(value.number, 'g', 17);
        words.append(value.name + u'=' + text);
    }
    return words;
}

/// Commands that nothing here makes use of, and why.
struct Unused
{
    const char *name;
    bool isSimulated;  // the simulated board carries it out all the same
    const char *reason;
};
// clang-format off
constexpr Unused kUnused[] = {
    {"GET_PARAMS_3", true, "no firmware has it: the document calls it not yet implemented"},
    {"SIGN_MESSAGE", false, "the board signs with a key that only its maker knows"},
    {"SET_ADJ_VARS_VAL_F", true, "all variables are whole numbers, which SET_ADJ_VARS_VAL sets and proves"},
    {"MODULE_LIST", false, "of modules on the CAN bus"},
    {"CAN_DEVICE_SCAN", false, "of modules on the CAN bus"},
    {"CAN_DRV_TELEMETRY", false, "of modules on the CAN bus"},
    {"CALIB_ORIENT_CORR", false, "it finds how crooked a sensor is mounted; the simulated one sits straight"},
    {"SYNC_MOTORS", false, "of axes that two motors turn"},
    {"EXT_IMU_CMD", false, "passed on to an external sensor"},
    {"EXT_SENS_CMD", false, "passed on to an external sensor"},
    {"EXT_MOTORS_ACTION", false, "of external motors"},
    {"EXT_MOTORS_CONTROL", false, "of external motors"},
    {"EXT_MOTORS_CONTROL_CONFIG", false, "of external motors"},
    {"EXT_MOTORS_STATE", false, "of external motors"},
    {"TRANSPARENT_SAPI", false, "passed on to another board"},
    {"SET_DEBUG_PORT", false, "repeats what passes the board's other ports; the simulated one has no others"},
};
// clang-format on

const Unused *unused(const MessageSpec &message)
{
    const auto found = std::find_if(std::begin(kUnused), std::end(kUnused), [&message](const Unused &each) {
        return qstrcmp(each.name, message.name) == 0;
    });
    return found == std::end(kUnused) ? nullptr : found;
}

/// The code of ERROR with which a board with all its sensors refuses it; 0: it does not, -1: nothing is said.
int refusalBy(int firmware, int id, const QByteArray &payload)
{
    constexpr int kErrorId = 255;
    SimulatorOptions options = withFirmware(firmware);
    for (const char *part : {"encoders", "frame-imu", "magnetometer", "fc"})
        options.own.insert(QLatin1String(part), 1);
    VirtualBoard board(options);
    const auto heard = board.channel.listen([](const FrameView &) { return true; });
    if (!board.channel.transact(silentRequest(CommandId(id), payload, 1)))
        return -1;
    const auto frame = heard->next(200ms);
    if (!frame)
        return -1;
    return frame->id == kErrorId ? int(quint8(frame->payload[1])) : 0;
}

}  // namespace

class TestSbgcMessages : public QObject
{
    Q_OBJECT
private slots:
    void numbersAreInOrder();
    void everyLayoutHasAVector();
    void layoutsAreThoseOfTheErrata_data();
    void layoutsAreThoseOfTheErrata();
    void commandsAreGivenByName();
    void whatIsWrongIsSaid_data();
    void whatIsWrongIsSaid();
    void framesAreWorded();
    void everyCommandIsOfUse();
    void everyCommandHasAnEffect();
    void earlierFirmwareKnowsNothingOfIt();
};

void TestSbgcMessages::numbersAreInOrder()
{
    int before = 0;
    QStringList names;
    for (const MessageSpec &message : messages()) {
        QVERIFY2(message.id > before && message.id < 256, message.name);
        before = message.id;
        QVERIFY2(!names.contains(QLatin1String(message.name)), message.name);
        names.append(QLatin1String(message.name));
        QVERIFY2(message.isPublic == (message.toBoard || message.fromBoard), message.name);
        QCOMPARE(findMessage(message.id), &message);
    }
}

// A command that is added without bytes from the errata fails here, and so does a layout that it had before.
void TestSbgcMessages::everyLayoutHasAVector()
{
    const auto isProven = [](const MessageSpec &message, char way, int firmware) {
        const auto fields = fieldsOf(message, way, firmware);
        return !fields
            || std::any_of(std::begin(kSbgcVectors), std::end(kSbgcVectors), [&](const SbgcVector &vector) {
                   return vector.way == way && messageOf(vector) == &message
                       && fieldsOf(message, way, vector.firmware)->data() == fields->data();
               });
    };
    for (const MessageSpec &message : messages()) {
        for (int firmware = kOldestNumber; firmware <= kNewestNumber; ++firmware) {
            for (const char way : {'>', '<'})
                QVERIFY2(isProven(message, way, firmware),
                         qPrintable(u"%1 %2 in %3"_s.arg(QLatin1String(message.name))
                                        .arg(QLatin1Char(way))
                                        .arg(firmware)));
        }
    }
}

void TestSbgcMessages::layoutsAreThoseOfTheErrata_data()
{
    QTest::addColumn<int>("row");
    for (std::size_t i = 0; i < std::size(kSbgcVectors); ++i)
        QTest::addRow("%s %c %zu", kSbgcVectors[i].name, kSbgcVectors[i].way, i) << int(i);
}

void TestSbgcMessages::layoutsAreThoseOfTheErrata()
{
    QFETCH(int, row);
    const SbgcVector &vector = kSbgcVectors[row];
    QVERIFY(messageOf(vector) && fieldsOf(vector));
    const Fields fields = *fieldsOf(vector);
    const QByteArray payload = QByteArray::fromHex(vector.hex);
    const auto values = decodeFields(fields, asBytes(payload));
    for (const QString &pair : QString::fromLatin1(vector.fields).split(u' ', Qt::SkipEmptyParts)) {
        const QString name = pair.section(u'=', 0, 0);
        const auto value = std::find_if(values.begin(), values.end(),
                                        [&name](const FieldValue &each) { return each.name == name; });
        QVERIFY2(value != values.end(), qPrintable(name));
        QVERIFY2(std::abs(value->number - pair.section(u'=', 1).toDouble()) < 1e-9, qPrintable(pair));
    }
    // The way back: from what was read the same bytes are made.
    if (vector.way != '>' || messageOf(vector)->id == number(CommandId::WriteProfileNames))
        return;
    const auto again
        = encodeFields(fields, wordsOf(fields, payload), asOf(*messageOf(vector), vector.firmware).least);
    QVERIFY2(again, again ? "" : qPrintable(again.error().detail));
    QCOMPARE(again->toHex(), payload.toHex());
}

void TestSbgcMessages::commandsAreGivenByName()
{
    const auto pin = parseCommand(u"trigger_pin pin=AUX1 state=high"_s, 1);
    QVERIFY2(pin, pin ? "" : qPrintable(pin.error().detail));
    QCOMPARE(pin->bytes, encodeFrame(84, QByteArray::fromHex("1001")));
    QCOMPARE(pin->risk, ActionRisk::Moves);
    const auto hex = parseCommand(u"TRIGGER_PIN 10 01"_s, 1);
    QVERIFY(hex);
    QCOMPARE(hex->bytes, pin->bytes);
    const auto notes = parseCommand(u"BEEP_SOUND sound=0x8000 length=40 decay=3 note1=988 note2=21000"_s, 1);
    QVERIFY2(notes, notes ? "" : qPrintable(notes.error().detail));
    QCOMPARE(notes->bytes.size(), 5 + 12 + 4);
    // The short form, and what only asks.
    QCOMPARE(parseCommand(u"EXECUTE_MENU action=18"_s, 1)->bytes, encodeFrame(69, "\x12"));
    QCOMPARE(parseCommand(u"AHRS_HELPER mode=2"_s, 1)->risk, ActionRisk::Safe);
    QCOMPARE(parseCommand(u"AHRS_HELPER mode=5 z.x=0 z.y=0 z.z=1 h.x=0 h.y=1 h.z=0"_s, 1)->risk,
             ActionRisk::Moves);
    QCOMPARE(parseCommand(u"SYSTEM_STATE 01"_s, 1)->risk, ActionRisk::Destroys);
    // As the firmware takes it.
    const QString attitude = u"AHRS_HELPER mode=5 z.x=0 z.y=0 z.z=1 h.x=0 h.y=1 h.z=0"_s;
    QCOMPARE(parseCommand(attitude, 1, 2695)->bytes.size(), 5 + 26);
    QCOMPARE(parseCommand(attitude, 1, 2694)->bytes.size(), 5 + 25);
    QVERIFY(!parseCommand(u"CONTROL mode=1 roll.speed=1 roll.angle=0"_s, 1));
    QCOMPARE(parseCommand(u"CONTROL mode=0 roll.speed=0 roll.angle=0 pitch.speed=0 pitch.angle=0 yaw.speed=0 "
                          "yaw.angle=0"_s,
                          1, 2554)
                 ->bytes,
             encodeFrame(67, QByteArray(13, '\0')));
    // Parts of a number by their names, the others are 0; or all of it as one.
    const auto parts = parseCommand(u"CONTROL_EXT set.yaw.speed=1 set.yaw.fine_speed=1 yaw.mode.kind=speed "
                                    "yaw.flags=0 yaw.speed=-5"_s,
                                    1);
    QVERIFY2(parts, parts ? "" : qPrintable(parts.error().detail));
    QCOMPARE(parts->bytes,
             encodeFrame(121,
                         QByteArray::fromHex("00240100"
                                             "78ecffff")));
    QCOMPARE(parseCommand(u"CONTROL_EXT set=0x2400 yaw.mode=1 yaw.flags=0 yaw.speed=-5"_s, 1)->bytes,
             parts->bytes);
    QCOMPARE(parseCommand(u"AUTO_PID2 action=stop command=0"_s, 1)->bytes,
             encodeFrame(108,
                         QByteArray::fromHex("05"
                                             "00000000000000000000")));
}

void TestSbgcMessages::whatIsWrongIsSaid_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("said");
    QTest::newRow("no field") << u"TRIGGER_PIN pin=16 level=1"_s
                              << u"state is missing; the fields are pin, state"_s;
    QTest::newRow("too many") << u"TRIGGER_PIN pin=16 state=1 more=1"_s << u"'more'"_s;
    QTest::newRow("not a number") << u"TRIGGER_PIN pin=here state=1"_s << u"'here' is not a number"_s;
    QTest::newRow("too large") << u"TRIGGER_PIN pin=256 state=1"_s << u"0 .. 255"_s;
    QTest::newRow("twice") << u"TRIGGER_PIN pin=1 pin=2"_s << u"twice"_s;
    QTest::newRow("no name") << u"TRIGGER_PIN pin=1 =2"_s << u"name=value"_s;
    QTest::newRow("not finite") << u"AHRS_HELPER mode=1 z.x=nan"_s << u"not a number"_s;
    QTest::newRow("from the board") << u"EVENT event=1"_s << u"the board sends"_s;
    QTest::newRow("nothing of it") << u"TRIGGER_PIN high"_s << u"pin=... state=..."_s;
    QTest::newRow("bytes") << u"EEPROM_WRITE address=0 data=xy"_s << u"hex"_s;
    QTest::newRow("too long") << u"WRITE_EXTERNAL_DATA data=%1"_s.arg(QString(258, u'0')) << u"128"_s;
    QTest::newRow("not said to be there") << u"CONTROL_EXT set.roll.speed=1 roll.mode.kind=1 roll.flags=0 "
                                             "roll.speed=10 roll.angle=5"_s
                                          << u"there is no field 'roll.angle' here"_s;
    QTest::newRow("said to be there") << u"CONTROL_EXT set.roll.speed=1"_s << u"roll.mode is missing"_s;
    QTest::newRow("more than its bits hold")
        << u"AUTO_PID2 action=start command=0 version=1 roll.flags.notches=4"_s << u"0 .. 3"_s;
    QTest::newRow("no such word") << u"CONTROL_EXT set.yaw.speed=1 yaw.mode.kind=fast"_s
                                  << u"'fast' is not a number"_s;
    QTest::newRow("settings are missing") << u"AUTO_PID2 action=start command=0"_s << u"version is missing"_s;
    QTest::newRow("no rotation") << u"CONTROL_QUAT mode=attitude flags.packed=1 attitude.w=1 attitude.x=1 "
                                    "attitude.y=0 attitude.z=0"_s
                                 << u"the length of a rotation is 1"_s;
    QTest::newRow("half a rotation") << u"CONTROL_QUAT mode=attitude flags.packed=1 attitude.w=1"_s
                                     << u"attitude.x is missing"_s;
    QTest::newRow("nothing") << u"NOTHING"_s << u"there is no command"_s;
}

void TestSbgcMessages::whatIsWrongIsSaid()
{
    QFETCH(QString, text);
    QFETCH(QString, said);
    const auto command = parseCommand(text, 1);
    QVERIFY(!command);
    QVERIFY2(command.error().detail.contains(said), qPrintable(command.error().detail));
}

void TestSbgcMessages::framesAreWorded()
{
    const auto worded = [](int id, const char *hex, bool fromBoard) {
        const QByteArray payload = QByteArray::fromHex(hex);
        return describeFrame({id, asBytes(payload), 1, {}}, fromBoard, nullptr).fields;
    };
    QCOMPARE(worded(84, "1001", false), u"pin 16 (AUX1), state 1 (high)"_s);
    QCOMPARE(worded(66, "d204", false), u"voltage 12.34 V"_s);
    QCOMPARE(worded(57, "0204", false), u"mode 2 (debug), slot 4"_s);
    QCOMPARE(worded(58, "110002", true), u"command 17, code 2 (file not found)"_s);
    QCOMPARE(worded(52, "0102", false), u"its layout is not public"_s);
    QCOMPARE(worded(200, "01", false), QString());
    // Only what is there, and of flags only those that are set.
    QCOMPARE(worded(121, "e0008200dc0572fcffff", false),
             u"set.pitch.speed, set.pitch.angle, set.pitch.fine_angle, pitch.mode.kind 2 (angle), "
             "pitch.mode.fine, pitch.speed 1.500°/s, pitch.angle -0.3124°"_s);
    QCOMPARE(worded(140, "0000", false), u"mode 0 (off)"_s);
    QCOMPARE(worded(130, "020a0032001e00", false),
             u"motors.second, set.speed, set.jerk, speed 100°/s, jerk 30 ms"_s);
    QCOMPARE(worded(106, "ca58", true),
             u"main.source.attitude 2 (external), main.source.heading 1 (internal), main.source.present, "
             "main.source.processing, frame.source.attitude 0 (none), frame.source.heading 3 (translated), "
             "frame.source.present"_s);
    // Every vector has words, and what is cut off anywhere does no harm.
    for (const SbgcVector &vector : kSbgcVectors) {
        const QByteArray payload = QByteArray::fromHex(vector.hex);
        for (qsizetype length = 0; length <= payload.size(); ++length) {
            const QByteArray part = payload.left(length);
            const FrameText text = describeFrame({messageOf(vector)->id, asBytes(part), 1, {}},
                                                 vector.way == '<', nullptr, vector.firmware);
            QVERIFY2(!text.name.isEmpty(), vector.name);
        }
    }
}

// It has a place, or there is a reason.
void TestSbgcMessages::everyCommandIsOfUse()
{
    for (const MessageSpec &message : messages())
        QVERIFY2(!message.isPublic || (*message.where != '\0') != (unused(message) != nullptr), message.name);
    for (const Unused &each : kUnused)
        QVERIFY2(findMessage(QString::fromLatin1(each.name)) && *each.reason, each.name);
}

// The newest firmware knows it.
void TestSbgcMessages::everyCommandHasAnEffect()
{
    constexpr int kUnknown = 6;
    for (const SbgcVector &vector : kSbgcVectors) {
        const MessageSpec &message = *messageOf(vector);
        if (vector.way != '>')
            continue;
        const Unused *reasoned = unused(message);
        const int code
            = refusalBy(simplebgc::Device::kNewestFirmware, message.id, QByteArray::fromHex(vector.hex));
        QVERIFY2((code != kUnknown) == (!reasoned || reasoned->isSimulated), vector.name);
    }
}

// Firmware before 2.60 is silent, later firmware refuses it.
void TestSbgcMessages::earlierFirmwareKnowsNothingOfIt()
{
    constexpr int kUnknown = 6;
    for (const SbgcVector &vector : kSbgcVectors) {
        const MessageSpec &message = *messageOf(vector);
        if (vector.way != '>' || message.since == 0)
            continue;
        const int code = refusalBy(message.since - 1, message.id, QByteArray::fromHex(vector.hex));
        QVERIFY2(code == (message.since > kLater ? kUnknown : -1), vector.name);
    }
}

QTEST_GUILESS_MAIN(TestSbgcMessages)
#include "tst_sbgcmessages.moc"
