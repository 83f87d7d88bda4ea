// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/boardhistory.h"

#include <QDir>
#include <QRegularExpression>
#include <QStandardPaths>

using namespace Qt::StringLiterals;

BoardHistory::BoardHistory(QString root)
    : m_root(std::move(root))
{
}

QString BoardHistory::defaultRoot()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + u"/gimbaldesk/history"_s;
}

QString BoardHistory::folder(const QString &serial) const
{
    // The number comes from the board: it must not lead out of the folder.
    QString name = serial;
    name.replace(QRegularExpression(u"[^A-Za-z0-9-]"_s), u"_"_s);
    return m_root + u'/' + (name.isEmpty() ? u"unknown"_s : name.left(80));
}

Result<QString> BoardHistory::save(const Configuration &configuration, const QString &reason) const
{
    const QString folderPath = folder(configuration.identity().serial);
    if (!QDir().mkpath(folderPath))
        return failure(ErrorCode::NoBackup, folderPath);
    const QString stamp = QDateTime::currentDateTimeUtc().toString(u"yyyyMMdd-HHmmss-zzz"_s);
    const QString path = u"%1/%2.json"_s.arg(folderPath, stamp);
    if (const auto saved = ConfigurationFile::save(path, configuration, reason); !saved)
        return failure(ErrorCode::NoBackup, saved.error().detail);
    // A backup counts only once it was read again and holds the same bytes.
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
