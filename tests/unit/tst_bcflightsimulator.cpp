// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated drone against the errata line by line: packets in, packets out.
#include "protocol/base/checksum.h"
#include "protocol/bcflight/framer.h"
#include "protocol/simulator/bcflight/board.h"

#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace bcflight;
using Drone = bcflight::SimulatedBoard;
using Own = QMap<QString, int>;

namespace {

enum class State { Fresh, Connected, Calibrated, Armed };

constexpr double kMoment = 0.05;
constexpr std::uint32_t kFarOffset = 4194304;

/// A drone whose packets are kept as they come.
struct Ground
{
    explicit Ground(State state = State::Connected, Generation spoken = Generation::G, const Own &own = {},
                    const Faults &faults = {})
        : generation(spoken)
        , drone(optionsOf(spoken, own, faults))
    {
        if (state == State::Fresh)
            return;
        connect();
        if (state == State::Connected)
            return;
        send(encode(Message::Calibrate, bigU32(1) + bigF32(0), generation));
        wait(Drone::kFullCalibrationTime + 0.1);
        if (state == State::Armed)
            send(controls({.thrust = 0.3, .arm = true}));
    }
    static SimulatorOptions optionsOf(Generation spoken, Own own, const Faults &faults)
    {
        SimulatorOptions options;
        own.insert(QLatin1String(Drone::kGeneration), int(spoken));
        options.own = own;
        options.faults = faults;
        options.faults.shake = 0;
        return options;
    }
    [[nodiscard]] QByteArray controls(const Controls &wanted) const
    {
        return encode(Message::Controls, wanted.encode(generation), generation);
    }
    void connect() { send(encode(Message::Ping, QByteArray(4, '\0'), generation)); }
    /// Sends a packet, and returns what comes in the time after it.
    QList<QByteArray> send(const QByteArray &packet, double seconds = kMoment)
    {
        drone.receive(asBytes(packet));
        return wait(seconds);
    }
    QList<QByteArray> sendHex(const char *packet, double seconds = kMoment)
    {
        return send(QByteArray::fromHex(packet), seconds);
    }
    QList<QByteArray> wait(double seconds)
    {
        QList<QByteArray> packets;
        for (const double end = drone.now() + seconds; drone.now() < end;) {
            drone.cycle();
            for (QByteArray packet = drone.takeOutput(65535); !packet.isEmpty();
                 packet = drone.takeOutput(65535))
                packets.append(packet);
        }
        return packets;
    }
    /// From now on nothing comes but answers (7.4).
    void silenceStream()
    {
        send(encode(Message::UploadInit, {}, generation));
        wait(kMoment);
    }
    /// When the status becomes so, in seconds from now; it is asked in each cycle. -1: not within the time.
    double until(std::uint32_t status, double seconds)
    {
        const double begin = drone.now();
        while (drone.now() < begin + seconds) {
            drone.receive(asBytes(QByteArray::fromHex("85")));
            drone.cycle();
            for (QByteArray packet = drone.takeOutput(65535); !packet.isEmpty();
                 packet = drone.takeOutput(65535)) {
                if (packet == char(0x85) + bigU32(status))
                    return drone.now() - begin;
            }
        }
        return -1;
    }
    [[nodiscard]] bool runs() const
    {
        return std::any_of(drone.outputs().begin(), drone.outputs().end(),
                           [](double output) { return output > 0; });
    }
    /// Steps until the outputs are these, in seconds from now; -1: not within the time.
    double untilOutputs(const std::vector<double> &outputs, double seconds)
    {
        const double begin = drone.now();
        while (drone.now() < begin + seconds) {
            drone.cycle();
            if (drone.outputs() == outputs)
                return drone.now() - begin;
        }
        return -1;
    }

    Generation generation;
    Drone drone;
};

QList<int> idsIn(const QByteArray &packet)
{
    QList<int> ids;
    bcflight::Framer framer;
    const FrameSink sink = [&ids](const FrameView &frame) { ids.append(frame.id); };
    framer.feed(asBytes(packet), sink);
    framer.packetEnded(sink);
    return ids;
}

QByteArray textOf(const QByteArray &packet)
{
    return packet.sliced(2, packet.size() - 3);
}

bool isNear(double value, double wanted)
{
    return std::abs(value - wanted) < 0.02;
}

QString hexOf(const QList<QByteArray> &packets)
{
    QStringList texts;
    for (const QByteArray &packet : packets)
        texts.append(QString::fromLatin1(packet.toHex()));
    return texts.join(u'|');
}

const Own kNoCamera{{QLatin1String(Drone::kCamera), 0}};
const Own kNoTransmitter{{QLatin1String(Drone::kTransmitter), 0}};

}  // namespace

class TestBcflightSimulator final : public QObject
{
    Q_OBJECT
private slots:
    void answers_data();
    void answers();
    void readingsAreNotAnswered_data();
    void readingsAreNotAnswered();
    void silentCommandsAreSilent_data();
    void silentCommandsAreSilent();

    void connectingPauses();
    void telemetryIsWhatIsMeasured();
    void currentIsNotMeasured();
    void steersAsItsGenerationDoes();
    void sticksAreTakenFromTheirBits();
    void setpointsAreNotGatedByArming();
    void retriesSwitchNothing();
    void sensitivityStepsByHundreds();
    void armsAgainAtOnceAfterATimeout();
    void armingAgainStopsWhatAClosedClientLeft();
    void outOfReachItFliesOn();

    void calibrationTakesItsTime_data();
    void calibrationTakesItsTime();
    void nothingIsSetBetweenCalibratingAndCalibrated();
    void nothingIsRefusedInTheAir_data();
    void nothingIsRefusedInTheAir();
    void busyDroneIgnoresWhatIsDangerousInTheAir_data();
    void busyDroneIgnoresWhatIsDangerousInTheAir();
    void motorTestHasItsPhases();
    void controllersHaveTheirPhases();
    void queueIsCarriedOutInItsOrder();

    void restartsTakeTheirTime_data();
    void restartsTakeTheirTime();
    void longTextGoesInTwoDatagrams();
    void textEndsAtItsZero();
    void userNameStandsInTheText();
    void offsetsAndTelemetryAreForgotten();
    void firstPieceEmptiesWhatWasReceived();
    void limitsOfPieces_data();
    void limitsOfPieces();

