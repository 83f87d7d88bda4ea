// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/framer.h"
#include "protocol/bcflight/infotext.h"
#include "protocol/bcflight/luatext.h"
#include "protocol/bcflight/payloads.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

// Any bytes in packets of any size, and as texts: no byte is in two messages.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size < 2)
        return 0;
    const Bytes bytes(reinterpret_cast<const std::byte *>(data + 2), size - 2);
    const std::size_t chunk = 1 + data[0];
    const bool hasPackets = data[1] & 1;
    std::size_t inFrames = 0;
    const auto count = [&inFrames](const FrameView &frame) {
        inFrames += frame.raw.size();
        if (frame.payload.size() > frame.raw.size())
            std::abort();
        if (const auto *message = bcflight::findMessage(bcflight::Message(frame.id));
            message && message->fromDrone)
            std::ignore = bcflight::decodeFields(*message->fromDrone, frame.payload);
    };
    bcflight::Framer framer;
    for (std::size_t at = 0; at < bytes.size(); at += chunk) {
        framer.feed(bytes.subspan(at, std::min(chunk, bytes.size() - at)), count);
        if (hasPackets)
            framer.packetEnded(count);
    }
    framer.flush(count);
    if (inFrames > bytes.size() || framer.isWaiting())
        std::abort();
    const QByteArray text = toByteArray(bytes);
    int damaged = 0;
    std::ignore = bcflight::readInfo(text);
    std::ignore = bcflight::readRecordings(text, damaged);
    std::ignore = bcflight::decodeChecked(bytes);
    std::ignore = bcflight::findMotors(text);
    std::ignore = bcflight::findScales(text);
    if (const auto gains = bcflight::findGains(text, QStringLiteral("pid_roll"))) {
        const QByteArray changed = bcflight::replaced(text, (*gains)[1], 2.5);
        const auto again = bcflight::findGains(changed, QStringLiteral("pid_roll"));
        if (!again || (*again)[1].value != 2.5 || (*again)[2].value != (*gains)[2].value)
            std::abort();
    }
    return 0;
}
