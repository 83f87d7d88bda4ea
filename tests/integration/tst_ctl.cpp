// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"

#include <QDateTime>
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QNetworkDatagram>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QUdpSocket>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr std::array kCommands{
    "info",   "list",    "get",     "set",       "profiles",   "rename",  "ports",    "dump",   "diff",
    "apply",  "script",  "do",      "calibrate", "motor-test", "upload",  "autotune", "motors", "streams",
    "export", "analyze", "monitor", "record",    "publish",    "measure", "config",   "scripts"};

struct Run
{
    int exitCode = -1;
    QString out;
    QString err;
    [[nodiscard]] QJsonDocument json() const { return QJsonDocument::fromJson(out.toUtf8()); }
};

}  // namespace

/// gimbalctl as a person or a script would use it, against a running simulator.
class TestCtl : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void info();
    void firmwareIsJudged();
    void memoriesAreCompared();
    void listAndGet();
    void setWritesAndTells();
    void setWithoutSaveIsVolatile();
    void whatIsInUseIsStored();
    void valuesThatNobodyMaySet_data();
    void valuesThatNobodyMaySet();
    void dumpDiffApply();
    void incompleteBoardIsTold();
    void profilesAndRename();
    void monitorPrintsCsv();
    void recordExportAnalyzeReplay();
    void recordingKilledInTheMiddleOpens();
    void streamsByHand();
    void publishesForOthers();
    void measuresByMoving();
    void doAction();
    void calibrate();
    void encodersAreCalibrated();
    void configurationOfAnEncoderIsThatOfItsType();
    void autotune();
    void steer();
    void rawCommandsAreAnswered();
    void rawCommandsThatChangeAreConfirmed();
    void motors();
    void destructiveTakesASnapshot();
    void everyCommandSpeaksJson_data();
    void everyCommandSpeaksJson();
    void wrongArguments_data();
    void wrongArguments();
    void refusalsAreExplained();
    void portsNeedsNoBoard();
    void helpListsCommandsAndFamilies();
    void everyCommandHasHelp_data();
    void everyCommandHasHelp();
    void optionsOfOtherCommandsAreRefused_data();
    void optionsOfOtherCommandsAreRefused();
    void stormOverAPseudoTerminal_data();
    void stormOverAPseudoTerminal();
    void stormThatIsLockedOut();
    void stormIsSetUp();
    void stormIsSteeredAndTuned();

private:
    /// A measurement runs in real time: where the machine stood still, telemetry has a hole, and the program
    /// says so and to try again.
    Run measure(const QStringList &arguments, bool withLink = true)
    {
        constexpr int kTries = 4;
        Run run;
        for (int i = 0; i < kTries; ++i) {
            run = ctl(arguments, withLink);
            if (!run.err.contains(u"without a hole"_s) && !run.err.contains(u"no telemetry for"_s))
                break;
        }
        return run;
    }
    Run ctl(const QStringList &arguments, bool withLink = true)
    {
        QStringList all{u"--history"_s, m_dir->filePath(u"history"_s)};
        if (withLink)
            all += {u"--link"_s, m_simulator->address()};
        QProcess process;
        process.start(QStringLiteral(GIMBAL_BIN_DIR "/gimbalctl"), all + arguments);
        if (!QTest::qWaitFor([&process] { return process.state() == QProcess::NotRunning; }, kPatience))
            process.kill();
        return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
                QString::fromUtf8(process.readAllStandardError())};
    }

    std::unique_ptr<QTemporaryDir> m_dir;
    std::unique_ptr<SimProcess> m_simulator;
};

void TestCtl::init()
{
    m_dir = std::make_unique<QTemporaryDir>();
    m_simulator = std::make_unique<SimProcess>(QStringList{u"--tcp"_s, u"0"_s});
    QVERIFY(!m_simulator->address().isEmpty());
}

void TestCtl::cleanup()
{
    m_simulator.reset();
    m_dir.reset();
}

void TestCtl::info()
{
    const Run run = ctl({u"info"_s});
    QCOMPARE(run.exitCode, 0);
    QVERIFY(run.out.contains(u"SimpleBGC 3.0"_s));
    QCOMPARE(ctl({u"--json"_s, u"info"_s}).json().object().value(u"firmware"_s).toString(), u"2.59b0"_s);
}

// What is known of it, and what newer ones would change here, by the tables.
void TestCtl::firmwareIsJudged()
{
    const Run old = ctl({u"--link"_s, u"sim:simplebgc?firmware=2.40"_s, u"--json"_s, u"info"_s}, false);
    QCOMPARE(old.exitCode, 0);
    const QJsonObject info = old.json().object();
    const QJsonArray remarks = info.value(u"firmwareRemarks"_s).toArray();
    QCOMPARE(remarks.size(), 4);
    QVERIFY(remarks[1].toObject().value(u"text"_s).toString().contains(u"even parity"_s));
    QCOMPARE(remarks[0].toObject().value(u"caution"_s).toBool(true), false);
    bool hasStreams = false;
    for (const QJsonValue &each : info.value(u"firmwareSteps"_s).toArray()) {
        const QJsonObject step = each.toObject();
        hasStreams |= step.value(u"firmware"_s).toString() == u"2.59b0"_s
            && step.value(u"streams"_s).toArray().contains(u"custom"_s);
    }
    QVERIFY2(hasStreams, qPrintable(old.out));
    const Run run = ctl({u"info"_s});
    QVERIFY2(run.out.contains(u"remark       This program knows this firmware."_s), qPrintable(run.out));
    QVERIFY2(run.out.contains(u"would bring  2.62b0: 1 action (profile_set)\n"_s), qPrintable(run.out));
    QVERIFY2(!run.out.contains(u"would bring  2.59b0"_s), qPrintable(run.out));
}

void TestCtl::memoriesAreCompared()
{
    const QString before = m_dir->filePath(u"before"_s);
    const QString after = m_dir->filePath(u"after"_s);
    QCOMPARE(ctl({u"do"_s, u"memory.save"_s, u"file="_s + before}).exitCode, 0);
    QCOMPARE(ctl({u"set"_s, u"motor.pitch.power=99"_s}).exitCode, 0);
    QCOMPARE(ctl({u"do"_s, u"memory.save"_s, u"file="_s + after}).exitCode, 0);
    // Against the board parameters have names.
    const Run board = ctl({u"do"_s, u"memory.compare"_s, u"file="_s + before});
    QCOMPARE(board.exitCode, 0);
    QVERIFY2(board.out.contains(u"profile 1: motor.pitch.power 150 -> 99"_s), qPrintable(board.out));
    // Two files alone have addresses.
    const Run files = ctl({u"diff"_s, before, after}, false);
    QCOMPARE(files.exitCode, 0);
    QVERIFY2(files.out.contains(u"bytes differ: "_s) && files.out.startsWith(u"0x00"_s),
             qPrintable(files.out));
    QVERIFY2(files.err.contains(u"documented nowhere"_s), qPrintable(files.err));
    const QJsonArray ranges = ctl({u"--json"_s, u"diff"_s, before, after}, false).json().array();
    QVERIFY(!ranges.isEmpty());
    for (const QJsonValue &range : ranges) {
        QVERIFY(range.toObject().value(u"changed"_s).toInt() > 0);
        QVERIFY(range.toObject().value(u"from"_s) != range.toObject().value(u"to"_s));
    }
    QCOMPARE(ctl({u"diff"_s, before, before}, false).out, u"no difference\n"_s);
    // Files that do not fit are told apart.
    const QString settings = m_dir->filePath(u"settings.json"_s);
    QCOMPARE(ctl({u"dump"_s, settings}).exitCode, 0);
    const Run mixed = ctl({u"diff"_s, before, settings}, false);
    QCOMPARE(mixed.exitCode, 2);
    QVERIFY2(mixed.err.contains(u"settings.json is none"_s), qPrintable(mixed.err));
    QVERIFY(ctl({u"diff"_s, after, u"board"_s}).err.contains(u"do memory.compare file="_s));
    QFile cut(after);
    QVERIFY(cut.resize(cut.size() - 1));
    const Run damaged = ctl({u"diff"_s, before, after}, false);
    QCOMPARE(damaged.exitCode, 1);
    QVERIFY2(damaged.err.contains(u"after"_s), qPrintable(damaged.err));
}

