// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"
#include "tests/support/virtualboard.h"
#include "widgets/models/thinningtext.h"

#include <QTest>

#include <cmath>

using namespace simplebgc;
using namespace Qt::StringLiterals;

namespace {

Request fireAndForget(const QByteArray &bytes)
{
    Request request;
    request.bytes = bytes;
    return request;
}

}  // namespace

/// Live data of a SimpleBGC board, on the simulated one in virtual time.
class TestSbgcStreams : public QObject
{
    Q_OBJECT
private slots:
    void streamsAtFullRateWithoutLoss();
    void oldFirmwareIsPolled();
    void pollsWhenAllStreamsAreTaken();
    void streamFitsASlowLine();
    void lostFramesAreCountedAsGaps();
    void streamsChosenByHandAllRun();
    void laterFieldsAreFoundByAsking_data();
    void laterFieldsAreFoundByAsking();
    void eachFlagOfCustomDelivers();
    void streamsThatDoNotFitAreRefused_data();
    void streamsThatDoNotFitAreRefused();
    void wireRatesAreThoseOfTheTable_data();
    void wireRatesAreThoseOfTheTable();
    void lossIsFound_data();
    void lossIsFound();
    void silenceIsNoLoss_data();
    void silenceIsNoLoss();
    void slowLinesThinOut_data();
    void slowLinesThinOut();
    void leftoversAreStopped_data();
    void leftoversAreStopped();
    void whatCannotBeStoppedIsTold();
    void foreignCustomIsNotTakenForOurs();
};

void TestSbgcStreams::streamsAtFullRateWithoutLoss()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    TelemetryStore store(int(bench.device.channels().size()));
    const ChannelRoles roles = rolesOf(bench.device);
    const QList<int> wanted{roles.angle[0], roles.gyro[1]};
    const auto plan = bench.device.subscribe(bench.channel, {wanted, 0}, {});
    QVERIFY(plan);
    QVERIFY(plan->streaming);
    QCOMPARE(plan->rate, 1250.0);
    bench.channel.setTap(
        [&](const FrameView &frame, TimePoint at) { plan->decoder->decode(frame, at, store); });
    std::ignore = bench.channel.sleep(4s);
    // A long read in between costs nothing.
    QVERIFY(bench.device.readConfiguration(bench.channel));
    const auto tracks = store.tracks(roles.gyro[1]);
    QCOMPARE(tracks.size(), std::size_t(1));
    QVERIFY(tracks[0].end() >= 5000);
    QCOMPARE(store.lost(), quint64(0));
    // Samples are evenly spaced, not at their times of arrival.
    for (std::size_t row = 1000; row < 4000; ++row) {
        const double step = tracks[0].time(row) - tracks[0].time(row - 1);
        QVERIFY2(std::abs(step - 0.0008) < 0.0002, qPrintable(QString::number(step)));
    }
    // Status channels come beside the fast ones.
    QVERIFY(std::abs(double(store.latest(roles.battery)) - 12.3) < 0.3);
    bench.channel.post(fireAndForget(plan->shutdownFrames));
    std::ignore = bench.channel.sleep(100ms);
    const auto rows = store.rows();
    std::ignore = bench.channel.sleep(500ms);
    QVERIFY(store.rows() <= rows + 1);
}

void TestSbgcStreams::oldFirmwareIsPolled()
{
    VirtualBoard bench(withFirmware(2439));
    QVERIFY(bench.identify());
    const auto plan = bench.device.subscribe(bench.channel, {}, {});
    QVERIFY(plan);
    QVERIFY(!plan->streaming);
    QVERIFY(plan->poll);
    TelemetryStore store(int(bench.device.channels().size()));
    const auto reply = bench.channel.transact(*plan->poll);
    QVERIFY(reply);
    plan->decoder->decode({reply->id, asBytes(reply->payload), 1}, bench.channel.now(), store);
    QVERIFY(double(store.latest(rolesOf(bench.device).battery)) > 11.0);
    QVERIFY(bench.device.fastChannels().isEmpty());
}

