// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/decoder.h"
#include "protocol/bcflight/device.h"
#include "protocol/bcflight/luatext.h"
#include "protocol/bcflight/tables.h"
#include "protocol/session/stopplan.h"
#include "protocol/simulator/bcflight/board.h"
#include "protocol/simulator/link/virtualchannel.h"
#include "protocol/telemetry/telemetryplan.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace Qt::StringLiterals;
using namespace bcflight;
using Drone = bcflight::SimulatedBoard;

namespace {

SimulatorOptions optionsOf(Generation generation, QMap<QString, int> own = {})
{
    SimulatorOptions options;
    own.insert(QLatin1String(Drone::kGeneration), int(generation));
    options.own = own;
    options.faults.shake = 0;
    return options;
}

/// A simulated drone and a virtual channel to it, whose telemetry is kept.
struct Rig
{
    explicit Rig(Generation generation = Generation::G, const QMap<QString, int> &own = {})
        : options(optionsOf(generation, own))
        , port(std::make_unique<Drone>(options), options, {})
        , channel(port, family.makeFramer(), family.timing)
        , store(std::make_shared<TelemetryStore>(int(bcflight::channels().size())))
    {
        channel.setTap([this](const FrameView &frame, TimePoint at) { decoder.decode(frame, at, *store); });
        channel.setLatestValues(store);
    }
    Drone &board() { return static_cast<Drone &>(port.board()); }
    bool identify() { return device.identify(channel).has_value(); }
    Result<ActionReply> perform(const char *key, const QMap<QString, QString> &texts = {})
    {
        for (const ActionSpec &action : device.actions()) {
            if (qstrcmp(action.key, key) != 0)
                continue;
            const auto arguments = parseArguments(action, texts);
            return arguments ? device.perform(channel, QString::fromLatin1(key), *arguments)
                             : tl::unexpected(arguments.error());
        }
        return failure(ErrorCode::Unsupported, QString::fromLatin1(key));
    }
    bool calibrate() { return identify() && perform("calibrate.all").has_value(); }
    /// Somebody else flies it.
    void fly(const Controls &controls)
    {
        Request request;
        request.bytes = encode(Message::Controls, controls.encode(Generation::G));
        channel.post(request);
        std::ignore = channel.sleep(20ms);
    }
    bool arm()
    {
        if (!calibrate())
            return false;
        fly({.arm = true});
        return board().isArmed();
    }

    SimulatorOptions options;
    const Family family = bcflight::family();
    bcflight::Device device;
    SimulatedPort port;
    VirtualChannel channel;
    std::shared_ptr<TelemetryStore> store;
    Decoder decoder;
};

double gainOf(const Configuration &configuration, const char *key)
{
    return configuration.raw(*configuration.parameters().find(QString::fromLatin1(key)), 0).value_or(-1);
}

}  // namespace

/// What the program knows of a drone, against the simulated one in virtual time.
class TestBcflightDevice final : public QObject
{
    Q_OBJECT
private slots:
    void generationsAreTold_data();
    void generationsAreTold();
    void everythingIsRead();
    void gainsAreSetOneByOne();
    void noNumberIsNeverSent();
    void refusalIsSilence();
    void nothingIsSetWhileArmed_data();
    void nothingIsSetWhileArmed();
    void gainsAreStoredInTheText();
    void textThatCannotBeEditedIsLeftAlone_data();
    void textThatCannotBeEditedIsLeftAlone();
    void textIsUploaded();
    void textIsRefused_data();
    void textIsRefused();
    void motorTestNeedsACountAndCalibration();
    void deafDroneIsLeftAlone();
    void calibrationIsFollowed();
    void stopIsProvenByStateAndOutputs();
    void telemetryIsDecoded();
    void noFalsePoints();
    void consoleRefusesWhatSteers();
    void actionsTell();
};

void TestBcflightDevice::generationsAreTold_data()
{
    QTest::addColumn<int>("generation");
    QTest::addColumn<QString>("told");
    QTest::addColumn<bool>("writable");
    const auto add = [](Generation generation, const QString &told, bool writable) {
        QTest::newRow(qPrintable(generationText(generation))) << int(generation) << told << writable;
    };
    add(Generation::A, u"A"_s, false);
    add(Generation::B, u"B"_s, false);
    add(Generation::C, u"C"_s, false);
    add(Generation::D, u"C"_s, false);  // these two cannot be told apart
    add(Generation::E, u"E"_s, false);
    add(Generation::F, u"G"_s, true);  // they differ by one flag
    add(Generation::G, u"G"_s, true);
}

