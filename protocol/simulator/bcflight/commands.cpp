// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/checksum.h"
#include "protocol/base/filefault.h"
#include "protocol/simulator/bcflight/board.h"

#include <QtEndian>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace bcflight {

namespace {

constexpr std::uint32_t kRefused = 0xFFFFFFFF;
constexpr std::uint32_t kAccepted = 3;
constexpr double kMostGain = 1.0;
constexpr double kMostOuterGain = 50.0;
constexpr double kMostOffset = 45.0;
constexpr double kConnectPause = 0.01;
constexpr std::size_t kRemembered = 512;  // messages
constexpr qsizetype kCut = 65000;  // longer packets go out in pieces (2.1)
constexpr int kShutter = 200;
constexpr const char *kWhiteBalances[] = {"auto", "incandescent", "fluorescent", "daylight", "cloudy"};

std::uint32_t u32At(Bytes payload, std::size_t at = 0)
{
    return payload.size() < at + 4 ? 0 : qFromBigEndian<std::uint32_t>(payload.data() + at);
}

float f32At(Bytes payload, std::size_t at = 0)
{
    return std::bit_cast<float>(u32At(payload, at));
}

QByteArray floats(std::initializer_list<double> values)
{
    QByteArray bytes;
    for (const double value : values)
        bytes += bigF32(float(value));
    return bytes;
}

// An image of the simulated drone names its version behind a mark; any other is the next one.
QByteArray versionIn(const QByteArray &image)
{
    static const QByteArray mark("version ");
    const qsizetype at = image.indexOf(mark);
    return at < 0 ? QByteArray("2.0")
                  : image.mid(at + mark.size(), 12).split('\n').first().split('\0').first();
}

QByteArray text(const QByteArray &words)
{
    return words + '\0';
}

}  // namespace

QByteArray SimulatedBoard::message(Message id, const QByteArray &payload) const
{
    const int wire = wireId(id, m_generation);
    QByteArray bytes;
    if (wire > 0xFF || wire < 0x80)  // the drone answers with one byte wherever it can (2.2)
        bytes.append(char(wire >> 8));
    bytes.append(char(wire & 0xFF));
    return bytes + payload;
}

void SimulatedBoard::send(const QByteArray &packet)
{
    for (qsizetype at = 0; at < packet.size(); at += kCut)
        m_outbox.push_back(packet.sliced(at, std::min(kCut, packet.size() - at)));
}

void SimulatedBoard::receive(Bytes bytes)
{
    if (hasDroppedClient() || isOutOfReach())
        return;
    m_heardClient = m_now;
    if (!m_isDead && m_now >= m_awayUntil && !bytes.empty())
        m_inbox.push_back(toByteArray(bytes));
}

void SimulatedBoard::restart(double seconds)
{
    start();
    m_awayUntil = m_now + seconds;
}

void SimulatedBoard::block(double seconds)
{
    m_busyUntil = m_now + seconds;
}

// What comes while the thread is busy is carried out in a burst afterwards (7.7).
void SimulatedBoard::serve()
{
    while (!m_inbox.empty() && !m_isHung && !m_isDead && m_now >= m_busyUntil && m_now >= m_awayUntil) {
        const QByteArray packet = std::move(m_inbox.front());
        m_inbox.pop_front();
        // The packet that connects is thrown away (3).
        if (!m_isConnected) {
            m_isConnected = packet.contains(char(0x81));
            if (m_isConnected)
                block(kConnectPause);
            continue;
        }
        handle(packet);
    }
}

void SimulatedBoard::handle(const QByteArray &packet)
{
    DroneReader reader(asBytes(packet), m_generation);
    m_isRetry = false;
    while (const auto item = reader.next()) {
        if (!item->id) {
            ++m_unknown;
            continue;
        }
        m_handled.push_back({m_now, *item->id});
        if (m_handled.size() > kRemembered)
            m_handled.pop_front();
        if (item->wire == m_options.faults.deaf)
            continue;
        if (!handle(*item, reader))
            reader.putBack(*item);
        m_isRetry &= *item->id == Message::Ack;
        // What stands behind it in its packet waits as well, or is never reached.
        if (m_isHung || m_isDead || m_now < m_awayUntil)
            return;
        if (m_now < m_busyUntil) {
            if (!reader.rest().empty())
                m_inbox.push_front(toByteArray(reader.rest()));
            return;
        }
    }
}

