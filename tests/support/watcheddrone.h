// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/bcflight/board.h"

#include <functional>

/// A simulated drone on a network of which the test sees every packet, and may lose or forge it.
class WatchedDrone final : public SimulatedBoard
{
public:
    explicit WatchedDrone(const SimulatorOptions &options)
        : m_drone(options)
    {
    }

    [[nodiscard]] bool isPacketBased() const override { return packetBased; }
    void receive(Bytes bytes) override
    {
        QByteArray packet = toByteArray(bytes);
        if (onReceive && !onReceive(packet))
            return;
        m_drone.receive(asBytes(packet));
    }
    void cycle() override { m_drone.cycle(); }
    QByteArray takeOutput(qsizetype max) override
    {
        for (;;) {
            QByteArray packet = m_drone.takeOutput(max);
            if (packet.isEmpty() || !onSend || onSend(packet))
                return packet;
        }
    }
    [[nodiscard]] bool isRunning() const override { return m_drone.isRunning(); }
    void setFaults(const Faults &faults) override { m_drone.setFaults(faults); }

    [[nodiscard]] bcflight::SimulatedBoard &drone() { return m_drone; }

    /// Called for each packet, which may be changed; false: it is lost.
    std::function<bool(QByteArray &packet)> onReceive;
    std::function<bool(QByteArray &packet)> onSend;
    bool packetBased = true;

private:
    bcflight::SimulatedBoard m_drone;
};
