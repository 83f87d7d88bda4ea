// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/filefault.h"
#include "protocol/configuration/livevalues.h"
#include "protocol/record/configurationfile.h"
#include "tests/support/valuetable.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRandomGenerator>
#include <QTest>

#include <bit>
#include <cmath>

using namespace valuetable;
using namespace Qt::StringLiterals;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

/// What this configuration's block holds where the parameter is.
QByteArray bytesOf(const Configuration &configuration, const char *key)
{
    const ParameterSpec &parameter = spec(configuration, key);
    return configuration.block({0, Numbers}).mid(parameter.offset, wireSize(parameter.row->wire));
}

/// The configuration with these bytes put where the parameter is, as a board may send them.
Configuration holding(const char *key, const QByteArray &bytes)
{
    Configuration result = configuration();
    QByteArray block = result.block({0, Numbers});
    block.replace(spec(result, key).offset, bytes.size(), bytes);
    result.setBlock({0, Numbers}, block);
    return result;
}

Result<ConfigurationFile> fromJson(const QByteArray &json)
{
    return ConfigurationFile::fromJson(json, [](const BoardIdentity &) { return parameters(); });
}

QByteArray toJson(const Configuration &configuration)
{
    return ConfigurationFile::toJson(configuration, u"test"_s, QDateTime::currentDateTimeUtc());
}

/// The file with another value for this parameter, or with none of the raw blocks.
QByteArray changedFile(const Configuration &configuration, const QString &key, const QJsonValue &value)
{
    QJsonObject root = QJsonDocument::fromJson(toJson(configuration)).object();
    QJsonArray profiles = root[u"profiles"_s].toArray();
    QJsonObject profile = profiles[0].toObject();
    QJsonObject values = profile[u"values"_s].toObject();
    values[key] = value;
    profile[u"values"_s] = values;
    profiles[0] = profile;
    root[u"profiles"_s] = profiles;
    return QJsonDocument(root).toJson();
}

float randomFloat(QRandomGenerator &random)
{
    for (;;) {
        const auto value = std::bit_cast<float>(random.generate());
        if (std::isfinite(value))
            return value;
    }
}

}  // namespace

class TestValues : public QObject
{
    Q_OBJECT
private slots:
    void valuesNeedTheirBlock();
    void wireTypes_data();
    void wireTypes();
    void shortBlocksHoldNothing();
    void bitFieldsLeaveTheirNeighboursAlone();
    void floatsAreTheNearestOnes();
    void integersStayIntegers();
    void everyFloatSurvivesItsText();
    void everyCountSurvivesItsText();
    void textsAreShort_data();
    void textsAreShort();
    void nonsenseIsNotParsed_data();
    void nonsenseIsNotParsed();
    void nothingButNumbersIsSet();
    void aBoardMayHoldNoNumber_data();
    void aBoardMayHoldNoNumber();
    void otherValuesLeaveItsBytesAlone();
    void differencesWithoutNumbers();
    void liveValuesWithoutNumbers();
    void filesAreExact();
    void filesKeepWhatIsNoNumber();
    void filesWithNonsenseNameTheEntry_data();
    void filesWithNonsenseNameTheEntry();
    void filesEditedByHandCountToTheLastDigit();
    void filesOfEarlierVersionsShowedRoundedCounts();
    void rangesAreChecked();
    void textsOfAnyLengthInFiles();
    void textsGoOntoBoards();
};

// A file without the block is no file with wrong values.
void TestValues::valuesNeedTheirBlock()
{
    QJsonObject root = QJsonDocument::fromJson(toJson(configuration())).object();
    root.remove(u"blocks"_s);
    const auto read = fromJson(QJsonDocument(root).toJson());
    QVERIFY(!read && read.error().file);
    QCOMPARE(read.error().file->problem, FileProblem::MissingEntry);
    QVERIFY(read.error().file->key.startsWith(u"blocks: 1/"_s));
}

