// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the errata forbid a ground (9.2), seen in the packets that leave for a drone.
#include "protocol/bcflight/luacheck.h"
#include "protocol/procedure/safeaction.h"
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/record/boardhistory.h"
#include "protocol/session/channelproxy.h"
#include "protocol/session/stopplan.h"
#include "protocol/telemetry/telemetryplan.h"
#include "tests/support/dronerig.h"
#include "tests/support/watcheddrone.h"

#include <QTemporaryDir>
#include <QTemporaryFile>
#include <QTest>

#include <algorithm>

using namespace Qt::StringLiterals;
using namespace bcflight;
using Drone = bcflight::SimulatedBoard;

namespace {

constexpr int kStatusId = 0x85;

/// A drone, a virtual channel to it, and every packet that goes there.
struct Rig : DroneRig
{
    explicit Rig(Generation generation = Generation::G, bool isPacketBased = true, const Faults &faults = {})
        : Rig(droneOptions(generation, {}, faults), isPacketBased)
    {
    }
    Rig(const SimulatorOptions &made, bool isPacketBased)
        : DroneRig(made, make(made, isPacketBased))
    {
        watched().onReceive = [this](QByteArray &packet) {
            sent.append(packet);
            return !loses || !loses(packet);
        };
    }
    static std::unique_ptr<WatchedDrone> make(const SimulatorOptions &options, bool isPacketBased)
    {
        auto drone = std::make_unique<WatchedDrone>(options);
        drone->packetBased = isPacketBased;
        return drone;
    }
    WatchedDrone &watched() { return static_cast<WatchedDrone &>(port.board()); }
    Drone &drone() { return watched().drone(); }
    /// Somebody else arms it.
    bool arm()
    {
        drone().receive(asBytes(encode(
            Message::Controls, Controls{.thrust = 0.3, .arm = true}.encode(Generation::G), Generation::G)));
        std::ignore = channel.sleep(20ms);
        return drone().isArmed();
    }
    /// What the drone says of its state from now on.
    void tell(std::uint32_t bits)
    {
        watched().onSend = [bits](QByteArray &packet) {
            if (quint8(packet[0]) == kStatusId)
                packet = char(kStatusId) + bigU32(bits);
            return true;
        };
    }
    /// Apart from heartbeats.
    [[nodiscard]] bool hasSentNothing() const
    {
        return std::all_of(sent.begin(), sent.end(),
                           [](const QByteArray &packet) { return packet.startsWith('\x81'); });
    }
    [[nodiscard]] bool hasSent(const char *start) const
    {
        return std::any_of(sent.begin(), sent.end(), [start](const QByteArray &packet) {
            return packet.startsWith(QByteArray::fromHex(start));
        });
    }
    Result<bool> type(const QString &text)
    {
        const auto command = device.parseCommand(text);
        if (!command)
            return tl::unexpected(command.error());
        const BoardHistory history(dir.path());
        const auto done = sendRaw(channel, device, *command, history, {});
        std::ignore = channel.sleep(50ms);
        return done;
    }

    QTemporaryDir dir;
    QList<QByteArray> sent;
    std::function<bool(const QByteArray &)> loses;
};

/// The messages of a packet as a drone of that generation reads it; nothing: one that it does not know.
QList<std::optional<Message>> messagesIn(const QByteArray &packet, Generation generation)
{
    QList<std::optional<Message>> all;
    DroneReader reader(asBytes(packet), generation);
    while (const auto item = reader.next())
        all.append(item->id);
    return all;
}

}  // namespace

