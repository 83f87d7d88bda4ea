// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Inspection: frames in readable form, commands by name.
#include "protocol/base/checksum.h"
#include "protocol/base/hexbytes.h"
#include "protocol/storm32/device.h"
#include "protocol/storm32/mavlinknames.h"
#include "protocol/storm32/parametertables.h"
#include "protocol/storm32/telemetrytables.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace storm32 {

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
    case Simple::RawSensors: return ActionRisk::Safe;
    case Simple::Level:
    case Simple::Restart:
    case Simple::HardReset: return ActionRisk::Moves;
    case Simple::EraseEeprom:
    case Simple::Defaults:
    case Simple::Retrieve: return ActionRisk::Destroys;
    default: return ActionRisk::Writes;
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
    case Rc::DoCamera: return ActionRisk::Safe;
    case Rc::SetParameter:
    case Rc::RestoreParameter:
    case Rc::RestoreAllParameters: return ActionRisk::Writes;
    default: return ActionRisk::Moves;
    }
}

// A parameter by its number, with its value in readable form.
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

// "pitch=30 roll=0", in wire order.
QString fieldsText(NamedFields fields, const QVariantMap &values)
{
    QStringList parts;
    for (const NamedField &field : fields) {
        const QVariant value = values.value(QString::fromLatin1(field.name));
        const bool command = qstrcmp(field.name, "command") == 0;
        parts.append(QString::fromLatin1(field.name) + u'='
                     + (field.type == NamedField::Bytes ? hexOf(value.toByteArray())
                            : command                   ? mavlink::commandName(value.toInt())
                                                        : value.toString()));
    }
    return parts.join(u' ');
}

QString liveFields(Bytes data)
{
    const auto row = liveRow(data, LiveScales(96));
    return u"state %1, pitch %2°, roll %3°, yaw %4°, %5 V"_s.arg(int(row[State]))
        .arg(double(row[AnglePitch]), 0, 'f', 2)
        .arg(double(row[AngleRoll]), 0, 'f', 2)
        .arg(double(row[AngleYaw]), 0, 'f', 2)
        .arg(double(row[Voltage]), 0, 'f', 2);
}

// A frame of the RC set, as a command or as a board's answer; null stands for an unknown one.
FrameText rcText(const RcCommand *known, int id, Bytes payload, bool answer, const ParameterSet *parameters)
{
    const QString name = known ? QString::fromLatin1(known->name) : u"RC %1"_s.arg(id);
    const NamedFields fields = !known ? NamedFields() : answer ? known->answer : known->fields;
    const auto values = decodeFields(fields, payload);
    if (!known || fields.empty() || !values)
        return {name, hexOf(toByteArray(payload))};
    if (known->id == Rc::Ack) {
        const auto error = ackError(values->value(u"code"_s).toInt(), u"ack"_s);
        return {name, error ? error->detail : u"ok"_s, error.has_value()};
    }
    if (known->id == Rc::GetData && answer && payload.size() == 66)
        return {name, liveFields(payload.subspan(2))};
    if (values->contains(u"index"_s) && values->contains(u"value"_s))
        return {name,
                wordText(parameters, values->value(u"index"_s).toInt(), values->value(u"value"_s).toInt())};
    return {name, fieldsText(fields, *values)};
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

// A command or an answer of the other sets inside MAVLink: FA or FB, number and payload, or the bytes of a
// simple command (errata 6).
QString embeddedText(Bytes inner, const ParameterSet *parameters)
{
    if (inner.size() >= 2 && (inner[0] == std::byte{0xFA} || inner[0] == std::byte{0xFB})) {
        const bool answer = inner[0] == std::byte{0xFB};
        const int id = std::to_integer<int>(inner[1]);
        const Bytes payload = inner.subspan(2);
        const FrameText text
            = rcText(answer ? findRcAnswer(id, payload) : findRc(id), id, payload, answer, parameters);
        return text.name + u' ' + text.fields;
    }
    return hexOf(toByteArray(inner));
}

QString mavlinkFields(const mavlink::Message &message, Bytes payload, const ParameterSet *parameters)
{
    const auto fields = mavlink::decodeFields(message, payload);
    if (!fields)
        return fields.error().detail;
    if (message.variable)
        return embeddedText(payload.subspan(std::size_t(message.size)), parameters);
    return fieldsText(message.fields, *fields);
}

// What is typed after the name of a command of the RC set.
QString afterName(const RcCommand &command)
{
    QStringList names;
    for (const NamedField &field : command.fields)
        names.append(QString::fromLatin1(field.name) + u"=…"_s);
    const QString bytes
        = u"after %1 come %2 bytes in hex"_s.arg(QLatin1String(command.name)).arg(command.payloadBytes);
    return names.isEmpty() ? bytes : u"%1, or %2"_s.arg(bytes, names.join(u' '));
}

// "pitch=10 yaw=-5"
Result<QByteArray> payloadByNames(const RcCommand &command, const QString &arguments)
{
    static const QRegularExpression blanks(u"\\s+"_s);
    QVariantMap values;
    for (const QString &argument : arguments.split(blanks, Qt::SkipEmptyParts)) {
        if (argument.count(u'=') != 1)
            return failure(ErrorCode::InvalidArgument, afterName(command));
        values.insert(argument.section(u'=', 0, 0).toLower(), argument.section(u'=', 1));
    }
    const auto payload = encodeFields(command.fields, values, command.payloadBytes);
    if (!payload)
        return failure(
            payload.error().code,
            u"%1: %2; %3"_s.arg(QLatin1String(command.name), payload.error().detail, afterName(command)));
    return payload;
}

Result<QByteArray> payloadByHex(const RcCommand &command, const QString &arguments)
{
    const auto payload = bytesFromHex(arguments);
    if (!payload || payload->size() != command.payloadBytes)
        return failure(ErrorCode::InvalidArgument, afterName(command));
    return *payload;
}

}  // namespace

