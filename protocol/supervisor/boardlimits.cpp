// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/supervisor/boardlimits.h"

#include "protocol/device/bearings.h"
#include "protocol/device/device.h"

#include <limits>

void setBoardLimits(SupervisorRules &rules, const Device &device, const Configuration &active)
{
    const Bearings *bearings = device.bearings();
    const auto unknown = [](int) { return std::numeric_limits<double>::quiet_NaN(); };
    rules.battery = bearings ? bearings->batteryThresholds(active) : BatteryThresholds();
    for (const Axis axis : kAxes) {
        const AxisBearing bearing = bearings ? bearings->bearing(axis, active, unknown) : AxisBearing();
        const auto &limits = bearing.limits;
        rules.isRemote[std::size_t(axis)] = bearing.isRemote;
        // Equal ones mean that nothing is limited.
        rules.angles[std::size_t(axis)] = limits && limits->first < limits->second ? limits : std::nullopt;
    }
}
