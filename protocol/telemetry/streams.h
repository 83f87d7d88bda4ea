// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"
#include "protocol/base/frame.h"
#include "protocol/base/result.h"
#include "protocol/telemetry/channelspec.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QSet>

/// Turns frames into rows of the store, on the I/O thread.
class TelemetryDecoder
{
public:
    virtual ~TelemetryDecoder() = default;
    virtual void decode(const FrameView &frame, TimePoint at, TelemetryStore &store) = 0;
    /// Complete frames that were sent to the board: what was asked for and is not answered is lost.
    /// Device::replayDecoder() learns from them what was ordered.
    virtual void sent(QByteArrayView, TelemetryStore &) { }
};

/// A stream that a board can send on request.
struct StreamSpec
{
    QString key;  ///< "realtime4": command line, settings
    QString label;  ///< "REALTIME_DATA_4": the document's name
    double maxRate = 0;  ///< rows per second
    bool choosesChannels = false;  ///< carries the requested channels; other streams carry all they have
    QList<int> channels;  ///< what it can carry
};

/// One stream as requested by the operator.
struct StreamChoice
{
    QString key;
    double rate = 0;  ///< rows per second; 0 = as fast as the rest of the line allows
    QList<int> channels;  ///< for a stream that chooses its channels

    friend bool operator==(const StreamChoice &, const StreamChoice &) = default;
};

/// The telemetry that the operator wants.
struct Subscription
{
    QList<int> channels;  ///< fast channels, for plots; status channels always come
    double rate = 0;  ///< rows per second; 0 = as fast as the link allows
    QList<StreamChoice> streams = {};  ///< chosen by hand; empty: selected to suit the channels

    friend bool operator==(const Subscription &, const Subscription &) = default;
};

/// One stream as it would be set up, and its share of the line.
struct StreamUse
{
    QString key;
    QString label;
    double rate = 0;  ///< rows per second
    int frameBytes = 0;
    QList<int> channels;
    double fullRate = 0;  ///< rows per second that a faster line would carry, if it was thinned out; else 0

    [[nodiscard]] double bytesPerSecond() const { return rate * frameBytes; }
};

/// Line capacity needed by streams, before they are started.
struct StreamBudget
{
    /// Usable share of the line; the rest stays free for requests.
    static constexpr double kShare = 0.85;

    std::vector<StreamUse> streams;
    double capacity = 0;  ///< bytes per second of the line; 0 = unlimited

    [[nodiscard]] double bytesPerSecond() const
    {
        double sum = 0;
        for (const StreamUse &use : streams)
            sum += use.bytesPerSecond();
        return sum;
    }
    [[nodiscard]] bool fits() const
    {
        return capacity <= 0 || bytesPerSecond() <= capacity * kShare * 1.0001;
    }
    /// The reason why it does not fit, with the numbers.
    [[nodiscard]] Error refusal() const;
};

/// Parses a stream: KIND or KIND@RATE, like "realtime4@100". Errors: InvalidArgument.
[[nodiscard]] Result<StreamChoice> parseStreamChoice(const QString &text);