void TestCtl::listAndGet()
{
    const Run list = ctl({u"--json"_s, u"list"_s, u"pid.*.p"_s});
    QCOMPARE(list.json().array().size(), 3);
    QCOMPARE(list.json().array().at(0).toObject().value(u"max"_s).toDouble(), 255.0);
    QCOMPARE(ctl({u"get"_s, u"pid.roll.p"_s}).out, u"35\n"_s);
    QCOMPARE(ctl({u"get"_s, u"pid.roll.p"_s, u"--profile"_s, u"2"_s}).out, u"45\n"_s);
    QCOMPARE(ctl({u"get"_s, u"pid.roll.p"_s, u"pid.roll.i"_s}).out, u"pid.roll.p=35\npid.roll.i=0.15\n"_s);
    QCOMPARE(ctl({u"list"_s, u"nothing.like.this"_s}).exitCode, 1);
}

void TestCtl::setWritesAndTells()
{
    const Run run = ctl({u"set"_s, u"pid.roll.p=48"_s, u"motor.yaw.power=130"_s});
    QCOMPARE(run.exitCode, 0);
    QCOMPARE(run.out.count(u"verified"_s), 2);
    QVERIFY(run.err.contains(u"snapshot: "_s));
    QCOMPARE(ctl({u"get"_s, u"pid.roll.p"_s}).out, u"48\n"_s);
    QCOMPARE(QDir(m_dir->filePath(u"history"_s)).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 1);
    // What was there already is named as well.
    const Run both = ctl({u"--json"_s, u"set"_s, u"pid.roll.p=49"_s, u"motor.yaw.poles=14"_s});
    const QJsonObject json = both.json().object();
    QCOMPARE(json.value(u"written"_s).toArray().size(), 1);
    QCOMPARE(json.value(u"unchanged"_s).toArray().size(), 1);
    QCOMPARE(json.value(u"unchanged"_s).toArray().first().toObject().value(u"key"_s).toString(),
             u"motor.yaw.poles"_s);
    const Run same = ctl({u"set"_s, u"motor.yaw.poles=14"_s});
    QVERIFY2(same.out.contains(u"nothing to write"_s) && same.out.contains(u"unchanged    motor.yaw.poles"_s),
             qPrintable(same.out));
}

void TestCtl::setWithoutSaveIsVolatile()
{
    QCOMPARE(ctl({u"set"_s, u"pid.roll.p=52"_s, u"--no-save"_s}).exitCode, 0);
    QCOMPARE(ctl({u"get"_s, u"pid.roll.p"_s}).out, u"52\n"_s);
    // Another profile and back: it was in volatile memory only.
    QCOMPARE(ctl({u"do"_s, u"profile.select"_s, u"profile=2"_s}).exitCode, 0);
    QCOMPARE(ctl({u"do"_s, u"profile.select"_s, u"profile=1"_s}).exitCode, 0);
    QCOMPARE(ctl({u"get"_s, u"pid.roll.p"_s}).out, u"35\n"_s);
    QCOMPARE(ctl({u"set"_s, u"motor.roll.poles=22"_s, u"--no-save"_s}).exitCode, 1);
}

// Such a board answers with what is in use: what is wanted there already is stored all the same, and what is
// stored with it is said.
void TestCtl::whatIsInUseIsStored()
{
    QCOMPARE(ctl({u"set"_s, u"pid.roll.p=53"_s, u"pid.yaw.p=61"_s, u"--no-save"_s}).exitCode, 0);
    const Run set = ctl({u"set"_s, u"pid.roll.p=53"_s});
    QVERIFY2(set.exitCode == 0 && set.out.contains(u"confirmed    pid.roll.p"_s),
             qPrintable(set.out + set.err));
    QVERIFY2(set.err.contains(u"only its next start shows"_s) && set.err.contains(u"may be stored now"_s),
             qPrintable(set.err));
    QCOMPARE(ctl({u"do"_s, u"profile.select"_s, u"profile=2"_s}).exitCode, 0);
    QCOMPARE(ctl({u"do"_s, u"profile.select"_s, u"profile=1"_s}).exitCode, 0);
    QCOMPARE(ctl({u"get"_s, u"pid.roll.p"_s}).out, u"53\n"_s);
    const QString file = m_dir->filePath(u"inuse.json"_s);
    QCOMPARE(ctl({u"dump"_s, file}).exitCode, 0);
    const Run applied = ctl({u"apply"_s, file});
    QVERIFY2(applied.out.contains(u"it does not tell whether"_s), qPrintable(applied.out));
}

void TestCtl::valuesThatNobodyMaySet_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("told");
    QTest::newRow("choice") << QStringList{u"set"_s, u"rc.map.roll=200"_s} << u"allowed 0 to 5, 33 to 35"_s;
    QTest::newRow("live") << QStringList{u"set"_s, u"imu.euler_order=9"_s, u"--no-save"_s}
                          << u"imu.euler_order = 9"_s;
    QTest::newRow("variable") << QStringList{u"do"_s, u"variables.write"_s, u"id=30"_s, u"value=7"_s}
                              << u"follow_mode = 7, allowed 0 to 2"_s;
    QTest::newRow("contradiction") << QStringList{u"set"_s, u"imu.main.axis_top=1"_s}
                                   << u"imu.main.axis_top = 1 and imu.main.axis_right = 1"_s;
}

void TestCtl::valuesThatNobodyMaySet()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, told);
    const Run run = ctl(arguments);
    QVERIFY2(run.exitCode != 0 && run.err.contains(told), qPrintable(run.out + run.err));
}

void TestCtl::dumpDiffApply()
{
    const QString a = m_dir->filePath(u"a.json"_s);
    const QString b = m_dir->filePath(u"b.json"_s);
    QCOMPARE(ctl({u"dump"_s, a}).exitCode, 0);
    QVERIFY(ctl({u"diff"_s, a, u"board"_s}).out.contains(u"no difference"_s));
    QCOMPARE(ctl({u"set"_s, u"pid.pitch.d=77"_s, u"--profile"_s, u"3"_s}).exitCode, 0);
    QCOMPARE(ctl({u"dump"_s, b}).exitCode, 0);
    const Run diff = ctl({u"diff"_s, a, b}, false);  // two files need no board
    QCOMPARE(diff.exitCode, 0);
    QVERIFY(diff.out.contains(u"pid.pitch.d"_s) && diff.out.contains(u"25 -> 77"_s));
    const Run dry = ctl({u"apply"_s, a, u"--dry-run"_s});
    QVERIFY(dry.out.contains(u"77 -> 25"_s));
    QCOMPARE(ctl({u"get"_s, u"pid.pitch.d"_s, u"--profile"_s, u"3"_s}).out, u"77\n"_s);
    QCOMPARE(ctl({u"apply"_s, a}).exitCode, 0);
    QCOMPARE(ctl({u"get"_s, u"pid.pitch.d"_s, u"--profile"_s, u"3"_s}).out, u"25\n"_s);
}

