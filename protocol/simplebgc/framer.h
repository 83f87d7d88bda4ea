// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/framer.h"

#include <array>

namespace simplebgc {

/// Finds SimpleBGC frames of both versions (document "Message format", errata 1.1-1.4). After a bad header or
/// body it re-scans from the byte after the start byte, because 0x3E and 0x24 occur freely inside payloads.
/// Never allocates.
class Framer final : public ::Framer
{
public:
    void feed(Bytes bytes, const FrameSink &sink) override;
    void flush(const FrameSink &sink) override;
    [[nodiscard]] bool isWaiting() const override { return m_kept > 0; }
    [[nodiscard]] const FramerStatistics &statistics() const override { return m_statistics; }

private:
    static constexpr std::size_t kLongestFrame = 4 + 255 + 2;

    std::size_t scan(Bytes bytes, bool last, const FrameSink &sink);

    FramerStatistics m_statistics;
    std::array<std::byte, kLongestFrame * 4> m_buffer;  // the beginning of an incomplete frame
    std::size_t m_kept = 0;
};

}  // namespace simplebgc
