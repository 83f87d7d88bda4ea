// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/client/connector.h"
#include "protocol/storm32/parametertables.h"
#include "protocol/storm32/telemetrytables.h"
#include "tests/support/channelproxy.h"
#include "tests/support/stormrig.h"
#if GIMBAL_WITH_SIMPLEBGC
#include "protocol/simplebgc/device.h"
#include "protocol/simulator/simplebgc/board.h"
#endif

#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace storm32;

namespace {

const LineSettings kLine{115200, Parity::None};

LinkAddress serialAddress()
{
    return LinkAddress::parse(u"serial:/dev/ttyTest"_s).value();
}

Result<FoundBoard> find(Channel &channel, ::Device &device)
{
    const QList<Family> known = allFamilies();
    const Family asked = dynamic_cast<storm32::Device *>(&device) ? storm32::family() : known.first();
    return findBoard(channel, asked, device, known, serialAddress());
}

Request offRequest(const storm32::Device &device)
{
    return device.stopPlan().means.at(0).requests.at(0);
}

}  // namespace

/// STorM32 as plain sequential code, against the simulated board, in virtual time.
class TestStormDevice : public QObject
{
    Q_OBJECT
private slots:
    void clockThatStoodStillIsMatchedAnew();
    void boardIsIdentified_data();
    void boardIsIdentified();
    void unknownLayoutIsReadOnlyWithRawWords();
    void familiesAreToldApart();
    void configurationIsReadAndWritten_data();
    void configurationIsReadAndWritten();
    void liveValues();
    void lockedOutBoardIsReached();
    void lockedOutBoardIsFoundDespiteLosses();
    void lockedOutBoardWithOtherNumbers();
    void lockedOutBoardIsListed_data();
    void lockedOutBoardIsListed();
    void wayFollowsTheHeartbeat();
    void textsAreHandedOn();
    void statusIsDecoded();
    void telemetryIsPolled_data();
    void telemetryIsPolled();
    void lossAndDamageAreSurvived();
    void angleIsSent();
    void everyActionIsAnswered();
    void sticksAreChecked();
    void scriptThatIsOffIsTold();
    void faultsHaveCauses();
    void steeringAndMotors();
    void framesAreWorded();
};

void TestStormDevice::boardIsIdentified_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<int>("layout");
    QTest::newRow("0.79") << 79 << 78;
    QTest::newRow("0.90") << 90 << 89;
    QTest::newRow("0.96") << 96 << 95;
}

void TestStormDevice::boardIsIdentified()
{
    QFETCH(int, firmware);
    QFETCH(int, layout);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.probe(rig.channel).value_or(false));
    const auto identity = rig.device.identify(rig.channel);
    QVERIFY(identity);
    QCOMPARE(identity->firmware, u"0.%1"_s.arg(firmware));
    QCOMPARE(identity->firmwareNumber, layout);
    QCOMPARE(identity->model, u"STorM32 v1.30 F103RC"_s);
    QCOMPARE(identity->extra[u"name"_s].toString(), u"OlliW 323BGC"_s);
    QVERIFY(identity->capabilities.contains(u"battery"_s) && identity->capabilities.contains(u"aux"_s));
    QVERIFY(identity->writable && !rig.device.isEmbedded());
    QVERIFY(rig.device.parameters()->find(u"pid.roll.p"_s));
    QVERIFY(!rig.device.adjustables().empty());
    for (const AdjustableSpec &spec : rig.device.adjustables())
        QVERIFY(rig.device.parameters()->find(QString::fromLatin1(spec.key))->adjustable == spec.id);
}

void TestStormDevice::unknownLayoutIsReadOnlyWithRawWords()
{
    SimulatorOptions o = stormOptions(96);
    o.faults.unknownFirmware = true;
    StormRig rig(o);
    const auto identity = rig.device.identify(rig.channel);
    QVERIFY(identity);
    QCOMPARE(identity->firmware, u"2.20"_s);
    QVERIFY(!identity->writable);
    const auto configuration = rig.device.readConfiguration(rig.channel);
    QVERIFY(configuration);
    QCOMPARE(configuration->raw(*rig.device.parameters()->find(u"word.0"_s), 0), 400);
    QCOMPARE(configuration->raw(*rig.device.parameters()->find(u"word.82"_s), 0), 25);
}