    void streamHasItsOrder_data();
    void streamHasItsOrder();
    void streamHasItsRate_data();
    void streamHasItsRate();
    void attitudeIsNothingBeforeACalibration();
    void spectrumHasItsBins();
    void streamGoesOnWhileItIsDeaf();
    void textsHaveTheirForms();
};

// A row: packets as hex, separated by '|'.
void TestBcflightSimulator::answers_data()
{
    QTest::addColumn<int>("state");
    QTest::addColumn<QByteArray>("in");
    QTest::addColumn<QString>("out");
    QTest::addColumn<int>("generation");
    QTest::addColumn<Own>("own");
    const auto row = [](const char *name, State state, const char *in, const char *out,
                        Generation generation = Generation::G, const Own &own = {}) {
        QTest::newRow(name) << int(state) << QByteArray::fromHex(in) << QString::fromLatin1(out).remove(u' ')
                            << int(generation) << own;
    };
    using enum State;
    // clang-format off
    row("2.2 one byte of id", Connected, "a3", "a3 00000001");
    row("2.2 two bytes of it", Connected, "00a3", "a3 00000001");
    row("2.2 STATUS as two bytes", Connected, "0085", "85 00000000");
    row("2.2 PING as two bytes", Connected, "0081 0102 0304", "81 0102 0304");
    row("2.2 TELEMETRY and others in one", Connected, "0085 bb 00bc", "85 00000000|bb 00000000|bc 000000c8");
    row("2.4 each reply is its own packet", Connected, "85 a0 0027 a1", "85 00000000|a0 00000001|0027 00000000 00000000|a1 00000000");
    row("2.4 CALIBRATE replies in one", Connected, "0060 00000001 00000000", "0060 00000003 0061 00000001");
    row("2.5 unknown id, two bytes", Connected, "78ff 85", "85 00000000");
    row("2.5 unknown id, one byte", Connected, "90 85", "85 00000000");
    row("2.5 payload of an unknown id is read", Connected, "1234 a4 00a0", "a4 00000000|a0 00000001");
    row("2.5 short payload is dropped and read on", Connected, "0050 85", "85 00000000");
    row("2.5 short CONTROLS are dropped", Calibrated, "83 85", "85 00000002");
    row("2.5 half an id", Connected, "85 00", "85 00000000");
    row("2.5 zero and one-byte id behind a text", Connected, "0071 00000000 7800 85", "0071 00000001|85 00000000");
    row("2.5 zero and two-byte id behind a text", Connected, "0071 00000000 7800 0027", "0071 00000001");
    row("2.5 zeros are padding", Connected, "0000 0000 85 0000 a0", "85 00000000|a0 00000001");
    row("3 nothing before a PING", Fresh, "85", "");
    row("3 a PING anywhere connects, and is thrown away", Fresh, "0050 8100 0000", "");
    row("3 PING with one word", Connected, "81 1234", "81 1234 0000");
    row("3 PING with less", Connected, "81 12", "");
    row("4.1 at rest", Connected, "85", "85 00000000");
    row("4.1 calibrated", Calibrated, "85", "85 00000002");
    row("4.1 armed", Armed, "85", "85 00000003");
    row("4.3 CONTROLS have no reply", Calibrated, "83 ff01 0000 0000 85", "85 00000002");
    row("4.3 arm is bit 40", Calibrated, "83 0000 0000 0001 85", "85 00000003");
    row("4.3 the other flags arm nothing", Calibrated, "83 0000 0000 00fe 85", "85 00000002");
    row("4.3 arm is a level", Armed, "83 0000 0000 0000 85", "85 00000002");
    row("5 the word twice", Connected, "0605", "06050605");
    row("5 before another command", Connected, "0607 a1", "06070607|a1 00000000");
    row("5 not before E", Connected, "0605", "", Generation::D);
    row("5 two bits are enough", Connected, "7f02", "7f027f02");
    row("6.1 CONNECT is dead", Connected, "84 85", "85 00000000");
    row("6.2 CALIBRATING is not handled", Connected, "0061 85", "85 00000000");
    row("6.2 SET_TIMESTAMP replies", Connected, "0062 5f5e1000", "0062 00000000");
    row("6.2 GET_USERNAME", Connected, "3001", "3001 73696d756c6174656400");
    row("6.2 its older id", Connected, "1001", "1001 73696d756c6174656400", Generation::E);
    row("6.2 each only in its generation", Connected, "1001 a1", "a1 00000000");
    row("6.3 PID_OUTPUT", Connected, "0021", "0021 00000000 00000000 00000000");
    row("6.3 OUTER_PID_OUTPUT", Connected, "0022", "0022 00000000 00000000 00000000");
    row("6.3 OUTER_PID_FACTORS", Connected, "0026", "0026 00000000 00000000 00000000");
    row("6.3 HORIZON_OFFSET", Connected, "0027", "0027 00000000 00000000");
    row("6.4 SET_MODE echoes any value", Connected, "0048 00000007", "0048 00000007");
    row("6.4 SET_ALTITUDE_HOLD without an altimeter", Connected, "0049 00000001", "0049 00000000");
    row("6.4 SET_HORIZON_OFFSET up to 45", Connected, "005c 42340000 c2340000", "005c 42340000 c2340000");
    row("6.4 and not beyond", Connected, "005c 00000000 42340001", "");
    row("6.5 VIDEO_PAUSE, RESUME", Connected, "00a0 00a1", "a0 00000001|a1 00000000");
    row("6.5 VIDEO_START, STOP_RECORD", Connected, "00a3 00a4", "a3 00000001|a4 00000000");
    row("6.5 the same without a camera", Connected, "00a3 00a4", "a3 00000001|a4 00000000", Generation::G, kNoCamera);
    row("6.5 VIDEO_NIGHT_MODE echoes", Connected, "00a5 00000001", "a5 00000001");
    row("6.5 ISO, SHUTTER_SPEED without a camera", Connected, "00bb 00bc 85", "85 00000000", Generation::G, kNoCamera);
    row("6.5 white balance goes on", Connected, "00c1 00c1 00c1 00c1 00c1",
        "c1 696e63616e64657363656e7400|c1 666c756f72657363656e7400|c1 6461796c6967687400|c1 636c6f75647900|c1 6175746f00");
    row("6.5 white balance without a camera", Connected, "00c1", "c1 286e6f6e652900", Generation::G, kNoCamera);
    row("6.5 exposure mode is empty today", Connected, "00c2", "c2 00");
    row("6.5 locked white balance", Connected, "00c3", "c3 52312e353042322e323500");
    row("6.5 lens shader has nine bytes", Connected, "00c5", "c5 2a2a2a2a2a2a2a2a2a");
    row("6.5 setting it has no reply", Connected, "00c6 0102030405060708 09 85", "85 00000000");
    row("6.5 unassigned", Connected, "00b1 00c4 00d1 85", "85 00000000");
    row("6.6 MOTORS_BEEP takes two bytes", Connected, "00e1 0001 85", "85 00000000");
    row("6.6 MOTORS_BEEP is not known before D", Connected, "00e1 81 0001 0002", "81 0001 0002", Generation::C);
    row("6.6 VTX_GET_SETTINGS", Connected, "2001", "2001 25 16ae 00 0e 03 0e141a");
    row("6.6 VTX_SET_POWER", Connected, "2002 01 2001", "2002 01 14|2001 25 16ae 01 14 03 0e141a");
    row("6.6 VTX_SET_CHANNEL", Connected, "2003 28 2001", "2003 28 171d|2001 28 171d 00 0e 03 0e141a");
    row("6.6 no transmitter", Connected, "2001", "2001 ff ffff ff ff 00", Generation::G, kNoTransmitter);
    row("6.6 its byte is not taken then", Connected, "2002 85", "85 00000000", Generation::G, kNoTransmitter);
    row("6.6 nor that of the channel", Connected, "2003 a0", "a0 00000001", Generation::G, kNoTransmitter);
    row("6.6 VTX is not known before E", Connected, "2001", "", Generation::D);
    row("7.1 refused while armed, and CALIBRATING all the same", Armed, "0060 00000001 00000000", "0060 ffffffff 0061 00000001");
    row("7.1 as the original sends it", Connected, "0000 0060 01000000 00000000", "0060 00000003 0061 00000001");
    row("7.2 a gain of 1", Connected, "0050 3f800000", "0050 3f800000");
    row("7.2 just above", Connected, "0050 3f800001", "");
    row("7.2 a negative one", Connected, "0058 bf800000 0025", "0058 bf800000|0025 3b3cea2c 3ba02854 bf800000");
    row("7.2 just below", Connected, "0057 bf800001", "");
    row("7.2 no number", Connected, "0053 7fc00000", "0053 7fc00000");
    row("7.2 outer gains up to 50, not applied", Connected, "0059 42480000 0026", "0059 42480000|0026 00000000 00000000 00000000");
    row("7.2 and not beyond", Connected, "005b 42480001", "");
    row("7.3 wrong checksum", Connected, "0071 00000000 6100", "0071 00000001");
    row("7.3 cut off at the end of a segment", Connected, "0071 00000000 6162", "0071 00000001");
    row("7.4 wrong checksum of a piece, which is taken", Connected, "0073 00000000 00000000 00000000 00000002 00000002 a0a1 85", "0073 00000002|85 00000000");
    row("7.4 sizes that differ, and the piece is read", Connected, "0073 00000000 00000000 00000000 00000002 00000003 a0a1", "0073 00000003|a0 00000001|a1 00000000");
    row("7.4 offsets that differ, and the piece is read", Connected, "0073 00000000 00000000 00000001 00000002 00000002 a0a1", "0073 00000004|a0 00000001|a1 00000000");
    row("7.4 wrong checksum of all", Connected, "0074 00000001 85", "85 00000000");
    row("7.6 no recordings", Connected, "00d0", "d0 fb17b1db 3b00", Generation::G, kNoCamera);
    row("13 PING", Connected, "81 1234 0007", "81 1234 0007");
    row("13 full thrust, disarmed", Calibrated, "83 ff 01 00 00 00 00 85", "85 00000002");
    row("13 SET_ROLL_PID_P", Connected, "0050 3f000000", "0050 3f000000");
    row("13 calibration", Connected, "0060 00000001 00000000", "0060 00000003 0061 00000001");
    // clang-format on
}

