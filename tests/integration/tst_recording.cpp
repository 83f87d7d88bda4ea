// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/base/responsecsv.h"
#include "protocol/client/deviceclient.h"
#include "protocol/device/abilities.h"
#include "protocol/record/recorder.h"
#include "protocol/record/replaystore.h"
#include "protocol/record/replaytransport.h"
#include "protocol/session/linkstatistics.h"
#include "protocol/telemetry/streams.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/patience.h"
#include "tests/support/pieces.h"

#include <QBuffer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace Qt::StringLiterals;

using Kind = RecordedPiece::Kind;

class TestRecording : public QObject
{
    Q_OBJECT
private slots:
    void whatIsWrittenIsRead();
    void cutAnywhereItOpensUpToTheCut();
    void anyFlippedByteIsFound();
    void foreignFilesAreRefused_data();
    void foreignFilesAreRefused();
    void fullDiskIsToldAndEndsIt();
    void recorderHoldsTheLastMinutes();
    void recorderKeepsMemoryWithinItsLimit();
    void recordingBeginsWithThePastOrWithout();
    void badReplayAddresses_data();
    void badReplayAddresses();
    void replayIsTheSameBoard();
    void replayFindsTheStreamThatRan();
    void responseTextsAreRead_data();
    void responseTextsAreRead();
    void responseTextsAreWritten();

private:
    QString path(const QString &name) const { return m_dir.filePath(name); }

    QTemporaryDir m_dir;
};

void TestRecording::whatIsWrittenIsRead()
{
    const QJsonObject description{{u"family"_s, u"simplebgc"_s}, {u"note"_s, u"grün"_s}};
    auto writer = RecordingWriter::create(path(u"a"_s), description);
    QVERIFY(writer);
    const auto pieces = somePieces(5000);  // more than one chunk
    for (const RecordedPiece &piece : pieces)
        QVERIFY(writer->append(piece));
    QVERIFY(writer->flush());
    QCOMPARE(writer->bytesWritten(), QFileInfo(path(u"a"_s)).size());
    const auto read = Recording::load(path(u"a"_s));
    QVERIFY(read);
    QCOMPARE(read->description, description);
    QVERIFY(read->pieces == pieces);
    QVERIFY(read->gaps.empty());
    QCOMPARE(read->begin(), qint64(0));
    QCOMPARE(read->end(), qint64(4998) * 1'000'000);
}

void TestRecording::cutAnywhereItOpensUpToTheCut()
{
    auto writer = RecordingWriter::create(path(u"b"_s), {{u"family"_s, u"x"_s}});
    QVERIFY(writer);
    const qsizetype first = writer->bytesWritten();
    const auto pieces = somePieces(60);
    std::vector<qsizetype> ends;
    for (const RecordedPiece &piece : pieces) {
        QVERIFY(writer->append(piece));
        QVERIFY(writer->flush());  // a chunk each
        ends.push_back(writer->bytesWritten());
    }
    const QByteArray whole = fileBytes(path(u"b"_s));
    for (qsizetype length = 0; length < whole.size(); ++length) {
        const auto read = Recording::fromBytes(whole.left(length));
        if (length < first) {
            QVERIFY(!read);
            continue;
        }
        QVERIFY(read);
        const auto complete = std::size_t(
            std::count_if(ends.begin(), ends.end(), [length](qsizetype end) { return end <= length; }));
        QCOMPARE(read->pieces.size(), complete);
        QVERIFY(std::equal(read->pieces.begin(), read->pieces.end(), pieces.begin()));
        const bool clean = length == first || (complete > 0 && ends[complete - 1] == length);
        QCOMPARE(read->gaps.size(), std::size_t(clean ? 0 : 1));
        if (clean)
            continue;
        const qsizetype at = complete ? ends[complete - 1] : first;
        QCOMPARE(read->gaps.front().offset, qint64(at));
        QCOMPARE(read->gaps.front().bytes, qint64(length - at));
        QCOMPARE(read->gaps.front().piece, complete);
    }
}

void TestRecording::anyFlippedByteIsFound()
{
    auto writer = RecordingWriter::create(path(u"c"_s), {{u"family"_s, u"x"_s}});
    QVERIFY(writer);
    for (const RecordedPiece &piece : somePieces(20))
        QVERIFY(writer->append(piece));
    QVERIFY(writer->flush());
    const QByteArray whole = fileBytes(path(u"c"_s));
    for (qsizetype i = 0; i < whole.size(); ++i) {
        QByteArray damaged = whole;
        damaged[i] = char(damaged[i] ^ 0x10);
        const auto read = Recording::fromBytes(damaged);
        QVERIFY2(!read || !read->gaps.empty(), qPrintable(u"byte %1"_s.arg(i)));
    }
}

