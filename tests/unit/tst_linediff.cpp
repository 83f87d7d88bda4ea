// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/configuration/linediff.h"

#include <QRandomGenerator>
#include <QTest>

using namespace Qt::StringLiterals;
using Kind = DiffLine::Kind;

/// Two texts line by line.
class TestLineDiff final : public QObject
{
    Q_OBJECT
private slots:
    void changes_data();
    void changes();
    void eitherTextFollowsFromTheLines();
    void fewestLinesChange();
    void gapsStandForWhatIsTheSame();
    void nothingInCommonEnds();
};

namespace {

// "-2 b": removed, line 2 of the first text.
QString toldLine(const DiffLine &line)
{
    switch (line.kind) {
    case Kind::Same: return u"=%1/%2 %3"_s.arg(line.before).arg(line.after).arg(line.text);
    case Kind::Removed: return u"-%1 %2"_s.arg(line.before).arg(line.text);
    case Kind::Added: return u"+%1 %2"_s.arg(line.after).arg(line.text);
    case Kind::Gap: return u"~%1"_s.arg(line.left);
    }
    return {};
}

QStringList toldLines(const std::vector<DiffLine> &lines)
{
    QStringList list;
    for (const DiffLine &line : lines)
        list.append(toldLine(line));
    return list;
}

// The lines of one side, put together again.
QByteArray side(const std::vector<DiffLine> &lines, Kind own)
{
    QByteArray text;
    for (const DiffLine &line : lines) {
        if (line.kind == Kind::Same || line.kind == own)
            text += line.text.toUtf8() + '\n';
    }
    return text;
}

QByteArray someLines(QRandomGenerator &random)
{
    QByteArray text;
    for (int count = random.bounded(12); count > 0; --count)
        text += QByteArray(1, char('a' + random.bounded(4))) + '\n';
    return text;
}

}  // namespace

void TestLineDiff::changes_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    QTest::addColumn<QStringList>("lines");
    QTest::newRow("the same") << QByteArray("a\nb\n") << QByteArray("a\nb\n")
                              << QStringList{u"=1/1 a"_s, u"=2/2 b"_s};
    QTest::newRow("one changed") << QByteArray("a\nb\nc\n") << QByteArray("a\nx\nc\n")
                                 << QStringList{u"=1/1 a"_s, u"-2 b"_s, u"+2 x"_s, u"=3/3 c"_s};
    QTest::newRow("one more") << QByteArray("a\nb\n") << QByteArray("a\nx\nb\n")
                              << QStringList{u"=1/1 a"_s, u"+2 x"_s, u"=2/3 b"_s};
    QTest::newRow("from nothing") << QByteArray() << QByteArray("a\n") << QStringList{u"+1 a"_s};
    QTest::newRow("to nothing") << QByteArray("a\n") << QByteArray() << QStringList{u"-1 a"_s};
    // What cannot be seen is shown where it differs.
    QTest::newRow("another end") << QByteArray("a\r\n") << QByteArray("a\n")
                                 << QStringList{u"-1 a␍"_s, u"+1 a"_s};
    QTest::newRow("no end") << QByteArray("a\n") << QByteArray("a") << QStringList{u"-1 a"_s, u"+1 a␄"_s};
}

void TestLineDiff::changes()
{
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    QFETCH(QStringList, lines);
    QCOMPARE(toldLines(lineDiff(before, after)), lines);
}

void TestLineDiff::eitherTextFollowsFromTheLines()
{
    QRandomGenerator random(7);
    for (int round = 0; round < 3000; ++round) {
        const QByteArray before = someLines(random);
        const QByteArray after = someLines(random);
        const auto lines = lineDiff(before, after);
        QCOMPARE(side(lines, Kind::Removed), before);
        QCOMPARE(side(lines, Kind::Added), after);
    }
}

void TestLineDiff::fewestLinesChange()
{
    QCOMPARE(countChanges(lineDiff("a\nb\nc\na\nb\nb\na\n", "c\nb\na\nb\na\nc\n")), std::pair(2, 3));
}

void TestLineDiff::gapsStandForWhatIsTheSame()
{
    const auto lines = lineDiff("1\n2\n3\n4\n5\n6\n7\n8\n9\n", "1\n2\n3\n4\nx\n6\n7\n8\n9\n");
    QCOMPARE(toldLines(aroundChanges(lines, 1)),
             (QStringList{u"~3"_s, u"=4/4 4"_s, u"-5 5"_s, u"+5 x"_s, u"=6/6 6"_s, u"~3"_s}));
    QVERIFY(aroundChanges(lineDiff("a\n", "a\n"), 3).empty());
}

void TestLineDiff::nothingInCommonEnds()
{
    QByteArray before;
    QByteArray after;
    for (int i = 0; i < 20000; ++i) {
        before += "a" + QByteArray::number(i) + '\n';
        after += "b" + QByteArray::number(i) + '\n';
    }
    QCOMPARE(countChanges(lineDiff(before, after)), std::pair(20000, 20000));
}

QTEST_GUILESS_MAIN(TestLineDiff)
#include "tst_linediff.moc"
