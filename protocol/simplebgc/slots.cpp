// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Slots by which signals run menu commands and set adjustable variables (document READ_ADJ_VARS_CFG, errata
// 3.15).
#include "protocol/simplebgc/adjustables.h"
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/parametertables.h"

#include <algorithm>
#include <iterator>

namespace simplebgc {

namespace {

constexpr int kNewest = 99999;
constexpr int kLastOld = 2599;
constexpr double kShare = 100.0 / 255.0;

// clang-format off
constexpr ParameterRow kTrigger{
    .key = "", .label = "", .group = "Trigger slots",
    .help = "Menu command that is run when the signal comes into this fifth of its range.",
    .block = AdjVarsCfg, .kind = ValueKind::Choice, .count = kTriggerSlots, .countStride = 6, .choices = kMenuActions,
    .level = ViewLevel::Advanced, .scope = Scope::Board, .inactive = {"slot.trigger%n.source", 0}};

constexpr ParameterRow trigger(const char *key, const char *label, std::uint16_t offset)
{
    ParameterRow row = kTrigger;
    row.key = key;
    row.label = label;
    row.offset = offset;
    return row;
}

constexpr ParameterRow kRows[] = {
    {.key = "slot.trigger%n.source", .label = "Trigger %1: signal", .group = "Trigger slots",
     .help = "Signal that runs menu commands; each fifth of its range has one.",
     .block = AdjVarsCfg, .offset = 0, .kind = ValueKind::Choice, .count = kTriggerSlots, .countStride = 6, .choices = kSignalSources,
     .scope = Scope::Board},
    trigger("slot.trigger%n.action1", "Trigger %1: lowest fifth", 1),
    trigger("slot.trigger%n.action2", "Trigger %1: second fifth", 2),
    trigger("slot.trigger%n.action3", "Trigger %1: middle", 3),
    trigger("slot.trigger%n.action4", "Trigger %1: fourth fifth", 4),
    trigger("slot.trigger%n.action5", "Trigger %1: highest fifth", 5),
    {.key = "slot.analog%n.source", .label = "Slot %1: signal", .group = "Variable slots",
     .help = "Signal that sets an adjustable variable continuously.",
     .block = AdjVarsCfg, .offset = 60, .kind = ValueKind::Choice, .count = kAnalogSlots, .countStride = 4, .choices = kSignalSources,
     .scope = Scope::Board},
    {.key = "slot.analog%n.variable", .label = "Slot %1: variable", .group = "Variable slots",
     .help = "Variable that the signal sets.",
     .block = AdjVarsCfg, .offset = 61, .bitShift = 0, .bitCount = 7, .kind = ValueKind::Choice, .count = kAnalogSlots, .countStride = 4,
     .max = 127, .scope = Scope::Board, .inactive = {"slot.analog%n.source", 0}},
    {.key = "slot.analog%n.multiply", .label = "Slot %1: multiply", .group = "Variable slots",
     .help = "The signal multiplies the stored value instead of replacing it.",
     .block = AdjVarsCfg, .offset = 61, .bitShift = 7, .bitCount = 1, .kind = ValueKind::Toggle, .count = kAnalogSlots, .countStride = 4,
     .max = 1, .scope = Scope::Board, .since = 2600, .inactive = {"slot.analog%n.source", 0}},
    {.key = "slot.analog%n.min", .label = "Slot %1: at lowest signal", .group = "Variable slots",
     .help = "Share of the variable's own range.",
     .block = AdjVarsCfg, .offset = 62, .count = kAnalogSlots, .countStride = 4, .unit = "%", .scale = kShare, .decimals = 1,
     .scope = Scope::Board, .inactive = {"slot.analog%n.source", 0}},
    {.key = "slot.analog%n.max", .label = "Slot %1: at highest signal", .group = "Variable slots",
     .help = "Share of the variable's own range.",
     .block = AdjVarsCfg, .offset = 63, .count = kAnalogSlots, .countStride = 4, .unit = "%", .scale = kShare, .decimals = 1,
     .defaults = {255}, .scope = Scope::Board, .inactive = {"slot.analog%n.source", 0}},
};
// clang-format on

constexpr std::pair<int, int> kReserved[] = {{120, 8}};
static_assert(coversBlock<kAdjVarsCfgSize>(kRows, AdjVarsCfg, kReserved));
static_assert(rangesFit(kRows));

}  // namespace

std::span<const ParameterRow> slotRows()
{
    static const std::vector<Choice> variables = [] {
        const auto old = adjustablesOf(kLastOld);
        std::vector<Choice> all;
        for (const AdjustableSpec &spec : adjustablesOf(kNewest)) {
            Choice choice{spec.id, spec.label, spec.since};
            // Two of them were renumbered in meaning (errata 6, row 13).
            if (spec.id < int(old.size()) && qstrcmp(old[std::size_t(spec.id)].label, spec.label) != 0) {
                all.push_back({spec.id, old[std::size_t(spec.id)].label, 0, kLastOld});
                choice.since = kLastOld + 1;
            }
            all.push_back(choice);
        }
        return all;
    }();
    static const std::vector<ParameterRow> rows = [] {
        // Slot by slot, as one is filled in.
        std::vector<ParameterRow> all;
        for (const int count : {kTriggerSlots, kAnalogSlots}) {
            for (int slot = 0; slot < count; ++slot) {
                for (ParameterRow row : kRows) {
                    if (row.count != count)
                        continue;
                    row.offset = std::uint16_t(row.offset + slot * row.countStride);
                    row.count = 1;
                    row.firstIndex = std::uint8_t(slot + 1);
                    if (row.kind == ValueKind::Choice && row.choices.empty())
                        row.choices = variables;
                    all.push_back(row);
                }
            }
        }
        return all;
    }();
    return rows;
}

}  // namespace simplebgc
