// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "tests/support/virtualboard.h"

#include <QSet>
#include <QTest>

#include <cmath>

using namespace simplebgc;
using namespace Qt::StringLiterals;

class TestTables : public QObject
{
    Q_OBJECT
private slots:
    void everyParameterIsComplete_data();
    void everyParameterIsComplete();
    void offsetsOfTheErrata_data();
    void offsetsOfTheErrata();
    void rampReadsAsTheErrataSays();
    void writesTouchOnlyTheirBits();
    void conversionsThereAndBack();
    void textsThereAndBack();
    void firmwareDecidesWhatThereIs();
    void capabilitiesDecideWhatThereIs();
    void adjustableVariablesMatchTheErrata();
    void rulesAreAboutWhatThereIs();
    void ordersForTwoAxesAreRuledOut();
    void gainsOfBothScalesAreTheSame();
    void channelKeysAreUnique();
};

void TestTables::everyParameterIsComplete_data()
{
    QTest::addColumn<int>("firmware");
    for (const int firmware : {2400, 2590, 2600, 2704, 2738})
        QTest::addRow("%d", firmware) << firmware;
}

void TestTables::everyParameterIsComplete()
{
    QFETCH(int, firmware);
    const ParameterSet set(parameterRows(), kBlocks, firmware, {u"encoders"_s});
    QSet<QString> keys;
    for (const ParameterSpec &spec : set.all()) {
        QVERIFY2(!keys.contains(spec.key), qPrintable(spec.key));
        keys.insert(spec.key);
        QVERIFY(*spec.row->label && *spec.row->group && *spec.row->help);
        QVERIFY2(!spec.key.contains(u'%'), qPrintable(spec.key));
        QVERIFY(set.find(spec.key) == &spec);
        QVERIFY(spec.offset + wireSize(spec.row->wire) <= set.block(spec.row->block)->size);
        if (!spec.row->state)
            QVERIFY(spec.isInRange(spec.defaultRaw));
        if (spec.row->kind == ValueKind::Choice && !spec.row->state) {
            bool known = false;
            for (const Choice &choice : spec.choices(firmware))
                known |= choice.value == spec.defaultRaw;
            QVERIFY2(known, qPrintable(spec.key));
        }
    }
    QVERIFY(set.all().size() > 200);
}

void TestTables::offsetsOfTheErrata_data()
{
    // Counted by hand in errata 3.4-3.6.
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("block");
    QTest::addColumn<int>("offset");
    const auto row = [](const QString &key, int block, int offset) {
        QTest::newRow(qPrintable(key)) << key << block << offset;
    };
    row(u"pid.roll.p"_s, 0, 1);
    row(u"pid.yaw.i"_s, 0, 14);
    row(u"motor.yaw.poles"_s, 0, 18);
    row(u"rc.pitch.min_angle"_s, 0, 30);
    row(u"rc.yaw.follow"_s, 0, 45);
    row(u"imu.gyro_trust"_s, 0, 46);
    row(u"rc.map.cmd"_s, 0, 59);
    row(u"imu.main.axis_top"_s, 0, 70);
    row(u"service.button.press5"_s, 0, 86);
    row(u"battery.alarm"_s, 0, 91);
    row(u"rc.yaw.memory"_s, 0, 111);
    row(u"service.servo4.source"_s, 0, 116);
    row(u"board.flags1"_s, 0, 125);
    row(u"state.profile"_s, 0, 133);
    row(u"filter.roll.notch1.frequency"_s, 1, 1);
    row(u"filter.yaw.notch3.width"_s, 1, 18);
    row(u"filter.pitch.lpf"_s, 1, 21);
    row(u"encoder.yaw.field_offset"_s, 1, 38);
    row(u"motor.yaw.gearing"_s, 1, 59);
    row(u"filter.yaw.notch3.gain"_s, 1, 75);
    row(u"encoder.roll.geared"_s, 1, 83);
    row(u"filter.yaw.d_lpf"_s, 1, 103);
    row(u"motor.yaw.magnetic_link"_s, 2, 21);
    row(u"motion.yaw.acc_limit"_s, 2, 25);
    row(u"mavlink.channel2.rate"_s, 2, 12);
    row(u"mavlink.channel2.options"_s, 2, 12);
    row(u"limit.yaw.max"_s, 2, 42);
    row(u"step6.trigger"_s, 2, 112);
    row(u"rccal5.scale_positive"_s, 2, 132);
    row(u"imu.middle_motor_tilt"_s, 2, 150);
}

void TestTables::offsetsOfTheErrata()
{
    QFETCH(QString, key);
    QFETCH(int, block);
    QFETCH(int, offset);
    const ParameterSet set(parameterRows(), kBlocks, 2704, {u"encoders"_s});
    const ParameterSpec *spec = set.find(key);
    QVERIFY(spec);
    QCOMPARE(int(spec->row->block), block);
    QCOMPARE(spec->offset, offset);
}

