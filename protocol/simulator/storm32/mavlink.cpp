// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// MAVLink of the simulated STorM32 board (document "Mavlink Communication", errata 6).
#include "protocol/base/angles.h"
#include "protocol/base/checksum.h"
#include "protocol/simulator/storm32/board.h"
#include "protocol/storm32/mavlinknames.h"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr double kBeatPeriod = 1.0;
constexpr double kAttitudePeriod = 0.5;
constexpr int kUint16 = 3;
constexpr int kInt16 = 4;
constexpr int kResultOk = 0;
constexpr int kResultUnsupported = 3;
constexpr qsizetype kMaxEmbedded = 253;
constexpr int kMagicRestore = 83;
constexpr int kInfo = 6;  // severity

int byIndex(const QVariantMap &values, const char *name)
{
    return values.value(QString::fromLatin1(name)).toInt();
}

}  // namespace

mavlink::ValueCoding SimulatedBoard::coding() const
{
    return m_options.firmware >= 91 ? mavlink::ValueCoding::Bits : mavlink::ValueCoding::Number;
}

mavlink::Address SimulatedBoard::address() const
{
    return {inUse(110) & 0xFF, inUse(111) & 0xFF};
}

std::optional<mavlink::Packet> SimulatedBoard::packetOf(Bytes frame)
{
    constexpr std::size_t kHead = 6;
    const auto at = [&frame](std::size_t i) { return std::to_integer<int>(frame[i]); };
    const mavlink::Message *message = mavlink::findMessage(at(5));
    if (!message)
        return {};
    const Bytes payload = frame.subspan(kHead, frame.size() - mavlink::kOverhead);
    const QByteArray covered = ByteWriter()
                                   .bytes(QByteArrayView(frame).sliced(1, qsizetype(frame.size()) - 3))
                                   .u8(message->crcExtra)
                                   .take();
    const bool isShort = payload.size() < std::size_t(message->size) && !message->variable;
    if (isShort || crc16Mcrf4xx(asBytes(covered)) != (at(frame.size() - 2) | at(frame.size() - 1) << 8))
        return {};
    return mavlink::Packet{at(5), at(2), {at(3), at(4)}, payload};
}

// Up to 0.90 a number is cut to 16 bits, then truncated (errata 13, row 9).
int SimulatedBoard::decode(float value) const
{
    if (coding() == mavlink::ValueCoding::Bits)
        return mavlink::decodeValue(value, coding());
    if (!(value > 0.0F))
        return 0;
    return int(qint64(std::min(value, 1e9F)) & 0xFFFF);
}

bool SimulatedBoard::isSigned(int index) const
{
    const auto it = std::find_if(m_parameters.all().begin(), m_parameters.all().end(),
                                 [index](const ParameterSpec &spec) { return spec.offset == 2 * index; });
    return it != m_parameters.all().end() ? it->row->wire == WireType::I16 : index < 38;
}

int SimulatedBoard::parameterIndex(const QString &id) const
{
    for (int word = 0; word < m_words; ++word) {
        if (mavlinkName(m_layout, word) == id)
            return word;
    }
    return 0;  // an unknown name is answered with the first parameter
}

void SimulatedBoard::sendMessage(mavlink::MessageId id, const QVariantMap &values)
{
    const auto payload = mavlink::encodeFields(*mavlink::findMessage(mavlink::number(id)), values);
    if (payload)
        reply(mavlink::encode(id, *payload, address(), m_sequence++));
}

void SimulatedBoard::sendParameter(int index)
{
    if (index < 0 || index >= m_words)
        index = 0;
    sendMessage(mavlink::MessageId::ParamValue,
                {{u"param_value"_s, mavlink::encodeValue(inUse(index), coding())},
                 {u"param_count"_s, m_words},
                 {u"param_index"_s, index},
                 {u"param_id"_s, mavlinkName(m_layout, index)},
                 {u"param_type"_s, isSigned(index) ? kInt16 : kUint16}});
}

void SimulatedBoard::sendParameter2(int index, const mavlink::Address &to)
{
    if (index < 0 || index >= m_words)
        index = 0;
    sendMessage(mavlink::MessageId::ParamValue2,
                {{u"param_value"_s, mavlink::encodeValue(inUse(index), coding())},
                 {u"param_index"_s, index},
                 {u"param_count"_s, m_words},
                 {u"target_system"_s, to.system},
                 {u"target_component"_s, to.component},
                 {u"param_type"_s, isSigned(index) ? kInt16 : kUint16}});
}

