// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/abilities.h"
#include "protocol/device/device.h"

#include <optional>

/// Whether the motors run, asked now; empty where the board does not tell.
[[nodiscard]] inline std::optional<bool> askMotors(Channel &channel, const Device &device)
{
    const MotorSwitch *motors = device.motorSwitch();
    const auto on = motors ? motors->areMotorsOn(channel) : failure(ErrorCode::Unsupported);
    return on ? std::optional(*on) : std::nullopt;
}
