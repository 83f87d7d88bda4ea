// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Where a recorded link stands.
struct ReplayState
{
    double position = 0;  ///< seconds since the recording's first byte
    double length = 0;  ///< seconds
    double speed = 1;  ///< times real time
    bool paused = false;

    [[nodiscard]] bool hasEnded() const { return position >= length; }
    friend bool operator==(const ReplayState &, const ReplayState &) = default;
};

/// What a recorded link can do and a living one cannot. Lives with its transport on the I/O thread.
class Replay
{
public:
    virtual ~Replay() = default;
    /// A recorded link waits with its live data until somebody can take them.
    virtual void play() = 0;
    virtual void setPaused(bool paused) = 0;
    /// @param speed times real time, 0.05 to 100
    virtual void setSpeed(double speed) = 0;
    /// A place before the present one cannot be gone to: what was received was received. What lies between is
    /// delivered at once.
    virtual void forwardTo(double seconds) = 0;
    [[nodiscard]] virtual ReplayState state() const = 0;
};
