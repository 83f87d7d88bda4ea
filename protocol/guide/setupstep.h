// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/actionspec.h"
#include "protocol/device/setupfacts.h"

class Device;

/// The steps from an unpacked gimbal to a tuned one, in this order.
enum class SetupStep : std::uint8_t {
    Power,
    Sensors,
    Gyroscope,
    Orientation,
    Level,
    Balance,
    Motors,
    MotorPower,
    Gains,
    Vibration,
    Limits,
    Remote,
    Use
};
inline constexpr std::size_t kSetupSteps = 13;

/// A step: what it is called, what it needs and does, and what it asks.
struct SetupStepSpec
{
    SetupStep step = SetupStep::Power;
    /// `help` says what it does, `confirm` what has to be so each time, `arguments` what it asks.
    ActionSpec action;
    const char *needs = "";  ///< what the operator has to see to first
    const char *elsewhere = "";  ///< key of the page that has more of the same
};
[[nodiscard]] const SetupStepSpec &setupStep(SetupStep step);
/// All of them. Those that a board lacks something for are left out of `stepsOf`.
[[nodiscard]] std::span<const SetupStepSpec> setupSteps();
[[nodiscard]] std::vector<SetupStep> stepsOf(const Device &device);
/// The step with this key, or this name on the page; null: there is none.
[[nodiscard]] const SetupStepSpec *findSetupStep(const QString &key);

/// What a step measured: its key begins the figure's ("drift.pitch").
struct SetupFigureSpec
{
    const char *key = "";
    const char *label = "";
    const char *unit = "";
    int decimals = 0;
};
[[nodiscard]] std::span<const SetupFigureSpec> setupFigures();
/// "drift.pitch"
[[nodiscard]] inline QString setupFigureKey(const char *figure, Axis axis)
{
    return QLatin1String(figure) + QLatin1Char('.') + QLatin1String(axisKey(axis));
}
/// How that figure is written; null: it is none of ours.
[[nodiscard]] const SetupFigureSpec *findSetupFigure(const QString &key);

/// A sentence about what a step found.
struct SetupRemarkSpec
{
    const char *key = "";
    const char *text = "";
    bool isGood = true;
};
[[nodiscard]] std::span<const SetupRemarkSpec> setupRemarks();
[[nodiscard]] const SetupRemarkSpec *findSetupRemark(const QString &key);
