// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/transport/systemtransport.h"

#include "protocol/transport/serialtransport.h"
#include "protocol/transport/sockettransport.h"

Result<std::unique_ptr<Transport>> makeSystemTransport(const LinkAddress &address)
{
    switch (address.kind()) {
    case LinkAddress::Kind::Serial: {
        const LineSettings defaults;
        return std::make_unique<SerialTransport>(
            address.target(),
            LineSettings{address.baud().value_or(defaults.baud), address.parity().value_or(defaults.parity)});
    }
    case LinkAddress::Kind::Tcp:
    case LinkAddress::Kind::Udp:
        return std::make_unique<SocketTransport>(address.kind(), address.target(), address.port());
    case LinkAddress::Kind::None:
    case LinkAddress::Kind::Simulator:
    case LinkAddress::Kind::Replay: break;
    }
    return failure(ErrorCode::InvalidArgument, address.toString());
}
