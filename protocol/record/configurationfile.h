// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

#include <QDateTime>

#include <functional>

/// A configuration as a file: JSON, readable and exact at once. "values" holds every parameter by its key in
/// the operator's units and is what counts when a person edits the file; "blocks" holds the raw bytes,
/// reserved ones too.
struct ConfigurationFile
{
    using MakeParameters = std::function<std::shared_ptr<const ParameterSet>(const BoardIdentity &)>;

    Configuration configuration;
    QDateTime savedAt;
    QString reason;  ///< why it was saved ("before the first write")
    QStringList unknownKeys;  ///< entries of the file that this program has no parameter for
    QStringList missingKeys;  ///< parameters that the file does not name and that got their defaults

    /// Writes the file whole or not at all. Errors: BadFile.
    static Result<void> save(const QString &path, const Configuration &configuration, const QString &reason);
    /// Errors: BadFile with what is wrong and where.
    static Result<ConfigurationFile> load(const QString &path, const MakeParameters &makeParameters);

    [[nodiscard]] static QByteArray toJson(const Configuration &configuration, const QString &reason,
                                           const QDateTime &savedAt);
    static Result<ConfigurationFile> fromJson(const QByteArray &json, const MakeParameters &makeParameters);
};

/// The board's configuration with the file's values put in: reserved bytes stay the board's, parameters that
/// the board does not have are listed in skipped.
[[nodiscard]] Configuration applied(const Configuration &board, const Configuration &file,
                                    QStringList &skipped);
