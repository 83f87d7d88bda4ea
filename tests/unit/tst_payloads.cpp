// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/payloads.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "tests/support/virtualboard.h"

#include <QTest>

#include <cmath>

using namespace simplebgc;
using namespace Qt::StringLiterals;

/// Every message against bytes worked out from the document and the errata by hand.
class TestPayloads : public QObject
{
    Q_OBJECT
private slots:
    void boardInfoRecordedFromARealBoard();
    void boardInfoOfLaterFirmware();
    void firmwareTexts_data();
    void firmwareTexts();
    void boardInfo3();
    void profileNamesKeepWholeCharacters();
    void angles();
    void anglesExtHaveAStrideOf18();
    void adjustableVariables();
    void debugVariablesOfAllTypes();
    void debugVariablesWithUnknownTypeAreRefused();
    void autoPidProgress();
    void controlShortForm();
    void controlExtendedForm();
    void dataStreamHas21Bytes();
    void calibrationExtendedForm();
    void beepExamplesOfTheDocument();
    void realtimeRamp();
    void customFieldsComeInBitOrder();
    void laterCustomFields_data();
    void laterCustomFields();
    void quaternionsSurviveEightBytes();
    void shortPayloadsAreErrors();
    void errorFrames();
};

void TestPayloads::boardInfoRecordedFromARealBoard()
{
    // Errata section 8, last row: board 3.1, firmware 2.43b9, features = battery, USB.
    const auto info
        = BoardInfo::decode(asBytes(hex("1F 87 09 00 02 00 01 00 00 00 00 00 00 00 00 00 00 00")));
    QVERIFY(info);
    QCOMPARE(info->boardVersion, 31);
    QCOMPARE(info->firmware, 2439);
    QCOMPARE(info->firmwareText(), u"2.43b9"_s);
    QCOMPARE(info->features, quint32(BatteryMonitor));
    QVERIFY(info->usb);
    QCOMPARE(info->encode().size(), 18);
    QCOMPARE(*BoardInfo::decode(asBytes(info->encode())), *info);
}

void TestPayloads::boardInfoOfLaterFirmware()
{
    BoardInfo info;
    info.boardVersion = 36;
    info.firmware = 2738;
    info.features = 0x00050003;
    QCOMPARE(*BoardInfo::decode(asBytes(info.encode())), info);
}

void TestPayloads::firmwareTexts_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<QString>("text");
    QTest::newRow("document's example") << 2305 << u"2.30b5"_s;
    QTest::newRow("2.59") << 2590 << u"2.59b0"_s;
    QTest::newRow("2.73.8") << 2738 << u"2.73.8"_s;
}

void TestPayloads::firmwareTexts()
{
    QFETCH(int, number);
    QFETCH(QString, text);
    BoardInfo info;
    info.firmware = number;
    QCOMPARE(info.firmwareText(), text);
}

void TestPayloads::boardInfo3()
{
    const auto info = BoardInfo3::decode(asBytes(ramp(69)));
    QVERIFY(info);
    QCOMPARE(info->deviceId, hex("00 01 02 03 04 05 06 07 08"));
    QCOMPARE(info->mcuId, hex("09 0A 0B 0C 0D 0E 0F 10 11 12 13 14"));
    QCOMPARE(info->eepromSize, quint32(0x18171615));
    QCOMPARE(info->scriptSizes[4], quint16(0x2221));
    QCOMPARE(info->encode().size(), 69);
}

void TestPayloads::profileNamesKeepWholeCharacters()
{
    const QStringList names{u"Handheld"_s, u"Grüße"_s, QString(), QString(47, u'x') + u'ü', u"五"_s};
    const QByteArray payload = encodeProfileNames(names);
    QCOMPARE(payload.size(), 240);
    const auto decoded = decodeProfileNames(asBytes(payload));
    QVERIFY(decoded);
    QCOMPARE((*decoded)[1], u"Grüße"_s);
    // 47 bytes fit, the two bytes of ü do not: it is left out whole.
    QCOMPARE((*decoded)[3], QString(47, u'x'));
    QCOMPARE((*decoded)[4], u"五"_s);
}

