// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/video/cameraserver.h"
#include "protocol/simulator/video/scene.h"
#include "protocol/video/videomodule.h"
#include "protocol/video/videopipeline.h"
#include "tests/support/ctlrun.h"
#include "tests/support/simprocess.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUdpSocket>

using namespace Qt::StringLiterals;

namespace {

/// The port on which a gimbalsim offers its video, as it prints it.
QString videoAddress(SimProcess &simulator)
{
    QByteArray line;
    std::ignore = QTest::qWaitFor(
        [&] {
            if (line.isEmpty() && simulator.process().canReadLine())
                line = simulator.process().readLine().trimmed();
            return !line.isEmpty();
        },
        kPatience);
    return line.startsWith("video ") ? QString::fromLatin1(line.mid(6)) : QString();
}

/// What a recording holds: the numbers of its frames, as far as they can be read.
QList<std::uint32_t> numbersIn(const QString &path, int *frames = nullptr)
{
    QList<std::uint32_t> numbers;
    const VideoCodecs *codecs = loadVideoCodecs().value();
    const auto reader = codecs->openFile(path);
    if (!reader)
        return numbers;
    const auto decoder = codecs->makeDecoder((*reader)->track().format).value();
    while (const auto packet = (*reader)->next()) {
        if (frames)
            ++*frames;
        VideoPicture picture;
        if (decoder->decode(asBytes(packet->bytes), packet->isKey) == VideoDecoder::Outcome::Nothing
            || !decoder->convert(picture, decoder->size()))
            continue;
        if (const auto number = readNumber(picture))
            numbers.append(*number);
    }
    return numbers;
}

bool isRising(const QList<std::uint32_t> &numbers)
{
    return std::adjacent_find(numbers.begin(), numbers.end(), std::greater_equal<>()) == numbers.end();
}

}  // namespace

/// Video over UDP: encoded by the simulated camera, received, decoded, recorded.
class TestVideoLink final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void numbersComeInOrder_data();
    void numbersComeInOrder();
    void onlyTheNewestPictureIsHandedOut();
    void silenceIsSeen();
    void foreignDatagramsAreNoVideo();
    void recordingsAreWhatCame();
    void recordingsEndWithTheLink();
    void stillsAreAsLargeAsTheyCome();
    void unknownHostsAreTold();
    void droneWithoutALinkIsRecorded();
    void dronesAreRecorded();
    void whatCannotBeRecordedIsTold();
    void simulatorsWithoutACameraSaySo();

private:
    /// What the camera sees from now on.
    void look(double loss = 0, int frameRate = 60, bool isMjpeg = false);
    VideoAddress address() const { return {u"127.0.0.1"_s, m_server->port()}; }
    Run ctl(const QStringList &arguments) { return Running(m_dir->path(), arguments).finish(); }
    QString path(const QString &name) const { return m_dir->filePath(name); }

    std::unique_ptr<QTemporaryDir> m_dir;
    std::shared_ptr<CameraFeed> m_feed;
    std::unique_ptr<CameraServer> m_server;
};

void TestVideoLink::init()
{
    m_dir = std::make_unique<QTemporaryDir>();
    m_feed = std::make_shared<CameraFeed>();
    m_server = std::make_unique<CameraServer>(m_feed);
    QVERIFY(m_server->start(0));
}

void TestVideoLink::cleanup()
{
    m_server.reset();
}

void TestVideoLink::look(double loss, int frameRate, bool isMjpeg)
{
    CameraView view;
    view.rollDeg = 10;
    view.pitchDeg = -5;
    view.loss = loss;
    view.frameRate = frameRate;
    view.isMjpeg = isMjpeg;
    m_feed->set(view);
}

void TestVideoLink::numbersComeInOrder_data()
{
    QTest::addColumn<double>("loss");
    QTest::addColumn<bool>("isMjpeg");
    QTest::newRow("H.264") << 0.0 << false;
    QTest::newRow("H.264, 5 % lost") << 0.05 << false;
    QTest::newRow("JPEG") << 0.0 << true;
    QTest::newRow("JPEG, 5 % lost") << 0.05 << true;
}

