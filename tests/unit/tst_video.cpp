// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/video/scene.h"
#include "protocol/video/videoaddress.h"
#include "protocol/video/videoassembler.h"
#include "protocol/video/videoinspector.h"
#include "protocol/video/videomodule.h"
#include "protocol/video/videostatistics.h"
#include "tests/support/patience.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace Qt::StringLiterals;

namespace {

constexpr int kFrames = 40;
constexpr int kKeyInterval = 10;

const VideoCodecs &codecs()
{
    static const auto loaded = loadVideoCodecs();
    if (!loaded)
        qFatal("%s", qPrintable(loaded.error().detail));
    return **loaded;
}

/// Some frames of the simulated camera, numbered from 0.
QList<QByteArray> encodedFrames(VideoFormat format, int count = kFrames, QSize size = {1280, 720})
{
    EncoderSettings settings;
    settings.size = size;
    settings.keyInterval = kKeyInterval;
    settings.format = format;
    const auto encoder = codecs().makeEncoder(settings).value();
    if (encoder->format() != format)
        qFatal("there is no encoder for this format");
    VideoPlanes picture(size.width(), size.height());
    QList<QByteArray> frames;
    for (int i = 0; i < count; ++i) {
        CameraView view;
        view.rollDeg = 3 * std::sin(i * 0.2);
        view.yawDeg = i * 0.3;
        view.seconds = i / 30.0;
        drawScene(picture, view, std::uint32_t(i));
        frames.append(encoder->encode(picture).value());
    }
    return frames;
}

QList<QByteArray> piecesOf(const QByteArray &frame)
{
    QList<QByteArray> pieces;
    constexpr auto kPiece = qsizetype(VideoAssembler::kPiece);
    for (qsizetype at = 0; at < frame.size(); at += kPiece)
        pieces.append(frame.mid(at, kPiece));
    return pieces;
}

QList<EncodedFrame> assembled(const QList<QByteArray> &datagrams)
{
    VideoAssembler assembler;
    QList<EncodedFrame> frames;
    TimePoint now{};
    for (const QByteArray &datagram : datagrams)
        assembler.take(asBytes(datagram), now += 1ms,
                       [&frames](const EncodedFrame &frame) { frames.append(frame); });
    return frames;
}

/// An H.264 frame of that many bytes, as far as its beginning goes.
QByteArray frameOf(qsizetype size, char fill)
{
    return QByteArray("\0\0\0\1\x65\x88", 6) + QByteArray(size - 6, fill);
}

}  // namespace

/// Video without a network: datagrams, what frames say of themselves, the module with libav.
class TestVideo final : public QObject
{
    Q_OBJECT
private slots:
    void datagramsBecomeFrames();
    void aLostEndDoesNotSpoilTheNextFrame();
    void framesWithoutAnEndAreThrownAway();
    void addressesAreUnderstood_data();
    void addressesAreUnderstood();
    void framesTellOfThemselves();
    void lostFramesAreCounted_data();
    void lostFramesAreCounted();
    void numbersAreReadBack_data();
    void numbersAreReadBack();
    void picturesAreMadeSmaller();
    void garbageIsSurvived();
    void filesAreReadBack_data();
    void filesAreReadBack();
    void cutFilesAreReadUpToThere();
    void placesThatCannotBeWrittenAreTold();
    void aMissingModuleIsTold();
    void ratesAreOfTheLastSeconds();
};

// A datagram of exactly 65000 bytes means that more follows.
void TestVideo::datagramsBecomeFrames()
{
    const QList<QByteArray> sent{frameOf(10, 'a'), frameOf(64999, 'b'), frameOf(65001, 'c'),
                                 frameOf(200000, 'd'), frameOf(20, 'e')};
    QList<QByteArray> datagrams;
    for (const QByteArray &frame : sent)
        datagrams += piecesOf(frame);
    QCOMPARE(datagrams.size(), 9);
    const QList<EncodedFrame> frames = assembled(datagrams);
    QCOMPARE(frames.size(), sent.size());
    for (qsizetype i = 0; i < sent.size(); ++i)
        QCOMPARE(frames[i].bytes, sent[i]);
    // The time is that of the first piece.
    QCOMPARE(frames[3].at, TimePoint(5ms));
}

