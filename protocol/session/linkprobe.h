// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"
#include "protocol/base/frame.h"

#include <QByteArray>

#include <optional>

/// What is known of a link by questions of its own.
struct ProbedLink
{
    std::optional<Duration> roundTrip;  ///< of the newest question that was answered
    std::optional<double> answered;  ///< share of the last ones, 0 to 1
    quint64 foreign = 0;  ///< answers that came here to questions of somebody else
    bool isShared
        = false;  ///< lately somebody else got answers that were meant for here, or the other way round

    friend bool operator==(const ProbedLink &, const ProbedLink &) = default;
};

/// Measures a link whose board answers heartbeats, and notices another program on it. One per link; lives on
/// the I/O thread, and has no clock of its own.
class LinkProbe
{
public:
    virtual ~LinkProbe() = default;
    /// The heartbeat to send now.
    [[nodiscard]] virtual QByteArray beat(TimePoint now) = 0;
    /// All that is sent, heartbeats too.
    virtual void sent(Bytes bytes, TimePoint now) = 0;
    virtual void frameArrived(const FrameView &frame, TimePoint at) = 0;
    /// Until then it may be away on purpose: what it leaves unanswered is no fault of the link.
    virtual void expectSilence(TimePoint until) { Q_UNUSED(until) }
    [[nodiscard]] virtual ProbedLink quality(TimePoint now) const = 0;
};
