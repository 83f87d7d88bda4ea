// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/plant.h"
#include "protocol/simulator/simulatedboard.h"
#include "protocol/transport/linkaddress.h"

#include <deque>

/// The cable and port of a simulated board: line rate and parity, wrong-rate garbage, lost, flipped, doubled
/// and delayed bytes, pulling and plugging. Without a line it is native USB: not throttled, and gone while
/// the board restarts.
class SimulatedPort
{
public:
    /// @param line rate and parity of a UART; empty = native USB
    SimulatedPort(std::unique_ptr<SimulatedBoard> board, const SimulatorOptions &options,
                  std::optional<LineSettings> line);

    /// Bytes that the host writes; lost while unplugged.
    void hostWrites(Bytes bytes);
    /// Everything that has reached the host by now.
    QByteArray hostReads();
    /// False while the host takes nothing: USB waits, a UART does not.
    void setHostReady(bool ready) { m_hostReady = ready; }
    /// What the host has set its end to, where that can be known; empty = whatever the board wants.
    void setHostLine(std::optional<LineSettings> line) { m_hostLine = line; }
    /// Lets simulated time pass, in whole firmware cycles.
    void advance(Duration time);
    /// False while the cable is out, and on USB while the board restarts.
    [[nodiscard]] bool isPlugged() const;
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

    std::unique_ptr<SimulatedBoard> m_board;
    Faults m_faults;
    std::optional<LineSettings> m_line;
    std::optional<LineSettings> m_hostLine;
    bool m_strictParity;
    SimulatedNoise m_noise;
    Duration m_now{};
    Duration m_rest{};
    QByteArray m_toBoard;
    bool m_hostReady = true;
    double m_inCredit = 0;
    double m_outCredit = 0;
    std::deque<Delayed> m_toHost;
};

/// Makes the board of a family. Errors: InvalidArgument for a family that has no simulator.
Result<std::unique_ptr<SimulatedBoard>> makeSimulatedBoard(const QString &family,
                                                           const SimulatorOptions &options);
