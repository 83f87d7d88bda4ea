// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/changewatch.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace {

constexpr Duration kUnchanged = 5s;
constexpr quint64 kUnchangedRows = 20;

}  // namespace

void ChangeWatch::look(const TelemetryStore *store, TimePoint now)
{
    std::vector<float> values;
    for (int channel = 0; store && channel < store->channelCount(); ++channel)
        values.push_back(store->latest(channel));
    // Bit by bit: a value that is none stays none.
    const auto isSame = [](float value, float before) {
        return std::bit_cast<std::uint32_t>(value) == std::bit_cast<std::uint32_t>(before);
    };
    if (std::equal(values.begin(), values.end(), m_values.begin(), m_values.end(), isSame))
        return;
    m_values = std::move(values);
    m_changedAt = now;
    m_rows = store ? store->rows() : 0;
}

std::optional<TimePoint> ChangeWatch::unchangedSince(const TelemetryStore &store, TimePoint now) const
{
    const bool isNew = store.stampedAt() != TimePoint{} && now - store.stampedAt() < kUnchanged;
    if (isNew || now - m_changedAt < kUnchanged || store.rows() < m_rows + kUnchangedRows)
        return {};
    return m_changedAt;
}
