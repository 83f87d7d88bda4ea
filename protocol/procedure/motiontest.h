// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/axis.h"
#include "protocol/base/result.h"
#include "protocol/telemetry/uniformsamples.h"

class Channel;
class Device;

/// A small movement that is made on purpose, to see how an axis follows.
struct MotionTestPlan
{
    enum class Kind { Steps, Sweep };

    static constexpr double kMaxDegrees = 10;

    Kind kind = Kind::Steps;
    Axis axis = Axis::Pitch;
    double degrees = 2;  ///< height of a step, or half of the swing; 0.2 to kMaxDegrees
    int steps = 6;  ///< there and back counts two; 2 to 40
    double rest = 1.0;  ///< seconds from step to step, 0.3 to 5
    double fromHz = 0.5;  ///< of a sweep, 0.1 to toHz
    double toHz = 12;  ///< up to 20: set-points go out 50 times a second
    double sweepSeconds = 20;  ///< 5 to 120
    double limit = 4;  ///< degrees the axis may be off beyond the movement itself; more ends the test

    /// Errors: OutOfRange.
    [[nodiscard]] Result<void> check() const;
    /// Degrees from the middle at a time since the beginning.
    [[nodiscard]] double offsetAt(double seconds) const;
    [[nodiscard]] double duration() const;
};

/// What was seen of it: both sides at the same instants.
struct MotionTestResult
{
    MotionTestPlan plan;
    UniformSamples target;
    UniformSamples angle;
};

/// Whether the board tells where it wants an axis to be.
[[nodiscard]] bool tellsTargets(const Device &device);
/// The channels of an axis that a test watches and that the board has.
[[nodiscard]] QList<int> motionChannels(const Device &device, Axis axis);

/// Runs a motion test: steers one axis through the channel's control stream (so that the dead-man's rule and
/// "motors off" hold), watches telemetry all the while, and stops when the axis does not follow. Where a
/// board tells its targets, the test begins from the one in force. Where it does not, the camera is brought
/// to its middle first, and what was sent stands for the target; the line's delay cannot be told from the
/// board's own then, so that only steps are measured. The axis' angle, and where the board tells it the
/// target, must come as telemetry meanwhile. Errors besides those of the link: ReadOnly, Unsupported (no way
/// to steer by angle, no telemetry, a sweep without targets), OutOfRange, Unready (motors off, no telemetry,
/// or the axis does not hold still), Diverged (the motors were switched off), Cancelled (control was given
/// back), InvalidArgument (the samples have too many holes).
Result<MotionTestResult> measureMotion(Channel &channel, const Device &device,
                                       const TelemetryStore &telemetry, const MotionTestPlan &plan);