FrameText Device::describeFrame(const FrameView &frame, bool fromBoard) const
{
    if (frame.id >= FrameId::kMavlink) {
        const mavlink::Message *message = mavlink::findMessage(frame.id - FrameId::kMavlink);
        return message ? FrameText{QString::fromLatin1(message->name),
                                   mavlinkFields(*message, frame.payload, m_parameters.get())}
                       : FrameText{u"MAVLink %1"_s.arg(frame.id - FrameId::kMavlink), {}};
    }
    if (frame.id >= FrameId::kRc) {
        const int id = frame.id - FrameId::kRc;
        const RcCommand *known = fromBoard ? findRcAnswer(id, frame.payload) : findRc(id);
        return rcText(known, id, frame.payload, fromBoard, m_parameters.get());
    }
    if (frame.id >= FrameId::kSimple) {
        const auto id = Simple(frame.id - FrameId::kSimple);
        return {QString::fromLatin1(simpleCommand(id).letters), simpleFields(id, frame.payload)};
    }
    switch (frame.id) {
    case 'o': return {u"o"_s, u"ok"_s};
    case 'e': return {u"e"_s, u"unknown command"_s, true};
    case 't': return {u"t"_s, u"arrived in pieces"_s, true};
    case 'c': return {u"c"_s, u"wrong checksum"_s, true};
    default: return {u"?"_s, {}};
    }
}

FrameText Device::describeSent(QByteArrayView bytes) const
{
    if (bytes.isEmpty())
        return {u"?"_s, {}};
    const auto first = std::uint8_t(bytes[0]);
    if (first == 0xFA && bytes.size() >= 5) {
        const int id = std::uint8_t(bytes[2]);
        return rcText(findRc(id), id, asBytes(bytes.sliced(3, bytes.size() - 5)), false, m_parameters.get());
    }
    if (const mavlink::Sighting seen = mavlink::sight(asBytes(bytes)); seen.look == mavlink::Look::Complete)
        return describeFrame({FrameId::kMavlink + seen.packet.id, seen.packet.payload}, false);
    if (const SimpleCommand *command = findSimple(asBytes(bytes))) {
        return {QString::fromLatin1(command->letters),
                QString::fromLatin1(command->name)
                    + (bytes.size() > 8 ? u", %1 bytes"_s.arg(bytes.size()) : QString())};
    }
    return {u"?"_s, hexOf(bytes)};
}

bool Device::isTelemetryFrame(int id) const
{
    return id == FrameId::kSimple + int(Simple::LiveData) || id == FrameId::kRc + int(Rc::GetData)
        || id == kMavlinkBeat || id == FrameId::kMavlink + mavlink::number(mavlink::MessageId::Attitude);
}

