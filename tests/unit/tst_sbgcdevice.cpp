// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/client/connector.h"
#include "protocol/simplebgc/steeringmodes.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"
#include "tests/support/channelproxy.h"
#include "tests/support/lossychannel.h"
#include "tests/support/virtualboard.h"

#include <QTest>

#include <cmath>

using namespace simplebgc;
using namespace Qt::StringLiterals;

namespace {

Result<FoundBoard> find(VirtualBoard &bench, const LinkAddress &address)
{
    return findBoard(bench.channel, bench.family, bench.device, allFamilies(), address);
}

/// A board that hears nothing until it has started.
class Starting final : public ChannelProxy
{
public:
    Starting(Channel &channel, milliseconds time)
        : ChannelProxy(channel)
        , m_ready(channel.now() + time)
    {
    }
    Result<Frame> transact(const Request &request) override
    {
        if (now() >= m_ready)
            return ChannelProxy::transact(request);
        if (const auto slept = sleep((request.retries + 1) * request.timeout); !slept)
            return tl::unexpected(slept.error());
        return failure(ErrorCode::Timeout, request.name);
    }

private:
    TimePoint m_ready;
};

// What the simulated board has otherwise than the factory's defaults.
bool isOfTheSimulator(const QString &key)
{
    return key == u"imu.skip_gyro_calibration"_s;
}

}  // namespace

/// The family's sequential code against the simulated board in virtual time.
class TestSbgcDevice : public QObject
{
    Q_OBJECT
private slots:
    void simulatedBoardHoldsWhatMayBe_data();
    void simulatedBoardHoldsWhatMayBe();
    void identifies();
    void unknownFirmwareIsReadOnly();
    void findsRateAndParity_data();
    void findsRateAndParity();
    void findsABoardThatStartsLate_data();
    void findsABoardThatStartsLate();
    void explainsSilenceGarbageAndForeigners();
    void readsEverything_data();
    void readsEverything();
    void frameSensorThatIsNotUsedTellsNothing();
    void missingExtendedBlocksAreLeftOut();
    void readTimeIsNearTheWire();
    void selectsProfiles();
    void profileNames();
    void adjustablesAreVolatileUntilSaved();
    void steersToAnAngle();
    void speedModeStopsAtTheEnd();
    void menuHasTheCommandsOfItsFirmware();
    void oldFirmwareSteersAllAxesOrNone();
    void steeringOutOfRangeIsRefused_data();
    void steeringOutOfRangeIsRefused();
    void everyControlModeIsEncoded();
    void resetIsAnnounced();
    void defaultsOverwriteAProfile();
    void motorsOffStopsEvenATuningBoard();
    void standingBoardsProveTheStop();
    void debugVariablesAreListedAndRead();
    void faultsAreNamed();
    void aMissingSensorHasNoAngles();
    void survivesADisturbedCable();
    void argumentsAreChecked();
};

void TestSbgcDevice::identifies()
{
    VirtualBoard bench;
    const auto identity = bench.device.identify(bench.channel);
    QVERIFY(identity);
    QCOMPARE(identity->model, u"SimpleBGC 3.0"_s);
    QCOMPARE(identity->firmware, u"2.59b0"_s);
    QVERIFY(identity->capabilities.contains(u"battery"_s));
    QVERIFY(identity->capabilities.contains(u"streams"_s));
    QVERIFY(identity->usb);
    QVERIFY(identity->writable);
    QVERIFY(!identity->serial.isEmpty());
    // The seed is in the serial number: another board is another board.
    SimulatorOptions other;
    other.seed = 2;
    VirtualBoard second(other);
    QVERIFY(second.device.identify(second.channel)->serial != identity->serial);
}

void TestSbgcDevice::unknownFirmwareIsReadOnly()
{
    SimulatorOptions o;
    o.faults.unknownFirmware = true;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    QVERIFY(!bench.device.identity().writable);
    // Everything we can decode is shown, nothing is written or moved.
    QVERIFY(bench.device.readConfiguration(bench.channel));
    QCOMPARE(bench.device.perform(bench.channel, u"motors.on"_s, {}).error().code, ErrorCode::ReadOnly);
    QVERIFY(bench.device.perform(bench.channel, u"motors.off"_s, {}));
}

