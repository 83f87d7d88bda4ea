// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"
#include "protocol/base/result.h"
#include "protocol/configuration/scriptmistake.h"

#include <QByteArray>
#include <QVariantMap>

#include <vector>

class Channel;
class Configuration;
struct RawCommand;

/// What a machine that flies tells of its state is old after that: it is asked five times a second, and a
/// lost packet or two are no news.
inline constexpr auto kOldFlightState = milliseconds(1500);

/// Where outputs are streamed some come within that time. A machine that tells none is believed by its word
/// that it is disarmed only then: what is older was told before it was stopped, and proves nothing.
inline constexpr auto kOutputsTold = milliseconds(600);

/// Machines that fly: their motors run as long as what steers them says "armed", and stopping them makes them
/// fall. They are steered through Steering, whose only switch arms; see ArmingSession for the rules.
class FlyingMachine
{
public:
    virtual ~FlyingMachine() = default;

    /// Why it is not steered from here, as a sentence of the tables; empty if it may be (Steering is there
    /// then).
    [[nodiscard]] virtual const char *refusal() const = 0;
    /// The action without which it cannot be armed, where it lacks it (ArmingBar::NotCalibrated).
    [[nodiscard]] virtual const char *calibration() const = 0;
    /// What of a configuration, and of the program that it was read from, decides how its axes are counted
    /// and its motors take part. Where it changes, the directions have to be checked anew.
    [[nodiscard]] virtual QByteArray axesKey(const Configuration &configuration) const = 0;
    /// What speaks against the texts of a configuration, found without running them. Empty proves nothing.
    /// @param board what it holds now, or nothing
    [[nodiscard]] virtual std::vector<ScriptMistake> doubts(const Configuration &wanted,
                                                            const Configuration &board) const = 0;
    /// What is not certain of an action with these arguments, as a sentence of the tables to be told before
    /// it is confirmed; empty: nothing is known to be open.
    [[nodiscard]] virtual const char *doubt(const QString &action, const QVariantMap &arguments) const = 0;
    /// Whether it may be told this now; where that depends on its state it is asked. On the worker. Errors:
    /// ConditionUnmet (it is armed or calibrates), those of the channel.
    virtual Result<void> checkMayTake(Channel &channel, const RawCommand &command) = 0;
    /// Asks it once whether it is armed. On the worker. Errors: those of the channel.
    virtual Result<bool> askArmed(Channel &channel) = 0;
    /// By the operator's word it is held in a test stand: values in use may be set while it is armed.
    /// May be called on any thread.
    virtual void setHeld(bool held) = 0;
};
