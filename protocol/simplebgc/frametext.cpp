// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/frametext.h"

#include "protocol/base/hexbytes.h"
#include "protocol/simplebgc/adjustables.h"
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/framer.h"
#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/payloads.h"
#include "protocol/simplebgc/steeringmodes.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simplebgc/units.h"

#include <QRegularExpression>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kCalibCogging = 93;
constexpr std::array<const char *, 3> kAxisLetters{"R", "P", "Y"};

ActionRisk riskOf(int id, const QByteArray &payload)
{
    if (id == number(CommandId::ExecuteMenu) && !payload.isEmpty()) {
        const int action = std::uint8_t(payload.front());
        for (const MenuEffect &effect : kMenuEffects) {
            if (effect.action == action)
                return effect.destroys ? ActionRisk::Destroys : ActionRisk::Writes;
        }
        const bool isKnown = std::any_of(std::begin(kMenuActions), std::end(kMenuActions),
                                         [action](const Choice &choice) { return choice.value == action; });
        return !isKnown ? ActionRisk::Destroys : action == 0 ? ActionRisk::Safe : ActionRisk::Moves;
    }
    // Whoever only asks sets nothing.
    const bool asks = !payload.isEmpty() && !(std::uint8_t(payload.front()) & 1U);
    if (id == number(CommandId::AhrsHelper) && asks)
        return ActionRisk::Safe;
    const MessageSpec *message = findMessage(id);
    return message ? message->risk : ActionRisk::Destroys;
}

QString menuName(int action)
{
    for (const Choice &choice : kMenuActions) {
        if (choice.value == action)
            return QLatin1String(choice.name);
    }
    return u"menu %1"_s.arg(action);
}

QString blockText(int block, Bytes payload, const ParameterSet *parameters)
{
    const QByteArray bytes = toByteArray(payload);
    QStringList parts{u"profile %1"_s.arg(int(quint8(bytes[0])) + 1)};
    if (parameters && bytes.size() > 1) {
        for (const ParameterSpec &spec : parameters->all()) {
            if (spec.row->block != block || spec.row->state)
                continue;
            if (const auto raw = spec.read(bytes))
                parts.append(spec.key + u' ' + spec.format(*raw));
        }
    }
    return parts.join(u", "_s);
}

QString fieldsText(Fields fields, Bytes payload)
{
    QStringList parts;
    for (const FieldValue &value : decodeFields(fields, payload)) {
        const bool isFlag = value.bits && value.bits->count == 1;
        if (!isFlag)
            parts.append(value.name + u' ' + value.text());
        else if (value.number != 0)
            parts.append(value.name);
    }
    return parts.join(u", "_s);
}

// By the table of commands.
QString messageText(int id, Bytes payload, bool fromBoard, int firmware)
{
    const MessageSpec *known = findMessage(id);
    if (!known)
        return {};
    if (!known->isPublic && !payload.empty())
        return u"its layout is not public"_s;
    const MessageSpec message = asOf(*known, firmware);
    const auto &fields = fromBoard ? message.fromBoard : message.toBoard;
    return fields ? fieldsText(*fields, payload) : QString();
}

// Of CONTROL, as the actions name them.
QString modeName(int mode)
{
    if (mode == NoControl)
        return u"not controlled"_s;
    if (mode == Ignore)
        return u"left alone"_s;
    for (const SteeringMode &known : steeringModes(kAnyFirmware)) {
        if (known.id == mode)
            return QLatin1String(known.key);
    }
    return u"mode %1"_s.arg(mode);
}

// What is asked for, or started (document READ_PARAMS_3): any number above 4 is the active one.
QString profileText(int profile)
{
    return profile < kProfileCount ? u"profile %1"_s.arg(profile + 1) : u"the active profile"_s;
}

// Errata 3.23.
QString defaultsText(int scope)
{
    return scope == 253 ? u"everything, the memory is erased"_s
        : scope == 255  ? u"all profiles"_s
                        : profileText(scope);
}

