// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What later firmware of the simulated board has beside all that: servos, more live data, the second way to
// search gains (errata 3.9, 3.16 and 3.20).
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kEventsSince = 2657;
constexpr int kServoExtSince = 2732;
constexpr int kCustom2Since = 2740;
constexpr int kServoBits = 18;  // four pins, and two of each CAN driver
constexpr int kLongestPulse = 20000;  // µs
constexpr int kTune2Question = 11;
constexpr int kTune2Size = 73;
constexpr quint32 kIncludeFlags = 1U << 31;

// Of AUTO_PID2.
constexpr int kTuneStart = 1;
constexpr int kTuneStartAndSave = 2;
constexpr int kTuneSave = 3;
constexpr int kTuneStop = 5;
constexpr int kTuneRead = 6;
constexpr int kAxisSettings = 13;  // bytes, from the second on

/// All axes, a gain in the middle, and what else there is at zero: the factory's are in no document.
QByteArray usualTuning()
{
    ByteWriter writer;
    writer.u8(1);
    for (std::size_t i = 0; i < kAxisCount; ++i)
        writer.u8(1).u8(128).u16(300).u8(20).u8(30).u8(30).zeros(6);
    return writer.u16(0).zeros(1).u8(10).u8(100).u8(0).zeros(16).take();
}

}  // namespace

bool SimulatedBoard::handleLater(const Frame &frame)
{
    const int firmware = m_options.firmware;
    ByteReader reader(frame.payload);
    switch (static_cast<CommandId>(frame.id)) {
    case CommandId::BodeTestStartStop:
        if (firmware < kLater)
            return false;
        startFrequencyTest(frame);
        return true;
    case CommandId::ServoOut:
    case CommandId::ServoOutExt:
        if (frame.id == number(CommandId::ServoOutExt) && firmware < kServoExtSince)
            return false;
        setServos(frame);
        return true;
    case CommandId::AutoPid2:
        if (firmware < kTuneByAxisSince)
            return false;
        tune2(frame);
        return true;
    case CommandId::RealtimeDataCustom2:
        if (firmware < kCustom2Since)
            return false;
        if (hasSize(frame, 10))
            reply(frame, CommandId::RealtimeDataCustom2, realtimeCustom2(reader.u32()));
        return true;
    case CommandId::ExtImuDebugInfo:
        if (firmware < kLater)
            return false;
        // There is no external sensor: it tells no matrix and no acceleration.
        if (hasSize(frame, 0))
            reply(frame, CommandId::ExtImuDebugInfo, referenceInfo() + QByteArray(48, '\0'));
        return true;
    default: return handleSensorInfo(frame);
    }
}

bool SimulatedBoard::isStreamed(CommandId id) const
{
    switch (id) {
    case CommandId::RealtimeDataCustom:
    case CommandId::RealtimeData3:
    case CommandId::RealtimeData4:
    case CommandId::AhrsHelper: return true;
    case CommandId::Event: return m_options.firmware >= kEventsSince;
    case CommandId::RealtimeDataCustom2: return m_options.firmware >= kCustom2Since;
    default: return false;
    }
}

// The eight of SERVO_OUT are the four pins and four that no board has.
void SimulatedBoard::setServos(const Frame &frame)
{
    ByteReader reader(frame.payload);
    const bool isMasked = frame.id == number(CommandId::ServoOutExt);
    const quint32 mask = isMasked ? reader.u32() : 0xFF;
    std::array<int, 4> servos = m_servos;
    for (std::size_t i = 0; i < 32; ++i) {
        if (!(mask >> i & 1U))
            continue;
        const int pulse = reader.i16();
        if (i < servos.size())
            servos[i] = std::clamp(pulse, -1, kLongestPulse);
    }
    if (!reader.ok() || reader.remaining() > 0 || mask >> kServoBits != 0)
        refuse(frame, kWrongSize);
    else
        m_servos = servos;
}

