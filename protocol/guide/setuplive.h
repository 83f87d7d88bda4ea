// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/guide/setupstep.h"
#include "protocol/telemetry/roles.h"

#include <optional>
#include <span>

class TelemetryStore;

/// What a step judges of the live data, one row of figures.
struct SetupLiveSpec
{
    SetupStep step = SetupStep::Power;
    const char *label = "";
    std::array<int, 3> ChannelRoles::*triple = nullptr;  ///< of the axes
    int ChannelRoles::*single = nullptr;
    bool isSpread = false;  ///< how much it varied in the last second, instead of its value

    /// The channels, -1 where the board has none; of a single one the first.
    [[nodiscard]] std::array<int, 3> channels(const ChannelRoles &roles) const;
    /// What it judges of one of them at this moment. Empty: nothing came yet.
    [[nodiscard]] std::optional<double> value(const TelemetryStore &telemetry, int channel) const;
};
inline constexpr int kSpreadDecimals = 3;
/// The figures of a step in one line, in English: "Angle 0.1 -0.2 3.0 °, Motor power 20 20 0 %".
[[nodiscard]] QString setupLiveText(SetupStep step, ChannelTable table, const ChannelRoles &roles,
                                    const TelemetryStore &telemetry);
[[nodiscard]] std::span<const SetupLiveSpec> setupLive();

/// The standard deviation.
[[nodiscard]] double spreadOf(std::span<const float> values);
