// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/record/configurationfile.h"

/// The snapshots of all boards this computer has met, one folder per board, named by its serial number.
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

private:
    [[nodiscard]] QString folder(const QString &serial) const;
    QString m_root;
};
