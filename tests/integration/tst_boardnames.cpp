// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/boardhistory.h"
#include "tests/support/ctlrun.h"
#include "tests/support/simprocess.h"

#include <QDir>
#include <QTemporaryDir>

using namespace Qt::StringLiterals;

namespace {

/// A simulated board behind a pseudo-terminal, and gimbalctl on it.
struct Board
{
    Board(const QString &folder, const QString &name, const QStringList &options, const QString &family)
        : link(u"serial:%1/%2"_s.arg(folder, name))
        , process(QStringList{u"--pty"_s, folder + u'/' + name} + options, family)
    {
    }
    QString link;
    SimProcess process;
};

}  // namespace

/// Boards without a serial number: whose snapshots are whose.
class TestBoardNames : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_dir = std::make_unique<QTemporaryDir>(); }
    void alikeShareNothing_data();
    void alikeShareNothing();
    void renamedHereKeepsItsHistory();
    void renamedElsewhereIsTold();
    void numberedBoardsNeedNoName();
    void olderHistoryIsTakenOver();

private:
    Run ctl(const Board &board, const QStringList &arguments, const QString &folder = {})
    {
        const QString root = m_dir->filePath(folder.isEmpty() ? u"own"_s : folder);
        QDir().mkpath(root);
        return Running(root, QStringList{u"--link"_s, board.link} + arguments).finish();
    }
    Board storm(const QString &name) { return {m_dir->path(), name, {}, u"storm32"_s}; }
    // Folder and number of the snapshots in it.
    QMap<QString, int> kept() const
    {
        QMap<QString, int> found;
        const QDir root(m_dir->filePath(u"own/history"_s));
        for (const QString &name : root.entryList(QDir::Dirs | QDir::NoDotAndDotDot))
            found.insert(name, int(QDir(root.filePath(name)).entryList({u"*.json"_s}).size()));
        return found;
    }

    std::unique_ptr<QTemporaryDir> m_dir;
};

void TestBoardNames::alikeShareNothing_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QString>("value");
    QTest::newRow("storm32") << u"storm32"_s << QStringList{} << u"pid.pitch.p=4.5"_s;
    QTest::newRow("simplebgc, zeros")
        << u"simplebgc"_s << QStringList{u"--number"_s, u"00"_s} << u"pid.roll.p=44"_s;
    QTest::newRow("simplebgc, never written")
        << u"simplebgc"_s << QStringList{u"--number"_s, u"ff"_s} << u"pid.roll.p=44"_s;
}

void TestBoardNames::alikeShareNothing()
{
    QFETCH(QString, family);
    QFETCH(QStringList, options);
    QFETCH(QString, value);
    const Board first(m_dir->path(), u"first"_s, options, family);
    const Board second(m_dir->path(), u"second"_s, options, family);
    const Run named = ctl(first, {u"--board"_s, u"Studio A"_s, u"set"_s, value});
    QVERIFY2(named.exitCode == 0, qPrintable(named.err));
    const Run other = ctl(second, {u"--board"_s, u"Studio B"_s, u"set"_s, value});
    QVERIFY2(other.exitCode == 0, qPrintable(other.err));
    QCOMPARE(kept().values(), (QList<int>{1, 1}));
    // Which one it is cannot be known without a word: neither history grows, and nothing waits for an answer.
    const QString again = value.section(u'=', 0, 0) + u"=5"_s;
    const Run unsaid = ctl(second, {u"set"_s, again});
    QVERIFY2(unsaid.exitCode == 0, qPrintable(unsaid.err));
    QVERIFY2(unsaid.err.contains(u"boards that look like this one are known: Studio A, Studio B"_s),
             qPrintable(unsaid.err));
    QVERIFY2(unsaid.err.contains(u"--board NAME"_s), qPrintable(unsaid.err));
    QCOMPARE(kept().values(), (QList<int>{1, 1, 1}));
    const Run said = ctl(second, {u"--board"_s, u"Studio B"_s, u"set"_s, value});
    QVERIFY2(said.exitCode == 0, qPrintable(said.err));
    QVERIFY2(!said.err.contains(u"look"_s), qPrintable(said.err));
    QList<int> counts = kept().values();
    std::sort(counts.begin(), counts.end());
    QCOMPARE(counts, (QList<int>{1, 1, 2}));
    QCOMPARE(ctl(first, {u"--json"_s, u"--board"_s, u"Studio A"_s, u"info"_s}).json().value(u"called"_s),
             u"Studio A"_s);
}

