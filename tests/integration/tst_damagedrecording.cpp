// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/client/deviceclient.h"
#include "protocol/record/recorder.h"
#include "protocol/record/replaystore.h"
#include "protocol/record/replaytransport.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/patience.h"
#include "tests/support/pieces.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

using namespace Qt::StringLiterals;

namespace {

using Kind = RecordedPiece::Kind;

/// A recording of some chunks with twenty pieces each.
struct Chunks
{
    QByteArray whole;
    std::vector<qsizetype> ends;  // of the description, then of each chunk
    std::vector<std::vector<RecordedPiece>> pieces;  // of each chunk
};

Chunks someChunks(const QString &path, int count)
{
    Chunks file;
    auto writer = RecordingWriter::create(path, {{u"a"_s, u"remark"_s}, {u"family"_s, u"x"_s}});
    file.ends.push_back(writer->bytesWritten());
    const auto pieces = somePieces(count * 20);
    for (int chunk = 0; chunk < count; ++chunk) {
        file.pieces.emplace_back(pieces.begin() + chunk * 20, pieces.begin() + chunk * 20 + 20);
        for (const RecordedPiece &piece : file.pieces.back())
            std::ignore = writer->append(piece);
        std::ignore = writer->flush();
        file.ends.push_back(writer->bytesWritten());
    }
    file.whole = fileBytes(path);
    return file;
}

}  // namespace

/// Damage costs a recording what it lies in, and nothing behind it.
class TestDamagedRecording : public QObject
{
    Q_OBJECT
private slots:
    void flippedByteCostsOneChunk();
    void garbageIsReadPast_data();
    void garbageIsReadPast();
    void leftOutHasItsTimes();
    void replayAnswersNothingFromBehindAGap();
    void answersComeBeforeWhatIsPlayed();
    void polledSamplesHaveAGapToo();

private:
    [[nodiscard]] QString path(const QString &name) const { return m_dir.filePath(name); }

    QTemporaryDir m_dir;
};

// Whatever byte it is, all that it costs is the chunk that it is in.
void TestDamagedRecording::flippedByteCostsOneChunk()
{
    const Chunks file = someChunks(path(u"g"_s), 12);
    for (const char bits : {char(0x01), char(0x80), char(0xff)}) {
        for (qsizetype i = 0; i < file.whole.size(); ++i) {
            QByteArray damaged = file.whole;
            damaged[i] = char(damaged[i] ^ bits);
            const auto read = Recording::fromBytes(damaged);
            const QByteArray place = u"byte %1"_s.arg(i).toUtf8();
            // Another version, or no family: nothing could be decoded.
            const qsizetype family = file.whole.indexOf("family") - 1;
            if (i == 10 || (i >= family && i <= file.whole.indexOf("}", family))) {
                QVERIFY2(!read || read->gaps.size() == 1, place);
                continue;
            }
            QVERIFY2(read && read->gaps.size() == 1, place);
            QCOMPARE(read->description.value(u"family"_s).toString(), u"x"_s);
            const auto chunk = std::size_t(
                std::count_if(file.ends.begin(), file.ends.end(), [i](qsizetype end) { return end <= i; }));
            const Recording::Gap &gap = read->gaps.front();
            std::vector<RecordedPiece> rest;
            for (std::size_t each = 1; each < file.ends.size(); ++each) {
                if (each != chunk)
                    rest.insert(rest.end(), file.pieces[each - 1].begin(), file.pieces[each - 1].end());
            }
            if (i < 12) {  // the first line
                QCOMPARE(gap.offset + gap.bytes, qint64(12));
            } else {
                QCOMPARE(gap.offset, qint64(chunk == 0 ? 12 : file.ends[chunk - 1]));
                QCOMPARE(gap.offset + gap.bytes, qint64(file.ends[chunk]));
            }
            QVERIFY2(read->pieces == rest, place);
        }
    }
}

