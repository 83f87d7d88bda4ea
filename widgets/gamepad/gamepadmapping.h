// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"
#include "widgets/gamepad/gamepadsource.h"

#include <array>
#include <optional>

/// What a stick can steer. For gimbals pitch, yaw and roll turn the camera.
enum class GamepadStick { Throttle, Roll, Pitch, Yaw, Speed };
inline constexpr std::size_t kGamepadSticks = 5;
/// What a button can do.
enum class GamepadButton { ArmHold, Disarm, Centre };
inline constexpr std::size_t kGamepadButtons = 3;

/// What is steered: what a stick does by default depends on it.
enum class GamepadUse { Camera, Flight };

/// Throttle and speed begin at the lower stop; everything else has its middle.
[[nodiscard]] constexpr bool startsAtStop(GamepadStick stick)
{
    return stick == GamepadStick::Throttle || stick == GamepadStick::Speed;
}

/// The axis that steers something, and how.
struct GamepadAxisUse
{
    int axis = -1;  ///< -1: none
    bool inverted = false;
    double deadBand = 0.05;  ///< share of the way that counts as its rest, 0 to 0.5
    double expo = 0.0;  ///< 0 is straight, 1 is gentlest around the rest
    /// Of throttle and speed: a stick that springs back counts from its middle up. Let go, it asks for
    /// nothing.
    bool fromMiddle = false;

    /// What a position of the axis, -1 to 1, means: -1 to 1. Beyond the dead band it begins at nothing.
    [[nodiscard]] double shaped(double position, bool atStop) const;
    friend bool operator==(const GamepadAxisUse &, const GamepadAxisUse &) = default;
};

/// What the sticks and buttons of one kind of gamepad are used for.
struct GamepadMapping
{
    static constexpr double kMaxDeadBand = 0.5;

    std::array<GamepadAxisUse, kGamepadSticks> sticks;
    std::array<int, kGamepadButtons> buttons{-1, -1, -1};

    [[nodiscard]] GamepadAxisUse &operator[](GamepadStick stick) { return sticks[std::size_t(stick)]; }
    [[nodiscard]] const GamepadAxisUse &operator[](GamepadStick stick) const
    {
        return sticks[std::size_t(stick)];
    }
    [[nodiscard]] int &operator[](GamepadButton button) { return buttons[std::size_t(button)]; }
    [[nodiscard]] int operator[](GamepadButton button) const { return buttons[std::size_t(button)]; }
    /// What an ordinary pad does until something else is assigned: for a drone the left stick is throttle and
    /// yaw, the right one roll and pitch (mode 2); for a camera the right one pans and tilts.
    /// @param layout GamepadReading::layout; without the sticks in it nothing is assigned
    [[nodiscard]] static GamepadMapping standard(const QByteArray &layout, GamepadUse use);
    /// Something is assigned.
    [[nodiscard]] bool isSetUp() const;
    /// Assigns an axis; whatever it steered before loses it.
    void assign(GamepadStick stick, int axis, bool inverted);
    /// The same for a button.
    void assign(GamepadButton button, int index);

    /// For the settings.
    [[nodiscard]] QByteArray toJson() const;
    /// What is missing or makes no sense has its default.
    [[nodiscard]] static GamepadMapping fromJson(const QByteArray &json);
    friend bool operator==(const GamepadMapping &, const GamepadMapping &) = default;
};

/// The sticks and buttons after mapping, at the time of the device's last poll.
struct GamepadSnapshot
{
    /// A thread that polls and is silent for this long counts as lost.
    static constexpr auto kDeadMan = 250ms;

    TimePoint at{};  ///< of the last poll
    bool connected = false;
    quint64 session
        = 0;  ///< counts pads that came; another number is another pad, or the same plugged in anew
    QString name;
    bool isSetUp = false;  ///< its sticks have been assigned
    bool isStandard = false;  ///< as they are by default
    /// -1 to 1. Without an axis: throttle and speed -1, everything else 0.
    std::array<double, kGamepadSticks> sticks{-1, 0, 0, 0, -1};
    std::array<bool, kGamepadSticks> assigned{};
    std::array<bool, kGamepadButtons> held{};
    /// Counts presses of each button, so that a short one is not missed.
    std::array<quint32, kGamepadButtons> presses{};

    [[nodiscard]] double operator[](GamepadStick stick) const { return sticks[std::size_t(stick)]; }
    [[nodiscard]] bool has(GamepadStick stick) const { return assigned[std::size_t(stick)]; }
    [[nodiscard]] bool isHeld(GamepadButton button) const { return held[std::size_t(button)]; }
    [[nodiscard]] quint32 pressesOf(GamepadButton button) const { return presses[std::size_t(button)]; }
    /// The pad is there and was read a moment ago: what stands here may be sent.
    [[nodiscard]] bool isAlive(TimePoint now) const { return connected && now - at <= kDeadMan; }
};

/// Applies the mapping to a reading; leaves the time, the session and the presses alone.
void applyMapping(const GamepadMapping &mapping, const GamepadReading &reading, GamepadSnapshot &snapshot);
