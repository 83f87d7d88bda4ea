// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/axis.h"
#include "protocol/base/battery.h"

#include <functional>
#include <optional>
#include <utility>

class Configuration;

/// How an axis of the camera is guided. What is not known is empty.
struct AxisBearing
{
    std::optional<std::pair<double, double>> limits;  ///< degrees that steering reaches, low and high
    std::optional<bool> follows;  ///< the frame, instead of keeping its direction
    std::optional<bool> isRemote;  ///< an input of the board may steer it
    std::optional<bool> isDriven;  ///< its motor works
};

/// Boards whose settings and status say how the gimbal hangs and what it lives on.
class Bearings
{
public:
    virtual ~Bearings() = default;
    /// Newest value of a channel, NaN if none.
    using Latest = std::function<double(int channel)>;

    /// @param active the configuration, its active profile counts; one without parameters tells nothing
    [[nodiscard]] virtual AxisBearing bearing(Axis axis, const Configuration &active,
                                              const Latest &latest) const = 0;
    /// Whether the angles with the roles "frame" are those of the frame; empty: not known.
    [[nodiscard]] virtual std::optional<bool> isFrameMeasured(const Configuration &active,
                                                              const Latest &latest) const = 0;
    [[nodiscard]] virtual BatteryThresholds batteryThresholds(const Configuration &active) const = 0;
};
