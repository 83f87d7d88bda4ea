// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/configuration/leap.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kRounding = 1e-6;  // of a float

}  // namespace

bool isLeap(const ParameterSpec &spec, double from, double to)
{
    const ParameterRow &row = *spec.row;
    // What the board holds may be no number.
    const double reference = std::isfinite(from) ? std::abs(from) : 0;
    return row.risk == Risk::Red && row.kind == ValueKind::Number && row.wire == WireType::F32 && row.min >= 0
        && to > kLeap * (1 + kRounding) * reference;
}

std::vector<ParameterChange> leapsAmong(const std::vector<ParameterChange> &changes)
{
    std::vector<ParameterChange> leaps;
    std::copy_if(changes.begin(), changes.end(), std::back_inserter(leaps),
                 [](const ParameterChange &change) { return isLeap(*change.spec, change.from, change.to); });
    return leaps;
}

std::optional<double> timesAsMuch(double from, double to)
{
    return std::isfinite(from) && from != 0 ? std::optional(to / std::abs(from)) : std::nullopt;
}

bool isOfRiskClass(const ParameterSet &parameters, const BlockSpec &block)
{
    const auto &all = parameters.all();
    return block.isText() && std::any_of(all.begin(), all.end(), [](const ParameterSpec &spec) {
               return spec.row->risk == Risk::Red && spec.row->textFigure;
           });
}
