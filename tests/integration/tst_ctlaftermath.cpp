// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/ctlrun.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"

#include <QJsonArray>
#include <QTemporaryDir>

#include <csignal>

using namespace Qt::StringLiterals;

/// What gimbalctl tells after something went wrong in the middle.
class TestCtlAftermath : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_dir = std::make_unique<QTemporaryDir>(); }
    void changedValuesAreTold_data();
    void changedValuesAreTold();
    void cancelledSearchLeavesNothing();
    void searchThatGoesOnIsTold();
    void rowsBeforeTheLossAreKept_data();
    void rowsBeforeTheLossAreKept();
    void liveValuesThatAreNotTakenAreTold();
    void contradictionsAreFoundDry();
    void partsThatDoNotFitAreNoSuccess();
    void outputThatIsLostIsNoSuccess_data();
    void outputThatIsLostIsNoSuccess();
    void pipesAreNotReplaced();
    void destroyingIsConfirmed();

private:
    [[nodiscard]] QString path(const QString &name) const { return m_dir->filePath(name); }
    [[nodiscard]] QStringList link() const
    {
        return {u"--json"_s, u"--link"_s, u"serial:"_s + path(u"port"_s) + u"?family=simplebgc"_s};
    }
    Run ctl(const QStringList &arguments) { return Running(m_dir->path(), link() + arguments).finish(60000); }

    std::unique_ptr<QTemporaryDir> m_dir;
};

void TestCtlAftermath::changedValuesAreTold_data()
{
    QTest::addColumn<QStringList>("faults");
    QTest::addColumn<QString>("loss");
    QTest::newRow("the board gives up") << QStringList{u"--fault"_s, u"fail=3"_s} << QString();
    QTest::newRow("the link breaks") << QStringList{u"--fault"_s, u"unplug=10"_s, u"--fault"_s, u"replug=2"_s}
                                     << u"the link broke; waiting for the board"_s;
    QTest::newRow("the board restarts") << QStringList{u"--rate"_s, u"115200"_s, u"--fault"_s, u"reset=10"_s}
                                        << u"the board restarted by itself; waiting"_s;
}

// Auto-tune has changed gains until it ended: which, and what they are now.
void TestCtlAftermath::changedValuesAreTold()
{
    QFETCH(QStringList, faults);
    QFETCH(QString, loss);
    const SimProcess simulator(QStringList{u"--pty"_s, path(u"port"_s)} + faults);
    const Run run = ctl({u"autotune"_s});
    QVERIFY2(run.exitCode == 1, qPrintable(run.err));
    QVERIFY2(!run.err.contains(u"Nothing was changed"_s), qPrintable(run.err));
    QVERIFY2(run.err.contains(u"waiting"_s) == !loss.isEmpty() && run.err.contains(loss),
             qPrintable(run.err));
    const QJsonObject json = run.json();
    QVERIFY(QFile::exists(json.value(u"snapshot"_s).toString()));
    const QJsonArray changed = json.value(u"changed"_s).toArray();
    if (loss.contains(u"restarted"_s)) {  // what was found by then was not stored
        QVERIFY2(run.err.contains(u"holds the old values"_s) && changed.isEmpty(), qPrintable(run.err));
        QVERIFY2(run.err.contains(u"motors may run again"_s), qPrintable(run.err));
        QVERIFY2(!run.err.contains(u"The link to the board broke"_s), qPrintable(run.err));
        return;
    }
    if (loss.isEmpty()) {  // nobody wants what was found by then
        QVERIFY2(run.err.contains(u"holds the old values"_s) && changed.isEmpty(), qPrintable(run.err));
        return;
    }
    QVERIFY(!changed.isEmpty());
    const QString key = changed.first().toObject().value(u"key"_s).toString();
    QVERIFY2(run.err.contains(key), qPrintable(run.err));
    QVERIFY2(run.err.contains(u"a restart brings the stored ones back"_s), qPrintable(run.err));
}

