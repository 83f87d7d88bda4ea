// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated drone, line by line against the errata.
#include "protocol/base/checksum.h"
#include "protocol/bcflight/framer.h"
#include "protocol/simulator/bcflight/board.h"

#include <QTest>

#include <cmath>
#include <map>

using namespace Qt::StringLiterals;
using namespace bcflight;
using Drone = bcflight::SimulatedBoard;

namespace {

/// A drone, and a ground that sends packets to it.
class Rig
{
public:
    explicit Rig(Generation generation = Generation::G, const QMap<QString, int> &own = {})
        : m_generation(generation)
        , board(options(generation, own))
    {
    }

    /// Sends a packet, and everything that comes within the time.
    std::vector<Frame> ask(const QByteArray &packet, double seconds = 0.02)
    {
        if (!packet.isEmpty())
            board.receive(asBytes(packet));
        return wait(seconds);
    }
    std::vector<Frame> ask(Message id, const QByteArray &payload = {}, double seconds = 0.02)
    {
        return ask(encode(id, payload, m_generation), seconds);
    }
    std::vector<Frame> wait(double seconds)
    {
        std::vector<Frame> frames;
        bcflight::Framer framer;
        const FrameSink sink = [&frames](const FrameView &frame) { frames.emplace_back(frame); };
        for (const double end = board.now() + seconds; board.now() < end;) {
            board.cycle();
            for (QByteArray packet = board.takeOutput(65535); !packet.isEmpty();
                 packet = board.takeOutput(65535)) {
                framer.feed(asBytes(packet), sink);
                framer.packetEnded(sink);
                packets.append(packet);
            }
        }
        return frames;
    }
    static std::optional<QByteArray> reply(const std::vector<Frame> &frames, Message id)
    {
        for (const Frame &frame : frames) {
            if (frame.id == int(id))
                return frame.payload;
        }
        return {};
    }
    std::optional<QByteArray> answer(Message id, const QByteArray &payload = {}, double seconds = 0.02)
    {
        return reply(ask(id, payload, seconds), id);
    }
    void connect()
    {
        ask(Message::Ping, QByteArray(4, '\0'));
        wait(0.02);
    }
    void calibrate()
    {
        connect();
        ask(Message::Calibrate, bigU32(1) + bigF32(0), Drone::kFullCalibrationTime + 0.1);
    }
    /// Steers for a time, as a ground does: 100 times a second.
    void fly(const Controls &controls, double seconds)
    {
        for (const double end = board.now() + seconds; board.now() < end;)
            ask(Message::Controls, controls.encode(m_generation), 0.01);
    }

private:
    static SimulatorOptions options(Generation generation, QMap<QString, int> own)
    {
        SimulatorOptions made;
        own.insert(QLatin1String(Drone::kGeneration), int(generation));
        made.own = own;
        made.faults.shake = 0;
        return made;
    }

    Generation m_generation;

public:
    Drone board;
    QList<QByteArray> packets;
};

bool runs(const Drone &board)
{
    return std::any_of(board.outputs().begin(), board.outputs().end(),
                       [](double output) { return output > 0; });
}

double floatAt(const QByteArray &payload, int index)
{
    return decodeFields(*findMessage(Message::Gyro)->fromDrone, asBytes(payload))[std::size_t(index)].number;
}

}  // namespace

