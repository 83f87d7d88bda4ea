// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/parametertables.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr Choice kInputs[] = {{0, "off"}, {1, "Rc-0"}, {2, "Rc-1"}, {3, "Rc-2"}, {4, "Rc2-0"}, {5, "Rc2-1"}, {6, "Rc2-2"},
    {7, "Rc2-3"}, {8, "Pot-0"}, {9, "Pot-1"}, {10, "Pot-2"}, {11, "Virtual-1"}, {12, "Virtual-2"}, {13, "Virtual-3"},
    {14, "Virtual-4"}, {15, "Virtual-5"}, {16, "Virtual-6"}, {17, "Virtual-7"}, {18, "Virtual-8"}, {19, "Virtual-9"},
    {20, "Virtual-10"}, {21, "Virtual-11"}, {22, "Virtual-12"}, {23, "Virtual-13"}, {24, "Virtual-14"}, {25, "Virtual-15"},
    {26, "Virtual-16"}, {27, "But switch"}, {28, "But latch"}, {29, "But step"}, {30, "Aux-0 switch"}, {31, "Aux-1 switch"},
    {32, "Aux-2 switch"}, {33, "Aux-01 switch"}, {34, "Aux-012 switch"}, {35, "Aux-0 latch"}, {36, "Aux-1 latch"},
    {37, "Aux-2 latch"}, {38, "Aux-01 latch"}, {39, "Aux-012 latch"}, {40, "Aux-0 step"}, {41, "Aux-1 step"},
    {42, "Aux-2 step"}};
constexpr Choice kInputs78[] = {{0, "off"}, {1, "Rc-0"}, {2, "Rc-1"}, {3, "Rc-2"}, {4, "Rc2-0"}, {5, "Rc2-1"}, {6, "Rc2-2"},
    {7, "Rc2-3"}, {8, "Pot-0"}, {9, "Pot-1"}, {10, "Pot-2"}, {11, "Virtual-1"}, {12, "Virtual-2"}, {13, "Virtual-3"},
    {14, "Virtual-4"}, {15, "Virtual-5"}, {16, "Virtual-6"}, {17, "Virtual-7"}, {18, "Virtual-8"}, {19, "Virtual-9"},
    {20, "Virtual-10"}, {21, "Virtual-11"}, {22, "Virtual-12"}, {23, "Virtual-13"}, {24, "Virtual-14"}, {25, "Virtual-15"},
    {26, "Virtual-16"}, {27, "But switch"}, {28, "But latch"}, {29, "Aux-0 switch"}, {30, "Aux-1 switch"},
    {31, "Aux-2 switch"}, {32, "Aux-01 switch"}, {33, "Aux-012 switch"}, {34, "Aux-0 latch"}, {35, "Aux-1 latch"},
    {36, "Aux-2 latch"}, {37, "Aux-01 latch"}, {38, "Aux-012 latch"}};
constexpr Choice kVoltages[] = {{0, "off"}, {1, "2.9 V/cell"}, {2, "3.0 V/cell"}, {3, "3.1 V/cell"}, {4, "3.2 V/cell"},
    {5, "3.3 V/cell"}, {6, "3.4 V/cell"}, {7, "3.5 V/cell"}};
constexpr Choice kDirections[] = {{0, "normal"}, {1, "reversed"}, {2, "auto"}};
constexpr Choice kImu3[] = {{0, "none"}, {1, "none, Imu2=on-board"}, {2, "Imu3 = NT Imu2"}, {3, "Imu3 = on-board Imu2"}};
constexpr Choice kMotorMapping[] = {{0, "M0=pitch , M1=roll"}, {1, "M0=roll , M1=pitch"}, {2, "roll yaw pitch"},
    {3, "yaw roll pitch"}, {4, "pitch yaw roll"}, {5, "yaw pitch roll"}};
constexpr Choice kVirtual[] = {{0, "off"}, {1, "sum ppm 6"}, {2, "sum ppm 7"}, {3, "sum ppm 8"}, {4, "sum ppm 10"},
    {5, "sum ppm 12"}, {6, "spektrum 10 bit"}, {7, "spektrum 11 bit"}, {8, "sbus"}, {9, "hott sumd"}, {10, "srxl"}};
constexpr Choice kPwmOut[] = {{0, "off"}, {1, "1520 us 55 Hz"}, {2, "1520 us 250 Hz"}};
constexpr Choice kRcModes[] = {{0, "absolute"}, {1, "relative"}, {2, "absolute centered"}};
constexpr Choice kRcYawModes[] = {{0, "absolute"}, {1, "relative"}, {2, "absolute centered"}, {3, "relative turn around"}};
constexpr Choice kPanModes[] = {{0, "hold hold pan"}, {1, "hold hold hold"}, {2, "pan pan pan"}, {3, "pan hold hold"},
    {4, "pan hold pan"}, {5, "hold pan pan"}, {6, "off"}};
constexpr Choice kCameras[] = {{0, "Sony Nex"}, {1, "Canon"}, {2, "Panasonic"}, {3, "Nikon"}};
constexpr Choice kShots[] = {{0, "shutter"}, {1, "shutter delay"}, {2, "video on/off"}, {3, "off"}};
constexpr Choice kLogging[] = {{0, "off"}, {1, "basic"}, {2, "basic + pid"}, {3, "basic + accgyro"},
    {4, "basic + accgyro_raw"}, {5, "basic + pid + accgyro"}, {6, "basic + pid + ag_raw"}, {7, "full"}};
constexpr Choice kUsage[] = {{0, "normal"}, {1, "level"}, {2, "startup pos"}, {3, "disabled"}};
constexpr Choice kAccLpf[] = {{0, "off"}, {1, "1.5 ms"}, {2, "4.5 ms"}, {3, "12 ms"}, {4, "25 ms"}, {5, "50 ms"},
    {6, "100 ms"}};
constexpr Choice kDlpf[] = {{0, "256 Hz"}, {1, "188 Hz"}, {2, "98 Hz"}, {3, "42 Hz"}, {4, "20 Hz"}, {5, "10 Hz"},
    {6, "5 Hz"}};
constexpr Choice kCompensation[] = {{0, "standard"}, {1, "advanced"}};
constexpr Choice kImu2[] = {{0, "off"}, {1, "full"}, {2, "full xy"}, {3, "full v1"}, {4, "full v1 xy"}};
constexpr Choice kBeep[] = {{0, "off"}, {1, "basic"}, {2, "all"}};
constexpr Choice kFeedForward[] = {{0, "off"}, {1, "1.5 ms"}, {2, "4 ms"}, {3, "10 ms"}, {4, "22 ms"}, {5, "46 ms"},
    {6, "94 ms"}};
constexpr Choice kGyroLpf[] = {{0, "off"}, {1, "1.5 ms"}, {2, "3.0 ms"}, {3, "4.5 ms"}, {4, "6.0 ms"}, {5, "7.5 ms"},
    {6, "9 ms"}};
