// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/checksum.h"
#include "protocol/simplebgc/commands.h"
#include "protocol/simplebgc/framer.h"
#include "tests/support/virtualboard.h"

#include <QTest>

#include <random>

namespace {

QList<Frame> framesOf(const QByteArray &bytes, qsizetype chunk, FramerStatistics *statistics = nullptr)
{
    simplebgc::Framer framer;
    QList<Frame> frames;
    const FrameSink sink = [&frames](const FrameView &view) { frames.append(Frame(view)); };
    for (qsizetype i = 0; i < bytes.size(); i += chunk)
        framer.feed(asBytes(QByteArrayView(bytes).sliced(i, std::min(chunk, bytes.size() - i))), sink);
    framer.flush(sink);
    if (statistics)
        *statistics = framer.statistics();
    return frames;
}

}  // namespace

class TestFramer : public QObject
{
    Q_OBJECT
private slots:
    void checksums();
    void knownFrames_data();
    void knownFrames();
    void rampFrames_data();
    void rampFrames();
    void anyChunkSizeGivesTheSameFrames();
    void rescansAfterBadHeader();
    void rescansInsideADamagedBody();
    void startBytesInsidePayloadsDoNoHarm();
    void rejectsIdZero();
    void truncatedFrameIsGivenUpOnFlush();
    void statisticsAddUp();
    void randomNoiseNeverCrashesAndAcceptsByChanceOnly();
    void findsEveryIntactFrameAmongDamagedOnes();
};

void TestFramer::checksums()
{
    // Check values of errata 1.2.
    QCOMPARE(crc16Arc(asBytes(QByteArrayView("123456789"))), quint16(0xBB3D));
    QCOMPARE(crc16ArcReversed(asBytes(QByteArrayView("123456789"))), quint16(0xBCDD));
    QCOMPARE(crc16ArcReversed(asBytes(hex("560056"))), quint16(0x0674));
    QCOMPARE(sum8(asBytes(hex("FF02"))), quint8(1));
}

void TestFramer::knownFrames_data()
{
    // Errata section 8.
    QTest::addColumn<int>("id");
    QTest::addColumn<QByteArray>("payload");
    QTest::addColumn<QByteArray>("version1");
    QTest::addColumn<QByteArray>("version2");
    const auto row = [](const char *name, int id, const char *payload, const char *v1, const char *v2) {
        QTest::newRow(name) << id << hex(payload) << hex(v1) << hex(v2);
    };
    row("BOARD_INFO", 86, "", "3E 56 00 56 00", "24 56 00 56 74 06");
    row("BOARD_INFO, 2 bytes", 86, "0000", "3E 56 02 58 00 00 00", "24 56 02 58 00 00 E6 13");
    row("READ_PARAMS_3 active", 21, "FF", "3E 15 01 16 FF FF", "24 15 01 16 FF 37 D8");
    row("READ_PARAMS profile 2", 82, "01", "3E 52 01 53 01 01", "24 52 01 53 01 12 3D");
    row("MOTORS_ON", 77, "", "3E 4D 00 4D 00", "24 4D 00 4D 44 0A");
    row("MOTORS_OFF", 109, "", "3E 6D 00 6D 00", "24 6D 00 6D 0C 0A");
    row("EXECUTE_MENU home", 69, "12", "3E 45 01 46 12 12", "24 45 01 46 12 85 6F");
    row("CONFIRM of MOTORS_ON", 67, "4D", "3E 43 01 44 4D 4D", "24 43 01 44 4D 8E ED");
    row("ERROR: 200 unknown", 255, "C80600000000", "3E FF 06 05 C8 06 00 00 00 00 CE",
        "24 FF 06 05 C8 06 00 00 00 00 69 10");
    row("REALTIME_DATA_CUSTOM", 88, "19010000000000000000", "3E 58 0A 62 19 01 00 00 00 00 00 00 00 00 1A",
        "24 58 0A 62 19 01 00 00 00 00 00 00 00 00 C9 77");
    row("RESET, notify, 1000 ms", 114, "01E803", "3E 72 03 75 01 E8 03 EC", "24 72 03 75 01 E8 03 F8 D0");
}

void TestFramer::knownFrames()
{
    QFETCH(int, id);
    QFETCH(QByteArray, payload);
    QFETCH(QByteArray, version1);
    QFETCH(QByteArray, version2);
    QCOMPARE(simplebgc::encodeFrame(id, payload, 1).toHex(' '), version1.toHex(' '));
    QCOMPARE(simplebgc::encodeFrame(id, payload, 2).toHex(' '), version2.toHex(' '));
    QCOMPARE(framesOf(version1, 1), QList<Frame>{Frame(id, payload, 1)});
    QCOMPARE(framesOf(version2, 1), QList<Frame>{Frame(id, payload, 2)});
}

void TestFramer::rampFrames_data()
{
    QTest::addColumn<int>("id");
    QTest::addColumn<int>("size");
    QTest::addColumn<int>("sum");
    QTest::addColumn<int>("crc");
    QTest::newRow("BOARD_INFO") << 86 << 18 << 0x99 << 0x6E92;
    QTest::newRow("PARAMS_3") << 21 << 134 << 0xCF << 0xD188;
    QTest::newRow("PARAMS_EXT") << 33 << 104 << 0xEC << 0x23A7;
    QTest::newRow("PARAMS_EXT2") << 62 << 151 << 0x3D << 0x81C0;
    QTest::newRow("REALTIME_DATA_4") << 25 << 124 << 0xCA << 0x11DD;
    QTest::newRow("PROFILE_NAMES") << 28 << 240 << 0x08 << 0x6CB3;
    QTest::newRow("longest") << 254 << 255 << 0x81 << 0x91AE;
}

