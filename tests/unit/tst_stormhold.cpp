// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/parametertables.h"
#include "protocol/storm32/telemetrytables.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/stormrig.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr int kUnlimitedAngle = 2;
constexpr int kPulse = 3;
constexpr int kHoldHoldHold = 2;  // pan modes of the command (errata 4, 13)
constexpr int kPanPanPan = 3;
constexpr int kPanDefault = 66;  // words (errata 11)
constexpr int kPitchOffset = 106;
constexpr int kYawOffset = 108;

const QStringList kAll{u"roll"_s, u"pitch"_s, u"yaw"_s};

}  // namespace

/// The set-point that holds a STorM32's camera where it is: an angle is only given where nothing else
/// contributes to the position, because the board adds up what it is told (errata 4).
class TestStormHold : public QObject
{
    Q_OBJECT
private slots:
    void anglesThatHoldAreKnownOrLeftOut_data();
    void anglesThatHoldAreKnownOrLeftOut();
    void whatHappenedBeforeTheLinkIsNotKnown_data();
    void whatHappenedBeforeTheLinkIsNotKnown();

private:
    bool meet();
    void look(double seconds);
    bool perform(const QString &action, const QVariantMap &arguments = {});
    std::array<double, kAxisCount> angles();
    SteeringSetpoint holdingSetpoint(int mode, SteeredBefore steeredBefore)
    {
        return m_rig->device.holdingSetpoint(mode, *m_store, steeredBefore);
    }

    std::unique_ptr<StormRig> m_rig;
    std::unique_ptr<TelemetryStore> m_store;
    std::optional<TelemetryPlan> m_plan;
};

/// A new link to the board: all that was known of it is forgotten.
bool TestStormHold::meet()
{
    storm32::Device &device = m_rig->device;
    if (!device.identify(m_rig->channel) || !device.readConfiguration(m_rig->channel))
        return false;
    m_store = std::make_unique<TelemetryStore>(int(device.channels().size()));
    const auto plan = device.subscribe(m_rig->channel, {}, {});
    if (!plan)
        return false;
    m_plan = *plan;
    // Virtual time, counted from where the store begins.
    const Duration ahead = m_store->origin() + 1s - m_rig->channel.now();
    m_rig->channel.setTap([this, ahead](const FrameView &frame, TimePoint at) {
        m_plan->decoder->decode(frame, at + ahead, *m_store);
    });
    return true;
}

/// The telemetry of so many seconds.
void TestStormHold::look(double seconds)
{
    const TimePoint until = m_rig->channel.now() + durationFromSeconds(seconds);
    while (m_rig->channel.now() < until)
        std::ignore = m_rig->channel.transact(*m_plan->poll);
}

bool TestStormHold::perform(const QString &action, const QVariantMap &arguments)
{
    return m_rig->device.perform(m_rig->channel, action, arguments).has_value();
}

std::array<double, kAxisCount> TestStormHold::angles()
{
    std::array<double, kAxisCount> values{};
    for (std::size_t axis = 0; axis < values.size(); ++axis)
        values[axis] = double(m_store->latest(storm32::AngleRoll + int(axis)));
    return values;
}

void TestStormHold::anglesThatHoldAreKnownOrLeftOut_data()
{
    using Words = QMap<int, int>;
    QTest::addColumn<int>("firmware");
    QTest::addColumn<Words>("words");  // in use when the board starts
    QTest::addColumn<QString>("then");
    QTest::addColumn<QStringList>("known");
    for (const int firmware : {79, 90, 96}) {
        const auto row = [firmware](const char *name, const Words &words, const QString &then,
                                    const QStringList &known) {
            QTest::addRow("0.%d, %s", firmware, name) << firmware << words << then << known;
        };
        const QStringList level{u"roll"_s, u"pitch"_s};
        row("all held", {{kPanDefault, 1}}, {}, kAll);
        row("yaw pans", {}, {}, level);
        row("yaw has panned", {}, u"hold"_s, level);
        row("all have panned", {{kPanDefault, 1}}, u"pan and hold"_s, {});
        row("pitch offset", {{kPanDefault, 1}, {kPitchOffset, 50}}, {}, {u"roll"_s, u"yaw"_s});
        row("yaw offset, written later", {{kPanDefault, 1}}, u"offset"_s, level);
        row("a stick is moved", {{kPanDefault, 1}}, u"stick"_s, level);
    }
}