void TestSbgcDevice::findsRateAndParity_data()
{
    QTest::addColumn<int>("baud");
    QTest::addColumn<bool>("even");
    QTest::addColumn<int>("firmware");
    for (const int baud : {115200, 57600, 38400, 19200, 9600, 256000}) {
        for (const bool even : {false, true})
            QTest::addRow("%d %s", baud, even ? "even" : "none") << baud << even << 2590;
        QTest::addRow("%d firmware 2.40", baud) << baud << true << 2400;
    }
}

void TestSbgcDevice::findsRateAndParity()
{
    QFETCH(int, baud);
    QFETCH(bool, even);
    QFETCH(int, firmware);
    SimulatorOptions o = withFirmware(firmware);
    o.usb = false;
    const LineSettings line{baud, even ? Parity::Even : Parity::None};
    VirtualBoard bench(o, line);
    const auto found = find(bench, LinkAddress::serial(u"/dev/x"_s));
    QVERIFY(found);
    QCOMPARE(found->line->baud, baud);
    // From 2.41 on the board takes either parity, so "none" is found first; 2.40 answers to even only.
    QCOMPARE(found->line->parity, firmware < 2410 ? Parity::Even : Parity::None);
    // It says what it tries.
    QVERIFY(bench.channel.progressReports().front().subject.contains(u"115200 8N1"_s));
}

void TestSbgcDevice::findsABoardThatStartsLate_data()
{
    QTest::addColumn<int>("baud");  // 0: not given
    QTest::addColumn<bool>("isThere");
    QTest::newRow("all rates") << 0 << true;
    QTest::newRow("given") << 115200 << true;
    QTest::newRow("given, and not there") << 57600 << false;
}

void TestSbgcDevice::findsABoardThatStartsLate()
{
    QFETCH(const int, baud);
    QFETCH(const bool, isThere);
    SimulatorOptions o = withFirmware(2590);
    o.usb = false;
    VirtualBoard bench(o, LineSettings{115200, Parity::None});
    Starting channel(bench.channel, baud ? 3s : 5s);  // later than its own rate's turn
    const auto address
        = baud ? LinkAddress::serial(u"/dev/x"_s, baud, Parity::None) : LinkAddress::serial(u"/dev/x"_s);
    const TimePoint began = bench.channel.now();
    const auto found = findBoard(channel, bench.family, bench.device, allFamilies(), address);
    QCOMPARE(found.has_value(), isThere);
    if (isThere) {
        QCOMPARE(found->line->baud, 115200);
        return;
    }
    QVERIFY(bench.channel.now() - began >= 5s);
    // It says what was tried, and nothing else.
    QVERIFY2(found.error().detail.contains(u"57600 8N1"_s), qPrintable(found.error().detail));
    QVERIFY(!found.error().detail.contains(u"115200"_s));
}

void TestSbgcDevice::explainsSilenceGarbageAndForeigners()
{
    SimulatorOptions o = withFirmware(2400);
    o.usb = false;
    VirtualBoard silent(o, LineSettings{115200, Parity::Even});
    const auto address = LinkAddress::serial(u"/dev/x"_s, 115200, Parity::None);
    QCOMPARE(find(silent, address).error().code, ErrorCode::Silent);

    SimulatorOptions noisy;
    noisy.faults.flipByte = 1.0;
    VirtualBoard garbage(noisy);
    // The board hears nothing either, so it is made to talk.
    garbage.port.board().receive(asBytes(DataStream{25, 20, QByteArray(8, '\0')}.encode()));
    garbage.port.board().receive(asBytes(encodeFrame(85, DataStream{25, 20, QByteArray(8, '\0')}.encode())));
    QCOMPARE(find(garbage, address).error().code, ErrorCode::Garbage);

    const QList<Family> known = allFamilies();
#if GIMBAL_WITH_STORM32
    // Two MAVLink heartbeats, one behind the other; a STorM32 answering every byte with e.
    const QByteArray heartbeat = hex("FE 09 00 01 01 00 00 00 00 00 1A 03 00 04 03 12 34");
    QCOMPARE(recogniseProtocol(known, heartbeat + heartbeat), u"MAVLink"_s);
    QCOMPARE(recogniseProtocol(known, "eeeee"), u"STorM32"_s);
#endif
    QCOMPARE(recogniseProtocol(known, hex("3E 56 00")), QString());
}

void TestSbgcDevice::readsEverything_data()
{
    QTest::addColumn<int>("firmware");
    for (const int firmware : {2400, 2439, 2590, 2610, 2704, 2738})
        QTest::addRow("%d", firmware) << firmware;
}

