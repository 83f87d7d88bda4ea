// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/commands.h"

#include "protocol/base/checksum.h"

#include <array>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

// clang-format off
constexpr std::pair<int, const char *> kNames[] = {
    {20, "BOARD_INFO_3"}, {21, "READ_PARAMS_3"}, {22, "WRITE_PARAMS_3"}, {23, "REALTIME_DATA_3"},
    {24, "SELECT_IMU_3"}, {25, "REALTIME_DATA_4"}, {28, "READ_PROFILE_NAMES"}, {29, "WRITE_PROFILE_NAMES"},
    {30, "GET_PARAMS_3"}, {31, "SET_ADJ_VARS_VAL"}, {32, "SAVE_PARAMS_3"}, {33, "READ_PARAMS_EXT"},
    {34, "WRITE_PARAMS_EXT"}, {35, "AUTO_PID"}, {56, "AHRS_HELPER"}, {61, "GET_ANGLES_EXT"},
    {62, "READ_PARAMS_EXT2"}, {63, "WRITE_PARAMS_EXT2"}, {64, "GET_ADJ_VARS_VAL"}, {65, "CALIB_ACC"},
    {66, "CALIB_BAT"}, {67, "CONTROL/CONFIRM"}, {68, "REALTIME_DATA"}, {69, "EXECUTE_MENU"},
    {70, "USE_DEFAULTS"}, {73, "GET_ANGLES"}, {77, "MOTORS_ON"}, {79, "CALIB_OFFSET"}, {82, "READ_PARAMS"},
    {85, "DATA_STREAM_INTERVAL"}, {86, "BOARD_INFO"}, {87, "WRITE_PARAMS"}, {88, "REALTIME_DATA_CUSTOM"},
    {89, "BEEP_SOUND"}, {103, "CALIB_GYRO"}, {109, "MOTORS_OFF"}, {114, "RESET"}, {119, "WRITE_PARAMS_SET"},
    {253, "DEBUG_VARS_INFO_3"}, {254, "DEBUG_VARS_3"}, {255, "ERROR"},
};
// clang-format on

constexpr int kErrorPayload = 6;  // command, code, 4 data bytes
constexpr int kSeedErrorPayload = 5;  // code, 4 data bytes: the document's form (errata 3.18)

int frameSize(int payload, int version)
{
    return payload + (version == 2 ? 6 : 5);
}

Request baseRequest(CommandId id, const QByteArray &payload, int version)
{
    Request request;
    request.name = commandName(number(id));
    request.bytes = encodeFrame(number(id), payload, version);
    return request;
}

}  // namespace

QString commandName(int id)
{
    for (const auto &[known, name] : kNames) {
        if (known == id)
            return QLatin1String(name);
    }
    return u"CMD_%1"_s.arg(id);
}

QByteArray encodeFrame(int id, QByteArrayView payload, int version)
{
    Q_ASSERT(payload.size() <= 255);
    const auto size = static_cast<int>(payload.size());
    ByteWriter writer;
    writer.u8(version == 2 ? '$' : '>').u8(id).u8(size).u8((id + size) & 0xFF).bytes(payload);
    QByteArray frame = writer.take();
    if (version == 2) {
        const std::uint16_t crc = crc16ArcReversed(asBytes(frame).subspan(1));
        frame.append(static_cast<char>(crc & 0xFF)).append(static_cast<char>(crc >> 8));
        return frame;
    }
    frame.append(static_cast<char>(sum8(asBytes(payload))));
    return frame;
}

Request replyRequest(CommandId id, const QByteArray &payload, CommandId reply, int replyPayload, int version)
{
    return replyRequest(id, payload, reply, replyPayload, version, {});
}

Request replyRequest(CommandId id, const QByteArray &payload, CommandId reply, int replyPayload, int version,
                     std::function<bool(Bytes)> accept)
{
    Request request = baseRequest(id, payload, version);
    request.kind = number(reply);
    request.replyBytes = frameSize(replyPayload, version);
    request.idempotent = true;
    request.retries = 2;
    request.answer = [command = number(id), wanted = number(reply),
                      accept = std::move(accept)](const FrameView &frame) -> std::optional<Result<Frame>> {
        if (frame.id == wanted && (!accept || accept(frame.payload)))
            return Frame(frame);
        if (auto refusal = refusalOf(frame, command))
            return tl::unexpected(*refusal);
        return {};
    };
    return request;
}

Request confirmRequest(CommandId id, const QByteArray &payload, int version)
{
    Request request = baseRequest(id, payload, version);
    request.kind = 0x100 + number(id);
    request.replyBytes = frameSize(1, version);
    request.timeout = 500ms;
    request.answer = [id](const FrameView &frame) -> std::optional<Result<Frame>> {
        if (isConfirmOf(frame, id))
            return Frame(frame);
        if (auto refusal = refusalOf(frame, number(id)))
            return tl::unexpected(*refusal);
        return {};
    };
    return request;
}

Request silentRequest(CommandId id, const QByteArray &payload, int version)
{
    return baseRequest(id, payload, version);
}

std::optional<Error> refusalOf(const FrameView &frame, int command)
{
    if (frame.id != number(CommandId::Error))
        return {};
    ByteReader reader(frame.payload);
    if (frame.payload.size() >= kErrorPayload && reader.u8() != command)
        return {};
    if (frame.payload.size() < kSeedErrorPayload)
        return {};
    const int code = reader.u8();
    return Error{ErrorCode::BoardError, commandName(command) + u": "_s + errorCodeText(code), code};
}

bool isConfirmOf(const FrameView &frame, CommandId id)
{
    return frame.id == number(CommandId::Confirm) && !frame.payload.empty()
        && std::to_integer<int>(frame.payload[0]) == number(id);
}

QString errorCodeText(int code)
{
    constexpr std::array<const char *, 12> texts{
        "no error",        "wrong payload size", "wrong parameters",
        "wrong device ID", "encryption failure", "battery calibration failed",
        "unknown command", "reserved",           "not possible in this state",
        "not supported",   "operation failed",   "temporarily impossible"};
    if (code >= 0 && code < int(texts.size()))
        return QLatin1String(texts[static_cast<std::size_t>(code)]);
    return u"error %1"_s.arg(code);
}

}  // namespace simplebgc
