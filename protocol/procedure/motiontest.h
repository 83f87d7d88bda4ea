// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/axis.h"
#include "protocol/base/progress.h"
#include "protocol/base/result.h"
#include "protocol/telemetry/uniformsamples.h"

#include <optional>

class Channel;
class Device;

/// A small deliberate movement that shows how an axis follows.
struct MotionTestPlan
{
    enum class Kind { Steps, Sweep };

    static constexpr double kMaxDegrees = 10;

    Kind kind = Kind::Steps;
    Axis axis = Axis::Pitch;
    double degrees = 2;  ///< height of a step, or amplitude of a sweep; 0.2 to kMaxDegrees
    int steps = 6;  ///< there and back count as two; 2 to 40
    double rest = 1.0;  ///< seconds between steps, 0.3 to 5
    double fromHz = 0.5;  ///< of a sweep, 0.1 to toHz
    double toHz = 12;  ///< up to 20: set-points go out 50 times a second
    double sweepSeconds = 20;  ///< 5 to 120
    double limit = 4;  ///< degrees of deviation allowed beyond the movement itself; more ends the test
    double maxRate = 0;  ///< deg/s; an axis that turns faster ends the test as well; 0: any
    /// What strays ends the test by ConditionUnmet, with its motors on: for whoever has weakened them, and
    /// strengthens them then. Too fast an axis is stopped all the same.
    bool mayStray = false;
    std::optional<Progress> told = {};  ///< what is told meanwhile, instead of how far the test is

    /// Errors: OutOfRange.
    [[nodiscard]] Result<void> check() const;
    /// Offset from the middle in degrees, at a time since the beginning.
    [[nodiscard]] double offsetAt(double seconds) const;
    [[nodiscard]] double duration() const;
};

/// What was measured: target and response at the same instants.
struct MotionTestResult
{
    MotionTestPlan plan;
    UniformSamples target;
    UniformSamples angle;
};

/// Whether the board reports its target angles.
[[nodiscard]] bool tellsTargets(const Device &device);
/// The channels of an axis that a test watches and that the board has.
[[nodiscard]] QList<int> motionChannels(const Device &device, Axis axis);

/// Runs a motion test: steers one axis through the channel's control stream (so that the dead-man rule and
/// "motors off" apply), watches telemetry throughout, and stops when the axis does not follow. If the board
/// reports its targets, the test starts from the one in force. If it does not, the camera is moved to its
/// middle first, and the set-points sent are taken as the target; the line's delay then cannot be told apart
/// from the board's own, so only steps are measured. The axis' angle, and the target if the board reports it,
/// must arrive as telemetry during the test. Errors besides those of the link: ReadOnly, Unsupported (no way
/// to steer by angle, no telemetry, a sweep without targets), OutOfRange, Unready (motors off, no telemetry,
/// or the axis does not hold still), Diverged (the motors were switched off), Cancelled (control was
/// released), InvalidArgument (the samples have too many gaps).
Result<MotionTestResult> measureMotion(Channel &channel, const Device &device,
                                       const TelemetryStore &telemetry, const MotionTestPlan &plan);