constexpr Choice kImuMapping[] = {{0, "1=IC2 , 2=IC2#2"}, {1, "1=IC2#2 , 2=IC2"}};
constexpr Choice kHeartbeat[] = {{0, "no heartbeat"}, {1, "emit heartbeat"}, {2, "heartbeat + attitude"}};
constexpr Choice kMotorMapping78[] = {{0, "M0=pitch , M1=roll"}, {1, "M0=roll , M1=pitch"}};
constexpr Choice kRcModes78[] = {{0, "absolute"}, {1, "relative"}};
constexpr Choice kRcYawModes78[] = {{0, "absolute"}, {1, "relative"}, {2, "relative turn around"}};
constexpr Choice kPanModes78[] = {{0, "hold hold pan"}, {1, "hold hold hold"}, {2, "pan pan pan"}, {3, "pan hold hold"},
    {4, "pan hold pan"}, {5, "off"}};
constexpr Choice kImu278[] = {{0, "off"}, {1, "full"}, {2, "full xy"}, {3, "light"}, {4, "light xy"}};
constexpr Choice kOrientations[] = {{0, "z0°"}, {1, "z90°"}, {2, "z180°"}, {3, "z270°"}, {4, "x0°"}, {5, "x90°"},
    {6, "x180°"}, {7, "x270°"}, {8, "y0°"}, {9, "y90°"}, {10, "y180°"}, {11, "y270°"}, {12, "-z0°"}, {13, "-z90°"},
    {14, "-z180°"}, {15, "-z270°"}, {16, "-x0°"}, {17, "-x90°"}, {18, "-x180°"}, {19, "-x270°"}, {20, "-y0°"}, {21, "-y90°"},
    {22, "-y180°"}, {23, "-y270°"}};

