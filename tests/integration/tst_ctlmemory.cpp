// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

using namespace Qt::StringLiterals;

namespace {

struct Run
{
    int exitCode = -1;
    QString out;
    QString err;
};

}  // namespace

/// gimbalctl on boards that store everything in use at once: nothing is stored unsaid.
class TestCtlMemory : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        m_dir = std::make_unique<QTemporaryDir>();
        m_simulator = std::make_unique<SimProcess>(QStringList{u"--tcp"_s, u"0"_s}, u"storm32"_s);
    }
    void cleanup() { m_simulator.reset(); }
    void whatElseIsInUseIsNotStored();
    void everyWayIsThere();
    void appliedFileIsInUse();
    void scriptIsNamed();
    void lockedOutBoardStoresNothingElse();
    void plainStoreIsTold();
    void restartNamesWhatIsLost_data();
    void restartNamesWhatIsLost();
    void slowStopIsTold();
    void stoppedBoardRefusesToStore_data();
    void stoppedBoardRefusesToStore();

private:
    Run ctl(const QStringList &arguments)
    {
        QProcess process;
        process.start(QStringLiteral(GIMBAL_BIN_DIR "/gimbalctl"),
                      QStringList{u"--history"_s, m_dir->filePath(u"history"_s), u"--family"_s, u"storm32"_s,
                                  u"--link"_s, m_simulator->address()}
                          + arguments);
        if (!QTest::qWaitFor([&process] { return process.state() == QProcess::NotRunning; }, kPatience))
            return {-1, {}, u"it does not end"_s};
        return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
                QString::fromUtf8(process.readAllStandardError())};
    }
    QString compared() { return ctl({u"do"_s, u"stored.compare"_s}).out; }

    std::unique_ptr<QTemporaryDir> m_dir;
    std::unique_ptr<SimProcess> m_simulator;
};

void TestCtlMemory::whatElseIsInUseIsNotStored()
{
    QCOMPARE(ctl({u"set"_s, u"--no-save"_s, u"pid.pitch.p=5"_s}).exitCode, 0);
    const Run set = ctl({u"set"_s, u"motor.yaw.poles=12"_s});
    QVERIFY2(set.exitCode == 0, qPrintable(set.err));
    QVERIFY2(set.out.contains(u"kept"_s) && set.out.contains(u"5.00 in use, 4.00 stored"_s),
             qPrintable(set.out));
    QVERIFY2(set.err.contains(u"--others store"_s) && set.err.contains(u"--others restore"_s),
             qPrintable(set.err));
    const QString differs = compared();
    QVERIFY2(differs.contains(u"5.00 in use, 4.00 stored"_s) && !differs.contains(u"poles"_s),
             qPrintable(differs));
    // Nothing to write is no reason to keep silent.
    const Run again = ctl({u"--json"_s, u"set"_s, u"motor.yaw.poles=12"_s});
    const QJsonObject json = QJsonDocument::fromJson(again.out.toUtf8()).object();
    QCOMPARE(json.value(u"others"_s).toArray().size(), 1);
    QCOMPARE(json.value(u"others"_s).toArray().first().toObject().value(u"key"_s).toString(),
             u"pid.pitch.p"_s);
    // The value in use is stored once it is asked for, though the board "holds" it already.
    QCOMPARE(ctl({u"set"_s, u"pid.pitch.p=5"_s}).exitCode, 0);
    QVERIFY2(compared().contains(u"false"_s), qPrintable(compared()));
}

void TestCtlMemory::everyWayIsThere()
{
    QCOMPARE(ctl({u"set"_s, u"--no-save"_s, u"pid.pitch.p=5"_s}).exitCode, 0);
    Run set = ctl({u"set"_s, u"motor.yaw.poles=12"_s, u"--others"_s, u"restore"_s});
    QVERIFY2(set.exitCode == 0 && set.out.contains(u"restored"_s), qPrintable(set.out + set.err));
    QCOMPARE(ctl({u"get"_s, u"pid.pitch.p"_s}).out, u"4.00\n"_s);
    QCOMPARE(ctl({u"set"_s, u"--no-save"_s, u"pid.pitch.p=5"_s}).exitCode, 0);
    set = ctl({u"set"_s, u"motor.yaw.poles=16"_s, u"--others"_s, u"store"_s});
    QVERIFY2(set.exitCode == 0 && set.out.contains(u"stored "_s), qPrintable(set.out + set.err));
    QVERIFY2(compared().contains(u"false"_s), qPrintable(compared()));
    QCOMPARE(ctl({u"set"_s, u"motor.yaw.poles=12"_s, u"--others"_s, u"forget"_s}).exitCode, 2);
    // A value that is wanted as it is stored is in use afterwards.
    QCOMPARE(ctl({u"set"_s, u"--no-save"_s, u"pid.pitch.p=6"_s}).exitCode, 0);
    QCOMPARE(ctl({u"set"_s, u"pid.pitch.p=5"_s}).exitCode, 0);
    QCOMPARE(ctl({u"get"_s, u"pid.pitch.p"_s}).out, u"5.00\n"_s);
}

