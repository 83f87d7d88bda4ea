// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"
#include "protocol/session/framer.h"
#include "protocol/session/linkprobe.h"

#include <optional>

/// Counters of one link, as shown in the status bar.
struct LinkStatistics
{
    FramerStatistics framing;
    quint64 bytesIn = 0;
    quint64 bytesOut = 0;
    quint64 timeouts = 0;
    double framesPerSecond = 0;
    std::optional<Duration> roundTrip;
    std::optional<ProbedLink> quality;  ///< where the board answers heartbeats
    /// Since the last byte, where a link ends by silence; what was announced does not count.
    Duration silence{};
    /// When it last came back from a silence that degraded the link; empty: there was none.
    std::optional<TimePoint> backAt;
    static constexpr auto kDegraded = 1s;
    /// It still stands, but nothing has come for a while.
    [[nodiscard]] bool isDegraded() const { return silence >= kDegraded; }
};
