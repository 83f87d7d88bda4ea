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
    [[nodiscard]] QJsonObject reply() const
    {
        return QJsonDocument::fromJson(out.toUtf8()).object().value(u"reply"_s).toObject();
    }
};

void put(const QString &path, const QByteArray &content)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qFatal("no file");
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

/// gimbalctl on all that a SimpleBGC board keeps and hears besides its settings.
class TestCtlBoard : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        m_dir = std::make_unique<QTemporaryDir>();
        m_simulator
            = std::make_unique<SimProcess>(QStringList{u"--tcp"_s, u"0"_s, u"--firmware"_s, u"2.70.4"_s});
        QVERIFY(!m_simulator->address().isEmpty());
    }
    void cleanup() { m_simulator.reset(); }
    void wholeBoardComesBack();
    void copyOverALineThatBreaks();
    void copyOfAnotherBoard();
    void filesComeBack();
    void allFilesAreErased();
    void calibrationsComeBack();
    void scriptsAreLoadedRunAndErased();
    void feedSendsRows();
    void busesAreSearchedReadAndWritten();

private:
    Run ctl(const QStringList &arguments)
    {
        QProcess process;
        process.start(QStringLiteral(GIMBAL_BIN_DIR "/gimbalctl"),
                      QStringList{u"--history"_s, path("history"), u"--link"_s, m_simulator->address()}
                          + arguments);
        if (!QTest::qWaitFor([&process] { return process.state() == QProcess::NotRunning; }, kPatience))
            process.kill();
        return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
                QString::fromUtf8(process.readAllStandardError())};
    }
    Run perform(const QStringList &words) { return ctl(QStringList{u"--json"_s, u"do"_s} + words); }
    [[nodiscard]] QString path(const char *name) const { return m_dir->filePath(QLatin1String(name)); }
    [[nodiscard]] QString file(const char *name) const { return u"file="_s + path(name); }
    void load(const QString &type, const QString &number, const QByteArray &content)
    {
        put(path("one"), content);
        QCOMPARE(
            perform({u"file.load"_s, u"type="_s + type, u"number="_s + number, file("one"), u"--confirmed"_s})
                .exitCode,
            0);
    }

    std::unique_ptr<QTemporaryDir> m_dir;
    std::unique_ptr<SimProcess> m_simulator;
};

#define DONE(run) QVERIFY2((run).exitCode == 0, qPrintable((run).err))
#define REFUSED(run, words) QVERIFY2((run).exitCode != 0 && (run).err.contains(words), qPrintable((run).err))

void TestCtlBoard::wholeBoardComesBack()
{
    load(u"script"_s, u"1"_s, QByteArray(300, 's'));
    const Run saved = perform({u"memory.save"_s, file("a")});
    DONE(saved);
    QCOMPARE(saved.reply().value(u"bytes"_s).toInt(), 32768);
    QCOMPARE(saved.reply().value(u"files"_s).toInt(), 1);
    DONE(ctl({u"set"_s, u"motor.pitch.power=99"_s}));
    load(u"script"_s, u"1"_s, "other");
    load(u"script"_s, u"3"_s, "more");
    const Run told = perform({u"memory.compare"_s, file("a")});
    DONE(told);
    QCOMPARE(told.reply().value(u"profile 1: motor.pitch.power"_s).toString(), u"150 -> 99"_s);
    QCOMPARE(told.reply().value(u"script 3"_s).toString(), u"none -> 4 bytes"_s);
    DONE(perform({u"memory.save"_s, file("b")}));
    const Run files = ctl({u"diff"_s, path("a"), path("b")});
    DONE(files);
    QVERIFY2(files.out.contains(u"script 1         differs: 300 bytes -> 5 bytes"_s), qPrintable(files.out));
    REFUSED(perform({u"memory.restore"_s, file("a")}), u"--confirmed"_s);
    const Run restored = perform({u"memory.restore"_s, file("a"), u"--confirmed"_s});
    DONE(restored);
    QCOMPARE(restored.reply().value(u"files_changed"_s).toInt(), 2);
    DONE(perform({u"memory.save"_s, file("b")}));
    QCOMPARE(contentOf(path("b")), contentOf(path("a")));
}

void TestCtlBoard::copyOverALineThatBreaks()
{
    DONE(perform({u"memory.save"_s, file("whole")}));
    const QString address = u"sim:simplebgc?firmware=2.70.4&unplug=0.8&replug=-1"_s;
    QProcess process;
    process.start(
        QStringLiteral(GIMBAL_BIN_DIR "/gimbalctl"),
        {u"--history"_s, path("history"), u"--link"_s, address, u"do"_s, u"memory.save"_s, file("a")});
    QVERIFY(QTest::qWaitFor([&process] { return process.state() == QProcess::NotRunning; }, kPatience));
    const QString said = QString::fromUtf8(process.readAllStandardError());
    QVERIFY2(process.exitCode() != 0 && !said.isEmpty(), qPrintable(said));
    QVERIFY(!QFile::exists(path("a")));
    DONE(perform({u"memory.save"_s, file("a")}));
    QCOMPARE(contentOf(path("a")), contentOf(path("whole")));
    QVERIFY(!QFile::exists(path("a.part")));
}