class TestBcflightSafety final : public QObject
{
    Q_OBJECT
private slots:
    void nothingSteersOverTcp();
    void uploadsNeedWholePackets();
    void olderOnesAreToldNothing_data();
    void olderOnesAreToldNothing();
    void onlyWhatItsGenerationKnowsIsSent_data();
    void onlyWhatItsGenerationKnowsIsSent();
    void nothingStandsBehindAText();
    void typedWordsAreRefusedInTheAir_data();
    void typedWordsAreRefusedInTheAir();
    void nothingForTheGroundIsSentInTheAir();
    void typedWordsAreThoseOfItsGeneration();
    void whatSteersIsNeverTyped();
    void actionsWaitForTheFirstWord();
    void benchIsRefusedWhileItCalibrates();
    void motorsAreCountedByTheirOutputs();
    void stopSaysBothAndIsRepeated();
    void stopIsNotBelievedByItself();
    void brokenLinkProvesNoStop();
    void drivenOutputsProveNoStop();
    void lostAnswersMakeNoOldDrone();
    void standingIsProvenByBoth();
    void textIsNeverRun();
};

// Errata 9.1: closing it leaves the motors running, and arm = 0 does not stop them.
void TestBcflightSafety::nothingSteersOverTcp()
{
    Rig rig(Generation::G, false);
    QVERIFY(rig.identify());
    QVERIFY(!rig.device.steering());
    QVERIFY(rig.device.perform(rig.channel, u"calibrate.all"_s, {}));
    for (const QString &turns : {u"motor.test"_s, u"escs.calibrate"_s}) {
        const auto done = rig.device.perform(rig.channel, turns, {{u"motor"_s, 1}});
        QVERIFY(!done);
        QCOMPARE(done.error().code, ErrorCode::Unsupported);
    }
    QVERIFY(QString::fromUtf8(rig.device.refusal()).contains(u"TCP"_s));
    Rig udp;
    QVERIFY(udp.identify());
    QVERIFY(udp.device.steering());
}

// Errata 2.6: what is cut in two is read as commands.
void TestBcflightSafety::uploadsNeedWholePackets()
{
    Rig rig(Generation::G, false);
    QVERIFY(rig.identify());
    const auto written = rig.device.writeBlock(rig.channel, {0, ConfigurationText},
                                               rig.drone().configuration() + "-- more\n");
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::Unsupported);
    QVERIFY(!rig.hasSent("0071"));
    QVERIFY(rig.device.writeAdjustables(rig.channel, {{0, 0.002}}));
    QVERIFY(!rig.perform("gains.store"));
    QVERIFY(!rig.hasSent("0071"));
    QTemporaryFile firmware;
    QVERIFY(firmware.open());
    QByteArray image;
    for (int i = 0; i < 3000; ++i)
        image.append(char(i * 37 + i / 256));
    QCOMPARE(firmware.write(image), image.size());
    firmware.close();
    const auto uploaded = rig.perform("firmware.upload", {{u"file"_s, firmware.fileName()}});
    QVERIFY(!uploaded);
    QCOMPARE(uploaded.error().code, ErrorCode::Unsupported);
    QVERIFY(!rig.hasSent("0072"));
}

void TestBcflightSafety::olderOnesAreToldNothing_data()
{
    QTest::addColumn<int>("generation");
    for (const Generation each : {Generation::A, Generation::B, Generation::C, Generation::D, Generation::E})
        QTest::newRow(qPrintable(generationText(each))) << int(each);
}

