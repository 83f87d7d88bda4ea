// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/telemetrytables.h"

#include "protocol/base/angles.h"
#include "protocol/storm32/commands.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

// clang-format off
constexpr ChannelSpec kChannels[] = {
    {"imu.angle.roll", "Camera angle, roll", "Angles", "°", 2, Axis::Roll, -180, 180, "attitude.roll"},
    {"imu.angle.pitch", "Camera angle, pitch", "Angles", "°", 2, Axis::Pitch, -180, 180, "attitude.pitch"},
    {"imu.angle.yaw", "Camera angle, yaw", "Angles", "°", 2, Axis::Yaw, -180, 180, "attitude.yaw"},
    {"frame.angle.roll", "Frame angle, roll", "Angles", "°", 2, Axis::Roll, -180, 180, "frame.roll"},
    {"frame.angle.pitch", "Frame angle, pitch", "Angles", "°", 2, Axis::Pitch, -180, 180, "frame.pitch"},
    {"frame.angle.yaw", "Frame angle, yaw", "Angles", "°", 2, Axis::Yaw, -180, 180, "frame.yaw"},
    {"gyro.x", "Gyro, about forward (roll)", "Inertial sensors", "°/s", 2, Axis::Roll, -200, 200, "rate.roll"},
    {"gyro.y", "Gyro, about left (pitch)", "Inertial sensors", "°/s", 2, Axis::Pitch, -200, 200, "rate.pitch"},
    {"gyro.z", "Gyro, about up (yaw)", "Inertial sensors", "°/s", 2, Axis::Yaw, -200, 200, "rate.yaw"},
    {"acc.x", "Acceleration, X", "Inertial sensors", "g", 3, Axis::Roll, -2, 2, "acceleration.x"},
    {"acc.y", "Acceleration, Y", "Inertial sensors", "g", 3, Axis::Pitch, -2, 2, "acceleration.y"},
    {"acc.z", "Acceleration, Z", "Inertial sensors", "g", 3, Axis::Yaw, -2, 2, "acceleration.z"},
    {"up.x", "Up direction, X", "Inertial sensors", "", 4, Axis::Roll, -1, 1},
    {"up.y", "Up direction, Y", "Inertial sensors", "", 4, Axis::Pitch, -1, 1},
    {"up.z", "Up direction, Z", "Inertial sensors", "", 4, Axis::Yaw, -1, 1},
    {"output.roll", "Controller output, roll", "Motors", "°", 2, Axis::Roll, -180, 180, "joint.roll"},
    {"output.pitch", "Controller output, pitch", "Motors", "°", 2, Axis::Pitch, -180, 180, "joint.pitch"},
    {"output.yaw", "Controller output, yaw", "Motors", "°", 2, Axis::Yaw, -180, 180, "joint.yaw"},
    {"input.roll", "Input, roll", "Remote control", "µs", 0, Axis::Roll, -800, 800, "input.roll"},
    {"input.pitch", "Input, pitch", "Remote control", "µs", 0, Axis::Pitch, -800, 800, "input.pitch"},
    {"input.yaw", "Input, yaw", "Remote control", "µs", 0, Axis::Yaw, -800, 800, "input.yaw"},
    {"mag.yaw", "Magnetometer, yaw", "Angles", "°", 2, Axis::Yaw, -180, 180},
    {"link.yaw", "STorM32-Link, yaw", "Angles", "°", 2, Axis::Yaw, -180, 180},
    {"acc.confidence", "Trust in the accelerometer", "Inertial sensors", "", 3, Axis::None, 0, 1.5},
    {"battery", "Battery", "Power", "V", 2, Axis::None, 0, 30, "battery"},
    {"state", "State", "Board", "", 0, Axis::None, 0, 100, "state fault_detail", "", 1, kStates},
    {"status", "Status bits", "Board", "", 0, Axis::None, 0, 65535, "faults", "", 1, kStatusBits, true},
    {"status2", "Status bits 2", "Board", "", 0, Axis::None, 0, 65535, "", "", 1, kStatus2Bits, true},
    {"errors.bus", "Sensor bus errors", "Board", "", 0, Axis::None, 0, 100, "bus_errors"},
    {"cycle_time", "Cycle time", "Board", "µs", 0, Axis::None, 0, 2000, "cycle_time"},
    {"motors.on", "Motors running", "Board", "", 0, Axis::None, 0, 1, "outputs", "", 1, kOffOn},
    {"functions", "Function inputs", "Remote control", "", 0, Axis::None, 0, 65535},
};
// clang-format on
static_assert(std::size(kChannels) == ChannelCount);