void TestSbgcDevice::readsEverything()
{
    QFETCH(int, firmware);
    VirtualBoard bench(withFirmware(firmware));
    QVERIFY(bench.identify());
    const auto configuration = bench.device.readConfiguration(bench.channel);
    QVERIFY(configuration);
    const bool hasExt2 = firmware >= kBlocks[ParamsExt2].since;
    const bool hasExt3 = firmware >= kBlocks[ParamsExt3].since;
    QCOMPARE(configuration->blocks().size(), std::size_t(kProfileCount * (3 + hasExt2 + hasExt3)));
    QCOMPARE(configuration->profileNames().first(), u"Handheld"_s);
    for (const ParameterSpec &spec : configuration->parameters().all()) {
        if (spec.row->block == ParamsExt2 && !hasExt2)
            continue;
        for (int profile = 0; profile < kProfileCount; ++profile)
            QVERIFY2(configuration->raw(spec, profile).has_value(), qPrintable(spec.key));
        if (!spec.row->state && !isOfTheSimulator(spec.key))
            QCOMPARE(*configuration->raw(spec, 4), spec.defaultRaw);
    }
    const ParameterSpec &p = *configuration->parameters().find(u"pid.roll.p"_s);
    QCOMPARE(p.rounded(*configuration->raw(p, 1)).toDouble(), firmware < 2731 ? 45.0 : 45.3);
}

// Without a sensor there, a board tells zeros for the frame's angles.
void TestSbgcDevice::frameSensorThatIsNotUsedTellsNothing()
{
    SimulatorOptions options;
    options.own.insert(u"frame-imu"_s, 1);
    VirtualBoard bench(options);
    QVERIFY(bench.identify());
    const auto angles = [&bench] {
        std::ignore = bench.channel.sleep(1s);  // the hand shakes
        const auto status = bench.channel.transact(bench.device.statusRequest());
        return status ? QByteArray(status->payload.mid(38, 6)) : QByteArray();
    };
    QVERIFY(angles() != QByteArray(6, '\0'));
    auto block = bench.device.readBlock(bench.channel, {0, Params3});
    QVERIFY(block);
    (*block)[74] = 0;  // FRAME_IMU_POS, errata 3.4
    QVERIFY(bench.device.writeBlock(bench.channel, {0, Params3}, *block));
    QCOMPARE(angles(), QByteArray(6, '\0'));
}

void TestSbgcDevice::missingExtendedBlocksAreLeftOut()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    LossyChannel channel(bench.channel);
    for (int profile = 0; profile < kProfileCount; ++profile)
        channel.lose(CommandId::ReadParamsExt2, profile, 99);
    const auto configuration = bench.device.readConfiguration(channel);
    QVERIFY(configuration);
    QCOMPARE(configuration->blocks().size(), std::size_t(15));
    QVERIFY(!configuration->raw(*configuration->parameters().find(u"motion.roll.acc_limit"_s), 0));
    QCOMPARE(*configuration->raw(*configuration->parameters().find(u"filter.roll.lpf"_s), 0), 400);
    // It is asked for in each profile, and not again and again at the end.
    QCOMPARE(channel.lost(), kProfileCount + 2);
    // Without the main block there is nothing to show.
    LossyChannel deaf(bench.channel);
    for (int profile = 0; profile < kProfileCount; ++profile)
        deaf.lose(CommandId::ReadParams3, profile, 99);
    QCOMPARE(bench.device.readConfiguration(deaf).error().code, ErrorCode::Timeout);
}

void TestSbgcDevice::readTimeIsNearTheWire()
{
    SimulatorOptions o;
    o.usb = false;
    const LineSettings line{115200, Parity::None};
    VirtualBoard bench(o, line);
    std::ignore = bench.channel.setLine(line);
    QVERIFY(bench.identify());
    QVERIFY(bench.channel.sleep(100ms));
    const TimePoint start = bench.channel.now();
    QVERIFY(bench.device.readConfiguration(bench.channel));
    const double taken = seconds(bench.channel.now() - start);
    // 15 blocks and the names: requests of 6 (5) bytes, replies of 139, 109, 156 (245) bytes.
    const double wire = line.secondsFor(15 * 6 + 5 * (139 + 109 + 156) + 5 + 245);
    // The document's pause is 10 ms after each command, beside the wire.
    const double allowed = wire + 16 * 0.010;
    qInfo() << "configuration read in" << taken * 1000 << "ms; wire" << wire * 1000 << "ms; wire and pauses"
            << allowed * 1000 << "ms; ratio" << taken / allowed;
    QVERIFY(taken < 1.15 * allowed);
}

