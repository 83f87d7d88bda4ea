// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/configurationformats.h"

#include "protocol/base/filefault.h"

#include <QFileInfo>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr qint64 kLargestSettings = 1024 * 1024;

}  // namespace

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
        const auto text = readWhole(path, FileKind::Settings, kLargestSettings);
        if (!text)
            return tl::unexpected(text.error());
        auto settings = family.settingsFile->read(*text);
        if (!settings)
            return tl::unexpected(inFile(settings.error(), path));
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
    return writeWhole(path, *text, FileKind::Settings);
}

Result<void> checkSameFamily(const Configuration &file, const QString &path, const QString &wanted,
                             const QList<Family> &families)
{
    const QString family = file.identity().family;
    if (family == wanted)
        return {};
    const auto nameOf = [&families](const QString &key) {
        const Family *known = findFamily(families, key);
        return known ? known->name : key;
    };
    return fileFailure({.problem = FileProblem::OtherFamily,
                        .kind = FileKind::Configuration,
                        .path = path,
                        .value = nameOf(family),
                        .expected = nameOf(wanted)});
}
