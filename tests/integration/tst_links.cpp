// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/client/deviceclient.h"
#include "protocol/device/abilities.h"
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/session/linkstatistics.h"
#include "protocol/simplebgc/device.h"
#include "protocol/telemetry/streams.h"
#include "protocol/telemetry/telemetryplan.h"
#include "protocol/telemetry/telemetrystore.h"
#include "protocol/transport/systemtransport.h"
#include "tests/support/boardtime.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QTimer>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <thread>

using namespace Qt::StringLiterals;

namespace {

/// Waits for a future without blocking the event loop.
template <typename T> Result<T> wait(QFuture<Result<T>> future, int ms = kPatience)
{
    if (!QTest::qWaitFor([&future] { return future.isFinished(); }, ms))
        return failure(ErrorCode::Timeout, u"the test waited too long"_s);
    return future.result();
}

std::unique_ptr<DeviceClient> makeClient()
{
    return std::make_unique<DeviceClient>(allLinks().transports, allFamilies());
}

bool connectTo(DeviceClient &client, const QString &address, int ms = kPatience)
{
    client.connectTo(*LinkAddress::parse(address), u"simplebgc"_s);
    return QTest::qWaitFor([&client] { return client.state() != DeviceClient::State::Connecting; }, ms)
        && client.isConnected();
}

Result<Configuration> read(DeviceClient &client)
{
    return wait(client.submit<Configuration>(
        [](Channel &channel, Device &device) { return device.readConfiguration(channel); }));
}

/// Looks at raw bytes from the client's side of a TCP link, at the time they come, on a thread of its own.
/// Everything is passed on to a simulator, or swallowed.
class WireTap
{
public:
    explicit WireTap(quint16 simulatorPort)
        : m_simulatorPort(simulatorPort)
    {
        m_thread = std::thread([this] { run(); });
        std::ignore = QTest::qWaitFor([this] { return m_port.load() != 0; }, kPatience);
    }
    ~WireTap()
    {
        m_stop = true;
        m_thread.join();
    }
    WireTap(const WireTap &) = delete;
    WireTap &operator=(const WireTap &) = delete;
    [[nodiscard]] QString address() const { return u"tcp://127.0.0.1:%1"_s.arg(m_port.load()); }
    /// Time at which the frame was last seen going to the board, or nothing.
    [[nodiscard]] std::optional<TimePoint> seen(int id)
    {
        const std::lock_guard lock(m_mutex);
        const auto it = m_seen.find(id);
        return it == m_seen.end() ? std::nullopt : std::optional(it->second);
    }
    void forget(int id)
    {
        const std::lock_guard lock(m_mutex);
        m_seen.erase(id);
    }
    int count(int id)
    {
        const std::lock_guard lock(m_mutex);
        return m_counts[id];
    }
    /// The next frames of this kind do not reach the board.
    void swallow(int id, int count)
    {
        const std::lock_guard lock(m_mutex);
        m_swallowed[id] = count;
    }
    /// The client's side of the link breaks; it may connect again.
    void dropLink() { m_drop = true; }
    /// From now on whoever connects is sent away at once.
    void slam(bool slams) { m_slams = slams; }
    /// When somebody was sent away.
    std::vector<TimePoint> sentAway()
    {
        const std::lock_guard lock(m_mutex);
        return m_sentAway;
    }

private:
    void run()
    {
        QTcpServer server;
        server.listen(QHostAddress::LocalHost, 0);
        m_port = server.serverPort();
        std::unique_ptr<QTcpSocket> client;
        QTcpSocket board;
        const auto framer = simplebgc::family().makeFramer();
        QByteArray passed;
        const FrameSink sink = [&](const FrameView &frame) {
            const std::lock_guard lock(m_mutex);
            m_seen[frame.id] = Clock::now();
            ++m_counts[frame.id];
            if (int &swallowed = m_swallowed[frame.id]; swallowed > 0)
                --swallowed;
            else
                passed += toByteArray(frame.raw);
        };
        board.connectToHost(QHostAddress::LocalHost, m_simulatorPort);
        board.waitForConnected(2000);
        board.setSocketOption(QAbstractSocket::LowDelayOption, 1);
        while (!m_stop) {
            if (!client) {
                if (server.waitForNewConnection(5))
                    client.reset(server.nextPendingConnection());
                if (client && m_slams) {
                    const std::lock_guard lock(m_mutex);
                    m_sentAway.push_back(Clock::now());
                    client.reset();
                }
                continue;
            }
            if (m_drop.exchange(false)) {
                client.reset();
                continue;
            }
            if (client->waitForReadyRead(1)) {
                framer->feed(asBytes(client->readAll()), sink);
                board.write(std::exchange(passed, {}));
                board.flush();
            }
            if (board.bytesAvailable() > 0 || board.waitForReadyRead(0)) {
                client->write(board.readAll());
                client->flush();
            }
        }
    }

