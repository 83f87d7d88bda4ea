// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/device.h"
#include "protocol/storm32/framer.h"
#include "protocol/storm32/telemetrytables.h"

#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace storm32;

namespace {

constexpr mavlink::Address kBoard{71, 67};
constexpr mavlink::Address kTool{82, 67};

QByteArray hex(const char *text)
{
    return QByteArray::fromHex(text);
}

// Words 0, 1, 2 ...
QByteArray counting(int words)
{
    ByteWriter writer;
    for (int i = 0; i < words; ++i)
        writer.u16(i);
    return writer.take();
}

// "pitch=-12.5, roll=3"
QVariantMap valuesOf(const char *text)
{
    QVariantMap values;
    for (const QString &pair : QString::fromLatin1(text).split(u", "_s, Qt::SkipEmptyParts))
        values.insert(pair.section(u'=', 0, 0), pair.section(u'=', 1));
    return values;
}

// What was decoded, as the rows write it; fields that the row does not name have to be empty.
QVariantMap asText(const QVariantMap &decoded, const QVariantMap &named)
{
    QVariantMap values;
    for (auto it = decoded.begin(); it != decoded.end(); ++it) {
        const bool bytes = it->userType() == QMetaType::QByteArray;
        const QString text = bytes ? QString::fromLatin1(it->toByteArray().toHex()) : it->toString();
        if (named.contains(it.key()) || text != u"0"_s)
            values.insert(it.key(), text);
    }
    return values;
}

// All frames in these bytes, behind what was asked.
QList<std::pair<int, QByteArray>> hear(const QByteArray &asked, const QByteArray &bytes)
{
    storm32::Framer framer;
    framer.sent(asBytes(asked));
    QList<std::pair<int, QByteArray>> heard;
    const auto sink = [&heard](const FrameView &frame) {
        heard.append({frame.id, toByteArray(frame.payload)});
    };
    for (const char byte : bytes)
        framer.feed(asBytes(QByteArray(1, byte)), sink);
    framer.flush(sink);
    return heard;
}

// Hears what is sent and never answers.
class DeafChannel final : public Channel
{
public:
    Result<Frame> transact(const Request &request) override
    {
        post(request);
        m_now += request.timeout;
        return failure(ErrorCode::Timeout);
    }
    void post(const Request &request) override
    {
        // What is asked before is no part of it.
        if (sent.isEmpty() && request.name != u"GETPARAMETER"_s)
            sent = request.bytes;
    }
    Result<void> sleep(milliseconds duration) override
    {
        m_now += duration;
        return {};
    }
    std::unique_ptr<Mailbox> listen(std::function<bool(const FrameView &)>) override { return nullptr; }
    Result<void> setLine(const LineSettings &) override { return {}; }
    void steer(const ControlFrames &) override { }
    void releaseControl() override { }
    void stopMotors(const StopPlan &) override { }
    void expectSilence(milliseconds) override { }
    [[nodiscard]] bool cancelled() const override { return false; }
    void progress(const Progress &) override { }
    [[nodiscard]] TimePoint now() const override { return m_now; }
    [[nodiscard]] LinkObservation observation() const override { return {}; }

    QByteArray sent;  // the first command

private:
    TimePoint m_now{};
};

// Adds rows of messages, and knows which messages have one.
struct MavlinkRows
{
    QSet<int> ids;

