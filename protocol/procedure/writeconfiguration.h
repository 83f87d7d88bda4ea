// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/livevalues.h"
#include "protocol/configuration/writereport.h"
#include "protocol/device/abilities.h"
#include "protocol/device/device.h"
#include "protocol/record/boardhistory.h"
#include "protocol/session/channel.h"

/// Options of a write.
struct WriteOptions
{
    const BoardHistory *history = nullptr;  ///< where the safety copy goes; null: nothing is written
    bool backupDone = false;  ///< a complete safety copy was already made on this connection
    LiveValues live;  ///< values in use that are not stored
    OtherValues others = OtherValues::Keep;
    /// Keys of parameters, and names of blocks without any, that are to be in use as wanted even where they
    /// are stored so already; for boards with a WholeMemory.
    QSet<QString> named = {};
    std::optional<WholeMemory::Contents> contents = {};  ///< of such a board, if they were just read
};

/// Writes the differences between base (what was read) and edited (what is wanted), and verifies them: safety
/// copy, fresh read (three-way: base, board, edited), write in the firmware's own bracket, read-back of every
/// byte, the previously active profile restored. What fails is rolled back while the board still answers; a
/// broken link leaves a report that states what is known of each parameter. A block whose writing restarts
/// the board (BlockSpec::effect) comes last, and is read back when the board has returned.
///
/// Errors before anything was touched: ReadOnly, NoBackup, Conflict (detail lists keys), and those of
/// reading. Everything later is in the report.
Result<WriteReport> writeConfiguration(Channel &channel, Device &device, const Configuration &base,
                                       const Configuration &edited, const WriteOptions &options);
