// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/bcflight/reader.h"

#include "protocol/bcflight/payloads.h"

namespace bcflight {

std::optional<DroneReader::Item> DroneReader::next()
{
    if (m_rest.empty())
        return {};
    const auto front = readId(m_rest);
    if (!front) {
        m_rest = {};
        return {};
    }
    Item item{groundMessage(front->wire, m_generation), front->wire, {}, m_rest.subspan(front->size)};
    m_rest = item.rest;
    // Both bits set is all that it looks for (5).
    if (front->size == 2 && (front->wire & 0x0600) == 0x0600)
        item.id = Message::Ack;
    const MessageSpec *message = item.id ? findMessage(*item.id) : nullptr;
    if (!message || !message->fromGround)
        return item;
    auto size = payloadSize(*message->fromGround, item.rest, Controls::size(m_generation));
    // The second word of a PING may be missing (3).
    if (!size && *item.id == Message::Ping && item.rest.size() >= 2)
        size = 2;
    // A text cut off at the end of a segment is taken as far as it came (7.3); its checksum tells.
    const bool isCut = !size && *item.id == Message::SetConfigFile && item.rest.size() >= 4;
    if (isCut)
        size = item.rest.size();
    if (!size) {
        item.id.reset();  // dropped; its bytes are read on
        return item;
    }
    item.payload = item.rest.first(*size);
    const bool hasText = !message->fromGround->empty() && message->fromGround->back().type == FieldType::Text;
    m_rest = item.rest.subspan(hasText && !isCut ? *size - 1 : *size);
    return item;
}

}  // namespace bcflight