// Without side effects: the simulated receiver takes whatever it does not know for commands.
void TestBcflightDevice::generationsAreTold()
{
    QFETCH(int, generation);
    QFETCH(QString, told);
    QFETCH(bool, writable);
    Rig rig{Generation(generation)};
    const auto identity = rig.device.identify(rig.channel);
    QVERIFY2(identity, identity ? "" : qPrintable(identity.error().detail));
    QCOMPARE(identity->extra.value(u"generation"_s).toString(), told);
    QCOMPARE(identity->writable, writable);
    QVERIFY2(identity->model.contains(u"BCFlight"_s), qPrintable(identity->model));
    QVERIFY(!identity->isNumbered());
    // A question that older ones do not know has nothing behind it (errata 1).
    QVERIFY(rig.board().unknownMessages() <= (generation < int(Generation::F) ? 3 : 0));
    QVERIFY(!rig.board().isArmed() && !rig.board().status().calibrating);
}

void TestBcflightDevice::everythingIsRead()
{
    Rig rig;
    QVERIFY(rig.identify());
    const auto read = rig.device.readConfiguration(rig.channel);
    QVERIFY(read);
    QVERIFY(read->missing().empty());
    QCOMPARE(read->block({0, ConfigurationText}), rig.board().configuration());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const QString name = QLatin1String(axisKey(kAxes[axis]));
        QCOMPARE(gainOf(*read, qPrintable(u"pid."_s + name + u".p"_s)),
                 double(float(rig.board().gains()[axis][0])));
        QCOMPARE(gainOf(*read, qPrintable(u"pid."_s + name + u".d"_s)),
                 double(float(rig.board().gains()[axis][2])));
    }
    QCOMPARE(rig.board().unknownMessages(), 0);
}

void TestBcflightDevice::gainsAreSetOneByOne()
{
    Rig rig;
    QVERIFY(rig.identify());
    auto wanted = rig.device.readConfiguration(rig.channel).value();
    const auto before = rig.board().gains();
    QVERIFY(wanted.setRaw(*wanted.parameters().find(u"pid.pitch.d"_s), 0, double(2.125e-6F)));
    QVERIFY(wanted.setRaw(*wanted.parameters().find(u"horizon.roll.offset"_s), 0, double(1.5F)));
    const auto written = rig.device.writeBlock(rig.channel, {0, Gains}, wanted.block({0, Gains}));
    QVERIFY(written);
    const auto now = rig.device.readConfiguration(rig.channel).value();
    QCOMPARE(now.block({0, Gains}), wanted.block({0, Gains}));
    QCOMPARE(rig.board().gains()[1][2], double(2.125e-6F));
    // The others kept every bit.
    QCOMPARE(rig.board().gains()[1][0], before[1][0]);
    QCOMPARE(rig.board().gains()[0], before[0]);
}

// The drone would take it and fly with it.
void TestBcflightDevice::noNumberIsNeverSent()
{
    Rig rig;
    QVERIFY(rig.identify());
    auto bytes = rig.device.readBlock(rig.channel, {0, Gains}).value();
    const QByteArray before = bytes;
    bytes.replace(4, 4, bigF32(std::numeric_limits<float>::quiet_NaN()));
    const auto written = rig.device.writeBlock(rig.channel, {0, Gains}, bytes);
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::OutOfRange);
    QCOMPARE(rig.device.readBlock(rig.channel, {0, Gains}).value(), before);
    for (const double value : {std::nan(""), -0.1, 1.5})
        QVERIFY(!rig.device.writeAdjustables(rig.channel, {{0, value}}));
    QCOMPARE(rig.device.readBlock(rig.channel, {0, Gains}).value(), before);
}

void TestBcflightDevice::refusalIsSilence()
{
    Rig rig;
    QVERIFY(rig.identify());
    auto bytes = rig.device.readBlock(rig.channel, {0, Gains}).value();
    bytes.replace(0, 4, bigF32(1.5F));
    const auto written = rig.device.writeBlock(rig.channel, {0, Gains}, bytes);
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::Timeout);
}

