// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/parametertables.h"

namespace simplebgc {

namespace {

constexpr Choice kFilters[] = {{0, "Notch 1"}, {1, "Notch 2"}, {2, "Notch 3"}, {3, "Low-pass"}};
// clang-format off
constexpr Choice kEncoderTypes[] = {
    {0, "None"}, {1, "AS5048A (SPI)"}, {2, "AS5048B (I2C)"}, {3, "AS5048 PWM"}, {4, "AMT203"}, {5, "MA3 10 bit"},
    {6, "MA3 12 bit"}, {7, "Analog"}, {8, "I2C driver 1"}, {9, "I2C driver 2"}, {10, "I2C driver 3"},
    {11, "I2C driver 4"}, {12, "AS5600 PWM"}, {13, "AS5600 I2C"}, {14, "RLS Orbis", 2600},
    {15, "RLS Orbis PWM", 2600}};
// Of an SPI encoder the clock; of an I2C driver the encoder inside, which is assumed to be numbered as above.
constexpr Choice kEncoderConfigs[] = {
    {0, "1 MHz"}, {1, "2 MHz (in a driver: AS5048A)"}, {2, "4 MHz (in a driver: AS5048B)"},
    {3, "500 kHz (in a driver: AS5048 PWM)"}, {4, "In a driver: AMT203"}, {5, "In a driver: MA3 10 bit"},
    {6, "In a driver: MA3 12 bit"}, {7, "In a driver: analog"}, {12, "In a driver: AS5600 PWM"},
    {13, "In a driver: AS5600 I2C"}, {14, "In a driver: RLS Orbis", 2600}, {15, "In a driver: RLS Orbis PWM", 2600}};

constexpr double kAngle14 = 0.02197265625;  // degrees per count (errata 0)

constexpr ParameterRow kParamsExtRows[] = {
    {.key = "state.blockext_profile", .label = "Profile of this block", .group = "Board state",
     .help = "The profile this block of values belongs to.",
     .block = ParamsExt, .offset = 0, .level = ViewLevel::Expert, .state = true},
    {.key = "filter.%a.notch%n.frequency", .label = "Notch %1 frequency", .group = "Filters",
     .help = "Center of the band that is taken out; set it on the resonance of the structure.",
     .block = ParamsExt, .offset = 1, .axes = 3, .axisStride = 6, .count = 3, .countStride = 1, .unit = "Hz",
     .scale = 2},
    {.key = "filter.%a.notch%n.width", .label = "Notch %1 width", .group = "Filters",
     .help = "Width of the band at -3 dB.",
     .block = ParamsExt, .offset = 4, .axes = 3, .axisStride = 6, .count = 3, .countStride = 1, .unit = "Hz"},
    {.key = "filter.%a.lpf", .label = "Low-pass frequency", .group = "Filters",
     .help = "Frequency above which the controller no longer reacts. Lower is quieter and slower.",
     .block = ParamsExt, .offset = 19, .wire = WireType::U16, .axes = 3, .axisStride = 2, .unit = "Hz", .max = 1000,
     .defaults = {400, 400, 400}, .adjustable = 45},
    {.key = "filter.%a.enabled", .label = "Filters in use", .group = "Filters",
     .help = "Which of the filters of this axis work.",
     .block = ParamsExt, .offset = 25, .kind = ValueKind::Flags, .axes = 3, .axisStride = 1, .choices = kFilters},
    {.key = "encoder.%a.offset", .label = "Encoder offset", .group = "Encoders",
     .help = "Encoder reading in the normal position; found by calibration.",
     .block = ParamsExt, .offset = 28, .wire = WireType::I16, .axes = 3, .axisStride = 2, .unit = "°",
     .scale = kAngle14, .min = -32768, .max = 32767, .decimals = 2, .scope = Scope::Board, .risk = Risk::Red,
     .capability = "encoders"},
    {.key = "encoder.%a.field_offset", .label = "Electrical field offset", .group = "Encoders",
     .help = "Angle between encoder zero and the motor's field; found by calibration. If it is wrong, the motor runs away.",
     .block = ParamsExt, .offset = 34, .wire = WireType::I16, .axes = 3, .axisStride = 2, .unit = "°",
     .scale = kAngle14, .min = -32768, .max = 32767, .decimals = 2, .scope = Scope::Board, .risk = Risk::Red,
     .capability = "encoders"},
    {.key = "encoder.%a.manual_set_time", .label = "Set-by-hand time", .group = "Encoders",
     .help = "How long the camera must be held before its new position is taken over.",
     .block = ParamsExt, .offset = 40, .axes = 3, .axisStride = 1, .unit = "ms", .scale = 10,
     .scope = Scope::Board, .capability = "encoders"},
    {.key = "motor.%a.heating", .label = "Heating factor", .group = "Motors",
     .help = "How fast this motor is taken to warm up; 0 = no heat model.",
     .block = ParamsExt, .offset = 43, .axes = 3, .axisStride = 1, .scope = Scope::Board, .risk = Risk::Red},
    {.key = "motor.%a.cooling", .label = "Cooling factor", .group = "Motors",
     .help = "How fast this motor is taken to cool down.",
     .block = ParamsExt, .offset = 46, .axes = 3, .axisStride = 1, .scope = Scope::Board, .risk = Risk::Red},
    {.key = "follow.inside_deadband", .label = "Rate inside the dead band", .group = "Follow",
     .help = "How much is still followed inside the dead band.",
     .block = ParamsExt, .offset = 51, .defaults = {50}},
    {.key = "motor.%a.magnetic_link_old", .label = "Magnetic link (old)", .group = "Motors",
     .help = "Replaced by the fine magnetic link.",
     .block = ParamsExt, .offset = 52, .axes = 3, .axisStride = 1, .level = ViewLevel::Expert,
     .scope = Scope::Board},
    {.key = "motor.%a.gearing", .label = "Gearing", .group = "Motors",
     .help = "Turns of the motor per turn of the axis; 1 = direct drive.",
     .block = ParamsExt, .offset = 55, .wire = WireType::U16, .axes = 3, .axisStride = 2, .scale = 1.0 / 256,
     .max = 65535, .decimals = 3, .defaults = {256, 256, 256}, .scope = Scope::Board, .risk = Risk::Red},
    {.key = "encoder.%a.limit_min", .label = "Lower limit", .group = "Encoders",
     .help = "Motor angle that the axis does not go below.",
     .block = ParamsExt, .offset = 61, .wire = WireType::I8, .axes = 3, .axisStride = 1, .unit = "°", .scale = 3,
     .min = -127, .max = 127, .scope = Scope::Board, .risk = Risk::Red, .until = 2609, .capability = "encoders"},
    {.key = "encoder.%a.limit_max", .label = "Upper limit", .group = "Encoders",
     .help = "Motor angle that the axis does not go above.",
     .block = ParamsExt, .offset = 64, .wire = WireType::I8, .axes = 3, .axisStride = 1, .unit = "°", .scale = 3,
     .min = -127, .max = 127, .scope = Scope::Board, .risk = Risk::Red, .until = 2609, .capability = "encoders"},
    {.key = "filter.%a.notch%n.gain", .label = "Notch %1 gain", .group = "Filters",
     .help = "Depth of the notch; negative makes it a peak.",
     .block = ParamsExt, .offset = 67, .wire = WireType::I8, .axes = 3, .axisStride = 1, .count = 3,
     .countStride = 3, .unit = "dB", .min = -100, .max = 100, .defaults = {100, 100, 100}},
    {.key = "service.beeper_volume", .label = "Beeper volume", .group = "Service",
     .help = "Loudness of the sounds made by the motors.",
     .block = ParamsExt, .offset = 76, .defaults = {97}, .scope = Scope::Board},
    {.key = "encoder.%a.gear_ratio", .label = "Encoder gear ratio", .group = "Encoders",
     .help = "Turns of the encoder per turn of the motor.",
     .block = ParamsExt, .offset = 77, .wire = WireType::U16, .axes = 3, .axisStride = 2, .scale = 0.001,
     .max = 65535, .decimals = 3, .defaults = {1000, 1000, 1000}, .scope = Scope::Board, .risk = Risk::Red,
     .capability = "encoders"},
    {.key = "encoder.%a.type", .label = "Encoder type", .group = "Encoders",
     .help = "Model of the encoder on this axis. If it is wrong, the motor runs away.",
     .block = ParamsExt, .offset = 83, .bitShift = 0, .bitCount = 4, .kind = ValueKind::Choice, .axes = 3,
     .axisStride = 1, .max = 15, .choices = kEncoderTypes, .scope = Scope::Board, .risk = Risk::Red,
     .capability = "encoders"},
    {.key = "encoder.%a.skip_detection", .label = "Skip detection", .group = "Encoders",
     .help = "Do not test the encoder at start.",
     .block = ParamsExt, .offset = 83, .bitShift = 4, .bitCount = 1, .kind = ValueKind::Toggle, .axes = 3,
     .axisStride = 1, .max = 1, .scope = Scope::Board, .risk = Risk::Red, .capability = "encoders"},
    {.key = "encoder.%a.type_reserved", .label = "Encoder type, further bits", .group = "Encoders",
     .help = "Bits 5 and 6 of the type byte, without documented meaning. Kept as read.",
     .block = ParamsExt, .offset = 83, .bitShift = 5, .bitCount = 2, .axes = 3, .axisStride = 1, .max = 3,
     .level = ViewLevel::Expert, .scope = Scope::Board, .state = true},
    {.key = "encoder.%a.geared", .label = "Geared encoder", .group = "Encoders",
     .help = "The encoder turns faster or slower than the axis.",
     .block = ParamsExt, .offset = 83, .bitShift = 7, .bitCount = 1, .kind = ValueKind::Toggle, .axes = 3,
     .axisStride = 1, .max = 1, .scope = Scope::Board, .risk = Risk::Red, .capability = "encoders"},
    {.key = "encoder.%a.config", .label = "Encoder bus speed", .group = "Encoders",
     .help = "Clock of an SPI encoder; for an I2C driver the type of its own encoder.",
     .block = ParamsExt, .offset = 86, .kind = ValueKind::Choice, .axes = 3, .axisStride = 1,
     .choices = kEncoderConfigs, .scope = Scope::Board, .capability = "encoders"},
    {.key = "pid.%a.outer_p", .label = "Outer P", .group = "Stabilization",
     .help = "Gain of the outer loop, from angle error to wanted speed.",
     .block = ParamsExt, .offset = 89, .axes = 3, .axisStride = 1, .defaults = {100, 100, 100}},
    {.key = "pid.%a.outer_i", .label = "Outer I", .group = "Stabilization",
     .help = "Integral part of the outer loop.",
     .block = ParamsExt, .offset = 92, .axes = 3, .axisStride = 1, .level = ViewLevel::Expert, .until = 2599},
    {.key = "imu.mag.axis_top", .label = "Magnetometer: axis up", .group = "Sensors",
     .help = "Which axis of the magnetometer points up.",
     .block = ParamsExt, .offset = 95, .wire = WireType::I8, .kind = ValueKind::Choice, .min = -3, .max = 3,
     .defaults = {3}, .choices = kSensorAxes, .scope = Scope::Board, .risk = Risk::Red},
    {.key = "imu.mag.axis_right", .label = "Magnetometer: axis right", .group = "Sensors",
     .help = "Which axis of the magnetometer points right.",
     .block = ParamsExt, .offset = 96, .wire = WireType::I8, .kind = ValueKind::Choice, .min = -3, .max = 3,
     .defaults = {1}, .choices = kSensorAxes, .scope = Scope::Board, .risk = Risk::Red},
    {.key = "imu.mag.trust", .label = "Magnetometer trust", .group = "Sensors",
     .help = "How strongly the heading follows the magnetometer.",
     .block = ParamsExt, .offset = 97, .defaults = {50}},
    {.key = "imu.mag.declination", .label = "Magnetic declination", .group = "Sensors",
     .help = "Angle between magnetic and true north at this place.",
     .block = ParamsExt, .offset = 98, .wire = WireType::I8, .unit = "°", .min = -127, .max = 127,
     .scope = Scope::Board, .until = 2599},
    {.key = "imu.mag.declination", .label = "Magnetic declination", .group = "Sensors",
     .help = "Angle between magnetic and true north at this place.",
     .block = ParamsExt, .offset = 98, .wire = WireType::I8, .unit = "°", .min = -90, .max = 90,
     .scope = Scope::Board, .since = 2600},
    {.key = "imu.acc_lpf", .label = "Accelerometer low-pass", .group = "Sensors",
     .help = "Smooths the accelerometer against vibration and accelerated motion; 0 = off.",
     .block = ParamsExt, .offset = 99, .wire = WireType::U16, .unit = "Hz", .scale = 0.01, .max = 1000,
     .decimals = 2, .defaults = {20}},
    {.key = "filter.%a.d_lpf", .label = "D-term low-pass", .group = "Filters",
     .help = "Smooths the D term alone; 0 = off. Lower lets D be higher before noise is heard.",
     .block = ParamsExt, .offset = 101, .axes = 3, .axisStride = 1, .unit = "Hz", .scale = 10, .max = 60,
     .defaults = {20, 20, 20}},
};
// clang-format on

constexpr std::pair<int, int> kParamsExtReserved[] = {{49, 2}};
static_assert(coversBlock<kParamsExtSize>(kParamsExtRows, ParamsExt, kParamsExtReserved));
static_assert(rangesFit(kParamsExtRows));

}  // namespace

std::span<const ParameterRow> paramsExtRows()
{
    return kParamsExtRows;
}

}  // namespace simplebgc