    quint16 m_simulatorPort;
    std::atomic<quint16> m_port = 0;
    std::atomic<bool> m_stop = false;
    std::atomic<bool> m_drop = false;
    std::atomic<bool> m_slams = false;
    std::mutex m_mutex;
    std::map<int, TimePoint> m_seen;
    std::map<int, int> m_swallowed;
    std::map<int, int> m_counts;
    std::vector<TimePoint> m_sentAway;
    std::thread m_thread;
};

quint16 portOf(const SimProcess &simulator)
{
    return LinkAddress::parse(simulator.address())->port();
}

constexpr int kControl = 67;
constexpr int kMotorsOff = 109;

}  // namespace

/// The real session, worker and client over real links: QSerialPort on a pseudo-terminal, TCP, and each
/// fault.
class TestLinks : public QObject
{
    Q_OBJECT
private slots:
    void theWorldChangesOnStandardInput();
    void serialPortOverPseudoTerminal();
    void serialFindsTheRate();
    void tcp();
    void inProcess();
    void explainsFailures_data();
    void explainsFailures();
    void faults_data();
    void faults();
    void unplugAndReplugKeepsTheBoard();
    void resetDuringAWriteEndsWithATrueReport();
    void resetNoticeReconnects();
    void restartWithoutNoticeIsNoticed_data();
    void restartWithoutNoticeIsNoticed();
    void restartWhileSteeringEndsIt();
    void calibrationIsNoRestart();
    void unansweredPollsAreLost();
    void motorsOffIsFastWhileEverythingIsBusy();
    void motorsOffIsRepeatedUntilConfirmed();
    void deadManStopsWhenTheScreenIsBlocked();
    void failsafeIsToldOncePerLink();
    void motorsOffCancelsAMovingJob();
    void cancelledJobsEndAtOnce();
    void telemetryGoesOnWhileTheScreenIsBlocked();
    void submittingWithoutABoardFails();
    void resultsComeFromTheEventLoop();
    void unfinishedJobsHaveResultsAfterTheEnd();
    void peerThatClosesAtOnceIsTriedAtEase();
    void foreignProtocolIsNamed();
    void portInUseIsToldAsBusy();
};

void TestLinks::serialPortOverPseudoTerminal()
{
    QTemporaryDir dir;
    const QString path = dir.filePath(u"gimbal"_s);
    SimProcess simulator({u"--pty"_s, path});
    QCOMPARE(simulator.address(), path);
    auto client = makeClient();
    QVERIFY(connectTo(*client, u"serial:"_s + path));
    QCOMPARE(client->identity().firmware, u"2.59b0"_s);
    const auto configuration = read(*client);
    QVERIFY(configuration);
    QCOMPARE(configuration->blocks().size(), std::size_t(20));

    // Write over the same port, and see that a second client reads it.
    Configuration edited = *configuration;
    QVERIFY(edited.setRaw(*edited.parameters().find(u"pid.roll.p"_s), 0, 61));
    const BoardHistory history(dir.path());
    const auto report = wait(client->submit<WriteReport>([&](Channel &channel, Device &device) {
        WriteOptions options;
        options.history = &history;
        return writeConfiguration(channel, device, *configuration, edited, options);
    }));
    QVERIFY(report && report->isComplete());
    client.reset();
    auto second = makeClient();
    QVERIFY(connectTo(*second, path));
    const auto again = read(*second);
    QVERIFY(again);
    QCOMPARE(*again->raw(*again->parameters().find(u"pid.roll.p"_s), 0), 61);

    // Full rate over the pseudo-terminal, nothing lost.
    const ChannelRoles roles = second->roles();
    second->subscribe({QList<int>(roles.angle.begin(), roles.angle.end()), 0});
    QTRY_VERIFY(second->telemetryPlan().rate == 1250.0);
    const SimProcess::Streams sentBefore = simulator.streams();
    const quint64 before = second->telemetry()->rows();
    QTRY_VERIFY(second->telemetry()->rows() - before > 2000);
    // However fast this machine is: what the board has sent by now arrives.
    const SimProcess::Streams sent = simulator.streams();
    QCOMPARE(sent.skipped, sentBefore.skipped);
    QTRY_VERIFY(second->telemetry()->rows() - before >= sent.all - sentBefore.all);
    QCOMPARE(second->telemetry()->lost(), quint64(0));
    second.reset();
    QCOMPARE(simulator.stop(), 0);
    QVERIFY(!QFileInfo(path).isSymLink());
}

