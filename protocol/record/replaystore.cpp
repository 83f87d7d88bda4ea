// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/replaystore.h"

#include "protocol/base/filefault.h"
#include "protocol/record/recordedboard.h"
#include "protocol/telemetry/streams.h"

#include <limits>

using namespace Qt::StringLiterals;

Result<std::shared_ptr<TelemetryStore>> readTelemetry(const Recording &recording, const Family &family,
                                                      Device &device)
{
    if (const auto identity = identifyRecorded(recording, family, device); !identity)
        return fileFailure({.problem = FileProblem::MissingEntry,
                            .kind = FileKind::Recording,
                            .key = u"firmware"_s,
                            .said = u"it does not tell which firmware these values come from (%1)"_s.arg(
                                identity.error().detail)});
    return decodeTelemetry(recording, family, device);
}

std::shared_ptr<TelemetryStore> decodeTelemetry(const Recording &recording, const Family &family,
                                                const Device &device)
{
    auto store = std::make_shared<TelemetryStore>(int(device.channels().size()));
    store->setRetention(std::numeric_limits<double>::infinity());
    const auto framer = family.makeFramer();
    const auto decoder = device.replayDecoder();
    const qint64 begin = recording.begin();
    TimePoint at = store->origin();
    const FrameSink sink = [&](const FrameView &frame) { decoder->decode(frame, at, *store); };
    for (std::size_t i = 0; i < recording.pieces.size(); ++i) {
        const RecordedPiece &piece = recording.pieces[i];
        if (recording.hasGapBefore(i)) {
            framer->flush(sink);
            store->interrupt();
        }
        at = store->origin() + std::chrono::nanoseconds(piece.at - begin);
        if (piece.kind == RecordedPiece::Kind::Sent) {
            framer->sent(asBytes(piece.bytes));
            decoder->sent(piece.bytes, *store);
        } else if (piece.kind == RecordedPiece::Kind::Received) {
            framer->feed(asBytes(piece.bytes), sink);
            if (recording.isPacketBased())
                framer->packetEnded(sink);
        }
    }
    return store;
}
