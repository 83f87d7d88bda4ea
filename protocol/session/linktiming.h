// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"

#include <QByteArray>

#include <functional>
#include <memory>

class LinkProbe;

/// Timing that a family requires on a link.
struct LinkTiming
{
    milliseconds pause{0};  ///< after each command, so that the board's input buffer does not overflow
    milliseconds controlPeriod{20};  ///< between two set-points of the control stream
    milliseconds heartbeatPeriod{0};  ///< 0: the board expects none
    std::function<QByteArray()> heartbeat = {};  ///< the frame to send in each period
    /// Makes what measures the link by heartbeats that are answered; it then makes them, instead of the
    /// function above.
    std::function<std::unique_ptr<LinkProbe>()> makeProbe = {};
    /// Without a byte for this long the link counts as lost; 0: the link itself reports it (serial, TCP).
    milliseconds silenceLimit{0};
    /// Stops motors in any state, whatever generation of the protocol it is; empty: there is nothing like
    /// that.
    QByteArray blindStop = {};
    /// It is sent from the moment at which the link opens until a stop of the board that is known takes over.
    bool stopsFirst = false;
};