class TestBcflightBoard final : public QObject
{
    Q_OBJECT

private slots:
    void firstPacketIsThrownAway();
    void pingIsEchoed_data();
    void pingIsEchoed();
    void statusFollowsItsGeneration();
    void telemetryIsAnswered();
    void streamComesAsScheduled();
    void slimStreamIsSlim();
    void thrustIsGarbageAtFirst();
    void calibrationAnswersOnce();
    void calibrationIsRefusedWhileArmed();
    void armingHasNoCheckOfTheThrottle();
    void armedByTheEndOfCalibration();
    void armAndDisarmDoNothing();
    void silenceDoesNotDisarm_data();
    void silenceDoesNotDisarm();
    void resetMotorsAlwaysStops();
    void gainsAreTakenUpToOne();
    void outerGainsAreEchoedAndIgnored();
    void horizonIsLimited();
    void readingsCannotBeAskedFor();
    void unknownPayloadIsCarriedOut();
    void whatFollowsATextIsShifted();
    void configurationIsRead();
    void configurationRestartsIt();
    void brokenConfigurationEndsIt();
    void uploadGoesInPieces();
    void inconsistentUploadIsCarriedOut();
    void motorTestTakesItsTime();
    void motorTestIsDangerous();
    void escCalibrationTakesItsTime();
    void acknowledgementsAreEchoed();
    void transmitterIsThereOrNot();
    void camerasAreThereOrNot();
    void recordingsAreListed();
    void controllerHoldsTheStand();
    void sticksTurnIt();
    void batterySags();
    void clientThatClosesLeavesTheMotorsRunning();
    void clientThatPausesIsDroppedFromTheSecondOn();
    void commandInTwoPiecesIsLost();
    void anyAcknowledgementIsEchoed();
    void modeLevelsTheAttitude();
};

void TestBcflightBoard::firstPacketIsThrownAway()
{
    Rig rig;
    QVERIFY(rig.ask(Message::Status).empty());
    QVERIFY(!rig.answer(Message::Ping, QByteArray(4, '\0')));
    QVERIFY(rig.answer(Message::Status));
}

void TestBcflightBoard::pingIsEchoed_data()
{
    QTest::addColumn<int>("generation");
    QTest::addColumn<int>("size");
    QTest::newRow("A") << int(Generation::A) << 21;
    QTest::newRow("B") << int(Generation::B) << 21;
    QTest::newRow("C") << int(Generation::C) << 5;
    QTest::newRow("G") << int(Generation::G) << 5;
}

void TestBcflightBoard::pingIsEchoed()
{
    QFETCH(int, generation);
    QFETCH(int, size);
    Rig rig{Generation(generation)};
    rig.connect();
    rig.packets.clear();
    rig.ask(Message::Ping, QByteArray::fromHex("12340007"), 0.002);
    const bool isThere = std::any_of(rig.packets.begin(), rig.packets.end(), [&](const QByteArray &packet) {
        return packet.size() == size && packet.startsWith(QByteArray::fromHex("8112340007"));
    });
    QVERIFY(isThere);
}

void TestBcflightBoard::statusFollowsItsGeneration()
{
    Rig now;
    now.connect();
    QCOMPARE(now.answer(Message::Status), bigU32(0));
    Rig old{Generation::C};
    old.connect();
    QVERIFY(!old.answer(Message::Status));
    const auto frames = old.ask(Message::Telemetry);
    QVERIFY(Rig::reply(frames, Message::Telemetry));
    QCOMPARE(Rig::reply(frames, Message::Status), bigU32(0));
}

void TestBcflightBoard::telemetryIsAnswered()
{
    Rig rig;
    rig.connect();
    const auto payload = rig.answer(Message::Telemetry);
    QVERIFY(payload);
    const auto telemetry = Telemetry::decode(asBytes(*payload));
    QVERIFY(telemetry);
    QVERIFY(telemetry->voltage > 15 && telemetry->voltage < 17);
    QCOMPARE(telemetry->current, 0.0);
}

void TestBcflightBoard::streamComesAsScheduled()
{
    Rig rig;
    rig.connect();
    rig.wait(0.1);
    rig.packets.clear();
    rig.wait(1.0);
    QVERIFY(std::abs(rig.packets.size() - 100) <= 1);
    std::map<qsizetype, int> sizes;
    for (const QByteArray &packet : rig.packets)
        ++sizes[packet.size()];
    // Errata 8.1.
    QVERIFY(std::abs(sizes[102] - 80) <= 1);
    QVERIFY(std::abs(sizes[150] - 10) <= 1);
    QVERIFY(std::abs(sizes[178] - 10) <= 1);
}