void TestBcflightSimulator::answers()
{
    QFETCH(int, state);
    QFETCH(QByteArray, in);
    QFETCH(QString, out);
    QFETCH(int, generation);
    QFETCH(Own, own);
    Ground ground(State(state), Generation(generation), own);
    if (State(state) != State::Fresh)
        ground.silenceStream();
    QList<QByteArray> packets = ground.send(in);
    packets.removeIf([](const QByteArray &packet) { return packet.size() >= 102; });  // the stream begins
    QCOMPARE(hexOf(packets), out);
    // The answer of a drone that is new proves that it was only not connected.
    if (State(state) == State::Fresh)
        QCOMPARE(ground.drone.status().bits(), 0U);
}

void TestBcflightSimulator::readingsAreNotAnswered_data()
{
    QTest::addColumn<int>("id");
    for (int id = 0x10; id <= 0x20; ++id)
        QTest::addRow("6.3 %04x", id) << id;
    for (int id = 0x30; id <= 0x39; ++id)
        QTest::addRow("6.3 %04x", id) << id;
}

void TestBcflightSimulator::readingsAreNotAnswered()
{
    QFETCH(int, id);
    Ground ground;
    ground.silenceStream();
    QCOMPARE(hexOf(ground.send(bigU16(std::uint16_t(id)) + '\x85')), u"8500000000"_s);
}

