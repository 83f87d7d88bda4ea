// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a drone with BCFlight holds, measures and does, as tables (errata 4, 6, 7).
#pragma once

#include "protocol/bcflight/blocks.h"
#include "protocol/configuration/parameterspec.h"
#include "protocol/device/actionspec.h"
#include "protocol/telemetry/channelspec.h"

namespace bcflight {

/// The block of gains as this program lays it out, big-endian floats: P, I, D of roll, pitch and yaw, the
/// horizon's offset in roll and pitch, and P, I, D of the outer controller.
inline constexpr int kRateGains = 9;
inline constexpr int kOffsets = 2;
inline constexpr int kOuterGains = 3;
inline constexpr int kGainsSize = 4 * (kRateGains + kOffsets + kOuterGains);
inline constexpr int kLiveValues = kRateGains + kOffsets;  ///< variables, numbered from 0 as in the block

inline constexpr int kLargestText = 60000;  ///< bytes (errata 7.3)
inline constexpr int kMostMotors = 8;
inline constexpr int kSpectrumBins = 257;

/// Channels, as positions in channels().
enum Quantity : std::uint8_t {
    AttitudeRoll,
    RateRoll = AttitudeRoll + 3,
    GyroX = RateRoll + 3,
    AccelX = GyroX + 3,
    FieldX = AccelX + 3,
    SlowRateRoll = FieldX + 3,
    AccelLength = SlowRateRoll + 3,
    Height,
    Thrust,
    Motor1,
    BatteryVolts = Motor1 + kMostMotors,
    BatteryCharge,
    BatteryCurrent,
    BatteryShare,
    CpuLoad,
    CpuCelsius,
    LinkQuality,
    LinkLevel,
    RoundTrip,  ///< as this program has measured it with the PING before
    Loops,
    State,  ///< the bits of STATUS
    Armed,
    Calibrated,
    Calibrating,
    Outputs,  ///< an output is above 0
    SpectrumRoll,
    BatteryCells = SpectrumRoll + 3,  ///< as its level shows that it counts them
    ChannelCount
};

[[nodiscard]] std::span<const ParameterRow> parameterRows();
[[nodiscard]] std::span<const BlockSpec> blocks();
[[nodiscard]] ChannelTable channels();
[[nodiscard]] std::span<const ActionSpec> actions();

}  // namespace bcflight