void SimulatedBoard::message(const mavlink::Packet &packet)
{
    const mavlink::Message *known = mavlink::findMessage(packet.id);
    // Without a target there is but the command (errata 13, row 11).
    if (known && known->id == mavlink::MessageId::TargetSpecific && packet.payload.size() < 2) {
        embedded(QByteArrayView(packet.payload), packet.from);
        return;
    }
    const auto fields
        = known ? mavlink::decodeFields(*known, packet.payload) : failure(ErrorCode::Unsupported);
    if (!fields)
        return;
    if (known->id == mavlink::MessageId::Heartbeat) {
        m_heardBeat = true;
        return;
    }
    // Frames for other targets are not answered, broadcasts included; but for one question to component 0
    // (errata 13, row 5).
    const mavlink::Address target{byIndex(*fields, "target_system"), byIndex(*fields, "target_component")};
    const bool isAsked = known->id == mavlink::MessageId::ParamRequestRead && target.component == 0
        && target.system == address().system;
    if (target != address() && !isAsked)
        return;
    switch (known->id) {
    case mavlink::MessageId::ParamRequestRead: {
        const int index = byIndex(*fields, "param_index");
        sendParameter(index == -1 ? parameterIndex(fields->value(u"param_id"_s).toString()) : index);
        break;
    }
    case mavlink::MessageId::ParamRequestList:
        for (int word = 0; word < m_words; ++word)
            sendParameter(word);
        break;
    case mavlink::MessageId::ParamSet: {
        // An unknown name writes the first parameter (errata 13, row 6).
        const int index = parameterIndex(fields->value(u"param_id"_s).toString());
        set(index, decode(fields->value(u"param_value"_s).toFloat()));
        sendParameter(index);
        break;
    }
    case mavlink::MessageId::ParamRead2: sendParameter2(byIndex(*fields, "param_index"), packet.from); break;
    case mavlink::MessageId::ParamSet2: {
        const int asked = byIndex(*fields, "param_index");
        const int index = asked >= 0 && asked < m_words ? asked : 0;  // errata 13, row 6
        set(index, decode(fields->value(u"param_value"_s).toFloat()));
        sendParameter2(index, packet.from);
        break;
    }
    case mavlink::MessageId::CommandLong: {
        std::array<float, 7> parameters{};
        for (std::size_t i = 0; i < parameters.size(); ++i)
            parameters[i] = fields->value(u"param%1"_s.arg(i + 1)).toFloat();
        const int id = byIndex(*fields, "command");
        if (id == 1234 && m_options.firmware >= 94) {
            m_attitudeAsked = true;  // a single one, in place of an ack
            break;
        }
        const int result = command(id, parameters);
        sendMessage(mavlink::MessageId::CommandAck, {{u"command"_s, id}, {u"result"_s, result}});
        break;
    }
    case mavlink::MessageId::MountConfigure:
        if (byIndex(*fields, "mount_mode") == 1)
            std::ignore = rc(int(Rc::SetPitchRollYaw), QByteArray(6, '\0'));
        break;
    case mavlink::MessageId::MountControl: {
        const unsigned flags = unsigned(byIndex(*fields, "save_position"));
        std::array<double, 3> values{};
        for (std::size_t i = 0; i < 3; ++i)
            values[i] = fields->value(QStringList{u"input_a"_s, u"input_b"_s, u"input_c"_s}[qsizetype(i)])
                            .toDouble();
        if (flags & 0x10) {
            for (std::size_t i = 0; i < 3; ++i)
                steer(std::array<std::size_t, 3>{1, 0, 2}[i], int(values[i]));
        } else {
            mountControl({values[0] / 100.0, values[1] / 100.0, values[2] / 100.0}, flags >> 1 & 7);
        }
        break;
    }
    case mavlink::MessageId::TargetSpecific:
        embedded(fields->value(u"specific_payload"_s).toByteArray(), packet.from);
        break;
    default: break;  // executed without an answer, or for another target
    }
}

int SimulatedBoard::command(int id, const std::array<float, 7> &parameters)
{
    const auto number = [&parameters](std::size_t i) {
        return std::isfinite(parameters[i]) ? int(std::clamp(parameters[i], -1e6F, 1e6F)) : 0;
    };
    switch (id) {
    case 180: {  // DO_SET_PARAMETER
        const int word = number(0);
        if (word >= 0 && word < m_words)
            set(word,
                number(6) == kMagicRestore ? stored(word) : std::max(0, number(1)));  // errata 13, row 8
        return kResultOk;
    }
    case 183:  // DO_SET_SERVO
        std::ignore = rc(int(Rc::SetPwmOut), ByteWriter().u16(number(1)).take());
        return kResultOk;
    case 203:  // DO_DIGICAM_CONTROL
    case 220:  // DO_MOUNT_CONTROL_QUAT
        return kResultOk;
    case 204:  // DO_MOUNT_CONFIGURE
        if (number(0) == 1)
            std::ignore = rc(int(Rc::SetPitchRollYaw), QByteArray(6, '\0'));
        return kResultOk;
    case 205: {  // DO_MOUNT_CONTROL
        const unsigned flags = unsigned(number(5));
        if (flags & 0x0100) {
            for (std::size_t i = 0; i < 3; ++i)
                steer(std::array<std::size_t, 3>{1, 0, 2}[i], number(i));
        } else {
            mountControl({double(parameters[0]), double(parameters[1]), double(parameters[2])}, flags & 7);
        }
        return kResultOk;
    }
    case 245:  // PREFLIGHT_STORAGE
        if (number(0) == 1)
            std::ignore = simple(Simple::Store, {});
        else if (number(0) == 0)
            std::ignore = simple(Simple::Retrieve, {});
        return kResultOk;
    default: return kResultUnsupported;
    }
}