void TestBcflightSimulator::silentCommandsAreSilent_data()
{
    QTest::addColumn<QByteArray>("packet");
    const auto row
        = [](const char *name, const char *packet) { QTest::newRow(name) << QByteArray::fromHex(packet); };
    row("6.2 ARM", "0063");
    row("6.2 DISARM", "0064");
    row("6.2 RESET_BATTERY", "0065 00000000");
    row("6.2 SET_FULL_TELEMETRY", "0067 00000001");
    row("6.2 UPDATE_UPLOAD_INIT", "0072");
    row("6.2 ENABLE_TUN_DEVICE", "0075");
    row("6.2 DISABLE_TUN_DEVICE", "0076");
    row("6.4 SET_ROLL", "0040 3f000000");
    row("6.4 SET_PITCH", "0041 3f000000");
    row("6.4 SET_YAW", "0042 3f000000");
    row("6.4 SET_THRUST", "0043 3f000000");
    row("6.4 RESET_MOTORS", "0047");
    row("6.5 VIDEO_TAKE_PICTURE", "00a2");
    for (const char *step : {"00b0", "00b2", "00b3", "00b4", "00b5", "00b6", "00b7", "00b8", "00b9", "00ba"})
        row(qPrintable(u"6.5 "_s + QLatin1String(step)), step);
    row("6.6 MOTORS_BEEP", "00e1 0001");
}

void TestBcflightSimulator::silentCommandsAreSilent()
{
    QFETCH(QByteArray, packet);
    Ground ground;
    ground.silenceStream();
    // Its payload is taken whole, so that what follows is read as what it is.
    QCOMPARE(hexOf(ground.send(packet + '\x85')), u"8500000000"_s);
    QCOMPARE(ground.drone.unknownMessages(), 0);
}

// Errata 3: about 10 ms.
void TestBcflightSimulator::connectingPauses()
{
    Ground ground(State::Fresh);
    ground.drone.receive(asBytes(QByteArray::fromHex("8100000000")));
    ground.drone.receive(asBytes(QByteArray::fromHex("85")));
    QVERIFY(!ground.wait(0.009).contains(QByteArray::fromHex("8500000000")));
    QVERIFY(ground.wait(0.005).contains(QByteArray::fromHex("8500000000")));
}

// Errata 4.2.
void TestBcflightSimulator::telemetryIsWhatIsMeasured()
{
    Faults faults;
    faults.battery = 11.0;
    faults.heat = 61;
    Ground ground(State::Connected, Generation::G, {}, faults);
    ground.silenceStream();
    // 1100 little-endian, the charge of an earlier flight, no current, a level below zero, load, temperature,
    // quality, -48 dBm.
    const QList<QByteArray> told = ground.sendHex("82");
    QCOMPARE(told.size(), 1);
    QCOMPARE(told.front().first(6).toHex(), QByteArray("824c049c0100"));
    QVERIFY(qint8(told.front()[6]) < 0);
    QCOMPARE(told.front().sliced(7).toHex(), QByteArray("1f3d64d0"));
    Ground old(State::Connected, Generation::D);
    old.silenceStream();
    const QList<QByteArray> together = old.sendHex("82");
    QCOMPARE(together.size(), 1);
    QCOMPARE(together.front().size(), 11 + 5);
    QCOMPARE(together.front().sliced(11).toHex(), QByteArray("8000000000"));
}

void TestBcflightSimulator::currentIsNotMeasured()
{
    Ground ground(State::Armed);
    for (int i = 0; i < 200; ++i)
        ground.send(ground.controls({.thrust = 0.9, .arm = true}), 0.01);
    QVERIFY(ground.drone.quadcopter().charge() > 1);
    ground.silenceStream();
    QCOMPARE(ground.sendHex("82").front().sliced(3, 3).toHex(), QByteArray("9c0100"));
    ground.sendHex("0065 00000000");
    QCOMPARE(ground.sendHex("82").front().sliced(3, 3).toHex(), QByteArray("000000"));
}

// Errata 4.3: five bytes up to generation C.
void TestBcflightSimulator::steersAsItsGenerationDoes()
{
    Ground old(State::Calibrated, Generation::C);
    old.sendHex("83 40 00 00 00 01");
    QVERIFY(old.drone.isArmed());
    QVERIFY(old.runs());
    Ground now(State::Calibrated);
    now.sendHex("83 40 00 00 00 01");
    QVERIFY(!now.drone.isArmed());
}

void TestBcflightSimulator::sticksAreTakenFromTheirBits()
{
    Ground ground(State::Armed);
    const auto streamed = [&ground](const char *packet) {
        ground.sendHex(packet);
        for (const QByteArray &each : ground.sendHex(packet)) {
            if (const qsizetype at = each.indexOf(QByteArray::fromHex("0043")); at >= 0)
                return each.mid(at, 6).toHex();
        }
        return QByteArray();
    };
    QCOMPARE(streamed("83 ff 01 00 00 00 01"), QByteArray("00433f800000"));  // 511
    QCOMPARE(streamed("83 00 00 00 00 00 01"), QByteArray("004300000000"));
    // Roll is the ten bits behind, and negative where their first is set: it turns the other way.
    const auto turn = [](const char *packet) {
        Ground other(State::Armed);
        for (int i = 0; i < 30; ++i)
            other.sendHex(packet, 0.01);
        return other.drone.quadcopter().rates();
    };
    QVERIFY(turn("83 00 fd 07 00 00 01").x > 20);  // thrust 256, roll 511
    QVERIFY(turn("83 00 05 08 00 00 01").x < -20);  // roll -511
    QVERIFY(turn("83 00 01 f0 1f 00 01").y > 20);  // pitch 511
}

// Errata 6.4: SET_THRUST and the like act whatever its state is, and CONTROLS overwrite them.
void TestBcflightSimulator::setpointsAreNotGatedByArming()
{
    Ground ground(State::Armed);
    ground.sendHex("0043 00000000");
    QVERIFY(ground.drone.isArmed());
    QVERIFY(!ground.runs());
    ground.sendHex("0043 3e800000");
    QVERIFY(ground.runs());
    ground.send(ground.controls({.thrust = 0, .arm = true}));
    QVERIFY(!ground.runs());
}