void TestSbgcStreams::pollsWhenAllStreamsAreTaken()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    // The board has ten streams (errata 3.10); somebody else holds them all.
    for (int i = 0; i < 10; ++i) {
        const DataStream taken{88, 1000, QByteArray(1, char(1 + i)) + QByteArray(7, '\0')};
        QVERIFY(bench.channel.transact(confirmRequest(CommandId::DataStreamInterval, taken.encode(), 1)));
    }
    const auto plan = bench.device.subscribe(bench.channel, {{rolesOf(bench.device).gyro[0]}, 0}, {});
    QVERIFY(plan);
    QVERIFY(!plan->streaming && plan->poll);
}

void TestSbgcStreams::streamFitsASlowLine()
{
    SimulatorOptions o;
    o.usb = false;
    const LineSettings line{115200, Parity::None};
    VirtualBoard bench(o, line);
    std::ignore = bench.channel.setLine(line);
    QVERIFY(bench.identify());
    const ChannelRoles roles = rolesOf(bench.device);
    const auto plan
        = bench.device.subscribe(bench.channel, {{roles.angle[0], roles.target[0], roles.gyro[0]}, 0}, line);
    QVERIFY(plan);
    // 25 bytes a frame: 443/s would fill the line (performance notes, section 1); some is left for requests.
    QVERIFY2(plan->rate > 280 && plan->rate < 400, qPrintable(QString::number(plan->rate)));
    TelemetryStore store(int(bench.device.channels().size()));
    bench.channel.setTap(
        [&](const FrameView &frame, TimePoint at) { plan->decoder->decode(frame, at, store); });
    std::ignore = bench.channel.sleep(3s);
    QCOMPARE(store.lost(), quint64(0));
    QVERIFY(store.tracks(roles.gyro[0])[0].end() > std::size_t(2.5 * plan->rate));
}

void TestSbgcStreams::lostFramesAreCountedAsGaps()
{
    SimulatorOptions o;
    o.faults.loseByte = 0.0006;
    o.seed = 4;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    const ChannelRoles roles = rolesOf(bench.device);
    const auto plan = bench.device.subscribe(bench.channel, {{roles.gyro[0]}, 0}, {});
    QVERIFY(plan);
    TelemetryStore store(int(bench.device.channels().size()));
    quint64 frames = 0;
    bench.channel.setTap([&](const FrameView &frame, TimePoint at) {
        frames += frame.id == 88;
        plan->decoder->decode(frame, at, store);
    });
    const TimePoint start = bench.channel.now();
    std::ignore = bench.channel.sleep(8s);
    const double sent = seconds(bench.channel.now() - start) * 1250.0;
    QVERIFY(store.lost() > 20);
    QVERIFY2(std::abs(double(frames + store.lost()) - sent) < 0.01 * sent,
             qPrintable(u"%1 + %2 of %3"_s.arg(frames).arg(store.lost()).arg(sent)));
}

void TestSbgcStreams::streamsChosenByHandAllRun()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const ChannelRoles roles = rolesOf(bench.device);
    // clang-format off
    const Subscription wish{{}, 0, {{u"custom"_s, 500, {roles.gyro[0]}}, {u"realtime4"_s, 200, {}}, {u"realtime3"_s, 50, {}},
                                     {u"helper"_s, 100, {}}}};
    // clang-format on
    const auto plan = bench.device.subscribe(bench.channel, wish, {});
    QVERIFY(plan);
    QCOMPARE(plan->budget.streams.size(), std::size_t(4));
    QCOMPARE(plan->rate, 500.0);
    TelemetryStore store(int(bench.device.channels().size()));
    QMap<int, int> frames;
    bench.channel.setTap([&](const FrameView &frame, TimePoint at) {
        ++frames[frame.id];
        plan->decoder->decode(frame, at, store);
    });
    std::ignore = bench.channel.sleep(4s);
    QVERIFY(std::abs(frames[88] - 2000) < 20 && std::abs(frames[25] - 800) < 10);
    QVERIFY(std::abs(frames[23] - 200) < 5 && std::abs(frames[56] - 400) < 6);
    QCOMPARE(store.lost(), quint64(0));
    QCOMPARE(store.silences(), quint64(0));
    // Each channel comes from the fastest stream that has it, and only from there.
    const auto periodOf = [&](const char *key) {
        const auto tracks = store.tracks(findChannel(bench.device.channels(), QString::fromLatin1(key)));
        return tracks.size() == 1 ? tracks[0].period() : -1.0;
    };
    QCOMPARE(periodOf("gyro.roll"), 0.002);
    QCOMPARE(periodOf("imu.angle.roll"), 0.005);
    QCOMPARE(periodOf("battery"), 0.005);
    QCOMPARE(periodOf("z1.z"), 0.01);
    QVERIFY(std::abs(double(store.latest(findChannel(bench.device.channels(), u"z1.z"_s))) - 1.0) < 0.05);
    // The shutdownFrames stops them all.
    QCOMPARE(plan->shutdownFrames.count(char(0x55)) >= 4, true);
    bench.channel.post(fireAndForget(plan->shutdownFrames));
    std::ignore = bench.channel.sleep(100ms);
    frames.clear();
    std::ignore = bench.channel.sleep(500ms);
    QCOMPARE(frames.value(88) + frames.value(25) + frames.value(23) + frames.value(56), 0);
}

