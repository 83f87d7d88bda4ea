// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/ctlrun.h"
#include "tests/support/simprocess.h"

#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

using namespace Qt::StringLiterals;

/// gimbalctl with a simulated drone over UDP.
class TestBcflightCtl final : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_dir = std::make_unique<QTemporaryDir>(); }
    void theDayOfADrone();
    void textThatIsNoLuaIsRefused();
    void otherGenerationsAreLookedAt_data();
    void otherGenerationsAreLookedAt();
    void aDroneThatIsNotThereIsTold();
    void nobodyElseAsksOverUdp();

private:
    [[nodiscard]] QString path(const QString &name) const { return m_dir->filePath(name); }
    Run ctl(const QStringList &arguments) { return Running(m_dir->path(), arguments).finish(); }

    std::unique_ptr<QTemporaryDir> m_dir;
};

// Connect, look, calibrate, tune, store, edit the text, test a motor, stop.
void TestBcflightCtl::theDayOfADrone()
{
    const SimProcess drone({u"--udp"_s, u"0"_s}, u"bcflight"_s);
    const QStringList link{u"--link"_s, drone.address()};
    const auto good = [&](const QStringList &command) {
        const Run run = ctl(link + command);
        if (run.exitCode != 0)
            qWarning().noquote() << command.join(u' ') << run.exitCode << run.err;
        return run;
    };
    const Run info = good({u"--json"_s, u"info"_s});
    QCOMPARE(info.exitCode, 0);
    QCOMPARE(info.json().value(u"family"_s).toString(), u"bcflight"_s);
    QVERIFY2(good({u"get"_s, u"pid.roll.p"_s}).out.contains(u"0.00144"_s), "the gain of the shipped text");
    QCOMPARE(good({u"do"_s, u"calibrate.all"_s}).exitCode, 0);
    const Run status = good({u"--json"_s, u"do"_s, u"status"_s});
    QVERIFY(status.json().value(u"reply"_s).toObject().value(u"calibrated"_s).toBool());
    const Run monitor
        = good({u"monitor"_s, u"--channels"_s, u"battery,attitude.roll,gyro.x"_s, u"--seconds"_s, u"1"_s});
    QVERIFY2(monitor.exitCode == 0 && monitor.out.count(u'\n') > 20, qPrintable(monitor.err));

    // In use is not stored.
    const Run set = good({u"set"_s, u"pid.roll.p=0.0018"_s});
    QCOMPARE(set.exitCode, 0);
    QVERIFY2(set.err.contains(u"in use until the board restarts, and not stored"_s)
                 && !set.err.contains(u"stored now"_s),
             qPrintable(set.err));
    QVERIFY(good({u"get"_s, u"pid.roll.p"_s}).out.contains(u"0.0018"_s));
    QCOMPARE(good({u"dump"_s, path(u"before.json"_s)}).exitCode, 0);
    const Run stored = good({u"do"_s, u"gains.store"_s});
    QCOMPARE(stored.exitCode, 0);
    QVERIFY2(!stored.out.contains(u"sent"_s), qPrintable(stored.out));  // it was seen to be stored
    QCOMPARE(good({u"dump"_s, path(u"after.json"_s)}).exitCode, 0);
    const Run differs = ctl(link + QStringList{u"diff"_s, path(u"before.json"_s), path(u"after.json"_s)});
    QVERIFY2(differs.out.contains(u"Configuration text"_s) || differs.out.contains(u"CONFIG_FILE"_s),
             qPrintable(differs.out + differs.err));
    QVERIFY(good({u"get"_s, u"pid.roll.p"_s}).out.contains(u"0.0018"_s));

    QCOMPARE(good({u"do"_s, u"calibrate.gyro"_s}).exitCode, 0);
    const Run turned = good({u"do"_s, u"motor.test"_s, u"motor=2"_s, u"--confirmed"_s});
    QVERIFY2(turned.exitCode == 0, qPrintable(turned.err));
    // That the propellers are off is confirmed each time.
    QVERIFY(ctl(link + QStringList{u"do"_s, u"motor.test"_s, u"motor=2"_s}).exitCode != 0);
    QCOMPARE(good({u"do"_s, u"motors.off"_s}).exitCode, 0);
}

void TestBcflightCtl::textThatIsNoLuaIsRefused()
{
    const SimProcess drone({u"--udp"_s, u"0"_s}, u"bcflight"_s);
    const QStringList link{u"--link"_s, drone.address()};
    const QString file = path(u"whole.json"_s);
    QCOMPARE(ctl(link + QStringList{u"dump"_s, file}).exitCode, 0);
    QFile whole(file);
    QVERIFY(whole.open(QFile::ReadOnly));
    QByteArray text = whole.readAll();
    whole.close();
    const QByteArray good = QByteArray("rate_speed = 300").toHex();
    QVERIFY(text.contains(good));
    text.replace(good, QByteArray("rate_speed = = 300").toHex());
    QVERIFY(whole.open(QFile::WriteOnly));
    whole.write(text);
    whole.close();
    const Run applied = ctl(link + QStringList{u"apply"_s, file});
    QCOMPARE(applied.exitCode, 1);
    QVERIFY2(applied.err.contains(u"line "_s), qPrintable(applied.err));
    QCOMPARE(ctl(link + QStringList{u"info"_s}).exitCode, 0);  // it is still there
}

void TestBcflightCtl::otherGenerationsAreLookedAt_data()
{
    QTest::addColumn<QString>("generation");
    for (const QString &letter : {u"A"_s, u"C"_s, u"E"_s})
        QTest::newRow(qPrintable(letter)) << letter;
}

void TestBcflightCtl::otherGenerationsAreLookedAt()
{
    QFETCH(QString, generation);
    const SimProcess drone({u"--udp"_s, u"0"_s, u"--generation"_s, generation}, u"bcflight"_s);
    const QStringList link{u"--link"_s, drone.address()};
    QCOMPARE(ctl(link + QStringList{u"info"_s}).exitCode, 0);
    QCOMPARE(ctl(link + QStringList{u"get"_s, u"pid.roll.p"_s}).exitCode, 0);
    const Run set = ctl(link + QStringList{u"set"_s, u"pid.roll.p=0.0018"_s});
    QCOMPARE(set.exitCode, 1);
}

void TestBcflightCtl::aDroneThatIsNotThereIsTold()
{
    const Run run = ctl({u"--link"_s, u"udp://127.0.0.1:9"_s, u"info"_s});
    QCOMPARE(run.exitCode, 1);
    QVERIFY(!run.err.isEmpty());
}

// Whatever a drone hears it takes for commands: other families' questions are not asked there.
void TestBcflightCtl::nobodyElseAsksOverUdp()
{
    const SimProcess drone({u"--udp"_s, u"0"_s}, u"bcflight"_s);
    const Run other = ctl({u"--family"_s, u"simplebgc"_s, u"--link"_s, drone.address(), u"info"_s});
    QVERIFY(other.exitCode != 0);
    QCOMPARE(ctl({u"--link"_s, drone.address(), u"info"_s}).exitCode, 0);
}

QTEST_GUILESS_MAIN(TestBcflightCtl)
#include "tst_bcflightctl.moc"