void TestSbgcDevice::selectsProfiles()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    for (const int profile : {3, 4, 0, 1, 2}) {
        QVERIFY(bench.device.selectProfile(bench.channel, profile));
        QCOMPARE(bench.board().activeProfile(), profile);
        QCOMPARE(*bench.device.activeProfile(bench.channel), profile);
    }
    QCOMPARE(bench.device.selectProfile(bench.channel, 5).error().code, ErrorCode::InvalidArgument);
}

void TestSbgcDevice::profileNames()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const QStringList names{u"Kran"_s, u"Büro"_s, u"五"_s, QString(), u"x"_s};
    QVERIFY(bench.device.writeProfileNames(bench.channel, names));
    QCOMPARE(*bench.device.readProfileNames(bench.channel), names);
}

void TestSbgcDevice::adjustablesAreVolatileUntilSaved()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    QVERIFY(bench.device.writeAdjustables(bench.channel, {{0, 77}, {39, 250}, {38, -5}}));
    const auto values = bench.device.readAdjustables(bench.channel, {0, 39, 38});
    QVERIFY(values);
    QCOMPARE((*values)[0].value, 77.0);
    QCOMPARE((*values)[1].value, 250.0);
    QCOMPARE((*values)[2].value, -5.0);
    QCOMPARE(bench.board().inUse(u"pid.roll.p"_s), 77);
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 35);
    // A profile that is loaded wipes them.
    QVERIFY(bench.device.selectProfile(bench.channel, 1));
    QVERIFY(bench.device.selectProfile(bench.channel, 0));
    QCOMPARE(bench.board().inUse(u"pid.roll.p"_s), 35);
    QVERIFY(bench.device.writeAdjustables(bench.channel, {{0, 78}}));
    QVERIFY(bench.device.perform(bench.channel, u"variables.save"_s, {}));
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 0), 78);
    QCOMPARE(bench.device.readAdjustables(bench.channel, {200}).error().code, ErrorCode::BoardError);
}

void TestSbgcDevice::steersToAnAngle()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    bench.board().stabilizer().imu().gyroCorrection = bench.board().stabilizer().imu().gyroBias;
    const auto reply = bench.device.perform(
        bench.channel, u"steer"_s,
        argumentsFor(bench.device, "steer",
                     {{u"yaw"_s, u"25"_s}, {u"speed"_s, u"40"_s}, {u"seconds"_s, u"3"_s}}));
    QVERIFY(reply);
    QVERIFY(std::abs(reply->value(u"imu.yaw"_s).toDouble() - 25.0) < 1.5);
    QVERIFY(std::abs(reply->value(u"imu.pitch"_s).toDouble()) < 1.5);
    QVERIFY(std::abs(bench.board().stabilizer().estimate(Axis::Yaw) - 25.0) < 1.5);
}

void TestSbgcDevice::speedModeStopsAtTheEnd()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    QVERIFY(bench.device.perform(
        bench.channel, u"steer"_s,
        argumentsFor(bench.device, "steer",
                     {{u"mode"_s, u"speed"_s}, {u"pitch"_s, u"15"_s}, {u"seconds"_s, u"2"_s}})));
    const double reached = bench.board().stabilizer().target(Axis::Pitch);
    QVERIFY2(reached > 24 && reached < 36, qPrintable(QString::number(reached)));
    std::ignore = bench.channel.sleep(2s);
    QCOMPARE(bench.board().stabilizer().target(Axis::Pitch), reached);
    QCOMPARE(
        bench.device.perform(bench.channel, u"steer"_s, argumentsFor(bench.device, "steer")).error().code,
        ErrorCode::InvalidArgument);
}

