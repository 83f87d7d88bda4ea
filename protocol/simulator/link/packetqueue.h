// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"
#include "protocol/simulator/world/faults.h"
#include "protocol/simulator/world/plant.h"

#include <QByteArray>
#include <QList>

#include <deque>
#include <optional>

/// One direction of a network: packets arrive whole, but may be lost, duplicated, delayed, or overtaken by
/// the next.
class PacketQueue
{
public:
    /// @param delayMs longest time in transit
    void push(const QByteArray &packet, Duration now, const Faults &faults, int delayMs,
              SimulatedNoise &noise);
    /// Packets that have arrived by now, oldest first.
    QList<QByteArray> take(Duration now);
    void clear();

private:
    struct Entry
    {
        Duration at{};
        QByteArray packet;
    };
    void append(Entry entry);

    std::deque<Entry> m_entries;
    std::optional<Entry> m_overtaken;  // is waiting for the next packet
};