// What was lost is missing, and damages pictures up to the next key frame; no older picture comes after a
// newer one.
void TestVideoLink::numbersComeInOrder()
{
    QFETCH(const double, loss);
    QFETCH(const bool, isMjpeg);
    look(loss, 30, isMjpeg);
    VideoPipeline video;
    QList<std::uint32_t> numbers;
    int unreadable = 0;
    int damaged = 0;
    connect(&video, &VideoPipeline::pictureReady, this, [&] {
        const auto picture = video.picture();
        video.painted(*picture);
        if (const auto number = readNumber(*picture))
            numbers.append(*number);
        else
            ++(picture->isDamaged ? damaged : unreadable);
    });
    QVERIFY(video.start(address()));
    constexpr int kWanted = 90;
    QTRY_VERIFY(numbers.size() >= kWanted);
    QVERIFY(isRising(numbers));
    QCOMPARE(unreadable, 0);
    const VideoStatistics statistics = video.statistics();
    video.stop();
    QCOMPARE(statistics.format, isMjpeg ? VideoFormat::Mjpeg : VideoFormat::H264);
    QCOMPARE(statistics.size, QSize(1280, 720));
    QVERIFY(statistics.latency && *statistics.latency > 0ms && *statistics.latency < 5s);
    QVERIFY(statistics.frameRate > 1 && statistics.bitRate > 10000);
    const auto sent = quint64(numbers.last() - numbers.first() + 1);
    if (loss == 0) {
        QCOMPARE(statistics.lost, 0U);
        QCOMPARE(statistics.damaged, 0U);
        QCOMPARE(damaged, 0);
    } else if (!isMjpeg) {
        QVERIFY2(statistics.lost > 0 && statistics.lossPercent > 0, "losses are counted");
        // A frame lost before a key frame cannot be told.
        QVERIFY2(statistics.lost <= sent - quint64(numbers.size()) + 2,
                 qPrintable(u"%1 lost of %2, %3 read"_s.arg(statistics.lost).arg(sent).arg(numbers.size())));
    }
}

// Who looks too rarely sees what is new, and does not lag behind.
void TestVideoLink::onlyTheNewestPictureIsHandedOut()
{
    look();
    VideoPipeline video;
    QSignalSpy ready(&video, &VideoPipeline::pictureReady);
    QVERIFY(video.start(address()));
    QTRY_VERIFY(video.statistics().frames >= 60);
    QCOMPARE(ready.count(), 1);  // nobody has looked since
    const auto first = readNumber(*video.picture());
    QVERIFY(first);
    QVERIFY2(*first + 60 >= video.statistics().frames && *first > 20, qPrintable(QString::number(*first)));
    QTRY_COMPARE(ready.count(), 2);
    // A smaller screen gets smaller pictures of the same shape.
    video.setPictureSize({500, 500});
    QTRY_COMPARE(video.picture()->width, 500);
    QCOMPARE(video.picture()->height, 281);
    // Nobody looks at all.
    video.setPaused(true);
    const auto frames = video.statistics().frames;
    QTRY_VERIFY(video.statistics().frames > frames + 5);
    const auto held = video.picture();
    const auto later = video.statistics().frames;
    QTRY_VERIFY(video.statistics().frames > later + 5);
    QCOMPARE(video.picture(), held);
}

void TestVideoLink::silenceIsSeen()
{
    VideoPipeline video;
    QVERIFY(video.start(address()));
    QVERIFY(!video.statistics().silence);
    look();
    QTRY_VERIFY(video.statistics().frames > 10);
    QVERIFY(*video.statistics().silence < 30s);
    m_feed->set({});
    QTRY_VERIFY(*video.statistics().silence > 1s);
    const quint64 before = video.statistics().frames;
    look();
    QTRY_VERIFY(video.statistics().frames > before && *video.statistics().silence < 1s);
}

