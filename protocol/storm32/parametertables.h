// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/parameterspec.h"
#include "protocol/storm32/scripts.h"

namespace storm32 {

/// The parts of what `g` delivers: the parameter words, and the scripts behind them (errata 3.4).
enum Block : std::uint8_t { Parameters, Scripts, BlockCount };

/// Layouts that there are tables for (errata 5). In a ParameterSet the layout stands where other families
/// have the firmware.
[[nodiscard]] bool isKnownLayout(int layout);
/// Parameter words of a layout, the dummy in front of the scripts included; for one without a table what its
/// kin has.
[[nodiscard]] int wordsOf(int layout);
[[nodiscard]] std::span<const BlockSpec> blocksOf(int layout);
/// What `g` delivers, by blocks; only the words when there is no more, nothing when it has another length.
[[nodiscard]] std::vector<std::pair<int, QByteArray>> splitStream(const QByteArray &stream, int words);

/// The words of a layout without a table, as numbers.
[[nodiscard]] std::span<const ParameterRow> rawRows(int layout);
/// Every parameter of layouts 78, 89 and 95 (errata 5 and 11). `name` is what settings files, scripts and the
/// original tool call it; the number of the word is offset / 2.
[[nodiscard]] std::span<const ParameterRow> parameterRows();
/// That name for one parameter.
[[nodiscard]] QString originalName(const ParameterSpec &spec);

/// What scripts of a layout may name.
[[nodiscard]] ScriptContext scriptContext(const ParameterSet &parameters, int firmware);

}  // namespace storm32
