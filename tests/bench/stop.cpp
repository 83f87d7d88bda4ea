// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/linkbar.h"
#include "app/pages/watch/monitorpage.h"
#include "protocol/bcflight/messages.h"
#include "protocol/bcflight/payloads.h"
#include "protocol/device/device.h"
#include "protocol/device/flight.h"
#include "protocol/telemetry/telemetrystore.h"
#include "protocol/video/videopipeline.h"
#include "tests/bench/report.h"
#include "tests/support/simprocess.h"
#include "tests/support/windowrig.h"
#include "widgets/views/videoview.h"

#include <QPushButton>

#include <arpa/inet.h>
#include <atomic>
#include <cmath>
#include <ctime>
#include <numeric>
#include <poll.h>
#include <random>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace {

constexpr int kPresses = 60;
constexpr int kMotorChannels = 4;
constexpr double kUnanswered = 1000;  // ms

qint64 nanoseconds(const timespec &time)
{
    return qint64(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

// As the kernel stamps datagrams.
qint64 realTime()
{
    timespec now{};
    ::clock_gettime(CLOCK_REALTIME, &now);
    return nanoseconds(now);
}

sockaddr_in loopback(quint16 port)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

/// A wire between the window and the drone: hands datagrams on, and notes by the kernel's time stamp when
/// those that disarm and those that stop motors have come out of the window's end.
class Wire
{
public:
    explicit Wire(quint16 drone)
        : m_window(::socket(AF_INET, SOCK_DGRAM, 0))
        , m_drone(::socket(AF_INET, SOCK_DGRAM, 0))
        , m_disarm(bcflight::encode(bcflight::Message::Controls,
                                    bcflight::Controls().encode(bcflight::Generation::G),
                                    bcflight::Generation::G))
        , m_reset(bcflight::encode(bcflight::Message::ResetMotors))
    {
        const int on = 1;
        sockaddr_in here = loopback(0);
        socklen_t size = sizeof(here);
        const sockaddr_in there = loopback(drone);
        if (::bind(m_window, reinterpret_cast<sockaddr *>(&here), size) != 0
            || ::getsockname(m_window, reinterpret_cast<sockaddr *>(&here), &size) != 0
            || ::setsockopt(m_window, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof(on)) != 0
            || ::connect(m_drone, reinterpret_cast<const sockaddr *>(&there), sizeof(there)) != 0)
            qFatal("no wire");
        m_port = ntohs(here.sin_port);
        m_thread = std::thread([this] { run(); });
    }
    ~Wire()
    {
        m_isEnding = true;
        m_thread.join();
        ::close(m_window);
        ::close(m_drone);
    }
    Wire(const Wire &) = delete;
    Wire &operator=(const Wire &) = delete;

    [[nodiscard]] quint16 port() const { return m_port; }
    void forget() { m_disarmedAt = m_resetAt = 0; }
    /// When both had left for the first time since forget(), in nanoseconds of real time; 0: they have not.
    [[nodiscard]] qint64 stoppedAt() const
    {
        return m_disarmedAt == 0 || m_resetAt == 0 ? 0 : std::max<qint64>(m_disarmedAt, m_resetAt);
    }

private:
    void run()
    {
        std::array<pollfd, 2> waiting{pollfd{m_window, POLLIN, 0}, pollfd{m_drone, POLLIN, 0}};
        while (!m_isEnding) {
            if (::poll(waiting.data(), waiting.size(), 100) <= 0)
                continue;
            if (waiting[0].revents & POLLIN)
                takeFromWindow();
            if (waiting[1].revents & POLLIN)
                takeFromDrone();
        }
    }
    void takeFromWindow()
    {
        alignas(cmsghdr) char control[CMSG_SPACE(sizeof(timespec))];
        iovec room{m_buffer.data(), m_buffer.size()};
        msghdr message{};
        message.msg_name = &m_peer;
        message.msg_namelen = sizeof(m_peer);
        message.msg_iov = &room;
        message.msg_iovlen = 1;
        message.msg_control = control;
        message.msg_controllen = sizeof(control);
        const ssize_t size = ::recvmsg(m_window, &message, 0);
        if (size < 0)
            return;
        const QByteArray packet(m_buffer.data(), size);
        if (const cmsghdr *part = CMSG_FIRSTHDR(&message); part && part->cmsg_type == SCM_TIMESTAMPNS) {
            timespec came{};
            std::memcpy(&came, CMSG_DATA(part), sizeof(came));
            if (packet.startsWith(m_disarm) && m_disarmedAt == 0)
                m_disarmedAt = nanoseconds(came);
            const bool hasReset = packet.startsWith(m_reset) || packet == m_disarm + m_reset;
            if (hasReset && m_resetAt == 0)
                m_resetAt = nanoseconds(came);
        }
        std::ignore = ::send(m_drone, packet.data(), std::size_t(packet.size()), 0);
    }
    void takeFromDrone()
    {
        const ssize_t size = ::recv(m_drone, m_buffer.data(), m_buffer.size(), 0);
        if (size > 0 && m_peer.sin_port != 0)
            std::ignore = ::sendto(m_window, m_buffer.data(), std::size_t(size), 0,
                                   reinterpret_cast<const sockaddr *>(&m_peer), sizeof(m_peer));
    }

    int m_window;
    int m_drone;
    const QByteArray m_disarm;
    const QByteArray m_reset;
    quint16 m_port = 0;
    sockaddr_in m_peer{};
    std::array<char, 65536> m_buffer{};
    std::atomic<qint64> m_disarmedAt = 0;
    std::atomic<qint64> m_resetAt = 0;
    std::atomic<bool> m_isEnding = false;
    std::thread m_thread;
};

// What a job has to do is asked of the board block by block.
void queueReading(DeviceClient &client)
{
    client.submit<bool>([](Channel &channel, Device &device) -> Result<bool> {
        return device.readConfiguration(channel).map([](const auto &) { return true; });
    });
}

/// Presses the red button at any moment, again and again. @param before what is done before each press
/// @return milliseconds from each press to the wire
std::vector<double> press(WindowRig &rig, Wire &wire, const std::function<void()> &before)
{
    QPushButton *button = rig.window().findChild<LinkBar *>()->motorsButton();
    std::minstd_rand random(7);
    std::vector<double> ms;
    for (int i = 0; i < kPresses; ++i) {
        QEventLoop loop;
        QObject::connect(&rig.client(), &DeviceClient::motorsOffFinished, &loop, &QEventLoop::quit);
        before();
        waitFor(20 + int(random() % 60));
        wire.forget();
        std::atomic<qint64> pressed = 0;
        // The finger knows nothing of what the screen is doing.
        std::thread finger([&, pause = microseconds(random() % 20'000)] {
            std::this_thread::sleep_for(pause);
            pressed = realTime();
            QMetaObject::invokeMethod(button, &QPushButton::click, Qt::QueuedConnection);
        });
        QTimer::singleShot(5000, &loop, &QEventLoop::quit);
        loop.exec();
        finger.join();
        if (wire.stoppedAt() != 0)
            ms.push_back(double(wire.stoppedAt() - pressed) / 1e6);
    }
    return ms;
}

/// Milliseconds from a question to its answer, by a socket and nothing else; kUnanswered or more without one.
double askBare(int socket, bcflight::Message message, const QByteArray &payload = {})
{
    const QByteArray question = bcflight::encode(message, payload, bcflight::Generation::G);
    std::array<char, 2048> buffer{};
    const qint64 asked = realTime();
    std::ignore = ::send(socket, question.data(), std::size_t(question.size()), 0);
    const auto waited = [asked] { return double(realTime() - asked) / 1e6; };
    pollfd ready{socket, POLLIN, 0};
    while (waited() < kUnanswered && ::poll(&ready, 1, int(kUnanswered)) > 0) {
        const ssize_t size = ::recv(socket, buffer.data(), buffer.size(), 0);
        if (size > 0 && QByteArrayView(buffer.data(), size).startsWith(question.first(1)))
            break;  // not the stream
    }
    return waited();
}

/// The same question by a job of this program, from its worker and back to it.
double askOwn(DeviceClient &client)
{
    double ms = 0;
    auto done = client.submit<bool>([&ms](Channel &channel, Device &device) {
        const qint64 asked = realTime();
        return device.flight()->askArmed(channel).map([&](bool armed) {
            ms = double(realTime() - asked) / 1e6;
            return armed;
        });
    });
    while (!done.isFinished())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
    return ms;
}

/// What a question costs through this program, while its window draws, and through a bare socket, in turn.
void benchRoundTrip(Report &report, DeviceClient &client)
{
    SimProcess other({u"--udp"_s, u"0"_s}, u"bcflight"_s);
    const int bare = ::socket(AF_INET, SOCK_DGRAM, 0);
    const sockaddr_in peer = loopback(other.address().section(u':', -1).toUShort());
    if (::connect(bare, reinterpret_cast<const sockaddr *>(&peer), sizeof(peer)) != 0)
        qFatal("no drone");
    const QByteArray ticks(4, '\0');
    for (int i = 0; askBare(bare, bcflight::Message::Ping, ticks) >= kUnanswered; ++i) {
        if (i == 5)
            qFatal("the drone does not answer");
    }
    std::vector<double> own;
    std::vector<double> base;
    for (int i = 0; i < 200; ++i) {
        base.push_back(askBare(bare, bcflight::Message::Status));
        own.push_back(askOwn(client));
    }
    ::close(bare);
    report.tell(u"round trip to a drone while its video and Monitor run: own / bare socket"_s,
                QString::number(median(own) / median(base), 'f', 1),
                u"median %1 / %2 ms, worst %3 / %4 ms"_s.arg(median(own), 0, 'f', 2)
                    .arg(median(base), 0, 'f', 2)
                    .arg(quantile(own, 1), 0, 'f', 1)
                    .arg(quantile(base, 1), 0, 'f', 1));
}

}  // namespace

/// P17: from the red button to the wire, while Monitor draws what a drone streams, its video runs and a job
/// goes on.
void benchStop(Report &report)
{
    SimProcess drone({u"--udp"_s, u"0"_s, u"--video"_s, u"0"_s}, u"bcflight"_s);
    if (!QTest::qWaitFor([&] { return drone.process().canReadLine(); }, kPatience))
        qFatal("no camera");
    const quint16 camera = QString::fromLatin1(drone.process().readLine()).section(u':', -1).toUShort();
    Wire wire(drone.address().section(u':', -1).toUShort());
    WindowRig rig;
    if (!rig.open(u"udp://127.0.0.1:%1"_s.arg(wire.port())))
        qFatal("no drone");
    if (!rig.window().showPage(u"system"_s) || !rig.jobsAreDone())
        qFatal("no page");
    const std::vector<double> idle = press(rig, wire, [] {});

    auto *monitor = rig.page<MonitorPage>();
    const ChannelRoles &roles = rig.workspace().roles();
    QList<int> channels = ChannelRoles::present({roles.angle, roles.gyro, roles.acc});
    channels += roles.motors.first(std::min<qsizetype>(roles.motors.size(), kMotorChannels));
    std::sort(channels.begin(), channels.end());
    monitor->channels().setTicked(channels);
    PaintCounter paints;
    monitor->plots().first()->viewport()->installEventFilter(&paints);
    VideoView view;
    VideoPipeline video;
    QObject::connect(&video, &VideoPipeline::pictureReady, &view, [&] { view.setPicture(video.picture()); });
    QObject::connect(&view, &VideoView::painted, &video,
                     [&](const std::shared_ptr<const VideoPicture> &picture) { video.painted(*picture); });
    view.resize(960, 540);
    view.show();
    if (!video.start({u"127.0.0.1"_s, camera}))
        qFatal("no video");
    if (!QTest::qWaitFor([&] { return video.statistics().shown > 10; }, kPatience))
        qFatal("no picture");
    const quint64 rows = rig.client().telemetry()->rows();
    const quint64 shown = video.statistics().shown;
    paints.count = 0;
    const TimePoint begun = Clock::now();
    const std::vector<double> loaded = press(rig, wire, [&] {
        queueReading(rig.client());
        queueReading(rig.client());
    });
    const double time = seconds(Clock::now() - begun);

    const QString what
        = u"%1 presses, %2 samples/s on %3 series at %4 frames/s, %5 pictures/s of video"_s.arg(loaded.size())
              .arg(double(rig.client().telemetry()->rows() - rows) / time, 0, 'f', 0)
              .arg(channels.size())
              .arg(paints.count / time, 0, 'f', 0)
              .arg(double(video.statistics().shown - shown) / time, 0, 'f', 0);
    report.atLeast(u"P17"_s, u"presses of the red button that reached the wire"_s,
                   double(std::min(idle.size(), loaded.size())), kPresses, {}, {});
    report.atMost(
        u"P17"_s, u"red button to the wire, a job queued, "_s + what, median(loaded), 20, u"ms"_s,
        u"idle: median %1 ms, worst %2 ms"_s.arg(median(idle), 0, 'f', 2).arg(quantile(idle, 1), 0, 'f', 1));
    report.atMost(u"P17"_s, u"the same, the worst"_s, quantile(loaded, 1), 100, u"ms"_s,
                  u"median / idle median: %1"_s.arg(median(loaded) / median(idle), 0, 'f', 1));
    benchRoundTrip(report, rig.client());
}
