// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"
#include "widgets/gamepad/gamepadsource.h"

#include <optional>

/// Finds out which axis or button the operator moves: first everything has to be at rest, then one axis has
/// to go most of its way, clearly farther than all others, or a button has to be pressed.
class GamepadDetector
{
public:
    static constexpr auto kRest = 300ms;  ///< for this long nothing moves before it counts
    static constexpr double kStill = 0.08;  ///< of an axis at rest
    static constexpr double kFar = 0.6;  ///< of an axis that is meant

    enum class Wanted { Axis, Button };
    struct Found
    {
        int index = -1;
        bool negative = false;  ///< an axis that went down
        friend bool operator==(const Found &, const Found &) = default;
    };

    /// @param taken axes that mean something else already: they may move back meanwhile
    explicit GamepadDetector(Wanted wanted, std::vector<int> taken = {})
        : m_wanted(wanted)
        , m_taken(std::move(taken))
    {
    }
    /// Looks at one reading more. Another pad begins anew.
    std::optional<Found> look(const GamepadReading &reading, TimePoint now);
    /// Everything was at rest, now the operator may move it.
    [[nodiscard]] bool isReady() const { return m_ready; }

private:
    void begin(const GamepadReading &reading, TimePoint now);
    [[nodiscard]] std::optional<Found> movedAxis(const GamepadReading &reading) const;
    [[nodiscard]] std::optional<Found> pressedButton(const GamepadReading &reading) const;

    [[nodiscard]] bool isTaken(std::size_t axis) const;

    Wanted m_wanted;
    std::vector<int> m_taken;
    GamepadReading m_rest;
    TimePoint m_restSince{};
    bool m_ready = false;
};
