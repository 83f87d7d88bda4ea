// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/base/filefault.h"
#include "protocol/bcflight/payloads.h"
#include "protocol/bcflight/tables.h"
#include "protocol/client/deviceclient.h"
#include "protocol/device/steering.h"
#include "protocol/session/linkstatistics.h"
#include "protocol/simulator/link/udphost.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/ctlrun.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"
#include "tests/support/watcheddrone.h"

#include <QJsonObject>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <QTimer>

#include <csignal>

using namespace Qt::StringLiterals;
using bcflight::Message;
using Drone = bcflight::SimulatedBoard;

namespace {

/// A watched drone behind a socket on a thread of its own, and a client for it, as the window has one.
struct Bench
{
    explicit Bench(const Faults &faults = {})
        : client(allLinks().transports, allFamilies())
    {
        SimulatorOptions options;
        options.faults = faults;
        options.faults.shake = 0;
        auto board = std::make_unique<WatchedDrone>(options);
        watched = board.get();
        host = new UdpHost(std::make_unique<SimulatedPort>(std::move(board), options, std::nullopt), 0);
        host->moveToThread(&thread);
        QObject::connect(&thread, &QThread::finished, host, &QObject::deleteLater);
        thread.start();
    }
    ~Bench()
    {
        client.shutDown();
        thread.quit();
        thread.wait();
    }
    Q_DISABLE_COPY_MOVE(Bench)

    bool connect()
    {
        QString address;
        QMetaObject::invokeMethod(
            host,
            [&] {
                if (host->start())
                    address = host->address();
            },
            Qt::BlockingQueuedConnection);
        client.connectTo(*LinkAddress::parse(address));
        return QTest::qWaitFor([this] { return client.isConnected(); }, kPatience);
    }
    QFuture<Result<ActionReply>> perform(const QString &key, const QVariantMap &arguments = {})
    {
        return client.submit<ActionReply>(
            [key, arguments](Channel &channel, Device &device) {
                return device.perform(channel, key, arguments);
            },
            DeviceClient::JobKind::Moving);
    }
    Result<ActionReply> done(QFuture<Result<ActionReply>> future)
    {
        return QTest::qWaitFor([&] { return future.isFinished(); }, 2 * kPatience)
            ? future.result()
            : failure(ErrorCode::Timeout, u"the test waited too long"_s);
    }
    /// On the drone's thread, while this one waits.
    template <typename Ask> auto with(Ask ask)
    {
        std::invoke_result_t<Ask, WatchedDrone &> answer{};
        QMetaObject::invokeMethod(
            host, [&] { answer = ask(*watched); }, Qt::BlockingQueuedConnection);
        return answer;
    }
    /// Calibrated, then armed and steered until this goes.
    std::unique_ptr<QTimer> fly()
    {
        if (!connect() || !done(perform(u"calibrate.all"_s)))
            return {};
        auto hand = std::make_unique<QTimer>();
        SteeringSetpoint wanted{1, {0.3, 0, 0, 0}, {1}};
        wanted.begun = Clock::now();
        QObject::connect(hand.get(), &QTimer::timeout,
                         [this, wanted] { client.setControl(wanted, DeviceClient::Steers::FlyingMachine); });
        hand->start(20ms);
        const auto turns = [](WatchedDrone &drone) { return drone.drone().outputs()[0] > 0; };
        return QTest::qWaitFor([&] { return with(turns); }, kPatience) ? std::move(hand) : nullptr;
    }

    QThread thread;
    UdpHost *host = nullptr;
    WatchedDrone *watched = nullptr;
    DeviceClient client;
};

}  // namespace

/// The bench over real datagrams.
class TestBcflightBenchLink final : public QObject
{
    Q_OBJECT
private slots:
    void stopIsHeardFirst_data();
    void stopIsHeardFirst();
    void firmwareComesThroughLosses();
    void commandsOfTheBench();
    void firmwareNeedsABatteryThatLasts();
    void interruptedTestSaysThatItIsDeaf();
    void silenceInTheAirIsNoDisarming();
    void whoeverQuitsStopsItFirst();
    void endThatIsNotProvenStopsTheMotors();

private:
    QTemporaryDir m_dir;
};

void TestBcflightBenchLink::stopIsHeardFirst_data()
{
    QTest::addColumn<double>("lose");
    QTest::newRow("all arrive") << 0.0;
    QTest::newRow("5 % are lost") << 0.05;
}

