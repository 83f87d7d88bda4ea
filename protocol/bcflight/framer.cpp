// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/framer.h"

#include "protocol/base/checksum.h"

#include <algorithm>

namespace bcflight {

namespace {

constexpr std::size_t kDatagram = 65000;  // longer packets are cut there (errata 2.1)

// The configuration text of generation A comes with the id that others use for the cameras' text; its CRC in
// front tells (errata 1). Size of the payload if it is one. @param isWhole no end has to follow
std::optional<std::size_t> oldConfigSize(Bytes bytes, bool isWhole)
{
    if (bytes.size() < 5)
        return {};
    const Bytes text = bytes.subspan(4);
    const auto end = std::find(text.begin(), text.end(), std::byte(0));
    const auto size = std::size_t(std::distance(text.begin(), end));
    if (end == text.end() && !isWhole)
        return {};
    std::uint32_t crc = 0;
    for (std::size_t i = 0; i < 4; ++i)
        crc = crc << 8 | std::to_integer<std::uint32_t>(bytes[i]);
    if (crc32c(text.first(size)) != crc)
        return {};
    return 4 + size + (end == text.end() ? 0 : 1);
}

bool hasText(const MessageSpec &message)
{
    return !message.fromDrone->empty() && message.fromDrone->back().type == FieldType::Text;
}

}  // namespace

void Framer::feed(Bytes bytes, const FrameSink &sink)
{
    if (m_isLost) {
        m_statistics.skippedBytes += bytes.size();
        return;
    }
    m_buffer.append(toByteArray(bytes));
    take(sink, false);
}

void Framer::packetEnded(const FrameSink &sink)
{
    // The rest of a long text comes in the next datagram, without an id.
    if (!m_buffer.isEmpty() && std::size_t(m_buffer.size()) % kDatagram == 0)
        return;
    flush(sink);
}

void Framer::flush(const FrameSink &sink)
{
    take(sink, true);
    m_buffer.clear();
    m_isLost = false;
}

void Framer::take(const FrameSink &sink, bool isWhole)
{
    qsizetype at = 0;
    while (at < m_buffer.size()) {
        const Bytes rest = asBytes(QByteArrayView(m_buffer).sliced(at));
        const auto front = readId(rest);
        if (!front) {
            // The zero behind a text, or half an id.
            if (isWhole && rest[0] != std::byte(0))
                discard(sink, at);
            break;
        }
        const auto id = droneMessage(front->wire);
        const MessageSpec *message = id ? findMessage(*id) : nullptr;
        if (!message) {
            ++m_statistics.headerErrors;
            discard(sink, at);
            at = m_buffer.size();
            break;
        }
        const Bytes payload = rest.subspan(front->size);
        int known = int(*id);
        auto size = payloadSize(*message->fromDrone, payload);
        if (*id == Message::Ack) {
            known += front->wire & 0x7F;
            size = 2;  // the word twice (errata 5)
        } else if (*id == Message::GetCamerasInfos) {
            if (const auto old = oldConfigSize(payload, isWhole)) {
                known = int(Message::GetConfigFile);
                size = old;
            }
        }
        if (!size && isWhole && hasText(*message)
            && payloadSize(message->fromDrone->first(message->fromDrone->size() - 1), payload))
            size = payload.size();  // its end was lost, its text was not
        const bool fits = size && *size <= payload.size();
        if (!fits) {
            const std::size_t limit = hasText(*message) ? kMaxText : kMaxCounted;
            if (!isWhole && payload.size() <= limit)
                break;
            ++m_statistics.bodyErrors;
            discard(sink, at);
            at = m_buffer.size();
            break;
        }
        ++m_statistics.frames;
        if (*id != Message::Unknown)
            sink({known, payload.first(*size), 1, rest.first(front->size + *size)});
        at += qsizetype(front->size + *size);
    }
    m_buffer.remove(0, at);
}

void Framer::discard(const FrameSink &sink, qsizetype from)
{
    const Bytes rest = asBytes(QByteArrayView(m_buffer).sliced(from));
    m_statistics.skippedBytes += rest.size();
    m_isLost = true;
    sink({kDiscarded, rest, 1, rest});
}

}  // namespace bcflight
