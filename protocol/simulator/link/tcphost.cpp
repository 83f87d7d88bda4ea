// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/link/tcphost.h"

using namespace Qt::StringLiterals;

TcpHost::TcpHost(std::unique_ptr<SimulatedPort> port, quint16 tcpPort, QObject *parent)
    : SimulatorHost(std::move(port), parent)
    , m_door(SimulatorHost::port().board(), tcpPort, this)
{
    connect(&m_door, &TcpDoor::read, this, [this](const QByteArray &bytes) { hostWrote(bytes); });
}

Result<void> TcpHost::start()
{
    if (const auto opened = m_door.open(); !opened)
        return opened;
    return SimulatorHost::start();
}

QString TcpHost::address() const
{
    return u"tcp://127.0.0.1:%1"_s.arg(m_door.port());
}

void TcpHost::plugged(bool in)
{
    if (in)
        (void)m_door.open();
    else
        m_door.close();
}
