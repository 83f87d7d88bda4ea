// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/axis.h"
#include "protocol/configuration/configuration.h"
#include "protocol/simplebgc/device.h"
#include "protocol/simplebgc/telemetrytables.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

// FOLLOW_MODE (document, CMD_READ_PARAMS_3).
constexpr int kFollowsFlightController = 1;

std::optional<double> settingOf(const Configuration &active, const QString &key)
{
    const ParameterSpec *spec = active.parameterSet() ? active.parameters().find(key) : nullptr;
    const auto raw = spec ? active.raw(*spec, active.activeProfile()) : std::nullopt;
    return raw ? std::optional(spec->toDisplay(*raw)) : std::nullopt;
}

// Negative means "off" (document, CMD_READ_PARAMS_3).
std::optional<double> thresholdOf(const Configuration &active, const QString &key)
{
    const auto volts = settingOf(active, key);
    return volts && *volts > 0 ? volts : std::nullopt;
}

}  // namespace

AxisBearing Device::bearing(Axis axis, const Configuration &active, const Latest &latest) const
{
    const QString name = QLatin1String(axisKey(axis));
    AxisBearing bearing;
    const auto low = settingOf(active, u"rc.%1.min_angle"_s.arg(name));
    const auto high = settingOf(active, u"rc.%1.max_angle"_s.arg(name));
    if (low && high)
        bearing.limits = {*low, *high};
    const auto rate = settingOf(active, u"rc.%1.follow"_s.arg(name));
    const auto mode = settingOf(active, u"follow.mode"_s);
    if (axis == Axis::Yaw && rate)
        bearing.follows = *rate != 0.0;
    else if (rate && mode)
        bearing.follows = int(*mode) == kFollowsFlightController ? *rate != 0.0 : *mode != 0.0;
    if (const double running = latest(MotorsRunning); !std::isnan(running))
        bearing.isDriven
            = running != 0.0 && settingOf(active, u"motor.%1.output"_s.arg(name)).value_or(1.0) != 0.0;
    return bearing;
}

// Without a second sensor the board sends zeros.
std::optional<bool> Device::isFrameMeasured(const Configuration &active, const Latest &) const
{
    const auto place = settingOf(active, u"imu.frame.position"_s);
    const auto byMotors = settingOf(active, u"imu.frame_angle_from_motors"_s);
    if (!place && !byMotors)
        return {};
    return place.value_or(0.0) != 0.0 || byMotors.value_or(0.0) != 0.0;
}

BatteryThresholds Device::batteryThresholds(const Configuration &active) const
{
    return {thresholdOf(active, u"battery.alarm"_s), thresholdOf(active, u"battery.motors_off"_s)};
}

}  // namespace simplebgc