// Errata 5: the same number again marks a retry, and commands that switch then only tell.
void TestBcflightSimulator::retriesSwitchNothing()
{
    Ground ground;
    ground.silenceStream();
    const QString first = u"c1696e63616e64657363656e7400"_s;
    QCOMPARE(hexOf(ground.sendHex("0605 00c1")), u"06050605|"_s + first);
    QCOMPARE(hexOf(ground.sendHex("0605 00c1")), u"06050605|"_s + first);
    QCOMPARE(hexOf(ground.sendHex("0606 00c1")), u"06060606|c1666c756f72657363656e7400"_s);
    // The mark stands directly in front, in the same packet.
    QCOMPARE(hexOf(ground.sendHex("0606")), u"06060606"_s);
    QCOMPARE(hexOf(ground.sendHex("00c1")), u"c16461796c6967687400"_s);
    // Its last number starts at 0.
    Ground other;
    other.silenceStream();
    QCOMPARE(hexOf(other.sendHex("0600 00c1")), u"06000600|c16175746f00"_s);
}

// Errata 6.5.
void TestBcflightSimulator::sensitivityStepsByHundreds()
{
    Ground ground;
    ground.silenceStream();
    QCOMPARE(hexOf(ground.sendHex("00b8 00bb")), u"bb00000000"_s);  // 0 is automatic
    QCOMPARE(hexOf(ground.sendHex("00b7 00b7 00bb")), u"bb000000c8"_s);
    QCOMPARE(hexOf(ground.sendHex("00b8 00bb")), u"bb00000064"_s);
    QCOMPARE(hexOf(ground.sendHex("00b9 00b9 00ba 00bc")), u"bc000000c8"_s);  // no effect today
}

// Errata 9.1, of the generations that notice silence.
void TestBcflightSimulator::armsAgainAtOnceAfterATimeout()
{
    Ground ground(State::Armed, Generation::E);
    QVERIFY(ground.drone.isArmed());
    ground.wait(1);
    QVERIFY(!ground.drone.isArmed() && !ground.runs());
    ground.send(ground.controls({.thrust = 0.6, .arm = true}));
    QVERIFY(ground.drone.isArmed() && ground.runs());
}

void TestBcflightSimulator::armingAgainStopsWhatAClosedClientLeft()
{
    Ground ground(State::Fresh);
    ground.drone.clientCame();
    ground.connect();
    ground.sendHex("0060 00000001 00000000", 3.1);
    ground.drone.receive(asBytes(QByteArray::fromHex("81 0000 0000")));
    ground.send(ground.controls({.thrust = 0.3, .arm = true}));
    QVERIFY(ground.runs());
    ground.drone.clientWent();
    ground.wait(1);
    QVERIFY(!ground.drone.isArmed() && ground.runs());
    ground.drone.clientCame();
    ground.connect();
    ground.send(ground.controls({}));
    QVERIFY(ground.runs());
    ground.send(ground.controls({.arm = true}));
    ground.send(ground.controls({}));
    QVERIFY(!ground.runs());
}

void TestBcflightSimulator::calibrationTakesItsTime_data()
{
    QTest::addColumn<bool>("full");
    QTest::addColumn<double>("seconds");
    QTest::newRow("7.1 gyroscope") << false << 2.0;
    QTest::newRow("7.1 all") << true << 3.0;
}

void TestBcflightSimulator::calibrationTakesItsTime()
{
    QFETCH(bool, full);
    QFETCH(double, seconds);
    Ground ground(State::Calibrated);
    ground.drone.receive(asBytes(encode(Message::Calibrate, bigU32(full ? 1 : 0) + bigF32(0))));
    ground.wait(0.01);
    QCOMPARE(ground.drone.status().bits(), std::uint32_t(Status::kCalibrating));
    const double took = 0.01 + ground.until(Status::kCalibrated, 10);
    QVERIFY2(isNear(took, seconds), qPrintable(QString::number(took)));
}

// Errata 7.1: for one loop.
void TestBcflightSimulator::nothingIsSetBetweenCalibratingAndCalibrated()
{
    Ground ground;
    ground.sendHex("0060 00000001 00000000", 0.01);
    QList<std::uint32_t> seen;
    for (int i = 0; i < 5000 && !ground.drone.status().calibrated; ++i) {
        ground.drone.cycle();
        if (seen.isEmpty() || seen.last() != ground.drone.status().bits())
            seen.append(ground.drone.status().bits());
    }
    QCOMPARE(seen, (QList<std::uint32_t>{Status::kCalibrating, 0, Status::kCalibrated}));
}

void TestBcflightSimulator::nothingIsRefusedInTheAir_data()
{
    QTest::addColumn<QString>("what");
    for (const char *what : {"text", "firmware", "mode", "gain", "offset"})
        QTest::addRow("9.1 %s", what) << QString::fromLatin1(what);
}

// Whoever sends it has to know better.
void TestBcflightSimulator::nothingIsRefusedInTheAir()
{
    QFETCH(QString, what);
    Ground ground(State::Armed);
    QVERIFY(ground.drone.isArmed());
    const QByteArray text = ground.drone.configuration() + "-- in the air\n";
    const QByteArray image("firmware");
    if (what == u"text"_s) {
        ground.send(encode(Message::SetConfigFile, encodeChecked(text)));
        QCOMPARE(ground.drone.configuration(), text);
        QVERIFY(!ground.drone.isArmed() && !ground.runs());  // it restarts
    } else if (what == u"firmware"_s) {
        ground.send(encode(Message::UploadData, encodeChunk(0, image)));
        ground.send(encode(Message::UploadProcess, bigU32(crc32c(asBytes(image)))));
        QCOMPARE(ground.drone.firmware(), image);
        QVERIFY(!ground.drone.isArmed());
    } else {
        const char *packet = what == u"mode"_s ? "0048 00000000"
            : what == u"gain"_s                ? "0050 3a83126f"
                                               : "005c 3f800000 00000000";
        QVERIFY(ground.sendHex(packet).contains(QByteArray::fromHex(packet)));
        QVERIFY(ground.drone.isArmed());
    }
}

void TestBcflightSimulator::busyDroneIgnoresWhatIsDangerousInTheAir_data()
{
    QTest::addColumn<QByteArray>("packet");
    QTest::newRow("9.1 MOTOR_TEST") << QByteArray::fromHex("00e0 00000001");
    QTest::newRow("9.1 MOTOR_TEST with no such motor") << QByteArray::fromHex("00e0 00000009");
    QTest::newRow("9.1 CALIBRATE_ESCS") << QByteArray::fromHex("0066");
    QTest::newRow("9.1 MOTORS_BEEP") << QByteArray::fromHex("00e1 0001");
}

