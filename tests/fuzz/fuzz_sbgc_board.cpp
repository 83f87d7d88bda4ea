// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <tuple>

// Commands with any payload against the simulated board; its answers through every decoder of ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    SbgcBoard board(SimulatorOptions{});
    sbgc::SbgcFramer framer;
    const auto decode = [](const FrameView &frame) {
        std::ignore = sbgc::BoardInfo::decode(frame.payload);
        std::ignore = sbgc::decodeAngles(frame.payload);
        std::ignore = sbgc::decodeAdjVars(frame.payload);
        std::ignore = sbgc::AutoPidProgress::decode(frame.payload);
        std::ignore = sbgc::DataStream::decode(frame.payload);
        if (const auto vars = sbgc::decodeDebugVarsInfo(frame.payload))
            std::ignore = sbgc::decodeDebugVars(vars->vars, frame.payload);
        for (const sbgc::WireField &field : sbgc::realtimeFields())
            std::ignore = sbgc::readField(field, frame.payload);
    };
    while (size >= 2) {
        const int id = std::max<int>(1, data[0]);
        const std::size_t length = std::min<std::size_t>(data[1], size - 2);
        const QByteArray payload(reinterpret_cast<const char *>(data + 2), qsizetype(length));
        decode({id, asBytes(payload), 1});
        board.receive(asBytes(sbgc::encodeFrame(id, payload)));
        data += 2 + length;
        size -= 2 + length;
        for (int i = 0; i < 60; ++i)
            board.cycle();
        framer.feed(asBytes(board.takeOutput(4096)), decode);
    }
    return 0;
}
