// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>

/// Finds swings of one axis that are too slow for a spectrum of what was just seen: half periods follow one
/// another, alike in length and not dying away. Time is that of the samples.
class SlowSwing
{
public:
    struct Finding
    {
        double rms = 0;  ///< deg/s
        double hertz = 0;
        bool isGrowing = false;  ///< it is still small, but each swing is wider than the one before
    };

    /// @param rate deg/s
    void add(double time, double rate);
    void clear();
    /// @param minRms from which a swing counts; one that grows counts from half of it
    [[nodiscard]] std::optional<Finding> look(double minRms) const;
    /// RMS of the latest so many seconds, without their mean, in deg/s.
    [[nodiscard]] double recent(double seconds) const;

private:
    struct Point
    {
        double time = 0;
        double rate = 0;
    };
    struct Half
    {
        double length = 0;  // seconds
        double peak = 0;  // deg/s
    };
    std::deque<Point> m_points;
    double m_sum = 0;
    int m_count = 0;
    double m_from = 0;
};