void TestBcflightSimulator::busyDroneIgnoresWhatIsDangerousInTheAir()
{
    QFETCH(QByteArray, packet);
    Ground ground(State::Armed);
    ground.silenceStream();
    QCOMPARE(hexOf(ground.send(packet + '\x85')), u"8500000003"_s);  // at once, and still armed
    ground.wait(3);
    QVERIFY(ground.drone.isArmed() && ground.runs());
    QVERIFY(!ground.drone.isLost() && !ground.drone.isBeeping());
}

// Errata 7.7: 5 % for 5 s, and 8 s without an ear.
void TestBcflightSimulator::motorTestHasItsPhases()
{
    Ground ground(State::Calibrated);
    ground.silenceStream();
    const double begin = ground.drone.now();
    ground.drone.receive(asBytes(QByteArray::fromHex("00e0 00000003 85")));
    QVERIFY(ground.untilOutputs({0, 0, 0, 0.05}, 8) > 0);
    const double turns = ground.untilOutputs({0, 0, 0, 0}, 8);
    QVERIFY2(isNear(turns, 5.0), qPrintable(QString::number(turns)));
    QVERIFY(ground.drone.now() < begin + 8);
    ground.drone.receive(asBytes(QByteArray::fromHex("85")));
    qsizetype answered = 0;
    while (answered == 0 && ground.drone.now() < begin + 20)
        answered = ground.wait(0.001).size();
    QVERIFY2(isNear(ground.drone.now() - begin, 8.0),
             qPrintable(QString::number(ground.drone.now() - begin)));
    QCOMPARE(ground.drone.status().bits(), std::uint32_t(Status::kCalibrated));
    // What stands behind it in its packet waits as well.
    QCOMPARE(answered, 2);
}

// Errata 7.7: off 10 s, full 8 s, zero 8 s.
void TestBcflightSimulator::controllersHaveTheirPhases()
{
    Ground ground;
    ground.silenceStream();
    const double begin = ground.drone.now();
    ground.drone.receive(asBytes(QByteArray::fromHex("0066")));
    const double off = ground.untilOutputs({1, 1, 1, 1}, 30);
    QVERIFY2(isNear(off, 10.0), qPrintable(QString::number(off)));
    const double full = ground.untilOutputs({0, 0, 0, 0}, 30);
    QVERIFY2(isNear(full, 8.0), qPrintable(QString::number(full)));
    ground.drone.receive(asBytes(QByteArray::fromHex("85")));
    while (ground.wait(0.001).isEmpty() && ground.drone.now() < begin + 60) { }
    QVERIFY2(isNear(ground.drone.now() - begin, 26.0),
             qPrintable(QString::number(ground.drone.now() - begin)));
    QVERIFY(!ground.drone.isArmed());
}

void TestBcflightSimulator::queueIsCarriedOutInItsOrder()
{
    Ground ground(State::Calibrated);
    ground.silenceStream();
    ground.sendHex("00e0 00000000", 1);
    for (const char *packet : {"a0", "85", "a1 0027", "0605"})
        QVERIFY(ground.sendHex(packet, 0.5).isEmpty());
    QCOMPARE(hexOf(ground.wait(6)), u"a000000001|8500000002|a100000000|00270000000000000000|06050605"_s);
}

void TestBcflightSimulator::restartsTakeTheirTime_data()
{
    QTest::addColumn<QString>("why");
    QTest::addColumn<double>("seconds");
    QTest::newRow("7.3 another text") << u"text"_s << Drone::kRestartTime;
    QTest::newRow("7.4 another firmware") << u"firmware"_s << Drone::kReplaceTime;
}

// It answers nothing meanwhile, then wants a PING, and is not calibrated.
void TestBcflightSimulator::restartsTakeTheirTime()
{
    QFETCH(QString, why);
    QFETCH(double, seconds);
    Ground ground(State::Calibrated);
    ground.silenceStream();
    const QByteArray image("firmware");
    if (why == u"text"_s) {
        const QByteArray upload = encodeChecked(ground.drone.configuration() + "-- more\n");
        QCOMPARE(hexOf(ground.send(encode(Message::SetConfigFile, upload), 0.005)), u"007100000000"_s);
    } else {
        QCOMPARE(hexOf(ground.send(encode(Message::UploadData, encodeChunk(0, image)))), u"007300000001"_s);
        QVERIFY(ground.send(encode(Message::UploadProcess, bigU32(crc32c(asBytes(image)))), 0.005).isEmpty());
    }
    const double begin = ground.drone.now();
    double back = -1;
    while (back < 0 && ground.drone.now() < begin + 30) {
        const bool answers = !ground.sendHex("81 0000 0000", 0.05).isEmpty();
        back = answers ? ground.drone.now() - begin : -1;
    }
    QVERIFY2(std::abs(back - seconds) < 0.2, qPrintable(QString::number(back)));
    QCOMPARE(ground.drone.status().bits(), 0U);
    QVERIFY(!ground.drone.isStreamPaused());
}

// Errata 2.1, 7.3: only the first has an id.
void TestBcflightSimulator::longTextGoesInTwoDatagrams()
{
    Ground ground;
    const QByteArray text = ground.drone.configuration() + "--" + QByteArray(70000, 'x') + '\n';
    ground.send(encode(Message::SetConfigFile, encodeChecked(text)), Drone::kRestartTime + 0.1);
    ground.connect();
    ground.silenceStream();
    const QList<QByteArray> packets = ground.sendHex("0070");
    QCOMPARE(packets.size(), 2);
    QCOMPARE(packets[0].size(), 65000);
    QCOMPARE(packets[0] + packets[1], QByteArray::fromHex("0070") + encodeChecked(text));
}

void TestBcflightSimulator::textEndsAtItsZero()
{
    Ground ground;
    const QByteArray before = ground.drone.configuration();
    ground.silenceStream();
    const QByteArray whole("a = 1\0b = 2\n", 12);
    const QByteArray crc = bigU32(crc32c(asBytes(whole)));
    QVERIFY(ground.send(encode(Message::SetConfigFile, crc + whole + '\0'))
                .contains(QByteArray::fromHex("0071 00000001")));
    QCOMPARE(ground.drone.configuration(), before);
}