void TestVideo::aLostEndDoesNotSpoilTheNextFrame()
{
    QList<QByteArray> datagrams = piecesOf(frameOf(100000, 'a'));
    datagrams.removeLast();
    datagrams += piecesOf(frameOf(100, 'b'));
    const QList<EncodedFrame> frames = assembled(datagrams);
    QCOMPARE(frames.size(), 2);
    QCOMPARE(frames[0].bytes.size(), 65000);
    QCOMPARE(frames[1].bytes, frameOf(100, 'b'));
}

void TestVideo::framesWithoutAnEndAreThrownAway()
{
    QList<QByteArray> datagrams(200, QByteArray(65000, 'x'));
    datagrams += frameOf(100, 'b');
    const QList<EncodedFrame> frames = assembled(datagrams);
    QCOMPARE(frames.size(), 1);
    QCOMPARE(frames[0].bytes, frameOf(100, 'b'));
}

void TestVideo::addressesAreUnderstood_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("address");  // empty: refused
    QTest::newRow("nothing") << u""_s << u"drone:2021"_s;
    QTest::newRow("host") << u" 10.0.0.1 "_s << u"10.0.0.1:2021"_s;
    QTest::newRow("port") << u":5000"_s << u"drone:5000"_s;
    QTest::newRow("both") << u"camera.local:5000"_s << u"camera.local:5000"_s;
    QTest::newRow("IPv6") << u"[fe80::1]:5000"_s << u"[fe80::1]:5000"_s;
    QTest::newRow("no number") << u"drone:video"_s << QString();
    QTest::newRow("too large") << u"drone:70000"_s << QString();
    QTest::newRow("port 0") << u"drone:0"_s << QString();
    QTest::newRow("scheme") << u"udp://drone"_s << QString();
}

void TestVideo::addressesAreUnderstood()
{
    QFETCH(const QString, text);
    QFETCH(const QString, address);
    const auto parsed = VideoAddress::parse(text, {u"drone"_s});
    QCOMPARE(parsed.has_value(), !address.isEmpty());
    if (parsed)
        QCOMPARE(parsed->toString(), address);
    QVERIFY(!VideoAddress::parse({}, {}));
}

void TestVideo::framesTellOfThemselves()
{
    VideoInspector inspector;
    const QList<QByteArray> frames = encodedFrames(VideoFormat::H264, 2 * kKeyInterval + 1, {640, 360});
    for (qsizetype i = 0; i < frames.size(); ++i) {
        const FrameFacts facts = inspector.inspect(asBytes(frames[i]));
        QCOMPARE(facts.format, VideoFormat::H264);
        QCOMPARE(facts.isKey, i % kKeyInterval == 0);
        QCOMPARE(facts.lost, 0);
    }
    QCOMPARE(inspector.size(), QSize(640, 360));
    QVERIFY(!inspector.parameterSets().isEmpty());
    for (const QByteArray &frame : encodedFrames(VideoFormat::Mjpeg, 2, {640, 360}))
        QVERIFY(inspector.inspect(asBytes(frame)).isKey);
    QCOMPARE(inspector.format(), VideoFormat::Mjpeg);
    QCOMPARE(inspector.size(), QSize(640, 360));
    QCOMPARE(inspector.inspect(asBytes("hello"_ba)).format, VideoFormat::Unknown);
}

void TestVideo::lostFramesAreCounted_data()
{
    QTest::addColumn<QList<int>>("missing");
    QTest::addColumn<int>("lost");
    QTest::newRow("none") << QList<int>{} << 0;
    QTest::newRow("one") << QList<int>{3} << 1;
    QTest::newRow("in a row") << QList<int>{3, 4, 5} << 3;
    QTest::newRow("here and there") << QList<int>{2, 5, 13, 14} << 4;
    QTest::newRow("a key frame") << QList<int>{10} << 0;  // the numbers go on from 1
}

void TestVideo::lostFramesAreCounted()
{
    QFETCH(const QList<int>, missing);
    VideoInspector inspector;
    const QList<QByteArray> frames = encodedFrames(VideoFormat::H264, 2 * kKeyInterval, {320, 180});
    int lost = 0;
    for (int i = 0; i < int(frames.size()); ++i) {
        if (!missing.contains(i))
            lost += inspector.inspect(asBytes(frames[i])).lost;
    }
    QTEST(lost, "lost");
}