// Worked out by hand; floats from IEEE 754: sign, eight bits of exponent (bias 127), 23 of fraction.
void TestValues::wireTypes_data()
{
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<double>("value");
    QTest::addColumn<QByteArray>("hex");
    // clang-format off
    const struct { const char *key; double value; const char *hex; } rows[] = {
        {"u8", 0, "00"}, {"u8", 255, "ff"}, {"u8", 165, "a5"},
        {"i8", 0, "00"}, {"i8", -128, "80"}, {"i8", 127, "7f"}, {"i8", -1, "ff"}, {"i8", -91, "a5"},
        {"u16", 0, "0000"}, {"u16", 65535, "ffff"}, {"u16", 4660, "3412"},
        {"i16", 0, "0000"}, {"i16", -32768, "0080"}, {"i16", 32767, "ff7f"}, {"i16", -2, "feff"},
        {"u32", 0, "00000000"}, {"u32", 4294967295, "ffffffff"}, {"u32", 305419896, "78563412"},
        {"u32", 16777217, "01000001"},  // no float holds it
        {"i32", 0, "00000000"}, {"i32", -2147483648.0, "00000080"}, {"i32", 2147483647, "ffffff7f"},
        {"i32", -2, "feffffff"}, {"i32", -16777217, "fffffffe"},
        {"be.u16", 4660, "1234"}, {"be.u16", 65535, "ffff"},
        {"be.i16", -32768, "8000"}, {"be.i16", 32767, "7fff"}, {"be.i16", -2, "fffe"},
        {"be.u32", 0, "00000000"}, {"be.u32", 4294967295, "ffffffff"}, {"be.u32", 305419896, "12345678"},
        {"be.i32", -2147483648.0, "80000000"}, {"be.i32", 2147483647, "7fffffff"}, {"be.i32", -2, "fffffffe"},
        {"f32", 0, "00000000"}, {"f32", -0.0, "00000080"}, {"f32", 1, "0000803f"}, {"f32", -2, "000000c0"},
        {"f32", 0.5, "0000003f"}, {"f32", 16777216, "0000804b"},
        {"f32", std::ldexp(8796093.0, -42), "bd370636"},  // 2e-6: 0x8637bd * 2^-42
        {"f32", std::ldexp(1.0, -149), "01000000"}, {"f32", -std::ldexp(1.0, -149), "01000080"},  // smallest denormal
        {"f32", std::ldexp(8388607.0, -149), "ffff7f00"},  // largest denormal
        {"f32", std::ldexp(1.0, -126), "00008000"}, {"f32", std::ldexp(16777215.0, 104), "ffff7f7f"},
        {"f32", -std::ldexp(16777215.0, 104), "ffff7fff"},
        {"be.f32", 1, "3f800000"}, {"be.f32", -0.0, "80000000"},
        {"be.f32", std::ldexp(8796093.0, -42), "360637bd"}, {"be.f32", std::ldexp(1.0, -149), "00000001"},
    };
    // clang-format on
    for (const auto &row : rows)
        QTest::addRow("%s %.9g", row.key, row.value)
            << QByteArray(row.key) << row.value << QByteArray(row.hex);
}

void TestValues::wireTypes()
{
    QFETCH(QByteArray, key);
    QFETCH(double, value);
    QFETCH(QByteArray, hex);
    Configuration board = configuration();
    QVERIFY(board.setRaw(spec(board, key), 0, value));
    QCOMPARE(bytesOf(board, key).toHex(), hex);
    QCOMPARE(std::bit_cast<quint64>(*board.raw(spec(board, key), 0)), std::bit_cast<quint64>(value));
    QCOMPARE(*holding(key, QByteArray::fromHex(hex)).raw(spec(board, key), 0), value);
    // Nothing beside it has changed.
    QByteArray block = board.block({0, Numbers});
    const qsizetype size = hex.size() / 2;
    block.replace(spec(board, key).offset, size, QByteArray(size, '\0'));
    QCOMPARE(block, QByteArray(kNumbersSize, '\0'));
    // The same through the text of files and of the command line.
    const auto parsed = spec(board, key).parse(spec(board, key).format(value));
    QVERIFY(parsed);
    QCOMPARE(std::bit_cast<quint64>(*parsed), std::bit_cast<quint64>(value));
}

void TestValues::shortBlocksHoldNothing()
{
    const Configuration board = configuration();
    for (const ParameterSpec &parameter : board.parameters().all()) {
        QByteArray tooShort(parameter.offset + wireSize(parameter.row->wire) - 1, 'x');
        const QByteArray before = tooShort;
        QVERIFY(!parameter.read(tooShort));
        QVERIFY(!parameter.write(tooShort, 1));
        QVERIFY(!parameter.copy(tooShort, board.block({0, Numbers})));
        QCOMPARE(tooShort, before);
    }
}