void TestSbgcStreams::laterFieldsAreFoundByAsking_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<quint32>("flags");
    QTest::newRow("2.59") << 2590 << quint32(0x1FF);
    QTest::newRow("2.66, none of the later ones") << 2660 << quint32(0x1FF);
    QTest::newRow("2.70, some of them") << 2700 << quint32(0x1FFFFF);
    QTest::newRow("2.73, all that are described") << 2739 << quint32(0x1FFFFFFF);
}

void TestSbgcStreams::laterFieldsAreFoundByAsking()
{
    QFETCH(int, firmware);
    QFETCH(quint32, flags);
    SimulatorOptions o;
    o.firmware = firmware;
    VirtualBoard bench(o);
    int asked = 0;
    bench.channel.setTap([&](const FrameView &frame, TimePoint) { asked += frame.id == 88; });
    QVERIFY(bench.identify());
    QVERIFY2(firmware >= 2610 ? asked >= 2 && asked < 30 : asked == 0, qPrintable(QString::number(asked)));
    QList<int> wanted;
    for (const simplebgc::WireField &field : simplebgc::customLayout(flags))
        wanted.append(field.channel);
    QCOMPARE(bench.device.fastChannels(), wanted);
    // What the firmware does not have is not asked for, and said.
    const auto budget = bench.device.streamBudget({{}, 0, {{u"custom"_s, 100, {simplebgc::FrameQuatX}}}}, {});
    QCOMPARE(bool(budget), firmware >= 2730);
    if (!budget)
        QCOMPARE(budget.error().code, ErrorCode::InvalidArgument);
}

void TestSbgcStreams::eachFlagOfCustomDelivers()
{
    SimulatorOptions o;
    o.firmware = 2739;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    for (const simplebgc::CustomField &field : simplebgc::customFields()) {
        const int channel = field.fields.front().channel;
        const QByteArray key = bench.device.channels()[std::size_t(channel)].key;
        const auto plan = bench.device.subscribe(bench.channel, {{}, 0, {{u"custom"_s, 250, {channel}}}}, {});
        QVERIFY2(plan, key);
        TelemetryStore store(int(bench.device.channels().size()));
        bench.channel.setTap(
            [&](const FrameView &frame, TimePoint at) { plan->decoder->decode(frame, at, store); });
        std::ignore = bench.channel.sleep(200ms);
        for (const simplebgc::WireField &wire : field.fields) {
            QVERIFY2(store.tracks(wire.channel).size() == 1 && store.tracks(wire.channel)[0].end() > 40, key);
            // Nothing is connected to the inputs, and there is no serial receiver (errata 3.9).
            QCOMPARE(std::isnan(store.latest(wire.channel)), field.bit == 5 || field.bit == 7);
        }
        QCOMPARE(store.lost(), quint64(0));
        bench.channel.setTap({});
    }
    // Different codings of one angle agree.
    const QList<int> same{simplebgc::ImuPitch, simplebgc::ImuRadPitch, simplebgc::Imu20Pitch,
                          simplebgc::ImuQuatW};
    const auto plan = bench.device.subscribe(bench.channel, {same, 0, {}}, {});
    QVERIFY(plan);
    TelemetryStore store(int(bench.device.channels().size()));
    bench.channel.setTap(
        [&](const FrameView &frame, TimePoint at) { plan->decoder->decode(frame, at, store); });
    bench.board().stabilizer().setTarget(Axis::Pitch, 20);
    std::ignore = bench.channel.sleep(2s);
    const auto latest = [&](int channel) { return double(store.latest(channel)); };
    QVERIFY2(std::abs(latest(simplebgc::ImuPitch)) > 1,
             qPrintable(QString::number(latest(simplebgc::ImuPitch))));
    QVERIFY(std::abs(latest(simplebgc::ImuPitch) - latest(simplebgc::ImuRadPitch)) < 0.012);
    QVERIFY(std::abs(latest(simplebgc::Imu20Pitch) - latest(simplebgc::ImuRadPitch)) < 0.0004);
    bench.channel.setTap({});
    // More than a frame can carry is refused before anything is sent.
    const auto most = bench.device.subscribe(bench.channel, {bench.device.fastChannels(), 0, {}}, {});
    QVERIFY(!most);
    QCOMPARE(most.error().code, ErrorCode::TooMuch);
    QVERIFY(most.error().detail.contains(u"255"_s));
}