// Of the first status word (errata 3.8).
constexpr int kSensorPresent = 0x8000;
constexpr int kMagnetometerPresent = 0x2000;
constexpr int kFrameSensorPresent = 0x1000;
constexpr int kLinkPresent = 0x0100;
// After a gap this long nothing is known about the time between.
constexpr double kGap = 0.5;
constexpr double kDrift = 2e-4;  // greatest drift of the board's clock against ours

}  // namespace

ChannelTable channelTable()
{
    return kChannels;
}

LiveScales::LiveScales(int firmware)
    : gyro(firmware >= 93 ? kDegreesPerRadian / 2048.0 : kDegreesPerRadian / 1000.0)
    , acc(firmware >= 94       ? 1.0 / 8192.0
              : firmware >= 93 ? 1.0 / 16384.0
                               : 1.0 / 10000.0)
    , clock(firmware >= 90)
{
}

std::array<float, ChannelCount> liveRow(Bytes data, const LiveScales &scales)
{
    std::array<float, ChannelCount> row{};
    row.fill(std::numeric_limits<float>::quiet_NaN());
    ByteReader reader(data);
    std::array<int, 32> words{};
    for (int &word : words)
        word = reader.u16();
    if (!reader.ok())
        return row;
    const auto put = [&](int channel, int word, double scale) {
        row[std::size_t(channel)] = float(std::int16_t(words[std::size_t(word)]) * scale);
    };
    const auto raw = [&](int channel, int word, double scale = 1.0) {
        row[std::size_t(channel)] = float(words[std::size_t(word)] * scale);
    };
    raw(State, 0);
    raw(Status, 1);
    raw(Status2, 2);
    raw(BusErrors, 3);
    raw(Voltage, 4, 0.001);
    raw(CycleTime, 6);
    for (int i = 0; i < 3; ++i) {
        put(GyroX + i, 7 + i, scales.gyro);
        put(AccX + i, 10 + i, scales.acc);
        put(UpX + i, 13 + i, 1e-4);
        // The words are in the order pitch, roll, yaw.
        const int channel = std::array{1, 0, 2}[std::size_t(i)];
        put(AngleRoll + channel, 16 + i, 0.01);
        put(OutputRoll + channel, 19 + i, 0.01);
        put(InputRoll + channel, 22 + i, 1.0);
        put(Angle2Roll + channel, 25 + i, 0.01);
    }
    put(MagYaw, 28, 0.01);
    const auto drop = [&row](int first, int last) {
        std::fill(row.begin() + first, row.begin() + last + 1, std::numeric_limits<float>::quiet_NaN());
    };
    // Zeros of a sensor that is not there are no values.
    if (!(words[1] & kSensorPresent)) {
        drop(AngleRoll, AngleYaw);
        drop(GyroX, UpZ);
    }
    if (!(words[1] & kFrameSensorPresent))
        drop(Angle2Roll, Angle2Yaw);
    if (!(words[1] & kMagnetometerPresent))
        drop(MagYaw, MagYaw);
    if (words[1] & kLinkPresent)
        put(LinkYaw, 29, 0.01);  // meaningless without a link
    if (words[1] & kSensorPresent)
        put(AccConfidence, 30, 1e-4);
    raw(Functions, 31);
    row[MotorsActive] = words[2] & kMotorBits ? 1.0F : 0.0F;
    return row;
}

bool isStandby(int state, int firmware)
{
    return state == 99 || (state == 7 && firmware <= 95);
}

QString stateName(int state, int firmware)
{
    const auto known = std::find_if(std::begin(kStates), std::end(kStates), [=](const Choice &choice) {
        return choice.value == state && firmware >= choice.since && firmware <= choice.until;
    });
    return known == std::end(kStates) ? u"unknown (%1)"_s.arg(state) : QString::fromLatin1(known->name);
}

