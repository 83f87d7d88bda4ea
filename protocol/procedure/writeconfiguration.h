// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/livevalues.h"
#include "protocol/configuration/writereport.h"
#include "protocol/device/abilities.h"
#include "protocol/device/device.h"
#include "protocol/record/boardhistory.h"
#include "protocol/session/channel.h"

/// What a write has to know beside the values.
struct WriteOptions
{
    const BoardHistory *history = nullptr;  ///< where the safety copy goes; without one nothing is written
    bool backupDone = false;  ///< this board was already saved on this connection
    LiveValues live;  ///< values in use that are not stored
};

/// Writes the differences between base (what was read) and edited (what is wanted), and knows that they are
/// written: safety copy, fresh read (three-way: base, board, edited), write in the firmware's own bracket,
/// read back of every byte, the former active profile restored. What fails is rolled back where the board
/// still answers; a broken link leaves a report that says of each parameter what is known. A block whose
/// writing restarts the board (BlockSpec::effect) comes last, and is read back when the board has returned.
///
/// Errors before anything was touched: ReadOnly, NoBackup, Conflict (detail lists keys), and those of
/// reading. Everything later is told by the report.
Result<WriteReport> writeConfiguration(Channel &channel, Device &device, const Configuration &base,
                                       const Configuration &edited, const WriteOptions &options);