void TestBcflightDevice::nothingIsSetWhileArmed_data()
{
    QTest::addColumn<QString>("what");
    for (const char *what : {"gain", "live", "text", "mode", "beep", "calibration", "store", "motor", "escs"})
        QTest::newRow(what) << QString::fromLatin1(what);
}

// Errata 9.2, rules 4, 5 and 6: the drone itself refuses hardly any of it.
void TestBcflightDevice::nothingIsSetWhileArmed()
{
    QFETCH(QString, what);
    Rig rig;
    QVERIFY(rig.arm());
    const QByteArray text = rig.board().configuration();
    const auto gains = rig.board().gains();
    auto bytes = rig.device.readBlock(rig.channel, {0, Gains}).value();
    bytes.replace(0, 4, bigF32(0.25F));
    const auto attempt = [&]() -> Result<void> {
        const auto done = [](const Result<ActionReply> &reply) {
            return reply ? Result<void>() : tl::unexpected(reply.error());
        };
        if (what == u"gain"_s)
            return rig.device.writeBlock(rig.channel, {0, Gains}, bytes);
        if (what == u"live"_s)
            return rig.device.writeAdjustables(rig.channel, {{0, 0.25}});
        if (what == u"text"_s)
            return rig.device.writeBlock(rig.channel, {0, ConfigurationText}, text + "-- more\n");
        if (what == u"mode"_s)
            return done(rig.perform("mode", {{u"mode"_s, u"rate"_s}}));
        if (what == u"beep"_s)
            return done(rig.perform("motors.beep", {{u"on"_s, u"on"_s}}));
        if (what == u"calibration"_s)
            return done(rig.perform("calibrate.gyro"));
        if (what == u"store"_s)
            return done(rig.perform("gains.store"));
        if (what == u"motor"_s)
            return done(rig.perform("motor.test", {{u"motor"_s, u"1"_s}}));
        return done(rig.perform("escs.calibrate"));
    };
    const auto result = attempt();
    QVERIFY(!result);
    QCOMPARE(result.error().code, ErrorCode::ConditionUnmet);
    QVERIFY2(result.error().detail.contains(u"armed"_s), qPrintable(result.error().detail));
    QVERIFY(rig.board().isArmed());
    QCOMPARE(rig.board().gains(), gains);
    QCOMPARE(rig.board().configuration(), text);
}

void TestBcflightDevice::gainsAreStoredInTheText()
{
    Rig rig;
    QVERIFY(rig.identify());
    const QByteArray before = rig.board().configuration();
    const double p = double(float(rig.board().gains()[0][0] * 1.25));
    QVERIFY(rig.device.writeAdjustables(rig.channel, {{0, p}}));
    const auto stored = rig.perform("gains.store");
    QVERIFY2(stored, stored ? "" : qPrintable(stored.error().detail));
    QCOMPARE(stored->value(u"changed"_s).toInt(), 1);
    // One number is another one, all else is as it was.
    const QByteArray after = rig.board().configuration();
    const auto literals = findGains(after, u"pid_roll"_s);
    QVERIFY(literals);
    QVERIFY(std::abs((*literals)[0].value - 112.5) < 0.001);
    QByteArray undone = after;
    undone.replace((*literals)[0].from, (*literals)[0].to - (*literals)[0].from, "90");
    QCOMPARE(undone, before);
    QCOMPARE(float(rig.board().gains()[0][0]), float(p));
    QVERIFY(!rig.board().isLost());
    // Nothing differs: nothing is uploaded, and it does not restart.
    QCOMPARE(rig.perform("gains.store").value().value(u"changed"_s).toInt(), 0);
}

void TestBcflightDevice::textThatCannotBeEditedIsLeftAlone_data()
{
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::newRow("set twice") << QByteArray("pid_yaw = PID( 180, 40, 0 ),")
                               << QByteArray("pid_yaw = PID( 180, 40, 0 ), pid_yaw = PID( 180, 40, 0 ),");
    QTest::newRow("computed") << QByteArray("PID( 90, 25, 80 )") << QByteArray("PID( 2 * 45, 25, 80 )");
}

