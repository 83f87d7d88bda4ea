// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QList>
#include <QString>

#include <optional>

namespace bcflight {

/// Something that a drone tells about itself, with what belongs to it.
struct InfoNode
{
    QString name;
    QString value;  ///< empty for what only has children
    QList<InfoNode> children = {};

    friend bool operator==(const InfoNode &, const InfoNode &) = default;
};

/// Reads what a drone says of its board, sensors or cameras (errata 7.5): a Lua table constructor, with or
/// without a name and "=" before it, or lines "Key:value", or "nil". It is read, never run; quotes inside of
/// values are not escaped there. Empty: it is neither, and is to be shown as it came.
[[nodiscard]] std::optional<QList<InfoNode>> readInfo(const QByteArray &text);

/// A recording on the drone (errata 7.6).
struct RecordingEntry
{
    QString name;
    qint64 bytes = 0;
    QString picture;  ///< base64; empty today

    friend bool operator==(const RecordingEntry &, const RecordingEntry &) = default;
};

/// The list of recordings: names with a dot in front are left out. An empty list is the single character ";".
/// @param damaged how many entries could not be read
[[nodiscard]] QList<RecordingEntry> readRecordings(const QByteArray &text, int &damaged);

}  // namespace bcflight
