// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

#include <vector>

/// How one motor takes part in each motion, as the board mixes it. The signs tell on which side of the middle
/// it sits and to which of two groups it belongs by its direction; which side and which direction that is
/// depends on the board.
struct MotorShare
{
    double roll = 0;
    double pitch = 0;
    double yaw = 0;
    double thrust = 0;
    friend bool operator==(const MotorShare &, const MotorShare &) = default;
};

/// Boards with numbered motors whose places follow from what they hold.
class MotorLayout
{
public:
    virtual ~MotorLayout() = default;
    /// In the order of the numbered motors; empty: the configuration does not tell.
    [[nodiscard]] virtual std::vector<MotorShare> motorShares(const Configuration &configuration) const = 0;
};
