// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/boardhistory.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QSaveFile>
#include <QStandardPaths>

#include <algorithm>
#include <functional>

using namespace Qt::StringLiterals;

namespace {

const QString kStamp = u"yyyyMMdd-HHmmss-zzz"_s;
const QString kUnsavedFolder = u"unsaved"_s;
const QString kEditsFile = u"edits.json"_s;
const QString kBaseFile = u"board.json"_s;
constexpr qint64 kLargestJournal = 4'194'304;

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
        return failure(ErrorCode::NoBackup, folderPath);
    const QString stamp = QDateTime::currentDateTimeUtc().toString(kStamp);
    const QString path = u"%1/%2.json"_s.arg(folderPath, stamp);
    if (const auto saved = ConfigurationFile::save(path, configuration, reason); !saved)
        return failure(ErrorCode::NoBackup, saved.error().detail);
    // A backup counts only once it was read back with the same bytes.
    const auto again = ConfigurationFile::load(
        path, [&configuration](const BoardIdentity &) { return configuration.parameterSet(); });
    if (!again)
        return failure(ErrorCode::NoBackup, again.error().detail);
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

Result<void> BoardHistory::saveUnsaved(const Configuration &base, const QJsonObject &edits) const
{
    const QDir dir(folder(base.identity().serial) + u'/' + kUnsavedFolder);
    if (!QDir().mkpath(dir.path()))
        return failure(ErrorCode::BadFile, dir.path());
    // The base first: edits are useless without the configuration they started from.
    const QByteArray board = ConfigurationFile::toJson(base, u"unsaved edits"_s, {});
    QFile known(dir.filePath(kBaseFile));
    if (!known.open(QIODevice::ReadOnly) || known.readAll() != board) {
        known.close();
        QSaveFile file(dir.filePath(kBaseFile));
        if (!file.open(QIODevice::WriteOnly) || file.write(board) != board.size() || !file.commit())
            return failure(ErrorCode::BadFile, u"%1: %2"_s.arg(file.fileName(), file.errorString()));
    }
    QSaveFile file(dir.filePath(kEditsFile));
    const QByteArray json = QJsonDocument(edits).toJson(QJsonDocument::Compact);
    if (!file.open(QIODevice::WriteOnly) || file.write(json) != json.size() || !file.commit())
        return failure(ErrorCode::BadFile, u"%1: %2"_s.arg(file.fileName(), file.errorString()));
    return {};
}

void BoardHistory::dropUnsaved(const QString &serial) const
{
    QDir(folder(serial) + u'/' + kUnsavedFolder).removeRecursively();
}

std::optional<QJsonObject> BoardHistory::unsaved(const QString &serial) const
{
    QFile file(folder(serial) + u'/' + kUnsavedFolder + u'/' + kEditsFile);
    if (!file.open(QIODevice::ReadOnly) || file.size() > kLargestJournal)
        return {};
    const QJsonObject edits = QJsonDocument::fromJson(file.readAll()).object();
    return edits.isEmpty() ? std::nullopt : std::optional(edits);
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
