// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/parameterspec.h"

#include <array>

/// Choice lists shared by the parameter tables (document "Variables description and range", errata 4).
namespace simplebgc {

inline constexpr int kScriptFile = 1;  ///< type of a file (errata 3.21)
inline constexpr int kFilePage = 64;  ///< bytes
inline constexpr int kLargestFile = 65535;
inline constexpr int kWholeMemory = 0;  ///< part of a copy that is restored
inline constexpr int kAllMotors = 255;  ///< of ENCODERS_CALIB_OFFSET_4
inline constexpr int kMostI2c = 64;  ///< bytes that one command reads or writes on a bus

// clang-format off
inline constexpr Choice kMenuActions[] = {
    {0, "No action"}, {1, "Use profile 1"}, {2, "Use profile 2"}, {3, "Use profile 3"}, {14, "Use profile 4"},
    {15, "Use profile 5"}, {4, "Swap RC pitch and roll"}, {5, "Swap RC yaw and roll"},
    {6, "Calibrate accelerometer"}, {9, "Calibrate gyroscope"}, {20, "Calibrate gyroscope (temperature)"},
    {21, "Calibrate accelerometer (temperature)"}, {33, "Calibrate magnetometer"}, {7, "Reset board"},
    {8, "Set tilt angles by hand"}, {37, "Set tilt angles by hand, do not save"}, {10, "Motors on/off"},
    {11, "Motors on"}, {12, "Motors off"}, {13, "Frame upside-down", 2600}, {16, "Auto PID"}, {17, "Look down"},
    {18, "Home position"}, {19, "Bind RC receiver"}, {22, "Menu button press"}, {23, "Run script 1"},
    {24, "Run script 2"}, {25, "Run script 3"}, {26, "Run script 4"}, {27, "Run script 5"},
    {28, "Run script 6", 2600}, {29, "Run script 7", 2600}, {30, "Run script 8", 2600},
    {31, "Run script 9", 2600}, {32, "Run script 10", 2600}, {34, "Level roll and pitch"}, {35, "Center yaw"},
    {36, "Untwist cables"}, {38, "Home position, shortest way", 2600}, {39, "Center yaw, shortest way", 2600},
    {40, "Rotate yaw 180 deg", 2600}, {41, "Rotate yaw 180 deg, relative to frame", 2600},
    {42, "Switch yaw 180 deg, relative to frame", 2600}, {43, "Switch roll 90 deg", 2600},
    {44, "Start time-lapse", 2600}, {45, "Calibrate momentum", 2620}, {46, "Level roll", 2600},
    {47, "Repeat time-lapse", 2600}, {48, "Load profile set 1", 2620}, {49, "Load profile set 2", 2620},
    {50, "Load profile set 3", 2620}, {51, "Load profile set 4", 2620}, {52, "Load profile set 5", 2620},
    {53, "Load backup set", 2620}, {54, "Invert RC roll", 2620}, {55, "Invert RC pitch", 2620},
    {56, "Invert RC yaw", 2620}, {57, "Snap to fixed position", 2620}, {58, "Camera: record or photo", 2660},
    {59, "Camera: photo", 2660}, {60, "Motors: safe stop", 2680}, {61, "Calibrate accelerometer (automatic)", 2680},
    {62, "Reset IMU", 2680}, {63, "Forced follow on/off", 2680}, {64, "Auto PID, gain only", 2680},
    {65, "Level pitch", 2680}, {66, "Motors: safe stop/on", 2680}, {67, "Time-lapse step 1", 2700},
    {68, "Calibrate external gyroscope", 2700}, {69, "Follow off/on", 2700}, {70, "Take position as home", 2700},
    {71, "Stop script", 2700}, {72, "Tripod mode off", 2700}, {73, "Tripod mode on", 2700},
    {74, "Set RC trim", 2700}, {75, "Home position of motors", 2730}, {76, "Retracted position", 2730},
    {77, "Shake generator off", 2730}, {78, "Shake generator on", 2730}, {79, "Servo mode on", 2730},
    {80, "Servo mode off", 2730}, {81, "Servo mode on/off", 2730},
};
// clang-format on

/// What becomes of the board's permanent memory; the others of kMenuActions only move something, or change
/// what is in use. A calibration goes on after the board has confirmed the entry, and nothing tells its end.
struct MenuEffect
{
    int action;
    bool destroys = false;
    bool goesOn = false;
};
// clang-format off
inline constexpr int kMenuMotorsSwitch = 10;
inline constexpr int kMenuMotorsOn = 11;
inline constexpr int kMenuMotorsOff = 12;
inline constexpr MenuEffect kMenuEffects[] = {
    {4}, {5}, {6, false, true}, {8}, {9, false, true}, {13}, {16, false, true}, {19, false, true},
    {20, false, true}, {21, false, true}, {33, false, true}, {34}, {45, false, true}, {48, true}, {49, true},
    {50, true}, {51, true}, {52, true}, {53, true}, {54}, {55}, {56}, {61, false, true}, {62},
    {64, false, true}, {68, false, true}, {70}, {74},
};
// clang-format on

namespace detail {

// 0 none, 1-5 PWM inputs, 33-35 analog, 65-95 RC serial channels, 129-159 API channels, 161-166 step signals
// (errata 4.3).
inline constexpr const char *kRcSerialNames[]
    = {"RC channel 1",  "RC channel 2",  "RC channel 3",  "RC channel 4",  "RC channel 5",  "RC channel 6",
       "RC channel 7",  "RC channel 8",  "RC channel 9",  "RC channel 10", "RC channel 11", "RC channel 12",
       "RC channel 13", "RC channel 14", "RC channel 15", "RC channel 16", "RC channel 17", "RC channel 18",
       "RC channel 19", "RC channel 20", "RC channel 21", "RC channel 22", "RC channel 23", "RC channel 24",
       "RC channel 25", "RC channel 26", "RC channel 27", "RC channel 28", "RC channel 29", "RC channel 30",
       "RC channel 31"};
inline constexpr const char *kApiNames[]
    = {"API channel 1",  "API channel 2",  "API channel 3",  "API channel 4",  "API channel 5",
       "API channel 6",  "API channel 7",  "API channel 8",  "API channel 9",  "API channel 10",
       "API channel 11", "API channel 12", "API channel 13", "API channel 14", "API channel 15",
       "API channel 16", "API channel 17", "API channel 18", "API channel 19", "API channel 20",
       "API channel 21", "API channel 22", "API channel 23", "API channel 24", "API channel 25",
       "API channel 26", "API channel 27", "API channel 28", "API channel 29", "API channel 30",
       "API channel 31"};

constexpr auto makeSources()
{
    std::array<Choice, 16 + 31 + 31> list{Choice{0, "None"},
                                          Choice{1, "RC_ROLL (PWM)"},
                                          Choice{2, "RC_PITCH (PWM)"},
                                          Choice{3, "FC_ROLL (PWM)"},
                                          Choice{4, "FC_PITCH (PWM)"},
                                          Choice{5, "RC_YAW (PWM)"},
                                          Choice{33, "ADC1 (analog)"},
                                          Choice{34, "ADC2 (analog)"},
                                          Choice{35, "ADC3 (analog)"},
                                          Choice{36, "ADC4 (analog)", 2730},
                                          Choice{161, "Step signal 1", 2680},
                                          Choice{162, "Step signal 2", 2680},
                                          Choice{163, "Step signal 3", 2680},
                                          Choice{164, "Step signal 4", 2680},
                                          Choice{165, "Step signal 5", 2680},
                                          Choice{166, "Step signal 6", 2680}};
    for (int i = 0; i < 31; ++i) {
        list[std::size_t(16) + std::size_t(i)] = Choice{65 + i, kRcSerialNames[i]};
        list[std::size_t(47) + std::size_t(i)] = Choice{129 + i, kApiNames[i]};
    }
    return list;
}

}  // namespace detail

inline constexpr auto kSignalSources = detail::makeSources();

inline constexpr Choice kSensorAxes[] = {{1, "X"}, {2, "Y"}, {3, "Z"}, {-1, "-X"}, {-2, "-Y"}, {-3, "-Z"}};
inline constexpr Choice kAxisNumbers[] = {{0, "Off"}, {1, "Roll"}, {2, "Pitch"}, {3, "Yaw"}};
// clang-format off
inline constexpr Choice kSerialSpeeds[] = {{0, "115200"}, {1, "57600"}, {2, "38400"}, {3, "19200"}, {4, "9600"},
                                           {5, "256000", 2600}};
// clang-format on
inline constexpr Choice kPorts[] = {{0, "Off"}, {1, "UART1"}, {2, "RC serial"}, {3, "UART2"}, {4, "USB"}};

// Of commands, in the words of the command line (errata 3.20 to 3.23, 4.2).
// clang-format off
inline constexpr Choice kPinNames[] = {{1, "RC_ROLL"}, {2, "RC_PITCH"}, {3, "FC_ROLL"}, {4, "FC_PITCH"}, {5, "RC_YAW"}, {16, "AUX1"},
                                {17, "AUX2"}, {18, "AUX3"}, {32, "buzzer"}, {33, "spektrum-power"}};
inline constexpr Choice kMotorNames[] = {{kAllMotors, "all"}, {0, "roll"}, {1, "pitch"}, {2, "yaw"}};
/// Of BODE_TEST_START_STOP, as the public Python library that the errata cite has them.
inline constexpr Choice kTestedSystems[] = {{135, "whole-loop"}, {7, "open-loop"}, {70, "plant"}, {198, "plant-closed"}, {3, "controller"}, {11, "overall"}};
inline constexpr Choice kStimuli[] = {{1, "noise"}, {2, "sweep"}, {3, "exponential-sweep"}};
inline constexpr Choice kPinStates[] = {{0, "low"}, {1, "high"}, {2, "floating"}};
inline constexpr Choice kSetActions[] = {{1, "store"}, {2, "clear"}, {3, "load"}};
inline constexpr Choice kFileTypes[] = {{1, "script"}, {3, "imu-calibration"}, {4, "cogging"}, {5, "look-up-table"}, {6, "profile-set"},
                                 {7, "parameters"}, {8, "tuning"}, {10, "can-driver"}};
inline constexpr Choice kScriptModes[] = {{0, "stop"}, {1, "start"}, {2, "debug"}};
/// What the board calibrates (errata 4.6), in the words of the command line.
inline constexpr Choice kCalibModes[] = {{0, "none"}, {1, "flight controller"}, {2, "angles by hand"}, {3, "poles"}, {4, "accelerometer"},
    {5, "gyroscope"}, {6, "encoder offset"}, {7, "encoder field"}, {8, "auto-tune"}, {9, "frequency response"},
    {10, "gyroscope, temperature"}, {11, "accelerometer, temperature"}, {12, "magnetometer"}, {13, "angles by hand, not stored"},
    {14, "system identification"}, {15, "magnetic link"}, {16, "search of limits"}, {17, "operating position"},
    {18, "orientation of the IMU"}, {19, "time-lapse"}, {20, "momentum"}, {21, "momentum, automatic"}, {22, "cogging"},
    {23, "accelerometer by reference"}, {24, "safe stop"}, {25, "accelerometer, sphere"}, {26, "axes of the gyroscope"},
    {27, "gyroscope of the external IMU"}, {28, "alignment of the external IMU"}, {34, "several positions"}, {35, "encoder table"},
    {36, "writing parameters"}, {37, "current sensor"}, {38, "home position of motors"}, {39, "inside the encoder"},
    {40, "vibration test"}, {41, "retracting"}, {42, "retracted"}};
/// Bits of SYSTEM_STATE_FLAGS (errata 4.4).
inline constexpr Choice kStateFlags[] = {{0, "debug"}, {1, "frame inverted"}, {2, "start step 1 done"}, {3, "start step 2 done"},
    {4, "started"}, {5, "power manager"}, {8, "shake generator"}, {9, "servo mode"}, {10, "follows roll"}, {11, "follows pitch"},
    {12, "follows yaw"}, {13, "tripod mode"}, {14, "retracted"}};
/// Bits of SYSTEM_ERROR (document REALTIME_DATA_3).
inline constexpr Choice kFaultNames[] = {
    {0, "No IMU"}, {1, "Accelerometer not calibrated"}, {2, "Motor power is not set"}, {3, "Poles are not calibrated"},
    {4, "Protection is active"}, {5, "Serial error"}, {6, "Battery below the alarm"}, {7, "Battery below its cut-off"},
    {8, "Firmware and tool differ"}, {9, "Motor lost steps"}, {10, "System error"}, {11, "Emergency stop"}};
/// What SYSTEM_SUB_ERROR tells of an emergency stop (errata 4.5).
inline constexpr Choice kStopCauses[] = {
    {0, "none"}, {1, "I2C errors"}, {2, "driver too hot"}, {3, "driver fault"}, {4, "encoder and IMU disagree"},
    {5, "calibration failed"}, {6, "internal fault"}, {7, "encoder scale"}, {8, "too hot"}, {9, "motor poles or inversion"},
    {10, "memory"}, {11, "IMU lost"}, {12, "CAN hardware"}, {13, "motor too hot"}, {14, "motor blocked"}, {15, "bad IMU"},
    {16, "endless restarts"}, {17, "wrong start position"}, {18, "overload too long"}, {19, "CAN driver: over-current"},
    {20, "CAN driver: under-voltage"}, {21, "CAN driver: emergency pin"}, {22, "CAN driver: field-oriented control"},
    {23, "CAN driver: controller too hot"}, {24, "CAN driver: motor too hot"}, {25, "CAN driver: lasting over-current"},
    {26, "CAN driver: several faults"}, {27, "CAN bus off, outside"}, {28, "CAN bus off, inside"}, {29, "encoder missing"},
    {30, "CAN driver does not answer"}, {31, "CAN driver: parameters"}, {32, "over-current"}, {33, "unsafe voltage"},
    {34, "battery setting"}, {35, "stored parameters"}, {36, "encoder type"}, {37, "type of the external IMU"},
    {38, "external IMU lost"}, {39, "parameters of the external IMU"}, {40, "start of the motor driver"},
    {41, "stored variables"}, {42, "watchdog"}, {43, "analogue inputs"}, {44, "calibration with motors off"}, {45, "time-out"},
    {46, "calibration of the driver"}, {47, "magnetometer lost"}, {48, "over-speed"}, {49, "self-calibration of the encoder"},
    {50, "version on the CAN bus"}, {51, "serial number on the CAN bus"}, {52, "serial numbers on the CAN bus differ"},
    {53, "stage of the driver's start"}, {54, "data of the encoder too late"}, {55, "link on the CAN bus lost"},
    {56, "clock crystal"}, {57, "frame IMU lost"}, {58, "parameters were changed"}, {59, "not in its normal position"},
    {60, "driver licence"}};
inline constexpr Choice kImuNames[] = {{1, "main IMU"}, {2, "frame IMU"}};
inline constexpr Choice kOffOn[] = {{0, "off"}, {1, "on"}};
inline constexpr Choice kActiveProfiles[] = {{0, "profile 1"}, {1, "profile 2"}, {2, "profile 3"}, {3, "profile 4"}, {4, "profile 5"}};
/// Of a motor's driver in SYSTEM_POWER_STATE (errata 3.9).
inline constexpr Choice kDriverFlags[] = {{0, "limit violated"}, {1, "over-current"}, {2, "driver on"}};
/// What is wrong with a file of the board (errata 3.18).
inline constexpr Choice kFileCodes[] = {{0, "no error"}, {1, "EEPROM fault"}, {2, "file not found"}, {3, "FAT damaged"}, {4, "no free space"},
    {5, "FAT full"}, {6, "wrong file size"}, {7, "CRC"}, {8, "limit reached"}, {9, "file corrupted"}, {10, "wrong parameters"}};
// clang-format on

}  // namespace simplebgc