QByteArray SimulatedBoard::realtimeCustom2(quint32 flags) const
{
    constexpr quint32 kUnassignedPins = 0xAAAA;  // two bits each: 2, nothing reads them
    ByteWriter writer;
    const auto has = [flags](int bit) { return (flags >> bit & 1U) != 0; };
    writer.u16(int(std::fmod(m_now * 1000.0, 65536.0)));
    if (flags & kIncludeFlags)
        writer.u32(flags & (kIncludeFlags | 0x7F));
    for (std::size_t i = 0; i < kAxisCount && has(0); ++i)
        writer.i16(reportedAngle(frameAngle(kAxes[i])));
    for (std::size_t i = 0; i < kAxisCount && has(1); ++i)
        writer.i16(isFrameSensor() ? toCount16(m_frameRawGyro[i] - m_frameImu.gyroCorrection[i], kGyroUnit)
                                   : 0);
    for (std::size_t i = 0; i < kAxisCount && has(2); ++i)
        writer.i16(isFrameSensor() ? toCount16(m_frameRawAcc[i] - m_frameImu.accCorrection[i], kAccUnit) : 0);
    if (has(3))
        writer.zeros(8);
    for (std::size_t i = 0; i < kAxisCount && has(4); ++i)
        writer.i16(int(std::lround(m_magRaw[i])));
    if (has(5))
        writer.u16(kUnassignedPins).u16(kUnassignedPins).zeros(4);
    for (std::size_t i = 0; i < kAxisCount && has(6); ++i) {
        const double error = m_stabilizer.target(kAxes[i]) - m_stabilizer.estimate(kAxes[i]);
        writer.u16(int(std::min(65535.0, std::round(std::abs(error) * 1000))));
    }
    return writer.take();
}

// Both references are the internal sensors; the main one is present and working.
QByteArray SimulatedBoard::referenceInfo() const
{
    constexpr int kWorks = 0xC9;
    return ByteWriter().u8(kWorks).u8(isFrameSensor() ? kWorks : 0).u8(2).zeros(23).take();
}

// The frequencies, the positions and the notches are kept, and the search takes no notice of them.
void SimulatedBoard::tune2(const Frame &frame)
{
    const int action = frame.payload.isEmpty() ? 0 : quint8(frame.payload[0]);
    const bool isSet = action >= kTuneStart && action <= kTuneSave;
    if (!hasSize(frame, isSet ? kTune2Size : kTune2Question))
        return;
    if (m_tune2.isEmpty())
        m_tune2 = usualTuning();
    if (action == kTuneRead) {
        reply(frame, CommandId::AutoPid2,
              ByteWriter().u8(kTuneRead).zeros(kTune2Question - 1).bytes(m_tune2).take());
        return;
    }
    if (action == kTuneStop) {
        if (m_autoPid && !m_options.faults.runsOn)
            m_autoPid.reset();
        confirm(frame);
        return;
    }
    const QByteArray settings = frame.payload.mid(kTune2Question);
    if (!isSet || settings[0] != 1) {
        refuse(frame, kWrongParameters);
        return;
    }
    int search = 0;  // flags of AUTO_PID
    int filters = 0;
    std::array<int, kAxisCount> strength{};
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        const qsizetype at = 1 + qsizetype(i) * kAxisSettings;
        search |= settings[at] & 1 ? 1 << i : 0;
        filters |= settings[at] & 2 ? 1 << i : 0;
        strength[i] = quint8(settings[at + 1]);
    }
    ByteReader reader(settings);
    reader.skip(1 + kAxisCount * kAxisSettings);
    const int flags = reader.u16();
    const bool starts = action != kTuneSave;
    if (starts && (isBusy() || !m_stabilizer.imuPresent())) {
        refuse(frame, kWrongState);
        return;
    }
    if (starts && search == 0) {
        refuse(frame, kWrongParameters);
        return;
    }
    if (action == kTuneStartAndSave || action == kTuneSave)
        m_tune2 = settings;
    confirm(frame);
    if (!starts)
        return;
    startAutoPid(CommandId::AutoPid2, search | (flags & 1 ? AutoPidKeepCurrent : 0), filters, strength);
    m_autoPidStores = flags & 16;
}

// A restart.
void SimulatedBoard::forget()
{
    m_steeringLimits = {};
    m_attitude = {};
    m_turnSpeed = {};
    if (m_frequencyTest.axis >= 0)
        m_stabilizer.setStimulus(kAxes[std::size_t(m_frequencyTest.axis)], 0);
    m_frequencyTest = {};
    m_servos = {-1, -1, -1, -1};
}

}  // namespace simplebgc
