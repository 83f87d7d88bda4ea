// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/telemetrytables.h"

#include "protocol/base/angles.h"
#include "protocol/base/bytes.h"
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/commands.h"
#include "protocol/simplebgc/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace simplebgc {

namespace {

// clang-format off
constexpr ChannelSpec kChannels[] = {
    {"imu.angle.roll", "Camera angle, roll", "Angles", "°", 2, Axis::Roll, -180, 180, "attitude.roll"},
    {"imu.angle.pitch", "Camera angle, pitch", "Angles", "°", 2, Axis::Pitch, -180, 180, "attitude.pitch"},
    {"imu.angle.yaw", "Camera angle, yaw", "Angles", "°", 2, Axis::Yaw, -180, 180, "attitude.yaw"},
    {"target.angle.roll", "Target angle, roll", "Angles", "°", 2, Axis::Roll, -180, 180, "target.roll"},
    {"target.angle.pitch", "Target angle, pitch", "Angles", "°", 2, Axis::Pitch, -180, 180, "target.pitch"},
    {"target.angle.yaw", "Target angle, yaw", "Angles", "°", 2, Axis::Yaw, -180, 180, "target.yaw"},
    {"gyro.roll", "Gyro, roll", "Inertial sensors", "°/s", 2, Axis::Roll, -200, 200, "rate.roll"},
    {"gyro.pitch", "Gyro, pitch", "Inertial sensors", "°/s", 2, Axis::Pitch, -200, 200, "rate.pitch"},
    {"gyro.yaw", "Gyro, yaw", "Inertial sensors", "°/s", 2, Axis::Yaw, -200, 200, "rate.yaw"},
    {"acc.x", "Acceleration, X", "Inertial sensors", "g", 3, Axis::Roll, -2, 2, "acceleration.x"},
    {"acc.y", "Acceleration, Y", "Inertial sensors", "g", 3, Axis::Pitch, -2, 2, "acceleration.y"},
    {"acc.z", "Acceleration, Z", "Inertial sensors", "g", 3, Axis::Yaw, -2, 2, "acceleration.z"},
    {"rotor.angle.roll", "Motor angle, roll", "Angles", "°", 2, Axis::Roll, -180, 180, "joint.roll"},
    {"rotor.angle.pitch", "Motor angle, pitch", "Angles", "°", 2, Axis::Pitch, -180, 180, "joint.pitch"},
    {"rotor.angle.yaw", "Motor angle, yaw", "Angles", "°", 2, Axis::Yaw, -180, 180, "joint.yaw"},
    {"frame.angle.roll", "Frame angle, roll", "Angles", "°", 2, Axis::Roll, -180, 180, "frame.roll"},
    {"frame.angle.pitch", "Frame angle, pitch", "Angles", "°", 2, Axis::Pitch, -180, 180, "frame.pitch"},
    {"frame.angle.yaw", "Frame angle, yaw", "Angles", "°", 2, Axis::Yaw, -180, 180, "frame.yaw"},
    {"target.speed.roll", "Target speed, roll", "Angles", "°/s", 2, Axis::Roll, -200, 200},
    {"target.speed.pitch", "Target speed, pitch", "Angles", "°/s", 2, Axis::Pitch, -200, 200},
    {"target.speed.yaw", "Target speed, yaw", "Angles", "°/s", 2, Axis::Yaw, -200, 200},
    {"power.roll", "Motor power, roll", "Motors", "%", 0, Axis::Roll, 0, 100, "motor.roll.output"},
    {"power.pitch", "Motor power, pitch", "Motors", "%", 0, Axis::Pitch, 0, 100, "motor.pitch.output"},
    {"power.yaw", "Motor power, yaw", "Motors", "%", 0, Axis::Yaw, 0, 100, "motor.yaw.output"},
    {"balance.roll", "Balance error, roll", "Motors", "%", 1, Axis::Roll, -100, 100},
    {"balance.pitch", "Balance error, pitch", "Motors", "%", 1, Axis::Pitch, -100, 100},
    {"balance.yaw", "Balance error, yaw", "Motors", "%", 1, Axis::Yaw, -100, 100},
    {"rc.roll", "RC input, roll", "Remote control", "", 0, Axis::None, 1000, 2000},
    {"rc.pitch", "RC input, pitch", "Remote control", "", 0, Axis::None, 1000, 2000},
    {"rc.yaw", "RC input, yaw", "Remote control", "", 0, Axis::None, 1000, 2000},
    {"rc.cmd", "RC input, command", "Remote control", "", 0, Axis::None, 1000, 2000},
    {"fc.roll", "Flight controller input, roll", "Remote control", "", 0, Axis::None, 1000, 2000},
    {"fc.pitch", "Flight controller input, pitch", "Remote control", "", 0, Axis::None, 1000, 2000},
    {"battery", "Battery", "Power", "V", 2, Axis::None, 0, 30, "battery"},
    {"current", "Current", "Power", "A", 3, Axis::None, 0, 10, "current", "current"},
    {"temperature.imu", "IMU temperature", "Board", "°C", 0, Axis::None, -20, 80, "temperature"},
    {"temperature.frame", "Frame IMU temperature", "Board", "°C", 0, Axis::None, -20, 80},
    {"mag.roll", "Magnetometer, roll", "Inertial sensors", "", 0, Axis::Roll, -2000, 2000},
    {"mag.pitch", "Magnetometer, pitch", "Inertial sensors", "", 0, Axis::Pitch, -2000, 2000},
    {"mag.yaw", "Magnetometer, yaw", "Inertial sensors", "", 0, Axis::Yaw, -2000, 2000},
    {"error.gravity", "Gravity error", "Inertial sensors", "°", 1, Axis::None, 0, 25},
    {"error.heading", "Heading error", "Inertial sensors", "°", 1, Axis::None, 0, 25},
    {"cycle_time", "Cycle time", "Board", "µs", 0, Axis::None, 0, 2000, "cycle_time"},
    {"errors.i2c", "I2C errors", "Board", "", 0, Axis::None, 0, 100, "bus_errors"},
    {"errors.serial", "Bad frames received", "Board", "", 0, Axis::None, 0, 100},
    {"system.error", "System error bits", "Board", "", 0, Axis::None, 0, 4095, "faults", "", 1, kFaultNames, true},
    {"system.sub_error", "Emergency stop cause", "Board", "", 0, Axis::None, 0, 60, "fault_detail", "", 1, kStopCauses},
    {"motors.on", "Motors running", "Board", "", 0, Axis::None, 0, 1, "outputs", "", 1, kOffOn},
    {"imu.selected", "Selected IMU", "Board", "", 0, Axis::None, 1, 2, "sensor", "", 1, kImuNames},
    {"profile.active", "Active profile", "Board", "", 0, Axis::None, 0, 4, "profile", "", 1, kActiveProfiles},
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
    {"motor4.speed", "Fourth motor, feed-forward speed", "Motors", "", 0, Axis::None, -1000, 1000},
    {"motor4.error", "Fourth motor, angle error", "Motors", "", 0, Axis::None, -1000, 1000},
    {"motor4.output", "Fourth motor, controller output", "Motors", "", 3, Axis::None, -1, 1},
    {"ahrs.source.main", "Attitude reference, main IMU", "Attitude checks", "", 0, Axis::None, 0, 255},
    {"ahrs.source.frame", "Attitude reference, frame IMU", "Attitude checks", "", 0, Axis::None, 0, 255},
    {"ahrs.error.main_z", "Gravity error, main IMU", "Attitude checks", "°", 1, Axis::None, 0, 25},
    {"ahrs.error.main_h", "Heading error, main IMU", "Attitude checks", "°", 1, Axis::None, 0, 25},
    {"ahrs.error.frame_z", "Gravity error, frame IMU", "Attitude checks", "°", 1, Axis::None, 0, 25},
    {"ahrs.error.frame_h", "Heading error, frame IMU", "Attitude checks", "°", 1, Axis::None, 0, 25},
    {"ext_imu.status", "External IMU, status", "Attitude checks", "", 0, Axis::None, 0, 255},
    {"ext_imu.packets", "External IMU, packets", "Attitude checks", "", 0, Axis::None, 0, 65535},
    {"ext_imu.faults", "External IMU, bad packets", "Attitude checks", "", 0, Axis::None, 0, 65535},
    {"ext_imu.error_h", "External IMU, heading error", "Attitude checks", "", 0, Axis::None, 0, 255},
    {"ext_imu.error_z", "External IMU, gravity error", "Attitude checks", "", 0, Axis::None, 0, 255},
    {"encoder.roll", "Encoder, roll", "High resolution", "", 0, Axis::Roll, 0, 16777215},
    {"encoder.pitch", "Encoder, pitch", "High resolution", "", 0, Axis::Pitch, 0, 16777215},
    {"encoder.yaw", "Encoder, yaw", "High resolution", "", 0, Axis::Yaw, 0, 16777215},
    {"imu.angle_float.roll", "Camera angle, floating point, roll", "High resolution", "°", 4, Axis::Roll, -180, 180},
    {"imu.angle_float.pitch", "Camera angle, floating point, pitch", "High resolution", "°", 4, Axis::Pitch, -180, 180},
    {"imu.angle_float.yaw", "Camera angle, floating point, yaw", "High resolution", "°", 4, Axis::Yaw, -180, 180},
    {"imu.angle20.roll", "Camera angle, 20 bits, roll", "High resolution", "°", 4, Axis::Roll, -180, 180},
    {"imu.angle20.pitch", "Camera angle, 20 bits, pitch", "High resolution", "°", 4, Axis::Pitch, -180, 180},
    {"imu.angle20.yaw", "Camera angle, 20 bits, yaw", "High resolution", "°", 4, Axis::Yaw, -180, 180},
    {"target.angle20.roll", "Target angle, 20 bits, roll", "High resolution", "°", 4, Axis::Roll, -180, 180},
    {"target.angle20.pitch", "Target angle, 20 bits, pitch", "High resolution", "°", 4, Axis::Pitch, -180, 180},
    {"target.angle20.yaw", "Target angle, 20 bits, yaw", "High resolution", "°", 4, Axis::Yaw, -180, 180},
    {"frame_camera.angle20.roll", "Frame-camera angle, 20 bits, roll", "High resolution", "°", 4, Axis::Roll, -180, 180},
    {"frame_camera.angle20.pitch", "Frame-camera angle, 20 bits, pitch", "High resolution", "°", 4, Axis::Pitch, -180, 180},
    {"frame_camera.angle20.yaw", "Frame-camera angle, 20 bits, yaw", "High resolution", "°", 4, Axis::Yaw, -180, 180},
    {"script.float.1", "Script variable 1", "Script variables", "", 3, Axis::None, -1, 1},
    {"script.float.2", "Script variable 2", "Script variables", "", 3, Axis::None, -1, 1},
    {"script.float.3", "Script variable 3", "Script variables", "", 3, Axis::None, -1, 1},
    {"script.float.4", "Script variable 4", "Script variables", "", 3, Axis::None, -1, 1},
    {"script.float.5", "Script variable 5", "Script variables", "", 3, Axis::None, -1, 1},
    {"script.float.6", "Script variable 6", "Script variables", "", 3, Axis::None, -1, 1},
    {"script.float.7", "Script variable 7", "Script variables", "", 3, Axis::None, -1, 1},
    {"script.float.8", "Script variable 8", "Script variables", "", 3, Axis::None, -1, 1},
    {"script.float.9", "Script variable 9", "Script variables", "", 3, Axis::None, -1, 1},
    {"script.float.10", "Script variable 10", "Script variables", "", 3, Axis::None, -1, 1},
    {"script.int.1", "Script variable 1, whole number", "Script variables", "", 0, Axis::None, -32768, 32767},
    {"script.int.2", "Script variable 2, whole number", "Script variables", "", 0, Axis::None, -32768, 32767},
    {"script.int.3", "Script variable 3, whole number", "Script variables", "", 0, Axis::None, -32768, 32767},
    {"script.int.4", "Script variable 4, whole number", "Script variables", "", 0, Axis::None, -32768, 32767},
    {"script.int.5", "Script variable 5, whole number", "Script variables", "", 0, Axis::None, -32768, 32767},
    {"script.int.6", "Script variable 6, whole number", "Script variables", "", 0, Axis::None, -32768, 32767},
    {"script.int.7", "Script variable 7, whole number", "Script variables", "", 0, Axis::None, -32768, 32767},
    {"script.int.8", "Script variable 8, whole number", "Script variables", "", 0, Axis::None, -32768, 32767},
    {"script.int.9", "Script variable 9, whole number", "Script variables", "", 0, Axis::None, -32768, 32767},
    {"script.int.10", "Script variable 10, whole number", "Script variables", "", 0, Axis::None, -32768, 32767},
    {"motor.output.roll", "Motor output, roll", "Power", "%", 1, Axis::Roll, -100, 100},
    {"motor.current.roll", "Motor current, roll", "Power", "A", 3, Axis::Roll, 0, 10},
    {"motor.temperature.roll", "Motor temperature, roll", "Power", "°C", 0, Axis::Roll, -20, 120, "motor.roll.temperature"},
    {"motor.flags.roll", "Motor driver flags, roll", "Power", "", 0, Axis::Roll, 0, 7, "", "", 1, kDriverFlags, true},
    {"motor.output.pitch", "Motor output, pitch", "Power", "%", 1, Axis::Pitch, -100, 100},
    {"motor.current.pitch", "Motor current, pitch", "Power", "A", 3, Axis::Pitch, 0, 10},
    {"motor.temperature.pitch", "Motor temperature, pitch", "Power", "°C", 0, Axis::Pitch, -20, 120, "motor.pitch.temperature"},
    {"motor.flags.pitch", "Motor driver flags, pitch", "Power", "", 0, Axis::Pitch, 0, 7, "", "", 1, kDriverFlags, true},
    {"motor.output.yaw", "Motor output, yaw", "Power", "%", 1, Axis::Yaw, -100, 100},
    {"motor.current.yaw", "Motor current, yaw", "Power", "A", 3, Axis::Yaw, 0, 10},
    {"motor.temperature.yaw", "Motor temperature, yaw", "Power", "°C", 0, Axis::Yaw, -20, 120, "motor.yaw.temperature"},
    {"motor.flags.yaw", "Motor driver flags, yaw", "Power", "", 0, Axis::Yaw, 0, 7, "", "", 1, kDriverFlags, true},
    {"power.state", "State of the power manager", "Power", "", 0, Axis::None, -2, 4},
    {"power.voltage", "Supply voltage", "Power", "V", 2, Axis::None, 0, 30},
    {"power.current", "Supply current", "Power", "A", 3, Axis::None, 0, 10},
    {"power.flags", "Flags of the power manager", "Power", "", 0, Axis::None, 0, 65535},
    {"frame_camera.rate.roll", "Rate between frame and camera, roll", "Angles", "°/s", 2, Axis::Roll, -200, 200},
    {"frame_camera.rate.pitch", "Rate between frame and camera, pitch", "Angles", "°/s", 2, Axis::Pitch, -200, 200},
    {"frame_camera.rate.yaw", "Rate between frame and camera, yaw", "Angles", "°/s", 2, Axis::Yaw, -200, 200},
    {"comm.i2c", "I2C error counter", "Board", "", 0, Axis::None, 0, 100},
    {"comm.serial", "Serial error counter", "Board", "", 0, Axis::None, 0, 100},
    {"comm.can", "CAN error counter", "Board", "", 0, Axis::None, 0, 100},
    {"comm.can_flags", "CAN error flags", "Board", "", 0, Axis::None, 0, 255},
    {"system.state", "System state flags", "Board", "", 0, Axis::None, 0, 32767, "", "", 1, kStateFlags, true},
    {"system.calibration", "Calibration in progress", "Board", "", 0, Axis::None, 0, 60, "", "", 1, kCalibModes},
    {"imu.quaternion.w", "Camera attitude, quaternion w", "Attitude quaternions", "", 4, Axis::None, -1, 1},
    {"imu.quaternion.x", "Camera attitude, quaternion x", "Attitude quaternions", "", 4, Axis::None, -1, 1},
    {"imu.quaternion.y", "Camera attitude, quaternion y", "Attitude quaternions", "", 4, Axis::None, -1, 1},
    {"imu.quaternion.z", "Camera attitude, quaternion z", "Attitude quaternions", "", 4, Axis::None, -1, 1},
    {"target.quaternion.w", "Target attitude, quaternion w", "Attitude quaternions", "", 4, Axis::None, -1, 1},
    {"target.quaternion.x", "Target attitude, quaternion x", "Attitude quaternions", "", 4, Axis::None, -1, 1},
    {"target.quaternion.y", "Target attitude, quaternion y", "Attitude quaternions", "", 4, Axis::None, -1, 1},
    {"target.quaternion.z", "Target attitude, quaternion z", "Attitude quaternions", "", 4, Axis::None, -1, 1},
    {"frame.quaternion.w", "Camera against frame, quaternion w", "Attitude quaternions", "", 4, Axis::None, -1, 1},
    {"frame.quaternion.x", "Camera against frame, quaternion x", "Attitude quaternions", "", 4, Axis::None, -1, 1},
    {"frame.quaternion.y", "Camera against frame, quaternion y", "Attitude quaternions", "", 4, Axis::None, -1, 1},
    {"frame.quaternion.z", "Camera against frame, quaternion z", "Attitude quaternions", "", 4, Axis::None, -1, 1},
    {"adc.1", "Analogue input 1", "Board", "", 0, Axis::None, 0, 4095},
    {"adc.2", "Analogue input 2", "Board", "", 0, Axis::None, 0, 4095},
    {"adc.3", "Analogue input 3", "Board", "", 0, Axis::None, 0, 4095},
    {"adc.4", "Analogue input 4", "Board", "", 0, Axis::None, 0, 4095},
    {"limit.roll.low", "Distance to the lower limit, roll", "Limits", "", 0, Axis::Roll, -16384, 16384},
    {"limit.roll.high", "Distance to the upper limit, roll", "Limits", "", 0, Axis::Roll, -16384, 16384},
    {"limit.pitch.low", "Distance to the lower limit, pitch", "Limits", "", 0, Axis::Pitch, -16384, 16384},
    {"limit.pitch.high", "Distance to the upper limit, pitch", "Limits", "", 0, Axis::Pitch, -16384, 16384},
    {"limit.yaw.low", "Distance to the lower limit, yaw", "Limits", "", 0, Axis::Yaw, -16384, 16384},
    {"limit.yaw.high", "Distance to the upper limit, yaw", "Limits", "", 0, Axis::Yaw, -16384, 16384},
    {"follow.distance.roll", "Follow distance, roll", "Limits", "", 0, Axis::Roll, -16384, 16384},
    {"follow.distance.pitch", "Follow distance, pitch", "Limits", "", 0, Axis::Pitch, -16384, 16384},
    {"follow.distance.yaw", "Follow distance, yaw", "Limits", "", 0, Axis::Yaw, -16384, 16384},
    {"external_limit.low.roll", "Lower target limit from outside, roll", "Limits", "", 0, Axis::Roll, -1048576, 1048576},
    {"external_limit.low.pitch", "Lower target limit from outside, pitch", "Limits", "", 0, Axis::Pitch, -1048576, 1048576},
    {"external_limit.low.yaw", "Lower target limit from outside, yaw", "Limits", "", 0, Axis::Yaw, -1048576, 1048576},
    {"external_limit.high.roll", "Upper target limit from outside, roll", "Limits", "", 0, Axis::Roll, -1048576, 1048576},
    {"external_limit.high.pitch", "Upper target limit from outside, pitch", "Limits", "", 0, Axis::Pitch, -1048576, 1048576},
    {"external_limit.high.yaw", "Upper target limit from outside, yaw", "Limits", "", 0, Axis::Yaw, -1048576, 1048576},
};
// clang-format on
static_assert(std::size(kChannels) == ChannelCount);

constexpr double kPowerUnit = 100.0 / 255.0;  // 0-255 as percent of full power
constexpr double kBalanceUnit = 100.0 / 512.0;  // 512 = all of the motor's power
constexpr double kRcFineUnit = 100.0 / 16384.0;
constexpr double kNoSignal = -32768;  // of the same

// REALTIME_DATA_3 and _4, errata 3.8.
// clang-format off
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
// clang-format on

template <std::size_t N>
constexpr std::array<WireField, N> run(int channel, WireField::Type type, double unit)
{
    std::array<WireField, N> fields{};
    for (std::size_t i = 0; i < N; ++i)
        fields[i] = {channel + int(i), int(i) * fieldSize(type), type, unit};
    return fields;
}

constexpr std::array<WireField, 3> three(int channel, double unit)
{
    return run<3>(channel, WireField::I16, unit);
}

constexpr auto kImu = three(ImuRoll, kDegreesPerCount);
constexpr auto kTarget = three(TargetRoll, kDegreesPerCount);
constexpr auto kTargetSpeed = three(TargetSpeedRoll, kGyroUnit);
constexpr auto kRotor = three(RotorRoll, kDegreesPerCount);
constexpr auto kGyro = three(GyroRoll, kGyroUnit);
constexpr auto kRcData = run<6>(RcData1, WireField::RcSignal, kRcFineUnit);
constexpr auto kVectors = run<6>(Z1X, WireField::F32, 1.0);
constexpr auto kRcChannels = run<18>(RcChannel1, WireField::RcSignal, kRcFineUnit);
constexpr auto kAcc = three(AccX, kAccUnit);

// Later ones (errata 3.9, bits 9 and up).
constexpr double kFineAngle = 360.0 / 1048576.0;
constexpr double kQuaternionUnit = 741453.786;  // the three smaller components are below 1/sqrt(2)

constexpr std::array<WireField, 4> quaternion(int channel)
{
    std::array<WireField, 4> fields{};
    for (int i = 0; i < 4; ++i)
        fields[std::size_t(i)] = {channel + i, 0, WireField::Quaternion, 1.0, i};
    return fields;
}

constexpr WireField kMotor4[] = {
    {Motor4Speed, 0, WireField::I16},
    {Motor4Error, 2, WireField::I16},
    {Motor4Output, 4, WireField::F32},
};
constexpr WireField kAhrs[] = {
    // errata 3.22
    {AhrsMainSource, 0, WireField::U8},  {AhrsFrameSource, 1, WireField::U8},
    {AhrsMainZ, 2, WireField::U8, 0.1},  {AhrsMainH, 3, WireField::U8, 0.1},
    {AhrsFrameZ, 4, WireField::U8, 0.1}, {AhrsFrameH, 5, WireField::U8, 0.1},
    {ExtImuStatus, 6, WireField::U8},    {ExtImuPackets, 7, WireField::U16},
    {ExtImuFaults, 9, WireField::U16},   {ExtImuH, 11, WireField::U8},
    {ExtImuZ, 12, WireField::U8},
};
constexpr auto kEncoders = run<3>(EncoderRoll, WireField::U24, 1.0);
constexpr auto kImuRad = run<3>(ImuRadRoll, WireField::F32, kDegreesPerRadian);
constexpr auto kScriptFloats = run<10>(ScriptFloat1, WireField::F32, 1.0);
constexpr auto kScriptInts = run<10>(ScriptInt1, WireField::I16, 1.0);
constexpr std::array<WireField, 16> powerState()
{
    std::array<WireField, 16> fields{};
    for (int a = 0; a < 3; ++a) {  // 13 bytes each, the last 6 reserved
        const auto i = std::size_t(a) * 4;
        const int channel = MotorRollOutput + 4 * a;
        fields[i] = {channel, 13 * a, WireField::I16, 0.01};
        fields[i + 1] = {channel + 1, 13 * a + 2, WireField::U16, 0.001};
        fields[i + 2] = {channel + 2, 13 * a + 4, WireField::I8};
        fields[i + 3] = {channel + 3, 13 * a + 5, WireField::U16};
    }
    fields[12] = {PowerState, 39, WireField::I8};
    fields[13] = {SupplyVoltage, 40, WireField::U16, 0.01};
    fields[14] = {SupplyCurrent, 42, WireField::U16, 0.001};
    fields[15] = {PowerFlags, 44, WireField::U16};
    return fields;
}
constexpr auto kPowerState = powerState();
constexpr auto kFrameRate = three(FrameRateRoll, kGyroUnit);
constexpr auto kImu20 = run<3>(Imu20Roll, WireField::I32, kFineAngle);
constexpr auto kTarget20 = run<3>(Target20Roll, WireField::I32, kFineAngle);
constexpr WireField kCommErrors[] = {
    {CommI2c, 0, WireField::U16},
    {CommSerial, 2, WireField::U16},
    {CommCan, 4, WireField::U16},
    {CommCanFlags, 6, WireField::U8},
};
constexpr WireField kSystemState[] = {{StateFlags, 0, WireField::U32}, {CalibrationMode, 4, WireField::U8}};
constexpr auto kImuQuaternion = quaternion(ImuQuatW);
constexpr auto kTargetQuaternion = quaternion(TargetQuatW);
constexpr auto kFrameQuaternion = quaternion(FrameQuatW);
constexpr auto kAdc = run<4>(Adc1, WireField::U16, 1.0);
constexpr auto kLimits = run<6>(LimitRollLow, WireField::I16, 1.0);
constexpr auto kFollow = three(FollowRoll, 1.0);
constexpr auto kExternalLimits = run<6>(ExtLowRoll, WireField::I32, 1.0);
constexpr auto kFrameCam20 = run<3>(FrameCam20Roll, WireField::I32, kFineAngle);

// In bit order. Bit 29, "main IMU state", has 11 undocumented bytes and is not requested.
// clang-format off
constexpr CustomField kCustom[] = {
    {0, 6, kImu},            {1, 6, kTarget},             {2, 6, kTargetSpeed},      {3, 6, kRotor},
    {4, 6, kGyro},           {5, 12, kRcData},            {6, 24, kVectors},         {7, 36, kRcChannels},
    {8, 6, kAcc},            {9, 8, kMotor4},             {10, 26, kAhrs},           {11, 9, kEncoders},
    {12, 12, kImuRad},       {13, 40, kScriptFloats},     {14, 20, kScriptInts},     {15, 46, kPowerState},
    {16, 6, kFrameRate},     {17, 12, kImu20},            {18, 12, kTarget20},       {19, 7, kCommErrors},
    {20, 13, kSystemState},  {21, 8, kImuQuaternion},     {22, 8, kTargetQuaternion}, {23, 8, kFrameQuaternion},
    {24, 8, kAdc},           {25, 12, kLimits},           {26, 6, kFollow},          {27, 24, kExternalLimits},
    {28, 12, kFrameCam20},
};
// clang-format on

}  // namespace