void TestPayloads::angles()
{
    // Errata section 8: R 10°/0/0; P -45°/-45°/0; Y 30°/30°/10 °/s.
    const QByteArray bytes = hex("C7 01 00 00 00 00 00 F8 00 F8 00 00 55 05 55 05 52 00");
    const auto decoded = decodeAngles(asBytes(bytes));
    QVERIFY(decoded);
    QVERIFY(std::abs((*decoded)[0].imu - 10.0) < 0.02);
    QCOMPARE((*decoded)[1].imu, -45.0);
    QVERIFY(std::abs((*decoded)[2].targetSpeed - 10.0) < 0.07);
    QCOMPARE(encodeAngles(*decoded), bytes);
}

void TestPayloads::anglesExtHaveAStrideOf18()
{
    QByteArray bytes(54, '\0');
    bytes[36] = 0x00;
    bytes[37] = 0x04;  // yaw: IMU angle 0x0400 = 22.5°
    bytes[40] = 0x00;
    bytes[42] = 0x01;  // rotor 0x00010000 = 1440°: does not wrap
    const auto decoded = decodeAnglesExt(asBytes(bytes));
    QVERIFY(decoded);
    QCOMPARE((*decoded)[2].imu, 22.5);
    QCOMPARE((*decoded)[2].rotor, 1440.0);
    QCOMPARE(encodeAnglesExt(*decoded), bytes);
}

void TestPayloads::adjustableVariables()
{
    // Errata section 8: SET_ADJ_VARS_VAL 19, 20, 21 = 100.
    const std::vector<AdjVar> values{{19, 100}, {20, 100}, {21, 100}};
    QCOMPARE(encodeAdjVars(values), hex("03 13 64 00 00 00 14 64 00 00 00 15 64 00 00 00"));
    QCOMPARE(*decodeAdjVars(asBytes(encodeAdjVars(values))), values);
    QCOMPARE(encodeAdjVars({{38, -2}}), hex("01 26 FE FF FF FF"));
}

void TestPayloads::debugVariablesOfAllTypes()
{
    const std::vector<DebugVar> vars{
        {u"A"_s, DebugVar::U8, 0, false, 1},  {u"B"_s, DebugVar::I8, 1, false, 1},
        {u"C"_s, DebugVar::U16, 2, false, 1}, {u"D"_s, DebugVar::I16, 3, true, 1},
        {u"E"_s, DebugVar::U32, 0, false, 1}, {u"F"_s, DebugVar::I32, 0, false, 2},
        {u"G"_s, DebugVar::F32, 0, false, 3}};
    const auto info = decodeDebugVarsInfo(asBytes(encodeDebugVarsInfo(7, vars)));
    QVERIFY(info);
    QCOMPARE(info->total, 7);
    QVERIFY(info->vars == vars);
    const QByteArray bytes = hex("FF  FE  34 12  00 08  01 00 00 80  FF FF FF FF 02 00 00 00"
                                 "00 00 80 3F 00 00 00 C0 00 00 00 00");
    const auto values = decodeDebugVars(vars, asBytes(bytes));
    QVERIFY(values);
    QCOMPARE((*values)[0], std::vector<double>{255});
    QCOMPARE((*values)[1], std::vector<double>{-2});
    QCOMPARE((*values)[2], std::vector<double>{0x1234});
    QCOMPARE((*values)[3], std::vector<double>{45.0});
    QCOMPARE((*values)[4], std::vector<double>{2147483649.0});
    QCOMPARE((*values)[5], (std::vector<double>{-1, 2}));
    QCOMPARE((*values)[6], (std::vector<double>{1, -2, 0}));
    QCOMPARE(encodeDebugVars(vars, *values), bytes);
}

void TestPayloads::debugVariablesWithUnknownTypeAreRefused()
{
    const std::vector<DebugVar> vars{{u"X"_s, 9, 0, false, 1}};
    QCOMPARE(decodeDebugVars(vars, asBytes(hex("00"))).error().code, ErrorCode::BadReply);
}

void TestPayloads::autoPidProgress()
{
    AutoPidProgress progress;
    progress.p = {35, 30, 40};
    progress.i = {15, 12, 10};
    progress.d = {30, 25, 35};
    progress.lpf = {400, 300, 200};
    progress.iteration = 7;
    progress.trackingError = {0.5F, 1.0F, 2.0F};
    const QByteArray bytes = progress.encode();
    QCOMPARE(bytes.size(), 57);
    QCOMPARE(bytes.mid(9, 8), hex("90 01 2C 01 C8 00 07 00"));
    QCOMPARE(bytes.mid(17, 4), hex("00 00 00 3F"));
    QCOMPARE(bytes.mid(27, 4), hex("00 00 80 3F"));
    QCOMPARE(*AutoPidProgress::decode(asBytes(bytes)), progress);
}

