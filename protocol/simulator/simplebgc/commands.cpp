// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr double kLatency = 0.0015;  // seconds from command to the first byte of its answer
constexpr double kWriteLatency = 0.030;  // EEPROM write (errata 7: tens of ms)
constexpr double kCalibrationTime = 4.0;
constexpr int kStreamsFrom = 2590;  // firmware
constexpr qsizetype kStreamSpace = 512;  // with more than this in the output buffer, streams are skipped
constexpr int kMaxStreams = 10;
constexpr int kUnknownFirmware = 9990;
constexpr int kBoardVersion = 30;
constexpr int kFirstSlots = 5;  // of scripts: the later ones stand elsewhere in BOARD_INFO_3 (errata 3.2)
constexpr int kFirstSizesAt = 25;
constexpr int kLaterSizesAt = 40;

}  // namespace

void SimulatedBoard::send(CommandId id, const QByteArray &payload, int version, bool isStream)
{
    if (isStream && m_output.size() > kStreamSpace) {
        ++m_streamCount.skipped;
        return;
    }
    m_streamCount.sent += isStream;
    m_output += encodeFrame(number(id), payload, version);
}

void SimulatedBoard::reply(const Frame &to, CommandId id, const QByteArray &payload)
{
    m_replies.push_back({m_now + kLatency, encodeFrame(number(id), payload, to.version)});
}

void SimulatedBoard::confirm(const Frame &to, const QByteArray &data)
{
    reply(to, CommandId::Confirm, QByteArray(1, static_cast<char>(to.id)) + data);
}

void SimulatedBoard::refuse(const Frame &to, int code)
{
    // Old firmware does not answer what it does not understand (errata 7).
    if (m_options.firmware < 2600 && (code == kUnknownCommand || code == kWrongSize))
        return;
    reply(to, CommandId::Error, ByteWriter().u8(to.id).u8(code).zeros(4).take());
}

bool SimulatedBoard::hasSize(const Frame &frame, qsizetype size)
{
    // Real boards accept one extra byte on commands without parameters (errata 1.4).
    if (frame.payload.size() == size || (size == 0 && frame.payload.size() == 1))
        return true;
    refuse(frame, kWrongSize);
    return false;
}

void SimulatedBoard::handle(const Frame &frame)
{
    m_lastVersion = frame.version;
    if (frame.id == m_options.faults.deaf)
        return;
    // The first boards know the commands whose numbers are letters; that they know no others is assumed.
    const bool isKnown = !isFitted("legacy") || (frame.id >= 'A' && frame.id <= 'z');
    if (isKnown
        && (handleRead(frame) || handleWrite(frame) || handleAction(frame) || handleGrown(frame)
            || handleMemory(frame) || handleMotors(frame) || handleExpert(frame) || handleSteering(frame)
            || handleLater(frame)))
        return;
    refuse(frame, kUnknownCommand);
}