ChannelTable channelTable(int firmware)
{
    const ChannelTable all(kChannels);
    return firmware >= kLaterCustomFirmware ? all : all.first(RcChannel18 + 1);
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
    case CommandId::RealtimeDataCustom: return customLayout(customFlags);
    case CommandId::AhrsHelper:
        return {kVectors.begin(), kVectors.end()};  // errata 3.22: Z, then H, as in CUSTOM
    case CommandId::RealtimeData3:
    case CommandId::RealtimeData4: {
        std::vector<WireField> fields;
        std::copy_if(std::begin(kRealtime), std::end(kRealtime), std::back_inserter(fields),
                     [id](const WireField &field) {
                         return id == number(CommandId::RealtimeData4) || field.offset < kRealtime3Size;
                     });
        return fields;
    }
    default: return {};
    }
}

std::array<double, 4> unpackQuaternion(quint64 packed)
{
    std::array<double, 4> result{};
    const auto largest = std::size_t(packed >> 60 & 3);
    double rest = 1.0;
    int shift = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        if (i == largest)
            continue;
        const double size = double(packed >> shift & 0x7FFFF) / kQuaternionUnit;
        result[i] = packed >> (shift + 19) & 1 ? -size : size;
        rest -= size * size;
        shift += 20;
    }
    const double size = std::sqrt(std::max(0.0, rest));
    result[largest] = packed >> 62 & 1 ? -size : size;
    return result;
}