    void operator()(const char *name, int id, const mavlink::Address &from, int sequence, const char *values,
                    const char *wire)
    {
        ids.insert(id);
        QTest::newRow(name) << id << from.system << sequence << valuesOf(values) << hex(wire);
    }
};

void addCommandLongs(MavlinkRows &row)
{
    row("COMMAND_LONG DO_SET_PARAMETER", 76, kTool, 9,
        "param1=47, param2=-250, command=180, target_system=71, target_component=67",
        "fe210952434c00003c4200007ac30000000000000000000000000000000000000000b400474300d263");
    row("COMMAND_LONG DO_SET_PARAMETER, restore", 76, kTool, 9,
        "param1=47, param7=83, command=180, target_system=71, target_component=67",
        "fe210952434c00003c4200000000000000000000000000000000000000000000a642b400474300a41b");
    row("COMMAND_LONG DO_SET_SERVO", 76, kTool, 9,
        "param2=1520, command=183, target_system=71, target_component=67",
        "fe210952434c000000000000be440000000000000000000000000000000000000000b700474300194b");
    row("COMMAND_LONG DO_DIGICAM_CONTROL", 76, kTool, 9,
        "param5=1, command=203, target_system=71, target_component=67",
        "fe210952434c000000000000000000000000000000000000803f0000000000000000cb00474300a5f1");
    row("COMMAND_LONG DO_MOUNT_CONFIGURE", 76, kTool, 9,
        "param1=1, command=204, target_system=71, target_component=67",
        "fe210952434c0000803f000000000000000000000000000000000000000000000000cc004743008fe3");
    row("COMMAND_LONG DO_MOUNT_CONTROL", 76, kTool, 9,
        "param1=-10, param2=2.5, param3=45, param6=7, command=205, target_system=71, target_component=67",
        "fe210952434c000020c1000020400000344200000000000000000000e04000000000cd00474300ee1c");
    row("COMMAND_LONG DO_MOUNT_CONTROL, pulses", 76, kTool, 9,
        "param1=1200, param2=1500, param3=1800, param6=256, command=205, target_system=71, "
        "target_component=67",
        "fe210952434c000096440080bb440000e14400000000000000000000804300000000cd00474300c9f2");
    row("COMMAND_LONG DO_MOUNT_CONTROL_QUAT", 76, kTool, 9,
        "param1=1, command=220, target_system=71, target_component=67",
        "fe210952434c0000803f000000000000000000000000000000000000000000000000dc004743003fa1");
    row("COMMAND_LONG PREFLIGHT_STORAGE", 76, kTool, 9,
        "param1=1, command=245, target_system=71, target_component=67",
        "fe210952434c0000803f000000000000000000000000000000000000000000000000f5004743002c01");
    row("COMMAND_LONG REQUEST_ATTITUDE", 76, kTool, 9, "command=1234, target_system=71, target_component=67",
        "fe210952434c00000000000000000000000000000000000000000000000000000000d204474300ebd1");
    row("COMMAND_LONG sent again", 76, kTool, 9,
        "param1=1, param7=83, command=180, target_system=71, target_component=67, confirmation=2",
        "fe210952434c0000803f00000000000000000000000000000000000000000000a642b40047430278a4");
}

void addCommandMessages(MavlinkRows &row)
{
    row("COMMAND_ACK", 77, kBoard, 5, "command=245, result=3", "fe030547434df5000371f3");
    row("DIGICAM_CONTROL", 155, kTool, 9,
        "extra_value=0.5, target_system=71, target_component=67, session=1, zoom_pos=2, zoom_step=-3, "
        "focus_lock=4, shot=3, "
        "command_id=6, extra_param=7",
        "fe0d0952439b0000003f47430102fd040306074969");
    row("MOUNT_CONFIGURE", 156, kTool, 9,
        "target_system=71, target_component=67, mount_mode=1, stab_roll=2, stab_pitch=3, stab_yaw=4",
        "fe060952439c474301020304b2a7");
    row("MOUNT_CONTROL", 157, kTool, 9,
        "input_a=-3000, input_b=500, input_c=9000, target_system=71, target_component=67, save_position=14",
        "fe0f0952439d48f4fffff40100002823000047430e150e");
}

}  // namespace

/// Every message of STorM32's three command sets against bytes that were worked out by hand from the tables
/// of the errata (sections 2, 3, 4 and 6), apart from the tables of this program: a message is encoded to
/// them, and found and read in them.
class TestStormHex : public QObject
{
    Q_OBJECT
private slots:
    void simple_data();
    void simple();
    void liveDataHasUnits();
    void rc_data();
    void rc();
    void actionsSendThem_data();
    void actionsSendThem();
    void mavlink_data();
    void mavlink();
    void valueBits();
    void wrongValuesAreTold();
};

