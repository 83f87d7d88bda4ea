// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/link/packetqueue.h"

#include <algorithm>

namespace {

constexpr auto kLongestOvertaking = 200ms;  // with nothing behind it, the packet arrives after this

}  // namespace

void PacketQueue::push(const QByteArray &packet, Duration now, const Faults &faults, int delayMs,
                       SimulatedNoise &noise)
{
    if (noise.chance(faults.loseByte))
        return;
    Entry entry{now, packet};
    for (char &byte : entry.packet) {
        if (noise.chance(faults.flipByte))
            byte = static_cast<char>(unsigned(byte) ^ 1U << unsigned(noise.uniform() * 8));
    }
    if (delayMs > 0)
        entry.at += durationFromSeconds(noise.uniform() * delayMs * 0.001);
    if (!m_overtaken && noise.chance(faults.reorder)) {
        entry.at += kLongestOvertaking;
        m_overtaken = std::move(entry);
        return;
    }
    append(entry);
    if (noise.chance(faults.doubleByte))
        append(entry);
    if (m_overtaken) {
        m_overtaken->at = entry.at;
        append(*std::exchange(m_overtaken, {}));
    }
}

// Packets stay in order unless one is meant to overtake.
void PacketQueue::append(Entry entry)
{
    if (!m_entries.empty())
        entry.at = std::max(entry.at, m_entries.back().at);
    m_entries.push_back(std::move(entry));
}

QList<QByteArray> PacketQueue::take(Duration now)
{
    if (m_overtaken && m_overtaken->at <= now)
        append(*std::exchange(m_overtaken, {}));
    QList<QByteArray> packets;
    while (!m_entries.empty() && m_entries.front().at <= now) {
        packets.append(m_entries.front().packet);
        m_entries.pop_front();
    }
    return packets;
}

void PacketQueue::clear()
{
    m_entries.clear();
    m_overtaken.reset();
}