void TestVideoLink::foreignDatagramsAreNoVideo()
{
    QUdpSocket drone;
    QVERIFY(drone.bind(QHostAddress::LocalHost, 0));
    VideoPipeline video;
    QSignalSpy ready(&video, &VideoPipeline::pictureReady);
    QVERIFY(video.start({u"127.0.0.1"_s, drone.localPort()}));
    QTRY_VERIFY(drone.hasPendingDatagrams());
    QHostAddress viewer;
    quint16 port = 0;
    QByteArray hello(16, '\0');
    hello.resize(drone.readDatagram(hello.data(), hello.size(), &viewer, &port));
    QCOMPARE(hello, QByteArray::fromHex("12345678"));
    for (const QByteArray &bytes :
         {"what is this"_ba, QByteArray(65000, '\0'), QByteArray("\0\0\1\x67\xff\xff", 6),
          QByteArray("\0\0\1\x65", 4), QByteArray("\xff\xd8\xff\xc0\0", 5)})
        drone.writeDatagram(bytes, viewer, port);
    QTRY_VERIFY(video.statistics().datagrams >= 5);
    QTRY_VERIFY(video.statistics().foreign > 0);
    QCOMPARE(ready.count(), 0);
    // It says again and again where it is.
    QTRY_VERIFY(drone.hasPendingDatagrams());
}

void TestVideoLink::recordingsAreWhatCame()
{
    look();
    VideoPipeline video;
    QSignalSpy ended(&video, &VideoPipeline::recordingEnded);
    QVERIFY(!video.startRecording(path(u"early.mkv"_s)));
    QVERIFY(video.start(address(), VideoPipeline::Use::RecordOnly));
    QVERIFY(video.startRecording(path(u"a.mkv"_s)));
    QVERIFY(!video.startRecording(path(u"b.mkv"_s)));
    QTRY_VERIFY(video.recordingState().length > 1500ms);
    QVERIFY(!video.recordingState().isWaiting);
    QVERIFY(video.isRecording());
    video.endRecording();
    QTRY_COMPARE(ended.count(), 1);
    QVERIFY(!video.isRecording());
    const VideoRecordingState state = video.recordingState();
    QVERIFY(!state.error);
    QCOMPARE(state.lost, 0U);
    QCOMPARE(state.bytes, QFile(path(u"a.mkv"_s)).size());
    int frames = 0;
    const QList<std::uint32_t> numbers = numbersIn(path(u"a.mkv"_s), &frames);
    QCOMPARE(quint64(frames), state.frames);
    QCOMPARE(numbers.size(), frames);
    QCOMPARE(numbers.last() - numbers.first() + 1, std::uint32_t(frames));
    // The next one.
    QVERIFY(video.startRecording(path(u"b.mkv"_s)));
    QTRY_VERIFY(video.recordingState().frames > 3);
}

void TestVideoLink::recordingsEndWithTheLink()
{
    look();
    VideoPipeline video;
    QSignalSpy ended(&video, &VideoPipeline::recordingEnded);
    QVERIFY(video.start(address()));
    QVERIFY(video.startRecording(path(u"a.mkv"_s)));
    QTRY_VERIFY(video.recordingState().frames > 20);
    video.stop();
    QTRY_COMPARE(ended.count(), 1);
    QVERIFY(isRising(numbersIn(path(u"a.mkv"_s))));
    QVERIFY(numbersIn(path(u"a.mkv"_s)).size() > 20);
    // A folder that cannot be written.
    QVERIFY(video.start(address()));
    const auto refused = video.startRecording(u"/nowhere/a.mkv"_s);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::BadFile);
}

void TestVideoLink::stillsAreAsLargeAsTheyCome()
{
    VideoPipeline video;
    std::optional<std::shared_ptr<const VideoPicture>> still;
    connect(&video, &VideoPipeline::stillTaken, this,
            [&still](const std::shared_ptr<const VideoPicture> &picture) { still = picture; });
    video.setPictureSize({320, 200});
    QVERIFY(video.start(address()));
    video.takeStill();
    QTRY_VERIFY(still);
    QVERIFY(!*still);  // there is none yet
    still.reset();
    look();
    QTRY_VERIFY(video.statistics().frames > 5);
    QTRY_VERIFY(video.picture());
    video.takeStill();
    QTRY_VERIFY(still);
    QVERIFY(*still);
    QCOMPARE((*still)->width, 1280);
    QVERIFY(readNumber(**still));
}

