// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gamepad/gamepaddetector.h"

#include <algorithm>
#include <cmath>

void GamepadDetector::begin(const GamepadReading &reading, TimePoint now)
{
    m_rest = reading;
    m_restSince = now;
    m_ready = false;
}

std::optional<GamepadDetector::Found> GamepadDetector::look(const GamepadReading &reading, TimePoint now)
{
    if (reading.id != m_rest.id || reading.axes.size() != m_rest.axes.size()
        || reading.buttons.size() != m_rest.buttons.size()) {
        begin(reading, now);
        return {};
    }
    if (m_ready)
        return m_wanted == Wanted::Axis ? movedAxis(reading) : pressedButton(reading);
    bool isStill = reading.buttons == m_rest.buttons;
    for (std::size_t i = 0; i < reading.axes.size(); ++i)
        isStill &= isTaken(i) || std::abs(reading.axes[i] - m_rest.axes[i]) <= kStill;
    if (!isStill)
        begin(reading, now);
    m_ready = now - m_restSince >= kRest;
    return {};
}

bool GamepadDetector::isTaken(std::size_t axis) const
{
    return std::find(m_taken.begin(), m_taken.end(), int(axis)) != m_taken.end();
}

std::optional<GamepadDetector::Found> GamepadDetector::movedAxis(const GamepadReading &reading) const
{
    int farthest = -1;
    double way = 0;
    double next = 0;  // the way of the one that went second farthest
    for (std::size_t i = 0; i < reading.axes.size(); ++i) {
        if (isTaken(i))
            continue;
        const double moved = reading.axes[i] - m_rest.axes[i];
        if (std::abs(moved) > std::abs(way)) {
            next = std::abs(way);
            way = moved;
            farthest = int(i);
        } else {
            next = std::max(next, std::abs(moved));
        }
    }
    if (farthest < 0 || std::abs(way) < kFar || next > std::abs(way) / 2)
        return {};
    return Found{farthest, way < 0};
}

std::optional<GamepadDetector::Found> GamepadDetector::pressedButton(const GamepadReading &reading) const
{
    for (std::size_t i = 0; i < reading.buttons.size(); ++i) {
        if (reading.buttons[i] && !m_rest.buttons[i])
            return Found{int(i), false};
    }
    return {};
}
