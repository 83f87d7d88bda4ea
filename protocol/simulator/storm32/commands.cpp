// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Simple and RC commands of the simulated STorM32 board (errata 3, 4, 7).
#include "protocol/base/checksum.h"
#include "protocol/simulator/storm32/board.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr double kControlCycle = 0.0015;  // one command is completed per cycle
constexpr double kInterByte = 0.1;  // then `t`
constexpr double kMemoryWrite = 0.7;  // seconds; nothing else is served meanwhile
constexpr int kMinPulse = 700;
constexpr int kMaxPulse = 2300;
constexpr int kMiddle = 1500;
constexpr int kAckUnknown = 3;
constexpr int kAckChecksum = 151;
constexpr int kAckLength = 152;
constexpr int kAckRange = 153;

int u8At(QByteArrayView bytes, qsizetype at)
{
    return std::uint8_t(bytes[at]);
}

int u16At(QByteArrayView bytes, qsizetype at)
{
    return u8At(bytes, at) | u8At(bytes, at + 1) << 8;
}

}  // namespace

bool SimulatedBoard::isLockedOut() const
{
    return !m_options.usb && inUse(kHeartbeatWord) != 0;  // USB keeps answering everything (errata 6)
}

void SimulatedBoard::reply(const QByteArray &bytes)
{
    if (m_isDeaf || bytes.isEmpty())
        return;
    const double at = std::max(m_busyUntil, m_now) + 0.001 + 0.004 * m_latency.uniform();
    m_replies.push_back({m_replies.empty() ? at : std::max(at, m_replies.back().at), bytes});
}

// Takes one complete command from the received bytes. False if there is none.
bool SimulatedBoard::serve()
{
    if (m_input.isEmpty())
        return false;
    const bool late = m_now - m_lastByteAt > kInterByte;
    const auto used = [this](qsizetype count) {
        m_input.remove(0, count);
        m_busyUntil = std::max(m_busyUntil, m_now) + kControlCycle;
        return true;
    };
    const Bytes all = asBytes(m_input);
    const int first = u8At(m_input, 0);
    m_isDeaf = first == m_options.faults.deaf;
    if (first == 0xFE) {
        // Unknown, damaged or for another address: the whole frame is skipped without an answer (errata 6, 13
        // row 3).
        const qsizetype size = m_input.size() >= 2 ? u8At(m_input, 1) + qsizetype(mavlink::kOverhead) : 2;
        if (m_input.size() < size || m_input.size() < 2)
            return late && used(m_input.size());
        if (const auto packet = packetOf(all.first(std::size_t(size))))
            message(*packet);
        return used(size);
    }
    if (isLockedOut())
        return used(1);
    if (first == 0xFA) {
        const qsizetype length = m_input.size() >= 2 ? u8At(m_input, 1) : 0;
        if (m_input.size() < length + 5) {
            if (!late)
                return false;
            reply("t");
            return used(m_input.size());
        }
        const QByteArray frame = m_input.left(length + 5);
        if (m_options.own.value(u"strict"_s) != 0 && crc16Mcrf4xx(asBytes(frame).subspan(1)) != 0) {
            reply(encodeRc(int(Rc::Ack), QByteArray(1, char(kAckChecksum)), true));
        } else {
            const auto [id, payload] = rc(u8At(frame, 2), QByteArrayView(frame).sliced(3, length));
            reply(encodeRc(id, payload, true));
        }
        return used(frame.size());
    }
    const bool twoLetters = first == 'x' || first == 'C';
    const SimpleCommand *command = findSimple(all);
    if (twoLetters && m_input.size() < 2) {
        if (!late)
            return false;
        reply("t");
        return used(1);
    }
    if (!command) {
        reply("e");
        return used(twoLetters ? 2 : 1);
    }
    const auto letters = qsizetype(qstrlen(command->letters));
    const qsizetype arguments = command->argumentBytes < 0 ? m_ram.size() : command->argumentBytes;
    const qsizetype total = letters + (arguments ? arguments + 2 : 0);
    if (m_input.size() < total) {
        if (!late)
            return false;
        reply("t");
        return used(m_input.size());
    }
    const QByteArray whole = m_input.left(total);
    const QByteArrayView data = QByteArrayView(whole).sliced(letters);
    const bool intact = arguments == 0 || crc16Mcrf4xx(asBytes(data)) == 0;
    reply(intact ? simple(command->id, data.first(arguments)) : QByteArray("c"));
    return used(total);
}

// The fault reset-on-write: power fails while parameters are taken or stored, of which half are new then.
bool SimulatedBoard::failsHalfway(const QByteArray &stored)
{
    if (++m_writesSeen != m_options.faults.resetOnWrite)
        return false;
    const auto half = m_eeprom.size() / 2;
    m_eeprom = stored.left(half) + m_eeprom.mid(half);
    restart(Memory::Reload);
    return true;
}

