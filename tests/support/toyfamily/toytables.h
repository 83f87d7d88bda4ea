// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/parameterspec.h"
#include "protocol/device/actionspec.h"
#include "protocol/telemetry/channelspec.h"

#include <memory>

namespace toy {

enum Block : std::uint8_t { Settings, Mission };
enum Channel : std::uint8_t {
    Pitch,
    Yaw,
    PitchRate,
    YawRate,
    Motor1,
    Motor2,
    Motor3,
    Motor4,
    Motor5,
    Armed,
    Calibrated,
    Outputs,
    Battery,
    Spectrum,
};
constexpr int kSettingsSize = 20;
constexpr int kSpectrumBins = 257;
constexpr int kMotors = 5;

[[nodiscard]] std::span<const ParameterRow> parameterRows();
[[nodiscard]] std::span<const BlockSpec> blocks();
[[nodiscard]] ChannelTable channels();
[[nodiscard]] std::span<const ActionSpec> actions();
/// What a new board holds: one value of it is no number.
[[nodiscard]] QByteArray defaultSettings();

}  // namespace toy