void TestSbgcStreams::streamsThatDoNotFitAreRefused_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<double>("rate");
    QTest::addColumn<int>("baud");
    QTest::addColumn<int>("code");
    QTest::newRow("too fast for the line") << u"realtime4"_s << 100.0 << 115200 << int(ErrorCode::TooMuch);
    QTest::newRow("just fits") << u"realtime4"_s << 75.0 << 115200 << -1;
    QTest::newRow("fits a faster line") << u"realtime4"_s << 500.0 << 921600 << -1;
    QTest::newRow("faster than the board")
        << u"realtime4"_s << 2000.0 << 921600 << int(ErrorCode::InvalidArgument);
    QTest::newRow("no such stream") << u"realtime5"_s << 10.0 << 115200 << int(ErrorCode::InvalidArgument);
    QTest::newRow("custom of nothing") << u"custom"_s << 10.0 << 115200 << int(ErrorCode::InvalidArgument);
}

void TestSbgcStreams::streamsThatDoNotFitAreRefused()
{
    QFETCH(QString, key);
    QFETCH(double, rate);
    QFETCH(int, baud);
    QFETCH(int, code);
    SimulatorOptions o;
    o.usb = false;
    const LineSettings line{baud, Parity::None};
    VirtualBoard bench(o, line);
    std::ignore = bench.channel.setLine(line);
    QVERIFY(bench.identify());
    const auto plan = bench.device.subscribe(bench.channel, {{}, 0, {{key, rate, {}}}}, line);
    QCOMPARE(plan ? -1 : int(plan.error().code), code);
    // The numbers are in it: 100 frames of 129 bytes against 85 % of 11520.
    if (code == int(ErrorCode::TooMuch))
        QVERIFY2(plan.error().detail.contains(u"12903"_s) || plan.error().detail.contains(u"12900"_s),
                 qPrintable(plan.error().detail));
}

void TestSbgcStreams::wireRatesAreThoseOfTheTable_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QStringList>("channels");
    QTest::addColumn<int>("baud");
    QTest::addColumn<bool>("even");
    QTest::addColumn<double>("rate");
    // Errata 1.3 and 3.8-3.10: frame version 1, payload and 5 bytes, 10 or 11 bits a byte.
    QTest::newRow("4 at 115200") << u"realtime4"_s << QStringList() << 115200 << false << 89.0;
    QTest::newRow("4 at 115200 8E1") << u"realtime4"_s << QStringList() << 115200 << true << 81.0;
    QTest::newRow("3 at 256000") << u"realtime3"_s << QStringList() << 256000 << false << 376.0;
    QTest::newRow("gyro at 115200") << u"custom"_s << QStringList{u"gyro.roll"_s} << 115200 << false << 886.0;
    QTest::newRow("gyro and acc at 115200")
        << u"custom"_s << QStringList{u"gyro.roll"_s, u"acc.x"_s} << 115200 << false << 606.0;
}

