// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/video/videotypes.h"

#include <QSize>

#include <deque>
#include <optional>

/// How the video of a drone arrives, as counted since it was started.
struct VideoStatistics
{
    VideoFormat format = VideoFormat::Unknown;
    QSize size;  ///< of the pictures; empty while unknown
    quint64 datagrams = 0;
    quint64 bytes = 0;
    quint64 frames = 0;  ///< encoded, that arrived
    quint64 lost = 0;  ///< frames that are missing by their numbers
    quint64 foreign = 0;  ///< what arrived and is no video
    quint64 damaged = 0;  ///< pictures from a loss to the next key frame: parts are made up
    quint64 undecoded = 0;  ///< frames that gave no picture, after the first one
    quint64 shown = 0;
    quint64 skipped = 0;  ///< pictures that were overtaken by a newer one
    double frameRate = 0;  ///< of the last two seconds
    double bitRate = 0;  ///< bits per second, of the last two seconds
    double lossPercent = 0;  ///< frames lost, of those of the last ten seconds
    std::optional<Duration> silence;  ///< since the last frame; empty before the first
    std::optional<Duration>
        latency;  ///< from a frame's first datagram to the screen: median of the last ones
    std::optional<Duration> worstLatency;

    /// Frames of MJPEG have no numbers, and datagrams neither (errata 10): what is lost cannot be counted.
    [[nodiscard]] bool countsLoss() const { return format != VideoFormat::Mjpeg; }
};

/// Counts what happens in time, over the last seconds.
class RateMeter
{
public:
    explicit RateMeter(Duration span)
        : m_span(span)
    {
    }

    void add(TimePoint at, double amount);
    /// How often, in a second.
    [[nodiscard]] double rate(TimePoint now) const;
    /// Sum of the amounts, in a second.
    [[nodiscard]] double amountRate(TimePoint now) const;
    /// Mean of the amounts; 0 without any.
    [[nodiscard]] double mean(TimePoint now) const;

private:
    struct Event
    {
        TimePoint at;
        double amount;
    };
    void forget(TimePoint now) const;
    [[nodiscard]] double sum() const;

    Duration m_span;
    mutable std::deque<Event> m_events;
};

/// The delays of the last pictures.
class DelayMeter
{
public:
    void add(Duration delay);
    [[nodiscard]] std::optional<Duration> median() const;
    [[nodiscard]] std::optional<Duration> worst() const;

private:
    static constexpr std::size_t kKept = 120;
    std::deque<Duration> m_delays;
};