std::vector<BoardFact> factsOf(unsigned status, unsigned status2, unsigned functions)
{
    const char *none = QT_TRANSLATE_NOOP("Tables", "none");
    const char *absent = QT_TRANSLATE_NOOP("Tables", "not present");
    const char *ok = QT_TRANSLATE_NOOP("Tables", "OK");
    const char *error = QT_TRANSLATE_NOOP("Tables", "error");
    const auto part = [&](unsigned present, unsigned sound) {
        return std::vector<const char *>{!(status & present) ? absent : status & sound ? ok : error};
    };
    const auto axes = [status2, none](unsigned pitch, unsigned roll, unsigned yaw) {
        std::vector<const char *> words;
        if (status2 & roll)
            words.push_back(QT_TRANSLATE_NOOP("Tables", "Roll"));
        if (status2 & pitch)
            words.push_back(QT_TRANSLATE_NOOP("Tables", "Pitch"));
        if (status2 & yaw)
            words.push_back(QT_TRANSLATE_NOOP("Tables", "Yaw"));
        return words.empty() ? std::vector<const char *>{none} : words;
    };
    std::vector<BoardFact> facts{
        {QT_TRANSLATE_NOOP("Tables", "Camera sensor"), part(0x8000, 0x0020)},
        {QT_TRANSLATE_NOOP("Tables", "Frame sensor"), part(0x1000, 0x0040)},
    };
    if (status & 0x1000)
        facts.back().words.push_back(status & 0x0800 ? QT_TRANSLATE_NOOP("Tables", "on the board")
                                                     : QT_TRANSLATE_NOOP("Tables", "external"));
    if (status & 0x2000)
        facts.push_back({QT_TRANSLATE_NOOP("Tables", "Magnetometer"), part(0x2000, 0x0080)});
    if (status & 0x0100) {
        const char *link = !(status & 0x0002) ? error
            : status & 0x0001                 ? ok
                                              : QT_TRANSLATE_NOOP("Tables", "unused");
        facts.push_back({QT_TRANSLATE_NOOP("Tables", "STorM32-Link"), {link}});
    }
    facts.push_back({QT_TRANSLATE_NOOP("Tables", "Motors running"), axes(0x0008, 0x0010, 0x0020)});
    facts.push_back({QT_TRANSLATE_NOOP("Tables", "Following axes"), axes(0x2000, 0x4000, 0x8000)});
    if (status2 & 0x0700)
        facts.push_back({QT_TRANSLATE_NOOP("Tables", "Re-centering"), axes(0x0100, 0x0200, 0x0400)});
    if (status2 & 0x0800)
        facts.push_back({QT_TRANSLATE_NOOP("Tables", "IR camera"), {QT_TRANSLATE_NOOP("Tables", "active")}});
    // Two bits for each function input, from the top.
    static constexpr std::array<const char *, 8> kInputBits{
        QT_TRANSLATE_NOOP("Tables", "Input of pan mode"),  QT_TRANSLATE_NOOP("Tables", "Input of standby"),
        QT_TRANSLATE_NOOP("Tables", "Input of IR camera"), QT_TRANSLATE_NOOP("Tables", "Input of re-center"),
        QT_TRANSLATE_NOOP("Tables", "Input of script 1"),  QT_TRANSLATE_NOOP("Tables", "Input of script 2"),
        QT_TRANSLATE_NOOP("Tables", "Input of script 3"),  QT_TRANSLATE_NOOP("Tables", "Input of script 4")};
    static constexpr std::array<const char *, 4> kLevels{"0", "+500", "-500", "+250"};
    for (std::size_t input = 0; input < kInputBits.size(); ++input) {
        if (const unsigned level = functions >> (14 - 2 * input) & 3U)
            facts.push_back({kInputBits[input], {kLevels[level]}});
    }
    return facts;
}