void TestStormHex::simple_data()
{
    QTest::addColumn<QString>("letters");
    QTest::addColumn<QByteArray>("command");
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<QByteArray>("reply");
    QTest::addColumn<int>("bytes");  // of the data in the reply
    QSet<QString> rows;
    const auto row = [&rows](const char *name, const char *letters, const QByteArray &command,
                             const QByteArray &arguments = {}, const QByteArray &reply = "o", int bytes = 0) {
        rows.insert(QString::fromLatin1(letters));
        QTest::newRow(name) << QString::fromLatin1(letters) << command << arguments << reply << bytes;
    };
    row("t", "t", hex("74"));
    row("v", "v", hex("76"), {},
        hex("76302e393600000000000000000000004f6c6c6957203332334247430000000076312e33302046313033524300000000"
            "60005f0003ff6eee6f"),
        54);
    row("g", "g", hex("67"), {},
        counting(125) + QByteArray(128, '\xFF')
            + hex("bc96"
                  "6f"),
        378);
    row("g, layout 78", "g", hex("67"), {},
        counting(124) + QByteArray(128, '\xFF')
            + hex("5ee6"
                  "6f"),
        376);
    row("p", "p", hex("70") + counting(125) + QByteArray(128, '\xFF') + hex("bc96"),
        counting(125) + QByteArray(128, '\xFF'));
    row("d", "d", hex("64"), {},
        hex("0600208038000200182e31d4dc0552ff6501000000000000002078ec0000d421b80b83ff282348f47d000000f4ff8401"
            "0000010002000300d3ffbc0210270040453a6f"),
        64);
    row("s", "s", hex("73"), {}, hex("0600208038000200182e6b086f"), 10);
    row("s, seven words", "s", hex("73"), {}, hex("060020803800000000000200182ec65c6f"), 14);
    row("xs", "xs", hex("7873"));
    row("xr", "xr", hex("7872"));
    row("xd", "xd", hex("7864"));
    row("xc", "xc", hex("7863"));
    row("xl", "xl", hex("786c"));
    row("xx", "xx", hex("7878"));
    row("xX", "xX", hex("7858"));
    row("xW", "xW", hex("7857"));
    row("xm", "xm", hex("786d"));
    row("xz", "xz", hex("787a"));
    row("xy", "xy", hex("7879"));
    row("xn", "xn", hex("786e526967203720202020202020202020200424"), "Rig 7           ");
    row("xu 0", "xu", hex("78750000b8f0"), hex("0000"));
    row("xu 1", "xu", hex("7875010060e9"), hex("0100"));
    row("xu 2", "xu", hex("7875020008c3"), hex("0200"));
    row("xu 3", "xu", hex("78750300d0da"), hex("0300"));
    row("xu 4", "xu", hex("78750400d897"), hex("0400"));
    row("CR", "CR", hex("4352"));
    row("Cr", "Cr", hex("4372"), {},
        hex("0100feff030000200120ff1ff9ff0800f7ff0000000000000020002000200000000000000e5a6f"), 36);
    row("Cw", "Cw",
        hex("437701000100feff030000200120ff1ff9ff0800f7ff00000000000000000000000000000000000005d0"),
        hex("01000100feff030000200120ff1ff9ff0800f7ff000000000000000000000000000000000000"));
    row("Cd", "Cd", hex("4364"), {}, hex("000000000020fbff0600f9ff48f40100020003000400050006000700c97c6f"),
        28);
    QCOMPARE(rows.size(), qsizetype(simpleCommands().size()));  // each command has one
}

