// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"
#include "protocol/session/framer.h"

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
};
