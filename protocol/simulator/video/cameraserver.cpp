// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/video/cameraserver.h"

#include "protocol/base/clock.h"
#include "protocol/simulator/video/scene.h"
#include "protocol/video/videoassembler.h"
#include "protocol/video/videomodule.h"

#include <QHostAddress>
#include <QTimer>
#include <QUdpSocket>
#include <QVariant>

#include <random>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kPatience = 5s;  // without a word from who watches
constexpr auto kIdlePeriod = 20ms;
constexpr int kKernelBuffer = 4 * 1024 * 1024;

/// What runs on the thread.
class Sender final : public QObject
{
public:
    Sender(std::shared_ptr<const CameraFeed> feed, const VideoCodecs &codecs,
           std::unique_ptr<QUdpSocket> socket)
        : m_feed(std::move(feed))
        , m_codecs(codecs)
        , m_socket(socket.release())
        , m_timer(this)
        , m_picture(CameraServer::kWidth, CameraServer::kHeight)
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        m_timer.setSingleShot(true);
        m_socket->setParent(this);
        connect(m_socket, &QUdpSocket::readyRead, this, [this] { hear(); });
        connect(&m_timer, &QTimer::timeout, this, [this] { tick(); });
    }

    void start() { m_timer.start(0); }

private:
    void hear()
    {
        while (m_socket->hasPendingDatagrams()) {
            m_socket->readDatagram(nullptr, 0, &m_peer, &m_peerPort);
            m_heardAt = Clock::now();
        }
    }

    void tick()
    {
        const TimePoint now = Clock::now();
        const auto view = m_feed->view();
        if (!view || m_peerPort == 0 || now - m_heardAt > kPatience) {
            m_next = {};
            m_encoder.reset();  // who watches next begins with a key frame
            m_timer.start(kIdlePeriod);
            return;
        }
        sendFrame(*view);
        // In step, as a camera is; after a pause it does not catch up.
        const auto period = durationFromSeconds(1.0 / view->frameRate);
        m_next = m_next == TimePoint() || now - m_next > 3 * period ? now + period : m_next + period;
        const auto wait = std::chrono::duration_cast<milliseconds>(m_next - Clock::now());
        m_timer.start(std::max(wait, 0ms));
    }

    void sendFrame(const CameraView &view)
    {
        const VideoFormat format = view.isMjpeg ? VideoFormat::Mjpeg : VideoFormat::H264;
        if (!m_encoder || m_frameRate != view.frameRate || m_wanted != format) {
            EncoderSettings settings;
            settings.frameRate = m_frameRate = view.frameRate;
            settings.keyInterval = view.frameRate / 2;
            settings.format = m_wanted = format;
            auto encoder = m_codecs.makeEncoder(settings);
            if (!encoder)
                return;
            m_encoder = std::move(*encoder);
        }
        drawScene(m_picture, view, m_number++);
        const auto frame = m_encoder->encode(m_picture);
        if (!frame)
            return;
        constexpr auto kPiece = qsizetype(VideoAssembler::kPiece);
        for (qsizetype at = 0; at < frame->size(); at += kPiece) {
            if (m_chance(m_random) >= view.loss)
                m_socket->writeDatagram(frame->mid(at, kPiece), m_peer, m_peerPort);
        }
    }

    std::shared_ptr<const CameraFeed> m_feed;
    const VideoCodecs &m_codecs;
    QUdpSocket *m_socket;  // a child, so that it moves along
    QTimer m_timer;
    VideoPlanes m_picture;
    std::unique_ptr<VideoEncoder> m_encoder;
    int m_frameRate = 0;
    VideoFormat m_wanted = VideoFormat::Unknown;
    std::uint32_t m_number = 0;
    QHostAddress m_peer;
    quint16 m_peerPort = 0;
    TimePoint m_heardAt{};
    TimePoint m_next{};
    std::minstd_rand m_random{1};
    std::uniform_real_distribution<double> m_chance{0, 1};
};

}  // namespace

CameraServer::CameraServer(std::shared_ptr<const CameraFeed> feed)
    : m_feed(std::move(feed))
{
    m_thread.setObjectName(u"gimbal-camera"_s);
}

CameraServer::~CameraServer()
{
    m_thread.quit();
    m_thread.wait();
}

Result<void> CameraServer::start(quint16 port)
{
    const auto codecs = loadVideoCodecs();
    if (!codecs)
        return tl::unexpected(codecs.error());
    const auto encoder = (*codecs)->makeEncoder({});
    if (!encoder)
        return tl::unexpected(encoder.error());
    m_isWithoutH264 = (*encoder)->format() != VideoFormat::H264;
    auto socket = std::make_unique<QUdpSocket>();
    if (!socket->bind(QHostAddress::LocalHost, port))
        return failure(ErrorCode::PortBusy, u"UDP port %1: %2"_s.arg(port).arg(socket->errorString()));
    socket->setSocketOption(QAbstractSocket::SendBufferSizeSocketOption, kKernelBuffer);
    m_port = socket->localPort();
    auto *sender = new Sender(m_feed, **codecs, std::move(socket));
    sender->moveToThread(&m_thread);
    QObject::connect(&m_thread, &QThread::started, sender, [sender] { sender->start(); });
    QObject::connect(&m_thread, &QThread::finished, sender, &QObject::deleteLater);
    m_thread.start();
    return {};
}
