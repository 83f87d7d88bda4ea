// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/ctlrun.h"
#include "tests/support/simprocess.h"

#include <QElapsedTimer>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <array>
#include <csignal>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

using namespace Qt::StringLiterals;

/// The guided set-up of the command line, on an unpacked gimbal in its own process.
class TestCtlSetup final : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_dir = std::make_unique<QTemporaryDir>(); }
    void anUnpackedGimbalIsTuned();
    void wrongWordsAreTold_data();
    void wrongWordsAreTold();
    void aStepThatFailsIsKept();
    void boardsWithoutItSaySo();
    void figuresAreShownLive();
    void onATerminalTheyStayInOneLine();
    void interruptedItIsDoneAgain();

private:
    Run setup(const QString &link, const QStringList &words)
    {
        return Running(m_dir->path(), QStringList{u"--link"_s, link, u"--json"_s, u"setup"_s} + words)
            .finish(4 * kPatience);
    }

    /// The step “Remote control”, with sticks that are moved as it is told.
    Run moveSticks(SimProcess &gimbal)
    {
        constexpr std::array kTold{std::pair("Let go", 0),      std::pair("let go of", 0),
                                   std::pair("Roll: move", 1),  std::pair("the stick for roll", 1),
                                   std::pair("Pitch: move", 3), std::pair("the stick for pitch", 3),
                                   std::pair("Yaw: move", 5),   std::pair("the stick for yaw", 5),
                                   std::pair("moves: now", -1)};
        Running running(
            m_dir->path(),
            {u"--link"_s, gimbal.address(), u"--json"_s, u"setup"_s, u"remote"_s, u"--confirmed"_s});
        qsizetype last = -1;
        int stick = 0;
        const auto obey = [&] {
            const QString told = running.told();
            const qsizetype before = last;
            int wanted = stick;
            for (const auto &[words, which] : kTold) {
                const qsizetype at = told.lastIndexOf(QLatin1String(words));
                if (at > last) {
                    last = at;
                    wanted = which < 0 ? stick + stick % 2 : which;
                }
            }
            if (last > before && std::exchange(stick, wanted) != wanted)
                gimbal.process().write("stick=" + QByteArray::number(stick) + "\n");
            return !running.isRunning();
        };
        std::ignore = QTest::qWaitFor(obey, 4 * kPatience);
        return running.finish();
    }

    std::unique_ptr<QTemporaryDir> m_dir;
};