void TestBcflightDevice::textThatCannotBeEditedIsLeftAlone()
{
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    Rig rig;
    QVERIFY(rig.identify());
    QByteArray text = rig.board().configuration();
    QVERIFY(text.contains(from));
    text.replace(from, to);
    rig.channel.expectSilence(20s);
    QVERIFY(rig.device.writeBlock(rig.channel, {0, ConfigurationText}, text));
    QVERIFY(rig.channel.sleep(20s));
    if (rig.board().isLost())
        return;  // this drone does not load such a text at all
    QVERIFY(rig.identify());
    QVERIFY(rig.device.writeAdjustables(rig.channel, {{0, 0.002}}));
    const auto stored = rig.perform("gains.store");
    QVERIFY(!stored);
    QCOMPARE(stored.error().code, ErrorCode::ConditionUnmet);
    QCOMPARE(rig.board().configuration(), text);
}

void TestBcflightDevice::textIsUploaded()
{
    Rig rig;
    QVERIFY(rig.identify());
    const QByteArray text = rig.board().configuration() + "-- uploaded\n";
    rig.channel.expectSilence(20s);
    QVERIFY(rig.device.writeBlock(rig.channel, {0, ConfigurationText}, text));
    QVERIFY(rig.channel.sleep(15s));
    QCOMPARE(rig.device.readBlock(rig.channel, {0, ConfigurationText}).value(), text);
    QCOMPARE(rig.board().configuration(), text);
    QVERIFY(!rig.board().status().calibrated);
}

void TestBcflightDevice::textIsRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<ErrorCode>("code");
    QTest::newRow("no Lua") << QByteArray("a = = 1\n") << ErrorCode::InvalidArgument;
    QTest::newRow("a later Lua") << QByteArray("a = 7 // 2\n") << ErrorCode::InvalidArgument;
    QTest::newRow("a later escape") << QByteArray("a = \"\\u{41}\"\n") << ErrorCode::InvalidArgument;
    QTest::newRow("compiled") << QByteArray("\x1bLJ\x02") << ErrorCode::InvalidArgument;
    QTest::newRow("a zero inside") << QByteArray("a = 1\0b = 2\n", 12) << ErrorCode::InvalidArgument;
    QTest::newRow("too long") << "--" + QByteArray(60000, 'x') << ErrorCode::TooMuch;
}

void TestBcflightDevice::textIsRefused()
{
    QFETCH(QByteArray, text);
    QFETCH(ErrorCode, code);
    Rig rig;
    QVERIFY(rig.identify());
    const QByteArray before = rig.board().configuration();
    const auto written = rig.device.writeBlock(rig.channel, {0, ConfigurationText}, text);
    QVERIFY(!written);
    QCOMPARE(written.error().code, code);
    QCOMPARE(rig.board().configuration(), before);
    QCOMPARE(rig.board().unknownMessages(), 0);
}

// Errata 7.7: before the calibration it would hang, with a wrong number it would end.
void TestBcflightDevice::motorTestNeedsACountAndCalibration()
{
    Rig rig;
    QVERIFY(rig.identify());
    const auto early = rig.perform("motor.test", {{u"motor"_s, u"1"_s}});
    QVERIFY(!early);
    QCOMPARE(early.error().code, ErrorCode::ConditionUnmet);
    QVERIFY(rig.perform("calibrate.all"));
    const auto fifth = rig.perform("motor.test", {{u"motor"_s, u"5"_s}});
    QVERIFY(!fifth);
    QCOMPARE(fifth.error().code, ErrorCode::InvalidArgument);
    QVERIFY(!rig.board().isLost());
    QVERIFY(rig.perform("telemetry.full", {{u"on"_s, u"off"_s}}));
    std::ignore = rig.channel.sleep(100ms);
    const auto unknown = rig.perform("motor.test", {{u"motor"_s, u"1"_s}});
    QVERIFY(!unknown);
    QCOMPARE(unknown.error().code, ErrorCode::ConditionUnmet);
    QVERIFY2(unknown.error().detail.contains(u"how many motors"_s), qPrintable(unknown.error().detail));
    QVERIFY(rig.perform("telemetry.full", {{u"on"_s, u"on"_s}}));
    const auto turned = rig.perform("motor.test", {{u"motor"_s, u"3"_s}});
    QVERIFY2(turned, turned ? "" : qPrintable(turned.error().detail));
    QVERIFY(!rig.board().isLost() && !rig.board().isArmed());
}

