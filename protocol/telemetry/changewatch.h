// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/telemetrystore.h"

#include <optional>
#include <vector>

/// Notices a board that sends the same values again and again, where no time stamp shows that they are new.
class ChangeWatch
{
public:
    /// To be called some times per second. @param store null = none
    void look(const TelemetryStore *store, TimePoint now);
    /// When the newest value of any channel was seen to differ from the one before.
    [[nodiscard]] TimePoint changedAt() const { return m_changedAt; }
    /// Since when samples come and none of them differs from the one before; empty: they do, or it is too
    /// early to tell, because values of few digits may repeat.
    [[nodiscard]] std::optional<TimePoint> unchangedSince(const TelemetryStore &store, TimePoint now) const;

private:
    std::vector<float> m_values;  // newest of all channels
    TimePoint m_changedAt{};
    quint64 m_rows = 0;  // how many had come then
};
