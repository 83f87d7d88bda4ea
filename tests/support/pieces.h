// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/record/recording.h"

#include <QFile>

/// Empty if it cannot be read.
inline QByteArray fileBytes(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Pieces of all kinds, a millisecond apart, of up to 49 bytes each.
inline std::vector<RecordedPiece> somePieces(int count)
{
    std::vector<RecordedPiece> pieces;
    for (int i = 0; i < count; ++i)
        pieces.push_back(
            {RecordedPiece::Kind(1 + i % 3), qint64(i) * 1'000'000, QByteArray(i % 50, char('a' + i % 26))});
    return pieces;
}
