// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/link/host.h"
#include "protocol/simulator/link/tcpdoor.h"

/// A board behind a TCP server.
class TcpHost final : public SimulatorHost
{
    Q_OBJECT
public:
    TcpHost(std::unique_ptr<SimulatedPort> port, quint16 tcpPort, QObject *parent = nullptr);

    Result<void> start() override;
    [[nodiscard]] QString address() const override;

protected:
    void deliver(const QByteArray &bytes) override { m_door.write(bytes); }
    void plugged(bool in) override;

private:
    TcpDoor m_door;
};
