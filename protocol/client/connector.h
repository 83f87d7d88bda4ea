// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/family.h"
#include "protocol/session/channel.h"

/// Where a board answered.
struct FoundBoard
{
    BoardIdentity identity;
    std::optional<LineSettings> line;  ///< serial links only
};

/// How far to search on a serial line whose settings are not known.
enum class Search { DefaultRate, AllRates };  // on links without a rate: asked once, or patiently

/// Finds rate and parity on an open link and identifies the board. Reports what it tries through
/// Channel::progress. If the address names settings, only those are tried.
/// @param known families whose protocols are recognised in foreign bytes
/// Errors: Silent (nothing ever arrived), Garbage (bytes, but no frame), WrongProtocol (another protocol is
/// spoken; the detail names it), or those of identification.
Result<FoundBoard> findBoard(Channel &channel, const Family &family, Device &device,
                             std::span<const Family> known, const LinkAddress &address,
                             Search search = Search::AllRates);

/// Waits until nothing more comes: what answers one family's questions late is not taken for an answer to the
/// next one's. What a board says by itself now and then is not waited for. Errors: those of Channel::sleep().
Result<void> awaitQuiet(Channel &channel);

/// Name of the protocol that these bytes look like, as its family calls it; empty if no family recognises
/// them.
[[nodiscard]] QString recogniseProtocol(std::span<const Family> known, const QByteArray &heard);

/// The families that may be there and are asked only where the address names them: they may take another
/// family's questions for commands.
[[nodiscard]] QList<Family> familiesNotAsked(const QList<Family> &known, const LinkAddress &address);

/// The families that may be probed at an address, in their order. A family requested by name, or by the
/// address (`?family=`), is the only one. Errors: InvalidArgument (no such family, it cannot be reached that
/// way, or it is unclear which of several is meant).
Result<QList<Family>> familiesFor(const QList<Family> &known, const LinkAddress &address,
                                  const QString &wanted);
