// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/family.h"
#include "protocol/record/configurationfile.h"

/// Configurations of all families in our own format and in those of the manufacturers' programs.

/// Errors: BadFile with the reason and the place.
[[nodiscard]] Result<ConfigurationFile> loadConfiguration(const QString &path, const QList<Family> &families);
/// The path's suffix selects the format. Errors: BadFile, Unsupported.
[[nodiscard]] Result<void> saveConfiguration(const QString &path, const Configuration &configuration,
                                             const QString &reason, const QList<Family> &families);
[[nodiscard]] const Family *findFamily(const QList<Family> &families, const QString &key);
/// Whether a file's values are those of boards of the wanted family. Errors: BadFile, which names both.
[[nodiscard]] Result<void> checkSameFamily(const Configuration &file, const QString &path,
                                           const QString &wanted, const QList<Family> &families);
