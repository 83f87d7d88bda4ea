// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/ctlrun.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"

#include <QTemporaryDir>

#include <map>
#include <memory>

using namespace Qt::StringLiterals;

namespace {

const QString kLong(5000, u'x');

}  // namespace

/// What a new user types wrongly: each is refused with words that tell what was expected, and changes
/// nothing.
class TestArguments : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void cleanupTestCase() { m_sims.clear(); }

    void wrongArguments_data();
    void wrongArguments();
    void nothingWasChanged();
    void everyCommandHasHelp_data();
    void everyCommandHasHelp();
    void wrongSimulators_data();
    void wrongSimulators();

private:
    Run run(const QStringList &arguments)
    {
        Running running(m_dir.path(), arguments);
        return running.finish();
    }

    QString values(const QString &sim)
    {
        return run({u"--link"_s, m_sims.at(sim)->address(), u"list"_s}).out;
    }

    QTemporaryDir m_dir;
    std::map<QString, std::unique_ptr<SimProcess>> m_sims;  // by family
    std::map<QString, QString> m_before;  // all values, as listed
};

void TestArguments::initTestCase()
{
    m_sims[u"simplebgc"_s] = std::make_unique<SimProcess>(QStringList{u"--pty"_s, m_dir.filePath(u"link"_s)});
    m_sims[u"storm32"_s] = std::make_unique<SimProcess>(QStringList{u"--tcp"_s, u"0"_s}, u"storm32"_s);
    for (const auto &[name, sim] : m_sims)
        QVERIFY2(!sim->address().isEmpty(), qPrintable(name));
    for (const auto &[name, sim] : m_sims)
        m_before[name] = values(name);
}