bool SimulatedBoard::handle(const DroneReader::Item &item, DroneReader &reader)
{
    const Message id = *item.id;
    const Bytes payload = item.payload;
    const auto answer = [&](const QByteArray &data) { send(message(id, data)); };
    switch (id) {
    case Message::Unknown: break;
    case Message::Ping: {
        QByteArray reply = message(Message::Ping, toByteArray(payload).leftJustified(4, '\0'));
        if (m_generation <= Generation::B)
            reply += message(Message::Status, bigU32(status().bits()))
                + message(Message::Telemetry, telemetry().encode());
        send(reply);
        break;
    }
    case Message::Status: answer(bigU32(status().bits())); break;
    case Message::Telemetry:
        send(message(id, telemetry().encode())
             + (m_generation < Generation::F ? message(Message::Status, bigU32(status().bits()))
                                             : QByteArray()));
        break;
    case Message::Controls: {
        m_sticks = *Controls::decode(payload, m_generation);
        m_heardControls = m_now;
        // No check of the throttle (9.1); without the attitude unit it is ignored.
        if (m_sticks.arm && !m_armed && m_calibrated) {
            m_armed = m_everArmed = true;
            m_armedAt = m_now;
        } else if (!m_sticks.arm && m_armed && !m_options.faults.runsOn)
            disarm();
        break;
    }
    case Message::Ack:
        // A number that comes again marks a retry (5).
        m_isRetry = std::exchange(m_lastAck, item.wire) == item.wire;
        if (m_generation >= Generation::E)
            send(bigU16(std::uint16_t(item.wire)).repeated(2));
        break;
    case Message::Calibrate: calibrate(payload); break;
    case Message::SetTimestamp:
        m_clock = u32At(payload);
        answer(bigU32(0));
        break;
    case Message::Arm:
    case Message::Disarm: break;  // no effect
    case Message::ResetBattery: m_storedCharge = 0; break;
    case Message::CalibrateEscs: {
        if (m_armed)
            break;
        const auto all = [this](double value) { return std::vector<double>(m_outputs.size(), value); };
        stopOutputs();
        m_steps = {{m_now + 10, all(1)}, {m_now + 18, all(0)}};
        block(kEscCalibrationTime);
        break;
    }
    case Message::SetFullTelemetry: m_isFull = u32At(payload) != 0; break;
    case Message::GetBoardInfos: answer(text(boardText())); break;
    case Message::GetSensorsInfos:
    case Message::GetCamerasInfos:
        if (hasVideo())
            answer(text(id == Message::GetSensorsInfos ? sensorsText() : camerasText()));
        break;
    case Message::GetConfigFile: answer(encodeChecked(m_configuration)); break;
    case Message::SetConfigFile: takeConfiguration(payload); break;
    case Message::UploadInit:
    case Message::UploadData:
    case Message::UploadProcess: return handleUpload(id, item, reader);
    case Message::EnableTunDevice:
    case Message::DisableTunDevice: break;
    case Message::GetUsername: answer(text(userName())); break;
    case Message::PidOutput: answer(floats({m_correction.x, m_correction.y, m_correction.z})); break;
    case Message::OuterPidOutput:
    case Message::OuterPidFactors: answer(floats({0, 0, 0})); break;
    case Message::RollPidFactors:
    case Message::PitchPidFactors:
    case Message::YawPidFactors: {
        const auto &gains = m_gains[std::size_t(id) - std::size_t(Message::RollPidFactors)];
        answer(floats({gains[0], gains[1], gains[2]}));
        break;
    }
    case Message::HorizonOffset: answer(floats({m_offset[0], m_offset[1]})); break;
    case Message::SetRoll: m_sticks.roll = double(f32At(payload)); break;
    case Message::SetPitch: m_sticks.pitch = double(f32At(payload)); break;
    case Message::SetYaw: m_sticks.yaw = double(f32At(payload)); break;
    case Message::SetThrust: m_sticks.thrust = double(f32At(payload)); break;
    case Message::ResetMotors:
        if (!m_options.faults.runsOn)
            disarm();
        break;
    case Message::SetMode:
        m_mode = int(u32At(payload));
        m_sticks.roll = m_sticks.pitch = 0;
        if (m_mode == 1)
            m_attitude = Vector3();  // in flight as well (6.4)
        answer(toByteArray(payload));  // any value is echoed (6.4)
        break;
    case Message::SetAltitudeHold: answer(bigU32(0)); break;  // it has no altimeter
    case Message::SetHorizonOffset:
        if (std::abs(f32At(payload)) > float(kMostOffset) || std::abs(f32At(payload, 4)) > float(kMostOffset))
            break;
        m_offset = {double(f32At(payload)), double(f32At(payload, 4))};
        answer(toByteArray(payload));
        break;
    case Message::GetRecordingsList:
        answer(encodeChecked(hasCamera()
                                 ? QByteArray(".:0:::;..:0:::;video_0.h264:734003:::;video_1.h264:20480:::;")
                                 : QByteArray(";")));
        break;
    case Message::MotorTest: testMotor(u32At(payload)); break;
    case Message::MotorsBeep:
        if (!m_armed)
            m_isBeeping = !payload.empty() && payload.back() != std::byte(0);
        break;
    case Message::VtxGetSettings:
    case Message::VtxSetPower:
    case Message::VtxSetChannel: handleVtx(id, item, reader); break;
    default: return handleGain(id, payload) || handleCamera(id, payload);
    }
    return true;
}