void TestBcflightBoard::slimStreamIsSlim()
{
    Rig rig;
    rig.connect();
    rig.ask(Message::SetFullTelemetry, bigU32(0), 0.1);
    rig.packets.clear();
    rig.wait(1.0);
    QCOMPARE(rig.packets.size(), qsizetype(20));
    for (const QByteArray &packet : rig.packets)
        QVERIFY(packet.size() == 48 || packet.size() == 54);
}

void TestBcflightBoard::thrustIsGarbageAtFirst()
{
    Rig rig;
    rig.calibrate();
    const auto before = Rig::reply(rig.wait(0.1), Message::SetThrust);
    QVERIFY(before);
    QVERIFY(
        std::isnan(decodeFields(*findMessage(Message::SetThrust)->fromDrone, asBytes(*before))[0].number));
    rig.fly({0.25, 0, 0, 0, true}, 0.1);
    const auto after = Rig::reply(rig.wait(0.1), Message::SetThrust);
    QVERIFY(
        std::abs(decodeFields(*findMessage(Message::SetThrust)->fromDrone, asBytes(*after))[0].number - 0.25)
        < 0.01);
}

void TestBcflightBoard::calibrationAnswersOnce()
{
    Rig rig;
    rig.connect();
    const auto frames = rig.ask(Message::Calibrate, bigU32(0) + bigF32(0));
    QCOMPARE(Rig::reply(frames, Message::Calibrate), bigU32(3));
    QCOMPARE(Rig::reply(frames, Message::Calibrating), bigU32(1));
    QCOMPARE(rig.answer(Message::Status), bigU32(Status::kCalibrating));
    rig.wait(2.5);  // no offsets are stored, so it is a full one (7.1)
    QCOMPARE(rig.answer(Message::Status), bigU32(Status::kCalibrating));
    rig.wait(0.6);
    QCOMPARE(rig.answer(Message::Status), bigU32(Status::kCalibrated));
    rig.ask(Message::Calibrate, bigU32(0) + bigF32(0), 2.1);
    QCOMPARE(rig.answer(Message::Status), bigU32(Status::kCalibrated));
}

void TestBcflightBoard::calibrationIsRefusedWhileArmed()
{
    Rig rig;
    rig.calibrate();
    rig.fly({0.2, 0, 0, 0, true}, 0.1);
    const auto frames = rig.ask(Message::Calibrate, bigU32(1) + bigF32(0));
    QCOMPARE(Rig::reply(frames, Message::Calibrate), bigU32(0xFFFFFFFF));
    QCOMPARE(Rig::reply(frames, Message::Calibrating), bigU32(1));  // all the same
    QVERIFY(rig.board.isArmed());
}

void TestBcflightBoard::armingHasNoCheckOfTheThrottle()
{
    Rig rig;
    rig.connect();
    rig.fly({0.6, 0, 0, 0, true}, 0.1);
    QVERIFY(!rig.board.isArmed());
    rig.calibrate();
    rig.fly({0.6, 0, 0, 0, true}, 0.1);
    QVERIFY(rig.board.isArmed());
    QVERIFY(runs(rig.board));
    rig.fly({0.6, 0, 0, 0, false}, 0.05);
    QVERIFY(!rig.board.isArmed());
    QVERIFY(!runs(rig.board));
}

void TestBcflightBoard::armedByTheEndOfCalibration()
{
    Rig rig;
    rig.connect();
    rig.ask(Message::Calibrate, bigU32(1) + bigF32(0));
    rig.fly({0.3, 0, 0, 0, true}, 2.0);
    QVERIFY(!rig.board.isArmed());
    rig.fly({0.3, 0, 0, 0, true}, 1.5);
    QVERIFY(rig.board.isArmed());
}

