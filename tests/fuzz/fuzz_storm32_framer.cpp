// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/device.h"
#include "protocol/storm32/framer.h"

#include <algorithm>
#include <cstdlib>

// Any bytes in any chunks, between any questions: every byte is accounted for, in a frame or as skipped.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size < 2)
        return 0;
    Bytes bytes(reinterpret_cast<const std::byte *>(data + 2), size - 2);
    const std::size_t chunk = 1 + data[0] % 97;
    const unsigned question = data[1];
    std::size_t inFrames = 0;
    static const storm32::Device device;
    const auto count = [&inFrames](const FrameView &frame) {
        inFrames += frame.raw.size();
        if (frame.payload.size() > frame.raw.size())
            std::abort();
        // Whoever gets a frame may look at it closely.
        if (const mavlink::Message *message = mavlink::findMessage(frame.id - storm32::FrameId::kMavlink))
            std::ignore = mavlink::decodeFields(*message, frame.payload);
        std::ignore = device.describeFrame(frame, true);
        std::ignore = device.describeFrame(frame, false);
    };
    storm32::Framer framer;
    std::size_t round = 0;
    for (std::size_t at = 0; at < bytes.size(); at += chunk, ++round) {
        if (round % 5 == 0) {
            const auto id
                = static_cast<storm32::Simple>((question + round) % unsigned(storm32::Simple::Count));
            framer.sent(asBytes(storm32::encodeSimple(id)));
        } else if (round % 7 == 3) {
            framer.sent(asBytes(storm32::encodeRc(int(question), {})));
        }
        framer.feed(bytes.subspan(at, std::min(chunk, bytes.size() - at)), count);
        if (round % 11 == 10)
            framer.flush(count);
    }
    framer.flush(count);
    // The same bytes as something that was sent, and as something that somebody types.
    const QByteArray whole = toByteArray(bytes);
    std::ignore = device.describeSent(whole);
    std::ignore = device.parseCommand(QString::fromLatin1(whole));
    if (framer.isWaiting() || inFrames + framer.statistics().skippedBytes != bytes.size())
        std::abort();
    return 0;
}
