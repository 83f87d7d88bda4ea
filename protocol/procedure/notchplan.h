// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/notchadvice.h"
#include "protocol/device/abilities.h"

class Device;

/// A notch that would take a line out of the active profile, with values that the board can hold.
struct NotchPlan
{
    Axis axis = Axis::None;
    SpectrumPeak peak;
    NotchFilter filter;
    NotchShape shape;
    int profile = 0;
    std::vector<std::pair<QString, double>> values;  ///< key, raw value

    /// The configuration with this notch in it and in use.
    [[nodiscard]] Configuration appliedTo(Configuration configuration) const;
};

/// For the first filter of the axis that is in use neither on the board nor in the edits. Empty: there is
/// none.
[[nodiscard]] std::optional<NotchPlan> planNotch(const Device &device, const Configuration &board,
                                                 const Configuration &edited, Axis axis,
                                                 const SpectrumPeak &peak);