// Neither family's question harms the other, and both are told apart (document "Serial Communication",
// errata 3.1).
void TestStormDevice::familiesAreToldApart()
{
    {
        StormRig rig(stormOptions(96, false), kLine);
        const auto found = find(rig.channel, rig.device);
        QVERIFY(found);
        QCOMPARE(found->line->baud, 115200);
    }
#if GIMBAL_WITH_SIMPLEBGC
    {  // our questions to a SimpleBGC board
        SimulatorOptions o;
        o.usb = false;
        SimulatedPort port(std::make_unique<simplebgc::SimulatedBoard>(o), o, kLine);
        auto &board = static_cast<simplebgc::SimulatedBoard &>(port.board());
        storm32::Device device;
        VirtualChannel channel(port, storm32::family().makeFramer(), storm32::family().timing);
        const int before = board.stored(u"pid.roll.p"_s, 0);
        QVERIFY(!find(channel, device));
        QCOMPARE(board.stored(u"pid.roll.p"_s, 0), before);
        QVERIFY(board.stabilizer().motorsOn());
        simplebgc::Device right;
        VirtualChannel again(port, simplebgc::family().makeFramer(), simplebgc::family().timing);
        QVERIFY(find(again, right));
    }
    {  // theirs to a STorM32 board
        StormRig rig(stormOptions(96, false), kLine);
        simplebgc::Device wrong;
        VirtualChannel channel(rig.port, simplebgc::family().makeFramer(), simplebgc::family().timing);
        const auto found = find(channel, wrong);
        QVERIFY(!found);
        QVERIFY2(found.error().code == ErrorCode::WrongProtocol, qPrintable(found.error().detail));
        QCOMPARE(found.error().detail, u"STorM32"_s);
        QCOMPARE(rig.board().inUse(0), 400);
    }
#endif
    {  // the wrong rate
        StormRig rig(stormOptions(90, false), LineSettings{38400, Parity::None});
        const auto found = find(rig.channel, rig.device);
        QVERIFY(found);
        QCOMPARE(found->line->baud, 38400);
    }
}

void TestStormDevice::configurationIsReadAndWritten_data()
{
    boardIsIdentified_data();
}

void TestStormDevice::configurationIsReadAndWritten()
{
    QFETCH(int, firmware);
    StormRig rig(stormOptions(firmware));
    QVERIFY(rig.device.identify(rig.channel));
    const auto base = rig.device.readConfiguration(rig.channel);
    QVERIFY(base);
    const ParameterSet &set = *rig.device.parameters();
    QCOMPARE(base->raw(*set.find(u"pid.pitch.p"_s), 0), 400);
    QCOMPARE(base->raw(*set.find(u"rc.pitch.min"_s), 0), -250);
    QCOMPARE(base->block({0, Scripts}).size(), 128);
    Configuration edited = *base;
    QVERIFY(edited.setRaw(*set.find(u"pid.yaw.d"_s), 0, 777));
    QVERIFY(edited.setRaw(*set.find(u"rc.roll.min"_s), 0, -300));
    QVERIFY(!edited.setRaw(*set.find(u"pid.yaw.d"_s), 0, 9000));  // the firmware would not mind; we do
    QVERIFY(rig.device.beginWrite(rig.channel));
    QVERIFY(rig.device.writeBlock(rig.channel, {0, Parameters}, edited.block({0, Parameters})));
    QCOMPARE(rig.board().inUse(14), 777);
    QCOMPARE(rig.board().stored(14), 500);
    QVERIFY(rig.device.endWrite(rig.channel));
    QCOMPARE(rig.board().stored(14), 777);
    QCOMPARE(rig.board().stored(82), 25);  // untouched
    QCOMPARE(*rig.device.readBlock(rig.channel, {0, Parameters}), edited.block({0, Parameters}));
    // Scripts are a block of their own.
    const auto area = compileScripts({u"DORECENTER\nSTOP"_s, {}, {}, {}}, scriptContext(set, firmware));
    QVERIFY(area);
    QVERIFY(rig.device.writeBlock(rig.channel, {0, Scripts}, *area));
    QCOMPARE(*rig.device.readBlock(rig.channel, {0, Scripts}), *area);
    QCOMPARE(rig.board().inUse(14), 777);
}