void TestValues::bitFieldsLeaveTheirNeighboursAlone()
{
    Configuration board = holding("field.low", QByteArray::fromHex("a5a5a5a5"));
    QCOMPARE(*board.raw(spec(board, "field.low"), 0), 5);
    QCOMPARE(*board.raw(spec(board, "field.high"), 0), 10);
    QVERIFY(board.setRaw(spec(board, "field.high"), 0, 15));
    QCOMPARE(bytesOf(board, "field.low").toHex(), "f5a5a5a5");
    QVERIFY(board.setRaw(spec(board, "field.low"), 0, 0));
    QCOMPARE(bytesOf(board, "field.low").toHex(), "f5a5a5a0");
    Configuration other = holding("field.low", QByteArray::fromHex("00000011"));
    QVERIFY(board.copyRaw(spec(board, "field.low"), 0, other));
    QCOMPARE(bytesOf(board, "field.low").toHex(), "f5a5a5b1");
}

void TestValues::floatsAreTheNearestOnes()
{
    const Configuration board = configuration();
    const ParameterSpec &gain = spec(board, "gain.1");
    QCOMPARE(gain.toRaw(2e-6), double(2e-6F));
    QCOMPARE(gain.defaultRaw, double(2e-6F));
    QVERIFY(gain.isInRange(0.1));  // the end of the range itself, as a float
    QVERIFY(gain.isInRange(double(0.1F)));
    QVERIFY(!gain.isInRange(0.10001));
    QCOMPARE(gain.clamped(7), double(0.1F));
    QCOMPARE(gain.clamped(-7), 0.0);
    QCOMPARE(gain.minText(), u"0"_s);
    QCOMPARE(gain.maxText(), u"0.1"_s);
    QCOMPARE(gain.rounded(2e-6), u"0.0000"_s);  // the screen's decimals
    QRandomGenerator random(1);
    for (int i = 0; i < 2000; ++i) {
        const double value = randomFloat(random);
        QByteArray block(kNumbersSize, '\0');
        const ParameterSpec &any = spec(board, i % 2 ? "f32" : "be.f32");
        QVERIFY(any.write(block, value));
        QCOMPARE(std::bit_cast<quint64>(*any.read(block)), std::bit_cast<quint64>(value));
        QCOMPARE(any.toRaw(any.toDisplay(value)), value);
    }
}

void TestValues::integersStayIntegers()
{
    Configuration board = configuration();
    QCOMPARE(spec(board, "i8").toRaw(-0.2), 0.0);
    QVERIFY(!std::signbit(spec(board, "i8").toRaw(-0.2)));
    QCOMPARE(spec(board, "i8").toRaw(-1.5), -2.0);
    QCOMPARE(spec(board, "scaled").toRaw(0.0050001), 2500.0);
    const auto refused = board.setRaw(spec(board, "u8"), 0, 1.5);
    QCOMPARE(refused.error().code, ErrorCode::InvalidArgument);
    QVERIFY(refused.error().detail.contains(u"u8"_s));
    for (const double value : {-1.0, 256.0, 1e300})
        QCOMPARE(board.setRaw(spec(board, "u8"), 0, value).error().code, ErrorCode::OutOfRange);
    QCOMPARE(board.setRaw(spec(board, "u32"), 0, 4294967296).error().code, ErrorCode::OutOfRange);
    QCOMPARE(board.setRaw(spec(board, "i32"), 0, -2147483649.0).error().code, ErrorCode::OutOfRange);
    QCOMPARE(board.block({0, Numbers}), QByteArray(kNumbersSize, '\0'));
}

void TestValues::everyFloatSurvivesItsText()
{
    const Configuration board = configuration();
    const ParameterSpec &any = spec(board, "f32");
    QRandomGenerator random(2);
    for (int i = 0; i < 5000; ++i) {
        const double value = randomFloat(random);
        const auto parsed = any.parse(any.format(value));
        QVERIFY2(parsed, qPrintable(any.format(value)));
        QCOMPARE(std::bit_cast<quint64>(*parsed), std::bit_cast<quint64>(value));
    }
}

