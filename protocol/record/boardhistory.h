// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/record/configurationfile.h"

#include <QJsonObject>

/// Snapshots of all boards that were connected to this computer, one folder per board, named by its serial
/// number.
class BoardHistory
{
public:
    /// Snapshots live below this folder; by default in the user's application data.
    explicit BoardHistory(QString root = defaultRoot());
    [[nodiscard]] static QString defaultRoot();

    /// Saves a snapshot, reads it back and compares; returns its path. Errors: NoBackup.
    Result<QString> save(const Configuration &configuration, const QString &reason) const;
    /// Paths of a board's snapshots, newest first.
    [[nodiscard]] QStringList snapshots(const QString &serial) const;
    /// When a snapshot was taken, from its file name (UTC).
    [[nodiscard]] static QDateTime timeOf(const QString &path);

    /// Edits that never reached the board, kept beside its snapshots to survive a crash: any JSON the program
    /// makes of them, and the configuration they started from. Errors: BadFile.
    Result<void> saveUnsaved(const Configuration &base, const QJsonObject &edits) const;
    void dropUnsaved(const QString &serial) const;
    [[nodiscard]] std::optional<QJsonObject> unsaved(const QString &serial) const;
    /// Files with the configuration that unsaved edits of any board started from, newest first.
    [[nodiscard]] QStringList unsavedBases() const;

private:
    [[nodiscard]] QString folder(const QString &serial) const;
    QString m_root;
};
