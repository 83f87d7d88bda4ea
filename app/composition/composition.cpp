// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"

#include "protocol/record/replaytransport.h"
#include "protocol/simplebgc/sbgcdevice.h"
#include "protocol/simulator/hosts.h"
#include "protocol/storm32/stormdevice.h"

QList<Family> allFamilies()
{
    return {sbgcFamily(), stormFamily()};
}

Links allLinks()
{
    const SimulatedGimbals simulated;
    Links links;
    links.transports = [simulated](const LinkAddress &address) {
        switch (address.kind()) {
        case LinkAddress::Kind::Simulator: return simulated.connectTo(address);
        case LinkAddress::Kind::Replay: return makeReplayTransport(address);
        default: return makeSystemTransport(address);
        }
    };
    links.changeWorld = [simulated](const LinkAddress &address, const QString &assignment) {
        return simulated.change(address, assignment);
    };
    return links;
}

std::shared_ptr<const ParameterSet> parametersFor(const BoardIdentity &identity)
{
    for (const Family &family : allFamilies()) {
        if (family.key == identity.family)
            return family.makeParameters(identity);
    }
    return nullptr;
}
