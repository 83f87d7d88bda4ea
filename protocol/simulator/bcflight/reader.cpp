// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/bcflight/reader.h"

#include "protocol/bcflight/payloads.h"

namespace bcflight {

std::optional<DroneReader::Item> DroneReader::next()
{
    if (m_rest.empty())
        return {};
    std::size_t idSize = 1;
    int wire = std::to_integer<int>(m_rest[0]);
    if (!(wire & 0x80)) {
        if (m_rest.size() < 2) {
            m_rest = {};
            return {};
        }
        wire = wire << 8 | std::to_integer<int>(m_rest[1]);
        idSize = 2;
    }
    Item item{groundMessage(wire, m_generation), wire, {}, m_rest.subspan(idSize)};
    m_rest = item.rest;
    const MessageSpec *message = item.id ? findMessage(*item.id) : nullptr;
    if (!message || !message->fromGround)
        return item;
    const auto size = payloadSize(*message->fromGround, item.rest, Controls::size(m_generation));
    if (!size) {
        item.id.reset();  // dropped; its bytes are read on
        return item;
    }
    item.payload = item.rest.first(*size);
    const bool hasText = !message->fromGround->empty() && message->fromGround->back().type == FieldType::Text;
    m_rest = item.rest.subspan(hasText ? *size - 1 : *size);
    return item;
}

}  // namespace bcflight