// Unknown generations are looked at and stopped, and nothing else.
void TestBcflightSafety::olderOnesAreToldNothing()
{
    QFETCH(int, generation);
    Rig rig{Generation(generation)};
    QVERIFY(rig.identify());
    QVERIFY(!rig.device.identity().writable);
    const QStringList questions{u"status"_s, u"motors.off"_s, u"board"_s, u"sensors"_s, u"cameras"_s};
    rig.sent.clear();
    for (const ActionSpec &action : rig.device.actions()) {
        const QString key = QString::fromLatin1(action.key);
        if (questions.contains(key))
            continue;
        const auto done = rig.device.perform(rig.channel, key, {{u"on"_s, true}, {u"motor"_s, 1}});
        QVERIFY2(!done && done.error().code == ErrorCode::Unsupported, action.key);
    }
    QVERIFY(rig.hasSentNothing());
    for (const QString &text : {u"SET_ROLL_PID_P 0.1"_s, u"CALIBRATE 1 0"_s, u"SET_MODE 1"_s,
                                u"RESET_BATTERY 0"_s, u"VIDEO_TAKE_PICTURE"_s}) {
        const auto done = rig.type(text);
        QVERIFY2(!done && done.error().code == ErrorCode::ReadOnly, qPrintable(text));
    }
    QVERIFY(rig.hasSentNothing());
    // Nor by whoever writes, sets or puts back values.
    const auto base = rig.device.readConfiguration(rig.channel);
    QVERIFY(base);
    Configuration edited = *base;
    edited.setBlock({0, ConfigurationText}, rig.drone().configuration() + "-- more\n");
    rig.sent.clear();
    const BoardHistory history(rig.dir.path());
    WriteOptions options;
    options.history = &history;
    const auto report = writeConfiguration(rig.channel, rig.device, *base, edited, options);
    QVERIFY(!report);
    QCOMPARE(report.error().code, ErrorCode::ReadOnly);
    QVERIFY(rig.hasSentNothing());
    const auto gains = base->block({0, Gains});
    const float half = rig.drone().gains()[0][0] / 2;
    const Result<void> attempts[]{
        rig.device.writeBlock(rig.channel, {0, ConfigurationText}, edited.block({0, ConfigurationText})),
        rig.device.writeBlock(rig.channel, {0, Gains}, bigF32(half) + gains.mid(4)),
        rig.device.writeAdjustables(rig.channel, {{0, double(half)}}),
        rig.device.restoreAdjustables(rig.channel, {{0, double(half)}})};
    for (const Result<void> &attempt : attempts) {
        QVERIFY(!attempt);
        QCOMPARE(attempt.error().code, ErrorCode::ReadOnly);
    }
    for (const QByteArray &packet : rig.sent) {
        for (const auto &id : messagesIn(packet, Generation(generation)))
            QVERIFY2(id && (*id < Message::SetRollP || *id > Message::SetHorizonOffset), packet.toHex());
    }
}

void TestBcflightSafety::onlyWhatItsGenerationKnowsIsSent_data()
{
    olderOnesAreToldNothing_data();
    QTest::newRow("F") << int(Generation::F);
    QTest::newRow("G") << int(Generation::G);
}

// Errata 9.2, 9: nothing unknown apart from the two questions of the detection (1), which carry nothing, and
// nothing empty.
void TestBcflightSafety::onlyWhatItsGenerationKnowsIsSent()
{
    QFETCH(int, generation);
    Rig rig{Generation(generation)};
    QVERIFY(rig.identify());
    const auto read = rig.device.readConfiguration(rig.channel);
    QVERIFY(read);
    QCOMPARE(read->block({0, ConfigurationText}), rig.drone().configuration());
    for (const char *key : {"status", "board", "sensors", "motors.off"}) {
        const auto done = rig.perform(key);
        QVERIFY2(done, done ? "" : qPrintable(u"%1: %2"_s.arg(QLatin1String(key), done.error().detail)));
    }
    const auto plan = rig.device.subscribe(rig.channel, {}, {});
    QVERIFY(plan && plan->poll);
    std::ignore = rig.channel.transact(*plan->poll);
    rig.channel.stopMotors(rig.device.stopPlan());
    std::ignore = rig.channel.sleep(1s);
    QVERIFY(rig.sent.size() > 10);
    for (const QByteArray &packet : rig.sent) {
        QVERIFY(!packet.isEmpty());
        if (packet == QByteArray::fromHex("85") || packet == QByteArray::fromHex("0601"))
            continue;
        for (const auto &id : messagesIn(packet, Generation(generation)))
            QVERIFY2(id, packet.toHex().constData());
    }
}

// Errata 2.5: whatever followed would be read shifted.
void TestBcflightSafety::nothingStandsBehindAText()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    QVERIFY(rig.device.writeBlock(rig.channel, {0, ConfigurationText},
                                  rig.drone().configuration() + "-- more\n"));
    int texts = 0;
    for (const QByteArray &packet : rig.sent) {
        if (!packet.startsWith(QByteArray::fromHex("0071")))
            continue;
        ++texts;
        QCOMPARE(packet.indexOf('\0', 6), packet.size() - 1);
        QVERIFY(packet.size() < 60000 + 7);
    }
    QCOMPARE(texts, 1);
    QCOMPARE(rig.drone().unknownMessages(), 0);
}

