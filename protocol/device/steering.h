// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/axis.h"
#include "protocol/base/latestvalues.h"
#include "protocol/configuration/parameterspec.h"

#include <span>
#include <vector>

struct ControlFrames;

/// One thing to steer with, as the operator sees it: a stick, a slider, an angle to go to.
struct SteeringInput
{
    const char *key = "";
    const char *label = "";
    Axis axis = Axis::None;  ///< what it turns; None for a speed, a throttle ...
    const char *unit = "";
    double min = -1;
    double max = 1;
    double centre = 0;
    bool springsBack = true;  ///< returns to its centre when let go; otherwise it stays
    double padReach = 0;  ///< where the rim of a pad points; 0: the family leaves it to the screen
};

/// A switch that goes with the set-points.
struct SteeringSwitch
{
    const char *key = "";
    const char *label = "";
    std::span<const Choice> choices{};
    int start = 0;  ///< where it stands before the operator touches it
    bool arms = false;  ///< anything but its start drives the motors
};

/// A way of steering: which inputs there are.
struct SteeringMode
{
    int id = 0;
    const char *key = "";
    const char *label = "";
    std::vector<SteeringInput> inputs;

    /// Position of the input that turns this axis, or -1.
    [[nodiscard]] int inputOf(Axis axis) const;
    /// Position of the input with that key, or -1.
    [[nodiscard]] int find(const char *wanted) const;
    /// The axes are steered to places, which stay, and not by how fast they turn.
    [[nodiscard]] bool isPositional() const;
};

/// Where inputs and switches stand. Inputs that are NaN are left alone.
struct SteeringSetpoint
{
    int mode = 0;  ///< id of a mode
    std::vector<double> inputs;  ///< in the order of the mode's
    std::vector<int> switches;  ///< in the order of Steering::switches()
    bool holds = false;  ///< nothing was moved since arming: no limit applies to where everything is
};

/// Boards that can be steered. Set-points are streamed by the I/O thread with the dead-man's rule.
class Steering
{
public:
    virtual ~Steering() = default;
    [[nodiscard]] virtual std::span<const SteeringMode> modes() const = 0;
    [[nodiscard]] virtual std::span<const SteeringSwitch> switches() const = 0;
    /// Set-points that keep everything where it is now, so that arming moves nothing. NaN where that is
    /// unknown.
    [[nodiscard]] virtual SteeringSetpoint holdingSetpoint(int mode, const LatestValues &latest) const = 0;
    /// The frames for the wire; an empty set-point where nothing is to be sent.
    [[nodiscard]] virtual ControlFrames controlFrames(const SteeringSetpoint &setpoint) const = 0;

    [[nodiscard]] const SteeringMode *mode(int id) const;
};