void TestCtlBoard::copyOfAnotherBoard()
{
    DONE(perform({u"memory.save"_s, file("a")}));
    put(path("a"), contentOf(path("a")).replace("\"serial\":\"", "\"serial\":\"99"));
    REFUSED(perform({u"memory.restore"_s, file("a"), u"--confirmed"_s}), u"part=settings"_s);
    const Run settings = perform({u"memory.restore"_s, file("a"), u"part=settings"_s, u"--confirmed"_s});
    DONE(settings);
    QVERIFY(!settings.reply().value(u"found"_s).toString().isEmpty());
    DONE(perform({u"memory.restore"_s, file("a"), u"other=on"_s, u"--confirmed"_s}));
    put(path("a"), contentOf(path("a")).chopped(1));
    REFUSED(perform({u"memory.restore"_s, file("a"), u"--confirmed"_s}), u"a"_s);
}

void TestCtlBoard::filesComeBack()
{
    const QStringList one{u"type=script"_s, u"number=2"_s};
    const QByteArray content(500, 'y');
    put(path("script"), content);
    REFUSED(perform(QStringList{u"file.save"_s} + one + QStringList{file("none")}), u"file not found"_s);
    QVERIFY(!QFile::exists(path("none")));
    REFUSED(perform(QStringList{u"file.load"_s} + one + QStringList{file("script")}), u"--confirmed"_s);
    DONE(perform(QStringList{u"file.load"_s} + one + QStringList{file("script"), u"--confirmed"_s}));
    DONE(perform(QStringList{u"file.save"_s} + one + QStringList{file("back")}));
    QCOMPARE(contentOf(path("back")), content);
    put(path("large"), QByteArray(65000, 'z'));
    DONE(perform({u"file.load"_s, u"type=tuning"_s, u"number=0"_s, file("large"), u"--confirmed"_s}));
    REFUSED(perform({u"file.load"_s, u"type=tuning"_s, u"number=1"_s, file("large"), u"--confirmed"_s}),
            u"no free space"_s);
    DONE(perform(QStringList{u"file.erase"_s} + one + QStringList{u"--confirmed"_s}));
    REFUSED(perform(QStringList{u"file.save"_s} + one + QStringList{file("none")}), u"file not found"_s);
}

void TestCtlBoard::allFilesAreErased()
{
    load(u"script"_s, u"1"_s, "abc");
    REFUSED(perform({u"file.erase_all"_s, file("a")}), u"--confirmed"_s);
    DONE(perform({u"file.erase_all"_s, file("a"), u"--confirmed"_s}));
    REFUSED(perform({u"file.erase_all"_s, file("a"), u"--confirmed"_s}), u"there already"_s);
    DONE(perform({u"memory.save"_s, file("b")}));
    QVERIFY(!contentOf(path("b")).contains("script 1"));
    DONE(perform({u"memory.restore"_s, file("a"), u"--confirmed"_s}));
    DONE(perform({u"file.save"_s, u"type=script"_s, u"number=1"_s, file("back")}));
    QCOMPARE(contentOf(path("back")), QByteArray("abc"));
}

void TestCtlBoard::calibrationsComeBack()
{
    DONE(ctl({u"calibrate"_s, u"gyro"_s}));
    DONE(perform({u"calibration.save"_s, file("a")}));
    const Run same = perform({u"calibration.compare"_s, file("a")});
    DONE(same);
    QCOMPARE(same.reply().value(u"files_differing"_s).toInt(-1), 0);
    DONE(ctl({u"calibrate"_s, u"gyro"_s}));
    const Run told = perform({u"calibration.compare"_s, file("a")});
    DONE(told);
    QCOMPARE(told.reply().value(u"imu-calibration 0"_s).toString(), u"36 bytes -> 36 bytes"_s);
    DONE(perform({u"calibration.restore"_s, file("a"), u"--confirmed"_s}));
    QCOMPARE(perform({u"calibration.compare"_s, file("a")}).reply().value(u"files_differing"_s).toInt(-1), 0);
}

