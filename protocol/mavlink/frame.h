// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/mavlink/messages.h"

namespace mavlink {

inline constexpr std::byte kStart{0xFE};
/// Start byte, length, sequence, system, component, message, and the checksum after the payload.
inline constexpr std::size_t kOverhead = 8;

/// Sender or addressee: STorM32 is 71, 67 unless it is changed (parameters 110 and 111).
struct Address
{
    int system = 71;
    int component = 67;
    friend bool operator==(const Address &, const Address &) = default;
};

/// A version 1 frame as received.
struct Packet
{
    int id = 0;
    int sequence = 0;
    Address from;
    Bytes payload;
};

/// What these bytes begin with.
enum class Look { No, Incomplete, Damaged, Complete };
struct Sighting
{
    Look look = Look::No;
    std::size_t size = 0;  ///< of a complete frame
    Packet packet{};
};
/// Looks for a frame at the first byte. Messages that are not in the table cannot be checked and count as No.
[[nodiscard]] Sighting sight(Bytes bytes);

/// A complete frame. The payload must have the message's size (a variable one at most 255 bytes).
[[nodiscard]] QByteArray encode(MessageId id, QByteArrayView payload, const Address &from, int sequence);

/// The values of a message's payload by field name. Errors: BadReply (too short).
[[nodiscard]] Result<QVariantMap> decodeFields(const Message &message, Bytes payload);
/// A message's payload from values by field name; fields not named are zero. Errors: those of the fields, and
/// InvalidArgument (more than 255 bytes).
[[nodiscard]] Result<QByteArray> encodeFields(const Message &message, const QVariantMap &values);

/// How a parameter's 16 bits travel in the value field (errata 6): as a float up to firmware 0.90, as raw
/// bits from 0.91.
enum class ValueCoding { Number, Bits };
[[nodiscard]] float encodeValue(int raw16, ValueCoding coding);
/// Back to the 16 bits; numbers outside 0..65535 are clamped.
[[nodiscard]] int decodeValue(float value, ValueCoding coding);

}  // namespace mavlink