void TestSbgcStreams::wireRatesAreThoseOfTheTable()
{
    QFETCH(QString, key);
    QFETCH(QStringList, channels);
    QFETCH(int, baud);
    QFETCH(bool, even);
    QFETCH(double, rate);
    SimulatorOptions o;
    o.usb = false;
    const LineSettings line{baud, even ? Parity::Even : Parity::None};
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    QList<int> wanted;
    for (const QString &name : channels)
        wanted.append(findChannel(bench.device.channels(), name));
    const auto budget = bench.device.streamBudget({{}, 0, {{key, 0, wanted}}}, line);
    QVERIFY(budget);
    QVERIFY(budget->fits());
    // As fast as goes: the share for streams, rounded down to whole milliseconds or the firmware's cycle.
    const StreamUse &use = budget->streams.front();
    const double wire = budget->capacity / use.frameBytes;
    QVERIFY2(std::abs(wire - rate) < 1.0, qPrintable(QString::number(wire)));
    QVERIFY(use.rate <= wire * StreamBudget::kShare);
    QVERIFY(1000.0 / use.rate - 1000.0 / (wire * StreamBudget::kShare) < 1.0001);
}

void TestSbgcStreams::lossIsFound_data()
{
    QTest::addColumn<QString>("stream");
    QTest::addColumn<int>("command");
    QTest::addColumn<double>("loses");
    QTest::newRow("without stamps") << u"realtime4"_s << 25 << 0.0003;
    // On a bad line, some damaged stamps pass the checksum.
    QTest::newRow("with stamps") << u"custom"_s << 88 << 0.003;
}

void TestSbgcStreams::lossIsFound()
{
    QFETCH(QString, stream);
    QFETCH(int, command);
    QFETCH(double, loses);
    SimulatorOptions o;
    o.faults.loseByte = loses;
    o.seed = 4;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    const int gyro = rolesOf(bench.device).gyro[0];
    const auto plan = bench.device.subscribe(bench.channel, {{}, 0, {{stream, 1250, {gyro}}}}, {});
    QVERIFY(plan);
    TelemetryStore store(int(bench.device.channels().size()));
    quint64 frames = 0;
    bench.channel.setTap([&](const FrameView &frame, TimePoint at) {
        frames += frame.id == command;
        plan->decoder->decode(frame, at, store);
    });
    const TimePoint start = bench.channel.now();
    std::ignore = bench.channel.sleep(60s);
    const double sent = seconds(bench.channel.now() - start) * 1250.0;
    QVERIFY(store.lost() > 100);
    // The loss of the last second is found a second later.
    QVERIFY2(std::abs(double(frames + store.lost()) - sent) < 0.01 * sent,
             qPrintable(u"%1 + %2 of %3"_s.arg(frames).arg(store.lost()).arg(sent)));
}

void TestSbgcStreams::silenceIsNoLoss_data()
{
    QTest::addColumn<QString>("stream");
    QTest::newRow("with stamps") << u"custom"_s;
    QTest::newRow("without stamps") << u"realtime4"_s;
}

void TestSbgcStreams::silenceIsNoLoss()
{
    QFETCH(QString, stream);
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const int gyro = rolesOf(bench.device).gyro[0];
    const auto plan = bench.device.subscribe(bench.channel, {{}, 0, {{stream, 1250, {gyro}}}}, {});
    QVERIFY(plan);
    TelemetryStore store(int(bench.device.channels().size()));
    bool deaf = false;  // the board calibrates and says nothing
    bench.channel.setTap([&](const FrameView &frame, TimePoint at) {
        if (!deaf)
            plan->decoder->decode(frame, at, store);
    });
    std::ignore = bench.channel.sleep(3s);
    deaf = true;
    std::ignore = bench.channel.sleep(2s);
    deaf = false;
    std::ignore = bench.channel.sleep(3s);
    QCOMPARE(store.lost(), quint64(0));
    QCOMPARE(store.silences(), quint64(1));
    QVERIFY2(std::abs(store.silentSeconds() - 2.0) < 0.05,
             qPrintable(QString::number(store.silentSeconds())));
    // It is drawn as a gap, and the samples behind it have their right times.
    const auto tracks = store.tracks(gyro);
    QCOMPARE(tracks.size(), std::size_t(1));
    int holes = 0;
    for (std::size_t row = tracks[0].begin(); row < tracks[0].end(); ++row)
        holes += std::isnan(tracks[0].value(row));
    QCOMPARE(holes, 1);
    const double newest = tracks[0].time(tracks[0].end() - 1);
    QVERIFY2(std::abs(newest - store.secondsAt(bench.channel.now())) < 0.02,
             qPrintable(QString::number(newest)));
}

