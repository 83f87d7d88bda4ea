// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Looking inside: frames in words, commands by name.
#include "protocol/base/checksum.h"
#include "protocol/base/hexbytes.h"
#include "protocol/storm32/parametertables.h"
#include "protocol/storm32/stormdevice.h"
#include "protocol/storm32/telemetrytables.h"

#include <QRegularExpression>

#include <algorithm>

using namespace Qt::StringLiterals;
using namespace storm32;

namespace {

constexpr int kMavlinkBeat = FrameId::kMavlink;

QString hexOf(QByteArrayView bytes)
{
    return QString::fromLatin1(bytes.toByteArray().toHex(' '));
}

// What a command does to the gimbal when it is sent by hand.
ActionRisk riskOf(Simple id)
{
    switch (id) {
    case Simple::Test:
    case Simple::Version:
    case Simple::GetParameters:
    case Simple::LiveData:
    case Simple::Status:
    case Simple::ReadCalibration:
    case Simple::RawSensors:
        return ActionRisk::Safe;
    case Simple::Level:
    case Simple::Restart:
    case Simple::HardReset:
        return ActionRisk::Moves;
    case Simple::EraseEeprom:
    case Simple::Defaults:
    case Simple::Retrieve:
        return ActionRisk::Destroys;
    default:
        return ActionRisk::Writes;
    }
}

ActionRisk riskOf(Rc id)
{
    switch (id) {
    case Rc::GetVersion:
    case Rc::GetVersionStrings:
    case Rc::GetParameter:
    case Rc::GetData:
    case Rc::GetDataFields:
    case Rc::DoCamera:
        return ActionRisk::Safe;
    case Rc::SetParameter:
    case Rc::RestoreParameter:
    case Rc::RestoreAllParameters:
        return ActionRisk::Writes;
    default:
        return ActionRisk::Moves;
    }
}

QString rcName(int id)
{
    const RcCommand *known = findRc(id);
    return known ? QString::fromLatin1(known->name) : id == int(Rc::Ack) ? u"ACK"_s : u"RC %1"_s.arg(id);
}

// A parameter by its number, with its value in words.
QString wordText(const ParameterSet *parameters, int word, int raw)
{
    if (parameters) {
        for (const ParameterSpec &spec : parameters->all()) {
            if (spec.offset == 2 * word) {
                const int value = spec.row->wire == WireType::I16 ? int(std::int16_t(raw)) : raw;
                return u"%1 = %2"_s.arg(spec.key, spec.format(value));
            }
        }
    }
    return u"word %1 = %2"_s.arg(word).arg(raw);
}

QString rcFields(int id, QByteArrayView payload, bool fromBoard, const ParameterSet *parameters)
{
    ByteReader reader(payload);
    if (id == int(Rc::Ack) && payload.size() == 1) {
        const auto error = ackError(std::uint8_t(payload[0]), u"ack"_s);
        return error ? error->detail : u"ok"_s;
    }
    if ((id == int(Rc::SetParameter) && payload.size() == 4) || (id == int(Rc::GetParameter) && fromBoard && payload.size() == 4)) {
        const int word = reader.u16();
        return wordText(parameters, word, reader.u16());
    }
    if (id == int(Rc::SetAngle) && payload.size() == 14) {
        const double pitch = double(reader.f32());
        const double roll = double(reader.f32());
        const double yaw = double(reader.f32());
        return u"pitch %1°, roll %2°, yaw %3°, flags %4"_s.arg(pitch).arg(roll).arg(yaw).arg(reader.u8());
    }
    return hexOf(payload);
}

QString liveFields(Bytes data)
{
    const auto row = liveRow(data, LiveScales(96));
    return u"state %1, pitch %2°, roll %3°, yaw %4°, %5 V"_s.arg(int(row[State]))
        .arg(double(row[AnglePitch]), 0, 'f', 2).arg(double(row[AngleRoll]), 0, 'f', 2).arg(double(row[AngleYaw]), 0, 'f', 2)
        .arg(double(row[Voltage]), 0, 'f', 2);
}

QString simpleFields(Simple id, Bytes data)
{
    if (id == Simple::LiveData && data.size() == 64)
        return liveFields(data);
    if (id == Simple::Version && data.size() == 54) {
        ByteReader numbers(data.subspan(48));
        const int firmware = numbers.u16();
        return u"firmware %1, layout %2"_s.arg(firmware).arg(numbers.u16());
    }
    if (id == Simple::Status && data.size() >= 10) {
        ByteReader words(data);
        const int state = words.u16();
        const int status = words.u16();
        return u"state %1, status 0x%2"_s.arg(state).arg(status, 4, 16, QChar(u'0'));
    }
    return u"%1 bytes"_s.arg(data.size());
}

QString mavlinkFields(const mavlink::Message &message, Bytes payload)
{
    const auto fields = mavlink::decodeFields(message, payload);
    if (!fields)
        return fields.error().detail;
    QStringList parts;
    for (const mavlink::Field &field : message.fields) {
        const QVariant value = fields->value(QString::fromLatin1(field.name));
        const bool command = qstrcmp(field.name, "command") == 0;
        parts.append(QString::fromLatin1(field.name) + u'='
                     + (field.type == mavlink::Field::Bytes ? hexOf(value.toByteArray())
                        : command ? mavlink::commandName(value.toInt()) : value.toString()));
    }
    return parts.join(u' ');
}

} // namespace

