// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/request.h"
#include "protocol/telemetry/streams.h"

/// What has been set up on the board.
struct TelemetryPlan
{
    std::shared_ptr<TelemetryDecoder> decoder;
    std::optional<Request> poll;  ///< to be repeated if the board cannot stream
    milliseconds pollInterval{50};
    double rate = 0;  ///< expected rows per second of the fastest stream
    /// Rows per second that a faster line would carry, where the line has thinned them out; else 0.
    double fullRate = 0;
    bool streaming = false;
    /// Beside what is asked for, the board streams by itself, at a rate of its own.
    bool isStreamedUnasked = false;
    StreamBudget budget;
    QByteArray shutdownFrames;  ///< frames that end the streams, for disconnecting
};