// The red button during a motor test: of all that the drone finds when it hears again, RESET_MOTORS is the
// first, and it is the only thing that was sent to it meanwhile.
void TestBcflightBenchLink::stopIsHeardFirst()
{
    QFETCH(double, lose);
    Bench bench;
    QVERIFY(bench.connect());
    QVERIFY(bench.done(bench.perform(u"calibrate.all"_s)));
    QSignalSpy queued(&bench.client, &DeviceClient::motorsOffQueued);
    QSignalSpy late(&bench.client, &DeviceClient::motorsOffLate);
    QSignalSpy stopped(&bench.client, &DeviceClient::motorsOffFinished);
    const auto test = bench.perform(u"motor.test"_s, {{u"motor"_s, 2}});
    QTRY_VERIFY(bench.client.deafUntil() > Clock::now());
    QTRY_VERIFY(bench.with([](WatchedDrone &watched) { return watched.drone().outputs()[1] > 0; }));
    QVERIFY(bench.with(
        [&](WatchedDrone &) { return bench.host->port().change(u"lose=%1"_s.arg(lose)).has_value(); }));
    bench.client.motorsOff();
    QTRY_COMPARE(queued.count(), 1);
    const int left = queued.first().first().toInt();
    QVERIFY2(left > 1000 && left <= 8000, qPrintable(QString::number(left)));
    QVERIFY(!bench.client.isStopUnproven());
    QTRY_VERIFY(test.isFinished());
    QTRY_VERIFY(stopped.count() > 0);
    QVERIFY(stopped.first().first().toBool());
    QCOMPARE(late.count(), 0);
    const auto handled = bench.with([](WatchedDrone &watched) { return watched.drone().handled(); });
    const auto asked = std::find_if(handled.begin(), handled.end(),
                                    [](const Drone::Handled &each) { return each.id == Message::MotorTest; });
    QVERIFY(asked != handled.end() && asked + 1 != handled.end());
    const Drone::Handled next = *(asked + 1);
    QVERIFY2(next.id == Message::ResetMotors, bcflight::findMessage(next.id)->name);
    QVERIFY2(next.at - asked->at >= Drone::kMotorTestTime
                 && next.at - asked->at < Drone::kMotorTestTime + 0.2,
             qPrintable(QString::number(next.at - asked->at)));
    qInfo("RESET_MOTORS was carried out %.0f ms after the drone heard again",
          1000 * (next.at - asked->at - Drone::kMotorTestTime));
}

void TestBcflightBenchLink::firmwareComesThroughLosses()
{
    Faults faults;
    faults.loseByte = 0.05;
    Bench bench(faults);
    QVERIFY(bench.connect());
    QByteArray image("version 4.2\n");
    image.resize(100 * 1024 + 17, '\x01');
    const QString path = m_dir.filePath(u"flight"_s);
    QVERIFY(writeWhole(path, image));
    const TimePoint begin = Clock::now();
    const auto done = bench.done(bench.perform(u"firmware.upload"_s, {{u"file"_s, path}}));
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->value(u"before"_s).toString(), u"1.0"_s);
    QCOMPARE(done->value(u"firmware"_s).toString(), u"4.2"_s);
    QVERIFY(done->value(u"confirmed"_s).toBool());
    QCOMPARE(bench.with([](WatchedDrone &watched) { return watched.drone().firmware(); }), image);
    QVERIFY(bench.client.isConnected());  // the restart was no loss of the link
    qInfo("100 kB with 5 %% lost took %.1f s with the restart", seconds(Clock::now() - begin));
}

// A drone that dies in the middle is a brick.
void TestBcflightBenchLink::firmwareNeedsABatteryThatLasts()
{
    const QString file = m_dir.filePath(u"next"_s);
    QVERIFY(writeWhole(file, QByteArray("version 6.0\n").leftJustified(5000, '\x01')));
    // The voltage alone takes the second one for three full cells; the drone has counted four.
    for (const QString &volts : {u"13.2"_s, u"12.6"_s}) {
        const SimProcess drone({u"--udp"_s, u"0"_s, u"--fault"_s, u"battery="_s + volts}, u"bcflight"_s);
        const QStringList link{u"--link"_s, drone.address()};
        const Run run
            = Running(m_dir.path(), link + QStringList{u"upload"_s, file, u"--confirmed"_s}).finish();
        QCOMPARE(run.exitCode, 1);
        QVERIFY2(run.err.contains(u"battery is low"_s), qPrintable(run.err));
        const Run info = Running(m_dir.path(), link + QStringList{u"--json"_s, u"info"_s}).finish();
        QCOMPARE(info.json().value(u"firmware"_s).toString(), u"1.0"_s);
    }
}

