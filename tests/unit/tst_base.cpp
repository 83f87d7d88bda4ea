// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/axis.h"
#include "protocol/base/checksum.h"
#include "protocol/base/clock.h"
#include "protocol/base/hexbytes.h"
#include "protocol/base/namedfields.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace Qt::StringLiterals;

namespace {

QByteArray randomBytes(int count, unsigned seed)
{
    std::mt19937 random(seed);
    QByteArray bytes(count, '\0');
    for (char &byte : bytes)
        byte = char(random());
    return bytes;
}

// A reflected CRC-16 as the books give it: bit by bit.
std::uint16_t bitwise(std::uint16_t polynomial, std::uint16_t crc, const QByteArray &bytes)
{
    for (const char byte : bytes) {
        crc = std::uint16_t(crc ^ std::uint8_t(byte));
        for (int bit = 0; bit < 8; ++bit)
            crc = std::uint16_t((crc & 1) ? (crc >> 1) ^ polynomial : crc >> 1);
    }
    return crc;
}

template <typename T> bool comesBack(T value)
{
    ByteWriter writer;
    writer.write(value);
    const QByteArray bytes = writer.take();
    ByteReader reader(bytes);
    const T read = reader.read<T>();
    return bytes.size() == qsizetype(sizeof(T)) && reader.ok() && reader.remaining() == 0
        && std::memcmp(&read, &value, sizeof(T)) == 0;  // NOLINT: NaN comes back bit by bit
}

template <typename T> bool extremesComeBack()
{
    using Limits = std::numeric_limits<T>;
    return comesBack(T{}) && comesBack(Limits::min()) && comesBack(Limits::max())
        && comesBack(Limits::lowest());
}

// A payload with each type, gaps between them and bytes at the end.
constexpr NamedField kFields[] = {
    {"u8", NamedField::U8, 0, 1},    {"i8", NamedField::I8, 1, 1},      {"u16", NamedField::U16, 4, 2},
    {"i16", NamedField::I16, 6, 2},  {"u32", NamedField::U32, 8, 4},    {"i32", NamedField::I32, 12, 4},
    {"f32", NamedField::F32, 16, 4}, {"text", NamedField::Text, 22, 6}, {"bytes", NamedField::Bytes, 28, 0},
};

}  // namespace

/// Bytes, checksums, hex, named fields and the small types below everything else.
class TestBase : public QObject
{
    Q_OBJECT
private slots:
    void fieldsAreLittleEndianOneAfterTheOther();
    void extremesOfEveryTypeComeBack();
    void readingPastTheEndStaysAFailure();
    void whatDoesNotFitIsCutOff();
    void checksumsAreThePublishedOnes();
    void checksumsAreTheBitwiseOnes();
    void checksumsGoOnAcrossSpans();
    void anyFlippedBitChangesTheChecksum();
    void hexIsRead_data();
    void hexIsRead();
    void namedFieldsComeBack();
    void numbersMayBeText();
    void shortPayloadsAreRefused();
    void wrongValuesAreRefused_data();
    void wrongValuesAreRefused();
    void textsAreCutToTheirRoom();
    void failuresCarryWhatIsKnown();
    void axesAreInTheOrderOfTheField();
    void secondsThereAndBack();
};

void TestBase::fieldsAreLittleEndianOneAfterTheOther()
{
    ByteWriter writer;
    writer.u8(0xFE).i8(-2).u16(0x1234).i16(-2).u32(0xDEADBEEF).i32(-2).f32(1.5F).bytes("ab").zeros(2);
    QCOMPARE(writer.size(), qsizetype(22));
    const QByteArray bytes = writer.take();
    QCOMPARE(bytes.toHex(), QByteArray("fefe3412feffefbeaddefeffffff0000c03f61620000"));
    ByteReader reader(bytes);
    QCOMPARE(reader.u8(), quint8(0xFE));
    QCOMPARE(reader.i8(), qint8(-2));
    QCOMPARE(reader.u16(), quint16(0x1234));
    QCOMPARE(reader.i16(), qint16(-2));
    QCOMPARE(reader.u32(), 0xDEADBEEFU);
    QCOMPARE(reader.i32(), -2);
    QCOMPARE(reader.f32(), 1.5F);
    QCOMPARE(reader.position(), std::size_t(18));
    QCOMPARE(toByteArray(reader.take(2)), QByteArray("ab"));
    reader.skip(1);
    QCOMPARE(reader.remaining(), std::size_t(1));
    QCOMPARE(reader.u8(), quint8(0));
    QVERIFY(reader.ok());
}

