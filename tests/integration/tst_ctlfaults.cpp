// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/ctlrun.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <cmath>
#include <csignal>
#include <functional>
#include <numeric>

using namespace Qt::StringLiterals;

/// gimbalctl against boards and files that fail: it ends, says so, and keeps what it has.
class TestCtlFaults : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_dir = std::make_unique<QTemporaryDir>(); }
    void silenceEndsIt_data();
    void silenceEndsIt();
    void aRestartEndsIt_data();
    void aRestartEndsIt();
    void aMissingSensorIsTold();
    void silenceIsNoTime();
    void theSameAgainIsNothing_data();
    void theSameAgainIsNothing();
    void alarmsAreInTheJson_data();
    void alarmsAreInTheJson();
    void nothingIsNoSuccess_data();
    void nothingIsNoSuccess();
    void recordingsEndWithoutSilence();
    void damagedRecordingIsReadPastTheDamage();
    void tooFewSamplesAreNoWrongArgument_data();
    void tooFewSamplesAreNoWrongArgument();
    void lostLinkInAWriteIsReadAgain_data();
    void lostLinkInAWriteIsReadAgain();
    void cancelledWriteIsReadAgain();
    void streamsOfAKilledProgramAreStopped();
    void streamsOfAKilledProgramAreStoppedOnASlowLine();
    void motorsAreOffWhileASensorIsTurned();
    void lettingGoIsConfirmed_data();
    void lettingGoIsConfirmed();
    void unprovenStopGoesOn_data();
    void unprovenStopGoesOn();
    void confirmedStopGoesOnUntilProven_data();
    void confirmedStopGoesOnUntilProven();
    void slowBoardIsStopped();
    void endedStopSaysWhatIsOpen_data();
    void endedStopSaysWhatIsOpen();
    void lostLinkIsNotPromisedBack_data();
    void lostLinkIsNotPromisedBack();
    void blockedAxisIsTold_data();
    void blockedAxisIsTold();
    void missingSensorIsNotCalibrated_data();
    void missingSensorIsNotCalibrated();
    void slowLinesThinOut_data();
    void slowLinesThinOut();
    void steeringEndsWithTheCommand_data();
    void steeringEndsWithTheCommand();
    void silenceWhileSteeringIsTold();
    void steeringUnseenIsNoSuccess_data();
    void steeringUnseenIsNoSuccess();
    void alarmsAreToldAndActedOn_data();
    void alarmsAreToldAndActedOn();
    void lateStopIsToldOnceProven();

private:
    [[nodiscard]] QString path(const QString &name) const { return m_dir->filePath(name); }
    Run ctl(const QStringList &arguments) { return Running(m_dir->path(), arguments).finish(); }

    std::unique_ptr<QTemporaryDir> m_dir;
};

void TestCtlFaults::silenceEndsIt_data()
{
    QTest::addColumn<QStringList>("command");
    QTest::newRow("monitor") << QStringList{u"monitor"_s};
    QTest::newRow("monitor for a time") << QStringList{u"monitor"_s, u"--seconds"_s, u"50"_s};
    QTest::newRow("monitor as JSON") << QStringList{u"--json"_s, u"monitor"_s};
    QTest::newRow("record") << QStringList{u"record"_s, u"FILE"_s, u"--seconds"_s, u"50"_s};
    QTest::newRow("record as JSON") << QStringList{u"--json"_s, u"record"_s, u"FILE"_s};
    QTest::newRow("publish") << QStringList{u"publish"_s, u"127.0.0.1:9"_s, u"--seconds"_s, u"50"_s};
}

// The board hangs in the middle: what came until then is kept.
void TestCtlFaults::silenceEndsIt()
{
    QFETCH(QStringList, command);
    SimProcess simulator({u"--tcp"_s, u"0"_s});
    const QString file = path(u"silent.rec"_s);
    command.replaceInStrings(u"FILE"_s, file);
    Running running(m_dir->path(), QStringList{u"--link"_s, simulator.address()} + command);
    const bool records = command.contains(u"record"_s);
    const bool prints = command.first() == u"monitor"_s;
    const quint64 before = simulator.streams().all;
    QVERIFY(QTest::qWaitFor(
        [&] {
            return records ? QFileInfo(file).size() > 100'000
                : prints   ? running.printed().count(u'\n') > 500
                           : simulator.streams().all > before + 1000;
        },
        kPatience));
    ::kill(pid_t(simulator.process().processId()), SIGSTOP);
    const Run run = running.finish(20000);
    ::kill(pid_t(simulator.process().processId()), SIGCONT);
    QCOMPARE(run.exitCode, 1);
    for (const QString &part :
         {u"No live data come."_s, u"Check its cable or network"_s, u"nothing more for"_s})
        QVERIFY2(run.err.contains(part), qPrintable(run.err));
    if (command.contains(u"--json"_s)) {
        QCOMPARE(run.json().value(u"error"_s).toString(), u"No live data come."_s);
        const QString detail = run.json().value(u"detail"_s).toString();
        static const QRegularExpression silence(u"^nothing more for ([0-9.]+) s"_s);
        QVERIFY2(silence.match(detail).captured(1).toDouble() >= 3.0, qPrintable(detail));
        QVERIFY(records || run.json().value(u"rows"_s).toArray().size() > 500);
    }
    if (prints)
        QVERIFY(run.out.endsWith(u'\n') && run.out.count(u'\n') > 500);
    if (records)
        QVERIFY(ctl({u"export"_s, file}).out.count(u'\n') > 500);
}

void TestCtlFaults::aRestartEndsIt_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QStringList>("command");
    for (const QString &family : {u"simplebgc"_s, u"storm32"_s}) {
        QTest::newRow(qPrintable(family + u", monitor"_s)) << family << QStringList{u"monitor"_s};
        QTest::newRow(qPrintable(family + u", record"_s)) << family << QStringList{u"record"_s, u"FILE"_s};
    }
}

