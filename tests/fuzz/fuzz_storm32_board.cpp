// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/storm32/board.h"
#include "protocol/storm32/framer.h"

#include <algorithm>
#include <array>
#include <tuple>

using namespace storm32;

// Commands of all three sets with any payload, and bytes that are none, against the simulated board; its
// answers through our framer.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size < 1)
        return 0;
    constexpr std::array<int, 3> kFirmwares{79, 90, 96};
    SimulatorOptions options;
    options.firmware = kFirmwares[data[0] % kFirmwares.size()];
    options.usb = data[0] & 0x80;
    storm32::SimulatedBoard board(options);
    storm32::Framer framer;
    const auto look = [](const FrameView &frame) {
        if (const mavlink::Message *message = mavlink::findMessage(frame.id - FrameId::kMavlink))
            std::ignore = mavlink::decodeFields(*message, frame.payload);
    };
    ++data;
    --size;
    while (size >= 3) {
        const std::size_t length = std::min<std::size_t>(data[2], size - 3);
        const QByteArray payload(reinterpret_cast<const char *>(data + 3), qsizetype(length));
        QByteArray sent = payload;
        switch (data[0] % 4) {
        case 0: sent = encodeSimple(static_cast<Simple>(data[1] % unsigned(Simple::Count)), payload); break;
        case 1: sent = encodeRc(data[1], payload); break;
        case 2:
            if (mavlink::findMessage(data[1]))
                sent = mavlink::encode(static_cast<mavlink::MessageId>(data[1]), payload, {82, 67}, 0);
            break;
        default: break;
        }
        data += 3 + length;
        size -= 3 + length;
        framer.sent(asBytes(sent));
        board.receive(asBytes(sent));
        for (int i = 0; i < 150; ++i)
            board.cycle();
        framer.feed(asBytes(board.takeOutput(4096)), look);
    }
    return 0;
}