void TestLinks::serialFindsTheRate()
{
    QTemporaryDir dir;
    const QString path = dir.filePath(u"gimbal"_s);
    SimProcess simulator({u"--pty"_s, path, u"--rate"_s, u"38400"_s, u"--parity"_s, u"even"_s});
    QVERIFY(!simulator.address().isEmpty());
    auto client = makeClient();
    QSignalSpy progress(client.get(), &DeviceClient::progressChanged);
    QVERIFY(connectTo(*client, u"serial:"_s + path));
    QCOMPARE(client->line()->baud, 38400);
    QVERIFY(!client->identity().usb);
    QVERIFY(progress.count() >= 3);
    QVERIFY(read(*client));
}

void TestLinks::tcp()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s});
    auto client = makeClient();
    QVERIFY(connectTo(*client, simulator.address()));
    QVERIFY(read(*client));
    QVERIFY(!client->line());
    client->disconnectFromBoard();
    QCOMPARE(client->state(), DeviceClient::State::Disconnected);
    // And once more: the simulator takes the next client.
    QVERIFY(connectTo(*client, simulator.address()));
}

void TestLinks::inProcess()
{
    auto client = makeClient();
    QVERIFY(connectTo(*client, u"sim:simplebgc?seed=7&rate=57600&parity=even"_s));
    QCOMPARE(client->line()->baud, 57600);
    QVERIFY(read(*client));
}

void TestLinks::explainsFailures_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<int>("code");
    QTest::newRow("no such port") << u"serial:/dev/nonexistent"_s << int(ErrorCode::PortNotFound);
    QTest::newRow("nothing listens") << u"tcp://127.0.0.1:9"_s << int(ErrorCode::HostUnreachable);
    QTest::newRow("bad simulator") << u"sim:nonsense"_s << int(ErrorCode::InvalidArgument);
    QTest::newRow("silent board") << u"sim:simplebgc?fault=lose=1"_s << int(ErrorCode::Silent);
}

void TestLinks::explainsFailures()
{
    QFETCH(QString, address);
    QFETCH(int, code);
    auto client = makeClient();
    QSignalSpy failed(client.get(), &DeviceClient::connectionFailed);
    client->connectTo(*LinkAddress::parse(address), u"simplebgc"_s);
    QTRY_COMPARE(failed.count(), 1);
    QCOMPARE(int(failed.first().first().value<Error>().code), code);
    QCOMPARE(client->state(), DeviceClient::State::Disconnected);
}

void TestLinks::faults_data()
{
    QTest::addColumn<QString>("fault");
    QTest::addColumn<QString>("faultKey");
    QTest::newRow("lost bytes") << u"lose=0.0002"_s << QString();
    QTest::newRow("flipped bytes") << u"flip=0.0002"_s << QString();
    QTest::newRow("doubled bytes") << u"double=0.0002"_s << QString();
    QTest::newRow("delayed bytes") << u"delay=30"_s << QString();
    QTest::newRow("missing IMU") << u"no-imu=1"_s << u"no-sensor"_s;
    QTest::newRow("low battery") << u"battery=10.2"_s << u"low-battery"_s;
}

void TestLinks::faults()
{
    QFETCH(QString, fault);
    QFETCH(QString, faultKey);
    SimProcess simulator({u"--tcp"_s, u"0"_s, u"--fault"_s, fault, u"--seed"_s, u"3"_s});
    auto client = makeClient();
    QVERIFY(connectTo(*client, simulator.address()));
    const auto configuration = read(*client);
    QVERIFY(configuration);
    QCOMPARE(*configuration->raw(*configuration->parameters().find(u"pid.roll.p"_s), 0), 35);
    if (faultKey.isEmpty())
        return;
    const ChannelRoles roles = client->roles();
    QTRY_VERIFY(client->telemetry()->latest(roles.faults) > 0);
    QStringList keys;
    for (const BoardFault &found :
         client->device()->faultWords()->faults(unsigned(client->telemetry()->latest(roles.faults)), 0))
        keys.append(found.key);
    QVERIFY(keys.contains(faultKey));
}

void TestLinks::unplugAndReplugKeepsTheBoard()
{
    QTemporaryDir dir;
    const QString path = dir.filePath(u"gimbal"_s);
    SimProcess simulator({u"--pty"_s, path, u"--fault"_s, u"unplug=3"_s, u"--fault"_s, u"replug=1.5"_s});
    auto client = makeClient();
    QSignalSpy lost(client.get(), &DeviceClient::connectionLost);
    QVERIFY(connectTo(*client, path));
    QVERIFY(wait(client->submit<bool>([](Channel &channel, Device &device) -> Result<bool> {
        const auto done = device.profiles()->writeProfileNames(channel, {u"Mine"_s, {}, {}, {}, {}});
        return done ? Result<bool>(true) : tl::unexpected(done.error());
    })));
    QTRY_COMPARE(lost.count(), 1);
    QCOMPARE(client->state(), DeviceClient::State::Reconnecting);
    QTRY_COMPARE(client->state(), DeviceClient::State::Connected);
    const auto configuration = read(*client);
    QVERIFY(configuration);
    QCOMPARE(configuration->profileNames().first(), u"Mine"_s);
}