// The board restarts by itself, and the link stays.
void TestCtlFaults::aRestartEndsIt()
{
    QFETCH(QString, family);
    QFETCH(QStringList, command);
    SimProcess simulator({u"--tcp"_s, u"0"_s, u"--rate"_s, u"115200"_s}, family);
    const QString file = path(u"restart.rec"_s);
    command.replaceInStrings(u"FILE"_s, file);
    Running running(m_dir->path(),
                    QStringList{u"--family"_s, family, u"--link"_s, simulator.address()} + command);
    QVERIFY(QTest::qWaitFor(
        [&] { return running.printed().count(u'\n') > 100 || QFileInfo(file).size() > 20'000; }, kPatience));
    simulator.process().write("reset=0\n");
    const Run run = running.finish(20000);
    QCOMPARE(run.exitCode, 1);
    QVERIFY2(run.err.contains(u"The board restarted by itself."_s), qPrintable(run.err));
}

void TestCtlFaults::aMissingSensorIsTold()
{
    for (const QString &family : {u"simplebgc"_s, u"storm32"_s}) {
        SimProcess simulator({u"--tcp"_s, u"0"_s, u"--fault"_s, u"no-imu=1"_s}, family);
        const Run run = ctl({u"--family"_s, family, u"--link"_s, simulator.address(), u"monitor"_s,
                             u"--seconds"_s, u"1"_s, u"--channels"_s, u"imu.angle.roll,battery"_s});
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(run.err.contains(u"no sensor sends any): imu.angle.roll"_s), qPrintable(run.err));
        QVERIFY2(run.err.contains(u"the board reports a fault: "_s), qPrintable(run.err));
        QVERIFY2(run.out.trimmed().section(u'\n', -1).section(u',', 1, 1).isEmpty(), qPrintable(run.out));
        QVERIFY(!run.out.trimmed().section(u'\n', -1).section(u',', 2, 2).isEmpty());
    }
}

void TestCtlFaults::theSameAgainIsNothing_data()
{
    QTest::addColumn<QString>("board");
    QTest::newRow("samples without a stamp") << u"storm32?firmware=0.79"_s;
    QTest::newRow("samples with a stamp") << u"storm32?firmware=0.96"_s;
    QTest::newRow("a stream") << u"simplebgc?seed=1"_s;
}

// A board whose data stand still measures nothing, even where no time stamp tells it.
void TestCtlFaults::theSameAgainIsNothing()
{
    QFETCH(QString, board);
    const auto monitor = [&](const QString &fault, const QString &seconds) {
        return ctl({u"--link"_s, u"sim:"_s + board + fault, u"monitor"_s, u"--seconds"_s, seconds,
                    u"--channels"_s, u"imu.angle.roll"_s});
    };
    const Run still = monitor(u"&fault=frozen=1"_s, u"30"_s);
    QCOMPARE(still.exitCode, 1);
    QVERIFY2(still.err.contains(u"No live data come."_s), qPrintable(still.err));
    const Run resting = monitor({}, u"7"_s);
    QVERIFY2(resting.exitCode == 0, qPrintable(resting.err));
}

// The time that was given ends although nothing comes in it, and what comes later is not waited for.
void TestCtlFaults::silenceIsNoTime()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s});
    Running monitor(m_dir->path(),
                    {u"--family"_s, u"simplebgc"_s, u"--link"_s, simulator.address(), u"monitor"_s,
                     u"--seconds"_s, u"2"_s, u"--channels"_s, u"imu.angle.roll"_s});
    QVERIFY(QTest::qWaitFor([&] { return monitor.printed().count(u'\n') > 1; }, kPatience));
    simulator.process().write("late=2600\n");
    const Run run = monitor.finish(20000);
    QCOMPARE(run.exitCode, 1);
    QVERIFY2(run.err.contains(u"nothing more for "_s) && run.err.contains(u"nothing came once"_s),
             qPrintable(run.err));
}

void TestCtlFaults::alarmsAreInTheJson_data()
{
    QTest::addColumn<QStringList>("command");
    QTest::newRow("record") << QStringList{u"record"_s, u"FILE"_s};
    QTest::newRow("monitor") << QStringList{u"monitor"_s};
}

// What people are told while it runs is told to programs at its end.
void TestCtlFaults::alarmsAreInTheJson()
{
    QFETCH(QStringList, command);
    command.replaceInStrings(u"FILE"_s, path(u"alarm.rec"_s));
    SimProcess simulator({u"--tcp"_s, u"0"_s, u"--fault"_s, u"no-imu=1"_s});
    const Run run
        = ctl(QStringList{u"--json"_s, u"--family"_s, u"simplebgc"_s, u"--link"_s, simulator.address()}
              + command + QStringList{u"--seconds"_s, u"4"_s});
    const QJsonArray alarms = run.json().value(u"alarms"_s).toArray();
    QVERIFY2(!alarms.isEmpty(), qPrintable(run.err));
    for (const QJsonValue alarm : alarms)
        QVERIFY2(run.err.contains(u"alarm: "_s + alarm.toString()), qPrintable(run.err));
}

void TestCtlFaults::nothingIsNoSuccess_data()
{
    QTest::addColumn<QStringList>("command");
    QTest::newRow("monitor") << QStringList{u"monitor"_s, u"--seconds"_s, u"1"_s};
    QTest::newRow("record") << QStringList{u"record"_s, u"FILE"_s, u"--seconds"_s, u"1"_s};
    QTest::newRow("publish") << QStringList{u"publish"_s, u"127.0.0.1:9"_s, u"--seconds"_s, u"1"_s};
    QTest::newRow("no end given") << QStringList{u"record"_s, u"FILE"_s};
    // It talks all the time, but not about this.
    QTest::newRow("other stream") << QStringList{
        u"monitor"_s, u"--channels"_s, u"z1.z"_s, u"--stream"_s, u"realtime4@100"_s, u"--seconds"_s, u"1"_s};
}

