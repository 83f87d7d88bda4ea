// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/guide/setuplive.h"

#include "protocol/telemetry/uniformsamples.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kRecently = 1;  // seconds

// clang-format off
constexpr SetupLiveSpec kLive[] = {
    {SetupStep::Power, "Voltage", nullptr, &ChannelRoles::battery},
    {SetupStep::Power, "Current of the gimbal", nullptr, &ChannelRoles::current},
    {SetupStep::Sensors, "Turn rate varies by", &ChannelRoles::gyro, nullptr, true},
    {SetupStep::Sensors, "Angle of the frame", &ChannelRoles::frameAngle},
    {SetupStep::Gyroscope, "Turn rate", &ChannelRoles::gyro},
    {SetupStep::Gyroscope, "Turn rate varies by", &ChannelRoles::gyro, nullptr, true},
    {SetupStep::Orientation, "Angle", &ChannelRoles::angle},
    {SetupStep::Orientation, "Acceleration X, Y, Z", &ChannelRoles::acc},
    {SetupStep::Level, "Angle", &ChannelRoles::angle},
    {SetupStep::Level, "Acceleration X, Y, Z", &ChannelRoles::acc},
    {SetupStep::Balance, "Angle", &ChannelRoles::angle},
    {SetupStep::Balance, "Turn rate", &ChannelRoles::gyro},
    {SetupStep::Motors, "Angle", &ChannelRoles::angle},
    {SetupStep::Motors, "Turn rate", &ChannelRoles::gyro},
    {SetupStep::Motors, "Motor power", &ChannelRoles::motorPower},
    {SetupStep::MotorPower, "Angle", &ChannelRoles::angle},
    {SetupStep::MotorPower, "Target", &ChannelRoles::target},
    {SetupStep::MotorPower, "Motor power", &ChannelRoles::motorPower},
    {SetupStep::MotorPower, "Temperature of the motor", &ChannelRoles::motorTemperature},
    {SetupStep::MotorPower, "Current of the gimbal", nullptr, &ChannelRoles::current},
    {SetupStep::Gains, "Angle", &ChannelRoles::angle},
    {SetupStep::Gains, "Target", &ChannelRoles::target},
    {SetupStep::Gains, "Turn rate varies by", &ChannelRoles::gyro, nullptr, true},
    {SetupStep::Vibration, "Turn rate varies by", &ChannelRoles::gyro, nullptr, true},
    {SetupStep::Limits, "Angle", &ChannelRoles::angle},
    {SetupStep::Limits, "Angle of the motor", &ChannelRoles::joint},
    {SetupStep::Use, "Angle", &ChannelRoles::angle},
    {SetupStep::Use, "Angle of the frame", &ChannelRoles::frameAngle},
};
// clang-format on

}  // namespace

std::array<int, 3> SetupLiveSpec::channels(const ChannelRoles &roles) const
{
    return triple ? roles.*triple : std::array<int, 3>{roles.*single, -1, -1};
}

std::span<const SetupLiveSpec> setupLive()
{
    return kLive;
}

double spreadOf(std::span<const float> values)
{
    double sum = 0;
    double squares = 0;
    for (const float value : values) {
        sum += double(value);
        squares += double(value) * double(value);
    }
    const auto count = double(std::max<std::size_t>(1, values.size()));
    return std::sqrt(std::max(0.0, squares / count - sum * sum / count / count));
}

std::optional<double> recentSpread(const TelemetryStore &telemetry, int channel)
{
    const double newest = telemetry.secondsAt(telemetry.latestAt(channel));
    const auto samples = uniformSamples(telemetry, channel, -1, newest - kRecently, newest);
    return samples ? std::optional(spreadOf(samples->values)) : std::nullopt;
}
