// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/base/framelistener.h"
#include "protocol/client/deviceclient.h"
#include "protocol/session/channel.h"
#include "protocol/simplebgc/framer.h"
#include "protocol/simplebgc/payloads.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/telemetry/telemetryplan.h"
#include "tests/bench/report.h"
#include "tests/support/simprocess.h"

#include <QElapsedTimer>
#include <QSerialPort>
#include <QTemporaryDir>
#include <QTimer>

#include <atomic>
#include <thread>

using namespace Qt::StringLiterals;
using namespace simplebgc;

namespace {

constexpr int kStatus = int(CommandId::RealtimeData4);
constexpr double kFrameBytes = kRealtime4Size + 5;

void busy(milliseconds time)
{
    const TimePoint end = Clock::now() + time;
    while (Clock::now() < end) { }
}

void process(milliseconds time)
{
    QTest::qWait(int(time.count()));
}

/// Frames of one kind that reached us, and when the last urgent bytes went out.
class Counter final : public FrameListener
{
public:
    void frameReceived(const FrameView &frame, TimePoint, bool) override { frames += frame.id == kStatus; }
    void bytesSent(QByteArrayView bytes, TimePoint at) override
    {
        if (bytes.size() > 1 && static_cast<unsigned char>(bytes[1]) == unsigned(CommandId::MotorsOff))
            motorsOff = at.time_since_epoch().count();
    }
    std::atomic<quint64> frames = 0;
    std::atomic<qint64> motorsOff = 0;
};

/// The way it is often done: the port lives on the GUI thread.
class ScreenPort
{
public:
    explicit ScreenPort(const QString &address)
    {
        m_port.setPortName(LinkAddress::parse(address)->target());
        m_port.setBaudRate(115200);
        if (!m_port.open(QIODevice::ReadWrite))
            qFatal("no port");
        QObject::connect(&m_port, &QSerialPort::readyRead, &m_port, [this] {
            m_framer.feed(asBytes(m_port.readAll()), [this](const FrameView &frame) {
                frames += frame.id == kStatus;
                if (frame.id == number(CommandId::BoardInfo) && answered)
                    answered();
            });
        });
    }
    void send(int id, const QByteArray &payload) { m_port.write(encodeFrame(id, payload, 1)); }
    quint64 frames = 0;
    std::function<void()> answered;

private:
    QSerialPort m_port;
    simplebgc::Framer m_framer;
};

std::unique_ptr<DeviceClient> connectClient(const QString &address)
{
    auto client = std::make_unique<DeviceClient>(allLinks().transports, allFamilies());
    client->connectTo(*LinkAddress::parse(address), u"simplebgc"_s);
    if (!QTest::qWaitFor([&] { return client->isConnected(); }, 10000))
        qFatal("no board");
    return client;
}

// The GUI thread works for half a second of each, ten seconds long.
void blockHalf()
{
    for (int i = 0; i < 10; ++i) {
        busy(500ms);
        process(500ms);
    }
}

void benchLoss(Report &report, const QString &path)
{
    double plain = 0;
    {
        SimProcess simulator({u"--pty"_s, path});
        ScreenPort port(simulator.address());
        port.send(int(CommandId::DataStreamInterval), DataStream{kStatus, 1, QByteArray(8, '\0')}.encode());
        blockHalf();
        port.send(int(CommandId::DataStreamInterval), DataStream{kStatus, 0, QByteArray(8, '\0')}.encode());
        process(500ms);
        const SimProcess::Streams sent = simulator.streams();
        plain = 100.0 * (1.0 - double(port.frames) / double(sent.all));
    }
    SimProcess simulator({u"--pty"_s, path});
    Counter counter;
    auto client = connectClient(simulator.address());
    client->addListener(counter);
    client->subscribe({{}, 0, {{u"realtime4"_s, 1250, {}}}});
    if (!QTest::qWaitFor([&] { return client->telemetryPlan().rate == 1250.0; }, 5000))
        qFatal("no stream");
    QElapsedTimer timer;
    timer.start();
    const quint64 before = counter.frames;
    blockHalf();
    const double rate = double(counter.frames - before) / (double(timer.elapsed()) / 1000.0);
    auto stopped = client->submit<bool>(
        [bytes = client->telemetryPlan().shutdownFrames](Channel &channel, ::Device &) -> Result<bool> {
            Request request;
            request.bytes = bytes;
            channel.post(request);
            return true;
        });
    std::ignore = QTest::qWaitFor([&] { return stopped.isFinished(); }, 5000);
    process(300ms);
    const SimProcess::Streams sent = simulator.streams();
    report.atMost(u"P6"_s,
                  u"frames lost at %1 kB/s, screen blocked 500 of 1000 ms, 10 s"_s.arg(
                      rate * kFrameBytes / 1000.0, 0, 'f', 0),
                  double(sent.all - counter.frames), 0, {},
                  u"port on the GUI thread: %1 % lost of %2"_s.arg(plain, 0, 'f', 0).arg(sent.all));
    client->removeListener(counter);
}

void benchLatency(Report &report, const QString &path)
{
    constexpr auto kDue = 50ms;
    constexpr int kRequests = 120;
    SimProcess simulator({u"--pty"_s, path});
    QTimer screen;
    screen.setTimerType(Qt::PreciseTimer);
    QObject::connect(&screen, &QTimer::timeout, &screen, [] { busy(28ms); });
    std::vector<double> plain;
    {
        ScreenPort port(simulator.address());
        process(200ms);
        screen.start(33);
        const TimePoint start = Clock::now();
        int sent = 0;
        int answered = 0;
        port.answered
            = [&] { plain.push_back(seconds(Clock::now() - (start + kDue * ++answered)) * 1000.0); };
        QTimer due;
        due.setTimerType(Qt::PreciseTimer);
        QObject::connect(&due, &QTimer::timeout, &due, [&] {
            for (; sent < kRequests && Clock::now() >= start + kDue * (sent + 1); ++sent)
                port.send(int(CommandId::BoardInfo), {});
        });
        due.start(1);
        std::ignore = QTest::qWaitFor([&] { return answered >= kRequests; }, 20000);
        screen.stop();
    }
    auto client = connectClient(simulator.address());
    process(500ms);
    screen.start(33);
    auto job = client->submit<std::vector<double>>(
        [=](Channel &channel, ::Device &) -> Result<std::vector<double>> {
            std::vector<double> ms;
            const TimePoint start = Clock::now();
            for (int i = 1; i <= kRequests; ++i) {
                const TimePoint due = start + kDue * i;
                if (const auto wait = std::chrono::ceil<milliseconds>(due - Clock::now()); wait > 0ms)
                    std::ignore = channel.sleep(wait);
                const auto reply
                    = channel.transact(replyRequest(CommandId::BoardInfo, {}, CommandId::BoardInfo, 18, 1));
                if (!reply)
                    return tl::unexpected(reply.error());
                ms.push_back(seconds(Clock::now() - due) * 1000.0);
            }
            return ms;
        });
    std::ignore = QTest::qWaitFor([&] { return job.isFinished(); }, 20000);
    screen.stop();
    if (!job.result())
        qFatal("requests failed");
    const std::vector<double> ours = *job.result();
    report.atMost(u"P7"_s, u"request p99, screen busy 28 of 33 ms: own / GUI thread"_s,
                  quantile(ours, 0.99) / quantile(plain, 0.99), 0.5, {},
                  u"%1 and %2 ms; medians %3 and %4 ms"_s.arg(quantile(ours, 0.99), 0, 'f', 1)
                      .arg(quantile(plain, 0.99), 0, 'f', 1)
                      .arg(median(ours), 0, 'f', 1)
                      .arg(median(plain), 0, 'f', 1));
}

void benchMotorsOff(Report &report, const QString &path)
{
    SimProcess simulator({u"--pty"_s, path});
    Counter counter;
    auto client = connectClient(simulator.address());
    client->addListener(counter);
    process(500ms);
    auto job = client->submit<int>([](Channel &channel, ::Device &device) -> Result<int> {
        for (int i = 0; i < 60; ++i) {
            if (const auto read = device.readConfiguration(channel); !read)
                return tl::unexpected(read.error());
        }
        return 60;
    });
    process(200ms);
    std::vector<double> ms;
    std::thread button([&] {
        for (int i = 0; i < 100; ++i) {
            std::this_thread::sleep_for(60ms);
            counter.motorsOff = 0;
            const TimePoint pressed = Clock::now();
            client->motorsOff();
            while (counter.motorsOff == 0 && Clock::now() - pressed < 1s)
                std::this_thread::sleep_for(50us);
            ms.push_back(counter.motorsOff == 0
                             ? 1000.0
                             : seconds(TimePoint(Clock::duration(counter.motorsOff.load())) - pressed)
                                 * 1000.0);
        }
    });
    busy(6100ms);  // this is the GUI thread
    button.join();
    client->cancelJobs();
    std::ignore = QTest::qWaitFor([&] { return job.isFinished(); }, 5000);
    report.atMost(u"P15"_s, u"motors off until its bytes are written, job runs, screen blocked, p99"_s,
                  quantile(ms, 0.99), 20, u"ms"_s,
                  u"median %1 ms of %2"_s.arg(median(ms), 0, 'f', 2).arg(ms.size()));
    client->removeListener(counter);
}

}  // namespace

/// P6, P7, P15: what a busy screen costs the link, against a port on the GUI thread.
void benchLink(Report &report)
{
    const QTemporaryDir folder;
    benchLoss(report, folder.filePath(u"loss"_s));
    benchLatency(report, folder.filePath(u"latency"_s));
    benchMotorsOff(report, folder.filePath(u"motors"_s));
}