void TestStormHex::simple()
{
    QFETCH(QString, letters);
    QFETCH(QByteArray, command);
    QFETCH(QByteArray, arguments);
    QFETCH(QByteArray, reply);
    QFETCH(int, bytes);
    const SimpleCommand *known = findSimple(asBytes(command));
    QVERIFY(known);
    QCOMPARE(QString::fromLatin1(known->letters), letters);
    QCOMPARE(encodeSimple(known->id, arguments).toHex(), command.toHex());
    const QByteArray data = reply.left(bytes);
    QCOMPARE(encodeReply(data).toHex(), reply.toHex());
    const auto heard = hear(command, reply);
    QCOMPARE(heard.size(), 1);
    QCOMPARE(heard[0].first, bytes ? FrameId::kSimple + int(known->id) : int('o'));
    QCOMPARE(heard[0].second.toHex(), data.toHex());
    const auto answer
        = simpleRequest(known->id, arguments).answer({heard[0].first, asBytes(heard[0].second)});
    QVERIFY(answer && answer->has_value());
}

// Errata 3.5: counts of `d` in the units of each firmware.
void TestStormHex::liveDataHasUnits()
{
    const QByteArray data = hex(
        "0600208038000200182e31d4dc0552ff6501000000000000002078ec0000d421b80b83ff282348f47d000000f4ff8401"
        "0000010002000300d3ffbc0210270040");
    const auto late = liveRow(asBytes(data), LiveScales(96));
    const auto early = liveRow(asBytes(data), LiveScales(79));
    const auto near = [](float value, double wanted) { return std::abs(double(value) - wanted) < 0.005; };
    QVERIFY(near(late[State], 6) && near(late[Status], 0x8020) && near(late[Status2], 0x38)
            && near(late[BusErrors], 2));
    QVERIFY(near(late[Voltage], 11.8) && near(late[CycleTime], 1500));
    QVERIFY(near(late[GyroY], 9.99) && near(early[GyroX], -9.97));  // 1/2048 and 1/1000 rad/s
    QVERIFY(near(late[AccZ], 1) && near(early[AccZ], 0.8192));  // 1/8192 and 1/10000 g
    QVERIFY(near(late[UpX], -0.5) && near(late[UpY], 0) && near(late[UpZ], 0.866));
    QVERIFY(near(late[AnglePitch], 30) && near(late[AngleRoll], -1.25) && near(late[AngleYaw], 90));
    QVERIFY(near(late[OutputPitch], -30) && near(late[OutputRoll], 1.25) && near(late[OutputYaw], 0));
    QVERIFY(near(late[InputPitch], -12) && near(late[InputRoll], 388) && near(late[InputYaw], 0));
    QVERIFY(near(late[AccConfidence], 1) && near(late[Functions], 0x4000));
    // What the status says is not there has no values.
    QVERIFY(std::isnan(late[Angle2Pitch]) && std::isnan(late[Angle2Yaw]) && std::isnan(late[MagYaw]));
    QByteArray whole = data;
    whole[3] = char(0xB0);  // status with the second sensor and the magnetometer
    const auto full = liveRow(asBytes(whole), LiveScales(96));
    QVERIFY(near(full[Angle2Pitch], 0.01) && near(full[Angle2Roll], 0.02) && near(full[Angle2Yaw], 0.03));
    QVERIFY(near(full[MagYaw], -0.45));
    whole[3] = char(0x30);  // without the first one
    const auto blind = liveRow(asBytes(whole), LiveScales(96));
    QVERIFY(std::isnan(blind[AngleRoll]) && std::isnan(blind[GyroX]) && std::isnan(blind[UpZ]));
}

