// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"

class QIODevice;

/// What a file was taken for.
enum class FileKind {
    Configuration,
    Recording,
    Settings,  ///< of the manufacturer's own program
    Calibration,
    Measurement,
    Script,
    Text,
    Firmware,
    Journal,  ///< unsaved edits of an earlier run
    BoardNames,
    Layout,  ///< of plots
    ProgramSettings,
    Other,  ///< only written
};

/// What is wrong with a file.
enum class FileProblem {
    Missing,
    NotReadable,  ///< no permission to read it
    NotWritable,  ///< no permission to write there
    DiskFull,
    System,  ///< another refusal of the system, whose words are the detail
    Empty,
    Truncated,
    OtherKind,  ///< not a file of the kind that was expected
    OtherFamily,  ///< of boards of another family; `value` is that family, `expected` the one that fits
    NewerVersion,  ///< `value` is its version of the format, `expected` the newest one that is known
    OutOfRange,  ///< `key` is `value`, `expected` says what is allowed
    BadValue,  ///< `key` is `value`, which is not understood; `expected` says what it would have to be
    MissingEntry,  ///< `key` does not occur
    Doubled,  ///< `key` occurs twice; `expected` is the line of the first
    Damaged,
    TooLarge,
    Same,  ///< it would be written over itself
};

/// What is wrong with which file, and where. The operator's words are made from it in
/// widgets/models/filefaulttext.cpp.
struct FileFault
{
    FileProblem problem = FileProblem::Damaged;
    FileKind kind = FileKind::Other;
    QString path = {};
    int line = 0;  ///< from 1; 0: of no line
    QString key = {};  ///< the entry
    QString value = {};
    QString expected = {};
    int profile = -1;  ///< from 0; -1: of no profile
    bool writing = false;  ///< it was to be written
    QString said = {};  ///< the words of the system or of a parser, for support

    friend bool operator==(const FileFault &, const FileFault &) = default;

    /// The fault as an error; the detail says all of it in a few words.
    [[nodiscard]] Error error() const;
};

/// Short form for returning a fault: `return fileFailure({FileProblem::Empty, FileKind::Recording});`
[[nodiscard]] tl::unexpected<Error> fileFailure(const FileFault &fault);

/// The error of a file that could not be opened, read or written, from what the system said of it. Another
/// device has no path.
[[nodiscard]] Error systemError(const QIODevice &device, FileKind kind, bool writing);

/// The same error, of the file at this path: readers of bytes do not know where they came from.
[[nodiscard]] Error inFile(Error error, const QString &path);

/// Writing a whole file would replace a device or a pipe by a file. Errors: BadFile, of those.
[[nodiscard]] Result<void> checkTarget(const QString &path, FileKind kind);

/// Writes all of it or nothing. Errors: BadFile.
[[nodiscard]] Result<void> writeWhole(const QString &path, const QByteArray &bytes,
                                      FileKind kind = FileKind::Other);

/// Reads a file of at most so many bytes. Errors: BadFile.
[[nodiscard]] Result<QByteArray> readWhole(const QString &path, FileKind kind, qint64 largest);

/// Copies a file. What is there under the other name stays until the copy is complete. Errors: BadFile (also
/// if both are the same file).
[[nodiscard]] Result<void> copyWhole(const QString &from, const QString &to, FileKind kind);

/// Number of the line, from 1, in which this byte of a text stands.
[[nodiscard]] int lineOfByte(QByteArrayView text, qsizetype offset);
