// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/faultteller.h"

#include "protocol/device/abilities.h"
#include "protocol/telemetry/telemetrystore.h"

#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kFaultPeriod = 500ms;

}  // namespace

FaultTeller::FaultTeller(const DeviceClient &client, QObject *parent)
    : QObject(parent)
    , m_client(client)
{
    connect(&m_timer, &QTimer::timeout, this, &FaultTeller::look);
    m_timer.start(kFaultPeriod);
}

void FaultTeller::look()
{
    const auto device = m_client.device();
    const auto store = m_client.telemetry();
    const FaultWords *words = device ? device->faultWords() : nullptr;
    const float bits = words && store ? store->latest(m_client.roles().faults) : std::nanf("");
    if (std::isnan(bits))
        return;
    const float detail = store->latest(m_client.roles().faultDetail);
    const auto before = std::exchange(m_present, {});
    for (const BoardFault &fault :
         words->faults(unsigned(bits), std::isnan(detail) ? 0U : unsigned(detail))) {
        if (!fault.severe)
            continue;
        m_present.insert(fault.key);
        if (!before.contains(fault.key))
            emit told(u"the board reports a fault: %1. %2 %3"_s.arg(fault.name, fault.meaning, fault.cure));
    }
}