// What is sent meanwhile would be carried out afterwards, in a burst.
void TestBcflightDevice::deafDroneIsLeftAlone()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    qint64 atStart = -1;
    qint64 atEnd = -1;
    rig.channel.setOperator([&](const Progress &progress) {
        if (progress.step != u"motor-test"_s)
            return;
        atEnd = rig.channel.bytesOut();
        if (atStart < 0 && progress.done > 0)
            atStart = atEnd;
    });
    QVERIFY(rig.perform("motor.test", {{u"motor"_s, u"2"_s}}));
    QVERIFY(atStart > 0);
    QCOMPARE(atEnd, atStart);
}

void TestBcflightDevice::calibrationIsFollowed()
{
    Rig rig;
    QVERIFY(rig.identify());
    QVERIFY(!rig.board().status().calibrated);
    QVERIFY(rig.perform("calibrate.gyro"));
    QVERIFY(rig.board().status().calibrated && !rig.board().status().calibrating);
}

void TestBcflightDevice::stopIsProvenByStateAndOutputs()
{
    Rig rig;
    QVERIFY(rig.arm());
    rig.fly({.thrust = 0.5, .arm = true});
    rig.channel.stopMotors(rig.device.stopPlan());
    std::ignore = rig.channel.sleep(1s);
    QVERIFY(rig.channel.stopResult());
    QVERIFY(*rig.channel.stopResult());
    QVERIFY(!rig.board().isArmed());
    for (const double output : rig.board().outputs())
        QCOMPARE(output, 0.0);
    QCOMPARE(rig.board().unknownMessages(), 0);

    // Disarmed is not stopped: outputs that go on are no proof.
    Rig turning;
    QVERIFY(turning.calibrate());
    const StopPlan plan = turning.device.stopPlan();
    TelemetryStore store(int(bcflight::channels().size()));
    const auto state = store.defineGroup({Armed}, 0);
    const auto outputs = store.defineGroup({Outputs}, 0);
    const TimePoint now = TimePoint() + 1h;
    const auto tell = [&](float armed, float driven, TimePoint at) {
        store.append(*state, at, std::array{armed});
        store.append(*outputs, at, std::array{driven});
    };
    tell(0, 1, now + 10ms);
    QCOMPARE(plan.fromTelemetry(store, now), Proof::Refuted);
    tell(1, 0, now + 20ms);
    QCOMPARE(plan.fromTelemetry(store, now), Proof::Refuted);
    tell(0, 0, now + 30ms);
    QCOMPARE(plan.fromTelemetry(store, now), Proof::Proven);
    QCOMPARE(plan.fromTelemetry(store, now + 1s), Proof::Nothing);
}

void TestBcflightDevice::telemetryIsDecoded()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    const auto plan = rig.device.subscribe(rig.channel, {}, {});
    QVERIFY(plan && plan->poll);
    QVERIFY(rig.channel.transact(*plan->poll));
    std::ignore = rig.channel.sleep(200ms);
    const auto latest = [&rig](int channel) { return double(rig.store->latest(channel)); };
    QVERIFY(std::abs(latest(BatteryVolts) - 16.8) < 0.6);
    QCOMPARE(latest(Armed), 0.0);
    QCOMPARE(latest(Calibrated), 1.0);
    QCOMPARE(latest(Outputs), 0.0);
    QCOMPARE(latest(Motor1), 0.0);
    QVERIFY(std::isnan(latest(Motor1 + 4)));
    QCOMPARE(latest(Loops), 1250.0);
    QVERIFY2(std::abs(latest(AccelX + 2) - 9.8) < 1.0, qPrintable(QString::number(latest(AccelX + 2))));
    QVERIFY(std::abs(latest(AttitudeRoll)) < 5);
    rig.fly({.thrust = 0.5, .arm = true});
    std::ignore = rig.channel.sleep(300ms);
    QCOMPARE(latest(Outputs), 1.0);
    QVERIFY(latest(Motor1) > 1);
}

