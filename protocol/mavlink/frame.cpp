// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/mavlink/frame.h"

#include "protocol/base/checksum.h"

#include <algorithm>
#include <bit>
#include <cmath>

using namespace Qt::StringLiterals;

namespace mavlink {

namespace {

std::uint16_t checksum(Bytes covered, std::uint8_t extra)
{
    const std::byte seed{extra};
    return crc16Mcrf4xx(Bytes(&seed, 1), crc16Mcrf4xx(covered));
}

}  // namespace

Sighting sight(Bytes bytes)
{
    Sighting result;
    if (bytes.empty() || bytes[0] != kStart)
        return result;
    const auto at = [&bytes](std::size_t i) { return std::to_integer<int>(bytes[i]); };
    if (bytes.size() >= 6) {
        const Message *message = findMessage(at(5));
        const bool fits = message && (message->variable ? at(1) >= message->size : at(1) == message->size);
        if (!fits)
            return result;
    }
    const std::size_t size = bytes.size() >= 2 ? std::size_t(at(1)) + kOverhead : kOverhead;
    if (bytes.size() < std::max<std::size_t>(size, 6)) {
        result.look = Look::Incomplete;
        return result;
    }
    const auto wanted = checksum(bytes.subspan(1, size - 3), findMessage(at(5))->crcExtra);
    if (wanted != (at(size - 2) | at(size - 1) << 8)) {
        result.look = Look::Damaged;
        return result;
    }
    result.look = Look::Complete;
    result.size = size;
    result.packet = {at(5), at(2), {at(3), at(4)}, bytes.subspan(6, size - kOverhead)};
    return result;
}

QByteArray encode(MessageId id, QByteArrayView payload, const Address &from, int sequence)
{
    ByteWriter writer;
    writer.u8(0xFE)
        .u8(int(payload.size()))
        .u8(sequence & 0xFF)
        .u8(from.system)
        .u8(from.component)
        .u8(number(id))
        .bytes(payload);
    QByteArray frame = writer.take();
    const auto crc = checksum(asBytes(frame).subspan(1), findMessage(number(id))->crcExtra);
    return frame + ByteWriter().u16(crc).take();
}

Result<QVariantMap> decodeFields(const Message &message, Bytes payload)
{
    if (payload.size() < std::size_t(message.size))
        return failure(ErrorCode::BadReply,
                       u"%1 of %2 bytes"_s.arg(QLatin1String(message.name)).arg(payload.size()));
    return ::decodeFields(message.fields, payload);
}

Result<QByteArray> encodeFields(const Message &message, const QVariantMap &values)
{
    auto payload = ::encodeFields(message.fields, values);
    if (!payload)
        return failure(payload.error().code,
                       u"%1: %2"_s.arg(QLatin1String(message.name), payload.error().detail));
    if (payload->size() > 255)
        return failure(ErrorCode::InvalidArgument,
                       u"%1 bytes in %2"_s.arg(payload->size()).arg(QLatin1String(message.name)));
    return payload;
}

float encodeValue(int raw16, ValueCoding coding)
{
    const auto bits = static_cast<std::uint32_t>(raw16) & 0xFFFFU;
    return coding == ValueCoding::Bits ? std::bit_cast<float>(bits) : static_cast<float>(bits);
}

int decodeValue(float value, ValueCoding coding)
{
    if (coding == ValueCoding::Bits)
        return static_cast<int>(std::bit_cast<std::uint32_t>(value) & 0xFFFFU);
    return std::isnan(value) ? 0 : static_cast<int>(std::lround(std::clamp(value, 0.0F, 65535.0F)));
}

}  // namespace mavlink