std::vector<BoardFault> faultsOf(unsigned bits, unsigned)
{
    struct Row
    {
        const char *key, *name, *meaning, *cure;
        bool severe;
    };
    std::vector<BoardFault> faults;
    const auto add = [&faults](const Row &row) {
        faults.push_back({QLatin1String(row.key), QLatin1String(row.name), QLatin1String(row.meaning),
                          QLatin1String(row.cure), row.severe});
    };
    if (!(bits & 0x8000))
        add({"no-sensor", "No IMU", "The board does not see its motion sensor, so it cannot stabilize.",
             "Check the sensor cable and its connectors, then restart the board.", true});
    else if (!(bits & 0x0020))
        add({"imu-error", "IMU error", "The motion sensor answers, but not well.",
             "Check the sensor cable and keep it away from motors.", true});
    if ((bits & 0x1000) && !(bits & 0x0040))
        add({"imu2-error", "Second IMU error", "The sensor at the frame answers, but not well.",
             "Check its cable, or switch it off in the setup.", false});
    if (!(bits & 0x0008))
        add({"no-battery", "No battery", "The motors have no supply; settings can still be changed.",
             "Connect the battery.", false});
    else if (bits & 0x0010)
        add({"low-battery", "Battery below the alarm",
             "Its voltage is below the alarm that is set in the board.",
             "Charge or change the battery; if it is full, correct the alarm.", false});
    if (bits & 0x0004)
        add({"level-failed", "Leveling failed", "The board did not find its level at the start.",
             "Hold the camera still and restart the board.", true});
    return faults;
}

double Decoder::timeOf(int stamp, double arrival)
{
    if (!m_scales.clock)
        return arrival;
    const bool again
        = m_lastStamp < 0 || arrival - m_lastArrival > 60.0;  // the counter may have wrapped more than once
    const double step = again ? 0.0 : double((stamp - m_lastStamp) & 0xFFFF) / 1000.0;
    m_boardTime += step;
    m_lastStamp = stamp;
    // The least late answer shows the offset of the clocks; it is forgotten slowly, because they drift, and
    // at once behind a silence, in which the board's may have stood still.
    const double late = arrival - m_boardTime;
    const bool isAnew = again || arrival - m_lastArrival > kGap;
    m_offset = isAnew ? late : std::min(late, m_offset + kDrift * step);
    return m_boardTime + m_offset;
}

void Decoder::decode(const FrameView &frame, TimePoint at, TelemetryStore &store)
{
    Bytes data = frame.payload;
    if (frame.id == FrameId::kRc + int(Rc::GetData) && data.size() == 66)
        data = data.subspan(2);
    else if (frame.id == FrameId::kMavlink + mavlink::number(mavlink::MessageId::TargetSpecificAck)
             && data.size() == 2 + 67)
        data = data.subspan(2, 64);
    else if (frame.id != FrameId::kSimple + int(Simple::LiveData))
        return;
    if (data.size() != 64)
        return;
    m_polls.answered(store);
    // A board whose clock stands still sends the same sample again.
    if (toByteArray(data) == std::exchange(m_newest, toByteArray(data)) && m_scales.clock) {
        store.noteRepeat(at);
        return;
    }
    if (!m_group) {
        QList<int> channels;
        for (int i = 0; i < ChannelCount; ++i)
            channels.append(i);
        m_group = store.defineGroup(channels, 0.0);
    }
    const double arrival = store.secondsAt(at);
    double time = timeOf(ByteReader(data.subspan(10)).u16(), arrival);
    if (m_lastTime > 0 && time - m_lastTime > kGap) {
        store.appendGap(*m_group, store.origin() + durationFromSeconds(m_lastTime + 1e-3));
        if (m_history)
            m_history->sawStart = false;  // an axis may have followed the handle meanwhile
    }
    time = std::max(time, m_lastTime);
    const auto row = liveRow(data, m_scales);
    if (m_history) {
        m_history->shifted |= unsigned(row[Status2]) & kAllPanBits;
        if (row[State] < kMotorsTurn)
            m_history->sawStart = true;
    }
    if (m_scales.clock)
        store.noteStamp(at);
    store.append(*m_group, store.origin() + durationFromSeconds(time), row);
    m_lastTime = time;
    m_lastArrival = arrival;
}

void Decoder::sent(QByteArrayView bytes, TelemetryStore &store)
{
    const auto isQuestion = [](QByteArrayView content) {
        const SimpleCommand *command = findSimple(asBytes(content));
        return content.size() == 1 && command && command->id == Simple::LiveData;
    };
    bool asks = isQuestion(bytes) || bytes == encodeRc(int(Rc::GetData), QByteArray(1, '\0'));
    if (const mavlink::Sighting seen = mavlink::sight(asBytes(bytes)); seen.look == mavlink::Look::Complete
        && seen.packet.id == mavlink::number(mavlink::MessageId::TargetSpecific))
        asks = isQuestion(toByteArray(seen.packet.payload.subspan(2)));
    if (asks)
        m_polls.asked(store);
}

}  // namespace storm32