// The board answers, but of what was asked for not one sample can be read.
void TestCtlFaults::nothingIsNoSuccess()
{
    QFETCH(QStringList, command);
    const QString file = path(u"nothing.rec"_s);
    command.replaceInStrings(u"FILE"_s, file);
    const bool talks = command.contains(u"--stream"_s);
    const QString port = path(u"storm"_s);
    const SimProcess simulator(talks ? QStringList{u"--tcp"_s, u"0"_s}
                                     : QStringList{u"--pty"_s, port, u"--fault"_s, u"deaf=100"_s},  // 'd'
                               talks ? u"simplebgc"_s : u"storm32"_s);
    const QString link = talks ? simulator.address() : u"serial:"_s + port;
    const Run run = ctl(QStringList{u"--json"_s, u"--link"_s, link} + command);
    QVERIFY2(run.exitCode == 1, qPrintable(run.err));
    QVERIFY2(run.err.contains(u"No live data come."_s), qPrintable(run.err));
    QCOMPARE(run.json().value(u"error"_s).toString(), u"No live data come."_s);
    QCOMPARE(QFileInfo::exists(file), command.contains(file));
}

// The end of a recording is none of the board's silence.
void TestCtlFaults::recordingsEndWithoutSilence()
{
    const SimProcess simulator({u"--tcp"_s, u"0"_s});
    const QString file = path(u"short.rec"_s);
    QCOMPARE(ctl({u"--link"_s, simulator.address(), u"record"_s, file, u"--seconds"_s, u"1"_s}).exitCode, 0);
    const QStringList replay{u"--link"_s, u"replay:%1?speed=4"_s.arg(file), u"monitor"_s};
    const Run whole = ctl(replay);
    QVERIFY2(whole.exitCode == 0 && whole.out.count(u'\n') > 500, qPrintable(whole.err));
    const Run more = ctl(replay + QStringList{u"--seconds"_s, u"60"_s});
    QVERIFY2(more.exitCode == 1 && more.err.contains(u"the recording ends after"_s), qPrintable(more.err));
}

// One flipped byte, anywhere: what it costs is one chunk, and that is told.
void TestCtlFaults::damagedRecordingIsReadPastTheDamage()
{
    const SimProcess simulator({u"--tcp"_s, u"0"_s});
    const QString file = path(u"flight.rec"_s);
    QCOMPARE(ctl({u"--link"_s, simulator.address(), u"record"_s, file, u"--seconds"_s, u"6"_s}).exitCode, 0);
    QFile stored(file);
    QVERIFY(stored.open(QIODevice::ReadWrite));
    const QByteArray whole = stored.readAll();
    const Run before = ctl({u"export"_s, file});
    QCOMPARE(before.exitCode, 0);
    constexpr double kArrivals = 1;  // seconds a starved machine delays; times begun anew are off by more
    for (const double place : {0.2, 0.5, 0.8}) {
        const auto at = qsizetype(double(whole.size()) * place);
        QByteArray damaged = whole;
        damaged[at] = char(damaged[at] ^ 0x20);
        QVERIFY(stored.seek(0) && stored.write(damaged) == damaged.size() && stored.flush());

        const Run run = ctl({u"--json"_s, u"export"_s, file, u"--csv"_s, path(u"flight.csv"_s)});
        QVERIFY2(run.exitCode == 1 && run.err.contains(u"bytes are left out, from"_s), qPrintable(run.err));
        const QJsonArray leftOut = run.json().value(u"leftOut"_s).toArray();
        QCOMPARE(leftOut.size(), 1);
        const QJsonObject gap = leftOut.first().toObject();
        QVERIFY(gap.value(u"at"_s).toInt() <= at
                && gap.value(u"at"_s).toInt() + gap.value(u"bytes"_s).toInt() > at);
        QFile csv(path(u"flight.csv"_s));
        QVERIFY(csv.open(QIODevice::ReadOnly));
        const QString rows = QString::fromUtf8(csv.readAll());
        // Behind the damage rows stand at their own time. Times of arrival are smoothed anew behind a gap, so
        // that rows move by as much as arrivals varied, and those of two streams may change places, and carry
        // what the other stream told before or after.
        const auto lastOf = [](const QString &text) { return text.trimmed().split(u'\n').last(10); };
        const QStringList lastRows = lastOf(rows);
        const QStringList undamaged = before.out.trimmed().split(u'\n');
        const bool isFound = std::any_of(lastRows.begin(), lastRows.end(), [&undamaged](const QString &row) {
            return std::any_of(undamaged.begin(), undamaged.end(), [&row](const QString &other) {
                const QStringList here = row.split(u',');
                const QStringList there = other.split(u',');
                if (here.size() != there.size())
                    return false;
                const auto same = std::inner_product(here.begin(), here.end(), there.begin(), qsizetype(0),
                                                     std::plus<>(), std::equal_to<>());
                return std::abs(here[0].toDouble() - there[0].toDouble()) < kArrivals
                    && 2 * same > here.size();
            });
        });
        QVERIFY2(isFound, qPrintable(lastRows.last() + u"\n\n"_s + undamaged.last()));
        QVERIFY(rows.count(u'\n') > before.out.count(u'\n') / 2);
        static const QRegularExpression empty(u"\\n[0-9.]+,+\\n"_s);
        QVERIFY(rows.contains(empty));  // the gap
        QCOMPARE(ctl({u"export"_s, file, u"--partial"_s}).exitCode, 0);

        const Run spectrum = ctl({u"analyze"_s, u"spectrum"_s, file});
        QVERIFY2(spectrum.exitCode == 1 && spectrum.out.contains(u"gyro.roll"_s)
                     && spectrum.err.contains(u"bytes are left out"_s),
                 qPrintable(spectrum.err));
        QCOMPARE(ctl({u"analyze"_s, u"spectrum"_s, file, u"--partial"_s}).exitCode, 0);
        const QStringList replay{u"--link"_s, u"replay:"_s + file};
        const Run info = ctl(replay + QStringList{u"--json"_s, u"info"_s});
        QVERIFY2(info.exitCode == 1 && info.err.contains(u"bytes are left out"_s), qPrintable(info.err));
        QCOMPARE(info.json().value(u"leftOut"_s).toArray(), leftOut);
        QCOMPARE(ctl(replay + QStringList{u"info"_s, u"--partial"_s}).exitCode, 0);
    }
    QCOMPARE(ctl({u"--link"_s, simulator.address(), u"info"_s, u"--partial"_s}).exitCode, 2);
}

void TestCtlFaults::tooFewSamplesAreNoWrongArgument_data()
{
    QTest::addColumn<QString>("kind");
    for (const char *kind : {"spectrum", "holding", "steps", "response"})
        QTest::newRow(kind) << QString::fromLatin1(kind);
}

