// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/client/connector.h"
#include "protocol/client/deviceclient.h"
#include "protocol/procedure/safeaction.h"
#include "protocol/record/configurationformats.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"
#include "tests/support/toyfamily/toycomposition.h"
#include "tests/support/toyfamily/toydevice.h"
#include "tests/support/toyfamily/toytables.h"

#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QNetworkDatagram>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTimer>
#include <QUdpSocket>

#include <csignal>

using namespace Qt::StringLiterals;

namespace {

template <typename T> Result<T> wait(QFuture<Result<T>> future, int ms = kPatience)
{
    if (!QTest::qWaitFor([&future] { return future.isFinished(); }, ms))
        return failure(ErrorCode::Timeout, u"the test waited too long"_s);
    return future.result();
}

/// A toy on the loopback interface, and a client for it.
class ToyLink
{
public:
    explicit ToyLink(const QStringList &options = {})
        : simulator(QStringList{u"--udp"_s, u"0"_s} + options, u"toy"_s, u"toysim"_s)
        , client(toyLinks().transports, toyFamilies())
        , lost(&client, &DeviceClient::connectionLost)
        , failsafe(&client, &DeviceClient::failsafeActed)
        , stopped(&client, &DeviceClient::motorsOffFinished)
    {
        m_send.setInterval(50);
        QObject::connect(&m_send, &QTimer::timeout, &client, [this] { client.setControl(m_setpoint); });
    }

    bool connect()
    {
        client.connectTo(*LinkAddress::parse(simulator.address()));
        return QTest::qWaitFor([this] { return client.isConnected(); }, kPatience);
    }
    /// Steers from now on, armed.
    void steer()
    {
        m_setpoint = {1, {30, 10, 0.5}, {1}};
        m_send.start();
    }
    void letGo() { m_send.stop(); }
    void signal(int number) { ::kill(pid_t(simulator.process().processId()), number); }
    [[nodiscard]] float latest(int channel) const
    {
        return client.telemetry() ? client.telemetry()->latest(channel) : -1.0F;
    }
    [[nodiscard]] quint64 rows() const { return client.telemetry() ? client.telemetry()->rows() : 0; }

    SimProcess simulator;
    DeviceClient client;
    QSignalSpy lost;
    QSignalSpy failsafe;
    QSignalSpy stopped;

private:
    QTimer m_send;
    SteeringSetpoint m_setpoint;
};

struct Run
{
    int exitCode = -1;
    QString out;
    QString err;
    [[nodiscard]] QJsonDocument json() const { return QJsonDocument::fromJson(out.toUtf8()); }
};

}  // namespace

/// A family unlike ours over a real network, and on the command line.
class TestToyLink : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_dir = std::make_unique<QTemporaryDir>(); }
    void addressNamesTheFamilyWhereItMust();
    void heartbeatKeepsItTalking();
    void silenceIsLossAndItComesBack();
    void unpluggedNetworkComesBack();
    void deadManStopsAndIsToldOnce();
    void motorsOff_data();
    void motorsOff();
    void deafnessIsNoLoss();
    void commandsReadAndWrite();
    void commandsWithFiles();
    void commandsPerform();
    void commandsWatchAndStop();

private:
    Run ctl(const ToyLink &link, const QStringList &arguments)
    {
        QProcess process;
        process.start(QStringLiteral(GIMBAL_BIN_DIR "/toyctl"),
                      QStringList{u"--history"_s, path(u"history"_s), u"--link"_s, link.simulator.address()}
                          + arguments);
        if (!QTest::qWaitFor([&process] { return process.state() == QProcess::NotRunning; }, kPatience))
            process.kill();
        return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
                QString::fromUtf8(process.readAllStandardError())};
    }
    [[nodiscard]] QString path(const QString &name) const { return m_dir->filePath(name); }

    std::unique_ptr<QTemporaryDir> m_dir;
};

