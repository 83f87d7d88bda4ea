// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/parameterspec.h"

/// Choice lists of the parameter tables (errata 5 and 11); those whose names end in 78 belong to that layout.
namespace storm32 {

// clang-format off
inline constexpr Choice kInputs[] = {{0, "off"}, {1, "Rc-0"}, {2, "Rc-1"}, {3, "Rc-2"}, {4, "Rc2-0"}, {5, "Rc2-1"}, {6, "Rc2-2"},
    {7, "Rc2-3"}, {8, "Pot-0"}, {9, "Pot-1"}, {10, "Pot-2"}, {11, "Virtual-1"}, {12, "Virtual-2"}, {13, "Virtual-3"},
    {14, "Virtual-4"}, {15, "Virtual-5"}, {16, "Virtual-6"}, {17, "Virtual-7"}, {18, "Virtual-8"}, {19, "Virtual-9"},
    {20, "Virtual-10"}, {21, "Virtual-11"}, {22, "Virtual-12"}, {23, "Virtual-13"}, {24, "Virtual-14"}, {25, "Virtual-15"},
    {26, "Virtual-16"}, {27, "But switch"}, {28, "But latch"}, {29, "But step"}, {30, "Aux-0 switch"}, {31, "Aux-1 switch"},
    {32, "Aux-2 switch"}, {33, "Aux-01 switch"}, {34, "Aux-012 switch"}, {35, "Aux-0 latch"}, {36, "Aux-1 latch"},
    {37, "Aux-2 latch"}, {38, "Aux-01 latch"}, {39, "Aux-012 latch"}, {40, "Aux-0 step"}, {41, "Aux-1 step"},
    {42, "Aux-2 step"}};
inline constexpr Choice kInputs78[] = {{0, "off"}, {1, "Rc-0"}, {2, "Rc-1"}, {3, "Rc-2"}, {4, "Rc2-0"}, {5, "Rc2-1"}, {6, "Rc2-2"},
    {7, "Rc2-3"}, {8, "Pot-0"}, {9, "Pot-1"}, {10, "Pot-2"}, {11, "Virtual-1"}, {12, "Virtual-2"}, {13, "Virtual-3"},
    {14, "Virtual-4"}, {15, "Virtual-5"}, {16, "Virtual-6"}, {17, "Virtual-7"}, {18, "Virtual-8"}, {19, "Virtual-9"},
    {20, "Virtual-10"}, {21, "Virtual-11"}, {22, "Virtual-12"}, {23, "Virtual-13"}, {24, "Virtual-14"}, {25, "Virtual-15"},
    {26, "Virtual-16"}, {27, "But switch"}, {28, "But latch"}, {29, "Aux-0 switch"}, {30, "Aux-1 switch"},
    {31, "Aux-2 switch"}, {32, "Aux-01 switch"}, {33, "Aux-012 switch"}, {34, "Aux-0 latch"}, {35, "Aux-1 latch"},
    {36, "Aux-2 latch"}, {37, "Aux-01 latch"}, {38, "Aux-012 latch"}};
inline constexpr Choice kVoltages[] = {{0, "off"}, {1, "2.9 V/cell"}, {2, "3.0 V/cell"}, {3, "3.1 V/cell"}, {4, "3.2 V/cell"},
    {5, "3.3 V/cell"}, {6, "3.4 V/cell"}, {7, "3.5 V/cell"}};
inline constexpr Choice kOffOn[] = {{0, "off"}, {1, "on"}};
/// Errata 3.7.
inline constexpr Choice kStates[] = {{0, "start motors"}, {1, "settle"}, {2, "calibrate"}, {3, "level"}, {4, "find motor directions"},
    {5, "relevel"}, {6, "normal"}, {7, "standby", 0, 95}, {7, "fast level", 208}, {99, "standby"}, {100, "service mode"}};
/// Bits of the status words (errata 3.8).
inline constexpr Choice kStatusBits[] = {{0, "link in use"}, {1, "link OK"}, {2, "leveling failed"}, {3, "battery connected"},
    {4, "battery below the alarm"}, {5, "IMU OK"}, {6, "second IMU OK"}, {7, "magnetometer OK"}, {8, "STorM32-Link present"},
    {9, "NT bus in use"}, {10, "second IMU on the NT bus"}, {11, "second IMU on the board"}, {12, "second IMU present"},
    {13, "magnetometer present"}, {14, "IMU at the high address"}, {15, "IMU present"}};
inline constexpr Choice kStatus2Bits[] = {{3, "pitch motor runs"}, {4, "roll motor runs"}, {5, "yaw motor runs"},
    {8, "re-centers pitch"}, {9, "re-centers roll"}, {10, "re-centers yaw"}, {11, "IR camera"}, {12, "standby"},
    {13, "follows pitch"}, {14, "follows roll"}, {15, "follows yaw"}};
inline constexpr Choice kDirections[] = {{0, "normal"}, {1, "reversed"}, {2, "auto"}};
inline constexpr Choice kImu3[] = {{0, "none"}, {1, "none, Imu2=on-board"}, {2, "Imu3 = NT Imu2"}, {3, "Imu3 = on-board Imu2"}};
inline constexpr Choice kMotorMapping[] = {{0, "M0=pitch , M1=roll"}, {1, "M0=roll , M1=pitch"}, {2, "roll yaw pitch"},
    {3, "yaw roll pitch"}, {4, "pitch yaw roll"}, {5, "yaw pitch roll"}};
inline constexpr Choice kVirtual[] = {{0, "off"}, {1, "sum ppm 6"}, {2, "sum ppm 7"}, {3, "sum ppm 8"}, {4, "sum ppm 10"},
    {5, "sum ppm 12"}, {6, "spektrum 10 bit"}, {7, "spektrum 11 bit"}, {8, "sbus"}, {9, "hott sumd"}, {10, "srxl"}};
inline constexpr Choice kPwmOut[] = {{0, "off"}, {1, "1520 us 55 Hz"}, {2, "1520 us 250 Hz"}};
inline constexpr Choice kRcModes[] = {{0, "absolute"}, {1, "relative"}, {2, "absolute centered"}};
inline constexpr Choice kRcYawModes[] = {{0, "absolute"}, {1, "relative"}, {2, "absolute centered"}, {3, "relative turn around"}};
inline constexpr Choice kPanModes[] = {{0, "hold hold pan"}, {1, "hold hold hold"}, {2, "pan pan pan"}, {3, "pan hold hold"},
    {4, "pan hold pan"}, {5, "hold pan pan"}, {6, "off"}};
inline constexpr Choice kCameras[] = {{0, "Sony Nex"}, {1, "Canon"}, {2, "Panasonic"}, {3, "Nikon"}};
inline constexpr Choice kShots[] = {{0, "shutter"}, {1, "shutter delay"}, {2, "video on/off"}, {3, "off"}};
inline constexpr Choice kLogging[] = {{0, "off"}, {1, "basic"}, {2, "basic + pid"}, {3, "basic + accgyro"},
    {4, "basic + accgyro_raw"}, {5, "basic + pid + accgyro"}, {6, "basic + pid + ag_raw"}, {7, "full"}};
inline constexpr Choice kUsage[] = {{0, "normal"}, {1, "level"}, {2, "startup pos"}, {3, "disabled"}};
inline constexpr Choice kAccLpf[] = {{0, "off"}, {1, "1.5 ms"}, {2, "4.5 ms"}, {3, "12 ms"}, {4, "25 ms"}, {5, "50 ms"},
    {6, "100 ms"}};
inline constexpr Choice kDlpf[] = {{0, "256 Hz"}, {1, "188 Hz"}, {2, "98 Hz"}, {3, "42 Hz"}, {4, "20 Hz"}, {5, "10 Hz"},
    {6, "5 Hz"}};
inline constexpr Choice kCompensation[] = {{0, "standard"}, {1, "advanced"}};
inline constexpr Choice kImu2[] = {{0, "off"}, {1, "full"}, {2, "full xy"}, {3, "full v1"}, {4, "full v1 xy"}};
inline constexpr Choice kBeep[] = {{0, "off"}, {1, "basic"}, {2, "all"}};
inline constexpr Choice kFeedForward[] = {{0, "off"}, {1, "1.5 ms"}, {2, "4 ms"}, {3, "10 ms"}, {4, "22 ms"}, {5, "46 ms"},
    {6, "94 ms"}};
inline constexpr Choice kGyroLpf[] = {{0, "off"}, {1, "1.5 ms"}, {2, "3.0 ms"}, {3, "4.5 ms"}, {4, "6.0 ms"}, {5, "7.5 ms"},
    {6, "9 ms"}};
inline constexpr Choice kImuMapping[] = {{0, "1=IC2 , 2=IC2#2"}, {1, "1=IC2#2 , 2=IC2"}};
inline constexpr Choice kHeartbeat[] = {{0, "no heartbeat"}, {1, "emit heartbeat"}, {2, "heartbeat + attitude"}};
inline constexpr Choice kMotorMapping78[] = {{0, "M0=pitch , M1=roll"}, {1, "M0=roll , M1=pitch"}};
inline constexpr Choice kRcModes78[] = {{0, "absolute"}, {1, "relative"}};
inline constexpr Choice kRcYawModes78[] = {{0, "absolute"}, {1, "relative"}, {2, "relative turn around"}};
inline constexpr Choice kPanModes78[] = {{0, "hold hold pan"}, {1, "hold hold hold"}, {2, "pan pan pan"}, {3, "pan hold hold"},
    {4, "pan hold pan"}, {5, "off"}};
inline constexpr Choice kImu278[] = {{0, "off"}, {1, "full"}, {2, "full xy"}, {3, "light"}, {4, "light xy"}};
inline constexpr Choice kOrientations[] = {{0, "z0°"}, {1, "z90°"}, {2, "z180°"}, {3, "z270°"}, {4, "x0°"}, {5, "x90°"},
    {6, "x180°"}, {7, "x270°"}, {8, "y0°"}, {9, "y90°"}, {10, "y180°"}, {11, "y270°"}, {12, "-z0°"}, {13, "-z90°"},
    {14, "-z180°"}, {15, "-z270°"}, {16, "-x0°"}, {17, "-x90°"}, {18, "-x180°"}, {19, "-x270°"}, {20, "-y0°"}, {21, "-y90°"},
    {22, "-y180°"}, {23, "-y270°"}};
// clang-format on

}  // namespace storm32