void TestStormDevice::liveValues()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    const int id = rig.device.parameters()->find(u"pid.roll.p"_s)->adjustable;
    QVERIFY(rig.device.writeAdjustables(rig.channel, {{id, 512}}));
    QCOMPARE(rig.board().inUse(6), 512);
    QCOMPARE(rig.board().stored(6), 400);
    QCOMPARE(rig.device.readAdjustables(rig.channel, {id})->front().value, 512.0);
    // The board takes anything; out of range nothing is sent.
    QCOMPARE(rig.device.writeAdjustables(rig.channel, {{id, 5000}}).error().code, ErrorCode::OutOfRange);
    QCOMPARE(rig.device.writeAdjustables(rig.channel, {{24, 1}}).error().code,
             ErrorCode::InvalidArgument);  // not assigned
    QCOMPARE(rig.board().inUse(6), 512);
    QCOMPARE(rig.board().inUse(24), 0);
}

void TestStormDevice::lockedOutBoardIsReached()
{
    for (const int firmware : {79, 90, 96}) {
        StormRig rig(stormOptions(firmware, false), kLine);
        rig.lockOut();
        const auto found = find(rig.channel, rig.device);
        QVERIFY(found);
        QVERIFY(rig.device.isEmbedded());
        QCOMPARE(found->identity.extra[u"embedded"_s].toBool(), true);
        QCOMPARE(found->identity.firmware, u"0.%1"_s.arg(firmware));
        // Word by word, because the whole does not fit into a frame; the scripts cannot be had.
        const auto base = rig.device.readConfiguration(rig.channel);
        QVERIFY2(base, qPrintable(base ? QString() : base.error().detail));
        QCOMPARE(base->raw(*rig.device.parameters()->find(u"pid.pitch.p"_s), 0), 400);
        QVERIFY(base->block({0, Scripts}).isEmpty());
        QCOMPARE(rig.device.readBlock(rig.channel, {0, Scripts}).error().code, ErrorCode::Unsupported);
        Configuration edited = *base;
        QVERIFY(edited.setRaw(*rig.device.parameters()->find(u"pid.pitch.i"_s), 0, 1234));
        QVERIFY(rig.device.writeBlock(rig.channel, {0, Parameters}, edited.block({0, Parameters})));
        QVERIFY(rig.device.endWrite(rig.channel));
        QCOMPARE(rig.board().stored(1), 1234);
        QVERIFY(rig.device.perform(rig.channel, u"status"_s, {}));
        // One action, and plain commands work again.
        QVERIFY(rig.device.perform(rig.channel, u"heartbeat.off"_s, {}));
        QCOMPARE(rig.board().inUse(112), 0);
        storm32::Device plain;
        VirtualChannel channel(rig.port, storm32::family().makeFramer(), storm32::family().timing);
        QVERIFY(find(channel, plain));
        QVERIFY(!plain.isEmbedded());
    }
}

// Its numbers on MAVLink are not the usual ones: its heartbeat tells them.
// Its heartbeat is heard: questions that are lost do not make it another board.
void TestStormDevice::lockedOutBoardIsFoundDespiteLosses()
{
    class Losing final : public ChannelProxy
    {
    public:
        using ChannelProxy::ChannelProxy;
        Result<Frame> transact(const Request &request) override
        {
            if (request.bytes.startsWith('\xFE') && m_left-- > 0)
                return failure(ErrorCode::Timeout, request.name);
            return ChannelProxy::transact(request);
        }

    private:
        int m_left = 1;
    };
    StormRig rig(stormOptions(96, false), kLine);
    rig.lockOut();
    std::ignore = rig.channel.setLine(kLine);
    Losing channel(rig.channel);
    QVERIFY(rig.device.probe(channel).value_or(false));
    QVERIFY(rig.device.isEmbedded());
}

void TestStormDevice::lockedOutBoardWithOtherNumbers()
{
    StormRig rig(stormOptions(96, false), kLine);
    rig.board().set(110, 12);
    rig.board().set(111, 34);
    rig.lockOut();
    const auto found = find(rig.channel, rig.device);
    QVERIFY(found);
    QVERIFY(rig.device.isEmbedded());
    QVERIFY(rig.device.perform(rig.channel, u"heartbeat.off"_s, {}));
    QCOMPARE(rig.board().inUse(112), 0);
}

void TestStormDevice::lockedOutBoardIsListed_data()
{
    boardIsIdentified_data();
}