void TestRecording::foreignFilesAreRefused_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("text") << QByteArray("time_s,imu.angle.roll\n0,1\n");
    QTest::newRow("mark only") << QByteArray("GIMBALREC 1\n");
    QTest::newRow("later version") << QByteArray("GIMBALREC 2\nGDCK");
    QTest::newRow("endless chunk") << QByteArray("GIMBALREC 1\nGDCK\1\0\0\0\xff\xff\xff\xff"
                                                 "12345678",
                                                 32);
}

void TestRecording::foreignFilesAreRefused()
{
    QFETCH(QByteArray, bytes);
    const auto read = Recording::fromBytes(bytes);
    QVERIFY(!read);
    QCOMPARE(read.error().code, ErrorCode::BadFile);
    QVERIFY(!read.error().detail.isEmpty());
    QVERIFY(!Recording::load(path(u"there is no such file"_s)));
    QVERIFY(!Recording::load(m_dir.path()));
}

void TestRecording::fullDiskIsToldAndEndsIt()
{
    if (!QFileInfo::exists(u"/dev/full"_s))
        QSKIP("this system has no /dev/full");
    const auto writer = RecordingWriter::create(u"/dev/full"_s, {{u"family"_s, u"x"_s}});
    QVERIFY(!writer);
    QCOMPARE(writer.error().code, ErrorCode::BadFile);
    QVERIFY(writer.error().detail.contains(u"space"_s));
    QVERIFY(!RecordingWriter::create(path(u"no/such/folder/a"_s), {}));
}

void TestRecording::recorderHoldsTheLastMinutes()
{
    Recorder recorder(10.0);
    const TimePoint start = Clock::now();
    recorder.bytesSent("hello", start);
    for (int i = 0; i < 3000; ++i)
        recorder.bytesReceived(QByteArray::number(i), start + i * 10ms);  // half a minute
    QVERIFY(std::abs(recorder.heldSeconds() - 10.0) < 0.1);
    const auto [pieces, number] = recorder.after(0);
    QCOMPARE(number, quint64(3001));
    QCOMPARE(pieces.front().kind, Kind::Sent);  // how the link was set up is never forgotten
    QCOMPARE(pieces.front().bytes, QByteArray("hello"));
    QCOMPARE(pieces[1].bytes, QByteArray("1999"));
    QCOMPARE(pieces.back().bytes, QByteArray("2999"));
    recorder.bytesReceived("new", start + 31s);
    const auto [fresh, newest] = recorder.after(number);
    QCOMPARE(fresh.size(), std::size_t(1));
    QCOMPARE(fresh.front().bytes, QByteArray("new"));
    QVERIFY(recorder.after(newest).first.empty());
    recorder.clear();
    QVERIFY(recorder.after(0).first.empty());
    QCOMPARE(recorder.heldBytes(), qsizetype(0));
}