void TestStormHold::anglesThatHoldAreKnownOrLeftOut()
{
    using Words = QMap<int, int>;
    QFETCH(const int, firmware);
    QFETCH(const Words, words);
    QFETCH(const QString, then);
    QFETCH(const QStringList, known);
    m_rig = std::make_unique<StormRig>(stormOptions(firmware));
    for (auto word = words.begin(); word != words.end(); ++word)
        m_rig->board().set(word.key(), word.value());
    storm32::Device &device = m_rig->device;
    QVERIFY(meet());
    look(5);  // in a hand

    if (then == u"hold") {
        QVERIFY(perform(u"pan.mode"_s, {{u"mode"_s, kHoldHoldHold}}));
    } else if (then == u"pan and hold") {
        QVERIFY(perform(u"pan.mode"_s, {{u"mode"_s, kPanPanPan}}));
        look(4);
        QVERIFY(perform(u"pan.mode"_s, {{u"mode"_s, kHoldHoldHold}}));
    } else if (then == u"offset") {
        const BlockKey key{0, storm32::Parameters};
        auto block = device.readBlock(m_rig->channel, key);
        QVERIFY(block);
        block->replace(2 * kYawOffset, 2, ByteWriter().u16(80).take());
        QVERIFY(device.writeBlock(m_rig->channel, key, *block));
        QVERIFY(device.readBlock(m_rig->channel, key) == block);  // verified, as after every write
    } else if (then == u"stick") {
        QVERIFY(perform(u"sticks"_s, {{u"pitch"_s, 1500}, {u"roll"_s, 1500}, {u"yaw"_s, 1620}}));
    }
    m_rig->change(u"shake=0"_s);
    look(12);

    const auto before = angles();
    const SteeringSetpoint hold = holdingSetpoint(kUnlimitedAngle, SteeredBefore::Never);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const QString &name = kAll[qsizetype(axis)];
        QVERIFY2(std::isnan(hold.inputs[axis]) != known.contains(name), qPrintable(name));
        QVERIFY2(std::isnan(hold.inputs[axis]) || qAbs(hold.inputs[axis] - before[axis]) < 1e-3,
                 qPrintable(name));
    }
    // Sent, it moves nothing; what is not known is not sent. Stick positions are always known.
    for (const int mode : {kUnlimitedAngle, kPulse}) {
        const QByteArray frame = device.controlFrames(holdingSetpoint(mode, SteeredBefore::Never)).setpoint;
        QCOMPARE(frame.isEmpty(), mode == kUnlimitedAngle && known != kAll);
        if (frame.isEmpty())
            continue;
        Request request;
        request.bytes = frame;
        m_rig->channel.post(request);
        look(3);
        for (std::size_t axis = 0; axis < kAxisCount; ++axis)
            QVERIFY2(qAbs(angles()[axis] - before[axis]) < 0.3, qPrintable(kAll[qsizetype(axis)]));
    }
}

void TestStormHold::whatHappenedBeforeTheLinkIsNotKnown_data()
{
    QTest::addColumn<int>("firmware");
    for (const int firmware : {79, 90, 96})
        QTest::addRow("0.%d", firmware) << firmware;
}

// Axes that followed the handle and are held again look like those that never did.
void TestStormHold::whatHappenedBeforeTheLinkIsNotKnown()
{
    QFETCH(const int, firmware);
    m_rig = std::make_unique<StormRig>(stormOptions(firmware));
    m_rig->board().set(kPanDefault, 1);
    QVERIFY(meet());
    look(12);
    QVERIFY(perform(u"pan.mode"_s, {{u"mode"_s, kPanPanPan}}));
    look(4);
    QVERIFY(perform(u"pan.mode"_s, {{u"mode"_s, kHoldHoldHold}}));
    m_rig->change(u"shake=0"_s);
    look(12);
    const auto unknown = [this](SteeredBefore steeredBefore) {
        const SteeringSetpoint hold = holdingSetpoint(kUnlimitedAngle, steeredBefore);
        return std::count_if(hold.inputs.begin(), hold.inputs.end(),
                             [](double input) { return std::isnan(input); });
    };
    for (int link = 0; link < 2; ++link) {
        // This link has seen it, whatever the operator says; the next one has not.
        QCOMPARE(unknown(SteeredBefore::Unknown), 3);
        QCOMPARE(unknown(SteeredBefore::Never), link == 0 ? 3 : 0);
        QVERIFY(meet());
        look(1);
    }
    // Standby is no start.
    QVERIFY(perform(u"standby"_s, {{u"on"_s, true}}));
    look(2);
    QVERIFY(perform(u"standby"_s, {{u"on"_s, false}}));
    look(5);
    QCOMPARE(unknown(SteeredBefore::Unknown), 3);
    // A board that starts has not panned.
    QVERIFY(perform(u"restart"_s));
    m_rig->board().set(kPanDefault, 1);
    QVERIFY(meet());
    look(12);
    QCOMPARE(unknown(SteeredBefore::Unknown), 0);
    // Nobody knows what it did while nothing was heard of it.
    QVERIFY(m_rig->channel.sleep(2s));
    look(1);
    QCOMPARE(unknown(SteeredBefore::Unknown), 3);
}

QTEST_GUILESS_MAIN(TestStormHold)
#include "tst_stormhold.moc"
