// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <utility>
#include <vector>

/// What a gimbal can be for, and which values follow from that.
struct GimbalUse
{
    const char *key = "";
    /// By key of the parameter, as it is shown.
    std::vector<std::pair<QString, double>> values;
};

/// Two parameters between which an axis moves, in degrees.
struct SetupRange
{
    /// What is limited: where steering reaches, where the axis stops against the frame, or the same as its
    /// encoder tells it.
    enum class Of { Steering, Joint, Encoder };

    QString lowest;
    QString highest;
    Of of = Of::Steering;
};

/// What a board calls that which a new gimbal needs to have found and set; an empty name: it has no such
/// thing. Names of an axis' parameters have "%1" for it.
struct SetupKeys
{
    QString batteryAlarm;  ///< V
    QString batteryOff;  ///< V below which motors are switched off
    /// The sensor's axis that points up, and the one that points right: 1 to 3 for X to Z, negative for the
    /// opposite.
    QString axisUp;
    QString axisRight;
    QString encoderType;  ///< 0: that axis has none
    QString poles;
    QString motorInverted;
    QString motorPower;  ///< which can be changed in use alone
    QString motorOutput;  ///< 0: no motor turns that axis
    std::vector<SetupRange> ranges;
    // Capabilities.
    QString magnetometer;
    QString encoders;
    // Remote control.
    QString inputMap;  ///< which input steers an axis, or gives commands where "%1" is `commandInput`
    QString inputInverted;
    QString inputChannel;  ///< telemetry: what the board takes for that function's signal
    QString commandInput;
    // Actions.
    QString readInputs;  ///< its reply has "input.NAME" in %, the names those of the map's choices; its
                         ///< argument "initialize" has inputs read that nothing uses yet
    QString calibrateGyro;  ///< its reply has "gyro.bias.before" and "gyro.bias.after", °/s
    QString calibrateLevel;  ///< its reply has "acc.error.before" and "acc.error.after", g
    QString findPoles;
    QString autoTune;
    std::vector<GimbalUse> uses;
};

/// Boards that can be led from the box to a tuned gimbal.
class SetupFacts
{
public:
    virtual ~SetupFacts() = default;
    [[nodiscard]] virtual SetupKeys setupKeys() const = 0;
};
