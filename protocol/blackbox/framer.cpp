// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/blackbox/framer.h"

namespace blackbox {

namespace {

constexpr qsizetype kLongest = 65536;  // the names in one line

}  // namespace

void Framer::feed(Bytes bytes, const FrameSink &sink)
{
    for (const std::byte byte : bytes) {
        if (byte != std::byte('\n')) {
            m_isTooLong |= m_line.size() >= kLongest;
            if (m_isTooLong)
                ++m_statistics.skippedBytes;
            else
                m_line.append(char(byte));
            continue;
        }
        if (!m_isTooLong && !m_line.isEmpty()) {
            ++m_statistics.frames;
            const Bytes line = asBytes(m_line);
            sink({m_line.startsWith('#') ? int(NamesFrame) : int(RowFrame), line, 1, line});
        }
        m_line.clear();
        m_isTooLong = false;
    }
}

void Framer::flush(const FrameSink &)
{
    m_statistics.skippedBytes += quint64(m_line.size());
    m_line.clear();
    m_isTooLong = false;
}

}  // namespace blackbox