// A recording of next to nothing: nobody typed anything wrong.
void TestCtlFaults::tooFewSamplesAreNoWrongArgument()
{
    QFETCH(QString, kind);
    const SimProcess simulator({u"--tcp"_s, u"0"_s});
    const QString file = path(u"short.rec"_s);
    QCOMPARE(ctl({u"--link"_s, simulator.address(), u"record"_s, file, u"--seconds"_s, u"0.5"_s}).exitCode,
             0);
    // Only how the link was set up is left.
    const QStringList analyze{u"--json"_s, u"analyze"_s, kind, file};
    QFile stored(file);
    QVERIFY(stored.open(QIODevice::ReadWrite));
    const QByteArray whole = stored.readAll();
    const qsizetype second = whole.indexOf("GDCK", whole.indexOf("GDCK", whole.indexOf("GDCK") + 4) + 4);
    QVERIFY(second > 0 && stored.resize(second));
    stored.close();
    const Run run = ctl(analyze);
    QVERIFY2(run.exitCode == 1, qPrintable(run.out + run.err));
    for (const QString &part : {u"There are too few samples."_s, u"Record longer"_s})
        QVERIFY2(run.err.contains(part), qPrintable(run.err));
    QCOMPARE(run.json().value(u"error"_s).toString(), u"There are too few samples."_s);
    QVERIFY(!run.json().value(u"cure"_s).toString().isEmpty());
}

void TestCtlFaults::lostLinkInAWriteIsReadAgain_data()
{
    QTest::addColumn<int>("atWrite");
    for (int n = 1; n <= 3; ++n)
        QTest::addRow("block %d", n) << n;
}

// The board resets itself while it is written, and its port goes with it. What is told afterwards is what it
// holds.
void TestCtlFaults::lostLinkInAWriteIsReadAgain()
{
    QFETCH(int, atWrite);
    const QString port = path(u"port"_s);
    SimProcess simulator({u"--pty"_s, port, u"--fault"_s, u"reset-on-write=%1"_s.arg(atWrite)});
    const QStringList link{u"--json"_s, u"--link"_s, u"serial:"_s + port};
    const Run run = ctl(link
                        + QStringList{u"set"_s, u"pid.roll.p=44"_s, u"filter.pitch.lpf=250"_s,
                                      u"follow.yaw.lpf=9"_s, u"motion.roll.acc_limit=50"_s});
    QVERIFY2(run.err.contains(u"waiting for the board"_s), qPrintable(run.err));
    QVERIFY(!run.err.contains(u"Nothing was changed"_s));
    const QJsonObject json = run.json();
    // Of the last block only the confirmation was lost.
    const bool isWhole = atWrite == 3;
    QCOMPARE(json.value(u"complete"_s).toBool(), isWhole);
    QCOMPARE(run.err.contains(u"holds all of it"_s), isWhole);
    // Motors that start with the board are a change all the same.
    const QJsonObject restart = json.value(u"restart"_s).toObject();
    const bool hasMoved
        = restart.value(u"motorsStarted"_s).toBool() || restart.value(u"motorsStopped"_s).toBool();
    QVERIFY2(run.exitCode == (isWhole && !hasMoved ? 0 : 1), qPrintable(run.err));
    QVERIFY(QFile::exists(json.value(u"snapshot"_s).toString()));
    const QJsonArray written = json.value(u"written"_s).toArray();
    QCOMPARE(written.size(), 4);
    for (const auto &value : written) {
        const QJsonObject line = value.toObject();
        const QString key = line.value(u"key"_s).toString();
        const QString state = line.value(u"state"_s).toString();
        QVERIFY2(state != u"unknown"_s, qPrintable(key));
        const Run now = ctl(link + QStringList{u"get"_s, key});
        QVERIFY2(now.exitCode == 0, qPrintable(now.err));
        const QJsonValue held
            = QJsonDocument::fromJson(now.out.toUtf8()).array().first().toObject().value(u"value"_s);
        QVERIFY2(line.value(u"onBoard"_s) == held, qPrintable(key + u": "_s + now.out));
        QCOMPARE(state == u"verified"_s, held == line.value(u"to"_s));
    }
}

// It had no time to stop what it had ordered.
// Ctrl-C between the values and the command to store: what was stored is asked for.
void TestCtlFaults::cancelledWriteIsReadAgain()
{
    const QString port = path(u"storm"_s);
    const SimProcess storm({u"--pty"_s, port, u"--rate"_s, u"115200"_s}, u"storm32"_s);
    Running set(m_dir->path(),
                {u"--link"_s, u"serial:%1?family=storm32"_s.arg(port), u"set"_s, u"pid.roll.p=5.00"_s});
    QTRY_VERIFY(set.told().contains(u"Writing"_s));
    ::kill(pid_t(set.id()), SIGINT);
    const Run run = set.finish();
    QCOMPARE(run.exitCode, 1);
    QVERIFY2(run.err.contains(u"Cancelled"_s), qPrintable(run.err));
    QVERIFY2(!run.out.contains(u"unknown"_s) && run.out.contains(u"pid.roll.p"_s),
             qPrintable(run.err + run.out));
}

void TestCtlFaults::streamsOfAKilledProgramAreStopped()
{
    SimProcess simulator({u"--pty"_s, path(u"board"_s)});
    const QStringList link{u"--link"_s, u"serial:"_s + path(u"board"_s)};
    for (const QString &channels : {u"imu.angle.roll,gyro.roll"_s, u"target.angle.yaw,gyro.roll"_s}) {
        Running running(m_dir->path(), link + QStringList{u"monitor"_s, u"--channels"_s, channels});
        QVERIFY(QTest::qWaitFor([&] { return running.printed().count(u'\n') > 50; }, kPatience));
        running.kill();
    }
    const quint64 before = simulator.streams().all;
    QTRY_VERIFY(simulator.streams().all > before + 500);
    const Run run = ctl(link + QStringList{u"--json"_s, u"info"_s});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    QVERIFY2(!run.err.contains(u"left on"_s), qPrintable(run.err));
    const quint64 after = simulator.streams().all;
    QCOMPARE(ctl(link + QStringList{u"get"_s, u"pid.roll.p"_s}).exitCode, 0);
    // Each run orders a status of its own, 25 times a second; what was left came 2500 times.
    QVERIFY(simulator.streams().all < after + 100);
}