QByteArray SimulatedBoard::simple(Simple id, QByteArrayView arguments)
{
    const QByteArray ok("o");
    switch (id) {
    case Simple::Test: return ok;
    case Simple::Version: return encodeReply(versionData());
    case Simple::GetParameters: return encodeReply(m_ram);
    case Simple::PutParameters:
        if (failsHalfway(m_eeprom))
            return {};
        m_ram = arguments.toByteArray();  // nothing is validated
        applyParameters();
        return ok;
    case Simple::LiveData: return encodeReply(liveData(32));
    case Simple::Status: return encodeReply(liveData(5));
    case Simple::Store:
        if (failsHalfway(m_ram))
            return {};
        m_eeprom = m_ram;
        m_busyUntil = m_now + kMemoryWrite;
        return ok;
    case Simple::Retrieve:
        m_ram = m_eeprom;
        applyParameters();
        return ok;
    case Simple::Defaults:
        m_ram = factoryStream();
        applyParameters();
        return ok;
    case Simple::EraseEeprom:
        m_eeprom = factoryStream();  // written by the next start
        m_busyUntil = m_now + kMemoryWrite;
        return ok;
    case Simple::Level:
        m_relevelUntil = m_now + 1.0;
        m_stabilizer.resetEstimate();
        return ok;
    case Simple::Restart:
    case Simple::HardReset: restart(Memory::Reload); return ok;
    case Simple::NormalMotors:
        for (const Axis axis : kAxes) {
            const ParameterSpec *usage
                = m_parameters.find(u"motor.%1.usage"_s.arg(QLatin1String(axisKey(axis))));
            usage->write(m_ram, 0);
        }
        restart(Memory::Keep);  // errata 9.3: the wizard only stores after that
        return ok;
    case Simple::TakeDirections:
        for (const Axis axis : kAxes)
            m_parameters.find(u"motor.%1.direction"_s.arg(QLatin1String(axisKey(axis))))->write(m_ram, 0);
        applyParameters();
        return ok;
    case Simple::TakeStartPositions: takeStartPositions({Axis::Roll, Axis::Pitch}); return ok;
    case Simple::TakeYawStartPosition: takeStartPositions({Axis::Yaw}); return ok;
    case Simple::SetName:
        m_name = arguments.toByteArray();
        m_busyUntil = m_now + kMemoryWrite;
        return ok;
    case Simple::SetBaudRate:
        m_baudCode = u8At(arguments, 0);
        m_busyUntil = m_now + kMemoryWrite;
        return ok;
    case Simple::RcTrim: return ok;  // no receiver: the sticks are centred
    case Simple::ReadCalibration: {
        ByteWriter writer;
        for (const int word : m_calibration)
            writer.i16(word);
        return encodeReply(writer.take());
    }
    case Simple::WriteCalibration: return writeCalibration(arguments);
    case Simple::RawSensors: return encodeReply(rawSensors());
    case Simple::Count: break;
    }
    return "e";
}

void SimulatedBoard::takeStartPositions(std::initializer_list<Axis> axes)
{
    for (const Axis axis : axes) {
        // 1008 steps are one electrical turn: seven of them make one turn of the motor.
        const int position = int(std::lround(m_stabilizer.jointAngle(axis) * 7.0 / 360.0 * 1008.0)) + 504;
        m_parameters.find(u"motor.%1.start_position"_s.arg(QLatin1String(axisKey(axis))))
            ->write(m_ram, ((position % 1008) + 1008) % 1008);
    }
}

// Data and their place in the calibration: the selector names one part, or several.
QByteArray SimulatedBoard::writeCalibration(QByteArrayView arguments)
{
    const int selector = u16At(arguments, 0);
    // Errors of this firmware (errata 13, row 14).
    if (selector == 0)
        return QByteArray("\x43\x18\x7F\x6F");
    if (selector > 7)
        return "Cw" + arguments.toByteArray() + ByteWriter().u16(crc16Mcrf4xx(asBytes(arguments))).take()
            + 'o';
    const auto word = [&arguments](int i) { return int(std::int16_t(u16At(arguments, 2 + 2 * i))); };
    const auto take = [&](int first, int count, int from) {
        for (int i = 0; i < count; ++i)
            m_calibration.at(std::size_t(first) + std::size_t(i)) = word(from + i);
    };
    if (selector == 1 || selector == 5 || selector == 7)
        take(0, 6, 0);
    if (selector == 2 || selector == 5 || selector == 7)
        take(6, 3, 7);  // an error of the firmware (errata 13, row 13)
    if (selector == 3 || selector == 6 || selector == 7)
        take(9, 6, 9);
    if (selector == 4 || selector == 6 || selector == 7)
        take(15, 3, 15);
    applyCalibration();
    m_busyUntil = m_now + kMemoryWrite;
    return "o";
}

// Pulses outside the range are ignored, 0 re-centers. @param axis as in kAxes
bool SimulatedBoard::steer(std::size_t axis, int pulse)
{
    if (pulse == 0) {
        m_pulse[axis] = 0;
        m_setAngle[axis] = 0;
        return true;
    }
    if (pulse < kMinPulse || pulse > kMaxPulse)
        return false;
    m_pulse[axis] = pulse - kMiddle;
    return true;
}

