// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <tuple>

// Commands with any payload against the simulated board; its answers through every decoder of ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    simplebgc::SimulatedBoard board(SimulatorOptions{});
    simplebgc::Framer framer;
    const auto decode = [](const FrameView &frame) {
        std::ignore = simplebgc::BoardInfo::decode(frame.payload);
        std::ignore = simplebgc::decodeAngles(frame.payload);
        std::ignore = simplebgc::decodeAdjVars(frame.payload);
        std::ignore = simplebgc::AutoPidProgress::decode(frame.payload);
        std::ignore = simplebgc::DataStream::decode(frame.payload);
        if (const auto vars = simplebgc::decodeDebugVarsInfo(frame.payload))
            std::ignore = simplebgc::decodeDebugVars(vars->vars, frame.payload);
        for (const simplebgc::WireField &field : simplebgc::realtimeFields())
            std::ignore = simplebgc::readField(field, frame.payload);
    };
    while (size >= 2) {
        const int id = std::max<int>(1, data[0]);
        const std::size_t length = std::min<std::size_t>(data[1], size - 2);
        const QByteArray payload(reinterpret_cast<const char *>(data + 2), qsizetype(length));
        decode({id, asBytes(payload), 1});
        board.receive(asBytes(simplebgc::encodeFrame(id, payload)));
        data += 2 + length;
        size -= 2 + length;
        for (int i = 0; i < 60; ++i)
            board.cycle();
        framer.feed(asBytes(board.takeOutput(4096)), decode);
    }
    return 0;
}