void TestVideo::numbersAreReadBack_data()
{
    QTest::addColumn<VideoFormat>("format");
    QTest::newRow("H.264") << VideoFormat::H264;
    QTest::newRow("JPEG") << VideoFormat::Mjpeg;
}

// Each frame is a picture as soon as it is there: none waits for the next one.
void TestVideo::numbersAreReadBack()
{
    QFETCH(const VideoFormat, format);
    const auto decoder = codecs().makeDecoder(format).value();
    VideoPicture picture;
    QVERIFY(!decoder->convert(picture, {100, 100}));
    std::uint32_t number = 0;
    for (const QByteArray &frame : encodedFrames(format)) {
        QCOMPARE(decoder->decode(asBytes(frame), number == 0), VideoDecoder::Outcome::Picture);
        QVERIFY(decoder->convert(picture, decoder->size()));
        QCOMPARE(QSize(picture.width, picture.height), QSize(1280, 720));
        QCOMPARE(readNumber(picture), std::optional(number++));
    }
}

void TestVideo::picturesAreMadeSmaller()
{
    const auto decoder = codecs().makeDecoder(VideoFormat::H264).value();
    QCOMPARE(decoder->decode(asBytes(encodedFrames(VideoFormat::H264, 1).first()), true),
             VideoDecoder::Outcome::Picture);
    VideoPicture picture;
    QVERIFY(decoder->convert(picture, {640, 360}));
    QCOMPARE(readNumber(picture), std::optional(0U));
    QVERIFY(decoder->convert(picture, {1920, 1080}));
    QCOMPARE(readNumber(picture), std::optional(0U));
    QVERIFY(!decoder->convert(picture, {0, 0}));
    QVERIFY(!decoder->convert(picture, {100000, 100000}));
}

// Whatever comes over the network: no crash, and decoding goes on with the next key frame.
void TestVideo::garbageIsSurvived()
{
    std::minstd_rand random(7);
    for (const VideoFormat format : {VideoFormat::H264, VideoFormat::Mjpeg}) {
        const QList<QByteArray> frames = encodedFrames(format, 2 * kKeyInterval);
        const auto decoder = codecs().makeDecoder(format).value();
        VideoInspector inspector;
        VideoPicture picture;
        for (int round = 0; round < 150; ++round) {
            QByteArray bytes = frames[qsizetype(random() % std::size_t(frames.size()))];
            if (round % 3 == 0)
                bytes.truncate(qsizetype(random() % std::size_t(bytes.size())));
            const int flips = int(random() % 200);
            for (int i = 0; i < flips && !bytes.isEmpty(); ++i)
                bytes[qsizetype(random() % std::size_t(bytes.size()))] = char(random());
            if (round % 7 == 0) {
                for (char &byte : bytes)
                    byte = char(random());
            }
            decoder->decode(asBytes(bytes), inspector.inspect(asBytes(bytes)).isKey);
            decoder->convert(picture, decoder->size());
        }
        QCOMPARE(decoder->decode({}, false), VideoDecoder::Outcome::Nothing);
        std::optional<std::uint32_t> last;
        for (const QByteArray &frame : frames) {
            decoder->decode(asBytes(frame), inspector.inspect(asBytes(frame)).isKey);
            QVERIFY(decoder->convert(picture, decoder->size()));
            last = readNumber(picture);
        }
        QCOMPARE(last, std::optional(std::uint32_t(frames.size() - 1)));
    }
}

void TestVideo::filesAreReadBack_data()
{
    numbersAreReadBack_data();
}

void TestVideo::filesAreReadBack()
{
    QFETCH(const VideoFormat, format);
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"a: b.mkv"_s);  // no protocol of libav
    const QList<QByteArray> frames = encodedFrames(format);
    VideoInspector inspector;
    QVERIFY(inspector.inspect(asBytes(frames.first())).isKey);
    auto writer = codecs().createFile(path, {format, inspector.size(), inspector.parameterSets()}).value();
    milliseconds time = 0ms;
    for (const QByteArray &frame : frames) {
        QVERIFY(writer->write({frame, time, inspector.inspect(asBytes(frame)).isKey}));
        time += 33ms;
    }
    QVERIFY(writer->finish());
    QCOMPARE(writer->bytesWritten(), QFile(path).size());

    const auto reader = codecs().openFile(path).value();
    QCOMPARE(reader->track().format, format);
    QCOMPARE(reader->track().size, QSize(1280, 720));
    const auto decoder = codecs().makeDecoder(format).value();
    int count = 0;
    while (const auto packet = reader->next()) {
        QCOMPARE(packet->time, count * 33ms);
        QCOMPARE(packet->isKey, format == VideoFormat::Mjpeg || count % kKeyInterval == 0);
        decoder->decode(asBytes(packet->bytes), packet->isKey);
        VideoPicture picture;
        QVERIFY(decoder->convert(picture, decoder->size()));
        QCOMPARE(readNumber(picture), std::optional(std::uint32_t(count)));
        ++count;
    }
    QCOMPARE(count, kFrames);
}