void TestLinks::resetDuringAWriteEndsWithATrueReport()
{
    QTemporaryDir dir;
    const QString path = dir.filePath(u"gimbal"_s);
    SimProcess simulator({u"--pty"_s, path, u"--fault"_s, u"reset-on-write=2"_s});
    auto client = makeClient();
    QVERIFY(connectTo(*client, path));
    const auto base = read(*client);
    QVERIFY(base);
    Configuration edited = *base;
    for (int profile = 0; profile < 4; ++profile)
        QVERIFY(edited.setRaw(*edited.parameters().find(u"pid.roll.p"_s), profile, 70 + profile));
    const BoardHistory history(dir.path());
    QSignalSpy lost(client.get(), &DeviceClient::connectionLost);
    const auto report = wait(client->submit<WriteReport>([&](Channel &channel, Device &device) {
        WriteOptions options;
        options.history = &history;
        return writeConfiguration(channel, device, *base, edited, options);
    }));
    QVERIFY(report);
    QVERIFY(!report->isComplete());
    QCOMPARE(report->count(WriteState::Verified), 0);  // nothing was read back
    QVERIFY(report->count(WriteState::Unknown) >= 1);
    QVERIFY(report->count(WriteState::NotWritten) >= 1);
    QVERIFY(QFile::exists(report->snapshotPath));
    QTRY_COMPARE(lost.count(), 1);
    QTRY_COMPARE(client->state(), DeviceClient::State::Connected);
    const auto now = read(*client);
    QVERIFY(now);
    QVERIFY(!now->changesTo(edited).empty());
}

void TestLinks::resetNoticeReconnects()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s, u"--rate"_s, u"115200"_s});
    auto client = makeClient();
    QVERIFY(connectTo(*client, simulator.address()));
    QSignalSpy lost(client.get(), &DeviceClient::connectionLost);
    QVERIFY(wait(client->submit<ActionReply>([](Channel &channel, Device &device) {
        return device.perform(channel, u"reset"_s, {{u"delay"_s, 800}});
    })));
    QTRY_COMPARE(lost.count(), 1);
    QCOMPARE(client->loss(), DeviceClient::Loss::OrderedRestart);
    QTRY_COMPARE(client->state(), DeviceClient::State::Connected);
    QVERIFY(read(*client));
    QVERIFY(boardGoesOn(*client, 3.0));
    QCOMPARE(lost.count(), 1);  // the order is used up, and nothing else was lost
}

void TestLinks::restartWithoutNoticeIsNoticed_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<bool>("isFast");
    QTest::addColumn<bool>("isBlocked");
    QTest::newRow("streams") << u"simplebgc"_s << false << false;
    QTest::newRow("fast stream") << u"simplebgc"_s << true << false;
    QTest::newRow("polled") << u"storm32"_s << false << false;
    QTest::newRow("the screen stands still") << u"simplebgc"_s << true << true;
}

// The link stays: the streams are gone, what was in use is the stored again.
void TestLinks::restartWithoutNoticeIsNoticed()
{
    QFETCH(QString, family);
    QFETCH(bool, isFast);
    QFETCH(bool, isBlocked);
    SimProcess simulator({u"--tcp"_s, u"0"_s, u"--rate"_s, u"115200"_s}, family);
    auto client = makeClient();
    client->connectTo(*LinkAddress::parse(simulator.address()), family);
    QTRY_VERIFY(client->isConnected());
    QSignalSpy lost(client.get(), &DeviceClient::connectionLost);
    if (isFast)
        client->subscribe({{client->roles().gyro[0]}, 0});
    QVERIFY(boardGoesOn(*client, 1.0));
    simulator.process().write("reset=0\n");
    // Until the board is back.
    if (isBlocked && simulator.process().waitForBytesWritten())
        QThread::sleep(3);
    QTRY_COMPARE(lost.count(), 1);
    QCOMPARE(lost.first().first().value<Error>().code, ErrorCode::Restarted);
    QCOMPARE(client->loss(), DeviceClient::Loss::Restart);
    QTRY_VERIFY(client->isConnected());
    QVERIFY(boardGoesOn(*client, 3.0));
    QCOMPARE(lost.count(), 1);
}

