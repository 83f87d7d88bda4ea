// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/device.h"
#include "protocol/device/livevalues.h"
#include "protocol/record/boardhistory.h"

/// The reply of an action and the safety copy taken before it, if any.
struct ActionOutcome
{
    ActionReply reply;
    QString snapshotPath;
};

/// Performs an action; one that writes or destroys takes a full snapshot first and refuses to run without it.
/// Errors: Unsupported for an unknown key, NoBackup, those of reading the board, and those of the action.
/// @param live values in use that are not stored, so that the snapshot tells what is
Result<ActionOutcome> performSafely(Channel &channel, Device &device, const QString &key,
                                    const QVariantMap &arguments, const BoardHistory &history,
                                    const LiveValues &live = {});

/// Sends a command typed by hand; one that writes or destroys takes a full snapshot first. Its answer goes to
/// whoever listens. Errors: ReadOnly, NoBackup, those of reading the board.
Result<bool> sendRaw(Channel &channel, Device &device, const RawCommand &command, const BoardHistory &history,
                     const LiveValues &live = {});