constexpr ParameterRow kRows[] = {
    {.key = "pid.%a.p", .label = "P", .group = "PID",
     .help = "Strength of the answer to an angle error. Too little is soft, too much vibrates.",
     .block = Parameters, .offset = 2 * 0, .wire = WireType::U16, .axes = 3, .axisStride = 12, .pitchFirst = true,
     .scale = 0.01, .max = 3000, .decimals = 2, .defaults = {400, 400, 400}, .level = ViewLevel::Basic, .adjustable = 0,
     .adjustableStride = 6, .name = "%A P"},
    {.key = "pid.%a.i", .label = "I", .group = "PID",
     .help = "How fast an error that stays is taken away. Too much sways slowly.",
     .block = Parameters, .offset = 2 * 1, .wire = WireType::U16, .axes = 3, .axisStride = 12, .pitchFirst = true,
     .scale = 0.1, .max = 20000, .decimals = 1, .defaults = {1000, 1000, 1000}, .level = ViewLevel::Basic, .adjustable = 1,
     .adjustableStride = 6, .name = "%A I"},
    {.key = "pid.%a.d", .label = "D", .group = "PID",
     .help = "Damping. Raise it until the motor buzzes, then take a third of it away.",
     .block = Parameters, .offset = 2 * 2, .wire = WireType::U16, .axes = 3, .axisStride = 12, .pitchFirst = true,
     .scale = 0.0001, .max = 8000, .decimals = 4, .defaults = {500, 500, 500}, .level = ViewLevel::Basic, .adjustable = 2,
     .adjustableStride = 6, .name = "%A D"},
    {.key = "motor.%a.vmax", .label = "Motor power", .group = "PID",
     .help = "Highest voltage at the motor. As little as holds the camera in a wind; more heats the motor.",
     .block = Parameters, .offset = 2 * 3, .wire = WireType::U16, .axes = 3, .axisStride = 12, .pitchFirst = true,
     .max = 255, .defaults = {150, 150, 150}, .level = ViewLevel::Basic, .risk = Risk::Red, .adjustable = 3,
     .adjustableStride = 6, .name = "%A Motor Vmax"},
    {.key = "pan.%a.speed", .label = "Pan speed", .group = "Pan",
     .help = "How fast the camera follows the handle in pan mode. 0 holds.",
     .block = Parameters, .offset = 2 * 4, .wire = WireType::U16, .axes = 3, .axisStride = 12, .pitchFirst = true,
     .scale = 0.1, .max = 50, .decimals = 1, .defaults = {20, 20, 20}, .since = 85, .name = "%A Pan (0 = hold)"},
    {.key = "pan.%a.speed", .label = "Pan speed", .group = "Pan",
     .help = "How fast the camera follows the handle in pan mode. 0 holds.",
     .block = Parameters, .offset = 2 * 4, .wire = WireType::U16, .axes = 3, .axisStride = 12, .pitchFirst = true,
     .scale = 0.1, .max = 100, .decimals = 1, .defaults = {20, 20, 20}, .until = 80, .name = "%A Pan (0 = hold)"},
    {.key = "pan.pitch.deadband", .label = "Pan dead band", .group = "Pan",
     .help = "The camera does not follow before the handle has turned so far.",
     .block = Parameters, .offset = 2 * 5, .wire = WireType::U16, .axis = Axis::Pitch,
     .unit = "°", .scale = 0.1, .max = 600, .decimals = 1, .since = 95, .name = "Pitch Pan Deadband", .idle = {"pan.pitch.speed", 0}},
    {.key = "pan.pitch.deadband", .label = "Pan dead band", .group = "Pan",
     .help = "The camera does not follow before the handle has turned so far.",
     .block = Parameters, .offset = 2 * 5, .wire = WireType::U16, .axis = Axis::Pitch,
     .unit = "°", .scale = 0.1, .max = 100, .decimals = 1, .until = 94, .name = "Pitch Pan Deadband", .idle = {"pan.pitch.speed", 0}},
    {.key = "pan.roll.deadband", .label = "Pan dead band", .group = "Pan",
     .help = "The camera does not follow before the handle has turned so far.",
     .block = Parameters, .offset = 2 * 11, .wire = WireType::U16, .axis = Axis::Roll,
     .unit = "°", .scale = 0.1, .max = 600, .decimals = 1, .since = 95, .name = "Roll Pan Deadband", .idle = {"pan.roll.speed", 0}},
    {.key = "pan.roll.deadband", .label = "Pan dead band", .group = "Pan",
     .help = "The camera does not follow before the handle has turned so far.",
     .block = Parameters, .offset = 2 * 11, .wire = WireType::U16, .axis = Axis::Roll,
     .unit = "°", .scale = 0.1, .max = 100, .decimals = 1, .until = 94, .name = "Roll Pan Deadband", .idle = {"pan.roll.speed", 0}},
    {.key = "pan.yaw.deadband", .label = "Pan dead band", .group = "Pan",
     .help = "The camera does not follow before the handle has turned so far.",
     .block = Parameters, .offset = 2 * 17, .wire = WireType::U16, .axis = Axis::Yaw,
     .unit = "°", .scale = 0.1, .max = 100, .decimals = 1, .defaults = {50}, .since = 85, .name = "Yaw Pan Deadband", .idle = {"pan.yaw.speed", 0}},
    {.key = "pan.yaw.deadband", .label = "Pan dead band", .group = "Pan",
     .help = "The camera does not follow before the handle has turned so far.",
     .block = Parameters, .offset = 2 * 17, .wire = WireType::U16, .axis = Axis::Yaw,
     .unit = "°", .scale = 0.1, .max = 100, .decimals = 1, .until = 80, .name = "Yaw Pan Deadband", .idle = {"pan.yaw.speed", 0}},
    {.key = "battery.low_limit", .label = "Low voltage limit", .group = "PID",
     .help = "Below it the board warns and takes the motors back.",
     .block = Parameters, .offset = 2 * 18, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 7, .defaults = {1}, .choices = kVoltages, .level = ViewLevel::Basic, .name = "Low Voltage Limit"},
    {.key = "battery.correction", .label = "Voltage correction", .group = "PID",
     .help = "How much of a falling battery voltage is made up for at the motors.",
     .block = Parameters, .offset = 2 * 19, .wire = WireType::U16,
     .unit = "%", .max = 200, .name = "Voltage Correction"},
    {.key = "motor.%a.poles", .label = "Motor poles", .group = "Gimbal configuration",
     .help = "Magnets in the bell of the motor. A wrong number makes the motor run away.",
     .block = Parameters, .offset = 2 * 20, .wire = WireType::U16, .axes = 3, .axisStride = 12, .pitchFirst = true,
     .min = 12, .max = 28, .defaults = {14, 14, 14}, .risk = Risk::Red, .name = "%A Motor Poles"},
    {.key = "motor.%a.direction", .label = "Motor direction", .group = "Gimbal configuration",
     .help = "Auto finds it at each start, with a little movement. A wrong one makes the motor run away.",
     .block = Parameters, .offset = 2 * 21, .wire = WireType::U16, .kind = ValueKind::Choice, .axes = 3, .axisStride = 12, .pitchFirst = true,
     .max = 2, .defaults = {2, 2, 2}, .choices = kDirections, .risk = Risk::Red, .name = "%A Motor Direction"},
    {.key = "motor.%a.offset", .label = "Angle offset", .group = "Gimbal configuration",
     .help = "Turns the level of this axis a little, to make up for a sensor that sits askew.",
     .block = Parameters, .offset = 2 * 22, .wire = WireType::I16, .axes = 3, .axisStride = 12, .pitchFirst = true,
     .unit = "°", .scale = 0.01, .min = -300, .max = 300, .decimals = 2, .name = "%A Offset"},
    {.key = "motor.%a.start_position", .label = "Start position", .group = "Gimbal configuration",
     .help = "Where the motor stands at the start when it is used by position. Take it over with the action, rather than by hand.",
     .block = Parameters, .offset = 2 * 23, .wire = WireType::U16, .axes = 3, .axisStride = 12, .pitchFirst = true,
     .max = 1008, .defaults = {504, 504, 504}, .risk = Risk::Red, .name = "%A Startup Motor Pos"},
    {.key = "imu3.configuration", .label = "Third IMU", .group = "Expert",
     .help = "Which sensor serves as the third one.",
     .block = Parameters, .offset = 2 * 38, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 2, .choices = kImu3, .level = ViewLevel::Expert, .since = 93, .name = "Imu3 Configuration"},
    {.key = "imu.orientation", .label = "Camera IMU orientation", .group = "Gimbal configuration",
     .help = "How the sensor at the camera is mounted: which of its axes point forward, left and up. A wrong one makes the camera swing away.",
     .block = Parameters, .offset = 2 * 39, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 23, .choices = kOrientations, .risk = Risk::Red, .name = "Imu Orientation"},
    {.key = "motor.mapping", .label = "Motor mapping", .group = "Expert",
     .help = "Which motor is at which connector. A wrong one makes the motors run away.",
     .block = Parameters, .offset = 2 * 40, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 5, .choices = kMotorMapping, .level = ViewLevel::Expert, .risk = Risk::Red, .since = 85, .name = "Motor Mapping"},
    {.key = "motor.mapping", .label = "Motor mapping", .group = "Expert",
     .help = "Which motor is at which connector. A wrong one makes the motors run away.",
     .block = Parameters, .offset = 2 * 40, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 1, .choices = kMotorMapping78, .level = ViewLevel::Expert, .risk = Risk::Red, .until = 80, .name = "Motor Mapping"},
    {.key = "rc.virtual_channels", .label = "Virtual channels", .group = "Setup",
     .help = "The receiver at the board's port, whose channels serve as inputs.",
     .block = Parameters, .offset = 2 * 41, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 10, .choices = kVirtual, .name = "Virtual Channel Configuration"},
    {.key = "pwm_out.configuration", .label = "PWM output", .group = "Setup",
     .help = "Makes a servo signal at the board's port.",
     .block = Parameters, .offset = 2 * 42, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 2, .choices = kPwmOut, .name = "Pwm Out Configuration"},
    {.key = "rc.deadband", .label = "Dead band of sticks", .group = "RC inputs",
     .help = "So far around its middle a stick does nothing.",
     .block = Parameters, .offset = 2 * 43, .wire = WireType::U16,
     .unit = "µs", .max = 50, .defaults = {10}, .name = "Rc Dead Band"},
    {.key = "rc.%a.input", .label = "Input", .group = "RC inputs",
     .help = "What steers this axis.",
     .block = Parameters, .offset = 2 * 44, .wire = WireType::U16, .kind = ValueKind::Choice, .axes = 3, .axisStride = 14, .pitchFirst = true,
     .max = 42, .choices = kInputs, .since = 85, .name = "Rc %A"},
    {.key = "rc.%a.input", .label = "Input", .group = "RC inputs",
     .help = "What steers this axis.",
     .block = Parameters, .offset = 2 * 44, .wire = WireType::U16, .kind = ValueKind::Choice, .axes = 3, .axisStride = 14, .pitchFirst = true,
     .max = 38, .choices = kInputs78, .until = 80, .name = "Rc %A"},
    {.key = "rc.pitch.mode", .label = "Mode", .group = "RC inputs",
     .help = "Absolute: the stick sets the angle. Relative: it sets the speed.",
     .block = Parameters, .offset = 2 * 45, .wire = WireType::U16, .kind = ValueKind::Choice, .axis = Axis::Pitch,
     .max = 2, .choices = kRcModes, .since = 85, .name = "Rc Pitch Mode", .idle = {"rc.pitch.input", 0}},
    {.key = "rc.roll.mode", .label = "Mode", .group = "RC inputs",
     .help = "Absolute: the stick sets the angle. Relative: it sets the speed.",
     .block = Parameters, .offset = 2 * 52, .wire = WireType::U16, .kind = ValueKind::Choice, .axis = Axis::Roll,
     .max = 2, .choices = kRcModes, .since = 85, .name = "Rc Roll Mode", .idle = {"rc.roll.input", 0}},
    {.key = "rc.yaw.mode", .label = "Mode", .group = "RC inputs",
     .help = "Absolute: the stick sets the angle. Relative: it sets the speed.",
     .block = Parameters, .offset = 2 * 59, .wire = WireType::U16, .kind = ValueKind::Choice, .axis = Axis::Yaw,
     .max = 3, .choices = kRcYawModes, .since = 85, .name = "Rc Yaw Mode", .idle = {"rc.yaw.input", 0}},
    {.key = "rc.pitch.mode", .label = "Mode", .group = "RC inputs",
     .help = "Absolute: the stick sets the angle. Relative: it sets the speed.",
     .block = Parameters, .offset = 2 * 45, .wire = WireType::U16, .kind = ValueKind::Choice, .axis = Axis::Pitch,
     .max = 1, .choices = kRcModes78, .until = 80, .name = "Rc Pitch Mode", .idle = {"rc.pitch.input", 0}},
    {.key = "rc.roll.mode", .label = "Mode", .group = "RC inputs",
     .help = "Absolute: the stick sets the angle. Relative: it sets the speed.",
     .block = Parameters, .offset = 2 * 52, .wire = WireType::U16, .kind = ValueKind::Choice, .axis = Axis::Roll,
     .max = 1, .choices = kRcModes78, .until = 80, .name = "Rc Roll Mode", .idle = {"rc.roll.input", 0}},
    {.key = "rc.yaw.mode", .label = "Mode", .group = "RC inputs",
     .help = "Absolute: the stick sets the angle. Relative: it sets the speed.",
     .block = Parameters, .offset = 2 * 59, .wire = WireType::U16, .kind = ValueKind::Choice, .axis = Axis::Yaw,
     .max = 2, .choices = kRcYawModes78, .until = 80, .name = "Rc Yaw Mode", .idle = {"rc.yaw.input", 0}},
    {.key = "rc.%a.trim", .label = "Trim", .group = "RC inputs",
     .help = "Moves the middle of the stick.",
     .block = Parameters, .offset = 2 * 46, .wire = WireType::I16, .axes = 3, .axisStride = 14, .pitchFirst = true,
     .unit = "µs", .min = -100, .max = 100, .name = "Rc %A Trim", .idle = {"rc.%a.input", 0}},
    {.key = "rc.pitch.min", .label = "Lowest angle", .group = "RC inputs",
     .help = "Steering does not take the camera beyond.",
     .block = Parameters, .offset = 2 * 47, .wire = WireType::I16, .axis = Axis::Pitch,
     .unit = "°", .scale = 0.1, .min = -1200, .max = 1200, .decimals = 1, .defaults = {-250}, .level = ViewLevel::Basic,
     .name = "Rc Pitch Min"},
    {.key = "rc.pitch.max", .label = "Highest angle", .group = "RC inputs",
     .help = "Steering does not take the camera beyond.",
     .block = Parameters, .offset = 2 * 48, .wire = WireType::I16, .axis = Axis::Pitch,
     .unit = "°", .scale = 0.1, .min = -1200, .max = 1200, .decimals = 1, .defaults = {250}, .level = ViewLevel::Basic,
     .name = "Rc Pitch Max"},
    {.key = "rc.roll.min", .label = "Lowest angle", .group = "RC inputs",
     .help = "Steering does not take the camera beyond.",
     .block = Parameters, .offset = 2 * 54, .wire = WireType::I16, .axis = Axis::Roll,
     .unit = "°", .scale = 0.1, .min = -450, .max = 450, .decimals = 1, .defaults = {-250}, .level = ViewLevel::Basic,
     .name = "Rc Roll Min"},
    {.key = "rc.roll.max", .label = "Highest angle", .group = "RC inputs",
     .help = "Steering does not take the camera beyond.",
     .block = Parameters, .offset = 2 * 55, .wire = WireType::I16, .axis = Axis::Roll,
     .unit = "°", .scale = 0.1, .min = -450, .max = 450, .decimals = 1, .defaults = {250}, .level = ViewLevel::Basic,
     .name = "Rc Roll Max"},
    {.key = "rc.yaw.min", .label = "Lowest angle", .group = "RC inputs",
     .help = "Steering does not take the camera beyond.",
     .block = Parameters, .offset = 2 * 61, .wire = WireType::I16, .axis = Axis::Yaw,
     .unit = "°", .scale = 0.1, .min = -2700, .max = 2700, .decimals = 1, .defaults = {-250}, .level = ViewLevel::Basic,
     .name = "Rc Yaw Min"},
    {.key = "rc.yaw.max", .label = "Highest angle", .group = "RC inputs",
     .help = "Steering does not take the camera beyond.",
     .block = Parameters, .offset = 2 * 62, .wire = WireType::I16, .axis = Axis::Yaw,
     .unit = "°", .scale = 0.1, .min = -2700, .max = 2700, .decimals = 1, .defaults = {250}, .level = ViewLevel::Basic,
     .name = "Rc Yaw Max"},
    {.key = "rc.%a.speed_limit", .label = "Speed limit", .group = "RC inputs",
     .help = "Highest speed of steering. 0 sets no limit.",
     .block = Parameters, .offset = 2 * 49, .wire = WireType::U16, .axes = 3, .axisStride = 14, .pitchFirst = true,
     .unit = "°/s", .scale = 0.1, .max = 1000, .decimals = 1, .defaults = {400, 400, 400}, .name = "Rc %A Speed Limit (0 = off)"},
    {.key = "rc.%a.acceleration_limit", .label = "Acceleration limit", .group = "RC inputs",
     .help = "How softly steering begins and ends. 0 sets no limit.",
     .block = Parameters, .offset = 2 * 50, .wire = WireType::U16, .axes = 3, .axisStride = 14, .pitchFirst = true,
     .scale = 0.001, .max = 1000, .decimals = 3, .defaults = {300, 300, 300}, .name = "Rc %A Accel Limit (0 = off)"},
    {.key = "pan.mode.input", .label = "Pan mode input", .group = "Pan",
     .help = "What switches between the pan modes.",
     .block = Parameters, .offset = 2 * 65, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 42, .choices = kInputs, .since = 85, .name = "Pan Mode Control"},
    {.key = "pan.mode.input", .label = "Pan mode input", .group = "Pan",
     .help = "What switches between the pan modes.",
     .block = Parameters, .offset = 2 * 65, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 38, .choices = kInputs78, .until = 80, .name = "Pan Mode Control"},
    {.key = "pan.mode.default", .label = "Pan mode, default", .group = "Pan",
     .help = "Which axes follow the handle (pan) and which keep their direction (hold): pitch, roll, yaw.",
     .block = Parameters, .offset = 2 * 66, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 5, .choices = kPanModes, .since = 92, .name = "Pan Mode Default Setting"},
    {.key = "pan.mode.default", .label = "Pan mode, default", .group = "Pan",
     .help = "Which axes follow the handle (pan) and which keep their direction (hold): pitch, roll, yaw.",
     .block = Parameters, .offset = 2 * 66, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 4, .choices = kPanModes78, .until = 91, .name = "Pan Mode Default Setting"},
    {.key = "pan.mode.setting1", .label = "Pan mode 1", .group = "Pan",
     .help = "Which axes follow the handle (pan) and which keep their direction (hold): pitch, roll, yaw.",
     .block = Parameters, .offset = 2 * 67, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 6, .defaults = {1}, .choices = kPanModes, .since = 92, .name = "Pan Mode Setting #1", .idle = {"pan.mode.input", 0}},
    {.key = "pan.mode.setting1", .label = "Pan mode 1", .group = "Pan",
     .help = "Which axes follow the handle (pan) and which keep their direction (hold): pitch, roll, yaw.",
     .block = Parameters, .offset = 2 * 67, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 5, .defaults = {1}, .choices = kPanModes78, .until = 91, .name = "Pan Mode Setting #1", .idle = {"pan.mode.input", 0}},
    {.key = "pan.mode.setting2", .label = "Pan mode 2", .group = "Pan",
     .help = "Which axes follow the handle (pan) and which keep their direction (hold): pitch, roll, yaw.",
     .block = Parameters, .offset = 2 * 68, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 6, .defaults = {4}, .choices = kPanModes, .since = 92, .name = "Pan Mode Setting #2", .idle = {"pan.mode.input", 0}},
    {.key = "pan.mode.setting2", .label = "Pan mode 2", .group = "Pan",
     .help = "Which axes follow the handle (pan) and which keep their direction (hold): pitch, roll, yaw.",
     .block = Parameters, .offset = 2 * 68, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 5, .defaults = {4}, .choices = kPanModes78, .until = 91, .name = "Pan Mode Setting #2", .idle = {"pan.mode.input", 0}},
    {.key = "pan.mode.setting3", .label = "Pan mode 3", .group = "Pan",
     .help = "Which axes follow the handle (pan) and which keep their direction (hold): pitch, roll, yaw.",
     .block = Parameters, .offset = 2 * 69, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 6, .defaults = {2}, .choices = kPanModes, .since = 92, .name = "Pan Mode Setting #3", .idle = {"pan.mode.input", 0}},
    {.key = "pan.mode.setting3", .label = "Pan mode 3", .group = "Pan",
     .help = "Which axes follow the handle (pan) and which keep their direction (hold): pitch, roll, yaw.",
     .block = Parameters, .offset = 2 * 69, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 5, .defaults = {2}, .choices = kPanModes78, .until = 91, .name = "Pan Mode Setting #3", .idle = {"pan.mode.input", 0}},
    {.key = "standby.input", .label = "Standby input", .group = "Functions",
     .help = "What switches the motors off and on.",
     .block = Parameters, .offset = 2 * 70, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 42, .choices = kInputs, .since = 85, .name = "Standby"},
    {.key = "standby.input", .label = "Standby input", .group = "Functions",
     .help = "What switches the motors off and on.",
     .block = Parameters, .offset = 2 * 70, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 38, .choices = kInputs78, .until = 80, .name = "Standby"},
    {.key = "camera.input", .label = "Camera input", .group = "Functions",
     .help = "What releases the camera.",
     .block = Parameters, .offset = 2 * 71, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 42, .choices = kInputs, .since = 85, .name = "IR Camera Control"},
    {.key = "camera.input", .label = "Camera input", .group = "Functions",
     .help = "What releases the camera.",
     .block = Parameters, .offset = 2 * 71, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 38, .choices = kInputs78, .until = 80, .name = "IR Camera Control"},
    {.key = "camera.model", .label = "Camera model", .group = "Functions",
     .help = "Whose remote control is imitated.",
     .block = Parameters, .offset = 2 * 72, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 3, .choices = kCameras, .since = 85, .name = "Camera Model"},
    {.key = "camera.model", .label = "Camera model", .group = "Functions",
     .help = "Whose remote control is imitated.",
     .block = Parameters, .offset = 2 * 72, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 2, .choices = kCameras, .until = 80, .name = "Camera Model"},
    {.key = "camera.setting1", .label = "Camera action 1", .group = "Functions",
     .help = "What the camera is told at the input's first position.",
     .block = Parameters, .offset = 2 * 73, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 2, .choices = kShots, .name = "IR Camera Setting #1", .idle = {"camera.input", 0}},
    {.key = "camera.setting2", .label = "Camera action 2", .group = "Functions",
     .help = "What the camera is told at the input's second position.",
     .block = Parameters, .offset = 2 * 74, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 3, .defaults = {2}, .choices = kShots, .name = "IR Camera Setting #2", .idle = {"camera.input", 0}},
    {.key = "camera.interval", .label = "Time between pictures", .group = "Functions",
     .help = "The camera is released again after so long. 0 switches that off.",
     .block = Parameters, .offset = 2 * 75, .wire = WireType::U16,
     .unit = "s", .scale = 0.1, .max = 150, .decimals = 1, .name = "Time Interval (0 = off)"},
    {.key = "recenter.input", .label = "Re-center input", .group = "Functions",
     .help = "What brings the camera back to its middle.",
     .block = Parameters, .offset = 2 * 76, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 42, .choices = kInputs, .since = 85, .name = "Re-center Camera"},
    {.key = "recenter.input", .label = "Re-center input", .group = "Functions",
     .help = "What brings the camera back to its middle.",
     .block = Parameters, .offset = 2 * 76, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 38, .choices = kInputs78, .until = 80, .name = "Re-center Camera"},
    {.key = "nt.logging", .label = "Logging", .group = "Expert",
     .help = "What is written by a logger on the NT bus.",
     .block = Parameters, .offset = 2 * 77, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 7, .choices = kLogging, .level = ViewLevel::Expert, .since = 95, .name = "NT Logging"},
    {.key = "nt.logging", .label = "Logging", .group = "Expert",
     .help = "What is written by a logger on the NT bus.",
     .block = Parameters, .offset = 2 * 77, .wire = WireType::U16,
     .max = 7, .level = ViewLevel::Expert, .since = 85, .until = 94, .name = "NT Logging"},
    {.key = "motor.%a.usage", .label = "Motor usage", .group = "Setup",
     .help = "Normal stabilizes. Disabled leaves the motor without current.",
     .block = Parameters, .offset = 2 * 78, .wire = WireType::U16, .kind = ValueKind::Choice, .axes = 3, .axisStride = 2, .pitchFirst = true,
     .max = 3, .defaults = {3, 3, 3}, .choices = kUsage, .level = ViewLevel::Basic, .risk = Risk::Red, .name = "%A Motor Usage"},
    {.key = "imu.ahrs", .label = "Attitude time constant", .group = "Setup",
     .help = "How long the accelerometer takes to correct the angles. Short in slow, long in fast motion.",
     .block = Parameters, .offset = 2 * 81, .wire = WireType::U16,
     .unit = "s", .scale = 0.01, .max = 2500, .decimals = 2, .defaults = {1000}, .name = "Imu AHRS"},
    {.key = "imu3.orientation", .label = "Third IMU orientation", .group = "Expert",
     .help = "How the third sensor is mounted.",
     .block = Parameters, .offset = 2 * 83, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 23, .choices = kOrientations, .level = ViewLevel::Expert, .since = 93, .name = "Imu3 Orientation", .idle = {"imu3.configuration", 0}},
    {.key = "imu.acc_threshold", .label = "Acceleration threshold of the IMU", .group = "Expert",
     .help = "An acceleration that differs so much from gravity is not used. 0 uses all.",
     .block = Parameters, .offset = 2 * 84, .wire = WireType::U16,
     .unit = "g", .scale = 0.01, .max = 100, .decimals = 2, .defaults = {25}, .level = ViewLevel::Expert,
     .name = "Imu Acc Threshold (0 = off)"},
    {.key = "acc.lpf", .label = "Accelerometer low-pass", .group = "Expert",
     .help = "Smooths the accelerometer.",
     .block = Parameters, .offset = 2 * 85, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 6, .defaults = {2}, .choices = kAccLpf, .level = ViewLevel::Expert, .name = "Acc LPF"},
    {.key = "imu.dlpf", .label = "Low-pass of the sensor", .group = "Expert",
     .help = "The filter inside the motion sensor. A lower one delays the control loop.",
     .block = Parameters, .offset = 2 * 86, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 6, .choices = kDlpf, .level = ViewLevel::Expert, .name = "Imu DLPF"},
    {.key = "pan.transition_time", .label = "Hold to pan transition", .group = "Expert",
     .help = "How long a change from hold to pan takes.",
     .block = Parameters, .offset = 2 * 87, .wire = WireType::U16,
     .unit = "ms", .max = 1000, .defaults = {250}, .level = ViewLevel::Expert, .name = "Hold To Pan Transition Time"},
    {.key = "acc.compensation", .label = "Acceleration compensation", .group = "Setup",
     .help = "How accelerations of the carrier are told from gravity.",
     .block = Parameters, .offset = 2 * 88, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 1, .defaults = {1}, .choices = kCompensation, .name = "Acc Compensation Method"},
    {.key = "acc.noise", .label = "Accelerometer noise", .group = "Expert",
     .help = "What the accelerometer shows at rest.",
     .block = Parameters, .offset = 2 * 89, .wire = WireType::U16,
     .unit = "g", .scale = 0.001, .max = 150, .decimals = 3, .defaults = {40}, .level = ViewLevel::Expert,
     .name = "Acc Noise Level"},
    {.key = "acc.threshold", .label = "Acceleration threshold", .group = "Expert",
     .help = "Above it the accelerometer is trusted less. 0 switches that off.",
     .block = Parameters, .offset = 2 * 90, .wire = WireType::U16,
     .unit = "g", .scale = 0.01, .max = 100, .decimals = 2, .defaults = {50}, .level = ViewLevel::Expert,
     .name = "Acc Threshold (0 = off)"},
    {.key = "acc.vertical_weight", .label = "Weight of vertical acceleration", .group = "Expert",
     .help = "How much vertical accelerations count.",
     .block = Parameters, .offset = 2 * 91, .wire = WireType::U16,
     .unit = "%", .max = 100, .defaults = {25}, .level = ViewLevel::Expert, .name = "Acc Vertical Weight"},
    {.key = "acc.centrifugal", .label = "Centrifugal correction", .group = "Expert",
     .help = "How much of the force in a turn is made up for.",
     .block = Parameters, .offset = 2 * 92, .wire = WireType::U16,
     .unit = "%", .max = 100, .defaults = {30}, .level = ViewLevel::Expert, .name = "Acc Zentrifugal Correction"},
    {.key = "acc.recover_time", .label = "Recovery time of the accelerometer", .group = "Expert",
     .help = "How long the accelerometer is trusted less after a disturbance.",
     .block = Parameters, .offset = 2 * 93, .wire = WireType::U16,
     .unit = "ms", .max = 1000, .defaults = {250}, .level = ViewLevel::Expert, .name = "Acc Recover Time"},
    {.key = "imu2.configuration", .label = "Second IMU", .group = "Setup",
     .help = "How the sensor at the frame is used.",
     .block = Parameters, .offset = 2 * 94, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 4, .choices = kImu2, .since = 85, .name = "Imu2 Configuration"},
    {.key = "imu2.configuration", .label = "Second IMU", .group = "Setup",
     .help = "How the sensor at the frame is used.",
     .block = Parameters, .offset = 2 * 94, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 2, .choices = kImu278, .until = 80, .name = "Imu2 Configuration"},
    {.key = "imu2.orientation", .label = "Frame IMU orientation", .group = "Gimbal configuration",
     .help = "How the sensor at the frame is mounted.",
     .block = Parameters, .offset = 2 * 95, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 23, .choices = kOrientations, .risk = Risk::Red, .name = "Imu2 Orientation", .idle = {"imu2.configuration", 0}},
    {.key = "rc.adc_lpf", .label = "Low-pass of analogue sticks", .group = "Expert",
     .help = "Smooths joysticks and potentiometers.",
     .block = Parameters, .offset = 2 * 96, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 6, .choices = kAccLpf, .level = ViewLevel::Expert, .name = "Rc Adc LPF"},
    {.key = "pan.hysteresis", .label = "Hysteresis of the pan dead band", .group = "Pan",
     .help = "The camera goes on following until the handle is so much inside the dead band.",
     .block = Parameters, .offset = 2 * 97, .wire = WireType::U16,
     .unit = "°", .scale = 0.1, .max = 50, .decimals = 1, .since = 95, .name = "Yaw Pan Deadband Hysteresis", .idle = {"pan.yaw.speed", 0}},
    {.key = "pan.hysteresis", .label = "Hysteresis of the pan dead band", .group = "Pan",
     .help = "The camera goes on following until the handle is so much inside the dead band.",
     .block = Parameters, .offset = 2 * 97, .wire = WireType::U16,
     .unit = "°", .scale = 0.1, .max = 50, .decimals = 1, .until = 94, .name = "Pan Deadband Hysteresis", .idle = {"pan.yaw.speed", 0}},
    {.key = "beep", .label = "Beep with the motors", .group = "Setup",
     .help = "What the motors sound for.",
     .block = Parameters, .offset = 2 * 98, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 2, .choices = kBeep, .name = "Beep with Motors"},
    {.key = "filter.imu2_lpf", .label = "Feed-forward low-pass", .group = "PID",
     .help = "Smooths what the frame's sensor adds.",
     .block = Parameters, .offset = 2 * 99, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 6, .defaults = {1}, .choices = kFeedForward, .adjustable = 99, .name = "Imu2 FeedForward LPF", .idle = {"imu2.configuration", 0}},
    {.key = "filter.gyro_lpf", .label = "Gyro low-pass", .group = "PID",
     .help = "Takes noise from the gyro. A lower one delays the control loop.",
     .block = Parameters, .offset = 2 * 100, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 6, .defaults = {1}, .choices = kGyroLpf, .adjustable = 100, .name = "Gyro LPF"},
    {.key = "adc.calibration", .label = "Voltage calibration", .group = "Expert",
     .help = "Makes the measured battery voltage right.",
     .block = Parameters, .offset = 2 * 101, .wire = WireType::U16,
     .min = 1000, .max = 2000, .defaults = {1550}, .level = ViewLevel::Expert, .name = "ADC Calibration"},
    {.key = "pan.%a.expo", .label = "Pan expo", .group = "Pan",
     .help = "How much softer following is near the middle.",
     .block = Parameters, .offset = 2 * 102, .wire = WireType::U16, .axes = 3, .axisStride = 2, .pitchFirst = true,
     .unit = "%", .max = 100, .since = 95, .name = "%A Pan Expo", .idle = {"pan.%a.speed", 0}},
    {.key = "pan.%a.limiter", .label = "Pan limiter", .group = "Pan",
     .help = "Limits how fast following changes.",
     .block = Parameters, .offset = 2 * 102, .wire = WireType::U16, .axes = 3, .axisStride = 2, .pitchFirst = true,
     .unit = "%", .max = 100, .until = 94, .name = "%A Pan Limiter", .idle = {"pan.%a.speed", 0}},
    {.key = "rc.hysteresis", .label = "Hysteresis of sticks", .group = "RC inputs",
     .help = "A stick has to move so far before anything changes.",
     .block = Parameters, .offset = 2 * 105, .wire = WireType::U16,
     .unit = "µs", .max = 50, .defaults = {5}, .since = 85, .name = "Rc Hysteresis"},
    {.key = "rc.hysteresis", .label = "Hysteresis of sticks", .group = "RC inputs",
     .help = "A stick has to move so far before anything changes.",
     .block = Parameters, .offset = 2 * 105, .wire = WireType::U16,
     .unit = "µs", .max = 20, .defaults = {5}, .until = 80, .name = "Rc Hysteresis"},
    {.key = "rc.%a.offset", .label = "Angle of the middle", .group = "Setup",
     .help = "Where the camera points when no stick is moved.",
     .block = Parameters, .offset = 2 * 106, .wire = WireType::I16, .axes = 3, .axisStride = 2, .pitchFirst = true,
     .unit = "°", .scale = 0.1, .min = -1200, .max = 1200, .decimals = 1, .name = "Rc %A Offset"},
    {.key = "imu.mapping", .label = "IMU mapping", .group = "Expert",
     .help = "Which sensor is at which bus. A wrong one makes the camera swing away.",
     .block = Parameters, .offset = 2 * 109, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 1, .choices = kImuMapping, .level = ViewLevel::Expert, .risk = Risk::Red, .name = "Imu Mapping"},
    {.key = "mavlink.system", .label = "MAVLink system", .group = "Expert",
     .help = "The board's number of system.",
     .block = Parameters, .offset = 2 * 110, .wire = WireType::U16,
     .max = 255, .defaults = {71}, .level = ViewLevel::Expert, .name = "Mavlink System ID"},
    {.key = "mavlink.component", .label = "MAVLink component", .group = "Expert",
     .help = "The board's number of component.",
     .block = Parameters, .offset = 2 * 111, .wire = WireType::U16,
     .max = 255, .defaults = {67}, .level = ViewLevel::Expert, .name = "Mavlink Component ID"},
    {.key = "mavlink.heartbeat", .label = "MAVLink heartbeat", .group = "Expert",
     .help = "What the serial port sends by itself. While it does, it answers MAVLink only: this program then goes the long way round.",
     .block = Parameters, .offset = 2 * 112, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 2, .choices = kHeartbeat, .level = ViewLevel::Expert, .name = "Mavlink Configuration"},
    {.key = "pwm_out.input", .label = "PWM output input", .group = "Functions",
     .help = "What the servo output follows.",
     .block = Parameters, .offset = 2 * 113, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 42, .choices = kInputs, .since = 85, .name = "Pwm Out Control", .idle = {"pwm_out.configuration", 0}},
    {.key = "pwm_out.input", .label = "PWM output input", .group = "Functions",
     .help = "What the servo output follows.",
     .block = Parameters, .offset = 2 * 113, .wire = WireType::U16, .kind = ValueKind::Choice,
     .max = 38, .choices = kInputs78, .until = 80, .name = "Pwm Out Control", .idle = {"pwm_out.configuration", 0}},
    {.key = "pwm_out.mid", .label = "PWM output, middle", .group = "Functions",
     .help = "Of the servo output.",
     .block = Parameters, .offset = 2 * 114, .wire = WireType::U16,
     .unit = "µs", .min = 900, .max = 2100, .defaults = {1500}, .name = "Pwm Out Mid", .idle = {"pwm_out.configuration", 0}},
    {.key = "pwm_out.min", .label = "PWM output, lowest", .group = "Functions",
     .help = "Of the servo output.",
     .block = Parameters, .offset = 2 * 115, .wire = WireType::U16,
     .unit = "µs", .min = 900, .max = 2100, .defaults = {1100}, .name = "Pwm Out Min", .idle = {"pwm_out.configuration", 0}},
    {.key = "pwm_out.max", .label = "PWM output, highest", .group = "Functions",
     .help = "Of the servo output.",
     .block = Parameters, .offset = 2 * 116, .wire = WireType::U16,
     .unit = "µs", .min = 900, .max = 2100, .defaults = {1900}, .name = "Pwm Out Max", .idle = {"pwm_out.configuration", 0}},
    {.key = "pwm_out.speed_limit", .label = "PWM output, speed limit", .group = "Functions",
     .help = "Of the servo output.",
     .block = Parameters, .offset = 2 * 117, .wire = WireType::U16,
     .unit = "µs/s", .max = 1000, .name = "Pwm Out Speed Limit (0 = off)", .idle = {"pwm_out.configuration", 0}},
    {.key = "pan.yaw.deadband_lpf", .label = "Low-pass of the pan dead band", .group = "Pan",
     .help = "Smooths what the dead band lets through.",
     .block = Parameters, .offset = 2 * 118, .wire = WireType::U16, .axis = Axis::Yaw,
     .unit = "s", .scale = 0.01, .max = 200, .decimals = 2, .since = 85, .name = "Yaw Pan Deadband LPF", .idle = {"pan.yaw.speed", 0}},
    {.key = "script%n.input", .label = "Input of script %1", .group = "Scripts",
     .help = "What chooses the case of the script that runs.",
     .block = Parameters, .offset = 2 * 120, .wire = WireType::U16, .kind = ValueKind::Choice, .count = 4, .countStride = 2,
     .max = 42, .choices = kInputs, .since = 85, .name = "Script%n Control"},
    {.key = "script%n.input", .label = "Input of script %1", .group = "Scripts",
     .help = "What chooses the case of the script that runs.",
     .block = Parameters, .offset = 2 * 119, .wire = WireType::U16, .kind = ValueKind::Choice, .count = 4, .countStride = 2,
     .max = 38, .choices = kInputs78, .until = 80, .name = "Script%n Control"},
};
static_assert(rangesFit(kRows));