void TestStormHex::rc_data()
{
    QTest::addColumn<int>("id");
    QTest::addColumn<QString>("command");
    QTest::addColumn<bool>("answer");
    QTest::addColumn<QVariantMap>("values");
    QTest::addColumn<QByteArray>("wire");
    QSet<QString> commands;
    QSet<QString> answers;
    const auto row = [&](const char *name, int id, const char *command, bool answer, const char *values,
                         const char *wire) {
        (answer ? answers : commands).insert(QString::fromLatin1(command));
        QTest::newRow(name) << id << QString::fromLatin1(command) << answer << valuesOf(values) << hex(wire);
    };
    row("GETVERSION", 1, "GETVERSION", false, "", "fa000131e1");
    row("GETVERSION answer", 1, "GETVERSION", true, "firmware=96, layout=95, capabilities=65283",
        "fb060160005f0003ffa63b");
    row("GETVERSIONSTR", 2, "GETVERSIONSTR", false, "", "fa0002aad3");
    row("GETVERSIONSTR answer", 5, "GETVERSIONSTR", true,
        "version=v0.96, name=OlliW 323BGC, board=v1.30 F103RC",
        "fb300576302e393600000000000000000000004f6c6c6957203332334247430000000076312e33302046313033524300"
        "0000007f8b");
    row("GETVERSIONSTR answer 2", 2, "GETVERSIONSTR", true, "version=v2.09, name=Rig, board=v1.30 F103RC",
        "fb300276322e303900000000000000000000005269670000000000000000000000000076312e33302046313033524300"
        "0000003f11");
    row("GETPARAMETER", 3, "GETPARAMETER", false, "index=47", "fa02032f00c875");
    row("GETPARAMETER answer", 3, "GETPARAMETER", true, "index=47, value=65286", "fb04032f0006ff1263");
    row("SETPARAMETER", 4, "SETPARAMETER", false, "index=0, value=400", "fa040400009001183d");
    row("GETDATA", 5, "GETDATA", false, "type=0", "fa010500571d");
    row("GETDATA answer", 5, "GETDATA", true,
        "type=0, "
        "data="
        "00000100020003000400050006000700080009000a000b000c000d000e000f00100011001200130014001500160017001800"
        "19001a001b00"
        "1c001d001e001f00",
        "fb4205000000000100020003000400050006000700080009000a000b000c000d000e000f001000110012001300140015"
        "0016001700180019001a001b001c001d001e001f00d1c5");
    row("GETDATA answer 1", 5, "GETDATA", true, "type=1, data=", "fb02050100321a");
    row("GETDATAFIELDS", 6, "GETDATAFIELDS", false, "mask=33", "fa0206210065d6");
    row("GETDATAFIELDS answer", 6, "GETDATAFIELDS", true, "mask=33, data=0600208038000200182e1efb1e009411",
        "fb120621000600208038000200182e1efb1e0094116e49");
    row("SETPITCH", 10, "SETPITCH", false, "pulse=1000", "fa020ae803ef5c");
    row("SETROLL", 11, "SETROLL", false, "pulse=1500", "fa020bdc05c7b2");
    row("SETYAW", 12, "SETYAW", false, "pulse=0", "fa020c0000f49f");
    row("SETPANMODE", 13, "SETPANMODE", false, "mode=5", "fa010d053a84");
    row("SETSTANDBY", 14, "SETSTANDBY", false, "on=1", "fa010e0176e8");
    row("DOCAMERA", 15, "DOCAMERA", false, "shot=3", "fa060f0003000000000565");
    row("SETSCRIPTCONTROL", 16, "SETSCRIPTCONTROL", false, "script=3, case=4", "fa021003048ed3");
    row("SETANGLE", 17, "SETANGLE", false, "pitch=-12.5, roll=3, yaw=90, flags=5, type=0",
        "fa0e11000048c1000040400000b4420500fdfd");
    row("SETPITCHROLLYAW", 18, "SETPITCHROLLYAW", false, "pitch=700, roll=1500, yaw=2300",
        "fa0612bc02dc05fc085009");
    row("SETPWMOUT", 19, "SETPWMOUT", false, "pulse=1520", "fa0213f005037b");
    row("RESTOREPARAMETER", 20, "RESTOREPARAMETER", false, "index=124", "fa02147c00c785");
    row("RESTOREALLPARAMETER", 21, "RESTOREALLPARAMETER", false, "", "fa001594b7");
    row("ACTIVEPANMODESETTING", 100, "ACTIVEPANMODESETTING", false, "setting=2", "fa016402c842");
    row("ack 0", 150, "ACK", true, "code=0", "fb019600622e");
    row("ack 1", 150, "ACK", true, "code=1", "fb019601eb3f");
    row("ack 2", 150, "ACK", true, "code=2", "fb019602700d");
    row("ack 3", 150, "ACK", true, "code=3", "fb019603f91c");
    row("ack 150", 150, "ACK", true, "code=150", "fb019696dddf");
    row("ack 151", 150, "ACK", true, "code=151", "fb01969754ce");
    row("ack 152", 150, "ACK", true, "code=152", "fb019698a336");
    row("ack 153", 150, "ACK", true, "code=153", "fb0196992a27");
    // Each command and each answer has one.
    for (const RcCommand &command : rcCommands()) {
        QVERIFY2(commands.contains(QString::fromLatin1(command.name)), command.name);
        QVERIFY2(answers.contains(QString::fromLatin1(command.name)) == !command.answer.empty(),
                 command.name);
    }
}