void TestTables::rampReadsAsTheErrataSays()
{
    // Errata section 8: POLES[YAW] = 18; RC_MIN_ANGLE[PITCH] = 7966; BAT_THRESHOLD_ALARM = 23643;
    // CUR_PROFILE_ID = 133.
    const QByteArray bytes = ramp(134);
    const ParameterSet set(parameterRows(), kBlocks, 2590, {});
    QCOMPARE(*set.find(u"motor.yaw.poles"_s)->read(bytes), 18);
    QCOMPARE(*set.find(u"rc.pitch.min_angle"_s)->read(bytes), 7966);
    QCOMPARE(*set.find(u"battery.alarm"_s)->read(bytes), 23643);
    QCOMPARE(*set.find(u"state.profile"_s)->read(bytes), 133);
    QVERIFY(!set.find(u"state.profile"_s)->read(bytes.first(133)));
}

void TestTables::writesTouchOnlyTheirBits()
{
    const ParameterSet set(parameterRows(), kBlocks, 2704, {u"encoders"_s});
    for (const ParameterSpec &spec : set.all()) {
        for (const char fill : {'\x00', '\xFF', '\x5A'}) {
            QByteArray block(set.block(spec.row->block)->size, fill);
            const QByteArray before = block;
            QVERIFY(spec.write(block, spec.row->max));
            QCOMPARE(*spec.read(block), spec.row->max);
            for (int i = 0; i < block.size(); ++i) {
                if (i < spec.offset || i >= spec.offset + wireSize(spec.row->wire))
                    QCOMPARE(block[i], before[i]);
            }
            if (spec.row->bitCount) {
                const int mask = ((1 << spec.row->bitCount) - 1) << spec.row->bitShift;
                QCOMPARE(quint8(block[spec.offset]) & ~mask & 0xFF,
                         quint8(before[spec.offset]) & ~mask & 0xFF);
            }
        }
    }
}

void TestTables::conversionsThereAndBack()
{
    for (const int firmware : {2590, 2738}) {
        const ParameterSet set(parameterRows(), kBlocks, firmware, {u"encoders"_s});
        for (const ParameterSpec &spec : set.all()) {
            for (double raw = spec.row->min; raw <= spec.row->max;
                 raw += std::max(1.0, std::floor((spec.row->max - spec.row->min) / 500)))
                QCOMPARE(spec.toRaw(spec.toDisplay(raw)), raw);
        }
    }
    // Errata 3.3: shown = 5 exp(v ln 52 / 255) - 5.
    const ParameterSet later(parameterRows(), kBlocks, 2738, {});
    QCOMPARE(later.find(u"pid.roll.p"_s)->toDisplay(0), 0.0);
    QVERIFY(std::abs(later.find(u"pid.roll.p"_s)->toDisplay(255) - 255.0) < 1e-9);
}

void TestTables::textsThereAndBack()
{
    const ParameterSet set(parameterRows(), kBlocks, 2590, {});
    QCOMPARE(set.find(u"pid.roll.i"_s)->format(18), u"0.18"_s);
    QCOMPARE(*set.find(u"pid.roll.i"_s)->parse(u"0.18"_s), 18);
    QCOMPARE(set.find(u"motor.roll.invert"_s)->format(1), u"on"_s);
    QCOMPARE(*set.find(u"motor.roll.invert"_s)->parse(u"off"_s), 0);
    QCOMPARE(set.find(u"board.flags1"_s)->format(0x410), u"0x0410"_s);
    QCOMPARE(*set.find(u"board.flags1"_s)->parse(u"0x0410"_s), 0x410);
    QCOMPARE(*set.find(u"rc.roll.mode"_s)->parse(u"speed"_s), 1);
    for (const QString &nonsense : {u"high"_s, u""_s, u"nan"_s, u"1e999"_s})
        QVERIFY(!set.find(u"pid.roll.p"_s)->parse(nonsense));
    for (const ParameterSpec &spec : set.all()) {
        for (const double raw : {spec.row->min, spec.row->max})
            QVERIFY2(*spec.parse(spec.format(raw)) == raw, qPrintable(spec.key));
    }
}

void TestTables::firmwareDecidesWhatThereIs()
{
    const ParameterSet seed(parameterRows(), kBlocks, 2590, {});
    const ParameterSet later(parameterRows(), kBlocks, 2704, {u"encoders"_s});
    QVERIFY(seed.find(u"port.i2c_pullups"_s) && !later.find(u"port.i2c_pullups"_s));
    QVERIFY(!seed.find(u"port.i2c_fast"_s) && later.find(u"port.i2c_fast"_s));
    QCOMPARE(seed.find(u"rc.roll.lpf"_s)->row->max, 15);
    QCOMPARE(later.find(u"rc.roll.lpf"_s)->row->max, 255);
    QVERIFY(!seed.find(u"limit.roll.min"_s) && later.find(u"limit.roll.min"_s));
    // Errata 6, row 28: menu actions 13 and 28-32 are not offered on 2.5x.
    for (const Choice &choice : seed.find(u"service.rc_low"_s)->choices(2590))
        QVERIFY(choice.value != 13 && choice.value != 28);
}

