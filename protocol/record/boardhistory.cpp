// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/boardhistory.h"

#include "protocol/base/filefault.h"
#include "protocol/base/jsonplace.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QStandardPaths>

#include <algorithm>
#include <functional>

using namespace Qt::StringLiterals;

namespace {

const QString kStamp = u"yyyyMMdd-HHmmss-zzz"_s;
const QString kUnsavedFolder = u"unsaved"_s;
const QString kEditsFile = u"edits.json"_s;
const QString kBaseFile = u"board.json"_s;
const QString kSetAside = u"unsaved-damaged"_s;
constexpr qint64 kLargestJournal = 4'194'304;

// The same fault, with what it means: no safety copy.
Error noBackup(Error error)
{
    error.code = ErrorCode::NoBackup;
    return error;
}

}  // namespace

BoardHistory::BoardHistory(QString root)
    : m_root(std::move(root))
{
}

QString BoardHistory::defaultRoot()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + u"/gimbaldesk/history"_s;
}

Result<QString> BoardHistory::save(const Configuration &configuration, const QString &reason) const
{
    const QString folderPath = folder(configuration.identity().serial);
    if (!QDir().mkpath(folderPath))
        return tl::unexpected(noBackup(FileFault{.problem = FileProblem::NotWritable,
                                                 .kind = FileKind::Configuration,
                                                 .path = folderPath,
                                                 .writing = true}
                                           .error()));
    const QString stamp = QDateTime::currentDateTimeUtc().toString(kStamp);
    const QString path = u"%1/%2.json"_s.arg(folderPath, stamp);
    if (const auto saved = ConfigurationFile::save(path, configuration, reason); !saved)
        return tl::unexpected(noBackup(saved.error()));
    // A backup counts only once it was read back with the same bytes.
    const auto again = ConfigurationFile::load(
        path, [&configuration](const BoardIdentity &) { return configuration.parameterSet(); });
    if (!again)
        return tl::unexpected(noBackup(again.error()));
    if (again->configuration.blocks() != configuration.blocks())
        return failure(ErrorCode::NoBackup, u"%1 does not hold what was saved"_s.arg(path));
    return path;
}

QStringList BoardHistory::snapshots(const QString &serial) const
{
    const QDir dir(folder(serial));
    QStringList paths;
    for (const QString &name : dir.entryList({u"*.json"_s}, QDir::Files, QDir::Name | QDir::Reversed))
        paths.append(dir.filePath(name));
    return paths;
}

QDateTime BoardHistory::timeOf(const QString &path)
{
    QDateTime time = QDateTime::fromString(QFileInfo(path).completeBaseName(), kStamp);
    time.setTimeSpec(Qt::UTC);
    return time;
}

QString BoardHistory::setupFile(const QString &serial) const
{
    return folder(serial) + u"/setup.json"_s;
}

QString BoardHistory::trialFile(const QString &serial) const
{
    return folder(serial) + u"/trial.json"_s;
}

Result<void> BoardHistory::saveUnsaved(const Configuration &base, const QJsonObject &edits) const
{
    const QDir dir(folder(base.identity().serial) + u'/' + kUnsavedFolder);
    if (!QDir().mkpath(dir.path()))
        return fileFailure({.problem = FileProblem::NotWritable,
                            .kind = FileKind::Journal,
                            .path = dir.path(),
                            .writing = true});
    // The base first: edits are useless without the configuration they started from.
    const QByteArray board = ConfigurationFile::toJson(base, u"unwritten edits"_s, {});
    QFile known(dir.filePath(kBaseFile));
    if (!known.open(QIODevice::ReadOnly) || known.readAll() != board) {
        known.close();
        if (const auto saved = writeWhole(dir.filePath(kBaseFile), board, FileKind::Journal); !saved)
            return saved;
    }
    return writeWhole(dir.filePath(kEditsFile), QJsonDocument(edits).toJson(QJsonDocument::Compact),
                      FileKind::Journal);
}

void BoardHistory::dropUnsaved(const QString &serial) const
{
    QDir(folder(serial) + u'/' + kUnsavedFolder).removeRecursively();
}

Result<QJsonObject> BoardHistory::unsaved(const QString &serial) const
{
    const auto edits = readJson(folder(serial) + u'/' + kUnsavedFolder + u'/' + kEditsFile, FileKind::Journal,
                                kLargestJournal);
    if (!edits)
        return tl::unexpected(edits.error());
    return edits->object();
}

QString BoardHistory::setAsideUnsaved(const QString &serial) const
{
    const QDir board(folder(serial));
    QDir(board.filePath(kSetAside)).removeRecursively();
    QDir().rename(board.filePath(kUnsavedFolder), board.filePath(kSetAside));
    return board.filePath(kSetAside);
}

QStringList BoardHistory::unsavedBases() const
{
    QList<std::pair<QDateTime, QString>> found;
    const QDir root(m_root);
    for (const QString &board : root.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        const QDir dir(root.filePath(board) + u'/' + kUnsavedFolder);
        if (dir.exists(kEditsFile) && dir.exists(kBaseFile))
            found.append({QFileInfo(dir.filePath(kEditsFile)).lastModified(), dir.filePath(kBaseFile)});
    }
    std::sort(found.begin(), found.end(), std::greater<>());
    QStringList paths;
    for (const auto &[time, path] : found)
        paths.append(path);
    return paths;
}
