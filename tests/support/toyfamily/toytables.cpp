// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/toyfamily/toytables.h"

#include "tests/support/toyfamily/toywire.h"

#include <limits>

namespace toy {
namespace {

// clang-format off
constexpr Choice kProtocols[] = {{0, "PWM"}, {1, "DShot300"}, {2, "DShot600"}};
constexpr Choice kLights[] = {{0, "Front"}, {1, "Rear"}, {9, "Siren"}};

constexpr ParameterRow kParameters[] = {
    {.key = "rate.gain", .label = "Rate gain", .group = "Flight", .help = "How hard the motors answer to a turn.", .block = Settings, .offset = 0,
     .wire = WireType::F32, .order = ByteOrder::Big, .min = 0, .max = 0.1, .decimals = 7, .defaults = {2e-6}, .level = ViewLevel::Basic, .scope = Scope::Board, .risk = Risk::Red},
    {.key = "hover.trim", .label = "Hover trim", .group = "Flight", .help = "Learned in flight.", .block = Settings, .offset = 4,
     .wire = WireType::F32, .order = ByteOrder::Big, .min = -1, .max = 1, .decimals = 3, .level = ViewLevel::Basic, .scope = Scope::Board},
    {.key = "flight.limit", .label = "Flight limit", .group = "Flight", .help = "Lands after so long.", .block = Settings, .offset = 8,
     .wire = WireType::U32, .order = ByteOrder::Big, .unit = "ms", .max = 4294967295, .defaults = {4000000000.0}, .level = ViewLevel::Basic, .scope = Scope::Board},
    {.key = "home.height", .label = "Home height", .group = "Flight", .help = "Above the sea.", .block = Settings, .offset = 12,
     .wire = WireType::I32, .order = ByteOrder::Big, .unit = "mm", .min = -2147483648.0, .max = 2147483647, .defaults = {-430000}, .level = ViewLevel::Basic, .scope = Scope::Board},
    {.key = "esc.protocol", .label = "Protocol", .group = "Motors", .help = "What the motor controllers speak.", .block = Settings, .offset = 16,
     .kind = ValueKind::Choice, .max = 2, .defaults = {1}, .choices = kProtocols, .level = ViewLevel::Basic, .scope = Scope::Board},
    {.key = "log.enabled", .label = "Log", .group = "Motors", .help = "Keeps a log of each flight.", .block = Settings, .offset = 17,
     .kind = ValueKind::Toggle, .max = 1, .level = ViewLevel::Basic, .scope = Scope::Board},
    {.key = "lights", .label = "Lights", .group = "Motors", .help = "Which lights are on.", .block = Settings, .offset = 18,
     .wire = WireType::U16, .order = ByteOrder::Big, .kind = ValueKind::Flags, .max = 1023, .defaults = {3}, .choices = kLights, .level = ViewLevel::Basic, .scope = Scope::Board},
};
static_assert(rangesFit(kParameters));
static_assert(coversBlock<kSettingsSize>(kParameters, Settings, {}));

constexpr BlockSpec kBlocks[] = {
    {.id = Settings, .name = "SETTINGS", .size = kSettingsSize},
    {.id = Mission, .name = "MISSION", .data = "Mission", .maxSize = 4096, .kind = DataKind::Text, .language = "lua",
     .effect = WriteEffect::Restarts, .restartTime = 5s},
};

constexpr ChannelSpec kChannels[] = {
    {"angle.pitch", "Pitch", "Attitude", "°", 1, Axis::Pitch, -90, 90, "attitude.pitch"},
    {"angle.yaw", "Yaw", "Attitude", "°", 1, Axis::Yaw, -180, 180, "attitude.yaw"},
    {"rate.pitch", "Pitch rate", "Attitude", "°/s", 1, Axis::Pitch, -200, 200, "rate.pitch"},
    {"rate.yaw", "Yaw rate", "Attitude", "°/s", 1, Axis::Yaw, -200, 200, "rate.yaw"},
    {"motor.1", "Motor 1", "Motors", "%", 0, Axis::None, 0, 100, "motor.1.output"},
    {"motor.2", "Motor 2", "Motors", "%", 0, Axis::None, 0, 100, "motor.2.output"},
    {"motor.3", "Motor 3", "Motors", "%", 0, Axis::None, 0, 100, "motor.3.output"},
    {"motor.4", "Motor 4", "Motors", "%", 0, Axis::None, 0, 100, "motor.4.output"},
    {"motor.5", "Motor 5", "Motors", "%", 0, Axis::None, 0, 100, "motor.5.output"},
    {"armed", "Armed", "State", "", 0, Axis::None, 0, 1, "armed"},
    {"calibrated", "Calibrated", "State", "", 0, Axis::None, 0, 1, "calibrated"},
    {"outputs", "Outputs", "State", "", 0, Axis::None, 0, 1, "outputs"},
    {"battery", "Battery", "State", "V", 2, Axis::None, 0, 20, "battery"},
    {.key = "spectrum", .label = "Vibration", .group = "Vibration", .unit = "dB", .decimals = 1, .min = -120, .max = 0, .elements = kSpectrumBins},
};

constexpr ArgumentSpec kBlink[] = {
    {.key = "light", .label = "Light", .kind = ArgumentKind::Choice, .choices = kLights, .defaultText = "Front"},
    {.key = "times", .label = "Times", .kind = ArgumentKind::Integer, .min = 1, .max = 20, .defaultText = "3"},
};
constexpr Condition kWhenDisarmed[] = {Condition::Disarmed};
constexpr Condition kWhenCalibrated[] = {Condition::Calibrated};

constexpr ActionSpec kActions[] = {
    {.key = "calibrate.level", .label = "Calibrate", .help = "Takes where it stands for level; the board is deaf meanwhile.", .group = "Sensors",
     .risk = ActionRisk::Writes, .needs = kWhenDisarmed, .confirm = "The propellers are off", .silence = 4s},
    {.key = "blink", .label = "Blink", .help = "Shows which board this is.", .group = "Lights", .arguments = kBlink},
    {.key = "home", .label = "Blink at home", .help = "Needs to know what is level.", .group = "Lights", .needs = kWhenCalibrated},
};
// clang-format on

}  // namespace

std::span<const ParameterRow> parameterRows()
{
    return kParameters;
}

std::span<const BlockSpec> blocks()
{
    return kBlocks;
}

ChannelTable channels()
{
    return kChannels;
}

std::span<const ActionSpec> actions()
{
    return kActions;
}

QByteArray defaultSettings()
{
    return pack([](QDataStream &out) {
        out << 2e-6F << std::numeric_limits<float>::quiet_NaN() << quint32(4000000000) << qint32(-430000)
            << quint8(1) << quint8(0) << quint16(3);
    });
}

}  // namespace toy