void TestBase::extremesOfEveryTypeComeBack()
{
    QVERIFY(extremesComeBack<std::uint8_t>() && extremesComeBack<std::int8_t>());
    QVERIFY(extremesComeBack<std::uint16_t>() && extremesComeBack<std::int16_t>());
    QVERIFY(extremesComeBack<std::uint32_t>() && extremesComeBack<std::int32_t>());
    QVERIFY(extremesComeBack<std::uint64_t>() && extremesComeBack<std::int64_t>());
    QVERIFY(extremesComeBack<float>() && extremesComeBack<double>());
    QVERIFY(comesBack(2e-6F) && comesBack(-0.0F) && comesBack(std::numeric_limits<float>::denorm_min()));
    QVERIFY(comesBack(std::numeric_limits<float>::quiet_NaN())
            && comesBack(std::numeric_limits<float>::infinity()));
}

void TestBase::readingPastTheEndStaysAFailure()
{
    const QByteArray bytes("\1\2\3", 3);
    ByteReader reader(bytes);
    QCOMPARE(reader.u16(), quint16(0x0201));
    QCOMPARE(reader.u16(), quint16(0));  // one byte is left
    QVERIFY(!reader.ok());
    QCOMPARE(reader.u8(), quint8(0));  // it would fit, but what came before did not
    QVERIFY(reader.take(0).empty());
    QCOMPARE(reader.position(), std::size_t(2));
    QVERIFY(!reader.ok());

    ByteReader whole(bytes);
    QCOMPARE(whole.take(3).size(), std::size_t(3));
    QVERIFY(whole.ok());
    QVERIFY(whole.take(0).empty());
    QVERIFY(whole.ok());  // nothing was asked for
    whole.skip(1);
    QVERIFY(!whole.ok());

    const QByteArray none;
    ByteReader empty(none);
    QVERIFY(empty.ok());
    QCOMPARE(empty.take(std::numeric_limits<std::size_t>::max()).size(), std::size_t(0));
    QVERIFY(!empty.ok());
}

void TestBase::whatDoesNotFitIsCutOff()
{
    ByteWriter writer;
    writer.u8(0x1FF).u16(-1).i8(0x80);
    QCOMPARE(writer.take().toHex(), QByteArray("ffffff80"));
    QCOMPARE(writer.size(), qsizetype(0));
}

void TestBase::checksumsAreThePublishedOnes()
{
    // The check values of the catalogue of parametrised CRC algorithms.
    const QByteArray check("123456789");
    QCOMPARE(crc16Arc(asBytes(check)), quint16(0xBB3D));
    QCOMPARE(crc16Mcrf4xx(asBytes(check)), quint16(0x6F91));
    // Our own: the bits of CRC-16/ARC in reverse.
    QCOMPARE(crc16ArcReversed(asBytes(check)), quint16(0xBCDD));
    QCOMPARE(sum8(asBytes(check)), quint8(0xDD));
    QCOMPARE(crc16Arc({}), quint16(0));
    QCOMPARE(crc16Mcrf4xx({}), quint16(0xFFFF));
    QCOMPARE(crc16ArcReversed({}), quint16(0));
    QCOMPARE(sum8({}), quint8(0));
}

void TestBase::checksumsAreTheBitwiseOnes()
{
    // Every length around the eight bytes that are taken at once.
    for (int length = 0; length < 70; ++length) {
        const QByteArray bytes = randomBytes(length, unsigned(length));
        QCOMPARE(crc16Arc(asBytes(bytes)), bitwise(0xA001, 0, bytes));
        QCOMPARE(crc16Arc(asBytes(bytes), 0x1D0F), bitwise(0xA001, 0x1D0F, bytes));
        QCOMPARE(crc16Mcrf4xx(asBytes(bytes)), bitwise(0x8408, 0xFFFF, bytes));
        const std::uint16_t arc = bitwise(0xA001, 0, bytes);
        std::uint16_t reversed = 0;
        for (int bit = 0; bit < 16; ++bit)
            reversed = std::uint16_t(reversed | ((arc >> bit & 1) << (15 - bit)));
        QCOMPARE(crc16ArcReversed(asBytes(bytes)), reversed);
    }
}

