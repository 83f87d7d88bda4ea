// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/commands.h"

#include "protocol/base/checksum.h"
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/messages.h"

#include <algorithm>
#include <array>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

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
    const MessageSpec *message = findMessage(id);
    return message ? QString(QLatin1String(message->name)) : u"CMD_%1"_s.arg(id);
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
    return Error{ErrorCode::BoardError, commandName(command) + u": "_s + errorCodeText(code, command), code};
}

bool isConfirmOf(const FrameView &frame, CommandId id)
{
    return frame.id == number(CommandId::Confirm) && !frame.payload.empty()
        && std::to_integer<int>(frame.payload[0]) == number(id);
}

QString errorCodeText(int code, int command)
{
    constexpr std::array kOfMemory{CommandId::EepromWrite, CommandId::EepromRead, CommandId::ReadFile,
                                   CommandId::WriteFile, CommandId::FsClearAll};
    const bool isOfMemory = std::any_of(kOfMemory.begin(), kOfMemory.end(),
                                        [command](CommandId each) { return number(each) == command; });
    // Which of both meanings the board has in mind nobody outside can tell (errata 3.18).
    for (const Choice &word : kFileCodes) {
        if (isOfMemory && word.value == code && code != 0)
            return u"%1 / %2"_s.arg(QLatin1String(word.name), errorCodeText(code));
    }
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
