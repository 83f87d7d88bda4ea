// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/parameterspec.h"
#include "protocol/telemetry/channelspec.h"

#include <array>
#include <limits>
#include <vector>

namespace simplebgc {

/// Telemetry channels of the family; the number is the position in channelTable().
// clang-format off
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
    // From here on: fields of CUSTOM that came after 2.60.
    Motor4Speed = RcChannel18 + 1, Motor4Error, Motor4Output, AhrsMainSource, AhrsFrameSource, AhrsMainZ, AhrsMainH,
    AhrsFrameZ, AhrsFrameH, ExtImuStatus, ExtImuPackets, ExtImuFaults, ExtImuH, ExtImuZ, EncoderRoll, EncoderPitch,
    EncoderYaw, ImuRadRoll, ImuRadPitch, ImuRadYaw, Imu20Roll, Imu20Pitch, Imu20Yaw, Target20Roll, Target20Pitch,
    Target20Yaw, FrameCam20Roll, FrameCam20Pitch, FrameCam20Yaw, ScriptFloat1, ScriptFloat2, ScriptFloat3, ScriptFloat4,
    ScriptFloat5, ScriptFloat6, ScriptFloat7, ScriptFloat8, ScriptFloat9, ScriptFloat10, ScriptInt1, ScriptInt2,
    ScriptInt3, ScriptInt4, ScriptInt5, ScriptInt6, ScriptInt7, ScriptInt8, ScriptInt9, ScriptInt10, MotorRollOutput,
    MotorRollCurrent, MotorRollTemperature, MotorRollFlags, MotorPitchOutput, MotorPitchCurrent, MotorPitchTemperature,
    MotorPitchFlags, MotorYawOutput, MotorYawCurrent, MotorYawTemperature, MotorYawFlags, PowerState, SupplyVoltage,
    SupplyCurrent, PowerFlags, FrameRateRoll, FrameRatePitch, FrameRateYaw, CommI2c, CommSerial, CommCan, CommCanFlags,
    StateFlags, CalibrationMode, ImuQuatW, ImuQuatX, ImuQuatY, ImuQuatZ, TargetQuatW, TargetQuatX, TargetQuatY,
    TargetQuatZ, FrameQuatW, FrameQuatX, FrameQuatY, FrameQuatZ, Adc1, Adc2, Adc3, Adc4, LimitRollLow, LimitRollHigh,
    LimitPitchLow, LimitPitchHigh, LimitYawLow, LimitYawHigh, FollowRoll, FollowPitch, FollowYaw, ExtLowRoll, ExtLowPitch,
    ExtLowYaw, ExtHighRoll, ExtHighPitch, ExtHighYaw,
    ChannelCount
};
// clang-format on

/// The channels of a firmware, or all; those added after 2.60 are at the end.
[[nodiscard]] ChannelTable channelTable(int firmware = std::numeric_limits<int>::max());

/// Fields of CUSTOM that each firmware with streams has (2.59/2.60, errata 3.9 bits 0-8).
inline constexpr quint32 kFirstCustomFlags = 0x1FF;
/// The first firmware that may have more.
inline constexpr int kLaterCustomFirmware = 2610;
/// Largest payload of a frame.
inline constexpr int kMaxPayload = 255;

/// Position of a channel's raw number in a payload and its conversion to a physical value.
struct WireField
{
    int channel = 0;
    int offset = 0;
    enum Type : std::uint8_t { U8, I8, U16, I16, RcSignal, U24, I32, U32, F32, Quaternion } type = I16;
    double scale = 1.0;
    int mask = 0;  ///< not 0: only these bits count; which of w, x, y, z of a quaternion
};

constexpr int fieldSize(WireField::Type type)
{
    switch (type) {
    case WireField::U8:
    case WireField::I8: return 1;
    case WireField::U16:
    case WireField::I16:
    case WireField::RcSignal: return 2;
    case WireField::U24: return 3;
    case WireField::I32:
    case WireField::U32:
    case WireField::F32: return 4;
    case WireField::Quaternion: return 8;
    }
    return 0;
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

/// The flags that deliver these channels; channels that CUSTOM does not have are ignored.
[[nodiscard]] quint32 customFlagsFor(const QList<int> &channels);
/// Payload size of a CUSTOM frame with these flags: 2 bytes of time stamp plus the fields.
[[nodiscard]] int customSize(quint32 flags);
/// The fields of such a frame in order, with offsets from the start of the payload.
[[nodiscard]] std::vector<WireField> customLayout(quint32 flags);

/// Fields of a real-time frame with that command number; flags apply to CUSTOM only. Empty: not a real-time
/// frame.
[[nodiscard]] std::vector<WireField> flowFields(int id, quint32 customFlags);

/// A unit quaternion w, x, y, z in eight bytes (errata 3.24).
[[nodiscard]] std::array<double, 4> unpackQuaternion(quint64 packed);
[[nodiscard]] quint64 packQuaternion(const std::array<double, 4> &quaternion);

/// The physical value of a field, NaN when the payload is too short, or no signal arrives (errata 3.23).
[[nodiscard]] float readField(const WireField &field, std::span<const std::byte> payload);

}  // namespace simplebgc