void TestBase::checksumsGoOnAcrossSpans()
{
    const QByteArray bytes = randomBytes(40, 1);
    for (int at = 0; at <= bytes.size(); ++at) {
        const auto first = asBytes(QByteArrayView(bytes).first(at));
        const auto second = asBytes(QByteArrayView(bytes).sliced(at));
        QCOMPARE(crc16Arc(second, crc16Arc(first)), crc16Arc(asBytes(bytes)));
        QCOMPARE(crc16Mcrf4xx(second, crc16Mcrf4xx(first)), crc16Mcrf4xx(asBytes(bytes)));
    }
    // Over data and its own two bytes, low one first, nothing is left.
    QByteArray closed = bytes;
    const std::uint16_t crc = crc16Mcrf4xx(asBytes(bytes));
    closed.append(char(crc)).append(char(crc >> 8));
    QCOMPARE(crc16Mcrf4xx(asBytes(closed)), quint16(0));
}

void TestBase::anyFlippedBitChangesTheChecksum()
{
    const QByteArray bytes = randomBytes(64, 2);
    for (int bit = 0; bit < 8 * bytes.size(); ++bit) {
        QByteArray flipped = bytes;
        flipped[bit / 8] = char(flipped[bit / 8] ^ (1 << bit % 8));
        QVERIFY(crc16Arc(asBytes(flipped)) != crc16Arc(asBytes(bytes)));
        QVERIFY(crc16ArcReversed(asBytes(flipped)) != crc16ArcReversed(asBytes(bytes)));
        QVERIFY(crc16Mcrf4xx(asBytes(flipped)) != crc16Mcrf4xx(asBytes(bytes)));
        QVERIFY(sum8(asBytes(flipped)) != sum8(asBytes(bytes)));
    }
}

void TestBase::hexIsRead_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("valid");
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("nothing") << QString() << true << QByteArray();
    QTest::newRow("blanks only") << u" \t\n"_s << true << QByteArray();
    QTest::newRow("either case") << u"3eFf"_s << true << QByteArray("\x3E\xFF");
    QTest::newRow("blanks anywhere") << u" 3 E ff\n00 "_s << true << QByteArray("\x3E\xFF\0", 3);
    QTest::newRow("half a byte") << u"3E F"_s << false << QByteArray();
    QTest::newRow("a letter too far") << u"3G"_s << false << QByteArray();
    QTest::newRow("prefix") << u"0x3E"_s << false << QByteArray();
    QTest::newRow("commas") << u"3E,FF"_s << false << QByteArray();
    QTest::newRow("digits of another script") << u"\u0663\u0663"_s << false << QByteArray();
}

void TestBase::hexIsRead()
{
    QFETCH(QString, text);
    QFETCH(bool, valid);
    QFETCH(QByteArray, bytes);
    const auto read = bytesFromHex(text);
    QCOMPARE(read.has_value(), valid);
    if (valid)
        QCOMPARE(*read, bytes);
}

void TestBase::namedFieldsComeBack()
{
    const QVariantMap values{
        {u"u8"_s, 255},     {u"i8"_s, -128},         {u"u16"_s, 65535},
        {u"i16"_s, -32768}, {u"u32"_s, 4294967295U}, {u"i32"_s, std::numeric_limits<int>::min()},
        {u"f32"_s, 0.1F},   {u"text"_s, u"pitch"_s}, {u"bytes"_s, QByteArray("\x01\x02\x03")}};
    const auto payload = encodeFields(kFields, values);
    QVERIFY(payload);
    QCOMPARE(payload->size(), qsizetype(31));
    QCOMPARE(payload->toHex(),
             QByteArray("ff80"
                        "0000"
                        "ffff0080ffffffff00000080cdcccc3d"
                        "0000"
                        "706974636800"
                        "010203"));
    const auto read = decodeFields(kFields, asBytes(*payload));
    QVERIFY(read);
    QCOMPARE(*read, values);

    // What is not named is zero, up to the size.
    const auto padded = encodeFields(kFields, {}, 40);
    QVERIFY(padded);
    QCOMPARE(*padded, QByteArray(40, '\0'));
    QCOMPARE(decodeFields(kFields, asBytes(*padded))->value(u"bytes"_s).toByteArray(), QByteArray(12, '\0'));
}

void TestBase::numbersMayBeText()
{
    const auto payload = encodeFields(
        kFields, {{u"u16"_s, u"513"_s}, {u"f32"_s, u"1.5"_s}, {u"bytes"_s, u"0a 0B"_s}, {u"i8"_s, u"-1"_s}});
    QVERIFY(payload);
    const auto read = decodeFields(kFields, asBytes(*payload));
    QVERIFY(read);
    QCOMPARE(read->value(u"u16"_s).toInt(), 513);
    QCOMPARE(read->value(u"f32"_s).toFloat(), 1.5F);
    QCOMPARE(read->value(u"i8"_s).toInt(), -1);
    QCOMPARE(read->value(u"bytes"_s).toByteArray(), QByteArray("\x0A\x0B"));
}

