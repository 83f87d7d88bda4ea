// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/recorder.h"
#include "tests/support/pieces.h"

#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace Qt::StringLiterals;

namespace {

using Kind = RecordedPiece::Kind;

// Made by the description of the format alone: three pieces, one before the link's first byte.
const char *const kPublished = "47494d42414c52454320310a"
                               "4744434b0100000016000000a812d90eb720b15f"
                               "7b0a202020202266616d696c79223a202278220a7d0a"
                               "4744434b020000002c000000f8e32ba72769a7bb"
                               "0203000000ffffffffffffffff61736b"
                               "0102000000050403020100000000ff"
                               "03000000000700000000000000";

std::vector<RecordedPiece> randomPieces(int count, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<RecordedPiece> pieces;
    for (int i = 0; i < count; ++i) {
        QByteArray bytes(qsizetype(random() % 40), '\0');
        for (char &byte : bytes)
            byte = char(random());
        pieces.push_back({Kind(1 + random() % 3), qint64(i) * 1'000'000, bytes});
    }
    return pieces;
}

// Everything a recorder gives away, as a task takes it.
std::vector<RecordedPiece> all(const Recorder &recorder)
{
    std::vector<RecordedPiece> pieces;
    quint64 number = 0;
    do {
        auto [some, last] = recorder.after(number);
        pieces.insert(pieces.end(), some.begin(), some.end());
        number = last;
    } while (number < recorder.newest());
    return pieces;
}

// The pieces of the chunks that both have: those of a recording that holds nothing else.
std::vector<RecordedPiece> undamaged(const QByteArray &whole, const QByteArray &damaged)
{
    QByteArray rest;
    qsizetype next = 0;
    for (qsizetype at = QByteArray("GIMBALREC 1\n").size(); at < whole.size(); at = next) {
        next = at + 20 + qsizetype(quint8(whole[at + 8])) + (qsizetype(quint8(whole[at + 9])) << 8)
            + (qsizetype(quint8(whole[at + 10])) << 16);
        // The description comes first and is needed to read the others.
        if (rest.isEmpty())
            rest = whole.first(next);
        else if (whole.sliced(at, next - at) == damaged.sliced(at, next - at))
            rest += whole.sliced(at, next - at);
    }
    return Recording::fromBytes(rest)->pieces;
}

}  // namespace

/// The recorder's ring and the format of recordings, beyond what whole recordings of boards show.
class TestRecorder : public QObject
{
    Q_OBJECT
private slots:
    void formatIsAsPublished();
    void chunksOfLaterVersionsAreLeftOut();
    void cutAnywhereInsideAChunk();
    void flippedBytesAreNeverBelieved();
    void noiseIsNoRecording();
    void piecesKeepTheirOrderOverChunks();
    void descriptionIsReadAlone();
    void ringKeepsWhatWasSaidLonger();
    void ringForgetsTheOldestBySize();
    void piecesAreGivenInPortions();
    void clearedRecorderBeginsAnew();
    void repliesAreKeptWhenClaimed();
    void taskWritesWhileTheLinkRuns();
    void twoTasksDoNotDisturbEachOther();

private:
    [[nodiscard]] QString path(const QString &name) const { return m_dir.filePath(name); }
    Result<QByteArray> written(const std::vector<RecordedPiece> &pieces) const
    {
        auto writer = RecordingWriter::create(path(u"w"_s), {{u"family"_s, u"x"_s}});
        if (!writer)
            return tl::unexpected(writer.error());
        for (const RecordedPiece &piece : pieces) {
            if (const auto appended = writer->append(piece); !appended)
                return tl::unexpected(appended.error());
        }
        if (const auto flushed = writer->flush(); !flushed)
            return tl::unexpected(flushed.error());
        return fileBytes(path(u"w"_s));
    }

    QTemporaryDir m_dir;
};

void TestRecorder::formatIsAsPublished()
{
    const QByteArray published = QByteArray::fromHex(kPublished);
    const std::vector<RecordedPiece> pieces{{Kind::Sent, -1, "ask"},
                                            {Kind::Received, 0x0102030405, QByteArray("\x00\xFF", 2)},
                                            {Kind::Reply, 7, {}}};
    const auto read = Recording::fromBytes(published);
    QVERIFY(read);
    QVERIFY(read->gaps.empty());
    QCOMPARE(read->description, (QJsonObject{{u"family"_s, u"x"_s}}));
    QVERIFY(read->pieces == pieces);
    QCOMPARE(read->begin(), qint64(0x0102030405));
    QCOMPARE(read->end(), qint64(0x0102030405));
    QCOMPARE(written(pieces).value().toHex(), published.toHex());
}