// What the board had queued before it obeyed goes on coming for a while, and is no stream that cannot be
// stopped.
void TestCtlFaults::streamsOfAKilledProgramAreStoppedOnASlowLine()
{
    SimProcess simulator({u"--pty"_s, path(u"slow"_s), u"--rate"_s, u"9600"_s});
    const QStringList link{u"--link"_s, u"serial:"_s + path(u"slow"_s) + u"?baud=9600&parity=none"_s};
    for (int i = 0; i < 3; ++i) {
        Running running(m_dir->path(), link + QStringList{u"monitor"_s});
        QVERIFY2(QTest::qWaitFor([&] { return running.printed().count(u'\n') > 20; }, kPatience),
                 qPrintable(running.told()));
        running.kill();
        const Run run = ctl(link + QStringList{u"info"_s});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        QVERIFY2(!run.err.contains(u"left on"_s), qPrintable(run.err));
    }
}

// Positions are asked for only once the motors are proven off, and they stay off.
void TestCtlFaults::motorsAreOffWhileASensorIsTurned()
{
    const QString port = path(u"storm"_s);
    const SimProcess storm({u"--pty"_s, port, u"--fault"_s, u"pose=1"_s}, u"storm32"_s);
    const QStringList link{u"--link"_s, u"serial:%1?family=storm32"_s.arg(port)};
    const auto status = [&] { return ctl(link + QStringList{u"do"_s, u"status"_s}).out; };
    QVERIFY2(status().contains(u"normal"_s), qPrintable(status()));
    {
        Running six(m_dir->path(), link + QStringList{u"calibrate"_s, u"six"_s, u"--confirmed"_s});
        QTRY_VERIFY2(six.told().contains(u"Lay the sensor"_s), qPrintable(six.told()));
        six.kill();
    }
    QVERIFY2(status().contains(u"standby"_s), qPrintable(status()));

    const SimProcess simplebgc({u"--tcp"_s, u"0"_s});
    const Run one
        = ctl({u"--link"_s, simplebgc.address(), u"calibrate"_s, u"acc"_s, u"six=on"_s, u"--confirmed"_s});
    QVERIFY2(one.exitCode == 0 && one.out.contains(u"motors_switched_off"_s), qPrintable(one.err + one.out));
}

void TestCtlFaults::lettingGoIsConfirmed_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QStringList>("command");
    const auto row = [](const QString &family, const QStringList &command) {
        QTest::newRow(qPrintable(family + u' ' + command.join(u' '))) << family << command;
    };
    row(u"simplebgc"_s, {u"do"_s, u"reset"_s});
    row(u"simplebgc"_s, {u"do"_s, u"menu"_s, u"command=Reset board"_s});
    row(u"simplebgc"_s, {u"calibrate"_s, u"gyro"_s, u"action=reset-all"_s});
    row(u"simplebgc"_s, {u"calibrate"_s, u"acc"_s, u"six=on"_s});
    row(u"storm32"_s, {u"do"_s, u"restart"_s});
    row(u"storm32"_s, {u"do"_s, u"reset"_s});
    row(u"storm32"_s, {u"do"_s, u"motors.normal"_s});
    row(u"storm32"_s, {u"calibrate"_s, u"six"_s});
}

// The camera falls when motors that run lose their current.
void TestCtlFaults::lettingGoIsConfirmed()
{
    QFETCH(QString, family);
    QFETCH(QStringList, command);
    const SimProcess board({u"--tcp"_s, u"0"_s}, family);
    const QStringList link{u"--link"_s, board.address(), u"--family"_s, family};
    const Run refused = ctl(link + command);
    QVERIFY2(refused.exitCode == 2 && refused.err.contains(u"--confirmed"_s), qPrintable(refused.err));
    // Nothing was sent: they still run.
    QVERIFY(ctl(link + command).err.contains(u"running"_s));
    if (command.contains(u"do"_s)) {
        QCOMPARE(ctl(link + QStringList{u"motors"_s, u"off"_s}).exitCode, 0);
        const Run limp = ctl(link + command);
        QVERIFY2(limp.exitCode == 0, qPrintable(limp.err));
        const SimProcess other({u"--tcp"_s, u"0"_s}, family);
        const Run confirmed = ctl(QStringList{u"--link"_s, other.address(), u"--family"_s, family} + command
                                  + QStringList{u"--confirmed"_s});
        QVERIFY2(confirmed.exitCode == 0, qPrintable(confirmed.err));
    }
}

void TestCtlFaults::unprovenStopGoesOn_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QStringList>("faults");
    QTest::addColumn<bool>("interrupted");
    QTest::newRow("simplebgc, Ctrl-C") << u"simplebgc"_s << QStringList{u"deaf=109"_s} << true;
    QTest::newRow("simplebgc, link ends")
        << u"simplebgc"_s << QStringList{u"deaf=109"_s, u"unplug=7"_s, u"replug=-1"_s} << false;
    QTest::newRow("storm32, Ctrl-C") << u"storm32"_s << QStringList{u"deaf=%1"_s.arg(int('s'))} << true;
}

// Motors that nobody has seen stop are not left to run.
void TestCtlFaults::unprovenStopGoesOn()
{
    QFETCH(QString, family);
    QFETCH(QStringList, faults);
    QFETCH(bool, interrupted);
    QStringList options{u"--tcp"_s, u"0"_s};
    for (const QString &fault : std::as_const(faults))
        options += {u"--fault"_s, fault};
    const SimProcess board(options, family);
    Running stop(m_dir->path(), {u"--link"_s, board.address(), u"--family"_s, family, u"motors"_s, u"off"_s});
    QTRY_VERIFY2(stop.told().contains(u"goes on until"_s), qPrintable(stop.told()));
    if (interrupted) {
        QTRY_VERIFY2(stop.told().contains(u"still stopping"_s), qPrintable(stop.told()));
        ::kill(pid_t(stop.id()), SIGINT);
    }
    const Run run = stop.finish();
    QCOMPARE(run.exitCode, 1);
    QVERIFY2(run.err.contains(u"did not confirm that the motors are off"_s), qPrintable(run.err));
    QCOMPARE(run.err.count(u"goes on until"_s), 1);
}