// Set-points go on until it is noticed: what a board that is back has taken of them is stopped.
void TestLinks::restartWhileSteeringEndsIt()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s, u"--rate"_s, u"115200"_s});
    auto client = makeClient();
    QVERIFY(connectTo(*client, simulator.address()));
    QVERIFY(boardGoesOn(*client, 1.0));
    QSignalSpy lost(client.get(), &DeviceClient::connectionLost);
    QSignalSpy ended(client.get(), &DeviceClient::steeringEnded);
    QSignalSpy rescued(client.get(), &DeviceClient::failsafeActed);
    QTimer steering;
    connect(&steering, &QTimer::timeout, client.get(), [&client] {
        client->setControl({1, {std::nan(""), std::nan(""), 10.0}, {}});
    });
    connect(client.get(), &DeviceClient::connectionLost, &steering, &QTimer::stop);
    steering.start(50);
    QTRY_VERIFY(client->isSteering());
    simulator.process().write("reset=0\n");
    QTRY_COMPARE(lost.count(), 1);
    QCOMPARE(client->loss(), DeviceClient::Loss::Restart);
    QTRY_VERIFY(client->isConnected());
    const auto target = [&] {
        return wait(client->submit<ActionReply>([](Channel &channel, Device &device) {
                   return device.perform(channel, u"angles"_s, {});
               }))
            .value_or(ActionReply())
            .value(u"target.yaw"_s)
            .toDouble();
    };
    const double before = target();
    QVERIFY(boardGoesOn(*client, 1.0));
    QVERIFY2(std::abs(target() - before) < 0.5, qPrintable(QString::number(target() - before)));
    QCOMPARE(ended.count(), 1);
    QVERIFY(ended.first().first().toBool());
    QCOMPARE(rescued.count(), 0);
    QCOMPARE(lost.count(), 1);
}

// It answers nothing for four seconds, and streams late.
void TestLinks::calibrationIsNoRestart()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s, u"--rate"_s, u"115200"_s, u"--fault"_s, u"late-streams=1.8"_s});
    auto client = makeClient();
    QVERIFY(connectTo(*client, simulator.address()));
    QVERIFY(boardGoesOn(*client, 1.0));
    QSignalSpy lost(client.get(), &DeviceClient::connectionLost);
    const auto calibrated = wait(client->submit<ActionReply>([](Channel &channel, Device &device) {
        return device.perform(channel, u"calibrate.gyro"_s,
                              {{u"imu"_s, 0}, {u"action"_s, 1}, {u"form"_s, 0}});
    }));
    QVERIFY2(calibrated, calibrated ? "" : qPrintable(calibrated.error().detail));
    QVERIFY(boardGoesOn(*client, 5.0));
    QCOMPARE(lost.count(), 0);
}

// What was asked for and not sent is lost, and nothing tells how fast the board answers.
void TestLinks::unansweredPollsAreLost()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s}, u"storm32"_s);
    auto client = makeClient();
    client->connectTo(*LinkAddress::parse(simulator.address()), u"storm32"_s);
    QTRY_VERIFY(client->isConnected());
    QVERIFY(boardGoesOn(*client, 1.0));
    QTRY_VERIFY(client->statistics().roundTrip.has_value());
    const quint64 before = client->telemetry()->lost();
    simulator.process().write("deaf=100\n");
    QTRY_VERIFY(client->telemetry()->lost() >= before + 3);
    QTRY_VERIFY(!client->statistics().roundTrip);
    simulator.process().write("deaf=-1\n");
    QVERIFY(boardGoesOn(*client, 1.0));
    QTRY_VERIFY(client->statistics().roundTrip.has_value());
    QVERIFY(client->telemetry()->lost() >= before + 3);
}

void TestLinks::motorsOffIsFastWhileEverythingIsBusy()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s});
    WireTap tap(portOf(simulator));
    auto client = makeClient();
    QVERIFY(connectTo(*client, tap.address()));
    const ChannelRoles roles = client->roles();
    client->subscribe({QList<int>(roles.gyro.begin(), roles.gyro.end()), 0});
    QTRY_VERIFY(client->telemetryPlan().rate > 0);
    // A long job runs: the whole board read over and over.
    std::atomic<int> runs = 0;
    auto job = client->submit<int>([&runs](Channel &channel, Device &device) -> Result<int> {
        for (int i = 0; i < 12; ++i) {
            ++runs;
            if (const auto configuration = device.readConfiguration(channel); !configuration)
                return tl::unexpected(configuration.error());
        }
        return 12;
    });
    QTRY_VERIFY(runs > 0);
    // The GUI thread is blocked meanwhile; another thread presses the button again and again.
    std::vector<double> latencies;
    std::thread button([&] {
        for (int i = 0; i < 20; ++i) {
            boardGoesOnWhileBlocked(*client, 0.09);
            tap.forget(kMotorsOff);
            const TimePoint pressed = Clock::now();
            client->motorsOff();
            while (!tap.seen(kMotorsOff) && Clock::now() - pressed < 1s)
                std::this_thread::sleep_for(200us);
            const auto seen = tap.seen(kMotorsOff);
            latencies.push_back(seen ? seconds(*seen - pressed) * 1000.0 : 1000.0);
        }
    });
    button.join();  // this is the GUI thread
    QCOMPARE(latencies.size(), std::size_t(20));
    std::sort(latencies.begin(), latencies.end());
    qInfo() << "motors off on the wire after" << latencies[latencies.size() / 2] << "ms (median),"
            << latencies.back() << "ms (worst) of" << latencies.size();
    // The goal is 20 ms; the machine that tests may be busy, so the median has to hold it.
    QVERIFY(latencies[latencies.size() / 2] < 20.0);
    QVERIFY(latencies.back() < 1000.0);
    QCOMPARE(wait(job).value_or(0), 12);  // reading was not disturbed
}

