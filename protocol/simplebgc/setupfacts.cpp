// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a new gimbal needs to have found and set, and what follows from what it is for.
#include "protocol/simplebgc/device.h"

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

// FOLLOW_MODE and the follow rate of yaw (document, CMD_READ_PARAMS_3): in the hand the camera is turned with
// the frame, softly; a drone points it by remote control and follows its heading; a vehicle turns hard and
// often, so only slowly; on a tripod nothing is followed, and the sensor of gravity may be trusted more.
const std::vector<GimbalUse> &gimbalUses()
{
    static const std::vector<GimbalUse> uses{
        {"handheld",
         {{u"follow.mode"_s, 2},
          {u"rc.yaw.follow"_s, 1},
          {u"follow.yaw.speed"_s, 40},
          {u"follow.pitch.speed"_s, 25},
          {u"follow.deadband"_s, 50},
          {u"imu.gyro_trust"_s, 120}}},
        {"drone",
         {{u"follow.mode"_s, 0},
          {u"rc.yaw.follow"_s, 1},
          {u"follow.yaw.speed"_s, 60},
          {u"follow.deadband"_s, 20},
          {u"imu.gyro_trust"_s, 170}}},
        {"vehicle",
         {{u"follow.mode"_s, 0},
          {u"rc.yaw.follow"_s, 1},
          {u"follow.yaw.speed"_s, 15},
          {u"follow.deadband"_s, 100},
          {u"imu.gyro_trust"_s, 200}}},
        {"tripod", {{u"follow.mode"_s, 0}, {u"rc.yaw.follow"_s, 0}, {u"imu.gyro_trust"_s, 80}}},
    };
    return uses;
}

}  // namespace

SetupKeys Device::setupKeys() const
{
    return {.batteryAlarm = u"battery.alarm"_s,
            .batteryOff = u"battery.motors_off"_s,
            .axisUp = u"imu.main.axis_top"_s,
            .axisRight = u"imu.main.axis_right"_s,
            .encoderType = u"encoder.%1.type"_s,
            .poles = u"motor.%1.poles"_s,
            .motorInverted = u"motor.%1.invert"_s,
            .motorPower = u"motor.%1.power"_s,
            .motorOutput = u"motor.%1.output"_s,
            .ranges = {{u"rc.%1.min_angle"_s, u"rc.%1.max_angle"_s},
                       {u"limit.%1.min"_s, u"limit.%1.max"_s, SetupRange::Of::Joint},
                       {u"encoder.%1.limit_min"_s, u"encoder.%1.limit_max"_s, SetupRange::Of::Encoder}},
            .magnetometer = u"magnetometer"_s,
            .encoders = u"encoders"_s,
            .inputMap = u"rc.map.%1"_s,
            .inputInverted = u"rc.%1.inverted"_s,
            .inputChannel = u"rc.%1"_s,
            .commandInput = u"cmd"_s,
            .readInputs = u"inputs"_s,
            .calibrateGyro = u"calibrate.gyro"_s,
            .calibrateLevel = u"calibrate.acc"_s,
            .findPoles = u"calibrate.poles"_s,
            .autoTune = u"autotune"_s,
            .uses = gimbalUses()};
}

}  // namespace simplebgc
