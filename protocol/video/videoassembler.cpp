// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/video/videoassembler.h"

#include "protocol/video/videoinspector.h"

#include <utility>

bool beginsPicture(Bytes bytes)
{
    if (isJpeg(bytes))
        return true;
    const QList<NalUnit> units = nalUnits(bytes, 1);
    if (units.isEmpty() || units.first().start != 0)
        return false;
    const Bytes unit = units.first().bytes;
    switch (units.first().type()) {
    case NalUnit::Slice:
    case NalUnit::KeySlice: return unit.size() > 1 && (std::to_integer<int>(unit[1]) & 0x80);  // its first
    case NalUnit::Sei:
    case NalUnit::Sps:
    case NalUnit::Pps:
    case NalUnit::Delimiter: return true;
    default: return false;
    }
}

void VideoAssembler::take(Bytes datagram, TimePoint at, const Sink &frame, Duration waited)
{
    const bool hasOpen = !m_open.bytes.isEmpty() || m_isTooLong;
    if (hasOpen && beginsPicture(datagram)) {
        if (!m_isTooLong)
            frame(std::exchange(m_open, {}));
        reset();
    }
    const bool goesOn = datagram.size() == kPiece;
    if (m_open.bytes.isEmpty()) {
        m_open.at = at;
        m_open.waited = waited;
    }
    if (m_isTooLong || m_open.bytes.size() + qsizetype(datagram.size()) > kLargest) {
        reset();
        m_isTooLong = goesOn;
        return;
    }
    m_open.bytes.append(reinterpret_cast<const char *>(datagram.data()), qsizetype(datagram.size()));
    if (goesOn || m_open.bytes.isEmpty())
        return;
    frame(std::exchange(m_open, {}));
}

void VideoAssembler::reset()
{
    m_open = {};
    m_isTooLong = false;
}