void TestCtlMemory::appliedFileIsInUse()
{
    const QString file = m_dir->filePath(u"board.json"_s);
    QCOMPARE(ctl({u"dump"_s, file}).exitCode, 0);
    QCOMPARE(ctl({u"set"_s, u"--no-save"_s, u"pid.pitch.p=5"_s, u"rc.pitch.min=-30"_s}).exitCode, 0);
    // What would be written is compared with what is stored.
    const Run dry = ctl({u"apply"_s, u"--dry-run"_s, file});
    QVERIFY2(dry.exitCode == 0 && dry.out.contains(u"nothing would change"_s), qPrintable(dry.out));
    QVERIFY2(dry.err.contains(u"pid.pitch.p (5.00 in use, 4.00 stored)"_s), qPrintable(dry.err));
    const Run applied = ctl({u"apply"_s, file});
    QVERIFY2(applied.exitCode == 0, qPrintable(applied.err));
    QCOMPARE(ctl({u"get"_s, u"pid.pitch.p"_s}).out, u"4.00\n"_s);
    QVERIFY2(compared().contains(u"false"_s), qPrintable(compared()));
}

void TestCtlMemory::scriptIsNamed()
{
    const QString file = m_dir->filePath(u"move.scr"_s);
    QFile text(file);
    QVERIFY(text.open(QIODevice::WriteOnly));
    text.write("CASE#DEFAULT\nSET \"Pitch P\" 500\n");
    text.close();
    QCOMPARE(ctl({u"script"_s, u"1"_s, file}).exitCode, 0);
    QCOMPARE(ctl({u"set"_s, u"script1.input=11"_s}).exitCode, 0);
    const Run set = ctl({u"set"_s, u"motor.yaw.poles=12"_s});
    QVERIFY2(set.exitCode == 0 && !set.err.contains(u"byte"_s), qPrintable(set.err));
    QVERIFY2(set.out.contains(u"pid.pitch.p"_s) && set.out.contains(u"script 1 sets it"_s),
             qPrintable(set.out));
}

// The heartbeat is on, in use only: it and another value in use stay so, and are not stored.
void TestCtlMemory::lockedOutBoardStoresNothingElse()
{
    QCOMPARE(ctl({u"set"_s, u"--no-save"_s, u"pid.pitch.p=6"_s}).exitCode, 0);
    QCOMPARE(ctl({u"set"_s, u"--no-save"_s, u"mavlink.heartbeat=1"_s}).exitCode, 0);
    const Run set = ctl({u"set"_s, u"motor.yaw.poles=16"_s});
    QVERIFY2(set.exitCode == 0, qPrintable(set.out + set.err));
    QVERIFY2(set.out.contains(u"6.00 in use, 4.00 stored"_s) && set.out.contains(u"mavlink.heartbeat"_s),
             qPrintable(set.out));
    const QString differs = compared();
    QVERIFY2(differs.contains(u"6.00 in use, 4.00 stored"_s) && differs.contains(u"mavlink.heartbeat"_s)
                 && !differs.contains(u"poles"_s),
             qPrintable(differs));
}

void TestCtlMemory::plainStoreIsTold()
{
    QCOMPARE(ctl({u"set"_s, u"--no-save"_s, u"pid.pitch.p=5"_s}).exitCode, 0);
    const Run store = ctl({u"--json"_s, u"do"_s, u"store"_s});
    QVERIFY2(store.exitCode == 0, qPrintable(store.err));
    const QJsonObject json = QJsonDocument::fromJson(store.out.toUtf8()).object();
    QCOMPARE(json.value(u"others"_s).toArray().size(), 1);
    // The snapshot brings back what was stored before.
    const Run back = ctl({u"apply"_s, json.value(u"snapshot"_s).toString()});
    QVERIFY2(back.exitCode == 0, qPrintable(back.err));
    QCOMPARE(ctl({u"get"_s, u"pid.pitch.p"_s}).out, u"4.00\n"_s);
}