void TestValues::everyCountSurvivesItsText()
{
    const Configuration board = configuration();
    QRandomGenerator random(3);
    for (int i = 0; i < 5000; ++i) {
        const double count = random.generate();
        for (const char *key : {"u32", "scaled"})
            QCOMPARE(*spec(board, key).parse(spec(board, key).format(count)), count);
        const double signedCount = qint32(random.generate());
        QCOMPARE(*spec(board, "i32").parse(spec(board, "i32").format(signedCount)), signedCount);
    }
}

void TestValues::textsAreShort_data()
{
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("text");
    // clang-format off
    const struct { const char *key; double value; const char16_t *text; } rows[] = {
        {"f32", 0, u"0"}, {"f32", 1, u"1"}, {"f32", 100000, u"100000"}, {"f32", double(0.1F), u"0.1"},
        {"f32", double(2e-6F), u"2e-06"}, {"f32", double(-1.5e-7F), u"-1.5e-07"}, {"f32", double(3.4e38F), u"3.4e+38"},
        {"f32", 16777216, u"16777216"}, {"f32", double(1.0F / 3.0F), u"0.33333334"}, {"f32", -0.0, u"-0"},
        {"u32", 4294967295, u"4294967295"}, {"i32", -2147483648.0, u"-2147483648"},
        {"scaled", 5000, u"0.01"},  // the row's decimals are enough
        {"scaled", 1, u"2e-06"},  // and here they are not
        {"f32", kNan, u"no number"},
    };
    // clang-format on
    for (const auto &row : rows)
        QTest::addRow("%s %s", row.key, qPrintable(QString::fromUtf16(row.text)))
            << QByteArray(row.key) << row.value << QString::fromUtf16(row.text);
}

void TestValues::textsAreShort()
{
    QFETCH(QByteArray, key);
    QFETCH(double, value);
    QFETCH(QString, text);
    const Configuration board = configuration();
    QCOMPARE(spec(board, key).format(value), text);
}

void TestValues::nonsenseIsNotParsed_data()
{
    QTest::addColumn<QString>("text");
    for (const auto *text : {u"nan", u"NaN", u"inf", u"-inf", u"infinity", u"1e999", u"-1e999", u"no number",
                             u"", u" ", u"1,5", u"0x", u"1e", u"--1", u"12V"})
        QTest::addRow("'%s'", qPrintable(QString::fromUtf16(text))) << QString::fromUtf16(text);
}

void TestValues::nonsenseIsNotParsed()
{
    QFETCH(QString, text);
    const Configuration board = configuration();
    for (const ParameterSpec &parameter : board.parameters().all())
        QVERIFY2(!parameter.parse(text), qPrintable(parameter.key));
    // What a double holds and a float does not.
    for (const QString &large : {u"1e39"_s, u"-3.5e38"_s})
        QVERIFY(!spec(board, "f32").parse(large));
}

void TestValues::nothingButNumbersIsSet()
{
    Configuration board = configuration();
    for (const ParameterSpec &parameter : board.parameters().all()) {
        for (const double value : {kNan, kInf, -kInf}) {
            const auto refused = board.setRaw(parameter, 0, value);
            QCOMPARE(refused.error().code, ErrorCode::OutOfRange);
            QVERIFY2(refused.error().detail.contains(parameter.key), qPrintable(refused.error().detail));
            QVERIFY(!parameter.isInRange(value));
            QByteArray block(kNumbersSize, 'x');
            QVERIFY(!parameter.write(block, value));
            QCOMPARE(block, QByteArray(kNumbersSize, 'x'));
        }
    }
    QCOMPARE(board.setRaw(spec(board, "f32"), 0, 1e39).error().code, ErrorCode::OutOfRange);
    QVERIFY(board.changesTo(configuration()).empty());
}

void TestValues::aBoardMayHoldNoNumber_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("NaN") << QByteArray::fromHex("0000c07f");
    QTest::newRow("NaN that signals, with a message") << QByteArray::fromHex("efbeadff");
    QTest::newRow("infinite") << QByteArray::fromHex("0000807f");
    QTest::newRow("minus infinite") << QByteArray::fromHex("000080ff");
}

