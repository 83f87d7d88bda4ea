// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// A black box as a recording.
#include "protocol/record/recording.h"
#include "protocol/telemetry/blackboxwire.h"

using namespace Qt::StringLiterals;

namespace {

constexpr qint64 kNanosecondsPerTick = 1000;

}  // namespace

Recording recordingOf(const BlackBox &box)
{
    Recording recording;
    recording.description = {{u"family"_s, QLatin1String(blackboxwire::kFamily)}};
    const qint64 begin = box.lines().front().at * kNanosecondsPerTick;
    recording.pieces.reserve(box.lines().size() + 2);
    recording.pieces.push_back({RecordedPiece::Kind::Sent, begin, QByteArray(blackboxwire::kQuestion)});
    recording.pieces.push_back({RecordedPiece::Kind::Reply, begin, blackboxwire::namesLine(box)});
    const std::size_t before = recording.pieces.size();
    for (const BlackBox::Line &line : box.lines()) {
        const QByteArray text = box.names()[line.name] + ',' + box.value(line).toByteArray() + '\n';
        recording.pieces.push_back({RecordedPiece::Kind::Received, line.at * kNanosecondsPerTick, text});
    }
    for (const BlackBox::Damage &damage : box.damage())
        recording.gaps.push_back({damage.offset, damage.bytes,
                                  damage.isEnd ? GapCause::EndsWithin : GapCause::Pieces,
                                  before + damage.line});
    return recording;
}