// Counted are commands and minutes: what the way costs.
void TestCtlSetup::anUnpackedGimbalIsTuned()
{
    SimProcess gimbal({u"--tcp"_s, u"0"_s, u"--condition"_s, u"new"_s});
    const QString link = gimbal.address();
    const auto world = [&gimbal](const char *line) {
        gimbal.process().write(line);
        gimbal.process().write("\n");
    };
    QElapsedTimer clock;
    clock.start();
    int commands = 0;
    const auto step = [&](const QStringList &words, const QString &state, int exitCode = 0) {
        ++commands;
        const Run run = setup(link, words);
        const bool fits = run.exitCode == exitCode && run.json().value(u"state"_s).toString() == state;
        if (!fits)
            qWarning("%s: %d\n%s\n%s", qPrintable(words.join(u' ')), run.exitCode, qPrintable(run.out),
                     qPrintable(run.err));
        return fits;
    };
    // It runs wild, as its sensor sits otherwise than it is told.
    world("hand=1");
    ++commands;
    QCOMPARE(Running(m_dir->path(), {u"--link"_s, link, u"motors"_s, u"off"_s}).finish().exitCode, 0);
    QVERIFY(step({u"power"_s}, u"done"_s));
    QVERIFY(step({u"sensors"_s}, u"done"_s));
    QVERIFY(step({u"gyroscope"_s, u"--confirmed"_s}, u"done"_s));
    // Tilts it as it is told to.
    Running tilting(m_dir->path(),
                    {u"--link"_s, link, u"--json"_s, u"setup"_s, u"orientation"_s, u"--confirmed"_s});
    ++commands;
    const auto lastTold = [&tilting] {
        const QString told = tilting.told();
        const std::array places{told.lastIndexOf(u"Hold the camera level"_s),
                                told.lastIndexOf(u"Tilt the nose"_s), told.lastIndexOf(u"Tilt the right"_s)};
        return int(std::max_element(places.begin(), places.end()) - places.begin());
    };
    constexpr std::array kHands{"hand=1", "hand=3", "hand=4"};
    int now = -1;
    const bool isOver = QTest::qWaitFor(
        [&] {
            if (const int told = lastTold(); std::exchange(now, told) != told)
                world(kHands[std::size_t(told)]);
            return !tilting.isRunning();
        },
        4 * kPatience);
    QVERIFY2(isOver, qPrintable(tilting.told()));
    const Run tilted = tilting.finish();
    QVERIFY2(tilted.exitCode == 0 && tilted.out.contains(u"orientation.set"_s),
             qPrintable(tilted.out + tilted.err));
    world("hand=1");
    QVERIFY(step({u"level"_s, u"--confirmed"_s}, u"done"_s));
    // Lets go when it is told to.
    const auto balance = [&] {
        Running running(m_dir->path(),
                        {u"--link"_s, link, u"--json"_s, u"setup"_s, u"balance"_s, u"--confirmed"_s});
        ++commands;
        world("hand=1");
        if (!QTest::qWaitFor([&] { return running.told().contains(u"tip it lightly"_s); }, kPatience))
            qWarning("%s", qPrintable(running.told()));
        world("hand=0");
        return running.finish();
    };
    world("shake=0");
    const Run unbalanced = balance();
    QVERIFY2(unbalanced.exitCode == 1, qPrintable(unbalanced.out + unbalanced.err));
    QCOMPARE(unbalanced.json().value(u"state"_s).toString(), u"poor"_s);
    world("imbalance=5");
    const Run balanced = balance();
    QVERIFY2(balanced.exitCode == 0, qPrintable(balanced.out + balanced.err));
    world("shake=1");
    QVERIFY(step({u"motors"_s, u"--confirmed"_s}, u"done"_s));
    QVERIFY(step({u"motor-power"_s, u"--confirmed"_s}, u"done"_s));
    // The board's own search may leave an axis that rings, which is said.
    const Run gains = setup(link, {u"gains"_s});
    ++commands;
    QVERIFY2(gains.exitCode == 0 || gains.out.contains(u"gains.shakes"_s), qPrintable(gains.out + gains.err));
    const Run vibration = setup(link, {u"vibration"_s});
    ++commands;
    QVERIFY2(vibration.out.contains(u"shakes.roll"_s)
                 && (vibration.exitCode == 0 || vibration.out.contains(u"vibration.strong"_s)),
             qPrintable(vibration.out + vibration.err));
    world("hand=2");
    QVERIFY(step({u"limits"_s, u"--confirmed"_s}, u"done"_s));
    world("hand=1");
    ++commands;
    const Run sticks = moveSticks(gimbal);
    QVERIFY2(sticks.exitCode == 0 && sticks.out.contains(u"remote.set"_s),
             qPrintable(sticks.out + sticks.err));
    world("hand=0");
    QVERIFY(step({u"use"_s, u"use=handheld"_s, u"apply=on"_s}, u"done"_s));
    const QString page = m_dir->filePath(u"certificate.html"_s);
    const Run last = setup(link, {u"--certificate"_s, page});
    QVERIFY2(last.exitCode == 0, qPrintable(last.err));
    QFile file(page);
    QVERIFY(file.open(QFile::ReadOnly));
    const QString text = QString::fromUtf8(file.readAll());
    for (const QString &part : {u"Gains: "_s, u"Vibrates · Roll"_s, u"° RMS"_s})
        QVERIFY2(text.contains(part), qPrintable(text));
    QVERIFY(!text.contains(u"left out<"_s));
    const QString data = m_dir->filePath(u"certificate.json"_s);
    QCOMPARE(setup(link, {u"--certificate"_s, data}).exitCode, 0);
    QFile steps(data);
    QVERIFY(steps.open(QFile::ReadOnly));
    const QJsonObject told = QJsonDocument::fromJson(steps.readAll()).object().value(u"steps"_s).toObject();
    QCOMPARE(told.value(u"gains"_s).toObject().value(u"state"_s).toString(),
             gains.exitCode ? u"poor"_s : u"done"_s);
    QVERIFY(step({u"use"_s, u"--skip"_s}, u"skipped"_s));
    const QString shorter = m_dir->filePath(u"shorter.html"_s);
    QCOMPARE(setup(link, {u"--certificate"_s, shorter}).exitCode, 0);
    QFile skipped(shorter);
    QVERIFY(skipped.open(QFile::ReadOnly));
    QVERIFY(skipped.readAll().contains("Use: left out"));
    qInfo("from the box to the certificate: %d commands, %.1f minutes", commands + 1,
          double(clock.elapsed()) / 60000);
    // The board itself holds it.
    const Run poles = Running(m_dir->path(), {u"--link"_s, link, u"get"_s, u"motor.pitch.poles"_s}).finish();
    QVERIFY2(poles.out.contains(u"14"_s), qPrintable(poles.out));
}