void TestBcflightBoard::armAndDisarmDoNothing()
{
    Rig rig;
    rig.calibrate();
    rig.ask(Message::Arm);
    QVERIFY(!rig.board.isArmed());
    rig.fly({0.3, 0, 0, 0, true}, 0.1);
    rig.ask(Message::Disarm);
    QVERIFY(rig.board.isArmed());
}

void TestBcflightBoard::silenceDoesNotDisarm_data()
{
    QTest::addColumn<int>("generation");
    QTest::addColumn<bool>("disarms");
    QTest::newRow("A") << int(Generation::A) << false;
    QTest::newRow("D") << int(Generation::D) << true;
    QTest::newRow("E") << int(Generation::E) << true;
    QTest::newRow("F") << int(Generation::F) << false;
    QTest::newRow("G") << int(Generation::G) << false;
}

void TestBcflightBoard::silenceDoesNotDisarm()
{
    QFETCH(int, generation);
    QFETCH(bool, disarms);
    Rig rig{Generation(generation)};
    rig.calibrate();
    rig.fly({0.4, 0, 0, 0, true}, 0.2);
    QVERIFY(rig.board.isArmed());
    rig.wait(5);
    QCOMPARE(rig.board.isArmed(), !disarms);
    QCOMPARE(runs(rig.board), !disarms);
}

void TestBcflightBoard::resetMotorsAlwaysStops()
{
    Rig rig;
    rig.calibrate();
    rig.fly({0.5, 0, 0, 0, true}, 0.2);
    rig.ask(Message::ResetMotors, {}, 0.002);
    QVERIFY(!rig.board.isArmed());
    QVERIFY(!runs(rig.board));
}

void TestBcflightBoard::gainsAreTakenUpToOne()
{
    Rig rig;
    rig.connect();
    const auto shipped = rig.answer(Message::RollPidFactors);
    QVERIFY(shipped);
    QCOMPARE(float(floatAt(*shipped, 0)), float(rig.board.gains()[0][0]));
    QCOMPARE(rig.answer(Message::SetRollP, bigF32(0.5F)), bigF32(0.5F));
    QCOMPARE(rig.board.gains()[0][0], 0.5);
    QVERIFY(!rig.answer(Message::SetRollP, bigF32(1.5F)));
    QCOMPARE(rig.board.gains()[0][0], 0.5);
    QVERIFY(rig.answer(Message::SetRollP, bigF32(std::nanf(""))));  // taken and applied (7.2)
    QVERIFY(std::isnan(rig.board.gains()[0][0]));
    rig.ask(Message::SetYawD, bigF32(0.25F));
    QCOMPARE(floatAt(*rig.answer(Message::YawPidFactors), 2), 0.25);
}

void TestBcflightBoard::outerGainsAreEchoedAndIgnored()
{
    Rig rig;
    rig.connect();
    QCOMPARE(rig.answer(Message::SetOuterP, bigF32(20)), bigF32(20));
    QVERIFY(!rig.answer(Message::SetOuterP, bigF32(51)));
    QCOMPARE(rig.answer(Message::OuterPidFactors), QByteArray(12, '\0'));
}

void TestBcflightBoard::horizonIsLimited()
{
    Rig rig;
    rig.connect();
    const QByteArray offset = bigF32(1.5F) + bigF32(-2);
    QCOMPARE(rig.answer(Message::SetHorizonOffset, offset), offset);
    QVERIFY(!rig.answer(Message::SetHorizonOffset, bigF32(46) + bigF32(0)));
    QCOMPARE(rig.answer(Message::HorizonOffset), offset);
}

void TestBcflightBoard::readingsCannotBeAskedFor()
{
    Rig rig;
    rig.connect();
    rig.ask(Message::SetFullTelemetry, bigU32(0), 0.2);
    rig.packets.clear();
    rig.ask(QByteArray::fromHex("0018"), 0.1);
    for (const QByteArray &packet : rig.packets)
        QVERIFY(packet.size() == 48 || packet.size() == 54);
}

