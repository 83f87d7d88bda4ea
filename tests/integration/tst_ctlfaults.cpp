// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/ctlrun.h"
#include "tests/support/simprocess.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <cmath>
#include <csignal>

using namespace Qt::StringLiterals;

/// gimbalctl against boards and files that fail: it ends, says so, and keeps what it has.
class TestCtlFaults : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_dir = std::make_unique<QTemporaryDir>(); }
    void silenceEndsIt_data();
    void silenceEndsIt();
    void nothingIsNoSuccess_data();
    void nothingIsNoSuccess();
    void recordingsEndWithoutSilence();
    void damagedRecordingIsReadPastTheDamage();
    void tooFewSamplesAreNoWrongArgument_data();
    void tooFewSamplesAreNoWrongArgument();
    void lostLinkInAWriteIsReadAgain_data();
    void lostLinkInAWriteIsReadAgain();
    void streamsOfAKilledProgramAreStopped();
    void slowLinesThinOut_data();
    void slowLinesThinOut();

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
        20000));
    ::kill(pid_t(simulator.process().processId()), SIGSTOP);
    const Run run = running.finish(20000);
    ::kill(pid_t(simulator.process().processId()), SIGCONT);
    QCOMPARE(run.exitCode, 1);
    for (const QString &part : {u"No live data come."_s, u"Check cable and power"_s, u"nothing more for"_s})
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
    QCOMPARE(ctl({u"--link"_s, simulator.address(), u"record"_s, file, u"--seconds"_s, u"2"_s}).exitCode, 0);
    QFile stored(file);
    QVERIFY(stored.open(QIODevice::ReadWrite));
    const QByteArray whole = stored.readAll();
    const Run before = ctl({u"export"_s, file});
    QCOMPARE(before.exitCode, 0);
    const auto lastLine = [](const QString &csv) { return csv.trimmed().section(u'\n', -1); };
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
        // Behind the damage, at its own time; times of arrival are smoothed, so the last digit may differ.
        const QString last = lastLine(rows);
        const QString undamaged = lastLine(before.out);
        QCOMPARE(last.section(u',', 1), undamaged.section(u',', 1));
        QVERIFY2(std::abs(last.section(u',', 0, 0).toDouble() - undamaged.section(u',', 0, 0).toDouble())
                     < 1e-4,
                 qPrintable(last));
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
    QVERIFY2(run.exitCode == 1, qPrintable(run.err));
    QVERIFY2(run.err.contains(u"waiting for the board"_s), qPrintable(run.err));
    QVERIFY(!run.err.contains(u"Nothing was changed"_s));
    const QJsonObject json = run.json();
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
void TestCtlFaults::streamsOfAKilledProgramAreStopped()
{
    SimProcess simulator({u"--pty"_s, path(u"board"_s)});
    const QStringList link{u"--link"_s, u"serial:"_s + path(u"board"_s)};
    for (const QString &channels : {u"imu.angle.roll,gyro.roll"_s, u"target.angle.yaw,gyro.roll"_s}) {
        Running running(m_dir->path(), link + QStringList{u"monitor"_s, u"--channels"_s, channels});
        QVERIFY(QTest::qWaitFor([&] { return running.printed().count(u'\n') > 50; }, 20000));
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
    QVERIFY(run.out.count(u'\n') > 8);
    QVERIFY2(run.err.contains(u" 0 lost"_s), qPrintable(run.err));
}

QTEST_GUILESS_MAIN(TestCtlFaults)
#include "tst_ctlfaults.moc"