// Both codings of values (errata 6), negative numbers among them; what the list loses is asked for one by
// one.
void TestStormDevice::lockedOutBoardIsListed()
{
    QFETCH(int, firmware);
    StormRig plain(stormOptions(firmware));
    QVERIFY(plain.device.identify(plain.channel));
    plain.board().set(22, 65536 - 250);
    plain.board().set(112, 0);
    StormRig rig(stormOptions(firmware, false), kLine);
    rig.board().set(22, 65536 - 250);
    rig.lockOut();
    QVERIFY(find(rig.channel, rig.device));
    QVERIFY(rig.device.isEmbedded());
    const auto listed = rig.device.readConfiguration(rig.channel);
    QVERIFY(listed);
    QCOMPARE(listed->raw(*rig.device.parameters()->find(u"motor.pitch.offset"_s), 0), -250);
    Configuration direct = plain.device.readConfiguration(plain.channel).value();
    QByteArray words = direct.block({0, Parameters});
    words[2 * 112] = 1;
    QCOMPARE(listed->block({0, Parameters}), words);
    QVERIFY(rig.channel.bytesOut() < 800);  // and not a question for each of 125 words
}

void TestStormDevice::wayFollowsTheHeartbeat()
{
    StormRig rig(stormOptions(96, false), kLine);
    QVERIFY(find(rig.channel, rig.device));
    auto configuration = rig.device.readConfiguration(rig.channel);
    QVERIFY(configuration);
    const QByteArray plainOff = offRequest(rig.device).bytes;
    QByteArray words = configuration->block({0, Parameters});
    words[2 * 110] = 12;  // other numbers as well
    words[2 * 111] = 34;
    words[2 * 112] = 1;
    QVERIFY(rig.device.writeBlock(rig.channel, {0, Parameters}, words));
    QVERIFY(rig.device.isEmbedded());
    QVERIFY(offRequest(rig.device).bytes != plainOff);
    QVERIFY(rig.channel.transact(offRequest(rig.device)));
    QCOMPARE(rig.board().state(), 99);
    QVERIFY(rig.device.endWrite(rig.channel));
    const auto again = rig.device.readConfiguration(rig.channel);
    QVERIFY(again);
    QCOMPARE(again->block({0, Parameters}), words);
    QVERIFY(rig.device.perform(rig.channel, u"heartbeat.off"_s, {}));
    QVERIFY(!rig.device.isEmbedded());
    QCOMPARE(offRequest(rig.device).bytes, plainOff);
    QCOMPARE(rig.device.readConfiguration(rig.channel)->blocks().size(), 2U);  // scripts too
    // USB answers everything all the time: nothing has to change.
    StormRig usb;
    QVERIFY(usb.device.identify(usb.channel));
    QVERIFY(usb.device.writeBlock(usb.channel, {0, Parameters}, words));
    QVERIFY(!usb.device.isEmbedded());
}

void TestStormDevice::textsAreHandedOn()
{
    const mavlink::Message *message = mavlink::findMessage(mavlink::number(mavlink::MessageId::StatusText));
    const QByteArray payload
        = mavlink::encodeFields(*message, {{u"severity"_s, 4}, {u"text"_s, u"Battery is weak"_s}}).value();
    const storm32::Device device;
    const FrameView frame{
        FrameId::kMavlink + mavlink::number(mavlink::MessageId::StatusText), asBytes(payload), {}};
    QCOMPARE(device.messageText(frame), u"Battery is weak"_s);
    QVERIFY(device.messageText({FrameId::kMavlink, asBytes(payload), {}}).isEmpty());
}

// Bits of errata 3.8 and word 31 of 3.5.
void TestStormDevice::statusIsDecoded()
{
    const auto text = [](unsigned status, unsigned status2, unsigned functions) {
        QStringList lines;
        for (const BoardFact &fact : factsOf(status, status2, functions)) {
            QStringList words;
            for (const char *word : fact.words)
                words.append(QString::fromUtf8(word));
            lines.append(u"%1: %2"_s.arg(QString::fromUtf8(fact.name), words.join(u' ')));
        }
        return lines.join(u'\n');
    };
    QCOMPARE(text(0x8028, 0x8038, 0),
             u"Camera sensor: OK\nFrame sensor: not present\nMotors running: Roll Pitch Yaw\n"
             "Following axes: Yaw"_s);
    const QString all = text(0x8000 | 0x1000 | 0x0800 | 0x0040 | 0x2000 | 0x0100 | 0x0002, 0x0100 | 0x0800,
                             0x4000 | 0x0080);
    for (const char *line : {"Camera sensor: error", "Frame sensor: OK on the board", "Magnetometer: error",
                             "STorM32-Link: unused", "Motors running: none", "Re-centering: Pitch",
                             "IR camera: active", "Input of pan mode: +500", "Input of script 1: -500"})
        QVERIFY2(all.contains(QLatin1String(line)), qPrintable(all));
    QVERIFY(text(0, 0, 0).startsWith(u"Camera sensor: not present"_s));
    // And from a running board.
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(rig.device.facts([](int) { return std::nan(""); }).empty());
}

