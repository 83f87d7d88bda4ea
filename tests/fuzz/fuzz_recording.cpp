// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/record/replaystore.h"

// A recording from anywhere: read, then decoded as a recording of each family. With an intact checksum in
// front of it any content gets further, so each input is also tried as the pieces of a sound file.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), qsizetype(size));
    static const Family family = allFamilies().first();
    static const auto device = family.makeDevice();
    if (const auto recording = Recording::fromBytes(bytes))
        (void)decodeTelemetry(*recording, family, *device);
    Recording pieces;
    qint64 at = 0;
    for (const QByteArray &part : bytes.split('\n')) {
        if (!part.isEmpty())
            pieces.pieces.push_back(
                {RecordedPiece::Kind(1 + quint8(part[0]) % 3), at += 800'000, part.mid(1)});
    }
    (void)decodeTelemetry(pieces, family, *device);
    return 0;
}
