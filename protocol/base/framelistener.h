// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"
#include "protocol/base/frame.h"

/// Receives every frame, on the I/O thread, with its time of arrival.
class FrameListener
{
public:
    virtual ~FrameListener() = default;
    /// @param claimed the frame answered a request (polled telemetry answers a request and is still
    /// telemetry)
    virtual void frameReceived(const FrameView &frame, TimePoint at, bool claimed) = 0;
    /// Bytes as they came from the port, before they are split into frames.
    virtual void bytesReceived(QByteArrayView, TimePoint) { }
    /// Complete frames that were sent to the board.
    virtual void bytesSent(QByteArrayView, TimePoint) { }
};
