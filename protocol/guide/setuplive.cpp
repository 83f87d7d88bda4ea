// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/guide/setuplive.h"

#include "protocol/telemetry/uniformsamples.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

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

// Of the last second. Empty: too few samples came.
std::optional<double> recentSpread(const TelemetryStore &telemetry, int channel)
{
    const double newest = telemetry.secondsAt(telemetry.latestAt(channel));
    const auto samples = uniformSamples(telemetry, channel, -1, newest - kRecently, newest);
    return samples ? std::optional(spreadOf(samples->values)) : std::nullopt;
}

}  // namespace

std::array<int, 3> SetupLiveSpec::channels(const ChannelRoles &roles) const
{
    return triple ? roles.*triple : std::array<int, 3>{roles.*single, -1, -1};
}

std::optional<double> SetupLiveSpec::value(const TelemetryStore &telemetry, int channel) const
{
    if (isSpread)
        return recentSpread(telemetry, channel);
    const double latest = double(telemetry.latest(channel));
    return std::isnan(latest) ? std::nullopt : std::optional(latest);
}

QString setupLiveText(SetupStep step, ChannelTable table, const ChannelRoles &roles,
                      const TelemetryStore &telemetry)
{
    QStringList rows;
    for (const SetupLiveSpec &spec : kLive) {
        QString row;
        const char *unit = "";
        for (const int channel : spec.step == step ? spec.channels(roles) : std::array{-1, -1, -1}) {
            if (channel < 0)
                continue;
            const ChannelSpec &each = table[std::size_t(channel)];
            const auto value = spec.value(telemetry, channel);
            row += u' ';
            row += value ? QString::number(*value, 'f', spec.isSpread ? kSpreadDecimals : each.decimals)
                         : u"–"_s;
            unit = each.unit;
        }
        if (!row.isEmpty())
            rows.append(QLatin1String(spec.label) + row
                        + (*unit ? u' ' + QString::fromUtf8(unit) : QString()));
    }
    return rows.join(u", "_s);
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
