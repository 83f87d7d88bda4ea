// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

#include <QByteArray>
#include <QMap>

#include <optional>
#include <vector>

/// A board's whole memory as a file: a line "GIMBALDESK-EEPROM 1", one of JSON (whose it is, its firmware,
/// the number of bytes, its files with their sizes, and the SHA-1 of all that follows), then the bytes, then
/// those of the files. Without files it is version 1, with them version 2.
struct MemoryImage
{
    static constexpr int kLargest = 4 * 1024 * 1024;  ///< bytes of a memory
    using Files = QMap<QString, QByteArray>;  ///< by the family's name of a file

    QString serial;
    QString model;
    QString firmware;
    QByteArray bytes;
    std::optional<Files> files = {};  ///< nothing: nobody asked for them, or the board keeps none

    [[nodiscard]] QByteArray encode() const;
    /// Errors: BadFile (another kind of file, cut off, damaged).
    [[nodiscard]] static Result<MemoryImage> decode(const QByteArray &file);
    /// Errors: BadFile, of decode() and of the system.
    [[nodiscard]] static Result<MemoryImage> load(const QString &path);
    /// Whether the file begins like one. What cannot be read is none.
    [[nodiscard]] static bool isAt(const QString &path);

    friend bool operator==(const MemoryImage &, const MemoryImage &) = default;
};

/// Bytes in which two memories differ; between them lie a few equal ones at most.
struct MemoryDifference
{
    qsizetype at = 0;
    QByteArray from;
    QByteArray to;

    /// How many of the bytes differ.
    [[nodiscard]] int changed() const;
    /// "0x1400-0x140f", "0x1400".
    [[nodiscard]] QString place() const;
    /// "01 02 -> 03 04"; of many bytes the first.
    [[nodiscard]] QString text() const;
};

/// In the order of their addresses. Both are of one size.
[[nodiscard]] std::vector<MemoryDifference> memoryDifferences(const QByteArray &from, const QByteArray &to);

/// Files that are not the same in both, by name, in words: "700 bytes -> none".
[[nodiscard]] QMap<QString, QString> fileDifferences(const MemoryImage::Files &from,
                                                     const MemoryImage::Files &to);