// What the board tries is in volatile memory alone, and nobody has chosen it.
void TestCtlAftermath::cancelledSearchLeavesNothing()
{
    const SimProcess simulator({u"--pty"_s, path(u"port"_s)});
    const auto inUse = [this] {
        const Run now = ctl({u"get"_s, u"pid.roll.p"_s});
        return QJsonDocument::fromJson(now.out.toUtf8()).array().first().toObject().value(u"value"_s);
    };
    QCOMPARE(ctl({u"set"_s, u"--no-save"_s, u"pid.roll.p=37"_s}).exitCode, 0);
    const QJsonValue before = inUse();
    Running search(m_dir->path(), link() + QStringList{u"autotune"_s});
    QTRY_VERIFY2(search.told().contains(u"iteration 3:"_s), qPrintable(search.told()));
    QCOMPARE(::kill(pid_t(search.id()), SIGINT), 0);
    const Run run = search.finish();
    QVERIFY2(run.exitCode == 1, qPrintable(run.err));
    QVERIFY2(run.err.contains(u"holds the old values"_s), qPrintable(run.err));
    QVERIFY2(run.json().value(u"changed"_s).toArray().isEmpty(), qPrintable(run.out));
    QCOMPARE(inUse(), before);
}

// What it holds for a moment says nothing: the board searches on.
void TestCtlAftermath::searchThatGoesOnIsTold()
{
    const SimProcess simulator({u"--pty"_s, path(u"port"_s), u"--fault"_s, u"runs-on=1"_s});
    Running search(m_dir->path(), link() + QStringList{u"autotune"_s});
    QTRY_VERIFY2(search.told().contains(u"iteration 3:"_s), qPrintable(search.told()));
    QCOMPARE(::kill(pid_t(search.id()), SIGINT), 0);
    const Run run = search.finish();
    QVERIFY2(run.exitCode == 1, qPrintable(run.err));
    QVERIFY2(run.err.contains(u"goes on with what it was told to end"_s), qPrintable(run.err));
    const Run stop = ctl({u"do"_s, u"autotune.stop"_s});
    QVERIFY2(stop.exitCode == 1 && stop.err.contains(u"searches on"_s), qPrintable(stop.err));
}

void TestCtlAftermath::rowsBeforeTheLossAreKept_data()
{
    QTest::addColumn<QStringList>("command");
    QTest::newRow("monitor") << QStringList{u"monitor"_s};
    QTest::newRow("record") << QStringList{u"record"_s, u"FILE"_s};
}

void TestCtlAftermath::rowsBeforeTheLossAreKept()
{
    QFETCH(QStringList, command);
    const QString file = path(u"lost.rec"_s);
    command.replaceInStrings(u"FILE"_s, file);
    const SimProcess simulator(
        {u"--pty"_s, path(u"port"_s), u"--fault"_s, u"unplug=8"_s, u"--fault"_s, u"replug=-1"_s});
    const Run run = ctl(command);
    QVERIFY2(run.exitCode == 1, qPrintable(run.err));
    const QJsonObject json = run.json();
    QVERIFY2(json.value(u"error"_s).toString().contains(u"link"_s), qPrintable(run.out.left(300)));
    if (command.first() == u"record"_s) {
        QCOMPARE(json.value(u"file"_s).toString(), file);
        QVERIFY(QFile::exists(file));
    } else {
        QVERIFY(json.value(u"rows"_s).toArray().size() > 50);
    }
}

// What is in use is read, and nothing else is said.
void TestCtlAftermath::liveValuesThatAreNotTakenAreTold()
{
    constexpr int kSetAdjVarsVal = 31;
    const SimProcess simulator({u"--pty"_s, path(u"port"_s), u"--fault"_s, u"deaf=%1"_s.arg(kSetAdjVarsVal)});
    const auto held = [this] {
        const Run now = ctl({u"get"_s, u"pid.roll.p"_s});
        return QJsonDocument::fromJson(now.out.toUtf8()).array().first().toObject().value(u"value"_s);
    };
    const QJsonValue before = held();
    const Run run = ctl({u"set"_s, u"--no-save"_s, u"pid.roll.p=52"_s});
    QVERIFY2(run.exitCode == 1, qPrintable(run.out));
    QVERIFY2(!run.out.contains(u"volatile"_s), qPrintable(run.out));
    QVERIFY2(run.json().value(u"changed"_s).isArray(), qPrintable(run.out));
    QVERIFY(run.json().value(u"changed"_s).toArray().isEmpty());
    QCOMPARE(held(), before);
}