// Beyond the limit: silence, and nothing is changed. A NaN passes every check (7.2).
bool SimulatedBoard::handleGain(Message id, Bytes payload)
{
    const int number = int(id) - int(Message::SetRollP);
    if (number < 0 || number > int(Message::SetOuterD) - int(Message::SetRollP))
        return false;
    const double gain = double(f32At(payload));
    const bool isOuter = id >= Message::SetOuterP;
    if (std::abs(gain) > (isOuter ? kMostOuterGain : kMostGain))
        return true;
    if (++m_gainsSet == m_options.faults.resetOnWrite) {
        restart(kRestartTime);
        return true;
    }
    if (!isOuter)
        m_gains[std::size_t(number / 3)][std::size_t(number % 3)] = gain;
    send(message(id, toByteArray(payload)));
    return true;
}

bool SimulatedBoard::handleCamera(Message id, Bytes payload)
{
    const auto answer = [&](const QByteArray &data) { send(message(id, data)); };
    switch (id) {
    case Message::VideoPause: answer(bigU32(1)); break;
    case Message::VideoResume: answer(bigU32(0)); break;
    case Message::VideoStartRecord: answer(bigU32(1)); break;
    case Message::VideoStopRecord: answer(bigU32(0)); break;
    case Message::VideoNightMode: answer(toByteArray(payload)); break;
    case Message::Iso:
    case Message::ShutterSpeed:
        if (hasCamera())
            answer(bigU32(std::uint32_t(id == Message::Iso ? m_iso : kShutter)));
        break;
    case Message::WhiteBalance:
        if (hasCamera() && !m_isRetry)
            m_whiteBalance = (m_whiteBalance + 1) % int(std::size(kWhiteBalances));
        answer(text(hasCamera() ? kWhiteBalances[m_whiteBalance] : "(none)"));
        break;
    case Message::ExposureMode: answer(text(hasCamera() ? "" : "(none)")); break;
    case Message::LockWhiteBalance: answer(text(hasCamera() ? "R1.50B2.25" : "(none)")); break;
    case Message::LensShader: answer(QByteArray(9, char(0x2A))); break;
    default: stepPicture(id); break;  // no reply, nothing that could be read
    }
    return true;
}

void SimulatedBoard::calibrate(Bytes payload)
{
    const bool isRefused = m_armed;
    if (!isRefused) {
        // Without stored offsets it becomes a full one by itself (7.1).
        m_isFullCalibration = u32At(payload) != 0 || !m_hasOffsets;
        m_calibrated = false;
        m_zeroSum = {};
        m_zeroCount = 0;
        m_calibratingUntil = m_now + (m_isFullCalibration ? kFullCalibrationTime : kCalibrationTime);
    }
    send(message(Message::Calibrate, bigU32(isRefused ? kRefused : kAccepted))
         + message(Message::Calibrating, bigU32(1)));
}