namespace {

constexpr int kUnlistedLayout = 89;
constexpr int kDoSetParameter = 180;  // a command of COMMAND_LONG

// A command for a parameter that is not there is confirmed and nothing is done (errata 4 and 6). Errors:
// InvalidArgument.
Result<void> checkWord(int word, int words)
{
    if (words == 0 || (word >= 0 && word < words))
        return {};
    return failure(
        ErrorCode::InvalidArgument,
        u"this board has no parameter %1, its last is %2; it would confirm the command and do nothing"_s
            .arg(word)
            .arg(words - 1));
}

int wordFrom(double number)
{
    return std::isfinite(number) ? int(std::clamp(number, -1.0, 65535.0)) : -1;
}

Result<void> checkRc(int id, Bytes payload, int words)
{
    const bool names
        = id == int(Rc::GetParameter) || id == int(Rc::SetParameter) || id == int(Rc::RestoreParameter);
    return names && payload.size() >= 2 ? checkWord(ByteReader(payload).u16(), words) : Result<void>();
}

// The firmware writes its first parameter where it does not know the one that is meant (errata 13, row 6).
// Errors: InvalidArgument.
Result<void> checkParameter(const mavlink::Packet &packet, int layout, int words)
{
    const mavlink::Message *message = mavlink::findMessage(packet.id);
    const auto fields = mavlink::decodeFields(*message, packet.payload);
    if (!fields)
        return tl::unexpected(fields.error());
    if (message->id == mavlink::MessageId::ParamSet) {
        const QString name = fields->value(u"param_id"_s).toString();
        // Of this layout no list of names was ever seen; those of its neighbour are only likely.
        if (layout == kUnlistedLayout)
            return failure(ErrorCode::InvalidArgument,
                           u"a name that this board does not know would set its first parameter, and its "
                           "names are not known for certain: use PARAM_SET2 with the number"_s);
        for (int word = 0; word < words; ++word) {
            if (mavlinkName(layout, word) == name)
                return {};
        }
        return failure(ErrorCode::InvalidArgument,
                       u"this board has no parameter '%1' and would set its first one"_s.arg(name));
    }
    if (message->id == mavlink::MessageId::CommandLong
        && fields->value(u"command"_s).toInt() == kDoSetParameter)
        return checkWord(wordFrom(fields->value(u"param1"_s).toDouble()), words);
    if (message->id == mavlink::MessageId::TargetSpecific && packet.payload.size() >= 4
        && packet.payload[2] == std::byte{0xFA})
        return checkRc(std::to_integer<int>(packet.payload[3]), packet.payload.subspan(4), words);
    const int index = fields->value(u"param_index"_s).toInt();
    if (message->id == mavlink::MessageId::ParamSet2 && (index < 0 || index >= words))
        return failure(ErrorCode::InvalidArgument,
                       u"this board has no parameter %1 and would set its first one"_s.arg(index));
    return {};
}

}  // namespace

// "d", "xs", "GETPARAMETER 2F00", "SETANGLE pitch=10 yaw=-5" or a whole frame in hex.
Result<RawCommand> Device::parseCommand(const QString &text) const
{
    const QString trimmed = text.trimmed();
    if (trimmed.isEmpty())
        return failure(ErrorCode::InvalidArgument, u"nothing to send"_s);
    const QString name = trimmed.section(QRegularExpression(u"\\s"_s), 0, 0);
    for (const SimpleCommand &command : simpleCommands()) {
        if (name != QLatin1String(command.letters))  // letters are case sensitive
            continue;
        const auto arguments = bytesFromHex(trimmed.mid(name.size()));
        const int wanted = command.argumentBytes < 0 ? 2 * m_words + kScriptArea : command.argumentBytes;
        if (!arguments || arguments->size() != wanted)
            return failure(ErrorCode::InvalidArgument,
                           u"after %1 come %2 bytes in hex"_s.arg(name).arg(wanted));
        return RawCommand{name, simple(command.id, *arguments).bytes, riskOf(command.id)};
    }
    for (const RcCommand &command : rcCommands()) {
        if (name.compare(QLatin1String(command.name), Qt::CaseInsensitive) != 0)
            continue;
        const QString arguments = trimmed.mid(name.size());
        const bool isNamed = arguments.contains(u'=');
        const auto payload = isNamed ? payloadByNames(command, arguments) : payloadByHex(command, arguments);
        if (!payload)
            return tl::unexpected(payload.error());
        if (const auto known = checkRc(int(command.id), asBytes(*payload), m_words); !known)
            return tl::unexpected(known.error());
        return RawCommand{name.toUpper(), rc(command.id, *payload).bytes, riskOf(command.id)};
    }
    const auto whole = bytesFromHex(trimmed);
    if (!whole || whole->isEmpty())
        return failure(ErrorCode::InvalidArgument, u"there is no command '%1'"_s.arg(name));
    const Bytes bytes = asBytes(*whole);
    if (bytes[0] == std::byte{0xFA} && whole->size() >= 5 && std::uint8_t((*whole)[1]) + 5 == whole->size()
        && crc16Mcrf4xx(bytes.subspan(1)) == 0) {
        if (const auto there
            = checkRc(std::to_integer<int>(bytes[2]), bytes.subspan(3, bytes.size() - 5), m_words);
            !there)
            return tl::unexpected(there.error());
        const RcCommand *known = findRc(std::uint8_t((*whole)[2]));
        return RawCommand{describeSent(*whole).name, *whole,
                          known ? riskOf(known->id) : ActionRisk::Destroys};
    }
    if (const auto seen = mavlink::sight(bytes);
        seen.look == mavlink::Look::Complete && seen.size == bytes.size()) {
        if (const auto known = checkParameter(seen.packet, m_identity.firmwareNumber, m_words); !known)
            return tl::unexpected(known.error());
        return RawCommand{describeSent(*whole).name, *whole, ActionRisk::Destroys};
    }
    return failure(ErrorCode::InvalidArgument,
                   u"these bytes are not one complete frame with valid checksums"_s);
}

QStringList Device::commandNames() const
{
    QStringList names;
    for (const SimpleCommand &command : simpleCommands())
        names.append(QString::fromLatin1(command.letters));
    for (const RcCommand &command : rcCommands())
        names.append(QString::fromLatin1(command.name));
    return names;
}

}  // namespace storm32
