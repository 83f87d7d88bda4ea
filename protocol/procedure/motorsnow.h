// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/abilities.h"
#include "protocol/device/device.h"
#include "protocol/telemetry/roles.h"
#include "protocol/telemetry/telemetrystore.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

/// Whether the motors run, asked now. Errors: Unsupported (the board has no such question), those of the
/// link.
[[nodiscard]] inline Result<bool> askMotors(Channel &channel, const Device &device)
{
    const MotorSwitch *motors = device.motorSwitch();
    return motors ? motors->areMotorsOn(channel) : failure(ErrorCode::Unsupported);
}

/// The same; empty where the board does not tell.
[[nodiscard]] inline std::optional<bool> motorsIfTold(Channel &channel, const Device &device)
{
    const auto on = askMotors(channel, device);
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
    return isSwitched ? std::nullopt : motorsIfTold(channel, device);
}

/// Why what needs running motors cannot begin, by what the board has told last; empty: they run, or it tells
/// nothing of them at all.
[[nodiscard]] inline std::optional<Error> findMotorsNotRunning(const ChannelRoles &roles,
                                                               const TelemetryStore &telemetry)
{
    if (roles.outputs < 0)
        return {};
    const auto told = double(telemetry.latest(roles.outputs));
    if (std::isnan(told))
        return Error{ErrorCode::Unready, QStringLiteral("the board has not told yet whether its motors run"),
                     0};
    return told > 0.5 ? std::nullopt
                      : std::optional(Error{ErrorCode::Unready, QStringLiteral("the motors are off"), 0});
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
        run = motorsIfTold(channel, device);
    return run == ranBefore ? std::nullopt : run;
}