QString controlText(Bytes payload)
{
    const auto command = decodeControl(payload);
    if (!command)
        return {};
    QStringList parts;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const ControlAxis &wanted = (*command)[axis];
        const int mode = wanted.mode & 0x0F;
        const double unit = wanted.mode & ControlHighResSpeed ? kFineSpeedUnit : kControlSpeedUnit;
        const bool isSignal = mode == Rc || mode == RcHighRes;
        QString text = u"%1: %2"_s.arg(QLatin1String(kAxisLetters[axis]), modeName(mode));
        if (mode != NoControl && mode != Ignore && !isSignal)
            text += u" %1°/s"_s.arg(wanted.speed * unit, 0, 'f', 2);
        if (isSignal)
            text += u" %1"_s.arg(wanted.angle);
        else if (mode != NoControl && mode != Ignore && mode != Speed)
            text += u", %1°"_s.arg(wanted.angle * kDegreesPerCount, 0, 'f', 2);
        parts.append(text);
    }
    return parts.join(u"; "_s);
}

QString anglesText(const Result<Angles> &angles, bool extended)
{
    if (!angles)
        return {};
    QStringList parts;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const AxisAngles &a = (*angles)[axis];
        parts.append(u"%1: camera %2°, target %3°"_s.arg(QLatin1String(kAxisLetters[axis]))
                         .arg(a.imu, 0, 'f', 2)
                         .arg(a.target, 0, 'f', 2));
        if (extended)
            parts.last() += u", motor %1°"_s.arg(a.rotor, 0, 'f', 2);
    }
    return parts.join(u"; "_s);
}

QString realtimeText(Bytes payload)
{
    QStringList parts;
    for (const WireField &field : realtimeFields()) {
        const float value = readField(field, payload);
        if (std::isnan(value))
            continue;
        const ChannelSpec &spec = channelTable()[std::size_t(field.channel)];
        parts.append(u"%1 %2"_s.arg(QLatin1String(spec.key)).arg(double(value), 0, 'f', spec.decimals));
    }
    // Older firmware leaves zeros there.
    const Bytes later = payload.size() > kRealtime4LaterAt ? payload.subspan(kRealtime4LaterAt) : Bytes();
    if (std::any_of(later.begin(), later.end(), [](std::byte byte) { return byte != std::byte{}; }))
        parts.append(fieldsText(realtime4Later(), later));
    return parts.join(u", "_s);
}

// What comes with the number of the command (errata 3.18).
QString confirmText(Bytes payload)
{
    if (payload.empty())
        return {};
    const auto command = static_cast<CommandId>(std::to_integer<int>(payload.front()));
    const QString name = commandName(number(command));
    const Bytes data = payload.subspan(1);
    ByteReader reader(data);
    const bool isFile = command == CommandId::WriteFile || command == CommandId::FsClearAll;
    if (isFile && data.size() == 1) {
        const int code = reader.u8();
        const auto word = std::find_if(std::begin(kFileCodes), std::end(kFileCodes),
                                       [code](const Choice &choice) { return choice.value == code; });
        return name + u": "_s
            + (word == std::end(kFileCodes) ? u"code %1"_s.arg(code) : QString(QLatin1String(word->name)));
    }
    if (command == CommandId::EepromWrite && data.size() == 4)
        return u"%1: address %2"_s.arg(name).arg(reader.u32());
    const bool isArrival = command == CommandId::Control && data.size() == 1 && data[0] == std::byte{1};
    const bool isEnd = number(command) == kCalibCogging && data.size() == 1 && data[0] == std::byte{255};
    if (isArrival || isEnd)
        return name + u": the task is done"_s;
    return data.empty() ? name
                        : u"%1: data %2"_s.arg(name, QString::fromLatin1(toByteArray(data).toHex(' ')));
}

QString variablesText(Bytes payload)
{
    const auto vars = decodeAdjVars(payload);
    if (!vars)
        return {};
    const auto known = adjustablesOf(kAnyFirmware);
    QStringList parts;
    for (const AdjVar &var : *vars) {
        const QString name = var.id < int(known.size()) ? QLatin1String(known[std::size_t(var.id)].key)
                                                        : QString::number(var.id);
        parts.append(u"%1 = %2"_s.arg(name).arg(var.value));
    }
    return parts.join(u", "_s);
}