bool SimulatedBoard::handleRead(const Frame &frame)
{
    const bool streams = m_options.firmware >= kStreamsFrom;
    switch (static_cast<CommandId>(frame.id)) {
    case CommandId::BoardInfo: {
        BoardInfo info;
        info.boardVersion = m_options.own.value(u"board"_s, kBoardVersion);
        info.firmware = m_options.faults.unknownFirmware ? kUnknownFirmware : m_options.firmware;
        info.features = ThreeAxis | BatteryMonitor | CurrentSensor | BodeTest;
        if (!isFitted("legacy"))
            info.features |= Scripting;
        if (isFitted("encoders"))
            info.features |= Encoders;
        if (isFitted("magnetometer") && m_options.firmware >= kLater)
            info.features |= Magnetometer;
        info.usb = m_options.usb;
        reply(frame, CommandId::BoardInfo, info.encode());
        return true;
    }
    case CommandId::BoardInfo3: {
        BoardInfo3 info;
        info.deviceId = ByteWriter().bytes("GDSIM").u32(m_options.seed).take();
        info.mcuId = QByteArray("SIMULATEDMCU");
        if (const int filler = m_options.own.value(u"number"_s, -1); filler >= 0) {
            info.deviceId.fill(char(filler));
            info.mcuId.fill(char(filler));
        }
        info.eepromSize = kMemorySize;
        QByteArray told = info.encode();
        for (int i = 0; i < scriptSlots(); ++i) {
            const auto size = quint16(m_files.value(kScriptFile + (i << 8)).size());
            const int at = i < kFirstSlots ? kFirstSizesAt + 2 * i : kLaterSizesAt + 2 * (i - kFirstSlots);
            told[at] = char(size & 0xFF);
            told[at + 1] = char(size >> 8);
        }
        for (std::size_t i = 0; i < m_sets.size(); ++i)
            told[35] = char(told[35] | (m_sets[i].empty() ? 0 : 1 << i));
        reply(frame, CommandId::BoardInfo3, told);
        return true;
    }
    case CommandId::ReadParams:
    case CommandId::ReadParams3: readParams(frame, Params3); return true;
    case CommandId::ReadParamsExt: readParams(frame, ParamsExt); return true;
    case CommandId::ReadParamsExt2:
        if (m_options.firmware < kBlocks[ParamsExt2].since)
            return false;
        readParams(frame, ParamsExt2);
        return true;
    case CommandId::ReadParamsExt3:
        if (m_options.firmware < kExt3Since)
            return false;
        readParams(frame, ParamsExt3);
        return true;
    case CommandId::ReadAdjVarsCfg:
        if (hasSize(frame, 0))
            reply(frame, CommandId::ReadAdjVarsCfg, m_ram[AdjVarsCfg]);
        return true;
    case CommandId::ReadProfileNames:
        reply(frame, CommandId::ReadProfileNames, encodeProfileNames(m_names));
        return true;
    case CommandId::RealtimeData:
    case CommandId::RealtimeData3:
        if (hasSize(frame, 0))
            reply(frame, CommandId::RealtimeData3, polled(CommandId::RealtimeData3, realtime(false)));
        return true;
    case CommandId::RealtimeData4:
        if (hasSize(frame, 0))
            reply(frame, CommandId::RealtimeData4, polled(CommandId::RealtimeData4, realtime(true)));
        return true;
    case CommandId::RealtimeDataCustom:
        if (!streams)
            return false;
        if (!hasSize(frame, 10))
            return true;
        if (const quint32 flags = ByteReader(frame.payload).u32(); isTooLong(flags))
            refuse(frame, kWrongParameters);
        else
            reply(frame, CommandId::RealtimeDataCustom, realtimeCustom(flags));
        return true;
    case CommandId::GetAngles:
        if (hasSize(frame, 0))
            reply(frame, CommandId::GetAngles, polled(CommandId::GetAngles, encodeAngles(angles())));
        return true;
    case CommandId::GetAnglesExt:
        if (m_options.firmware < kAnglesExtSince)
            return false;
        if (hasSize(frame, 0))
            reply(frame, CommandId::GetAnglesExt, encodeAnglesExt(angles()));
        return true;
    case CommandId::GetAdjVarsVal: getAdjVars(frame); return true;
    case CommandId::AdjVarsState:
        if (frame.payload.size() == 2 || frame.payload.size() == 7)
            reply(frame, CommandId::AdjVarsState, slotState(frame));
        else
            refuse(frame, kWrongSize);
        return true;
    case CommandId::ReadRcInputs:
        if (m_options.firmware < kLater)
            return false;
        if (const qsizetype sources = frame.payload.size() - 2; sources >= 1 && sources <= kMostSources)
            reply(frame, CommandId::ReadRcInputs, rcInputs(frame));
        else
            refuse(frame, kWrongSize);
        return true;
    case CommandId::GetParams3:
        refuse(frame, kNotSupported);  // "not yet implemented" according to the document
        return true;
    default: return false;
    }
}