// Each time the motors run, and up to three commands get lost before one arrives.
void TestLinks::motorsOffIsRepeatedUntilConfirmed()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s});
    WireTap tap(portOf(simulator));
    auto client = makeClient();
    QVERIFY(connectTo(*client, tap.address()));
    QSignalSpy finished(client.get(), &DeviceClient::motorsOffFinished);
    for (int i = 0; i < 8; ++i) {
        const int lost = i % 4;
        auto on = client->submit<void>([](Channel &channel, Device &device) {
            return device.perform(channel, u"motors.on"_s, {}).map([](const ActionReply &) {});
        });
        QVERIFY(wait(on));
        tap.swallow(kMotorsOff, lost);
        const int before = tap.count(kMotorsOff);
        client->motorsOff();
        QTRY_COMPARE(finished.count(), i + 1);
        QVERIFY(finished.last().first().toBool());
        QVERIFY(tap.count(kMotorsOff) - before > lost);
    }
}

void TestLinks::deadManStopsWhenTheScreenIsBlocked()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s});
    WireTap tap(portOf(simulator));
    auto client = makeClient();
    QVERIFY(connectTo(*client, tap.address()));
    const SteeringSetpoint setpoint{1, {std::nan(""), std::nan(""), 30.0}, {}};  // yaw, speed mode
    const ChannelRoles roles = client->roles();
    client->subscribe({QList<int>(roles.gyro.begin(), roles.gyro.end()), 0});
    QTRY_VERIFY(newestSample(*client) > 0.0);
    const double begin = newestSample(*client);
    const auto steered = [&] {
        client->setControl(setpoint);
        return newestSample(*client) > begin + 0.5;
    };
    QTRY_VERIFY(steered());
    QVERIFY(tap.count(kControl) > 15);
    QSignalSpy rescued(client.get(), &DeviceClient::failsafeActed);
    // The GUI thread is blocked: nobody refreshes. The stop is repeated until it is proven, for two seconds
    // at most.
    const double blocked = newestSample(*client);
    QVERIFY(boardGoesOnWhileBlocked(*client, 0.8));
    for (int after = -1; after != tap.count(kControl);) {
        after = tap.count(kControl);
        QVERIFY(newestSample(*client) < blocked + 3.5);
        QVERIFY(boardGoesOnWhileBlocked(*client, 0.3));
    }
    QTRY_VERIFY(rescued.count() == 1);
    // The board stands: its yaw target does not move any more.
    const auto angles = [&] {
        return wait(client->submit<ActionReply>(
            [](Channel &channel, Device &device) { return device.perform(channel, u"angles"_s, {}); }));
    };
    const auto first = angles();
    QVERIFY(first);
    QVERIFY(first->value(u"target.yaw"_s).toDouble() > 5.0);
    QVERIFY(boardGoesOn(*client, 0.5));
    QVERIFY(std::abs(angles()->value(u"target.yaw"_s).toDouble() - first->value(u"target.yaw"_s).toDouble())
            < 0.1);
}