void TestBase::shortPayloadsAreRefused()
{
    const QByteArray payload = encodeFields(kFields, {}).value();
    for (qsizetype length = 0; length < payload.size(); ++length) {
        const auto read = decodeFields(kFields, asBytes(QByteArrayView(payload).first(length)));
        QVERIFY(!read);
        QCOMPARE(read.error().code, ErrorCode::BadReply);
    }
    QVERIFY(decodeFields(kFields, asBytes(payload)));
    QVERIFY(decodeFields({}, {})->isEmpty());
}

void TestBase::wrongValuesAreRefused_data()
{
    QTest::addColumn<QString>("field");
    QTest::addColumn<QVariant>("value");
    QTest::addColumn<int>("code");
    const int range = int(ErrorCode::OutOfRange);
    const int invalid = int(ErrorCode::InvalidArgument);
    QTest::newRow("u8 too large") << u"u8"_s << QVariant(256) << range;
    QTest::newRow("u8 negative") << u"u8"_s << QVariant(-1) << range;
    QTest::newRow("i8 too small") << u"i8"_s << QVariant(-129) << range;
    QTest::newRow("u16 too large") << u"u16"_s << QVariant(65536) << range;
    QTest::newRow("i16 too large") << u"i16"_s << QVariant(32768) << range;
    QTest::newRow("u32 too large") << u"u32"_s << QVariant(4294967296LL) << range;
    QTest::newRow("i32 too small") << u"i32"_s << QVariant(-2147483649LL) << range;
    QTest::newRow("no whole number") << u"u16"_s << QVariant(u"many"_s) << invalid;
    QTest::newRow("no number") << u"f32"_s << QVariant(u"much"_s) << invalid;
    QTest::newRow("no hex") << u"bytes"_s << QVariant(u"0g"_s) << invalid;
    QTest::newRow("no such field") << u"colour"_s << QVariant(1) << invalid;
}

void TestBase::wrongValuesAreRefused()
{
    QFETCH(QString, field);
    QFETCH(QVariant, value);
    QFETCH(int, code);
    const auto payload = encodeFields(kFields, {{field, value}});
    QVERIFY(!payload);
    QCOMPARE(int(payload.error().code), code);
    QVERIFY2(payload.error().detail.contains(field), qPrintable(payload.error().detail));
}

void TestBase::textsAreCutToTheirRoom()
{
    const auto payload = encodeFields(kFields, {{u"text"_s, u"pitch axis"_s}});
    QVERIFY(payload);
    QCOMPARE(payload->size(), qsizetype(28));
    // A text that fills its room ends there, without a zero.
    QCOMPARE(decodeFields(kFields, asBytes(*payload))->value(u"text"_s).toString(), u"pitch "_s);
}

void TestBase::failuresCarryWhatIsKnown()
{
    const Result<int> failed = failure(ErrorCode::BoardError, u"CALIB_ACC"_s, 8);
    QVERIFY(!failed);
    QCOMPARE(failed.error(), (Error{ErrorCode::BoardError, u"CALIB_ACC"_s, 8}));
    QVERIFY(failed.error() != (Error{ErrorCode::BoardError, u"CALIB_ACC"_s, 7}));
    const Result<void> bare = failure(ErrorCode::Timeout);
    QVERIFY(bare.error().detail.isEmpty() && bare.error().boardCode == 0);
}

void TestBase::axesAreInTheOrderOfTheField()
{
    QStringList keys;
    for (const Axis axis : kAxes)
        keys.append(QString::fromLatin1(axisKey(axis)));
    QCOMPARE(keys, (QStringList{u"roll"_s, u"pitch"_s, u"yaw"_s}));
    QCOMPARE(kAxisCount, 3);
    QVERIFY(!*axisKey(Axis::None));
}

void TestBase::secondsThereAndBack()
{
    QCOMPARE(seconds(1500ms), 1.5);
    QCOMPARE(seconds(-250us), -0.00025);
    QCOMPARE(durationFromSeconds(0.0008), Duration(800us));
    for (const double value : {0.0, 1e-9, 0.1, 12345.678, -3.25})
        QVERIFY(std::abs(seconds(durationFromSeconds(value)) - value) <= 1e-9);
}

QTEST_APPLESS_MAIN(TestBase)
#include "tst_base.moc"