void TestCtlBoard::scriptsAreLoadedRunAndErased()
{
    const auto scripts = [this](const QStringList &words) {
        return ctl(QStringList{u"--json"_s, u"scripts"_s} + words);
    };
    const auto slot = [&scripts](int number) {
        const QJsonDocument told = QJsonDocument::fromJson(scripts({u"list"_s}).out.toUtf8());
        return told.object().value(u"slots"_s).toArray().at(number - 1).toObject();
    };
    put(path("new"), QByteArray(30, 'x'));
    DONE(scripts({u"load"_s, u"2"_s, path("new")}));
    QCOMPARE(slot(2).value(u"bytes"_s).toInt(), 30);
    QCOMPARE(slot(10).value(u"bytes"_s).toInt(), 0);
    DONE(scripts({u"save"_s, u"2"_s, path("back")}));
    QCOMPARE(contentOf(path("back")), QByteArray(30, 'x'));
    // Nobody knows what it does.
    REFUSED(scripts({u"run"_s, u"2"_s}), u"--confirmed"_s);
    const Run followed = ctl({u"scripts"_s, u"run"_s, u"2"_s, u"--follow"_s, u"--confirmed"_s});
    DONE(followed);
    QVERIFY2(followed.err.contains(u"Script 2 runs: command 7"_s), qPrintable(followed.err));
    QVERIFY2(followed.out.contains(u"command              30"_s), qPrintable(followed.out));
    put(path("long"), QByteArray(600, 'x'));
    DONE(scripts({u"load"_s, u"2"_s, path("long")}));
    const Run begun = scripts({u"run"_s, u"2"_s, u"--confirmed"_s});
    DONE(begun);
    QVERIFY2(begun.reply().value(u"running"_s).toBool(), qPrintable(begun.out));
    const Run stopped = scripts({u"stop"_s});
    DONE(stopped);
    QVERIFY2(stopped.reply().value(u"stopped"_s).toBool(), qPrintable(stopped.out));
    const Run erased = ctl({u"scripts"_s, u"erase"_s, u"2"_s});
    DONE(erased);
    QVERIFY2(erased.err.contains(u"what was in the slot: "_s), qPrintable(erased.err));
    QCOMPARE(contentOf(slot(2).value(u"kept"_s).toString()), QByteArray(600, 'x'));
    DONE(scripts({u"load"_s, u"2"_s, slot(2).value(u"kept"_s).toString()}));
    QCOMPARE(slot(2).value(u"bytes"_s).toInt(), 600);
    REFUSED(scripts({u"run"_s, u"3"_s, u"--confirmed"_s}), u"slot 3 holds no script"_s);
    REFUSED(scripts({u"load"_s, u"11"_s, path("new")}), u"slots 1 to 10"_s);
    QCOMPARE(scripts({u"load"_s, u"2"_s}).exitCode, 2);
    QCOMPARE(scripts({u"compile"_s, u"2"_s}).exitCode, 2);
}

void TestCtlBoard::feedSendsRows()
{
    put(path("gyro.csv"), "time,imu,zero.x,zero.y,zero.z,heading\n0,main,0.1,0,0,0\n0.1,main,0,0,0,0\n");
    const Run run = ctl({u"--json"_s, u"feed"_s, u"gyro"_s, path("gyro.csv")});
    DONE(run);
    QCOMPARE(run.reply().value(u"rows"_s).toInt(), 2);
    QVERIFY(run.out.contains(u"\"sent\""_s));
    put(path("wrong.csv"), "time,imu,nothing\n0,main,1\n");
    REFUSED(ctl({u"feed"_s, u"gyro"_s, path("wrong.csv")}), u"nothing"_s);
    REFUSED(ctl({u"feed"_s, u"gyro"_s, path("none.csv")}), u"none.csv"_s);
    REFUSED(ctl({u"feed"_s, u"magic"_s, path("gyro.csv")}), u"helper"_s);
    REFUSED(ctl({u"feed"_s, u"gyro"_s}), u"feed needs"_s);
}

void TestCtlBoard::busesAreSearchedReadAndWritten()
{
    const Run found = perform({u"i2c.scan"_s});
    DONE(found);
    QCOMPARE(found.reply().value(u"devices"_s).toString(), u"0x68"_s);
    const QStringList place{u"device=104"_s, u"register=117"_s};
    const Run read = perform(QStringList{u"i2c.read"_s} + place);
    DONE(read);
    QCOMPARE(read.reply().value(u"data"_s).toString(), u"68"_s);
    REFUSED(perform({u"i2c.read"_s, u"device=32"_s, u"register=0"_s}), u"operation failed"_s);
    const QStringList write{u"i2c.write"_s, u"device=104"_s, u"register=118"_s, u"data=03"_s};
    REFUSED(perform(write), u"--confirmed"_s);
    const Run written = perform(write + QStringList{u"--confirmed"_s});
    DONE(written);
    QCOMPARE(written.reply().value(u"before"_s).toString(), u"00"_s);
    QCOMPARE(written.reply().value(u"now"_s).toString(), u"03"_s);
    QCOMPARE(perform({u"i2c.read"_s, u"device=104"_s, u"register=118"_s}).reply().value(u"data"_s).toString(),
             u"03"_s);
    // The memory is not written that way.
    REFUSED(perform({u"i2c.write"_s, u"bus=internal"_s, u"device=80"_s, u"register=0"_s, u"data=00"_s,
                     u"--confirmed"_s}),
            u"memory.restore"_s);
}

QTEST_GUILESS_MAIN(TestCtlBoard)
#include "tst_ctlboard.moc"
