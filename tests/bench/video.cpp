// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/video/scene.h"
#include "protocol/video/videoassembler.h"
#include "protocol/video/videoinspector.h"
#include "protocol/video/videomodule.h"
#include "protocol/video/videopipeline.h"
#include "tests/bench/report.h"
#include "widgets/views/videoview.h"

#include <QUdpSocket>

#include <atomic>
#include <cmath>
#include <future>
#include <random>
#include <thread>

using namespace Qt::StringLiterals;

namespace {

constexpr int kFrameRate = 60;
constexpr int kSeconds = 10;
constexpr QSize kSize(1280, 720);

/// Two seconds of a picture that moves and is as noisy as a camera's.
QList<QByteArray> makeClip(const VideoCodecs &codecs)
{
    EncoderSettings settings;
    settings.size = kSize;
    settings.frameRate = kFrameRate;
    settings.keyInterval = kFrameRate;
    settings.bitRate = 8'000'000;
    const auto encoder = codecs.makeEncoder(settings).value();
    VideoPlanes picture(kSize.width(), kSize.height());
    std::minstd_rand random(1);
    QList<QByteArray> clip;
    for (int i = 0; i < 2 * kFrameRate; ++i) {
        CameraView view;
        view.rollDeg = 10 * std::sin(i * M_PI / kFrameRate);
        view.yawDeg = 5 * std::cos(i * M_PI / kFrameRate);
        drawScene(picture, view, std::uint32_t(i));
        for (std::uint8_t &pixel : picture.y)
            pixel = std::uint8_t(std::clamp(int(pixel) + int(random() % 9) - 4, 16, 235));
        clip.append(encoder->encode(picture).value());
    }
    return clip;
}

/// Sends the clip again and again, in step, to whoever has written.
class Drone
{
public:
    explicit Drone(QList<QByteArray> clip)
        : m_clip(std::move(clip))
    {
        std::promise<quint16> bound;
        m_thread = std::thread([this, &bound] { run(bound); });
        m_port = bound.get_future().get();
    }
    ~Drone()
    {
        m_isEnding = true;
        m_thread.join();
    }
    Drone(const Drone &) = delete;
    Drone &operator=(const Drone &) = delete;

    void setSending(bool on) { m_isSending = on; }
    [[nodiscard]] quint16 port() const { return m_port; }
    /// Processor time of its thread, which a viewer does not pay for.
    [[nodiscard]] double ms() const { return m_ms; }

private:
    void run(std::promise<quint16> &bound)
    {
        QUdpSocket socket;
        socket.bind(QHostAddress::LocalHost, 0);
        bound.set_value(socket.localPort());
        QHostAddress viewer;
        quint16 port = 0;
        TimePoint next = Clock::now();
        for (qsizetype i = 0; !m_isEnding; ++i) {
            next += microseconds(1'000'000 / kFrameRate);
            std::this_thread::sleep_until(next);
            m_ms = threadMs();
            while (socket.hasPendingDatagrams())
                socket.readDatagram(nullptr, 0, &viewer, &port);
            const QByteArray &frame = m_clip[i % m_clip.size()];
            constexpr auto kPiece = qsizetype(VideoAssembler::kPiece);
            for (qsizetype at = 0; port != 0 && m_isSending && at < frame.size(); at += kPiece)
                socket.writeDatagram(frame.mid(at, kPiece), viewer, port);
        }
    }

    QList<QByteArray> m_clip;
    quint16 m_port = 0;
    std::atomic<bool> m_isSending = false;
    std::atomic<bool> m_isEnding = false;
    std::atomic<double> m_ms = 0;
    std::thread m_thread;
};

// Percent of a core that decoding alone takes at this rate.
double decodingShare(const VideoCodecs &codecs, const QList<QByteArray> &clip)
{
    const auto decoder = codecs.makeDecoder(VideoFormat::H264).value();
    VideoInspector inspector;
    const double before = processMs();
    for (const QByteArray &frame : clip)
        decoder->decode(asBytes(frame), inspector.inspect(asBytes(frame)).isKey);
    return (processMs() - before) / double(clip.size()) * kFrameRate / 10;
}

}  // namespace

/// P16: a clip of 1280x720 at 60 frames/s on the screen, unscaled, beyond the same program without video.
void benchVideo(Report &report)
{
    const VideoCodecs &codecs = *loadVideoCodecs().value();
    const QList<QByteArray> clip = makeClip(codecs);
    qint64 bytes = 0;
    for (const QByteArray &frame : clip)
        bytes += frame.size();
    const double alone = decodingShare(codecs, clip);
    Drone drone(clip);
    VideoView view;
    VideoPipeline video;
    std::vector<double> sinceCame;  // ms
    std::vector<double> sinceRead;
    QObject::connect(&video, &VideoPipeline::pictureReady, &view, [&] { view.setPicture(video.picture()); });
    QObject::connect(&view, &VideoView::painted, &video,
                     [&](const std::shared_ptr<const VideoPicture> &picture) {
                         video.painted(*picture);
                         const double behind = seconds(Clock::now() - picture->at) * 1000;
                         sinceCame.push_back(behind);
                         sinceRead.push_back(behind - seconds(picture->waited) * 1000);
                     });
    view.resize(kSize / view.devicePixelRatioF());
    view.show();
    if (!video.start({u"127.0.0.1"_s, drone.port()}))
        qFatal("no video");
    const auto share = [&drone](int seconds) {
        const double before = processMs() - drone.ms();
        waitFor(seconds * 1000);
        return (processMs() - drone.ms() - before) / (seconds * 10.0);
    };
    waitFor(1000);
    const double idle = share(kSeconds / 2);
    drone.setSending(true);
    waitFor(2000);
    const quint64 shownBefore = video.statistics().shown;
    sinceCame.clear();
    sinceRead.clear();
    const double busy = share(kSeconds);
    const VideoStatistics statistics = video.statistics();
    const double painted = double(statistics.shown - shownBefore) / kSeconds;
    const QString what = u"%1 x %2 at %3/s, %4 Mbit/s"_s.arg(kSize.width())
                             .arg(kSize.height())
                             .arg(kFrameRate)
                             .arg(double(bytes) * 8 / 2e6, 0, 'f', 1);
    report.atMost(u"P16"_s, u"share of a core for video, "_s + what, busy - idle, 30, u"%"_s,
                  u"decoding alone %1 %, idle %2 %"_s.arg(alone, 0, 'f', 1).arg(idle, 0, 'f', 1));
    report.atMost(u"P16"_s, u"the same / decoding alone"_s, (busy - idle) / alone, 3, {},
                  u"decoding alone"_s);
    report.atLeast(u"P16"_s, u"pictures/s of the screen"_s, painted, 58, u"/s"_s,
                   u"%1 lost, %2 skipped"_s.arg(statistics.lost).arg(statistics.skipped));
    report.atMost(u"P16"_s, u"latency from the kernel's receipt of the datagram to the screen, median"_s,
                  median(sinceCame), 33, u"ms"_s, u"worst %1 ms"_s.arg(quantile(sinceCame, 1), 0, 'f', 1));
    report.tell(u"the same from where the datagram was read, median"_s,
                u"%1 ms"_s.arg(median(sinceRead), 0, 'f', 2),
                u"worst %1 ms"_s.arg(quantile(sinceRead, 1), 0, 'f', 1));
}
