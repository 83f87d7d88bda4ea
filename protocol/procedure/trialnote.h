// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"
#include "protocol/configuration/configuration.h"

class BoardHistory;
class Channel;
class Device;

/// Values that a board holds on trial. Kept beside its backups from before they are written until they are
/// accepted, or the old ones are proven to be back: the program, or the link, may end in the middle.
struct TrialNote
{
    struct Value
    {
        QString key;
        double old = 0;  ///< raw, as that on trial
        double tried = 0;
    };

    int profile = 0;
    std::vector<Value> values;

    /// The same with the old values, where those on trial are still there.
    [[nodiscard]] Configuration madeGood(const Configuration &board) const;
};

/// @param before what was tried before that, and may be on the board still, in part. Errors: BadFile.
Result<void> keepTrial(const BoardHistory &history, const Configuration &base, const Configuration &tried,
                       const Configuration *before = nullptr);
void dropTrial(const BoardHistory &history, const BoardIdentity &identity);
/// Empty: there is none, or none that can be read.
[[nodiscard]] std::optional<TrialNote> keptTrial(const BoardHistory &history, const BoardIdentity &identity);
/// Writes back what a trial that was cut off has left.
/// @param board what it holds @return keys of what was written back; empty: nothing was left
Result<QStringList> makeTrialGood(Channel &channel, Device &device, const BoardHistory &history,
                                  const Configuration &board);
