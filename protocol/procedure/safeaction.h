// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/livevalues.h"
#include "protocol/configuration/writereport.h"
#include "protocol/device/abilities.h"
#include "protocol/device/device.h"
#include "protocol/record/boardhistory.h"
#include "protocol/session/channel.h"

/// The reply of an action and the safety copy taken before it, if any.
struct ActionOutcome
{
    ActionReply reply;
    QString snapshotPath;
    bool answered
        = true;  ///< false: the board was told, and nothing shows that it heard (ActionSpec::answered), or
                 ///< that it has stored what is in use; then `reply` has why ("unproven")
    /// The board confirms that it has stored, and answers with what is in use: only its next start shows it.
    bool isStoreUntold = false;
    /// Whether motors run since, where that is otherwise than before and not what the action is for.
    std::optional<bool> motorsNow = {};
    /// Of an action that stores everything in use on a board with a WholeMemory: what was in use without
    /// being stored (`others`), or why that is not known.
    std::optional<WriteReport> stored = {};
    /// Of an action that puts what is stored into use there: what was in use before, `from`, and is not any
    /// more.
    std::vector<ParameterChange> lost = {};
};

/// The channel that reports a condition; -1 if the board has none.
[[nodiscard]] int channelOf(Condition condition, const ChannelRoles &roles);

/// Whether motors run, as far as telemetry tells; empty where it does not.
[[nodiscard]] std::optional<bool> motorsRun(const Device &device, const LatestValues *latest, TimePoint now);

/// Performs an action; one that writes or destroys takes a full snapshot first and refuses to run without it.
/// Where it overwrites what is stored on a board with a WholeMemory, that is what the snapshot holds. Asking
/// for its confirmation is up to the caller. Errors: Unsupported for an unknown key, NoBackup, ConditionUnmet
/// (a condition of the action is not met, or unknown), Unready (the board is starting with motors disabled,
/// which must not be stored unseen), those of reading the board, those of the action, and NotStored (a board
/// with a WholeMemory was asked afterwards what it has stored).
/// @param live values in use that are not stored, so that the snapshot holds the stored ones
/// @param latest telemetry that shows whether the board is armed, calibrated, driving its motors; may be null
/// for actions without conditions
Result<ActionOutcome> performSafely(Channel &channel, Device &device, const QString &key,
                                    const QVariantMap &arguments, const BoardHistory &history,
                                    const LiveValues &live = {}, const LatestValues *latest = nullptr);

/// Sends a command typed by hand; one that writes or destroys takes a full snapshot first. Its answer goes to
/// the frame listeners. Errors: ReadOnly, NoBackup, those of reading the board.
Result<bool> sendRaw(Channel &channel, Device &device, const RawCommand &command, const BoardHistory &history,
                     const LiveValues &live = {});