void TestSbgcStreams::slowLinesThinOut_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<int>("baud");
    QTest::addColumn<bool>("fast");  // channels beside the status
    QTest::addColumn<double>("rate");  // asked for; 0: as fast as it goes
    QTest::newRow("2.59, 9600, status") << 2590 << 9600 << false << 0.0;
    QTest::newRow("2.59, 9600, fast") << 2590 << 9600 << true << 0.0;
    QTest::newRow("2.59, 9600, 100 asked for") << 2590 << 9600 << true << 100.0;
    QTest::newRow("2.59, 19200, status") << 2590 << 19200 << false << 0.0;
    QTest::newRow("2.59, 19200, 500 asked for") << 2590 << 19200 << true << 500.0;
    QTest::newRow("2.73, 9600, fast") << 2738 << 9600 << true << 0.0;
    QTest::newRow("2.43, 9600, polled") << 2439 << 9600 << false << 0.0;
}

void TestSbgcStreams::slowLinesThinOut()
{
    QFETCH(int, firmware);
    QFETCH(int, baud);
    QFETCH(bool, fast);
    QFETCH(double, rate);
    SimulatorOptions o = withFirmware(firmware);
    o.usb = false;
    const LineSettings line{baud, Parity::None};
    VirtualBoard bench(o, line);
    std::ignore = bench.channel.setLine(line);
    QVERIFY(bench.identify());
    const ChannelRoles roles = rolesOf(bench.device);
    const QList<int> channels = fast ? QList<int>{roles.angle[0], roles.gyro[0]} : QList<int>{};
    const auto plan = bench.device.subscribe(bench.channel, {channels, rate}, line);
    QVERIFY(plan);
    const QString told = thinningText(plan->rate, plan->fullRate, plan->budget);
    QVERIFY2(told.contains(u"The line is slow"_s), qPrintable(told));
    QVERIFY(plan->rate > 0);
    if (!plan->streaming) {
        QVERIFY(plan->poll && plan->fullRate > plan->rate);
        const TimePoint begun = bench.channel.now();
        for (int i = 0; i < 10; ++i)
            QVERIFY(bench.channel.transact(*plan->poll));
        const double real = 10.0 / seconds(bench.channel.now() - begun);
        QVERIFY2(std::abs(real - plan->rate) < 0.2 * plan->rate, qPrintable(QString::number(real)));
        return;
    }
    QVERIFY(plan->budget.fits());
    TelemetryStore store(int(bench.device.channels().size()));
    bench.channel.setTap(
        [&](const FrameView &frame, TimePoint at) { plan->decoder->decode(frame, at, store); });
    std::ignore = bench.channel.sleep(5s);
    QCOMPARE(store.lost(), quint64(0));
    const double rows = double(store.tracks(fast ? roles.gyro[0] : roles.battery)[0].end()) / 5.0;
    QVERIFY2(std::abs(rows - plan->rate) < 0.15 * plan->rate + 0.3, qPrintable(QString::number(rows)));
    QVERIFY(!std::isnan(store.latest(roles.battery)));
    // Requests still get through.
    QVERIFY(bench.device.readBlock(bench.channel, {0, 0}));
}

void TestSbgcStreams::leftoversAreStopped_data()
{
    using Orders = QList<QPair<int, quint32>>;  // interval, flags of CUSTOM
    QTest::addColumn<int>("firmware");
    QTest::addColumn<int>("baud");  // 0: USB
    QTest::addColumn<Orders>("orders");
    QTest::newRow("2.59, one") << 2590 << 0 << Orders{{1, 0x11}};
    QTest::newRow("2.59, 2510 frames/s") << 2590 << 0 << Orders{{1, 0x13}, {1, 0x1D}};
    QTest::newRow("2.59, two of one size") << 2590 << 0 << Orders{{1, 0x13}, {2, 0x15}};
    QTest::newRow("2.59, all fields") << 2590 << 0 << Orders{{1, 0x1FF}};
    QTest::newRow("2.59, 115200") << 2590 << 115200 << Orders{{3, 0x13}};
    QTest::newRow("2.73, later fields") << 2738 << 0 << Orders{{1, 0x13}, {1, 0x40001 | 1U << 22}};
}

