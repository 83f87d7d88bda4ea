// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/bytes.h"

#include <chrono>
#include <functional>

/// One intact frame as it lies in the framer's buffer. Valid during the call that hands it out.
struct FrameView
{
    int id = 0;  ///< the family's own command or message number
    Bytes payload;
    int version = 1;  ///< frame format, where a family has more than one
    Bytes raw
        = {};  ///< all of the frame, from its first byte to its checksum; empty where it was not on a wire
};

/// A frame that is kept.
struct Frame
{
    int id = 0;
    QByteArray payload;
    int version = 1;

    Frame() = default;
    Frame(int frameId, QByteArray data, int frameVersion = 1)
        : id(frameId)
        , payload(std::move(data))
        , version(frameVersion)
    {
    }
    explicit Frame(const FrameView &view)
        : id(view.id)
        , payload(toByteArray(view.payload))
        , version(view.version)
    {
    }

    friend bool operator==(const Frame &, const Frame &) = default;
};

using FrameSink = std::function<void(const FrameView &)>;

/// What a framer has seen since it was made. Never reset while a link is open.
struct FramerStatistics
{
    quint64 frames = 0;
    quint64 headerErrors = 0;
    quint64 bodyErrors = 0;
    quint64 skippedBytes = 0;  ///< bytes that belonged to no intact frame

    friend bool operator==(const FramerStatistics &, const FramerStatistics &) = default;
};

/// Finds frames in bytes. No I/O, no clock; survives any input. One per wire format.
class Framer
{
public:
    virtual ~Framer() = default;

    /// Takes the next bytes and calls the sink once for each intact frame in them, in order.
    virtual void feed(Bytes bytes, const FrameSink &sink) = 0;
    /// Tells what left for the board, for wire formats whose answers are understood only by what was asked.
    virtual void sent(Bytes) { }
    /// A gap in the stream: whatever is half received will not be completed. Frames hidden inside it are
    /// delivered.
    virtual void flush(const FrameSink &sink) = 0;
    /// So much silence is a gap (SimpleBGC errata 1.4: 100-500 ms).
    [[nodiscard]] virtual std::chrono::milliseconds gap() const { return std::chrono::milliseconds(150); }
    /// True while a frame is half received, so that the session knows when a gap matters.
    [[nodiscard]] virtual bool isWaiting() const = 0;
    [[nodiscard]] virtual const FramerStatistics &statistics() const = 0;
};