void TestPayloads::controlShortForm()
{
    // Errata section 8: mode 2, speed 30 °/s on P and Y, pitch +20°, yaw -45°.
    const ControlCommand command{{{2, 0, 0}, {2, 0xF6, 0x038E}, {2, 0xF6, -2048}}};
    const QByteArray bytes = hex("02 00 00 00 00 F6 00 8E 03 F6 00 00 F8");
    QCOMPARE(encodeControlShort(command), bytes);
    QCOMPARE(*decodeControl(asBytes(bytes)), command);
}

void TestPayloads::controlExtendedForm()
{
    const ControlCommand command{{{0, 0, 0}, {2, 0xF6, -2048}, {0, 0, 0}}};
    const QByteArray bytes = hex("00 02 00 00 00 00 00 F6 00 00 F8 00 00 00 00");
    QCOMPARE(encodeControl(command), bytes);
    QCOMPARE(*decodeControl(asBytes(bytes)), command);
    QVERIFY(!decodeControl(asBytes(bytes.first(14))));
}

void TestPayloads::dataStreamHas21Bytes()
{
    const DataStream stream{25, 20, QByteArray(8, '\0')};
    QCOMPARE(stream.encode(), hex("19 14 00") + QByteArray(18, '\0'));
    QCOMPARE(*DataStream::decode(asBytes(stream.encode())), stream);
    // The document's 23 bytes are understood too (errata 3.10).
    QVERIFY(DataStream::decode(asBytes(stream.encode() + QByteArray(2, '\0'))));
    QVERIFY(!DataStream::decode(asBytes(stream.encode() + QByteArray(1, '\0'))));
}

void TestPayloads::calibrationExtendedForm()
{
    QCOMPARE(encodeCalibration(1, 1), hex("01 01") + QByteArray(10, '\0'));
}

void TestPayloads::beepExamplesOfTheDocument()
{
    QCOMPARE(encodeBeep(1, 0, 3, {}), hex("01 00 00 03") + QByteArray(8, '\0'));
    QCOMPARE(encodeBeep(0x8000, 0x7D, 0, {3000}), hex("00 80 7D 00") + QByteArray(8, '\0') + hex("B8 0B"));
}

void TestPayloads::realtimeRamp()
{
    // Errata section 8: BAT_LEVEL = 14391, CURRENT = 19788, IMU_TEMPERATURE = 84 of the ramp.
    const QByteArray bytes = ramp(124);
    const auto value = [&bytes](int channel) {
        for (const WireField &field : realtimeFields()) {
            if (field.channel == channel)
                return double(readField(field, asBytes(bytes)));
        }
        return std::nan("");
    };
    QVERIFY(std::abs(value(Battery) - 143.91) < 1e-4);
    QVERIFY(std::abs(value(Current) - 19.788) < 1e-4);
    QCOMPARE(value(ImuTemperature), 84.0);
    QCOMPARE(value(SystemError), double(0x0F0E));
    QCOMPARE(value(CurrentProfile), 59.0);
    QCOMPARE(value(MotorsRunning), double(57 & 1));
    QVERIFY(std::abs(value(AccY) - 0x0504 / 512.0) < 1e-4);
    QVERIFY(std::abs(value(RotorYaw) - 0x4443 * 0.02197265625) < 1e-3);
}

void TestPayloads::customFieldsComeInBitOrder()
{
    const quint32 flags = customFlagsFor({ImuRoll, GyroPitch, AccZ, RotorYaw});
    QCOMPARE(flags, quint32(0x119));  // bits 0, 3, 4, 8: errata section 8
    QCOMPARE(customSize(flags), 2 + 4 * 6);
    const auto layout = customLayout(flags);
    QCOMPARE(layout.size(), std::size_t(12));
    QCOMPARE(layout[0].channel, int(ImuRoll));
    QCOMPARE(layout[0].offset, 2);
    QCOMPARE(layout[3].channel, int(RotorRoll));
    QCOMPARE(layout[3].offset, 8);
    QCOMPARE(layout[9].channel, int(AccX));
    QCOMPARE(layout[9].offset, 20);
    QCOMPARE(customSize(0x1FF), 2 + 6 * 5 + 12 + 24 + 36 + 6);
    QCOMPARE(customFlagsFor({Battery}), quint32(0));
}

