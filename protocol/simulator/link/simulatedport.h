// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/link/packetqueue.h"
#include "protocol/simulator/world/plant.h"
#include "protocol/simulator/world/simulatedboard.h"
#include "protocol/transport/linkaddress.h"

#include <deque>

/// The cable and port of a simulated board: line rate and parity, garbage at the wrong rate, lost, flipped,
/// duplicated and delayed bytes, unplugging and plugging in. Without a line it is native USB: not throttled,
/// and absent while the board restarts. For a packet-based board it is a network, which carries packets
/// whole.
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
    /// False while the host does not read: USB waits, a UART does not.
    void setHostReady(bool ready) { m_hostReady = ready; }
    /// Line settings of the host's end, if they can be known; empty = the same as the board's.
    void setHostLine(std::optional<LineSettings> line) { m_hostLine = line; }
    /// Lets simulated time pass, in whole firmware cycles.
    void advance(Duration time);
    /// False while the cable is out, and on USB while the board restarts.
    [[nodiscard]] bool isPlugged() const;
    /// Whether the host notices: a port disappears, but a network only becomes silent.
    [[nodiscard]] bool isGone() const { return !m_packetBased && !isPlugged(); }
    [[nodiscard]] bool isPacketBased() const { return m_packetBased; }
    [[nodiscard]] Duration now() const { return m_now; }
    [[nodiscard]] SimulatedBoard &board() { return *m_board; }
    /// Changes the surroundings at run time: a fault as NAME=VALUE; times count from now. Errors:
    /// InvalidArgument.
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
    void letOthersAsk();

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
    bool m_othersAskedLast = false;
    Duration m_othersAskAt{};
    PacketQueue m_packetsToBoard;
    PacketQueue m_packetsToHost;
};