bool SimulatedBoard::handleWrite(const Frame &frame)
{
    switch (static_cast<CommandId>(frame.id)) {
    case CommandId::WriteParams:
    case CommandId::WriteParams3: writeParams(frame, Params3); return true;
    case CommandId::WriteParamsExt: writeParams(frame, ParamsExt); return true;
    case CommandId::WriteParamsExt2:
        if (m_options.firmware < kBlocks[ParamsExt2].since)
            return false;
        writeParams(frame, ParamsExt2);
        return true;
    case CommandId::WriteParamsExt3:
        if (m_options.firmware < kExt3Since)
            return false;
        writeParams(frame, ParamsExt3);
        return true;
    case CommandId::WriteAdjVarsCfg: writeParams(frame, AdjVarsCfg); return true;
    case CommandId::WriteProfileNames: {
        if (!hasSize(frame, kProfileCount * kProfileNameSize))
            return true;
        if (const auto names = decodeProfileNames(asBytes(frame.payload)))
            m_names = *names;
        confirm(frame);
        return true;
    }
    case CommandId::SetAdjVarsVal: setAdjVars(frame); return true;
    default: return false;
    }
}

bool SimulatedBoard::handleAction(const Frame &frame)
{
    switch (static_cast<CommandId>(frame.id)) {
    case CommandId::MotorsOn:
        switchMotors(SwitchOn);
        confirm(frame);
        return true;
    case CommandId::Control: control(frame); return true;
    case CommandId::SelectImu3:
        // A sensor that is not there is not selected, and nothing is said (errata 7).
        if (const int imu = frame.payload.isEmpty() ? 0 : quint8(frame.payload[0]);
            imu == 1 || (imu == kFrameImu && isFrameSensor())) {
            m_imu = imu;
            confirm(frame);
        }
        return true;
    case CommandId::CalibGyro:
    case CommandId::CalibAcc: startCalibration(frame); return true;
    case CommandId::CalibOffset: confirm(frame); return true;
    case CommandId::CalibBat:
        if (!hasSize(frame, 2))
            return true;
        m_voltageOffset += ByteReader(frame.payload).u16() * 0.01 - volts();
        confirm(frame);
        return true;
    case CommandId::AutoPid: autoPid(frame); return true;
    case CommandId::DataStreamInterval:
        if (m_options.firmware < 2590)
            return false;
        registerStream(frame);
        return true;
    case CommandId::BeepSound: return m_options.firmware >= 2590;
    case CommandId::ApiVirtChControl: setChannels(frame); return true;
    case CommandId::ApiVirtChHighRes:
        if (m_options.firmware < 2687)
            return false;
        setChannels(frame);
        return true;
    case CommandId::Reset: {
        double delay = 0;
        if (frame.payload.size() >= 3) {
            ByteReader reader(frame.payload);
            if (reader.u8() & 1)
                reply(frame, CommandId::Reset, {});
            delay = reader.u16() * 0.001;
        }
        restart(delay + 2 * kLatency);
        return true;
    }
    default: return false;
    }
}

void SimulatedBoard::readParams(const Frame &frame, int block)
{
    if (!hasSize(frame, 1))
        return;
    const int asked = quint8(frame.payload[0]);
    const int profile = asked < kProfileCount ? asked : m_active;
    QByteArray bytes = profile == m_active ? m_ram[std::size_t(block)]
                                           : m_eeprom[std::size_t(profile)][std::size_t(block)];
    bytes[0] = static_cast<char>(profile);
    if (block == Params3) {
        bytes[132] = static_cast<char>(m_imu);
        bytes[133] = static_cast<char>(m_active);
    }
    reply(frame, static_cast<CommandId>(frame.id), bytes);
}

