// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/livevalues.h"
#include "protocol/configuration/writereport.h"
#include "protocol/device/abilities.h"
#include "protocol/record/boardhistory.h"

#include <QSet>

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
    /// Named values are written even where the board answers with them already: one that answers with what is
    /// in use may have stored others.
    bool evenIfInUse = false;
    std::optional<WholeMemory::Contents> contents = {};  ///< of such a board, if they were just read
};
