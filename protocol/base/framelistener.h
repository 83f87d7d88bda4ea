// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"
#include "protocol/base/frame.h"

/// Gets every frame on the I/O thread with its time of arrival.
class FrameListener
{
public:
    virtual ~FrameListener() = default;
    /// @param claimed the frame was the answer to a request (polled telemetry is an answer and telemetry all
    /// the same)
    virtual void frameReceived(const FrameView &frame, TimePoint at, bool claimed) = 0;
    /// Bytes as they came from the port, before the frames in them are found.
    virtual void bytesReceived(QByteArrayView, TimePoint) { }
    /// Whole frames that left for the board.
    virtual void bytesSent(QByteArrayView, TimePoint) { }
};