QString fromBoardText(CommandId id, Bytes payload, const ParameterSet *parameters, int firmware)
{
    ByteReader reader(payload);
    switch (id) {
    case CommandId::Confirm: return confirmText(payload);
    case CommandId::Error: {
        // The document's five-byte form does not name the command (errata 3.18).
        const int command = payload.size() >= 6 ? reader.u8() : 0;
        return (command ? commandName(command) + u": "_s : QString()) + errorCodeText(reader.u8(), command);
    }
    case CommandId::BoardInfo: {
        const auto info = BoardInfo::decode(payload);
        return info
            ? u"board %1, firmware %2"_s.arg(info->boardVersion / 10.0, 0, 'f', 1).arg(info->firmwareText())
            : QString();
    }
    case CommandId::ReadProfileNames: {
        const auto names = decodeProfileNames(payload);
        return names ? names->join(u", "_s) : QString();
    }
    case CommandId::RealtimeData3:
    case CommandId::RealtimeData4: return realtimeText(payload);
    case CommandId::RealtimeDataCustom:
        return u"time %1 ms, %2 bytes"_s.arg(reader.u16()).arg(payload.size());
    case CommandId::GetAngles: return anglesText(decodeAngles(payload), false);
    case CommandId::GetAnglesExt: return anglesText(decodeAnglesExt(payload), true);
    case CommandId::SetAdjVarsVal: return variablesText(payload);
    case CommandId::AutoPid: {
        const auto progress = AutoPidProgress::decode(payload);
        if (!progress)
            return {};
        QString text = u"iteration %1"_s.arg(progress->iteration);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // As the parameters are shown, whose scale depends on the firmware.
            const auto gain = [&](const char *key, int raw) {
                const ParameterSpec *spec = parameters
                    ? parameters->find(u"pid.%1.%2"_s.arg(axisName(axis), QLatin1String(key)))
                    : nullptr;
                return spec ? spec->rounded(raw) : QString::number(raw);
            };
            text += u"; %1: P %2 I %3 D %4 error %5"_s.arg(QLatin1String(kAxisLetters[axis]))
                        .arg(gain("p", progress->p[axis]), gain("i", progress->i[axis]),
                             gain("d", progress->d[axis]))
                        .arg(double(progress->trackingError[axis]), 0, 'f', 3);
        }
        return text;
    }
    case CommandId::DebugVarsInfo3: {
        const auto vars = decodeDebugVarsInfo(payload);
        if (!vars)
            return {};
        QStringList names;
        for (const DebugVar &var : vars->vars)
            names.append(var.name);
        return u"%1 variables: %2"_s.arg(vars->total).arg(names.join(u", "_s));
    }
    case CommandId::ReadParams3:
    case CommandId::ReadParams: return payload.empty() ? QString() : blockText(Params3, payload, parameters);
    case CommandId::ReadParamsExt:
        return payload.empty() ? QString() : blockText(ParamsExt, payload, parameters);
    case CommandId::ReadParamsExt2:
        return payload.empty() ? QString() : blockText(ParamsExt2, payload, parameters);
    case CommandId::ReadParamsExt3:
        return payload.empty() ? QString() : blockText(ParamsExt3, payload, parameters);
    default: return messageText(number(id), payload, true, firmware);
    }
}

QString toBoardText(CommandId id, Bytes payload, const ParameterSet *parameters, int firmware)
{
    ByteReader reader(payload);
    if (payload.empty())
        return {};
    switch (id) {
    case CommandId::Control: return controlText(payload);
    case CommandId::ExecuteMenu: return menuName(reader.u8());
    case CommandId::SetAdjVarsVal: return variablesText(payload);
    case CommandId::GetAdjVarsVal: {
        QStringList ids;
        for (std::size_t i = 1; i < payload.size(); ++i)
            ids.append(QString::number(std::to_integer<int>(payload[i])));
        return u"variables %1"_s.arg(ids.join(u", "_s));
    }
    case CommandId::DataStreamInterval: {
        const auto stream = DataStream::decode(payload);
        if (!stream)
            return {};
        const QString every = stream->intervalMs ? u"every %1 ms"_s.arg(stream->intervalMs) : u"stop"_s;
        return u"%1, %2, configuration %3"_s.arg(commandName(stream->command), every,
                                                 QString::fromLatin1(stream->config.toHex(' ')));
    }
    case CommandId::AutoPid: {
        const QString profile = profileText(reader.u8());
        return u"%1, flags 0x%2"_s.arg(profile).arg(reader.u8(), 2, 16, QChar(u'0'));
    }
    case CommandId::UseDefaults: return defaultsText(reader.u8());
    case CommandId::WriteProfileNames: {
        const auto names = decodeProfileNames(payload);
        return names ? names->join(u", "_s) : QString();
    }
    case CommandId::ReadParams3:
    case CommandId::ReadParamsExt:
    case CommandId::ReadParamsExt2:
    case CommandId::ReadParamsExt3:
    case CommandId::ReadParams: return profileText(reader.u8());
    case CommandId::WriteParams3:
    case CommandId::WriteParams: return blockText(Params3, payload, parameters);
    case CommandId::WriteParamsExt: return blockText(ParamsExt, payload, parameters);
    case CommandId::WriteParamsExt2: return blockText(ParamsExt2, payload, parameters);
    case CommandId::WriteParamsExt3: return blockText(ParamsExt3, payload, parameters);
    default: return messageText(number(id), payload, false, firmware);
    }
}

}  // namespace

