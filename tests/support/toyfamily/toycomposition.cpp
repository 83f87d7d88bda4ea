// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/toyfamily/toycomposition.h"

#include "protocol/simulator/link/simulatedgimbals.h"
#include "protocol/transport/systemtransport.h"
#include "tests/support/toyfamily/toyboard.h"
#include "tests/support/toyfamily/toydevice.h"

QList<Family> toyFamilies()
{
    return {toyFamily()};
}

Links toyLinks()
{
    const SimulatedGimbals simulated({simulatedToy()});
    Links links;
    links.defaultFamily = toyFamily().key;
    links.transports = [simulated](const LinkAddress &address) {
        return address.kind() == LinkAddress::Kind::Simulator ? simulated.connectTo(address)
                                                              : makeSystemTransport(address);
    };
    links.changeWorld = [simulated](const LinkAddress &address, const QString &assignment) {
        return simulated.change(address, assignment);
    };
    return links;
}
