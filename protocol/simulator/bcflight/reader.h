// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/bcflight/messages.h"

namespace bcflight {

/// Reads a packet as the flight program does, with its hazards (errata 2.5): of an unknown message only the
/// id is taken and its payload is read as messages; what is too short is dropped and its bytes are read on; a
/// text ends before its zero, which stays.
class DroneReader
{
public:
    struct Item
    {
        std::optional<Message> id;  ///< empty: unknown
        int wire = 0;
        Bytes payload;
        Bytes rest;  ///< everything behind the id
    };

    DroneReader(Bytes packet, Generation generation)
        : m_rest(packet)
        , m_generation(generation)
    {
    }

    /// The next message; empty at the end.
    std::optional<Item> next();
    /// The handler of the last message has not taken its payload, or only so much of it.
    void putBack(const Item &item, std::size_t taken = 0) { m_rest = item.rest.subspan(taken); }

    /// What is not read yet.
    [[nodiscard]] Bytes rest() const { return m_rest; }

private:
    Bytes m_rest;
    Generation m_generation;
};

}  // namespace bcflight