// A board that leaves a part of its values unanswered: nothing is said about those.
void TestCtl::incompleteBoardIsTold()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s, u"--fault"_s, u"deaf=62"_s});  // READ_PARAMS_EXT2
    const QStringList link{u"--link"_s, simulator.address()};
    const auto ask = [&](const QStringList &arguments) { return ctl(link + arguments, false); };
    const QString part = u"PARAMS_EXT2 of all profiles"_s;
    const QString first = u"PARAMS_EXT2 of profile 1"_s;
    const QString file = m_dir->filePath(u"incomplete.json"_s);
    const Run dump = ask({u"dump"_s, file});
    QVERIFY2(dump.exitCode == 1 && dump.err.contains(part), qPrintable(dump.err));
    QCOMPARE(ask({u"dump"_s, file, u"--partial"_s}).exitCode, 0);
    const Run json = ask({u"--json"_s, u"dump"_s, file});
    QCOMPARE(json.json().object().value(u"missing"_s).toArray().size(), 5);
    const Run same = ask({u"diff"_s, file, u"board"_s});
    QVERIFY2(same.exitCode == 1 && same.out == u"no difference in what both have\n"_s
                 && same.err.contains(part),
             qPrintable(same.out + same.err));
    const Run apply = ask({u"apply"_s, file});
    QVERIFY2(apply.exitCode == 1 && apply.out.contains(u"in what the board delivered"_s),
             qPrintable(apply.out));
    QCOMPARE(ask({u"list"_s}).exitCode, 1);
    QCOMPARE(ask({u"list"_s, u"--partial"_s}).exitCode, 0);
    for (const QStringList &command :
         {QStringList{u"get"_s, u"motion.roll.acc_limit"_s}, {u"set"_s, u"motion.roll.acc_limit=50"_s}}) {
        const Run run = ask(command);
        QVERIFY2(run.exitCode == 1 && run.err.contains(first), qPrintable(run.err));
    }
    QCOMPARE(ask({u"get"_s, u"pid.roll.p"_s}).exitCode, 0);
    QCOMPARE(ask({u"set"_s, u"pid.roll.p=44"_s}).exitCode, 0);
}

void TestCtl::profilesAndRename()
{
    QVERIFY(ctl({u"profiles"_s}).out.startsWith(u"* 1  Handheld"_s));
    QCOMPARE(ctl({u"rename"_s, u"4"_s, u"Überflug"_s}).exitCode, 0);
    const auto profiles = ctl({u"--json"_s, u"profiles"_s}).json().array();
    QCOMPARE(profiles.at(3).toObject().value(u"name"_s).toString(), u"Überflug"_s);
    QVERIFY(profiles.at(0).toObject().value(u"active"_s).toBool());
    QCOMPARE(ctl({u"rename"_s, u"9"_s, u"x"_s}).exitCode, 2);
    QCOMPARE(ctl({u"rename"_s, u"1"_s, QString(60, u'x')}).exitCode, 2);
}