std::pair<int, QByteArray> SimulatedBoard::rc(int id, QByteArrayView payload)
{
    const auto ack = [](int code) { return std::pair{int(Rc::Ack), QByteArray(1, char(code))}; };
    const RcCommand *known = findRc(id);
    if (!known)
        return ack(kAckUnknown);
    if (payload.size() != known->payloadBytes)
        return ack(kAckLength);
    constexpr std::size_t kRoll = 0, kPitch = 1, kYaw = 2;
    const auto word = [this](int index) { return index < m_words ? inUse(index) : 0; };
    switch (known->id) {
    case Rc::GetVersion: return {1, versionData().mid(48, 6)};
    case Rc::GetVersionStrings: return {5, versionData().left(48)};
    case Rc::GetParameter:
        return {3, ByteWriter().u16(u16At(payload, 0)).u16(word(u16At(payload, 0))).take()};
    case Rc::SetParameter:
        if (u16At(payload, 0) < m_words)
            set(u16At(payload, 0), u16At(payload, 2));
        return ack(0);
    case Rc::GetData:
        return {5,
                ByteWriter().u8(u8At(payload, 0)).u8(0).take()
                    + (u8At(payload, 0) == 0 ? liveData(32) : QByteArray())};
    case Rc::GetDataFields: return {6, liveFields(u16At(payload, 0))};
    case Rc::SetPitch: steer(kPitch, u16At(payload, 0)); return ack(0);
    case Rc::SetRoll: steer(kRoll, u16At(payload, 0)); return ack(0);
    case Rc::SetYaw: steer(kYaw, u16At(payload, 0)); return ack(0);
    case Rc::SetPitchRollYaw:
        steer(kPitch, u16At(payload, 0));
        steer(kRoll, u16At(payload, 2));
        steer(kYaw, u16At(payload, 4));
        return ack(0);
    case Rc::SetPanMode: setPanMode(u8At(payload, 0)); return ack(0);
    case Rc::SetStandby:
        // Acknowledged and ignored while starting (errata 13, row 1).
        if (!m_standby && (state() != 6 || m_options.faults.runsOn))
            return ack(0);
        if (m_standby && u8At(payload, 0) == 0)
            m_relevelUntil = m_now + 1.0;
        m_standby = u8At(payload, 0) != 0;
        return ack(0);
    case Rc::DoCamera: return ack(0);
    case Rc::SetScriptControl:
        // Nothing is refused (errata 13, row 12).
        if (u8At(payload, 0) < kScriptCount && u8At(payload, 1) <= 4)
            m_scriptCase[std::size_t(u8At(payload, 0))] = u8At(payload, 1);
        return ack(0);
    case Rc::SetAngle: {
        ByteReader reader(payload);
        std::array<double, 3> angles{};
        for (double &angle : angles)
            angle = double(reader.f32());
        mountControl(angles, reader.u8());
        return ack(0);
    }
    case Rc::SetPwmOut:
        if (u16At(payload, 0) < kMinPulse || u16At(payload, 0) > kMaxPulse)
            return ack(kAckRange);
        m_pwmOut = u16At(payload, 0);
        return ack(0);
    case Rc::RestoreParameter:
        if (u16At(payload, 0) < m_words)
            set(u16At(payload, 0), stored(u16At(payload, 0)));
        return ack(0);
    case Rc::RestoreAllParameters:
        m_ram = m_eeprom;
        applyParameters();
        return ack(0);
    case Rc::ActivePanModeSetting: usePanSetting(u8At(payload, 0)); return ack(0);
    case Rc::Ack: break;
    }
    return ack(kAckUnknown);
}

// 1 hold hold pan, 2 hold hold hold, 3 pan pan pan, 4 pan hold hold, 5 pan hold pan, 6 hold pan pan.
void SimulatedBoard::setPanMode(int mode)
{
    if (mode == 0)
        m_panMode.reset();
    else if (mode <= (m_options.firmware >= 92 ? 6 : 5))
        m_panMode = mode - 1;
}

void SimulatedBoard::usePanSetting(int setting)
{
    static constexpr std::array<const char *, 4> kSettings{"pan.mode.default", "pan.mode.setting1",
                                                           "pan.mode.setting2", "pan.mode.setting3"};
    if (setting < int(kSettings.size()))
        m_panMode = int(value(QString::fromLatin1(kSettings[std::size_t(setting)])));
}

// Angles pitch, roll, yaw. Flags 1, 2, 4: limited to the range of the sticks (errata 4).
void SimulatedBoard::mountControl(const std::array<double, 3> &values, unsigned flags)
{
    static constexpr std::array<std::size_t, 3> kPlace{1, 0, 2};
    for (std::size_t i = 0; i < 3; ++i) {
        const Axis axis = kAxes[kPlace[i]];
        if (!std::isfinite(values[i]))
            continue;
        const double low = axisValue("rc.%a.min", axis);
        const double high = axisValue("rc.%a.max", axis);
        m_setAngle[kPlace[i]] = flags >> i & 1
            ? std::clamp(values[i], std::min(low, high), std::max(low, high))
            : std::clamp(values[i], -720.0, 720.0);
    }
}

}  // namespace storm32