// The hazard that a client must never run into.
void TestBcflightBoard::unknownPayloadIsCarriedOut()
{
    Rig rig;
    rig.calibrate();
    const int before = rig.board.unknownMessages();
    rig.ask(QByteArray::fromHex("78ff")
            + encode(Message::Controls, (Controls{0.3, 0, 0, 0, true}).encode(Generation::G)));
    QVERIFY(rig.board.isArmed());
    QCOMPARE(rig.board.unknownMessages(), before + 1);
    // Too short: dropped, and nothing of it is steering.
    Rig shorter;
    shorter.calibrate();
    shorter.ask(QByteArray::fromHex("830001"));
    QVERIFY(!shorter.board.isArmed());
}

void TestBcflightBoard::whatFollowsATextIsShifted()
{
    Rig rig;
    rig.connect();
    const QByteArray wrong = encode(Message::SetConfigFile, bigU32(0) + "x" + '\0');  // refused by its CRC
    QVERIFY(Rig::reply(rig.ask(wrong + encode(Message::Status)),
                       Message::Status));  // zero and one byte: happens to work
    QVERIFY(!Rig::reply(rig.ask(wrong + encode(Message::HorizonOffset)), Message::HorizonOffset));
}

void TestBcflightBoard::configurationIsRead()
{
    Rig rig;
    rig.connect();
    const auto payload = rig.answer(Message::GetConfigFile);
    QVERIFY(payload);
    QCOMPARE(*decodeChecked(asBytes(*payload)), rig.board.configuration());
    Rig old{Generation::A};
    old.connect();
    QVERIFY(old.answer(Message::GetConfigFile));
}

void TestBcflightBoard::configurationRestartsIt()
{
    Rig rig;
    rig.calibrate();
    QByteArray other = rig.board.configuration();
    QVERIFY(other.contains("pid_roll = PID( "));
    other.replace("pid_roll = PID( ", "pid_roll = PID( 1");
    const double before = rig.board.gains()[0][0];
    QCOMPARE(rig.answer(Message::SetConfigFile, bigU32(1) + other + '\0'), bigU32(1));
    QVERIFY(rig.board.configuration() != other);
    rig.fly({0.3, 0, 0, 0, true}, 0.1);
    // Also while it flies (7.3).
    QCOMPARE(rig.answer(Message::SetConfigFile, encodeChecked(other), 0.01), bigU32(0));
    QVERIFY(rig.ask(Message::Status, {}, 3.0).empty());
    rig.wait(Drone::kRestartTime);
    rig.connect();
    QCOMPARE(rig.answer(Message::Status), bigU32(0));
    QCOMPARE(rig.board.configuration(), other);
    QVERIFY(rig.board.gains()[0][0] > before);
}

void TestBcflightBoard::brokenConfigurationEndsIt()
{
    Rig rig;
    rig.connect();
    rig.ask(Message::SetConfigFile, encodeChecked("pid_roll = PID( 1, 2"), 0.1);
    rig.wait(20);
    rig.connect();
    QVERIFY(!rig.answer(Message::Status));
    QVERIFY(rig.board.isLost());
}

void TestBcflightBoard::uploadGoesInPieces()
{
    Rig rig;
    rig.connect();
    const QByteArray image = QByteArray("firmware").repeated(300);
    rig.ask(Message::UploadInit);
    rig.packets.clear();
    rig.wait(0.2);
    QVERIFY(rig.packets.isEmpty());  // the stream pauses
    for (qsizetype at = 0; at < image.size(); at += 1024) {
        const QByteArray piece = image.sliced(at, std::min<qsizetype>(1024, image.size() - at));
        QCOMPARE(rig.answer(Message::UploadData, encodeChunk(std::uint32_t(at), piece)), bigU32(1));
    }
    rig.ask(Message::UploadProcess, bigU32(1), 0.1);
    QVERIFY(rig.answer(Message::Status));  // a wrong CRC is not told
    rig.ask(Message::UploadProcess, bigU32(crc32c(asBytes(image))), 0.1);
    QVERIFY(!rig.answer(Message::Status));
    QCOMPARE(rig.board.firmware(), image);
    rig.wait(Drone::kReplaceTime);
    rig.connect();
    QVERIFY(rig.answer(Message::GetBoardInfos)->contains("2.0"));
}

