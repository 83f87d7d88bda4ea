// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/device/steering.h"

#include <algorithm>
#include <limits>

int SteeringMode::inputOf(Axis axis) const
{
    const auto it = std::find_if(inputs.begin(), inputs.end(),
                                 [axis](const SteeringInput &input) { return input.axis == axis; });
    return it == inputs.end() ? -1 : int(it - inputs.begin());
}

int SteeringMode::find(const char *wanted) const
{
    const auto it = std::find_if(inputs.begin(), inputs.end(), [wanted](const SteeringInput &input) {
        return qstrcmp(input.key, wanted) == 0;
    });
    return it == inputs.end() ? -1 : int(it - inputs.begin());
}

bool SteeringMode::isPositional() const
{
    return std::any_of(inputs.begin(), inputs.end(), [](const SteeringInput &input) {
        return input.axis != Axis::None && !input.springsBack;
    });
}

std::array<double, kAxisCount> Steering::levelAngles(const LatestValues &) const
{
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    return {kUnknown, kUnknown, kUnknown};
}

const SteeringMode *Steering::mode(int id) const
{
    const auto all = modes();
    const auto it
        = std::find_if(all.begin(), all.end(), [id](const SteeringMode &mode) { return mode.id == id; });
    return it == all.end() ? nullptr : &*it;
}
