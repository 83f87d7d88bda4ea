// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/client/deviceclient.h"
#include "protocol/device/abilities.h"
#include "protocol/procedure/safeaction.h"
#include "protocol/record/boardhistory.h"
#include "protocol/supervisor/alarmreport.h"
#include "protocol/telemetry/streams.h"
#include "protocol/telemetry/telemetrystore.h"
#include "protocol/transport/linkaddress.h"
#include "tests/support/boardtime.h"
#include "tests/support/patience.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace Qt::StringLiterals;

/// An acknowledgement proves nothing: boards of each family that confirm every stop and go on.
class TestStops : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void confirmedIsNotOff_data();
    void confirmedIsNotOff();
    void confirmedActionIsNotDone_data() { confirmedIsNotOff_data(); }
    void confirmedActionIsNotDone();
    void supervisorsStopIsNotDone_data() { confirmedIsNotOff_data(); }
    void supervisorsStopIsNotDone();

private:
    /// Connects, and waits until the motors run. @param address of a simulated board
    /// @param lockedOut its heartbeat is switched on: it answers no plain command
    void open(const QString &address, bool lockedOut);
    bool change(const QString &assignment) { return m_links.changeWorld(m_address, assignment).has_value(); }
    [[nodiscard]] bool isDriven() const
    {
        return m_client->telemetry()->latest(m_client->roles().outputs) > 0;
    }
    Result<ActionOutcome> stopByAction();

    Links m_links = allLinks();
    std::unique_ptr<DeviceClient> m_client;
    LinkAddress m_address;
    QTemporaryDir m_dir;
};

void TestStops::init()
{
    m_client = std::make_unique<DeviceClient>(m_links.transports, allFamilies());
}

void TestStops::cleanup()
{
    m_client->shutDown();
    m_client.reset();
}

// A board of its own for each row: simulated boards keep what happened to them.
void TestStops::open(const QString &address, bool lockedOut)
{
    constexpr int kHeartbeat = 112;  // word
    static int seed = 300;
    m_address = LinkAddress::parse(u"%1&seed=%2"_s.arg(address).arg(++seed)).value();
    m_client->connectTo(m_address);
    QTRY_VERIFY(m_client->isConnected());
    QTRY_VERIFY(isDriven());
    const StatusWords *words = m_client->device()->statusWords();
    QTRY_VERIFY(!words || words->isStabilising(int(m_client->telemetry()->latest(m_client->roles().state))));
    if (!lockedOut)
        return;
    auto locked = m_client->submit<void>([](Channel &channel, Device &device) {
        return device.live()->writeAdjustables(channel, {{kHeartbeat, 1}});
    });
    QTRY_VERIFY(locked.isFinished());
    QVERIFY(locked.result());
    QVERIFY(boardGoesOn(*m_client, 1.0));
}

void TestStops::confirmedIsNotOff_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<bool>("lockedOut");
    for (const char *firmware : {"2.40", "2.59", "2.66"})
        QTest::addRow("simplebgc %s", firmware)
            << u"sim:simplebgc?firmware=%1"_s.arg(QLatin1String(firmware)) << false;
    for (const char *firmware : {"0.79", "0.90", "0.96"})
        QTest::addRow("storm32 %s", firmware)
            << u"sim:storm32?firmware=%1"_s.arg(QLatin1String(firmware)) << false;
    for (const char *firmware : {"0.79", "0.96"})
        QTest::addRow("storm32 %s, by MAVLink", firmware)
            << u"sim:storm32?rate=115200&firmware=%1"_s.arg(QLatin1String(firmware)) << true;
}

// The red button.
void TestStops::confirmedIsNotOff()
{
    QFETCH(QString, address);
    QFETCH(bool, lockedOut);
    open(address, lockedOut);
    QVERIFY(change(u"runs-on=1"_s));
    QSignalSpy finished(m_client.get(), &DeviceClient::motorsOffFinished);
    m_client->motorsOff();
    QTRY_VERIFY(!finished.isEmpty());
    QVERIFY(!finished.last().first().toBool());
    QVERIFY(m_client->isStopUnproven());
    QVERIFY(isDriven());
    // It goes on by itself, and is told when it is so.
    QVERIFY(change(u"runs-on=0"_s));
    QTRY_VERIFY(finished.last().first().toBool());
    QTRY_VERIFY(!isDriven());
    QVERIFY(!m_client->isStopUnproven());
}

Result<ActionOutcome> TestStops::stopByAction()
{
    auto future = m_client->submit<ActionOutcome>([this](Channel &channel, Device &device) {
        return performSafely(channel, device, u"motors.off"_s, {}, BoardHistory(m_dir.path()));
    });
    if (!QTest::qWaitFor([&future] { return future.isFinished(); }, kPatience))
        return failure(ErrorCode::Timeout, u"the test waited too long"_s);
    return future.result();
}

void TestStops::confirmedActionIsNotDone()
{
    QFETCH(QString, address);
    QFETCH(bool, lockedOut);
    open(address, lockedOut);
    QVERIFY(change(u"runs-on=1"_s));
    const auto failed = stopByAction();
    QVERIFY(!failed);
    QCOMPARE(failed.error().code, ErrorCode::NotProven);
    QVERIFY(isDriven());
    QVERIFY(change(u"runs-on=0"_s));
    const auto done = stopByAction();
    QVERIFY2(done && done->answered, done ? "sent" : qPrintable(done.error().detail));
    QTRY_VERIFY(!isDriven());
}

// An alarm says what is so, and says so when that changes.
void TestStops::supervisorsStopIsNotDone()
{
    QFETCH(QString, address);
    QFETCH(bool, lockedOut);
    QList<AlarmReport> reports;
    connect(m_client.get(), &DeviceClient::alarmChanged, m_client.get(),
            [&reports](const AlarmReport &report) {
                if (report.action == AlarmAction::MotorsOff)
                    reports.append(report);
            });
    open(address, lockedOut);
    const ChannelRoles &roles = m_client->roles();
    if (m_client->device()->streamControl())
        m_client->subscribe({ChannelRoles::present({roles.angle, roles.target, roles.gyro})});
    QVERIFY(boardGoesOn(*m_client, 1.5));
    QVERIFY(change(u"runs-on=1"_s));
    QVERIFY(change(u"swapped-axes=1"_s));
    const auto isTold = [&reports](AlarmOutcome outcome) {
        return std::any_of(reports.begin(), reports.end(),
                           [outcome](const AlarmReport &report) { return report.outcome == outcome; });
    };
    QTRY_VERIFY(isTold(AlarmOutcome::NotProven));
    QVERIFY(!isTold(AlarmOutcome::Done));
    QVERIFY(isDriven());
    QVERIFY(change(u"runs-on=0"_s));
    QTRY_VERIFY(isTold(AlarmOutcome::Done));
    QTRY_VERIFY(!isDriven());
}

QTEST_GUILESS_MAIN(TestStops)
#include "tst_stops.moc"