void TestCtlSetup::wrongWordsAreTold_data()
{
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QString>("says");
    QTest::newRow("no such step") << QStringList{u"polish"_s} << u"there is no step 'polish'"_s;
    QTest::newRow("nothing to skip") << QStringList{u"--skip"_s} << u"the step to leave out"_s;
    QTest::newRow("not confirmed") << QStringList{u"motors"_s} << u"--confirmed"_s;
    QTest::newRow("no such answer") << QStringList{u"power"_s, u"colour=red"_s} << u"colour"_s;
    QTest::newRow("out of range") << QStringList{u"power"_s, u"cells=99"_s} << u"cells"_s;
    QTest::newRow("by its name on the page") << QStringList{u"Battery"_s, u"cells=99"_s} << u"cells"_s;
    QTest::newRow("no such form") << QStringList{u"--certificate"_s, u"page.pdf"_s}
                                  << u"ends in .html or .json"_s;
    QTest::newRow("no value") << QStringList{u"power"_s, u"cells"_s} << u"ANSWER=VALUE"_s;
}

void TestCtlSetup::wrongWordsAreTold()
{
    QFETCH(QStringList, words);
    QFETCH(QString, says);
    const SimProcess gimbal({u"--tcp"_s, u"0"_s});
    const Run run = setup(gimbal.address(), words);
    QCOMPARE(run.exitCode, 2);
    QVERIFY2(run.err.contains(says) || run.out.contains(says), qPrintable(run.err + run.out));
    const Run list = setup(gimbal.address(), {});
    QCOMPARE(list.exitCode, 0);
    QVERIFY(list.json().value(u"steps"_s).toObject().isEmpty());  // nothing was done
}

void TestCtlSetup::aStepThatFailsIsKept()
{
    const SimProcess gimbal({u"--tcp"_s, u"0"_s, u"--fault"_s, u"battery=4.9"_s});
    const Run run = setup(gimbal.address(), {u"power"_s});
    QCOMPARE(run.exitCode, 1);
    const QJsonObject steps = setup(gimbal.address(), {}).json().value(u"steps"_s).toObject();
    QCOMPARE(steps.value(u"power"_s).toObject().value(u"state"_s).toString(), u"failed"_s);
    QVERIFY(steps.value(u"power"_s).toObject().value(u"why"_s).toString().contains(u"only USB"_s));
    // And is forgotten on demand.
    QVERIFY(setup(gimbal.address(), {u"--anew"_s}).json().value(u"steps"_s).toObject().isEmpty());
}

void TestCtlSetup::boardsWithoutItSaySo()
{
    const SimProcess gimbal({u"--tcp"_s, u"0"_s}, u"storm32"_s);
    const Run run = setup(gimbal.address(), {});
    QCOMPARE(run.exitCode, 1);
    QVERIFY2(run.err.contains(u"no set-up is known"_s) || run.out.contains(u"no set-up is known"_s),
             qPrintable(run.err + run.out));
}

