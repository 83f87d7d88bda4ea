// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/framer.h"

#include <algorithm>
#include <cstdlib>

// Any bytes in any chunks: the same frames come out as from one piece, and every byte is accounted for.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const Bytes bytes(reinterpret_cast<const std::byte *>(data), size);
    std::size_t inFrames = 0;
    const auto count = [&inFrames](const FrameView &frame) {
        inFrames += frame.payload.size() + (frame.version == 2 ? 6 : 5);
    };
    simplebgc::Framer whole;
    whole.feed(bytes, count);
    whole.flush(count);
    if (inFrames + whole.statistics().skippedBytes != size)
        std::abort();
    simplebgc::Framer pieces;
    const std::size_t chunk = size ? 1 + data[0] % 64 : 1;
    const auto ignore = [](const FrameView &) {};
    for (std::size_t at = 0; at < size; at += chunk)
        pieces.feed(bytes.subspan(at, std::min(chunk, size - at)), ignore);
    pieces.flush(ignore);
    if (!(pieces.statistics() == whole.statistics()))
        std::abort();
    return 0;
}