constexpr BlockSpec kBlocks78[] = {{Parameters, "PARAMETERS", 2 * 124}, {Scripts, "SCRIPTS", kScriptArea, "Scripts"}};
constexpr BlockSpec kBlocks95[] = {{Parameters, "PARAMETERS", 2 * 125}, {Scripts, "SCRIPTS", kScriptArea, "Scripts"}};

constexpr BlockSpec kBlocksLater[] = {{Parameters, "PARAMETERS", 2 * 155}, {Scripts, "SCRIPTS", kScriptArea, "Scripts"}};

constexpr ParameterRow rawWords(std::uint8_t count)
{
    return {.key = "word.%n", .label = "Word", .group = "Raw words", .help = "A value of a layout that this program has no table for.",
            .block = Parameters, .offset = 0, .wire = WireType::U16, .count = count, .countStride = 2, .max = 65535, .name = "Word %n"};
}
constexpr ParameterRow kRawRows[] = {rawWords(124)};
constexpr ParameterRow kRawRows89[] = {rawWords(125)};
constexpr ParameterRow kRawRowsLater[] = {rawWords(155)};

constexpr Orientation kOrientationTable[] = {
    {"z0°", 0, {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}}},
    {"z90°", 1, {{{{0, -1, 0}}, {{1, 0, 0}}, {{0, 0, 1}}}}},
    {"z180°", 2, {{{{-1, 0, 0}}, {{0, -1, 0}}, {{0, 0, 1}}}}},
    {"z270°", 3, {{{{0, 1, 0}}, {{-1, 0, 0}}, {{0, 0, 1}}}}},
    {"x0°", 4, {{{{0, 1, 0}}, {{0, 0, 1}}, {{1, 0, 0}}}}},
    {"x90°", 5, {{{{0, 0, -1}}, {{0, 1, 0}}, {{1, 0, 0}}}}},
    {"x180°", 6, {{{{0, -1, 0}}, {{0, 0, -1}}, {{1, 0, 0}}}}},
    {"x270°", 7, {{{{0, 0, 1}}, {{0, -1, 0}}, {{1, 0, 0}}}}},
    {"y0°", 8, {{{{0, 0, 1}}, {{1, 0, 0}}, {{0, 1, 0}}}}},
    {"y90°", 9, {{{{-1, 0, 0}}, {{0, 0, 1}}, {{0, 1, 0}}}}},
    {"y180°", 10, {{{{0, 0, -1}}, {{-1, 0, 0}}, {{0, 1, 0}}}}},
    {"y270°", 11, {{{{1, 0, 0}}, {{0, 0, -1}}, {{0, 1, 0}}}}},
    {"-z0°", 16, {{{{0, 1, 0}}, {{1, 0, 0}}, {{0, 0, -1}}}}},
    {"-z90°", 17, {{{{-1, 0, 0}}, {{0, 1, 0}}, {{0, 0, -1}}}}},
    {"-z180°", 18, {{{{0, -1, 0}}, {{-1, 0, 0}}, {{0, 0, -1}}}}},
    {"-z270°", 19, {{{{1, 0, 0}}, {{0, -1, 0}}, {{0, 0, -1}}}}},
    {"-x0°", 20, {{{{0, 0, 1}}, {{0, 1, 0}}, {{-1, 0, 0}}}}},
    {"-x90°", 21, {{{{0, -1, 0}}, {{0, 0, 1}}, {{-1, 0, 0}}}}},
    {"-x180°", 22, {{{{0, 0, -1}}, {{0, -1, 0}}, {{-1, 0, 0}}}}},
    {"-x270°", 23, {{{{0, 1, 0}}, {{0, 0, -1}}, {{-1, 0, 0}}}}},
    {"-y0°", 24, {{{{1, 0, 0}}, {{0, 0, 1}}, {{0, -1, 0}}}}},
    {"-y90°", 25, {{{{0, 0, -1}}, {{1, 0, 0}}, {{0, -1, 0}}}}},
    {"-y180°", 26, {{{{-1, 0, 0}}, {{0, 0, -1}}, {{0, -1, 0}}}}},
    {"-y270°", 27, {{{{0, 0, 1}}, {{-1, 0, 0}}, {{0, -1, 0}}}}},
};

} // namespace