void TestToyLink::addressNamesTheFamilyWhereItMust()
{
    Family serial = toyFamily();
    serial.key = u"serial"_s;
    serial.links = {{LinkAddress::Kind::Serial}};
    Family other = toyFamily();
    other.key = u"other"_s;
    const auto keys = [](const QList<Family> &known, const QString &address) {
        const auto found = familiesFor(known, *LinkAddress::parse(address), {});
        if (!found)
            return found.error().detail;
        QStringList names;
        for (const Family &family : *found)
            names.append(family.key);
        return names.join(u',');
    };
    const QString udp = u"udp://127.0.0.1:5000"_s;
    QCOMPARE(keys({serial, toyFamily()}, udp), u"toy"_s);
    QVERIFY(keys({toyFamily(), other}, udp).contains(u"?family= and one of toy, other"_s));
    QCOMPARE(keys({toyFamily(), other}, udp + u"?family=other"_s), u"other"_s);
    QCOMPARE(keys({toyFamily(), serial}, u"serial:/dev/ttyUSB0"_s), u"serial"_s);
    QVERIFY(!familiesFor({toyFamily()}, *LinkAddress::parse(u"tcp://127.0.0.1:5000"_s), {}));
}

void TestToyLink::heartbeatKeepsItTalking()
{
    ToyLink link;
    QVERIFY(link.connect());
    QCOMPARE(link.client.identity().model, u"Toy with five motors"_s);
    // Twice as long as it would talk without heartbeats.
    QElapsedTimer timer;
    timer.start();
    QTRY_VERIFY(timer.elapsed() > 2000);
    const quint64 before = link.rows();
    QTRY_VERIFY(link.rows() > before + 5);
    QCOMPARE(link.lost.count(), 0);
    QVERIFY(link.client.telemetry()->latestArray(toy::Spectrum).values->size() == toy::kSpectrumBins);
}

void TestToyLink::silenceIsLossAndItComesBack()
{
    ToyLink link;
    QVERIFY(link.connect());
    QTRY_VERIFY(link.rows() > 5);
    QElapsedTimer timer;
    timer.start();
    link.signal(SIGSTOP);
    QTRY_COMPARE(link.lost.count(), 1);
    const qint64 after = timer.elapsed();
    link.signal(SIGCONT);
    QVERIFY2(after > 500 && after < 3000, qPrintable(QString::number(after)));
    QCOMPARE(link.lost.first().first().value<Error>().code, ErrorCode::LinkClosed);
    QTRY_VERIFY(link.client.isConnected());
    const quint64 before = link.rows();
    QTRY_VERIFY(link.rows() > before + 5);
}

void TestToyLink::unpluggedNetworkComesBack()
{
    ToyLink link;
    QVERIFY(link.connect());
    link.simulator.process().write("unplug=0\n");
    QTRY_COMPARE(link.lost.count(), 1);
    QTRY_VERIFY(link.client.isConnected());
}

// The counter of the rule belongs to one link: a new one has nothing to tell.
void TestToyLink::deadManStopsAndIsToldOnce()
{
    ToyLink link;
    QVERIFY(link.connect());
    link.steer();
    QTRY_COMPARE(link.latest(toy::Outputs), 1.0F);
    QTRY_COMPARE(link.latest(toy::Motor1), 55.0F);
    link.letGo();
    QTRY_COMPARE(link.failsafe.count(), 1);
    QTRY_COMPARE(link.latest(toy::Outputs), 0.0F);
    link.simulator.process().write("unplug=0\n");
    QTRY_COMPARE(link.lost.count(), 1);
    QTRY_VERIFY(link.client.isConnected());
    link.steer();
    QTRY_COMPARE(link.latest(toy::Outputs), 1.0F);
    link.letGo();
    link.client.releaseControl();
    QTRY_COMPARE(link.latest(toy::Outputs), 0.0F);
    QCOMPARE(link.failsafe.count(), 1);
}

void TestToyLink::motorsOff_data()
{
    QTest::addColumn<QString>("deaf");
    QTest::addColumn<bool>("proven");
    QTest::newRow("obeys") << u"0"_s << true;
    QTest::newRow("deaf to the first means") << u"1"_s << true;
    QTest::newRow("deaf to both") << u"2"_s << false;
}

