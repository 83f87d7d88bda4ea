// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/framelistener.h"

#include <deque>
#include <mutex>
#include <vector>

/// One frame that was sent or received.
struct LoggedFrame
{
    quint64 number = 0;  ///< counts up from 1
    TimePoint at{};
    bool fromBoard = false;
    bool claimed = false;  ///< answered a request
    int id = 0;  ///< of a received frame
    int version = 1;
    QByteArray bytes;  ///< payload of a received frame; the whole of a sent one
};

/// The most recent frames of a link, for the console. Written on the I/O thread, readable from any.
class FrameLog final : public FrameListener
{
public:
    explicit FrameLog(std::size_t capacity = 4096)
        : m_capacity(capacity)
    {
    }

    void frameReceived(const FrameView &frame, TimePoint at, bool claimed) override;
    void bytesSent(QByteArrayView bytes, TimePoint at) override;

    /// Frames after this number that are still kept, oldest first.
    [[nodiscard]] std::vector<LoggedFrame> after(quint64 number) const;
    /// Number of the newest frame, 0 before the first.
    [[nodiscard]] quint64 newest() const;

private:
    void append(LoggedFrame frame);

    std::size_t m_capacity;
    mutable std::mutex m_mutex;
    std::deque<LoggedFrame> m_frames;
    quint64 m_newest = 0;
};