FrameText describeFrame(const FrameView &frame, bool fromBoard, const ParameterSet *parameters, int firmware)
{
    const auto id = static_cast<CommandId>(frame.id);
    FrameText text;
    text.name = id == CommandId::Control ? (fromBoard ? u"CONFIRM"_s : u"CONTROL"_s) : commandName(frame.id);
    text.fields = fromBoard ? fromBoardText(id, frame.payload, parameters, firmware)
                            : toBoardText(id, frame.payload, parameters, firmware);
    text.isRefusal = fromBoard && id == CommandId::Error;
    return text;
}

namespace {

// "12 01" or "pin=16 state=high".
Result<QByteArray> payloadOf(const MessageSpec &message, const QStringList &words)
{
    if (message.toBoard && words.join(u' ').contains(u'='))
        return encodeFields(*message.toBoard, words, message.least);
    if (const auto bytes = bytesFromHex(words.join(u' ')))
        return *bytes;
    const QStringList fields = message.toBoard ? fieldNames(*message.toBoard) : QStringList();
    return failure(ErrorCode::InvalidArgument,
                   u"after %1 come payload bytes in hex%2"_s.arg(
                       QLatin1String(message.name),
                       fields.isEmpty() ? QString() : u", or %1=..."_s.arg(fields.join(u"=... "_s))));
}

}  // namespace

QStringList commandNames()
{
    QStringList names;
    for (const MessageSpec &message : messages()) {
        if (message.toBoard)
            names.append(QLatin1String(message.name));
    }
    names.sort();
    return names;
}

Result<RawCommand> parseCommand(const QString &text, int version, int firmware)
{
    const QString trimmed = text.trimmed();
    if (trimmed.isEmpty())
        return failure(ErrorCode::InvalidArgument, u"nothing to send"_s);

    if (const auto whole = bytesFromHex(trimmed)) {
        std::optional<Frame> found;
        Framer framer;
        const FrameSink sink = [&found](const FrameView &frame) { found = Frame(frame); };
        framer.feed(asBytes(*whole), sink);
        framer.flush(sink);
        if (!found || framer.statistics().frames != 1 || framer.statistics().skippedBytes != 0)
            return failure(ErrorCode::InvalidArgument,
                           u"these bytes are not one complete frame with valid checksums"_s);
        return RawCommand{
            describeFrame({found->id, asBytes(found->payload), found->version}, false, nullptr).name, *whole,
            riskOf(found->id, found->payload)};
    }
    QStringList words = trimmed.split(QRegularExpression(u"\\s+"_s));
    const QString name = words.takeFirst().toUpper();
    const MessageSpec *message = findMessage(name);
    if (!message)
        return failure(ErrorCode::InvalidArgument, u"there is no command '%1'"_s.arg(name));
    if (!message->toBoard && message->isPublic)
        return failure(ErrorCode::InvalidArgument, u"%1 is what the board sends"_s.arg(name));
    const auto payload = payloadOf(asOf(*message, firmware), words);
    if (!payload)
        return tl::unexpected(payload.error());
    if (payload->size() > 255)
        return failure(ErrorCode::InvalidArgument,
                       u"%1 payload bytes, a frame holds 255"_s.arg(payload->size()));
    return RawCommand{name, encodeFrame(message->id, *payload, version), riskOf(message->id, *payload)};
}

}  // namespace simplebgc