void TestBcflightSafety::typedWordsAreRefusedInTheAir_data()
{
    QTest::addColumn<QString>("text");
    for (const QString &text : {u"SET_ROLL_PID_P 0.25"_s, u"SET_HORIZON_OFFSET 5 5"_s, u"SET_MODE 1"_s,
                                u"CALIBRATE 1 0"_s, u"MOTORS_BEEP 1"_s, u"SET_ALTITUDE_HOLD 1"_s})
        QTest::newRow(qPrintable(text)) << text;
}

// Errata 9.2, 4 and 5: the drone would take them.
void TestBcflightSafety::typedWordsAreRefusedInTheAir()
{
    QFETCH(QString, text);
    Rig rig;
    QVERIFY(rig.calibrate());
    QVERIFY(rig.type(text));
    if (!rig.drone().status().calibrated)
        std::ignore = rig.channel.sleep(4s);
    QVERIFY(rig.arm());
    rig.sent.clear();
    const auto done = rig.type(text);
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::ConditionUnmet);
    for (const QByteArray &packet : rig.sent)
        QVERIFY2(packet == "\x85" || packet.startsWith('\x81'),
                 packet.toHex());  // it was asked, and nothing else was sent
    // What stops always goes out.
    QVERIFY(rig.type(u"RESET_MOTORS"_s));
    QVERIFY(!rig.drone().isArmed());
}

// Whoever sends it: the row of each message decides.
void TestBcflightSafety::nothingForTheGroundIsSentInTheAir()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    QVERIFY(rig.arm());
    rig.sent.clear();
    const BoardHistory history(rig.dir.path());
    int refused = 0;
    for (const MessageSpec &message : messages()) {
        if (message.maySend == MaySend::Anytime)
            continue;
        const QByteArray bytes = message.fromGround ? encode(message.id) : QByteArray("\x84");
        const auto done = sendRaw(rig.channel, rig.device,
                                  {QString::fromLatin1(message.name), bytes, ActionRisk::Safe}, history, {});
        QVERIFY2(!done && done.error().code == ErrorCode::ConditionUnmet, message.name);
        ++refused;
    }
    QVERIFY(refused > 50);
    for (const ActionSpec &action : rig.device.actions()) {
        if (!action.stopsMotors)
            std::ignore = rig.perform(action.key, {{u"motor"_s, 1}, {u"on"_s, true}});
    }
    std::ignore = rig.channel.sleep(50ms);
    for (const QByteArray &packet : rig.sent) {
        for (const auto &id : messagesIn(packet, Generation::G))
            QVERIFY2(id && findMessage(*id)->maySend == MaySend::Anytime, packet.toHex());
    }
    QVERIFY(rig.drone().isArmed());
    // The same messages are taken on the ground.
    QVERIFY(rig.type(u"RESET_MOTORS"_s));
    QVERIFY(rig.type(u"SET_MODE 1"_s) && rig.hasSent("0048"));
}

void TestBcflightSafety::typedWordsAreThoseOfItsGeneration()
{
    Rig old{Generation::C};
    QVERIFY(old.identify());
    QVERIFY(!old.device.parseCommand(u"STATUS"_s));  // which it would take for something else
    QVERIFY(!old.device.parseCommand(u"VTX_GET_SETTINGS"_s));
    QVERIFY(old.device.parseCommand(u"TELEMETRY"_s));
    Rig now;
    QVERIFY(now.identify());
    QVERIFY(now.device.parseCommand(u"STATUS"_s));
    QVERIFY(now.device.parseCommand(u"VTX_GET_SETTINGS"_s));
}