void TestRecorder::chunksOfLaterVersionsAreLeftOut()
{
    const QByteArray later = QByteArray::fromHex(
        "4744434b090000001c000000731bd1626ac41bcc736f6d657468696e67206f662061206c617465722076657273696f6e");
    const QByteArray published = QByteArray::fromHex(kPublished);
    const auto whole = Recording::fromBytes(published);
    const qsizetype between = published.lastIndexOf("GDCK");
    for (const QByteArray &bytes : {published + later, QByteArray(published).insert(between, later)}) {
        const auto read = Recording::fromBytes(bytes);
        QVERIFY(read);
        QVERIFY(read->gaps.empty());
        QVERIFY(read->pieces == whole->pieces);
    }
}

void TestRecorder::cutAnywhereInsideAChunk()
{
    // One chunk of many pieces: it counts as a whole or not at all.
    const auto pieces = randomPieces(60, 1);
    const QByteArray whole = written(pieces).value();
    const qsizetype chunk = whole.indexOf("GDCK", 20);
    for (qsizetype length = 0; length <= whole.size(); ++length) {
        const auto read = Recording::fromBytes(whole.left(length));
        QCOMPARE(read.has_value(), length >= chunk);
        if (!read)
            continue;
        QCOMPARE(read->pieces.size(), length == whole.size() ? pieces.size() : std::size_t(0));
        QCOMPARE(read->gaps.empty(), length == chunk || length == whole.size());
        if (!read->gaps.empty())
            QCOMPARE(read->gaps.front().offset, qint64(chunk));
    }
}

void TestRecorder::flippedBytesAreNeverBelieved()
{
    const auto pieces = randomPieces(4000, 2);  // more than one chunk
    const QByteArray whole = written(pieces).value();
    std::mt19937 random(3);
    for (int i = 0; i < 400; ++i) {
        QByteArray damaged = whole;
        const int flips = 1 + int(random() % 4);
        for (int flip = 0; flip < flips; ++flip) {
            const auto at = qsizetype(random() % unsigned(damaged.size()));
            damaged[at] = char(damaged[at] ^ char(1 + random() % 255));
        }
        if (damaged == whole)
            continue;
        const auto read = Recording::fromBytes(damaged);
        if (!read)
            continue;
        // What is there is all that stands in undamaged chunks, and that something is missing is said.
        QVERIFY(!read->gaps.empty());
        QVERIFY(read->pieces == undamaged(whole, damaged));
    }
}

void TestRecorder::noiseIsNoRecording()
{
    std::mt19937 random(4);
    const QByteArray magic("GIMBALREC 1\n");
    for (int i = 0; i < 2000; ++i) {
        QByteArray noise(qsizetype(random() % 200), '\0');
        for (char &byte : noise)
            byte = char(random());
        QVERIFY(!Recording::fromBytes(noise));
        QVERIFY(!Recording::fromBytes(magic + noise));
        QVERIFY(!Recording::fromBytes(magic + "GDCK" + noise));
    }
}

void TestRecorder::piecesKeepTheirOrderOverChunks()
{
    auto pieces = randomPieces(20000, 5);
    pieces[100].bytes = QByteArray(1'000'000, 'x');  // larger than a chunk would otherwise become
    pieces[101].bytes.clear();
    const QByteArray whole = written(pieces).value();
    QVERIFY(whole.count("GDCK") > 5);
    const auto read = Recording::fromBytes(whole);
    QVERIFY(read && read->gaps.empty());
    QVERIFY(read->pieces == pieces);
}