void TestArguments::wrongArguments_data()
{
    QTest::addColumn<QString>("sim");
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("says");
    struct Row
    {
        const char *name;
        QStringList arguments;
        int exitCode;
        QString says;
        const char *only = "";  ///< the family that it makes sense with
    };
    const QList<Row> rows{
        {"unknown command", {u"fly"_s}, 2, u"there is no command 'fly'"_s},
        {"unknown option", {u"info"_s, u"--loud"_s}, 2, u"loud"_s},
        {"unknown alarm", {u"info"_s, u"--alarm"_s, u"noise=off"_s}, 2, u"KIND is one of runaway"_s},
        {"unknown reaction", {u"info"_s, u"--alarm"_s, u"runaway=explode"_s}, 2, u"WHAT of warn"_s},
        {"reaction without a change",
         {u"info"_s, u"--alarm"_s, u"battery=revert"_s},
         2,
         u"choose warn or off"_s},
        {"option of another command", {u"info"_s, u"--profile"_s, u"1"_s}, 2, u"it takes"_s},
        {"word too many", {u"profiles"_s, u"x"_s}, 2, u"takes options only"_s},
        {"word too many for info", {u"info"_s, u"x"_s}, 2, u"takes options only"_s},
        {"option twice",
         {u"get"_s, u"pid.roll.p"_s, u"--profile"_s, u"1"_s, u"--profile"_s, u"1"_s},
         2,
         u"--profile is given twice"_s},
        {"link twice", {u"info"_s, u"--link"_s, u"sim:simplebgc"_s}, 2, u"--link is given twice"_s},
        {"no key", {u"get"_s}, 2, u"usage: gimbalctl get KEY"_s},
        {"empty key", {u"get"_s, u""_s}, 2, u"is empty"_s},
        {"unknown key", {u"get"_s, u"nope"_s}, 2, u"there is no parameter 'nope'"_s},
        {"unicode key", {u"get"_s, u"pïd.röll"_s}, 2, u"'pïd.röll'"_s},
        {"very long key", {u"get"_s, kLong}, 2, u"has 5000 characters"_s},
        {"profile 0", {u"get"_s, u"pid.roll.p"_s, u"--profile"_s, u"0"_s}, 2, u"a number from 1"_s},
        {"profile 9", {u"get"_s, u"pid.roll.p"_s, u"--profile"_s, u"9"_s}, 2, u"the board has"_s},
        {"no assignment", {u"set"_s}, 2, u"KEY=VALUE"_s},
        {"no value", {u"set"_s, u"pid.roll.p="_s}, 2, u"which takes 0"_s},
        {"not a number", {u"set"_s, u"pid.roll.p=abc"_s}, 2, u"which takes 0"_s},
        {"digits of another script", {u"set"_s, u"pid.roll.p=٣"_s}, 2, u"which takes 0"_s},
        {"out of range", {u"set"_s, u"pid.roll.p=99999"_s}, 2, u"allowed 0"_s},
        {"key twice", {u"set"_s, u"pid.roll.p=1"_s, u"pid.roll.p=2"_s}, 2, u"'pid.roll.p' is given twice"_s},
        {"no such choice",
         {u"set"_s, u"service.servo1.source=Channel"_s},
         2,
         u"0 (Off), 1 (Virtual channel 1)"_s,
         "simplebgc"},
        {"list of two", {u"list"_s, u"a"_s, u"b"_s}, 2, u"one pattern at most"_s},
        {"nothing matches", {u"list"_s, u"zzzz"_s}, 1, u"no parameter matches 'zzzz'"_s},
        {"file without a name", {u"dump"_s, u""_s}, 2, u"is empty"_s},
        {"file in no folder", {u"dump"_s, u"/nonexistent/x.json"_s}, 1, u"/nonexistent/x.json"_s},
        {"file that is a folder", {u"dump"_s, m_dir.path()}, 1, m_dir.path()},
        {"no such file", {u"apply"_s, u"/nonexistent/x.json"_s}, 1, u"/nonexistent/x.json"_s},
        {"no name", {u"rename"_s, u"1"_s}, 2, u"rename needs"_s},
        {"no such profile", {u"rename"_s, u"9"_s, u"x"_s}, 2, u"there is no profile 9"_s},
        {"name of two lines", {u"rename"_s, u"1"_s, u"a\nb"_s}, 2, u"no control characters"_s},
        {"name too long in bytes",
         {u"rename"_s, u"1"_s, QString(30, u'ü')},
         2,
         u"48 bytes, this one has 60"_s,
         "simplebgc"},
        {"no action", {u"do"_s}, 2, u"\"do help\" lists them"_s},
        {"unknown action", {u"do"_s, u"dance"_s}, 2, u"no action 'dance'; there are:"_s},
        {"argument twice", {u"do"_s, u"motors.off"_s, u"a=1"_s, u"a=1"_s}, 2, u"'a' is given twice"_s},
        {"unknown argument", {u"do"_s, u"motors.off"_s, u"a=1"_s}, 2, u"has no argument 'a'"_s},
        {"no argument", {u"do"_s, u"variables.write"_s}, 2, u"needs id="_s, "simplebgc"},
        {"text of two lines", {u"do"_s, u"name"_s, u"name=a\nb"_s}, 2, u"control characters"_s, "storm32"},
        {"text too long",
         {u"do"_s, u"name"_s, u"name=abcdefghijklmnopqrstuvwxyz"_s},
         2,
         u"up to 16 letters, not 26"_s,
         "storm32"},
        {"letter that the board does not have",
         {u"do"_s, u"name"_s, u"name=Žofie"_s},
         2,
         u"no letter “Ž”"_s,
         "storm32"},
        {"motors maybe", {u"motors"_s, u"maybe"_s}, 2, u"motors needs on or off"_s},
        {"unknown channel",
         {u"monitor"_s, u"--channels"_s, u"nope"_s, u"--seconds"_s, u"1"_s},
         2,
         u"no channel 'nope'"_s},
        {"seconds below zero", {u"monitor"_s, u"--seconds"_s, u"-3"_s}, 2, u"seconds"_s},
        {"monitor of a word", {u"monitor"_s, u"roll"_s}, 2, u"takes options only"_s},
        {"address without a port",
         {u"publish"_s, u"localhost:"_s, u"--seconds"_s, u"1"_s},
         2,
         u"one looks like 127.0.0.1:9870"_s}};
    for (const auto &[sim, process] : m_sims) {
        for (const Row &row : rows) {
            if (!*row.only || sim.startsWith(QLatin1String(row.only)))
                QTest::addRow("%s: %s", qPrintable(sim), row.name)
                    << sim << row.arguments << row.exitCode << row.says;
        }
    }
}

