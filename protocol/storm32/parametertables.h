// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/parameterspec.h"
#include "protocol/storm32/scripts.h"

namespace storm32 {

/// The parts of the `g` data: the parameter words, and the scripts after them (errata 3.4).
enum Block : std::uint8_t { Parameters, Scripts, BlockCount };

inline constexpr int kSystemWord = 110;  ///< MAVLink system, followed by the component
inline constexpr int kHeartbeatWord = 112;  ///< MAVLink configuration (errata 6)

/// Layouts that have a table (errata 5). A ParameterSet holds the layout where other families have the
/// firmware.
[[nodiscard]] bool isKnownLayout(int layout);
/// Number of parameter words of a layout, including the dummy before the scripts; a layout without a table is
/// assumed to have as many as its relatives.
[[nodiscard]] int wordsOf(int layout);
[[nodiscard]] std::span<const BlockSpec> blocksOf(int layout);
/// The `g` data, split into blocks; only the words if there is no more, empty if the length is a different
/// one.
[[nodiscard]] std::vector<std::pair<int, QByteArray>> splitStream(const QByteArray &stream, int words);

/// The words of a layout without a table, as numbers.
[[nodiscard]] std::span<const ParameterRow> rawRows(int layout);
/// Every parameter of layouts 78, 89 and 95 (errata 5 and 11). `name` is the name in settings files, scripts
/// and the original tool; the number of the word is offset / 2.
[[nodiscard]] std::span<const ParameterRow> parameterRows();
/// The `name` of one parameter.
[[nodiscard]] QString originalName(const ParameterSpec &spec);

/// The names that scripts of a layout may use.
[[nodiscard]] ScriptContext scriptContext(const ParameterSet &parameters, int firmware);

}  // namespace storm32