void TestRecorder::descriptionIsReadAlone()
{
    QVERIFY(written(randomPieces(30000, 6)));
    const auto description = Recording::describe(path(u"w"_s));
    QVERIFY(description);
    QCOMPARE(*description, (QJsonObject{{u"family"_s, u"x"_s}}));
    QFile empty(path(u"empty"_s));
    QVERIFY(empty.open(QIODevice::WriteOnly));
    QVERIFY(!Recording::describe(path(u"empty"_s)));
    QVERIFY(!Recording::describe(path(u"missing"_s)));

    BoardIdentity identity;
    identity.family = u"storm32"_s;
    identity.firmware = u"0.96"_s;
    identity.serial = u"4711"_s;
    const QJsonObject told = recordingDescription(identity, LinkAddress::parse(u"tcp://host:1"_s).value());
    QCOMPARE(told.value(u"family"_s).toString(), u"storm32"_s);
    QCOMPARE(told.value(u"firmware"_s).toString(), u"0.96"_s);
    QCOMPARE(told.value(u"serial"_s).toString(), u"4711"_s);
    QCOMPARE(told.value(u"address"_s).toString(), u"tcp://host:1"_s);
    QVERIFY(told.value(u"program"_s).toString().startsWith(u"GimbalDesk "_s));
    QVERIFY(QDateTime::fromString(told.value(u"started"_s).toString(), Qt::ISODate).isValid());
}

// Received bytes of the last minutes only; of what was said, the beginning for ever and the rest for long.
void TestRecorder::ringKeepsWhatWasSaidLonger()
{
    Recorder recorder(1.0);
    const TimePoint start = Clock::now();
    constexpr int kSaid = 30000;
    for (int i = 0; i < kSaid; ++i) {
        recorder.bytesSent(QByteArray::number(i), start + i * 10ms);
        recorder.bytesReceived("answer", start + i * 10ms + 1ms);
    }
    std::vector<int> said;
    int received = 0;
    for (const RecordedPiece &piece : all(recorder)) {
        if (piece.kind == Kind::Sent)
            said.push_back(piece.bytes.toInt());
        else
            ++received;
    }
    QVERIFY(received >= 99 && received <= 101);
    QVERIFY(std::is_sorted(said.begin(), said.end()));
    QVERIFY(std::adjacent_find(said.begin(), said.end()) == said.end());
    QCOMPARE(said.front(), 0);
    QCOMPARE(said.back(), kSaid - 1);
    QCOMPARE(said[1999], 1999);  // how the link was set up
    QVERIFY(said.size() > 20000 && said.size() < 25000);  // but not without limit
    QVERIFY(recorder.heldSeconds() <= 1.0);
}

