// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/configurationformats.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>

using namespace Qt::StringLiterals;

const Family *findFamily(const QList<Family> &families, const QString &key)
{
    const auto it = std::find_if(families.begin(), families.end(),
                                 [&key](const Family &family) { return family.key == key; });
    return it == families.end() ? nullptr : &*it;
}

Result<ConfigurationFile> loadConfiguration(const QString &path, const QList<Family> &families)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    for (const Family &family : families) {
        if (!family.settingsFile || family.settingsFile->suffix != suffix)
            continue;
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            return failure(ErrorCode::BadFile, u"%1: %2"_s.arg(path, file.errorString()));
        auto settings = family.settingsFile->read(file.read(1024 * 1024));
        if (!settings)
            return failure(settings.error().code, path + u": "_s + settings.error().detail);
        ConfigurationFile result;
        result.configuration = std::move(settings->configuration);
        result.savedAt = QFileInfo(path).lastModified();
        result.unknownKeys = settings->unknown;
        result.missingKeys = settings->missing;
        return result;
    }
    return ConfigurationFile::load(
        path, [&families](const BoardIdentity &identity) -> std::shared_ptr<const ParameterSet> {
            const Family *family = findFamily(families, identity.family);
            return family ? family->makeParameters(identity) : nullptr;
        });
}

Result<void> saveConfiguration(const QString &path, const Configuration &configuration, const QString &reason,
                               const QList<Family> &families)
{
    const Family *family = findFamily(families, configuration.identity().family);
    if (!family || !family->settingsFile
        || QFileInfo(path).suffix().toLower() != family->settingsFile->suffix)
        return ConfigurationFile::save(path, configuration, reason);
    const auto text = family->settingsFile->write(configuration);
    if (!text)
        return tl::unexpected(text.error());
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(*text) < 0 || !file.commit())
        return failure(ErrorCode::BadFile, u"%1: %2"_s.arg(path, file.errorString()));
    return {};
}
