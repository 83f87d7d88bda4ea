// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/commands.h"

#include "protocol/base/checksum.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

// The stream is 124 words and 128 bytes of scripts on layout 78, 125 words from 89 and 155 from 223 on
// (errata 3.4, 5).
constexpr std::array<int, 3> kStreamWords{124 + 64, 125 + 64, 155 + 64};

// clang-format off
constexpr SimpleCommand kSimple[] = {
    {Simple::Test, "t", "test", 0, {}},
    {Simple::Version, "v", "version", 0, {27, 27, 27}},
    {Simple::GetParameters, "g", "get parameters", 0, kStreamWords},
    {Simple::PutParameters, "p", "put parameters", -1, {}},
    {Simple::LiveData, "d", "live data", 0, {32, 32, 32}},
    {Simple::Status, "s", "status", 0, {5, 7, 7}},
    {Simple::Store, "xs", "store", 0, {}},
    {Simple::Retrieve, "xr", "retrieve", 0, {}},
    {Simple::Defaults, "xd", "defaults", 0, {}},
    {Simple::EraseEeprom, "xc", "erase EEPROM", 0, {}},
    {Simple::Level, "xl", "level", 0, {}},
    {Simple::Restart, "xx", "restart", 0, {}},
    {Simple::HardReset, "xX", "reset", 0, {}},
    {Simple::NormalMotors, "xW", "motors normal, restart", 0, {}},
    {Simple::TakeDirections, "xm", "take motor directions", 0, {}},
    {Simple::TakeStartPositions, "xz", "take start positions", 0, {}},
    {Simple::TakeYawStartPosition, "xy", "take yaw start position", 0, {}},
    {Simple::SetName, "xn", "set name", 16, {}},
    {Simple::SetBaudRate, "xu", "set baud rate", 2, {}},
    {Simple::RcTrim, "CR", "take RC trims", 0, {}},
    {Simple::ReadCalibration, "Cr", "read calibration", 0, {18, 18, 18}},
    {Simple::WriteCalibration, "Cw", "write calibration", 38, {}},
    {Simple::RawSensors, "Cd", "raw sensors", 0, {14, 14, 14}},
};
// clang-format on
static_assert(std::size(kSimple) == std::size_t(Simple::Count));

// Payloads of the RC set (errata 4). The board ignores bytes that have no name here.
constexpr NamedField kIndex[] = {{"index", NamedField::U16, 0, 2}};
constexpr NamedField kIndexAndValue[] = {{"index", NamedField::U16, 0, 2}, {"value", NamedField::U16, 2, 2}};
// clang-format off
constexpr NamedField kVersion[] = {{"firmware", NamedField::U16, 0, 2}, {"layout", NamedField::U16, 2, 2},
                                   {"capabilities", NamedField::U16, 4, 2}};
constexpr NamedField kVersionStrings[] = {{"version", NamedField::Text, 0, 16}, {"name", NamedField::Text, 16, 16},
                                          {"board", NamedField::Text, 32, 16}};
// clang-format on
constexpr NamedField kDataType[] = {{"type", NamedField::U8, 0}};
constexpr NamedField kTypedData[] = {{"type", NamedField::U8, 0}, {"data", NamedField::Bytes, 2, 0}};
constexpr NamedField kMask[] = {{"mask", NamedField::U16, 0, 2}};
constexpr NamedField kMaskedData[] = {{"mask", NamedField::U16, 0, 2}, {"data", NamedField::Bytes, 2, 0}};
constexpr NamedField kPulseField[] = {{"pulse", NamedField::U16, 0, 2}};
constexpr NamedField kPanModeField[] = {{"mode", NamedField::U8, 0}};
constexpr NamedField kStandbyField[] = {{"on", NamedField::U8, 0}};
constexpr NamedField kCamera[] = {{"shot", NamedField::U8, 1}};
constexpr NamedField kScriptFields[] = {{"script", NamedField::U8, 0}, {"case", NamedField::U8, 1}};
// clang-format off
constexpr NamedField kAngleFields[] = {{"pitch", NamedField::F32, 0, 4}, {"roll", NamedField::F32, 4, 4}, {"yaw", NamedField::F32, 8, 4},
                                  {"flags", NamedField::U8, 12}, {"type", NamedField::U8, 13}};
