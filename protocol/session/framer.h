// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/frame.h"

#include <chrono>
#include <functional>

using FrameSink = std::function<void(const FrameView &)>;

/// What a framer has seen since it was created. Never reset while a link is open.
struct FramerStatistics
{
    quint64 frames = 0;
    quint64 headerErrors = 0;
    quint64 bodyErrors = 0;
    quint64 skippedBytes = 0;  ///< bytes that belong to no intact frame

    friend bool operator==(const FramerStatistics &, const FramerStatistics &) = default;
};

/// Finds frames in bytes. No I/O, no clock; survives any input. One per wire format.
class Framer
{
public:
    virtual ~Framer() = default;

    /// Takes the next bytes and calls the sink once for each intact frame in them, in order.
    virtual void feed(Bytes bytes, const FrameSink &sink) = 0;
    /// The bytes fed last ended a packet (UDP). No frame spans two packets.
    virtual void packetEnded(const FrameSink &sink) { flush(sink); }
    /// Reports what was sent to the board, for wire formats whose answers can only be understood from the
    /// request.
    virtual void sent(Bytes) { }
    /// A gap in the stream: a partly received frame will not be completed. Frames hidden inside it are
    /// delivered.
    virtual void flush(const FrameSink &sink) = 0;
    /// How much silence counts as a gap (SimpleBGC errata 1.4: 100-500 ms).
    [[nodiscard]] virtual std::chrono::milliseconds gap() const { return std::chrono::milliseconds(150); }
    /// True while a frame is partly received, so that the session knows when a gap matters.
    [[nodiscard]] virtual bool isWaiting() const = 0;
    [[nodiscard]] virtual const FramerStatistics &statistics() const = 0;
};
