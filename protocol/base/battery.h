// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

/// Below this it is no battery: the board is supplied by USB.
inline constexpr double kNoBatteryVolts = 5.0;
/// The most that a full cell of lithium polymer shows.
inline constexpr double kHighestCellVolts = 4.25;

/// Volts of a cell below which a battery is low, where nobody says otherwise.
inline constexpr double kLowCellVolts = 3.4;

/// The highest alarm that is meant for one cell: a cell that is two thirds full would set off a higher one.
inline constexpr double kHighestCellAlarm = 3.9;

/// Voltages below which a board does something, those that are set.
struct BatteryThresholds
{
    std::optional<double> alarm;  ///< volts: it warns
    std::optional<double> motorsOff;  ///< volts: it switches the motors off
    bool perCell = false;  ///< both are meant for one cell of the battery

    friend bool operator==(const BatteryThresholds &, const BatteryThresholds &) = default;
};

/// Cells of lithium polymer that such a voltage takes; 0: no battery's voltage.
[[nodiscard]] inline int batteryCells(double volts)
{
    return std::isnan(volts) || volts < kNoBatteryVolts ? 0 : int(std::ceil(volts / kHighestCellVolts));
}

/// Volts below which a battery of so many cells is low: by the board's setting or the program's, whichever
/// comes first. Empty if neither says so. @param cellVolts the program's, for one cell
[[nodiscard]] inline std::optional<double> lowBattery(int cells, double cellVolts,
                                                      const BatteryThresholds &board)
{
    std::optional<double> low;
    if (cells > 0 && cellVolts > 0)
        low = cells * cellVolts;
    if (board.alarm && (!board.perCell || cells > 0))
        low = std::max(low.value_or(0.0), board.perCell ? *board.alarm * cells : *board.alarm);
    return low;
}

/// The board takes the battery for low by an alarm that suits one with more cells: either the alarm is wrong,
/// or the battery has more cells than it seems to have. @param isReported the board says that it is low
[[nodiscard]] inline bool isAlarmOfOtherBattery(double volts, int cells, double cellVolts,
                                                const BatteryThresholds &board, bool isReported)
{
    if (cells == 0 || std::isnan(volts) || volts < cells * cellVolts)
        return false;
    const bool isTooHigh = board.alarm && !board.perCell && *board.alarm > cells * kHighestCellAlarm;
    return isTooHigh || (isReported && volts >= cells * kHighestCellAlarm);
}
