// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

#include <vector>

namespace simplebgc {

/// Where in a board's memory something lies that the board also tells by a command. No document says it; it
/// was found by its bytes, which stand there once.
struct MemoryPlace
{
    static constexpr int kNames = -1;  ///< as BlockKey::block: the names of the profiles

    BlockKey key;
    qsizetype at = 0;
    qsizetype size = 0;
};

/// The blocks of a configuration and the names of its profiles, as far as their place can be told.
/// @param board what the same board says of itself; what it uses without having stored it is not found
[[nodiscard]] std::vector<MemoryPlace> findPlaces(const QByteArray &memory, const Configuration &board);

/// How many places there could be.
[[nodiscard]] int placesWanted(const Configuration &board);

/// What differs in words, "profile 2: pid.roll.p" and "15 -> 16". Takes these differences out of `file`.
[[nodiscard]] std::vector<std::pair<QString, QString>>
explainDifferences(QByteArray &file, const QByteArray &memory, const std::vector<MemoryPlace> &places,
                   const Configuration &board);

}  // namespace simplebgc
