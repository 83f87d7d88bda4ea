// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

#include <QDateTime>

#include <functional>

/// A configuration as a file: JSON, both readable and exact. "values" holds every parameter by its key in the
/// operator's units and takes precedence when a person edits the file; "blocks" holds the raw bytes,
/// including the reserved ones.
struct ConfigurationFile
{
    using MakeParameters = std::function<std::shared_ptr<const ParameterSet>(const BoardIdentity &)>;

    Configuration configuration;
    QDateTime savedAt;
    QString reason;  ///< why it was saved ("before the first write")
    QStringList unknownKeys;  ///< entries of the file that match no parameter of this program
    /// Keys of parameters, and names of blocks without any, that the file does not have: the configuration
    /// has their defaults, which nobody wanted.
    QStringList missingKeys;
    QStringList rounded;  ///< what roundingText() tells of values that were rounded

    /// Writes the complete file or nothing. Errors: BadFile.
    static Result<void> save(const QString &path, const Configuration &configuration, const QString &reason);
    /// Errors: BadFile with the reason and the place.
    static Result<ConfigurationFile> load(const QString &path, const MakeParameters &makeParameters);

    [[nodiscard]] static QByteArray toJson(const Configuration &configuration, const QString &reason,
                                           const QDateTime &savedAt);
    static Result<ConfigurationFile> fromJson(const QByteArray &json, const MakeParameters &makeParameters);
};

/// What applied() is for.
enum class AppliedFor {
    Writing,  ///< values that nobody may set are left out
    Comparing,  ///< what a board holds counts, allowed or not
};

/// The board's configuration with the file's values: reserved bytes stay the board's. What was left out is
/// listed in skipped: the key of a parameter that the board does not have, "KEY = VALUE, allowed ..." of a
/// value that it does not take.
/// @param missingKeys what the file does not have, although its configuration has a value: left alone
[[nodiscard]] Configuration applied(const Configuration &board, const Configuration &file,
                                    QStringList &skipped, AppliedFor purpose = AppliedFor::Writing,
                                    const QStringList &missingKeys = {});
/// The same of a whole file: what it does not have stays the board's.
[[nodiscard]] Configuration applied(const Configuration &board, const ConfigurationFile &file,
                                    QStringList &skipped);
