// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/device.h"

/// Where a board answered.
struct FoundBoard
{
    BoardIdentity identity;
    std::optional<LineSettings> line;  ///< of serial links
};

/// How far to look on a serial line whose settings nobody has told.
enum class Search { UsualRate, AllRates };

/// Finds rate and parity on an open link and identifies the board. Says what it tries through
/// Channel::progress. Only the given settings are tried where the address names them. Errors: Silent (nothing
/// ever came), Garbage (bytes, but no frame), WrongProtocol (another family speaks; detail names it), or what
/// identification met.
Result<FoundBoard> findBoard(Channel &channel, Device &device, const LinkAddress &address,
                             Search search = Search::AllRates);

/// The protocol that these bytes look like ("MAVLink", "STorM32", "BCFlight"), or nothing.
[[nodiscard]] QString recognizeProtocol(const QByteArray &bytes);
