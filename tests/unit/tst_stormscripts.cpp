// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/scripts.h"

#include <QTest>

#include <random>

using namespace Qt::StringLiterals;
using namespace storm32;

namespace {

const ScriptContext &context()
{
    static const ScriptContext made{
        {{0, u"Pitch P"_s, false}, {22, u"Pitch Offset"_s, true}, {66, u"Pan Mode Default Setting"_s, false}},
        96};
    return made;
}

QByteArray code(const char *hex)
{
    return QByteArray::fromHex(hex);
}

}  // namespace

/// Scripts of a STorM32 board: text, bytecode and back, against errata 8.
class TestStormScripts : public QObject
{
    Q_OBJECT
private slots:
    void textBecomesCode_data();
    void textBecomesCode();
    void mistakesAreNamed_data();
    void mistakesAreNamed();
    void whatIsCompiledReadsTheSame();
    void fourScriptsShareTheArea();
    void anyBytesAreShown();
};

void TestStormScripts::textBecomesCode_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QByteArray>("wanted");
    QTest::newRow("nothing") << u"\n  \n// words\n; more\n"_s << QByteArray();
    QTest::newRow("stop") << u"STOP"_s << code("00ff");
    QTest::newRow("stop is put behind") << u"DORECENTER"_s << code("1700ff");
    QTest::newRow("case is not minded") << u"wait 20\nStop"_s << code("091400ff");
    QTest::newRow("set") << u"SET \"Pitch P\" 400\nSTOP"_s << code("0a00900100ff");
    QTest::newRow("set, signed") << u"SET \"pitch offset\" -250\nSTOP"_s << code("0a1606ff00ff");
    QTest::newRow("set, by number") << u"RESTORE \"#119\"\nSTOP"_s << code("0c7700ff");
    QTest::newRow("limits") << u"SETMINMAX \"Pitch Offset\" -1 2\nSTOP"_s << code("0b16ffff020000ff");
    QTest::newRow("angle as fine as a board holds") << u"SETANGLEPITCH -290.29\nSTOP"_s << code("0d9b8e00ff");
    QTest::newRow("angle") << u"SETANGLEPITCH -12.34\nSTOP"_s << code("0d2efb00ff");
    QTest::newRow("angles") << u"SETANGLE 1 2 -3\nRESTART"_s << code("106400c800d4fe01ff");
    QTest::newRow("pwm") << u"SETPWM 2300\nSTOP"_s << code("18fc0800ff");
    QTest::newRow("panorama") << u"SETPANOWAITS 1 2 3\nSETPANORANGE 720\nDOPANO -2 5\nSTOP"_s
                              << code("19010203"
                                      "1ad002"
                                      "1bfe05"
                                      "00ff");
    QTest::newRow("angle and wait") << u"SETANGLEYAW_W 10 5\nREMOTEDISABLE\nSTOP"_s
                                    << code("1ee80305"
                                            "20"
                                            "00ff");
    // Two cases: each knows where the next one, or the end, is; REPEAT knows its own.
    QTest::newRow("cases") << u"CASE#DEFAULT\n DORECENTER\nCASE#1\n WAIT 5\n REPEAT"_s
                           << code("0304"
                                   "17"
                                   "00"
                                   "040a"
                                   "0905"
                                   "0204"
                                   "ff");
    QTest::newRow("repeat without a case") << u"WAIT 1\nREPEAT"_s
                                           << code("0901"
                                                   "0200"
                                                   "ff");
}

void TestStormScripts::textBecomesCode()
{
    QFETCH(QString, text);
    QFETCH(QByteArray, wanted);
    const auto area = compileScripts({text, {}, {}, {}}, context());
    QVERIFY2(area, qPrintable(area ? QString() : area.error().error().detail));
    QCOMPARE(area->size(), kScriptArea);
    QByteArray expected = (wanted.isEmpty() ? code("ffffffff") : code("04ffffff")) + wanted;
    expected.append(kScriptArea - expected.size(), char(0xFF));
    QCOMPARE(area->toHex(), expected.toHex());
}

void TestStormScripts::mistakesAreNamed_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("word");
    QTest::newRow("unknown word") << u"STOP\nJUMPUP"_s << u"line 2"_s;
    QTest::newRow("shown only") << u"SETPITCH 1500"_s << u"SETANGLE"_s;
    QTest::newRow("too few") << u"SETANGLE 1 2"_s << u"takes 3"_s;
    QTest::newRow("too many") << u"STOP 1"_s << u"takes 0"_s;
    QTest::newRow("unknown parameter") << u"SET \"Patch P\" 1"_s << u"Patch P"_s;
    QTest::newRow("no number") << u"WAIT long"_s << u"'long'"_s;
    QTest::newRow("not whole") << u"WAIT 1.5"_s << u"whole"_s;
    QTest::newRow("finer than a board holds") << u"SETANGLEPITCH 12.345"_s << u"the nearest is 12.3"_s;
    QTest::newRow("one of three is finer") << u"SETANGLE 1 2.005 3"_s << u"cannot hold 2.005"_s;
    QTest::newRow("not finite") << u"SETANGLEPITCH inf"_s << u"is not a number"_s;
    QTest::newRow("out of range") << u"SETPWM 600"_s << u"700"_s;
    QTest::newRow("negative for unsigned") << u"SET \"Pitch P\" -1"_s << u"outside 0"_s;
    QTest::newRow("too great for signed") << u"SET \"Pitch Offset\" 40000"_s << u"32767"_s;
    QTest::newRow("open quote") << u"SET \"Pitch P 1"_s << u"quote"_s;
    QTest::newRow("case twice") << u"CASE#DEFAULT\nSTOP\nCASE#DEFAULT"_s << u"already"_s;
    QTest::newRow("hole") << u"CASE#DEFAULT\nSTOP\nCASE#2"_s << u"CASE#1"_s;
    QTest::newRow("not the default first") << u"CASE#1\nSTOP"_s << u"CASE#DEFAULT"_s;
}