void TestStormDevice::telemetryIsPolled_data()
{
    boardIsIdentified_data();
}

void TestStormDevice::telemetryIsPolled()
{
    QFETCH(int, firmware);
    for (const bool locked : {false, true}) {
        StormRig rig(stormOptions(firmware, false), kLine);
        std::ignore = rig.channel.setLine(kLine);
        if (locked)
            rig.lockOut();
        QVERIFY(rig.device.probe(rig.channel).value_or(false));
        QVERIFY(rig.device.identify(rig.channel));
        const auto plan = rig.device.subscribe(rig.channel, {}, kLine);
        QVERIFY(plan && plan->poll && !plan->streaming);
        QVERIFY2(plan->rate > 40 && plan->rate < 120, qPrintable(QString::number(plan->rate)));
        TelemetryStore store(int(rig.device.channels().size()));
        rig.channel.setTap(
            [&](const FrameView &frame, TimePoint at) { plan->decoder->decode(frame, at, store); });
        for (int i = 0; i < 100; ++i)
            QVERIFY(rig.channel.transact(*plan->poll));
        QCOMPARE(store.rows(), quint64(100));
        QVERIFY(std::abs(store.latest(AnglePitch)) < 5);
        QVERIFY(std::abs(store.latest(AccZ) - 1.0F) < 0.15F);
        QVERIFY(std::abs(store.latest(Voltage) - 12.3F) < 0.2F);
        QCOMPARE(store.latest(MotorsActive), 1.0F);
        QVERIFY(std::isnan(store.latest(LinkYaw)));  // without a link the word means nothing
        // Times go forward, evenly where the board has a clock of use.
        const auto tracks = store.tracks(GyroX);
        QCOMPARE(tracks.size(), std::size_t(1));
        for (std::size_t row = 1; row < tracks[0].end(); ++row)
            QVERIFY(tracks[0].time(row) >= tracks[0].time(row - 1));
        rig.channel.setTap({});
        QVERIFY(!rig.device.subscribe(rig.channel, {{}, 0, {{u"custom"_s, 10, {}}}}, kLine));
    }
}

void TestStormDevice::lossAndDamageAreSurvived()
{
    for (const unsigned seed : {1U, 2U, 3U}) {
        SimulatorOptions o = stormOptions(96, false);
        o.seed = seed;
        o.faults.loseByte = 0.001;
        o.faults.flipByte = 0.001;
        StormRig rig(o, kLine);
        std::ignore = rig.channel.setLine(kLine);
        int identified = 0;
        for (int i = 0; i < 5; ++i)
            identified += rig.device.identify(rig.channel).has_value();
        QVERIFY(identified >= 4);
        int good = 0;
        for (int i = 0; i < 20; ++i) {
            const auto configuration = rig.device.readConfiguration(rig.channel);
            if (!configuration)
                continue;
            ++good;
            // What is taken for the configuration is the configuration.
            QCOMPARE(configuration->raw(*rig.device.parameters()->find(u"pid.pitch.p"_s), 0), 400);
            QCOMPARE(configuration->raw(*rig.device.parameters()->find(u"motor.yaw.vmax"_s), 0), 150);
        }
        QVERIFY2(good >= 19, qPrintable(QString::number(good)));
    }
}

void TestStormDevice::sticksAreChecked()
{
    StormRig rig(stormOptions(96));
    QVERIFY(rig.device.identify(rig.channel));
    const auto sent = [&rig](const QMap<QString, QString> &texts) -> Result<ActionReply> {
        for (const ActionSpec &action : rig.device.actions()) {
            if (QLatin1String(action.key) != "sticks"_L1)
                continue;
            const auto arguments = parseArguments(action, texts);
            return arguments ? rig.device.perform(rig.channel, u"sticks"_s, *arguments)
                             : tl::unexpected(arguments.error());
        }
        return failure(ErrorCode::Unsupported);
    };
    QVERIFY(sent({{u"pitch"_s, u"1700"_s}, {u"roll"_s, u"1600"_s}, {u"yaw"_s, u"1400"_s}}));
    QVERIFY(sent({{u"yaw"_s, u"1300"_s}}));
    for (const QString &pulse : {u"1"_s, u"699"_s, u"2300.5"_s, u"2301"_s, u"-1"_s})
        QVERIFY2(!sent({{u"pitch"_s, pulse}}), qPrintable(pulse));
    for (const QString &pulse : {u"0"_s, u"700"_s, u"2300"_s})
        QVERIFY2(sent({{u"pitch"_s, pulse}}), qPrintable(pulse));
    QCOMPARE(sent({}).error().code, ErrorCode::InvalidArgument);
}