void TestCtlAftermath::contradictionsAreFoundDry()
{
    const SimProcess simulator({u"--pty"_s, path(u"port"_s)});
    const QString file = path(u"file.json"_s);
    QCOMPARE(ctl({u"dump"_s, file}).exitCode, 0);
    QFile json(file);
    QVERIFY(json.open(QIODevice::ReadWrite));
    QJsonObject root = QJsonDocument::fromJson(json.readAll()).object();
    QJsonObject values = root.value(u"boardValues"_s).toObject();
    values.insert(u"imu.main.axis_right"_s, values.value(u"imu.main.axis_top"_s));
    root.insert(u"boardValues"_s, values);
    json.resize(0);
    json.write(QJsonDocument(root).toJson());
    json.close();
    const Run dry = ctl({u"apply"_s, file, u"--dry-run"_s});
    QVERIFY2(dry.exitCode == 1, qPrintable(dry.out));
    QVERIFY2(dry.err.contains(u"exclude each other"_s), qPrintable(dry.err));
}

// A board of other firmware lacks values of the file.
void TestCtlAftermath::partsThatDoNotFitAreNoSuccess()
{
    const QString file = path(u"file.json"_s);
    {
        const SimProcess newer({u"--pty"_s, path(u"port"_s), u"--firmware"_s, u"2.73.8"_s});
        QCOMPARE(ctl({u"dump"_s, file}).exitCode, 0);
    }
    const SimProcess older({u"--pty"_s, path(u"port"_s), u"--firmware"_s, u"2.59"_s});
    Run run = ctl({u"apply"_s, file, u"--dry-run"_s});
    QVERIFY2(run.exitCode == 1, qPrintable(run.err));
    QVERIFY2(run.err.contains(u"not applied"_s), qPrintable(run.err));
    run = ctl({u"apply"_s, file, u"--dry-run"_s, u"--partial"_s});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
}

void TestCtlAftermath::outputThatIsLostIsNoSuccess_data()
{
    QTest::addColumn<QStringList>("command");
    QTest::newRow("list") << QStringList{u"list"_s};
    QTest::newRow("info") << QStringList{u"--json"_s, u"info"_s};
    QTest::newRow("monitor") << QStringList{u"monitor"_s, u"--seconds"_s, u"20"_s};
    QTest::newRow("help") << QStringList{u"--help"_s};
}

void TestCtlAftermath::outputThatIsLostIsNoSuccess()
{
    QFETCH(QStringList, command);
    if (!QFileInfo::exists(u"/dev/full"_s))
        QSKIP("this system has no /dev/full");
    QProcess process;
    process.setStandardOutputFile(u"/dev/full"_s);
    process.start(QStringLiteral(GIMBAL_BIN_DIR "/gimbalctl"),
                  QStringList{u"--history"_s, path(u"history"_s), u"--link"_s, u"sim:simplebgc"_s} + command);
    QVERIFY(process.waitForFinished(kPatience));
    const QByteArray told = process.readAllStandardError();
    QVERIFY2(process.exitCode() == 1, told);
    QVERIFY2(told.contains("disk is full"), told);
}

void TestCtlAftermath::pipesAreNotReplaced()
{
    const QString pipe = path(u"pipe"_s);
    QCOMPARE(QProcess::execute(u"mkfifo"_s, {pipe}), 0);
    const SimProcess simulator({u"--pty"_s, path(u"port"_s)});
    const Run run = ctl({u"dump"_s, pipe});
    QVERIFY2(run.exitCode == 1, qPrintable(run.err));
    QVERIFY2(run.err.contains(u"a device or a pipe"_s), qPrintable(run.err));
    const QFileInfo info(pipe);
    QVERIFY(info.exists() && !info.isFile());
}

void TestCtlAftermath::destroyingIsConfirmed()
{
    const SimProcess simulator({u"--pty"_s, path(u"port"_s)});
    const Run refused = ctl({u"do"_s, u"defaults"_s, u"what=profile2"_s});
    QVERIFY2(refused.exitCode == 2, qPrintable(refused.err));
    QVERIFY2(refused.err.contains(u"--confirmed"_s), qPrintable(refused.err));
    QCOMPARE(ctl({u"do"_s, u"menu"_s, u"command=Home position"_s}).exitCode, 0);
    // Nor is a choice accepted that this board does not have.
    const Run others = ctl({u"set"_s, u"pid.roll.p=40"_s, u"--others"_s, u"restore"_s});
    QVERIFY2(others.exitCode == 2 && others.err.contains(u"--others"_s), qPrintable(others.err));
}

QTEST_GUILESS_MAIN(TestCtlAftermath)
#include "tst_ctlaftermath.moc"