void TestBoardNames::renamedHereKeepsItsHistory()
{
    const Board board = storm(u"board"_s);
    const Run set = ctl(board, {u"set"_s, u"pid.pitch.p=4.5"_s});
    QVERIFY2(set.exitCode == 0, qPrintable(set.err));
    QCOMPARE(kept().values(), QList<int>{1});
    const QString folder = kept().firstKey();
    const Run renamed = ctl(board, {u"do"_s, u"name"_s, u"name=Studio"_s});
    QVERIFY2(renamed.exitCode == 0, qPrintable(renamed.err));
    const Run after = ctl(board, {u"set"_s, u"pid.pitch.p=5"_s});
    QVERIFY2(after.exitCode == 0, qPrintable(after.err));
    QVERIFY2(!after.err.contains(u"serial number"_s), qPrintable(after.err));
    QCOMPARE(kept(), (QMap<QString, int>{{folder, 3}}));
    QCOMPARE(ctl(board, {u"--json"_s, u"info"_s}).json().value(u"called"_s), u"Studio"_s);
    // Another one that looks as the first did has nothing of it.
    const Board fresh = storm(u"fresh"_s);
    const Run other = ctl(fresh, {u"set"_s, u"pid.pitch.p=5"_s});
    QVERIFY2(other.exitCode == 0, qPrintable(other.err));
    QVERIFY2(other.err.contains(u"looks like none of Studio"_s), qPrintable(other.err));
    QCOMPARE(kept().value(folder), 3);
    QCOMPARE(kept().size(), 2);
}

void TestBoardNames::renamedElsewhereIsTold()
{
    const Board board = storm(u"board"_s);
    QCOMPARE(ctl(board, {u"--board"_s, u"Studio"_s, u"set"_s, u"pid.pitch.p=4.5"_s}).exitCode, 0);
    const QString folder = kept().firstKey();
    QCOMPARE(ctl(board, {u"do"_s, u"name"_s, u"name=Elsewhere"_s}, u"elsewhere"_s).exitCode, 0);
    const Run asked = ctl(board, {u"info"_s});
    QCOMPARE(asked.exitCode, 0);
    QVERIFY2(asked.err.contains(u"looks like none of Studio"_s), qPrintable(asked.err));
    QVERIFY2(!asked.out.contains(u"called"_s), qPrintable(asked.out));
    QVERIFY2(asked.out.contains(u"serial       none"_s), qPrintable(asked.out));
    QVERIFY(!ctl(board, {u"--json"_s, u"info"_s}).json().value(u"numbered"_s).toBool(true));
    const Run said = ctl(board, {u"--board"_s, u"Studio"_s, u"set"_s, u"pid.pitch.p=5"_s});
    QVERIFY2(said.exitCode == 0, qPrintable(said.err));
    QCOMPARE(kept(), (QMap<QString, int>{{folder, 2}}));
    // Said once.
    const Run later = ctl(board, {u"info"_s});
    QVERIFY2(!later.err.contains(u"serial number"_s), qPrintable(later.err));
    QVERIFY2(later.out.contains(u"called       Studio"_s), qPrintable(later.out));
}

void TestBoardNames::numberedBoardsNeedNoName()
{
    const Board board(m_dir->path(), u"board"_s, {}, u"simplebgc"_s);
    const Run run = ctl(board, {u"--board"_s, u"Studio"_s, u"info"_s});
    QCOMPARE(run.exitCode, 2);
    QVERIFY2(run.err.contains(u"serial number"_s), qPrintable(run.err));
    QVERIFY(run.out.isEmpty());
    QVERIFY(kept().isEmpty());
}

// What an earlier version kept under the look of the board belongs to the first one that gets a name.
void TestBoardNames::olderHistoryIsTakenOver()
{
    const QString look = u"storm32-4f6c6c6957203332334247432076312e333020463130335243"_s;
    const QString from = QStringLiteral(GIMBAL_SOURCE_DIR "/tests/data/version-0.1/history/") + look;
    const QString to = m_dir->filePath(u"own/history/"_s + look);
    QVERIFY(QDir().mkpath(to));
    const QStringList snapshots = QDir(from).entryList({u"*.json"_s}, QDir::Files);
    QCOMPARE(snapshots.size(), 1);
    QVERIFY(QFile::copy(from + u'/' + snapshots.first(), to + u'/' + snapshots.first()));
    const Board board = storm(u"board"_s);
    const Run unsaid = ctl(board, {u"info"_s});
    QVERIFY2(unsaid.err.contains(u"name it once with --board NAME"_s), qPrintable(unsaid.err));
    QCOMPARE(ctl(board, {u"--board"_s, u"Old"_s, u"set"_s, u"pid.pitch.p=4.5"_s}).exitCode, 0);
    QCOMPARE(kept(), (QMap<QString, int>{{look, 2}}));
    const BoardHistory history(m_dir->filePath(u"own/history"_s));
    QCOMPARE(history.nameOf(look), u"Old"_s);
    QCOMPARE(history.snapshots(look).size(), 2);
}

QTEST_GUILESS_MAIN(TestBoardNames)
#include "tst_boardnames.moc"
