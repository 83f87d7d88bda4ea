// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/notchplan.h"

#include "protocol/device/device.h"

#include <algorithm>

namespace {

constexpr double kDepthDb = 20.0;
constexpr double kMinWidth = 0.25;  // of its frequency

}  // namespace

Configuration NotchPlan::appliedTo(Configuration configuration) const
{
    for (const auto &[key, raw] : values) {
        if (const ParameterSpec *spec = configuration.parameters().find(key))
            std::ignore = configuration.setRaw(*spec, profile, raw);
    }
    const ParameterSpec *enabled = configuration.parameters().find(filter.enabled);
    if (const auto bits = enabled ? configuration.raw(*enabled, profile) : std::nullopt)
        std::ignore = configuration.setRaw(*enabled, profile, flagBits(*bits) | (1U << filter.bit));
    return configuration;
}

std::optional<NotchPlan> planNotch(const Device &device, const Configuration &board,
                                   const Configuration &edited, Axis axis, const SpectrumPeak &peak)
{
    const NotchFilters *notches = device.notchFilters();
    if (!notches)
        return {};
    const int profile = board.activeProfile();
    for (const NotchFilter &filter : notches->notchesOf(axis)) {
        const ParameterSpec *enabled = board.parameters().find(filter.enabled);
        const auto isFree = [&](const Configuration &configuration) {
            const auto bits = enabled ? configuration.raw(*enabled, profile) : std::nullopt;
            return bits && !(flagBits(*bits) & (1U << filter.bit));
        };
        const ParameterSpec *frequency = board.parameters().find(filter.frequency);
        const ParameterSpec *width = board.parameters().find(filter.width);
        const ParameterSpec *depth = board.parameters().find(filter.depth);
        if (!frequency || !width || !depth || !isFree(board) || !isFree(edited))
            continue;
        NotchPlan plan{axis, peak, filter, {}, profile, {}};
        const auto put = [&plan](const ParameterSpec &spec, double value) {
            const double raw = spec.clamped(spec.toRaw(value));
            plan.values.emplace_back(spec.key, raw);
            return spec.toDisplay(raw);
        };
        // A resonance wanders with temperature and load: twice its width, a quarter of its frequency at
        // least.
        plan.shape.hz = put(*frequency, peak.frequency);
        plan.shape.width = put(*width, std::max(2.0 * peak.width, peak.frequency * kMinWidth));
        plan.shape.depthDb = put(*depth, kDepthDb);
        return plan;
    }
    return {};
}