// Errata 9.2, 7 and 9: not by its name either, in whatever generation.
void TestBcflightSafety::whatSteersIsNeverTyped()
{
    for (const Generation generation : {Generation::A, Generation::C, Generation::E, Generation::G}) {
        Rig rig{generation};
        QVERIFY(rig.identify());
        const QStringList names = rig.device.commandNames();
        QVERIFY(names.contains(u"RESET_MOTORS"_s));
        for (const Message id :
             {Message::Unknown, Message::Controls, Message::SetRoll, Message::SetPitch, Message::SetYaw,
              Message::SetThrust, Message::SetConfigFile, Message::UploadInit, Message::UploadData,
              Message::UploadProcess, Message::MotorTest, Message::CalibrateEscs, Message::Ack}) {
            const MessageSpec *spec = findMessage(id);
            const QString text = QLatin1String(spec->name);
            QVERIFY2(!names.contains(text), spec->name);
            // With as many numbers as it takes.
            const auto fields = spec->fromGround ? spec->fromGround->size() : 0;
            QVERIFY2(!rig.device.parseCommand(text + u" 0"_s.repeated(qsizetype(fields))), spec->name);
        }
    }
}

// Telemetry of a board that has just been connected: its first word comes after a while.
struct LateTelemetry final : LatestValues
{
    LateTelemetry(const DroneRig &of, Duration wait)
        : rig(of)
        , begins(of.channel.now() + wait)
    {
    }
    float latest(int channel) const override
    {
        return rig.channel.now() < begins ? std::nanf("") : rig.store->latest(channel);
    }
    TimePoint latestAt(int channel) const override
    {
        return std::isnan(latest(channel)) ? TimePoint{} : rig.channel.now();
    }
    const DroneRig &rig;
    TimePoint begins;
};

void TestBcflightSafety::actionsWaitForTheFirstWord()
{
    Rig rig;
    const BoardHistory history(rig.dir.path());
    QVERIFY(rig.identify());
    const LateTelemetry never(rig, 1h);
    const auto refused = performSafely(rig.channel, rig.device, u"calibrate.gyro"_s, {}, history, {}, &never);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::ConditionUnmet);
    QVERIFY(!rig.drone().status().calibrated);
    const LateTelemetry soon(rig, 1s);
    const auto done = performSafely(rig.channel, rig.device, u"calibrate.gyro"_s, {}, history, {}, &soon);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QVERIFY(rig.drone().status().calibrated);
}

// Errata 7.7.
void TestBcflightSafety::benchIsRefusedWhileItCalibrates()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    // Its words count, whatever else it says.
    rig.tell(Status::kCalibrated | Status::kCalibrating);
    for (const char *key : {"motor.test", "escs.calibrate", "motors.beep", "mode", "gains.store"}) {
        const auto done = rig.perform(key, {{u"motor"_s, 1}, {u"on"_s, true}, {u"mode"_s, 0}});
        QVERIFY2(!done && done.error().code == ErrorCode::ConditionUnmet, key);
    }
    for (const char *start : {"00e0", "0066", "00e1", "0048", "0071"})
        QVERIFY2(!rig.hasSent(start), start);
}

// Errata 7.7: as many as MOTORS_SPEED tells, and not as most drones have.
void TestBcflightSafety::motorsAreCountedByTheirOutputs()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    const QByteArray outputs = encode(Message::MotorsSpeed, bigU32(4));
    rig.watched().onSend = [&outputs](QByteArray &packet) {
        if (const qsizetype at = packet.indexOf(outputs); at >= 0)
            packet.replace(at, outputs.size() + 16,
                           encode(Message::MotorsSpeed, bigU32(3)) + QByteArray(12, '\0'));
        return true;
    };
    const auto fourth = rig.perform("motor.test", {{u"motor"_s, 4}});
    QVERIFY(!fourth);
    QCOMPARE(fourth.error().code, ErrorCode::InvalidArgument);
    QVERIFY(!rig.hasSent("00e0"));
    QVERIFY(rig.perform("motor.test", {{u"motor"_s, 3}}));
    QVERIFY(rig.hasSent("00e000000002"));
}

