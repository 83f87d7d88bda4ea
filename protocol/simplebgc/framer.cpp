// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/framer.h"

#include "protocol/base/checksum.h"

#include <algorithm>
#include <utility>

namespace simplebgc {

namespace {

constexpr std::byte kStart1{'>'};
constexpr std::byte kStart2{'$'};
constexpr std::size_t kHeader = 4;

}  // namespace

void Framer::feed(Bytes bytes, const FrameSink &sink)
{
    // First complete what was begun before: top up the buffer until it holds no unfinished frame from the old
    // bytes.
    while (m_kept > 0 && !bytes.empty()) {
        const std::size_t taken = std::min(bytes.size(), m_buffer.size() - m_kept);
        const std::size_t before = m_kept;
        std::copy_n(bytes.begin(), taken, m_buffer.begin() + static_cast<std::ptrdiff_t>(m_kept));
        const std::size_t used = scan(Bytes(m_buffer).first(m_kept + taken), false, sink);
        if (used >= before) {
            // All old bytes are consumed; continue in the caller's bytes, without copying.
            bytes = bytes.subspan(used - before);
            m_kept = 0;
            break;
        }
        m_kept = m_kept + taken - used;
        std::copy_n(m_buffer.begin() + static_cast<std::ptrdiff_t>(used), m_kept, m_buffer.begin());
        bytes = bytes.subspan(taken);
    }
    if (bytes.empty())
        return;
    const std::size_t used = scan(bytes, false, sink);
    const Bytes rest = bytes.subspan(used);
    std::copy(rest.begin(), rest.end(), m_buffer.begin());
    m_kept = rest.size();
}

void Framer::flush(const FrameSink &sink)
{
    const std::size_t kept = std::exchange(m_kept, 0);
    scan(Bytes(m_buffer).first(kept), true, sink);
}

// Delivers all complete frames; returns how many bytes were consumed. What remains is the beginning of a
// frame, shorter than the longest one. If last is set nothing remains: an incomplete frame counts as damaged.
std::size_t Framer::scan(Bytes bytes, bool last, const FrameSink &sink)
{
    std::size_t at = 0;
    const std::size_t size = bytes.size();
    while (at < size) {
        const std::byte start = bytes[at];
        if (start != kStart1 && start != kStart2) {
            ++at;
            ++m_statistics.skippedBytes;
            continue;
        }
        const bool crc = start == kStart2;
        if (size - at < kHeader) {
            if (!last)
                return at;
            ++m_statistics.headerErrors;
            ++m_statistics.skippedBytes;
            ++at;
            continue;
        }
        const auto id = std::to_integer<unsigned>(bytes[at + 1]);
        const auto length = std::to_integer<unsigned>(bytes[at + 2]);
        if (id == 0 || ((id + length) & 0xFF) != std::to_integer<unsigned>(bytes[at + 3])) {
            ++m_statistics.headerErrors;
            ++m_statistics.skippedBytes;
            ++at;
            continue;
        }
        const std::size_t total = kHeader + length + (crc ? 2 : 1);
        bool intact = false;
        if (size - at >= total) {
            const Bytes payload = bytes.subspan(at + kHeader, length);
            const auto trailer = std::to_integer<unsigned>(bytes[at + kHeader + length]);
            intact = crc ? crc16ArcReversed(bytes.subspan(at + 1, kHeader - 1 + length))
                    == (trailer | std::to_integer<unsigned>(bytes[at + total - 1]) << 8)
                         : sum8(payload) == trailer;
        } else if (!last) {
            return at;
        }
        if (!intact) {
            ++m_statistics.bodyErrors;
            ++m_statistics.skippedBytes;
            ++at;
            continue;
        }
        ++m_statistics.frames;
        sink({static_cast<int>(id), bytes.subspan(at + kHeader, length), crc ? 2 : 1,
              bytes.subspan(at, total)});
        at += total;
    }
    return at;
}

}  // namespace simplebgc
