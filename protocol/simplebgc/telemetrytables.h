// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/channelspec.h"
#include "protocol/device/parameterspec.h"

#include <vector>

namespace sbgc {

/// Telemetry channels of the family; the number is the position in channelTable().
enum ChannelId : int {
    ImuRoll, ImuPitch, ImuYaw,
    TargetRoll, TargetPitch, TargetYaw,
    GyroRoll, GyroPitch, GyroYaw,
    AccX, AccY, AccZ,
    RotorRoll, RotorPitch, RotorYaw,
    FrameRoll, FramePitch, FrameYaw,
    TargetSpeedRoll, TargetSpeedPitch, TargetSpeedYaw,
    PowerRoll, PowerPitch, PowerYaw,
    BalanceRoll, BalancePitch, BalanceYaw,
    RcRoll, RcPitch, RcYaw, RcCmd, FcRoll, FcPitch,
    Battery, Current, ImuTemperature, FrameTemperature,
    MagRoll, MagPitch, MagYaw,
    GravityError, HeadingError,
    CycleTime, I2cErrors, SerialErrors, SystemError, SubError, MotorsRunning, CurrentImu, CurrentProfile,
    Z1X, Z1Y, Z1Z, H1X, H1Y, H1Z,
    RcData1, RcData2, RcData3, RcData4, RcData5, RcData6,
    RcChannel1,
    RcChannel18 = RcChannel1 + 17,
    ChannelCount
};

[[nodiscard]] ChannelTable channelTable();

/// Where a channel's raw number stands in a payload and how it becomes a physical one.
struct WireField
{
    int channel = 0;
    int offset = 0;
    enum Type : std::uint8_t { U8, I8, U16, I16, F32 } type = I16;
    double scale = 1.0;
    int mask = 0;        ///< not 0: only these bits count
};

constexpr int fieldSize(WireField::Type type)
{
    return type == WireField::F32 ? 4 : type == WireField::U16 || type == WireField::I16 ? 2 : 1;
}

inline constexpr int kRealtime3Size = 63;
inline constexpr int kRealtime4Size = 124;
inline constexpr int kHelperSize = 24;

/// Fields of REALTIME_DATA_3 (offsets below 63) and REALTIME_DATA_4 (all), errata 3.8.
[[nodiscard]] std::span<const WireField> realtimeFields();

/// One selectable field of REALTIME_DATA_CUSTOM (errata 3.9); offsets count from the field's first byte.
struct CustomField
{
    int bit = 0;
    int bytes = 0;
    std::span<const WireField> fields;
};

[[nodiscard]] std::span<const CustomField> customFields();

/// The flags that deliver these channels; channels that CUSTOM does not have are passed over.
[[nodiscard]] quint32 customFlagsFor(const QList<int> &channels);
/// Payload size of a CUSTOM frame with these flags: 2 bytes of time stamp and the fields.
[[nodiscard]] int customSize(quint32 flags);
/// The fields of such a frame in order, offsets counted from the beginning of the payload.
[[nodiscard]] std::vector<WireField> customLayout(quint32 flags);

/// Fields of a real-time frame with that command number; flags count for CUSTOM only. Empty: no real-time frame.
[[nodiscard]] std::vector<WireField> flowFields(int id, quint32 customFlags);

/// The physical value of a field, NaN when the payload is too short.
[[nodiscard]] float readField(const WireField &field, std::span<const std::byte> payload);

} // namespace sbgc
