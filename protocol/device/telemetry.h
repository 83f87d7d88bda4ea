// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/channelspec.h"
#include "protocol/device/telemetrystore.h"
#include "protocol/session/request.h"

#include <QSet>

/// Turns frames into rows of the store, on the I/O thread.
class TelemetryDecoder
{
public:
    virtual ~TelemetryDecoder() = default;
    virtual void decode(const FrameView &frame, TimePoint at, TelemetryStore &store) = 0;
    /// Whole frames that were sent to the board. Of use to Device::replayDecoder() only.
    virtual void sent(QByteArrayView) { }
};

/// What the operator wants to see.
struct TelemetryWish
{
    QList<int> channels;         ///< fast channels, for plots; status channels always come
    double rate = 0;             ///< rows per second; 0 = as fast as the link allows

    friend bool operator==(const TelemetryWish &, const TelemetryWish &) = default;
};

/// What was arranged with the board.
struct TelemetryPlan
{
    std::shared_ptr<TelemetryDecoder> decoder;
    std::optional<Request> poll;       ///< repeat this where the board cannot stream
    milliseconds pollInterval{50};
    double rate = 0;                   ///< expected fast rows per second
    bool streaming = false;
    QByteArray farewell;               ///< frames that end the streams, for leaving
};