// Commands of later firmware were offered, and sent (errata 4.1).
void TestSbgcDevice::menuHasTheCommandsOfItsFirmware()
{
    for (const int firmware : {2590, 2600, 2738}) {
        VirtualBoard bench(withFirmware(firmware));
        QVERIFY(bench.identify());
        const auto menu = std::find_if(bench.device.actions().begin(), bench.device.actions().end(),
                                       [](const ActionSpec &action) { return action.key == "menu"_ba; });
        QVERIFY(menu != bench.device.actions().end());
        const ArgumentSpec &command = menu->arguments.front();
        const auto offers = [&command](int entry) {
            return std::any_of(command.choices.begin(), command.choices.end(),
                               [entry](const Choice &choice) { return choice.value == entry; });
        };
        QVERIFY(offers(18));
        QCOMPARE(offers(13), firmware >= 2600);
        QCOMPARE(offers(28), firmware >= 2600);
        QCOMPARE(offers(60), firmware >= 2680);
        QCOMPARE(offers(81), firmware >= 2730);
        QCOMPARE(bool(parseArguments(*menu, {{u"command"_s, u"81"_s}})), firmware >= 2730);
    }
}

// The 13-byte form of CONTROL has one mode for all axes (document CMD_CONTROL; errata 3.12): an axis that was
// not named was told to go to 0, and the mode of roll, 0, made nothing of the rest.
void TestSbgcDevice::oldFirmwareSteersAllAxesOrNone()
{
    VirtualBoard bench(withFirmware(2439));
    QVERIFY(bench.identify());
    const auto steer = [&bench](const QMap<QString, QString> &wanted) {
        return bench.device.perform(bench.channel, u"steer"_s, argumentsFor(bench.device, "steer", wanted));
    };
    bench.board().stabilizer().setTarget(Axis::Yaw, 12.0);
    for (const auto &wanted : {QMap<QString, QString>{{u"pitch"_s, u"-20"_s}},
                               {{u"roll"_s, u"10"_s}},
                               {{u"roll"_s, u"0"_s}, {u"pitch"_s, u"-20"_s}}}) {
        const auto refused = steer(wanted);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::InvalidArgument);
        QVERIFY2(refused.error().detail.contains(u"2.55b5"_s), qPrintable(refused.error().detail));
    }
    QCOMPARE(bench.board().stabilizer().target(Axis::Yaw), 12.0);
    QCOMPARE(bench.board().stabilizer().target(Axis::Pitch), 0.0);
    // Errata 9.4, the 13-byte example.
    simplebgc::Device::Control control{};
    control.fill({Angle, 0.0, 0.0});
    control[1] = {Angle, 30.0, 20.0};
    control[2] = {Angle, 30.0, -45.0};
    QCOMPARE(bench.device.controlFrames(control).setpoint.toHex(' ').toUpper(),
             "3E 43 0D 50 02 00 00 00 00 F6 00 8E 03 F6 00 00 F8 77");
    control[0].mode = NoControl;
    QVERIFY(bench.device.controlFrames(control).setpoint.isEmpty());
    const auto reply = steer({{u"roll"_s, u"0"_s}, {u"pitch"_s, u"-20"_s}, {u"yaw"_s, u"12"_s}});
    QVERIFY2(reply, qPrintable(reply ? QString() : reply.error().detail));
    QVERIFY(std::abs(bench.board().stabilizer().estimate(Axis::Pitch) + 20.0) < 1.5);
}

void TestSbgcDevice::steeringOutOfRangeIsRefused_data()
{
    QTest::addColumn<QString>("mode");
    QTest::addColumn<QString>("wanted");
    QTest::addColumn<QString>("range");
    QTest::newRow("two turns") << u"angle"_s << u"720"_s << u"-720 to 719.9°"_s;
    QTest::newRow("to the frame") << u"angle-frame"_s << u"-721"_s << u"-720 to 719.9°"_s;
    QTest::newRow("signal") << u"rc"_s << u"600"_s << u"-500 to 500"_s;
    QTest::newRow("speed") << u"speed"_s << u"4001"_s << u"-4000 to 4000"_s;
}

