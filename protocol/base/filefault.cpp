// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/filefault.h"

#include <QFileInfo>
#include <QSaveFile>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <initializer_list>

using namespace Qt::StringLiterals;

namespace {

// In the order of FileProblem.
constexpr std::array<const char *, 17> kProblemWords{
    "does not exist", "may not be read",   "may not be written",  "the disk is full",    "the system refuses",
    "is empty",       "is cut off",        "is of another kind",  "of another family",   "of a newer version",
    "out of range",   "is not understood", "an entry is missing", "an entry is doubled", "is damaged",
    "is too large",   "is the same file"};
static_assert(kProblemWords.size() == std::size_t(FileProblem::Same) + 1);

// Qt hands the system's words on, but tells a full disk from no other failure.
bool systemSaid(const QFileDevice &file, std::initializer_list<int> codes)
{
    return std::any_of(codes.begin(), codes.end(), [&file](int code) {
        return file.errorString() == QString::fromLocal8Bit(std::strerror(code));
    });
}

FileProblem problemOf(const QFileDevice &file, bool writing)
{
    const QFileInfo info(file.fileName());
    if (systemSaid(file, {ENOSPC, EDQUOT}))
        return FileProblem::DiskFull;
    if (file.error() == QFileDevice::PermissionsError || systemSaid(file, {EACCES, EPERM, EROFS})
        || (writing && info.exists() && !info.isWritable()))
        return writing ? FileProblem::NotWritable : FileProblem::NotReadable;
    const QFileInfo needed(writing ? info.absolutePath() : info.absoluteFilePath());
    return needed.exists() ? FileProblem::System : FileProblem::Missing;
}

}  // namespace

bool operator==(const Error &a, const Error &b)
{
    const bool sameFile = a.file && b.file ? *a.file == *b.file : !a.file == !b.file;
    return a.code == b.code && a.detail == b.detail && a.boardCode == b.boardCode && a.place == b.place
        && sameFile;
}

Error FileFault::error() const
{
    QStringList parts;
    if (!path.isEmpty())
        parts.append(path);
    if (line > 0)
        parts.append(u"line %1"_s.arg(line));
    QString about = key;
    if (!value.isEmpty())
        about += key.isEmpty() ? value : u" = "_s + value;
    if (!expected.isEmpty())
        about += (problem == FileProblem::Doubled ? u", also in line "_s : u", allowed "_s) + expected;
    if (about.isEmpty() || key.isEmpty())
        about = QLatin1String(kProblemWords.at(std::size_t(problem))) + (about.isEmpty() ? u""_s : u": "_s)
            + about;
    parts.append(about);
    if (!said.isEmpty())
        parts.append(said);
    return {ErrorCode::BadFile, parts.join(u": "_s), 0, std::make_shared<const FileFault>(*this)};
}

tl::unexpected<Error> fileFailure(const FileFault &fault)
{
    return tl::unexpected<Error>(fault.error());
}

Error systemError(const QIODevice &device, FileKind kind, bool writing)
{
    FileFault fault{
        .problem = FileProblem::System, .kind = kind, .writing = writing, .said = device.errorString()};
    if (const auto *file = qobject_cast<const QFileDevice *>(&device)) {
        fault.problem = problemOf(*file, writing);
        fault.path = file->fileName();
    }
    return fault.error();
}

Error inFile(Error error, const QString &path)
{
    if (!error.file || !error.file->path.isEmpty())
        return error;
    FileFault fault = *error.file;
    fault.path = path;
    Error placed = fault.error();
    placed.code = error.code;
    return placed;
}

Result<void> checkTarget(const QString &path, FileKind kind)
{
    const QFileInfo info(path);
    if (!info.exists() || info.isFile() || info.isDir())
        return {};
    return fileFailure({.problem = FileProblem::System,
                        .kind = kind,
                        .path = path,
                        .writing = true,
                        .said = u"it is a device or a pipe"_s});
}

Result<void> writeWhole(const QString &path, const QByteArray &bytes, FileKind kind)
{
    if (const auto checked = checkTarget(path, kind); !checked)
        return checked;
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit())
        return tl::unexpected(systemError(file, kind, true));
    return {};
}

Result<QByteArray> readWhole(const QString &path, FileKind kind, qint64 largest)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return tl::unexpected(systemError(file, kind, false));
    QByteArray bytes = file.read(largest + 1);
    if (file.error() != QFileDevice::NoError)
        return tl::unexpected(systemError(file, kind, false));
    if (bytes.size() > largest)
        return fileFailure({.problem = FileProblem::TooLarge,
                            .kind = kind,
                            .path = path,
                            .said = u"more than %1 bytes"_s.arg(largest)});
    return bytes;
}

Result<void> copyWhole(const QString &from, const QString &to, FileKind kind)
{
    const QFileInfo source(from);
    const QFileInfo target(to);
    if (target.exists() && source.canonicalFilePath() == target.canonicalFilePath())
        return fileFailure({.problem = FileProblem::Same, .kind = kind, .path = to, .writing = true});
    const auto bytes = readWhole(from, kind, source.size());
    if (!bytes)
        return tl::unexpected(bytes.error());
    return writeWhole(to, *bytes, kind);
}

int lineOfByte(QByteArrayView text, qsizetype offset)
{
    return 1 + int(text.first(std::clamp<qsizetype>(offset, 0, text.size())).toByteArray().count('\n'));
}