void TestToyLink::motorsOff()
{
    QFETCH(const QString, deaf);
    QFETCH(const bool, proven);
    ToyLink link({u"--deaf-stop"_s, deaf});
    QVERIFY(link.connect());
    link.steer();
    QTRY_COMPARE(link.latest(toy::Outputs), 1.0F);
    link.letGo();
    link.client.motorsOff();
    QTRY_COMPARE(link.stopped.count(), 1);
    QCOMPARE(link.stopped.first().first().toBool(), proven);
    QTRY_COMPARE(link.latest(toy::Outputs), proven ? 0.0F : 1.0F);
}

void TestToyLink::deafnessIsNoLoss()
{
    ToyLink link;
    QVERIFY(link.connect());
    QTRY_COMPARE(link.latest(toy::Armed), 0.0F);
    const BoardHistory history(path(u"history"_s));
    const auto done = wait(link.client.submit<ActionOutcome>(
        [history, latest = link.client.telemetry()](Channel &channel, Device &device) {
            return performSafely(channel, device, u"calibrate.level"_s, {}, history, {}, latest.get());
        }));
    QVERIFY(done);
    QTRY_COMPARE(link.latest(toy::Calibrated), 1.0F);
    QCOMPARE(link.lost.count(), 0);
}

void TestToyLink::commandsReadAndWrite()
{
    const ToyLink link;
    Run run = ctl(link, {u"--json"_s, u"info"_s});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    QCOMPARE(run.json().object().value(u"family"_s).toString(), u"toy"_s);
    run = ctl(link, {u"--json"_s, u"list"_s});
    QCOMPARE(run.json().array().size(), 7);
    QCOMPARE(ctl(link, {u"get"_s, u"rate.gain"_s}).out, u"2e-06\n"_s);
    QCOMPARE(ctl(link, {u"get"_s, u"hover.trim"_s}).out, u"no number\n"_s);
    QCOMPARE(ctl(link, {u"get"_s, u"flight.limit"_s}).out.section(u' ', 0, 0).trimmed(), u"4000000000"_s);
    run = ctl(link, {u"set"_s, u"rate.gain=3.5e-6"_s, u"home.height=-2147483648"_s});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    QCOMPARE(run.out.count(u"verified"_s), 2);
    QCOMPARE(ctl(link, {u"get"_s, u"rate.gain"_s}).out, u"3.5e-06\n"_s);
    QCOMPARE(ctl(link, {u"get"_s, u"hover.trim"_s}).out, u"no number\n"_s);
    QCOMPARE(ctl(link, {u"set"_s, u"hover.trim=nan"_s}).exitCode, 2);
    run = ctl(link, {u"profiles"_s});
    QVERIFY2(run.exitCode == 0 || run.exitCode == 1, qPrintable(run.err));  // it ends, one way or the other
}

void TestToyLink::commandsWithFiles()
{
    ToyLink link;
    QVERIFY2(ctl(link, {u"dump"_s, path(u"before.json"_s)}).exitCode == 0, "dump");
    QVERIFY(link.connect());
    auto read = wait(link.client.submit<Configuration>(
        [](Channel &channel, Device &device) { return device.readConfiguration(channel); }));
    QVERIFY(read);
    read->setBlock({0, toy::Mission}, "climb(3)\nland()\n");
    QVERIFY(read->setRaw(*read->parameters().find(u"rate.gain"_s), 0, double(7e-6F)));
    QVERIFY(saveConfiguration(path(u"wanted.json"_s), *read, u"by the test"_s, toyFamilies()));
    link.client.disconnectFromBoard();

    Run run = ctl(link, {u"diff"_s, path(u"before.json"_s), path(u"wanted.json"_s)});
    QVERIFY2(run.out.contains(u"rate.gain"_s) && run.out.contains(u"Mission"_s),
             qPrintable(run.out + run.err));
    run = ctl(link, {u"apply"_s, path(u"wanted.json"_s), u"--confirmed"_s});
    QVERIFY2(run.exitCode == 0, qPrintable(run.out + run.err));
    QCOMPARE(run.out.count(u"verified"_s), 2);
    QCOMPARE(ctl(link, {u"get"_s, u"rate.gain"_s}).out, u"7e-06\n"_s);
    QCOMPARE(ctl(link, {u"get"_s, u"hover.trim"_s}).out, u"no number\n"_s);
    QCOMPARE(ctl(link, {u"dump"_s, path(u"after.json"_s)}).exitCode, 0);
    const auto after = loadConfiguration(path(u"after.json"_s), toyFamilies());
    QVERIFY(after);
    QCOMPARE(after->configuration.block({0, toy::Mission}), QByteArray("climb(3)\nland()\n"));
}

