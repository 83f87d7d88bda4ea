// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/world/simulatedfamily.h"
#include "protocol/transport/transport.h"

/// The in-process pipe: transports with the simulator behind them, for `sim:` addresses. A simulated gimbal
/// lives as long as this object and the transports made by it, so reconnecting after unplugging finds the
/// same board.
class SimulatedGimbals
{
public:
    explicit SimulatedGimbals(QList<SimulatedFamily> families);

    /// Errors: InvalidArgument for a family or option that does not exist. Called on the I/O thread.
    Result<std::unique_ptr<Transport>> connectTo(const LinkAddress &address) const;
    /// Offers the camera of a board that was connected to on the loopback interface: the port to which a
    /// viewer writes. Callable from any thread. Errors: NotConnected, Unsupported.
    Result<quint16> offerVideo(const LinkAddress &address) const;
    /// Changes the surroundings of a gimbal that was connected to: a fault as NAME=VALUE. Callable from any
    /// thread. Errors: InvalidArgument, NotConnected.
    Result<void> change(const LinkAddress &address, const QString &assignment) const;

private:
    struct Rigs;
    QList<SimulatedFamily> m_families;
    std::shared_ptr<Rigs> m_rigs;
};