void SimulatedBoard::testMotor(std::uint32_t index)
{
    if (m_armed)
        return;
    if (!m_calibrated) {
        m_isHung = true;  // for good
        return;
    }
    if (index >= m_outputs.size()) {
        stopOutputs();
        m_isDead = true;
        return;
    }
    stopOutputs();
    std::vector<double> one(m_outputs.size());
    one[index] = 0.05;
    m_steps = {{m_now + 2.0, one}, {m_now + 7.0, std::vector<double>(m_outputs.size())}};
    block(kMotorTestTime);
}

// The answer goes out first; then the text is written, whatever it is, and the program restarts, armed or
// not.
void SimulatedBoard::takeConfiguration(Bytes payload)
{
    const auto given = decodeChecked(payload);
    send(message(Message::SetConfigFile, bigU32(given ? 0 : 1)));
    if (!given)
        return;
    m_configuration = *given;
    if (!m_options.memoryFile.isEmpty())
        std::ignore = writeWhole(m_options.memoryFile, m_configuration);  // as a drone: nobody is told
    const auto last = m_outbox;
    restart(kRestartTime);
    m_outbox = last;
}

bool SimulatedBoard::handleUpload(Message id, const DroneReader::Item &item, DroneReader &reader)
{
    if (id == Message::UploadInit) {
        m_isStreamPaused = true;
        return true;
    }
    if (id == Message::UploadProcess) {
        if (crc32c(asBytes(m_upload)) != u32At(item.payload))
            return true;  // only its log tells
        m_firmware = m_upload;
        m_version = versionIn(m_firmware);
        restart(kReplaceTime);
        return true;
    }
    constexpr std::size_t kHead = 20;
    const std::uint32_t crc = u32At(item.payload);
    const std::uint32_t offset = u32At(item.payload, 4);
    const std::uint32_t size = u32At(item.payload, 12);
    const auto answer = [&](std::uint32_t code) { send(message(id, bigU32(code))); };
    // With an inconsistent head the data stay, and are read as messages (7.4).
    if (size != u32At(item.payload, 16) || size >= kLargestImage) {
        answer(3);
        reader.putBack(item, kHead);
        return true;
    }
    if (offset != u32At(item.payload, 8) || offset >= kLargestImage) {
        answer(4);
        reader.putBack(item, kHead);
        return true;
    }
    const Bytes rest = item.payload.subspan(kHead);
    const Bytes data = rest.first(std::min<std::size_t>(size, rest.size()));
    reader.putBack(item, kHead + data.size());
    if (crc32c(data) != crc) {
        answer(2);
        return true;
    }
    if (offset == 0)
        m_upload.clear();
    if (m_upload.size() < qsizetype(offset + data.size()))
        m_upload.resize(qsizetype(offset + data.size()));
    std::copy(data.begin(), data.end(), reinterpret_cast<std::byte *>(m_upload.data()) + offset);
    answer(1);
    return true;
}

// Without a transmitter the byte behind the setters stays (6.6).
void SimulatedBoard::handleVtx(Message id, const DroneReader::Item &item, DroneReader &reader)
{
    const bool isThere = m_options.own.value(QLatin1String(kTransmitter), 1) != 0;
    if (!isThere) {
        reader.putBack(item);
        if (id == Message::VtxGetSettings)
            send(message(id, transmitter()));
        return;
    }
    const int value = item.payload.empty() ? 0 : std::to_integer<int>(item.payload[0]);
    if (id == Message::VtxSetPower)
        m_vtxPower = std::clamp(value, 0, 2);
    else if (id == Message::VtxSetChannel && value >= 1 && value <= 40)
        m_vtxChannel = value;
    const QByteArray now = transmitter();  // channel, MHz, power, dBm
    send(message(id,
                 id == Message::VtxGetSettings    ? now
                     : id == Message::VtxSetPower ? now.sliced(3, 2)
                                                  : now.first(3)));
}

}  // namespace bcflight