void TestDamagedRecording::garbageIsReadPast_data()
{
    QTest::addColumn<QByteArray>("garbage");
    QByteArray noise(5000, '\0');
    std::mt19937 random(7);
    for (char &byte : noise)
        byte = char(random());
    QTest::newRow("one byte") << QByteArray("x");
    QTest::newRow("noise") << noise;
    QTest::newRow("zeros") << QByteArray(70'000, '\0');
    QTest::newRow("marks") << QByteArray("GDCK").repeated(3000);
    const QByteArray claim = QByteArray::fromHex("4744434b02000000") + QByteArray("\x10\0\0\0", 4);
    QTest::newRow("short claims") << (claim + QByteArray(9, 'G')).repeated(500);
    // Each claims some hundred thousand bytes that would have to be hashed.
    const QByteArray greedy = QByteArray::fromHex("4744434b02000000") + QByteArray("\0\0\x04\0", 4);
    QTest::newRow("long claims") << (greedy + QByteArray(8, 'x')).repeated(20'000);
}

// Put between two chunks and into one: the chunks around it are there.
void TestDamagedRecording::garbageIsReadPast()
{
    QFETCH(QByteArray, garbage);
    const Chunks file = someChunks(path(u"h"_s), 6);
    const bool isEndless = garbage.size() > 300'000;  // searching it to its end would take too long
    for (const qsizetype shift : {0, 25}) {
        QByteArray bytes = file.whole;
        bytes.insert(file.ends[2] + shift, garbage);
        const auto read = Recording::fromBytes(bytes);
        QVERIFY(read);
        QCOMPARE(read->gaps.size(), std::size_t(1));
        QCOMPARE(read->gaps.front().offset, qint64(file.ends[2]));
        std::vector<RecordedPiece> rest;
        for (std::size_t chunk = 0; chunk < 6; ++chunk) {
            if (chunk < 2 || (!isEndless && (chunk > 2 || shift == 0)))
                rest.insert(rest.end(), file.pieces[chunk].begin(), file.pieces[chunk].end());
        }
        QVERIFY(read->pieces == rest);
    }
}

void TestDamagedRecording::leftOutHasItsTimes()
{
    Chunks file = someChunks(path(u"i"_s), 4);
    for (const std::size_t chunk : {0, 2, 3}) {
        QByteArray damaged = file.whole;
        damaged[file.ends[chunk] + 30] = char(damaged[file.ends[chunk] + 30] ^ 4);
        const auto read = Recording::fromBytes(damaged);
        QVERIFY(read);
        const QList<ReplayGap> gaps = read->leftOut();
        QCOMPARE(gaps.size(), qsizetype(1));
        QCOMPARE(gaps.first().bytes, qint64(file.ends[chunk + 1] - file.ends[chunk]));
        QCOMPARE(std::isnan(gaps.first().from), chunk == 0);
        QCOMPARE(std::isnan(gaps.first().to), chunk == 3);
        if (chunk == 2) {  // pieces come each millisecond, 20 in a chunk, each third of them received
            QCOMPARE(gaps.first().from, 0.039);
            QCOMPARE(gaps.first().to, 0.060);
        }
    }
}

// The answers behind a gap belong to requests that are missing.
void TestDamagedRecording::replayAnswersNothingFromBehindAGap()
{
    auto writer = RecordingWriter::create(path(u"k"_s), {{u"family"_s, u"x"_s}});
    QVERIFY(writer);
    const std::vector<std::vector<RecordedPiece>> chunks{
        {{Kind::Received, 0, "r"}, {Kind::Sent, 1, "first"}},
        {{Kind::Reply, 2, "first answer"}, {Kind::Sent, 3, "second"}},
        {{Kind::Reply, 4, "second answer"}, {Kind::Sent, 5, "third"}, {Kind::Reply, 6, "third answer"}}};
    std::vector<qsizetype> ends;
    for (const auto &chunk : chunks) {
        for (const RecordedPiece &piece : chunk)
            QVERIFY(writer->append(piece));
        QVERIFY(writer->flush());
        ends.push_back(writer->bytesWritten());
    }
    QByteArray damaged = fileBytes(path(u"k"_s));
    damaged[ends[0] + 25] = '?';
    auto recording = Recording::fromBytes(damaged);
    QVERIFY(recording);
    ReplayTransport replay(*recording, 1, 0);
    QByteArray answers;
    connect(&replay, &Transport::received, this,
            [&](QByteArrayView bytes) { answers += bytes.toByteArray(); });
    QSignalSpy written(&replay, &Transport::bytesWritten);
    replay.open();
    for (const char *request : {"first", "second", "third"})
        replay.write(QByteArrayView(request));
    QTRY_COMPARE(written.count(), 3);
    QCOMPARE(answers, QByteArray("third answer"));
    QCOMPARE(replay.state().gaps.size(), qsizetype(1));
}

// A paused program plays a second at once, and the answer to what it asks must not stand behind that.
void TestDamagedRecording::answersComeBeforeWhatIsPlayed()
{
    Recording recording;
    recording.pieces = {{Kind::Sent, 0, "g"}, {Kind::Received, 1, "values"}, {Kind::Reply, 1, "values"}};
    for (int i = 2; i < 200; i += 2) {
        recording.pieces.push_back({Kind::Sent, i, "d"});
        recording.pieces.push_back({Kind::Received, i + 1, "data"});
    }
    ReplayTransport replay(recording, 1, 0);
    QByteArrayList order;
    connect(&replay, &Transport::received, this, [&](QByteArrayView bytes) { order += bytes.toByteArray(); });
    connect(&replay, &Transport::replayed, this, [&](QByteArrayView bytes) { order += bytes.toByteArray(); });
    replay.open();
    replay.play();
    order.clear();
    replay.write("g");
    replay.forwardTo(1);
    QCOMPARE(order, QByteArrayList{});
    QTRY_COMPARE(order.size(), int(recording.pieces.size()) - 1);
    QCOMPARE(order.first(), QByteArray("values"));
    QCOMPARE(order.count("values"), 2);
}

// Nothing but the recording itself shows that a few polled samples are missing.
void TestDamagedRecording::polledSamplesHaveAGapToo()
{
    Recorder recorder;
    {
        DeviceClient client(allLinks().transports, allFamilies());
        client.addListener(recorder);
        client.connectTo(*LinkAddress::parse(u"sim:storm32?seed=4"_s), u"storm32"_s);
        QTRY_VERIFY(client.isConnected());
        QTRY_VERIFY(client.telemetry()->rows() > 20);
        client.removeListener(recorder);
    }
    const auto families = allFamilies();
    const auto family = std::find_if(families.begin(), families.end(),
                                     [](const Family &each) { return each.key == u"storm32"_s; });
    const auto device = family->makeDevice();
    Recording recording;
    recording.pieces = recorder.after(0).first;
    const auto holes = [&] {
        const auto store = decodeTelemetry(recording, *family, *device);
        const TrackView track = store->tracks(0).front();
        int found = 0;
        for (std::size_t row = track.begin(); row < track.end(); ++row)
            found += std::isnan(track.value(row));
        return found;
    };
    const int before = holes();
    recording.gaps.push_back({0, 1, GapCause::Checksum, recording.pieces.size() - 4});
    QCOMPARE(holes(), before + 1);
}

QTEST_GUILESS_MAIN(TestDamagedRecording)
#include "tst_damagedrecording.moc"