void TestValues::aBoardMayHoldNoNumber()
{
    QFETCH(QByteArray, bytes);
    const Configuration board = holding("f32", bytes);
    const auto value = board.raw(spec(board, "f32"), 0);
    QVERIFY(value && std::isnan(*value));
    QCOMPARE(spec(board, "f32").format(*value), u"no number"_s);
    QVERIFY(sameValue(value, kNan));
    QVERIFY(!sameValue(value, 0.0));
    QVERIFY(!sameValue(value, std::nullopt));
    // The bytes go where the value is taken over.
    Configuration other = configuration();
    QVERIFY(other.copyRaw(spec(other, "f32"), 0, board));
    QCOMPARE(bytesOf(other, "f32"), bytes);
}

void TestValues::otherValuesLeaveItsBytesAlone()
{
    const QByteArray bytes = QByteArray::fromHex("efbeadff");
    Configuration board = holding("f32", bytes);
    for (const ParameterSpec &parameter : board.parameters().all()) {
        if (parameter.key != u"f32"_s)
            QVERIFY(board.setRaw(parameter, 0, parameter.row->max));
    }
    QCOMPARE(bytesOf(board, "f32"), bytes);
    QVERIFY(board.setRaw(spec(board, "f32"), 0, 1));
    QCOMPARE(*board.raw(spec(board, "f32"), 0), 1.0);
}

void TestValues::differencesWithoutNumbers()
{
    const Configuration board = holding("f32", QByteArray::fromHex("0000c07f"));
    QVERIFY(board.changesTo(board).empty());
    Configuration edited = board;
    QVERIFY(edited.setRaw(spec(edited, "gain.2"), 0, 2e-6));
    auto changes = board.changesTo(edited);
    QCOMPARE(changes.size(), std::size_t(1));
    QCOMPARE(changes[0].to, double(2e-6F));
    QVERIFY(edited.setRaw(spec(edited, "f32"), 0, 3));
    changes = board.changesTo(edited);
    QCOMPARE(changes.size(), std::size_t(2));
    QVERIFY(std::isnan(changes[0].from));
    QCOMPARE(changes[0].to, 3.0);
    // 0 and -0 are one number.
    Configuration minusZero = configuration();
    QVERIFY(minusZero.setRaw(spec(minusZero, "f32"), 0, -0.0));
    QVERIFY(configuration().changesTo(minusZero).empty());
}

void TestValues::liveValuesWithoutNumbers()
{
    Configuration read = holding("f32", QByteArray::fromHex("0000c07f"));
    QVERIFY(read.setRaw(spec(read, "gain.1"), 0, 0.05));
    const Configuration stored
        = withoutLive(read, {{u"gain.1"_s, double(2e-6F), double(0.05F)}, {u"f32"_s, 1.0, kNan}});
    QCOMPARE(*stored.raw(spec(stored, "gain.1"), 0), double(2e-6F));
    QCOMPARE(*stored.raw(spec(stored, "f32"), 0), 1.0);
}

void TestValues::filesAreExact()
{
    QRandomGenerator random(4);
    for (int i = 0; i < 50; ++i) {
        Configuration board = configuration();
        QVERIFY(board.setRaw(spec(board, "u32"), 0, i == 0 ? 4294967295.0 : double(random.generate())));
        QVERIFY(
            board.setRaw(spec(board, "i32"), 0, i == 0 ? -2147483648.0 : double(qint32(random.generate()))));
        QVERIFY(board.setRaw(spec(board, "gain.1"), 0, 2e-6));
        QVERIFY(board.setRaw(spec(board, "scaled"), 0, random.generate()));
        QVERIFY(board.setRaw(spec(board, "be.f32"), 0, randomFloat(random)));
        const auto file = fromJson(toJson(board));
        QVERIFY(file);
        QVERIFY(file->configuration.blocks() == board.blocks());
        // Values alone are as good as the blocks.
        QJsonObject root = QJsonDocument::fromJson(toJson(board)).object();
        QJsonObject blocks = root[u"blocks"_s].toObject();
        blocks[u"1/NUMBERS"_s] = QString::fromLatin1(QByteArray(kNumbersSize, '\0').toHex());
        root[u"blocks"_s] = blocks;
        const auto fromValues = fromJson(QJsonDocument(root).toJson());
        QVERIFY2(fromValues, fromValues ? "" : qPrintable(fromValues.error().detail));
        QVERIFY(fromValues->configuration.blocks() == board.blocks());
    }
}