// Errata 6.2.
void TestBcflightSimulator::userNameStandsInTheText()
{
    Ground ground;
    QByteArray text = ground.drone.configuration();
    QVERIFY(text.contains("username = \"simulated\""));
    const auto told = [&](const QByteArray &next) {
        ground.send(encode(Message::SetConfigFile, encodeChecked(next)), Drone::kRestartTime + 0.1);
        ground.connect();
        ground.silenceStream();
        return textOf(ground.sendHex("3001").value(0));
    };
    QCOMPARE(told(QByteArray(text).replace("\"simulated\"", "\"Ann\"")), QByteArray("Ann"));
    QCOMPARE(told(QByteArray(text).replace("username", "-- username")), QByteArray("[unknown]"));
}

// Errata 6.2, 6.4: neither is stored.
void TestBcflightSimulator::offsetsAndTelemetryAreForgotten()
{
    Ground ground;
    ground.sendHex("005c 3f800000 3f800000");
    ground.sendHex("0050 3e800000");
    ground.sendHex("0067 00000000");
    ground.send(encode(Message::SetConfigFile, encodeChecked(ground.drone.configuration() + "-- x\n")),
                Drone::kRestartTime + 0.1);
    ground.connect();
    const QList<QByteArray> packets = ground.wait(0.3);
    QVERIFY(std::all_of(packets.begin(), packets.end(),
                        [](const QByteArray &packet) { return packet.size() >= 102; }));
    QVERIFY(ground.sendHex("0027").contains(QByteArray::fromHex("0027 00000000 00000000")));
    QVERIFY(ground.drone.gains()[0][0] < 0.01);
}

// Errata 7.4.
void TestBcflightSimulator::firstPieceEmptiesWhatWasReceived()
{
    const QByteArray first(1024, 'a');
    const QByteArray second(1000, 'b');
    const auto piece = [](std::uint32_t at, const QByteArray &data) {
        return encode(Message::UploadData, encodeChunk(at, data));
    };
    const auto finish = [](Ground &ground, const QByteArray &image) {
        ground.send(encode(Message::UploadProcess, bigU32(crc32c(asBytes(image)))));
        return ground.drone.firmware() == image;
    };
    Ground ground;
    for (const QByteArray &packet : {piece(0, first), piece(1024, second), piece(0, first)})
        QVERIFY(ground.send(packet).contains(QByteArray::fromHex("0073 00000001")));
    QVERIFY(!finish(ground, first + second));
    QVERIFY(finish(ground, first));
    // A later one that comes twice harms nothing.
    Ground other;
    for (const QByteArray &packet : {piece(0, first), piece(1024, second), piece(1024, second)})
        other.send(packet);
    QVERIFY(finish(other, first + second));
}

void TestBcflightSimulator::limitsOfPieces_data()
{
    QTest::addColumn<std::uint32_t>("offset");
    QTest::addColumn<std::uint32_t>("size");
    QTest::addColumn<int>("code");
    QTest::newRow("7.4 last offset") << kFarOffset - 1 << 1U << 1;
    QTest::newRow("7.4 offset of 4 MiB") << kFarOffset << 1U << 4;
    QTest::newRow("7.4 size of 4 MiB") << 0U << kFarOffset << 3;
}

void TestBcflightSimulator::limitsOfPieces()
{
    QFETCH(std::uint32_t, offset);
    QFETCH(std::uint32_t, size);
    QFETCH(int, code);
    Ground ground;
    const QByteArray data("x");
    const QByteArray packet = bigU32(crc32c(asBytes(data))) + bigU32(offset) + bigU32(offset) + bigU32(size)
        + bigU32(size) + data;
    QVERIFY(ground.send(encode(Message::UploadData, packet))
                .contains(QByteArray::fromHex("0073") + bigU32(std::uint32_t(code))));
}

void TestBcflightSimulator::streamHasItsOrder_data()
{
    QTest::addColumn<int>("generation");
    QTest::addColumn<bool>("full");
    QTest::addColumn<QString>("always");
    const QString flight = u"43 16 1b 12 1d 18 17 19 1c"_s;
    QTest::newRow("8.1 G") << int(Generation::G) << true << flight;
    QTest::newRow("8.1 D") << int(Generation::D) << true << flight;
    QTest::newRow("8.1 C, without RATES") << int(Generation::C) << true << QString(flight).remove(u"1d "_s);
    QTest::newRow("8.1 slim") << int(Generation::G) << false << QString();
    QTest::newRow("1 B, slim") << int(Generation::B) << false << QString();
    QTest::newRow("1 A, slim, with its attitude all the same")
        << int(Generation::A) << false << QString(flight).remove(u"1d "_s);
}

void TestBcflightSimulator::streamHasItsOrder()
{
    QFETCH(int, generation);
    QFETCH(bool, full);
    QFETCH(QString, always);
    Ground ground(State::Connected, Generation(generation));
    ground.send(encode(Message::SetFullTelemetry, bigU32(full ? 1 : 0), Generation(generation)));
    ground.wait(0.2);
    const QString battery = u"30 31 32 34 35 36 37 38"_s;
    const QString loop = full ? u"39 1a"_s : u"39"_s;
    const auto all = [](QStringList parts) {
        parts.removeAll(QString());
        return parts.join(u' ');
    };
    QStringList seen;
    for (const QByteArray &packet : ground.wait(0.4)) {
        QStringList ids;
        for (const int id : idsIn(packet))
            ids.append(QString::number(id, 16));
        seen.append(ids.join(u' '));
    }
    QStringList kinds{all({loop, battery, always}), all({battery, always}), all({always})};
    kinds.removeAll(QString());
    for (const QString &each : seen)
        QVERIFY2(kinds.contains(each), qPrintable(each));
    // Of ten periods one has everything, and every fifth the battery.
    QCOMPARE(seen.count(kinds[0]), 4);
    QCOMPARE(seen.count(kinds[1]), 4);
    if (kinds.size() > 2)
        QVERIFY(std::abs(seen.count(kinds[2]) - 32) <= 1);
}

