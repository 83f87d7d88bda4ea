// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/axis.h"
#include "protocol/base/clock.h"
#include "protocol/base/latestvalues.h"
#include "protocol/configuration/parameterspec.h"

#include <optional>
#include <span>
#include <vector>

struct ControlFrames;

/// One input for steering, as the operator sees it: a stick, a slider, a target angle.
struct SteeringInput
{
    const char *key = "";
    const char *label = "";
    Axis axis = Axis::None;  ///< what it turns; None for a speed, a throttle ...
    const char *unit = "";
    double min = -1;
    double max = 1;
    double centre = 0;
    bool springsBack = true;  ///< returns to its centre when released; otherwise it stays
    double padReach = 0;  ///< value at the rim of a pad; 0: the GUI chooses
};

/// A switch sent along with the set-points.
struct SteeringSwitch
{
    const char *key = "";
    const char *label = "";
    std::span<const Choice> choices{};
    int start = 0;  ///< position before the operator touches it
    bool arms = false;  ///< any position but the start drives the motors
};

/// A steering mode and its inputs.
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
    /// The axes are steered to positions, which they keep, rather than by rate.
    [[nodiscard]] bool isPositional() const;
};

/// Positions of inputs and switches. Inputs that are NaN are left unchanged.
struct SteeringSetpoint
{
    int mode = 0;  ///< id of a mode
    std::vector<double> inputs;  ///< in the order of the mode's
    std::vector<int> switches;  ///< in the order of Steering::switches()
    std::optional<TimePoint> begun{};  ///< see ControlFrames
    bool holds = false;  ///< nothing was moved since arming: no limit applies to the present position
};

/// What another than this link may have told a board since it started, if the board itself does not report
/// it.
enum class SteeredBefore {
    Unknown,
    Never,  ///< by the operator's word
};

/// Boards that can be steered. The I/O thread streams set-points under the dead-man rule.
class Steering
{
public:
    virtual ~Steering() = default;
    [[nodiscard]] virtual std::span<const SteeringMode> modes() const = 0;
    [[nodiscard]] virtual std::span<const SteeringSwitch> switches() const = 0;
    /// Set-points that keep everything where it is now, so that arming moves nothing. NaN where it is not
    /// known what does. @param steeredBefore what the board was told before this link
    [[nodiscard]] virtual SteeringSetpoint holdingSetpoint(int mode, const LatestValues &latest,
                                                           SteeredBefore steeredBefore) const = 0;
    /// The frames to send; an empty set-point if nothing is to be sent.
    [[nodiscard]] virtual ControlFrames controlFrames(const SteeringSetpoint &setpoint) const = 0;
    /// Angles at which the board holds roll, pitch and yaw as long as nobody has steered it, in degrees; NaN
    /// for an axis that follows the frame or is steered from outside, and where it is not known.
    [[nodiscard]] virtual std::array<double, kAxisCount> levelAngles(const LatestValues &latest) const;

    [[nodiscard]] const SteeringMode *mode(int id) const;
};