// A name that no resolver is asked for.
void TestVideoLink::unknownHostsAreTold()
{
    VideoPipeline video;
    QSignalSpy failed(&video, &VideoPipeline::failed);
    QVERIFY(video.start({u"no such host"_s}));
    QTRY_COMPARE(failed.count(), 1);
    QCOMPARE(failed.first().first().value<Error>().code, ErrorCode::HostUnreachable);
}

void TestVideoLink::droneWithoutALinkIsRecorded()
{
    look(0, 30);
    const Run run = ctl({u"--json"_s, u"video"_s, path(u"a.mkv"_s), u"--from"_s, address().toString(),
                         u"--seconds"_s, u"1"_s});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    QVERIFY(run.json().value(u"seconds"_s).toDouble() >= 1);
    QCOMPARE(run.json().value(u"width"_s).toInt(), 1280);
    QCOMPARE(run.json().value(u"lost"_s).toInt(), 0);
    QCOMPARE(numbersIn(path(u"a.mkv"_s)).size(), run.json().value(u"frames"_s).toInt());
}

// The host of the link, the port that is said; datagrams are lost on the way.
void TestVideoLink::dronesAreRecorded()
{
    SimProcess drone(
        {u"--udp"_s, u"0"_s, u"--video"_s, u"0"_s, u"--frames"_s, u"60"_s, u"--fault"_s, u"lose=0.05"_s},
        u"bcflight"_s);
    const QString from = videoAddress(drone);
    QVERIFY(!from.isEmpty());
    const Run run = ctl({u"--link"_s, drone.address(), u"--json"_s, u"video"_s, path(u"a.mkv"_s), u"--from"_s,
                         from.mid(from.indexOf(u':')), u"--seconds"_s, u"3"_s});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    QVERIFY(run.json().value(u"lost"_s).toInt() > 0);
    const QList<std::uint32_t> numbers = numbersIn(path(u"a.mkv"_s));
    QVERIFY(isRising(numbers));
    QVERIFY(numbers.size() > 30);
    QCOMPARE(drone.stop(), 0);
}

void TestVideoLink::whatCannotBeRecordedIsTold()
{
    // Nothing comes.
    const Run silent
        = ctl({u"video"_s, path(u"a.mkv"_s), u"--from"_s, address().toString(), u"--seconds"_s, u"1"_s});
    QCOMPARE(silent.exitCode, 1);
    QVERIFY2(silent.err.contains(u"not one frame of video came from 127.0.0.1"_s), qPrintable(silent.err));
    QVERIFY(!QFile::exists(path(u"a.mkv"_s)));
    look();
    QCOMPARE(ctl({u"video"_s, u"/nowhere/a.mkv"_s, u"--from"_s, address().toString()}).exitCode, 1);
    QCOMPARE(ctl({u"video"_s, path(u"a.mkv"_s), u"--from"_s, u"a b"_s}).exitCode, 2);
    QCOMPARE(ctl({u"video"_s, path(u"a.mkv"_s)}).exitCode, 2);
    QCOMPARE(ctl({u"video"_s, path(u"a.mkv"_s), u"--seconds"_s, u"-1"_s}).exitCode, 2);
    // The module is not installed.
    qputenv(kVideoModuleFolder, m_dir->path().toLocal8Bit());
    const Run missing = ctl({u"video"_s, path(u"a.mkv"_s), u"--from"_s, address().toString()});
    const SimProcess blind({u"--udp"_s, u"0"_s, u"--video"_s, u"0"_s}, u"bcflight"_s);
    qunsetenv(kVideoModuleFolder);
    QCOMPARE(missing.exitCode, 1);
    QVERIFY2(missing.err.contains(u"the video module is missing"_s), qPrintable(missing.err));
    QVERIFY(blind.address().isEmpty());
}

void TestVideoLink::simulatorsWithoutACameraSaySo()
{
    const SimProcess blind({u"--udp"_s, u"0"_s, u"--video"_s, u"0"_s, u"--camera"_s, u"0"_s}, u"bcflight"_s);
    QVERIFY(blind.address().isEmpty());
    const SimProcess wrong({u"--udp"_s, u"0"_s, u"--frames"_s, u"25"_s}, u"bcflight"_s);
    QVERIFY(wrong.address().isEmpty());
}

QTEST_GUILESS_MAIN(TestVideoLink)
#include "tst_videolink.moc"