void TestToyLink::commandsPerform()
{
    const ToyLink link;
    const Run help = ctl(link, {u"do"_s, u"help"_s});
    QVERIFY(help.out.contains(u"calibrate.level"_s) && help.out.contains(u"The propellers are off"_s));
    Run run = ctl(link, {u"do"_s, u"blink"_s, u"times=2"_s});
    QVERIFY2(run.exitCode == 0 && run.out.contains(u"times"_s), qPrintable(run.err));
    run = ctl(link, {u"do"_s, u"home"_s});
    QVERIFY2(run.exitCode == 1 && run.err.contains(u"not calibrated"_s), qPrintable(run.err));
    run = ctl(link, {u"do"_s, u"calibrate.level"_s});
    QVERIFY2(run.exitCode == 2 && run.err.contains(u"The propellers are off"_s), qPrintable(run.err));
    QCOMPARE(ctl(link, {u"calibrate"_s, u"level"_s}).exitCode, 2);
    run = ctl(link, {u"do"_s, u"calibrate.level"_s, u"--confirmed"_s});
    QVERIFY2(run.exitCode == 0 && run.err.contains(u"snapshot"_s), qPrintable(run.err));
    QTRY_COMPARE(ctl(link, {u"do"_s, u"home"_s}).exitCode, 0);
}

void TestToyLink::commandsWatchAndStop()
{
    ToyLink link;
    Run run = ctl(link, {u"monitor"_s, u"--seconds"_s, u"0.3"_s});
    QVERIFY2(run.exitCode == 0 && run.out.startsWith(u"time_s,angle.pitch,angle.yaw,rate.pitch,rate.yaw\n"_s),
             qPrintable(run.out + run.err));
    run = ctl(link, {u"monitor"_s, u"--seconds"_s, u"0.3"_s, u"--channels"_s, u"motor.5,outputs"_s});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    run = ctl(link, {u"monitor"_s, u"--seconds"_s, u"0.3"_s, u"--channels"_s, u"spectrum"_s});
    QVERIFY2(run.exitCode == 2 && run.err.contains(u"array"_s), qPrintable(run.err));
    QVERIFY(ctl(link, {u"streams"_s}).out.contains(u"polled"_s));
    // A family without targets publishes what it has.
    QUdpSocket listener;
    QVERIFY(listener.bind(QHostAddress::LocalHost, 0));
    run = ctl(link, {u"publish"_s, u"127.0.0.1:%1"_s.arg(listener.localPort()), u"--seconds"_s, u"0.3"_s});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    QTRY_VERIFY(listener.hasPendingDatagrams());
    const QJsonObject told = QJsonDocument::fromJson(listener.receiveDatagram().data()).object();
    QCOMPARE(told.keys(), (QStringList{u"angle"_s, u"rate"_s, u"timestamp"_s}));

    QVERIFY(link.connect());
    link.steer();
    QTRY_COMPARE(link.latest(toy::Outputs), 1.0F);
    link.letGo();
    link.client.disconnectFromBoard();
    run = ctl(link, {u"motors"_s, u"off"_s});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    QVERIFY(link.connect());
    QTRY_COMPARE(link.latest(toy::Outputs), 0.0F);
    link.client.disconnectFromBoard();
    run = ctl(link, {u"motors"_s, u"on"_s});
    QCOMPARE(run.exitCode, 1);

    const ToyLink deaf({u"--deaf-stop"_s, u"2"_s});
    QCOMPARE(ctl(deaf, {u"motors"_s, u"off"_s}).exitCode, 0);  // they stood already, and that is proof
}

QTEST_GUILESS_MAIN(TestToyLink)
#include "tst_toylink.moc"