void TestBcflightBoard::inconsistentUploadIsCarriedOut()
{
    Rig rig;
    rig.calibrate();
    const QByteArray evil = encode(Message::Controls, (Controls{0.3, 0, 0, 0, true}).encode(Generation::G));
    QCOMPARE(rig.answer(Message::UploadData,
                        bigU32(crc32c(asBytes(evil))) + bigU32(0) + bigU32(0) + bigU32(7) + bigU32(8) + evil),
             bigU32(3));
    QVERIFY(rig.board.isArmed());
    Rig other;
    other.connect();
    QCOMPARE(
        other.answer(Message::UploadData, bigU32(0) + bigU32(0) + bigU32(0) + bigU32(2) + bigU32(2) + "xy"),
        bigU32(2));
    QCOMPARE(
        other.answer(Message::UploadData, bigU32(0) + bigU32(1) + bigU32(2) + bigU32(2) + bigU32(2) + "\0\0"),
        bigU32(4));
}

void TestBcflightBoard::motorTestTakesItsTime()
{
    Rig rig;
    rig.calibrate();
    rig.ask(Message::MotorTest, bigU32(2), 3.0);
    QCOMPARE(rig.board.outputs(), (std::vector<double>{0, 0, 0.05, 0}));
    QVERIFY(!rig.answer(Message::Status));
    rig.board.receive(asBytes(encode(Message::HorizonOffset)));
    rig.packets.clear();
    const auto later = rig.wait(6.0);
    QVERIFY(Rig::reply(later, Message::Status));  // what queued up, in a burst
    QVERIFY(Rig::reply(later, Message::HorizonOffset));
    QVERIFY(!runs(rig.board));
}

void TestBcflightBoard::motorTestIsDangerous()
{
    Rig uncalibrated;
    uncalibrated.connect();
    uncalibrated.ask(Message::MotorTest, bigU32(0), 20);
    QVERIFY(!uncalibrated.answer(Message::Status));
    QVERIFY(uncalibrated.board.isLost());
    Rig beyond;
    beyond.calibrate();
    beyond.ask(Message::MotorTest, bigU32(4), 1);
    QVERIFY(beyond.board.isLost());
}

void TestBcflightBoard::escCalibrationTakesItsTime()
{
    Rig rig;
    rig.connect();
    rig.ask(Message::CalibrateEscs, {}, 9);
    QVERIFY(!runs(rig.board));
    rig.wait(5);
    QCOMPARE(rig.board.outputs(), (std::vector<double>{1, 1, 1, 1}));
    QVERIFY(!rig.answer(Message::Status));
    rig.wait(13);
    QVERIFY(!runs(rig.board));
    QVERIFY(rig.answer(Message::Status));
}

void TestBcflightBoard::acknowledgementsAreEchoed()
{
    Rig rig;
    rig.connect();
    rig.packets.clear();
    rig.ask(encodeAck(5), 0.002);
    QVERIFY(rig.packets.contains(QByteArray::fromHex("06050605")));
    Rig old{Generation::D};
    old.connect();
    old.packets.clear();
    old.ask(encodeAck(5), 0.05);
    QVERIFY(!old.packets.contains(QByteArray::fromHex("06050605")));
}

