// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

/// The program's only clock. Everything that keeps time takes a TimePoint, so tests run in virtual time.
using Clock = std::chrono::steady_clock;
using TimePoint = Clock::time_point;
using Duration = Clock::duration;
using std::chrono::microseconds;
using std::chrono::milliseconds;
using namespace std::chrono_literals;

/// Seconds as a floating point number, for physics and plots.
inline double seconds(Duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

/// The reverse: a duration from a number of seconds.
inline Duration durationFromSeconds(double value)
{
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(value));
}
