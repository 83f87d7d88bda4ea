// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/client/framelog.h"

#include <algorithm>

void FrameLog::frameReceived(const FrameView &frame, TimePoint at, bool claimed)
{
    append({0, at, true, claimed, frame.id, frame.version, toByteArray(frame.payload)});
}

void FrameLog::bytesSent(QByteArrayView bytes, TimePoint at)
{
    append({0, at, false, false, 0, 1, bytes.toByteArray()});
}

void FrameLog::append(LoggedFrame frame)
{
    const std::lock_guard lock(m_mutex);
    frame.number = ++m_newest;
    m_frames.push_back(std::move(frame));
    if (m_frames.size() > m_capacity)
        m_frames.pop_front();
}

std::vector<LoggedFrame> FrameLog::after(quint64 number) const
{
    const std::lock_guard lock(m_mutex);
    const auto fresh = std::min<quint64>(m_newest - std::min(number, m_newest), m_frames.size());
    return {m_frames.end() - std::ptrdiff_t(fresh), m_frames.end()};
}

quint64 FrameLog::newest() const
{
    const std::lock_guard lock(m_mutex);
    return m_newest;
}