// 720 degrees wrapped to -720, and the camera turned the wrong way.
void TestSbgcDevice::steeringOutOfRangeIsRefused()
{
    QFETCH(QString, mode);
    QFETCH(QString, wanted);
    QFETCH(QString, range);
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const QVariantMap arguments{{u"mode"_s,
                                 int(mode == u"angle"_s             ? Angle
                                         : mode == u"angle-frame"_s ? AngleRelFrame
                                         : mode == u"rc"_s          ? Rc
                                                                    : Speed)},
                                {u"yaw"_s, wanted.toDouble()},
                                {u"speed"_s, 30.0},
                                {u"seconds"_s, 1.0},
                                {u"release"_s, true}};
    const auto refused = bench.device.perform(bench.channel, u"steer"_s, arguments);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::InvalidArgument);
    QVERIFY2(refused.error().detail.contains(range), qPrintable(refused.error().detail));
    QCOMPARE(bench.board().stabilizer().target(Axis::Yaw), 0.0);
    // Whoever asks: the wire does not turn round.
    simplebgc::Device::Control control{};
    control[2] = {Angle, 0.0, 725.0};
    const auto sent = decodeControl(asBytes(bench.device.controlFrames(control).setpoint).subspan(4, 15));
    QCOMPARE((*sent)[2].angle, 32767);
}

void TestSbgcDevice::everyControlModeIsEncoded()
{
    VirtualBoard old(withFirmware(2439));
    VirtualBoard now(withFirmware(2738));
    QVERIFY(old.identify());
    QVERIFY(now.identify());
    // All but those that steer nothing.
    QCOMPARE(old.device.modes().size(), std::size_t(6));
    QCOMPARE(now.device.modes().size(), std::size_t(8));
    for (const int still : {int(NoControl), int(Ignore)}) {
        simplebgc::Device::Control control{};
        control[1].mode = still;
        const auto command
            = decodeControl(asBytes(now.device.controlFrames(control).setpoint).subspan(4, 15));
        QCOMPARE((*command)[1].mode, still);
        const auto stop = decodeControl(asBytes(now.device.controlFrames(control).stop).subspan(4, 15));
        QCOMPARE((*stop)[1].mode, still);
    }
    for (const SteeringMode &mode : now.device.modes()) {
        if (mode.id == kVirtualChannelMode)
            continue;  // another command (tst_sbgcexpert)
        // Axes whose input is unknown keep what they do.
        SteeringSetpoint setpoint{mode.id, std::vector<double>(mode.inputs.size(), std::nan("")), {}};
        const bool usesSpeed = mode.find("speed") >= 0 || !mode.isPositional();
        setpoint.inputs[1] = mode.isPositional() ? 20.0 : 30.0;
        if (mode.find("speed") >= 0)
            setpoint.inputs[std::size_t(mode.find("speed"))] = 30.0;
        const ControlFrames frames = now.device.controlFrames(setpoint);
        const auto command = decodeControl(asBytes(frames.setpoint).subspan(4, 15));
        QVERIFY(command);
        QCOMPARE((*command)[1].mode & 0x0F, mode.id);
        QCOMPARE((*command)[0], ControlAxis());
        if (usesSpeed)
            QCOMPARE((*command)[1].speed, 246);  // 30 °/s, errata section 8
        const auto stop = decodeControl(asBytes(frames.stop).subspan(4, 15));
        QCOMPARE((*stop)[1].speed, 0);
        QCOMPARE(frames.release, encodeFrame(67, QByteArray(13, '\0')));
    }
    // Slow motion uses the fine unit where the firmware has it; before 2.55b5 all axes share one mode byte.
    simplebgc::Device::Control slow{};
    slow[2] = {Speed, 0.5, 0};
    const auto fine = decodeControl(asBytes(now.device.controlFrames(slow).setpoint).subspan(4, 15));
    QCOMPARE((*fine)[2].mode, int(Speed) | int(ControlHighResSpeed));
    QCOMPARE((*fine)[2].speed, 500);
    slow.fill({Speed, 0.5, 0});
    QCOMPARE(old.device.controlFrames(slow).setpoint.size(), 13 + 5);
}

void TestSbgcDevice::resetIsAnnounced()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    QVERIFY(bench.device.writeAdjustables(bench.channel, {{0, 99}}));
    TimePoint notice{};
    bench.channel.setTap([&](const FrameView &frame, TimePoint at) {
        if (bench.device.announcesReset(frame))
            notice = at;
    });
    QVERIFY(bench.device.perform(bench.channel, u"reset"_s, argumentsFor(bench.device, "reset")));
    QVERIFY(notice != TimePoint());
    const auto gone = bench.channel.sleep(3s);
    QCOMPARE(gone.error().code, ErrorCode::LinkClosed);  // native USB vanishes
    QVERIFY(bench.channel.now() - notice > 950ms && bench.channel.now() - notice < 1100ms);
    bench.port.advance(2s);
    QVERIFY(bench.port.isPlugged());
    QCOMPARE(bench.board().inUse(u"pid.roll.p"_s), 35);  // volatile values are gone
}