// clang-format on
constexpr NamedField kPulseFields[]
    = {{"pitch", NamedField::U16, 0, 2}, {"roll", NamedField::U16, 2, 2}, {"yaw", NamedField::U16, 4, 2}};
constexpr NamedField kPanSettingField[] = {{"setting", NamedField::U8, 0}};
constexpr NamedField kAck[] = {{"code", NamedField::U8, 0}};

// clang-format off
constexpr RcCommand kRc[] = {
    {Rc::GetVersion, "GETVERSION", 0, {}, kVersion},
    {Rc::GetVersionStrings, "GETVERSIONSTR", 0, {}, kVersionStrings},
    {Rc::GetParameter, "GETPARAMETER", 2, kIndex, kIndexAndValue},
    {Rc::SetParameter, "SETPARAMETER", 4, kIndexAndValue},
    {Rc::GetData, "GETDATA", 1, kDataType, kTypedData},
    {Rc::GetDataFields, "GETDATAFIELDS", 2, kMask, kMaskedData},
    {Rc::SetPitch, "SETPITCH", 2, kPulseField},
    {Rc::SetRoll, "SETROLL", 2, kPulseField},
    {Rc::SetYaw, "SETYAW", 2, kPulseField},
    {Rc::SetPanMode, "SETPANMODE", 1, kPanModeField},
    {Rc::SetStandby, "SETSTANDBY", 1, kStandbyField},
    {Rc::DoCamera, "DOCAMERA", 6, kCamera},
    {Rc::SetScriptControl, "SETSCRIPTCONTROL", 2, kScriptFields},
    {Rc::SetAngle, "SETANGLE", 14, kAngleFields},
    {Rc::SetPitchRollYaw, "SETPITCHROLLYAW", 6, kPulseFields},
    {Rc::SetPwmOut, "SETPWMOUT", 2, kPulseField},
    {Rc::RestoreParameter, "RESTOREPARAMETER", 2, kIndex},
    {Rc::RestoreAllParameters, "RESTOREALLPARAMETER", 0},
    {Rc::ActivePanModeSetting, "ACTIVEPANMODESETTING", 1, kPanSettingField},
};
// clang-format on

constexpr RcCommand kAckFrame{Rc::Ack, "ACK", 1, {}, kAck};

// Answers that carry data have these numbers (errata 4); everything else is acknowledged.
bool isAnswer(Rc asked, int number, Bytes payload)
{
    switch (asked) {
    case Rc::GetVersion: return number == 1 && payload.size() == 6;
    case Rc::GetVersionStrings:
        return (number == 5 || number == 2) && payload.size() == 48;  // 2 from v2.09 on
    case Rc::GetParameter: return number == 3 && payload.size() == 4;
    case Rc::GetData: return number == 5 && payload.size() >= 2 && payload.size() != 48;
    case Rc::GetDataFields: return number == 6 && payload.size() >= 2;
    case Rc::Ack: return number == int(Rc::Ack) && payload.size() == 1;
    default: return false;
    }
}

// A STorM32 board serves one request at a time, so all of them are of one kind.
constexpr int kOneKind = 1;

}  // namespace

std::span<const SimpleCommand> simpleCommands()
{
    return kSimple;
}

const SimpleCommand &simpleCommand(Simple id)
{
    return kSimple[std::size_t(id)];
}

const SimpleCommand *findSimple(Bytes bytes)
{
    const SimpleCommand *best = nullptr;
    for (const SimpleCommand &command : kSimple) {
        const Bytes letters = asBytes(QByteArrayView(command.letters));
        if (bytes.size() >= letters.size() && std::equal(letters.begin(), letters.end(), bytes.begin())
            && (!best || letters.size() > qstrlen(best->letters)))
            best = &command;
    }
    return best;
}

std::span<const RcCommand> rcCommands()
{
    return kRc;
}

const RcCommand *findRc(int id)
{
    const auto it = std::find_if(std::begin(kRc), std::end(kRc),
                                 [id](const RcCommand &command) { return int(command.id) == id; });
    return it == std::end(kRc) ? nullptr : it;
}

const RcCommand *findRcAnswer(int id, Bytes payload)
{
    const auto answers
        = [id, payload](const RcCommand &command) { return isAnswer(command.id, id, payload); };
    if (answers(kAckFrame))
        return &kAckFrame;
    const auto it = std::find_if(std::begin(kRc), std::end(kRc), answers);
    return it == std::end(kRc) ? nullptr : it;
}

