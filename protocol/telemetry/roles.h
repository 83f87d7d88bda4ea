// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/channelspec.h"

#include <QList>
#include <QSet>

#include <array>

/// Finds channels by their meaning, independent of the family's names (ChannelSpec::role):
///   attitude.AXIS, target.AXIS, rate.AXIS   angle, target angle and angular rate of what is stabilised
///   acceleration.x/y/z, frame.AXIS          of its sensor; attitude of the frame it hangs on
///   input.AXIS                              what it is steered with from outside, in any unit
///   motor.N.output, motor.AXIS.output       N from 1
///   motor.AXIS.temperature
///   spectrum.AXIS                           of the rate, as the board computes it: an array over its loop's
///   rate joint.AXIS                              by which the motor has turned the camera against the frame
///   battery, current, temperature, cycle_time, bus_errors
///   battery.charge, battery.level           drawn so far; what the board says is left, in %
///   battery.cells                           that the board counts
///   cpu.load, cpu.temperature, loops        of its processor; rounds of its control loop per second
///   rx.quality, rx.level                    how it receives this computer: %, dBm
///   armed, calibrated, outputs              three different things: ready to fly, level known, motors driven
///   sensor                                  whose rates and accelerations it tells: 1 the camera's, or
///   another calibrating                             it measures its sensors right now faults, fault_detail,
///   profile, state    see the device's FaultWords and StatusWords
class ChannelRoles
{
public:
    ChannelRoles() = default;
    /// @param capabilities of the board, see ChannelSpec::capability
    ChannelRoles(ChannelTable table, const QSet<QString> &capabilities);

    // -1 if the board has no such channel.
    std::array<int, 3> angle{-1, -1, -1};  ///< roll, pitch, yaw
    std::array<int, 3> target{-1, -1, -1};
    std::array<int, 3> gyro{-1, -1, -1};
    std::array<int, 3> acc{-1, -1, -1};  ///< x, y, z
    std::array<int, 3> frameAngle{-1, -1, -1};
    std::array<int, 3> input{-1, -1, -1};
    std::array<int, 3> motorPower{-1, -1, -1};  ///< of the motor that turns that axis
    std::array<int, 3> motorTemperature{-1, -1, -1};
    std::array<int, 3> joint{-1, -1, -1};
    std::array<int, 3> spectrum{-1, -1, -1};
    QList<int> motors;  ///< outputs of numbered motors, in order
    int battery = -1;
    int temperature = -1;
    int current = -1;
    int outputs = -1;  ///< not 0: the motors are driven
    int armed = -1;
    int calibrated = -1;
    int calibrating = -1;
    int faults = -1;
    int faultDetail = -1;
    int activeProfile = -1;
    int cycleTime = -1;
    int busErrors = -1;
    int state = -1;
    int charge = -1;
    int batteryLevel = -1;
    int batteryCells = -1;
    int cpuLoad = -1;
    int cpuTemperature = -1;
    int loops = -1;
    int receiveQuality = -1;
    int receiveLevel = -1;

    /// Those of the given channels that exist.
    [[nodiscard]] static QList<int> present(std::initializer_list<std::array<int, 3>> triples);
};

/// Position of the channel with this role, or -1.
[[nodiscard]] int findRole(ChannelTable table, const QSet<QString> &capabilities, const QByteArray &role);
