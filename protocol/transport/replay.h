// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

/// What is wrong where a recording cannot be read.
enum class GapCause {
    FirstLine,
    EndsWithin,  ///< the file ends in the middle of a chunk
    NoChunk,
    Checksum,
    Description,  ///< it is no JSON
    Pieces,  ///< a chunk of pieces holds something else
};

/// A part of a recording that cannot be read and is left out.
struct ReplayGap
{
    qint64 offset = 0;  ///< in the file
    qint64 bytes = 0;
    GapCause cause = GapCause::Checksum;
    double from = 0;  ///< seconds since the recording's first byte; NaN: nothing was received before
    double to = 0;  ///< NaN: nothing was received after

    friend bool operator==(const ReplayGap &, const ReplayGap &) = default;
};

/// Playback state of a recorded link.
struct ReplayState
{
    double position = 0;  ///< seconds since the recording's first byte
    double length = 0;  ///< seconds
    double speed = 1;  ///< multiple of real time
    bool paused = false;
    QList<ReplayGap> gaps = {};  ///< what the recording lacks

    [[nodiscard]] bool hasEnded() const { return position >= length; }
    friend bool operator==(const ReplayState &, const ReplayState &) = default;
};

/// What a recorded link can do and a live one cannot. Lives with its transport on the I/O thread.
class Replay
{
public:
    virtual ~Replay() = default;
    /// Starts delivering live data; a recorded link holds them back until a receiver is ready.
    virtual void play() = 0;
    virtual void setPaused(bool paused) = 0;
    /// @param speed multiple of real time, 0.05 to 100
    virtual void setSpeed(double speed) = 0;
    /// Moves forward and delivers everything in between at once. Cannot move back: received data cannot be
    /// taken back.
    virtual void forwardTo(double seconds) = 0;
    [[nodiscard]] virtual ReplayState state() const = 0;
};