// How often the rule acted is counted for each link: a new one has nothing to tell.
void TestLinks::failsafeIsToldOncePerLink()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s});
    WireTap tap(portOf(simulator));
    auto client = makeClient();
    QVERIFY(connectTo(*client, tap.address()));
    QSignalSpy acted(client.get(), &DeviceClient::failsafeActed);
    const ChannelRoles roles = client->roles();
    client->subscribe({QList<int>(roles.gyro.begin(), roles.gyro.end()), 0});
    QTRY_VERIFY(newestSample(*client) > 0.0);
    QTimer steering;
    connect(&steering, &QTimer::timeout, client.get(), [&client] {
        client->setControl({1, {std::nan(""), std::nan(""), 10.0}, {}});
    });
    const auto steer = [&] {
        const int before = tap.count(kControl);
        steering.start(50);
        return QTest::qWaitFor([&] { return tap.count(kControl) > before + 10; }, kPatience);
    };
    QVERIFY(steer());
    steering.stop();  // nobody refreshes
    QTRY_COMPARE(acted.count(), 1);
    QVERIFY(boardGoesOn(*client, 0.5));
    QCOMPARE(acted.count(), 1);

    QSignalSpy lost(client.get(), &DeviceClient::connectionLost);
    tap.dropLink();
    QTRY_COMPARE(lost.count(), 1);
    QTRY_VERIFY(client->isConnected());
    QVERIFY(boardGoesOn(*client, 0.5));
    QCOMPARE(acted.count(), 1);
    QVERIFY(steer());
    steering.stop();
    client->releaseControl();  // let go on purpose
    QVERIFY(boardGoesOn(*client, 0.5));
    QCOMPARE(acted.count(), 1);
    QVERIFY(steer());
    steering.stop();
    QTRY_COMPARE(acted.count(), 2);  // the new link tells what happens on it
}

void TestLinks::motorsOffCancelsAMovingJob()
{
    auto client = makeClient();
    QVERIFY(connectTo(*client, u"sim:simplebgc?seed=21"_s));
    auto job = client->submit<ActionReply>(
        [](Channel &channel, Device &device) {
            QVariantMap arguments{{u"roll"_s, true}, {u"gain"_s, 128}, {u"save"_s, true}};
            return device.perform(channel, u"autotune"_s, arguments);
        },
        DeviceClient::JobKind::Moving);
    QSignalSpy progress(client.get(), &DeviceClient::progressChanged);
    QTRY_VERIFY(progress.count() >= 3);
    QVERIFY(!job.isFinished());
    client->motorsOff();
    const auto result = wait(job);
    QVERIFY(!result);
    QCOMPARE(result.error().code, ErrorCode::Cancelled);
    const ChannelRoles roles = client->roles();
    QTRY_VERIFY(client->telemetry()->latest(roles.outputs) == 0.0F);
}

void TestLinks::cancelledJobsEndAtOnce()
{
    auto client = makeClient();
    QVERIFY(connectTo(*client, u"sim:simplebgc?seed=22"_s));
    std::atomic<bool> begun = false;
    auto running = client->submit<bool>([&begun](Channel &channel, Device &) -> Result<bool> {
        begun = true;
        const auto slept = channel.sleep(60s);
        return slept ? Result<bool>(true) : tl::unexpected(slept.error());
    });
    auto waiting = client->submit<bool>([](Channel &, Device &) -> Result<bool> { return true; });
    QTRY_VERIFY(begun);
    QElapsedTimer timer;
    timer.start();
    client->cancelJobs();
    QCOMPARE(wait(running).error().code, ErrorCode::Cancelled);
    QCOMPARE(wait(waiting).error().code, ErrorCode::Cancelled);
    QVERIFY(timer.elapsed() < 2000);
    QVERIFY(read(*client));  // the link lives on
}

void TestLinks::telemetryGoesOnWhileTheScreenIsBlocked()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s});
    auto client = makeClient();
    QVERIFY(connectTo(*client, simulator.address()));
    const ChannelRoles roles = client->roles();
    client->subscribe({{roles.gyro[0]}, 0});
    QTRY_VERIFY(client->telemetryPlan().rate == 1250.0);
    const quint64 before = client->telemetry()->rows();
    QVERIFY(boardGoesOnWhileBlocked(*client, 1.5));
    const quint64 rows = client->telemetry()->rows() - before;
    QVERIFY2(rows > 1600, qPrintable(QString::number(rows)));
    QCOMPARE(client->telemetry()->lost(), quint64(0));
}

// A continuation that is attached on one thread while another finishes its future may run twice in Qt 6.4,
// and crash: so a future is never finished while whoever submitted is still at it.
void TestLinks::resultsComeFromTheEventLoop()
{
    const auto client = makeClient();
    QVERIFY(connectTo(*client, u"sim:simplebgc"_s));
    std::atomic<bool> hasRun = false;
    auto first = client->submit<bool>([](Channel &, Device &) -> Result<bool> { return true; });
    const auto second = client->submit<bool>([&hasRun](Channel &, Device &) -> Result<bool> {
        hasRun = true;
        return true;
    });
    while (!hasRun)
        std::this_thread::yield();
    QVERIFY(!first.isFinished());
    int runs = 0;
    first.then(client.get(), [&runs](const Result<bool> &) { ++runs; });
    QTRY_VERIFY(second.isFinished());
    QCOMPARE(runs, 1);
}

