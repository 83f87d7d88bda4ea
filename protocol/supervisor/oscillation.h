// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>

/// Finds a narrow-band oscillation in the angular rate of one axis, from samples at any rate and with any
/// jitter. Has no clock: time is that of the samples.
class OscillationDetector
{
public:
    struct Finding
    {
        double rms = 0;  ///< deg/s, of the narrow band
        double hertz = 0;
        bool isHertzVague = false;  ///< the samples are too far apart to exclude a higher frequency
    };

    /// @param rate deg/s
    void add(double time, double rate);
    void clear();
    /// What it does now: an oscillation that goes on with at least this RMS, or nothing. One that dies away,
    /// like the answer to a step, is none.
    /// @param lowest frequency that counts, in Hz; 0: the lowest that can be told, some 2.5 Hz
    [[nodiscard]] std::optional<Finding> look(double minRms, double lowest = 0) const;
    /// RMS of all that is faster than a hand or a steered motion, over the last window, in deg/s.
    [[nodiscard]] double roughness() const;

private:
    struct Point
    {
        double time = 0;
        double rate = 0;
    };
    struct Window;
    [[nodiscard]] Window window(double length) const;
    [[nodiscard]] static std::optional<Finding> lookAt(const Window &window, double lowest, double minRms);

    std::deque<Point> m_points;
    // Samples that come faster than needed are averaged.
    double m_sumTime = 0;
    double m_sumRate = 0;
    int m_sumCount = 0;
    double m_sumFrom = 0;
};