void TestCtlFaults::confirmedStopGoesOnUntilProven_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QStringList>("command");
    for (const QString &family : {u"simplebgc"_s, u"storm32"_s}) {
        QTest::newRow(qPrintable(family + u" motors off"_s)) << family << QStringList{u"motors"_s, u"off"_s};
        QTest::newRow(qPrintable(family + u" do motors.off"_s))
            << family << QStringList{u"do"_s, u"motors.off"_s};
    }
    QTest::newRow("simplebgc do menu")
        << u"simplebgc"_s << QStringList{u"do"_s, u"menu"_s, u"command=Motors off"_s};
    QTest::newRow("storm32 do standby") << u"storm32"_s << QStringList{u"do"_s, u"standby"_s, u"on=on"_s};
}

// A board that confirms each stop and goes on.
void TestCtlFaults::confirmedStopGoesOnUntilProven()
{
    QFETCH(QString, family);
    QFETCH(QStringList, command);
    SimProcess board({u"--tcp"_s, u"0"_s, u"--fault"_s, u"runs-on=1"_s}, family);
    const QStringList link{u"--link"_s, board.address(), u"--family"_s, family};
    Running stop(m_dir->path(), link + command);
    QTRY_VERIFY2(stop.told().contains(u"still stopping"_s), qPrintable(stop.told()));
    QVERIFY(!stop.printed().contains(u"done"_s));
    board.process().write("runs-on=0\n");
    const Run run = stop.finish(60000);
    QVERIFY2(run.exitCode == 0 && run.out.contains(u"done"_s), qPrintable(run.err + run.out));
    // They are off: nothing that lets go asks for more.
    const QString restart = family == u"storm32"_s ? u"restart"_s : u"reset"_s;
    const Run limp = ctl(link + QStringList{u"do"_s, restart});
    QVERIFY2(limp.exitCode == 0, qPrintable(limp.err));
}

// Its answers come later than anybody waits for, and belong to the questions all the same.
void TestCtlFaults::slowBoardIsStopped()
{
    const QString port = path(u"storm"_s);
    const SimProcess storm({u"--pty"_s, port, u"--fault"_s, u"late=1500"_s}, u"storm32"_s);
    const Run run
        = Running(m_dir->path(), {u"--link"_s, u"serial:"_s + port, u"motors"_s, u"off"_s}).finish(90000);
    QVERIFY2(run.exitCode == 0 && run.out.contains(u"done"_s), qPrintable(run.err + run.out));
}

void TestCtlFaults::endedStopSaysWhatIsOpen_data()
{
    QTest::addColumn<QString>("link");
    QTest::addColumn<QStringList>("options");  // of a board
    QTest::newRow("no port") << u"serial:/dev/gimbal-that-is-not-there"_s << QStringList();
    QTest::newRow("nobody there") << u"tcp://127.0.0.1:9?family=storm32"_s << QStringList();
    QTest::newRow("no answer") << u"?family=storm32"_s << QStringList{u"--fault"_s, u"lose=1"_s};
    QTest::newRow("another kind") << u"?family=storm32"_s << QStringList{u"--firmware"_s, u"2.59"_s};
}

// However a stop ends without proof.
void TestCtlFaults::endedStopSaysWhatIsOpen()
{
    QFETCH(QString, link);
    QFETCH(QStringList, options);
    const QString port = path(u"board"_s);
    std::unique_ptr<SimProcess> board;
    if (!options.isEmpty()) {
        board = std::make_unique<SimProcess>(QStringList{u"--pty"_s, port} + options);
        link.prepend(u"serial:"_s + port);
    }
    for (const QStringList &stop : {QStringList{u"motors"_s, u"off"_s}, {u"do"_s, u"motors.off"_s}}) {
        const Run run
            = Running(m_dir->path(), QStringList{u"--json"_s, u"--link"_s, link} + stop).finish(90000);
        QVERIFY2(run.exitCode == 1, qPrintable(run.err));
        QVERIFY2(run.err.contains(u"nobody has seen the motors stop"_s)
                     && run.err.contains(u"disconnect the power"_s),
                 qPrintable(run.err));
        QVERIFY(run.json().value(u"open"_s).toString().contains(u"nobody has seen"_s));
    }
    QVERIFY(!ctl({u"--link"_s, u"serial:/dev/gimbal-that-is-not-there"_s, u"info"_s})
                 .err.contains(u"nobody has seen"_s));
}

void TestCtlFaults::lostLinkIsNotPromisedBack_data()
{
    QTest::addColumn<QStringList>("command");
    QTest::newRow("monitor") << QStringList{u"monitor"_s};
    QTest::newRow("record") << QStringList{u"record"_s, u"FILE"_s};
    QTest::newRow("calibrate") << QStringList{u"calibrate"_s, u"gyro"_s};
}

// A window connects again by itself; a command has ended.
void TestCtlFaults::lostLinkIsNotPromisedBack()
{
    QFETCH(QStringList, command);
    command.replaceInStrings(u"FILE"_s, path(u"lost.rec"_s));
    const QString port = path(u"board"_s);
    SimProcess board({u"--pty"_s, port});
    Running running(m_dir->path(), QStringList{u"--json"_s, u"--link"_s, u"serial:"_s + port} + command);
    QTRY_VERIFY2(board.streams().all > 50 || running.told().contains(u"alibrat"_s),
                 qPrintable(running.told()));
    board.process().write("replug=-1\nunplug=0\n");
    const Run run = running.finish(60000);
    QCOMPARE(run.exitCode, 1);
    QVERIFY2(run.err.contains(u"run the command again"_s) && !run.err.contains(u"connects again by itself"_s),
             qPrintable(run.err));
    QVERIFY(!run.out.contains(u"connects again by itself"_s));
}

