// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/configuration/memoryimage.h"
#include "protocol/simplebgc/frametext.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <array>
#include <tuple>

// Commands with any payload against the simulated board; its answers through every decoder of ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    // An old, a middle and a new generation.
    SimulatorOptions options;
    if (size > 0)
        options.firmware = std::array{2590, 2439, 2704, 2738}[data[0] % 4];
    simplebgc::SimulatedBoard board(options);
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
        for (const bool fromBoard : {false, true})
            std::ignore = simplebgc::describeFrame(frame, fromBoard, nullptr);
        const simplebgc::MessageSpec *message = simplebgc::findMessage(frame.id);
        if (message && message->toBoard) {
            QStringList words;
            for (const simplebgc::FieldValue &value :
                 simplebgc::decodeFields(*message->toBoard, frame.payload))
                words.append(value.name + u'=' + QString::number(value.number, 'g', 17));
            std::ignore = simplebgc::encodeFields(*message->toBoard, words, message->least);
        }
        std::ignore = MemoryImage::decode(toByteArray(frame.payload));
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