// gimbalctl calibrate, motor-test, upload: what they need, and their exit codes.
void TestBcflightBenchLink::commandsOfTheBench()
{
    const SimProcess drone({u"--udp"_s, u"0"_s}, u"bcflight"_s);
    const QStringList link{u"--link"_s, drone.address()};
    const auto ctl
        = [&](const QStringList &command) { return Running(m_dir.path(), link + command).finish(); };
    const QString file = m_dir.filePath(u"new"_s);
    QVERIFY(writeWhole(file, QByteArray("version 5.0\n").leftJustified(5000, '\x01')));
    // What it would do is confirmed, its state is looked at, and words that make no sense are refused.
    QCOMPARE(ctl({u"motor-test"_s, u"1"_s}).exitCode, 2);
    const Run early = ctl({u"motor-test"_s, u"1"_s, u"--confirmed"_s});
    QVERIFY2(early.exitCode == 1 && early.err.contains(u"not calibrated"_s), qPrintable(early.err));
    QCOMPARE(ctl({u"motor-test"_s, u"first"_s}).exitCode, 2);
    QCOMPARE(ctl({u"calibrate"_s, u"gyro"_s, u"--full"_s}).exitCode, 2);
    QCOMPARE(ctl({u"upload"_s, file}).exitCode, 2);
    QCOMPARE(ctl({u"upload"_s, m_dir.filePath(u"none"_s), u"--confirmed"_s}).exitCode, 1);

    const Run calibrated = ctl({u"calibrate"_s, u"--full"_s});
    QVERIFY2(calibrated.exitCode == 0, qPrintable(calibrated.err));
    QCOMPARE(ctl({u"calibrate"_s}).exitCode, 0);
    const Run fifth = ctl({u"motor-test"_s, u"5"_s, u"--confirmed"_s});
    QVERIFY2(fifth.exitCode != 0 && fifth.err.contains(u"4 motors"_s), qPrintable(fifth.err));
    const Run turned = ctl({u"motor-test"_s, u"2"_s, u"--confirmed"_s});
    QVERIFY2(turned.exitCode == 0, qPrintable(turned.err));
    const Run uploaded = ctl({u"--json"_s, u"upload"_s, file, u"--confirmed"_s});
    QVERIFY2(uploaded.exitCode == 0, qPrintable(uploaded.err));
    QVERIFY(uploaded.json().value(u"done"_s).toBool());
    QVERIFY2(uploaded.err.contains(u"Nothing in the file shows"_s), qPrintable(uploaded.err));
    QCOMPARE(uploaded.json().value(u"reply"_s).toObject().value(u"firmware"_s).toString(), u"5.0"_s);
    QCOMPARE(ctl({u"--json"_s, u"info"_s}).json().value(u"firmware"_s).toString(), u"5.0"_s);
    // The same version again proves nothing: it is told as sent.
    const Run again = ctl({u"--json"_s, u"upload"_s, file, u"--confirmed"_s});
    QVERIFY2(again.exitCode == 0, qPrintable(again.err));
    QCOMPARE(again.json().value(u"state"_s).toString(), u"sent"_s);
    QVERIFY(again.out.contains(u"same version"_s));
}

// Ctrl-C during a motor test: nothing reaches the drone, and that is said.
void TestBcflightBenchLink::interruptedTestSaysThatItIsDeaf()
{
    const SimProcess drone({u"--udp"_s, u"0"_s}, u"bcflight"_s);
    const QStringList link{u"--link"_s, drone.address()};
    QCOMPARE(Running(m_dir.path(), link + QStringList{u"calibrate"_s, u"--full"_s}).finish().exitCode, 0);
    Running test(m_dir.path(), link + QStringList{u"motor-test"_s, u"1"_s, u"--confirmed"_s});
    QTRY_VERIFY(test.told().contains(u"The motor is tested"_s));
    ::kill(pid_t(test.id()), SIGINT);
    const Run run = test.finish();
    QCOMPARE(run.exitCode, 1);
    QVERIFY2(run.err.contains(u"the first thing that it hears"_s), qPrintable(run.err));
}