void TestTables::capabilitiesDecideWhatThereIs()
{
    const ParameterSet plain(parameterRows(), kBlocks, 2590, {});
    const ParameterSet encoders(parameterRows(), kBlocks, 2590, {u"encoders"_s});
    QVERIFY(!plain.find(u"encoder.roll.offset"_s));
    QVERIFY(encoders.find(u"encoder.roll.offset"_s));
    QCOMPARE(encoders.find(u"encoder.roll.offset"_s)->row->risk, Risk::Red);
}

void TestTables::rulesAreAboutWhatThereIs()
{
    const ParameterSet set(parameterRows(), kBlocks, 2590, {u"yaw-axis"_s, u"encoders"_s}, valueRules());
    QCOMPARE(set.rules().size(), valueRules().size());
    for (const ValueRule &rule : set.rules()) {
        QVERIFY2(set.find(QLatin1String(rule.first)), rule.first);
        QVERIFY2(!*rule.second || set.find(QLatin1String(rule.second)), rule.second);
        QVERIFY(*rule.why && rule.isBroken);
    }
}

// The document's note to EULER_ORDER; later firmware knows them for three axes.
void TestTables::ordersForTwoAxesAreRuledOut()
{
    const auto isRuledOut = [](int firmware, const Capabilities &capabilities, double order) {
        const ParameterSet set(parameterRows(), kBlocks, firmware, capabilities, valueRules());
        return std::any_of(set.rules().begin(), set.rules().end(), [order](const ValueRule &rule) {
            return rule.concerns(u"imu.euler_order"_s) && rule.isBroken(order, 0);
        });
    };
    QVERIFY(isRuledOut(2590, {u"yaw-axis"_s}, 2));
    QVERIFY(isRuledOut(2590, {u"yaw-axis"_s}, 3));
    QVERIFY(!isRuledOut(2590, {u"yaw-axis"_s}, 1));
    QVERIFY(!isRuledOut(2590, {}, 2));
    QVERIFY(!isRuledOut(2704, {u"yaw-axis"_s}, 2));
}

// Errata 3.3: a board of 2.73.1 starts with the same gains, in another scale.
void TestTables::gainsOfBothScalesAreTheSame()
{
    const ParameterSet linear(parameterRows(), kBlocks, 2704, {});
    const ParameterSet logarithmic(parameterRows(), kBlocks, 2731, {});
    for (const char *axis : {"roll", "pitch", "yaw"}) {
        for (const char *gain : {"p", "i", "d", "gain"}) {
            const QString key = u"pid.%1.%2"_s.arg(QLatin1String(axis), QLatin1String(gain));
            const auto shown = [&key](const ParameterSet &set) {
                const ParameterSpec *spec = set.find(key);
                return spec->toDisplay(spec->defaultRaw);
            };
            // I was in hundredths of the units of P.
            const double factor = *gain == 'i' ? 100 : 1;
            QVERIFY2(std::abs(shown(linear) * factor / shown(logarithmic) - 1) < 0.03, qPrintable(key));
        }
    }
}

void TestTables::adjustableVariablesMatchTheErrata()
{
    const ParameterSet set(parameterRows(), kBlocks, 2704, {});
    const std::pair<const char *, int> expected[] = {{"pid.roll.p", 0},
                                                     {"pid.yaw.i", 5},
                                                     {"pid.pitch.d", 7},
                                                     {"motor.yaw.power", 11},
                                                     {"motion.acc_limit_all", 12},
                                                     {"follow.yaw.speed", 15},
                                                     {"follow.roll.lpf", 16},
                                                     {"rc.pitch.speed", 20},
                                                     {"rc.yaw.lpf", 24},
                                                     {"rc.roll.trim", 25},
                                                     {"rc.deadband", 28},
                                                     {"rc.expo", 29},
                                                     {"follow.deadband", 32},
                                                     {"imu.gyro_trust", 36},
                                                     {"motion.yaw.acc_limit", 41},
                                                     {"pid.roll.gain", 42},
                                                     {"filter.yaw.lpf", 47},
                                                     {"motion.timelapse_time", 48}};
    for (const auto &[key, id] : expected)
        QCOMPARE(set.find(QLatin1String(key))->adjustable, id);
}

void TestTables::channelKeysAreUnique()
{
    QSet<QString> keys;
    for (const ChannelSpec &spec : channelTable()) {
        QVERIFY(!keys.contains(QLatin1String(spec.key)));
        keys.insert(QLatin1String(spec.key));
        QVERIFY(*spec.label && *spec.group);
    }
    QCOMPARE(findChannel(channelTable(), u"imu.angle.yaw"_s), int(ImuYaw));
    QCOMPARE(findChannel(channelTable(), u"nonsense"_s), -1);
}

QTEST_APPLESS_MAIN(TestTables)
#include "tst_tables.moc"