void TestPayloads::laterCustomFields_data()
{
    QTest::addColumn<int>("bit");
    QTest::addColumn<QByteArray>("hex");
    QTest::addColumn<int>("channel");
    QTest::addColumn<double>("value");
    // Bytes after errata 3.9, 3.22 and 3.24, by hand; sizes are the column "Bytes".
    QTest::newRow("motor 4") << 9 << QByteArray("0100feff0000c03f") << int(Motor4Error) << -2.0;
    QTest::newRow("motor 4, output") << 9 << QByteArray("0100feff0000c03f") << int(Motor4Output) << 1.5;
    QTest::newRow("AHRS") << 10 << QByteArray("c90003040506020a0b0c0d0e0f") + QByteArray(26, '0')
                          << int(AhrsMainZ) << 0.3;
    QTest::newRow("external IMU") << 10 << QByteArray("c90003040506020a0b0c0d0e0f") + QByteArray(26, '0')
                                  << int(ExtImuPackets) << double(0x0b0a);
    QTest::newRow("encoder") << 11
                             << QByteArray("000000"
                                           "030201"
                                           "ffffff")
                             << int(EncoderPitch) << double(0x010203);
    QTest::newRow("encoder, yaw") << 11
                                  << QByteArray("000000"
                                                "030201"
                                                "ffffff")
                                  << int(EncoderYaw) << 16777215.0;
    QTest::newRow("angle in radians") << 12
                                      << QByteArray("0000803f"
                                                    "00000000"
                                                    "000080bf")
                                      << int(ImuRadYaw) << -57.29577951;
    QTest::newRow("script, float") << 13 << QByteArray(72, '0') + "0000803f" << int(ScriptFloat10) << 1.0;
    QTest::newRow("script, int") << 14 << QByteArray("ffff") + QByteArray(36, '0') << int(ScriptInt1) << -1.0;
    const QByteArray power = QByteArray(26, '0') + "f0d8d204280500" + QByteArray(12, '0')
        + QByteArray(26, '0') + "01ce043a020700";
    QTest::newRow("power, motor output") << 15 << power << int(MotorPitchOutput) << -100.0;
    QTest::newRow("power, motor current") << 15 << power << int(MotorPitchCurrent) << 1.234;
    QTest::newRow("power, motor temperature") << 15 << power << int(MotorPitchTemperature) << 40.0;
    QTest::newRow("power, motor flags") << 15 << power << int(MotorPitchFlags) << 5.0;
    QTest::newRow("power, voltage") << 15 << power << int(SupplyVoltage) << 12.3;
    QTest::newRow("power, current") << 15 << power << int(SupplyCurrent) << 0.57;
    QTest::newRow("power, flags") << 15 << power << int(PowerFlags) << 7.0;
    QTest::newRow("frame rate") << 16
                                << QByteArray("0040"
                                              "0000"
                                              "0000")
                                << int(FrameRateRoll) << 16384 * 0.06103701895;
    QTest::newRow("20 bits") << 17
                             << QByteArray("00000400"
                                           "00000000"
                                           "0100ffff")
                             << int(Imu20Roll) << 90.0;
    QTest::newRow("20 bits, target") << 18
                                     << QByteArray("00000000"
                                                   "0000fcff"
                                                   "00000000")
                                     << int(Target20Pitch) << -90.0;
    QTest::newRow("errors") << 19 << QByteArray("0100020003000f") << int(CommCanFlags) << 15.0;
    QTest::newRow("state") << 20
                           << QByteArray("10002000"
                                         "05")
            + QByteArray(16, '0')
                           << int(StateFlags) << double(0x200010);
    QTest::newRow("calibration") << 20
                                 << QByteArray("10002000"
                                               "05")
            + QByteArray(16, '0') << int(CalibrationMode)
                                 << 5.0;
    QTest::newRow("quaternion, largest") << 21 << QByteArray("0000000000000000") << int(ImuQuatW) << 1.0;
    QTest::newRow("quaternion, its sign") << 22 << QByteArray("0000000000000060") << int(TargetQuatY) << -1.0;
    QTest::newRow("quaternion, another") << 23 << QByteArray("0000000000000010") << int(FrameQuatX) << 1.0;
    QTest::newRow("analogue") << 24 << QByteArray("0000000000000110") << int(Adc4) << 4097.0;
    QTest::newRow("limits") << 25 << QByteArray("0100020003000400050006ff") << int(LimitYawHigh) << -250.0;
    QTest::newRow("follow") << 26 << QByteArray("0100020003ff") << int(FollowYaw) << -253.0;
    QTest::newRow("outside limits") << 27 << QByteArray(24, '0') + "0000000000000000ffffffff"
                                    << int(ExtHighYaw) << -1.0;
    QTest::newRow("frame-camera") << 28
                                  << QByteArray("00000000"
                                                "00000000"
                                                "00000800")
                                  << int(FrameCam20Yaw) << 180.0;
}