void TestValues::filesKeepWhatIsNoNumber()
{
    Configuration board = holding("f32", QByteArray::fromHex("efbeadff"));
    QVERIFY(board.setRaw(spec(board, "u8"), 0, 7));
    const QByteArray json = toJson(board);
    QVERIFY(json.contains("\"f32\": null"));
    const auto file = fromJson(json);
    QVERIFY2(file, file ? "" : qPrintable(file.error().detail));
    QVERIFY(file->configuration.blocks() == board.blocks());
    // A number written in its place by hand counts.
    const auto edited = fromJson(changedFile(board, u"f32"_s, 2.5));
    QVERIFY(edited);
    QCOMPARE(*edited->configuration.raw(spec(board, "f32"), 0), 2.5);
    // Put onto a board: the one that is no number stays behind, by name, unless the board has it as well.
    QStringList skipped;
    Configuration result = applied(configuration(), file->configuration, skipped);
    QCOMPARE(skipped, QStringList{u"f32"_s});
    QCOMPARE(*result.raw(spec(result, "u8"), 0), 7.0);
    skipped.clear();
    result = applied(board, file->configuration, skipped);
    QVERIFY(skipped.isEmpty());
    QVERIFY(result.blocks() == board.blocks());
}

void TestValues::filesWithNonsenseNameTheEntry_data()
{
    QTest::addColumn<QByteArray>("value");
    for (const char *value :
         {"null", "\"nan\"", "\"inf\"", "\"1e999\"", "1e999", "-1e999", "nan", "1e39", "true1", "[1]", "{}"})
        QTest::newRow(value) << QByteArray(value);
}

void TestValues::filesWithNonsenseNameTheEntry()
{
    QFETCH(QByteArray, value);
    QByteArray json = changedFile(configuration(), u"gain.3"_s, u"HERE"_s);
    json.replace("\"HERE\"", value);
    const auto file = fromJson(json);
    QVERIFY(!file);
    QCOMPARE(file.error().code, ErrorCode::BadFile);
    QVERIFY2(file.error().detail.contains(u"gain.3"_s), qPrintable(file.error().detail));
}

void TestValues::filesEditedByHandCountToTheLastDigit()
{
    Configuration board = configuration();
    QVERIFY(board.setRaw(spec(board, "gain.1"), 0, 2e-6));
    const auto edited = fromJson(changedFile(board, u"gain.1"_s, 3e-6));
    QVERIFY(edited);
    QCOMPARE(*edited->configuration.raw(spec(board, "gain.1"), 0), double(3e-6F));
    const auto tooLarge = fromJson(changedFile(board, u"gain.1"_s, 0.2));
    QCOMPARE(tooLarge.error().code, ErrorCode::BadFile);
    QVERIFY(tooLarge.error().detail.contains(u"gain.1"_s));
}

// Before, counts had the decimals of the screen in files as well, which may stand for several counts.
void TestValues::filesOfEarlierVersionsShowedRoundedCounts()
{
    Configuration board = configuration();
    QVERIFY(board.setRaw(spec(board, "scaled"), 0, 5123));  // 0.010246
    const auto file = fromJson(changedFile(board, u"scaled"_s, 0.01));
    QVERIFY(file);
    QCOMPARE(*file->configuration.raw(spec(board, "scaled"), 0), 5123.0);
}