void TestBcflightSimulator::streamHasItsRate_data()
{
    QTest::addColumn<QByteArray>("rate");
    QTest::addColumn<int>("perSecond");
    QTest::newRow("8.1 20 Hz") << QByteArray("20") << 20;
    QTest::newRow("8.1 none") << QByteArray("0") << 0;
}

void TestBcflightSimulator::streamHasItsRate()
{
    QFETCH(QByteArray, rate);
    QFETCH(int, perSecond);
    Ground ground;
    QByteArray text = ground.drone.configuration();
    QVERIFY(text.contains("telemetry_rate = 100"));
    text.replace("telemetry_rate = 100", "telemetry_rate = " + rate);
    ground.send(encode(Message::SetConfigFile, encodeChecked(text)), Drone::kRestartTime + 0.1);
    ground.connect();
    ground.wait(1.0);
    QVERIFY(std::abs(ground.wait(1.0).size() - perSecond) <= (perSecond > 0 ? 1 : 0));
    QVERIFY(ground.sendHex("85").contains(QByteArray::fromHex("8500000000")));
}

// Errata 8.2.
void TestBcflightSimulator::attitudeIsNothingBeforeACalibration()
{
    const auto payloads = [](Ground &ground) {
        QMap<int, QByteArray> told;
        bcflight::Framer framer;
        const FrameSink sink
            = [&told](const FrameView &frame) { told[frame.id] = toByteArray(frame.payload); };
        for (const QByteArray &packet : ground.wait(0.1)) {
            framer.feed(asBytes(packet), sink);
            framer.packetEnded(sink);
        }
        return told;
    };
    Ground off;
    const auto before = payloads(off);
    Ground on(State::Calibrated);
    const auto after = payloads(on);
    for (const Message id : {Message::RollPitchYaw, Message::Rates, Message::Gyro, Message::Accel,
                             Message::Magn, Message::GyroDterm}) {
        QCOMPARE(before.value(int(id)), QByteArray(12, '\0'));
        QVERIFY(after.value(int(id)) != QByteArray(12, '\0'));
    }
    QCOMPARE(before.value(int(Message::CurrentAcceleration)), QByteArray(4, '\0'));
}

// Errata 9.1: it does not notice.
void TestBcflightSimulator::outOfReachItFliesOn()
{
    Faults faults;
    faults.silentArmed = 5;
    Ground ground(State::Armed, Generation::G, {}, faults);
    QVERIFY(ground.drone.isArmed());
    QVERIFY(ground.wait(2).isEmpty());
    QVERIFY(ground.send(QByteArray::fromHex("0047 85"), 2).isEmpty());
    QVERIFY(ground.drone.isArmed() && ground.runs());
    QVERIFY(!ground.wait(2).isEmpty());
    QVERIFY(ground.drone.isArmed() && ground.runs());
    QVERIFY(!ground.sendHex("0047 85").isEmpty());
    QVERIFY(!ground.drone.isArmed() && !ground.runs());
    // And again, until it is cleared.
    ground.send(ground.controls({.thrust = 0.3, .arm = true}));
    QVERIFY(ground.drone.isArmed() && ground.wait(1).isEmpty());
    ground.drone.setFaults({});
    QVERIFY(ground.drone.isArmed() && !ground.wait(1).isEmpty());
}

// Errata 8.3: half of 512, and one.
void TestBcflightSimulator::spectrumHasItsBins()
{
    Ground ground(State::Calibrated, Generation::G, {{QLatin1String(Drone::kNotch), 1}});
    const QList<QByteArray> packets = ground.wait(0.1);
    QVERIFY(!packets.isEmpty());
    for (const QByteArray &packet : packets) {
        QCOMPARE(idsIn(packet).last(), int(Message::RateSpectrum));
        const QByteArray spectrum = packet.last(4 + 257 * 16);
        QCOMPARE(spectrum.first(4).toHex(), QByteArray("001e1010"));
        for (qsizetype bin = 0; bin < 257; ++bin)
            QCOMPARE(spectrum.sliced(4 + 16 * bin + 12, 4), QByteArray(4, '\0'));  // unused
    }
    Ground old(State::Calibrated, Generation::D, {{QLatin1String(Drone::kNotch), 1}});
    for (const QByteArray &packet : old.wait(0.1))
        QVERIFY(!idsIn(packet).contains(int(Message::RateSpectrum)));
}

// Only the thread of the commands is busy.
void TestBcflightSimulator::streamGoesOnWhileItIsDeaf()
{
    Ground ground(State::Calibrated);
    ground.sendHex("00e0 00000000", 0.1);
    QVERIFY(std::abs(ground.wait(1.0).size() - 100) <= 1);
}

// Errata 7.5, 7.6.
void TestBcflightSimulator::textsHaveTheirForms()
{
    Ground ground;
    ground.silenceStream();
    QVERIFY(textOf(ground.sendHex("0069").value(0)).startsWith("{\n    [\"Type\"] = \""));
    QVERIFY(textOf(ground.sendHex("006a").value(0)).startsWith("{\n    Accelerometers = {\n"));
    QVERIFY(textOf(ground.sendHex("006b").value(0)).startsWith("{\n    [\"Camera 0\"] = {\n"));
    const QByteArray list = ground.sendHex("00d0").value(0);
    QCOMPARE(list.first(1).toHex(), QByteArray("d0"));
    QCOMPARE(*decodeChecked(asBytes(list).subspan(1)),
             QByteArray(".:0:::;..:0:::;video_0.h264:734003:::;video_1.h264:20480:::;"));
    Ground old(State::Connected, Generation::A);
    old.silenceStream();
    QVERIFY(textOf(old.sendHex("0069").value(0)).startsWith("Type:simulated\n"));
    QVERIFY(textOf(old.sendHex("006a").value(0)).startsWith("Sensors = {\n"));
    // The id of the cameras is that of the configuration then (1).
    const QByteArray configuration = old.sendHex("006b").value(0);
    QCOMPARE(configuration, QByteArray::fromHex("006b") + encodeChecked(old.drone.configuration()));
}

QTEST_GUILESS_MAIN(TestBcflightSimulator)
#include "tst_bcflightsimulator.moc"