void TestBcflightBoard::transmitterIsThereOrNot()
{
    Rig rig;
    rig.connect();
    QCOMPARE(rig.answer(Message::VtxGetSettings),
             QByteArray::fromHex("2516ae000e03") + QByteArray::fromHex("0e141a"));
    QCOMPARE(rig.answer(Message::VtxSetPower, QByteArray(1, 2)), QByteArray::fromHex("021a"));
    QCOMPARE(rig.answer(Message::VtxSetChannel, QByteArray(1, 1)), QByteArray::fromHex("0116e9"));
    Rig none{Generation::G, {{QLatin1String(Drone::kTransmitter), 0}}};
    none.connect();
    QCOMPARE(none.answer(Message::VtxGetSettings), QByteArray::fromHex("ffffffffff00"));
    QVERIFY(!none.answer(Message::VtxSetPower, QByteArray(1, 2)));
}

void TestBcflightBoard::camerasAreThereOrNot()
{
    Rig rig;
    rig.connect();
    QCOMPARE(rig.answer(Message::WhiteBalance), QByteArray("incandescent\0", 13));
    QVERIFY(rig.answer(Message::Iso));
    QVERIFY(!rig.answer(Message::BrightnessUp));
    Rig none{Generation::G, {{QLatin1String(Drone::kCamera), 0}}};
    none.connect();
    QCOMPARE(none.answer(Message::WhiteBalance), QByteArray("(none)\0", 7));
    QVERIFY(!none.answer(Message::Iso));
    QCOMPARE(none.answer(Message::GetCamerasInfos), QByteArray("nil\0", 4));
    // Built without video it tells of neither (6.2).
    QVERIFY(rig.answer(Message::GetSensorsInfos) && rig.answer(Message::GetCamerasInfos));
    Rig plain{Generation::G, {{QLatin1String(Drone::kVideoless), 1}}};
    plain.connect();
    QVERIFY(!plain.answer(Message::GetSensorsInfos));
    QVERIFY(!plain.answer(Message::GetCamerasInfos));
    QVERIFY(plain.answer(Message::GetBoardInfos));
    QVERIFY(!plain.board.cameraView());
}

void TestBcflightBoard::recordingsAreListed()
{
    Rig rig;
    rig.connect();
    QVERIFY(
        decodeChecked(asBytes(*rig.answer(Message::GetRecordingsList)))->contains("video_0.h264:734003:::;"));
    Rig none{Generation::G, {{QLatin1String(Drone::kCamera), 0}}};
    none.connect();
    QCOMPARE(*decodeChecked(asBytes(*none.answer(Message::GetRecordingsList))), QByteArray(";"));
}

// In its stand, tilted by hand: it comes level, and stays there.
void TestBcflightBoard::controllerHoldsTheStand()
{
    Rig rig;
    rig.calibrate();
    rig.board.quadcopter().setAttitude(25, -20, 0);
    rig.wait(4.0);  // its estimate follows gravity
    rig.fly({0.5, 0, 0, 0, true}, 4.0);
    const Vector3 attitude = rig.board.quadcopter().attitude();
    QVERIFY2(std::abs(attitude.x) < 4 && std::abs(attitude.y) < 4,
             qPrintable(u"%1 %2"_s.arg(attitude.x).arg(attitude.y)));
    double most = 0;
    for (int i = 0; i < 100; ++i) {
        rig.fly({0.5, 0, 0, 0, true}, 0.01);
        const Vector3 rates = rig.board.quadcopter().rates();
        most = std::max({most, std::abs(rates.x), std::abs(rates.y)});
    }
    QVERIFY2(most < 15, qPrintable(QString::number(most)));
}

void TestBcflightBoard::sticksTurnIt()
{
    Rig rig;
    rig.calibrate();
    rig.fly({0.5, 0, 0, 0, true}, 0.5);
    rig.fly({0.5, 0.5, 0, 0, true}, 2.0);
    QVERIFY2(std::abs(rig.board.quadcopter().attitude().x - 20) < 6,
             qPrintable(QString::number(rig.board.quadcopter().attitude().x)));
    rig.fly({0.5, 0, 0, 0.2, true}, 1.5);
    QVERIFY2(std::abs(rig.board.quadcopter().rates().z - 60) < 12,
             qPrintable(QString::number(rig.board.quadcopter().rates().z)));
}

