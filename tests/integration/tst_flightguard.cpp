// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/messages.h"
#include "protocol/bcflight/payloads.h"
#include "protocol/transport/flightguard.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"

#include <QFile>
#include <QNetworkDatagram>
#include <QProcess>
#include <QSignalSpy>
#include <QTest>
#include <QUdpSocket>

#include <csignal>

using namespace Qt::StringLiterals;
using namespace bcflight;

/// The process that stops a drone when the program that steered it has died, against the simulated one over
/// UDP.
class TestFlightGuard final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void deathIsNoticed_data();
    void deathIsNoticed();
    void leaveTakenStopsNothing();
    void signalsDoNotEndIt();
    void stopIsRepeated();
    void programThatDiesLeavesIt();
    void itsEndIsTold();
    void wrongArgumentsAreRefused();

private:
    [[nodiscard]] static QByteArray stopBytes()
    {
        return encode(Message::Controls, Controls().encode(Generation::G), Generation::G)
            + encode(Message::ResetMotors);
    }
    void send(const QByteArray &packet) { m_socket.writeDatagram(packet, QHostAddress::LocalHost, m_port); }
    /// What the drone says when it is asked now.
    std::optional<Status> ask();
    void startGuard();

    std::unique_ptr<SimProcess> m_drone;
    QUdpSocket m_socket;
    quint16 m_port = 0;
    std::unique_ptr<QProcess> m_guard;
};

std::optional<Status> TestFlightGuard::ask()
{
    while (m_socket.hasPendingDatagrams())
        m_socket.receiveDatagram();
    send(encode(Message::Status, {}, Generation::G));
    std::optional<Status> told;
    std::ignore = QTest::qWaitFor(
        [&] {
            while (m_socket.hasPendingDatagrams()) {
                const QByteArray packet = m_socket.receiveDatagram().data();
                if (packet.size() == 5 && quint8(packet[0]) == 0x85)
                    told = Status::decode(asBytes(packet).subspan(1));
            }
            return told.has_value();
        },
        1000);
    return told;
}

void TestFlightGuard::init()
{
    m_socket.bind(QHostAddress::LocalHost);
    m_drone = std::make_unique<SimProcess>(QStringList{u"--udp"_s, u"0"_s}, u"bcflight"_s);
    m_port = m_drone->address().section(u':', -1).toUShort();
    QVERIFY(m_port > 0);
    send(encode(Message::Ping, bigU16(1) + bigU16(0)));
    QTRY_VERIFY_WITH_TIMEOUT(ask(), kPatience);
    send(encode(Message::Calibrate, bigU32(1) + bigF32(0)));
    QVERIFY(QTest::qWaitFor([this] { return ask().value_or(Status()).calibrated; }, kPatience));
    Controls fly;
    fly.arm = true;
    fly.thrust = 0.3;
    QVERIFY(QTest::qWaitFor(
        [&] {
            send(encode(Message::Controls, fly.encode(Generation::G), Generation::G));
            return ask().value_or(Status()).armed;
        },
        kPatience));
}

void TestFlightGuard::cleanup()
{
    m_guard.reset();
    m_drone.reset();
    m_socket.close();
}

void TestFlightGuard::startGuard()
{
    m_guard = std::make_unique<QProcess>();
    m_guard->start(QStringLiteral(GIMBAL_BIN_DIR "/gimbalguard"),
                   {u"127.0.0.1"_s, QString::number(m_port), QString::fromLatin1(stopBytes().toHex())});
    QVERIFY(m_guard->waitForStarted());
}

void TestFlightGuard::deathIsNoticed_data()
{
    QTest::addColumn<bool>("isSilent");
    QTest::addColumn<bool>("isTold");
    QTest::newRow("gone") << false << true;
    QTest::newRow("hangs") << true << true;
    QTest::newRow("was never heard of") << true << false;
}

void TestFlightGuard::deathIsNoticed()
{
    QFETCH(bool, isSilent);
    QFETCH(bool, isTold);
    startGuard();
    // As long as it is told that all is well it does nothing.
    const auto isOver = [this] {
        m_guard->write(&FlightGuard::kAlive, 1);
        return m_guard->state() != QProcess::Running;
    };
    if (isTold) {
        QVERIFY(!QTest::qWaitFor(isOver, int(milliseconds(FlightGuard::kSilence).count() * 3 / 2)));
        QVERIFY(ask().value_or(Status()).armed);
    }
    if (!isSilent)
        m_guard->closeWriteChannel();
    QVERIFY(QTest::qWaitFor(
        [this] {
            const auto now = ask();
            return now && !now->armed;
        },
        kPatience));
    QTRY_COMPARE_WITH_TIMEOUT(m_guard->state(), QProcess::NotRunning, kPatience);
    QCOMPARE(m_guard->exitCode(), 3);
}