void TestSbgcDevice::defaultsOverwriteAProfile()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 1), 45);
    QVERIFY(bench.device.perform(bench.channel, u"defaults"_s,
                                 argumentsFor(bench.device, "defaults", {{u"what"_s, u"profile2"_s}})));
    QCOMPARE(bench.board().stored(u"pid.roll.p"_s, 1), 35);
    QCOMPARE(bench.board().stored(u"imu.gyro_trust"_s, 2), 190);
}

void TestSbgcDevice::motorsOffStopsEvenATuningBoard()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    QVERIFY(bench.channel.transact(
        confirmRequest(CommandId::AutoPid, hex("00 0F 80") + QByteArray(16, '\0'), 1)));
    std::ignore = bench.channel.sleep(1s);
    bench.channel.stopMotors(bench.device.stopPlan());
    std::ignore = bench.channel.sleep(200ms);
    QVERIFY(bench.channel.stopResult() && bench.channel.stopResult()->has_value());
    QVERIFY(!bench.board().stabilizer().motorsOn());
    std::ignore = bench.channel.sleep(2s);
    QVERIFY(!bench.board().stabilizer().motorsOn());
    QVERIFY(bench.device.switchMotorsOn(bench.channel));
    QVERIFY(bench.board().stabilizer().motorsOn());
}

// The same answer again and again is none, but of a board without its sensor, of which nothing changes.
void TestSbgcDevice::standingBoardsProveTheStop()
{
    const auto status = [](bool areOn, bool isBlind, char noise) {
        QByteArray payload(63, '\0');
        payload[0] = noise;
        payload[14] = isBlind;
        payload[57] = areOn;
        Frame frame;
        frame.id = number(CommandId::RealtimeData3);
        frame.payload = payload;
        return frame;
    };
    for (const bool isBlind : {false, true}) {
        const StopPlan plan = simplebgc::Device().stopPlan();
        QCOMPARE(plan.fromAnswer(status(true, isBlind, 1)), Proof::Refuted);
        QCOMPARE(plan.fromAnswer(status(false, isBlind, 1)), Proof::Nothing);
        QCOMPARE(plan.fromAnswer(status(false, isBlind, 1)), isBlind ? Proof::Proven : Proof::Nothing);
        QCOMPARE(plan.fromAnswer(status(false, isBlind, 2)), Proof::Proven);
    }
}

void TestSbgcDevice::debugVariablesAreListedAndRead()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const auto list = bench.device.perform(bench.channel, u"debug.list"_s, {});
    QVERIFY(list);
    QCOMPARE(list->value(u"MOTOR_OUT"_s).toString(), u"f32[3]"_s);
    const auto values = bench.device.perform(bench.channel, u"debug.read"_s, {});
    QVERIFY(values);
    QCOMPARE(values->size(), list->size());
    QCOMPARE(values->value(u"CYCLE_US"_s).toInt(), 800);
    QCOMPARE(values->value(u"MOTOR_OUT"_s).toList().size(), 3);
}

void TestSbgcDevice::faultsAreNamed()
{
    SimulatorOptions o;
    o.faults.noImu = true;
    o.faults.battery = 9.5;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    QVERIFY(bench.device.readConfiguration(bench.channel));  // a missing sensor never stops reading
    std::ignore = bench.channel.sleep(1s);
    const auto frame
        = bench.channel.transact(replyRequest(CommandId::RealtimeData3, {}, CommandId::RealtimeData3, 63, 1));
    const unsigned bits = ByteReader(QByteArrayView(frame->payload).sliced(14)).u16();
    QStringList keys;
    for (const BoardFault &fault : bench.device.faults(bits, 0)) {
        keys.append(fault.key);
        QVERIFY(!fault.meaning.isEmpty() && !fault.cure.isEmpty());
    }
    QCOMPARE(keys, (QStringList{u"no-sensor"_s, u"low-battery"_s, u"battery-empty"_s}));
    QVERIFY(!bench.board().stabilizer().motorsOn());
    QVERIFY(bench.device.faults(1 << 11, 9).front().name.contains(u"inversion"_s));
    QCOMPARE(bench.device.faults(0xFFF, 0).size(), std::size_t(12));
}

