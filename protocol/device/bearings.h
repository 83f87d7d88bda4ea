// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/axis.h"

#include <functional>
#include <optional>
#include <utility>

class Configuration;

/// How an axis of the camera is guided. What is not known is empty.
struct AxisBearing
{
    std::optional<std::pair<double, double>> limits;  ///< degrees that steering reaches, low and high
    std::optional<bool> follows;  ///< the frame, instead of keeping its direction
};

/// Voltages below which a board does something, those that are set.
struct BatteryThresholds
{
    std::optional<double> alarm;  ///< volts: it warns
    std::optional<double> motorsOff;  ///< volts: it switches the motors off
    bool perCell = false;  ///< both are meant for one cell of the battery
};

/// Boards whose settings and status say how the gimbal hangs and what it lives on.
class Bearings
{
public:
    virtual ~Bearings() = default;
    /// Newest value of a channel, NaN if none.
    using Latest = std::function<double(int channel)>;

    /// @param active the configuration; its active profile counts
    [[nodiscard]] virtual AxisBearing bearing(Axis axis, const Configuration &active,
                                              const Latest &latest) const = 0;
    /// Whether the angles with the roles "frame" are those of the frame; empty: not known.
    [[nodiscard]] virtual std::optional<bool> isFrameMeasured(const Configuration &active,
                                                              const Latest &latest) const = 0;
    [[nodiscard]] virtual BatteryThresholds batteryThresholds(const Configuration &active) const = 0;
};