// The program or the computer was gone from one moment to the next.
void TestVideo::cutFilesAreReadUpToThere()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"whole.mkv"_s);
    const QList<QByteArray> frames = encodedFrames(VideoFormat::H264, 100, {320, 180});
    VideoInspector inspector;
    inspector.inspect(asBytes(frames.first()));
    auto writer
        = codecs().createFile(path, {VideoFormat::H264, inspector.size(), inspector.parameterSets()}).value();
    milliseconds time = 0ms;
    for (const QByteArray &frame : frames) {
        QVERIFY(writer->write({frame, time, inspector.inspect(asBytes(frame)).isKey}));
        time += 33ms;
    }
    const auto framesIn = [](const QString &file) {
        const auto reader = codecs().openFile(file);
        int count = 0;
        while (reader && (*reader)->next())
            ++count;
        return count;
    };
    // Without an end: all but the last half second is there.
    const QString dead = folder.filePath(u"dead.mkv"_s);
    QVERIFY(QFile::copy(path, dead));
    QVERIFY2(framesIn(dead) >= 80, qPrintable(QString::number(framesIn(dead))));
    QVERIFY(writer->finish());
    QCOMPARE(framesIn(path), 100);
    const QString half = folder.filePath(u"half.mkv"_s);
    QVERIFY(QFile::copy(path, half));
    QVERIFY(QFile::resize(half, QFile(half).size() / 2));
    QVERIFY2(framesIn(half) >= 30, qPrintable(QString::number(framesIn(half))));
    QVERIFY(!codecs().openFile(folder.filePath(u"none.mkv"_s)));
}

void TestVideo::placesThatCannotBeWrittenAreTold()
{
    const auto file = codecs().createFile(u"/nowhere/a.mkv"_s, {VideoFormat::Mjpeg, {320, 180}, {}});
    QVERIFY(!file);
    QCOMPARE(file.error().code, ErrorCode::BadFile);
    QVERIFY(file.error().file);
}

void TestVideo::aMissingModuleIsTold()
{
    const QTemporaryDir empty;
    qputenv(kVideoModuleFolder, empty.path().toLocal8Bit());
    const auto missing = loadVideoCodecs();
    qunsetenv(kVideoModuleFolder);
    QVERIFY(!missing);
    QCOMPARE(missing.error().code, ErrorCode::Unsupported);
    QVERIFY2(missing.error().detail.contains(empty.path()), qPrintable(missing.error().detail));
    QVERIFY(loadVideoCodecs());
}

void TestVideo::ratesAreOfTheLastSeconds()
{
    RateMeter meter(2s);
    TimePoint now(100s);
    QCOMPARE(meter.rate(now), 0.0);
    for (int i = 0; i < 200; ++i)
        meter.add(now += 20ms, 1000);
    QVERIFY(std::abs(meter.rate(now) - 50) < 0.01);
    QVERIFY(std::abs(meter.amountRate(now) - 50000) < 10);
    QCOMPARE(meter.mean(now), 1000.0);
    QCOMPARE(meter.rate(now + 3s), 0.0);
    QCOMPARE(meter.mean(now + 3s), 0.0);

    DelayMeter delays;
    QVERIFY(!delays.median());
    for (int i = 1; i <= 9; ++i)
        delays.add(milliseconds(i));
    QCOMPARE(delays.median(), std::optional<Duration>(5ms));
    QCOMPARE(delays.worst(), std::optional<Duration>(9ms));
}

QTEST_GUILESS_MAIN(TestVideo)
#include "tst_video.moc"
