// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/namedfields.h"

/// The MAVLink version 1 messages that a STorM32 board speaks, with the checksum seeds of its own dialect.
/// Today's public tables give different seeds for some of the message numbers, so none of them can be used
/// (STorM32 errata 6).
namespace mavlink {

enum class MessageId : int {
    Heartbeat = 0,
    ParamRequestRead = 20,
    ParamRequestList = 21,
    ParamValue = 22,
    ParamSet = 23,
    Attitude = 30,
    CommandLong = 76,
    CommandAck = 77,
    DigicamControl = 155,
    MountConfigure = 156,
    MountControl = 157,
    TargetSpecific = 234,
    TargetSpecificAck = 235,
    ParamRead2 = 236,
    ParamSet2 = 237,
    ParamValue2 = 238,
    StatusText = 253,
};

constexpr int number(MessageId id)
{
    return static_cast<int>(id);
}

using Field = NamedField;

struct Message
{
    MessageId id{};
    const char *name = "";
    std::uint8_t crcExtra = 0;
    int size = 0;  ///< of the payload; the minimum if it is variable
    bool variable = false;
    NamedFields fields;  ///< in wire order, without gaps
};

[[nodiscard]] std::span<const Message> messages();
/// The message with this number, or null.
[[nodiscard]] const Message *findMessage(int id);
[[nodiscard]] const Message *findMessage(const QString &name);

/// Commands of COMMAND_LONG that the board knows (document "MAVLINK_MSG_ID_COMMAND_LONG", errata 6), or "n".
[[nodiscard]] QString commandName(int command);

}  // namespace mavlink