// Errata 9.2, 2: disarmed controls and RESET_MOTORS, over and over until it says so.
void TestBcflightSafety::stopSaysBothAndIsRepeated()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    QVERIFY(rig.arm());
    rig.sent.clear();
    const TimePoint heardFrom = rig.channel.now() + 1s;
    rig.loses = [&](const QByteArray &) { return rig.channel.now() < heardFrom; };
    rig.channel.stopMotors(rig.device.stopPlan());
    std::ignore = rig.channel.sleep(900ms);
    QVERIFY(rig.drone().isArmed());
    const QByteArray disarmed = encode(Message::Controls, Controls().encode(Generation::G), Generation::G);
    QVERIFY2(rig.sent.count(disarmed) >= 8, qPrintable(QString::number(rig.sent.count(disarmed))));
    QVERIFY(rig.sent.count(QByteArray::fromHex("0047")) >= 8);
    QVERIFY(rig.sent.count(QByteArray::fromHex("85")) >= 8);
    std::ignore = rig.channel.sleep(500ms);
    QVERIFY(!rig.drone().isArmed());
    QVERIFY(rig.channel.stopResult() && *rig.channel.stopResult());
    const auto stops = rig.sent.count(QByteArray::fromHex("0047"));
    std::ignore = rig.channel.sleep(1s);
    QCOMPARE(rig.sent.count(QByteArray::fromHex("0047")), stops);  // then it is over
}

// A drone that says nothing, or that it is armed, is not said to be stopped.
void TestBcflightSafety::stopIsNotBelievedByItself()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    QVERIFY(rig.arm());
    QVERIFY(rig.port.change(u"runs-on=1"_s));
    const auto stopped = rig.perform("motors.off");
    QVERIFY(!stopped);
    QCOMPARE(stopped.error().code, ErrorCode::NotProven);
    QVERIFY(rig.sent.count(QByteArray::fromHex("0047")) >= 5);
    QVERIFY(rig.port.change(u"runs-on=0"_s));
    QVERIFY(rig.perform("motors.off"));
    QVERIFY(!rig.drone().isArmed());
    // Its motors stand, and it is armed all the same.
    rig.tell(Status::kArmed | Status::kCalibrated);
    const auto armed = rig.perform("motors.off");
    QVERIFY(!armed);
    QCOMPARE(armed.error().code, ErrorCode::NotProven);
    rig.loses = [](const QByteArray &) { return true; };
    const auto silent = rig.perform("motors.off");
    QVERIFY(!silent);
    QCOMPARE(silent.error().code, ErrorCode::Timeout);
}

// The outputs do not come because nothing comes any more, which is no board that streams none.
void TestBcflightSafety::brokenLinkProvesNoStop()
{
    struct Gone final : Mailbox
    {
        Result<Frame> next(milliseconds) override { return failure(ErrorCode::LinkClosed); }
    };
    struct Breaking final : ChannelProxy
    {
        using ChannelProxy::ChannelProxy;
        std::unique_ptr<Mailbox> listen(std::function<bool(const FrameView &)>) override
        {
            return std::make_unique<Gone>();
        }
    };
    Rig rig;
    QVERIFY(rig.calibrate());
    Breaking channel(rig.channel);
    const auto stopped = rig.device.perform(channel, u"motors.off"_s, {});
    QVERIFY(!stopped);
    QCOMPARE(stopped.error().code, ErrorCode::LinkClosed);
}