// Simple commands are embedded unchanged, RC commands as FA, number, payload; the same applies to answers,
// where RC has no length and no checksum.
void SimulatedBoard::embedded(QByteArrayView content, const mavlink::Address &from)
{
    QByteArray answer;
    if (content.isEmpty()) {
        answer = "e";
    } else if (content == QByteArrayView("\xFA")) {
        answer = QByteArray("\xFB\x96\x03");
    } else if (std::uint8_t(content[0]) == 0xFA) {
        const auto [id, payload] = rc(std::uint8_t(content[1]), content.sliced(2));
        answer = ByteWriter().u8(0xFB).u8(id).bytes(payload).take();
    } else if (const SimpleCommand *command = findSimple(asBytes(content))) {
        const auto letters = qsizetype(qstrlen(command->letters));
        const qsizetype arguments = command->argumentBytes < 0 ? m_ram.size() : command->argumentBytes;
        const QByteArrayView data = content.sliced(letters);
        if (data.size() < (arguments ? arguments + 2 : 0))
            answer = "t";
        else
            answer = simple(command->id, data.first(arguments));
        // 2 + 381 bytes overflow the length byte: only the remainder modulo 256 arrives (errata 6).
        if (answer.size() > kMaxEmbedded)
            answer.truncate(((answer.size() + 2) & 0xFF) - 2);
    } else {
        answer = "e";
    }
    sendMessage(mavlink::MessageId::TargetSpecificAck,
                {{u"target_system"_s, from.system},
                 {u"target_component"_s, from.component},
                 {u"specific_payload"_s, answer}});
}

// Unsolicited messages of the board.
void SimulatedBoard::beat()
{
    const bool asked = std::exchange(m_attitudeAsked, false);
    if (inUse(kHeartbeatWord) == 0 && !asked) {
        m_nextBeat = m_now;
        m_nextAttitude = m_now;
        m_isBeating = false;
        return;
    }
    // Who it is comes first (errata 13, row 4).
    if (inUse(kHeartbeatWord) != 0 && !std::exchange(m_isBeating, true)) {
        const QByteArray version = versionData();
        const auto text = [&version](int at) {
            const QByteArray padded = version.mid(at, 16);
            const qsizetype end = padded.indexOf('\0');
            return QString::fromLatin1(end < 0 ? padded : padded.first(end)).trimmed();
        };
        for (const QString &line : {u"SToRM32 %1 %2"_s.arg(text(0), text(32)), text(16)})
            sendMessage(mavlink::MessageId::StatusText, {{u"severity"_s, kInfo}, {u"text"_s, line}});
    }
    const int state = this->state();
    if (inUse(kHeartbeatWord) != 0 && m_now >= m_nextBeat) {
        m_nextBeat = m_now + kBeatPeriod;
        sendMessage(mavlink::MessageId::Heartbeat,
                    {{u"custom_mode"_s, state},
                     {u"type"_s, 26},
                     {u"autopilot"_s, 0x53},
                     {u"base_mode"_s, state == 6 ? 0x80 : 0},
                     {u"system_status"_s, state == 6 ? 4 : 1},
                     {u"mavlink_version"_s, 3}});
    }
    if (asked || (inUse(kHeartbeatWord) >= 2 && m_heardBeat && m_now >= m_nextAttitude)) {
        m_nextAttitude = m_now + kAttitudePeriod;
        // Pitch up is positive here; yaw and the rates are always zero.
        sendMessage(mavlink::MessageId::Attitude,
                    {{u"time_boot_ms"_s, uint((m_now - m_started) * 1000.0)},
                     {u"roll"_s, float(radians(-m_stabilizer.estimate(Axis::Roll)))},
                     {u"pitch"_s, float(radians(-m_stabilizer.estimate(Axis::Pitch)))}});
    }
}

}  // namespace storm32
