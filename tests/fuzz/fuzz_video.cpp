// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/video/videoassembler.h"
#include "protocol/video/videoinspector.h"

#include <algorithm>
#include <cstdlib>

// Any datagrams: no byte comes twice, sizes stay within what was received, and what frames say of themselves
// is possible.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    VideoAssembler assembler;
    VideoInspector inspector;
    std::size_t sent = 0;
    std::size_t received = 0;
    const auto take = [&](const EncodedFrame &frame) {
        received += std::size_t(frame.bytes.size());
        if (frame.bytes.isEmpty() || frame.bytes.size() > VideoAssembler::kLargest)
            std::abort();
        const FrameFacts facts = inspector.inspect(asBytes(frame.bytes));
        if (facts.lost < 0 || inspector.size().width() < -1 || inspector.size().width() > 65535)
            std::abort();
        for (const NalUnit &unit : nalUnits(asBytes(frame.bytes))) {
            if (unit.bytes.empty() || unit.start >= std::size_t(frame.bytes.size()))
                std::abort();
        }
    };
    // The first byte of each datagram is its length; 255 stands for a full one, filled up.
    while (size > 1) {
        const std::size_t length = std::min<std::size_t>(data[0], size - 1);
        QByteArray datagram(reinterpret_cast<const char *>(data + 1), qsizetype(length));
        if (data[0] == 255)
            datagram.append(qsizetype(VideoAssembler::kPiece) - datagram.size(), char(1));
        sent += std::size_t(datagram.size());
        assembler.take(asBytes(datagram), TimePoint(), take);
        data += 1 + length;
        size -= 1 + length;
    }
    if (received > sent)
        std::abort();
    return 0;
}