void TestStormDevice::scriptThatIsOffIsTold()
{
    for (const int firmware : {79, 90, 96}) {
        StormRig rig(stormOptions(firmware));
        QVERIFY(rig.device.identify(rig.channel));
        const QVariantMap arguments{{u"script"_s, 2}, {u"case"_s, 1}};
        const auto refused = rig.device.perform(rig.channel, u"script"_s, arguments);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::ConditionUnmet);
        QVERIFY2(refused.error().detail.contains(u"script2.input is off"_s),
                 qPrintable(refused.error().detail));
        rig.board().set(rig.device.parameters()->find(u"script2.input"_s)->offset / 2, 1);
        QVERIFY(rig.device.perform(rig.channel, u"script"_s, arguments));
    }
}

// It is sent once the board has said that its motors run.
void TestStormDevice::angleIsSent()
{
    struct Noting final : ChannelProxy
    {
        using ChannelProxy::ChannelProxy;
        Result<Frame> transact(const Request &request) override
        {
            sent.append(request.bytes.toHex());
            return ChannelProxy::transact(request);
        }
        QByteArrayList sent;
    };
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QVERIFY(rig.channel.sleep(15s));
    Noting noting(rig.channel);
    std::ignore = rig.device.perform(
        noting, u"angle"_s, {{u"pitch"_s, -12.5}, {u"roll"_s, 3}, {u"yaw"_s, 90}, {u"limited"_s, true}});
    QVERIFY2(noting.sent.contains("fa0e11000048c1000040400000b44207004dce"),
             noting.sent.join(' ').constData());
}

void TestStormDevice::everyActionIsAnswered()
{
    for (const int firmware : {79, 90, 96}) {
        StormRig rig(stormOptions(firmware));
        QVERIFY(rig.device.identify(rig.channel));
        const QMap<QString, QMap<QString, QString>> arguments{
            {u"pan.mode"_s, {{u"mode"_s, u"pan pan pan"_s}}},
            {u"pan.setting"_s, {{u"setting"_s, u"2"_s}}},
            {u"script"_s, {{u"script"_s, u"4"_s}}},
            {u"sticks"_s, {{u"yaw"_s, u"1500"_s}}},
            {u"name"_s, {{u"name"_s, u"Top"_s}}},
            {u"restore"_s, {{u"word"_s, u"0"_s}}},
        };
        rig.board().set(rig.device.parameters()->find(u"script4.input"_s)->offset / 2, 1);
        for (const ActionSpec &action : rig.device.actions()) {
            if (action.isProcedure || QLatin1String(action.group) == "Gimbal configuration"_L1
                || QLatin1String(action.key) == "calibration.write"_L1)
                continue;  // these need somebody who does his part: tst_stormsetup
            const auto parsed = parseArguments(action, arguments.value(QString::fromLatin1(action.key)));
            QVERIFY2(parsed, action.key);
            // The memory is erased by now: what is stored would let running motors go.
            if (QLatin1String(action.key) == "stored.compare"_L1) {
                const auto refused
                    = rig.device.perform(rig.channel, QString::fromLatin1(action.key), *parsed);
                QVERIFY(!refused);
                QCOMPARE(refused.error().code, ErrorCode::ConditionUnmet);
                QVERIFY(refused.error().detail.contains(u"motor.pitch.usage"_s));
                QVERIFY(rig.channel.sleep(30s));  // it was reset before
                for (const int word : {78, 79, 80})
                    rig.board().set(word, 3);
            }
            // What turns the camera needs motors, which have been stopped by now.
            if (QLatin1String(action.key) == "angle"_L1) {
                QVERIFY(rig.channel.sleep(30s));
                QVERIFY(rig.device.switchMotorsOn(rig.channel));
            }
            const auto reply = rig.device.perform(rig.channel, QString::fromLatin1(action.key), *parsed);
            QVERIFY2(reply,
                     qPrintable(u"%1: %2"_s.arg(QLatin1String(action.key),
                                                reply ? QString() : reply.error().detail)));
        }
        QCOMPARE(rig.device.perform(rig.channel, u"nonsense"_s, {}).error().code, ErrorCode::Unsupported);
    }
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    QCOMPARE(rig.device.perform(rig.channel, u"status"_s, {})->value(u"state"_s).toString(), u"normal"_s);
    QCOMPARE(rig.device.perform(rig.channel, u"calibration.read"_s, {})->value(u"imu.acc.scale.z"_s).toInt(),
             8192);
    QVERIFY(
        std::abs(rig.device.perform(rig.channel, u"sensors.raw"_s, {})->value(u"imu.temperature"_s).toDouble()
                 - 31)
        < 0.1);
    QCOMPARE(rig.device.perform(rig.channel, u"name"_s, {{u"name"_s, u"a name that is far too long"_s}})
                 .error()
                 .code,
             ErrorCode::InvalidArgument);
    QVERIFY(rig.device.perform(rig.channel, u"name"_s, {{u"name"_s, u"Top"_s}}));
    QCOMPARE(rig.device.identify(rig.channel)->extra[u"name"_s].toString(), u"Top"_s);
    // A refusal comes with its cause.
    const auto refused = rig.device.perform(rig.channel, u"pwm"_s, {{u"pulse"_s, 9}});
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::OutOfRange);
    QCOMPARE(refused.error().boardCode, 153);
}