void SimulatedBoard::writeParams(const Frame &frame, int block)
{
    if (!hasSize(frame, kBlocks[block].size))
        return;
    // The slots belong to the board, and writing them loads no profile.
    const bool isBoardWide = block == AdjVarsCfg;
    const int asked = quint8(frame.payload[0]);
    const int profile = !isBoardWide && asked < kProfileCount ? asked : m_active;
    QByteArray bytes = frame.payload;
    ++m_writesSeen;
    if (m_options.faults.resetOnWrite > 0 && m_writesSeen == m_options.faults.resetOnWrite) {
        // Power fails during the memory write: half of the block is new, the rest old.
        const QByteArray old = m_eeprom[std::size_t(profile)][std::size_t(block)];
        bytes = bytes.left(bytes.size() / 2) + old.mid(bytes.size() / 2);
        m_eeprom[std::size_t(profile)][std::size_t(block)] = bytes;
        shareBoardValues(profile);
        restart(0.0);
        return;
    }
    // The other blocks of the newly active profile are loaded from memory; unsaved variables are lost.
    m_eeprom[std::size_t(profile)][std::size_t(block)] = bytes;
    shareBoardValues(profile);
    if (isBoardWide)
        m_ram[std::size_t(block)] = bytes;
    else if (m_isWriteSet)
        m_writtenProfile = profile;
    else
        loadProfile(profile);
    m_replies.push_back(
        {m_now + kWriteLatency,
         encodeFrame(number(CommandId::Confirm), QByteArray(1, static_cast<char>(frame.id)), frame.version)});
    m_nextCommandAt = m_now + kWriteLatency;
}

std::optional<qint32> SimulatedBoard::adjVar(int id) const
{
    if (m_otherVars.contains(id))
        return m_otherVars.value(id);
    if (id == 31)
        return inUse(u"rc.yaw.follow"_s) != 0;
    for (const ParameterSpec &parameter : m_parameters.all()) {
        if (parameter.adjustable == id)
            return parameter.read(m_ram[parameter.row->block]).value_or(0) * parameter.row->adjustableScale;
    }
    return {};
}

bool SimulatedBoard::setAdjVar(int id, qint32 wanted)
{
    if (m_otherVars.contains(id)) {
        m_otherVars[id] = wanted;
        return true;
    }
    if (id == 31) {
        const ParameterSpec *follow = spec(u"rc.yaw.follow"_s);
        return follow->write(m_ram[Params3], wanted != 0);
    }
    for (const ParameterSpec &parameter : m_parameters.all()) {
        if (parameter.adjustable == id)
            return parameter.write(m_ram[parameter.row->block],
                                   parameter.clamped(wanted / parameter.row->adjustableScale));
    }
    return false;
}

void SimulatedBoard::setAdjVars(const Frame &frame)
{
    const auto vars = decodeAdjVars(asBytes(frame.payload));
    if (!vars) {
        refuse(frame, kWrongSize);
        return;
    }
    bool known = true;
    for (const AdjVar &var : *vars)
        known &= setAdjVar(var.id, var.value);
    applyParameters();
    if (known)
        confirm(frame);
    else
        refuse(frame, kWrongParameters);
}

void SimulatedBoard::getAdjVars(const Frame &frame)
{
    ByteReader reader(frame.payload);
    const int count = reader.u8();
    std::vector<AdjVar> values;
    for (int i = 0; i < count; ++i) {
        const int id = reader.u8();
        const auto now = adjVar(id);
        if (!now) {
            refuse(frame, kWrongParameters);
            return;
        }
        values.push_back({id, *now});
    }
    if (!reader.ok() || count == 0 || count > kAdjVarsPerCommand) {
        refuse(frame, kWrongSize);
        return;
    }
    reply(frame, CommandId::SetAdjVarsVal, encodeAdjVars(values));
}

void SimulatedBoard::registerStream(const Frame &frame)
{
    const auto stream = DataStream::decode(asBytes(frame.payload));
    if (!stream) {
        refuse(frame, kWrongSize);
        return;
    }
    const auto id = static_cast<CommandId>(stream->command);
    const bool isCustom = id == CommandId::RealtimeDataCustom;
    if (!isStreamed(id) || (isCustom && isTooLong(ByteReader(stream->config).u32()))) {
        refuse(frame, kWrongParameters);
        return;
    }
    const auto same = [&stream](const Stream &known) {
        return known.request.command == stream->command && known.request.config == stream->config;
    };
    std::erase_if(m_streams, same);
    if (stream->intervalMs > 0) {
        if (int(m_streams.size()) >= kMaxStreams) {
            refuse(frame, kNotSupported);
            return;
        }
        // Interval 1 means every 0.8 ms cycle (document DATA_STREAM_INTERVAL).
        const double interval = stream->intervalMs == 1 ? Stabilizer::kCycle : stream->intervalMs * 0.001;
        m_streams.push_back({*stream, frame.version, m_now + interval, interval});
    }
    confirm(frame);
}