void TestFlightGuard::leaveTakenStopsNothing()
{
    startGuard();
    m_guard->write(&FlightGuard::kAlive, 1);
    m_guard->write(&FlightGuard::kLeave, 1);
    QTRY_COMPARE_WITH_TIMEOUT(m_guard->state(), QProcess::NotRunning, kPatience);
    QCOMPARE(m_guard->exitCode(), 0);
    QVERIFY(ask().value_or(Status()).armed);
}

// It outlives the terminal that it was started from.
void TestFlightGuard::signalsDoNotEndIt()
{
    startGuard();
    const auto ignores = [this](int number) {
        QFile status(u"/proc/%1/status"_s.arg(m_guard->processId()));
        if (!status.open(QFile::ReadOnly))
            return false;
        const QByteArray all = status.readAll();
        const QByteArray mask = all.mid(all.indexOf("SigIgn:") + 7).split('\n').front().trimmed();
        return (mask.toULongLong(nullptr, 16) >> (number - 1) & 1) != 0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(ignores(SIGTERM), kPatience);
    for (const int number : {SIGINT, SIGHUP, SIGTERM})
        ::kill(pid_t(m_guard->processId()), number);
    m_guard->closeWriteChannel();
    QTRY_COMPARE_WITH_TIMEOUT(m_guard->state(), QProcess::NotRunning, kPatience);
    QCOMPARE(m_guard->exitStatus(), QProcess::NormalExit);
    QCOMPARE(m_guard->exitCode(), 3);
    QVERIFY(!ask().value_or(Status{.armed = true}).armed);
}

// One datagram may be lost: they come for a second and a half.
void TestFlightGuard::stopIsRepeated()
{
    QUdpSocket listener;
    QVERIFY(listener.bind(QHostAddress::LocalHost));
    m_port = listener.localPort();
    startGuard();
    m_guard->closeWriteChannel();
    QTRY_COMPARE_WITH_TIMEOUT(m_guard->state(), QProcess::NotRunning, kPatience);
    int stops = 0;
    while (listener.hasPendingDatagrams())
        stops += listener.receiveDatagram().data() == stopBytes() ? 1 : 0;
    QVERIFY2(stops >= 20, qPrintable(QString::number(stops)));
}

// The side of the program: it goes without a word, and the stop comes.
void TestFlightGuard::programThatDiesLeavesIt()
{
    auto guardian = std::make_unique<FlightGuardian>();
    guardian->start(u"127.0.0.1"_s, m_port, stopBytes());
    QTRY_VERIFY_WITH_TIMEOUT(guardian->isWatching(), kPatience);
    guardian->tell();
    guardian.reset();
    QVERIFY(QTest::qWaitFor([this] { return !ask().value_or(Status{.armed = true}).armed; }, kPatience));
}

void TestFlightGuard::itsEndIsTold()
{
    FlightGuardian guardian;
    QSignalSpy lost(&guardian, &FlightGuardian::lost);
    guardian.start(u"127.0.0.1"_s, m_port, stopBytes());
    QTRY_VERIFY_WITH_TIMEOUT(guardian.isWatching(), kPatience);
    QCOMPARE(lost.count(), 0);
    guardian.findChild<QProcess *>()->kill();
    QTRY_VERIFY_WITH_TIMEOUT(lost.count() > 0, kPatience);
    QVERIFY(!guardian.isWatching());
}

void TestFlightGuard::wrongArgumentsAreRefused()
{
    for (const QStringList &wrong :
         {QStringList{}, {u"127.0.0.1"_s, u"0"_s, u"00"_s}, {u"127.0.0.1"_s, u"2020"_s, u"xy"_s}}) {
        QProcess guard;
        guard.start(QStringLiteral(GIMBAL_BIN_DIR "/gimbalguard"), wrong);
        QVERIFY(guard.waitForFinished(kPatience));
        QCOMPARE(guard.exitCode(), 2);
    }
}

QTEST_GUILESS_MAIN(TestFlightGuard)
#include "tst_flightguard.moc"