// Zeros of a sensor that is not there are no angles.
void TestSbgcDevice::aMissingSensorHasNoAngles()
{
    SimulatorOptions o;
    o.faults.noImu = true;
    VirtualBoard bench(o);
    QVERIFY(bench.identify());
    std::ignore = bench.channel.sleep(1s);
    const auto blind = bench.device.perform(bench.channel, u"angles"_s, {});
    QVERIFY(blind);
    QVERIFY(!blind->contains(u"imu.roll"_s) && blind->contains(u"target.roll"_s));
    QCOMPARE(blind->value(u"sensor"_s).toString(), u"missing"_s);
    bench.board().setFaults({});
    std::ignore = bench.channel.sleep(1s);
    const auto seeing = bench.device.perform(bench.channel, u"angles"_s, {});
    QVERIFY(seeing && seeing->contains(u"imu.roll"_s) && !seeing->contains(u"sensor"_s));
}

void TestSbgcDevice::survivesADisturbedCable()
{
    SimulatorOptions o;
    o.faults.flipByte = 0.0008;
    o.faults.loseByte = 0.0004;
    o.faults.doubleByte = 0.0004;
    o.faults.delayMs = 20;
    VirtualBoard bench(o);
    for (int i = 0; i < 10 && !bench.identify(); ++i) { }
    QVERIFY(!bench.device.identity().serial.isEmpty());
    int complete = 0;
    for (int i = 0; i < 5; ++i) {
        const auto configuration = bench.device.readConfiguration(bench.channel);
        if (!configuration)
            continue;
        complete += configuration->blocks().size() == 20;
        // What arrived is right, whatever the cable did.
        for (const ParameterSpec &spec : configuration->parameters().all()) {
            const auto raw = configuration->raw(spec, 4);
            if (raw && !spec.row->state && !isOfTheSimulator(spec.key))
                QCOMPARE(*raw, spec.defaultRaw);
        }
    }
    QVERIFY(complete >= 3);
}

void TestSbgcDevice::argumentsAreChecked()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    for (const ActionSpec &action : bench.device.actions()) {
        QVERIFY(*action.label && *action.help && *action.group);
        QVERIFY(!parseArguments(action, {{u"nonsense"_s, u"1"_s}}));
        for (const ArgumentSpec &argument : action.arguments) {
            if (argument.kind != ArgumentKind::Text)
                QVERIFY(!parseArguments(action, {{QLatin1String(argument.key), u"what"_s}}));
        }
    }
    QCOMPARE(bench.device.perform(bench.channel, u"nonsense"_s, {}).error().code, ErrorCode::Unsupported);
}

void TestSbgcDevice::simulatedBoardHoldsWhatMayBe_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<bool>("isNew");
    for (const int firmware :
         {2400, 2500, 2590, 2600, 2670, 2680, 2690, 2730, simplebgc::Device::kNewestFirmware}) {
        QTest::addRow("%d", firmware) << firmware << false;
        QTest::addRow("%d, unpacked", firmware) << firmware << true;
    }
}

// Fields of later firmware too: each value is one that an operator may set.
void TestSbgcDevice::simulatedBoardHoldsWhatMayBe()
{
    QFETCH(const int, firmware);
    QFETCH(const bool, isNew);
    SimulatorOptions options;
    options.firmware = firmware;
    options.own = {{u"encoders"_s, 1}, {u"magnetometer"_s, 1}};
    if (isNew)
        options.own.insert(u"condition"_s, 1);
    VirtualBoard board(options);
    QVERIFY(board.identify());
    const auto configuration = board.device.readConfiguration(board.channel);
    QVERIFY(configuration);
    QVERIFY(configuration->missing().empty());
    QStringList wrong;
    for (const ParameterSpec &spec : configuration->parameters().all()) {
        for (int profile = 0; profile < 5; ++profile) {
            const auto raw = configuration->raw(spec, profile);
            if (raw && !spec.row->state && !spec.accepts(*raw)
                && (profile == 0 || spec.row->scope == Scope::Profile))
                wrong.append(u"%1 of profile %2 = %3, allowed %4 to %5"_s.arg(spec.key)
                                 .arg(profile)
                                 .arg(*raw)
                                 .arg(spec.row->min)
                                 .arg(spec.row->max));
        }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

QTEST_APPLESS_MAIN(TestSbgcDevice)
#include "tst_sbgcdevice.moc"