void TestStormScripts::mistakesAreNamed()
{
    QFETCH(QString, text);
    QFETCH(QString, word);
    const auto area = compileScripts({QString(), text, QString(), QString()}, context());
    QVERIFY(!area);
    QCOMPARE(area.error().script, 1);
    QVERIFY2(area.error().error().detail.startsWith(u"script 2, line"_s)
                 && area.error().error().detail.contains(word),
             qPrintable(area.error().error().detail));
}

void TestStormScripts::whatIsCompiledReadsTheSame()
{
    // Every statement that compiles, in all firmwares.
    for (const int firmware : {79, 90, 96}) {
        ScriptContext old = context();
        old.firmware = firmware;
        QString text;
        const QStringList words = scriptWords(firmware);
        QVERIFY(words.contains(u"SETPWM"_s));
        QCOMPARE(words.contains(u"DOPANO"_s), firmware >= 91);
        QCOMPARE(words.contains(u"REMOTEENABLE"_s), firmware >= 95);
        for (const char *line : {"CASE#DEFAULT",
                                 "  RESTOREALL",
                                 "  WAIT 7",
                                 "  SET \"Pitch P\" 65535",
                                 "  SET \"Pitch Offset\" -300",
                                 "  SETMINMAX \"Pan Mode Default Setting\" 0 3",
                                 "  RESTORE \"Pitch P\"",
                                 "  SETANGLEROLL -0.5",
                                 "  SETANGLEYAW 325",
                                 "  SETANGLE 1.25 -2 3",
                                 "  SETSTANDBY 1",
                                 "  DOCAMERA 4",
                                 "  SETPWM 1500",
                                 "  STOP",
                                 "CASE#1",
                                 "  DORECENTER",
                                 "  REPEAT",
                                 "CASE#2",
                                 "  RESTART",
                                 "CASE#3",
                                 "  STOP"})
            text += QString::fromLatin1(line) + u'\n';
        const auto area = compileScripts({QString(), QString(), text, QString()}, old);
        QVERIFY2(area, qPrintable(area ? QString() : area.error().error().detail));
        QCOMPARE(scriptText(*area, 2, old), text);
        QVERIFY(scriptText(*area, 0, old).isEmpty());
    }
    ScriptContext old = context();
    old.firmware = 79;
    QVERIFY(compileScripts({u"DOPANO 1 1"_s, {}, {}, {}}, old).error().error().detail.contains(u"0.79"_s));
}

void TestStormScripts::fourScriptsShareTheArea()
{
    const QString ten = u"WAIT 1\nWAIT 2\nWAIT 3\nWAIT 4\nSTOP"_s;  // 10 bytes with its end
    const auto area = compileScripts({ten, {}, ten, ten}, context());
    QVERIFY(area);
    QCOMPARE(area->left(4).toHex(), "04ff0e18");
    QCOMPARE(disassemble(*area, 3, context()).size(), std::size_t(5));
    QCOMPARE(disassemble(*area, 3, context())[2].offset, 4);
    const QString sixty = u"SETANGLE 1 2 3\n"_s.repeated(8) + u"WAIT 1\nSTOP"_s;  // 60
    QVERIFY(compileScripts({sixty, sixty, {}, {}}, context()));
    const auto tooLong = compileScripts({sixty, sixty, ten, {}}, context());
    QVERIFY(!tooLong);
    QCOMPARE(tooLong.error().script, 2);
    QCOMPARE(tooLong.error().line, 0);
    QVERIFY(tooLong.error().error().detail.contains(u"128"_s));
    QVERIFY(compileScripts({(sixty + u'\n').repeated(40), {}, {}, {}}, context())
                .error()
                .error()
                .detail.contains(u"too long"_s));
    // A word that looks like a place for a value is shown as it is.
    QVERIFY(compileScripts({u"%2"_s, {}, {}, {}}, context()).error().error().detail.contains(u"'%2'"_s));
}

void TestStormScripts::anyBytesAreShown()
{
    std::mt19937 random(3);
    for (int round = 0; round < 2000; ++round) {
        QByteArray area;
        for (int i = 0; i < int(random() % 129); ++i)
            area.append(char(random()));
        for (int script = -1; script < 5; ++script) {
            int at = 0;
            for (const ScriptLine &line : disassemble(area, script, context())) {
                QCOMPARE(line.offset, at);
                QVERIFY(line.size > 0 && !line.text.isEmpty());
                at += line.size;
            }
            QVERIFY(at <= area.size());
        }
    }
    QVERIFY(scriptText(QByteArray::fromHex("04ffffff2a00ff"), 0, context()).contains(u"?? 2A"_s));
}

QTEST_GUILESS_MAIN(TestStormScripts)
#include "tst_stormscripts.moc"