void TestValues::rangesAreChecked()
{
    const auto fits = [](const ParameterRow &row) { return rangesFit({&row, 1}); };
    QVERIFY(fits({.wire = WireType::U32, .max = 4294967295}));
    QVERIFY(!fits({.wire = WireType::U32, .max = 4294967296}));
    QVERIFY(!fits({.wire = WireType::U32, .min = -1}));
    QVERIFY(fits({.wire = WireType::I32, .min = -2147483648.0}));
    QVERIFY(!fits({.wire = WireType::I32, .min = -2147483649.0}));
    QVERIFY(!fits({.wire = WireType::U8, .max = 1.5}));
    QVERIFY(!fits({.wire = WireType::U8, .max = 256}));
    QVERIFY(!fits({.wire = WireType::U8, .defaults = {0.5}}));
    QVERIFY(fits({.wire = WireType::F32, .max = 1.5, .defaults = {0.5}}));
    QVERIFY(!fits({.wire = WireType::F32, .max = 1e39}));
    QVERIFY(!fits({.wire = WireType::F32, .max = kNan}));
    QVERIFY(!fits({.wire = WireType::F32, .max = 1, .defaults = {kNan}}));
    QVERIFY(!fits({.wire = WireType::F32, .max = 1, .defaults = {2}}));
    QVERIFY(!fits({.wire = WireType::F32, .bitCount = 4, .max = 1}));
    QVERIFY(!fits({.wire = WireType::F32, .kind = ValueKind::Choice, .max = 1}));
    QVERIFY(fits({.wire = WireType::U32, .bitShift = 31, .bitCount = 1, .max = 1}));
    QVERIFY(!fits({.wire = WireType::U32, .bitShift = 31, .bitCount = 2, .max = 1}));
    QVERIFY(fits({.wire = WireType::U32, .bitCount = 32, .max = 4294967295}));
    QVERIFY(!fits({.wire = WireType::I16, .kind = ValueKind::Flags, .max = 1}));
    const ParameterRow word{.block = 1, .offset = 2, .wire = WireType::F32};
    QVERIFY(coversBlock<6>({&word, 1}, 1, std::array{std::pair{0, 2}}));
    QVERIFY(!coversBlock<7>({&word, 1}, 1, std::array{std::pair{0, 2}}));
    QVERIFY(!coversBlock<6>({&word, 1}, 1, std::array{std::pair{0, 3}}));
    QVERIFY(!coversBlock<5>({&word, 1}, 1, std::array{std::pair{0, 2}}));
}

void TestValues::textsOfAnyLengthInFiles()
{
    const BlockSpec &document = *configuration().parameters().block(Document);
    QVERIFY(document.isText() && document.holds(0) && document.holds(4096) && !document.holds(4097));
    const BlockSpec &numbers = *configuration().parameters().block(Numbers);
    QVERIFY(!numbers.isData() && numbers.holds(kNumbersSize) && !numbers.holds(kNumbersSize + 1));
    for (const QByteArray &text : {QByteArray(), QByteArray("a = \"ä\"\n"), QByteArray(4096, 'x')}) {
        Configuration board = configuration();
        board.setBlock({0, Document}, text);
        const auto changes = configuration().dataChangesTo(board);
        QCOMPARE(changes.size(), std::size_t(1));
        QCOMPARE(changes[0].to, text);
        const auto file = fromJson(toJson(board));
        QVERIFY2(file, file ? "" : qPrintable(file.error().detail));
        QVERIFY(file->configuration.blocks() == board.blocks());
    }
    Configuration tooLong = configuration();
    tooLong.setBlock({0, Document}, QByteArray(4097, 'x'));
    const auto refused = fromJson(toJson(tooLong));
    QCOMPARE(refused.error().code, ErrorCode::BadFile);
    QVERIFY(refused.error().detail.contains(u"DOCUMENT"_s));
}

void TestValues::textsGoOntoBoards()
{
    const BlockKey key{0, Document};
    Configuration file = configuration();
    file.setBlock(key, "b = 2\n");
    // Onto an empty text as well, and onto other firmware: a text says itself what it means.
    Configuration board(identity(), std::make_shared<ParameterSet>(kRows, kBlocks, 2, Capabilities{}));
    board.setBlock({0, Numbers}, QByteArray(kNumbersSize, '\0'));
    board.setBlock(key, {});
    QStringList skipped;
    QCOMPARE(applied(board, file, skipped).block(key), "b = 2\n");
    QVERIFY(skipped.isEmpty());
    // Not onto a board without one, or with less room.
    Configuration without(identity(), parameters());
    without.setBlock({0, Numbers}, QByteArray(kNumbersSize, '\0'));
    QVERIFY(!applied(without, file, skipped).blocks().contains(key));
    QCOMPARE(skipped, QStringList{u"Settings text"_s});
    skipped.clear();
    std::array<BlockSpec, 2> blocks{kBlocks[0], kBlocks[1]};
    blocks[1].maxSize = 3;
    Configuration small(identity(), std::make_shared<ParameterSet>(kRows, blocks, 1, Capabilities{}));
    small.setBlock({0, Numbers}, QByteArray(kNumbersSize, '\0'));
    small.setBlock(key, "a");
    QCOMPARE(applied(small, file, skipped).block(key), "a");
    QCOMPARE(skipped, QStringList{u"Settings text"_s});
}

QTEST_GUILESS_MAIN(TestValues)
#include "tst_values.moc"
