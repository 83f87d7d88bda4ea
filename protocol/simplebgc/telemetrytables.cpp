// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/telemetrytables.h"

#include "protocol/base/bytes.h"
#include "protocol/simplebgc/commands.h"
#include "protocol/simplebgc/units.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

namespace sbgc {

namespace {

constexpr ChannelSpec kChannels[] = {
    {"imu.angle.roll", "Camera angle, roll", "Angles", "°", 2, Axis::Roll, -180, 180},
    {"imu.angle.pitch", "Camera angle, pitch", "Angles", "°", 2, Axis::Pitch, -180, 180},
    {"imu.angle.yaw", "Camera angle, yaw", "Angles", "°", 2, Axis::Yaw, -180, 180},
    {"target.angle.roll", "Target angle, roll", "Angles", "°", 2, Axis::Roll, -180, 180},
    {"target.angle.pitch", "Target angle, pitch", "Angles", "°", 2, Axis::Pitch, -180, 180},
    {"target.angle.yaw", "Target angle, yaw", "Angles", "°", 2, Axis::Yaw, -180, 180},
    {"gyro.roll", "Gyro, roll", "Inertial sensors", "°/s", 2, Axis::Roll, -200, 200},
    {"gyro.pitch", "Gyro, pitch", "Inertial sensors", "°/s", 2, Axis::Pitch, -200, 200},
    {"gyro.yaw", "Gyro, yaw", "Inertial sensors", "°/s", 2, Axis::Yaw, -200, 200},
    {"acc.x", "Acceleration, X", "Inertial sensors", "g", 3, Axis::Roll, -2, 2},
    {"acc.y", "Acceleration, Y", "Inertial sensors", "g", 3, Axis::Pitch, -2, 2},
    {"acc.z", "Acceleration, Z", "Inertial sensors", "g", 3, Axis::Yaw, -2, 2},
    {"rotor.angle.roll", "Motor angle, roll", "Angles", "°", 2, Axis::Roll, -180, 180},
    {"rotor.angle.pitch", "Motor angle, pitch", "Angles", "°", 2, Axis::Pitch, -180, 180},
    {"rotor.angle.yaw", "Motor angle, yaw", "Angles", "°", 2, Axis::Yaw, -180, 180},
    {"frame.angle.roll", "Frame angle, roll", "Angles", "°", 2, Axis::Roll, -180, 180},
    {"frame.angle.pitch", "Frame angle, pitch", "Angles", "°", 2, Axis::Pitch, -180, 180},
    {"frame.angle.yaw", "Frame angle, yaw", "Angles", "°", 2, Axis::Yaw, -180, 180},
    {"target.speed.roll", "Target speed, roll", "Angles", "°/s", 2, Axis::Roll, -200, 200},
    {"target.speed.pitch", "Target speed, pitch", "Angles", "°/s", 2, Axis::Pitch, -200, 200},
    {"target.speed.yaw", "Target speed, yaw", "Angles", "°/s", 2, Axis::Yaw, -200, 200},
    {"power.roll", "Motor power, roll", "Motors", "%", 0, Axis::Roll, 0, 100},
    {"power.pitch", "Motor power, pitch", "Motors", "%", 0, Axis::Pitch, 0, 100},
    {"power.yaw", "Motor power, yaw", "Motors", "%", 0, Axis::Yaw, 0, 100},
    {"balance.roll", "Balance error, roll", "Motors", "%", 1, Axis::Roll, -100, 100},
    {"balance.pitch", "Balance error, pitch", "Motors", "%", 1, Axis::Pitch, -100, 100},
    {"balance.yaw", "Balance error, yaw", "Motors", "%", 1, Axis::Yaw, -100, 100},
    {"rc.roll", "RC input, roll", "Remote control", "", 0, Axis::None, 1000, 2000},
    {"rc.pitch", "RC input, pitch", "Remote control", "", 0, Axis::None, 1000, 2000},
    {"rc.yaw", "RC input, yaw", "Remote control", "", 0, Axis::None, 1000, 2000},
    {"rc.cmd", "RC input, command", "Remote control", "", 0, Axis::None, 1000, 2000},
    {"fc.roll", "Flight controller input, roll", "Remote control", "", 0, Axis::None, 1000, 2000},
    {"fc.pitch", "Flight controller input, pitch", "Remote control", "", 0, Axis::None, 1000, 2000},
    {"battery", "Battery", "Power", "V", 2, Axis::None, 0, 30},
    {"current", "Current", "Power", "A", 3, Axis::None, 0, 10},
    {"temperature.imu", "IMU temperature", "Board", "°C", 0, Axis::None, -20, 80},
    {"temperature.frame", "Frame IMU temperature", "Board", "°C", 0, Axis::None, -20, 80},
    {"mag.roll", "Magnetometer, roll", "Inertial sensors", "", 0, Axis::Roll, -2000, 2000},
    {"mag.pitch", "Magnetometer, pitch", "Inertial sensors", "", 0, Axis::Pitch, -2000, 2000},
    {"mag.yaw", "Magnetometer, yaw", "Inertial sensors", "", 0, Axis::Yaw, -2000, 2000},
    {"error.gravity", "Gravity error", "Inertial sensors", "°", 1, Axis::None, 0, 25},
    {"error.heading", "Heading error", "Inertial sensors", "°", 1, Axis::None, 0, 25},
    {"cycle_time", "Cycle time", "Board", "µs", 0, Axis::None, 0, 2000},
    {"errors.i2c", "I2C errors", "Board", "", 0, Axis::None, 0, 100},
    {"errors.serial", "Bad frames received", "Board", "", 0, Axis::None, 0, 100},
    {"system.error", "System error bits", "Board", "", 0, Axis::None, 0, 4095},
    {"system.sub_error", "Emergency stop cause", "Board", "", 0, Axis::None, 0, 60},
    {"motors.on", "Motors running", "Board", "", 0, Axis::None, 0, 1},
    {"imu.selected", "Selected IMU", "Board", "", 0, Axis::None, 1, 2},
    {"profile.active", "Active profile", "Board", "", 0, Axis::None, 0, 4},
    {"z1.x", "Gravity vector, x", "Attitude vectors", "", 4, Axis::None, -1, 1},
    {"z1.y", "Gravity vector, y", "Attitude vectors", "", 4, Axis::None, -1, 1},
    {"z1.z", "Gravity vector, z", "Attitude vectors", "", 4, Axis::None, -1, 1},
    {"h1.x", "Heading vector, x", "Attitude vectors", "", 4, Axis::None, -1, 1},
    {"h1.y", "Heading vector, y", "Attitude vectors", "", 4, Axis::None, -1, 1},
    {"h1.z", "Heading vector, z", "Attitude vectors", "", 4, Axis::None, -1, 1},
    {"rc_fine.roll", "RC signal, roll", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_fine.pitch", "RC signal, pitch", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_fine.yaw", "RC signal, yaw", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_fine.command", "RC signal, command", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_fine.fc_roll", "RC signal, FC roll", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_fine.fc_pitch", "RC signal, FC pitch", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.1", "RC channel 1", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.2", "RC channel 2", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.3", "RC channel 3", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.4", "RC channel 4", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.5", "RC channel 5", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.6", "RC channel 6", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.7", "RC channel 7", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.8", "RC channel 8", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.9", "RC channel 9", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.10", "RC channel 10", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.11", "RC channel 11", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.12", "RC channel 12", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.13", "RC channel 13", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.14", "RC channel 14", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.15", "RC channel 15", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.16", "RC channel 16", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.17", "RC channel 17", "Remote control", "%", 2, Axis::None, -100, 100},
    {"rc_channel.18", "RC channel 18", "Remote control", "%", 2, Axis::None, -100, 100},
};
static_assert(std::size(kChannels) == ChannelCount);

constexpr double kPowerUnit = 100.0 / 255.0;      // 0-255 as percent of full power
constexpr double kBalanceUnit = 100.0 / 512.0;    // 512 = all of the motor's power
constexpr double kRcFineUnit = 100.0 / 16384.0;

// REALTIME_DATA_3 and _4, errata 3.8.
constexpr WireField kRealtime[] = {
    {AccX, 0, WireField::I16, kAccUnit}, {GyroRoll, 2, WireField::I16, kGyroUnit},
    {AccY, 4, WireField::I16, kAccUnit}, {GyroPitch, 6, WireField::I16, kGyroUnit},
    {AccZ, 8, WireField::I16, kAccUnit}, {GyroYaw, 10, WireField::I16, kGyroUnit},
    {SerialErrors, 12, WireField::U16}, {SystemError, 14, WireField::U16}, {SubError, 16, WireField::U8},
    {RcRoll, 20, WireField::I16}, {RcPitch, 22, WireField::I16}, {RcYaw, 24, WireField::I16},
    {RcCmd, 26, WireField::I16}, {FcRoll, 28, WireField::I16}, {FcPitch, 30, WireField::I16},
    {ImuRoll, 32, WireField::I16, kDegreesPerCount}, {ImuPitch, 34, WireField::I16, kDegreesPerCount},
    {ImuYaw, 36, WireField::I16, kDegreesPerCount}, {FrameRoll, 38, WireField::I16, kDegreesPerCount},
    {FramePitch, 40, WireField::I16, kDegreesPerCount}, {FrameYaw, 42, WireField::I16, kDegreesPerCount},
    {TargetRoll, 44, WireField::I16, kDegreesPerCount}, {TargetPitch, 46, WireField::I16, kDegreesPerCount},
    {TargetYaw, 48, WireField::I16, kDegreesPerCount}, {CycleTime, 50, WireField::U16},
    {I2cErrors, 52, WireField::U16}, {Battery, 55, WireField::U16, 0.01}, {MotorsRunning, 57, WireField::U8, 1, 1},
    {CurrentImu, 58, WireField::U8}, {CurrentProfile, 59, WireField::U8}, {PowerRoll, 60, WireField::U8, kPowerUnit},
    {PowerPitch, 61, WireField::U8, kPowerUnit}, {PowerYaw, 62, WireField::U8, kPowerUnit},
    {RotorRoll, 63, WireField::I16, kDegreesPerCount}, {RotorPitch, 65, WireField::I16, kDegreesPerCount},
    {RotorYaw, 67, WireField::I16, kDegreesPerCount}, {BalanceRoll, 70, WireField::I16, kBalanceUnit},
    {BalancePitch, 72, WireField::I16, kBalanceUnit}, {BalanceYaw, 74, WireField::I16, kBalanceUnit},
    {Current, 76, WireField::U16, 0.001}, {MagRoll, 78, WireField::I16}, {MagPitch, 80, WireField::I16},
    {MagYaw, 82, WireField::I16}, {ImuTemperature, 84, WireField::I8}, {FrameTemperature, 85, WireField::I8},
    {GravityError, 86, WireField::U8, 0.1}, {HeadingError, 87, WireField::U8, 0.1},
};

constexpr std::array<WireField, 3> three(int channel, double unit)
{
    return {WireField{channel, 0, WireField::I16, unit}, WireField{channel + 1, 2, WireField::I16, unit},
            WireField{channel + 2, 4, WireField::I16, unit}};
}

template<std::size_t N>
constexpr std::array<WireField, N> run(int channel, WireField::Type type, double unit)
{
    std::array<WireField, N> fields{};
    for (std::size_t i = 0; i < N; ++i)
        fields[i] = {channel + int(i), int(i) * fieldSize(type), type, unit};
    return fields;
}

constexpr auto kImu = three(ImuRoll, kDegreesPerCount);
constexpr auto kTarget = three(TargetRoll, kDegreesPerCount);
constexpr auto kTargetSpeed = three(TargetSpeedRoll, kGyroUnit);
constexpr auto kRotor = three(RotorRoll, kDegreesPerCount);
constexpr auto kGyro = three(GyroRoll, kGyroUnit);
constexpr auto kRcData = run<6>(RcData1, WireField::I16, kRcFineUnit);
constexpr auto kVectors = run<6>(Z1X, WireField::F32, 1.0);
constexpr auto kRcChannels = run<18>(RcChannel1, WireField::I16, kRcFineUnit);
constexpr auto kAcc = three(AccX, kAccUnit);

// The nine fields of firmware 2.59/2.60 (errata 3.9, bits 0-8).
constexpr CustomField kCustom[] = {
    {0, 6, kImu},      {1, 6, kTarget},   {2, 6, kTargetSpeed}, {3, 6, kRotor}, {4, 6, kGyro},
    {5, 12, kRcData},  {6, 24, kVectors}, {7, 36, kRcChannels}, {8, 6, kAcc},
};

} // namespace

ChannelTable channelTable()
{
    return kChannels;
}

std::span<const WireField> realtimeFields()
{
    return kRealtime;
}

std::span<const CustomField> customFields()
{
    return kCustom;
}

quint32 customFlagsFor(const QList<int> &channels)
{
    quint32 flags = 0;
    for (const CustomField &field : kCustom) {
        for (const WireField &wire : field.fields) {
            if (channels.contains(wire.channel))
                flags |= 1U << field.bit;
        }
    }
    return flags;
}

int customSize(quint32 flags)
{
    int size = 2;
    for (const CustomField &field : kCustom) {
        if (flags & (1U << field.bit))
            size += field.bytes;
    }
    return size;
}

std::vector<WireField> customLayout(quint32 flags)
{
    std::vector<WireField> layout;
    int offset = 2;
    for (const CustomField &field : kCustom) {
        if (!(flags & (1U << field.bit)))
            continue;
        for (WireField wire : field.fields) {
            wire.offset += offset;
            layout.push_back(wire);
        }
        offset += field.bytes;
    }
    return layout;
}

std::vector<WireField> flowFields(int id, quint32 customFlags)
{
    switch (static_cast<CommandId>(id)) {
    case CommandId::RealtimeDataCustom:
        return customLayout(customFlags);
    case CommandId::AhrsHelper:
        return {kVectors.begin(), kVectors.end()};   // errata 3.22: Z, then H, as in CUSTOM
    case CommandId::RealtimeData3:
    case CommandId::RealtimeData4: {
        std::vector<WireField> fields;
        std::copy_if(std::begin(kRealtime), std::end(kRealtime), std::back_inserter(fields), [id](const WireField &field) {
            return id == number(CommandId::RealtimeData4) || field.offset < kRealtime3Size;
        });
        return fields;
    }
    default:
        return {};
    }
}

float readField(const WireField &field, std::span<const std::byte> payload)
{
    const auto offset = static_cast<std::size_t>(field.offset);
    if (payload.size() < offset + static_cast<std::size_t>(fieldSize(field.type)))
        return std::numeric_limits<float>::quiet_NaN();
    ByteReader reader(payload.subspan(offset));
    double value = 0;
    switch (field.type) {
    case WireField::U8: value = reader.u8(); break;
    case WireField::I8: value = reader.i8(); break;
    case WireField::U16: value = reader.u16(); break;
    case WireField::I16: value = reader.i16(); break;
    case WireField::F32: value = double(reader.f32()); break;
    }
    if (field.mask)
        value = static_cast<int>(value) & field.mask;
    return static_cast<float>(value * field.scale);
}

} // namespace sbgc