void TestPayloads::laterCustomFields()
{
    QFETCH(int, bit);
    QFETCH(QByteArray, hex);
    QFETCH(int, channel);
    QFETCH(double, value);
    const quint32 flags = 1U << bit;
    QCOMPARE(customFlagsFor({channel}), flags);
    const QByteArray payload = "\x12\x34" + QByteArray::fromHex(hex);
    QCOMPARE(payload.size(), customSize(flags));
    for (const WireField &field : customLayout(flags)) {
        if (field.channel == channel)
            QVERIFY2(std::abs(double(readField(field, asBytes(payload))) - value)
                         < 1e-5 * std::max(1.0, std::abs(value)),
                     qPrintable(QString::number(double(readField(field, asBytes(payload))))));
        QVERIFY(std::isnan(readField(field, asBytes(payload.left(field.offset)))));
    }
}

void TestPayloads::quaternionsSurviveEightBytes()
{
    // Errata 3.24, by hand: y is the largest and negative, w = +0.5, x = -0.25, z = 0.
    const auto w = quint64(std::lround(0.5 * 741453.786));
    const auto x = quint64(std::lround(0.25 * 741453.786));
    const quint64 packed = w | (x | 1ULL << 19) << 20 | 2ULL << 60 | 1ULL << 62;
    const auto read = unpackQuaternion(packed);
    QVERIFY(std::abs(read[0] - 0.5) < 1e-5 && std::abs(read[1] + 0.25) < 1e-5 && std::abs(read[3]) < 1e-5);
    QVERIFY(std::abs(read[2] + std::sqrt(1 - 0.25 - 0.0625)) < 1e-5);
    QCOMPARE(packQuaternion(read), packed);
    for (int i = 0; i < 4; ++i) {
        for (const double sign : {1.0, -1.0}) {
            std::array<double, 4> wanted{0.1, -0.2, 0.3, -0.1};
            wanted[std::size_t(i)] = 0;
            double rest = 1;
            for (const double part : wanted)
                rest -= part * part;
            wanted[std::size_t(i)] = sign * std::sqrt(rest);
            const auto got = unpackQuaternion(packQuaternion(wanted));
            for (std::size_t k = 0; k < 4; ++k)
                QVERIFY(std::abs(got[k] - wanted[k]) < 1e-5);
        }
    }
}

void TestPayloads::shortPayloadsAreErrors()
{
    for (int size = 0; size < 18; ++size) {
        QVERIFY(size >= 11 || !BoardInfo::decode(asBytes(ramp(size))));
        QVERIFY(!decodeAngles(asBytes(ramp(size))));
        QVERIFY(!AutoPidProgress::decode(asBytes(ramp(size))));
        QVERIFY(!decodeProfileNames(asBytes(ramp(size))));
    }
    QVERIFY(!decodeAdjVars(asBytes(hex("02 13 64 00 00 00"))));
    QVERIFY(!decodeDebugVarsInfo(Bytes()));
}

void TestPayloads::errorFrames()
{
    const Request request = confirmRequest(CommandId::MotorsOn, {}, 1);
    const auto answer = [&request](const char *payload, int id = 255) {
        const QByteArray bytes = hex(payload);
        return request.answer({id, asBytes(bytes), 1});
    };
    // Current form: command, code, data; the document's form: code, data (errata 3.18).
    QCOMPARE((*answer("4D 08 00 00 00 00")).error().boardCode, 8);
    QCOMPARE((*answer("06 00 00 00 00")).error().boardCode, 6);
    QVERIFY(!answer("16 08 00 00 00 00"));
    QVERIFY(!answer("4D"));
    QVERIFY((*answer("4D", 67)).has_value());
    QVERIFY((*answer("4D 00", 67)).has_value());
    QVERIFY(!answer("6D", 67));
    QVERIFY(errorCodeText(6).contains(u"unknown"_s));
    QVERIFY(errorCodeText(77).contains(u"77"_s));
}

QTEST_APPLESS_MAIN(TestPayloads)
#include "tst_payloads.moc"