// Errata 9.1: it flies on as it was told last. Found again it is disarmed, and that is seen.
void TestBcflightBenchLink::silenceInTheAirIsNoDisarming()
{
    Bench bench;
    QVERIFY(bench.connect());
    QVERIFY(bench.done(bench.perform(u"calibrate.all"_s)));
    const auto change = [&](const QString &fault) {
        return bench.with([&](WatchedDrone &) { return bench.host->port().change(fault).has_value(); });
    };
    const auto flies = [&] {
        return bench.with([](WatchedDrone &watched) {
            return watched.drone().isArmed()
                && bcflight::areDriven({watched.drone().outputs().begin(), watched.drone().outputs().end()});
        });
    };
    QVERIFY(change(u"silent-armed=86400"_s));
    QSignalSpy ended(&bench.client, &DeviceClient::steeringEnded);
    bool wasDegraded = false;
    QObject::connect(&bench.client, &DeviceClient::statisticsChanged, &bench.client, [&] {
        wasDegraded |= bench.client.isConnected() && bench.client.statistics().isDegraded();
    });
    QTimer hand;
    QObject::connect(&hand, &QTimer::timeout, &bench.client, [&] {
        bench.client.setControl({1, {0.3, 0, 0, 0}, {1}}, DeviceClient::Steers::FlyingMachine);
    });
    hand.start(20ms);
    QTRY_VERIFY_WITH_TIMEOUT(flies(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!bench.client.isConnected(), kPatience);
    hand.stop();
    QVERIFY(wasDegraded);
    QTRY_COMPARE(ended.count(), 1);
    QVERIFY(!ended.first().first().toBool());
    QVERIFY(flies());

    const TimePoint found = Clock::now();
    QVERIFY(change(u"silent-armed=0"_s));
    QTRY_VERIFY_WITH_TIMEOUT(bench.client.isConnected(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(ended.count() > 1 && ended.last().first().toBool(), kPatience);
    QVERIFY(!flies());
    const auto tells = [&](int channel) {
        const auto store = bench.client.telemetry();
        return store && store->latestAt(channel) > found && store->latest(channel) == 0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(tells(bcflight::Armed) && tells(bcflight::Outputs), kPatience);
    QVERIFY(!bench.client.areOutputsUnknown());
}

// Errata 9.2, 2: the program goes only when it has told the drone so for half a second.
void TestBcflightBenchLink::whoeverQuitsStopsItFirst()
{
    Bench bench;
    const auto hand = bench.fly();
    QVERIFY(hand);
    bench.client.shutDown();
    QVERIFY(!bench.with([](WatchedDrone &watched) { return watched.drone().isArmed(); }));
    QCOMPARE(bench.with([](WatchedDrone &watched) { return watched.drone().outputs()[0]; }), 0.0);
    // Each stop is both, in one packet.
    const auto handled = bench.with([](WatchedDrone &watched) { return watched.drone().handled(); });
    QList<double> stops;
    for (std::size_t i = 1; i < handled.size(); ++i) {
        if (handled[i].id == Message::ResetMotors && handled[i - 1].id == Message::Controls)
            stops.append(handled[i].at);
    }
    QVERIFY2(stops.size() >= 15, qPrintable(QString::number(stops.size())));
    QVERIFY2(stops.last() - stops.first() > 0.45, qPrintable(QString::number(stops.last() - stops.first())));
}

// Its releases are over after a moment: a drone that has not obeyed by then goes on being told.
void TestBcflightBenchLink::endThatIsNotProvenStopsTheMotors()
{
    Bench bench;
    auto hand = bench.fly();
    QVERIFY(hand);
    const auto disobey = [&](bool on) {
        return bench.with([&](WatchedDrone &) {
            return bench.host->port().change(on ? u"runs-on=1"_s : u"runs-on=0"_s).has_value();
        });
    };
    QVERIFY(disobey(true));
    QSignalSpy ended(&bench.client, &DeviceClient::steeringEnded);
    QSignalSpy stopped(&bench.client, &DeviceClient::motorsOffFinished);
    hand.reset();
    bench.client.releaseControl();
    QTRY_COMPARE(ended.count(), 1);
    QVERIFY(!ended.first().first().toBool());
    QTRY_COMPARE(stopped.count(), 1);
    QVERIFY(!stopped.first().first().toBool());
    QVERIFY(bench.client.isStopUnproven());
    QVERIFY(disobey(false));
    QTRY_COMPARE(stopped.count(), 2);
    QVERIFY(stopped.last().first().toBool());
    QVERIFY(!bench.with([](WatchedDrone &watched) { return watched.drone().isArmed(); }));
}

QTEST_GUILESS_MAIN(TestBcflightBenchLink)
#include "tst_bcflightbenchlink.moc"