void TestBcflightBoard::batterySags()
{
    Rig rig;
    rig.calibrate();
    const double before = rig.board.quadcopter().voltage();
    rig.fly({0.9, 0, 0, 0, true}, 1.0);
    QVERIFY(rig.board.quadcopter().voltage() < before - 0.3);
    rig.fly({0, 0, 0, 0, false}, 1.0);
    QVERIFY(rig.board.quadcopter().voltage() > before - 0.2);
    QVERIFY(rig.board.quadcopter().charge() > 0);
}

// Errata 9.1: closing TCP disarms in word only, and arm = 0 afterwards stops nothing.
void TestBcflightBoard::clientThatClosesLeavesTheMotorsRunning()
{
    Rig rig;
    rig.board.clientCame();
    rig.calibrate();
    rig.fly({.thrust = 0.3, .arm = true}, 0.3);
    QVERIFY(rig.board.isArmed() && runs(rig.board));
    rig.board.clientWent();
    rig.wait(1);
    QVERIFY(!rig.board.status().armed);
    QVERIFY(runs(rig.board));
    rig.board.clientCame();
    QVERIFY(!rig.answer(Message::Status));  // not connected before a PING
    rig.connect();
    rig.fly({.arm = false}, 0.2);
    QVERIFY(runs(rig.board));
    rig.ask(Message::ResetMotors);
    QVERIFY(!runs(rig.board));
}

// Errata 2.6: silence, and no end of the stream.
void TestBcflightBoard::clientThatPausesIsDroppedFromTheSecondOn()
{
    Rig rig;
    rig.board.clientCame();
    rig.connect();
    rig.wait(2 * Drone::kReadTimeout);
    QVERIFY(rig.answer(Message::Status));
    rig.board.clientWent();
    rig.board.clientCame();
    rig.connect();
    QVERIFY(rig.answer(Message::Status));
    rig.wait(2 * Drone::kReadTimeout);
    QVERIFY(!rig.answer(Message::Status));
    rig.board.clientWent();
    rig.board.clientCame();
    rig.connect();
    QVERIFY(rig.answer(Message::Status));
}

// Errata 2.6: what is split over two reads is lost, and its tail is parsed as commands.
void TestBcflightBoard::commandInTwoPiecesIsLost()
{
    Rig rig;
    rig.connect();
    const auto gain = [&rig] { return rig.board.gains()[0][0]; };
    const double before = gain();
    const QByteArray set = encode(Message::SetRollP, bigF32(0.5F));
    rig.ask(set.first(4));
    rig.ask(set.sliced(4));
    QCOMPARE(gain(), before);
    rig.ask(set);
    QCOMPARE(gain(), 0.5);
}

// Errata 5: it only looks for two bits.
void TestBcflightBoard::anyAcknowledgementIsEchoed()
{
    Rig rig;
    rig.connect();
    rig.packets.clear();
    rig.ask(QByteArray::fromHex("0605"));
    QVERIFY(rig.packets.contains(QByteArray::fromHex("06050605")));
    rig.ask(QByteArray::fromHex("7f01"));
    QVERIFY(rig.packets.contains(QByteArray::fromHex("7f017f01")));
}

// Errata 6.4: SET_MODE 1 resets the attitude estimate, whatever the drone does.
void TestBcflightBoard::modeLevelsTheAttitude()
{
    Rig rig;
    rig.calibrate();
    rig.fly({.thrust = 0.3, .roll = 0.5, .arm = true}, 1.0);
    const auto roll = [&rig] { return floatAt(*Rig::reply(rig.wait(0.03), Message::RollPitchYaw), 0); };
    QVERIFY(std::abs(roll()) > 5);
    QCOMPARE(rig.answer(Message::SetMode, bigU32(1)), std::optional(bigU32(1)));
    QVERIFY(std::abs(roll()) < 3);
}

QTEST_GUILESS_MAIN(TestBcflightBoard)
#include "tst_bcflightboard.moc"
