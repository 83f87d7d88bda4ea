// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"

#include "protocol/blackbox/device.h"
#include "protocol/record/replaytransport.h"
#include "protocol/simulator/link/simulatedgimbals.h"
#include "protocol/transport/systemtransport.h"

#if GIMBAL_WITH_BCFLIGHT
#include "protocol/bcflight/device.h"
#include "protocol/simulator/bcflight/family.h"
#endif
#if GIMBAL_WITH_SIMPLEBGC
#include "protocol/simplebgc/device.h"
#include "protocol/simulator/simplebgc/family.h"
#endif
#if GIMBAL_WITH_STORM32
#include "protocol/simulator/storm32/family.h"
#include "protocol/storm32/device.h"
#endif

QList<Family> allFamilies()
{
    QList<Family> families;
#if GIMBAL_WITH_SIMPLEBGC
    families.append(simplebgc::family());
#endif
#if GIMBAL_WITH_STORM32
    families.append(storm32::family());
#endif
#if GIMBAL_WITH_BCFLIGHT
    families.append(bcflight::family());
#endif
    return families;
}

QList<Family> recordedFamilies()
{
    return {blackbox::family()};
}

QList<SimulatedFamily> allSimulatedFamilies()
{
    QList<SimulatedFamily> families;
#if GIMBAL_WITH_SIMPLEBGC
    families.append(simplebgc::simulatedFamily());
#endif
#if GIMBAL_WITH_STORM32
    families.append(storm32::simulatedFamily());
#endif
#if GIMBAL_WITH_BCFLIGHT
    families.append(bcflight::simulatedFamily());
#endif
    return families;
}

Links allLinks()
{
    const SimulatedGimbals simulated(allSimulatedFamilies());
    Links links;
    links.defaultFamily = allFamilies().first().key;
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
    links.offerVideo = [simulated](const LinkAddress &address) { return simulated.offerVideo(address); };
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