void TestStormDevice::faultsHaveCauses()
{
    const auto keys = [](unsigned bits) {
        QStringList list;
        for (const BoardFault &fault : faultsOf(bits, 6)) {
            list.append(fault.key);
            if (fault.meaning.isEmpty() || fault.cure.isEmpty())
                list.append(u"without words"_s);
        }
        return list;
    };
    QCOMPARE(keys(0x8028), QStringList());
    QCOMPARE(keys(0x0008), QStringList{u"no-sensor"_s});
    QCOMPARE(keys(0x8008), QStringList{u"imu-error"_s});
    QCOMPARE(keys(0x9028), QStringList{u"imu2-error"_s});
    QCOMPARE(keys(0x8020), QStringList{u"no-battery"_s});
    QCOMPARE(keys(0x8038), QStringList{u"low-battery"_s});
    QCOMPARE(keys(0x802C), QStringList{u"level-failed"_s});
    QCOMPARE(stateName(7, 90), u"standby"_s);
    QCOMPARE(stateName(99, 96), u"standby"_s);
    QCOMPARE(stateName(7, 210), u"fast level"_s);
    QCOMPARE(stateName(42, 96), u"unknown (42)"_s);
}

void TestStormDevice::steeringAndMotors()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    rig.board().stabilizer().hand().setStrength(0);
    QVERIFY(rig.channel.transact(offRequest(rig.device)));
    QVERIFY(rig.channel.sleep(50ms));
    QVERIFY(!rig.board().stabilizer().motorsOn());
    QVERIFY(rig.device.switchMotorsOn(rig.channel));
    QVERIFY(rig.channel.sleep(1500ms));
    QVERIFY(rig.board().stabilizer().motorsOn());
    const SteeringSetpoint setpoint{2, {0, 20, 0}, {}};  // pitch, without limits
    Request request;
    request.bytes = rig.device.controlFrames(setpoint).setpoint;
    rig.channel.post(request);
    QVERIFY(rig.channel.sleep(4s));
    QVERIFY(std::abs(rig.board().stabilizer().trueAngle(Axis::Pitch) - 20) < 1.5);
    // Let go, it stays where it is.
    request.bytes = rig.device.controlFrames(setpoint).release;
    rig.channel.post(request);
    QVERIFY(rig.channel.sleep(2s));
    QVERIFY(std::abs(rig.board().stabilizer().trueAngle(Axis::Pitch) - 20) < 1.5);
}