// A line each second at most, and none where a program reads.
void TestCtlSetup::figuresAreShownLive()
{
    SimProcess gimbal({u"--tcp"_s, u"0"_s});
    const auto lines = [](const QString &told) {
        return told.split(u'\n').filter(
            QRegularExpression(u"^Angle -?[0-9.]+ .*Turn rate varies by .*°/s$"_s));
    };
    QElapsedTimer clock;
    clock.start();
    Running running(m_dir->path(), {u"--link"_s, gimbal.address(), u"setup"_s, u"gains"_s, u"search=off"_s});
    const Run run = running.finish(4 * kPatience);
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    const QStringList shown = lines(run.err);
    QVERIFY2(shown.size() >= 4 && shown.size() <= 1 + clock.elapsed() / 1000, qPrintable(run.err));
    QVERIFY(QSet<QString>(shown.begin(), shown.end()).size() > 2);  // they live
    QVERIFY(!run.err.contains(u'\r') && lines(run.out).isEmpty());
    const Run data = setup(gimbal.address(), {u"gains"_s, u"search=off"_s});
    QVERIFY2(data.exitCode == 0 && lines(data.err).isEmpty(), qPrintable(data.err));
}

void TestCtlSetup::onATerminalTheyStayInOneLine()
{
    SimProcess gimbal({u"--tcp"_s, u"0"_s});
    const int master = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    QVERIFY(master >= 0 && ::grantpt(master) == 0 && ::unlockpt(master) == 0);
    constexpr unsigned short kColumns = 60;
    const winsize size{24, kColumns, 0, 0};
    QVERIFY(::ioctl(master, TIOCSWINSZ, &size) == 0);
    QProcess ctl;
    ctl.setStandardOutputFile(m_dir->filePath(u"out"_s));
    ctl.setStandardErrorFile(QString::fromLocal8Bit(::ptsname(master)));
    ctl.start(QStringLiteral(GIMBAL_BIN_DIR "/gimbalctl"),
              {u"--history"_s, m_dir->filePath(u"history"_s), u"--link"_s, gimbal.address(), u"setup"_s,
               u"gains"_s, u"search=off"_s});
    QByteArray told;
    const auto readAll = [&] {
        std::array<char, 4096> part{};
        for (ssize_t got = 0; (got = ::read(master, part.data(), part.size())) > 0;)
            told.append(part.data(), got);
        return ctl.state() == QProcess::NotRunning;
    };
    QVERIFY2(QTest::qWaitFor(readAll, 4 * kPatience), told.constData());
    ::close(master);
    QCOMPARE(ctl.exitCode(), 0);
    const QByteArray kAnew = "\r\x1b[K";
    QVERIFY2(told.count(kAnew + "Angle ") > 5, told.constData());
    // It is gone when something else is told, and never as wide as the terminal.
    for (const QByteArray &line : told.split('\n')) {
        const QByteArray left = line.mid(line.lastIndexOf(kAnew) + 1);
        QVERIFY2(!left.contains("Turn rate varies"), line.constData());
    }
    for (qsizetype at = told.indexOf(kAnew); at >= 0; at = told.indexOf(kAnew, at + 1)) {
        const QByteArray shown = told.mid(at + kAnew.size()).split('\r').first();
        if (shown.startsWith("Angle "))
            QVERIFY2(QString::fromUtf8(shown).size() < kColumns, shown.constData());
    }
}

void TestCtlSetup::interruptedItIsDoneAgain()
{
    SimProcess gimbal({u"--tcp"_s, u"0"_s});
    Running running(m_dir->path(), {u"--link"_s, gimbal.address(), u"setup"_s, u"gains"_s});
    QVERIFY2(QTest::qWaitFor([&] { return running.told().contains(u"Measuring"_s); }, kPatience),
             qPrintable(running.told()));
    ::kill(pid_t(running.id()), SIGINT);
    const Run run = running.finish();
    QVERIFY(run.exitCode != 0);
    const QJsonObject steps = setup(gimbal.address(), {}).json().value(u"steps"_s).toObject();
    QCOMPARE(steps.value(u"gains"_s).toObject().value(u"state"_s).toString(), u"failed"_s);
}

QTEST_GUILESS_MAIN(TestCtlSetup)
#include "tst_ctlsetup.moc"
