// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/family.h"
#include "protocol/record/recording.h"

#include <QHash>
#include <QSet>

/// What a recorded board answered, by the bytes that it was asked with. Keeps a reference to the recording.
/// Where it answered in packets, they are whole: what came along with the answer is part of it.
class RecordedAnswers
{
public:
    explicit RecordedAnswers(const Recording &recording);

    /// The answer to the last such request before this time of the recording (nanoseconds), else to the first
    /// one after it. Where damage swallowed them all, the one that the description repeats. Empty: none.
    [[nodiscard]] QList<QByteArray> find(const QByteArray &request, qint64 at) const;

private:
    [[nodiscard]] QList<QByteArray> answerBehind(const std::vector<RecordedPiece> &pieces,
                                                 std::size_t request) const;

    const Recording &m_recording;
    QHash<QByteArray, std::vector<std::size_t>> m_requests;  // what was sent -> pieces, in order of time
    QSet<QByteArray> m_asked;  // by the opening
};

/// Identifies a recorded board: the device asks, the recording answers. What a board sends is scaled by its
/// firmware, so nothing may be decoded before. Errors: Timeout if the recording does not hold the answer.
Result<BoardIdentity> identifyRecorded(const Recording &recording, const Family &family, Device &device);