// Before the first arming the thrust is whatever the memory held.
void TestBcflightDevice::noFalsePoints()
{
    TelemetryStore store(int(bcflight::channels().size()));
    Decoder decoder;
    const auto take = [&](Message id, const QByteArray &payload) {
        decoder.decode({int(id), asBytes(payload)}, Clock::now(), store);
    };
    for (const float absurd : {std::nanf(""), 1e30F, -0.5F, 3.0F}) {
        take(Message::SetThrust, bigF32(absurd));
        QVERIFY(std::isnan(store.latest(Thrust)));
    }
    take(Message::SetThrust, bigF32(0.5F));
    QCOMPARE(store.latest(Thrust), 0.5F);
    take(Message::Gyro, bigF32(1) + bigF32(std::numeric_limits<float>::infinity()) + bigF32(3));
    QCOMPARE(store.latest(GyroX), 1.0F);
    QVERIFY(std::isnan(store.latest(GyroX + 1)));
    QCOMPARE(store.latest(GyroX + 2), 3.0F);
    // More motors than anybody has, and none at all.
    take(Message::MotorsSpeed, bigU32(0));
    take(Message::MotorsSpeed, bigU32(100) + QByteArray(400, '\0'));
    QVERIFY(std::isnan(store.latest(Outputs)));
}

void TestBcflightDevice::consoleRefusesWhatSteers()
{
    Rig rig;
    QVERIFY(rig.identify());
    for (const char *text :
         {"CONTROLS 0", "SET_THRUST 0.5", "SET_ROLL 1", "MOTOR_TEST 0", "CALIBRATE_ESCS", "SET_CONFIG_FILE 0",
          "UPDATE_UPLOAD_INIT", "NOTHING", "", "SET_ROLL_PID_P", "SET_ROLL_PID_P nan", "SET_ROLL_PID_P 2"})
        QVERIFY2(!rig.device.parseCommand(QString::fromLatin1(text)), text);
    const auto status = rig.device.parseCommand(u"status"_s);
    QVERIFY(status);
    QCOMPARE(status->bytes, QByteArray::fromHex("85"));
    QCOMPARE(status->risk, ActionRisk::Safe);
    const auto gain = rig.device.parseCommand(u"SET_ROLL_PID_P 0.5"_s);
    QVERIFY(gain);
    QCOMPARE(gain->bytes, QByteArray::fromHex("00503f000000"));
    QCOMPARE(gain->risk, ActionRisk::Writes);
    QCOMPARE(rig.device.describeSent(gain->bytes).name, u"SET_ROLL_PID_P"_s);
    QCOMPARE(rig.device.describeSent(QByteArray::fromHex("8582")).name, u"STATUS + TELEMETRY"_s);
    QVERIFY(!rig.device.commandNames().contains(u"CONTROLS"_s));
}

void TestBcflightDevice::actionsTell()
{
    Rig rig;
    QVERIFY(rig.identify());
    const auto status = rig.perform("status");
    QVERIFY(status);
    QCOMPARE(status->value(u"armed"_s).toBool(), false);
    QVERIFY(status->value(u"battery.voltage"_s).toDouble() > 10);
    QVERIFY(!rig.perform("board").value().isEmpty());
    QVERIFY(rig.perform("sensors").value().contains(u"Gyroscopes.ICM-42605.sample_rate"_s));
    const auto vtx = rig.perform("vtx.channel", {{u"band"_s, u"RaceBand"_s}, {u"channel"_s, u"2"_s}});
    QVERIFY2(vtx, vtx ? "" : qPrintable(vtx.error().detail));
    QCOMPARE(vtx->value(u"frequency"_s).toInt(), 5695);
    QCOMPARE(rig.perform("mode", {{u"mode"_s, u"rate"_s}}).value().value(u"mode"_s).toInt(), 0);
    QVERIFY(!rig.perform("recordings").value().isEmpty());
    Rig bare{Generation::G, {{QLatin1String(Drone::kCamera), 0}, {QLatin1String(Drone::kTransmitter), 0}}};
    QVERIFY(bare.identify());
    QVERIFY(!bare.perform("camera"));
    QVERIFY(!bare.perform("vtx.power", {{u"power"_s, u"2"_s}}));
    QCOMPARE(bare.board().unknownMessages(), 0);
}

QTEST_GUILESS_MAIN(TestBcflightDevice)
#include "tst_bcflightdevice.moc"
