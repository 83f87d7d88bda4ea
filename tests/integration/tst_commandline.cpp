// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/patience.h"

#include <QProcess>
#include <QTest>

using namespace Qt::StringLiterals;

/// What the program says on a terminal, with and without a screen.
class TestCommandLine : public QObject
{
    Q_OBJECT
private slots:
    void answersOnTheTerminal_data();
    void answersOnTheTerminal();
};

void TestCommandLine::answersOnTheTerminal_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("platform");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("says");
    const QString none;
    QTest::newRow("help") << QStringList{u"--help"_s} << none << 0 << u"--tour"_s;
    QTest::newRow("version") << QStringList{u"-v"_s} << none << 0 << QStringLiteral(GIMBAL_VERSION);
    QTest::newRow("no screen") << QStringList{} << none << 2 << u"there is no display"_s;
    QTest::newRow("no screen for the demo") << QStringList{u"--demo"_s} << none << 2 << u"gimbalctl"_s;
    QTest::newRow("no such page") << QStringList{u"--page"_s, u"nonsense"_s} << u"offscreen"_s << 2
                                  << u"dashboard"_s;
    QTest::newRow("no such theme") << QStringList{u"--theme"_s, u"pink"_s} << u"offscreen"_s << 2
                                   << u"light or dark"_s;
    QTest::newRow("no such word") << QStringList{u"please"_s} << u"offscreen"_s << 2 << u"--help"_s;
}

void TestCommandLine::answersOnTheTerminal()
{
    QFETCH(const QStringList, arguments);
    QFETCH(const QString, platform);
    QFETCH(const int, exitCode);
    QFETCH(const QString, says);
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const QString &name : {u"DISPLAY"_s, u"WAYLAND_DISPLAY"_s, u"QT_QPA_PLATFORM"_s})
        environment.remove(name);
    if (!platform.isEmpty())
        environment.insert(u"QT_QPA_PLATFORM"_s, platform);
    program.setProcessEnvironment(environment);
    program.setProcessChannelMode(QProcess::MergedChannels);
    program.start(QStringLiteral(GIMBAL_BIN_DIR "/gimbaldesk"), arguments);
    QVERIFY(program.waitForFinished(kPatience));
    const QString output = QString::fromUtf8(program.readAll());
    QCOMPARE(program.exitStatus(), QProcess::NormalExit);
    QVERIFY2(program.exitCode() == exitCode, qPrintable(output));
    QVERIFY2(output.contains(says), qPrintable(output));
}

QTEST_GUILESS_MAIN(TestCommandLine)
#include "tst_commandline.moc"
