// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/inuse.h"

#include "protocol/device/abilities.h"
#include "protocol/device/device.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace {

using InUse = QMap<int, double>;  // by number of the variable

std::optional<InUse> askInUse(Channel &channel, LiveAccess &live, const QList<int> &variables)
{
    const auto read = live.readAdjustables(channel, variables);
    if (!read)
        return {};
    InUse values;
    for (const AdjustableValue &value : *read)
        values.insert(value.id, value.value);
    return values;
}

}  // namespace

bool answersWithUse(const Device &device)
{
    return device.live() && !device.wholeMemory();
}

std::vector<OtherValue> readReplaceable(Channel &channel, Device &device, const Configuration &stored)
{
    LiveAccess *live = device.live();
    if (!answersWithUse(device))
        return {};
    QList<int> variables;
    for (const AdjustableSpec &variable : live->adjustables()) {
        const auto &all = stored.parameters().all();
        if (std::any_of(all.begin(), all.end(),
                        [&variable](const ParameterSpec &spec) { return spec.adjustable == variable.id; }))
            variables.append(variable.id);
    }
    const auto inUse = variables.isEmpty() ? std::nullopt : askInUse(channel, *live, variables);
    std::vector<OtherValue> values;
    for (const ParameterSpec &spec : stored.parameters().all()) {
        const auto raw = stored.raw(spec, stored.activeProfile());
        if (!inUse || !raw || spec.row->state || !inUse->contains(spec.adjustable))
            continue;
        const double used = spec.rawOf(inUse->value(spec.adjustable));
        if (!sameValue(*raw, used))
            values.push_back({&spec, used, *raw, {}});
    }
    return values;
}

std::vector<OtherValue> findReplaced(Channel &channel, Device &device, std::vector<OtherValue> before)
{
    if (before.empty())
        return before;
    QList<int> variables;
    for (const OtherValue &value : before)
        variables.append(value.spec->adjustable);
    const auto now = askInUse(channel, *device.live(), variables);
    if (!now)
        return {};
    std::erase_if(before, [&now](OtherValue &value) {
        value.now = value.spec->rawOf(now->value(value.spec->adjustable));
        return sameValue(*value.now, value.inUse);
    });
    return before;
}

Configuration withInUse(Channel &channel, Device &device, Configuration answered)
{
    for (const OtherValue &value : readReplaceable(channel, device, answered))
        std::ignore = answered.restoreRaw(*value.spec, answered.activeProfile(), value.inUse);
    return answered;
}