// The screen was busy when they ended.
void TestLinks::unfinishedJobsHaveResultsAfterTheEnd()
{
    const auto client = makeClient();
    QVERIFY(connectTo(*client, u"sim:simplebgc"_s));
    std::atomic<int> begun = 0;
    std::vector<QFuture<Result<int>>> jobs;
    for (int i = 0; i < 3; ++i) {
        jobs.push_back(client->submit<int>([&begun](Channel &, Device &) -> Result<int> { return ++begun; }));
    }
    while (begun < 3)
        std::this_thread::yield();
    client->shutDown();
    for (int i = 0; i < 3; ++i) {
        QVERIFY(jobs[std::size_t(i)].isFinished());
        QCOMPARE(jobs[std::size_t(i)].result().value_or(-1), i + 1);
    }
}

void TestLinks::submittingWithoutABoardFails()
{
    auto client = makeClient();
    QCOMPARE(read(*client).error().code, ErrorCode::NotConnected);
    QSignalSpy finished(client.get(), &DeviceClient::motorsOffFinished);
    client->motorsOff();
    QTRY_COMPARE(finished.count(), 1);
    QCOMPARE(finished.first().first().toBool(), false);
}

// Not a storm of attempts, and it goes on until somebody lets it in.
void TestLinks::peerThatClosesAtOnceIsTriedAtEase()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s});
    WireTap tap(portOf(simulator));
    const auto client = makeClient();
    QVERIFY(connectTo(*client, tap.address()));
    tap.slam(true);
    tap.dropLink();
    QTRY_VERIFY(tap.sentAway().size() >= 5);
    QCOMPARE(client->state(), DeviceClient::State::Reconnecting);
    const std::vector<TimePoint> tries = tap.sentAway();
    QVERIFY2(tries[4] - tries[0] > 1500ms, qPrintable(QString::number(seconds(tries[4] - tries[0]))));
    tap.slam(false);
    QTRY_VERIFY(client->isConnected());
    QVERIFY(read(*client));
}

void TestLinks::foreignProtocolIsNamed()
{
    // A STorM32 board answers each byte that it does not know with the letter e.
    QTcpServer server;
    QVERIFY(server.listen(QHostAddress::LocalHost, 0));
    connect(&server, &QTcpServer::newConnection, this, [&server] {
        QTcpSocket *socket = server.nextPendingConnection();
        connect(socket, &QTcpSocket::readyRead, socket,
                [socket] { socket->write(QByteArray(socket->readAll().size(), 'e')); });
    });
    auto client = makeClient();
    QSignalSpy failed(client.get(), &DeviceClient::connectionFailed);
    client->connectTo(*LinkAddress::parse(u"tcp://127.0.0.1:%1"_s.arg(server.serverPort())), u"simplebgc"_s);
    QTRY_COMPARE(failed.count(), 1);
    const auto error = failed.first().first().value<Error>();
    QCOMPARE(error.code, ErrorCode::WrongProtocol);
    QCOMPARE(error.detail, u"STorM32"_s);
}

void TestLinks::portInUseIsToldAsBusy()
{
    QTemporaryDir dir;
    const QString path = dir.filePath(u"gimbal"_s);
    SimProcess simulator({u"--pty"_s, path});
    auto first = makeClient();
    QVERIFY(connectTo(*first, path));
    auto second = makeClient();
    QSignalSpy failed(second.get(), &DeviceClient::connectionFailed);
    second->connectTo(*LinkAddress::parse(path), u"simplebgc"_s);
    QTRY_COMPARE(failed.count(), 1);
    QCOMPARE(int(failed.first().first().value<Error>().code), int(ErrorCode::PortBusy));
    QVERIFY(read(*first));  // the one who has it is not disturbed
}

void TestLinks::theWorldChangesOnStandardInput()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s});
    const auto client = makeClient();
    QVERIFY(connectTo(*client, simulator.address()));
    const ChannelRoles roles = client->roles();
    client->subscribe({QList<int>(roles.acc.begin(), roles.acc.end()), 0});
    const auto acc = [&](int axis) { return client->telemetry()->latest(roles.acc[std::size_t(axis)]); };
    QTRY_VERIFY(acc(2) > 0.9F);
    simulator.process().write("pose=4\nnonsense\n");  // X down; the second line is refused and does no harm
    QTRY_VERIFY(acc(0) < -0.9F);
    QByteArray said;
    const auto complains
        = [&] { return (said += simulator.process().readAllStandardError()).contains("nonsense"); };
    QTRY_VERIFY(complains());
    simulator.process().closeWriteChannel();
    QVERIFY(boardGoesOn(*client, 0.5));
    QCOMPARE(simulator.process().state(), QProcess::Running);  // the end of its input is not the end of it
}

QTEST_GUILESS_MAIN(TestLinks)
#include "tst_links.moc"