// It says that it is disarmed, and drives them all the same.
void TestBcflightSafety::drivenOutputsProveNoStop()
{
    struct Driven final : Mailbox
    {
        explicit Driven(Frame told)
            : frame(std::move(told))
        {
        }
        Result<Frame> next(milliseconds) override { return frame; }
        Frame frame;
    };
    struct Driving final : ChannelProxy
    {
        using ChannelProxy::ChannelProxy;
        std::unique_ptr<Mailbox> listen(std::function<bool(const FrameView &)>) override
        {
            return std::make_unique<Driven>(told);
        }
        Frame told;
    };
    Rig rig;
    QVERIFY(rig.calibrate());
    const auto outputs
        = rig.channel.listen([](const FrameView &frame) { return frame.id == int(Message::MotorsSpeed); });
    Driving channel(rig.channel);
    const auto turns = [&] {
        const auto frame = outputs->next(1s);
        if (frame)
            channel.told = *frame;
        return frame && areDriven(outputsIn(asBytes(frame->payload)));
    };
    QVERIFY(rig.arm());
    while (!turns() && rig.channel.now() < TimePoint() + 2h)
        rig.channel.steer(rig.device.steering()->controlFrames({1, {0.4, 0, 0, 0}, {1}}));
    QVERIFY(areDriven(outputsIn(asBytes(channel.told.payload))));
    rig.channel.releaseControl();
    const auto stopped = rig.device.perform(channel, u"motors.off"_s, {});
    QVERIFY(!stopped);
    QCOMPARE(stopped.error().code, ErrorCode::NotProven);
    QVERIFY2(stopped.error().detail.contains(u"though disarmed"_s), qPrintable(stopped.error().detail));
}

// Its generation is told by what it answers: four answers that are lost are not its age.
void TestBcflightSafety::lostAnswersMakeNoOldDrone()
{
    Rig rig;
    int lost = 0;
    rig.loses = [&lost](const QByteArray &packet) { return packet == "\x85" && lost++ < 4; };
    QVERIFY(rig.identify());
    QVERIFY(lost >= 4);
    QVERIFY(rig.device.identity().writable);
}

// Errata 9.2, 8: by what was told since, of both.
void TestBcflightSafety::standingIsProvenByBoth()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    const StopPlan plan = rig.device.stopPlan();
    const auto frames = rig.device.steering()->controlFrames({1, {0, 0, 0, 0}, {0}});
    const TimePoint stop = TimePoint() + 1h;
    const auto proof = [&](std::optional<milliseconds> state, float armed,
                           std::optional<milliseconds> outputs, float driven) {
        TelemetryStore store(int(bcflight::channels().size()));
        const auto armedGroup = store.defineGroup({Armed}, 0);
        const auto outputGroup = store.defineGroup({Outputs}, 0);
        if (state)
            store.append(*armedGroup, stop + *state, std::array{armed});
        if (outputs)
            store.append(*outputGroup, stop + *outputs, std::array{driven});
        const Proof byPlan = plan.fromTelemetry(store, stop);
        return byPlan == frames.stopped(store, stop) ? byPlan : Proof::Refuted;
    };
    QCOMPARE(proof(10ms, 0, 10ms, 0), Proof::Proven);
    // It does not stream them, or has had no time to.
    QCOMPARE(proof(700ms, 0, {}, 0), Proof::Proven);
    QCOMPARE(proof(10ms, 0, {}, 0), Proof::Nothing);
    QCOMPARE(proof(-10ms, 0, 10ms, 0), Proof::Nothing);
    QCOMPARE(proof(10ms, 0, -10ms, 0), Proof::Nothing);
    // It told them once, and does not any more: no reason to say for ever that motors may run.
    QCOMPARE(proof(700ms, 0, -10ms, 1), Proof::Proven);
    QCOMPARE(proof({}, 0, 10ms, 0), Proof::Nothing);
    QCOMPARE(proof(10ms, 1, 10ms, 0), Proof::Refuted);
    QCOMPARE(proof(10ms, 0, 10ms, 1), Proof::Refuted);
}

// Errata 9.2, 11: it is compiled, and no more.
void TestBcflightSafety::textIsNeverRun()
{
    const QTemporaryDir dir;
    const QString mark = dir.filePath(u"ran"_s);
    const QByteArray text = "local f = io.open(\"" + mark.toUtf8() + "\", \"w\") f:write(\"x\") f:close()\n";
    QVERIFY(checkSyntax(text));
    QVERIFY(!QFile::exists(mark));
    QVERIFY(checkSyntax("error(\"run\")\n"));
}

QTEST_GUILESS_MAIN(TestBcflightSafety)
#include "tst_bcflightsafety.moc"
