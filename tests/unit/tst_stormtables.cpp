// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/orientations.h"
#include "protocol/storm32/parametertables.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>
#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace storm32;

namespace {

// The facts of the field, as they were given: layout, word, range, default, choices.
QJsonObject layoutFacts(int layout)
{
    QFile file(QStringLiteral(GIMBAL_SOURCE_DIR "/tests/data/storm32-parameters.json"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QJsonArray layouts = QJsonDocument::fromJson(file.readAll()).object()[u"layouts"_s].toArray();
    for (const QJsonValue each : layouts) {
        if (each[u"layout"_s].toInt() == layout)
            return each.toObject();
    }
    return {};
}

const ParameterSpec *findWord(const ParameterSet &set, int word)
{
    for (const ParameterSpec &spec : set.all()) {
        if (spec.offset == 2 * word)
            return &spec;
    }
    return nullptr;
}

ParameterSet setOf(int layout)
{
    return ParameterSet(parameterRows(), blocksOf(layout), layout, {});
}

}  // namespace

/// The tables of STorM32 against the facts.
class TestStormTables : public QObject
{
    Q_OBJECT
private slots:
    void layoutIsAsGiven_data();
    void layoutIsAsGiven();
    void layoutBetweenDiffersAsTold();
    void unknownLayoutsHaveNoTable();
    void keysAreUniqueAndNamesKnown();
    void axesLieWhereTheyShould();
    void valuesThatNobodyMaySet();
    void wordOfLayout89HasItsName();
    void orientationsAreRightHanded();
};

void TestStormTables::layoutIsAsGiven_data()
{
    QTest::addColumn<int>("layout");
    QTest::newRow("78") << 78;
    QTest::newRow("95") << 95;
}

void TestStormTables::layoutIsAsGiven()
{
    QFETCH(int, layout);
    const QJsonObject facts = layoutFacts(layout);
    const QJsonArray parameters = facts[u"parameters"_s].toArray();
    QVERIFY(parameters.size() > 110);
    const ParameterSet set = setOf(layout);
    QCOMPARE(qsizetype(set.all().size()), parameters.size());
    QCOMPARE(wordsOf(layout), facts[u"words"_s].toInt());
    QCOMPARE(set.block(Parameters)->size + set.block(Scripts)->size, facts[u"stream_bytes"_s].toInt());
    for (const QJsonValue fact : parameters) {
        const int word = fact[u"index"_s].toInt();
        const QByteArray where = fact[u"name"_s].toString().toUtf8();
        const ParameterSpec *spec = findWord(set, word);
        QVERIFY2(spec, where);
        QCOMPARE(originalName(*spec).toUtf8(), where);
        QVERIFY2((spec->row->wire == WireType::I16) == (fact[u"wire"_s].toString() == u"s16"_s), where);
        QCOMPARE(spec->row->min, fact[u"min"_s].toInt());
        QVERIFY2(spec->row->max == fact[u"max"_s].toInt(), where);
        QVERIFY2(spec->defaultRaw == fact[u"default"_s].toInt(), where);
        const bool choice = fact[u"kind"_s].toString() == u"enum"_s;
        QCOMPARE(spec->row->kind == ValueKind::Choice, choice);
        if (!choice) {
            QCOMPARE(spec->row->decimals, fact[u"decimals"_s].toInt());
            QVERIFY2(std::abs(spec->toDisplay(1000) - 1000 * std::pow(10.0, -spec->row->decimals)) < 1e-9,
                     where);
            const QString unit = fact[u"unit"_s].toString();
            QCOMPARE(QString::fromUtf8(spec->row->unit),
                     unit == u"us"_s         ? u"µs"_s
                         : unit == u"us/s"_s ? u"µs/s"_s
                                             : unit);
            continue;
        }
        QJsonArray names = fact[u"choices"_s].toArray();
        const QString reference = fact[u"choices_ref"_s].toString();
        if (reference == u"function_input"_s)
            names = facts[u"enums"_s][reference].toArray();
        const std::vector<Choice> choices = spec->choices(layout);
        for (int value = spec->row->min; value <= spec->row->max; ++value) {
            const auto it = std::find_if(choices.begin(), choices.end(),
                                         [value](const Choice &each) { return each.value == value; });
            QVERIFY2(it != choices.end(), where);
            if (!names.isEmpty())
                QCOMPARE(QString::fromUtf8(it->name), names[value].toString());
        }
    }
    // What no parameter uses is left alone.
    for (const QJsonValue fact : facts[u"unassigned"_s].toArray())
        QVERIFY(!findWord(set, fact[u"index"_s].toInt()));
}

// Errata 5: layout 89 equals 95 except for these.
void TestStormTables::layoutBetweenDiffersAsTold()
{
    const ParameterSet set89 = setOf(89);
    const ParameterSet set95 = setOf(95);
    QSet<int> different;
    for (int word = 0; word < 125; ++word) {
        const ParameterSpec *a = findWord(set89, word);
        const ParameterSpec *b = findWord(set95, word);
        if (!a || !b || originalName(*a) != originalName(*b) || a->row->max != b->row->max
            || a->row->kind != b->row->kind) {
            if (a || b)
                different.insert(word);
        }
    }
    QCOMPARE(different, (QSet<int>{102, 103, 104, 97, 5, 11, 38, 83, 66, 67, 68, 69, 77, 118}));
    QCOMPARE(originalName(*findWord(set89, 102)), u"Pitch Pan Limiter"_s);
    QCOMPARE(findWord(set89, 5)->row->max, 100);
    QCOMPARE(findWord(set89, 67)->row->max, 5);  // "off"
    QVERIFY(!findWord(set89, 38) && !findWord(set89, 83));
    QCOMPARE(wordsOf(89), 125);
}

void TestStormTables::unknownLayoutsHaveNoTable()
{
    for (const int layout : {0, 66, 85, 87, 93, 94, 219, 223, 236})
        QVERIFY(!isKnownLayout(layout));
    // Their words are shown as numbers.
    QCOMPARE(wordsOf(66), 124);
    QCOMPARE(wordsOf(219), 125);
    QCOMPARE(wordsOf(236), 155);
    const ParameterSet raw(rawRows(236), blocksOf(236), 236, {});
    QCOMPARE(raw.all().size(), std::size_t(155));
    QCOMPARE(raw.find(u"word.154"_s)->offset, 308);
    QCOMPARE(splitStream(QByteArray(438, 'x'), 155).size(), std::size_t(2));
    QCOMPARE(splitStream(QByteArray(250, 'x'), 125).size(), std::size_t(1));
    QVERIFY(splitStream(QByteArray(251, 'x'), 125).empty());
}

void TestStormTables::keysAreUniqueAndNamesKnown()
{
    for (const int layout : {78, 89, 95}) {
        const ParameterSet set = setOf(layout);
        QSet<QString> keys;
        QSet<int> words;
        for (const ParameterSpec &spec : set.all()) {
            QVERIFY2(!keys.contains(spec.key) && !words.contains(spec.offset), qPrintable(spec.key));
            keys.insert(spec.key);
            words.insert(spec.offset);
            QVERIFY2(*spec.row->help && *spec.row->label && *spec.row->group
                         && !originalName(spec).contains(u'%'),
                     qPrintable(spec.key));
        }
        const ScriptContext context = scriptContext(set, layout);
        QCOMPARE(context.parameters.size(), set.all().size());
        const auto area
            = compileScripts({u"SET \"Pitch Pan\" 3\nSET \"Rc Yaw Min\" -450\nSTOP"_s, {}, {}, {}}, context);
        QVERIFY2(area, qPrintable(area ? QString() : area.error().error().detail));
        QCOMPARE(area->mid(4, 9).toHex(), "0a0403000a3d3efe00");
    }
}

void TestStormTables::valuesThatNobodyMaySet()
{
    for (const int layout : {78, 89, 95}) {
        const ParameterSet set = setOf(layout);
        for (const char *key : {"motor.pitch.poles", "motor.roll.poles", "motor.yaw.poles"}) {
            const ParameterSpec &poles = *set.find(QLatin1String(key));
            for (const int odd : {11, 13, 27, 29})
                QVERIFY(!poles.accepts(odd));
            for (const int even : {12, 14, 22, 28})
                QVERIFY(poles.accepts(even));
            QCOMPARE(poles.allowedText(), u"12 to 28 in steps of 2"_s);
            QCOMPARE(poles.clamped(13), 14.0);
            QCOMPARE(poles.clamped(40), 28.0);
        }
        for (const ParameterSpec &spec : set.all()) {
            QVERIFY2(spec.accepts(spec.defaultRaw), qPrintable(spec.key));
            for (const Choice &choice : spec.choices(layout))
                QVERIFY2(spec.row->kind != ValueKind::Choice || !spec.isInRange(choice.value)
                             || spec.accepts(choice.value),
                         qPrintable(spec.key));
        }
    }
}

// Errata 13: the firmware of layout 89 calls it so.
void TestStormTables::wordOfLayout89HasItsName()
{
    QCOMPARE(originalName(*findWord(setOf(89), 118)), u"Yaw Pan LPF"_s);
    QCOMPARE(originalName(*findWord(setOf(95), 118)), u"Yaw Pan Deadband LPF"_s);
}

void TestStormTables::axesLieWhereTheyShould()
{
    const ParameterSet set = setOf(95);
    QCOMPARE(set.find(u"pid.pitch.p"_s)->offset, 0);
    QCOMPARE(set.find(u"pid.roll.p"_s)->offset, 12);
    QCOMPARE(set.find(u"pid.yaw.d"_s)->offset, 28);
    QCOMPARE(set.find(u"motor.roll.usage"_s)->offset, 158);
    QCOMPARE(set.find(u"pid.roll.i"_s)->adjustable, 7);  // live: the number of the word
    QCOMPARE(set.find(u"motor.yaw.vmax"_s)->adjustable, 15);
    QCOMPARE(set.find(u"filter.gyro_lpf"_s)->adjustable, 100);
    QCOMPARE(set.find(u"script4.input"_s)->offset, 246);
    QCOMPARE(setOf(78).find(u"script4.input"_s)->offset, 244);
    QCOMPARE(set.find(u"rc.yaw.mode"_s)->axis, Axis::Yaw);
}

// Forward, left and up of each one make a right-handed frame, and the pair that tells them apart is unique
// (errata 10).
void TestStormTables::orientationsAreRightHanded()
{
    QCOMPARE(orientations().size(), std::size_t(24));
    for (std::size_t i = 0; i < 24; ++i) {
        const auto &[forward, left, up] = orientations()[i].axes;
        const std::array<int, 3> cross{forward[1] * left[2] - forward[2] * left[1],
                                       forward[2] * left[0] - forward[0] * left[2],
                                       forward[0] * left[1] - forward[1] * left[0]};
        QVERIFY2(cross == up, orientations()[i].name);
        QCOMPARE(findOrientation(up, forward), int(i));
        QCOMPARE(orientations()[i].code, int(i) + (i >= 12 ? 4 : 0));
    }
    QCOMPARE(findOrientation({1, 0, 0}, {1, 0, 0}), -1);
}

QTEST_GUILESS_MAIN(TestStormTables)
#include "tst_stormtables.moc"