// A board that starts ignores standby: its motors are disabled meanwhile, and that is said.
void TestCtlMemory::restartNamesWhatIsLost_data()
{
    QTest::addColumn<QString>("action");
    for (const QString &action : {u"restart"_s, u"reset"_s, u"retrieve"_s})
        QTest::newRow(qPrintable(action)) << action;
}

// Whatever puts the stored values into use.
void TestCtlMemory::restartNamesWhatIsLost()
{
    QFETCH(QString, action);
    QCOMPARE(ctl({u"set"_s, u"--no-save"_s, u"pid.pitch.p=5"_s}).exitCode, 0);
    const Run restart = ctl({u"--json"_s, u"do"_s, action, u"--confirmed"_s});
    QVERIFY2(restart.exitCode == 0, qPrintable(restart.err));
    const QJsonArray lost = QJsonDocument::fromJson(restart.out.toUtf8()).object().value(u"lost"_s).toArray();
    QCOMPARE(lost.size(), 1);
    QCOMPARE(lost.first().toObject().value(u"key"_s).toString(), u"pid.pitch.p"_s);
    QCOMPARE(ctl({u"set"_s, u"--no-save"_s, u"pid.pitch.p=5"_s}).exitCode, 0);
    const Run told = ctl({u"do"_s, action, u"--confirmed"_s});
    QVERIFY2(told.out.contains(u"4.00 (5.00 was in use, and not stored)"_s), qPrintable(told.out));
    QVERIFY(!ctl({u"do"_s, action, u"--confirmed"_s}).out.contains(u"in use"_s));
}

void TestCtlMemory::slowStopIsTold()
{
    QCOMPARE(ctl({u"do"_s, u"reset"_s, u"--confirmed"_s}).exitCode, 0);
    const Run off = ctl({u"motors"_s, u"off"_s});
    QVERIFY2(off.exitCode == 0, qPrintable(off.err));
    QVERIFY2(off.err.contains(u"the motors are off; they stay disabled until the board"_s),
             qPrintable(off.err));
    QCOMPARE(ctl({u"get"_s, u"motor.yaw.usage"_s}).out, u"0\n"_s);
    // One that obeys at once needs no words.
    const Run again = ctl({u"motors"_s, u"off"_s});
    QVERIFY2(again.exitCode == 0 && !again.err.contains(u"disabled"_s), qPrintable(again.err));
}

void TestCtlMemory::stoppedBoardRefusesToStore_data()
{
    QTest::addColumn<QString>("firmware");
    for (const QString &firmware : {u"0.79"_s, u"0.90"_s, u"0.96"_s})
        QTest::newRow(qPrintable(firmware)) << firmware;
}

// "Store nothing before": a stop has disabled the motors in RAM while the board was starting.
void TestCtlMemory::stoppedBoardRefusesToStore()
{
    QFETCH(const QString, firmware);
    m_simulator = std::make_unique<SimProcess>(
        QStringList{u"--tcp"_s, u"0"_s, u"--firmware"_s, firmware, u"--fault"_s, u"no-imu=1"_s},
        u"storm32"_s);
    QCOMPARE(ctl({u"do"_s, u"reset"_s, u"--confirmed"_s}).exitCode, 0);
    QCOMPARE(ctl({u"set"_s, u"--no-save"_s, u"motor.pitch.usage=3"_s, u"motor.roll.usage=3"_s,
                  u"motor.yaw.usage=3"_s})
                 .exitCode,
             0);
    for (const QStringList &words :
         {QStringList{u"set"_s, u"pid.pitch.p=4.4"_s}, QStringList{u"do"_s, u"store"_s},
          QStringList{u"do"_s, u"stored.compare"_s}}) {
        const Run refused = ctl(words);
        QCOMPARE(refused.exitCode, 1);
        QVERIFY2(refused.err.contains(u"the board is starting"_s), qPrintable(refused.err));
    }
}

QTEST_GUILESS_MAIN(TestCtlMemory)
#include "tst_ctlmemory.moc"