quint64 packQuaternion(const std::array<double, 4> &quaternion)
{
    const auto bySize = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto largest
        = std::size_t(std::max_element(quaternion.begin(), quaternion.end(), bySize) - quaternion.begin());
    quint64 packed = quint64(largest) << 60 | quint64(quaternion[largest] < 0) << 62;
    int shift = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        if (i == largest)
            continue;
        packed |= quint64(std::lround(std::abs(quaternion[i]) * kQuaternionUnit)) << shift;
        packed |= quint64(quaternion[i] < 0) << (shift + 19);
        shift += 20;
    }
    return packed;
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
    case WireField::RcSignal:
        value = reader.i16();
        if (value == kNoSignal)
            return std::numeric_limits<float>::quiet_NaN();
        break;
    case WireField::U24:
        value = reader.u16();
        value += reader.u8() * 65536.0;
        break;
    case WireField::I32: value = reader.i32(); break;
    case WireField::U32: value = reader.u32(); break;
    case WireField::F32: value = double(reader.f32()); break;
    case WireField::Quaternion:
        return static_cast<float>(unpackQuaternion(reader.read<quint64>())[std::size_t(field.mask)]);
    }
    if (field.mask)
        value = static_cast<int>(value) & field.mask;
    return static_cast<float>(value * field.scale);
}

}  // namespace simplebgc