void TestArguments::wrongArguments()
{
    QFETCH(QString, sim);
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    QFETCH(QString, says);
    const QStringList link{u"--link"_s, m_sims.at(sim)->address()};
    const Run told = run(link + arguments);
    QVERIFY2(told.exitCode == exitCode, qPrintable(told.err));
    QVERIFY2(told.err.contains(says), qPrintable(told.err));
    // Nobody reads pages of what they have typed themselves.
    QVERIFY2(told.err.size() < 3000, qPrintable(told.err));
    QVERIFY2(told.out.isEmpty(), qPrintable(told.out));
}

void TestArguments::nothingWasChanged()
{
    for (const auto &[name, sim] : m_sims) {
        QVERIFY(!m_before[name].isEmpty());
        QCOMPARE(values(name), m_before[name]);
    }
}

void TestArguments::everyCommandHasHelp_data()
{
    QTest::addColumn<QString>("command");
    const QString help = run({u"--help"_s}).out;
    for (const QString &line : help.split(u'\n')) {
        if (line.startsWith(u"  "_s) && !line.startsWith(u"   "_s) && !line.startsWith(u"  --"_s))
            QTest::newRow(qPrintable(line.simplified().section(u' ', 0, 0)))
                << line.simplified().section(u' ', 0, 0);
    }
}

void TestArguments::everyCommandHasHelp()
{
    QFETCH(QString, command);
    const Run help = run({command, u"--help"_s});
    QCOMPARE(help.exitCode, 0);
    QVERIFY2(help.err.isEmpty(), qPrintable(help.err));
    QVERIFY2(help.out.contains(u"gimbalctl "_s + command) && help.out.count(u'\n') > 2, qPrintable(help.out));
}

void TestArguments::wrongSimulators_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("says");
    const QStringList good{u"--family"_s, u"storm32"_s, u"--tcp"_s, u"0"_s};
    QTest::newRow("nothing") << QStringList() << u"--help"_s;
    QTest::newRow("no place") << QStringList{u"--family"_s, u"storm32"_s} << u"--pty PATH"_s;
    QTest::newRow("two places") << good + QStringList{u"--pty"_s, m_dir.filePath(u"x"_s)} << u"one of"_s;
    QTest::newRow("no such family") << QStringList{u"--family"_s, u"x"_s, u"--tcp"_s, u"0"_s}
                                    << u"simplebgc"_s;
    QTest::newRow("port twice") << good + QStringList{u"--tcp"_s, u"0"_s} << u"--tcp is given twice"_s;
    QTest::newRow("port too high") << QStringList{u"--family"_s, u"storm32"_s, u"--tcp"_s, u"70000"_s}
                                   << u"0 to 65535"_s;
    QTest::newRow("word") << good + QStringList{u"now"_s} << u"'now' is not understood"_s;
    QTest::newRow("fault without a value") << good + QStringList{u"--fault"_s, u"lose"_s} << u"lose"_s;
    QTest::newRow("fault out of range") << good + QStringList{u"--fault"_s, u"lose=7"_s} << u"lose"_s;
    QTest::newRow("unknown option") << good + QStringList{u"--fast"_s} << u"fast"_s;
    QTest::newRow("seed of letters") << good + QStringList{u"--seed"_s, u"abc"_s} << u"seed"_s;
}

void TestArguments::wrongSimulators()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, says);
    QProcess sim;
    sim.start(QStringLiteral(GIMBAL_BIN_DIR "/gimbalsim"), arguments);
    QVERIFY(QTest::qWaitFor([&sim] { return sim.state() == QProcess::NotRunning; }, kPatience));
    const QString told = QString::fromUtf8(sim.readAllStandardError());
    QVERIFY2(sim.exitCode() == 2, qPrintable(told));
    QVERIFY2(told.contains(says), qPrintable(told));
}

QTEST_GUILESS_MAIN(TestArguments)
#include "tst_arguments.moc"
