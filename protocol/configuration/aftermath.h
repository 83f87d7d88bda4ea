// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

/// What is known of a board after something failed that had been sent to it already: what it held before,
/// and what it holds since, once it was read again.
struct Aftermath
{
    QString snapshotPath;  ///< the copy made before; empty where none is needed
    Configuration before;
    bool isInUse
        = false;  ///< `before` is what was in use, on a board that keeps that apart from what is stored
    std::optional<Configuration> now = {};
    bool isBlind = false;  ///< what failed changes, above all, what no parameter shows
    bool isUnseen = false;  ///< nothing that the board tells shows whether it was carried out
    bool isStoring = false;  ///< what failed was to store what is in use: `before` is what was stored
    bool isStoreUntold = false;  ///< what failed was to store what is in use, which is all the board tells
    QString endedBy = {};  ///< what failed may go on on the board: the action that ends it and proves that
    bool isUnstored = false;  ///< what failed changes values in use, and stores them at its very end at most

    /// What differs now; nothing is said of what was not read both times.
    [[nodiscard]] std::vector<ParameterChange> changes() const
    {
        return now ? before.changesTo(*now) : std::vector<ParameterChange>();
    }
    [[nodiscard]] std::vector<DataChange> dataChanges() const
    {
        return now ? before.dataChangesTo(*now) : std::vector<DataChange>();
    }
    /// Parts that the board delivered before and not since.
    [[nodiscard]] QStringList lost() const
    {
        QStringList names;
        for (const MissingPart &part : now ? now->missing() : std::vector<MissingPart>()) {
            if (!before.findMissing(part.key))
                names.append(before.partName(part.key));
        }
        return names;
    }
};

/// The same error, with the aftermath as it is once the board was read.
[[nodiscard]] inline Error settled(Error error, Configuration now)
{
    auto after = std::make_shared<Aftermath>(*error.after);
    after->now = std::move(now);
    error.after = std::move(after);
    return error;
}