void TestCtlFaults::blockedAxisIsTold_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QStringList>("command");
    QTest::newRow("simplebgc") << u"simplebgc"_s << QStringList{u"steer"_s, u"pitch=30"_s};
    QTest::newRow("storm32") << u"storm32"_s << QStringList{u"angle"_s, u"pitch=20"_s};
}

// The board took the command, and its own target; the camera did not follow.
void TestCtlFaults::blockedAxisIsTold()
{
    QFETCH(QString, family);
    QFETCH(QStringList, command);
    SimProcess board({u"--tcp"_s, u"0"_s}, family);
    const QStringList steer
        = QStringList{u"--link"_s, board.address(), u"--family"_s, family, u"do"_s} + command;
    const Run free = ctl(steer);
    QVERIFY2(free.exitCode == 0, qPrintable(free.err));
    QCOMPARE(ctl(steer.first(steer.size() - 1) + QStringList{u"pitch=0"_s}).exitCode, 0);
    board.process().write("blocked=2\n");
    const Run run = ctl(steer);
    QVERIFY2(run.exitCode == 1, qPrintable(u"%1: %2%3"_s.arg(run.exitCode).arg(run.out, run.err)));
    QVERIFY2(run.err.contains(u"pitch: target "_s) && run.err.contains(u"camera at"_s), qPrintable(run.err));
}

void TestCtlFaults::missingSensorIsNotCalibrated_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QStringList>("command");
    QTest::newRow("simplebgc, gyroscope") << u"simplebgc"_s << QStringList{u"calibrate"_s, u"gyro"_s};
    QTest::newRow("simplebgc, accelerometer") << u"simplebgc"_s << QStringList{u"calibrate"_s, u"acc"_s};
    QTest::newRow("simplebgc, auto-tune") << u"simplebgc"_s << QStringList{u"autotune"_s};
    QTest::newRow("simplebgc, measure")
        << u"simplebgc"_s << QStringList{u"measure"_s, u"steps"_s, u"pitch"_s};
    QTest::newRow("storm32, level") << u"storm32"_s << QStringList{u"calibrate"_s, u"level"_s};
    QTest::newRow("storm32, six") << u"storm32"_s << QStringList{u"calibrate"_s, u"six"_s, u"--confirmed"_s};
    QTest::newRow("storm32, measure") << u"storm32"_s << QStringList{u"measure"_s, u"steps"_s, u"pitch"_s};
}

// No figures, and no success, from a sensor that is not there.
void TestCtlFaults::missingSensorIsNotCalibrated()
{
    QFETCH(QString, family);
    QFETCH(QStringList, command);
    const SimProcess board({u"--tcp"_s, u"0"_s, u"--fault"_s, u"no-imu=1"_s}, family);
    const Run run = ctl(QStringList{u"--link"_s, board.address(), u"--family"_s, family} + command);
    QVERIFY2(run.exitCode == 1, qPrintable(run.err + run.out));
    QVERIFY2(run.out.isEmpty(), qPrintable(run.out));
}

void TestCtlFaults::slowLinesThinOut_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QString>("firmware");
    QTest::addColumn<QString>("channels");
    QTest::newRow("simplebgc") << u"simplebgc"_s << u"2.59"_s << u"imu.angle.roll,gyro.roll"_s;
    QTest::newRow("simplebgc, polled") << u"simplebgc"_s << u"2.43b9"_s << u"imu.angle.roll"_s;
    QTest::newRow("storm32") << u"storm32"_s << u"0.96"_s << u"imu.angle.roll"_s;
}

void TestCtlFaults::slowLinesThinOut()
{
    QFETCH(QString, family);
    QFETCH(QString, firmware);
    QFETCH(QString, channels);
    SimProcess simulator({u"--pty"_s, path(u"board"_s), u"--rate"_s, u"9600"_s, u"--firmware"_s, firmware},
                         family);
    const Run run = ctl({u"--family"_s, family, u"--link"_s, u"serial:%1?baud=9600"_s.arg(path(u"board"_s)),
                         u"monitor"_s, u"--channels"_s, channels, u"--seconds"_s, u"2"_s});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    QVERIFY2(run.err.contains(u"The line is slow"_s), qPrintable(run.err));
    // Nothing is lost, unless this machine stood still for a while, which is told: an answer for each time
    // that one is waited for.
    static const QRegularExpression counts(u"([0-9]+) rows, ([0-9]+) lost, [^\n]*?"
                                           "(?:nothing came (once|[0-9]+ times), [^\n]*?([0-9.]+) s|\n)"_s);
    constexpr double kAnswerIsAwaited = 0.3;  // s
    const auto counted = counts.match(run.err);
    QVERIFY2(counted.hasMatch(), qPrintable(run.err));
    const QString holes = counted.captured(3);
    const int stood = holes.isEmpty() ? 0 : holes == u"once"_s ? 1 : holes.section(u' ', 0, 0).toInt();
    const double most = stood + counted.captured(4).toDouble() / kAnswerIsAwaited;
    QVERIFY2(counted.captured(2).toInt() <= most, qPrintable(run.err));
    QVERIFY(run.out.count(u'\n') > 8);
}

void TestCtlFaults::steeringEndsWithTheCommand_data()
{
    QTest::addColumn<int>("signal");
    QTest::newRow("Ctrl-C") << SIGINT;
    QTest::newRow("terminated") << SIGTERM;
    QTest::newRow("terminal closed") << SIGHUP;
}

// In the mode of speeds the board turns until it is told otherwise.
void TestCtlFaults::steeringEndsWithTheCommand()
{
    QFETCH(int, signal);
    const SimProcess simulator({u"--tcp"_s, u"0"_s});
    const QStringList link{u"--link"_s, simulator.address()};
    const QStringList steer{u"do"_s, u"steer"_s, u"mode=speed"_s, u"yaw=10"_s, u"seconds=60"_s};
    {
        Running running(m_dir->path(), link + steer);
        QTRY_VERIFY2(running.told().contains(u"steer"_s, Qt::CaseInsensitive), qPrintable(running.told()));
        ::kill(pid_t(running.id()), signal);
        const Run run = running.finish();
        QCOMPARE(run.exitCode, 1);
        QVERIFY2(!run.err.contains(u"go on moving"_s), qPrintable(run.err));
    }
    const auto target = [&] {
        return ctl(link + QStringList{u"--json"_s, u"do"_s, u"angles"_s})
            .json()
            .value(u"reply"_s)
            .toObject()
            .value(u"target.yaw"_s)
            .toDouble(std::nan(""));
    };
    const double before = target();
    const double after = target();  // it takes longer than to find the board
    QVERIFY2(std::abs(after - before) < 1.5, qPrintable(u"%1 -> %2"_s.arg(before).arg(after)));
}