bool isKnownLayout(int layout)
{
    return layout == 78 || layout == 89 || layout == 95;
}

int wordsOf(int layout)
{
    return layout >= 223 ? 155 : layout >= 85 ? 125 : 124;   // errata 5
}

std::span<const BlockSpec> blocksOf(int layout)
{
    switch (wordsOf(layout)) {
    case 124: return kBlocks78;
    case 125: return kBlocks95;
    default: return kBlocksLater;
    }
}

std::vector<std::pair<int, QByteArray>> splitStream(const QByteArray &stream, int words)
{
    std::vector<std::pair<int, QByteArray>> blocks;
    if (stream.size() == 2 * words || stream.size() == 2 * words + kScriptArea)
        blocks.emplace_back(Parameters, stream.left(2 * words));
    if (stream.size() == 2 * words + kScriptArea)
        blocks.emplace_back(Scripts, stream.mid(2 * words));
    return blocks;
}

std::span<const ParameterRow> rawRows(int layout)
{
    switch (wordsOf(layout)) {
    case 124: return kRawRows;
    case 125: return kRawRows89;
    default: return kRawRowsLater;
    }
}

std::span<const ParameterRow> parameterRows()
{
    return kRows;
}

QString originalName(const ParameterSpec &spec)
{
    static constexpr std::array<const char *, 3> kAxisNames{"Roll", "Pitch", "Yaw"};
    QString name = QString::fromLatin1(spec.row->name);
    if (spec.axis != Axis::None)
        name.replace(u"%A"_s, QLatin1String(kAxisNames[std::size_t(spec.axis)]));
    return name.replace(u"%n"_s, QString::number(spec.index));
}

ScriptContext scriptContext(const ParameterSet &parameters, int firmware)
{
    ScriptContext context;
    context.firmware = firmware;
    for (const ParameterSpec &spec : parameters.all())
        context.parameters.push_back({spec.offset / 2, originalName(spec).section(u" ("_s, 0, 0), spec.row->wire == WireType::I16});
    return context;
}

std::span<const Orientation> orientations()
{
    return kOrientationTable;
}

int findOrientation(const std::array<int, 3> &up, const std::array<int, 3> &forward)
{
    const auto it = std::find_if(std::begin(kOrientationTable), std::end(kOrientationTable), [&](const Orientation &each) {
        return each.axes[2] == up && each.axes[0] == forward;
    });
    return it == std::end(kOrientationTable) ? -1 : int(it - std::begin(kOrientationTable));
}

} // namespace storm32