// A program was killed: its streams are of no use to the next one, and could be taken for answers.
void TestSbgcStreams::leftoversAreStopped()
{
    using Orders = QList<QPair<int, quint32>>;
    QFETCH(int, firmware);
    QFETCH(int, baud);
    QFETCH(Orders, orders);
    SimulatorOptions o = withFirmware(firmware);
    o.usb = baud == 0;
    std::optional<LineSettings> line;
    if (baud > 0)
        line = LineSettings{baud, Parity::None};
    VirtualBoard bench(o, line);
    if (line)
        std::ignore = bench.channel.setLine(*line);
    QVERIFY(bench.identify());
    const QList<int> fast = bench.device.fastChannels();
    const auto order = [&](const DataStream &stream) {
        return bench.channel.transact(confirmRequest(CommandId::DataStreamInterval, stream.encode(), 1));
    };
    QVERIFY(order({25, 100, QByteArray(8, '\0')}));
    QVERIFY(order({56, 20, QByteArray(1, '\1') + QByteArray(7, '\0')}));
    for (const auto &[interval, flags] : orders)
        QVERIFY(order({88, interval, ByteWriter().u32(flags).zeros(4).take()}));

    int heard = 0;
    bench.channel.setTap([&](const FrameView &, TimePoint) { ++heard; });
    std::ignore = bench.channel.sleep(500ms);
    QVERIFY(heard > 20);
    simplebgc::Device next;
    const TimePoint begun = bench.channel.now();
    const auto identity = next.identify(bench.channel);
    QVERIFY(identity);
    QVERIFY2(bench.channel.now() - begun < 7s, "it took too long");
    QVERIFY2(!identity->extra.contains(u"streams.left"_s),
             qPrintable(identity->extra.value(u"streams.left"_s).toString()));
    QCOMPARE(next.fastChannels(), fast);
    heard = 0;
    std::ignore = bench.channel.sleep(2s);
    QCOMPARE(heard, 0);
}

// Nobody knows what it was ordered with: it goes on, and is told.
void TestSbgcStreams::whatCannotBeStoppedIsTold()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const DataStream strange{88, 10, ByteWriter().u32(0x11).u32(7).take()};
    QVERIFY(bench.channel.transact(confirmRequest(CommandId::DataStreamInterval, strange.encode(), 1)));
    simplebgc::Device next;
    const auto identity = next.identify(bench.channel);
    QVERIFY(identity);
    const QString left = identity->extra.value(u"streams.left"_s).toString();
    QVERIFY2(left.contains(u"REALTIME_DATA_CUSTOM (14 bytes, 100/s)"_s), qPrintable(left));
}

// Frames of a stream that somebody else has ordered have other fields.
void TestSbgcStreams::foreignCustomIsNotTakenForOurs()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const ChannelRoles roles = rolesOf(bench.device);
    const auto plan = bench.device.subscribe(bench.channel, {{roles.angle[0]}, 100}, {});
    QVERIFY(plan);
    TelemetryStore store(int(bench.device.channels().size()));
    bench.channel.setTap(
        [&](const FrameView &frame, TimePoint at) { plan->decoder->decode(frame, at, store); });
    std::ignore = bench.channel.sleep(1s);
    const auto rows = store.tracks(roles.angle[0])[0].end();
    const DataStream foreign{88, 10, ByteWriter().u32(0x1F0).zeros(4).take()};
    QVERIFY(bench.channel.transact(confirmRequest(CommandId::DataStreamInterval, foreign.encode(), 1)));
    std::ignore = bench.channel.sleep(1s);
    const auto more = store.tracks(roles.angle[0])[0].end() - rows;
    QVERIFY2(more >= 95 && more <= 105, qPrintable(QString::number(more)));
}

QTEST_APPLESS_MAIN(TestSbgcStreams)
#include "tst_sbgcstreams.moc"
