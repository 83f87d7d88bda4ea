// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/family.h"
#include "protocol/session/channel.h"

/// Where a board answered.
struct FoundBoard
{
    BoardIdentity identity;
    std::optional<LineSettings> line;  ///< of serial links
};

/// How far to look on a serial line whose settings nobody has told.
enum class Search { DefaultRate, AllRates };

/// Finds rate and parity on an open link and identifies the board. Says what it tries through
/// Channel::progress. Only the given settings are tried where the address names them.
/// @param known families by which foreign bytes can be named
/// Errors: Silent (nothing ever came), Garbage (bytes, but no frame), WrongProtocol (another protocol is
/// spoken; detail names it), or what identification met.
Result<FoundBoard> findBoard(Channel &channel, const Family &family, Device &device,
                             std::span<const Family> known, const LinkAddress &address,
                             Search search = Search::AllRates);

/// The protocol that these bytes look like, in the words of the family that knows it; empty where none does.
[[nodiscard]] QString recogniseProtocol(std::span<const Family> known, const QByteArray &heard);

/// The families whose question may be asked at an address, in their order. One that is asked for by name, or
/// by the address (`?family=`), is the only one. Errors: InvalidArgument (no such family, it is not reached
/// that way, or nobody knows which of several is meant).
Result<QList<Family>> familiesFor(const QList<Family> &known, const LinkAddress &address,
                                  const QString &wanted);