void TestStormHex::rc()
{
    QFETCH(int, id);
    QFETCH(QString, command);
    QFETCH(bool, answer);
    QFETCH(QVariantMap, values);
    QFETCH(QByteArray, wire);
    const QByteArray payload = wire.sliced(3, wire.size() - 5);
    const RcCommand *known = answer ? findRcAnswer(id, asBytes(payload)) : findRc(id);
    QVERIFY(known);
    QCOMPARE(QString::fromLatin1(known->name), command);
    const NamedFields fields = answer ? known->answer : known->fields;
    const auto encoded = encodeFields(fields, values, answer ? 0 : known->payloadBytes);
    QVERIFY2(encoded, encoded ? "" : qPrintable(encoded.error().detail));
    QCOMPARE(encodeRc(id, *encoded, answer).toHex(), wire.toHex());
    const auto decoded = decodeFields(fields, asBytes(payload));
    QVERIFY(decoded);
    QCOMPARE(asText(*decoded, values), values);
    const auto heard = hear(encodeRc(id, {}), wire);
    if (answer) {
        QCOMPARE(heard.size(), 1);
        QCOMPARE(heard[0].first, FrameId::kRc + id);
        QCOMPARE(heard[0].second.toHex(), payload.toHex());
    } else {  // what we send is no frame that comes (a byte of it may well be a letter)
        for (const auto &[number, data] : heard)
            QVERIFY(number < FrameId::kSimple);
    }
}

void TestStormHex::actionsSendThem_data()
{
    QTest::addColumn<QString>("action");
    QTest::addColumn<QVariantMap>("arguments");
    QTest::addColumn<QByteArray>("wire");
    const auto row = [](const char *action, const char *arguments, const char *wire) {
        QTest::newRow(action) << QString::fromLatin1(action) << valuesOf(arguments) << hex(wire);
    };
    row("standby", "on=true", "fa010e0176e8");
    row("motors.off", "", "fa010e0176e8");
    row("sticks", "pitch=700, roll=1500, yaw=2300", "fa0612bc02dc05fc085009");
    row("recenter", "", "fa06120000000000004fe3");
    row("pan.mode", "mode=5", "fa010d053a84");
    row("pan.setting", "setting=2", "fa016402c842");
    row("camera", "shot=3", "fa060f0003000000000565");
    row("script", "script=4, case=4", "fa021003048ed3");  // the board counts from 0
    row("pwm", "pulse=1520", "fa0213f005037b");
    row("restore", "word=124", "fa02147c00c785");
}

void TestStormHex::actionsSendThem()
{
    QFETCH(QString, action);
    QFETCH(QVariantMap, arguments);
    QFETCH(QByteArray, wire);
    storm32::Device device;
    DeafChannel channel;
    // Standby counts once the status proves it.
    const bool stops = action == u"standby"_s || action == u"motors.off"_s;
    const ErrorCode expected = stops ? ErrorCode::NotProven : ErrorCode::Timeout;
    QCOMPARE(device.perform(channel, action, arguments).error().code, expected);
    QCOMPARE(channel.sent.toHex(), wire.toHex());
}

