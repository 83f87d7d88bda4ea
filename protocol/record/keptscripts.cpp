// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/keptscripts.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

const QString kScriptTime = u"yyyyMMdd-HHmmss-zzz"_s;
const QString kWholeScript = u".bin"_s;
const QString kScriptPart = u".bin.part"_s;

QString scriptPrefix(int slot)
{
    return u"slot%1-"_s.arg(slot);
}

}  // namespace

KeptScripts::KeptScripts(const BoardHistory &history, const QString &serial)
    : m_folder(QFileInfo(history.setupFile(serial)).dir().filePath(u"scripts"_s))
{
}

QString KeptScripts::next(int slot) const
{
    QDir().mkpath(m_folder);
    return QDir(m_folder).filePath(scriptPrefix(slot) + QDateTime::currentDateTimeUtc().toString(kScriptTime)
                                   + kWholeScript);
}

QStringList KeptScripts::files(int slot, const QString &ending) const
{
    const QDir folder(m_folder);
    QStringList paths;
    for (const QString &name : folder.entryList({scriptPrefix(slot) + u'*' + ending}, QDir::Files))
        paths.append(folder.filePath(name));
    return paths;
}

QList<KeptScripts::Copy> KeptScripts::copies(int slot) const
{
    QList<Copy> found;
    for (const QString &path : files(slot, kWholeScript) + files(slot, kScriptPart)) {
        const QFileInfo file(path);
        const QString stamp = file.fileName().mid(scriptPrefix(slot).size()).section(u'.', 0, 0);
        QDateTime time = QDateTime::fromString(stamp, kScriptTime);
        time.setTimeSpec(Qt::UTC);
        if (file.size() > 0)
            found.append({path, time, file.size()});
    }
    std::ranges::sort(found, std::greater(), &Copy::path);
    return found;
}

bool KeptScripts::isUnfinished(int slot) const
{
    return !files(slot, kScriptPart).isEmpty();
}

void KeptScripts::settle(int slot) const
{
    for (const QString &path : files(slot, kScriptPart)) {
        if (QFileInfo(path).size() == 0)
            QFile::remove(path);
        else
            QFile::rename(path, path.chopped(kScriptPart.size()) + kWholeScript);
    }
}