void TestCtl::monitorPrintsCsv()
{
    const Run run = ctl({u"monitor"_s, u"--channels"_s, u"imu.angle.roll,battery"_s, u"--seconds"_s, u"1"_s});
    QCOMPARE(run.exitCode, 0);
    const QStringList lines = run.out.split(u'\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.first(), u"time_s,imu.angle.roll,battery"_s);
    QVERIFY2(lines.size() > 1100 && lines.size() < 1300, qPrintable(QString::number(lines.size())));
    QCOMPARE(lines.last().count(u','), 2);
    const auto json = ctl({u"--json"_s, u"monitor"_s, u"--seconds"_s, u"0.3"_s}).json().object();
    QVERIFY(json.value(u"rows"_s).toArray().size() > 200);
    QCOMPARE(json.value(u"lost"_s).toInt(), 0);
    QCOMPARE(ctl({u"monitor"_s, u"--channels"_s, u"nonsense"_s}).exitCode, 2);
}

void TestCtl::streamsByHand()
{
    const Run list = ctl({u"streams"_s});
    QCOMPARE(list.exitCode, 0);
    QVERIFY2(list.out.contains(u"REALTIME_DATA_4"_s) && list.out.contains(u"129"_s), qPrintable(list.out));
    const Run run = ctl({u"monitor"_s, u"--channels"_s, u"battery,z1.z"_s, u"--stream"_s, u"realtime4@200"_s,
                         u"--stream"_s, u"helper@100"_s, u"--seconds"_s, u"1"_s});
    QCOMPARE(run.exitCode, 0);
    const auto lines = run.out.count(u'\n');
    QVERIFY2(lines > 180 && lines < 220, qPrintable(QString::number(lines)));
    QVERIFY2(run.err.contains(u"28700 of 1000000 bytes/s"_s), qPrintable(run.err));  // 200 x 129 + 100 x 29
}

void TestCtl::publishesForOthers()
{
    QUdpSocket listener;
    QVERIFY(listener.bind(QHostAddress::LocalHost, 0));
    const Run run = ctl({u"publish"_s, u"localhost:%1"_s.arg(listener.localPort()), u"--channels"_s,
                         u"gyro.roll,gyro.yaw"_s, u"--seconds"_s, u"1"_s});
    QCOMPARE(run.exitCode, 0);
    QTRY_VERIFY(listener.hasPendingDatagrams());
    int count = 0;
    double last = 0;
    while (listener.hasPendingDatagrams()) {
        const QJsonObject message = QJsonDocument::fromJson(listener.receiveDatagram().data()).object();
        QVERIFY(message.value(u"gyro"_s)[u"roll"_s].isDouble()
                && message.value(u"gyro"_s)[u"yaw"_s].isDouble());
        QVERIFY(message.value(u"timestamp"_s).toDouble() >= last);
        last = message.value(u"timestamp"_s).toDouble();
        ++count;
    }
    // The system drops datagrams that nobody takes off in time, never the first ones.
    QVERIFY2(count > 100, qPrintable(QString::number(count)));
    QVERIFY(std::abs(last - double(QDateTime::currentMSecsSinceEpoch()) / 1000.0) < 60.0);
}

void TestCtl::measuresByMoving()
{
    const QString file = m_dir->filePath(u"sweep.csv"_s);
    const Run steps = measure({u"measure"_s, u"steps"_s, u"yaw"_s, u"steps=2"_s, u"rest=0.8"_s});
    QVERIFY2(steps.exitCode == 0 && steps.out.contains(u"2 steps: rise"_s),
             qPrintable(steps.out + steps.err));
    const Run sweep
        = measure({u"measure"_s, u"sweep"_s, u"yaw"_s, u"seconds=8"_s, u"to=8"_s, u"--csv"_s, file});
    QVERIFY2(sweep.exitCode == 0 && sweep.out.contains(u"phase margin"_s), qPrintable(sweep.out + sweep.err));
    const Run again = ctl({u"analyze"_s, u"response"_s, file}, false);
    QVERIFY2(again.exitCode == 0 && again.out.contains(u"phase margin"_s), qPrintable(again.out + again.err));
    // Without motors nothing is moved.
    QCOMPARE(ctl({u"motors"_s, u"off"_s}).exitCode, 0);
    const Run refused = ctl({u"measure"_s, u"steps"_s, u"yaw"_s});
    QCOMPARE(refused.exitCode, 1);
    QVERIFY2(refused.err.contains(u"motors"_s), qPrintable(refused.err));
}

void TestCtl::recordExportAnalyzeReplay()
{
    const QString file = m_dir->filePath(u"flight.rec"_s);
    const Run record = ctl({u"record"_s, file, u"--seconds"_s, u"3"_s});
    QCOMPARE(record.exitCode, 0);
    QVERIFY(record.err.contains(u" 0 lost"_s));
    const QString csv = m_dir->filePath(u"flight.csv"_s);
    QCOMPARE(
        ctl({u"export"_s, file, u"--csv"_s, csv, u"--channels"_s, u"gyro.roll,gyro.yaw"_s}, false).exitCode,
        0);
    QFile saved(csv);
    QVERIFY(saved.open(QIODevice::ReadOnly));
    QCOMPARE(saved.readLine(), QByteArray("time_s,gyro.roll [°/s],gyro.yaw [°/s]\n"));
    QVERIFY(saved.readAll().count('\n') > 3000);
    const Run screen = ctl({u"export"_s, file, u"--csv"_s, u"-"_s}, false);
    QCOMPARE(screen.exitCode, 0);
    QVERIFY(screen.out.startsWith(u"time_s,"_s));
    // What is measured agrees with the file's own numbers.
    const Run spectrum
        = ctl({u"--json"_s, u"analyze"_s, u"spectrum"_s, file, u"--channels"_s, u"gyro.roll"_s}, false);
    QCOMPARE(spectrum.exitCode, 0);
    const QJsonObject roll = spectrum.json().object().value(u"gyro.roll"_s).toObject();
    QVERIFY(roll.value(u"density"_s).toArray().size() > 500);
    for (const QString &kind : {u"holding"_s, u"steps"_s, u"response"_s}) {
        const Run run = ctl({u"analyze"_s, kind, file}, false);
        QCOMPARE(run.exitCode, 0);
        QVERIFY(!run.out.isEmpty());
    }
    QVERIFY(ctl({u"analyze"_s, u"holding"_s, file}, false).out.contains(u"5 to 30 Hz"_s));
    // The recording opens like the board.
    const QStringList replay{u"--link"_s, u"replay:%1?speed=8"_s.arg(file)};
    QVERIFY(ctl(replay + QStringList{u"info"_s}, false).out.contains(u"read-only"_s));
    QCOMPARE(ctl(replay + QStringList{u"get"_s, u"pid.roll.p"_s}, false).out, u"35\n"_s);
    const Run monitor = ctl(replay + QStringList{u"monitor"_s, u"--seconds"_s, u"1"_s}, false);
    QVERIFY(monitor.out.count(u'\n') > 1200);
    const Run set = ctl(replay + QStringList{u"set"_s, u"pid.roll.p=40"_s}, false);
    QCOMPARE(set.exitCode, 1);
    QVERIFY(set.err.contains(u"recording"_s));
}

void TestCtl::recordingKilledInTheMiddleOpens()
{
    const QString file = m_dir->filePath(u"killed.rec"_s);
    QProcess process;
    process.start(QStringLiteral(GIMBAL_BIN_DIR "/gimbalctl"),
                  {u"--link"_s, m_simulator->address(), u"record"_s, file});
    QVERIFY(QTest::qWaitFor([&file] { return QFileInfo(file).size() > 100'000; }, kPatience));
    process.kill();
    QVERIFY(QTest::qWaitFor([&process] { return process.state() == QProcess::NotRunning; }, kPatience));
    const Run whole = ctl({u"export"_s, file}, false);
    QCOMPARE(whole.exitCode, 0);
    QVERIFY(whole.out.count(u'\n') > 1000);
    // Cut within a chunk, as a power failure leaves it: everything before the cut is there, and it is told.
    QVERIFY(QFile::resize(file, QFileInfo(file).size() - 100));
    const Run cut = ctl({u"export"_s, file}, false);
    QCOMPARE(cut.exitCode, 1);
    QVERIFY(cut.out.count(u'\n') > 500);
    QVERIFY(cut.err.contains(u"damaged from byte"_s));
    QVERIFY2(cut.err.contains(u" bytes are left out, from "_s) && cut.err.contains(u" s to the end"_s),
             qPrintable(cut.err));
    QCOMPARE(ctl({u"export"_s, file, u"--partial"_s}, false).exitCode, 0);
    QVERIFY(ctl({u"--link"_s, u"replay:"_s + file, u"get"_s, u"pid.roll.p"_s}, false).out == u"35\n"_s);
    const Run none = ctl({u"export"_s, m_dir->filePath(u"none"_s)}, false);
    QCOMPARE(none.exitCode, 1);
    QVERIFY(!none.err.isEmpty());
}

void TestCtl::doAction()
{
    QVERIFY(ctl({u"do"_s, u"help"_s}).out.contains(u"autotune"_s));
    QVERIFY(ctl({u"do"_s, u"angles"_s}).out.contains(u"imu.roll"_s));
    QVERIFY(ctl({u"do"_s, u"debug.read"_s}).out.contains(u"CYCLE_US"_s));
    const Run beep = ctl({u"do"_s, u"beep"_s, u"sound=melody"_s, u"notes=988,1175"_s});
    QCOMPARE(beep.exitCode, 0);
    QCOMPARE(beep.out, u"sent\n"_s);  // nothing answers it
    const auto state = [this](const QStringList &arguments) {
        const QJsonObject json = ctl(QStringList{u"--json"_s} + arguments).json().object();
        return json.value(u"state"_s).toString() + (json.value(u"done"_s).toBool() ? u"+"_s : u"-"_s);
    };
    QCOMPARE(state({u"do"_s, u"beep"_s}), u"sent-"_s);
    QCOMPARE(state({u"do"_s, u"angles"_s}), u"done+"_s);
    QCOMPARE(state({u"motors"_s, u"on"_s}), u"done+"_s);
    QCOMPARE(state({u"motors"_s, u"off"_s}), u"done+"_s);
    QCOMPARE(ctl({u"motors"_s, u"on"_s}).out, u"done\n"_s);
    QCOMPARE(ctl({u"do"_s, u"beep"_s, u"sound=melody"_s, u"notes=5"_s}).exitCode, 2);
    QCOMPARE(ctl({u"do"_s, u"menu"_s, u"command=Home position"_s}).exitCode, 0);
    QCOMPARE(ctl({u"do"_s, u"nonsense"_s}).exitCode, 2);
}

void TestCtl::calibrate()
{
    const Run run = ctl({u"--json"_s, u"calibrate"_s, u"gyro"_s});
    QCOMPARE(run.exitCode, 0);
    const auto reply = run.json().object().value(u"reply"_s).toObject();
    QVERIFY(reply.value(u"confirmed"_s).toBool());
    QVERIFY(reply.value(u"gyro.bias.before"_s).toDouble() > 1.0);
    QVERIFY(reply.value(u"gyro.bias.after"_s).toDouble() < 1.0);
}

// Motors whose fields were never found may run away meanwhile: they are off before.
void TestCtl::encodersAreCalibrated()
{
    const SimProcess simulator({u"--tcp"_s, u"0"_s, u"--firmware"_s, u"2.73.0"_s, u"--encoders"_s, u"new"_s});
    const QStringList link{u"--link"_s, simulator.address(), u"--json"_s};
    QCOMPARE(ctl(link + QStringList{u"motors"_s, u"off"_s}, false).exitCode, 0);
    const QStringList calibrate{u"calibrate"_s, u"encoder_field"_s, u"angle=10"_s, u"speed=40"_s};
    QCOMPARE(ctl(link + calibrate, false).exitCode, 2);  // it asks before it turns them
    const Run run = ctl(link + calibrate + QStringList{u"--confirmed"_s}, false);
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    const auto reply = run.json().object().value(u"reply"_s).toObject();
    QCOMPARE(reply.value(u"encoder.roll.field_offset.before"_s).toDouble(), 0.0);
    QVERIFY(std::abs(reply.value(u"encoder.roll.field_offset"_s).toDouble() - 9.18) < 0.01);
    const Run read = ctl(link + QStringList{u"get"_s, u"encoder.roll.field_offset"_s}, false);
    QVERIFY2(read.out.contains(u"9.18"_s), qPrintable(read.out));
}

// The clock of one on SPI; of one at a driver, which it is.
void TestCtl::configurationOfAnEncoderIsThatOfItsType()
{
    const SimProcess simulator({u"--tcp"_s, u"0"_s, u"--firmware"_s, u"2.73.0"_s, u"--encoders"_s, u"1"_s});
    const auto ask = [&](const QStringList &arguments) {
        return ctl(QStringList{u"--link"_s, simulator.address()} + arguments, false);
    };
    const QString config = u"encoder.roll.config"_s;
    const auto set = [&](const QString &type, const QString &value) {
        return ask({u"set"_s, u"encoder.roll.type="_s + type, config + u'=' + value, u"--confirmed"_s});
    };
    Run run = set(u"AS5048A (SPI)"_s, u"500 kHz (in a driver: AS5048 PWM)"_s);
    QVERIFY2(run.exitCode == 0, qPrintable(run.out + run.err));
    QCOMPARE(ask({u"get"_s, config}).out, u"3\n"_s);
    run = set(u"AS5048A (SPI)"_s, u"In a driver: AMT203"_s);
    QVERIFY2(run.exitCode != 0 && run.err.contains(u"one of four speeds"_s), qPrintable(run.out + run.err));
    QCOMPARE(ask({u"get"_s, config}).out, u"3\n"_s);
    run = set(u"I2C driver 1"_s, u"In a driver: AMT203"_s);
    QVERIFY2(run.exitCode == 0, qPrintable(run.out + run.err));
    QCOMPARE(ask({u"get"_s, config}).out, u"4\n"_s);
    run = set(u"I2C driver 1"_s, u"8"_s);
    QVERIFY2(run.exitCode != 0 && run.err.contains(u"allowed"_s), qPrintable(run.out + run.err));
}

void TestCtl::autotune()
{
    const Run run = ctl({u"--json"_s, u"autotune"_s, u"yaw=off"_s, u"pitch=off"_s});
    QCOMPARE(run.exitCode, 0);
    QVERIFY(run.err.contains(u"iteration 5"_s));
    const double p = run.json().object().value(u"reply"_s).toObject().value(u"p.roll"_s).toDouble();
    QVERIFY(p > 12);
    QCOMPARE(ctl({u"get"_s, u"pid.roll.p"_s}).out.toDouble(), p);
}

void TestCtl::steer()
{
    const Run run = ctl({u"--json"_s, u"do"_s, u"steer"_s, u"pitch=-15"_s, u"speed=40"_s, u"seconds=2"_s});
    QCOMPARE(run.exitCode, 0);
    const double pitch = run.json().object().value(u"reply"_s).toObject().value(u"imu.pitch"_s).toDouble();
    QVERIFY2(std::abs(pitch + 15) < 3.0, qPrintable(QString::number(pitch)));
}

void TestCtl::rawCommandsAreAnswered()
{
    const Run info = ctl({u"--json"_s, u"raw"_s, u"BOARD_INFO"_s});
    QCOMPARE(info.exitCode, 0);
    const QJsonObject answer = info.json().object().value(u"answers"_s).toArray().first().toObject();
    QCOMPARE(answer.value(u"name"_s).toString(), u"BOARD_INFO"_s);
    QVERIFY2(answer.value(u"fields"_s).toString().contains(u"firmware 2.59"_s), qPrintable(info.out));
    // A whole frame, to the byte (errata section 8); and what is live data.
    QVERIFY(ctl({u"raw"_s, u"3E"_s, u"56"_s, u"00"_s, u"56"_s, u"00"_s}).out.contains(u"firmware 2.59"_s));
    QVERIFY(ctl({u"raw"_s, u"get_angles"_s}).out.contains(u"GET_ANGLES: "_s));
    // What the board refuses is told in its words.
    const Run refused = ctl({u"raw"_s, u"execute_menu"_s, u"C8"_s, u"--confirmed"_s});
    QVERIFY2(refused.out.contains(u"wrong parameters"_s), qPrintable(refused.out));
    QCOMPARE(refused.exitCode, 1);
}

void TestCtl::rawCommandsThatChangeAreConfirmed()
{
    QCOMPARE(ctl({u"set"_s, u"pid.roll.p=41"_s}).exitCode, 0);
    const Run refused = ctl({u"raw"_s, u"USE_DEFAULTS"_s, u"00"_s});
    QCOMPARE(refused.exitCode, 2);
    QVERIFY2(refused.err.contains(u"--confirmed"_s), qPrintable(refused.err));
    QCOMPARE(ctl({u"get"_s, u"pid.roll.p"_s}).out.trimmed(), u"41"_s);
    QCOMPARE(ctl({u"raw"_s, u"RESET"_s}).exitCode, 2);
    QCOMPARE(ctl({u"raw"_s, u"NO_SUCH_COMMAND"_s}).exitCode, 2);
    QCOMPARE(ctl({u"raw"_s, u"3E"_s, u"56"_s}).exitCode, 2);
    QCOMPARE(ctl({u"raw"_s}).exitCode, 2);
    const auto snapshots = [this] {
        return QDir(m_dir->filePath(u"history"_s)).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size();
    };
    QVERIFY(snapshots() > 0);
    QCOMPARE(ctl({u"raw"_s, u"USE_DEFAULTS"_s, u"00"_s, u"--confirmed"_s}).exitCode, 0);
    QTRY_COMPARE(ctl({u"get"_s, u"pid.roll.p"_s}).out.trimmed(), u"35"_s);
}

void TestCtl::motors()
{
    const auto running = [this] {
        const Run run
            = ctl({u"--json"_s, u"monitor"_s, u"--channels"_s, u"motors.on"_s, u"--seconds"_s, u"0.3"_s});
        return run.json().object().value(u"rows"_s).toArray().last().toArray().at(1).toDouble();
    };
    QCOMPARE(running(), 1.0);
    QCOMPARE(ctl({u"motors"_s, u"off"_s}).exitCode, 0);
    QCOMPARE(running(), 0.0);
    QCOMPARE(ctl({u"motors"_s, u"on"_s}).exitCode, 0);
    QCOMPARE(running(), 1.0);
    QCOMPARE(ctl({u"motors"_s, u"maybe"_s}).exitCode, 2);
}

void TestCtl::destructiveTakesASnapshot()
{
    const Run run = ctl({u"do"_s, u"defaults"_s, u"what=profile2"_s, u"--confirmed"_s});
    QCOMPARE(run.exitCode, 0);
    const QString path = run.err.section(u"snapshot: "_s, 1).section(u'\n', 0, 0);
    QVERIFY2(QFile::exists(path), qPrintable(run.err));
    // Profiles count from one everywhere, the list of choices from zero.
    const Run unclear = ctl({u"do"_s, u"defaults"_s, u"what=1"_s, u"--confirmed"_s});
    QCOMPARE(unclear.exitCode, 2);
    QVERIFY2(unclear.err.contains(u"profile1"_s), qPrintable(unclear.err));
}

void TestCtl::everyCommandSpeaksJson_data()
{
    QTest::addColumn<QStringList>("arguments");
    const auto row
        = [](const QStringList &arguments) { QTest::newRow(qPrintable(arguments.join(u' '))) << arguments; };
    row({u"ports"_s});
    row({u"info"_s});
    row({u"list"_s});
    row({u"get"_s, u"pid.roll.p"_s});
    row({u"set"_s, u"pid.roll.p=36"_s});
    row({u"profiles"_s});
    row({u"do"_s, u"help"_s});
    row({u"do"_s, u"angles"_s});
    row({u"raw"_s, u"help"_s});
    row({u"streams"_s});
    row({u"publish"_s, u"127.0.0.1:9"_s, u"--seconds"_s, u"0.3"_s});
    row({u"measure"_s, u"steps"_s, u"yaw"_s, u"steps=2"_s, u"rest=0.5"_s});
    row({u"motors"_s, u"on"_s});
    row({u"get"_s, u"nonsense"_s});
}

void TestCtl::everyCommandSpeaksJson()
{
    QFETCH(QStringList, arguments);
    const Run run = ctl(QStringList{u"--json"_s} + arguments);
    // One document and nothing else, also when something went wrong.
    QJsonParseError error;
    QJsonDocument::fromJson(run.out.toUtf8(), &error);
    QVERIFY2(error.error == QJsonParseError::NoError, qPrintable(run.out));
}

void TestCtl::wrongArguments_data()
{
    QTest::addColumn<QStringList>("arguments");
    const auto row
        = [](const QStringList &arguments) { QTest::newRow(qPrintable(arguments.join(u' '))) << arguments; };
    row({});
    row({u"nonsense"_s});
    row({u"get"_s});
    row({u"get"_s, u"no.such.key"_s});
    row({u"set"_s, u"pid.roll.p"_s});
    row({u"set"_s, u"pid.roll.p=999"_s});
    row({u"set"_s, u"pid.roll.p=high"_s});
    row({u"get"_s, u"pid.roll.p"_s, u"--profile"_s, u"0"_s});
    row({u"get"_s, u"pid.roll.p"_s, u"--profile"_s, u"9"_s});
    row({u"--colour"_s, u"info"_s});
    row({u"--family"_s, u"toaster"_s, u"info"_s});
    row({u"monitor"_s, u"--seconds"_s, u"-1"_s});
    row({u"do"_s, u"steer"_s, u"yaw=left"_s});
    row({u"do"_s, u"steer"_s});
    row({u"calibrate"_s, u"toaster"_s});
    row({u"record"_s});
    row({u"export"_s});
    row({u"analyze"_s, u"weather"_s, u"file"_s});
    row({u"analyze"_s, u"spectrum"_s});
    row({u"analyze"_s, u"response"_s, u"file"_s, u"--channels"_s, u"gyro.roll"_s});
    row({u"monitor"_s, u"--stream"_s, u"@5"_s});
    row({u"monitor"_s, u"--stream"_s, u"realtime4@fast"_s});
    row({u"monitor"_s, u"--stream"_s, u"realtime4@2000"_s});
    row({u"monitor"_s, u"--stream"_s, u"realtime9"_s});
    row({u"publish"_s});
    row({u"publish"_s, u"nowhere:70000"_s});
    row({u"measure"_s, u"steps"_s});
    row({u"measure"_s, u"jump"_s, u"pitch"_s});
    row({u"measure"_s, u"steps"_s, u"nose"_s});
    row({u"measure"_s, u"steps"_s, u"pitch"_s, u"degrees=40"_s});
    row({u"measure"_s, u"steps"_s, u"pitch"_s, u"height=2"_s});
}

void TestCtl::wrongArguments()
{
    QFETCH(QStringList, arguments);
    const Run run = ctl(arguments);
    QCOMPARE(run.exitCode, 2);
    QVERIFY(!run.err.isEmpty());
}

void TestCtl::refusalsAreExplained()
{
    QCOMPARE(ctl({u"info"_s}, false).exitCode, 2);
    const Run nobody = ctl({u"--link"_s, u"tcp://127.0.0.1:9"_s, u"info"_s}, false);
    QCOMPARE(nobody.exitCode, 1);
    QVERIFY(nobody.err.contains(u"network address"_s));
    const Run missing = ctl({u"apply"_s, u"/nonexistent.json"_s});
    QCOMPARE(missing.exitCode, 1);
    QVERIFY(missing.err.contains(u"/nonexistent.json"_s));
    QCOMPARE(ctl({u"--link"_s, u"nonsense"_s, u"info"_s}, false).exitCode, 2);
}

void TestCtl::portsNeedsNoBoard()
{
    QCOMPARE(ctl({u"ports"_s}, false).exitCode, 0);
    QCOMPARE(ctl({u"--help"_s}, false).exitCode, 0);
    QCOMPARE(ctl({u"--version"_s}, false).out.trimmed(), u"gimbalctl " GIMBAL_VERSION ""_s);
}

void TestCtl::helpListsCommandsAndFamilies()
{
    const Run help = ctl({u"--help"_s}, false);
    QCOMPARE(help.exitCode, 0);
    QVERIFY(help.out.contains(u"F: simplebgc or storm32 or bcflight\n"_s));
    QVERIFY(help.out.contains(u".cfg for STorM32"_s));
    QVERIFY(help.out.contains(u"--history DIR"_s));
    for (const char *command : kCommands)
        QVERIFY2(help.out.contains(u"\n  %1 "_s.arg(QLatin1String(command))), command);
    QCOMPARE(ctl({u"nonsense"_s, u"--help"_s}, false).exitCode, 2);
}

void TestCtl::everyCommandHasHelp_data()
{
    QTest::addColumn<QString>("command");
    for (const char *command : kCommands)
        QTest::newRow(command) << QString::fromLatin1(command);
}

// Usage, what it does, each option of the usage line explained, and a line to type.
void TestCtl::everyCommandHasHelp()
{
    QFETCH(QString, command);
    const Run run = ctl({command, u"--help"_s}, false);
    QCOMPARE(run.exitCode, 0);
    QVERIFY(run.err.isEmpty());
    const QStringList lines = run.out.split(u'\n');
    QVERIFY(lines.first().startsWith(u"gimbalctl "_s + command));
    QVERIFY(run.out.contains(u"\nExample: gimbalctl "_s));
    QVERIFY(run.out.section(u"\nExample: "_s, 1).section(u'\n', 0, 0).contains(command));
    static const QRegularExpression option(u"\\[(--[a-z-]+)"_s);
    auto it = option.globalMatch(lines.first());
    while (it.hasNext()) {
        const QString name = it.next().captured(1);
        QVERIFY2(run.out.contains(u"\n  %1 "_s.arg(name)), qPrintable(name));
    }
    // The general list says the same.
    QVERIFY(ctl({u"--help"_s}, false).out.contains(lines.first().mid(10)));
}

void TestCtl::optionsOfOtherCommandsAreRefused_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("takes");
    const auto row = [](const QStringList &arguments, const QString &takes) {
        QTest::newRow(qPrintable(arguments.join(u' '))) << arguments << takes;
    };
    const QString general = u"--link, --family, --json, --history, --board, --alarm, --version"_s;
    row({u"info"_s, u"--profile"_s, u"1"_s}, u"info has no option '--profile'; it takes "_s + general);
    row({u"get"_s, u"pid.roll.p"_s, u"--csv"_s, u"x"_s}, u"it takes --profile N, "_s + general);
    row({u"--dry-run"_s, u"set"_s, u"pid.roll.p=1"_s},
        u"it takes --profile N, --no-save, --others WHAT, --confirmed, "_s + general);
    row({u"measure"_s, u"steps"_s, u"yaw"_s, u"--seconds"_s, u"3"_s}, u"it takes --csv FILE, "_s + general);
    row({u"monitor"_s, u"--no-save"_s},
        u"it takes --channels a,b, --stream KIND@RATE, --seconds N, "_s + general);
    row({u"apply"_s, u"x"_s, u"--colour"_s},
        u"apply has no option '--colour'; it takes --dry-run, --partial, --others WHAT, --confirmed, "_s
            + general);
}

void TestCtl::optionsOfOtherCommandsAreRefused()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, takes);
    const Run run = ctl(arguments);
    QCOMPARE(run.exitCode, 2);
    QVERIFY2(run.err.contains(takes), qPrintable(run.err));
    QVERIFY(run.out.isEmpty());
}

void TestCtl::stormOverAPseudoTerminal_data()
{
    QTest::addColumn<QString>("firmware");
    for (const char *firmware : {"0.79", "0.90", "0.96"})
        QTest::newRow(firmware) << QString::fromLatin1(firmware);
}

// The other family, found without being named: read, change, store, restart, read again, steer, record,
// replay.
void TestCtl::stormOverAPseudoTerminal()
{
    QFETCH(QString, firmware);
    const QString path = m_dir->filePath(u"storm"_s);
    const SimProcess storm({u"--pty"_s, path, u"--rate"_s, u"115200"_s, u"--firmware"_s, firmware},
                           u"storm32"_s);
    QCOMPARE(storm.address(), path);
    const QStringList link{u"--link"_s, u"serial:"_s + path};
    const auto ask = [&](const QStringList &arguments) { return ctl(link + arguments, false); };
    const Run info = ask({u"--json"_s, u"info"_s});
    QVERIFY2(info.exitCode == 0, qPrintable(info.err));
    QCOMPARE(info.json().object().value(u"firmware"_s).toString(), firmware);
    QCOMPARE(ask({u"get"_s, u"pid.roll.p"_s}).out, u"4.00\n"_s);
    const QString dump = m_dir->filePath(u"before.json"_s);
    QCOMPARE(ask({u"dump"_s, dump}).exitCode, 0);
    const Run set = ask({u"set"_s, u"pid.roll.p=5.00"_s, u"rc.yaw.min=-40"_s});
    QVERIFY2(set.exitCode == 0 && set.out.contains(u"verified"_s), qPrintable(set.out + set.err));
    QCOMPARE(ask({u"do"_s, u"restart"_s, u"--confirmed"_s}).exitCode, 0);
    QCOMPARE(ask({u"get"_s, u"pid.roll.p"_s, u"rc.yaw.min"_s}).out,
             u"pid.roll.p=5.00\nrc.yaw.min=-40.0\n"_s);  // it was stored
    const Run diff = ask({u"diff"_s, dump, u"board"_s});
    QVERIFY(diff.out.contains(u"pid.roll.p"_s) && diff.out.contains(u"rc.yaw.min"_s));
    QCOMPARE(ask({u"apply"_s, dump}).exitCode, 0);
    QCOMPARE(ask({u"get"_s, u"pid.roll.p"_s}).out, u"4.00\n"_s);
    QCOMPARE(ask({u"set"_s, u"pid.roll.p=90"_s}).exitCode, 2);  // the firmware would take it
    QCOMPARE(ask({u"do"_s, u"angle"_s, u"pitch=20"_s}).exitCode, 0);
    const QString file = m_dir->filePath(u"storm.gimbalrec"_s);
    const Run record = ask({u"record"_s, file, u"--seconds"_s, u"2"_s});
    QVERIFY2(record.exitCode == 0, qPrintable(record.err));
    const Run replayed = ctl({u"--link"_s, u"replay:"_s + file, u"get"_s, u"pid.roll.p"_s}, false);
    QCOMPARE(replayed.out, u"4.00\n"_s);
    const Run off = ctl({u"--link"_s, u"replay:"_s + file, u"motors"_s, u"off"_s}, false);
    QVERIFY2(off.exitCode == 1 && !off.err.contains(u"hold"_s, Qt::CaseInsensitive), qPrintable(off.err));
    const QStringList rows
        = ctl({u"export"_s, file, u"--csv"_s, u"-"_s, u"--channels"_s, u"imu.angle.pitch,battery"_s}, false)
              .out.split(u'\n');
    QVERIFY2(rows.size() > 60, qPrintable(QString::number(rows.size())));
    QVERIFY(rows.first().contains(u"imu.angle.pitch"_s));
}

// Its heartbeat is on: it is found, read, and let out.
void TestCtl::stormThatIsLockedOut()
{
    const QString path = m_dir->filePath(u"storm"_s);
    const SimProcess storm({u"--pty"_s, path, u"--rate"_s, u"115200"_s}, u"storm32"_s);
    const QStringList link{u"--link"_s, u"serial:"_s + path};
    const auto ask = [&](const QStringList &arguments) { return ctl(link + arguments, false); };
    std::ignore = ask({u"set"_s, u"mavlink.heartbeat=1"_s});  // from then on it answers in MAVLink only
    const Run info = ask({u"info"_s});
    QVERIFY2(info.exitCode == 0 && info.out.contains(u"STorM32"_s), qPrintable(info.err));
    QCOMPARE(ask({u"get"_s, u"pid.roll.p"_s}).out, u"4.00\n"_s);
    QCOMPARE(ask({u"do"_s, u"heartbeat.off"_s}).exitCode, 0);
    const Run plain = ask({u"get"_s, u"mavlink.heartbeat"_s});
    QCOMPARE(plain.out, u"0\n"_s);
}

// Calibrating, comparing what is in use with what is stored, scripts and settings files, from the command
// line.
void TestCtl::stormIsSetUp()
{
    const QString path = m_dir->filePath(u"storm"_s);
    const SimProcess storm({u"--pty"_s, path, u"--fault"_s, u"pose=1"_s}, u"storm32"_s);
    const QStringList link{u"--link"_s, u"serial:"_s + path, u"--family"_s, u"storm32"_s};
    const auto ask = [&](const QStringList &arguments) { return ctl(link + arguments, false); };
    const Run calibrated = ask({u"calibrate"_s, u"level"_s});
    QVERIFY2(calibrated.exitCode == 0 && calibrated.out.contains(u"stored"_s),
             qPrintable(calibrated.err + calibrated.out));
    QVERIFY(!ask({u"do"_s, u"calibration.read"_s}).out.contains(u"imu.acc.zero.z      0\n"_s));
    QVERIFY(ask({u"do"_s, u"stored.compare"_s}).out.contains(u"false"_s));
    QCOMPARE(ask({u"set"_s, u"pid.roll.p=4.44"_s, u"--no-save"_s}).exitCode, 0);
    QVERIFY(ask({u"do"_s, u"stored.compare"_s}).out.contains(u"4.44 in use, 4.00 stored"_s));
    QCOMPARE(ask({u"do"_s, u"retrieve"_s, u"--confirmed"_s}).exitCode, 0);
    QCOMPARE(ask({u"get"_s, u"pid.roll.p"_s}).out, u"4.00\n"_s);

    const auto save = [this](const QString &name, const QByteArray &text) {
        QFile file(m_dir->filePath(name));
        return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() ? file.fileName()
                                                                                  : QString();
    };
    const QString script = save(u"look.scr"_s, "WAIT 5\nDORECENTER\n");
    QVERIFY(ask({u"script"_s, u"2"_s, script, u"--dry-run"_s}).out.contains(u"5 of 124 bytes"_s));
    const Run written = ask({u"script"_s, u"2"_s, script});
    QVERIFY2(written.exitCode == 0 && written.out.contains(u"verified"_s), qPrintable(written.err));
    QVERIFY(ask({u"script"_s, u"2"_s}).out.trimmed().startsWith(u"WAIT 5"_s));
    const Run wrong = ask({u"script"_s, u"2"_s, save(u"bad.scr"_s, "WAIT 5\nFLY\n")});
    QVERIFY(wrong.exitCode != 0 && wrong.err.contains(u"script 2, line 2"_s));
    QVERIFY(ask({u"script"_s, u"2"_s}).out.trimmed().startsWith(u"WAIT 5"_s));

    const QString settings = m_dir->filePath(u"mine.cfg"_s);
    QCOMPARE(ask({u"dump"_s, settings}).exitCode, 0);
    QVERIFY(ask({u"diff"_s, settings, u"board"_s}).out.contains(u"no difference"_s));
    QCOMPARE(ask({u"set"_s, u"pid.yaw.p=5"_s}).exitCode, 0);
    const Run applied = ask({u"apply"_s, settings});
    QVERIFY2(applied.exitCode == 0 && applied.out.contains(u"pid.yaw.p"_s), qPrintable(applied.err));
    QCOMPARE(ask({u"get"_s, u"pid.yaw.p"_s}).out, u"4.00\n"_s);
    // What the board cannot hold exactly is rounded, and that is said.
    const Run rounded = ask({u"--json"_s, u"set"_s, u"pid.yaw.p=4.123456"_s});
    QCOMPARE(rounded.exitCode, 0);
    QVERIFY2(rounded.err.contains(u"4.12 is the nearest to 4.123456"_s), qPrintable(rounded.err));
    QCOMPARE(rounded.json().object().value(u"rounded"_s).toArray().size(), 1);
    QVERIFY(!ask({u"set"_s, u"pid.yaw.p=4.1"_s}).err.contains(u"nearest"_s));
    // What a file does not have stays, and is named.
    QCOMPARE(ask({u"set"_s, u"pid.yaw.p=5"_s}).exitCode, 0);
    const QString few = save(u"few.cfg"_s, "%SettingsHash = (\n'Roll P' => [ 512 , '5.12' ],\n);\n");
    const Run partly = ask({u"apply"_s, few});
    QVERIFY2(partly.exitCode == 1 && partly.err.contains(u"left as the board holds them: "_s)
                 && partly.err.contains(u"pid.yaw.p"_s),
             qPrintable(partly.err));
    QCOMPARE(ask({u"get"_s, u"pid.yaw.p"_s}).out, u"5.00\n"_s);
    QCOMPARE(ask({u"get"_s, u"pid.roll.p"_s}).out, u"5.12\n"_s);
    const Run again = ask({u"--json"_s, u"apply"_s, few, u"--partial"_s});
    QCOMPARE(again.exitCode, 0);
    QVERIFY(again.json().object().value(u"missing"_s).toArray().size() > 50);
    const Run same = ask({u"diff"_s, few, u"board"_s, u"--partial"_s});
    QVERIFY2(same.out.contains(u"no difference in what both have"_s), qPrintable(same.out));
    QVERIFY(ask({u"script"_s, u"2"_s}).out.trimmed().startsWith(u"WAIT 5"_s));
}

// Steering, then tuning by what a step shows, kept over a reset.
void TestCtl::stormIsSteeredAndTuned()
{
    const QString path = m_dir->filePath(u"storm"_s);
    SimProcess storm({u"--pty"_s, path, u"--rate"_s, u"115200"_s, u"--fault"_s, u"shake=0"_s}, u"storm32"_s);
    const QStringList link{u"--link"_s, u"serial:"_s + path};
    const auto ask = [&](const QStringList &arguments) { return ctl(link + arguments, false); };
    const auto does
        = [&](const QStringList &arguments) { return ask(QStringList{u"do"_s} + arguments).exitCode == 0; };
    // The last row of what comes now; read again where a busy machine was late for its answer and left it
    // empty.
    const auto shows = [&](const QString &channel) {
        QString value;
        for (int i = 0; i < 3 && value.isEmpty(); ++i) {
            value = ask({u"monitor"_s, u"--channels"_s, channel, u"--seconds"_s, u"1.5"_s})
                        .out.trimmed()
                        .split(u'\n')
                        .last()
                        .section(u',', 1, 1);
        }
        return value.isEmpty() ? std::nan("") : value.toDouble();
    };
    QVERIFY(does({u"angle"_s, u"pitch=15"_s}));
    QVERIFY(std::abs(shows(u"imu.angle.pitch"_s) - 15) < 1.0);
    const Run limited = ask({u"do"_s, u"angle"_s, u"pitch=90"_s});  // the sticks reach 25 degrees
    QVERIFY2(limited.exitCode == 1 && limited.err.contains(u"target 90.0°, camera at 2"_s),
             qPrintable(limited.err));
    QVERIFY(std::abs(shows(u"imu.angle.pitch"_s) - 25) < 1.0);
    QVERIFY(does({u"recenter"_s}));
    QVERIFY(std::abs(shows(u"imu.angle.pitch"_s)) < 1.0);
    QVERIFY(does({u"sticks"_s, u"pitch=1700"_s}));
    QCOMPARE(shows(u"input.pitch"_s), 200.0);
    QVERIFY(does({u"sticks"_s, u"roll=1450"_s}));  // the other axes stay
    QCOMPARE(shows(u"input.pitch"_s), 200.0);
    QCOMPARE(shows(u"input.roll"_s), -50.0);
    const Run ignored = ask({u"do"_s, u"sticks"_s, u"pitch=500"_s});
    QVERIFY2(ignored.exitCode != 0 && ignored.err.contains(u"700 to 2300"_s), qPrintable(ignored.err));
    QVERIFY(ask({u"info"_s}).out.contains(u"name         OlliW 323BGC"_s));
    QVERIFY(does({u"recenter"_s}));
    QCOMPARE(shows(u"input.pitch"_s), 0.0);
    QVERIFY(does({u"pan.mode"_s, u"mode=3"_s}));  // pan pan pan
    QCOMPARE(int(shows(u"status2"_s)) & 0xE000, 0xE000);
    QVERIFY(does({u"pan.mode"_s, u"mode=0"_s}));
    QCOMPARE(ask({u"motors"_s, u"off"_s}).exitCode, 0);
    QCOMPARE(shows(u"state"_s), 99.0);
    const Run refused = ask({u"measure"_s, u"steps"_s, u"yaw"_s});
    QVERIFY2(refused.exitCode == 1 && refused.err.contains(u"motors are off"_s), qPrintable(refused.err));
    QCOMPARE(ask({u"motors"_s, u"on"_s}).exitCode, 0);

    QString said;
    const auto overshoot = [&] {
        const Run measured
            = measure(link + QStringList{u"--json"_s, u"measure"_s, u"steps"_s, u"yaw"_s}, false);
        said = measured.err;
        return measured.exitCode == 0 ? measured.json().object().value(u"overshootPercent"_s).toDouble(-1)
                                      : -1.0;
    };
    QTRY_VERIFY(shows(u"state"_s) == 6.0);
    const double before = overshoot();
    QVERIFY2(before >= 0, qPrintable(said));
    QCOMPARE(ask({u"set"_s, u"pid.yaw.d=0.0200"_s, u"--no-save"_s}).exitCode, 0);
    const double lively = overshoot();
    QVERIFY2(lively > before + 5, qPrintable(u"%1 after %2, %3"_s.arg(lively).arg(before).arg(said)));
    QCOMPARE(ask({u"set"_s, u"pid.yaw.d=0.0600"_s, u"--no-save"_s}).exitCode, 0);
    QVERIFY(overshoot() < lively - 5);
    QVERIFY(ask({u"do"_s, u"stored.compare"_s}).out.contains(u"0.0600 in use, 0.0500 stored"_s));
    QVERIFY(does({u"store"_s}));
    QVERIFY(does({u"reset"_s, u"--confirmed"_s}));
    QTRY_COMPARE(ask({u"get"_s, u"pid.yaw.d"_s}).out, u"0.0600\n"_s);
    const Run sweep = ask({u"measure"_s, u"sweep"_s, u"yaw"_s});
    QVERIFY2(sweep.exitCode == 1 && sweep.err.contains(u"steps can be measured"_s), qPrintable(sweep.err));
    // Without told targets a recording cannot say how the camera followed; how it held it can.
    const QString file = m_dir->filePath(u"held.gimbalrec"_s);
    QCOMPARE(ask({u"record"_s, file, u"--seconds"_s, u"3"_s}).exitCode, 0);
    QVERIFY(ctl({u"analyze"_s, u"steps"_s, file}, false).err.contains(u"does not tell its targets"_s));
    // A board that tells the same again and again holds nothing that could be measured.
    storm.process().write("frozen=1\n");
    const QString frozen = m_dir->filePath(u"frozen.gimbalrec"_s);
    ask({u"record"_s, frozen, u"--seconds"_s, u"3"_s});
    const Run still = ctl({u"analyze"_s, u"holding"_s, frozen}, false);
    QVERIFY2(still.exitCode == 1 && still.err.contains(u"too few samples"_s), qPrintable(still.err));
    storm.process().write("frozen=0\nshake=3\n");
    const QString shaken = m_dir->filePath(u"shaken.gimbalrec"_s);
    QCOMPARE(ask({u"record"_s, shaken, u"--seconds"_s, u"3"_s}).exitCode, 0);
    QVERIFY(ctl({u"analyze"_s, u"holding"_s, shaken}, false).out.contains(u"RMS"_s));
    QVERIFY(ctl({u"analyze"_s, u"spectrum"_s, file}, false).out.contains(u"gyro.z"_s));
}

QTEST_GUILESS_MAIN(TestCtl)
#include "tst_ctl.moc"
