// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/device/telemetrystore.h"
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/transport/portlist.h"
#include "tests/support/virtualboard.h"

#include <QSet>
#include <QTest>

#include <cmath>
#include <thread>

using namespace sbgc;
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
    void channelKeysAreUnique();
    void addressesThereAndBack_data();
    void addressesThereAndBack();
    void badAddressesAreExplained();
    void portsAreNamedWithTheirNumbers();
    void storeKeepsEverySample();
    void storeIsReadWhileItIsWritten();
    void storeForgetsWhatIsTooOld();
    void sampleClockIgnoresLateArrival();
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
    row(u"mavlink.channel2.flags"_s, 2, 12);
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
            for (int raw = spec.row->min; raw <= spec.row->max;
                 raw += std::max(1, (spec.row->max - spec.row->min) / 500))
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
        for (const int raw : {spec.row->min, spec.row->max}) {
            if (spec.row->kind != ValueKind::Number || spec.row->decimals > 0 || spec.row->scale >= 1.0)
                QVERIFY2(std::abs(*spec.parse(spec.format(raw)) - raw) <= 1, qPrintable(spec.key));
        }
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

void TestTables::addressesThereAndBack_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("normal");
    QTest::newRow("serial") << u"serial:/dev/ttyUSB0?baud=115200&parity=none"_s
                            << u"serial:/dev/ttyUSB0?baud=115200&parity=none"_s;
    QTest::newRow("bare path") << u"/dev/ttyACM0"_s << u"serial:/dev/ttyACM0"_s;
    QTest::newRow("windows") << u"COM3"_s << u"serial:COM3"_s;
    QTest::newRow("tcp") << u"tcp://192.168.4.1:23"_s << u"tcp://192.168.4.1:23"_s;
    QTest::newRow("tcp6") << u"tcp://[::1]:2020"_s << u"tcp://[::1]:2020"_s;
    QTest::newRow("udp") << u"udp://drone:2020"_s << u"udp://drone:2020"_s;
    QTest::newRow("sim") << u"sim:simplebgc?seed=1"_s << u"sim:simplebgc?seed=1"_s;
}

void TestTables::addressesThereAndBack()
{
    QFETCH(QString, text);
    QFETCH(QString, normal);
    const auto address = LinkAddress::parse(text);
    QVERIFY(address);
    QCOMPARE(address->toString(), normal);
    QCOMPARE(*LinkAddress::parse(normal), *address);
}

void TestTables::badAddressesAreExplained()
{
    for (const QString &text :
         {u""_s, u"nonsense"_s, u"tcp://host"_s, u"tcp://:99"_s, u"tcp://a:70000"_s, u"sim:"_s, u"serial:"_s,
          u"serial:/dev/x?baud=fast"_s, u"serial:/dev/x?parity=odd"_s, u"tcp://host:1/path"_s,
          u"sim:simplebgc?seed="_s}) {
        const auto address = LinkAddress::parse(text);
        QVERIFY2(!address, qPrintable(text));
        QCOMPARE(address.error().code, ErrorCode::InvalidArgument);
        QVERIFY(!address.error().detail.isEmpty());
    }
}

void TestTables::portsAreNamedWithTheirNumbers()
{
    QCOMPARE((PortInfo{u"/dev/ttyUSB0"_s, u"CP2102"_s, 0x10C4, 0xEA60}.label()),
             u"/dev/ttyUSB0 – CP2102 – 10C4:EA60"_s);
    QCOMPARE((PortInfo{u"/dev/ttyS0"_s, {}, 0, 0}.label()), u"/dev/ttyS0"_s);
}

void TestTables::storeKeepsEverySample()
{
    TelemetryStore store(4);
    const auto group = store.defineGroup({1, 3}, 0.001);
    for (int i = 0; i < 5000; ++i) {
        const float row[] = {float(i), float(-i)};
        store.append(*group, store.origin() + std::chrono::milliseconds(i), row);
    }
    auto tracks = store.tracks(3);
    QCOMPARE(tracks.size(), std::size_t(1));
    QCOMPARE(tracks[0].end(), std::size_t(5000));
    for (std::size_t i = 0; i < 5000; ++i) {
        QCOMPARE(tracks[0].value(i), -float(i));
        QVERIFY(std::abs(tracks[0].time(i) - double(i) * 0.001) < 1e-9);
    }
    QCOMPARE(tracks[0].rowAt(2.5), std::size_t(2500));
    QCOMPARE(tracks[0].rowAt(-1), std::size_t(0));
    QCOMPARE(tracks[0].rowAt(99), std::size_t(5000));
    QCOMPARE(store.latest(1), 4999.0F);
    QVERIFY(std::isnan(store.latest(0)));
    QVERIFY(std::isnan(store.latest(77)));
    QVERIFY(store.tracks(0).empty());
    store.appendGap(*group, store.origin() + 6s);
    tracks[0].refresh();
    QVERIFY(std::isnan(tracks[0].value(5000)));
}

void TestTables::storeIsReadWhileItIsWritten()
{
    TelemetryStore store(1);
    const auto group = store.defineGroup({0}, 0.001);
    constexpr int kRows = 200000;
    std::thread writer([&] {
        for (int i = 0; i < kRows; ++i) {
            const float row[] = {float(i)};
            store.append(*group, store.origin() + std::chrono::microseconds(i), row);
        }
    });
    auto tracks = store.tracks(0);
    std::size_t next = 0;
    bool right = true;
    while (next < kRows) {
        tracks[0].refresh();
        for (; next < tracks[0].end(); ++next)
            right &= tracks[0].value(next) == float(next);
    }
    writer.join();
    QVERIFY(right);
}

void TestTables::storeForgetsWhatIsTooOld()
{
    TelemetryStore store(1);
    store.setRetention(10.0);
    const auto group = store.defineGroup({0}, 0.01);
    for (int i = 0; i < 6000; ++i) {
        const float row[] = {float(i)};
        store.append(*group, store.origin() + std::chrono::milliseconds(10 * i), row);
    }
    const auto tracks = store.tracks(0);
    QVERIFY(tracks[0].begin() > 0);
    QVERIFY(tracks[0].time(tracks[0].begin()) <= 50.0);
    QVERIFY(tracks[0].time(tracks[0].begin()) > 35.0);
    QCOMPARE(tracks[0].value(tracks[0].begin()), float(tracks[0].begin()));
}

void TestTables::sampleClockIgnoresLateArrival()
{
    SampleClock clock(0.001);
    double worst = 0;
    double last = clock.next(0.0);
    for (int i = 1; i < 3000; ++i) {
        // A reader that was busy gets 80 samples at once, each 80 ms.
        const double time = clock.next(std::ceil(i / 80.0) * 0.080);
        worst = std::max(worst, std::abs(time - last - 0.001));
        last = time;
    }
    QVERIFY2(worst < 0.002, qPrintable(QString::number(worst)));
    QVERIFY(std::abs(last - 3.0) < 0.1);
}

QTEST_APPLESS_MAIN(TestTables)
#include "tst_tables.moc"
