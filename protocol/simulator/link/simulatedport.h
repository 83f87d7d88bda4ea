// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/link/packetqueue.h"
#include "protocol/simulator/world/plant.h"
#include "protocol/simulator/world/simulatedboard.h"
#include "protocol/transport/linkaddress.h"

#include <deque>

/// The cable and port of a simulated board: line rate and parity, wrong-rate garbage, lost, flipped, doubled
/// and delayed bytes, pulling and plugging. Without a line it is native USB: not throttled, and gone while
/// the board restarts. For a board that works in packets it is a network, which carries them whole.
class SimulatedPort
{
public:
    /// @param line rate and parity of a UART; empty = native USB
    SimulatedPort(std::unique_ptr<SimulatedBoard> board, const SimulatorOptions &options,
                  std::optional<LineSettings> line);

    /// Bytes that the host writes, or one packet; lost while unplugged.
    void hostWrites(Bytes bytes);
    /// Everything that has reached the host by now: packets, or the bytes of a line in one piece.
    QList<QByteArray> hostReads();
    /// False while the host takes nothing: USB waits, a UART does not.
    void setHostReady(bool ready) { m_hostReady = ready; }
    /// What the host has set its end to, where that can be known; empty = whatever the board wants.
    void setHostLine(std::optional<LineSettings> line) { m_hostLine = line; }
    /// Lets simulated time pass, in whole firmware cycles.
    void advance(Duration time);
    /// False while the cable is out, and on USB while the board restarts.
    [[nodiscard]] bool isPlugged() const;
    /// The host is told: a port that is gone, but never a network that has become silent.
    [[nodiscard]] bool isGone() const { return !m_packetBased && !isPlugged(); }
    [[nodiscard]] bool isPacketBased() const { return m_packetBased; }
    [[nodiscard]] Duration now() const { return m_now; }
    [[nodiscard]] SimulatedBoard &board() { return *m_board; }
    /// Changes the world while it runs: a fault as NAME=VALUE; times count from now. Errors: InvalidArgument.
    Result<void> change(const QString &assignment);

private:
    struct Delayed
    {
        Duration at;
        QByteArray bytes;
    };
    QByteArray damaged(Bytes bytes);
    [[nodiscard]] bool hears() const;
    void cycle();
    void exchangeBytes();
    void exchangePackets();

    std::unique_ptr<SimulatedBoard> m_board;
    Faults m_faults;
    std::optional<LineSettings> m_line;
    std::optional<LineSettings> m_hostLine;
    bool m_strictParity;
    bool m_packetBased;
    SimulatedNoise m_noise;
    Duration m_now{};
    Duration m_rest{};
    QByteArray m_toBoard;
    bool m_hostReady = true;
    double m_inCredit = 0;
    double m_outCredit = 0;
    std::deque<Delayed> m_toHost;
    PacketQueue m_packetsToBoard;
    PacketQueue m_packetsToHost;
};
