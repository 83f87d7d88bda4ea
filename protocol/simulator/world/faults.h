// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

#include <QStringList>

/// What can go wrong with a simulated gimbal and its cable. Each has a name for `gimbalsim --fault
/// NAME=VALUE`.
struct Faults
{
    double loseByte = 0;  ///< lose: probability per byte (of a network: per packet), both directions
    double flipByte = 0;  ///< flip: probability that one bit of a byte is wrong
    double doubleByte = 0;  ///< double: probability that a byte (or packet) arrives twice
    int delayMs = 0;  ///< delay: data to the host are delayed by up to this many ms
    int lateMs = 0;  ///< late: everything that the board sends comes so much later
    double reorder = 0;  ///< reorder: probability that a packet is overtaken by the next one
    double unplugAfter = -1;  ///< unplug: seconds until the cable is pulled
    double replugAfter = 3;  ///< replug: seconds until it is plugged in again; negative = never
    double resetAfter = -1;  ///< reset: seconds until the board restarts by itself, without notice
    int resetOnWrite = 0;  ///< reset-on-write: the n-th parameter block written from now on resets the board
                           ///< half-way; a drone: the n-th gain
    int deaf = -1;  ///< deaf: number, or letter code, of a command that is never answered; -1 = none
    int failWith = 0;  ///< fail: error code with which a calibration or auto-tune ends half-way, 0 = none
    double lateStreams
        = 0;  ///< late-streams: seconds after a calibration, which answers nothing then; 0 = normal
    bool noImu = false;  ///< no-imu
    bool frozen = false;  ///< frozen: live data stand still, with their time stamps
    double battery = 0;  ///< battery: volts, 0 = normal
    double heat = 0;  ///< heat: °C of the board's sensor and of its motors, 0 = normal
    int blocked = 0;  ///< blocked: an axis that something holds fast, 1-3 = roll, pitch, yaw; 0 = none
    bool runsOn
        = false;  ///< runs-on: what switches the motors off, or ends a search, is confirmed and not obeyed
    bool unknownFirmware = false;  ///< unknown-firmware: reports an unknown version
    double otherClient = -1;  ///< other-client: seconds until another client changes P of roll by 10
    double otherGround = 0;  ///< other-ground: packets per second of another station on the same network,
                             ///< which gets the answers and streams until we write again; 0 = none
    double silentArmed = 0;  ///< silent-armed: seconds for which a drone neither hears nor sends anything
                             ///< once it is armed; it flies on as it was told last; 0 = none
    double shake = 1;  ///< shake: strength of the hand, 0 = tripod
    bool swappedAxes = false;  ///< swapped-axes: roll and pitch motors are swapped
    int pose = 0;  ///< pose: 0 in the gimbal, 1-6 the camera lies still with Z, -Z, X, -X, Y, -Y up, 7 tilted
                   ///< 45° down; a drone: see its board
    int hand = 0;  ///< hand: what a hand does with the camera in the gimbal: 0 nothing, 1 holds it level, 2
                   ///< moves it to and fro as far as it goes, 3 tilts its nose down, 4 its right side, 5
                   ///< turns it to all sides, 6 about its upright axis only
    double imbalance = 100;  ///< imbalance: how far off balance the camera is mounted, % of a usual one
    int mount
        = 0;  ///< mount: orientation of the sensor on the camera, as STorM32 numbers them; SimpleBGC: 4 times
              ///< which axis points up (Z X Y -Z -X -Y), and which of the others right (Z: X Y -X -Y)
    int receiver = 0;  ///< receiver: at the board's inputs: 0 none, 1 with a wire for each channel, 2 CPPM, 3
                       ///< S-bus, 4 Spektrum
    int stick = 0;  ///< stick: which one is held at an end: 0 none, 1 roll to the right, 2 to the left, 3
                    ///< pitch down, 4 up, 5 yaw right, 6 left, 7 the switch up, 8 down, 9 roll and pitch
    double rcNoise = 1;  ///< rc-noise: of the pulses that a receiver gives, µs
    double rcLoss = 0;  ///< rc-loss: probability that a frame of the transmitter is not received
    int frameMount = 0;  ///< frame-mount: the same for the second sensor, at the frame

    /// Parses NAME=VALUE, for a family (key; empty: whichever it is). Errors: InvalidArgument listing all
    /// faults, or saying that its simulator has none of that name.
    Result<void> set(const QString &assignment, const QString &family = {});
    /// Lines "name=range  meaning" for --help.
    [[nodiscard]] static QStringList help();
};
