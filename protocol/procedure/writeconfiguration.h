// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/device.h"
#include "protocol/procedure/writeoptions.h"
#include "protocol/session/channel.h"

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
