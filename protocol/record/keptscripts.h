// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/record/boardhistory.h"

/// Copies of the scripts that were in a board's slots before they were replaced or erased, beside the board's
/// snapshots. One whose name ends in ".part" tells of a write whose end nobody saw.
class KeptScripts
{
public:
    struct Copy
    {
        QString path;
        QDateTime time;  ///< UTC, when it was replaced
        qint64 bytes = 0;
    };

    KeptScripts(const BoardHistory &history, const QString &serial);

    /// A path for the next copy; its folder is there afterwards. @param slot from 1, as everywhere here
    [[nodiscard]] QString next(int slot) const;
    /// Newest first, without empty ones.
    [[nodiscard]] QList<Copy> copies(int slot) const;
    /// The slot was being written when the link or the program ended: what is in it may be half a script.
    [[nodiscard]] bool isUnfinished(int slot) const;
    /// What is in the slot is known again.
    void settle(int slot) const;

private:
    [[nodiscard]] QStringList files(int slot, const QString &ending) const;

    QString m_folder;
};