FrameText StormDevice::describeFrame(const FrameView &frame, bool fromBoard) const
{
    if (frame.id >= FrameId::kMavlink) {
        const mavlink::Message *message = mavlink::findMessage(frame.id - FrameId::kMavlink);
        return message ? FrameText{QString::fromLatin1(message->name), mavlinkFields(*message, frame.payload)}
                       : FrameText{u"MAVLink %1"_s.arg(frame.id - FrameId::kMavlink), {}};
    }
    if (frame.id >= FrameId::kRc) {
        const int id = frame.id - FrameId::kRc;
        if (id == int(Rc::GetData) && frame.payload.size() == 66)
            return {rcName(id), liveFields(frame.payload.subspan(2))};
        return {rcName(id), rcFields(id, toByteArray(frame.payload), fromBoard, m_parameters.get())};
    }
    if (frame.id >= FrameId::kSimple) {
        const auto id = Simple(frame.id - FrameId::kSimple);
        return {QString::fromLatin1(simpleCommand(id).letters), simpleFields(id, frame.payload)};
    }
    switch (frame.id) {
    case 'o': return {u"o"_s, u"ok"_s};
    case 'e': return {u"e"_s, u"unknown command"_s};
    case 't': return {u"t"_s, u"arrived in pieces"_s};
    case 'c': return {u"c"_s, u"wrong checksum"_s};
    default: return {u"?"_s, {}};
    }
}

FrameText StormDevice::describeSent(QByteArrayView bytes) const
{
    if (bytes.isEmpty())
        return {u"?"_s, {}};
    const auto first = std::uint8_t(bytes[0]);
    if (first == 0xFA && bytes.size() >= 5) {
        const int id = std::uint8_t(bytes[2]);
        return {rcName(id), rcFields(id, bytes.sliced(3, bytes.size() - 5), false, m_parameters.get())};
    }
    if (const mavlink::Sighting seen = mavlink::sight(asBytes(bytes)); seen.look == mavlink::Look::Complete)
        return describeFrame({FrameId::kMavlink + seen.packet.id, seen.packet.payload}, false);
    if (const SimpleCommand *command = findSimple(asBytes(bytes))) {
        return {QString::fromLatin1(command->letters),
                QString::fromLatin1(command->name) + (bytes.size() > 8 ? u", %1 bytes"_s.arg(bytes.size()) : QString())};
    }
    return {u"?"_s, hexOf(bytes)};
}

bool StormDevice::isTelemetryFrame(int id) const
{
    return id == FrameId::kSimple + int(Simple::LiveData) || id == FrameId::kRc + int(Rc::GetData) || id == kMavlinkBeat
        || id == FrameId::kMavlink + mavlink::number(mavlink::MessageId::Attitude);
}

// "d", "xs", "GETPARAMETER 2F00" or the whole of a frame in hex.
Result<RawCommand> StormDevice::parseCommand(const QString &text) const
{
    const QString trimmed = text.trimmed();
    if (trimmed.isEmpty())
        return failure(ErrorCode::InvalidArgument, u"nothing to send"_s);
    const QString name = trimmed.section(QRegularExpression(u"\\s"_s), 0, 0);
    for (const SimpleCommand &command : simpleCommands()) {
        if (name != QLatin1String(command.letters))   // letters are case sensitive
            continue;
        const auto arguments = bytesFromHex(trimmed.mid(name.size()));
        const int wanted = command.argumentBytes < 0 ? 2 * m_words + kScriptArea : command.argumentBytes;
        if (!arguments || arguments->size() != wanted)
            return failure(ErrorCode::InvalidArgument, u"after %1 come %2 bytes in hex"_s.arg(name).arg(wanted));
        return RawCommand{name, simple(command.id, *arguments).bytes, riskOf(command.id)};
    }
    for (const RcCommand &command : rcCommands()) {
        if (name.compare(QLatin1String(command.name), Qt::CaseInsensitive) != 0)
            continue;
        const auto payload = bytesFromHex(trimmed.mid(name.size()));
        if (!payload || payload->size() != command.payloadBytes)
            return failure(ErrorCode::InvalidArgument, u"after %1 come %2 bytes in hex"_s.arg(name.toUpper()).arg(command.payloadBytes));
        return RawCommand{name.toUpper(), rc(command.id, *payload).bytes, riskOf(command.id)};
    }
    const auto whole = bytesFromHex(trimmed);
    if (!whole || whole->isEmpty())
        return failure(ErrorCode::InvalidArgument, u"there is no command '%1'"_s.arg(name));
    const Bytes bytes = asBytes(*whole);
    if (bytes[0] == std::byte{0xFA} && whole->size() >= 5 && std::uint8_t((*whole)[1]) + 5 == whole->size()
        && crc16Mcrf4xx(bytes.subspan(1)) == 0) {
        const RcCommand *known = findRc(std::uint8_t((*whole)[2]));
        return RawCommand{describeSent(*whole).name, *whole, known ? riskOf(known->id) : ActionRisk::Destroys};
    }
    if (const auto seen = mavlink::sight(bytes); seen.look == mavlink::Look::Complete && seen.size == bytes.size())
        return RawCommand{describeSent(*whole).name, *whole, ActionRisk::Destroys};
    return failure(ErrorCode::InvalidArgument, u"these bytes are not one complete frame with valid checksums"_s);
}

QStringList StormDevice::commandNames() const
{
    QStringList names;
    for (const SimpleCommand &command : simpleCommands())
        names.append(QString::fromLatin1(command.letters));
    for (const RcCommand &command : rcCommands())
        names.append(QString::fromLatin1(command.name));
    return names;
}
