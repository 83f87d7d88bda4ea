// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/ctlrun.h"
#include "tests/support/simprocess.h"

#include <QJsonArray>
#include <QTemporaryDir>

using namespace Qt::StringLiterals;

namespace {

/// A family as this test meets it.
struct Tried
{
    QString key;
    QString simulator;
    QString program;
    QString value;  // a parameter
    QString wanted;  // a value of it that no board holds at first
};

const QList<Tried> &families()
{
    static const QList<Tried> all{
        {u"simplebgc"_s, u"gimbalsim"_s, u"gimbalctl"_s, u"pid.roll.p"_s, u"44"_s},
        {u"storm32"_s, u"gimbalsim"_s, u"gimbalctl"_s, u"pid.pitch.p"_s, u"4.50"_s},
        {u"toy"_s, u"toysim"_s, u"toyctl"_s, u"flight.limit"_s, u"1234"_s},
    };
    return all;
}

/// A way to misbehave, and whether the board can be read and written all the same.
struct Kind
{
    const char *name;
    QStringList faults;
    bool mustWork;
};

const QList<Kind> &kinds()
{
    static const QList<Kind> all{
        {"well", {}, true},
        {"late", {u"late=150"_s}, true},
        {"at any time", {u"delay=60"_s}, true},
        {"twice", {u"double=0.001"_s}, false},
        {"wrong lengths", {u"lose=0.001"_s}, false},
        {"errors", {u"flip=0.001"_s}, false},
        {"resets", {u"reset-on-write=1"_s}, false},
    };
    return all;
}

}  // namespace

/// Boards that misbehave, in each family: what gimbalctl says of values is so, or it says that it failed.
class TestMisbehaving : public QObject
{
    Q_OBJECT
private slots:
    void nothingFalseIsSaid_data();
    void nothingFalseIsSaid();
};

void TestMisbehaving::nothingFalseIsSaid_data()
{
    QTest::addColumn<int>("family");
    QTest::addColumn<int>("kind");
    for (int family = 0; family < int(families().size()); ++family) {
        for (int kind = 0; kind < int(kinds().size()); ++kind)
            QTest::addRow("%s: %s", qPrintable(families()[family].key), kinds()[kind].name) << family << kind;
    }
}

void TestMisbehaving::nothingFalseIsSaid()
{
    QFETCH(int, family);
    QFETCH(int, kind);
    const Tried &tried = families()[family];
    const Kind &misbehaves = kinds()[kind];
    const QTemporaryDir dir;
    const bool isNetwork = tried.key == u"toy"_s;
    QStringList options
        = isNetwork ? QStringList{u"--udp"_s, u"0"_s} : QStringList{u"--pty"_s, dir.filePath(u"board"_s)};
    for (const QString &fault : misbehaves.faults)
        options += {u"--fault"_s, fault};
    const SimProcess board(options, tried.key, tried.simulator);
    const QString link
        = isNetwork ? board.address() : u"serial:%1?family=%2"_s.arg(dir.filePath(u"board"_s), tried.key);
    const auto ctl = [&](const QStringList &arguments) {
        return Running(dir.path(), QStringList{u"--link"_s, link} + arguments, tried.program).finish(60000);
    };
    const auto fails = [&](const Run &run) {
        return run.exitCode == 1 && !run.err.trimmed().isEmpty() && !misbehaves.mustWork;
    };

    const Run before = ctl({u"get"_s, tried.value});
    QVERIFY2(before.exitCode == 0 || fails(before), qPrintable(before.err));
    QVERIFY2(before.exitCode == 0 || before.out.isEmpty(), qPrintable(before.out));

    const Run set = ctl({u"--json"_s, u"set"_s, tried.value + u'=' + tried.wanted});
    QVERIFY2(set.exitCode == 0 || fails(set), qPrintable(set.err));
    // What the board holds, told by itself: asked until it is told.
    Run after;
    for (int i = 0; i < 10 && after.exitCode != 0; ++i)
        after = ctl({u"get"_s, tried.value});
    QVERIFY2(after.exitCode == 0, qPrintable(after.err));
    const double holds = after.out.trimmed().toDouble();
    if (set.exitCode == 0)
        QCOMPARE(holds, tried.wanted.toDouble());
    const QJsonArray written = set.json().value(u"written"_s).toArray();
    for (const QJsonValue value : written) {
        const QJsonObject line = value.toObject();
        if (line.contains(u"onBoard"_s))
            QCOMPARE(holds, line.value(u"onBoard"_s).toString().toDouble());
        if (line.value(u"state"_s) == u"verified"_s)
            QCOMPARE(holds, tried.wanted.toDouble());
    }
    // Before anything was written the board as it was has been kept, and the path is told.
    if (!written.isEmpty())
        QVERIFY(QFile::exists(set.json().value(u"snapshot"_s).toString()));
}

QTEST_GUILESS_MAIN(TestMisbehaving)
#include "tst_misbehaving.moc"