void TestRecording::recorderKeepsMemoryWithinItsLimit()
{
    Recorder recorder(600.0, 100'000);
    const TimePoint start = Clock::now();
    for (int i = 0; i < 2000; ++i)
        recorder.bytesReceived(QByteArray(1000, 'x'), start + i * 1ms);
    QVERIFY(recorder.heldBytes() <= 100'000);
    QVERIFY(recorder.after(0).first.size() > 80);
}

void TestRecording::recordingBeginsWithThePastOrWithout()
{
    Recorder recorder;
    const TimePoint start = Clock::now();
    recorder.bytesSent("ask", start);
    recorder.bytesReceived("past", start + 1ms);
    for (const bool withPast : {true, false}) {
        auto task = RecordingTask::start(recorder, path(u"d"_s), {{u"family"_s, u"x"_s}}, withPast);
        QVERIFY(task);
        QVERIFY((*task)->finish());
        QVERIFY(!(*task)->hasFailed());
        QVERIFY((*task)->bytesWritten() > 0);
        const auto read = Recording::load(path(u"d"_s));
        QVERIFY(read);
        QCOMPARE(read->pieces.size(), std::size_t(withPast ? 2 : 1));
        QCOMPARE(read->pieces.front().bytes, QByteArray("ask"));
    }
    // What comes while it runs is in it, to the last byte before finish().
    auto task = RecordingTask::start(recorder, path(u"e"_s), {{u"family"_s, u"x"_s}}, false);
    QVERIFY(task);
    const auto before = (*task)->bytesWritten();
    QTRY_VERIFY((*task)->bytesWritten() > before);  // what was said is written
    for (int i = 0; i < 1000; ++i)
        recorder.bytesReceived(QByteArray::number(i), start + 2ms + i * 1us);
    QVERIFY((*task)->finish());
    const auto read = Recording::load(path(u"e"_s));
    QVERIFY(read);
    QCOMPARE(read->pieces.size(), std::size_t(1001));
    QCOMPARE(read->pieces.back().bytes, QByteArray("999"));
}

void TestRecording::badReplayAddresses_data()
{
    QTest::addColumn<QString>("address");
    QTest::newRow("no file") << u"replay:/there/is/none"_s;
    QTest::newRow("speed 0") << u"replay:FILE?speed=0"_s;
    QTest::newRow("speed in words") << u"replay:FILE?speed=fast"_s;
    QTest::newRow("speed NaN") << u"replay:FILE?speed=nan"_s;
    QTest::newRow("before the start") << u"replay:FILE?from=-1"_s;
}

void TestRecording::badReplayAddresses()
{
    QFETCH(QString, address);
    QVERIFY(RecordingWriter::create(path(u"f"_s), {{u"family"_s, u"x"_s}}));
    const auto parsed = LinkAddress::parse(address.replace(u"FILE"_s, path(u"f"_s)));
    QVERIFY(parsed);
    QCOMPARE(parsed->toString(), address);
    const auto transport = makeReplayTransport(*parsed);
    QVERIFY(!transport);
    QVERIFY(!transport.error().detail.isEmpty());
}

void TestRecording::responseTextsAreRead_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("rows");  // -1: refused
    QTest::addColumn<double>("rate");
    QTest::newRow("ours") << QByteArray("# 500 samples/s\nin;out\n1;2\n3;4\n") << 2 << 500.0;
    QTest::newRow("bare") << QByteArray("1;2\r\n3;4") << 2 << 1250.0;
    QTest::newRow("commas") << QByteArray("in,out\n1.5,-2e-3\n") << 1 << 1250.0;
    QTest::newRow("tabs and blanks") << QByteArray("\n 1 \t 2 \n\n") << 1 << 1250.0;
    QTest::newRow("odd remark") << QByteArray("# hello\n# -5\n1;2\n") << 1 << 1250.0;
    QTest::newRow("three columns") << QByteArray("1;2;3\n4;5;6\n7;8;9\n1;1;1\n") << -1 << 0.0;
    QTest::newRow("words") << QByteArray("1;2\n3;four\n") << -1 << 0.0;
    QTest::newRow("not a number") << QByteArray("1;2\nnan;inf\n") << -1 << 0.0;
    QTest::newRow("one column") << QByteArray("1\n2\n3\n4\n5\n") << -1 << 0.0;
    QTest::newRow("empty") << QByteArray() << -1 << 0.0;
    QTest::newRow("binary") << QByteArray("\0\xff\n\0;\n;\n\n\x01;", 12) << -1 << 0.0;
}

void TestRecording::responseTextsAreRead()
{
    QFETCH(QByteArray, text);
    QFETCH(int, rows);
    QFETCH(double, rate);
    const auto samples = readResponseCsv(text, 1250);
    if (rows < 0) {
        QVERIFY(!samples);
        QCOMPARE(samples.error().code, ErrorCode::BadFile);
        QVERIFY(!samples.error().detail.isEmpty());
        return;
    }
    QVERIFY2(samples, samples ? "" : qPrintable(samples.error().detail));
    QCOMPARE(int(samples->in.size()), rows);
    QCOMPARE(samples->in.size(), samples->out.size());
    QCOMPARE(samples->rate, rate);
    QCOMPARE(samples->rateAssumed, !text.contains("samples/s"));
    // Without a family that has a full rate there is nothing to assume.
    QCOMPARE(bool(readResponseCsv(text, 0)), !samples->rateAssumed);
}

void TestRecording::responseTextsAreWritten()
{
    const std::vector<float> in{1.0F, -0.125F, 3.5e-5F};
    const std::vector<float> out{0.0F, 7.0F, 1234.5F};
    QBuffer buffer;
    QVERIFY(buffer.open(QIODevice::WriteOnly));
    QVERIFY(writeResponseCsv(buffer, in, out, 833.25));
    const auto read = readResponseCsv(buffer.data(), 0);
    QVERIFY(read);
    QCOMPARE(read->in, in);
    QCOMPARE(read->out, out);
    QCOMPARE(read->rate, 833.25);
    QFile full(u"/dev/full"_s);
    if (full.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
        QVERIFY(!writeResponseCsv(full, in, out, 1));
}

void TestRecording::replayIsTheSameBoard()
{
    const QString file = path(u"board.rec"_s);
    Recorder recorder;
    Configuration original;
    BoardIdentity identity;
    quint64 rows = 0;
    QList<int> wanted;
    {
        DeviceClient client(allLinks().transports, allFamilies());
        client.addListener(recorder);
        client.connectTo(*LinkAddress::parse(u"sim:simplebgc?seed=4"_s), u"simplebgc"_s);
        QTRY_VERIFY(client.isConnected());
        auto configuration = client.submit<Configuration>(
            [](Channel &channel, Device &device) { return device.readConfiguration(channel); });
        QTRY_VERIFY(configuration.isFinished());
        original = *configuration.result();
        identity = client.identity();
        const ChannelRoles roles = client.roles();
        wanted = QList<int>(roles.gyro.begin(), roles.gyro.end());
        client.subscribe({wanted, 0});
        QTRY_VERIFY(client.telemetry()->rows() > 1500);
        client.shutDown();
        rows = client.telemetry()->rows();
    }
    auto task = RecordingTask::start(recorder, file, {{u"family"_s, u"simplebgc"_s}}, true);
    QVERIFY(task);
    QVERIFY((*task)->finish());

    // All at once.
    const auto recording = Recording::load(file);
    QVERIFY(recording);
    const auto device = allFamilies().first().makeDevice();
    const auto read = readTelemetry(*recording, allFamilies().first(), *device);
    QVERIFY(read);
    const auto &store = *read;
    QVERIFY2(store->rows() >= rows, qPrintable(u"%1 of %2"_s.arg(store->rows()).arg(rows)));
    QCOMPARE(store->lost(), quint64(0));
    QVERIFY(!store->tracks(wanted.first()).empty());

    // And as a link.
    DeviceClient client(allLinks().transports, allFamilies());
    client.connectTo(*LinkAddress::parse(u"replay:%1?speed=10"_s.arg(file)), u"simplebgc"_s);
    QTRY_VERIFY(client.isConnected());
    QCOMPARE(client.identity().serial, identity.serial);
    QCOMPARE(client.identity().firmware, identity.firmware);
    QVERIFY(!client.identity().writable);
    auto again = client.submit<Configuration>(
        [](Channel &channel, Device &d) { return d.readConfiguration(channel); });
    QTRY_VERIFY(again.isFinished());
    QVERIFY(again.result());
    QCOMPARE(again.result()->blocks().size(), original.blocks().size());
    for (const auto &[key, bytes] : original.blocks())
        QCOMPARE(again.result()->blocks().at(key), bytes);
    QTRY_VERIFY(client.telemetry()->rows() >= rows);
    QVERIFY(client.isConnected());  // the end of the recording is no lost link
    // Nothing can be written to the past.
    auto written = client.submit<QVariantMap>([](Channel &channel, Device &d) -> Result<QVariantMap> {
        const auto reply = d.perform(channel, u"motors.on"_s, {});
        return reply ? Result<QVariantMap>(QVariantMap()) : tl::unexpected(reply.error());
    });
    QTRY_VERIFY(written.isFinished());
    QVERIFY(!written.result());
    QCOMPARE(written.result().error().code, ErrorCode::ReadOnly);
}

void TestRecording::replayFindsTheStreamThatRan()
{
    // Two streams one after the other: each is decoded with the fields it was asked for.
    Recorder recorder;
    int gyro = -1;
    int angle = -1;
    {
        DeviceClient client(allLinks().transports, allFamilies());
        client.addListener(recorder);
        client.connectTo(*LinkAddress::parse(u"sim:simplebgc?seed=4"_s), u"simplebgc"_s);
        QTRY_VERIFY(client.isConnected());
        gyro = client.roles().gyro[0];
        angle = client.roles().angle[0];
        for (const int channel : {gyro, angle}) {
            QSignalSpy planned(&client, &DeviceClient::telemetryPlanChanged);
            const quint64 rows = client.telemetry()->rows();
            client.subscribe({{channel}, 0});
            QTRY_VERIFY(planned.count() > 0);
            QTRY_VERIFY(client.telemetry()->rows() > rows + 500);
        }
        client.removeListener(recorder);
    }
    Recording recording;
    recording.pieces = recorder.after(0).first;
    const auto device = allFamilies().first().makeDevice();
    const auto store = decodeTelemetry(recording, allFamilies().first(), *device);
    const auto fastRows = [&store](int channel) {
        std::size_t rows = 0;
        for (TrackView track : store->tracks(channel)) {
            track.refresh();
            if (track.period() > 0)
                rows += track.end();
        }
        return rows;
    };
    QVERIFY2(fastRows(gyro) > 400, qPrintable(QString::number(fastRows(gyro))));
    QVERIFY2(fastRows(angle) > 400, qPrintable(QString::number(fastRows(angle))));
    // Angles of a held camera are small, rates too: a wrong layout would show thousands.
    for (const int channel : {gyro, angle}) {
        for (TrackView track : store->tracks(channel)) {
            track.refresh();
            for (std::size_t row = track.begin(); row < track.end(); ++row)
                QVERIFY(std::isnan(track.value(row)) || std::abs(track.value(row)) < 90.0F);
        }
    }
}

QTEST_GUILESS_MAIN(TestRecording)
#include "tst_recording.moc"