void TestStormHex::mavlink_data()
{
    QTest::addColumn<int>("id");
    QTest::addColumn<int>("system");
    QTest::addColumn<int>("sequence");
    QTest::addColumn<QVariantMap>("values");
    QTest::addColumn<QByteArray>("wire");
    MavlinkRows row;
    row("HEARTBEAT", 0, kBoard, 5,
        "custom_mode=6, type=26, autopilot=83, base_mode=128, system_status=4, mavlink_version=3",
        "fe0905474300060000001a53800403d161");
    row("PARAM_REQUEST_READ", 20, kTool, 9,
        "param_index=-1, target_system=71, target_component=67, param_id=PID_PITCH_P",
        "fe1409524314ffff47435049445f50495443485f500000000000b166");
    row("PARAM_REQUEST_LIST", 21, kTool, 9, "target_system=71, target_component=67", "fe02095243154743f685");
    row("PARAM_VALUE", 22, kBoard, 5,
        "param_value=65286, param_count=125, param_index=47, param_id=RC_PITCH_MIN, param_type=4",
        "fe190547431600067f477d002f0052435f50495443485f4d494e00000000048374");
    row("PARAM_SET", 23, kTool, 9,
        "param_value=400, target_system=71, target_component=67, param_id=PID_PITCH_P, param_type=3",
        "fe17095243170000c84347435049445f50495443485f50000000000003ac95");
    row("ATTITUDE", 30, kBoard, 5,
        "time_boot_ms=123456, roll=0.5, pitch=-0.25, yaw=1.5, rollspeed=0, pitchspeed=-0.125, yawspeed=0.75",
        "fe1c0547431e40e201000000003f000080be0000c03f00000000000000be0000403f99fc");
    addCommandLongs(row);
    addCommandMessages(row);
    row("COMMAND_TARGET_SPECIFIC rc", 234, kTool, 9,
        "target_system=71, target_component=67, specific_payload=fa0ae803", "fe06095243ea4743fa0ae8033c58");
    row("COMMAND_TARGET_SPECIFIC t", 234, kTool, 0,
        "target_system=71, target_component=67, specific_payload=74", "fe03005243ea4743746893");
    row("COMMAND_TARGET_SPECIFIC_ACK ack", 235, kBoard, 5,
        "target_system=82, target_component=67, specific_payload=fb9600", "fe05054743eb5243fb960099a9");
    row("COMMAND_TARGET_SPECIFIC_ACK o", 235, kBoard, 5,
        "target_system=82, target_component=67, specific_payload=6f", "fe03054743eb52436f1988");
    row("PARAM_READ2", 236, kTool, 9, "param_index=47, target_system=71, target_component=67",
        "fe04095243ec2f004743c2ef");
    row("PARAM_SET2", 237, kTool, 9,
        "param_value=400, param_index=47, target_system=71, target_component=67, param_type=4",
        "fe09095243ed0000c8432f00474304cc18");
    row("PARAM_VALUE2", 238, kBoard, 5,
        "param_value=400, param_index=47, param_count=125, target_system=82, target_component=67, "
        "param_type=4",
        "fe0b054743ee0000c8432f007d005243043d3e");
    row("STATUSTEXT", 253, kBoard, 5, "severity=4, text=Battery is weak",
        "fe33054743fd0442617474657279206973207765616b0000000000000000000000000000000000000000000000000000"
        "000000000000000000dcda");
    QCOMPARE(row.ids.size(), qsizetype(mavlink::messages().size()));  // each message has one
}

