// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/axis.h"
#include "protocol/configuration/configuration.h"
#include "protocol/storm32/device.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

// The bits that factsOf() words: the second sensor is there and sound, the axes that follow.
constexpr unsigned kFrameSensor = 0x1000 | 0x0040;

constexpr unsigned followingBit(Axis axis)
{
    return axis == Axis::Pitch ? 0x2000U : axis == Axis::Roll ? 0x4000U : 0x8000U;
}

constexpr unsigned motorBit(Axis axis)
{
    return axis == Axis::Pitch ? 0x0008U : axis == Axis::Roll ? 0x0010U : 0x0020U;
}

std::optional<double> valueOf(const Configuration &active, const QString &key)
{
    const ParameterSpec *spec = active.parameterSet() ? active.parameters().find(key) : nullptr;
    const auto raw = spec ? active.raw(*spec, active.activeProfile()) : std::nullopt;
    return raw ? std::optional(spec->toDisplay(*raw)) : std::nullopt;
}

}  // namespace

AxisBearing Device::bearing(Axis axis, const Configuration &active, const Latest &latest) const
{
    const QString name = QLatin1String(axisKey(axis));
    AxisBearing bearing;
    const auto low = valueOf(active, u"rc.%1.min"_s.arg(name));
    const auto high = valueOf(active, u"rc.%1.max"_s.arg(name));
    if (low && high)
        bearing.limits = {*low, *high};
    const double status = latest(Status2);
    if (!std::isnan(status)) {
        bearing.follows = (unsigned(status) & followingBit(axis)) != 0;
        bearing.isDriven = (unsigned(status) & motorBit(axis)) != 0;
    }
    if (const auto input = valueOf(active, u"rc.%1.input"_s.arg(name)))
        bearing.isRemote = *input != 0.0;
    return bearing;
}

std::optional<bool> Device::isFrameMeasured(const Configuration &, const Latest &latest) const
{
    const double status = latest(Status);
    if (std::isnan(status))
        return {};
    return (unsigned(status) & kFrameSensor) == kFrameSensor;
}

// "Low Voltage Limit": off, then 2.9 V to 3.5 V for each cell.
BatteryThresholds Device::batteryThresholds(const Configuration &active) const
{
    const double choice = valueOf(active, u"battery.low_limit"_s).value_or(0.0);
    if (choice < 1.0)
        return {};
    return {.alarm = 2.8 + 0.1 * choice, .motorsOff = {}, .perCell = true};
}

}  // namespace storm32
