// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/parametertables.h"

#include "protocol/simplebgc/choices.h"

namespace simplebgc {

std::span<const ParameterRow> parameterRows()
{
    static const std::vector<ParameterRow> rows = [] {
        std::vector<ParameterRow> all;
        for (const auto part : {params3Rows(), paramsExtRows(), paramsExt2Rows()})
            all.insert(all.end(), part.begin(), part.end());
        return all;
    }();
    return rows;
}

std::span<const ValueRule> valueRules()
{
    using enum ValueRule::Kind;
    static constexpr const char *kSensor = "one axis of a sensor cannot point both up and to the right";
    static constexpr const char *kPort = "two motors cannot be at the same output";
    static constexpr ValueRule kRules[] = {
        {OtherDirection, "imu.main.axis_top", "imu.main.axis_right", kSensor},
        {OtherDirection, "imu.frame.axis_top", "imu.frame.axis_right", kSensor},
        {OtherDirection, "imu.mag.axis_top", "imu.mag.axis_right", kSensor},
        {OtherUnlessZero, "motor.roll.output", "motor.pitch.output", kPort},
        {OtherUnlessZero, "motor.roll.output", "motor.yaw.output", kPort},
        {OtherUnlessZero, "motor.pitch.output", "motor.yaw.output", kPort},
    };
    return kRules;
}

std::span<const Choice> menuActions()
{
    return kMenuActions;
}

std::span<const Choice> signalSources()
{
    return kSignalSources;
}

}  // namespace simplebgc