void TestStormDevice::framesAreWorded()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    const storm32::Device &device = rig.device;
    QCOMPARE(device.describeSent("xs").name, u"xs"_s);
    QCOMPARE(device.describeSent("xs").fields, u"store"_s);
    const FrameText set = device.describeSent(encodeRc(4, QByteArray::fromHex("2f0006ff")));
    QCOMPARE(set.name, u"SETPARAMETER"_s);
    QCOMPARE(set.fields, u"rc.pitch.min = -25.0"_s);
    const auto sent
        = [&device](const char *bytes) { return device.describeSent(QByteArray::fromHex(bytes)); };
    QCOMPARE(sent("fa0e11000048c1000040400000b4420500fdfd").fields,
             u"pitch=-12.5 roll=3 yaw=90 flags=5 type=0"_s);
    QCOMPARE(sent("fa060f0003000000000565").fields, u"shot=3"_s);
    // What is embedded in MAVLink is told like what is not.
    QCOMPARE(sent("fe03005243ea4743746893").name, u"COMMAND_TARGET_SPECIFIC"_s);
    QCOMPARE(sent("fe03005243ea4743746893").fields, u"74"_s);
    QCOMPARE(sent("fe06095243ea4743fa0ae8033c58").fields, u"SETPITCH pulse=1000"_s);
    QCOMPARE(sent("fe05054743eb5243fb960099a9").fields, u"ACK ok"_s);
    const QByteArray ack("\x99");
    QVERIFY(device.describeFrame({FrameId::kRc + 150, asBytes(ack)}, true).fields.contains(u"range"_s));
    QCOMPARE(device.describeFrame({'t', {}}, true).fields, u"arrived in pieces"_s);
    const QByteArray version = QByteArray::fromHex("60005f0003ff");
    QCOMPARE(device.describeFrame({FrameId::kRc + 1, asBytes(version)}, true).fields,
             u"firmware=96 layout=95 capabilities=65283"_s);
    const QByteArray texts(48, 'a');  // under the number of the data, by their length
    QCOMPARE(device.describeFrame({FrameId::kRc + 5, asBytes(texts)}, true).name, u"GETVERSIONSTR"_s);
    QCOMPARE(device.describeFrame({FrameId::kRc + 77, asBytes(version)}, true).name, u"RC 77"_s);
    QCOMPARE(device.parseCommand(u"xs"_s)->bytes, "xs");
    QCOMPARE(device.parseCommand(u"xc"_s)->risk, ActionRisk::Destroys);
    QCOMPARE(device.parseCommand(u"getparameter 2F00"_s)->bytes, QByteArray::fromHex("fa02032f00c875"));
    QCOMPARE(device.parseCommand(u"setangle pitch=-12.5  roll=3 yaw=90 flags=5"_s)->bytes,
             QByteArray::fromHex("fa0e11000048c1000040400000b4420500fdfd"));
    QCOMPARE(device.parseCommand(u"SETANGLE Pitch=5"_s)->risk, ActionRisk::Moves);
    QCOMPARE(device.parseCommand(u"fa000131e1"_s)->name, u"GETVERSION"_s);
    for (const char *wrong :
         {"", "XS", "getparameter 2F", "fa000131e2", "nonsense", "p 00", "setangle tilt=5",
          "setangle pitch=", "setangle pitch=5 7", "setstandby on=256", "getversion on=1"})
        QVERIFY2(!device.parseCommand(QString::fromLatin1(wrong)), wrong);
    QVERIFY(device.commandNames().contains(u"ACTIVEPANMODESETTING"_s));
}

// A processor that was suspended, or a board whose counter was: what it sends afterwards is of now.
void TestStormDevice::clockThatStoodStillIsMatchedAnew()
{
    StormRig rig;
    QVERIFY(rig.device.identify(rig.channel));
    TelemetryStore store(int(rig.device.channels().size()), TimePoint{});
    Decoder decoder(96);
    Frame frame = *rig.channel.transact(simpleRequest(Simple::LiveData));
    int stamp = 0;
    const auto arrive = [&](double arrival) {
        frame.payload[10] = char(stamp & 0xFF);
        frame.payload[11] = char(stamp >> 8);
        decoder.decode({frame.id, asBytes(frame.payload)}, TimePoint{} + durationFromSeconds(arrival), store);
        stamp += 10;
    };
    for (int i = 0; i < 100; ++i)
        arrive(1 + i * 0.01);
    QVERIFY(std::abs(seconds(store.latestAt(0) - TimePoint{}) - 1.99) < 0.02);
    for (int i = 0; i < 100; ++i)
        arrive(8 + i * 0.01);
    QVERIFY(std::abs(seconds(store.latestAt(0) - TimePoint{}) - 8.99) < 0.02);
    // Answers that were held back by the link are as old as they are.
    for (int i = 0; i < 100; ++i)
        arrive(10 + i * 0.001);
    for (int i = 0; i < 50; ++i)
        arrive(10.1 + i * 0.01);
    QVERIFY(std::abs(seconds(store.latestAt(0) - TimePoint{}) - 10.59) < 0.02);
}

QTEST_GUILESS_MAIN(TestStormDevice)
#include "tst_stormdevice.moc"