// Where there are no streams, live data are what is asked for again and again.
QByteArray SimulatedBoard::polled(CommandId id, const QByteArray &payload)
{
    QByteArray &sent = m_polled[id];
    const bool isFrozen = m_options.faults.frozen && m_options.firmware < kStreamsFrom && !sent.isEmpty();
    return isFrozen ? sent : sent = payload;
}

void SimulatedBoard::sendStreams()
{
    for (Stream &stream : m_streams) {
        if (m_now + 1e-9 < stream.next || stream.request.command == number(CommandId::Event))
            continue;
        stream.next += stream.interval;
        QByteArray payload;
        const auto id = static_cast<CommandId>(stream.request.command);
        if (id == CommandId::RealtimeData3 || id == CommandId::RealtimeData4)
            payload = realtime(id == CommandId::RealtimeData4);
        else if (id == CommandId::RealtimeDataCustom)
            payload = realtimeCustom(ByteReader(stream.request.config).u32());
        else if (id == CommandId::RealtimeDataCustom2)
            payload = realtimeCustom2(ByteReader(stream.request.config).u32());
        else
            payload = attitudeVectors(isFrameSensor() && stream.request.config.startsWith('\1'));
        if (m_options.faults.frozen && !stream.sent.isEmpty())
            payload = stream.sent;
        stream.sent = payload;
        send(id, payload, stream.version, true);
    }
}

void SimulatedBoard::startCalibration(const Frame &frame)
{
    const bool extended = frame.payload.size() == 12;
    if (!extended && !hasSize(frame, 0))
        return;
    const int asked = extended ? quint8(frame.payload[0]) : 0;
    const int action = extended ? quint8(frame.payload[1]) : 1;
    if (asked > kFrameImu || action < 1 || action > 7) {
        refuse(frame, kWrongParameters);
        return;
    }
    const int imu = asked == 0 ? m_imu : asked;
    if (isBusy() || (imu == kFrameImu && !isFrameSensor())) {
        refuse(frame, kWrongState);
        return;
    }
    if (extended)
        confirm(frame);  // at reception; the second one comes at the end (document CALIB_ACC)
    if (action != 1 && action != 3) {
        noteTemperatures(static_cast<CommandId>(frame.id), imu, action);
        if (action == 2) {
            SimulatedImu &sensor = imu == kFrameImu ? m_frameImu : m_stabilizer.imu();
            sensor.gyroCorrection = {};
            sensor.accCorrection = {};
            sensor.accScale = {1.0, 1.0, 1.0};
            if (imu != kFrameImu)
                m_accLimits = {};
        }
        if (action == 2 || action == 4 || action == 5) {
            reply(frame, CommandId::Reset, {});
            restart(kResetNotice);
        } else {
            confirm(frame);
        }
        return;
    }
    beginCalibration(static_cast<CommandId>(frame.id), imu, action, frame.version);
}

void SimulatedBoard::beginCalibration(CommandId command, int imu, int action, int version)
{
    m_calibration = {};
    m_calibration.command = command;
    m_calibration.left = m_calibration.total = kCalibrationTime;
    m_calibration.action = action;
    m_calibration.version = version;
    m_calibration.motorsWereOn = m_stabilizer.motorsOn();
    m_calibration.imu = imu;
    if (imu == kFrameImu || command == CommandId::CalibAccExtRef)
        return;  // the camera may move
    m_stabilizer.setMotorsOn(false);
    // The operator lays the camera down level, unless a fault has him shake it.
    if (m_options.faults.shake <= 2.0 && m_options.faults.pose == 0) {
        for (const Axis axis : kAxes)
            m_stabilizer.plant(axis).setAngle(0.0);
        m_stabilizer.setHeld(true);
    }
}

}  // namespace simplebgc