void TestRecorder::ringForgetsTheOldestBySize()
{
    Recorder recorder(600.0, 10'000);
    const TimePoint start = Clock::now();
    for (int i = 0; i < 100; ++i)
        recorder.bytesReceived(QByteArray(900, char(i)), start + i * 1ms);
    QVERIFY(recorder.heldBytes() <= 10'000 && recorder.heldBytes() > 9000);
    const auto pieces = recorder.after(0).first;
    QCOMPARE(pieces.back().bytes, QByteArray(900, char(99)));
    for (std::size_t i = 1; i < pieces.size(); ++i)
        QCOMPARE(pieces[i].bytes[0], char(pieces[i - 1].bytes[0] + 1));
    // More at once than it may hold: nothing is held, and what comes next is.
    recorder.bytesReceived(QByteArray(20'000, 'x'), start + 1s);
    QCOMPARE(recorder.heldBytes(), qsizetype(0));
    QCOMPARE(recorder.heldSeconds(), 0.0);
    recorder.bytesReceived("next", start + 2s);
    QCOMPARE(recorder.after(0).first.size(), std::size_t(1));
}

void TestRecorder::piecesAreGivenInPortions()
{
    Recorder recorder;
    const TimePoint start = Clock::now();
    constexpr int kPieces = 23456;
    for (int i = 0; i < kPieces; ++i)
        recorder.bytesReceived(QByteArray::number(i), start + i * 1us);
    QCOMPARE(recorder.newest(), quint64(kPieces));
    QVERIFY(recorder.after(0).first.size() < kPieces);  // nobody is kept waiting for all of them
    const auto pieces = all(recorder);
    QCOMPARE(pieces.size(), std::size_t(kPieces));
    for (int i = 0; i < kPieces; ++i)
        QCOMPARE(pieces[std::size_t(i)].bytes.toInt(), i);
    QCOMPARE(recorder.after(kPieces + 5).first.size(), std::size_t(0));
    // After a number, the next one comes.
    QCOMPARE(recorder.after(20000).first.front().bytes, QByteArray("20000"));
    QCOMPARE(recorder.after(kPieces - 1).first.size(), std::size_t(1));
}

void TestRecorder::clearedRecorderBeginsAnew()
{
    Recorder recorder(1.0);
    const TimePoint start = Clock::now();
    for (int i = 0; i < 500; ++i)
        recorder.bytesSent("old", start + i * 10ms);
    const quint64 before = recorder.newest();
    recorder.clear();
    QCOMPARE(recorder.heldBytes(), qsizetype(0));
    QCOMPARE(recorder.heldSeconds(), 0.0);
    QVERIFY(recorder.after(0).first.empty());
    recorder.bytesSent("new", start + 100s);
    // Numbers go on, so that a task never takes the new for the old; times begin again.
    QCOMPARE(recorder.newest(), before + 1);
    const auto pieces = recorder.after(before).first;
    QCOMPARE(pieces.size(), std::size_t(1));
    QVERIFY(pieces.front() == (RecordedPiece{Kind::Sent, 0, "new"}));
}

void TestRecorder::repliesAreKeptWhenClaimed()
{
    Recorder recorder;
    const TimePoint start = Clock::now();
    const QByteArray raw("\x3E\x01\x02", 3);
    FrameView frame;
    frame.raw = asBytes(raw);
    recorder.bytesReceived(raw, start);
    recorder.frameReceived(frame, start + 1ms, false);  // telemetry: its bytes are there already
    recorder.frameReceived(frame, start + 2ms, true);
    recorder.frameReceived(FrameView(), start + 3ms, true);  // never was on a wire
    const auto pieces = recorder.after(0).first;
    QCOMPARE(pieces.size(), std::size_t(2));
    QVERIFY(pieces[1] == (RecordedPiece{Kind::Reply, 2'000'000, raw}));
}

void TestRecorder::taskWritesWhileTheLinkRuns()
{
    Recorder recorder(0.5);  // the ring is much shorter than the recording
    auto task = RecordingTask::start(recorder, path(u"live"_s), {{u"family"_s, u"x"_s}}, true);
    QVERIFY(task);
    constexpr int kPieces = 60000;
    std::thread link([&recorder] {
        const TimePoint start = Clock::now();
        for (int i = 0; i < kPieces; ++i) {
            if (i % 10 == 0)
                recorder.bytesSent(QByteArray::number(i), start + i * 1us);
            else
                recorder.bytesReceived(QByteArray::number(i), start + i * 1us);
        }
    });
    link.join();
    QVERIFY((*task)->finish());
    QVERIFY((*task)->finish());  // a second time does no harm
    const auto read = Recording::load(path(u"live"_s));
    QVERIFY(read && read->gaps.empty());
    QCOMPARE(read->pieces.size(), std::size_t(kPieces));
    for (int i = 0; i < kPieces; ++i) {
        QCOMPARE(read->pieces[std::size_t(i)].bytes.toInt(), i);
        QCOMPARE(read->pieces[std::size_t(i)].kind, i % 10 ? Kind::Received : Kind::Sent);
    }
    QCOMPARE((*task)->bytesWritten(), QFileInfo(path(u"live"_s)).size());
}

void TestRecorder::twoTasksDoNotDisturbEachOther()
{
    Recorder recorder;
    const TimePoint start = Clock::now();
    for (int i = 0; i < 100; ++i)
        recorder.bytesReceived(QByteArray::number(i), start + i * 1ms);
    auto past = RecordingTask::start(recorder, path(u"past"_s), {{u"family"_s, u"x"_s}}, true);
    auto fresh = RecordingTask::start(recorder, path(u"fresh"_s), {{u"family"_s, u"x"_s}}, false);
    QVERIFY(past && fresh);
    for (int i = 100; i < 200; ++i)
        recorder.bytesReceived(QByteArray::number(i), start + i * 1ms);
    QVERIFY((*past)->finish());
    recorder.bytesReceived("200", start + 200ms);
    QVERIFY((*fresh)->finish());
    QCOMPARE(Recording::load(path(u"past"_s))->pieces.size(), std::size_t(200));
    const auto read = Recording::load(path(u"fresh"_s));
    QCOMPARE(read->pieces.size(), std::size_t(101));
    QCOMPARE(read->pieces.front().bytes, QByteArray("100"));
    QCOMPARE(read->pieces.back().bytes, QByteArray("200"));
}

QTEST_APPLESS_MAIN(TestRecorder)
#include "tst_recorder.moc"
