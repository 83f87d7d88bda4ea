// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/abilities.h"
#include "protocol/device/device.h"

#include <algorithm>
#include <optional>
#include <vector>

/// Whether the motors run, asked now; empty where the board does not tell.
[[nodiscard]] inline std::optional<bool> askMotors(Channel &channel, const Device &device)
{
    const MotorSwitch *motors = device.motorSwitch();
    const auto on = motors ? motors->areMotorsOn(channel) : failure(ErrorCode::Unsupported);
    return on ? std::optional(*on) : std::nullopt;
}

/// The same before these are changed; empty also where that starts or stops them.
[[nodiscard]] inline std::optional<bool> askMotorsBefore(Channel &channel, const Device &device,
                                                         const std::vector<const ParameterSpec *> &changed)
{
    const MotorSwitch *motors = device.motorSwitch();
    const bool isSwitched = motors
        && std::any_of(changed.begin(), changed.end(),
                       [motors](const ParameterSpec *spec) { return motors->isSwitchedBy(*spec); });
    return isSwitched ? std::nullopt : askMotors(channel, device);
}

/// For the details of an error.
[[nodiscard]] inline QString motorsChangedText(bool run)
{
    return run ? QStringLiteral("the motors run now; before this they were off")
               : QStringLiteral("the motors are off now; before this they were running");
}

/// Whether they run now, if that is otherwise than before; empty: it is not, or the board does not tell.
[[nodiscard]] inline std::optional<bool> findMotorsChanged(Channel &channel, const Device &device,
                                                           std::optional<bool> ranBefore)
{
    // A board that told before and does not now may be starting, or still answer something else.
    std::optional<bool> run;
    for (int tries = 0; tries < 2 && ranBefore && !run; ++tries)
        run = askMotors(channel, device);
    return run == ranBefore ? std::nullopt : run;
}
