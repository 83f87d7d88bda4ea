// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/parameterspec.h"

#include <array>

namespace simplebgc {

/// The blocks of a SimpleBGC configuration and the commands that carry them.
enum Block : std::uint8_t { Params3, ParamsExt, ParamsExt2, ParamsExt3, AdjVarsCfg, BlockCount };

inline constexpr int kParams3Size = 134;
inline constexpr int kParamsExtSize = 104;
inline constexpr int kParamsExt2Size = 151;
inline constexpr int kParamsExt3Size = 221;
inline constexpr int kAdjVarsCfgSize = 128;

/// The first firmware with PARAMS_EXT3. Assumed: the errata tell "later", and the oldest of its fields that
/// they date came with 2.68.
inline constexpr int kExt3Since = 2680;

/// The parameters that say which signal a function has.
inline constexpr std::array<const char *, 6> kSignalKeys{"rc.map.roll", "rc.map.pitch", "rc.map.yaw",
                                                         "rc.map.cmd",  "fc.map.roll",  "fc.map.pitch"};

inline constexpr int kTriggerSlots = 10;
inline constexpr int kAnalogSlots = 15;
/// Firmware from which ADJ_VARS_STATE is asked by source instead of by slot (errata 3.15).
inline constexpr int kSlotStateBySource = 2625;

// clang-format off
inline constexpr BlockSpec kBlocks[] = {
    {Params3, "PARAMS_3", kParams3Size},
    {ParamsExt, "PARAMS_EXT", kParamsExtSize},
    // The document has it since March 2016; that this was 2.56 is an assumption.
    {.id = ParamsExt2, .name = "PARAMS_EXT2", .size = kParamsExt2Size, .since = 2560},
    {.id = ParamsExt3, .name = "PARAMS_EXT3", .size = kParamsExt3Size, .since = kExt3Since},
    // The board has it once; here it stands in every profile, like all values that belong to the board.
    {AdjVarsCfg, "ADJ_VARS_CFG", kAdjVarsCfgSize},
};
// clang-format on

/// Every field of PARAMS_3, PARAMS_EXT, PARAMS_EXT2, PARAMS_EXT3 and ADJ_VARS_CFG (document "Variables
/// description and range", errata 3.3-3.7 and 3.15). Labels, groups, help texts and choice names are
/// translated in the context "Tables".
[[nodiscard]] std::span<const ParameterRow> parameterRows();

/// Values of two parameters that exclude each other.
[[nodiscard]] std::span<const ValueRule> valueRules();

/// Menu actions (errata 4.1), for EXECUTE_MENU, buttons, RC commands and start-up actions.
[[nodiscard]] std::span<const Choice> menuActions();

/// Signal sources (errata 4.3) as choices.
[[nodiscard]] std::span<const Choice> signalSources();

// The rows block by block, in their own files.
[[nodiscard]] std::span<const ParameterRow> params3Rows();
[[nodiscard]] std::span<const ParameterRow> paramsExtRows();
[[nodiscard]] std::span<const ParameterRow> paramsExt2Rows();
[[nodiscard]] std::span<const ParameterRow> paramsExt3Rows();
[[nodiscard]] std::span<const ParameterRow> slotRows();

}  // namespace simplebgc