void TestFramer::rampFrames()
{
    QFETCH(int, id);
    QFETCH(int, size);
    QFETCH(int, sum);
    QFETCH(int, crc);
    const QByteArray v1 = simplebgc::encodeFrame(id, ramp(size), 1);
    const QByteArray v2 = simplebgc::encodeFrame(id, ramp(size), 2);
    QCOMPARE(int(quint8(v1.back())), sum);
    QCOMPARE(int(quint8(v2[v2.size() - 2])) | int(quint8(v2.back())) << 8, crc);
    for (const qsizetype chunk : {1, 7, 64, 1000}) {
        QCOMPARE(framesOf(v1 + v2, chunk),
                 (QList<Frame>{Frame(id, ramp(size), 1), Frame(id, ramp(size), 2)}));
    }
}

void TestFramer::anyChunkSizeGivesTheSameFrames()
{
    QByteArray stream("noise > $ more");
    for (int i = 0; i < 40; ++i)
        stream += simplebgc::encodeFrame(1 + i * 5, ramp((i * 37) % 256), 1 + i % 2) + QByteArray(i % 3, '>');
    const QList<Frame> whole = framesOf(stream, stream.size());
    QCOMPARE(whole.size(), 40);
    for (qsizetype chunk = 1; chunk < 400; ++chunk)
        QCOMPARE(framesOf(stream, chunk), whole);
}

void TestFramer::rescansAfterBadHeader()
{
    // The frame begins inside what looked like a header.
    FramerStatistics statistics;
    const auto frames = framesOf(hex("3E 56 3E 4D 00 4D 00"), 3, &statistics);
    QCOMPARE(frames, QList<Frame>{Frame(77, {}, 1)});
    QCOMPARE(statistics.headerErrors, quint64(1));
    QCOMPARE(statistics.skippedBytes, quint64(2));
}

void TestFramer::rescansInsideADamagedBody()
{
    // A frame lost its last bytes; the next one lies where its body should be.
    const QByteArray cut = simplebgc::encodeFrame(21, ramp(134), 1).first(60);
    const QByteArray good = simplebgc::encodeFrame(77, {}, 1);
    FramerStatistics statistics;
    const auto frames = framesOf(cut + good + QByteArray(200, '\0'), 11, &statistics);
    QVERIFY(frames.contains(Frame(77, {}, 1)));
    QCOMPARE(statistics.bodyErrors, quint64(1));
}

void TestFramer::startBytesInsidePayloadsDoNoHarm()
{
    const QByteArray payload = QByteArray(100, '>') + QByteArray(100, '$');
    QCOMPARE(framesOf(simplebgc::encodeFrame(41, payload, 2), 13), QList<Frame>{Frame(41, payload, 2)});
}

void TestFramer::rejectsIdZero()
{
    QVERIFY(framesOf(hex("3E 00 00 00 00"), 5).isEmpty());
}

void TestFramer::truncatedFrameIsGivenUpOnFlush()
{
    simplebgc::Framer framer;
    int count = 0;
    const FrameSink sink = [&count](const FrameView &) { ++count; };
    framer.feed(asBytes(hex("3E 15 86 9B 01 02 3E 4D 00 4D 00")), sink);
    QCOMPARE(count, 0);
    QVERIFY(framer.isWaiting());
    framer.flush(sink);
    QCOMPARE(count, 1);
    QVERIFY(!framer.isWaiting());
}

void TestFramer::statisticsAddUp()
{
    std::mt19937 random(4);
    QByteArray stream;
    for (int i = 0; i < 5000; ++i)
        stream.append(static_cast<char>(random()));
    for (int i = 0; i < 50; ++i)
        stream += simplebgc::encodeFrame(23, ramp(63), 1 + i % 2);
    FramerStatistics statistics;
    qsizetype inFrames = 0;
    for (const Frame &frame : framesOf(stream, 97, &statistics))
        inFrames += frame.payload.size() + (frame.version == 2 ? 6 : 5);
    QCOMPARE(qsizetype(statistics.skippedBytes) + inFrames, stream.size());
}

void TestFramer::randomNoiseNeverCrashesAndAcceptsByChanceOnly()
{
    std::mt19937 random(12);
    QByteArray noise;
    for (int i = 0; i < 400000; ++i)
        noise.append(static_cast<char>(random()));
    FramerStatistics statistics;
    framesOf(noise, 333, &statistics);
    // Chance: start byte, header sum and one-byte trailer agree about once in 256^3 for version 1, times two
    // kinds.
    QVERIFY2(statistics.frames < 12, qPrintable(QString::number(statistics.frames)));
}

void TestFramer::findsEveryIntactFrameAmongDamagedOnes()
{
    std::mt19937 random(7);
    QByteArray stream;
    int intact = 0;
    for (int i = 0; i < 2000; ++i) {
        QByteArray payload(124, '\0');
        for (char &byte : payload)
            byte = static_cast<char>(random());
        QByteArray frame = simplebgc::encodeFrame(25, payload, 2);
        if (random() % 10 == 0)
            frame[qsizetype(random() % quint32(frame.size()))] ^= static_cast<char>(1 + random() % 255);
        else
            ++intact;
        stream += frame;
    }
    FramerStatistics statistics;
    framesOf(stream, 4096, &statistics);
    QVERIFY(int(statistics.frames) >= intact);
    QVERIFY(int(statistics.frames) <= intact + 2);
}

QTEST_APPLESS_MAIN(TestFramer)
#include "tst_framer.moc"
