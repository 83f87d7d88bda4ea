// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"

/// The newest telemetry of a board, by channel, with the time at which it arrived.
class LatestValues
{
public:
    virtual ~LatestValues() = default;
    /// NaN before the first value.
    [[nodiscard]] virtual float latest(int channel) const = 0;
    /// Arrival time of that value; the epoch before the first.
    [[nodiscard]] virtual TimePoint latestAt(int channel) const = 0;
};