void TestStormHex::mavlink()
{
    QFETCH(int, id);
    QFETCH(int, system);
    QFETCH(int, sequence);
    QFETCH(QVariantMap, values);
    QFETCH(QByteArray, wire);
    const mavlink::Message *message = mavlink::findMessage(id);
    QVERIFY(message);
    QVERIFY2(QByteArray(QTest::currentDataTag()).startsWith(message->name), message->name);
    const mavlink::Address from{system, 67};
    const auto payload = mavlink::encodeFields(*message, values);
    QVERIFY2(payload, payload ? "" : qPrintable(payload.error().detail));
    QCOMPARE(mavlink::encode(mavlink::MessageId(id), *payload, from, sequence).toHex(), wire.toHex());
    const auto seen = mavlink::sight(asBytes(wire));
    QCOMPARE(seen.look, mavlink::Look::Complete);
    QCOMPARE(seen.size, std::size_t(wire.size()));
    QCOMPARE(seen.packet.id, id);
    QCOMPARE(seen.packet.sequence, sequence);
    QCOMPARE(seen.packet.from, from);
    const auto decoded = mavlink::decodeFields(*message, seen.packet.payload);
    QVERIFY(decoded);
    QCOMPARE(asText(*decoded, values), values);
    for (qsizetype i = 1; i < wire.size(); ++i)
        QCOMPARE(mavlink::sight(asBytes(wire.left(i))).look, mavlink::Look::Incomplete);
    for (qsizetype i = 1; i < wire.size(); ++i) {
        QByteArray damaged = wire;
        damaged[i] = char(damaged[i] ^ 0x10);
        QVERIFY(mavlink::sight(asBytes(damaged)).look != mavlink::Look::Complete);
    }
}

// From v0.91 on the 16 bits travel as they are: -250 in a parameter's value (errata 6).
void TestStormHex::valueBits()
{
    const QByteArray wire = hex("fe190547431606ff00007d002f0052435f50495443485f4d494e0000000004c95c");
    const auto seen = mavlink::sight(asBytes(wire));
    QCOMPARE(seen.look, mavlink::Look::Complete);
    const auto values = mavlink::decodeFields(*mavlink::findMessage(seen.packet.id), seen.packet.payload);
    QVERIFY(values);
    QCOMPARE(mavlink::decodeValue(values->value(u"param_value"_s).toFloat(), mavlink::ValueCoding::Bits),
             0xFF06);
    const auto payload = mavlink::encodeFields(*mavlink::findMessage(22), *values);
    QCOMPARE(mavlink::encode(mavlink::MessageId::ParamValue, *payload, kBoard, 5).toHex(), wire.toHex());
}

void TestStormHex::wrongValuesAreTold()
{
    const RcCommand &angle = *findRc(int(Rc::SetAngle));
    const auto code = [&angle](const char *values) {
        return encodeFields(angle.fields, valuesOf(values), angle.payloadBytes).error().code;
    };
    QCOMPARE(code("tilt=1"), ErrorCode::InvalidArgument);
    QCOMPARE(code("pitch=up"), ErrorCode::InvalidArgument);
    QCOMPARE(code("pitch=nan"), ErrorCode::InvalidArgument);
    QCOMPARE(code("pitch=-inf"), ErrorCode::InvalidArgument);
    QCOMPARE(code("flags=1.5"), ErrorCode::InvalidArgument);
    QCOMPARE(code("flags=256"), ErrorCode::OutOfRange);
    QCOMPARE(code("flags=-1"), ErrorCode::OutOfRange);
    QCOMPARE(decodeFields(angle.fields, asBytes(QByteArray(13, '\0'))).error().code, ErrorCode::BadReply);
    const RcCommand &data = *findRcAnswer(6, asBytes(QByteArray(8, '\0')));
    QCOMPARE(encodeFields(data.answer, valuesOf("mask=1, data=0x")).error().code, ErrorCode::InvalidArgument);
    QVERIFY(!findRcAnswer(6, {}) && !findRcAnswer(77, {}) && !findRcAnswer(int(Rc::Ack), {}));
}

QTEST_GUILESS_MAIN(TestStormHex)
#include "tst_stormhex.moc"