void TestCtlFaults::silenceWhileSteeringIsTold()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s});
    Running running(m_dir->path(),
                    {u"--link"_s, simulator.address(), u"do"_s, u"steer"_s, u"mode=speed"_s, u"yaw=10"_s,
                     u"seconds=3"_s});
    QTRY_VERIFY2(running.told().contains(u"steer"_s, Qt::CaseInsensitive), qPrintable(running.told()));
    ::kill(pid_t(simulator.process().processId()), SIGSTOP);
    const Run run = running.finish(30000);
    ::kill(pid_t(simulator.process().processId()), SIGCONT);
    QCOMPARE(run.exitCode, 1);
    QVERIFY2(run.err.contains(u"may go on moving"_s) && run.err.contains(u"motors off"_s),
             qPrintable(run.err));
}

void TestCtlFaults::steeringUnseenIsNoSuccess_data()
{
    QTest::addColumn<QString>("firmware");
    QTest::newRow("its stamps stand still") << u"2.59"_s;
    QTest::newRow("its values stand still") << u"2.40"_s;
}

// It answers all the time, and what it tells is old.
void TestCtlFaults::steeringUnseenIsNoSuccess()
{
    QFETCH(QString, firmware);
    SimProcess simulator({u"--tcp"_s, u"0"_s, u"--firmware"_s, firmware});
    Running running(m_dir->path(),
                    {u"--link"_s, simulator.address(), u"--json"_s, u"do"_s, u"steer"_s, u"mode=angle"_s,
                     u"roll=0"_s, u"pitch=0"_s, u"yaw=0"_s, u"seconds=15"_s});
    QTRY_VERIFY2(running.told().contains(u"steer"_s, Qt::CaseInsensitive), qPrintable(running.told()));
    simulator.process().write("frozen=1\n");
    const Run run = running.finish();
    const QString told = u"alarm: No new live data"_s;
    QVERIFY2(run.exitCode == 1 && run.err.contains(told), qPrintable(run.err));
    QVERIFY2(!run.json().value(u"alarms"_s).toArray().isEmpty(), qPrintable(run.out));
}

void TestCtlFaults::alarmsAreToldAndActedOn_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QString>("fault");
    QTest::addColumn<QString>("told");
    QTest::addColumn<QStringList>("wanted");
    QTest::addColumn<bool>("ends");  // motors off
    const QString swapped = u"the axes are swapped"_s;
    const QString sensor = u"does not see its motion sensor"_s;
    for (const QString &family : {u"simplebgc"_s, u"storm32"_s}) {
        const auto add = [&family](const char *name, const QString &fault, const QString &told,
                                   const QStringList &wanted, bool ends) {
            QTest::addRow("%s, %s", qPrintable(family), name) << family << fault << told << wanted << ends;
        };
        const QString alarm = u"--alarm"_s;
        add("runaway", u"swapped-axes=1"_s, swapped, {}, true);
        add("runaway, warn", u"swapped-axes=1"_s, swapped, {alarm, u"runaway=warn"_s}, false);
        add("battery", u"battery=10.1"_s, u"battery"_s, {}, false);
        add("battery, off", u"battery=10.1"_s, u"battery"_s,
            {alarm, u"sensor=off"_s, alarm, u"battery=off"_s}, true);
        add("sensor", u"no-imu=1"_s, sensor, {}, false);
        add("sensor, off", u"no-imu=1"_s, sensor, {alarm, u"sensor=off"_s}, true);
    }
}

// The supervisor works without a screen as well, while a command runs.
void TestCtlFaults::alarmsAreToldAndActedOn()
{
    QFETCH(QString, family);
    QFETCH(QString, fault);
    QFETCH(QString, told);
    QFETCH(QStringList, wanted);
    QFETCH(bool, ends);
    SimProcess simulator({u"--tcp"_s, u"0"_s}, family);
    Running running(m_dir->path(),
                    QStringList{u"--family"_s, family, u"--link"_s, simulator.address(), u"monitor"_s,
                                u"--seconds"_s, u"60"_s}
                        + wanted);
    QVERIFY(QTest::qWaitFor([&] { return running.printed().count(u'\n') > 200; }, kPatience));
    simulator.process().write(fault.toUtf8() + '\n');
    QVERIFY2(QTest::qWaitFor(
                 [&] { return running.told().contains(told) && running.told().contains(u"alarm: "_s); },
                 kPatience),
             qPrintable(running.told()));
    if (ends)
        QVERIFY2(QTest::qWaitFor([&] { return running.told().contains(u"The motors were switched off."_s); },
                                 kPatience),
                 qPrintable(running.told()));
    else
        QVERIFY(!running.told().contains(u"switched off"_s));
}

// A stop that is proven too late for the first word is told once it is.
void TestCtlFaults::lateStopIsToldOnceProven()
{
    SimProcess simulator({u"--tcp"_s, u"0"_s});
    Running running(m_dir->path(),
                    {u"--family"_s, u"simplebgc"_s, u"--link"_s, simulator.address(), u"monitor"_s,
                     u"--alarm"_s, u"sensor=off"_s});
    QVERIFY(QTest::qWaitFor([&] { return running.printed().count(u'\n') > 200; }, kPatience));
    simulator.process().write("late=3000\nno-imu=1\n");
    const auto isTold = [&](const QString &words) {
        return QTest::qWaitFor([&] { return running.told().contains(words); }, kPatience);
    };
    QVERIFY2(isTold(u"nothing proves that they did"_s), qPrintable(running.told()));
    simulator.process().write("late=0\n");
    QVERIFY2(isTold(u"The motors were switched off."_s), qPrintable(running.told()));
}

QTEST_GUILESS_MAIN(TestCtlFaults)
#include "tst_ctlfaults.moc"