QByteArray encodeSimple(Simple id, QByteArrayView arguments)
{
    ByteWriter writer;
    writer.bytes(simpleCommand(id).letters);
    if (!arguments.isEmpty())
        writer.bytes(arguments).u16(crc16Mcrf4xx(asBytes(arguments)));
    return writer.take();
}

QByteArray encodeRc(int id, QByteArrayView payload, bool answer)
{
    const QByteArray body = ByteWriter().u8(int(payload.size())).u8(id).bytes(payload).take();
    return ByteWriter().u8(answer ? 0xFB : 0xFA).bytes(body).u16(crc16Mcrf4xx(asBytes(body))).take();
}

QByteArray encodeReply(QByteArrayView data)
{
    if (data.isEmpty())
        return QByteArray("o");
    return ByteWriter().bytes(data).u16(crc16Mcrf4xx(asBytes(data))).bytes("o").take();
}

std::optional<Error> ackError(int code, const QString &command)
{
    switch (code) {
    case 0: return {};
    case 1: return Error{ErrorCode::BoardError, u"%1: failed"_s.arg(command), code};
    case 2: return Error{ErrorCode::BoardError, u"%1: access denied"_s.arg(command), code};
    case 3: return Error{ErrorCode::Unsupported, u"%1: this firmware does not know it"_s.arg(command), code};
    case 150: return Error{ErrorCode::Damaged, u"%1: the command arrived in pieces"_s.arg(command), code};
    case 151: return Error{ErrorCode::Damaged, u"%1: the command arrived damaged"_s.arg(command), code};
    case 152: return Error{ErrorCode::BoardError, u"%1: wrong length"_s.arg(command), code};
    case 153: return Error{ErrorCode::OutOfRange, u"%1: value out of range"_s.arg(command), code};
    default: return Error{ErrorCode::BoardError, u"%1: code %2"_s.arg(command).arg(code), code};
    }
}

Request simpleRequest(Simple id, QByteArrayView arguments)
{
    const SimpleCommand &command = simpleCommand(id);
    Request request;
    request.name = QString::fromLatin1(command.letters);
    request.bytes = encodeSimple(id, arguments);
    request.kind = kOneKind;
    request.replyBytes
        = command.replyWords[1] ? 2 * command.replyWords[1] + 3 : 1;  // of the most common firmware
    const bool data = command.replyWords[1] != 0;
    request.answer = [id, data, name = request.name](const FrameView &frame) -> std::optional<Result<Frame>> {
        if (frame.id == FrameId::kSimple + int(id) || (!data && frame.id == 'o'))
            return Frame(frame);
        if (frame.id == 'e')
            return failure(ErrorCode::Unsupported, u"'%1': the board does not know this command"_s.arg(name),
                           'e');
        if (frame.id == 't')
            return failure(ErrorCode::Damaged, u"'%1': the command arrived in pieces"_s.arg(name), 't');
        if (frame.id == 'c')
            return failure(ErrorCode::Damaged, u"'%1': the command arrived damaged"_s.arg(name), 'c');
        return {};
    };
    return request;
}

Request rcRequest(Rc id, const QByteArray &payload)
{
    Request request;
    const RcCommand *command = findRc(int(id));
    request.name = QString::fromLatin1(command ? command->name : "RC");
    request.bytes = encodeRc(int(id), payload);
    request.kind = kOneKind;
    request.replyBytes = id == Rc::GetData || id == Rc::GetDataFields ? 71 : 53;
    request.answer = [id, name = request.name](const FrameView &frame) -> std::optional<Result<Frame>> {
        if (isAnswer(id, frame.id - FrameId::kRc, frame.payload))
            return Frame(frame);
        if (isAnswer(Rc::Ack, frame.id - FrameId::kRc, frame.payload)) {
            if (const auto error = ackError(std::to_integer<int>(frame.payload[0]), name))
                return tl::unexpected(*error);
            return Frame(frame);
        }
        if (frame.id == 't')
            return failure(ErrorCode::Damaged, u"%1: the command arrived in pieces"_s.arg(name), 't');
        if (frame.id == 'e')
            return failure(ErrorCode::Unsupported, u"%1: the board does not know this command"_s.arg(name),
                           'e');
        return {};
    };
    return request;
}

}  // namespace storm32
